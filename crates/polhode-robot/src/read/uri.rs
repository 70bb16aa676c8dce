//! Lookup of the files that a model names: below the roots, in the checked folder, or in an
//! ancestor folder that is the package.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use polhode_source::files::Files;

use crate::model::{GeometryShape, Note, RobotModel};
use crate::read::ReadOptions;
use crate::read::checked::CheckedFolder;
use crate::read::package::package_name;
use crate::read::xml::{Element, with_root};

/// Folders that a model's files may be in.
#[derive(Debug)]
pub(super) struct Roots<'a> {
    pub(super) files: &'a dyn Files,
    /// Canonical path of the model's own folder, if it exists.
    folder: Option<PathBuf>,
    /// Canonical paths of all roots, each with its names as a package.
    roots: Vec<(PathBuf, Vec<String>)>,
    /// True if no file is searched elsewhere.
    confined: bool,
    checked: Option<Arc<CheckedFolder>>,
    /// Packages found outside the roots: the location in words, by the start of their URIs.
    found: RefCell<BTreeMap<String, String>>,
}

impl<'a> Roots<'a> {
    /// Collects the roots of a model: its own folder; the nearest enclosing package, which has a
    /// `package.xml` or `model.config`; and the roots given by the user. If confined, only the
    /// last.
    pub(super) fn of(model: &Path, options: &ReadOptions<'a>) -> Self {
        let files = options.files;
        let folder =
            model.parent().map(|folder| if folder.as_os_str().is_empty() { Path::new(".") } else { folder });
        let folder = folder.and_then(|folder| files.canonical(folder).ok());
        let package =
            folder.as_deref().and_then(|folder| folder.ancestors().find(|folder| is_package(files, folder)));
        // The model's own package takes precedence over others of the same name.
        let mut roots: Vec<PathBuf> = Vec::new();
        if !options.confined {
            roots.extend(package.map(Path::to_owned));
            roots.extend(folder.clone());
        }
        roots.extend(options.roots.iter().filter_map(|root| files.canonical(root).ok()));
        let mut seen = std::collections::HashSet::new();
        roots.retain(|root| seen.insert(root.clone()));
        let holds = |path: &Path| roots.iter().any(|root| path.starts_with(root));
        let roots = roots.iter().map(|root| (root.clone(), names(files, root, holds))).collect();
        let confined = options.confined;
        let checked = options.checked.clone().filter(|_| !confined);
        Self { files, folder, roots, confined, checked, found: RefCell::default() }
    }

    /// Returns the canonical path of the model's own folder.
    pub(super) const fn folder(&self) -> &Option<PathBuf> {
        &self.folder
    }

    /// Adds notes for packages that were found outside the roots.
    pub(super) fn report(&self, model: &mut RobotModel) {
        let shapes = || model.links.iter().flat_map(|link| &link.geometry).map(|geometry| &geometry.shape);
        let note = |(start, found): (&String, &String)| {
            let span = shapes().find_map(|shape| match shape {
                GeometryShape::Mesh { uri, path: Ok(_), .. } if uri.text.starts_with(start) => {
                    Some(uri.span.clone())
                }
                _ => None,
            });
            Note::new("read.package", "", span.unwrap_or(0..0), format!("{start}… {found}"))
        };
        let notes: Vec<Note> = self.found.borrow().iter().map(note).collect();
        model.notes.extend(notes);
    }

    /// Returns the canonical path of the file that a URI names, or the reason why it is not found.
    /// No file outside the roots is accessed.
    ///
    /// `within` is the canonical path of the folder at which relative paths start: the model's own,
    /// or `meshdir` of MJCF.
    pub(super) fn resolve(&self, uri: &str, within: &Path) -> Result<PathBuf, String> {
        self.resolved(uri, within, |file| self.files.is_file(file).then(|| file.to_owned()))
    }

    /// Returns the SDF file of a model that a URI names: the file itself, or the file that the
    /// folder's `model.config` names.
    pub(super) fn resolve_model(&self, uri: &str, within: &Path) -> Result<PathBuf, String> {
        self.resolved(uri.trim_end_matches('/'), within, |found| {
            if self.files.is_file(found) {
                return Some(found.to_owned());
            }
            let file = model_file(self.files, found, |path| self.holds(path))
                .and_then(|file| self.files.canonical(&found.join(file)).ok())?;
            (self.holds(&file) && self.files.is_file(&file)).then_some(file)
        })
    }

    /// Returns the first candidate path of a URI that `take` accepts.
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
            // Incorrect but common: file://meshes/arm.stl.
            Some(("file", rest)) => self.beside(Path::new(rest), within),
            Some((scheme, _)) => return Err(format!("{scheme}:// addresses are not opened")),
            None => self.beside(Path::new(uri), within),
        };
        let mut outside = false;
        for candidate in candidates {
            match self.opened(&candidate, None) {
                Ok(file) => {
                    if let Some(file) = take(&file) {
                        return Ok(file);
                    }
                }
                Err(is_outside) => outside |= is_outside,
            }
        }
        if let Some(file) = self.elsewhere(uri, &take)? {
            return Ok(file);
        }
        Err(match (outside, uri.starts_with("package://") || uri.starts_with("model://")) {
            (true, _) => "it is outside the roots; --root DIR adds a root".to_owned(),
            (false, true) => {
                "no root contains it; --root DIR adds a root: a package, or the folder that contains it"
                    .to_owned()
            }
            (false, false) => "the file does not exist".to_owned(),
        })
    }

    /// Returns the canonical path of a file that may be opened: below a root, the checked folder or
    /// `package`.
    ///
    /// # Errors
    /// True if the path is outside of these, false if it does not exist.
    fn opened(&self, path: &Path, package: Option<&Path>) -> Result<PathBuf, bool> {
        let holds =
            |path: &Path| self.holds(path) || package.is_some_and(|package| path.starts_with(package));
        let path = lexical(path);
        if !holds(&path) {
            return Err(true);
        }
        match self.files.canonical(&path) {
            Ok(file) if holds(&file) => Ok(file),
            Ok(_) => Err(true),
            Err(_) => Err(false),
        }
    }

    /// Looks up a URI that no root holds: in an ancestor that is the package, and in the checked
    /// folder.
    fn elsewhere(
        &self,
        uri: &str,
        take: &impl Fn(&Path) -> Option<PathBuf>,
    ) -> Result<Option<PathBuf>, String> {
        let Some((scheme, rest)) = uri.split_once("://").filter(|_| !self.confined) else { return Ok(None) };
        let is_package = matches!(scheme, "package" | "model");
        if scheme == "file" && !rest.starts_with('/') || is_package && rest.starts_with('/') {
            // file://meshes/arm.stl, package:///meshes/arm.stl
            let slash = if is_package { "/" } else { "" };
            if let Some(file) = self.above(&format!("{scheme}://{slash}"), rest.trim_start_matches('/'), take)
            {
                return Ok(Some(file));
            }
        }
        if !is_package {
            return Ok(None);
        }
        // A third slash before the package is an error that is ignored.
        let (package, path) = rest.trim_start_matches('/').split_once('/').unwrap_or((rest, ""));
        let start = uri.get(..uri.len() - path.len()).unwrap_or(uri);
        match self.in_ancestor(start, package, path, take) {
            Some(file) => Ok(Some(file)),
            None => self.in_checked(start, package, path, take),
        }
    }

    /// Finds a file without a package, relative to a folder around the model.
    fn above(&self, start: &str, path: &str, take: &impl Fn(&Path) -> Option<PathBuf>) -> Option<PathBuf> {
        let mut folders = self.ancestors_below_checked();
        let (folder, file) = folders.find_map(|folder| Some((folder, self.file_in(folder, path, take)?)))?;
        self.found(
            start,
            format!("names no package; its files were found relative to {}", self.shown(folder)),
        );
        Some(file)
    }

    /// Finds a file of a package that is a folder around the model.
    fn in_ancestor(
        &self,
        start: &str,
        package: &str,
        path: &str,
        take: &impl Fn(&Path) -> Option<PathBuf>,
    ) -> Option<PathBuf> {
        let is_package = |folder: &Path| {
            names(self.files, folder, |file| file.starts_with(folder)).iter().any(|name| name == package)
        };
        let ancestors = self.folder.iter().flat_map(|folder| folder.ancestors());
        let (folder, file) = ancestors
            .filter(|folder| is_package(folder))
            .find_map(|folder| Some((folder, self.file_in(folder, path, take)?)))?;
        self.found(
            start,
            format!("was found at {}, an ancestor folder of the model with that name", self.shown(folder)),
        );
        Some(file)
    }

    /// Finds a file of a package below the checked folder. Exactly one folder must have the
    /// package's name and the file.
    fn in_checked(
        &self,
        start: &str,
        package: &str,
        path: &str,
        take: &impl Fn(&Path) -> Option<PathBuf>,
    ) -> Result<Option<PathBuf>, String> {
        let folders = self.checked.iter().flat_map(|checked| checked.packages(self.files, package));
        let files: Vec<_> =
            folders.filter_map(|folder| Some((folder, self.file_in(folder, path, take)?))).collect();
        match files.as_slice() {
            [] => Ok(None),
            [(folder, file)] => {
                let of_name = "the only folder of that name below the checked folder that contains this file";
                self.found(start, format!("was found at {}, {of_name}", self.shown(folder)));
                Ok(Some(file.clone()))
            }
            [(first, _), (second, _), ..] => Err(format!(
                "{} folders named {package} contain it, {} and {}{}; choose one with --root DIR",
                files.len(),
                self.shown(first),
                self.shown(second),
                if files.len() > 2 { ", …" } else { "" },
            )),
        }
    }

    fn file_in(
        &self,
        folder: &Path,
        path: &str,
        take: &impl Fn(&Path) -> Option<PathBuf>,
    ) -> Option<PathBuf> {
        self.opened(&folder.join(path), Some(folder)).ok().and_then(|file| take(&file))
    }

    /// Records where URIs with this start were found.
    fn found(&self, start: &str, words: String) {
        self.found.borrow_mut().entry(start.to_owned()).or_insert(words);
    }

    /// Returns the folders around the model up to the checked folder, the nearest first.
    fn ancestors_below_checked(&self) -> impl Iterator<Item = &Path> {
        let checked = self.checked.as_deref().map(CheckedFolder::path);
        let ancestors = self.folder.iter().flat_map(|folder| folder.ancestors());
        ancestors.take_while(move |folder| checked.is_some_and(|checked| folder.starts_with(checked)))
    }

    /// Returns a folder relative to the model's.
    fn shown(&self, folder: &Path) -> String {
        let Some(own) = &self.folder else { return folder.display().to_string() };
        let common = own.components().zip(folder.components()).take_while(|(a, b)| a == b).count();
        let up = own.components().skip(common).map(|_| Component::ParentDir);
        let path: PathBuf = up.chain(folder.components().skip(common)).collect();
        if path.as_os_str().is_empty() {
            ".".to_owned()
        } else {
            path.display().to_string().replace('\\', "/")
        }
    }

    /// Returns the candidate paths: ROOT/… for a root that is the package, and ROOT/PACKAGE/… for
    /// every root.
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
        self.folder.iter().map(|_| within.join(path)).collect()
    }

    fn holds(&self, path: &Path) -> bool {
        self.roots.iter().any(|(root, _)| path.starts_with(root))
            || self.checked.as_ref().is_some_and(|checked| path.starts_with(checked.path()))
    }
}

/// Returns true if the folder is a package of ROS or a model of Gazebo.
fn is_package(files: &dyn Files, folder: &Path) -> bool {
    ["package.xml", "model.config"].iter().any(|file| files.is_file(&folder.join(file)))
}

/// Returns the file that `model.config` names. Of several, it is that of the latest SDFormat
/// version, as in libsdformat. Without `model.config` it is `model.sdf`.
fn model_file(files: &dyn Files, folder: &Path, holds: impl Fn(&Path) -> bool) -> Option<String> {
    /// Maximum number of bytes to read; the file is short.
    const MOST: u64 = 1 << 16;
    // The file may be a symbolic link to another folder.
    let Ok(config) = files.canonical(&folder.join("model.config")) else {
        return Some("model.sdf".to_owned());
    };
    if !holds(&config) || !files.is_file(&config) {
        return None;
    }
    let mut text = String::new();
    let file = files.open(&config).ok()?;
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

/// Returns the names of a folder as a package: its last component, and the name in its
/// `package.xml`.
fn names(files: &dyn Files, folder: &Path, holds: impl Fn(&Path) -> bool) -> Vec<String> {
    let own = folder.file_name().map(|name| name.to_string_lossy().into_owned());
    own.into_iter().chain(package_name(files, folder, holds)).collect()
}

/// Returns the path without `.` and `..`, without access to the file system.
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
