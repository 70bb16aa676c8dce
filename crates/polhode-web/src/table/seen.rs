//! Files of a page as a slice sees them.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use polhode_source::files::{Files, Kind, Look, Memory, NotOpened, OpenFile, lexical};

/// Folder in which a dropped file sees the scenario that is open, if that is from another set.
const OPEN: &str = "(open)";

/// Files as a document sees them: those of its dropped set, with paths in that set, and the other
/// documents. Texts that were edited replace their files.
pub(crate) struct Seen<'a> {
    files: &'a dyn Files,
    /// Folder of the dropped set; `None` for a document that may open any file.
    set: Option<&'a Path>,
    /// Edited texts, by their paths in `files`.
    texts: Memory,
    /// Paths of other documents, which are not relative to the set.
    others: Vec<PathBuf>,
    /// Folder of the scenario that is open.
    open: Option<PathBuf>,
}

/// Scenario that is open: its path and its text.
pub(crate) struct OpenScenario<'a> {
    pub(crate) path: &'a Path,
    pub(crate) text: &'a str,
}

impl<'a> Seen<'a> {
    pub(crate) fn new(files: &'a dyn Files, set: Option<&'a Path>, others: Vec<PathBuf>) -> Self {
        Self { files, set, texts: Memory::default(), others, open: None }
    }

    /// Returns the path by which the document sees one of its own files.
    pub(crate) fn path(&self, real: &Path) -> PathBuf {
        let within = self.set.and_then(|set| real.strip_prefix(set).ok());
        within.unwrap_or(real).to_owned()
    }

    /// Replaces the text of a file.
    pub(crate) fn replace(&mut self, real: &Path, text: &str) {
        self.texts.insert(real, text.as_bytes());
    }

    /// Shows the scenario that is open, and returns its path. A log that names a scenario of this
    /// name sees it too.
    pub(crate) fn open_scenario(&mut self, scenario: &OpenScenario<'_>, log: &Path) -> PathBuf {
        // The scenario of a molecule or a mesh is a text without a file.
        let mut real = scenario.path.to_owned();
        if real.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("toml")) {
            real.as_mut_os_string().push(".toml");
        }
        self.replace(&real, scenario.text);
        let Some(set) = self.set.filter(|set| !real.starts_with(set)) else { return self.path(&real) };
        let name = Path::new(real.file_name().unwrap_or_default());
        let alias = lexical(&set.join(log).with_file_name(name));
        if !self.files.is_file(&alias) {
            self.replace(&alias, scenario.text);
        }
        self.open = real.parent().map(Path::to_owned);
        Path::new(OPEN).join(name)
    }

    /// Returns the path in `files`.
    fn real(&self, path: &Path) -> io::Result<PathBuf> {
        let Some(set) = self.set else { return Ok(path.to_owned()) };
        if self.others.iter().any(|other| other == path) {
            return Ok(path.to_owned());
        }
        if let (Some(open), Ok(rest)) = (&self.open, path.strip_prefix(OPEN)) {
            return Ok(open.join(rest));
        }
        let real = lexical(&set.join(path));
        if real.starts_with(set) { Ok(real) } else { Err(io::ErrorKind::NotFound.into()) }
    }

    /// Returns the path by which the document sees a path in `files`.
    fn shown(&self, asked: &Path, real: PathBuf) -> PathBuf {
        match (self.set, asked.starts_with(OPEN) || self.others.iter().any(|other| other == asked)) {
            (Some(set), false) => real.strip_prefix(set).map(Path::to_owned).unwrap_or(real),
            (Some(_), true) => lexical(asked),
            (None, _) => real,
        }
    }

    fn source(&self, real: &Path) -> &dyn Files {
        if self.texts.is_file(real) { &self.texts } else { self.files }
    }
}

impl fmt::Debug for Seen<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Seen").field("set", &self.set).finish_non_exhaustive()
    }
}

impl Files for Seen<'_> {
    fn open(&self, path: &Path) -> io::Result<Box<dyn OpenFile>> {
        let real = self.real(path)?;
        self.source(&real).open(&real)
    }

    fn look(&self, path: &Path) -> io::Result<Look> {
        let real = self.real(path)?;
        self.source(&real).look(&real)
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        let real = self.real(path)?;
        Ok(self.shown(path, self.source(&real).canonical(&real)?))
    }

    fn entries(&self, folder: &Path) -> io::Result<Vec<(PathBuf, Kind)>> {
        let entries = self.files.entries(&self.real(folder)?)?;
        let shown = |(real, kind): (PathBuf, Kind)| (folder.join(real.file_name().unwrap_or_default()), kind);
        Ok(entries.into_iter().map(shown).collect())
    }

    fn named(&self, folder: &Path, name: &Path) -> Result<PathBuf, NotOpened> {
        let path = folder.join(name);
        let real = self.real(&path).map_err(|_| NotOpened::NotGiven)?;
        if self.set.is_some() || self.texts.is_file(&real) {
            return if self.is_file(&path) { Ok(path) } else { Err(NotOpened::NotGiven) };
        }
        self.files.named(folder, name)
    }
}
