//! `SpatialTransform` of a `CustomJoint` with all coordinates at zero: three rotations about
//! successively rotated axes, and three translations along axes of the parent's frame.
//!
//! Functions are read if their value at zero is in the file; a spline passes through its points.

use crate::model::Pose;
use crate::pose::{about_axis, product, sum};
use crate::read::xml::{Element, Written};

const TURNS: [&str; 3] = ["rotation1", "rotation2", "rotation3"];
const WAYS: [&str; 3] = ["translation1", "translation2", "translation3"];

/// Maximum nesting depth of functions.
const MOST_STEPS: usize = 20;

/// Returns the pose of the moving frame in the fixed frame, or the reason why it is unknown.
pub(super) fn at_zero(joint: Element<'_>) -> Result<Pose, String> {
    let mut pose = Pose::IDENTITY;
    let axes = || joint.named("SpatialTransform").flat_map(|own| own.named("TransformAxis"));
    if let Some(other) = axes().find(|axis| {
        !axis.word("name").is_some_and(|name| TURNS.into_iter().chain(WAYS).any(|known| known == name))
    }) {
        return Err(format!(
            "{:?} is not an axis of a SpatialTransform",
            other.word("name").unwrap_or_default()
        ));
    }
    for name in TURNS.into_iter().chain(WAYS) {
        let mut own = axes().filter(|axis| axis.word("name") == Some(name));
        let (Some(axis), None) = (own.next(), own.next()) else {
            if axes().any(|axis| axis.word("name") == Some(name)) {
                return Err(format!("{name} occurs twice"));
            }
            continue;
        };
        let value = value(axis).map_err(|why| format!("{name} at zero: {why}"))?;
        if value == 0.0 {
            continue;
        }
        let direction = direction(axis).ok_or_else(|| format!("{name} has no axis of length 1"))?;
        if TURNS.contains(&name) {
            let turn = about_axis(direction, value).ok_or_else(|| format!("{name} has no axis"))?;
            pose.rotation = product(pose.rotation, turn);
        } else {
            pose.position = sum(pose.position, direction.map(|c| value * c));
        }
    }
    Ok(pose)
}

fn direction(axis: Element<'_>) -> Option<[f64; 3]> {
    let written = axis.child_text("axis")?.array::<3>()?;
    let length = written.iter().map(|c| c * c).sum::<f64>().sqrt();
    ((length - 1.0).abs() < 1e-6).then(|| written.map(|c| c / length))
}

/// Returns the value of an axis with its coordinates at zero; zero if it has no function.
fn value(axis: Element<'_>) -> Result<f64, String> {
    let function = axis.children().find(|child| child.word("name") == Some("function"));
    let held = axis.child("function").and_then(|own| own.children().next());
    let others = ["coordinates", "axis", "function"];
    match function.or(held) {
        Some(function) => of_function(function),
        None => match axis.children().find(|child| !others.contains(&child.name())) {
            Some(other) => Err(format!("{} is not read", other.name())),
            None => Ok(0.0),
        },
    }
}

fn of_function(function: Element<'_>) -> Result<f64, String> {
    let (mut function, mut scale) = (function, 1.0);
    for _ in 0..MOST_STEPS {
        let last = |text: Option<Written<'_>>, default: f64| {
            text.map_or(Some(default), |text| text.values().last()).filter(|value| value.is_finite())
        };
        let is_numbers =
            |name: &str| function.child_text(name).is_none_or(|text| text.values().all(f64::is_finite));
        let value = match function.name() {
            "Constant" => last(function.child_text("value"), 0.0),
            // The coefficients begin with the highest power.
            "LinearFunction" | "PolynomialFunction" if is_numbers("coefficients") => {
                last(function.child_text("coefficients"), 0.0)
            }
            "SimmSpline" | "NaturalCubicSpline" | "PiecewiseLinearFunction" => {
                return spline(function).map(|y| scale * y);
            }
            "MultiplierFunction" => {
                let factor = last(function.child_text("scale"), 1.0).ok_or("its scale is not a number")?;
                let inner = function.child("function").and_then(|own| own.children().next());
                let named = function.children().find(|child| child.word("name") == Some("function"));
                function = inner.or(named).ok_or("MultiplierFunction without a function")?;
                scale *= factor;
                continue;
            }
            other => return Err(format!("{other} is not read")),
        };
        return value
            .map(|value| scale * value)
            .filter(|value| value.is_finite())
            .ok_or_else(|| format!("{} has an invalid number", function.name()));
    }
    Err("functions nested too deeply".to_owned())
}

/// Returns the value of a spline at zero, if this is one of its points.
fn spline(function: Element<'_>) -> Result<f64, String> {
    let numbers = |name: &str| function.child_text(name).map(|text| text.values().collect::<Vec<_>>());
    let (Some(x), Some(y)) = (numbers("x"), numbers("y")) else {
        return Err(format!("{} without points", function.name()));
    };
    if x.len() != y.len() || !x.iter().chain(&y).all(|value| value.is_finite()) {
        return Err(format!("{} has an invalid number", function.name()));
    }
    let mut at_zero = x.iter().zip(&y).filter(|(x, _)| **x == 0.0);
    match (at_zero.next(), at_zero.next()) {
        (Some((_, y)), None) => Ok(*y),
        _ => Err(format!("{} is read only at its points", function.name())),
    }
}
