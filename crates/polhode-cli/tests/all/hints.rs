//! Hints of the command, followed literally: the command with the option, or the file with the text
//! that a hint names, succeeds. The readers' own tests do the same for the hints of every mistake
//! in a scenario, a sweep, and a plan of swings.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Output;

use crate::common::Scratch;
use crate::obey;

/// Cases, one after the other. `@ NAME` starts a file, which later cases have too; `$ ARGUMENTS` is
/// a command that fails with a hint; `>` says how the hint is followed:
/// - `> +TEXT` adds TEXT to the command, `> -TEXT` removes TEXT from it, and `> OLD => NEW`
///   replaces one by the other; TEXT and NEW are in the hint;
/// - `> ^TEXT` writes the lines TEXT at the beginning of the file of the error, `> #TEXT` writes
///   them as lines of its head, which begin with `# ` in the same file; `> .TEXT` replaces
///   the line of the error by TEXT, and `> ~TEXT` replaces the marked text by TEXT;
/// - `>` alone writes what the hint says at the marked place.
///
/// `>>` is for a file with a second mistake: the error after it is another one.
const CASES: &str = include_str!("hints.txt");

/// A command that fails, and how its hint is followed.
struct Case<'a> {
    line: usize,
    files: BTreeMap<&'a str, String>,
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
    check_sites(&hints);
    assert!(cases.len() >= 60, "{} cases", cases.len());
}

fn cases<'a>() -> Vec<Case<'a>> {
    let mut cases = Vec::new();
    let mut files: BTreeMap<&str, String> = BTreeMap::new();
    let (mut file, mut command) = ("", Vec::new());
    for (number, line) in (1..).zip(CASES.lines()) {
        if let Some(name) = line.strip_prefix("@ ") {
            file = name;
            files.insert(name, String::new());
        } else if let Some(arguments) = line.strip_prefix("$ ") {
            (file, command) = ("", words(arguments));
        } else if let Some(follow) = line.strip_prefix('>') {
            let is_followed_by_another = follow.starts_with('>');
            let (files, arguments) = (files.clone(), command.clone());
            let follow = follow.trim_start_matches('>').trim_start();
            cases.push(Case { line: number, files, arguments, follow, is_followed_by_another });
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
    let output = scratch.run(&case.arguments.iter().map(String::as_str).collect::<Vec<_>>());
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    let at = format!("hints.txt:{}: polhode {}", case.line, case.arguments.join(" "));
    if succeeds(&output) {
        return Err(format!("{at}: it succeeds"));
    }
    let hint = hint(&error).ok_or_else(|| format!("{at}: no hint\n{error}"))?;
    let fail = |why: String| Err(format!("{at}\n{error}{why}"));
    let mut arguments = case.arguments.clone();
    let (kind, text) = case.follow.split_at(case.follow.chars().next().map_or(0, char::len_utf8));
    let wanted = case.follow.split_once(" => ").map_or(text, |(_, new)| new);
    // The value of an option is the user's.
    let options = wanted.split([' ', '=']).filter(|word| word.starts_with('-'));
    let parts = wanted.split("\\n");
    let wanted: Vec<&str> = match kind {
        "+" => options.collect(),
        "-" => Vec::new(),
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
    let again = scratch.run(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
    let other = String::from_utf8_lossy(&again.stderr).into_owned();
    if succeeds(&again) == case.is_followed_by_another || other.lines().next() == error.lines().next() {
        return fail(format!("followed: {}\n{other}", arguments.join(" ")));
    }
    Ok(hint.to_owned())
}

/// Checks that every hint in the sources with an option or code to write is the hint of a case, or
/// is listed with `! TEXT` and the reason that it has none; and that no listed hint has a case.
fn check_sites(hints: &[String]) {
    let listed: Vec<&str> = CASES.lines().filter_map(|line| line.strip_prefix("! ")).collect();
    let mut wrong = Vec::new();
    let mut count = 0;
    for (place, text) in sites() {
        count += 1;
        let has_case = hints.iter().any(|hint| is_made_by(hint, &text));
        let is_listed = listed.iter().any(|start| text.starts_with(start));
        if has_case == is_listed {
            wrong.push(format!("{place}: {}: {text}", if has_case { "is listed" } else { "has no case" }));
        }
    }
    assert!(count > 70 && wrong.is_empty(), "{count} hints\n{}", wrong.join("\n"));
}

/// Returns true if a format string can make a hint.
fn is_made_by(hint: &str, format: &str) -> bool {
    let mut rest = hint;
    format.replace("{{", "\u{1}").replace("}}", "\u{2}").split('{').enumerate().all(|(k, piece)| {
        let literal = if k == 0 { piece } else { piece.split_once('}').map_or("", |(_, after)| after) };
        let literal = literal.replace('\u{1}', "{").replace('\u{2}', "}");
        let Some((_, after)) = rest.split_once(literal.as_str()) else { return false };
        rest = after;
        true
    })
}

/// Returns the place and the text of every string in the sources that tells to write code or an
/// option. Scenarios, sweeps and units have such tests of their own.
fn sites() -> Vec<(String, String)> {
    const VERBS: [&str; 12] = [
        "write ",
        "add ",
        "give ",
        "use ",
        "set ",
        "name ",
        "state ",
        "remove ",
        "delete ",
        "choose ",
        "allow ",
        "leave out ",
    ];
    let mut found = Vec::new();
    for name in ["budget", "cli", "identify", "judge", "robot", "shape", "table"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../polhode-{name}/src"));
        for path in sources(&folder) {
            let text = fs::read_to_string(&path).unwrap();
            let text = text.split("#[cfg(test)]\nmod ").next().unwrap_or(&text);
            for (line, literal) in literals(text) {
                let begins = |verb: &&str| {
                    literal.starts_with(*verb)
                        || ["; ", ": ", ", ", "or ", "and ", "("]
                            .iter()
                            .any(|before| literal.contains(&format!("{before}{verb}")))
                };
                let has_code = ["--", " = ", "[["].iter().any(|code| literal.contains(code));
                if has_code && !literal.contains('\n') && VERBS.iter().any(begins) {
                    found.push((format!("{}:{line}", path.display()), literal));
                }
            }
        }
    }
    found
}

fn sources(folder: &Path) -> Vec<std::path::PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let rust = files.into_iter().filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
    rust.chain(folders.iter().flat_map(|folder| sources(folder))).collect()
}

/// Returns the strings of a source file that are not in comments, with their lines.
fn literals(text: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let mut joined: Option<(usize, String)> = None;
    for (number, line) in (1..).zip(text.lines()) {
        let mut rest = if joined.is_some() { line.trim_start() } else { line };
        if joined.is_none() && line.trim_start().starts_with("//") {
            continue;
        }
        loop {
            if let Some((start, mut literal)) = joined.take() {
                // A string goes on after a backslash at the end of a line.
                let Some((end, is_closed)) = end_of_string(rest) else { break };
                literal.push_str(&rest[..end]);
                if !is_closed {
                    joined = Some((start, literal));
                    break;
                }
                found.push((start, literal.replace("\\\"", "\"").replace("\\n", "\n")));
                rest = &rest[end + 1..];
            }
            // A quote as a character is not the beginning of a string.
            let Some(open) =
                rest.match_indices('"').map(|(at, _)| at).find(|&at| !rest[..at].ends_with('\''))
            else {
                break;
            };
            joined = Some((number, String::new()));
            rest = &rest[open + 1..];
        }
    }
    found
}

/// Returns the end of a string, and true if it is a quote, false if it is the end of the line.
fn end_of_string(rest: &str) -> Option<(usize, bool)> {
    let mut escaped = false;
    for (at, c) in rest.char_indices() {
        match c {
            '"' if !escaped => return Some((at, true)),
            _ => escaped = c == '\\' && !escaped,
        }
    }
    Some((rest.len() - usize::from(rest.ends_with('\\')), false))
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
fn place(error: &str, folder: &Path) -> Option<(String, std::ops::Range<usize>)> {
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
