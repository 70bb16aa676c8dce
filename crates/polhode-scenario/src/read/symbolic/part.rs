//! Parts of a body in symbols.

use polhode_algebra::{Matrix, RationalFunction, Vector};
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::shape::moments;
use super::value::{Letters, unreadable};
use crate::symbolic::{Gap, OwnTensor, SymbolicPart, SymbolicParticle, about_axis, sine_and_cosine};

/// Returns part number `number`, counted from 1.
pub(super) fn part(letters: &Letters<'_>, table: &Table<'_>, number: usize) -> Result<SymbolicPart, Gap> {
    let kind = table.get("shape").and_then(|shape| shape.string().ok()).unwrap_or_default();
    let name = table.get("name").and_then(|name| name.string().ok());
    let name = name.map_or_else(|| format!("{kind} {number}"), str::to_owned);
    let of = |what: &str| format!("the {what} of part \"{name}\"");
    let position = match table.get("position") {
        Some(position) => letters.vector(&position, Dimension::LENGTH, || of("position"))?,
        None => Vector::zero(),
    };
    let rotation = match table.get("rotate") {
        Some(value) => rotation(letters, &value, || of("rotation"))?,
        None => None,
    };
    let placed = |v: &Vector| match &rotation {
        Some(r) => &position + &r.times_vector(v),
        None => &position + v,
    };
    if kind == "particles" {
        let list = table.get("particles").ok_or_else(|| unreadable(of("particles")))?;
        let list = list.elements("tables").map_err(|_| unreadable(of("particles")))?;
        let particles = list.iter().map(|element| {
            let table = element.table().map_err(|_| unreadable(of("particles")))?;
            let value = |key| table.get(key).ok_or_else(|| unreadable(of("particles")));
            let mass = letters.quantity(&value("mass")?, Dimension::MASS, || of("mass"))?;
            let at = letters.vector(&value("position")?, Dimension::LENGTH, || of("position"))?;
            Ok(SymbolicParticle { mass, position: placed(&at) })
        });
        let particles = particles.collect::<Result<Vec<_>, Gap>>()?;
        return Ok(SymbolicPart { name: name.clone(), particles, own: None });
    }
    let moments = moments(letters, table, kind, &name)?;
    let mass = mass(letters, table, moments.measure.as_ref(), of)?;
    let tensor = moments.tensor(&mass);
    let particles = vec![SymbolicParticle { mass, position: placed(&moments.centroid) }];
    Ok(SymbolicPart { particles, own: Some(OwnTensor { tensor, rotation }), name: name.clone() })
}

/// Returns the mass, given or as density times volume.
fn mass(
    letters: &Letters<'_>,
    table: &Table<'_>,
    measure: Option<&RationalFunction>,
    of: impl Fn(&str) -> String,
) -> Result<RationalFunction, Gap> {
    if let Some(mass) = table.get("mass") {
        return letters.quantity(&mass, Dimension::MASS, || of("mass"));
    }
    let without = |why| Gap::Kind { what: of("mass"), why };
    let density =
        table.get("density").ok_or_else(|| without("is that of a material; give mass or density a name"))?;
    let measure =
        measure.ok_or_else(|| without("is not a rational function of sizes and density; name it"))?;
    let thickness = table.get("thickness");
    let thickness =
        thickness.map(|value| letters.quantity(&value, Dimension::LENGTH, || of("thickness"))).transpose()?;
    // The density of a thin part without a thickness is per area or length.
    let kinds = [Dimension::DENSITY, Dimension::AREA_DENSITY, Dimension::LINE_DENSITY];
    let dimension = kinds.into_iter().find(|kind| density.quantity(*kind).is_ok());
    let dimension = dimension.ok_or_else(|| without("is the integral of a varying density"))?;
    let density = letters.quantity(&density, dimension, || of("density"))?;
    Ok(density * measure * thickness.unwrap_or_else(RationalFunction::one))
}

/// Returns a rotation; `None` for none.
pub(super) fn rotation(
    letters: &Letters<'_>,
    value: &Value<'_>,
    what: impl Fn() -> String,
) -> Result<Option<Matrix>, Gap> {
    let table = value.table().map_err(|_| unreadable(what()))?;
    let inexact = |why| Gap::Kind { what: what(), why };
    let turn = |axis: &Vector, angle: &RationalFunction| {
        let both = sine_and_cosine(angle, letters.pi).ok_or_else(|| {
            inexact("has an angle without exact sine; use a symbol, or a multiple of 15 deg")
        })?;
        about_axis(axis, &both, &letters.symbols).ok_or_else(|| inexact("has an axis without exact length"))
    };
    if let (Some(axis), Some(angle)) = (table.get("axis"), table.get("angle")) {
        let axis = letters.vector(&axis, Dimension::NONE, &what)?;
        return turn(&axis, &letters.quantity(&angle, Dimension::ANGLE, &what)?).map(Some);
    }
    // R = Rz(φ) Rx(θ) Rz(ψ), and R = Rz(yaw) Ry(pitch) Rx(roll)
    for (key, axes) in [("euler313", [2, 0, 2]), ("roll_pitch_yaw", [0, 1, 2])] {
        let Some(angles) = table.get(key) else { continue };
        let angles = letters.vector(&angles, Dimension::ANGLE, &what)?;
        let mut turns = Vec::new();
        for (axis, angle) in axes.into_iter().zip(&angles.0) {
            turns.push(turn(&Vector::unit(axis), angle)?);
        }
        if key == "roll_pitch_yaw" {
            turns.reverse();
        }
        return Ok(Some(turns[0].times(&turns[1]).times(&turns[2])));
    }
    if let Some(rows) = table.get("matrix") {
        let rows = rows.fixed::<3>("rows").map_err(|_| unreadable(what()))?;
        let [x, y, z] = rows.map(|row| letters.vector(&row, Dimension::NONE, &what));
        return Ok(Some(Matrix([x?.0, y?.0, z?.0])));
    }
    if table.get("quaternion").is_none() {
        return Err(inexact("is given in a form without symbols; use axis and angle, euler313 or matrix"));
    }
    let parts = table.get("quaternion").map(|value| value.fixed::<4>("numbers"));
    let parts = parts.and_then(Result::ok).ok_or_else(|| unreadable(what()))?;
    let [w, x, y, z] = parts.map(|part| letters.quantity(&part, Dimension::NONE, &what));
    let (w, v) = (w?, Vector([x?, y?, z?]));
    // R = cos θ 1 + … with cos θ = (w² − v²)/q², and the axis v with sin θ = 2 w |v|/q²:
    // written without roots, R = 1 + 2 (w [v]× + [v]×²)/q².
    let square = &w * &w + v.dot(&v);
    let scale =
        RationalFunction::from(2).over(&square).ok_or_else(|| inexact("has a quaternion of length zero"))?;
    let cross = Matrix::from_elements(|i, j| v.cross(&Vector::unit(j)).0[i].clone());
    let twice = (cross.scaled(&w) + cross.times(&cross)).scaled(&scale);
    Ok(Some(Matrix::identity() + twice))
}
