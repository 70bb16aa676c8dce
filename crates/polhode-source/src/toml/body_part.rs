//! Part of a body, written as TOML.

use core::fmt::Write as _;

use polhode::body::MassProperties;
use polhode::math::Body;

/// Part of a body in a scenario file.
#[derive(Debug)]
pub struct BodyPart<'a> {
    /// Description of the part and its numbers; each line becomes a comment.
    pub comments: Vec<String>,
    /// Name of the part.
    pub name: &'a str,
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass from the origin of the body, body axes, m.
    pub center: [f64; 3],
    /// Ixx, Iyy, Izz, Ixy, Ixz, Iyz about the centre of mass, body axes, kg m².
    pub inertia: [f64; 6],
}

impl<'a> BodyPart<'a> {
    /// Creates a part with one comment from the mass properties of a body.
    pub fn of_body(comment: String, name: &'a str, body: &MassProperties<Body>) -> Self {
        let [[xx, xy, xz], [_, yy, yz], [.., zz]] = body.inertia().matrix();
        Self {
            comments: vec![comment],
            name,
            mass: body.mass(),
            center: body.center_of_mass().to_array(),
            inertia: [xx, yy, zz, xy, xz, yz],
        }
    }

    /// Returns the part as a `[[body.part]]` table.
    pub fn to_toml(&self) -> String {
        let mut text = String::new();
        for line in &self.comments {
            let line: String = line.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
            let _ = writeln!(text, "# {line}");
        }
        let [x, y, z] = self.center;
        let [xx, yy, zz, xy, xz, yz] = self.inertia;
        let rows: String = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
            .map(|[x, y, z]| format!("    [{x:?}, {y:?}, {z:?}],\n"))
            .concat();
        let _ = write!(
            text,
            "[[body.part]]\nname = \"{}\"\nshape = \"tensor\"\nmass = {:?}\ncenter_of_mass = [{x:?}, {y:?}, {z:?}]\ninertia = [\n{rows}]\n",
            self.name, self.mass
        );
        text
    }
}
