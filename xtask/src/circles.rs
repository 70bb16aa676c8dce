//! Files that import each other in a circle.
//!
//! Only `use` lines are read, by module paths; a module and those inside it are one place, so that neither importing the other counts.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::{Outcome, files, read, root, short};

/// The modules that each module imports; both by their paths in the crate.
type Imports = BTreeMap<Vec<String>, BTreeSet<Vec<String>>>;

/// Looks for circles in every crate.
pub(crate) fn check() -> Outcome {
    let mut circles = Vec::new();
    let crates = root().join("crates");
    for entry in std::fs::read_dir(&crates).map_err(|error| format!("{}: {error}", short(&crates)))? {
        let sources = entry.map_err(|error| error.to_string())?.path().join("src");
        let mut texts = Vec::new();
        for path in files(&sources, "rs")?.into_iter().filter(|path| !path.ends_with("tests.rs")) {
            texts.push((module(path.strip_prefix(&sources).unwrap_or(&path)), read(&path)?));
        }
        let circle = circle(&imports(&texts));
        circles.extend(circle.map(|names| format!("\n  {}: {}", short(&sources), names.join(" → "))));
    }
    if circles.is_empty() {
        Ok(())
    } else {
        Err(format!("files import each other in a circle:{}", circles.concat()))
    }
}

/// The module of a file: `motion`, `model`, `rotor`.
fn module(file: &Path) -> Vec<String> {
    let text = file.with_extension("").to_string_lossy().replace('\\', "/");
    let names = text.split('/').filter(|name| !["mod", "lib", "main"].contains(name));
    names.map(str::to_owned).collect()
}

fn imports(texts: &[(Vec<String>, String)]) -> Imports {
    let modules: BTreeSet<&Vec<String>> = texts.iter().map(|(module, _)| module).collect();
    let one = |(here, text): &(Vec<String>, String)| {
        let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
        let all = used(code).into_iter().filter_map(|path| {
            let path = absolute(here, &path)?;
            // The longest path that is a file.
            let end = (0..=path.len()).rev().find(|end| modules.contains(&path[..*end].to_vec()))?;
            Some(path[..end].to_vec())
        });
        let others = all.filter(|other| !other.starts_with(here) && !here.starts_with(other));
        (here.clone(), others.collect())
    };
    texts.iter().map(one).collect()
}

/// The paths of all `use` lines, groups taken apart.
fn used(code: &str) -> Vec<Vec<String>> {
    let lines = code.split('\n').map(|line| line.split("//").next().unwrap_or_default().trim());
    let code: String = lines.collect::<Vec<_>>().join(" ");
    let mut paths = Vec::new();
    for start in code
        .match_indices("use ")
        .map(|(at, _)| at)
        .filter(|at| *at == 0 || code[..*at].ends_with([' ', ';', '}']))
    {
        let tree = code[start + 4..].split(';').next().unwrap_or_default();
        expand(&[], tree.trim(), &mut paths);
    }
    paths
}

/// The paths of a tree of `use`, after these names.
fn expand(before: &[String], tree: &str, paths: &mut Vec<Vec<String>>) {
    let (head, group) =
        tree.split_once('{').map_or((tree, None), |(head, group)| (head, group.strip_suffix('}')));
    let names = head.split("::").map(str::trim).filter(|name| !name.is_empty());
    let names: Vec<String> = before.iter().cloned().chain(names.map(str::to_owned)).collect();
    let Some(group) = group else { return paths.push(names) };
    let (mut depth, mut from) = (0_i32, 0);
    for (at, c) in group.char_indices().chain([(group.len(), ',')]) {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                let part = group[from..at].trim();
                if !part.is_empty() {
                    expand(&names, part, paths);
                }
                from = at + 1;
            }
            _ => {}
        }
    }
}

/// A path from the root of the crate; `None` of another crate's.
fn absolute(here: &[String], path: &[String]) -> Option<Vec<String>> {
    let ups = path.iter().take_while(|name| *name == "super").count();
    match path.first()?.as_str() {
        "crate" => Some(path[1..].to_vec()),
        "super" => Some(here[..here.len().saturating_sub(ups)].iter().chain(&path[ups..]).cloned().collect()),
        "self" => Some(here.iter().chain(&path[1..]).cloned().collect()),
        _ => None,
    }
}

/// The names along a circle, if there is one.
fn circle(imports: &Imports) -> Option<Vec<String>> {
    let mut left = imports.clone();
    // What imports nothing that is left is in no circle.
    while let Some(done) = left
        .iter()
        .find(|(_, others)| {
            others.iter().all(|other| !imports.contains_key(other) || !left.contains_key(other))
        })
        .map(|(module, _)| module.clone())
    {
        left.remove(&done);
    }
    let mut way = vec![left.keys().next()?.clone()];
    loop {
        let next = left[way.last()?].iter().find(|other| left.contains_key(*other))?.clone();
        let first = way.iter().position(|seen| *seen == next);
        way.push(next);
        if let Some(first) = first {
            return Some(way[first..].iter().map(|module| module.join("/")).collect());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(texts: &[(&str, &str)]) -> Option<Vec<String>> {
        let texts: Vec<_> =
            texts.iter().map(|(file, text)| (module(Path::new(file)), (*text).to_owned())).collect();
        circle(&imports(&texts))
    }

    #[test]
    fn circles_are_found_through_groups_and_relative_paths() {
        let a = ("a/one.rs", "use super::two::{Two, other};\n");
        let b = ("a/two.rs", "use crate::{\n    b::Three, // comment\n    c::{self, Four},\n};\n");
        let c = ("b.rs", "use crate::a::one::One;\n");
        assert_eq!(found(&[a, b, c, ("c.rs", "")]).unwrap(), ["a/one", "a/two", "b", "a/one"]);
        assert_eq!(found(&[a, b, ("b.rs", "use std::fmt;\n"), ("c.rs", "")]), None);
        // A module and what is inside it are one place; tests are free.
        let d = ("a/mod.rs", "use one::One;\nuse self::two::Two;\n");
        let tests = "#[cfg(test)]\nmod tests {\n    use crate::a::one::One;\n}\n";
        assert_eq!(found(&[a, d, ("a/two.rs", "use super::Member;\n"), ("b.rs", tests)]), None);
    }
}
