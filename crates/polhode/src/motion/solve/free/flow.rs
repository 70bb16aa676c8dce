//! One kernel for every free motion: two phases, a few terms of a theta series, a quaternion.

use crate::math::complex::Complex;
use crate::math::elementary::sin_cos_quarters;
use crate::math::number::Splat;
use crate::motion::solve::phase::{Elapsed, Phase, Rate};

/// A place on the polhode, as the theta functions give it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point<T> {
    /// f: the theta function of the attitude.
    pub(super) f: Complex<T>,
    /// cn, sn and dn times constants, times `below`.
    pub(super) theta: [T; 3],
    /// The theta function that they share.
    pub(super) below: T,
}

/// The constants of a motion, in the form that is evaluated: all follow from a [`CompactConstants`](super::compact::CompactConstants).
///
/// With z = π(u0 + λt)/2K, the unit vector along L is e = (A1 cn, A2 sn, A3 dn)/L in the labelled axes, and the quaternion
/// from them to axes along L is w + iz = α, x + iy = β,
///
/// α = e^iφ f(z),  β = α (e2 − i e1)/(1 + e3),  φ = ½(Ωt − z) + b′z
///
/// where f is the series and b′ its bend: zero for the trigonometric one. ω = (A1/i1 cn, A2/i2 sn, A3/i3 dn).
///
/// Source: Klein & Sommerfeld, Über die Theorie des Kreisels, ch. VI; derived in `book/free-motion.md`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Flow<T, S> {
    pub(super) phase_rates: PhaseRates<T>,
    pub(super) curve: LabelledState<T, S>,
    pub(super) to_body: ToBodyMap<T>,
}

/// What makes phases of the time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PhaseRates<T> {
    /// ½(Ωt − z), quarter turns.
    pub(super) precession: Rate<T>,
    /// λ/K: 2z/π, quarter turns.
    pub(super) polhode: Rate<T>,
    /// 2z/π at the start, quarter turns.
    pub(super) start: [T; 2],
    /// The longest time that needs no more than two words of either.
    pub(super) reach: T,
}

/// What makes a quaternion and ω of phases, in the labelled axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LabelledState<T, S> {
    pub(super) series: S,
    /// What makes theta functions the components of e.
    pub(super) direction: [T; 3],
}

/// What turns them into the axes that they are wanted in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ToBodyMap<T> {
    /// From what the quaternion is in the labelled axes to the attitude's, of norm 1/`scale`.
    pub(super) attitude: [[T; 4]; 4],
    /// Columns: the axes times the amplitudes of ω along them, and the constants that make theta functions cn, sn and dn.
    pub(super) omega: [[T; 3]; 3],
}

/// Both angles of a time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Phases<T> {
    pub(super) polhode: Phase<T>,
    pub(super) precession: Phase<T>,
}

/// What the time is to the series.
#[derive(Clone, Copy, Debug)]
pub(super) struct ThetaArgument<T> {
    /// z, as the series takes it.
    place: [T; 2],
    /// e^iφ
    phase: Complex<T>,
}

/// A state before it is scaled and argument into the axes that it is wanted in.
#[derive(Clone, Copy, Debug)]
pub(super) struct UnnormalisedState<T> {
    /// (Re α, Re β, Im β, Im α), all times one number.
    pub(super) quaternion: [T; 4],
    /// Makes its norm one, or a constant.
    pub(super) scale: T,
    /// cn, sn and dn times constants.
    pub(super) rates: [T; 3],
}

/// The way from phases to a state, in three stages: of a flow, or of what becomes one as it is needed.
pub(super) trait Stages<T> {
    fn theta_argument(&self, phases: &Phases<T>) -> ThetaArgument<T>;

    /// Quaternion and ω of the phases, in the labelled axes.
    fn unnormalised(&self, argument: &ThetaArgument<T>) -> UnnormalisedState<T>;

    /// Quaternion and ω of the phases.
    fn state(&self, unnormalised: &UnnormalisedState<T>) -> ([T; 4], [T; 3]);
}

/// Theta functions of one kind.
pub(super) trait Series<T> {
    /// z as the series takes it, and b′z in quarter turns if there is a bend.
    fn place(&self, z: Phase<T>) -> ([T; 2], Option<T>);

    fn at(&self, place: [T; 2]) -> Point<T>;
}

// Places for them, all numbers the same.

impl<T: Copy> Phases<T> {
    pub(super) fn of(x: T) -> Self {
        let phase = Phase { quarters: x, rest: x };
        Self { polhode: phase, precession: phase }
    }
}

impl<T: Copy> ThetaArgument<T> {
    pub(super) fn of(x: T) -> Self {
        Self { place: [x; 2], phase: Complex { re: x, im: x } }
    }
}

impl<T: Copy> UnnormalisedState<T> {
    pub(super) fn of(x: T) -> Self {
        Self { quaternion: [x; 4], scale: x, rates: [x; 3] }
    }
}

impl<T: Splat> PhaseRates<T> {
    #[inline(always)]
    pub(super) fn of(precession: Rate<T>, polhode: Rate<T>, start: [T; 2]) -> Self {
        let reach = precession.reach().zip(polhode.reach(), f64::min);
        Self { precession, polhode, start, reach }
    }

    /// Of what does not move.
    #[inline(always)]
    pub(super) fn none() -> Self {
        let zero = T::splat(0.0);
        let rate = Rate::of([zero; 2], zero);
        Self { precession: rate, polhode: rate, start: [zero; 2], reach: zero }
    }

    /// Both phases, reduced; `WHOLE` if the time has one word, `LONG` if it may be beyond reach.
    #[inline(always)]
    pub(super) fn phases<const WHOLE: bool, const LONG: bool>(&self, elapsed: &Elapsed<T>) -> Phases<T> {
        let polhode = self.polhode_phase::<WHOLE, LONG>(elapsed);
        Phases { polhode, precession: self.precession_phase::<WHOLE, LONG>(elapsed) }
    }

    #[inline(always)]
    pub(super) fn polhode_phase<const WHOLE: bool, const LONG: bool>(
        &self,
        elapsed: &Elapsed<T>,
    ) -> Phase<T> {
        Phase::of(self.polhode.quarters::<WHOLE, LONG>(elapsed, self.reach), Some(self.start))
    }

    #[inline(always)]
    pub(super) fn precession_phase<const WHOLE: bool, const LONG: bool>(
        &self,
        elapsed: &Elapsed<T>,
    ) -> Phase<T> {
        Phase::of(self.precession.quarters::<WHOLE, LONG>(elapsed, self.reach), None)
    }
}

impl<T: Splat, S: Series<T>> Stages<T> for &Flow<T, S> {
    #[inline(always)]
    fn theta_argument(&self, phases: &Phases<T>) -> ThetaArgument<T> {
        self.curve.theta_argument(phases)
    }

    #[inline(always)]
    fn unnormalised(&self, argument: &ThetaArgument<T>) -> UnnormalisedState<T> {
        self.curve.unnormalised(argument)
    }

    #[inline(always)]
    fn state(&self, unnormalised: &UnnormalisedState<T>) -> ([T; 4], [T; 3]) {
        self.to_body.state(unnormalised)
    }
}

impl<T: Splat, S: Series<T>> LabelledState<T, S> {
    #[inline(always)]
    pub(super) fn theta_argument(&self, phases: &Phases<T>) -> ThetaArgument<T> {
        let (place, bend) = self.series.place(phases.polhode);
        let phase = bend.map_or(phases.precession, |bend| phases.precession.plus(bend));
        let (im, re) = sin_cos_quarters(phase.quarters, phase.rest);
        ThetaArgument { place, phase: Complex { re, im } }
    }

    #[inline(always)]
    pub(super) fn unnormalised(&self, argument: &ThetaArgument<T>) -> UnnormalisedState<T> {
        let Point { f, theta, below } = self.series.at(argument.place);
        let d = &self.direction;
        let (e1, e2, e3) = (d[0] * theta[0], d[1] * theta[1], d[2] * theta[2]); // times below
        let sum = below + e3;
        let alpha = f.times(argument.phase);
        let beta = alpha.times(Complex { re: e2, im: -e1 });
        // |β|² + |sum α|² = constant · below · sum², as |α|² = constant · sum
        let both = (below * sum).map(|product| 1.0 / product);
        let over = sum * both;
        UnnormalisedState {
            quaternion: [sum * alpha.re, beta.re, beta.im, sum * alpha.im],
            scale: (below * both) * over.map(f64::sqrt),
            rates: [theta[0] * over, theta[1] * over, theta[2] * over],
        }
    }
}

impl<T: Splat> ToBodyMap<T> {
    #[inline(always)]
    pub(super) fn state(&self, unnormalised: &UnnormalisedState<T>) -> ([T; 4], [T; 3]) {
        let UnnormalisedState { quaternion: labelled, scale, rates } = *unnormalised;
        let (a, w) = (&self.attitude, &self.omega);
        let [qw, qx, qy, qz] =
            [dot4(&a[0], &labelled), dot4(&a[1], &labelled), dot4(&a[2], &labelled), dot4(&a[3], &labelled)];
        // The norm's last digits by 1/√n = (3 − n)/2 for n near 1.
        let norm2 = (scale * scale) * ((qw * qw + qx * qx) + (qy * qy + qz * qz));
        let k = scale * (T::splat(1.5) - T::splat(0.5) * norm2);
        ([qw * k, qx * k, qy * k, qz * k], [dot3(&w[0], &rates), dot3(&w[1], &rates), dot3(&w[2], &rates)])
    }
}

#[inline(always)]
fn dot3<T: Splat>(a: &[T; 3], b: &[T; 3]) -> T {
    (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]
}

#[inline(always)]
fn dot4<T: Splat>(a: &[T; 4], b: &[T; 4]) -> T {
    (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])
}
