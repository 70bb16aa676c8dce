//! `polhode live`

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode_live::{LessonError, LessonInfo, Live as Server, LiveError, LiveOptions, lessons, page};
use polhode_source::{Failure as Request, shown};

use crate::failure::Failure;
use crate::page::check_file;
use crate::stdout::print;
use crate::{browser, partial};

/// Interactive 3-D page: change parameters and see the motion.
///
/// The page is served on 127.0.0.1 and opens only with the printed address; other sites cannot use
/// it. It shows scenarios, meshes, molecules and particles. For a defective mesh it shows the
/// location of each defect; for a robot, every link with its inertia and the fixes. Drop further
/// files on the page to open them. If a file changes on disk, the page shows the change. Nothing is
/// written to disk: save results from the page. Press Ctrl-C to stop. With --output the page and
/// the files are one HTML file, which needs no server and no network.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode live
  polhode live examples/t-handle.toml
  polhode live part.stl water.xyz
  polhode live robot.urdf
  polhode live --lesson
  polhode live --lesson cube
  polhode live examples/heavy-top.toml --no-open --port 8000
  polhode live examples/t-handle.toml --output t-handle.html")]
pub(crate) struct Live {
    /// Scenarios, meshes, robots, molecules or particles [default: an example scenario].
    files: Vec<PathBuf>,
    /// Open a lesson by name, or from your own file; without a name, list the lessons.
    #[arg(long, value_name = "NAME|FILE.toml", num_args = 0..=1, conflicts_with = "files")]
    lesson: Option<Option<String>>,
    /// Do not open the browser.
    #[arg(long)]
    no_open: bool,
    /// Port [default: a free port].
    #[arg(long, value_name = "N")]
    port: Option<u16>,
    /// Write the page with its files as one HTML file, without a server.
    #[arg(short, long, value_name = "PAGE.html", conflicts_with_all = ["no_open", "port"])]
    output: Option<PathBuf>,
    /// Overwrite an existing page.
    #[arg(long, requires = "output")]
    force: bool,
}

impl Live {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if let Some(None) = self.lesson {
            let idle = [
                ("--no-open", self.no_open),
                ("--port", self.port.is_some()),
                ("--output", self.output.is_some()),
            ];
            return match idle.iter().find(|(_, is_given)| *is_given) {
                Some((option, _)) => Err(Failure::usage(
                    format!("{option} has no effect: --lesson without a name lists the lessons"),
                    format!("remove {option}, or name a lesson: --lesson cube"),
                )),
                None => print(&list()),
            };
        }
        let port = self.port.unwrap_or_default();
        let options = LiveOptions { port, files: self.files, lesson: self.lesson.flatten() };
        if let Some(file) = &self.output {
            return write(&options, file, self.force);
        }
        let live = Server::bind(&options).map_err(failed)?;
        print(&format!("{}\n", live.address()))?;
        if !self.no_open {
            browser::open(live.address().as_ref());
        }
        live.run()
    }
}

/// Writes the page, completely or not at all. No input has the extension of a page.
fn write(options: &LiveOptions, file: &Path, force: bool) -> Result<(), Failure> {
    if file.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("html")) {
        let rule = format!("{} is not the name of a page", shown(file));
        return Err(Failure::usage(rule, "choose a file name that ends with .html"));
    }
    check_file(file, force)?;
    let html = page(options).map_err(failed)?;
    partial::write(file, force, |out| out.write_all(&html))?;
    print(&format!("wrote {}\n", shown(file)))
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
