//! Edits of numbers whose positions the model does not store: the sizes of shapes and the centre of
//! mass.
//!
//! The element is parsed again from its own text. If its numbers differ from the model's, nothing
//! is edited. Reasons are another frame, a default class or an entity.

use polhode_source::xml::{Element, Number, with_root};

use super::written::{restyled, shifted};
use crate::model::{Geometry, GeometryShape, Inertial, ModelFormat, RobotModel, Span};

/// Returns the edits that multiply the sizes of all shapes of a link by a factor; `None` if one of
/// them cannot be written.
pub(super) fn resized(model: &RobotModel, shapes: &[Geometry], factor: f64) -> Option<Vec<(Span, String)>> {
    let mut edits = Vec::new();
    for geometry in shapes {
        let edit = in_element(model, &geometry.span, |root| of_shape(model.format, root, geometry, factor))?;
        for one in edit {
            if !edits.contains(&one) {
                edits.push(one);
            }
        }
    }
    Some(edits)
}

/// Returns the three numbers of the centre of mass.
pub(super) fn center(model: &RobotModel, inertial: &Inertial) -> Option<[Number; 3]> {
    let numbers = in_element(model, &inertial.span, |root| {
        let written = match model.format {
            ModelFormat::Urdf => root.child("origin")?.attribute("xyz")?,
            ModelFormat::Sdf => root.child_text("pose")?,
            ModelFormat::Mjcf => root.attribute("pos")?,
            ModelFormat::Usd | ModelFormat::Osim => return None,
        };
        Some(written.numbers().take(3).collect::<Vec<_>>())
    })?;
    let numbers = numbers.into_iter().map(|number| moved(number, inertial.span.start));
    let numbers: [Number; 3] = numbers.collect::<Vec<_>>().try_into().ok()?;
    let agree = numbers.iter().zip(inertial.pose.position).all(|(number, x)| number.value == Some(x));
    agree.then_some(numbers)
}

/// Returns the number multiplied by a factor. For a power of ten the digits are kept.
pub(super) fn multiplied(number: &Number, factor: f64) -> Option<String> {
    let power = factor.log10().round();
    // Shifting the decimal point is exact. Powers of ten below 10²² are exact, too.
    let is_power = (factor / 10_f64.powi(power as i32) - 1.0).abs() < 1e-12;
    if is_power {
        shifted(&number.text, power as i32)
    } else {
        Some(restyled(factor * number.value?, &number.text))
    }
}

fn in_element<T>(model: &RobotModel, span: &Span, read: impl FnOnce(Element<'_>) -> Option<T>) -> Option<T> {
    if model.is_included(span) {
        return None;
    }
    let mut found = None;
    with_root(model.text.get(span.clone())?, |root| {
        found = read(root);
        Ok(())
    })
    .ok()?;
    found
}

fn of_shape(
    format: ModelFormat,
    root: Element<'_>,
    geometry: &Geometry,
    factor: f64,
) -> Option<Vec<(Span, String)>> {
    let start = geometry.span.start;
    let shape = root.child("geometry")?.children().next()?;
    let names: &[&str] = match geometry.shape {
        GeometryShape::Mesh { .. } => &["scale"],
        GeometryShape::Box(_) => &["size"],
        GeometryShape::Sphere(_) => &["radius"],
        GeometryShape::Cylinder { .. } | GeometryShape::Capsule { .. } | GeometryShape::Cone { .. } => {
            &["radius", "length"]
        }
        GeometryShape::Ellipsoid(_) => &["radii"],
        GeometryShape::Inline { .. } | GeometryShape::Other(_) => return None,
    };
    let mut edits = Vec::new();
    for name in names {
        let written = match format {
            ModelFormat::Urdf => shape.attribute(name),
            ModelFormat::Sdf => shape.child_text(name),
            ModelFormat::Mjcf | ModelFormat::Usd | ModelFormat::Osim => return None,
        };
        let Some(written) = written else {
            edits.push(unscaled(format, shape, start, factor)?);
            continue;
        };
        for number in written.numbers() {
            let text = multiplied(&number, factor)?;
            edits.push((moved(number, start).span, text));
        }
    }
    Some(edits)
}

/// Returns the edit that inserts a scale for a mesh without one, after its file name.
fn unscaled(format: ModelFormat, mesh: Element<'_>, start: usize, factor: f64) -> Option<(Span, String)> {
    let scale = format!("{factor} {factor} {factor}");
    let (end, text) = match format {
        ModelFormat::Urdf => {
            // Position after the closing quote.
            let end = mesh.attribute("filename")?.span.end;
            mesh.document().get(end..end + 1).filter(|quote| ["\"", "'"].contains(quote))?;
            (end + 1, format!(" scale=\"{scale}\""))
        }
        _ => (mesh.child("uri")?.span().end, format!("<scale>{scale}</scale>")),
    };
    Some((start + end..start + end, text))
}

fn moved(number: Number, start: usize) -> Number {
    Number { span: start + number.span.start..start + number.span.end, ..number }
}
