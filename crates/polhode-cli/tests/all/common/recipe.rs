//! Runs a documentation page: creates its files, runs its commands, and compares their output with
//! the page.
//!
//! - A block is a file if its first or second line is a comment with the file name: `# top.toml`,
//!   `## parts.csv` or `<!-- arm.urdf -->`.
//! - ```` ```console ```` contains commands after `$
//!   `. They must succeed, unless the page states `# exit status 1`. `cargo run --release --
//!   simulate …` is run as `polhode simulate …`.
//! - ```` ```text ```` after it is their complete output; a line `…` stands for omitted lines.

use std::fs;
use std::path::Path;

use super::Scratch;

/// Number of commands run and excerpts compared.
#[derive(Default)]
pub struct Followed {
    pub commands: usize,
    pub excerpts: usize,
}

/// Runs a page in a folder with the examples; panics with the line number at the first difference.
pub fn follow(page: &Path, scratch: &Scratch) -> Followed {
    let name = page.file_name().unwrap().to_string_lossy();
    let text = fs::read_to_string(page).unwrap().replace("\r\n", "\n");
    let mut followed = Followed::default();
    let mut printed = None;
    for block in blocks(&text) {
        let at = format!("{name}:{}", block.line);
        match block.language {
            "console" => {
                let lines = block.text.lines().map(|line| {
                    line.strip_prefix("$ ").unwrap_or_else(|| panic!("{at}: not a command: {line}"))
                });
                printed = Some(lines.map(|line| run(line, scratch, &at)).collect::<String>());
                followed.commands += block.text.lines().count();
            }
            "text" => {
                let printed = printed.take().unwrap_or_else(|| panic!("{at}: no command has printed this"));
                if let Err(missing) = compare(block.text, &printed) {
                    panic!("{at}: not printed here: {missing}\n\n{printed}");
                }
                followed.excerpts += 1;
            }
            language => {
                let file = file_name(block.text);
                assert!(file.is_some() || language != "toml", "{at}: a scenario without `# NAME.toml`");
                if let Some(file) = file {
                    scratch.write(file, block.text);
                }
            }
        }
    }
    followed
}

struct Block<'a> {
    /// Number of its first line, from 1.
    line: usize,
    language: &'a str,
    text: &'a str,
}

fn blocks(page: &str) -> Vec<Block<'_>> {
    let mut found: Vec<Block<'_>> = Vec::new();
    let mut open = None;
    let mut offset = 0;
    for (number, line) in (1..).zip(page.split_inclusive('\n')) {
        let end = offset + line.len();
        match (line.strip_prefix("```"), open) {
            (Some(language), None) => open = Some((number + 1, language.trim_end(), end)),
            (Some(_), Some((line, language, start))) => {
                found.push(Block { line, language, text: &page[start..offset] });
                open = None;
            }
            (None, _) => {}
        }
        offset = end;
    }
    assert!(open.is_none(), "a block is not closed");
    found
}

fn file_name(text: &str) -> Option<&str> {
    let comments = text.lines().take(2).filter_map(|line| {
        let hash = line.strip_prefix("# ").or_else(|| line.strip_prefix("## "));
        hash.or_else(|| line.strip_prefix("<!-- ")?.strip_suffix(" -->"))
    });
    comments.filter_map(|line| line.split([' ', ',']).next()).find(|word| {
        word.contains('.') && word.chars().all(|c| c.is_ascii_alphanumeric() || "._-".contains(c))
    })
}

/// Runs a command; returns its standard output followed by its standard error.
fn run(line: &str, scratch: &Scratch, at: &str) -> String {
    let (command, status) = match line.split_once("# exit status ") {
        Some((command, status)) => (command, status.trim().parse().unwrap()),
        None => (line, 0),
    };
    let command = match command.strip_prefix("cargo run --release -- ") {
        Some(arguments) => format!("polhode {arguments}"),
        None => command.to_owned(),
    };
    let words = words(&command);
    assert_eq!(words.first().map(String::as_str), Some("polhode"), "{at}: not polhode's: {command}");
    let arguments: Vec<&str> = words[1..].iter().map(String::as_str).collect();
    let output = scratch.run(&arguments);
    let all = [output.stdout, output.stderr].concat();
    let printed = String::from_utf8(all).unwrap();
    assert_eq!(output.status.code(), Some(status), "{at}: {command}\n{printed}");
    printed
}

/// Splits a command into words as a shell does; quotes group words.
fn words(command: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word: Option<String> = None;
    let mut quote = None;
    for c in command.chars() {
        match quote {
            Some(open) if c == open => quote = None,
            None if c == '"' || c == '\'' => {
                quote = Some(c);
                word.get_or_insert_default();
            }
            None if c == ' ' => words.extend(word.take()),
            None if "|<>;&$`\\".contains(c) => panic!("{command}: {c} would need a shell"),
            _ => word.get_or_insert_default().push(c),
        }
    }
    assert!(quote.is_none(), "{command}: a quote is not closed");
    words.extend(word);
    words
}

/// Checks that an excerpt matches the output. The groups of lines between `…` must occur in order.
/// The first and last group must be at the beginning and end, unless `…` is there. Returns the
/// missing line otherwise.
fn compare(excerpt: &str, printed: &str) -> Result<(), String> {
    let printed: Vec<&str> = printed.lines().map(str::trim_end).collect();
    let wanted: Vec<&str> = excerpt.lines().map(str::trim_end).collect();
    let mut runs = wanted.split(|line| *line == "…").peekable();
    let (mut next, mut anchored) = (0, true);
    while let Some(run) = runs.next() {
        let rest = &printed[next..];
        let last_start = rest.len().checked_sub(run.len()).ok_or("less is printed")?;
        let starts = match (anchored, runs.peek()) {
            (true, _) => 0..=0,
            (false, None) => last_start..=last_start,
            (false, Some(_)) => 0..=last_start,
        };
        let fits = |start: &usize| rest.get(*start..*start + run.len()) == Some(run);
        let Some(start) = starts.into_iter().find(fits) else {
            let missing = run.iter().find(|line| !rest.contains(line));
            return Err(missing.or(run.first()).unwrap_or(&"").to_string());
        };
        next += start + run.len();
        anchored = false;
        if runs.peek().is_none() && next != printed.len() {
            return Err(format!("more is printed: {}", printed[next]));
        }
    }
    Ok(())
}

#[test]
fn an_excerpt_is_compared_line_by_line() {
    let printed = "a\nb\nc\nd\n";
    for right in ["a\nb\nc\nd\n", "a\n…\n", "…\nd\n", "…\nb\nc\n…\n", "a\n…\nc\n…\nd\n", "…\n"]
    {
        assert_eq!(compare(right, printed), Ok(()), "{right}");
    }
    for wrong in
        ["a\nb\n", "b\n…\n", "…\nc\n", "…\nb\nd\n…\n", "…\nc\n…\nb\n…\n", "…\ne\n…\n", "a\nb\nc\nd\ne\n"]
    {
        assert!(compare(wrong, printed).is_err(), "{wrong}");
    }
}

#[test]
fn a_page_is_taken_apart() {
    let page = "Text.\n```toml\n# a.toml\nx = 1\n```\n```console\n$ polhode --version\n```\n";
    let found: Vec<_> = blocks(page).iter().map(|b| (b.line, b.language, b.text)).collect();
    assert_eq!(found, [(3, "toml", "# a.toml\nx = 1\n"), (7, "console", "$ polhode --version\n")]);
    let names = [
        "# a.toml\n",
        "## b.csv\n",
        "<!-- arm.urdf -->\n",
        "3\n# hdo.xyz, water\n",
        "# a word\n",
        "x\n",
        "# 2 a.b\n",
    ];
    let found = names.map(file_name);
    assert_eq!(found, [Some("a.toml"), Some("b.csv"), Some("arm.urdf"), Some("hdo.xyz"), None, None, None]);
    assert_eq!(words("polhode spin --at \"1 s, 2 s\" ''"), ["polhode", "spin", "--at", "1 s, 2 s", ""]);
}
