//! Mass properties of bodies.

use std::path::Path;

use polhode_document::Report as _;
use polhode_robot::{LinkChoice, LinkHost};
use polhode_scenario::read::ScenarioFile;
use polhode_shape::{Request, run_in};
use polhode_source::Failure;
use polhode_source::files::Files;
use serde_json::{Map, Value};

use crate::failed::Failed;
use crate::message::invalid;
use crate::outcome::Outcome;

/// Keys of a [`LinkChoice`]; its table is a report of another kind.
const LINK_KEYS: [&str; 5] = ["link", "lump", "subtree", "skip-invalid", "joint"];

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
    let scenario = |files: &dyn Files, file: &Path| Ok(ScenarioFile::read(files, file)?.inertia());
    let mut host = LinkHost { files, links, scenario };
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
