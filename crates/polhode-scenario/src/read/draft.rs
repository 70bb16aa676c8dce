//! Scenario whose text is being edited.

use std::any::Any;
use std::collections::BTreeSet;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::{Path, PathBuf};

use polhode_shape::mesh::MeshSolid;
use polhode_source::FormatError;
use polhode_source::files::{Disk, Files, Listed, Memory};
use polhode_source::toml::source::{Source, Watch};
use polhode_source::toml::tree;
use polhode_source::toml::tree::{Entries, Kind};
use polhode_source::toml::{Asked, Question};

use super::completion::{self, Completion};
use super::known_mesh::KnownMesh;
use super::number::{self, WrittenNumber};
use super::{ScenarioFile, TOP, document, file_of_root};

/// Scenario whose text is being edited, and read after each change.
///
/// Each named file is read once. Only files that were opened with the scenario are read, because
/// the text may come from an untrusted source.
///
/// ```
/// use polhode_scenario::read::Draft;
/// use polhode_source::files::Memory;
/// let mut draft = Draft::new("ball.toml".as_ref(), []);
/// let text = "[[body.part]]\nname = \"ball\"\nshape = \"sphere\"\nradius = \"20 mm\"\nmass = \"0.5 kg\"\n";
/// let file = draft.read(&Memory::default(), text.to_owned())?;
/// assert_eq!(file.scenario.body().mass(), 0.5);
/// let radius = &draft.numbers()[0];
/// assert_eq!((radius.key.as_str(), radius.owner.as_deref()), ("body.part[0].radius", Some("ball")));
/// assert_eq!((radius.value, radius.unit.as_str()), (0.02, "mm"));
///
/// let other = text.replace("shape = \"sphere\"\nradius = \"20 mm\"", "shape = \"mesh\"\nfile = \"other.stl\"");
/// let refused = draft.read(&Memory::default(), other).unwrap_err().to_string();
/// assert!(refused.contains("opened or dropped together with the scenario"));
/// # Ok::<(), polhode_source::FormatError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Draft {
    path: PathBuf,
    files: BTreeSet<PathBuf>,
    last: Entries,
    mesh: Option<Box<KnownMesh>>,
}

impl Draft {
    /// Creates a draft that may name `files`; `path` is used in messages, and its folder is the
    /// base of file names in the text.
    pub fn new(path: &Path, files: impl IntoIterator<Item = PathBuf>) -> Self {
        Self { path: path.to_owned(), files: files.into_iter().collect(), last: Entries::new(), mesh: None }
    }

    /// Creates a draft that may name all files named in `text`, the text of a file opened by the
    /// user.
    pub fn trusting(path: &Path, text: &str) -> Self {
        let source = Source::new(&Disk, path, text);
        let mut files = Vec::new();
        for entry in tree::parse(text).iter().flat_map(Entries::values) {
            entry.node.each_leaf(&mut |leaf| {
                // Texts that are not file names do not match existing files.
                if let Kind::Text(name) = &leaf.kind {
                    files.push(source.sibling(name));
                }
            });
        }
        Self::new(path, files)
    }

    /// Returns the path used in messages.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the files that the text may name; they need not exist.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        self.files.iter().map(PathBuf::as_path)
    }

    /// Clears the cache, so that files are read again.
    pub fn forget(&mut self) {
        (self.last, self.mesh) = (Entries::new(), None);
    }

    /// Caches the contents of a mesh file for a unit of length; the next text that names it does
    /// not read the file.
    #[must_use]
    pub fn knowing(self, path: PathBuf, unit: Option<f64>, solid: MeshSolid) -> Self {
        Self { mesh: Some(Box::new(KnownMesh { path, unit, solid })), ..self }
    }

    /// Reads a new text of the scenario.
    ///
    /// # Errors
    /// Same as [`scenario::read`](super::read), and an error for a file that the draft may not
    /// name.
    pub fn read(&mut self, files: &dyn Files, text: String) -> Result<ScenarioFile, FormatError> {
        self.read_watched(files, text, &|| true)
    }

    /// Reads a new text as [`Draft::read`] does, with a cancellation check.
    ///
    /// The check is called often while a mesh is examined. After cancellation it remains undecided
    /// if the mesh bounds a solid.
    ///
    /// # Errors
    /// Same as [`Draft::read`].
    pub fn read_watched(
        &mut self,
        files: &dyn Files,
        text: String,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<ScenarioFile, FormatError> {
        let mesh = self.mesh.take();
        let listed = Listed { files, paths: &self.files };
        let watch = Watch(goes_on);
        let kept = mesh.as_deref().map(|mesh| mesh as &(dyn Any + Send + Sync));
        let source = Source { watch, kept, headings: &TOP, ..Source::new(&listed, &self.path, &text) };
        let mut entries = document(source)?;
        tree::adopt(&mut entries, &self.last);
        let read = file_of_root(source, &entries);
        self.last = entries;
        let (scenario, tables, torques) = read?;
        Ok(ScenarioFile { scenario, tables, torques, path: self.path.clone(), text })
    }

    /// Returns the numbers of the last text, as far as they were read; none if it was not TOML.
    pub fn numbers(&self) -> Vec<WrittenNumber> {
        number::numbers(&self.last)
    }

    /// Returns a hash of all data that affect how the body looks; the start, the run and similar
    /// tables are excluded.
    pub fn body_fingerprint(&self) -> u64 {
        const APART: [&str; 8] = ["title", "start", "run", "orbit", "event", "pointing", "wheel", "sweep"];
        let mut hasher = DefaultHasher::new();
        for (key, entry) in self.last.iter().filter(|(key, _)| !APART.contains(&key.as_ref())) {
            key.hash(&mut hasher);
            entry.node.hash_into(&mut hasher);
        }
        hasher.finish()
    }

    /// Returns the completions at a byte of a text: keys, names and units that the reader accepts
    /// there.
    pub fn complete(&self, text: &str, at: usize) -> Option<Completion> {
        completion::complete(text, at, |text| self.asked(text))
    }

    /// Returns the reader's requests for a text; `None` if it is not TOML.
    fn asked(&self, text: &str) -> Option<Vec<Question>> {
        let asked = Asked::default();
        let nothing = Memory::default();
        let new = Source::new(&nothing, &self.path, text);
        let source = Source { asked: Some(&asked), headings: &TOP, ..new };
        let mut entries = tree::parse(text).ok()?;
        tree::adopt(&mut entries, &self.last);
        // An error after the requested place does not matter.
        let _ = file_of_root(source, &entries);
        Some(asked.all())
    }
}
