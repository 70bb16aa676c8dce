//! Follows a hint literally: the tests of every reader feed the result back to it.
#![allow(dead_code, unreachable_pub, reason = "each crate uses some of it")]

use std::ops::Range;

/// Text changed as a hint says, and the range of what was written into it.
#[derive(Debug)]
pub struct Obeyed {
    pub text: String,
    pub written: Range<usize>,
}

/// Returns the text changed as the hint says; `at` is the place of the error. `None` if the hint
/// has nothing that can be copied, such as "check its sign".
pub fn obey(text: &str, at: &Range<usize>, hint: &str) -> Option<Obeyed> {
    if let Some(name) = meant(hint) {
        // A name without quotes replaces what is in them; a unit, the word after the number.
        let marked = &text[at.clone()];
        let (mut from, mut to) = (at.start, at.end);
        if marked.starts_with(['"', '\'']) && !name.starts_with(['"', '\'']) {
            (from, to) = (from + 1, to - 1);
        }
        if let Some(space) = text[from..to].rfind(' ').filter(|_| !name.contains(' ')) {
            from += space + 1;
        }
        return Some(put(text, &(from..to), name));
    }
    let codes = codes(hint);
    let (header, line) =
        (codes.iter().find(|code| is_header(code)), codes.iter().find(|code| key(code).is_some()));
    match (header, line) {
        // `write [orbit] on a line of its own, and under it altitude = "500 km"`
        (Some(header), Some(line)) if text.contains(&format!("\n{header}\n")) => {
            let end = text.find(&format!("\n{header}\n"))? + header.len() + 2;
            Some(put(text, &(end..end), &format!("{line}\n")))
        }
        (Some(header), Some(_)) => {
            // The key is in the wrong table.
            let wrong = entry_at(text, at).filter(|_| hint.contains("in place of it"));
            let mut text = wrong.map_or(text.to_owned(), |entry| put(text, &entry, "").text);
            // An empty list stands where the tables belong.
            let name = header.trim_matches(['[', ']']).rsplit('.').next()?;
            for empty in [format!("{name} = []"), format!("{name}=[]")] {
                text = text.replace(&empty, "");
            }
            let lines: Vec<&str> = codes.iter().copied().filter(|code| key(code).is_some()).collect();
            Some(put(&text, &(text.len()..text.len()), &format!("\n{header}\n{}\n", lines.join("\n"))))
        }
        (_, Some(line)) if hint.contains(" in place of ") => {
            let entry = entry_at(text, at)?;
            Some(put(text, &entry, line))
        }
        (_, Some(line)) => Some(assign(text, at, line)),
        (None, None) if hint.contains("leave out ") => {
            let (_, key) = hint.split_once("leave out ")?;
            let key = key.split([' ', ',', ';', ':']).next()?;
            let entry = entry_at(text, at).filter(|entry| text[entry.clone()].starts_with(key))?;
            Some(put(text, &entry, ""))
        }
        _ => codes.first().filter(|code| !is_header(code)).map(|code| put(text, at, code)),
    }
}

/// Returns the name in "did you mean NAME?".
pub fn meant(hint: &str) -> Option<&str> {
    let (_, rest) = hint.split_once("did you mean ")?;
    Some(rest.split_once('?')?.0)
}

/// Returns the code after `write`, `add`, `give`, `use` and `under it`: assignments, values, and
/// headers. Alternatives after "or" are not used, a second line after "and" is.
pub fn codes(hint: &str) -> Vec<&str> {
    const VERBS: [&str; 8] =
        ["write ", "add ", "give ", "use ", "under it ", "with ", "on the next line, ", "and "];
    let mut codes: Vec<(usize, &str)> = Vec::new();
    for verb in VERBS {
        for (start, _) in hint.match_indices(verb) {
            let before = hint[..start].chars().next_back();
            let begin = start + verb.len();
            if before.is_some_and(char::is_alphanumeric) {
                continue;
            }
            let mut next = begin;
            // More assignments follow after commas.
            while let Some(code) = code(&hint[next..]) {
                let end = next + code.len();
                // A value before other words is not for the marked place.
                let is_last = hint[end..].is_empty() || hint[end..].starts_with([',', ';', ':']);
                if key(code).is_some() || is_header(code) || is_last || hint[end..].starts_with(" or ") {
                    codes.push((next, code));
                }
                if key(code).is_none() || !hint[end..].starts_with(", ") {
                    break;
                }
                next = end + 2;
            }
        }
    }
    codes.sort_unstable();
    codes.dedup();
    codes.into_iter().map(|(_, code)| code).collect()
}

fn is_header(code: &str) -> bool {
    let name = code.trim_matches(['[', ']']);
    let is_name = name.chars().all(|c| c.is_ascii_lowercase() || "_.".contains(c));
    code.starts_with('[') && !name.is_empty() && is_name
}

/// Returns the key of `key = value`.
fn key(code: &str) -> Option<&str> {
    let (key, _) = code.split_once(" = ")?;
    (!key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')).then_some(key)
}

/// Returns `key = value` or a value at the beginning of a text. A value is a string, an array, a
/// table, a number or a truth value; `…` and `...` are not values.
fn code(text: &str) -> Option<&str> {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let key = text.find(|c| !is_word(c)).filter(|end| *end > 0 && text[*end..].starts_with(" = "));
    let start = key.map_or(0, |end| end + 3);
    let end = start + value(&text[start..])?;
    let code = &text[..end];
    (!code.contains("...") && !code.contains('…')).then_some(code)
}

/// Returns the length of the value at the beginning of a text.
fn value(text: &str) -> Option<usize> {
    let (mut depth, mut quote) = (0_i32, None);
    let first = text.chars().next()?;
    let is_bare = !"\"'[{".contains(first);
    for (at, c) in text.char_indices() {
        match quote {
            Some(open) if c == open => quote = None,
            Some(_) => continue,
            None if "\"'".contains(c) => {
                quote = Some(c);
                continue;
            }
            None => depth += i32::from("[{".contains(c)) - i32::from("]}".contains(c)),
        }
        if !is_bare && depth == 0 {
            return Some(at + c.len_utf8());
        }
    }
    let end = text.find([' ', ',', ';', ':', ')', '\n', ']', '}']).unwrap_or(text.len());
    let word = text[..end].trim_end_matches('.');
    let is_value = word == "true" || word == "false" || word.parse::<f64>().is_ok();
    (is_bare && is_value).then_some(word.len())
}

fn put(text: &str, at: &Range<usize>, with: &str) -> Obeyed {
    let written = at.start..at.start + with.len();
    Obeyed { text: [&text[..at.start], with, &text[at.end..]].concat(), written }
}

/// Writes `key = value` instead of the entry at a place, if it has this key or the place is its
/// key; else next to it; or below a header.
fn assign(text: &str, at: &Range<usize>, line: &str) -> Obeyed {
    let key = key(line).unwrap_or_default();
    let marked = &text[at.clone()];
    if marked.starts_with('[') && is_header(marked) || at.is_empty() && at.start == 0 {
        // An entry of this table, or a new line in it.
        let body = at.end..text[at.end..].find("\n[").map_or(text.len(), |end| at.end + end + 1);
        if let Some(entry) = entries(text)
            .into_iter()
            .find(|entry| body.contains(&entry.start) && text[entry.clone()].starts_with(&format!("{key} ")))
        {
            return put(text, &entry, line);
        }
        let after = text[at.end..].find('\n').map_or(text.len(), |end| at.end + end);
        let start = if at.start == 0 && at.is_empty() { 0 } else { after };
        return put(text, &(start..start), &format!("\n{line}\n"));
    }
    let Some(entry) = entry_at(text, at) else { return put(text, at, line) };
    let own = text[entry.clone()].split([' ', '=']).next().unwrap_or_default();
    if marked.starts_with('{') && own != key {
        return put(text, &(at.start + 1..at.start + 1), &format!(" {line},"));
    }
    // A key that the table has is changed, not added.
    let table = text[..at.start].rfind("\n[").unwrap_or(0)
        ..text[at.start..].find("\n[").map_or(text.len(), |end| at.start + end);
    let has_key = |it: &&Range<usize>| {
        table.contains(&it.start)
            && text[it.start..].starts_with(&format!("{key} "))
            && (it.start == 0 || text[..it.start].ends_with('\n'))
    };
    if let Some(other) = entries(text).iter().find(has_key) {
        return put(text, other, line);
    }
    if own == key || at.start == entry.start && at.end <= entry.start + own.len() {
        return put(text, &entry, line);
    }
    // In an inline table entries are separated by commas.
    let line_start = text[..entry.start].rfind('\n').map_or(0, |end| end + 1);
    let inline = text[line_start..entry.start].contains(['{', '[']);
    let with = if inline { format!("{line}, ") } else { format!("{line}\n") };
    put(text, &(entry.start..entry.start), &with)
}

/// Returns the innermost entry that contains a place.
fn entry_at(text: &str, at: &Range<usize>) -> Option<Range<usize>> {
    let around = entries(text).into_iter().filter(|it| it.start <= at.start && at.end <= it.end);
    around.max_by_key(|it| it.start)
}

/// Returns the ranges of all `key = value`, also those in inline tables.
fn entries(text: &str) -> Vec<Range<usize>> {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut found = Vec::new();
    for (at, _) in text.match_indices('=') {
        let key_end = text[..at].trim_end_matches(' ').len();
        let start = text[..key_end].rfind(|c| !is_word(c)).map_or(0, |end| end + 1);
        let begin = at + 1 + text[at + 1..].len() - text[at + 1..].trim_start_matches(' ').len();
        let end = value(&text[begin..]).map_or_else(
            || text[begin..].find('\n').map_or(text.len(), |end| begin + end),
            |length| begin + length,
        );
        if start < key_end {
            found.push(start..end);
        }
    }
    found
}

/// Checks that a text with an error is accepted after its hint is followed, or is refused for
/// another reason that is not in what the hint wrote. `read` returns the message and the place of
/// the error. Returns true if the hint could be followed.
#[track_caller]
pub fn check<E>(
    text: &str,
    (message, at, hint): (&str, &Range<usize>, &str),
    read: impl Fn(&str) -> Result<(), E>,
    parts: impl Fn(&E) -> (String, Option<Range<usize>>),
) -> bool {
    let Some(obeyed) = obey(text, at, hint) else { return false };
    if let Err(again) = read(&obeyed.text) {
        let (again, place) = parts(&again);
        let place = place.unwrap_or(0..0);
        // A name that was meant may be of another kind than the text around it wants.
        let in_it = meant(hint).is_none()
            && !place.is_empty()
            && obeyed.written.start <= place.start
            && place.end <= obeyed.written.end;
        // The next element of a list may have the same mistake.
        let is_next = obeyed.written.end <= place.start;
        assert!(
            (again != message || is_next) && !in_it,
            "{message}\nhint: {hint}\nfollowed:\n{}\nwhich is refused too: {again}",
            obeyed.text
        );
    }
    true
}
