//! Documents: files that were opened or dropped.

use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::io::{self, Read as _};
use std::mem;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use polhode_scenario::read::Draft;
use polhode_shape::brep::BrepFormat;
use polhode_source::files::{self, Files, Look};

use crate::inspect::{DocumentContent, MeshInspection, RobotInspection};
use crate::kind::Kind;
use crate::limits;
use crate::mesh::{self, Mesh};
use crate::opened::{scenario_of, scenario_of_mesh};
use crate::protocol::DocumentInfo;
use crate::refusal::{Refusal, RefusalKind};
use crate::table::{Table, TableKind};
use crate::watch::{Watch, require_wanted};

/// Scenario of a session that was started without a file.
const FIRST: &str = include_str!("../assets/first.toml");

/// A file that was opened or dropped.
#[derive(Debug)]
pub(crate) struct Document {
    pub(crate) id: u32,
    pub(crate) name: String,
    pub(crate) content: Content,
    /// Path of the file, or the path that it would have.
    pub(crate) path: PathBuf,
    /// Folders other than the model's own in which it finds its meshes.
    pub(crate) roots: Vec<PathBuf>,
}

/// Content of a document.
#[derive(Debug)]
pub(crate) enum Content {
    /// Scenario, read from a file or made from the file of a body.
    Scenario {
        draft: Mutex<Draft>,
        made: Option<String>,
        /// State of the files when the draft began to read them.
        stamp: Mutex<String>,
        /// True if it was made from a mesh, which can also be inspected by itself.
        is_mesh: bool,
    },
    /// Table or plan of one of these kinds.
    Table(Vec<TableKind>),
    /// Mesh that is not closed: its inspection, and the state of the file at that time.
    Mesh(Mutex<(String, Arc<MeshInspection>)>),
    Robot,
}

/// Files that were dropped together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DroppedSet {
    /// Folder of the set.
    pub folder: PathBuf,
    /// Files of the set: a file may refer only to these.
    pub files: Vec<PathBuf>,
}

impl DroppedSet {
    /// Returns the set of all files below a folder.
    pub fn of(folder: PathBuf, files: &dyn Files) -> Self {
        let mut found = Vec::new();
        below(&folder, files, &mut found);
        Self { folder, files: found }
    }
}

fn below(folder: &Path, files: &dyn Files, found: &mut Vec<PathBuf>) {
    for (path, kind) in files.entries(folder).unwrap_or_default() {
        match kind {
            files::Kind::Folder => below(&path, files, found),
            files::Kind::File => found.push(path),
            files::Kind::Other => {}
        }
    }
}

/// All documents of a session.
#[derive(Debug, Default)]
pub(crate) struct Documents(Mutex<Vec<Arc<Document>>>);

impl Documents {
    /// Opens the default scenario.
    pub(crate) fn open_example(&self) -> Arc<Document> {
        let path = Path::new("t-handle.toml");
        self.put_scenario(path, Draft::new(path, []), FIRST.to_owned())
    }

    /// Opens a file that the user named, or one of a set of dropped files. A table that may be of
    /// several kinds is opened as particles if the reader has chosen that.
    pub(crate) fn open(
        &self,
        (path, as_particles): (&Path, bool),
        dropped: Option<&DroppedSet>,
        files: &dyn Files,
        watch: &dyn Watch,
    ) -> Result<Arc<Document>, Refusal> {
        if self.all().len() >= limits::DOCUMENTS {
            let rule = format!("a session shows at most {} documents", limits::DOCUMENTS);
            return Err(Refusal::new(RefusalKind::Full, rule));
        }
        let goes_on = || watch.goes_on();
        let name = name_of(path);
        let unreadable = |error: String| unreadable(&name, &error);
        let mut draft = match dropped {
            Some(set) => Draft::new(path, set.files.iter().cloned()),
            None => Draft::new(path, [path.to_owned()]),
        };
        // Taken before the files are read: a file that is written to meanwhile is read again.
        let own = std::iter::once(path);
        let [own, all] = [stamp(files, own.clone()), stamp(files, own.chain(draft.files()))];
        let bytes = read(files, path).map_err(|error| unreadable(error.to_string()))?;
        let is_chosen = |kind: &Kind| matches!(kind, Kind::Table(kinds) if as_particles && kinds.contains(&TableKind::Particles));
        let kind = Kind::of(path, &bytes).map(|kind| if is_chosen(&kind) { Kind::Particles } else { kind });
        let kind = kind.ok_or_else(|| {
            if bytes.starts_with(b"PAR1") {
                return unreadable("it is a Parquet file, which the page does not read".to_owned())
                    .hint("write it as CSV, or use the polhode command");
            }
            if let Some(format) = BrepFormat::of(files, path) {
                return unreadable(format.refusal()).hint(format.hint(path));
            }
            unreadable("its file extension is unknown".to_owned()).hint(
                "the page shows scenarios and plans (.toml), parts lists, logs and particles (.csv .xlsx), meshes (.stl .obj .ply .off .gltf .glb .3mf .dae), robots (.urdf .sdf .xml .osim) and molecules (.xyz .mol .pdb)",
            )
        })?;
        let is_mesh = kind == Kind::Mesh;
        let made = |text: String, mut draft: Draft| -> Result<Content, Refusal> {
            let read = draft.read_watched(files, text.clone(), &goes_on);
            read.map_err(|error| unreadable(error.to_string()))?;
            let (draft, stamp) = (Mutex::new(draft), Mutex::new(all));
            Ok(Content::Scenario { draft, made: Some(text), stamp, is_mesh })
        };
        let content = match kind {
            Kind::Robot => Content::Robot,
            Kind::Table(kinds) => Content::Table(kinds),
            Kind::Scenario => {
                let text =
                    String::from_utf8(bytes).map_err(|_| unreadable("it is not UTF-8 text".to_owned()))?;
                if dropped.is_none() {
                    draft = Draft::trusting(path, &text);
                }
                Content::Scenario {
                    draft: Mutex::new(draft),
                    made: None,
                    stamp: Mutex::default(),
                    is_mesh: false,
                }
            }
            Kind::Mesh => match Mesh::of(&name, path, (&bytes, files), &goes_on).map_err(unreadable)? {
                Mesh::Solid(solid, unit) => {
                    made(scenario_of_mesh(path, unit), draft.knowing(path.to_owned(), unit, *solid))?
                }
                Mesh::Flawed(found) => Content::Mesh(Mutex::new((own, Arc::new(found)))),
            },
            Kind::Molecule | Kind::Particles => {
                made(scenario_of(&kind, path, &bytes).map_err(unreadable)?, draft)?
            }
        };
        require_wanted(watch)?;
        let roots = dropped.into_iter().map(|set| set.folder.clone()).collect();
        Ok(self.put(name, path.to_owned(), roots, content))
    }

    /// Adds a scenario with this text, which may differ from its file.
    pub(crate) fn put_scenario(&self, path: &Path, draft: Draft, text: String) -> Arc<Document> {
        let (draft, stamp) = (Mutex::new(draft), Mutex::default());
        let content = Content::Scenario { draft, made: Some(text), stamp, is_mesh: false };
        self.put(name_of(path), path.to_owned(), Vec::new(), content)
    }

    fn put(&self, name: String, path: PathBuf, roots: Vec<PathBuf>, content: Content) -> Arc<Document> {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let id = u32::try_from(all.len()).unwrap_or(u32::MAX);
        let document = Arc::new(Document { id, name, content, path, roots });
        all.push(document.clone());
        document
    }

    pub(crate) fn all(&self) -> Vec<Arc<Document>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Returns the paths of all tables except one.
    pub(crate) fn other_tables(&self, id: u32) -> Vec<PathBuf> {
        let is_other = |one: &Arc<Document>| one.id != id && matches!(one.content, Content::Table(_));
        self.all().into_iter().filter(is_other).map(|one| one.path.clone()).collect()
    }

    pub(crate) fn get(&self, id: u32) -> Result<Arc<Document>, Refusal> {
        let all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        usize::try_from(id).ok().and_then(|k| all.get(k)).cloned().ok_or_else(|| {
            let message = format!("unknown document {id}");
            Refusal::new(RefusalKind::NotFound, message)
        })
    }
}

impl Document {
    /// Returns the text of a scenario, the inspection of a mesh or a robot, or the kinds of a table.
    /// `others` are the paths of other tables.
    pub(crate) fn content(
        &self,
        others: &[PathBuf],
        files: &dyn Files,
        watch: &dyn Watch,
    ) -> Result<DocumentContent, Refusal> {
        match &self.content {
            Content::Scenario { draft, made, stamp, .. } => {
                self.text((draft, made.as_ref(), stamp), files).map(|text| DocumentContent::Scenario { text })
            }
            Content::Mesh(_) => self.looked_at(files, watch).map(|mesh| DocumentContent::Mesh { mesh }),
            Content::Robot => {
                let roots = self.roots.clone();
                RobotInspection::of(&self.name, &self.path, roots, files, &|| watch.goes_on())
                    .map(|robot| DocumentContent::Robot { robot })
            }
            Content::Table(_) => {
                self.table()?.content(others, files).map(|table| DocumentContent::Table { table })
            }
        }
    }

    /// Opens the files that a scenario or a robot names; those of a mesh were opened with it.
    pub(crate) fn open_named(&self, files: &dyn Files, watch: &dyn Watch) {
        if let Ok(table) = self.table() {
            table.open_named(files);
            return;
        }
        let content = self.content(&[], files, watch);
        if let (Content::Scenario { draft, .. }, Ok(DocumentContent::Scenario { text })) =
            (&self.content, content)
        {
            let mut draft = draft.lock().unwrap_or_else(PoisonError::into_inner);
            let _ = draft.read_watched(files, text, &|| watch.goes_on());
        }
    }

    pub(crate) fn info(&self, files: &dyn Files) -> DocumentInfo {
        let kind = match self.content {
            Content::Scenario { .. } => "scenario",
            Content::Mesh(_) => "mesh",
            Content::Robot => "robot",
            Content::Table(_) => "table",
        };
        let is_mesh = matches!(self.content, Content::Mesh(_) | Content::Scenario { is_mesh: true, .. });
        DocumentInfo { id: self.id, name: self.name.clone(), kind, is_mesh, stamp: self.stamp(files) }
    }

    /// Returns a stamp that changes when the file, or a file that it names, is written to.
    fn stamp(&self, files: &dyn Files) -> String {
        let own = std::iter::once(self.path.as_path());
        match &self.content {
            Content::Scenario { draft, .. } => {
                let draft = draft.lock().unwrap_or_else(PoisonError::into_inner);
                stamp(files, own.chain(draft.files()))
            }
            Content::Table(_) => {
                let named = self.table().map(|table| table.named(files)).unwrap_or_default();
                stamp(files, own.chain(named.iter().map(PathBuf::as_path)))
            }
            _ => stamp(files, own),
        }
    }

    /// Returns the text of a scenario from its file. If a file was written to, it reads all of them
    /// again.
    fn text(
        &self,
        (draft, made, stamp): (&Mutex<Draft>, Option<&String>, &Mutex<String>),
        files: &dyn Files,
    ) -> Result<String, Refusal> {
        let now = self.stamp(files);
        let before = mem::replace(&mut *stamp.lock().unwrap_or_else(PoisonError::into_inner), now.clone());
        let mut draft = draft.lock().unwrap_or_else(PoisonError::into_inner);
        if before != now {
            draft.forget();
        }
        if let Some(made) = made {
            return Ok(made.clone());
        }
        let text = files.open(&self.path).and_then(io::read_to_string);
        let text = text.map_err(|error| unreadable(&self.name, &error.to_string()))?;
        if self.roots.is_empty() && before != now {
            *draft = Draft::trusting(&self.path, &text);
        }
        Ok(text)
    }

    /// Returns the table or the plan of this document.
    pub(crate) fn table(&self) -> Result<Table<'_>, Refusal> {
        match &self.content {
            Content::Table(kinds) => {
                let set = self.roots.first().map(PathBuf::as_path);
                Ok(Table { name: &self.name, path: &self.path, set, kinds })
            }
            _ => Err(Refusal::new(RefusalKind::BadRequest, format!("{:?} is not a table", self.name))),
        }
    }

    /// Returns the inspection of a mesh, from its file as it is now.
    pub(crate) fn looked_at(
        &self,
        files: &dyn Files,
        watch: &dyn Watch,
    ) -> Result<Arc<MeshInspection>, Refusal> {
        let found = match &self.content {
            Content::Mesh(found) => Some(found),
            Content::Scenario { is_mesh: true, .. } => None,
            _ => {
                let message = format!("{:?} is not a mesh", self.name);
                return Err(Refusal::new(RefusalKind::NotFound, message));
            }
        };
        let now = self.stamp(files);
        let known = found.map(|found| found.lock().unwrap_or_else(PoisonError::into_inner).clone());
        if let Some((_, known)) = known.filter(|(before, _)| *before == now) {
            return Ok(known);
        }
        let unreadable = |error: String| unreadable(&self.name, &error);
        let bytes = read(files, &self.path).map_err(|error| unreadable(error.to_string()))?;
        let inspection = mesh::looked_at(&self.name, &self.path, (&bytes, files), &|| watch.goes_on());
        let inspection = inspection.map_err(unreadable)?;
        require_wanted(watch)?;
        let inspection = Arc::new(inspection);
        if let Some(found) = found {
            *found.lock().unwrap_or_else(PoisonError::into_inner) = (now, inspection.clone());
        }
        Ok(inspection)
    }

    /// Returns the draft of a scenario.
    pub(crate) fn draft(&self) -> Result<&Mutex<Draft>, Refusal> {
        match &self.content {
            Content::Scenario { draft, .. } => Ok(draft),
            _ => Err(Refusal::new(RefusalKind::BadRequest, format!("{:?} is not a scenario", self.name))),
        }
    }
}

fn read(files: &dyn Files, path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    files.open(path)?.read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn name_of(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn unreadable(name: &str, error: &str) -> Refusal {
    Refusal::new(RefusalKind::Unprocessable, format!("{name:?} cannot be read: {error}"))
}

/// Returns a stamp that changes when one of the files is written to. Files without a time of
/// change, such as those in memory, are compared by their contents.
fn stamp<'a>(files: &dyn Files, paths: impl Iterator<Item = &'a Path>) -> String {
    let mut hasher = DefaultHasher::new();
    for path in paths {
        let look = files.look(path).ok().filter(Look::is_file);
        look.map(|look| (look.length, look.changed)).hash(&mut hasher);
        if look.is_some_and(|look| look.changed.is_none()) {
            read(files, path).ok().hash(&mut hasher);
        }
    }
    format!("{:016x}", hasher.finish())
}
