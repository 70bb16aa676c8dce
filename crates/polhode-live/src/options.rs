//! Options: files, lesson and address.

use std::path::{Path, PathBuf};

use polhode_web::lessons;

/// Options of the page: files or a lesson, and its address.
#[derive(Clone, Debug, Default)]
pub struct LiveOptions {
    /// Port on the loopback address; 0 selects a free one.
    pub port: u16,
    /// Files to show: scenarios, meshes, robots, molecules, particles. Without files, a default
    /// scenario is shown.
    pub files: Vec<PathBuf>,
    /// Lesson to begin with: the id of one of [`lessons`](crate::lessons), or a file.
    pub lesson: Option<String>,
}

impl LiveOptions {
    /// Returns the path of the lesson, unless it is one of the program's, which need no file.
    pub(crate) fn lesson_file(&self) -> Option<&str> {
        self.lesson.as_deref().filter(|lesson| lessons().all(|info| info.id != *lesson))
    }

    /// Returns the options with other paths of all files.
    pub(crate) fn renamed(&self, renamed: impl Fn(&Path) -> PathBuf) -> Self {
        let lesson = self.lesson_file().map(|path| renamed(path.as_ref()).to_string_lossy().into_owned());
        let files = self.files.iter().map(|path| renamed(path)).collect();
        Self { port: self.port, files, lesson: lesson.or_else(|| self.lesson.clone()) }
    }
}
