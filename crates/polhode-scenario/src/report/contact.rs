//! A body on the ground, in text and JSON.

use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{
    BodySurface, ContactEvent, ContactState, Friction, Grip, Ground, GroundShape, GroundSide, SurfaceShape,
};
use polhode::motion::{GroundContact, Scenario, Trajectory};
use polhode_document::json::vector;
use polhode_document::layout::{columns, labelled};
use polhode_document::number::{count, error, number, vector as triple};
use polhode_document::unit::{DIGITS, angle, length, place};
use serde_json::{Value, json};

/// More changes than these fill the screen: JSON has them all.
const MOST: usize = 12;

/// `it rolls without slipping on a level plane`
pub(crate) fn how(ground: &GroundContact) -> String {
    let contact = &ground.contact;
    let law = match contact.law.grip() {
        Grip::NoSlip => "it rolls without slipping",
        Grip::Friction(friction) if *friction == Friction::default() => "it slides without friction",
        _ => "it rolls or slides, with friction,",
    };
    format!("{law} {}", place_of(&contact.ground))
}

/// What touches what, how, what changed about that, and where the body went; `None` of any other motion.
pub(crate) fn facts(scenario: &Scenario, trajectory: &Trajectory) -> Option<Vec<(&'static str, String)>> {
    let (ground, contact) = (scenario.ground()?, trajectory.channel(CONTACT)?);
    let mut facts = given(ground);
    facts.push(("at the start", contact.start().phase.name().to_owned()));
    let change =
        |event: &ContactEvent| ("change", format!("t = {} s: {}", number(event.time, DIGITS), event.change));
    let changes = trajectory.changes();
    facts.extend(changes.iter().take(MOST).map(change));
    if changes.len() > MOST {
        facts.push(("changes", format!("{} in all: summary.json has them", count(changes.len() as u64))));
    }
    Some(facts)
}

/// The surface, the ground and the law.
fn given(ground: &GroundContact) -> Vec<(&'static str, String)> {
    let contact = &ground.contact;
    let gravity = triple(contact.gravity.to_array(), 6);
    vec![
        ("surface", surface(&contact.surface)),
        ("ground", form(&contact.ground)),
        ("law", format!("{}; g = {gravity} m/s²", law(ground))),
    ]
}

/// The same on the screen, with the balance of energy, where the centre of mass went, and what became of the energy.
pub(crate) fn to_text(scenario: &Scenario, trajectory: &Trajectory) -> String {
    let (Some(ground), Some(contact)) = (scenario.ground(), trajectory.channel(CONTACT)) else {
        return String::new();
    };
    let mut text: String = given(ground).iter().map(|(label, fact)| labelled(label, fact)).collect();
    text.push_str(&changes(&contact.start(), trajectory.changes()));
    let drift = error(trajectory.energy_drift());
    let line = format!("T + U less the work of friction and of the ground {drift} (relative, worst sample)");
    text + &labelled("drift", &line)
}

/// The phase at the start, and what changed about the contact.
fn changes(start: &ContactState, all: &[ContactEvent]) -> String {
    let phase = start.phase.name();
    if all.is_empty() {
        return labelled("contact", &format!("{phase} throughout"));
    }
    let head = format!("{phase} at the start; changes ({})", count(all.len() as u64));
    let row =
        |event: &ContactEvent| vec![format!("t = {} s", number(event.time, 12)), event.change.to_string()];
    let rows: Vec<Vec<String>> = all.iter().take(MOST).map(row).collect();
    let mut text = labelled("contact", &head);
    text.extend(columns(&rows).into_iter().map(|line| format!("  {line}\n")));
    if all.len() > MOST {
        text.push_str("  …: summary.json has all\n");
    }
    text
}

/// Path of the centre of mass, forces and energy at both ends; `None` of any other motion.
pub(crate) fn ends(trajectory: &Trajectory) -> Option<String> {
    let contact = trajectory.channel(CONTACT)?;
    let (first, last) = (contact.first()?, contact.last()?);
    let [from, to] = [first, last].map(|s| triple(s.center.to_array(), 6));
    let pair = |of: fn(&ContactState) -> f64| format!("{} → {}", number(of(&first), 6), number(of(&last), 6));
    let mut energy = format!("T {} J, U {} J", pair(|s| s.kinetic_energy), pair(|s| s.potential_energy));
    for (work, of) in [(last.friction_work, "friction"), (last.ground_work, "the moving ground")] {
        if work != 0.0 {
            energy.push_str(&format!(", work of {of} {} J", number(work, 6)));
        }
    }
    let slip = format!("N {} N, slip {} m/s", pair(|s| s.normal_force), pair(|s| s.slip.norm()));
    Some(
        labelled("centre of mass", &format!("{from} → {to} m"))
            + &labelled("contact", &slip)
            + &labelled("energy", &energy),
    )
}

/// `ellipsoid, semi-axes (200, 30, 20) mm, centred at (0, 0, 10) mm`
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

/// `on a level plane`
fn place_of(ground: &Ground) -> String {
    let in_or_on = match ground.shape() {
        GroundShape::Sphere { side: GroundSide::Inside, .. }
        | GroundShape::Cylinder { side: GroundSide::Inside, .. } => "in",
        _ => "on",
    };
    format!("{in_or_on} {}", form(ground))
}

/// `a level plane that turns at 3 rad/s`
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

/// What touches what, what changed about it, energies, the state of the contact at both ends.
pub(crate) fn to_json(scenario: &Scenario, trajectory: &Trajectory) -> Value {
    let (Some(ground), Some(states)) = (scenario.ground(), trajectory.channel(CONTACT)) else {
        return Value::Null;
    };
    let contact = &ground.contact;
    let change = |event: &ContactEvent| json!({ "time_s": event.time, "change": event.change.name(), "what": event.change.to_string() });
    json!({
        "surface": surface_json(&contact.surface),
        "ground": ground_json(&contact.ground),
        "law": law_json(ground),
        "gravity_m_s2": vector(contact.gravity),
        "changes": trajectory.changes().iter().map(change).collect::<Value>(),
        "energy_drift": trajectory.energy_drift(),
        "start": state(&states.start()),
        "final": states.last().as_ref().map_or(Value::Null, state),
    })
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

fn state(s: &ContactState) -> Value {
    json!({
        "time_s": s.state.time,
        "phase": s.phase.name(),
        "center_m": vector(s.center),
        "velocity_m_s": vector(s.velocity),
        "contact_m": vector(s.contact),
        "contact_body_m": vector(s.contact_in_body),
        "normal_force_n": s.normal_force,
        "slip_m_s": vector(s.slip),
        "friction_n": vector(s.friction),
        "kinetic_energy_j": s.kinetic_energy,
        "potential_energy_j": s.potential_energy,
        "friction_work_j": s.friction_work,
        "ground_work_j": s.ground_work,
    })
}
