//! Evaluation of every free motion: two phases, a few terms of a theta series, a quaternion.

use crate::math::complex::Complex;
use crate::math::elementary::sin_cos_quarters;
use crate::math::number::Splat;
use crate::motion::solve::phase::{Elapsed, Phase, Rate};

/// Values of the theta functions at a point of the polhode.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point<T> {
    /// f: theta function of the attitude.
    pub(super) f: Complex<T>,
    /// cn, sn and dn, each times a constant and times `below`.
    pub(super) theta: [T; 3],
    /// Common denominator: the theta function that cn, sn and dn share.
    pub(super) below: T,
}

/// Constants of a motion in the form that is evaluated. All follow from
/// [`CompactConstants`](super::compact::CompactConstants).
///
/// Let z = π(u0 + λt)/2K. The unit vector along L is e = (A1 cn, A2 sn, A3 dn)/L in the labelled
/// axes. The quaternion from the labelled axes to axes along L has w + iz = α and x + iy = β, where
///
/// α = e^iφ f(z),  β = α (e2 − i e1)/(1 + e3),  φ = ½(Ωt − z) + b′z
///
/// Here f is the theta series and b′ its bend, which is zero for the trigonometric series. ω =
/// (A1/i1 cn, A2/i2 sn, A3/i3 dn).
///
/// Source: Klein & Sommerfeld, Über die Theorie des Kreisels, ch. VI; derived in
/// `book/free-motion.md`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Flow<T, S> {
    pub(super) phase_rates: PhaseRates<T>,
    pub(super) curve: LabelledState<T, S>,
    pub(super) to_body: ToBodyMap<T>,
}

/// Rates and start of the two phases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PhaseRates<T> {
    /// Rate of ½(Ωt − z), quarter turns per unit time.
    pub(super) precession: Rate<T>,
    /// Rate λ/K of 2z/π, quarter turns per unit time.
    pub(super) polhode: Rate<T>,
    /// 2z/π at the start, quarter turns, in two words.
    pub(super) start: [T; 2],
    /// Longest time for which two words of both rates suffice.
    pub(super) reach: T,
}

/// Map from phases to a quaternion and ω in the labelled axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LabelledState<T, S> {
    pub(super) series: S,
    /// Factors that turn the theta functions into the components of e.
    pub(super) direction: [T; 3],
}

/// Map of quaternion and ω from the labelled axes to the body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ToBodyMap<T> {
    /// Matrix from the quaternion in the labelled axes to that of the attitude, of norm 1/`scale`.
    pub(super) attitude: [[T; 4]; 4],
    /// Columns: the axes times the amplitudes of ω along them, times the factors that turn theta
    /// functions into cn, sn and dn.
    pub(super) omega: [[T; 3]; 3],
}

/// Both phases at one time, reduced.
#[derive(Clone, Copy, Debug)]
pub(super) struct Phases<T> {
    pub(super) polhode: Phase<T>,
    pub(super) precession: Phase<T>,
}

/// Argument of the theta series at one time.
#[derive(Clone, Copy, Debug)]
pub(super) struct ThetaArgument<T> {
    /// z in the form that the series takes.
    place: [T; 2],
    /// e^iφ
    phase: Complex<T>,
}

/// State before normalisation, in the labelled axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct UnnormalisedState<T> {
    /// (Re α, Re β, Im β, Im α), all times one number.
    pub(super) quaternion: [T; 4],
    /// Factor that makes the norm of the quaternion 1 or a constant.
    pub(super) scale: T,
    /// cn, sn and dn, each times a constant.
    pub(super) rates: [T; 3],
}

/// Three stages from phases to a state. A [`Flow`] implements them, and so does a type that
/// computes parts of its flow on demand.
pub(super) trait Stages<T> {
    fn theta_argument(&self, phases: &Phases<T>) -> ThetaArgument<T>;

    /// Returns quaternion and ω in the labelled axes, not normalised.
    fn unnormalised(&self, argument: &ThetaArgument<T>) -> UnnormalisedState<T>;

    /// Returns quaternion and ω in body axes.
    fn state(&self, unnormalised: &UnnormalisedState<T>) -> ([T; 4], [T; 3]);
}

/// Theta series of one kind.
pub(super) trait Series<T> {
    /// Returns z in the form that the series takes, and b′z in quarter turns if the series has a
    /// bend.
    fn place(&self, z: Phase<T>) -> ([T; 2], Option<T>);

    fn at(&self, place: [T; 2]) -> Point<T>;
}

// Values with all components equal, to initialise buffers.

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

    /// Rates of a motion at rest.
    #[inline(always)]
    pub(super) fn none() -> Self {
        let zero = T::splat(0.0);
        let rate = Rate::of([zero; 2], zero);
        Self { precession: rate, polhode: rate, start: [zero; 2], reach: zero }
    }

    /// Returns both phases, reduced. `WHOLE`: the time has one word. `LONG`: the time may be beyond
    /// `reach`.
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
        // Correct the last digits of the norm by 1/√n = (3 − n)/2 for n near 1.
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
