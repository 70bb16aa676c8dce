//! Answer to the question how the body moves: one to three lines, above the text and as the caption
//! of the page.

use polhode::motion::channel::{CONTACT, GIMBALS};
use polhode::motion::contact::ContactState;
use polhode::motion::torque::TorqueModel;
use polhode::motion::{GroundContact, HeavyTop, Mechanism, Motor, Regime, Sample, Scenario, Swing, TopPath};
use polhode::observe::FreeRegime;
use polhode_document::fact::LARGEST_ATTITUDE_ERROR;
use polhode_document::layout::printable;
use polhode_document::number::{NO_BREAK, has_digits, number, tidy_beside, within};
use polhode_document::unit::{amplitude, length, time};

use crate::report::facts::{
    Angles, Known, ending_in_words, in_gimbals, is_larger, on_ground, target, time_round,
};
use crate::report::free_facts::FreeFacts;
use crate::report::global_error;
use crate::report::periods::Periods;
use crate::report::torque::{Description, wheel_name};

/// Significant digits of a number in an answer.
pub(crate) const DIGITS: usize = 4;

/// Maximum number of angles in an answer; the facts contain all of them.
const MOST_ANGLES: usize = 2;

/// Returns the kind of the motion with its main numbers, its cause, and its end if it is not the
/// end of the run.
pub(crate) fn lines(known: &Known<'_>) -> Vec<String> {
    let pointing = || known.scenario.map_or_else(Vec::new, |scenario| angles(known, scenario));
    let mut lines = match (&known.heavy_top, known.free(), known.scenario) {
        (Some(top), _, _) => [vec![heavy_top(top)], pointing()].concat(),
        (None, Some(free), _) => {
            let kind = [free_motion(free), "No torque: L is constant in space.".to_owned()];
            [kind.to_vec(), pointing()].concat()
        }
        (None, None, Some(scenario)) => driven(known, scenario),
        (None, None, None) => Vec::new(),
    };
    let ending = known.scenario.and_then(|scenario| ending_in_words(known.trajectory, scenario));
    lines.extend(ending.map(|ending| format!("{}.", capitalised(&ending))));
    lines
}

fn heavy_top(top: &HeavyTop) -> String {
    let path = capitalised(top.path().description());
    let [highest, lowest] = top.nutation_bounds().map(degrees);
    let round = time_round(top).map(|period| format!(", and it precesses once in {}", time(period, DIGITS)));
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
            format!("{path}. The axis nutates between θ₁ = {highest} and θ₂ = {lowest} in {period}{round}.")
        }
    }
}

/// Describes the flips of a body that starts near its intermediate axis, or else the kind of motion
/// with its periods.
pub(crate) fn free_motion(free: &FreeFacts) -> String {
    let FreeRegime { regime, period, flip_interval, growth_rate } = free.regime;
    let kind = capitalised(regime.description());
    let Periods { precession, rotation } = free.periods;
    let shown = |seconds: f64| time(seconds, DIGITS);
    let in_body = period.map_or_else(String::new, |t| format!("; period of ω in the body {}", shown(t)));
    match (regime, precession, rotation) {
        (Regime::LongAxis | Regime::ShortAxis, Some(precession), Some(rotation)) => {
            if let (Some(flip), Some(_)) = (flip_interval, growth_rate) {
                let (flip, off) = (shown(flip), free.degrees_off());
                return format!(
                    "Flips every {flip}: ω starts {off}° from the unstable intermediate axis{in_body}."
                );
            }
            let (mode, axis) = if free.motion.circles_least() { ("Long", 1) } else { ("Short", 3) };
            let [precession, rotation] = [precession, rotation].map(shown);
            format!(
                "{mode}-axis mode: axis {axis} precesses about L once in {precession} on average, and the body turns \
                 about it once in {rotation}."
            )
        }
        (Regime::Permanent(_), _, Some(rotation)) => format!("{kind}, one turn in {}.", shown(rotation)),
        (Regime::Separatrix, ..) => format!("{kind}; the motion has no period."),
        (_, Some(precession), _) => format!("{kind} once in {}{in_body}.", shown(precession)),
        _ => format!("{kind}."),
    }
}

/// Returns the torque at the start, N·m, and the largest of a run with its time, s, in a sentence.
/// Rounding of `scale`, N·m, is 0.
pub(crate) fn torque_needed(at_start: f64, largest: Option<[f64; 2]>, scale: f64) -> String {
    let exact = |x: f64| tidy_beside([x, 0.0, 0.0], 10.0 * scale)[0];
    let start = exact(at_start);
    let larger = largest.map(|[n, t]| [exact(n), t]).filter(|[most, _]| is_larger(*most, start));
    let shown = number(start, DIGITS);
    match larger.map(|numbers| numbers.map(|x| number(x, DIGITS))) {
        Some([most, when]) => {
            format!(
                "The motion needs a torque of at most {most} N·m (t = {when} s), {shown} N·m at the start."
            )
        }
        None if start == 0.0 => "The motion needs no torque.".to_owned(),
        None => format!("The motion needs a torque of {shown} N·m at the start."),
    }
}

fn driven(known: &Known<'_>, scenario: &Scenario) -> Vec<String> {
    if let Some(needed) = &known.needed {
        let largest = needed.largest.map(|largest| [largest.torque.norm(), largest.state.time]);
        return vec![
            torque_needed(needed.at_start.torque.norm(), largest, needed.scale()),
            "The motion is prescribed; N is the torque that it needs: dL/dt = N.".to_owned(),
        ];
    }
    if let Some(ground) = scenario.ground() {
        return contact(known, ground);
    }
    if let Mechanism::Gimbals(gimbals) = scenario.mechanism() {
        let states = known.trajectory.channel(GIMBALS).filter(|_| is_end_known(known));
        let turned = states.and_then(|states| Some([states.first()?, states.last()?]));
        let turned = turned.map_or_else(String::new, |ends| {
            let [outer, inner] = [0, 1].map(|k| {
                let [from, to] = ends.map(|s| degrees(s.angles.get(k).copied().unwrap_or_default()));
                format!("from {from} to {to}")
            });
            format!(": the outer axis turns {outer}, the inner one {inner}")
        });
        return vec![
            format!("{}{turned}.", capitalised(&in_gimbals(gimbals))),
            "N: torque about the crossing of the axes, of gimbals and weight.".to_owned(),
        ];
    }
    let mut lines: Vec<String> = known.hanging.as_ref().map(|(_, swing)| swings(swing)).into_iter().collect();
    lines.extend(angles(known, scenario));
    if let (true, Some([first, last])) = (lines.is_empty(), known.ends()) {
        lines.extend(change(known, first, last));
    }
    lines.push(cause(scenario));
    lines
}

fn swings(swing: &Swing) -> String {
    match *swing {
        Swing::Rest => "Hangs at rest.".to_owned(),
        Swing::Oscillation { amplitude: most, period } => {
            format!("Swings between ±{} in {}.", amplitude(most), time(period, DIGITS))
        }
        Swing::Separatrix => "Comes to rest upside down, after infinite time.".to_owned(),
        Swing::Revolution { period } => format!("Goes over the top, one turn in {}.", time(period, DIGITS)),
    }
}

/// Describes the largest of each requested angle. The result is empty if the attitude at the end
/// has no correct digit.
fn angles(known: &Known<'_>, scenario: &Scenario) -> Vec<String> {
    if !is_end_known(known) {
        return Vec::new();
    }
    let samples = known.trajectory.samples();
    let largest = scenario.pointings().iter().filter_map(|pointing| {
        let angles = Angles::of(pointing, samples)?;
        let (name, most) = (printable(pointing.name()), degrees(angles.largest));
        let when = time(angles.time, DIGITS);
        let within = pointing.limit().zip(angles.within).map_or_else(String::new, |(limit, share)| {
            format!(
                "; within {} for {}{NO_BREAK}% of the time",
                degrees(limit),
                number(100.0 * share, DIGITS)
            )
        });
        let target = target(pointing);
        Some(format!("{}: at most {most} to {target}, at t = {when}{within}.", capitalised(&name)))
    });
    largest.take(MOST_ANGLES).collect()
}

/// Returns true if the attitude at the end has a correct digit.
fn is_end_known(known: &Known<'_>) -> bool {
    has_digits(LARGEST_ATTITUDE_ERROR, global_error::of_attitude(known.trajectory))
}

/// Describes |ω| at both ends; `None` if the digits at the end are not known.
fn change(known: &Known<'_>, first: &Sample, last: &Sample) -> Option<String> {
    let ([from, to], error) =
        ([first, last].map(|s| s.state.omega.norm()), global_error::of_omega(known.trajectory));
    let duration = time(last.state.time - first.state.time, DIGITS);
    let [from_text, to_text] = [number(from, DIGITS), within(to, error, DIGITS)];
    let is_known = has_digits(to, error) && last.state.time > first.state.time;
    is_known.then(|| match from_text == to_text {
        true => format!("|ω| is {from_text} rad/s at the start and after {duration}."),
        false => format!("|ω| goes from {from_text} to {to_text} rad/s in {duration}."),
    })
}

fn contact(known: &Known<'_>, ground: &GroundContact) -> Vec<String> {
    let how = capitalised(on_ground(ground).trim_end_matches(','));
    let ends = known.trajectory.channel(CONTACT).and_then(|states| Some([states.first()?, states.last()?]));
    let changes = known.trajectory.changes();
    let phase = known.trajectory.channel(CONTACT).map_or("", |states| states.start().phase.name());
    let first = match changes {
        [] => format!("{phase} throughout"),
        [first, rest @ ..] => {
            let more =
                if rest.is_empty() { String::new() } else { format!("; {} changes in all", changes.len()) };
            format!("{phase} at the start; t = {}: {}{more}", time(first.time, DIGITS), first.change)
        }
    };
    let mut lines = vec![format!("{how}: {first}.")];
    lines.extend(ends.map(|[first, last]| energy_and_height(&first, &last, is_end_known(known))));
    lines
}

/// Describes the energy at both ends, and the rise of the centre of mass if the attitude at the end
/// is known.
fn energy_and_height(first: &ContactState, last: &ContactState, is_known: bool) -> String {
    /// Smallest change of the height that is reported, relative to the height.
    const RISE: f64 = 1e-3;
    let [before, after] = [first, last].map(|s| number(s.kinetic_energy + s.potential_energy, DIGITS));
    let energy = match before == after {
        true => format!("T + U stays at {before} J"),
        false => format!("T + U goes from {before} to {after} J"),
    };
    let [low, high] = [first.center.z, last.center.z];
    let moves = match high - low {
        change if !is_known || change.abs() <= RISE * low.abs() => return format!("{energy}."),
        change if change > 0.0 => "rises",
        _ => "sinks",
    };
    format!("{energy}; the centre of mass {moves} by {}.", length((high - low).abs()))
}

/// Describes the causes of the motion: torques, wheels and changing mass.
fn cause(scenario: &Scenario) -> String {
    // Losses of energy inside the body do not change L.
    let (inner, outer): (Vec<&TorqueModel>, Vec<_>) =
        scenario.torques().iter().partition(|torque| matches!(torque, TorqueModel::EnergySink(_)));
    let torques: Vec<String> = outer.into_iter().map(|torque| Description::of(torque).title).collect();
    let wheels: Vec<String> = (0..scenario.wheels().len()).map(|k| wheel(scenario, k)).collect();
    let outside = if torques.is_empty() && scenario.history().is_some() {
        "No torque from outside".to_owned()
    } else if torques.is_empty() {
        "No torque from outside: L is constant in space".to_owned()
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

/// Describes the drive of a wheel, such as `a motor turns the wheel from 5 s to 25 s`.
fn wheel(scenario: &Scenario, k: usize) -> String {
    let Some(wheel) = scenario.wheels().get(k) else { return String::new() };
    let name = match wheel_name(scenario, k) {
        name if name.starts_with("wheel") => format!("the {name}"),
        name => format!("the wheel “{}”", printable(&name)),
    };
    let when = Description::of_wheel(wheel).when().map_or_else(String::new, |when| format!(" {when}"));
    match wheel.motor() {
        _ if wheel.is_driven() => format!("a motor turns {name}{when}"),
        Motor::HeldSpeed => format!("{name} is held at its speed"),
        _ => format!("{name} turns freely"),
    }
}

fn degrees(rad: f64) -> String {
    format!("{}°", number(rad.to_degrees(), DIGITS))
}

pub(crate) fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
