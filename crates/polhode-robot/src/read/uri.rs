//! Where the files are that a model names: under the roots, or nowhere.

use std::fs;
use std::path::{Component, Path, PathBuf};

use crate::read::ReadOptions;
use crate::read::xml::{Element, with_root};

/// Folders that a model's files may lie in.
#[derive(Debug)]
pub(super) struct Roots {
    /// The model's own folder, if it can be said.
    folder: Option<PathBuf>,
    /// All of them, canonical, each with the names of the package that it is.
    roots: Vec<(PathBuf, Vec<String>)>,
}

impl Roots {
    /// The roots of a model: its own folder; the nearest folder around it that is a package, having `package.xml` or
    /// `model.config`; and those that the user gives, or these alone.
    pub(super) fn of(model: &Path, options: &ReadOptions) -> Self {
        let folder =
            model.parent().map(|folder| if folder.as_os_str().is_empty() { Path::new(".") } else { folder });
        let folder = folder.and_then(|folder| fs::canonicalize(folder).ok());
        let package =
            folder.as_deref().and_then(|folder| folder.ancestors().find(|folder| is_package(folder)));
        // a model's own package is what it means by that name, wherever others of the name are
        let mut roots: Vec<PathBuf> = Vec::new();
        if !options.confined {
            roots.extend(package.map(Path::to_owned));
            roots.extend(folder.clone());
        }
        roots.extend(options.roots.iter().filter_map(|root| fs::canonicalize(root).ok()));
        let mut seen = std::collections::HashSet::new();
        roots.retain(|root| seen.insert(root.clone()));
        let holds = |path: &Path| roots.iter().any(|root| path.starts_with(root));
        let roots = roots.iter().map(|root| (root.clone(), names(root, holds))).collect();
        Self { folder, roots }
    }

    /// The file that a URI names, canonical, or why it cannot be said. Nothing outside the roots is looked at.
    ///
    /// `within` is a folder below the model's own that relative paths start at: `meshdir` of MJCF.
    pub(super) fn resolve(&self, uri: &str, within: &Path) -> Result<PathBuf, String> {
        self.resolved(uri, within, |file| file.is_file().then(|| file.to_owned()))
    }

    /// The SDF file of a model that a URI names: itself a file, or a folder whose `model.config` says which.
    pub(super) fn resolve_model(&self, uri: &str, within: &Path) -> Result<PathBuf, String> {
        self.resolved(uri.trim_end_matches('/'), within, |found| {
            if found.is_file() {
                return Some(found.to_owned());
            }
            let file = model_file(found, |path| self.holds(path))
                .and_then(|file| fs::canonicalize(found.join(file)).ok())?;
            (self.holds(&file) && file.is_file()).then_some(file)
        })
    }

    /// What a URI names, taken as `take` takes it.
    fn resolved(
        &self,
        uri: &str,
        within: &Path,
        take: impl Fn(&Path) -> Option<PathBuf>,
    ) -> Result<PathBuf, String> {
        if uri.is_empty() {
            return Err("no file is named".to_owned());
        }
        let candidates = match uri.split_once("://") {
            Some(("package" | "model", rest)) => {
                let (package, path) = rest.split_once('/').unwrap_or((rest, ""));
                self.in_package(package, path)
            }
            Some(("file", rest)) if rest.starts_with('/') => vec![PathBuf::from(rest)],
            // sloppy, but common: file://meshes/arm.stl
            Some(("file", rest)) => self.beside(Path::new(rest), within),
            Some((scheme, _)) => return Err(format!("{scheme}:// is not looked up")),
            None => self.beside(Path::new(uri), within),
        };
        let mut outside = false;
        for candidate in candidates {
            let candidate = lexical(&candidate);
            if !self.holds(&candidate) {
                outside = true;
                continue;
            }
            match fs::canonicalize(&candidate) {
                Ok(file) if self.holds(&file) => {
                    if let Some(file) = take(&file) {
                        return Ok(file);
                    }
                }
                Ok(_) => outside = true,
                Err(_) => {}
            }
        }
        Err(match (outside, uri.starts_with("package://") || uri.starts_with("model://")) {
            (true, _) => "it lies outside the roots; --root DIR adds one".to_owned(),
            (false, true) => {
                "no root holds it; --root DIR adds one, a package or the folder around it".to_owned()
            }
            (false, false) => "there is no such file".to_owned(),
        })
    }

    /// ROOT/… for the root that is the package, ROOT/PACKAGE/… for the others.
    fn in_package(&self, package: &str, path: &str) -> Vec<PathBuf> {
        let mut candidates = Vec::new();
        for (root, names) in &self.roots {
            if names.iter().any(|name| name == package) {
                candidates.push(root.join(path));
            }
            candidates.push(root.join(package).join(path));
        }
        candidates
    }

    fn beside(&self, path: &Path, within: &Path) -> Vec<PathBuf> {
        self.folder.iter().map(|folder| folder.join(within).join(path)).collect()
    }

    fn holds(&self, path: &Path) -> bool {
        self.roots.iter().any(|(root, _)| path.starts_with(root))
    }
}

/// Whether ROS or Gazebo would call the folder a package or a model.
fn is_package(folder: &Path) -> bool {
    ["package.xml", "model.config"].iter().any(|file| folder.join(file).is_file())
}

/// The file that `model.config` names: of several, that of the latest SDFormat, as libsdformat takes it. Without one, `model.sdf`.
fn model_file(folder: &Path, holds: impl Fn(&Path) -> bool) -> Option<String> {
    /// It has some hundred bytes.
    const MOST: u64 = 1 << 16;
    // It may be a link to somewhere else.
    let Ok(config) = fs::canonicalize(folder.join("model.config")) else {
        return Some("model.sdf".to_owned());
    };
    if !holds(&config) || !config.is_file() {
        return None;
    }
    let mut text = String::new();
    let file = fs::File::open(config).ok()?;
    std::io::Read::read_to_string(&mut std::io::Read::take(file, MOST), &mut text).ok()?;
    let named = with_root(&text, |root| {
        let version = |element: &Element<'_>| {
            let version = element.word("version").unwrap_or("0");
            let (major, minor) = version.split_once('.').unwrap_or((version, "0"));
            (major.parse::<u32>().unwrap_or(0), minor.parse::<u32>().unwrap_or(0))
        };
        let latest = root.named("sdf").max_by_key(version);
        Ok(latest.and_then(Element::text).map(|text| text.value.to_owned()))
    });
    named.ok().flatten()
}

/// What a root is called as a package: its last component, and the name in its `package.xml`.
fn names(root: &Path, holds: impl Fn(&Path) -> bool) -> Vec<String> {
    /// A package file is some hundred bytes; its name stands near the start.
    const MOST: u64 = 1 << 16;
    let mut names: Vec<String> =
        root.file_name().map(|name| name.to_string_lossy().into_owned()).into_iter().collect();
    let mut text = String::new();
    // It may be a link to somewhere else.
    let file = fs::canonicalize(root.join("package.xml")).ok().filter(|file| holds(file) && file.is_file());
    if let Some(file) = file.and_then(|file| fs::File::open(file).ok())
        && std::io::Read::read_to_string(&mut std::io::Read::take(file, MOST), &mut text).is_ok()
        && let Some((_, rest)) = text.split_once("<name>")
        && let Some((name, _)) = rest.split_once("</name>")
    {
        names.push(name.trim().to_owned());
    }
    names
}

/// The path without `.` and `..`, by its words alone.
fn lexical(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir => {
                plain.pop();
            }
            other => plain.push(other),
        }
    }
    plain
}
