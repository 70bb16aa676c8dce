//! Geometry of a free motion: the curves of ω and L.

use polhode::math::Vector;
use polhode::motion::{ClosedForm, FreeMotion, Regime, Solution};
use polhode::observe::{CurveError, Herpolhode, MomentumTrace, Polhode};
use serde_json::{Value, json};

use super::cones::ConeAngles;
use super::motion::Shown;
use super::rows::Rows;
use super::{PageInput, PageSubject};
use crate::report::free_facts::FreeFacts;

/// Largest deviation of chords from their curves, relative to the largest vector; invisible.
const CHORD: f64 = 1e-3;

/// Number of other motions shown around each end of an axis.
const SISTERS: usize = 5;

/// Largest number of periods of ω in the herpolhode.
const MOST_PERIODS: f64 = 12.0;

/// Largest number of points of the herpolhode; a longer curve is truncated.
const MOST_POINTS: usize = 4_000;

/// Returns the free motion of a page.
///
/// `None` if a torque acts, wheels spin, the motion is prescribed, or the body is at rest.
pub(crate) fn facts(input: &PageInput<'_>) -> Option<FreeFacts> {
    let motion = match (input.trajectory.solution(), input.subject) {
        (Solution::ClosedForm(ClosedForm::Free(motion)), _) => **motion,
        (solution, PageSubject::Scenario(scenario))
            if solution.statistics().is_some() && scenario.is_free() =>
        {
            FreeMotion::of(scenario.rotor(), input.trajectory.start().state).ok()?
        }
        _ => return None,
    };
    (motion.regime() != Regime::AtRest).then(|| FreeFacts::of(motion))
}

/// Returns the curves; null if one cannot be computed. Other motions are included only if `whole`.
pub(crate) fn json(free: &FreeFacts, shown: &Shown<'_>, whole: bool, rows: &mut Rows) -> Value {
    curves(free, shown, whole, rows).unwrap_or(Value::Null)
}

fn curves(free: &FreeFacts, shown: &Shown<'_>, whole: bool, rows: &mut Rows) -> Result<Value, CurveError> {
    let motion = &free.motion;
    let polhode = Polhode::of(motion, CHORD)?;
    let trace = MomentumTrace::of(motion, CHORD)?;
    let herpolhode = herpolhode(motion, shown)?;
    let Family { sisters, separatrices } = if whole { Family::of(motion)? } else { Family::default() };
    let mut row = |points: &mut dyn Iterator<Item = [f64; 3]>| rows.put(points.flatten());
    Ok(json!({
        "regime": motion.regime().description(),
        "period": motion.period(),
        "momentum": motion.momentum().norm(),
        "energy": motion.kinetic_energy(),
        "polhode": row(&mut polhode.curve.points().iter().map(|p| p.to_array())),
        "herpolhode": row(&mut herpolhode.into_iter()),
        "separatrix": separatrices.into_iter().map(|line| row(&mut line.into_iter())).collect::<Vec<_>>(),
        "family": sisters.into_iter().map(|line| row(&mut line.into_iter())).collect::<Vec<_>>(),
        "cones": ConeAngles::of(free).json(),
        "trace": row(&mut trace.curve.points().iter().map(|l| in_principal_axes(motion, *l))),
    }))
}

/// Returns ω in space over the duration of the page, from one period to [`MOST_PERIODS`].
fn herpolhode(motion: &FreeMotion, shown: &Shown<'_>) -> Result<Vec<[f64; 3]>, CurveError> {
    let time = |sample: Option<&&polhode::motion::Sample>| sample.map_or(0.0, |s| s.state.time);
    let duration = time(shown.samples.last()) - time(shown.samples.first());
    let wanted = motion.period().map_or(1.0, |period| (duration / period).clamp(1.0, MOST_PERIODS));
    // If ω circles L much faster than it moves in the body, even one period has too many points.
    let fits = |periods: f64| Herpolhode::of(motion, periods, CHORD);
    let curve = match fits(wanted) {
        Err(CurveError::TooManyPoints { .. }) => fits(1e-3)?,
        curve => curve?,
    };
    let along = curve.normal * curve.height;
    let point = |p: &polhode::math::AngularVelocity<polhode::math::Space>| {
        let ([x, y, z], [a, b, c]) = (p.to_array(), along.to_array());
        [x + a, y + b, z + c]
    };
    Ok(curve.curve.points().iter().take(MOST_POINTS).map(point).collect())
}

/// Other curves on the momentum sphere; they depend on the principal moments only.
#[derive(Default)]
struct Family {
    sisters: Vec<Vec<[f64; 3]>>,
    separatrices: Vec<Vec<[f64; 3]>>,
}

impl Family {
    fn of(motion: &FreeMotion) -> Result<Self, CurveError> {
        let (mut sisters, mut halves) = (Vec::new(), Vec::new());
        for sister in Polhode::family(motion, SISTERS, CHORD)? {
            let line: Vec<[f64; 3]> =
                sister.curve.points().iter().map(|omega| direction(motion, *omega)).collect();
            if sister.regime == Regime::Separatrix { halves.push(line) } else { sisters.push(line) }
        }
        // The halves have the signs (+, +), (+, −), (−, +), (−, −). The first and last form one
        // circle, the others another.
        let separatrices = match halves.as_slice() {
            [first, second, third, fourth] => vec![circle(first, fourth), circle(second, third)],
            _ => Vec::new(),
        };
        Ok(Self { sisters, separatrices })
    }
}

/// Returns two halves with common ends as one closed line.
fn circle(there: &[[f64; 3]], back: &[[f64; 3]]) -> Vec<[f64; 3]> {
    there.iter().chain(back.iter().rev()).chain(there.first()).copied().collect()
}

/// Returns L/|L| for an angular velocity in the body: (i1 ω1, i2 ω2, i3 ω3) / |…|, principal axes.
fn direction(motion: &FreeMotion, omega: polhode::math::AngularVelocity<polhode::math::Body>) -> [f64; 3] {
    let principal = motion.principal();
    let omega = (principal.rotation().inverse() * omega).to_array();
    let [i1, i2, i3] = principal.moments();
    unit([i1 * omega[0], i2 * omega[1], i3 * omega[2]])
}

fn in_principal_axes<Q>(motion: &FreeMotion, l: Vector<Q, polhode::math::Body>) -> [f64; 3] {
    let to_principal = motion.principal().rotation().inverse();
    unit((to_principal * l).to_array())
}

/// Returns the unit vector; zero remains zero.
fn unit(v: [f64; 3]) -> [f64; 3] {
    let largest = v.iter().fold(0.0, |max, x| f64::max(max, x.abs()));
    if !(largest > 0.0 && largest.is_finite()) {
        return [0.0; 3];
    }
    let v = v.map(|x| x / largest);
    let norm = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / norm)
}
