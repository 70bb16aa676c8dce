//! Check for circular uses between files and folders.
//!
//! The files and subfolders of one folder are nodes. A subfolder represents everything inside it: a
//! circle through its files is a circle through the subfolder.
//!
//! Uses in Rust are paths in `use` lines, expressions and types. A name that a module imports
//! leads to its origin. A module and its submodules are one place, so uses between them do not
//! count.
//!
//! Uses in Python and TypeScript are relative imports.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::{Outcome, files, read, root, short};

/// Path of a module from the root of its crate or package, such as `motion`, `model`, `rotor`.
type Module = Vec<String>;

/// Modules with their texts.
type Texts = [(Module, String)];

/// Uses by folder: for each node the nodes that it uses, each with a file that does so.
type Uses = BTreeMap<Module, BTreeMap<String, BTreeMap<String, Module>>>;

/// Names imported by each module, with their paths from the root of the crate.
type Taken = BTreeMap<Module, BTreeMap<String, Module>>;

/// Checks all crates, the Python package, the viewer, the npm package and the extension.
pub(crate) fn check() -> Outcome {
    let mut found = Vec::new();
    let crates = root().join("crates");
    for entry in std::fs::read_dir(&crates).map_err(|error| format!("{}: {error}", short(&crates)))? {
        let sources = entry.map_err(|error| error.to_string())?.path().join("src");
        found.extend(circles_of(&sources, "rs", |texts| uses(&rust(texts)))?);
    }
    let package = crates.join("polhode-py/python/polhode");
    found.extend(circles_of(&package, "py", |texts| imports(texts, python))?);
    for sources in ["viewer/src", "npm/src", "integrations/vscode/src"] {
        found.extend(circles_of(&root().join(sources), "ts", |texts| imports(texts, typescript))?);
    }
    if found.is_empty() {
        Ok(())
    } else {
        Err(format!("files or folders use each other in a circle:{}", found.concat()))
    }
}

/// Describes all circles of the files below a folder.
fn circles_of(sources: &Path, extension: &str, uses: impl Fn(&Texts) -> Uses) -> Result<Vec<String>, String> {
    let mut texts = Vec::new();
    for path in files(sources, extension)? {
        texts.push((place(path.strip_prefix(sources).unwrap_or(&path)), read(&path)?));
    }
    let circles = circles(&uses(&texts)).into_iter();
    Ok(circles.map(|circle| format!("\n  {}: {circle}", short(sources))).collect())
}

/// Returns the path of a file without its extension.
fn place(file: &Path) -> Module {
    let text = file.with_extension("").to_string_lossy().replace('\\', "/");
    text.split('/').map(str::to_owned).collect()
}

/// Returns the modules of Rust files with their code, without tests.
fn rust(texts: &Texts) -> Vec<(Module, String)> {
    let is_module = |name: &String| !["mod", "lib", "main"].contains(&name.as_str());
    let of_program = texts.iter().filter(|(place, _)| !place.iter().any(|name| name == "tests"));
    of_program
        .map(|(place, text)| (place.iter().filter(|name| is_module(name)).cloned().collect(), code(text)))
        .collect()
}

/// Returns the uses of files with relative imports.
fn imports(texts: &Texts, imported: impl Fn(&[String], &str) -> Vec<Module>) -> Uses {
    let modules: BTreeSet<&Module> = texts.iter().map(|(module, _)| module).collect();
    let mut uses = Uses::new();
    for (here, text) in texts {
        let folder = &here[..here.len().saturating_sub(1)];
        for there in imported(folder, text).iter().filter(|there| modules.contains(there)) {
            add(&mut uses, here, there);
        }
    }
    uses
}

/// Returns the modules imported by `from .` in a Python file of this folder.
fn python(folder: &[String], text: &str) -> Vec<Module> {
    let mut paths = Vec::new();
    for (at, start) in text.match_indices("from .") {
        let is_line = text[..at].rsplit('\n').next().is_some_and(|before| before.trim().is_empty());
        let Some((from, names)) = text[at + start.len()..].split_once(" import ").filter(|_| is_line) else {
            continue;
        };
        let path = |name: &str| folder.iter().cloned().chain(name.split('.').map(str::to_owned)).collect();
        if !from.is_empty() {
            paths.push(path(from));
            continue;
        }
        let names = match names.strip_prefix('(') {
            Some(group) => group.split(')').next(),
            None => names.lines().next(),
        };
        let names = names.unwrap_or_default().split(',').filter_map(|name| name.split_whitespace().next());
        paths.extend(names.map(path));
    }
    paths
}

/// Returns the files imported by a TypeScript file of this folder.
fn typescript(folder: &[String], text: &str) -> Vec<Module> {
    let path = |name: &str| {
        let mut path = folder.to_vec();
        for part in name.trim_end_matches(".js").split('/').filter(|part| *part != ".") {
            if part == ".." {
                path.pop();
            } else {
                path.push(part.to_owned());
            }
        }
        path
    };
    let is_import = |at: usize| ["from ", "import ", "import("].iter().any(|word| text[..at].ends_with(word));
    let names = text.match_indices("\".").filter(|(at, _)| is_import(*at));
    names.filter_map(|(at, _)| text[at + 1..].split('"').next()).map(path).collect()
}

/// Returns the code of a file on one line, without comments and tests.
fn code(text: &str) -> String {
    let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
    let lines = code.split('\n').map(|line| line.split("//").next().unwrap_or_default().trim());
    lines.collect::<Vec<_>>().join(" ")
}

/// Returns the uses of Rust modules.
fn uses(texts: &Texts) -> Uses {
    let modules: BTreeSet<&Module> = texts.iter().map(|(module, _)| module).collect();
    let taken: Taken = texts.iter().map(|(here, code)| (here.clone(), taken(here, code, &modules))).collect();
    let mut uses = Uses::new();
    for (here, code) in texts {
        let by_name = |path: &[String]| {
            let from = taken.get(here)?.get(path.first()?)?;
            Some(from.iter().chain(&path[1..]).cloned().collect())
        };
        let lines = used(code).into_iter().filter_map(|(path, _)| absolute(here, &path));
        let others =
            named(code).into_iter().filter_map(|path| absolute(here, &path).or_else(|| by_name(&path)));
        for there in lines.chain(others).filter_map(|path| target(path, &modules, &taken)) {
            add(&mut uses, here, &there);
        }
    }
    uses
}

/// Adds a use between two nodes of the innermost folder that contains both modules.
fn add(uses: &mut Uses, here: &Module, there: &Module) {
    let shared = here.iter().zip(there).take_while(|(a, b)| a == b).count();
    if let (Some(from), Some(to)) = (here.get(shared), there.get(shared)) {
        let folder = uses.entry(here[..shared].to_vec()).or_default();
        folder.entry(from.clone()).or_default().entry(to.clone()).or_insert_with(|| here.clone());
    }
}

/// Returns the module that defines the item at a path, following imported names.
fn target(mut path: Module, modules: &BTreeSet<&Module>, taken: &Taken) -> Option<Module> {
    /// Largest number of imports in a chain.
    const MOST: usize = 16;
    for _ in 0..MOST {
        let end = (0..=path.len()).rev().find(|end| modules.contains(&path[..*end].to_vec()))?;
        let (module, rest) = path.split_at(end);
        let from = rest.first().and_then(|name| taken.get(module)?.get(name));
        match from {
            Some(from) => path = from.iter().chain(&rest[1..]).cloned().collect(),
            None => return Some(module.to_vec()),
        }
    }
    None
}

/// Returns the names that a module imports from its crate.
fn taken(here: &Module, code: &str, modules: &BTreeSet<&Module>) -> BTreeMap<String, Module> {
    let one = |(path, name): (Vec<String>, String)| {
        let inner: Module = here.iter().chain(path.first()).cloned().collect();
        let path = match absolute(here, &path) {
            Some(path) => path,
            None if modules.contains(&inner) => here.iter().chain(&path).cloned().collect(),
            None => return None,
        };
        let own: Module = here.iter().chain([&name]).cloned().collect();
        (path != own).then_some((name, path))
    };
    used(code).into_iter().filter_map(one).collect()
}

/// Returns the paths of all `use` lines, one for each name of a group, with the imported name.
fn used(code: &str) -> Vec<(Vec<String>, String)> {
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

/// Adds the paths of a tree of `use`, after the path `before`.
fn expand(before: &[String], tree: &str, paths: &mut Vec<(Vec<String>, String)>) {
    let (head, group) =
        tree.split_once('{').map_or((tree, None), |(head, group)| (head, group.strip_suffix('}')));
    let (head, renamed) = head.split_once(" as ").map_or((head, None), |(head, name)| (head, Some(name)));
    let names = head.split("::").map(str::trim).filter(|name| !name.is_empty());
    let mut names: Vec<String> = before.iter().cloned().chain(names.map(str::to_owned)).collect();
    let Some(group) = group else {
        names.pop_if(|last| last == "self" && !before.is_empty());
        let name =
            renamed.map_or_else(|| names.last().cloned().unwrap_or_default(), |name| name.trim().to_owned());
        return paths.push((names, name));
    };
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

/// Returns the paths in expressions and types, except those of `pub(in …)`.
fn named(code: &str) -> Vec<Vec<String>> {
    let is_of_name = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let code = code.replace("(in ", "(in:");
    let paths = code.split(|c| !is_of_name(c)).filter(|path| path.contains("::") && !path.starts_with("in:"));
    paths.map(|path| path.split("::").filter(|name| !name.is_empty()).map(str::to_owned).collect()).collect()
}

/// Returns the path from the root of the crate; `None` for a path into another crate.
fn absolute(here: &Module, path: &[String]) -> Option<Module> {
    let ups = path.iter().take_while(|name| *name == "super").count();
    match path.first()?.as_str() {
        "crate" => Some(path[1..].to_vec()),
        "super" => Some(here[..here.len().saturating_sub(ups)].iter().chain(&path[ups..]).cloned().collect()),
        "self" => Some(here.iter().chain(&path[1..]).cloned().collect()),
        _ => None,
    }
}

/// Describes one circle for each folder that has any: its nodes, each with the file that uses the
/// next.
fn circles(uses: &Uses) -> Vec<String> {
    let one = |(folder, nodes): (&Module, &BTreeMap<String, BTreeMap<String, Module>>)| {
        let way = circle(nodes)?;
        let step = |pair: &[String]| Some(format!("{} → ", nodes.get(&pair[0])?.get(&pair[1])?.join("/")));
        let steps: String = way.windows(2).filter_map(step).collect();
        let first = folder.iter().chain(way.first()).cloned().collect::<Vec<_>>().join("/");
        Some(steps + &first)
    };
    uses.iter().filter_map(one).collect()
}

/// Returns the nodes of a circle, with the first repeated at the end; `None` without a circle.
fn circle(nodes: &BTreeMap<String, BTreeMap<String, Module>>) -> Option<Vec<String>> {
    let mut left: BTreeSet<&String> = nodes.keys().collect();
    let next = |node: &String, left: &BTreeSet<&String>| {
        nodes.get(node)?.keys().find(|other| left.contains(other)).cloned()
    };
    // A node that uses no remaining node is not part of a circle.
    while let Some(done) = left.iter().copied().find(|node| next(node, &left).is_none()) {
        left.remove(done);
    }
    let mut way = vec![(*left.first()?).clone()];
    loop {
        let node = next(way.last()?, &left)?;
        let first = way.iter().position(|seen| *seen == node);
        way.push(node);
        if let Some(first) = first {
            return Some(way.split_off(first));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(files: &[(&str, &str)]) -> Vec<(Module, String)> {
        files.iter().map(|(file, text)| (place(Path::new(file)), (*text).to_owned())).collect()
    }

    fn found(files: &[(&str, &str)]) -> Vec<String> {
        circles(&uses(&rust(&texts(files))))
    }

    #[test]
    fn circles_are_found_through_groups_and_relative_paths() {
        let a = ("a.rs", "use super::b::{Two, other};\n");
        let b = ("b.rs", "use crate::{\n    c::Three, // comment\n    d::{self, Four},\n};\n");
        let c = ("c.rs", "use crate::a::One;\n");
        assert_eq!(found(&[a, b, c, ("d.rs", "")]), ["a → b → c → a"]);
        assert!(found(&[a, b, ("c.rs", "use std::fmt;\n"), ("d.rs", "")]).is_empty());
        // A module and its submodules are one place, and tests do not count.
        let e = ("a/mod.rs", "use one::One;\nuse self::two::Two;\n");
        let tests = "#[cfg(test)]\nmod tests {\n    use crate::a::one::One;\n}\n";
        assert!(
            found(&[e, ("a/one.rs", ""), ("a/two.rs", "use super::Member;\n"), ("b.rs", tests)]).is_empty()
        );
    }

    #[test]
    fn a_folder_is_one_node_among_its_siblings() {
        let a = ("m/a/one.rs", "use crate::m::b::Two;\n");
        let b = ("m/b.rs", "use super::a::two::Three;\n");
        let files = [("m/mod.rs", ""), ("m/a/mod.rs", ""), ("m/a/two.rs", ""), a, b];
        assert_eq!(found(&files), ["m/a/one → m/b → m/a"]);
    }

    #[test]
    fn paths_in_expressions_count_and_visibilities_do_not() {
        let a = ("a.rs", "fn one() -> crate::b::Two {\n    super::b::two(1)\n}\n");
        assert_eq!(found(&[a, ("b.rs", "fn two() {\n    crate::a::one();\n}\n")]), ["a → b → a"]);
        assert!(found(&[a, ("b.rs", "pub(in crate::a) fn two() {}\n")]).is_empty());
    }

    #[test]
    fn names_that_a_module_takes_lead_to_their_files() {
        let root = ("m/mod.rs", "mod a;\npub use a::One;\npub use self::b::Two as Other;\n");
        let files = [root, ("m/a.rs", "use super::Other;\n"), ("m/b.rs", "use super::{One, other};\n")];
        assert_eq!(found(&files), ["m/a → m/b → m/a"]);
    }

    #[test]
    fn a_name_that_a_file_takes_begins_paths_in_expressions() {
        let a = ("m/a.rs", "use crate::m;\nfn one() {\n    m::b::two();\n}\n");
        let b = ("m/b.rs", "fn two() {\n    super::a::one();\n}\n");
        assert_eq!(found(&[("m/mod.rs", ""), a, b]), ["m/a → m/b → m/a"]);
    }

    #[test]
    fn imports_of_python_are_read() {
        let found = |files: &[(&str, &str)]| circles(&imports(&texts(files), python));
        let a = ("_a.py", "def one():\n    from . import (\n        _native,\n        _b as other,\n    )\n");
        let b = ("_b.py", "from ._a import one  # later\n");
        assert_eq!(found(&[("__init__.py", "from ._a import one\n"), a, b]), ["_a → _b → _a"]);
        assert!(found(&[a, ("_b.py", "\"\"\"\n>>> from ._a import one\n\"\"\"\n")]).is_empty());
    }

    #[test]
    fn imports_of_typescript_are_read() {
        let found = |files: &[(&str, &str)]| circles(&imports(&texts(files), typescript));
        let a = ("scene/a.ts", "import type { Two } from \"../save/b\";\n");
        let b = ("save/b.ts", "const one = await import(\"../scene/c\");\nimport { d } from \"./d\";\n");
        let others = [("scene/c.ts", ""), ("save/d.ts", "import { gone } from \"three\";\n")];
        assert_eq!(found(&[a, b, others[0], others[1]]), ["save/b → scene/a → save"]);
        assert!(found(&[a, ("save/b.ts", "const text = \"../scene/c\";\n"), others[0]]).is_empty());
    }
}
