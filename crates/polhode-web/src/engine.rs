//! Engine of the page: the documents and lessons of a session, and its answers.

use std::path::Path;
use std::sync::{Arc, PoisonError};

use polhode_source::files::Files;
use serde::Serialize;

use crate::documents::{Documents, DroppedSet};
use crate::exercise::{self, ExerciseAnswer, ExerciseRequest};
use crate::framed::{json, with_rows};
use crate::inspect::{DocumentContent, MeshInspection};
use crate::lesson::{self, LessonError, Lessons};
use crate::message::{Message, read_request};
use crate::motion;
use crate::protocol::{
    Choice, CompleteAnswer, CompleteRequest, DocumentInfo, DocumentList, Lesson, LessonInfo, MotionAnswer,
    MotionRequest,
};
use crate::refusal::Refusal;
use crate::table::{OpenScenario, ReportAnswer, ReportRequest, ScenarioText};
use crate::utf16;
use crate::watch::{Watch, require_wanted};

/// Session of the page: its documents and lessons.
///
/// The text of a scenario is the only state of a motion. The engine keeps the files that were
/// opened, but no motions. Several threads may call it simultaneously. Files are those of the
/// [`Files`] that a call passes, and a [`Watch`] ends long computations.
///
/// ```
/// use polhode_source::files::Memory;
/// use polhode_web::{Edit, Engine, MotionRequest};
/// let text = "[[body.part]]\nshape = \"box\"\nsize = [\"1 m\", \"2 m\", \"3 m\"]\nmass = \"5 kg\"\n\
///             [start]\nspin = { body = [\"0.1 rad/s\", \"2 rad/s\", \"0.3 rad/s\"] }\n\
///             [run]\nduration = \"4 s\"\nsamples = 5\n";
/// let files = Memory::from([("box.toml", text)]);
/// let engine = Engine::default();
/// let opened = engine.open("box.toml".as_ref(), None, &files, &|| true)?;
/// let edits = vec![Edit::Set { set: "body.part[0].mass".to_owned(), value: Some("\"7 kg\"".to_owned()) }];
/// let (text, body) = (text.to_owned(), None);
/// let request = MotionRequest { document: opened.id, text, edits, error: false, working: false, body };
/// let answer = engine.motion(&request, &files, &|| true)?;
/// assert!(answer.text.contains("mass = \"7 kg\"") && answer.errors.is_empty());
/// let motion = answer.motion.unwrap();
/// assert_eq!(motion.page["motion"]["times"]["f64"][1], 5);
/// # Ok::<(), polhode_web::Refusal>(())
/// ```
#[derive(Debug, Default)]
pub struct Engine {
    documents: Documents,
    lessons: Lessons,
}

impl Engine {
    /// Creates a session that begins with a lesson: the id of one of [`lessons`](crate::lessons),
    /// or a file.
    ///
    /// # Errors
    /// [`LessonError`] if the lesson is unknown or invalid.
    pub fn beginning_with_lesson(
        name: &str,
        files: &dyn Files,
        watch: &dyn Watch,
    ) -> Result<Self, LessonError> {
        let engine = Self::default();
        engine.begin_lesson(name.as_ref(), files, watch)?;
        Ok(engine)
    }

    /// Begins with a lesson, and returns its id.
    fn begin_lesson(&self, name: &Path, files: &dyn Files, watch: &dyn Watch) -> Result<&str, LessonError> {
        let id = self.lessons.begin_with(name)?;
        self.lessons.open(id, &self.documents, files, watch).map_err(|error| match error {
            lesson::Error::Wrong(error) => error,
            lesson::Error::Unknown => lesson::unknown(name),
        })?;
        Ok(id)
    }

    /// Returns the id of the lesson with which the session begins.
    pub fn first_lesson(&self) -> Option<&str> {
        self.lessons.first()
    }

    /// Opens the default scenario as a document.
    pub fn open_example(&self, files: &dyn Files) -> DocumentInfo {
        self.documents.open_example().info(files)
    }

    /// Opens a file as a document: a scenario, mesh, molecule, robot, table or plan.
    ///
    /// A file without a set is one that the user named: it may refer to other files. A file of a
    /// set may refer only to files of that set.
    ///
    /// # Errors
    /// [`Refusal`] if the file cannot be read, the session is full, or nobody waits.
    pub fn open(
        &self,
        path: &Path,
        set: Option<&DroppedSet>,
        files: &dyn Files,
        watch: &dyn Watch,
    ) -> Result<DocumentInfo, Refusal> {
        Ok(self.documents.open((path, false), set, files, watch)?.info(files))
    }

    /// Returns the documents, in the order in which they were opened.
    pub fn documents(&self, files: &dyn Files) -> DocumentList {
        let documents: Vec<_> = self.documents.all().iter().map(|one| one.info(files)).collect();
        DocumentList { first: documents.first().map(|one| one.id), documents }
    }

    /// Returns the text of a scenario, the inspection of a mesh or a robot, or the kinds of a table,
    /// from the file as it is now.
    ///
    /// # Errors
    /// [`Refusal`] if the document is unknown, the file cannot be read, or nobody waits.
    pub fn document(
        &self,
        id: u32,
        files: &dyn Files,
        watch: &dyn Watch,
    ) -> Result<DocumentContent, Refusal> {
        self.documents.get(id)?.content(&self.documents.other_tables(id), files, watch)
    }

    /// Opens every file that a document names, as its motion or its inspection does.
    ///
    /// A caller learns from its [`Files`] which files these are. Errors of their contents are
    /// ignored: [`Engine::motion`] and [`Engine::document`] report them.
    ///
    /// # Errors
    /// [`Refusal`] if the document is unknown.
    pub fn open_named(&self, id: u32, files: &dyn Files, watch: &dyn Watch) -> Result<(), Refusal> {
        self.documents.get(id)?.open_named(files, watch);
        Ok(())
    }

    /// Returns the inspection of a mesh, also of a closed one that is a scenario's body.
    ///
    /// # Errors
    /// [`Refusal`] if the document is unknown or not a mesh, the file cannot be read, or nobody
    /// waits.
    pub fn mesh(
        &self,
        id: u32,
        files: &dyn Files,
        watch: &dyn Watch,
    ) -> Result<Arc<MeshInspection>, Refusal> {
        self.documents.get(id)?.looked_at(files, watch)
    }

    /// Returns all lessons, the one of a teacher first.
    pub fn lessons(&self, files: &dyn Files) -> Vec<LessonInfo> {
        self.lessons.list(files)
    }

    /// Opens a lesson: its scenario becomes a document.
    ///
    /// # Errors
    /// [`Refusal`] if the lesson is unknown or invalid.
    pub fn lesson(&self, id: &str, files: &dyn Files, watch: &dyn Watch) -> Result<Lesson, Refusal> {
        Ok(self.lessons.open(id, &self.documents, files, watch)?)
    }

    /// Makes an exercise, and grades the answers of the request. Errors of their text are part of the
    /// answer.
    ///
    /// # Errors
    /// [`Refusal`] for an unknown topic, or one without a problem in symbols if that is requested.
    pub fn exercise(&self, request: &ExerciseRequest) -> Result<ExerciseAnswer, Refusal> {
        exercise::answer(request)
    }

    /// Changes a text and computes its motion. Errors of the text are part of the answer.
    ///
    /// # Errors
    /// [`Refusal`] if the document is unknown or not a scenario, there are too many edits, or
    /// nobody waits.
    pub fn motion(
        &self,
        request: &MotionRequest,
        files: &dyn Files,
        watch: &dyn Watch,
    ) -> Result<MotionAnswer, Refusal> {
        motion::answer(self.documents.get(request.document)?.draft()?, request, files, watch)
    }

    /// Returns the report on a table or a plan, or its error. A table may be of several kinds: the
    /// request has the one that the reader chose.
    ///
    /// # Errors
    /// [`Refusal`] if a document is unknown or of another kind, or nobody waits.
    pub fn report(
        &self,
        request: &ReportRequest,
        files: &dyn Files,
        watch: &dyn Watch,
    ) -> Result<ReportAnswer, Refusal> {
        let document = self.documents.get(request.document)?;
        let others = self.documents.other_tables(request.document);
        let answer = match &request.scenario {
            None => document.table()?.report(request, None, others, files)?,
            Some(ScenarioText { document: id, text }) => {
                let open = self.documents.get(*id)?;
                open.draft()?;
                let open = OpenScenario { path: &open.path, text };
                document.table()?.report(request, Some(&open), others, files)?
            }
        };
        require_wanted(watch)?;
        Ok(answer)
    }

    /// Returns completions of a text at a position.
    ///
    /// # Errors
    /// [`Refusal`] if the document is unknown or not a scenario.
    pub fn complete(&self, request: &CompleteRequest) -> Result<CompleteAnswer, Refusal> {
        let document = self.documents.get(request.document)?;
        let draft = document.draft()?.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let text = &request.text;
        let found = draft.complete(text, utf16::to_byte(text, request.at));
        let place = found
            .as_ref()
            .map(|found| [found.place.start, found.place.end].map(|at| utf16::of_byte(text, at)));
        let [from, to] = place.unwrap_or([request.at; 2]);
        let options = found.into_iter().flat_map(|found| found.suggested);
        let options = options.map(|one| Choice { label: one.text, detail: one.detail }).collect();
        Ok(CompleteAnswer { from, to, options })
    }

    /// Answers a [`Message`] in JSON.
    ///
    /// An answer with rows of numbers begins with [`json_before_rows`](crate::json_before_rows).
    /// All others are JSON and begin with `{`. A refusal is `{"refusal": {"kind", "message",
    /// "hint"}}`.
    ///
    /// ```
    /// use polhode_source::files::Memory;
    /// let (engine, files) = (polhode_web::Engine::default(), Memory::default());
    /// let answer = engine.answer(br#"{"document": {"id": 4}}"#, &files, &|| true);
    /// let refusal = r#"{"refusal":{"kind":"not_found","message":"unknown document 4","hint":null}}"#;
    /// assert_eq!(answer, refusal.as_bytes());
    /// ```
    pub fn answer(&self, request: &[u8], files: &dyn Files, watch: &dyn Watch) -> Vec<u8> {
        self.answered(request, files, watch).unwrap_or_else(|refusal| {
            json(&Refused { refusal }).unwrap_or_else(|_| br#"{"refusal":null}"#.to_vec())
        })
    }

    fn answered(&self, request: &[u8], files: &dyn Files, watch: &dyn Watch) -> Result<Vec<u8>, Refusal> {
        require_wanted(watch)?;
        match read_request(request)? {
            Message::Documents => json(&self.documents(files)),
            Message::Document { id } => self.document(id, files, watch)?.to_bytes(),
            Message::Mesh { id } => DocumentContent::Mesh { mesh: self.mesh(id, files, watch)? }.to_bytes(),
            Message::Lessons => json(&serde_json::json!({ "lessons": self.lessons(files) })),
            Message::Lesson { id } => json(&self.lesson(&id, files, watch)?),
            Message::Exercises => json(&exercise::topics()?),
            Message::Exercise(request) => json(&self.exercise(&request)?),
            Message::Motion(request) => {
                let answer = self.motion(&request, files, watch)?;
                with_rows(&answer, answer.motion.as_ref().map_or(&[], |motion| &motion.rows))
            }
            Message::Complete(request) => json(&self.complete(&request)?),
            Message::LessonFile { path } => json(
                &serde_json::json!({ "id": self.begin_lesson(&path, files, watch).map_err(lesson::Error::Wrong)? }),
            ),
            Message::Report(request) => json(&self.report(&request, files, watch)?),
            Message::Open { path, set } => {
                let set = set.map(|folder| DroppedSet::of(folder, files));
                json(&self.open(&path, set.as_ref(), files, watch)?)
            }
            Message::Particles { id } => {
                let document = self.documents.get(id)?;
                let set = document.table()?.set.map(|set| DroppedSet::of(set.to_owned(), files));
                let open = self.documents.open((&document.path, true), set.as_ref(), files, watch)?;
                json(&open.info(files))
            }
            Message::OpenExample => json(&self.open_example(files)),
        }
    }
}

#[derive(Serialize)]
struct Refused {
    refusal: Refusal,
}

impl DocumentContent {
    fn to_bytes(&self) -> Result<Vec<u8>, Refusal> {
        match self {
            Self::Mesh { mesh } => with_rows(self, mesh.rows()),
            _ => json(self),
        }
    }
}
