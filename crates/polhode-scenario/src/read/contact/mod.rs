//! `[contact]`: the body's surface, the ground, and the contact law.

mod ground;
mod law;
mod refusal;
mod surface;

use polhode::math::{Acceleration, Space, Velocity};
use polhode::motion::contact::{Contact, Grip, GroundShape, StartVelocity, SurfaceShape};
use polhode::motion::{GroundContact, Method, Scenario};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

/// Body on the ground, with the tables that define it.
pub(crate) struct OnGround<'a> {
    ground: GroundContact,
    root: Table<'a>,
    table: Table<'a>,
    value: Value<'a>,
}

/// Reads `[contact]`, if present; `velocity` is the initial velocity.
pub(crate) fn contact<'a>(
    root: &Table<'a>,
    velocity: Option<Velocity<Space>>,
) -> Result<Option<OnGround<'a>>, FormatError> {
    const KEYS: [&str; 11] = [
        "surface",
        "ground",
        "law",
        "friction",
        "static_friction",
        "viscous",
        "rolling_friction",
        "pivoting_friction",
        "gravity",
        "at",
        "rolls",
    ];
    let Some(value) = root.get("contact") else { return Ok(None) };
    let table = value.table()?;
    table.allow(&KEYS)?;
    let surface = surface::surface(&table.require("surface", surface::EXAMPLE)?)?;
    let of_ground = table.get("ground");
    let ground = ground::ground(of_ground.as_ref())?;
    if let (SurfaceShape::Cylinder { .. }, GroundShape::Sphere { .. }, Some(value)) =
        (surface.shape(), ground.shape(), &of_ground)
    {
        let hint = "a cylinder touches the ground along a line: it needs a plane or a cylinder as its ground";
        return Err(value
            .invalid("a plane or a cylinder under a surface of shape \"cylinder\"")
            .with_hint(hint));
    }
    let law = law::law(&table)?;
    let gravity = match table.get("gravity") {
        Some(gravity) => Acceleration::from_array(gravity.quantities(Dimension::ACCELERATION)?),
        None => Acceleration::new(0.0, 0.0, -9.806_65),
    };
    let at = ground::touched(&table, &ground, gravity)?;
    let velocity = start_velocity(root, &table, *law.grip() == Grip::NoSlip, velocity)?;
    let contact = Contact { surface, ground, law, gravity };
    Ok(Some(OnGround { ground: GroundContact { contact, at, velocity }, root: root.clone(), table, value }))
}

/// Returns the initial velocity of the centre of mass: from `[start] velocity`, or such that the
/// body rolls.
fn start_velocity(
    root: &Table<'_>,
    table: &Table<'_>,
    never_slips: bool,
    velocity: Option<Velocity<Space>>,
) -> Result<StartVelocity, FormatError> {
    let Some(given) = table.get("rolls") else {
        return match velocity {
            Some(velocity) => Ok(StartVelocity::Along(velocity)),
            None if never_slips => Ok(StartVelocity::Rolling),
            None => {
                let error = table.missing("rolls", "rolls = true");
                Err(error.with_hint("write rolls = true for a rolling start, or give the velocity of the centre of mass under [start]"))
            }
        };
    };
    if never_slips {
        return Err(given.invalid("left out with law = \"rolling\"").with_hint("it always rolls"));
    }
    match (given.boolean()?, velocity) {
        (true, None) => Ok(StartVelocity::Rolling),
        (true, Some(_)) => {
            let start = root.get("start").map(|start| start.table()).transpose()?;
            let velocity = start.and_then(|start| start.get("velocity")).unwrap_or(given);
            let hint = "the velocity of a rolling body follows from its spin: leave out velocity or rolls";
            Err(velocity.invalid("left out with rolls = true").with_hint(hint))
        }
        (false, Some(velocity)) => Ok(StartVelocity::Along(velocity)),
        (false, None) => Err(given.invalid("true, unless [start] has a velocity").with_hint(
            "under [start] write velocity = [\"0.2 m/s\", 0, 0], the velocity of the centre of mass",
        )),
    }
}

impl OnGround<'_> {
    /// Returns the scenario on the ground; `pivot` is the value of a pivot, if there is one.
    pub(crate) fn under(
        &self,
        scenario: Scenario,
        pivot: Option<Value<'_>>,
    ) -> Result<Scenario, FormatError> {
        if let Some(pivot) = pivot {
            let hint = "a body on the ground has no pivot: leave out the pivot or [contact]";
            return Err(pivot.invalid("left out with [contact]").with_hint(hint));
        }
        let method = scenario.run().map_or(Method::Auto, |run| run.method);
        if !matches!(method, Method::Auto | Method::Taylor) {
            let run = self.root.get("run").map(|run| run.table()).transpose()?;
            let value = run.and_then(|run| run.get("method")).unwrap_or(self.value);
            let rule = "\"auto\" or \"taylor\": each phase of a body on the ground has its own, collocation or Taylor series";
            return Err(value.invalid(rule));
        }
        let events = scenario.events().to_vec();
        scenario.on_ground(self.ground).map_err(|error| self.refused(error, &events))
    }
}

/// Reads a quantity that is not negative.
fn not_negative(value: &Value<'_>, dimension: Dimension) -> Result<f64, FormatError> {
    let number = value.quantity(dimension)?;
    if number >= 0.0 { Ok(number) } else { Err(value.invalid("not negative")) }
}

/// Returns the keys of all shapes, each once.
fn all_keys(common: &[&'static str], shapes: &[(&str, &[&'static str])]) -> Vec<&'static str> {
    let own = shapes.iter().flat_map(|(_, keys)| keys.iter().copied());
    let mut all: Vec<_> = common.iter().copied().chain(own).collect();
    all.sort_unstable();
    all.dedup();
    all
}
