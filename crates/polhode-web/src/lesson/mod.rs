//! Lessons: a few steps of text, each with a question to answer before the motion is shown, and
//! with its knobs.
//!
//! A lesson is a small TOML file. Those in `lessons/` are part of the program. A teacher's own
//! lesson is read each time the page requests it. [`check`] refuses a lesson that the
//! page could not show.

mod check;
mod error;
mod file;
mod included;

use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use polhode_source::files::Files;

use crate::documents::{Document, Documents};
use crate::protocol::{Lesson, LessonInfo, LessonStep};
use crate::refusal::{Refusal, RefusalKind};
use crate::watch::Watch;
use check::Checked;
pub use error::LessonError;
use file::File;
use included::INCLUDED;

/// Returns the lessons that are part of the program, in the recommended order.
pub fn lessons() -> impl Iterator<Item = LessonInfo> {
    INCLUDED.iter().filter_map(|(id, text)| info(id, Path::new(id), text).ok())
}

fn info(id: &str, path: &Path, text: &str) -> Result<LessonInfo, LessonError> {
    let File { title, summary, .. } = File::read(path, text)?;
    Ok(LessonInfo { id: id.to_owned(), title: title.into_inner(), summary: summary.into_inner() })
}

/// Lessons of a session: those of the program, and a teacher's own.
#[derive(Debug, Default)]
pub(crate) struct Lessons {
    own: OnceLock<PathBuf>,
    /// Id of the lesson with which the session begins.
    first: OnceLock<String>,
    /// Opened lessons: id, scenario, and the document with the scenario.
    opened: Mutex<Vec<(String, String, Arc<Document>)>>,
}

impl Lessons {
    /// Begins with a lesson: the id of one of the program's, or a file. Returns its id. A session
    /// that has begun with a lesson begins with no other one.
    pub(crate) fn begin_with(&self, name: &Path) -> Result<&str, LessonError> {
        let id = match name.to_str().filter(|id| text_of(id).is_some()) {
            Some(id) => id.to_owned(),
            None if name.extension().is_none_or(|ending| ending != "toml") => return Err(unknown(name)),
            // Ids of the program's lessons contain no dot.
            None => name.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        };
        let is_own = text_of(&id).is_none();
        let first = self.first.get_or_init(|| id.clone());
        if *first != id || is_own && self.own.get_or_init(|| name.to_owned()) != name {
            return Err(LessonError::whole(name, format!("the session has begun with the lesson {first:?}")));
        }
        Ok(first)
    }

    /// Returns the id of the lesson with which the session begins.
    pub(crate) fn first(&self) -> Option<&str> {
        self.first.get().map(String::as_str)
    }

    /// Returns all lessons, the teacher's own first.
    pub(crate) fn list(&self, files: &dyn Files) -> Vec<LessonInfo> {
        let own = self.own.get().into_iter().filter_map(|path| {
            let text = read(files, path).ok()?;
            info(self.first()?, path, &text).ok()
        });
        own.chain(lessons()).collect()
    }

    /// Opens a lesson by its id. Its scenario becomes a document.
    pub(crate) fn open(
        &self,
        id: &str,
        documents: &Documents,
        files: &dyn Files,
        watch: &dyn Watch,
    ) -> Result<Lesson, Error> {
        let checked = match (text_of(id), self.own.get()) {
            (Some(text), _) => Checked::read(Path::new(&format!("{id}.toml")), text, false, files, watch)?,
            (None, Some(path)) if self.first() == Some(id) => {
                let text = read(files, path)
                    .map_err(|error| LessonError::whole(path, format!("cannot be read: {error}")))?;
                Checked::read(path, &text, true, files, watch)?
            }
            _ => return Err(Error::Unknown),
        };
        let Checked { title, summary, path, draft, scenario, steps } = checked;
        let mut opened = self.opened.lock().unwrap_or_else(PoisonError::into_inner);
        let known = opened.iter().find(|(known, text, _)| known == id && *text == scenario);
        let document = known.map(|(_, _, document)| document.id).unwrap_or_else(|| {
            let document = documents.put_scenario(&path, draft, scenario.clone());
            opened.push((id.to_owned(), scenario, document.clone()));
            document.id
        });
        Ok(Lesson { info: LessonInfo { id: id.to_owned(), title, summary }, document, steps })
    }
}

/// Makes an error that lists the known lessons.
pub(crate) fn unknown(path: &Path) -> LessonError {
    let ids: Vec<_> = INCLUDED.iter().map(|(id, _)| *id).collect();
    LessonError::whole(path, "unknown lesson").hint(format!(
        "known lessons: {}; or give a file of your own with the extension .toml",
        ids.join(", ")
    ))
}

fn read(files: &dyn Files, path: &Path) -> io::Result<String> {
    files.open(path).and_then(io::read_to_string)
}

fn text_of(id: &str) -> Option<&'static str> {
    INCLUDED.iter().find(|(known, _)| *known == id).map(|(_, text)| *text)
}

/// Reason why a lesson is not opened.
#[derive(Debug)]
pub(crate) enum Error {
    /// No lesson has this id.
    Unknown,
    /// The lesson is invalid.
    Wrong(LessonError),
}

impl From<LessonError> for Error {
    fn from(error: LessonError) -> Self {
        Self::Wrong(error)
    }
}

impl From<Error> for Refusal {
    fn from(error: Error) -> Self {
        match error {
            Error::Unknown => Self::new(RefusalKind::NotFound, "unknown lesson"),
            Error::Wrong(error) => {
                Self { hint: error.hint.clone(), ..Self::new(RefusalKind::Unprocessable, error.to_string()) }
            }
        }
    }
}
