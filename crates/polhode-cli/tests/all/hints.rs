//! Hints of the command, followed literally: the command with the option, or the file with the text
//! that a hint names, succeeds. The readers' own tests do the same for the hints of every mistake
//! in a scenario, a sweep, and a plan of swings.

use std::collections::BTreeMap;
use std::fs;
use std::process::Output;

mod sites;

use crate::common::Scratch;
use crate::obey;

/// Cases, one after the other. `@ NAME` starts a file, which later cases have too; `@ NAME < OLD`
/// starts it with the text of OLD, and `@ NAME < OLD ~ A => B` with B for A in it.
/// `$ ARGUMENTS` is a command that fails with a hint, and `% ARGUMENTS` one that succeeds before
/// it; `>` says how the hint is followed:
/// - `> +TEXT` adds TEXT to the command, `> -TEXT` removes TEXT from it, and `> OLD => NEW`
///   replaces one by the other; TEXT and NEW are in the hint;
/// - `> ^TEXT` writes the lines TEXT at the beginning of the file of the error, `> #TEXT` writes
///   them as lines of its head, which begin with `# ` in the same file; `> .TEXT` replaces
///   the line of the error by TEXT, and `> ~TEXT` replaces the marked text by TEXT;
/// - `> =OLD => NEW` replaces OLD by NEW in the file that the command names, and `> ?OLD => NEW`
///   does so where the hint says it in words only: the value is the user's;
/// - `>` alone writes what the hint says at the marked place.
///
/// `? FILE` before it names a source file that looks for the name that was meant.
/// `>>` is for a file with a second mistake: the error after it is another one.
const CASES: &str = include_str!("hints.txt");

/// A command that fails, and how its hint is followed.
struct Case<'a> {
    line: usize,
    files: BTreeMap<&'a str, String>,
    before: Vec<String>,
    site: &'a str,
    arguments: Vec<String>,
    follow: &'a str,
    is_followed_by_another: bool,
}

#[test]
fn a_hint_that_is_followed_removes_the_error() {
    let cases = cases();
    let (mut hints, mut faults) = (Vec::new(), Vec::new());
    for case in &cases {
        match followed(case) {
            Ok(hint) => hints.push(hint),
            Err(fault) => faults.push(fault),
        }
    }
    assert!(faults.is_empty(), "{} of {}:\n{}", faults.len(), cases.len(), faults.join("\n\n"));
    sites::check(&hints);
    sites::check_names(cases.iter().map(|case| case.site));
    assert!(cases.len() >= 60, "{} cases", cases.len());
}

#[test]
fn options_in_hints_exist() {
    let scratch = Scratch::new("hint-options");
    sites::check_options(|command| String::from_utf8(scratch.run(&[command, "--help"]).stdout).unwrap());
}

fn cases<'a>() -> Vec<Case<'a>> {
    let mut cases = Vec::new();
    let mut files: BTreeMap<&str, String> = BTreeMap::new();
    let mut site = "";
    let (mut file, mut before, mut command) = ("", Vec::new(), Vec::new());
    for (number, line) in (1..).zip(CASES.lines()) {
        if let Some(name) = line.strip_prefix("@ ") {
            let (name, old) = name.split_once(" < ").unwrap_or((name, ""));
            let (old, change) = old.split_once(" ~ ").unwrap_or((old, " => "));
            let (from, to) = change.split_once(" => ").unwrap();
            let text = files.get(old).map(|text| text.replace(from, &to.replace("\\n", "\n")));
            file = name;
            files.insert(
                name,
                text.filter(|_| !from.is_empty()).or(files.get(old).cloned()).unwrap_or_default(),
            );
            before.clear();
        } else if let Some(file) = line.strip_prefix("? ") {
            site = file;
        } else if let Some(arguments) = line.strip_prefix("% ") {
            before = words(arguments);
        } else if let Some(arguments) = line.strip_prefix('$') {
            (file, command) = ("", words(arguments));
        } else if let Some(follow) = line.strip_prefix('>') {
            let is_followed_by_another = follow.starts_with('>');
            let (files, before, arguments) = (files.clone(), before.clone(), command.clone());
            let follow = follow.trim_start_matches('>').trim_start();
            cases.push(Case { line: number, files, before, site, arguments, follow, is_followed_by_another });
            site = "";
        } else if let Some(text) = files.get_mut(file) {
            text.push_str(line);
            text.push('\n');
        }
    }
    cases
}

/// Splits arguments at spaces outside of double quotes.
fn words(line: &str) -> Vec<String> {
    let parts = line.split('"').enumerate();
    let mut words: Vec<String> = Vec::new();
    let mut joins = false;
    for (k, part) in parts {
        if k % 2 == 1 {
            match words.last_mut().filter(|_| joins) {
                Some(word) => word.push_str(part),
                None => words.push(part.to_owned()),
            }
            continue;
        }
        words.extend(part.split(' ').filter(|word| !word.is_empty()).map(str::to_owned));
        joins = part.ends_with('=');
    }
    words
}

/// Follows the hint of a case; returns it, or what is wrong.
fn followed(case: &Case<'_>) -> Result<String, String> {
    let scratch = Scratch::new(&format!("hint-{}", case.line));
    case.files.iter().for_each(|(name, text)| scratch.write(name, text));
    let run = |words: &[String]| scratch.run(&words.iter().map(String::as_str).collect::<Vec<_>>());
    if !case.before.is_empty() && !succeeds(&run(&case.before)) {
        return Err(format!("hints.txt:{}: polhode {} fails", case.line, case.before.join(" ")));
    }
    let output = run(&case.arguments);
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    let at = format!("hints.txt:{}: polhode {}", case.line, case.arguments.join(" "));
    if succeeds(&output) {
        return Err(format!("{at}: it succeeds"));
    }
    let hint = hint(&error).ok_or_else(|| format!("{at}: no hint\n{error}"))?;
    if !case.site.is_empty() && !hint.contains("did you mean ") {
        return Err(format!("{at}: no name in {hint}"));
    }
    let fail = |why: String| Err(format!("{at}\n{error}{why}"));
    let mut arguments = case.arguments.clone();
    let (kind, text) = case.follow.split_at(case.follow.chars().next().map_or(0, char::len_utf8));
    let wanted = case.follow.split_once(" => ").map_or(text, |(_, new)| new);
    // The value of an option is the user's.
    let options = wanted.split([' ', '=']).filter(|word| word.starts_with('-'));
    let parts = wanted.split("\\n");
    let wanted: Vec<&str> = match kind {
        "+" => options.collect(),
        "-" | "?" => Vec::new(),
        _ => parts.map(|part| part.trim_matches('"')).collect(),
    };
    if let Some(missing) = wanted.into_iter().find(|part| !error.contains(part)) {
        return fail(format!("the error does not have {missing}"));
    }
    match (kind, case.follow.split_once(" => ")) {
        ("+", None) => arguments.extend(words(text)),
        // The option, and its value, which follows it.
        ("-", None) => {
            let gone = arguments.iter().position(|word| *word == case.follow);
            let end = gone.map_or(0, |at| {
                at + 1 + usize::from(arguments.get(at + 1).is_some_and(|word| !word.starts_with("--")))
            });
            gone.map(|at| arguments.drain(at..end));
        }
        ("=" | "?", Some((old, new))) => {
            let file = arguments.iter().find(|word| scratch.0.join(word).is_file());
            let Some(file) = file else { return fail("no file".to_owned()) };
            let whole = fs::read_to_string(scratch.0.join(file)).unwrap();
            let [old, new] = [&old[1..], new].map(|text| text.replace("\\n", "\n"));
            if !whole.contains(&old) {
                return fail(format!("no {old} to replace"));
            }
            scratch.write(file, &whole.replace(&old, &new));
        }
        (_, Some((old, new))) => {
            let joined = arguments.join("\u{1f}");
            let old = words(old).join("\u{1f}");
            if !joined.contains(&old) {
                return fail(format!("no {old} to replace"));
            }
            arguments =
                joined.replace(&old, &words(new).join("\u{1f}")).split('\u{1f}').map(str::to_owned).collect();
        }
        _ => {
            let named = || arguments.iter().find(|word| scratch.0.join(word).is_file());
            let place = place(&error, &scratch.0).or_else(|| Some((named()?.clone(), 0..0)));
            let Some((file, range)) = place else { return fail("no place".to_owned()) };
            let whole = fs::read_to_string(scratch.0.join(&file)).unwrap();
            let line = whole[..range.start].rfind('\n').map_or(0, |end| end + 1)
                ..whole[range.start..].find('\n').map_or(whole.len(), |end| range.start + end);
            let put = |at: std::ops::Range<usize>, text: &str| {
                [&whole[..at.start], &text.replace("\\n", "\n"), &whole[at.end..]].concat()
            };
            let new = match kind {
                "^" => put(0..0, &format!("{text}\n")),
                "#" => put(0..0, &format!("# {}\n", text.replace("\\n", "\n# "))),
                "." => put(line, text),
                "~" => put(range, text),
                _ => match obey::obey(&whole, &range, hint) {
                    Some(obeyed) => obeyed.text,
                    None => return fail("the hint cannot be followed".to_owned()),
                },
            };
            scratch.write(&file, &new);
        }
    }
    let again = run(&arguments);
    let other = String::from_utf8_lossy(&again.stderr).into_owned();
    if succeeds(&again) == case.is_followed_by_another || other.lines().next() == error.lines().next() {
        return fail(format!("followed: {}\n{other}", arguments.join(" ")));
    }
    Ok(hint.to_owned())
}

/// Returns true if a command answers: findings are an answer too.
fn succeeds(output: &Output) -> bool {
    matches!(output.status.code(), Some(0 | 1))
}

/// Returns the advice of an error: a line `hint:`, or clap's tip.
fn hint(error: &str) -> Option<&str> {
    let advice = ["\nhint: ", "hint: ", "tip: ", "error: "].iter().find_map(|mark| error.split_once(mark))?.1;
    Some(advice.split('\n').next().unwrap_or(advice).trim_end_matches(')'))
}

/// Returns the file of the first place of an error, and the bytes that are marked in it.
fn place(error: &str, folder: &std::path::Path) -> Option<(String, std::ops::Range<usize>)> {
    let place = error.lines().find_map(|line| line.trim_start().strip_prefix("--> "))?;
    let mut parts = place.rsplitn(3, ':');
    let (column, line) = (parts.next()?.parse::<usize>().ok()?, parts.next()?.parse::<usize>().ok()?);
    let file = parts.next()?.to_owned();
    let width = error.lines().find_map(|line| {
        let (_, marks) = line.split_once('|')?;
        (!marks.is_empty() && marks.chars().all(|c| " ^".contains(c)) && marks.contains('^'))
            .then(|| marks.matches('^').count())
    });
    let text = fs::read_to_string(folder.join(&file)).ok()?;
    let start = text.split_inclusive('\n').take(line - 1).map(str::len).sum::<usize>();
    let offset =
        |count: usize| text[start..].char_indices().nth(count).map_or(text.len() - start, |(at, _)| at);
    Some((file, start + offset(column - 1)..start + offset(column - 1 + width.unwrap_or(1))))
}
