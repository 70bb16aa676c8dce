//! Checks which crates use which.
//!
//! A ground crate uses no slice, and a slice uses no other slice except shape and scenario.

use crate::{Outcome, read, root};

/// Crates, each with the crates that it may use.
const MAY_USE: [(&str, &[&str]); 20] = [
    ("polhode", &[]),
    ("polhode-algebra", &[]),
    ("polhode-source", &["polhode"]),
    ("polhode-document", &["polhode"]),
    ("polhode-table", &["polhode", "polhode-source"]),
    ("polhode-shape", &GROUND),
    ("polhode-course", &["polhode", "polhode-algebra", "polhode-source", "polhode-document"]),
    ("polhode-scenario", &WITH_SHAPE_AND_ALGEBRA),
    ("polhode-robot", WITH_SHAPE),
    ("polhode-judge", &SLICE),
    ("polhode-identify", &SLICE),
    ("polhode-budget", &SLICE),
    ("polhode-sweep", &SLICE),
    ("polhode-web", FRONT.split_at(11).0),
    ("polhode-npm", FRONT.split_at(7).0),
    ("polhode-wasm", &["polhode-source", "polhode-web", "polhode-npm"]),
    ("polhode-live", &["polhode-source", "polhode-web"]),
    ("polhode-mcp", FRONT.split_at(8).0),
    ("polhode-cli", FRONT.split_at(15).0),
    ("polhode-py", &FRONT),
];

const GROUND: [&str; 4] = ["polhode", "polhode-source", "polhode-document", "polhode-table"];
const WITH_SHAPE: &[&str] = WITH_SHAPE_AND_ALGEBRA.split_at(5).0;
const WITH_SHAPE_AND_ALGEBRA: [&str; 6] =
    ["polhode", "polhode-source", "polhode-document", "polhode-table", "polhode-shape", "polhode-algebra"];
const SLICE: [&str; 6] =
    ["polhode", "polhode-source", "polhode-document", "polhode-table", "polhode-shape", "polhode-scenario"];
const FRONT: [&str; 16] = [
    "polhode",
    "polhode-source",
    "polhode-document",
    "polhode-table",
    "polhode-shape",
    "polhode-scenario",
    "polhode-robot",
    "polhode-judge",
    "polhode-identify",
    "polhode-budget",
    "polhode-course",
    "polhode-sweep",
    "polhode-web",
    "polhode-live",
    "polhode-mcp",
    "polhode-cli",
];

/// Checks the manifests of all crates.
pub(crate) fn check() -> Outcome {
    let mut found = Vec::new();
    let folder = root().join("crates");
    for entry in std::fs::read_dir(&folder).map_err(|error| format!("crates: {error}"))? {
        let path = entry.map_err(|error| error.to_string())?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        found.extend(wrong(&name, &read(&path.join("Cargo.toml"))?));
    }
    if found.is_empty() { Ok(()) } else { Err(format!("crates use what they may not:{}", found.concat())) }
}

/// Returns the forbidden dependencies in a crate's manifest; dependencies of tests are not
/// restricted.
fn wrong(name: &str, manifest: &str) -> Vec<String> {
    let Some((_, allowed)) = MAY_USE.iter().find(|(known, _)| *known == name) else {
        return vec![format!("\n  {name} has no line in the list of crates")];
    };
    let mut section = "";
    let mut found = Vec::new();
    for line in manifest.lines() {
        if line.starts_with('[') {
            section = line;
        }
        let used = line.split(['.', ' ', '=']).next().unwrap_or_default();
        let is_ours = used == "polhode" || used.starts_with("polhode-");
        let is_dependency = section.ends_with("dependencies]") && !section.contains("dev-");
        if is_dependency && is_ours && !allowed.contains(&used) {
            found.push(format!("\n  {name} may not use {used}"));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arrow_between_subjects_is_found() {
        let manifest = "[dependencies]\npolhode.workspace = true\npolhode-budget.workspace = true\n\
                        [dev-dependencies]\npolhode-cli.workspace = true\n";
        assert_eq!(wrong("polhode-judge", manifest), ["\n  polhode-judge may not use polhode-budget"]);
        assert_eq!(wrong("polhode-cli", manifest), Vec::<String>::new());
        assert_eq!(wrong("polhode-new", manifest).len(), 1);
    }

    #[test]
    fn nothing_is_used_both_ways() {
        for (name, allowed) in MAY_USE {
            for other in allowed {
                let (_, back) = MAY_USE.iter().find(|(known, _)| known == other).unwrap();
                assert!(!back.contains(&name), "{name} {other}");
            }
        }
    }
}
