//! A scenario whose text is being changed.

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

/// A scenario whose text is being changed, and is read after each change.
///
/// The files that it names are read once, and no others than those that it was opened with: a text may come from where nobody is trusted.
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
/// assert!(draft.read(&Memory::default(), other).unwrap_err().to_string().contains("was opened with the scenario"));
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
    /// A draft that may name `files`; `path` is for messages, and its folder is where the scenario's file names begin.
    pub fn new(path: &Path, files: impl IntoIterator<Item = PathBuf>) -> Self {
        Self { path: path.to_owned(), files: files.into_iter().collect(), last: Entries::new(), mesh: None }
    }

    /// A draft that may name the files that `text` names: that of a file which its user opened.
    pub fn trusting(path: &Path, text: &str) -> Self {
        let source = Source::new(&Disk, path, text);
        let mut files = Vec::new();
        for entry in tree::parse(text).iter().flat_map(Entries::values) {
            entry.node.each_leaf(&mut |leaf| {
                // What is no name of a file is none of a file that is there either.
                if let Kind::Text(name) = &leaf.kind {
                    files.push(source.beside(name));
                }
            });
        }
        Self::new(path, files)
    }

    /// The path that messages have.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The files that it may name; not all of them need to be there.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        self.files.iter().map(PathBuf::as_path)
    }

    /// Forgets what it has read: files are read anew.
    pub fn forget(&mut self) {
        (self.last, self.mesh) = (Entries::new(), None);
    }

    /// Knows what is in the file of a mesh, if it is read in this unit: the next text that names it does not read it.
    #[must_use]
    pub fn knowing(self, path: PathBuf, unit: Option<f64>, solid: MeshSolid) -> Self {
        Self { mesh: Some(Box::new(KnownMesh { path, unit, solid })), ..self }
    }

    /// Reads a text of the scenario.
    ///
    /// # Errors
    /// As [`scenario::read`](super::read), and of a file that the draft may not name.
    pub fn read(&mut self, files: &dyn Files, text: String) -> Result<ScenarioFile, FormatError> {
        self.read_watched(files, text, &|| true)
    }

    /// The same as long as it `goes_on`, which is asked often where a mesh is looked at: of what would take longer it is undecided whether
    /// it bounds a solid.
    ///
    /// # Errors
    /// As [`Draft::read`].
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

    /// The numbers of the text that was read last, as far as they were read; none if it was no TOML.
    pub fn numbers(&self) -> Vec<WrittenNumber> {
        number::numbers(&self.last)
    }

    /// Differs between texts whose bodies may look otherwise: of all that the last one says but how the body starts and how long it moves.
    pub fn body_fingerprint(&self) -> u64 {
        const APART: [&str; 8] = ["title", "start", "run", "orbit", "event", "pointing", "wheel", "sweep"];
        let mut hasher = DefaultHasher::new();
        for (key, entry) in self.last.iter().filter(|(key, _)| !APART.contains(&key.as_ref())) {
            key.hash(&mut hasher);
            entry.node.hash_into(&mut hasher);
        }
        hasher.finish()
    }

    /// What may stand at a place of a text, in bytes: keys, names and units that the reader asks for there.
    pub fn complete(&self, text: &str, at: usize) -> Option<Completion> {
        completion::complete(text, at, |text| self.asked(text))
    }

    /// What the reader asks a text for; nothing if it is no TOML.
    fn asked(&self, text: &str) -> Option<Vec<Question>> {
        let asked = Asked::default();
        let nothing = Memory::default();
        let new = Source::new(&nothing, &self.path, text);
        let source = Source { asked: Some(&asked), headings: &TOP, ..new };
        let mut entries = tree::parse(text).ok()?;
        tree::adopt(&mut entries, &self.last);
        // Where it ends is beyond what was asked for.
        let _ = file_of_root(source, &entries);
        Some(asked.all())
    }
}
