//! Torques in reports: one description of each model, the source of text, JSON and page.

use polhode::motion::torque::{
    Attracted, ConstantTorque, Drag, DragLaw, FormulaTorque, Interpolation, MagneticField, Schedule,
    Tabulated, TorqueAxes, TorqueModel,
};
use polhode::motion::{EventAction, Motor, Orbit, Scenario, Wheel};
use polhode_document::json;
use polhode_document::layout::printable;
use polhode_document::number::{DIGITS, number, tidy, tidy_matrix, vector};
use serde_json::{Map, Value, json};

/// A torque or a wheel, prepared for output.
#[derive(Clone, Debug)]
pub(crate) struct Description {
    /// Name of the model in scenario files.
    pub model: &'static str,
    /// Short description.
    pub title: String,
    pub parameters: Vec<Parameter>,
    /// Times at which it acts; `None` if it acts always.
    schedule: Option<Schedule>,
    /// Orbit on which it depends; its parameters have keys that start with [`ORBIT`].
    orbit: Option<Orbit>,
    /// Parameters without a number, as (key, word), such as (`axes`, `body`).
    words: Vec<(&'static str, String)>,
}

/// Numerical parameter of a torque: a number, a vector or a matrix.
#[derive(Clone, Debug)]
pub(crate) struct Parameter {
    /// Key in JSON, with the unit.
    key: &'static str,
    /// Symbol in the text.
    symbol: &'static str,
    value: Shown,
    unit: &'static str,
}

#[derive(Clone, Copy, Debug)]
enum Shown {
    Number(f64),
    Vector([f64; 3]),
    Matrix([[f64; 3]; 3]),
}

/// Start of the keys of an orbit's parameters.
const ORBIT: &str = "orbit_";

impl Description {
    pub(crate) fn of(model: &TorqueModel) -> Self {
        let name = model.name();
        match model {
            TorqueModel::Constant(ConstantTorque::Body(n)) => Self::new(name, "constant in body axes")
                .word("axes", "body")
                .put("torque_n_m", "N", Shown::Vector(n.to_array()), "N·m"),
            TorqueModel::Constant(ConstantTorque::Space(n)) => Self::new(name, "constant in space axes")
                .word("axes", "space")
                .put("torque_n_m", "N", Shown::Vector(n.to_array()), "N·m"),
            TorqueModel::Gravity(g) => Self::new(name, "gravity").word("axes", "space").put(
                "acceleration_m_s2",
                "g",
                Shown::Vector(g.acceleration.to_array()),
                "m/s² in space axes",
            ),
            TorqueModel::Thruster(thruster) => Self::new(name, "a thruster")
                .put("force_n", "F", Shown::Vector(thruster.force.to_array()), "N in body axes")
                .put("position_m", "r", Shown::Vector(thruster.position.to_array()), "m"),
            TorqueModel::EnergySink(sink) => Self::new(name, "energy lost inside the body").put(
                "coefficient_per_n_m_s",
                "α",
                Shown::Number(sink.coefficient()),
                "1/(N·m·s)",
            ),
            TorqueModel::Torsion(torsion) => {
                let title = if torsion.axis().is_some() { "a torsion wire" } else { "a torsion spring" };
                let spring = Self::new(name, title).put(
                    "stiffness_n_m_per_rad",
                    "k",
                    Shown::Number(torsion.stiffness()),
                    "N·m/rad",
                );
                match torsion.axis() {
                    Some(axis) => {
                        spring.put("axis_space", "along", Shown::Vector(axis.to_array()), "in space axes")
                    }
                    None => spring,
                }
            }
            TorqueModel::Drag(drag) => Self::drag(name, drag),
            TorqueModel::Magnetic(magnet) => {
                let magnetic = Self::new(name, "a magnet in a field").put(
                    "moment_a_m2",
                    "m",
                    Shown::Vector(magnet.moment.to_array()),
                    "A·m² in body axes",
                );
                match &magnet.field {
                    MagneticField::Uniform(b) => magnetic.word("field", "uniform").put(
                        "field_t",
                        "B",
                        Shown::Vector(b.to_array()),
                        "T in space axes",
                    ),
                    MagneticField::Dipole { dipole, orbit } => {
                        let dipole = Shown::Vector(dipole.to_array());
                        let magnetic = magnetic.word("field", "dipole");
                        magnetic
                            .put("dipole_a_m2", "of the dipole", dipole, "A·m² in space axes")
                            .orbit(orbit)
                    }
                    _ => magnetic,
                }
            }
            TorqueModel::Scheduled(scheduled) => {
                Self { schedule: Some(scheduled.schedule), ..Self::of(&scheduled.torque) }
            }
            TorqueModel::GravityGradient(gradient) => {
                let (title, mass) = match gradient.attracted {
                    Attracted::Points(_) => ("the gravity gradient, of mass points", "points"),
                    _ => ("the gravity gradient, of the inertia tensor", "tensor"),
                };
                Self::new(name, title).word("mass", mass).orbit(&gradient.orbit)
            }
            TorqueModel::Formula(formula) => {
                let axes = if matches!(**formula, FormulaTorque::Body(_)) { "body" } else { "space" };
                Self::new(name, format!("given by formulas along {axes} axes")).word("axes", axes)
            }
            TorqueModel::Tabulated(table) => Self::tabulated(name, table),
            other => Self::new(name, other.name()),
        }
    }

    fn tabulated(name: &'static str, table: &Tabulated) -> Self {
        let axes = if table.axes() == TorqueAxes::Body { "body" } else { "space" };
        let between = match table.interpolation() {
            Interpolation::Steps => "steps",
            Interpolation::Linear => "linear",
            Interpolation::Spline => "spline",
        };
        let (first, last) = (table.times().first(), table.times().last());
        let title = format!("from a table of {} rows ({between}) along {axes} axes", table.times().len());
        Self::new(name, title)
            .word("axes", axes)
            .word("interpolation", between)
            .put("first_row_s", "from t", Shown::Number(first.copied().unwrap_or_default()), "s")
            .put("last_row_s", "to t", Shown::Number(last.copied().unwrap_or_default()), "s")
            .put("greatest_n_m", "greatest |N|", Shown::Number(table.greatest()), "N·m")
    }

    /// Describes a wheel with its axis, momentum and motor.
    pub(crate) fn of_wheel(wheel: &Wheel) -> Self {
        let (title, schedule, motor) = match wheel.motor() {
            Motor::Torque { inertia, torque, schedule } => {
                ("a wheel that its motor turns", schedule, Some([inertia, torque]))
            }
            _ => ("a wheel of held speed", None, None),
        };
        let description = Self { schedule, ..Self::new("wheel", title) }
            .put("axis_body", "along", Shown::Vector(wheel.axis().to_array()), "in body axes")
            .put("momentum_kg_m2_s", "h", Shown::Number(wheel.momentum()), "kg·m²/s");
        match motor {
            Some([inertia, torque]) => description
                .put("inertia_kg_m2", "J", Shown::Number(inertia), "kg·m²")
                .put("motor_torque_n_m", "N", Shown::Number(torque), "N·m"),
            None => description,
        }
    }

    fn drag(name: &'static str, drag: &Drag) -> Self {
        let matrix = Shown::Matrix(drag.matrix());
        match drag.law() {
            DragLaw::Linear => Self::new(name, "drag, −C ω").put("linear_n_m_s", "C", matrix, "N·m·s"),
            DragLaw::Quadratic => {
                Self::new(name, "drag, −|ω| D ω").put("quadratic_n_m_s2", "D", matrix, "N·m·s²")
            }
        }
    }

    /// Adds the parameters of the orbit of the centre of mass.
    fn orbit(self, orbit: &Orbit) -> Self {
        let closest = Self { orbit: Some(orbit.clone()), ..self }
            .put("orbit_mu_m3_s2", "µ", Shown::Number(orbit.mu()), "m³/s²")
            .put("orbit_periapsis_m", "periapsis", Shown::Number(orbit.periapsis()), "m")
            .put("orbit_eccentricity", "eccentricity", Shown::Number(orbit.eccentricity()), "");
        match orbit.period() {
            Some(period) => closest.put("orbit_period_s", "period", Shown::Number(period), "s"),
            None => closest,
        }
    }

    fn new(model: &'static str, title: impl Into<String>) -> Self {
        let (parameters, words) = (Vec::new(), Vec::new());
        Self { model, title: title.into(), parameters, schedule: None, orbit: None, words }
    }

    fn put(mut self, key: &'static str, symbol: &'static str, value: Shown, unit: &'static str) -> Self {
        self.parameters.push(Parameter { key, symbol, value, unit });
        self
    }

    fn word(mut self, key: &'static str, word: &str) -> Self {
        self.words.push((key, word.to_owned()));
        self
    }

    /// Returns the text, such as
    /// `gravity, g = (0, 0, -9.80665) m/s² in space axes, from 1 s to 3 s`.
    pub(crate) fn text(&self) -> String {
        self.text_beside(None)
    }

    /// Returns the text without the parameters of an orbit that is stated elsewhere.
    pub(crate) fn text_beside(&self, stated: Option<&Orbit>) -> String {
        let is_stated = stated.is_some() && self.orbit.as_ref() == stated;
        let numbers = self
            .parameters
            .iter()
            .filter(|p| !(is_stated && p.key.starts_with(ORBIT)))
            .map(|p| format!("{} = {} {}", p.symbol, p.shown(), p.unit).trim_end().to_owned());
        [self.title.clone()].into_iter().chain(numbers).chain(self.when()).collect::<Vec<_>>().join(", ")
    }

    /// Describes the times at which it acts; `None` if it acts always.
    pub(crate) fn when(&self) -> Option<String> {
        let n = |x: f64| number(x, DIGITS);
        let schedule = self.schedule?;
        if let Some(([first, width, period], count)) = schedule.as_pulses() {
            let count = count.map_or_else(String::new, |count| format!(", {count} times"));
            return Some(format!(
                "for {} s of every {} s from {} s on{count}",
                n(width),
                n(period),
                n(first)
            ));
        }
        let [from, until] = schedule.as_window()?;
        match (from.is_finite(), until.is_finite()) {
            (true, true) => Some(format!("from {} s to {} s", n(from), n(until))),
            (true, false) => Some(format!("from {} s on", n(from))),
            (false, true) => Some(format!("until {} s", n(until))),
            (false, false) => None,
        }
    }

    /// Returns `model`, the words, the numbers and the `schedule`.
    pub(crate) fn json(&self) -> Map<String, Value> {
        let mut object = Map::new();
        object.insert("model".to_owned(), self.model.into());
        for (key, word) in &self.words {
            object.insert((*key).to_owned(), word.as_str().into());
        }
        for parameter in &self.parameters {
            object.insert(parameter.key.to_owned(), parameter.json());
        }
        object.insert("schedule".to_owned(), self.schedule.map_or(Value::Null, schedule));
        object
    }
}

/// Returns the name of a wheel in its scenario, or else its number if there are several wheels.
pub(crate) fn wheel_name(scenario: &Scenario, k: usize) -> String {
    match scenario.wheel_name(k) {
        Some(name) => name.to_owned(),
        None if scenario.wheels().len() > 1 => format!("wheel {}", k + 1),
        None => "wheel".to_owned(),
    }
}

/// Returns the wheels of a scenario with their names.
pub(crate) fn named_wheels(scenario: &Scenario) -> Vec<(String, Wheel)> {
    scenario.wheels().iter().enumerate().map(|(k, wheel)| (wheel_name(scenario, k), *wheel)).collect()
}

/// Describes when a torque that is off at the start is switched on:
/// `off until the event "spun down"`.
pub(crate) fn off_at_start(scenario: &Scenario, torque: usize) -> Option<String> {
    if !scenario.switched_off().contains(&torque) {
        return None;
    }
    let turns_on = EventAction::Switch { torque, on: true };
    let names: Vec<String> = scenario
        .events()
        .iter()
        .filter(|event| event.action() == turns_on)
        .map(|event| format!("\"{}\"", printable(event.name())))
        .collect();
    Some(match names.as_slice() {
        [] => "off throughout".to_owned(),
        [name] => format!("off until the event {name}"),
        names => format!("off until one of the events {}", names.join(", ")),
    })
}

impl Parameter {
    /// Returns the value without its unit.
    fn shown(&self) -> String {
        match self.value {
            Shown::Number(x) => number(x, DIGITS),
            Shown::Vector(v) => vector(tidy(v), 6),
            Shown::Matrix(m) => match tidy_matrix(m) {
                [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]] if x == y && y == z => number(x, DIGITS),
                [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]] => format!("diagonal {}", vector([x, y, z], 6)),
                rows => format!("[{}]", rows.map(|row| vector(row, 6)).join(", ")),
            },
        }
    }

    fn json(&self) -> Value {
        match self.value {
            Shown::Number(x) => x.into(),
            Shown::Vector(v) => json::numbers(&v),
            Shown::Matrix(m) => json::matrix(m),
        }
    }
}

/// Returns `from_s` and `until_s` (`null` if infinite), or `first_s`, `width_s`, `period_s` and
/// `count`.
fn schedule(schedule: Schedule) -> Value {
    if let Some(([first, width, period], count)) = schedule.as_pulses() {
        return json!({ "first_s": first, "width_s": width, "period_s": period, "count": count });
    }
    schedule.as_window().map_or(Value::Null, |[from, until]| json!({ "from_s": from, "until_s": until }))
}
