//! What was opened or dropped.

use std::fs;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use hyper::StatusCode;
use polhode_formats::scenario::Draft;

use crate::answer::Refusal;
use crate::kind::Kind;
use crate::limits;
use crate::opened::{readable, scenario_of};
use crate::protocol::DocumentInfo;

/// The scenario of a session that was started without a file.
const FIRST: &str = include_str!("../assets/first.toml");

/// One thing that was opened or dropped.
#[derive(Debug)]
pub(crate) struct Document {
    pub(crate) id: u32,
    pub(crate) name: String,
    pub(crate) content: Content,
    /// The file, or where it would be.
    pub(crate) path: PathBuf,
    /// Folders in which a model finds its meshes, beside its own.
    pub(crate) roots: Vec<PathBuf>,
}

/// What it is.
#[derive(Debug)]
pub(crate) enum Content {
    /// A scenario: its file has it, or it was made of the file of a body.
    Scenario {
        draft: Mutex<Draft>,
        made: Option<String>,
    },
    /// A mesh that bounds no solid.
    Mesh,
    Robot,
}

/// All of them.
#[derive(Debug, Default)]
pub(crate) struct Documents(Mutex<Vec<Arc<Document>>>);

impl Documents {
    /// Opens a file that the user named, which may name others; without one there is a scenario to begin with.
    pub(crate) fn open_first(&self, files: &[PathBuf]) -> Result<(), Refusal> {
        if files.is_empty() {
            let path = Path::new("t-handle.toml");
            self.put_scenario(path, Draft::new(path, []), FIRST.to_owned());
        }
        files.iter().try_for_each(|file| self.open(file, None).map(|_| ()))
    }

    /// Opens a file: one that the user named, or one of a set of dropped files, which are all that it may name.
    pub(crate) fn open(
        &self,
        path: &Path,
        dropped: Option<(PathBuf, Vec<PathBuf>)>,
    ) -> Result<Arc<Document>, Refusal> {
        if self.all().len() >= limits::DOCUMENTS {
            let rule = format!("a session shows {} documents", limits::DOCUMENTS);
            return Err(Refusal::new(StatusCode::INSUFFICIENT_STORAGE, rule)
                .hint("end polhode live, and start it again"));
        }
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let unreadable = |error: String| {
            Refusal::new(StatusCode::UNPROCESSABLE_ENTITY, format!("{name:?} cannot be read: {error}"))
        };
        let bytes = fs::read(path).map_err(|error| unreadable(error.to_string()))?;
        let kind = Kind::of(path, &bytes).ok_or_else(|| {
            unreadable("its name does not say what it is".to_owned()).hint(
                "the page shows scenarios (.toml), meshes (.stl .obj .ply .off .gltf .glb .3mf), robots (.urdf .sdf .xml .usda .osim), molecules (.xyz .mol .pdb) and particles (.csv)",
            )
        })?;
        let draft = |text: &str| match &dropped {
            Some((_, files)) => Draft::new(path, files.iter().cloned()),
            None => Draft::trusting(path, text),
        };
        let content = match kind {
            Kind::Robot => Content::Robot,
            Kind::Scenario => {
                let text =
                    String::from_utf8(bytes).map_err(|_| unreadable("it is not UTF-8 text".to_owned()))?;
                Content::Scenario { draft: Mutex::new(draft(&text)), made: None }
            }
            _ => {
                let text = scenario_of(kind, path, &bytes).map_err(unreadable)?;
                let mut draft = draft(&text);
                match (draft.read(text.clone()), kind) {
                    (Ok(_), _) => Content::Scenario { draft: Mutex::new(draft), made: Some(text) },
                    (Err(_), Kind::Mesh) => {
                        // What cannot be read is nothing to be looked at.
                        readable(path, &bytes).map_err(unreadable)?;
                        Content::Mesh
                    }
                    (Err(error), _) => return Err(unreadable(error.to_string())),
                }
            }
        };
        let roots = dropped.into_iter().map(|(folder, _)| folder).collect();
        Ok(self.put(name, path.to_owned(), roots, content))
    }

    /// A scenario with this text, whatever the file has.
    pub(crate) fn put_scenario(&self, path: &Path, draft: Draft, text: String) -> Arc<Document> {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let content = Content::Scenario { draft: Mutex::new(draft), made: Some(text) };
        self.put(name, path.to_owned(), Vec::new(), content)
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
            Content::Mesh => "mesh",
            Content::Robot => "robot",
        };
        DocumentInfo { id: self.id, name: self.name.clone(), kind, stamp: self.stamp() }
    }

    /// Differs after the file, or one that it names, was written to.
    fn stamp(&self) -> String {
        let mut hasher = DefaultHasher::new();
        let mut see = |path: &Path| {
            let told = fs::metadata(path).ok().filter(fs::Metadata::is_file);
            told.map(|told| (told.len(), told.modified().ok())).hash(&mut hasher);
        };
        see(&self.path);
        if let Content::Scenario { draft, .. } = &self.content {
            let draft = draft.lock().unwrap_or_else(PoisonError::into_inner);
            draft.files().for_each(see);
        }
        format!("{:016x}", hasher.finish())
    }

    /// The text of a scenario as its file has it now, with all files read anew.
    pub(crate) fn text(&self) -> Result<String, Refusal> {
        let Content::Scenario { draft, made } = &self.content else { return Err(Refusal::not_found()) };
        let mut draft = draft.lock().unwrap_or_else(PoisonError::into_inner);
        draft.forget();
        if let Some(made) = made {
            return Ok(made.clone());
        }
        let unreadable = |error: std::io::Error| {
            Refusal::new(StatusCode::UNPROCESSABLE_ENTITY, format!("{:?} cannot be read: {error}", self.name))
        };
        let text = fs::read_to_string(&self.path).map_err(unreadable)?;
        if self.roots.is_empty() {
            *draft = Draft::trusting(&self.path, &text);
        }
        Ok(text)
    }

    /// The draft of a scenario.
    pub(crate) fn draft(&self) -> Result<&Mutex<Draft>, Refusal> {
        match &self.content {
            Content::Scenario { draft, .. } => Ok(draft),
            _ => Err(Refusal::new(StatusCode::BAD_REQUEST, format!("{:?} is no scenario", self.name))),
        }
    }
}
