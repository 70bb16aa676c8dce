//! Mass properties of a mesh file.

use std::path::Path;

use polhode::body::mesh::PrintShell;
use polhode_source::Failure;
use polhode_source::files::Files;
use polhode_source::given::{Given, Positive};

use super::choice::{MeshChoice, PartSubstance};
use super::host::Host;
use super::mesh_body::{MeshUse, MeshWords};
use super::print::Print;
use super::request::Request;
use super::written::MeshFile;
use crate::mesh::{MeshFormat, MeshLength};
use crate::report::InertiaReport;

pub(super) fn report(
    files: &dyn Files,
    file: &Path,
    format: MeshFormat,
    request: &Request,
    host: &mut dyn Host,
) -> Result<(InertiaReport, Option<MeshFile>), Failure> {
    let choice = &request.mesh;
    let length = |given: &Option<Given<Positive<MeshLength>>>| given.as_ref().map(|given| given.value.0);
    let parts: Vec<PartSubstance> = choice.part.iter().map(|part| part.value.clone()).collect();
    let name = file.display().to_string();
    let how = MeshUse {
        unit: request.length_unit(),
        hull: choice.hull,
        shell: choice.shell.as_ref().map(|shell| shell.value.0.0),
        weld: length(&choice.weld),
        fill: length(&choice.fill),
        close_within: choice.close_within.as_ref().map(|share| share.value),
        print: print_of(choice),
        union: choice.union,
        check: true,
        substance: request.substance.given(),
        parts: &parts,
        field: choice.field.as_ref().map(|formula| &formula.value.0),
        tolerance: choice.tolerance.as_ref().map(|tolerance| tolerance.value.0.0),
        goes_on: &|| true,
        words: MeshWords {
            unit: "--unit mm, or --unit m if metres are right",
            file: Some(&name),
            substance: Some("--density, --mass or --material"),
        },
    };
    let mut body = how.read(files, file, format, host)?;
    let target = choice.write_mesh.as_ref();
    let written = target.map(|target| MeshFile::of(&mut body, target)).transpose()?;
    Ok((body.into_report()?, written))
}

/// Returns the walls, layers and infill of a print.
fn print_of(choice: &MeshChoice) -> Option<Print> {
    let (walls, infill) = choice.walls.as_ref().zip(choice.infill.as_ref())?;
    let [top, bottom] = [&choice.top_layers, &choice.bottom_layers]
        .map(|layers| layers.as_ref().map_or(0.0, |layers| layers.value.0.0));
    Some(Print { shell: PrintShell { walls: walls.value.0.0, top, bottom }, infill: infill.value })
}
