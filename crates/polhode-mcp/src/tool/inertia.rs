//! Mass properties of bodies.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use polhode_document::Report as _;
use polhode_robot::read::is_model;
use polhode_robot::{LINK_CHOICE_SCHEMA, LinkChoice};
use polhode_scenario::read::ScenarioFile;
use polhode_shape::report::InertiaReport;
use polhode_shape::{Host, Kind, REPORT_SCHEMA, REQUEST_SCHEMA, Request, run_in};
use polhode_source::Failure;
use polhode_source::files::Files;

use crate::arguments::Arguments;
use crate::definition::Definition;
use crate::outcome::Outcome;

pub(super) const DEFINITION: Definition = Definition {
    name: "inertia",
    title: "Mass properties of a body",
    description: "\
What are the mass (kg), centre of mass (m), inertia tensor (kg m²), principal moments and axes of this body? \
For meshes, molecules, particles, voxel grids, CAD reports, scenarios, links of robot models, or a shape such as box. \
The tensor is about the centre of mass, along body axes; its off-diagonal elements are minus the integrals, I_xy = -∫xy dm. \
A mesh without a unit needs unit; a mesh or shape needs mass, density or material. \
Example: {\"files\": [\"bracket.stl\"], \"unit\": \"mm\", \"material\": \"aluminium\"}",
    request: REQUEST_SCHEMA,
    report: || REPORT_SCHEMA,
    more: LINK_CHOICE_SCHEMA,
    without: &["write-mesh"],
    required: &[],
};

pub(super) fn run(mut arguments: Arguments, files: &dyn Files, _: &AtomicBool) -> Result<Outcome, Failure> {
    let links: LinkChoice = arguments.take(["link", "lump", "subtree", "joint"]).read()?;
    let request: Request = arguments.read()?;
    if request.files.is_empty() && !request.primitive.is_given() {
        let hint =
            "name files, or give a shape with its mass: box = \"20 cm, 10 cm, 6 cm\" and mass = \"2.5 kg\"";
        return Err(Failure::usage("no body is given", hint));
    }
    let bodies = run_in(&request, files, &mut Readers { files, links: links.require_one()? })?;
    let failures: Vec<Failure> =
        bodies.files.iter().filter_map(|file| file.reports.as_ref().err().cloned()).collect();
    Ok(Outcome::of(&bodies, bodies.to_text(None), &failures))
}

/// Readers of scenarios and robot models.
struct Readers<'a> {
    files: &'a dyn Files,
    links: LinkChoice,
}

impl Host for Readers<'_> {
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
