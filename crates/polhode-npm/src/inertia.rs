//! Mass properties of bodies.

use std::path::Path;

use polhode_document::Report as _;
use polhode_robot::LinkChoice;
use polhode_robot::read::is_model;
use polhode_scenario::read::ScenarioFile;
use polhode_shape::report::InertiaReport;
use polhode_shape::{Host, Kind, Request, run_in};
use polhode_source::Failure;
use polhode_source::files::Files;
use serde_json::{Map, Value};

use crate::failed::Failed;
use crate::message::invalid;
use crate::outcome::Outcome;

/// Keys of a [`LinkChoice`]; its table is a report of another kind.
const LINK_KEYS: [&str; 4] = ["link", "lump", "subtree", "joint"];

/// Returns the reports of all bodies, in the order of their files.
pub(crate) fn outcome(mut request: Map<String, Value>, files: &dyn Files) -> Outcome {
    let links: Map<String, Value> =
        LINK_KEYS.iter().filter_map(|key| request.shift_remove_entry(*key)).collect();
    let read = || -> Result<(LinkChoice, Request), Failure> {
        let of = |object| Value::Object(object);
        let links: LinkChoice = serde_json::from_value(of(links)).map_err(|error| invalid(&error))?;
        let request: Request = serde_json::from_value(of(request)).map_err(|error| invalid(&error))?;
        Ok((links.require_one()?, without_output(request)?))
    };
    let (links, request) = match read() {
        Ok(read) => read,
        Err(failure) => return failure.into(),
    };
    let mut host = Package { files, links };
    let bodies = match run_in(&request, files, &mut host) {
        Ok(bodies) => bodies,
        Err(failure) => return failure.into(),
    };
    let failed = |file: &polhode_shape::FileBodies| {
        let failure = file.reports.as_ref().err()?;
        Some(Failed::in_file(failure, &file.path))
    };
    let failures: Vec<Failed> = bodies.files.iter().filter_map(failed).collect();
    if !failures.is_empty() {
        return Outcome::Failed(failures);
    }
    Outcome::of(match bodies.to_json() {
        Value::Array(reports) => Value::Array(reports),
        report => Value::Array(vec![report]),
    })
}

/// Refuses a request that writes a file.
fn without_output(request: Request) -> Result<Request, Failure> {
    if request.mesh.write_mesh.is_some() {
        let message = "write-mesh names an output file, but the package writes no files";
        return Err(Failure::usage(message, "leave it out; `polhode inertia --write-mesh` writes the mesh"));
    }
    Ok(request)
}

/// Readers of scenarios and robot models.
struct Package<'a> {
    files: &'a dyn Files,
    links: LinkChoice,
}

impl Host for Package<'_> {
    fn is_robot(&self, file: &Path) -> bool {
        is_model(self.files, file)
    }

    fn robot_option(&self) -> Option<&'static str> {
        self.links.given()
    }

    fn reports(&self, file: &Path, kind: Kind) -> Result<Vec<InertiaReport>, Failure> {
        match kind {
            Kind::Robot => self.links.reports(self.files, file),
            _ => Ok(vec![ScenarioFile::read(self.files, file)?.inertia()]),
        }
    }
}
