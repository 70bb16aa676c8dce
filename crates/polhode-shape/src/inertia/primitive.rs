//! Shapes that a few lengths determine.

use std::str::FromStr;

use polhode::body::shape::{
    BoxShape, Capsule, Cone, Cylinder, Disk, Ellipsoid, Rod, Shape, Sphere, Substance, Torus,
};
use polhode::body::{BodyError, Form};
use polhode::math::{Body, Position};
use polhode_document::{SourceInfo, unit};
use polhode_source::Failure;
use polhode_source::given::list;
use polhode_source::unit::{Dimension, bare};
use serde_json::{Map, Value};

use super::in_body;
use crate::report::InertiaReport;

/// Shape of uniform density that N lengths determine.
pub trait Primitive<const N: usize>: Shape + Sized {
    /// Name, as in scenario files and as option.
    const NAME: &'static str;
    /// Names of the lengths, in the order of the option's value.
    const LENGTHS: [&'static str; N];
    /// Position and directions in body axes.
    const PLACE: &'static str;

    /// Creates the shape from its lengths, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the lengths do not form a shape.
    fn of_lengths(lengths: [f64; N]) -> Result<Self, BodyError>;
}

/// Implements [`Primitive`] for shapes: name, lengths, constructor, position.
macro_rules! primitives {
    ($($shape:ident: $name:literal, $n:literal [$($length:ident),+] => $new:expr, $place:literal;)*) => {$(
        impl Primitive<$n> for $shape {
            const NAME: &'static str = $name;
            const LENGTHS: [&'static str; $n] = [$(stringify!($length)),+];
            const PLACE: &'static str = $place;

            fn of_lengths([$($length),+]: [f64; $n]) -> Result<Self, BodyError> {
                $new
            }
        }
    )*};
}

primitives! {
    BoxShape: "box", 3 [a, b, c] => Self::new([a, b, c]), "edges along x, y, z; centre at the origin";
    Sphere: "sphere", 1 [radius] => Self::new(radius), "centre at the origin";
    Ellipsoid: "ellipsoid", 3 [a, b, c] => Self::new([a, b, c]),
        "semi-axes along x, y, z; centre at the origin";
    Cylinder: "cylinder", 2 [radius, length] => Self::new(radius, length),
        "axis along z, centre at the origin";
    Capsule: "capsule", 2 [radius, length] => Self::new(radius, length),
        "length without the caps; axis along z, centre at the origin";
    Cone: "cone", 2 [radius, height] => Self::new(radius, 0.0, height),
        "apex on +z, centre of the base at the origin";
    Torus: "torus", 2 [ring_radius, tube_radius] => Self::new(ring_radius, tube_radius),
        "axis along z, centre at the origin";
    Rod: "rod", 1 [length] => Self::new(length), "thin, along z, centre at the origin";
    Disk: "disk", 1 [radius] => Self::new(radius), "thin, axis along z, centre at the origin";
}

/// Shape, parsed from its lengths, such as `2 cm, 5 cm`. A unit is required, because a bare number
/// may be meant in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured<S, const N: usize> {
    shape: S,
    lengths: [f64; N],
}

impl<S: Primitive<N>, const N: usize> FromStr for Measured<S, N> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let form = || {
            let example = ["20 cm", "10 cm", "6 cm"].into_iter().take(N).collect::<Vec<_>>().join(", ");
            let lengths = if N == 1 { "length" } else { "lengths" };
            format!("{N} {lengths} ({}), such as \"{example}\"", spaced(S::LENGTHS).join(", "))
        };
        let lengths = list(text, Dimension::LENGTH)?;
        let count = lengths.len();
        let lengths = lengths.try_into().map_err(|_| format!("expected {}, but found {count}", form()))?;
        if text.trim().trim_matches(['(', ')']).split(',').all(|part| bare(part).is_some()) {
            return Err(format!("{text:?} has no unit: expected {}", form()));
        }
        let shape = S::of_lengths(lengths).map_err(|error| error.to_string())?;
        Ok(Self { shape, lengths })
    }
}

/// Returns the names of lengths as words.
fn spaced<const N: usize>(names: [&str; N]) -> [String; N] {
    names.map(|name| name.replace('_', " "))
}

/// Primitive of any kind.
pub(super) trait AnyPrimitive {
    /// Returns the name, which is the option without dashes.
    fn name(&self) -> &'static str;

    /// Returns the corner with the smallest coordinates; `None` for shapes other than a box.
    fn corner(&self) -> Option<Position<Body>>;

    /// Returns the report of the shape made of a substance.
    ///
    /// # Errors
    /// [`Failure`] without a substance, or if it does not fit the shape.
    fn report(&self, substance: Option<Substance>) -> Result<InertiaReport, Failure>;
}

impl<S: Primitive<N>, const N: usize> AnyPrimitive for Measured<S, N> {
    fn name(&self) -> &'static str {
        S::NAME
    }

    fn corner(&self) -> Option<Position<Body>> {
        match self.shape.form() {
            Some(Form::Box { size }) => Some(Position::from_array(size.map(|edge| -0.5 * edge))),
            _ => None,
        }
    }

    fn report(&self, substance: Option<Substance>) -> Result<InertiaReport, Failure> {
        let volume = self.shape.spread().extent().volume();
        let substance = match (substance, volume) {
            (Some(Substance::Density(_)), None) => {
                let message =
                    format!("--density and --material are only for solids, but --{} is thin", S::NAME);
                return Err(Failure::usage(message, "give --mass"));
            }
            (Some(substance), _) => substance,
            (None, Some(_)) => return Err(no_mass(S::NAME, "give --mass, --density or --material")),
            (None, None) => return Err(no_mass(S::NAME, "give --mass")),
        };
        let properties = self.shape.mass_properties(substance).and_then(in_body).map_err(|error| {
            Failure::usage(error.to_string(), format!("check --{} and its mass or density", S::NAME))
        })?;
        let names = spaced(S::LENGTHS);
        let lengths = names.iter().zip(self.lengths);
        let words: Vec<_> = lengths.map(|(name, m)| format!("{name} = {}", unit::length(m))).collect();
        let keys = S::LENGTHS.iter().zip(self.lengths);
        let keys: Map<_, _> = keys.map(|(name, m)| ((*name).to_owned(), m.into())).collect();
        let source = SourceInfo::new(S::NAME, "shape")
            .described(format!("{}; {}", words.join(", "), S::PLACE))
            .with("lengths_m", Value::Object(keys));
        // A rod has no area, and that of a huge thin box may be infinite.
        let area = Some(self.shape.surface_area()).filter(|area| *area > 0.0 && area.is_finite());
        Ok(InertiaReport { surface_area: area, ..InertiaReport::new(source, properties).with_volume(volume) })
    }
}

fn no_mass(name: &str, hint: &str) -> Failure {
    Failure::usage(format!("the mass of --{name} is missing"), hint)
}
