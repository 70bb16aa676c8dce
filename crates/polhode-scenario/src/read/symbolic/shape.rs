//! Shapes in symbols.

use polhode_algebra::{RationalFunction, Vector};
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::value::{Letters, unreadable};
use crate::symbolic::{Gap, Moments};

/// Returns the moments of the shape of a part.
pub(super) fn moments(
    letters: &Letters<'_>,
    table: &Table<'_>,
    kind: &str,
    part: &str,
) -> Result<Moments, Gap> {
    let of = |key: &str| format!("the {key} of part \"{part}\"");
    let value = |key: &'static str| table.get(key).ok_or_else(|| unreadable(of(key)));
    let length = |key: &'static str| letters.quantity(&value(key)?, Dimension::LENGTH, || of(key));
    let or_zero = |key: &'static str| match table.get(key) {
        Some(value) => letters.quantity(&value, Dimension::LENGTH, || of(key)),
        None => Ok(RationalFunction::zero()),
    };
    let three = |key: &'static str| letters.vector(&value(key)?, Dimension::LENGTH, || of(key)).map(|v| v.0);
    let has_ends = table.get("ends").is_some_and(|ends| ends.boolean() == Ok(true));
    let pi = RationalFunction::from(letters.pi);
    Ok(match kind {
        "box" => Moments::of_box(&three("size")?),
        "box_shell" => Moments::of_box_shell(&three("size")?),
        "plate" => {
            let [a, b] = lengths(letters, &value("size")?, || of("size"))?;
            Moments::of_plate(&[a, b])
        }
        "sphere" => Moments::of_ball(&length("radius")?, &or_zero("inner_radius")?, &pi),
        "sphere_shell" => Moments::of_sphere_shell(&length("radius")?, &pi),
        "ellipsoid" => Moments::of_ellipsoid(&three("semi_axes")?, &pi),
        "cylinder" => {
            let [outer, inner] = [length("radius")?, or_zero("inner_radius")?];
            Moments::of_cylinder(&outer, &inner, &length("length")?, &pi)
        }
        "cylinder_shell" if has_ends => Moments::of_closed_tube(&length("radius")?, &length("length")?, &pi),
        "cylinder_shell" => Moments::of_tube(&length("radius")?, &length("length")?, &pi),
        "cone" => Moments::of_cone(&length("radius")?, &or_zero("top_radius")?, &length("height")?, &pi),
        "cone_shell" if !has_ends => {
            Moments::of_cone_shell(&length("radius")?, &or_zero("top_radius")?, &length("height")?)
        }
        "capsule" => Moments::of_capsule(&length("radius")?, &length("length")?, &pi),
        "torus" => Moments::of_torus(&length("ring_radius")?, &length("tube_radius")?, &pi),
        "rod" => Moments::of_rod(&length("length")?),
        "disk" => Moments::of_disk(&length("radius")?, &pi),
        "triangular_plate" | "triangular_prism" => {
            let rows = value("vertices")?.fixed::<3>("corners").map_err(|_| unreadable(of("vertices")))?;
            let [a, b, c] = rows.map(|row| lengths(letters, &row, || of("vertices")));
            Moments::of_triangle(&[a?, b?, c?], &or_zero("length")?)
        }
        "tetrahedron" => {
            let rows = value("vertices")?.fixed::<4>("corners").map_err(|_| unreadable(of("vertices")))?;
            let corner = |row: Value<'_>| letters.vector(&row, Dimension::LENGTH, || of("vertices"));
            let [a, b, c, d] = rows.map(corner);
            let corners: [Vector; 4] = [a?, b?, c?, d?];
            Moments::of_tetrahedron(&corners)
        }
        _ => {
            let why = "has no closed form of its tensor in rational functions";
            return Err(Gap::Kind { what: format!("part \"{part}\" ({kind})"), why });
        }
    })
}

/// Returns N lengths.
fn lengths<const N: usize>(
    letters: &Letters<'_>,
    value: &Value<'_>,
    what: impl Fn() -> String,
) -> Result<[RationalFunction; N], Gap> {
    let elements = value.fixed::<N>("lengths").map_err(|_| unreadable(what()))?;
    let mut lengths = std::array::from_fn(|_| RationalFunction::zero());
    for (length, element) in lengths.iter_mut().zip(&elements) {
        *length = letters.quantity(element, Dimension::LENGTH, &what)?;
    }
    Ok(lengths)
}
