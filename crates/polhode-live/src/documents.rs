//! Documents: files that were opened or dropped.

use std::fs;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::mem;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, PoisonError};

use polhode_scenario::read::Draft;
use polhode_shape::brep::BrepFormat;
use polhode_source::files::Disk;

use crate::answer::Refusal;
use crate::inspect::MeshInspection;
use crate::kind::Kind;
use crate::mesh::{self, Mesh};
use crate::opened::{scenario_of, scenario_of_mesh};
use crate::protocol::DocumentInfo;
use crate::{limits, watch};
use hyper::StatusCode;

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
    /// Mesh that is not closed: its inspection, and the state of the file at that time.
    Mesh(Mutex<(String, Arc<MeshInspection>)>),
    Robot,
}

/// All documents of a session.
#[derive(Debug, Default)]
pub(crate) struct Documents(Mutex<Vec<Arc<Document>>>);

impl Documents {
    /// Opens the files that the user named, which may refer to others. Without files, it opens a
    /// default scenario.
    pub(crate) fn open_first(&self, files: &[PathBuf]) -> Result<(), Refusal> {
        if files.is_empty() {
            let path = Path::new("t-handle.toml");
            self.put_scenario(path, Draft::new(path, []), FIRST.to_owned());
        }
        let stop = AtomicBool::new(false);
        files.iter().try_for_each(|file| self.open(file, None, &stop).map(|_| ()))
    }

    /// Opens a file that the user named, or one of a set of dropped files. A dropped file may refer
    /// only to files of its set. `stop` ends the reading.
    pub(crate) fn open(
        &self,
        path: &Path,
        dropped: Option<(PathBuf, Vec<PathBuf>)>,
        stop: &AtomicBool,
    ) -> Result<Arc<Document>, Refusal> {
        if self.all().len() >= limits::DOCUMENTS {
            let rule = format!("a session shows at most {} documents", limits::DOCUMENTS);
            return Err(Refusal::new(StatusCode::INSUFFICIENT_STORAGE, rule)
                .hint("stop polhode live and start it again"));
        }
        let name = name_of(path);
        let unreadable = |error: String| unreadable(&name, &error);
        let mut draft = match &dropped {
            Some((_, files)) => Draft::new(path, files.iter().cloned()),
            None => Draft::new(path, [path.to_owned()]),
        };
        // Taken before the files are read: a file that is written to meanwhile is read again.
        let own = std::iter::once(path);
        let [own, all] = [stamp(own.clone()), stamp(own.chain(draft.files()))];
        let bytes = fs::read(path).map_err(|error| unreadable(error.to_string()))?;
        let kind = Kind::of(path, &bytes).ok_or_else(|| {
            if let Some(format) = BrepFormat::of(&Disk, path) {
                return unreadable(format.refusal()).hint(format.hint(path));
            }
            unreadable("its file extension is unknown".to_owned()).hint(
                "the page shows scenarios (.toml), meshes (.stl .obj .ply .off .gltf .glb .3mf .dae), robots (.urdf .sdf .xml .usda .osim), molecules (.xyz .mol .pdb) and particles (.csv)",
            )
        })?;
        let made = |text: String, mut draft: Draft| -> Result<Content, Refusal> {
            let read = draft.read_watched(&Disk, text.clone(), &watch::within(limits::INSPECTION, stop));
            read.map_err(|error| unreadable(error.to_string()))?;
            let (draft, stamp) = (Mutex::new(draft), Mutex::new(all));
            Ok(Content::Scenario { draft, made: Some(text), stamp, is_mesh: kind == Kind::Mesh })
        };
        let content = match kind {
            Kind::Robot => Content::Robot,
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
            Kind::Mesh => {
                match Mesh::of(&name, path, &bytes, &watch::within(limits::INSPECTION, stop))
                    .map_err(unreadable)?
                {
                    Mesh::Solid(solid, unit) => {
                        made(scenario_of_mesh(path, unit), draft.knowing(path.to_owned(), unit, *solid))?
                    }
                    Mesh::Flawed(found) => Content::Mesh(Mutex::new((own, Arc::new(found)))),
                }
            }
            Kind::Molecule | Kind::Particles => {
                made(scenario_of(kind, path, &bytes).map_err(unreadable)?, draft)?
            }
        };
        watch::is_wanted(stop)?;
        let roots = dropped.into_iter().map(|(folder, _)| folder).collect();
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

    pub(crate) fn get(&self, id: u32) -> Result<Arc<Document>, Refusal> {
        let all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        usize::try_from(id).ok().and_then(|k| all.get(k)).cloned().ok_or_else(Refusal::not_found)
    }
}

impl Document {
    pub(crate) fn info(&self) -> DocumentInfo {
        let kind = match self.content {
            Content::Scenario { .. } => "scenario",
            Content::Mesh(_) => "mesh",
            Content::Robot => "robot",
        };
        let is_mesh = matches!(self.content, Content::Mesh(_) | Content::Scenario { is_mesh: true, .. });
        DocumentInfo { id: self.id, name: self.name.clone(), kind, is_mesh, stamp: self.stamp() }
    }

    /// Returns a stamp that changes when the file, or a file that it names, is written to.
    fn stamp(&self) -> String {
        let own = std::iter::once(self.path.as_path());
        match &self.content {
            Content::Scenario { draft, .. } => {
                let draft = draft.lock().unwrap_or_else(PoisonError::into_inner);
                stamp(own.chain(draft.files()))
            }
            _ => stamp(own),
        }
    }

    /// Returns the text of a scenario from its file. If a file was written to, it reads all of them
    /// again.
    pub(crate) fn text(&self) -> Result<String, Refusal> {
        let Content::Scenario { draft, made, stamp, .. } = &self.content else {
            return Err(Refusal::not_found());
        };
        let now = self.stamp();
        let before = mem::replace(&mut *stamp.lock().unwrap_or_else(PoisonError::into_inner), now.clone());
        let mut draft = draft.lock().unwrap_or_else(PoisonError::into_inner);
        if before != now {
            draft.forget();
        }
        if let Some(made) = made {
            return Ok(made.clone());
        }
        let text =
            fs::read_to_string(&self.path).map_err(|error| unreadable(&self.name, &error.to_string()))?;
        if self.roots.is_empty() && before != now {
            *draft = Draft::trusting(&self.path, &text);
        }
        Ok(text)
    }

    /// Returns the inspection of a mesh, from its file as it is now; `stop` ends the inspection.
    pub(crate) fn looked_at(&self, stop: &AtomicBool) -> Result<Arc<MeshInspection>, Refusal> {
        let found = match &self.content {
            Content::Mesh(found) => Some(found),
            Content::Scenario { is_mesh: true, .. } => None,
            _ => return Err(Refusal::not_found()),
        };
        let now = self.stamp();
        let known = found.map(|found| found.lock().unwrap_or_else(PoisonError::into_inner).clone());
        if let Some((_, known)) = known.filter(|(before, _)| *before == now) {
            return Ok(known);
        }
        let unreadable = |error: String| unreadable(&self.name, &error);
        let bytes = fs::read(&self.path).map_err(|error| unreadable(error.to_string()))?;
        let goes_on = watch::within(limits::INSPECTION, stop);
        let inspection = mesh::looked_at(&self.name, &self.path, &bytes, &goes_on).map_err(unreadable)?;
        watch::is_wanted(stop)?;
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
            _ => Err(Refusal::new(StatusCode::BAD_REQUEST, format!("{:?} is not a scenario", self.name))),
        }
    }
}

fn name_of(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn unreadable(name: &str, error: &str) -> Refusal {
    Refusal::new(StatusCode::UNPROCESSABLE_ENTITY, format!("{name:?} cannot be read: {error}"))
}

/// Returns a stamp that changes when one of the files is written to.
fn stamp<'a>(files: impl Iterator<Item = &'a Path>) -> String {
    let mut hasher = DefaultHasher::new();
    for path in files {
        let told = fs::metadata(path).ok().filter(fs::Metadata::is_file);
        told.map(|told| (told.len(), told.modified().ok())).hash(&mut hasher);
    }
    format!("{:016x}", hasher.finish())
}
