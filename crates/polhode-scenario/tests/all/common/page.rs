//! Tables and code blocks of the book's pages.

use std::fs;
use std::path::{Path, PathBuf};

pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Returns the names in `book/` of `scenario.md` and of the pages `scenario-….md`, in order.
pub fn scenario_pages() -> Vec<String> {
    let entries = fs::read_dir(root().join("book")).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut pages: Vec<_> = names
        .filter(|name| name == "scenario.md" || name.starts_with("scenario-") && name.ends_with(".md"))
        .collect();
    pages.sort();
    pages
}

/// Returns the text of all [`scenario_pages`]. Their headings of tables are unique.
pub fn scenario_reference() -> String {
    let pages = scenario_pages();
    pages.iter().map(|name| fs::read_to_string(root().join("book").join(name)).unwrap() + "\n").collect()
}

/// Returns the `toml` blocks of a page: number of the first line, true for a fragment, and the
/// text.
pub fn blocks(page: &str) -> Vec<(usize, bool, String)> {
    let mut found: Vec<(usize, bool, String)> = Vec::new();
    let mut inside = None;
    for (number, line) in (1..).zip(page.lines()) {
        match (inside, line.strip_prefix("```")) {
            (None, Some(language)) => {
                inside = Some(language);
                match language {
                    "toml" | "toml fragment" => found.push((number + 1, language != "toml", String::new())),
                    _ => assert!(!language.starts_with("toml"), "line {number}: {line}"),
                }
            }
            (Some(_), Some(_)) => inside = None,
            (Some("toml" | "toml fragment"), None) => {
                let (.., text) = found.last_mut().unwrap();
                *text += &format!("{line}\n");
            }
            _ => {}
        }
    }
    assert!(inside.is_none(), "a block is not closed");
    found
}

/// Returns the text from a heading to the next heading of any level.
pub fn section<'a>(page: &'a str, heading: &str) -> &'a str {
    let start = page.find(&format!("\n{heading}\n")).unwrap_or_else(|| panic!("no heading {heading:?}"));
    let text = &page[start + 1 + heading.len()..];
    &text[..text.find("\n#").unwrap_or(text.len())]
}

/// Returns the cells of the tables in a text, without the header rows.
pub fn rows(text: &str) -> Vec<Vec<&str>> {
    let mut rows = Vec::new();
    let mut above = "";
    for line in text.lines() {
        if line.starts_with("|---") {
            rows.pop();
        } else if let Some(row) = line.strip_prefix("| ").or(line.strip_prefix('|')) {
            rows.push(row.split('|').map(str::trim).collect());
        }
        assert!(!line.starts_with("|---") || above.starts_with("| "), "{line}");
        above = line;
    }
    rows
}

/// Returns the `names` in a cell.
pub fn names(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

#[test]
fn a_block_is_found_where_it_is() {
    let page = "a\n```toml\nx = 1\n\n[y]\n```\n```console\n$ z\n```\n```toml fragment\nw = 2\n```\n";
    assert_eq!(blocks(page), [(3, false, "x = 1\n\n[y]\n".into()), (11, true, "w = 2\n".into())]);
}
