//! Suggestions for misspelt names.

/// Returns the name closest to a word, if it is close enough to be a misspelling and no other is as
/// close. Capital letters count as one edit, because M and m are different symbols.
pub(crate) fn nearest<'a>(word: &str, names: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let letters: Vec<char> = word.chars().take(40).collect();
    let mut near: Vec<(usize, &str)> = names
        .map(|name| (edits(&letters, &name.chars().take(40).collect::<Vec<_>>()), name))
        .filter(|&(edits, name)| {
            let is_case = name.to_lowercase() == word.to_lowercase();
            is_case || edits <= (name.chars().count().max(letters.len()) / 2).min(2)
        })
        .collect();
    near.sort_by_key(|&(edits, _)| edits);
    match near[..] {
        [(least, _), (edits, _), ..] if edits == least => None,
        [(_, name), ..] => Some(name),
        [] => None,
    }
}

/// Returns the edit distance: insertions, deletions and replacements (Wagner and Fischer, 1974).
fn edits(a: &[char], b: &[char]) -> usize {
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(x != y);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}
