//! Files of a session: those that the user names, and every file that these name.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf, absolute};

use polhode_source::FormatErrorKind;
use polhode_source::files::{Asked, Disk, Files, Memory, Recorded, lexical};
use polhode_source::{file, shown};
use polhode_web::Engine;

use crate::error::LiveError;
use crate::limits;
use crate::options::LiveOptions;
use crate::within::Within;

/// Contents of the files of a session.
#[derive(Debug, Default)]
pub(crate) struct Gathered {
    /// Named files, by absolute path, and the lesson.
    pub(crate) named: LiveOptions,
    /// Contents of all files, by absolute path.
    pub(crate) files: BTreeMap<PathBuf, Vec<u8>>,
}

/// Reads all files of a session. Returns also the paths whose change requires to do so again.
pub(crate) fn gather(options: &LiveOptions) -> (Asked, Result<Gathered, LiveError>) {
    let recorded = Recorded::new(&Disk);
    let opened = open(options, &recorded);
    let asked = recorded.end();
    let gathered = opened.and_then(|()| Gathered::of(options, &asked));
    (asked, gathered)
}

/// Opens what the user named, and every file that it names, as the page does.
fn open(options: &LiveOptions, files: &dyn Files) -> Result<(), LiveError> {
    if let Some(lesson) = options.lesson_file() {
        let watch = Within::new(limits::MOTION);
        return Engine::beginning_with_lesson(lesson, files, &watch).map(drop).map_err(LiveError::Lesson);
    }
    let engine = Engine::default();
    for path in &options.files {
        match files.look(path) {
            Ok(look) if !look.is_file() => {
                return Err(LiveError::unreadable(path, "it is not a regular file"));
            }
            Ok(look) if look.length > limits::FILE => return Err(LiveError::too_large(path)),
            // The engine reports a file that does not exist.
            _ => {}
        }
        let watch = Within::new(limits::INSPECTION);
        let opened = engine
            .open(path, None, files, &watch)
            .and_then(|document| engine.open_named(document.id, files, &watch));
        opened.map_err(LiveError::refused)?;
    }
    Ok(())
}

impl Gathered {
    fn of(options: &LiveOptions, asked: &Asked) -> Result<Self, LiveError> {
        let named = options.renamed(place);
        let mut paths: BTreeMap<PathBuf, PathBuf> =
            asked.files().map(|path| (place(path), path.to_owned())).collect();
        // The page has no links: a file is at each path under which a reader may look for it.
        let links: Vec<_> = asked.links().map(|(link, canonical)| (place(link), canonical)).collect();
        let targets: BTreeSet<&Path> = links.iter().map(|(_, canonical)| *canonical).collect();
        for (link, canonical) in links.iter().filter(|(link, canonical)| link != canonical) {
            let (link, folder) = match canonical.is_dir() {
                true => (link.clone(), *canonical),
                false => (folder_of(link), canonical.parent().unwrap_or(canonical)),
            };
            let below = paths.iter().filter(|(path, _)| !targets.contains(path.as_path()));
            let linked: Vec<_> = below
                .filter_map(|(path, read)| Some((link.join(path.strip_prefix(folder).ok()?), read.clone())))
                .collect();
            for (path, read) in linked {
                paths.entry(path).or_insert(read);
            }
        }
        if let Some((_, path)) = paths.iter().nth(limits::FILE_COUNT) {
            let rule = format!("a session has at most {} files", limits::FILE_COUNT);
            return Err(LiveError::limit(path, &rule));
        }
        let (mut files, mut size) = (BTreeMap::new(), 0);
        for (path, read) in paths {
            let bytes = file::bytes(&Disk, &read, &shown(&read), limits::FILE);
            let bytes = bytes.map_err(|error| match error {
                FormatErrorKind::Io { kind: io::ErrorKind::FileTooLarge, .. } => LiveError::too_large(&read),
                FormatErrorKind::Io { why, .. } => LiveError::unreadable(&read, &why),
                error => LiveError::unreadable(&read, &error.to_string()),
            })?;
            size += bytes.len() as u64;
            if size > limits::FILES {
                let rule =
                    format!("the files of a session have at most {} MiB together", limits::FILES >> 20);
                return Err(LiveError::limit(&read, &rule));
            }
            files.insert(path, bytes);
        }
        Ok(Self { named, files })
    }

    /// Returns the same files with paths relative to their deepest common folder, without those
    /// that the page does not open there.
    ///
    /// # Errors
    /// [`LiveError::File`] for a file that is found only at its absolute path.
    pub(crate) fn relative(self) -> Result<Self, LiveError> {
        let canonical = |path: &Path| fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let before: BTreeMap<PathBuf, PathBuf> =
            self.files.keys().map(|path| (path.clone(), canonical(path))).collect();
        let common = self.common_folder();
        let mut all = self.without(&common);
        let mut memory = Memory::default();
        all.files.iter().for_each(|(path, bytes)| memory.insert(path, bytes.as_slice()));
        let recorded = Recorded::new(&memory);
        open(&all.named, &recorded)?;
        let asked = recorded.end();
        let opened: BTreeSet<PathBuf> = asked.files().map(lexical).collect();
        all.files.retain(|path, _| opened.contains(path));
        let found: BTreeSet<_> = opened.iter().filter_map(|path| before.get(&common.join(path))).collect();
        if let Some((path, _)) = before.iter().find(|(_, canonical)| !found.contains(canonical)) {
            let path = shown(path);
            let message =
                format!("the page cannot contain {path}: another file names it by its absolute path");
            let hint = "name it by a path relative to that file".to_owned();
            return Err(LiveError::File { message, hint: Some(hint) });
        }
        let common = all.common_folder();
        Ok(all.without(&common))
    }

    /// Returns the deepest folder in which all files are.
    fn common_folder(&self) -> PathBuf {
        let folders = self.files.keys().map(|path| folder_of(path));
        let common = |one: PathBuf, other: PathBuf| {
            let same = one.components().zip(other.components()).take_while(|(a, b)| a == b);
            same.map(|(component, _)| component).collect()
        };
        folders.reduce(common).unwrap_or_default()
    }

    /// Removes the beginning of all paths.
    fn without(self, folder: &Path) -> Self {
        let relative = |path: &Path| path.strip_prefix(folder).unwrap_or(path).to_owned();
        let files = self.files.into_iter().map(|(path, bytes)| (relative(&path), bytes)).collect();
        Self { named: self.named.renamed(relative), files }
    }
}

/// Returns the absolute path at which the page has a file.
fn place(path: &Path) -> PathBuf {
    lexical(&absolute(path).unwrap_or_else(|_| path.to_owned()))
}

fn folder_of(path: &Path) -> PathBuf {
    path.parent().unwrap_or(path).to_owned()
}
