//! The body that was found, as a scenario file.

use core::fmt;
use core::fmt::Write as _;

use polhode::body::MassProperties;
use polhode::math::Body;

/// What is said of a body besides what was found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodySize {
    /// kg
    pub mass: Option<f64>,
    /// kg·m²
    pub greatest_moment: Option<f64>,
}

/// Why there is no scenario of a body.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NoBody {
    /// Not all of it is known.
    Unknown {
        /// What was measured.
        by: &'static str,
    },
    /// Tumbles do not show the mass.
    Mass,
    /// These tumbles do not show how large the moments are.
    Size,
    /// It was found, and cannot be said.
    Found {
        /// `mass`, `greatest-moment`
        what: &'static str,
    },
}

impl NoBody {
    /// What to do.
    pub const fn hint(&self) -> &'static str {
        match self {
            Self::Unknown { .. } => "leave --body out to see what is unknown",
            Self::Mass => "weigh the body, and say it: --mass \"350 g\"",
            Self::Size => "say how large it is, as by one swing test: --greatest-moment \"0.0166 kg m^2\"",
            Self::Found { .. } => "leave the flag out",
        }
    }
}

impl fmt::Display for NoBody {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { by } => {
                write!(f, "--body has no body to print: {by} does not determine all of it")
            }
            Self::Mass => f.write_str("--body has no body to print: free motion does not show the mass"),
            Self::Size => {
                f.write_str("--body has no body to print: this motion shows only ratios of moments")
            }
            Self::Found { what } => {
                write!(f, "--{what} has nothing to say: the {} was found", what.replace('-', " "))
            }
        }
    }
}

impl std::error::Error for NoBody {}

/// A body as it stands in a scenario file.
pub(super) struct Part<'a> {
    /// What it is, and what its numbers mean: each line becomes a comment.
    pub(super) comments: Vec<String>,
    pub(super) name: &'a str,
    pub(super) mass: f64,
    pub(super) center: [f64; 3],
    /// Ixx, Iyy, Izz, Ixy, Ixz, Iyz about the centre of mass.
    pub(super) inertia: [f64; 6],
}

impl<'a> Part<'a> {
    pub(super) fn of_body(comment: String, name: &'a str, body: &MassProperties<Body>) -> Self {
        let [[xx, xy, xz], [_, yy, yz], [.., zz]] = body.inertia().matrix();
        Self {
            comments: vec![comment],
            name,
            mass: body.mass(),
            center: body.center_of_mass().to_array(),
            inertia: [xx, yy, zz, xy, xz, yz],
        }
    }

    /// `[[body.part]]`
    pub(super) fn to_toml(&self) -> String {
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
