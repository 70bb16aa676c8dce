//! A line on each picture: what is seen, and why, with its numbers.

use polhode::motion::torque::TorqueModel;
use polhode::motion::{FreeMotion, HeavyTop, Mechanism, Regime, Scenario, Solution, TopPath, Trajectory};
use polhode_document::layout::printable;
use polhode_document::number::{number, typeset};
use polhode_document::unit::time;
use serde_json::{Value, json};

use super::cones::{ConeAngles, Precession, is_moving};
use super::top::time_round;
use crate::report::contact;
use crate::report::free_facts::FreeFacts;
use crate::report::gimbals;
use crate::report::torque::{Description, wheel_name};

/// Digits of a number in a caption.
const DIGITS: usize = 4;

/// The captions of the pictures; those of the last three are of free motions.
#[derive(Clone, Debug)]
pub(crate) struct Captions {
    body: String,
    free: Option<[String; 3]>,
}

impl Captions {
    pub(crate) fn of(
        scenario: Option<&Scenario>,
        trajectory: &Trajectory,
        top: Option<&HeavyTop>,
        free: Option<&FreeFacts>,
    ) -> Self {
        let body = match (top, free, scenario) {
            (Some(top), _, _) => heavy_top(top),
            (None, Some(free), _) => body(free),
            (None, None, Some(scenario)) => driven(scenario, trajectory),
            (None, None, None) => String::new(),
        };
        Self { body, free: free.map(|free| [poinsot(&free.motion), cones(free), sphere(free)]) }
    }

    pub(crate) fn json(&self) -> Value {
        let free = |k: usize| self.free.as_ref().and_then(|all| all.get(k)).map(|text| typeset(text));
        json!({ "body": typeset(&self.body), "poinsot": free(0), "cones": free(1), "sphere": free(2) })
    }
}

fn heavy_top(top: &HeavyTop) -> String {
    let path = capitalised(top.path().description());
    let [highest, lowest] = top.nutation_bounds().map(degrees);
    let round = time_round(top).map(|period| format!(" and precesses once in {}", time(period, DIGITS)));
    let round = round.unwrap_or_default();
    match (top.path(), top.nutation_period()) {
        (TopPath::Sleeping { .. } | TopPath::Hanging, _) | (_, None) => format!("{path}."),
        (TopPath::SteadySlow | TopPath::SteadyFast | TopPath::Conical, _) => {
            format!("{path}: the axis stays at θ = {highest} from the vertical{round}.")
        }
        (TopPath::Planar, Some(period)) => {
            format!("{path}: θ from {highest} to {lowest} and back in {}.", time(period, DIGITS))
        }
        (_, Some(period)) => {
            let period = time(period, DIGITS);
            format!(
                "{path}. The axis nods between θ₁ = {highest} and θ₂ = {lowest} (circles) in {period}{round}."
            )
        }
    }
}

fn body(free: &FreeFacts) -> String {
    let kind = capitalised(free.motion.regime().description());
    let times = match (free.regime.flip_interval, free.periods.precession, free.regime.period) {
        (Some(flip), _, Some(period)) => {
            let [flip, period] = [flip, period].map(|t| time(t, DIGITS));
            format!(", ω repeats in the body every {period}; along axis 2 it reverses every {flip}")
        }
        (_, Some(precession), Some(period)) => {
            let [precession, period] = [precession, period].map(|t| time(t, DIGITS));
            format!(", in space once in {precession}, in the body once in {period}")
        }
        _ => String::new(),
    };
    format!("{kind}{times}. No torque: L is fixed in space.")
}

fn driven(scenario: &Scenario, trajectory: &Trajectory) -> String {
    if matches!(trajectory.solution(), Solution::Prescribed(_)) {
        return "The motion is prescribed; N is the torque that it needs: dL/dt = N.".to_owned();
    }
    if let Some(ground) = scenario.ground() {
        return format!(
            "{}. N: torque of the forces at the point of contact.",
            capitalised(&contact::how(ground))
        );
    }
    if let Mechanism::Gimbals(gimbals) = scenario.mechanism() {
        return format!(
            "{}. N: torque about the crossing of the axes, of gimbals and weight.",
            capitalised(&gimbals::how(gimbals))
        );
    }
    // What takes energy inside the body leaves L as it is.
    let (inner, outer): (Vec<&TorqueModel>, Vec<_>) =
        scenario.torques().iter().partition(|torque| matches!(torque, TorqueModel::EnergySink(_)));
    let torques: Vec<String> = outer.into_iter().map(|torque| Description::of(torque).title).collect();
    let wheels: Vec<String> = scenario.wheels().iter().enumerate().map(|(k, _)| wheel(scenario, k)).collect();
    let outside = if torques.is_empty() && scenario.history().is_some() {
        "No torque from outside".to_owned()
    } else if torques.is_empty() {
        "No torque from outside: L is fixed in space".to_owned()
    } else {
        let law = if scenario.history().is_some() { "" } else { "; dL/dt = N" };
        format!("Torque N: {}{law}", printable(&torques.join(" + ")))
    };
    let lost = if inner.is_empty() { "" } else { ". Friction inside the body takes kinetic energy" };
    if scenario.history().is_some() {
        return format!(
            "{outside}. The mass of the body changes: what leaves takes angular momentum with it."
        );
    }
    let inside =
        if wheels.is_empty() { String::new() } else { format!(". L = Iω + h; {}", wheels.join("; ")) };
    format!("{outside}{lost}{inside}.")
}

/// `the motor turns the wheel from 5 s to 25 s`
fn wheel(scenario: &Scenario, k: usize) -> String {
    let Some(wheel) = scenario.wheels().get(k) else { return String::new() };
    let name = match wheel_name(scenario, k) {
        name if name.starts_with("wheel") => format!("the {name}"),
        name => format!("the wheel “{}”", printable(&name)),
    };
    let when = Description::of_wheel(wheel).when().map_or_else(String::new, |when| format!(" {when}"));
    match wheel.motor() {
        _ if wheel.is_driven() => format!("a motor turns {name}{when}"),
        polhode::motion::Motor::HeldSpeed => format!("{name} is held at its speed"),
        _ => format!("{name} turns freely"),
    }
}

fn poinsot(motion: &FreeMotion) -> String {
    let height = number(2.0 * motion.kinetic_energy() / motion.momentum().norm(), DIGITS);
    match (is_rod(motion), is_moving(motion)) {
        (false, true) => format!(
            "The inertia ellipsoid rolls without slipping on the invariable plane, 2T/|L| = {height} rad/s from its centre; the \
             point of contact, the tip of ω, traces the polhode and the herpolhode."
        ),
        (false, false) => format!(
            "The inertia ellipsoid touches the invariable plane, 2T/|L| = {height} rad/s from its centre, at one point: ω stays \
             along L."
        ),
        (true, is_moving) => {
            let tip = if is_moving {
                ". The point of this line that is at rest, the tip of ω, traces the polhode and the herpolhode"
            } else {
                ": ω stays along L"
            };
            format!(
                "The inertia ellipsoid of a rod is a cylinder: it touches the invariable plane, 2T/|L| = {height} rad/s from its \
                 centre, along a line{tip}."
            )
        }
    }
}

fn cones(free: &FreeFacts) -> String {
    if !is_moving(&free.motion) {
        return "A permanent rotation: ω stays along L, and either cone is a line.".to_owned();
    }
    let ConeAngles { body, space, precession } = ConeAngles::of(free);
    let [half, narrow] = [body, space].map(|[least, _]| degrees(least));
    match precession {
        Some(Precession::Prograde) => format!(
            "The body cone (half-angle {half}) rolls outside on the space cone ({narrow}): prograde precession."
        ),
        Some(Precession::Retrograde) => format!(
            "The body cone (half-angle {half}) rolls around the space cone ({narrow}), which is inside it: retrograde precession."
        ),
        None => {
            let axis = circled(&free.motion);
            let [body, space] =
                [body, space].map(|[least, most]| format!("{} … {}", degrees(least), degrees(most)));
            format!(
                "The body cone (ω to axis {axis}: {body}) rolls on the space cone (ω to L: {space}); the body is asymmetric, so \
                 neither is circular."
            )
        }
    }
}

fn sphere(free: &FreeFacts) -> String {
    let motion = &free.motion;
    match (motion.regime(), free.regime.period) {
        (Regime::Separatrix, _) => {
            "The tip of L in the body runs along a separatrix to axis 2, which it never reaches.".to_owned()
        }
        (_, Some(period)) if is_rod(motion) => {
            let period = time(period, DIGITS);
            format!(
                "The tip of L in the body runs round axis 1 once in {period}, on the great circle across the rod: L has no component along \
                 it."
            )
        }
        (regime, Some(period)) => {
            let separatrices = if regime == Regime::Symmetric {
                "; of a symmetric body all are circles"
            } else {
                "; the separatrices pass through axis 2"
            };
            let axis = circled(motion);
            let period = time(period, DIGITS);
            format!(
                "The tip of L in the body runs round axis {axis} once in {period}, along T = const on the sphere |L| = \
                 const{separatrices}."
            )
        }
        (regime, None) => format!("L keeps its place in the body: {}.", regime.description()),
    }
}

/// A moment of zero: 2T = I (ω₂² + ω₃²), whatever ω₁ is.
fn is_rod(motion: &FreeMotion) -> bool {
    motion.labelled_moments().contains(&0.0)
}

fn circled(motion: &FreeMotion) -> u8 {
    if motion.circles_least() { 1 } else { 3 }
}

fn degrees(rad: f64) -> String {
    format!("{}°", number(rad.to_degrees(), DIGITS))
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
