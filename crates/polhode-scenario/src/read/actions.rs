//! Actions on bodies that are defined elsewhere: a scenario without its body, start and run.

use std::path::{Path, PathBuf};

use polhode::body::{BodyPart, Finding, InertiaTensor, MassProperties};
use polhode::math::{AngularVelocity, Body, Position};
use polhode::motion::{ActingTorque, Event, MotionError, Rotor, Scenario};
use polhode_source::files::{Disk, Files};
use polhode_source::toml::reader::Table;
use polhode_source::toml::source::Source;
use polhode_source::toml::tree::Entries;
use polhode_source::{FormatError, FormatErrorKind};

use super::body::Pivot;
use super::pointing::References;
use super::torque::Torques;
use super::{document, event, orbit, torque, wheel};

/// Torques on a body, wheels in it and events to detect, without the body: `[orbit]`, `[[torque]]`,
/// `[[wheel]]` and `[[event]]`.
///
/// They are read once, for any number of bodies.
///
/// ```
/// use polhode::prelude::*;
/// use polhode_scenario::read::Actions;
/// use polhode_source::files::Memory;
/// let text = r#"
/// [[torque]]
/// model = "gravity"
/// pivot = [0, 0, "-10 cm"]
///
/// [[event]]
/// measure = "nutation"
/// value = "40 deg"
/// "#;
/// let actions = Actions::parse(&Memory::default(), text.to_owned(), "top.toml".as_ref(), false)?;
/// assert_eq!(actions.pivot(), Some(Position::new(0.0, 0.0, -0.1)));
/// assert_eq!((actions.scenario().torques().len(), actions.scenario().events().len()), (1, 1));
/// # Ok::<(), polhode_source::FormatError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Actions {
    path: PathBuf,
    text: String,
    entries: Entries,
    /// Scenario with a placeholder body.
    scenario: Scenario,
    pivot: Option<Position<Body>>,
    has_wheels: bool,
}

impl Actions {
    /// Reads the actions from a text; `path` is used in messages and for the files that they name.
    /// `is_held` is true if the body has a pivot that is given elsewhere, which gravity then need
    /// not repeat.
    ///
    /// # Errors
    /// [`FormatError`] as [`read`](super::read), and for other tables.
    pub fn parse(files: &dyn Files, text: String, path: &Path, is_held: bool) -> Result<Self, FormatError> {
        let source = Source::new(files, path, &text);
        let entries = document(source)?;
        let root = Table::root(source, &entries);
        root.allow(&["orbit", "torque", "wheel", "event"])?;
        let shared = orbit::read(&root)?;
        let orbit = shared.as_ref().map(|shared| &shared.orbit);
        let (torques, pivot) = torques(&root, orbit, is_held)?;
        let references = References { orbit, field: torques.field() };
        let events: Vec<Event> = event::events_of(&root, &torques, &references)?;
        let has_wheels = !wheel::wheels(&root)?.is_empty();
        let whole = |error: MotionError| root.error(FormatErrorKind::Motion(error));
        let named = torques.names.into_iter().enumerate();
        let acting = torques.models.into_iter().zip(named).map(|(model, (k, name))| {
            let is_on = !torques.switched_off.contains(&k);
            ActingTorque { model, name, is_on }
        });
        let mut scenario =
            Scenario::new(stand_in().map_err(|error| root.error(FormatErrorKind::Body(error)))?);
        if let Some(orbit) = orbit {
            scenario = scenario.in_orbit(orbit.clone()).map_err(whole)?;
        }
        scenario =
            scenario.with_torques(acting).and_then(|scenario| scenario.watching(events)).map_err(whole)?;
        let noticed = scenario.check();
        scenario = scenario.noting(noticed).noting(shared.and_then(|shared| shared.underground()));
        let path = path.to_owned();
        Ok(Self { path, entries, scenario, pivot, has_wheels, text })
    }

    /// Returns a scenario of a placeholder body without wheels, with the torques, their
    /// switched-off ones, the events and the orbit.
    pub const fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// Returns the findings on the actions.
    pub fn findings(&self) -> &[Finding] {
        self.scenario.findings()
    }

    /// Returns the pivot given by gravity.
    pub const fn pivot(&self) -> Option<Position<Body>> {
        self.pivot
    }

    /// Returns the body with the wheels in it, for an initial angular velocity.
    ///
    /// # Errors
    /// [`FormatError`] if a wheel does not fit the body.
    pub fn with_wheels(&self, rotor: Rotor, omega: AngularVelocity<Body>) -> Result<Rotor, FormatError> {
        if !self.has_wheels {
            return Ok(rotor);
        }
        let root = Table::root(Source::new(&Disk, &self.path, &self.text), &self.entries);
        let wheels = wheel::turning(&rotor, &wheel::wheels(&root)?, omega)?;
        rotor.with_wheels(&wheels).map_err(|error| root.error(FormatErrorKind::Motion(error)))
    }
}

/// Reads the torques and the pivot that gravity gives, unless a pivot is given elsewhere.
fn torques(
    root: &Table<'_>,
    orbit: Option<&polhode::motion::Orbit>,
    is_held: bool,
) -> Result<(Torques, Option<Position<Body>>), FormatError> {
    let body = stand_in().map_err(|error| root.error(FormatErrorKind::Body(error)))?;
    let part = BodyPart {
        name: String::new(),
        kind: "tensor",
        properties: body,
        extent: None,
        surface_area: None,
        particles: Vec::new(),
        form: None,
    };
    let Some(list) = root.get("torque").filter(|_| is_held) else {
        let mut pivot = None;
        let torques = torque::torques(root, &[part], orbit, None, &mut pivot)?;
        return Ok((torques, pivot.map(|pivot| pivot.point)));
    };
    for table in list.tables("torque")? {
        let model = table.require("model", "model = \"gravity\"")?;
        if let Some(pivot) = table.get("pivot").filter(|_| model.string() == Ok("gravity")) {
            return Err(pivot.invalid("left out, since the pivot is given for the bodies already"));
        }
        if model.string() == Ok("gravity_gradient") {
            let rule = "left out, since the bodies are held at a pivot";
            return Err(model.invalid(rule).with_hint("a body on an orbit is free: leave out the pivot"));
        }
    }
    // The pivot is arbitrary, because gravity acts about whatever point is held.
    let mut pivot = Some(Pivot { point: Position::ZERO, value: list });
    Ok((torque::torques(root, &[part], orbit, None, &mut pivot)?, None))
}

/// Returns a placeholder body.
fn stand_in() -> Result<MassProperties<Body>, polhode::body::BodyError> {
    MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([1.0; 3])?)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use polhode::body::{InertiaTensor, MassProperties};
    use polhode::math::Direction;
    use polhode::motion::{Motor, Wheel};

    use polhode_source::files::Memory;

    use super::*;
    use crate::read as scenario;

    const ACTIONS: &str = r#"
[[torque]]
model = "gravity"
acceleration = [0.3, -0.4, -9.1]

[[torque]]
model = "drag"
name = "brake"
on = false
law = "linear"
coefficient = [0.1, 0.2, 0.3]

[[wheel]]
axis = [0.5, -0.3, 0.9]
inertia = 0.2
speed = 3
motor_torque = 0.35

[[event]]
measure = "omega_body_z"
value = 2
then = { switch = "brake", on = true }
"#;

    /// Actions read without a body equal those of a scenario with that body.
    #[test]
    fn actions_are_those_of_a_scenario() {
        let whole = format!(
            "{ACTIONS}\n[start]\nspin = {{ body = [0.7, -1.1, 0.4] }}\n[run]\nduration = 1\n[body]\npivot = [-0.4, 0.9, 0.2]\n\
             [[body.part]]\nshape = \"tensor\"\nmass = 2.3\ncenter_of_mass = [0.11, -0.07, 0.23]\n\
             inertia = [[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]]\nproducts = \"negative_integral\"\n"
        );
        let whole = scenario::parse(&whole, "whole.toml".as_ref()).unwrap();
        let actions =
            Actions::parse(&Memory::default(), ACTIONS.to_owned(), "actions.toml".as_ref(), true).unwrap();
        let found = actions.scenario();
        assert_eq!((found.torques(), found.events()), (whole.torques(), whole.events()));
        assert_eq!(
            (found.switched_off(), found.torque_names()),
            (whole.switched_off(), whole.torque_names())
        );
        assert_eq!((actions.pivot(), actions.findings()), (None, &[][..]));
        let rotor = Rotor::pivoted(whole.body(), whole.pivot().unwrap());
        let rotor = actions.with_wheels(rotor, whole.start().omega).unwrap();
        assert_eq!(&rotor, whole.rotor());
        let motor = Motor::Torque { inertia: 0.2, torque: 0.35, schedule: None };
        let wheel = Wheel::turning(Direction::new(0.5, -0.3, 0.9), 3.0, motor, whole.start().omega);
        assert_eq!(rotor.wheels(), [wheel.unwrap()]);
    }

    #[test]
    fn what_is_refused() {
        let read = |text: &str, is_held| {
            let error = Actions::parse(&Memory::default(), text.to_owned(), "actions.toml".as_ref(), is_held)
                .unwrap_err();
            error.to_string()
        };
        let gravity = "[[torque]]\nmodel = \"gravity\"\n";
        assert!(read(gravity, false).contains("pivot"));
        assert!(read(&format!("{gravity}pivot = [0, 0, 1]\n"), true).contains("actions.toml:3:9: "));
        let orbit = "[orbit]\naltitude = \"500 km\"\n[[torque]]\nmodel = \"gravity_gradient\"\n";
        assert!(read(orbit, true).contains("the bodies are held at a pivot"));
        assert!(read(&format!("{orbit}mass = \"points\"\n"), false).contains("not every part"));
        assert!(read("[run]\nduration = 1\n", false).contains("run"));
        let actions =
            Actions::parse(&Memory::default(), ACTIONS.to_owned(), "actions.toml".as_ref(), true).unwrap();
        let small = MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([0.1; 3]).unwrap());
        let refused = actions.with_wheels(Rotor::free(&small.unwrap()), AngularVelocity::ZERO).unwrap_err();
        assert!(refused.to_string().starts_with("actions.toml:15:11: "), "{refused}");
    }
}
