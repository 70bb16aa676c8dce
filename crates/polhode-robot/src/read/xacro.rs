//! Files with the macros of an expanded model: the xacro file, and the files that it includes.
//!
//! Nothing is evaluated. `<xacro:include filename="…">` is followed where the name is a path, or a
//! path in `$(find PACKAGE)`; one with another expression leaves the files incomplete.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use polhode_source::files::Files;
use polhode_source::read_text_file;

use super::uri::Roots;
use super::xml::with_root;
use crate::model::{Expansion, RobotModel, Source};

/// Maximum number of files with macros.
const MOST_FILES: usize = 1000;

/// Returns the name of the text that a macro file expands to.
pub(super) fn expanded(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(" (expanded)");
    name.into()
}

/// Adds the macro file and its included files to a model that was expanded from it.
pub(super) fn add_sources(model: &mut RobotModel, files: &dyn Files, roots: &Roots<'_>, expanded: PathBuf) {
    let end = model.included.last().map_or(model.text.len(), |source| source.start + source.text.len());
    let mut next = end + 1;
    let mut is_whole = true;
    let mut waiting = vec![model.path.clone()];
    let mut seen: HashSet<PathBuf> = files.canonical(&model.path).into_iter().collect();
    let mut number = 0;
    while let Some(path) = waiting.get(number).cloned() {
        number += 1;
        let text = read_text_file(files, &path, |text| Ok(text.to_owned()));
        let named = |text: String| included(&text).map(|included| (text, included));
        let Some((text, included)) = text.ok().and_then(named) else {
            is_whole = false;
            continue;
        };
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        for name in included {
            let folder = files.canonical(folder).unwrap_or_else(|_| folder.to_owned());
            match uri(&name).and_then(|uri| roots.resolve(&uri, &folder).ok()) {
                Some(file) if waiting.len() < MOST_FILES => {
                    if seen.insert(file.clone()) {
                        waiting.push(file);
                    }
                }
                _ => is_whole = false,
            }
        }
        let start = next;
        next += text.len() + 1;
        model.included.push(Source { path, text, start });
    }
    model.expansion = Some(Expansion { path: expanded, is_whole });
}

/// Returns the names of the files that a macro file includes; `None` if it is not XML.
fn included(text: &str) -> Option<Vec<String>> {
    let names = with_root(text, |root| {
        let (mut names, mut waiting) = (Vec::new(), vec![root]);
        while let Some(element) = waiting.pop() {
            if matches!(element.name(), "xacro_include" | "include")
                && let Some(name) = element.word("filename")
            {
                names.push(name.to_owned());
            }
            waiting.extend(element.children());
        }
        Ok(names)
    });
    names.ok()
}

/// Returns the URI of an included file; `None` if its name has to be evaluated.
fn uri(name: &str) -> Option<String> {
    let name = name.trim();
    let uri = match name.strip_prefix("$(find ").and_then(|rest| rest.split_once(')')) {
        Some((package, path)) => format!("package://{}/{}", package.trim(), path.trim_start_matches('/')),
        None => name.to_owned(),
    };
    (!uri.contains('$')).then_some(uri)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_names_without_expressions_are_files() {
        assert_eq!(uri("leg.xacro").as_deref(), Some("leg.xacro"));
        assert_eq!(uri("$(find  arm)/urdf/a.xacro").as_deref(), Some("package://arm/urdf/a.xacro"));
        assert_eq!(uri("$(find arm)/${model}.xacro"), None);
        assert_eq!(uri("$(arg file)"), None);
    }
}
