//! What a file says besides its parts.

use polhode_budget::{Group, GrowthTable};

use super::Questions;
use crate::error::FormatError;
use crate::scenario::reader::Table;
use crate::scenario::source::Source;
use crate::scenario::tree;

/// What a file says besides its parts.
#[derive(Debug, Default)]
pub(super) struct Plan {
    pub(super) title: Option<String>,
    pub(super) questions: Questions,
    pub(super) groups: Vec<Group>,
    pub(super) growth: GrowthTable,
}

/// The head of a CSV, and where its table begins.
pub(super) fn of_head(source: Source<'_>) -> Result<(Plan, usize), FormatError> {
    // With blanks for all that is no TOML, so that places are those of the file.
    let mut toml = String::new();
    let mut end = 0;
    for line in source.text.split_inclusive('\n') {
        let mark = if end == 0 && line.starts_with('\u{feff}') { 3 } else { 0 };
        let content = &line[mark..];
        if let Some(rest) = content.trim_start().strip_prefix('#') {
            toml.extend(std::iter::repeat_n(' ', line.len() - rest.len()));
            toml.push_str(rest);
        } else if content.trim().is_empty() {
            toml.extend(std::iter::repeat_n(' ', line.trim_end().len()));
            toml.push_str(&line[line.trim_end().len()..]);
        } else {
            end += mark;
            break;
        }
        end += line.len();
    }
    let entries = tree::parse(&toml).map_err(|error| source.syntax(&error))?;
    let root = Table::root(source, &entries);
    Ok((plan(&root)?, end))
}

fn plan(root: &Table<'_>) -> Result<Plan, FormatError> {
    root.allow(&["title"])?;
    let title = root.get("title").map(|title| title.string().map(str::to_owned)).transpose()?;
    Ok(Plan { title, ..Plan::default() })
}
