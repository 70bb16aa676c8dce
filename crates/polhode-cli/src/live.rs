//! `polhode live`

use std::path::PathBuf;

use clap::Args;
use polhode_live::{LessonError, LessonInfo, Live as Server, LiveError, LiveOptions, lessons};
use polhode_source::{Failure as Request, shown};

use crate::browser;
use crate::failure::Failure;
use crate::stdout::print;

/// Change a body and its motion on a page, and see at once what becomes of it.
///
/// The page is served on this machine's own address, 127.0.0.1, for whoever has the address that is printed, and for no other site. It shows
/// scenarios, and the bodies of other files: meshes, molecules, particles. Of a mesh that bounds no solid it shows where it is wrong, of a robot
/// every link with its inertia, and the repair. More can be dropped on it. Nothing is written to the disk: what is worth keeping is saved from
/// the page. Ctrl-C ends it.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode live
  polhode live examples/t-handle.toml
  polhode live part.stl water.xyz
  polhode live robot.urdf
  polhode live --lesson
  polhode live --lesson cube
  polhode live examples/heavy-top.toml --no-open --port 8000")]
pub(crate) struct Live {
    /// Scenarios, meshes, robots, molecules or particles [default: a scenario to begin with].
    files: Vec<PathBuf>,
    /// A lesson of this name, or of a file of your own; without a name, the list of lessons.
    #[arg(long, value_name = "NAME|FILE.toml", num_args = 0..=1, conflicts_with = "files")]
    lesson: Option<Option<String>>,
    /// Do not open the browser.
    #[arg(long)]
    no_open: bool,
    /// The port [default: a free one].
    #[arg(long, value_name = "N")]
    port: Option<u16>,
}

impl Live {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if let Some(None) = self.lesson {
            let idle = [("--no-open", self.no_open), ("--port", self.port.is_some())];
            return match idle.iter().find(|(_, is_given)| *is_given) {
                Some((option, _)) => Err(Failure::usage(
                    format!("{option} has nothing to do: --lesson without a name lists the lessons"),
                    format!("leave out {option}, or name a lesson: --lesson cube"),
                )),
                None => print(&list()),
            };
        }
        let port = self.port.unwrap_or_default();
        let options = LiveOptions { port, files: self.files, lesson: self.lesson.flatten() };
        let live = Server::bind(&options).map_err(failed)?;
        print(&format!("{}\n", live.address()))?;
        if !self.no_open {
            browser::open(live.address().as_ref());
        }
        live.run().map_err(failed)
    }
}

/// Returns the list of lessons, two lines each.
fn list() -> String {
    let one = |LessonInfo { id, title, summary }| format!("{id:20}{title}\n{:20}{summary}\n", "");
    lessons().map(one).collect()
}

fn failed(error: LiveError) -> Failure {
    let hint = error.hint().map(str::to_owned);
    match error {
        LiveError::Lesson(LessonError { path, place, message, .. }) => {
            Request::Usage { message, file: Some(shown(&path)), place, hint }.into()
        }
        error => Failure::usage(error.to_string(), hint.unwrap_or_default()),
    }
}
