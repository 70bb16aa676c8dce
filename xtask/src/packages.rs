//! Checks of the crates as packages: licences, README, and no paths to files outside.

use std::path::{Component, Path, PathBuf};

use crate::process::{build_folder, cargo, run};
use crate::{Outcome, files, read, root, short};

/// Packages every crate, and looks for paths that lead outside of it.
pub(crate) fn check() -> Outcome {
    package(&["--no-verify"])
}

/// Packages every crate of a commit, and compiles each from its package; returns the folder of the
/// packages.
///
/// Cargo keeps unpacked crates by version and build folder, so the commit is in the folder's name.
pub(crate) fn compiled(commit: &str) -> Result<PathBuf, String> {
    let folder = build_folder()?.with_file_name(format!("packages-{}", commit.trim()));
    package(&["--target-dir", &folder.to_string_lossy()])?;
    Ok(folder.join("package"))
}

fn package(options: &[&str]) -> Outcome {
    let crates = root().join("crates");
    let mut leaving = Vec::new();
    let mut count = 0;
    for entry in std::fs::read_dir(&crates).map_err(|error| format!("{}: {error}", short(&crates)))? {
        let folder = entry.map_err(|error| error.to_string())?.path();
        for needed in ["README.md", "LICENSE-MIT", "LICENSE-APACHE"] {
            read(&folder.join(needed))?;
        }
        for file in files(&folder.join("src"), "rs")? {
            let text = read(&file)?;
            let inside = file.strip_prefix(&folder).map_err(|error| error.to_string())?;
            leaving
                .extend(included(&text).filter(|path| leaves(inside, path)).map(|path| (short(&file), path)));
        }
        count += 1;
    }
    if !leaving.is_empty() {
        return Err(format!("files that are not in the package: {leaving:?}"));
    }
    let all = ["package", "--quiet", "--workspace", "--exclude", "xtask", "--locked", "--allow-dirty"];
    run(cargo(&all).args(options))?;
    println!("   {count} packages");
    Ok(())
}

/// Returns the paths in `include!`, `include_str!` and `include_bytes!`.
fn included(text: &str) -> impl Iterator<Item = String> {
    ["include!(\"", "include_str!(\"", "include_bytes!(\""].into_iter().flat_map(|name| {
        let paths = text.split(name).skip(1).filter_map(|rest| rest.split('"').next());
        paths.map(str::to_owned).collect::<Vec<_>>()
    })
}

/// Returns true if a path in a file of a package leads outside the package.
fn leaves(file: &Path, path: &str) -> bool {
    let mut depth = file.parent().map_or(0, |folder| folder.components().count());
    for part in Path::new(path).components() {
        match part {
            Component::ParentDir if depth == 0 => return true,
            Component::ParentDir => depth -= 1,
            Component::Normal(_) => depth += 1,
            _ => {}
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_leaves_by_as_many_steps_up_as_the_file_is_deep() {
        let text = "const A: &str = include_str!(\"../../assets/a.html\");";
        assert_eq!(included(text).collect::<Vec<_>>(), ["../../assets/a.html"]);
        assert!(!leaves(Path::new("src/page/mod.rs"), "../../assets/a.html"));
        assert!(leaves(Path::new("src/lib.rs"), "../../README.md"));
        assert!(!leaves(Path::new("src/lib.rs"), "../README.md"));
    }
}
