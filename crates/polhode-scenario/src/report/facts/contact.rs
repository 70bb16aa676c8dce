//! A body on the ground.

use polhode::motion::contact::{
    BodySurface, ContactEvent, ContactState, Friction, Grip, Ground, GroundShape, GroundSide, SurfaceShape,
};
use polhode::motion::{GroundContact, Series, Trajectory};
use polhode_document::fact::{Fact, Quantity};
use polhode_document::json::vector;
use polhode_document::number::{DIGITS, number, vector as triple};
use polhode_document::unit::{angle, length, place};
use serde_json::{Value, json};

use crate::report::global_error::{self, known_to};

/// Maximum number of changes of contact in the text; JSON contains all of them.
const MOST: usize = 12;

/// Describes the contact, such as `it rolls without slipping on a level plane`.
pub(crate) fn how(ground: &GroundContact) -> String {
    let contact = &ground.contact;
    let law = match contact.law.grip() {
        Grip::NoSlip => "it rolls without slipping",
        Grip::Friction(friction) if *friction == Friction::default() => "it slides without friction",
        _ => "it rolls or slides, with friction,",
    };
    format!("{law} {}", place_of(&contact.ground))
}

/// Returns facts about the surface, the ground, the contact law, the changes of contact, and the
/// state at both ends.
pub(super) fn facts(
    ground: &GroundContact,
    states: Series<'_, ContactState>,
    trajectory: &Trajectory,
) -> Vec<Fact> {
    let contact = &ground.contact;
    let gravity = contact.gravity.to_array();
    let changes = trajectory.changes();
    let change = |event: &ContactEvent| {
        let time = Quantity::Duration(event.time);
        Fact::shown("change of contact", time).note(event.change.to_string())
    };
    let mut facts = vec![
        Fact::new(
            "contact.surface",
            "surface",
            Quantity::Data(surface_json(&contact.surface), surface(&contact.surface)),
        ),
        Fact::new(
            "contact.ground",
            "ground",
            Quantity::Data(ground_json(&contact.ground), form(&contact.ground)),
        ),
        Fact::new("contact.law", "contact law", Quantity::Data(law_json(ground), law(ground))),
        Fact::new("contact.gravity_m_s2", "g", Quantity::Vector(gravity, "m/s²")),
        Fact::data("contact.changes", changes.iter().map(change_json).collect::<Value>()),
        Fact::data("contact.energy_drift", Quantity::Error(trajectory.energy_drift(), "")),
    ];
    facts.extend(state("start", " at the start", &states.start(), 0.0, true));
    facts.extend(changes.iter().take(MOST).map(change));
    if changes.len() > MOST {
        let all = Quantity::Count(changes.len() as u64);
        facts.push(Fact::shown("changes of contact", all).note("in all: summary.json has them"));
    }
    match states.last() {
        Some(last) => {
            let error = global_error::of_attitude(trajectory);
            facts.extend(state("final", " at the end", &last, error, states.start() != last));
        }
        None => facts.push(Fact::data("contact.final", None)),
    }
    facts
}

fn change_json(event: &ContactEvent) -> Value {
    json!({ "time_s": event.time, "change": event.change.name(), "what": event.change.to_string() })
}

/// Returns the state of the contact; `error` is the error of the attitude, rad.
fn state(key: &str, when: &str, s: &ContactState, error: f64, is_shown: bool) -> Vec<Fact> {
    // A rolling body moves by its lever times its rotation angle.
    let lever = (s.center - s.contact).norm();
    let vector = |v: [f64; 3], unit| Quantity::Vector(v, unit);
    let fact = |name: &str, label: &str, value: Quantity| {
        let label = if label.is_empty() { String::new() } else { format!("{label}{when}") };
        Fact::new(format!("contact.{key}.{name}"), label, value).shown_if(is_shown)
    };
    vec![
        fact("time_s", "", Quantity::Duration(s.state.time)),
        fact("phase", "contact", Quantity::Word(s.phase.name(), s.phase.name().to_owned())),
        known_to(error, fact("center_m", "centre", vector(s.center.to_array(), "m")).within(lever * error))
            .note("of mass, in space axes"),
        fact("velocity_m_s", "", vector(s.velocity.to_array(), "m/s")),
        fact("contact_m", "", vector(s.contact.to_array(), "m")),
        fact("contact_body_m", "", vector(s.contact_in_body.to_array(), "m")),
        known_to(error, fact("normal_force_n", "force", Quantity::Number(s.normal_force, "N")))
            .note(format!("normal; slip {} m/s", number(s.slip.norm(), 6))),
        fact("slip_m_s", "", vector(s.slip.to_array(), "m/s")),
        fact("friction_n", "", vector(s.friction.to_array(), "N")),
        fact("kinetic_energy_j", "", Quantity::Energy(s.kinetic_energy)),
        fact("potential_energy_j", "", Quantity::Energy(s.potential_energy)),
        Fact::new(
            format!("contact.{key}.friction_work_j"),
            "work of friction",
            Quantity::Energy(s.friction_work),
        )
        .shown_if(s.friction_work != 0.0),
        Fact::new(
            format!("contact.{key}.ground_work_j"),
            "work of the ground",
            Quantity::Energy(s.ground_work),
        )
        .shown_if(s.ground_work != 0.0),
    ]
}

/// Describes a surface, such as `ellipsoid, semi-axes (200, 30, 20) mm, centred at (0, 0, 10) mm`.
pub(crate) fn surface(surface: &BodySurface) -> String {
    let center = surface.center().to_array();
    let shape = match *surface.shape() {
        SurfaceShape::Sphere { radius } => format!("sphere, radius {}", length(radius)),
        SurfaceShape::Ellipsoid { semi_axes } => format!("ellipsoid, semi-axes {}", place(semi_axes)),
        SurfaceShape::Rim { radius, tube, thickness } => {
            let tube = if tube > 0.0 { format!(", tube {}", length(tube)) } else { String::new() };
            let thick =
                if thickness > 0.0 { format!(", thickness {}", length(thickness)) } else { String::new() };
            format!("rim, radius {}{tube}{thick}", length(radius))
        }
        SurfaceShape::Cylinder { radius, length: along } => {
            let along = along.map_or_else(String::new, |along| format!(", length {}", length(along)));
            format!("cylinder that lies, radius {}{along}", length(radius))
        }
        _ => "surface".to_owned(),
    };
    format!("{shape}, centred at {} in the body", place(center))
}

/// Describes the place, such as `on a level plane`.
fn place_of(ground: &Ground) -> String {
    let in_or_on = match ground.shape() {
        GroundShape::Sphere { side: GroundSide::Inside, .. }
        | GroundShape::Cylinder { side: GroundSide::Inside, .. } => "in",
        _ => "on",
    };
    format!("{in_or_on} {}", form(ground))
}

/// Describes the ground, such as `a level plane that turns at 3 rad/s`.
pub(crate) fn form(ground: &Ground) -> String {
    let axis = triple(ground.axis().to_array(), 6);
    let inside = |side: GroundSide| if side == GroundSide::Inside { "the inside" } else { "the outside" };
    let shape = match *ground.shape() {
        GroundShape::Plane if ground.axis().z >= 1.0 => "a level plane".to_owned(),
        GroundShape::Plane => {
            format!(
                "a plane of normal {axis}, {} from the level",
                angle(ground.axis().z.clamp(-1.0, 1.0).acos())
            )
        }
        GroundShape::Sphere { radius, side } => {
            format!("{} of a sphere, radius {}", inside(side), length(radius))
        }
        GroundShape::Cylinder { radius, side } => {
            format!("{} of a cylinder, radius {}, along {axis}", inside(side), length(radius))
        }
        _ => "the ground".to_owned(),
    };
    match ground.turning() {
        0.0 => shape,
        rate => format!("{shape}, turning about {axis} at {} rad/s", number(rate, DIGITS)),
    }
}

fn law(ground: &GroundContact) -> String {
    let law = &ground.contact.law;
    let mut text = match *law.grip() {
        Grip::Friction(friction) if friction == Friction::default() => "no friction".to_owned(),
        Grip::Friction(friction) => {
            let [kinetic, sticking] = [friction.kinetic, friction.sticking].map(|x| number(x, DIGITS));
            let coulomb = match friction.kinetic == friction.sticking {
                true => format!("friction µ = {kinetic}"),
                false => format!("friction µ = {kinetic}, at rest µₛ = {sticking}"),
            };
            let viscous = match friction.viscous {
                0.0 => String::new(),
                c => format!(", viscous c = {} N·s/m", number(c, DIGITS)),
            };
            coulomb + &viscous
        }
        _ => "rolls without slipping".to_owned(),
    };
    let resistance = law.resistance();
    for (lever, of) in [(resistance.rolling, "rolling"), (resistance.pivoting, "pivoting")] {
        if lever > 0.0 {
            text.push_str(&format!(", {of} friction {}", length(lever)));
        }
    }
    text
}

fn surface_json(surface: &BodySurface) -> Value {
    let shape = match *surface.shape() {
        SurfaceShape::Sphere { radius } => json!({ "shape": "sphere", "radius_m": radius }),
        SurfaceShape::Ellipsoid { semi_axes } => json!({ "shape": "ellipsoid", "semi_axes_m": semi_axes }),
        SurfaceShape::Rim { radius, tube, thickness } => {
            json!({ "shape": "rim", "radius_m": radius, "tube_m": tube, "thickness_m": thickness })
        }
        SurfaceShape::Cylinder { radius, length } => {
            json!({ "shape": "cylinder", "radius_m": radius, "length_m": length })
        }
        _ => json!({}),
    };
    with(
        shape,
        [
            ("center_body_m", vector(surface.center())),
            ("axes_in_body_wxyz", json!(surface.axes().canonical_quaternion())),
        ],
    )
}

fn ground_json(ground: &Ground) -> Value {
    let side = |side: GroundSide| if side == GroundSide::Inside { "inside" } else { "outside" };
    let shape = match *ground.shape() {
        GroundShape::Sphere { radius, side: at } => {
            json!({ "shape": "sphere", "radius_m": radius, "side": side(at) })
        }
        GroundShape::Cylinder { radius, side: at } => {
            json!({ "shape": "cylinder", "radius_m": radius, "side": side(at) })
        }
        _ => json!({ "shape": "plane" }),
    };
    with(shape, [("axis", vector(ground.axis())), ("rate_rad_s", ground.turning().into())])
}

fn law_json(ground: &GroundContact) -> Value {
    let (law, resistance) = (&ground.contact.law, ground.contact.law.resistance());
    let grip = match *law.grip() {
        Grip::Friction(friction) => json!({
            "name": if friction == Friction::default() { "frictionless" } else { "friction" },
            "friction": friction.kinetic,
            "static_friction": friction.sticking,
            "viscous_n_s_m": friction.viscous,
        }),
        _ => json!({ "name": "rolling" }),
    };
    with(
        grip,
        [
            ("rolling_friction_m", resistance.rolling.into()),
            ("pivoting_friction_m", resistance.pivoting.into()),
        ],
    )
}

fn with<const N: usize>(mut object: Value, more: [(&str, Value); N]) -> Value {
    for (key, value) in more {
        object[key] = value;
    }
    object
}
