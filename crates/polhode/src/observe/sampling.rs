//! Selection of the times at which a path is sampled, so that its chords stay close to it.

use crate::motion::model::state::State;
use crate::motion::solve::free::{FreeMotion, Regime};

use super::curve::CurveError;

/// Time interval over which a path is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) start: f64,
    pub(super) end: f64,
    /// True if ω returns to its initial value in the body at the end.
    pub(super) closed: bool,
    /// Number of equal initial parts; no chord is longer, even if the tolerance would allow it.
    parts: f64,
}

/// States connected by chords, and the largest distance of each of N paths from its chords.
#[derive(Clone, Debug)]
pub(super) struct Sampling<const N: usize> {
    pub(super) states: Vec<State>,
    pub(super) errors: [f64; N],
}

/// Minimum number of chords per period.
const ROUND: f64 = 64.0;

/// Maximum number of points of a curve; a circle at the finest tolerance has a quarter of them.
const MOST_POINTS: usize = 1_000_000;

const FINEST: f64 = 1e-10;
const COARSEST: f64 = 0.1;

impl Span {
    /// Returns the span of `periods` periods from the start of a motion, or the whole separatrix up
    /// to the tolerance, because its full time is infinite.
    ///
    /// `None` for a motion whose ω is constant in the body. `winding` is the largest rate in
    /// addition to λ at which the path turns, rad/s.
    pub(super) fn of(
        motion: &FreeMotion,
        periods: f64,
        winding: f64,
        tolerance: f64,
    ) -> Result<Option<Self>, CurveError> {
        if !(FINEST..=COARSEST).contains(&tolerance) {
            let (what, rule) = ("the relative tolerance of a curve", "between 1e-10 and 0.1");
            return Err(CurveError::Parameter { what, value: tolerance, rule });
        }
        if !(periods > 0.0 && periods.is_finite()) {
            let (what, rule) = ("the number of periods", "positive and finite");
            return Err(CurveError::Parameter { what, value: periods, rule });
        }
        if matches!(motion.regime(), Regime::Permanent(_) | Regime::AtRest) {
            return Ok(None);
        }
        let rate = motion.polhode_rate();
        let Some(period) = motion.period() else {
            return Ok(Some(Self::separatrix(middle_of_separatrix(motion, rate), rate, winding, tolerance)));
        };
        let start = motion.start().time;
        let end = start + periods * period;
        // A path that turns by at most one radian between two times hides nothing from the probes.
        let parts = (ROUND * periods).max((rate + winding) * (end - start)).ceil();
        Ok(Some(Self { start, end, closed: periods.fract() == 0.0, parts }))
    }

    /// Returns the span of ω = (a1 sech, a2 tanh, a3 sech)(λ(t − middle)) in which sech, the
    /// component perpendicular to the intermediate axis, exceeds the tolerance.
    pub(super) fn separatrix(middle: f64, rate: f64, winding: f64, tolerance: f64) -> Self {
        let half = libm::acosh(1.0 / (SAFETY * tolerance)) / rate;
        let parts = (0.5 * ROUND).max(2.0 * (rate + winding) * half).ceil();
        Self { start: middle - half, end: middle + half, closed: false, parts }
    }

    /// Returns states so close in time that each of N paths, scaled by its largest magnitude, is
    /// within its allowed distance of its chords.
    ///
    /// Every part is divided until seven places between its ends are close enough to the chord; an
    /// inflection is therefore detected.
    pub(super) fn sample<const N: usize>(
        &self,
        at: impl Fn(f64) -> State,
        paths: impl Fn(&State) -> [[f64; 3]; N],
        allowed: [f64; N],
    ) -> Result<Sampling<N>, CurveError> {
        let too_many = |time| Err(CurveError::TooManyPoints { time, most: MOST_POINTS });
        if !(self.parts < MOST_POINTS as f64) {
            return too_many(self.start);
        }
        let mut left = at(self.start);
        let mut sampling = Sampling { states: vec![left], errors: [0.0; N] };
        for k in 1..=self.parts as usize {
            let mut pending = vec![self.end_of_part(k as f64, &at)];
            while let Some(&right) = pending.last() {
                if !(left.time < right.time) {
                    let step = (self.end - self.start) / self.parts;
                    return Err(CurveError::StepTooSmall { time: left.time, step });
                }
                let distances = distances_from_chord(&at, &paths, &left, &right);
                let pieces = pieces(distances, allowed);
                if pieces == 1 {
                    sampling.accept(right, distances);
                    left = right;
                    pending.pop();
                } else if sampling.states.len() + pending.len() + usize::from(pieces) > MOST_POINTS {
                    return too_many(left.time);
                }
                for piece in (1..pieces).rev() {
                    pending.push(at(between(&left, &right, f64::from(piece) / f64::from(pieces))));
                }
            }
        }
        Ok(sampling)
    }

    fn end_of_part(&self, k: f64, at: &impl Fn(f64) -> State) -> State {
        if k < self.parts {
            return at(self.start + (self.end - self.start) * (k / self.parts));
        }
        let end = at(self.end);
        if self.closed { State { omega: at(self.start).omega, ..end } } else { end }
    }
}

impl<const N: usize> Sampling<N> {
    fn accept(&mut self, state: State, distances: [f64; N]) {
        self.states.push(state);
        for (error, distance) in self.errors.iter_mut().zip(distances) {
            *error = error.max(distance);
        }
    }
}

/// Returns λ = a3 √((i3 − i1)(i3 − i2) / i1 i2), 1/s.
pub(super) fn separatrix_rate([i1, i2, i3]: [f64; 3], a3: f64) -> f64 {
    a3 * ((i3 - i1) / i1 * ((i3 - i2) / i2)).sqrt()
}

/// Returns the largest |ω| of a motion, rad/s, which occurs where ω has no component along the
/// intermediate axis.
///
/// |ω|² there exceeds that a quarter period later by a1² (i3 − i1)(i2 − i1) / (i2 i3), which is
/// positive in both modes.
pub(super) fn largest_rate(motion: &FreeMotion) -> f64 {
    let [a1, _, a3] = motion.amplitudes();
    libm::hypot(a1, a3)
}

/// Returns the allowed distance of a path from its chords, relative to its largest magnitude.
/// `rounding` is |ω| in the same units; the points are rounded like ω.
pub(super) fn allowed(tolerance: f64, rounding: f64) -> f64 {
    (SAFETY * tolerance).max(32.0 * f64::EPSILON * rounding)
}

/// Safety factor for the path between the probes.
const SAFETY: f64 = 0.95;

/// Returns the time at which the separatrix crosses the plane of the axes of smallest and largest
/// moment, s.
fn middle_of_separatrix(motion: &FreeMotion, rate: f64) -> f64 {
    let start = motion.start();
    let [least, intermediate, greatest] = motion.principal().axes().map(|axis| axis.dot(start.omega));
    // sinh u = tanh u / sech u.
    let [_, a2, _] = motion.amplitudes();
    let sech = libm::hypot(least, greatest) / largest_rate(motion);
    // i2 ω̇2 = (i3 − i1) ω3 ω1.
    let grows = (least > 0.0) == (greatest > 0.0);
    let phase = libm::asinh(intermediate / a2 / sech) / rate;
    if grows { start.time - phase } else { start.time + phase }
}

/// Returns the largest distance of each path from the straight line between its ends, at seven
/// times between them.
fn distances_from_chord<const N: usize>(
    at: &impl Fn(f64) -> State,
    paths: &impl Fn(&State) -> [[f64; 3]; N],
    left: &State,
    right: &State,
) -> [f64; N] {
    let (from, to) = (paths(left), paths(right));
    let mut largest = [0.0; N];
    for probe in 1..=PROBES {
        let time = between(left, right, f64::from(probe) / f64::from(PROBES + 1));
        let points = paths(&at(time));
        for (k, point) in points.iter().enumerate() {
            largest[k] = f64::max(largest[k], distance(*point, from[k], to[k]));
        }
    }
    largest
}

const PROBES: u8 = 7;

fn between(left: &State, right: &State, part: f64) -> f64 {
    left.time + part * (right.time - left.time)
}

/// Returns the number of pieces into which a chord is divided; the distance is proportional to the
/// square of the length.
fn pieces<const N: usize>(distances: [f64; N], allowed: [f64; N]) -> u16 {
    let excess = (0..N).fold(0.0, |most: f64, path| most.max(distances[path] / allowed[path]));
    if excess <= 1.0 { 1 } else { excess.sqrt().ceil().clamp(2.0, MOST_PIECES) as u16 }
}

/// Limit of a single division; longer pieces are divided again.
const MOST_PIECES: f64 = 1024.0;

/// Returns the distance from a point to the segment from a to b.
fn distance(point: [f64; 3], a: [f64; 3], b: [f64; 3]) -> f64 {
    let minus = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let (chord, reach) = (minus(b, a), minus(point, a));
    let squared = dot(chord, chord);
    let part = if squared == 0.0 { 0.0 } else { (dot(reach, chord) / squared).clamp(0.0, 1.0) };
    let away = minus(reach, chord.map(|c| part * c));
    dot(away, away).sqrt()
}
