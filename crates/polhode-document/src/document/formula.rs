//! The rows of a formula: each is set by itself where an environment of rows, or a line so long, cannot be.

use crate::layout::width;

/// Columns of the Unicode text of a formula that stands on one line of a page.
const LONGEST: usize = 84;

/// What separates the equations of one line.
const BETWEEN: &str = r"\qquad";

/// The rows of a formula of which `text` is the Unicode form: the equations of an `aligned`, or of a line that is too long, one by one;
/// `None` if it has rows that cannot stand alone, as a determinant.
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

/// `a = b, \qquad c = d` in two.
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
