//! Scenarios of files that are none: a mesh, a molecule, particles, as a body that turns.

use std::fmt::Write as _;
use std::path::Path;

use polhode::body::mesh::TriangleMesh;
use polhode_formats::mesh::{MeshContents, MeshFormat};
use polhode_formats::particles::{self, ParticleOptions};

use crate::kind::Kind;

/// Particles that a text has room for.
const MOST_PARTICLES: usize = 400;

/// A scenario with the body of a file that lies beside it, or why there is none.
pub(crate) fn scenario_of(kind: Kind, path: &Path, bytes: &[u8]) -> Result<String, String> {
    let file = path.file_name().unwrap_or_default().to_string_lossy();
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let (body, spin, duration) = match kind {
        Kind::Mesh => (mesh(path, bytes, &file)?, "[\"0.05 rad/s\", \"0.1 rad/s\", \"3 rad/s\"]", "20 s"),
        Kind::Molecule => (
            format!("[[body.part]]\nshape = \"molecule\"\nfile = {}\n", quoted(&file)),
            "[\"5e10 rad/s\", \"1e12 rad/s\", \"2e11 rad/s\"]",
            "100e-12 s",
        ),
        Kind::Particles => (particle_table(bytes)?, "[\"0.1 rad/s\", \"3 rad/s\", \"0.2 rad/s\"]", "20 s"),
        Kind::Scenario | Kind::Robot => return Err("it is no body".to_owned()),
    };
    Ok(format!(
        "title = {}\n\n{body}\n[start]\nspin = {{ body = {spin} }}\n\n[run]\nduration = \"{duration}\"\nsamples = 2001\n",
        quoted(&name)
    ))
}

/// A solid of water, as a file of triangles says neither what it is made of nor, most of them, in which unit.
fn mesh(path: &Path, bytes: &[u8], file: &str) -> Result<String, String> {
    let format = MeshFormat::of_path(path).ok_or("it is no mesh")?;
    let mut text = format!("[[body.part]]\nshape = \"mesh\"\nfile = {}\n", quoted(file));
    if !format.has_unit() {
        let contents = MeshContents::parse(bytes, path, format).map_err(|error| error.to_string())?;
        // A part of a machine in millimetres is some metres long when they are taken for metres.
        let is_millimetres = contents.parts.iter().any(|part| largest(&part.mesh) > 2.5);
        let unit = if is_millimetres { "mm" } else { "m" };
        let _ =
            writeln!(text, "unit = \"{unit}\"           # the file does not say: this is taken by its size");
    }
    text += "density = \"1000 kg/m^3\"  # water, until it is said\n";
    Ok(text)
}

/// The largest coordinate, in the file's unit.
fn largest(mesh: &TriangleMesh) -> f64 {
    mesh.coordinates().iter().flatten().fold(0.0, |most, x| x.abs().max(most))
}

fn particle_table(bytes: &[u8]) -> Result<String, String> {
    let options = ParticleOptions { mass_unit: None, length_unit: None, total_mass: None };
    let table = particles::read(bytes, &options).map_err(|error| error.to_string())?;
    if table.particles.len() <= MOST_PARTICLES && table.tensors.is_empty() {
        let row = |p: &polhode::body::Particle<_>| {
            let [x, y, z] = polhode::math::Position::to_array(p.position());
            format!("    {{ mass = {:?}, position = [{x:?}, {y:?}, {z:?}] }},\n", p.mass())
        };
        let rows: String = table.particles.iter().map(row).collect();
        return Ok(format!("[[body.part]]\nshape = \"particles\"\nparticles = [\n{rows}]\n"));
    }
    let body = table.mass_properties().map_err(|error| error.to_string())?;
    let list = |values: [f64; 3]| format!("[{:?}, {:?}, {:?}]", values[0], values[1], values[2]);
    let rows = body.inertia().matrix().map(list).join(", ");
    Ok(format!(
        "# {}, as one tensor\n[[body.part]]\nshape = \"tensor\"\nmass = {:?}\ncenter_of_mass = {}\ninertia = [{rows}]\n",
        table.described().replace(['\n', '\r'], " "),
        body.mass(),
        list(body.center_of_mass().to_array()),
    ))
}

/// A string of TOML.
fn quoted(text: &str) -> String {
    toml_edit::Value::from(text).to_string()
}
