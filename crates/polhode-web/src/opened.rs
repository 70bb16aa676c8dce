//! Scenarios made from a mesh, a molecule or particles, as a rotating body.

use std::fmt::Write as _;
use std::path::Path;

use polhode_shape::particles;
use polhode_shape::particles::ParticleOptions;

use crate::kind::Kind;

/// Maximum number of particles in a text.
const MOST_PARTICLES: usize = 400;

/// Makes a scenario with the body of a file in the same folder, or returns the reason why that is
/// not possible.
pub(crate) fn scenario_of(kind: &Kind, path: &Path, bytes: &[u8]) -> Result<String, String> {
    let file = path.file_name().unwrap_or_default().to_string_lossy();
    match kind {
        Kind::Molecule => Ok(scenario(
            path,
            &format!("[[body.part]]\nshape = \"molecule\"\nfile = {}\n", quoted(&file)),
            "[\"5e10 rad/s\", \"1e12 rad/s\", \"2e11 rad/s\"]",
            "100e-12 s",
        )),
        Kind::Particles => {
            Ok(scenario(path, &particle_table(bytes)?, "[\"0.1 rad/s\", \"3 rad/s\", \"0.2 rad/s\"]", "20 s"))
        }
        Kind::Scenario | Kind::Robot | Kind::Mesh | Kind::Table(_) => Err("it is not a body".to_owned()),
    }
}

/// Makes a scenario with a solid of water, because a mesh file has no density. Most mesh files have
/// no unit either: `unit`, in metres, is the assumed one.
pub(crate) fn scenario_of_mesh(path: &Path, unit: Option<f64>) -> String {
    let file = path.file_name().unwrap_or_default().to_string_lossy();
    let mut text = format!("[[body.part]]\nshape = \"mesh\"\nfile = {}\n", quoted(&file));
    if let Some(unit) = unit {
        let unit = if unit == 1.0 { "m" } else { "mm" };
        let _ = writeln!(
            text,
            "unit = \"{unit}\"           # the file has no unit: assumed from the size of the mesh"
        );
    }
    text += "density = \"1000 kg/m^3\"  # assumed: water\n";
    scenario(path, &text, "[\"0.05 rad/s\", \"0.1 rad/s\", \"3 rad/s\"]", "20 s")
}

fn scenario(path: &Path, body: &str, spin: &str, duration: &str) -> String {
    let title = quoted(&path.file_stem().unwrap_or_default().to_string_lossy());
    format!(
        "title = {title}\n\n{body}\n[start]\nspin = {{ body = {spin} }}\n\n[run]\nduration = \"{duration}\"\nsamples = 2001\n"
    )
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

/// Returns a TOML string.
fn quoted(text: &str) -> String {
    toml_edit::Value::from(text).to_string()
}
