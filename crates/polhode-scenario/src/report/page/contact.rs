//! Body on the ground: the ground, the point of contact, the contact forces, and the phases of the
//! motion.

use polhode::math::{Direction, Space};
use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{ContactChange, ContactState, Ground, GroundShape, GroundSide};
use polhode::motion::{Scenario, Trajectory};
use polhode_document::json::{finite, numbers};
use serde_json::{Value, json};

use super::PageSubject;
use super::motion::Shown;
use super::rows::Rows;
use super::surface;

/// Returns the JSON of a body on the ground; null for other bodies.
pub(crate) fn json(
    trajectory: &Trajectory,
    subject: &PageSubject<'_>,
    shown: &Shown<'_>,
    rows: &mut Rows,
) -> Value {
    let (PageSubject::Scenario(scenario), Some(states)) = (subject, trajectory.channel(CONTACT)) else {
        return Value::Null;
    };
    let Some(ground) = scenario.ground() else { return Value::Null };
    let mut row = |of: &dyn Fn(&ContactState) -> f64| rows.put(shown.contact.iter().map(|s| finite(of(s))));
    let [normal_force, slip, friction] =
        [row(&|s| s.normal_force), row(&|s| s.slip.norm()), row(&|s| s.friction.norm())];
    let [friction_work, ground_work] = [row(&|s| s.friction_work), row(&|s| s.ground_work)];
    let up = Direction::<Space>::from_array(ground.contact.gravity.to_array()).direction().map(|down| -down);
    json!({
        "ground": of_ground(&ground.contact.ground),
        "up": up.map(|up| numbers(&up.to_array())),
        "surface": surface_beside(scenario),
        "center": rows.put(shown.contact.iter().flat_map(|s| s.center.to_array())),
        "point": rows.put(shown.contact.iter().flat_map(|s| s.contact.to_array())),
        "normalForce": normal_force,
        "friction": friction,
        "slip": slip,
        "frictionWork": friction_work,
        "groundWork": ground_work,
        "phases": phases(&states.start(), trajectory),
    })
}

fn of_ground(ground: &Ground) -> Value {
    let (kind, radius, side) = match *ground.shape() {
        GroundShape::Sphere { radius, side } => ("sphere", radius, Some(side)),
        GroundShape::Cylinder { radius, side } => ("cylinder", radius, Some(side)),
        _ => ("plane", 0.0, None),
    };
    json!({
        "form": kind,
        "radius": radius,
        "inside": side == Some(GroundSide::Inside),
        "axis": numbers(&ground.axis().to_array()),
        "rate": ground.turning(),
    })
}

/// Returns the surface of the body, unless its parts already show it.
fn surface_beside(scenario: &Scenario) -> Option<Value> {
    let ground = scenario.ground()?;
    let is_shown =
        !surface::has_forms(scenario.parts()) || surface::is_shown(&ground.contact.surface, scenario.parts());
    if is_shown { None } else { surface::shape(&ground.contact.surface, scenario.body().center_of_mass()) }
}

/// Returns the phases in order, each with its start and end times.
fn phases(start: &ContactState, trajectory: &Trajectory) -> Value {
    let end = trajectory.samples().last().unwrap_or(trajectory.start()).state.time;
    let mut all: Vec<(&str, f64)> = vec![(start.phase.name(), start.state.time)];
    for event in trajectory.changes() {
        let begins = match event.change {
            ContactChange::Slips | ContactChange::SlipsAnew => "sliding",
            ContactChange::Grips => "rolling",
            ContactChange::LiftsOff => "flying",
            _ => continue,
        };
        if all.last().is_some_and(|(name, _)| *name != begins) {
            all.push((begins, event.time));
        }
    }
    let ends = all.iter().skip(1).map(|(_, from)| *from).chain([end]);
    all.iter().zip(ends).map(|((name, from), to)| json!({ "name": name, "from": from, "to": to })).collect()
}
