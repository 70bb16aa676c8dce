//! Suggestions: terms of books and other programs, and the corresponding terms of a scenario.

use crate::text::cut;

/// Foreign key, the known key to which the advice applies, and the advice; empty if the known key
/// has the same values.
const KEYS: [(&str, &str, &str); 57] = [
    ("euler", "euler313", EULER),
    ("roll", "euler313", ROLL),
    ("rpy", "roll_pitch_yaw", ""),
    ("ypr", "euler313", ROLL),
    ("yaw", "euler313", ROLL),
    ("pitch", "euler313", ROLL),
    ("xyzw", "quaternion_xyzw", ""),
    ("wxyz", "quaternion", ""),
    ("rotation_matrix", "matrix", MATRIX),
    ("dcm", "matrix", MATRIX),
    ("height", "altitude", ""),
    ("central_body", "mu", "write mu = \"398600.44 km^3/s^2\", the value of the central body"),
    ("raan", "node", ""),
    (
        "period",
        "semi_major_axis",
        "write rate = \"0.0011 rad/s\", for a circular orbit: 2π divided by the period",
    ),
    ("mean_motion", "rate", ""),
    ("diameter", "radius", "write radius, half the diameter"),
    ("scale", "unit", "write unit = \"mm\", the unit of length of the file"),
    ("units", "unit", ""),
    ("orientation", "rotate", ""),
    ("rotation", "rotate", ""),
    ("orientation", "attitude", ""),
    ("rotation", "attitude", ""),
    ("omega", "spin", SPIN),
    ("angular_velocity", "spin", SPIN),
    ("angular_momentum", "spin", "write spin = { momentum = [0, 0, \"4 N m s\"] }, in space axes"),
    ("com", "center_of_mass", ""),
    ("principal_moments", "moments", ""),
    ("tensor", "inertia", ""),
    ("t_end", "duration", ""),
    ("time", "duration", ""),
    ("dt", "every", "write every = \"10 ms\", the sample interval; the method chooses its own steps"),
    ("time_step", "every", "write every = \"10 ms\", the sample interval; the method chooses its own steps"),
    ("integrator", "method", ""),
    ("type", "model", ""),
    ("kind", "model", ""),
    ("type", "shape", ""),
    ("kind", "shape", ""),
    ("runs", "members", ""),
    ("samples", "members", ""),
    ("altitude", "attitude", ORBIT),
    ("height", "attitude", ORBIT),
    ("altitude", "model", ORBIT),
    ("height", "model", ORBIT),
    ("altitude", "body", ORBIT),
    ("frame", "relative_to", RELATIVE),
    ("reference", "relative_to", RELATIVE),
    ("lvlh", "relative_to", RELATIVE),
    ("axis", "to", "write body = [0, 0, 1]: a direction of the body"),
    ("target", "to", ""),
    ("euler", "attitude", IN_ATTITUDE),
    ("roll", "attitude", IN_ATTITUDE),
    ("damping", "attitude", DAMPING_OF_TORQUE),
    ("mu", "friction", ""),
    ("mu_s", "static_friction", ""),
    (
        "body",
        "torque",
        "write axes = \"body\" and, on the next line, torque = [\"0 N m\", \"0 N m\", \"0.1 N m\"]",
    ),
    (
        "space",
        "torque",
        "write axes = \"space\" and, on the next line, torque = [\"0 N m\", \"0 N m\", \"0.1 N m\"]",
    ),
    ("damping", "coefficient", ""),
];

const ORBIT: &str = "write [orbit] on a line of its own, and under it altitude = \"400 km\", in place of it";
const RELATIVE: &str = "write relative_to = \"orbit\": attitude and spin are then relative to its axes (x forward, y opposite to the orbit normal, z to the nadir)";
const IN_ATTITUDE: &str = "write the angles in attitude = { … }: euler313 (about z, x, z), or roll_pitch_yaw (3-2-1: yaw about z first)";
const DAMPING_OF_TORQUE: &str = "damping is a [[torque]]: model = \"drag\" with its coefficient, or \"energy_sink\" for internal friction";

const EULER: &str = "write euler313 = [\"30 deg\", \"20 deg\", \"10 deg\"] (about z, x, z), or roll_pitch_yaw = [φ, θ, ψ] (3-2-1: ψ about z, θ about the new y, φ about the new x); convert other sequences to quaternion = [w, x, y, z] or to a matrix";
const ROLL: &str = "write roll_pitch_yaw = [\"10 deg\", \"20 deg\", \"30 deg\"], 3-2-1: yaw about z, then pitch about the new y, then roll about the new x";
/// A matrix of another program may have the other sense.
const MATRIX: &str = "write matrix: rows of three that take body components to space components; transpose a matrix of the other sense";
const SPIN: &str =
    "write spin = { body = [0, 0, \"12 rad/s\"] }, or spin = { space = [0, 0, \"12 rad/s\"] } in space axes";

/// Foreign name, the corresponding valid name, and the advice.
const NAMES: [(&str, &str, &str); 42] = [
    ("lhs", "latin hypercube", ""),
    ("lhc", "latin hypercube", ""),
    ("latin", "latin hypercube", ""),
    ("mc", "monte carlo", ""),
    ("random", "monte carlo", ""),
    ("montecarlo", "monte carlo", ""),
    ("qmc", "sobol", ""),
    ("factorial", "grid", ""),
    ("full factorial", "grid", ""),
    ("rk4", "dop853", RUNGE_KUTTA),
    ("rk45", "dop853", RUNGE_KUTTA),
    ("runge-kutta", "dop853", RUNGE_KUTTA),
    ("dopri5", "dop853", RUNGE_KUTTA),
    ("symplectic", "splitting", ""),
    ("leapfrog", "splitting", ""),
    ("damping", "drag", DAMPING),
    ("friction", "drag", DAMPING),
    ("viscous", "drag", DAMPING),
    ("spring", "torsion", ""),
    ("weight", "gravity", ""),
    ("jet", "thruster", ""),
    ("dipole", "magnetic", ""),
    ("cube", "box", ""),
    ("cuboid", "box", ""),
    ("brick", "box", ""),
    ("ball", "sphere", ""),
    ("tube", "cylinder", TUBE),
    ("pipe", "cylinder", TUBE),
    ("hollow_cylinder", "cylinder", TUBE),
    ("hollow_sphere", "sphere", HOLLOW_SPHERE),
    ("triangle", "triangular_plate", ""),
    ("prism", "triangular_prism", ""),
    ("wedge", "triangular_prism", ""),
    ("ring", "torus", ""),
    ("point", "particles", ""),
    ("disk", "rim", ""),
    ("hoop", "rim", ""),
    ("ring", "rim", ""),
    ("coulomb", "friction", ""),
    ("no slip", "rolling", ""),
    ("stl", "mesh", ""),
    ("inertia", "tensor", ""),
];

const RUNGE_KUTTA: &str =
    "the Runge–Kutta method is \"dop853\", of order 8; \"auto\" chooses a method for the motion";
const TUBE: &str = "write shape = \"cylinder\" with its inner_radius, or \"cylinder_shell\" for a thin wall";
const HOLLOW_SPHERE: &str =
    "write shape = \"sphere\" with its inner_radius, or \"sphere_shell\" for a thin wall";
const DAMPING: &str = "use model = \"drag\" for air drag, or \"energy_sink\" for internal friction";

/// Returns the known key that an unknown key means in a table with these known keys, and the advice,
/// which is empty if only the key changes.
pub(crate) fn key(word: &str, known: &[&str]) -> Option<(&'static str, &'static str)> {
    // All sequences that are not supported (euler123, euler_zyx) get the same advice.
    let word = if word.to_lowercase().starts_with("euler") { "euler" } else { word };
    let meant = KEYS.iter().find(|(others, ours, _)| same(word, others) && known.contains(ours));
    meant.map(|&(_, ours, advice)| (ours, advice))
}

/// Returns advice for an unknown name in a list of valid names.
pub(crate) fn name(word: &str, known: &[&str]) -> Option<String> {
    let (_, ours, advice) =
        NAMES.iter().find(|(others, ours, _)| same(word, others) && known.contains(ours))?;
    Some(if advice.is_empty() { format!("did you mean \"{ours}\"?") } else { (*advice).to_owned() })
}

/// Returns advice for a value that must be a table; `text` is the value as written, `elements` its
/// number of elements.
pub(crate) fn table(key: &str, text: &str, elements: usize) -> Option<String> {
    let text = cut(text);
    let whole = !text.contains(['…', '\n']);
    Some(match (key, elements) {
        ("spin", 3) if whole => {
            format!("write spin = {{ body = {text} }}, or spin = {{ space = {text} }} in space axes")
        }
        ("omega", 3) if whole => {
            format!("write omega = {{ body = {text} }}, or omega = {{ space = {text} }} in space axes")
        }
        ("attitude" | "rotate", 4) if whole => {
            format!("write {key} = {{ quaternion = {text} }}: the scalar comes first")
        }
        _ => {
            let example = TABLES.iter().find(|(keys, _)| keys.split(' ').any(|other| other == key))?.1;
            format!("write {key} = {example}")
        }
    })
}

/// Returns advice for an element of an array that must be a table.
pub(crate) fn element(key: &str, text: &str, elements: usize) -> String {
    let text = cut(text);
    match (key, elements) {
        ("between", 3) if !text.contains(['…', '\n']) => {
            format!("write {{ body = {text} }}, or {{ space = {text} }} in space axes")
        }
        ("between", _) => "write { body = [0, 0, 1] }, or \"momentum\"".to_owned(),
        ("particles", _) => "write { mass = \"1 kg\", position = [0, 0, \"0.5 m\"] }".to_owned(),
        _ => "write { ... }".to_owned(),
    }
}

/// Keys, and an example of a table for them.
const TABLES: [(&str, &str); 21] = [
    ("surface", "{ shape = \"sphere\", radius = \"20 mm\" }"),
    ("ground", "{ shape = \"plane\", slope = \"10 deg\" }"),
    ("outer inner", "{ angle = \"10 deg\" }"),
    ("rotor", "{ rate = \"6000 rpm\" }"),
    ("base", "{ latitude = \"52 deg\" }"),
    ("to", "\"nadir\", or { space = [1, 0, 0] }"),
    ("then", "\"stop\", or { switch = \"thruster\", on = false }"),
    ("spin", "{ body = [0, 0, \"12 rad/s\"] }"),
    ("omega", "{ body = [\"0\", \"0\", \"2[rad/s^2]*t\"] }"),
    ("attitude rotate", "{ axis = [0, 0, 1], angle = \"90 deg\" }"),
    ("pulses", "{ width = \"0.2 s\", period = \"5 s\" }"),
    ("balance", "{ planes = [0, \"0.2 m\"], radii = [\"50 mm\", \"50 mm\"] }"),
    ("normal", "{ mean = 3, sd = 0.1 }"),
    ("uniform log_uniform", "{ from = 0.1, to = 0.5 }"),
    ("log_normal", "{ median = 0.3, sigma = 0.5 }"),
    ("triangular", "{ from = 0.1, mode = 0.2, to = 0.5 }"),
    ("grid", "{ from = 0, to = 1, count = 11 }"),
    ("magnitude", "{ uniform = { from = 0, to = 1 } }"),
    ("random", "\"uniform\", or { sd = \"2 deg\" }"),
    ("direction", "\"uniform\", or { within = \"5 deg\" }"),
    ("particles", "[{ mass = \"1 kg\", position = [0, 0, \"0.5 m\"] }]"),
];

fn same(word: &str, other: &str) -> bool {
    let letters = |text: &str| text.to_lowercase().replace(['-', ' '], "_");
    letters(word) == letters(other)
}
