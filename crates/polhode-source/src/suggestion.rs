//! Suggestions for misspelt names.

/// Returns the candidate closest to a word, if it is close enough to be a misspelling and no other
/// is as close.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let letters = |text: &str| -> Vec<char> {
        text.chars()
            .take(40)
            .map(|c| if c == '-' || c == ' ' { '_' } else { c.to_ascii_lowercase() })
            .collect()
    };
    // A different digit means a different name: euler321 is not a misspelling of euler313.
    let digits = |text: &str| text.chars().filter(char::is_ascii_digit).collect::<String>();
    let number = digits(word);
    let word = letters(word);
    let mut near: Vec<(usize, &str)> = candidates
        .into_iter()
        .filter(|candidate| {
            let other = digits(candidate);
            number.is_empty() || other.is_empty() || number == other
        })
        .map(|candidate| (edits(&word, &letters(candidate)), candidate))
        .filter(|&(edits, candidate)| {
            let length = candidate.chars().count();
            // Allows edits of up to a third of the letters: wood is not a misspelling of gold.
            edits <= (length.max(word.len()) / 3).min(2)
        })
        .collect();
    near.sort_by_key(|&(edits, _)| edits);
    match near[..] {
        // A tie gives no suggestion: w2 may mean wx or wy.
        [(least, one), (edits, other), ..] if edits == least && one != other => None,
        [(_, candidate), ..] => Some(candidate),
        [] => None,
    }
}

/// Returns the edit distance of `a` and `b`: insertions, deletions, replacements and swaps of
/// neighbours.
fn edits(a: &[char], b: &[char]) -> usize {
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = replaced.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_is_recognised_and_another_word_is_not() {
        let keys = ["radius", "length", "size", "spin", "carbon fibre"];
        for (word, meant) in
            [("raduis", "radius"), ("Length", "length"), ("sizes", "size"), ("carbon-fiber", "carbon fibre")]
        {
            assert_eq!(nearest(word, keys), Some(meant), "{word}");
        }
        assert_eq!(nearest("euler321", ["axis", "euler313"]), None);
        assert_eq!(nearest("wood", ["gold", "lead", "oak"]), None);
        assert_eq!(nearest("silvr", ["gold", "silver"]), Some("silver"));
        for word in ["", "x", "colour", "long", "diameter"] {
            assert_eq!(nearest(word, keys), None, "{word}");
        }
    }
}
