//! Rows of a formula, typeset one by one where an `aligned` environment or a long line is not
//! possible.

use crate::layout::width;

/// Largest width of a formula on one line of a page, in columns of its Unicode text.
const LONGEST: usize = 84;

/// Separator between the equations of one line.
const BETWEEN: &str = r"\qquad";

/// Splits a formula, with Unicode form `text`, into its equations: the rows of an `aligned`
/// environment, or the equations of a line that is too long. Returns `None` if the rows belong
/// together, as in a determinant.
pub(super) fn rows(text: &str, latex: &str) -> Option<Vec<String>> {
    if let Some(inside) =
        latex.strip_prefix(r"\begin{aligned}").and_then(|rest| rest.strip_suffix(r"\end{aligned}"))
    {
        return Some(inside.split(r"\cr").map(|row| row.replace('&', "").trim().to_owned()).collect());
    }
    if latex.contains(r"\cr") {
        return None;
    }
    let is_long = text.lines().any(|line| width(line) > LONGEST);
    Some(if is_long { equations(latex) } else { vec![latex.to_owned()] })
}

/// Splits `a = b, \qquad c = d` into its equations.
fn equations(latex: &str) -> Vec<String> {
    let rows = latex.split(BETWEEN).map(|row| row.trim().trim_end_matches(',').trim_end().to_owned());
    rows.filter(|row| !row.is_empty()).collect()
}

#[cfg(test)]
mod tests {
    use super::rows;

    #[test]
    fn each_equation_is_a_row() {
        let long = "a".repeat(100);
        assert_eq!(rows("a, b", r"a, \qquad b"), Some(vec![r"a, \qquad b".to_owned()]));
        assert_eq!(rows(&long, r"a, \qquad b"), Some(vec!["a".to_owned(), "b".to_owned()]));
        let aligned = "\\begin{aligned}\na &= b \\cr\nc &= d\n\\end{aligned}";
        assert_eq!(rows("", aligned), Some(vec!["a = b".to_owned(), "c = d".to_owned()]));
        assert_eq!(rows("", "\\begin{vmatrix}\na \\cr\nb\n\\end{vmatrix}"), None);
    }
}
