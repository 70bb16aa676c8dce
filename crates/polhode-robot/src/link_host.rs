//! Robot models and scenarios among the files of `inertia`.

use std::path::Path;

use polhode_shape::report::InertiaReport;
use polhode_shape::{Host, Kind};
use polhode_source::Failure;
use polhode_source::files::Files;

use crate::link_choice::LinkChoice;
use crate::read::is_model;

/// Readers of robot models and scenarios for [`run_in`](polhode_shape::run_in).
#[derive(Debug)]
pub struct LinkHost<'a> {
    /// Source of all files.
    pub files: &'a dyn Files,
    /// Links of robots that form the bodies.
    pub links: LinkChoice,
    /// Reader of scenarios.
    pub scenario: fn(&dyn Files, &Path) -> Result<InertiaReport, Failure>,
}

impl Host for LinkHost<'_> {
    fn is_robot(&self, file: &Path) -> bool {
        is_model(self.files, file)
    }

    fn robot_option(&self) -> Option<&'static str> {
        self.links.given()
    }

    fn reports(&self, file: &Path, kind: Kind) -> Result<Vec<InertiaReport>, Failure> {
        match kind {
            Kind::Robot => self.links.reports(self.files, file),
            _ => Ok(vec![(self.scenario)(self.files, file)?]),
        }
    }
}
