//! Evaluation of a top's motion by theta functions.
//!
//! P, Q and ω⊥ = ω1 + iω2 are elliptic functions of the second kind. They share one pole, the zero
//! of θ₄, and have one zero each. With z = πx/2K and x = x₀ + λt,
//!
//! P = p e^iφ_P N_P(z)/θ₄(z),  Q = q e^iφ_Q N_Q(z)/θ₄(z),
//! ω⊥ = iω e^i(φ_Q − φ_P) e^2ikz N_ω(z)/θ₄(z)
//!
//! The functions N are those of `theta.rs`, with ε = −1 for P and 1 for the others; the phases φ
//! are linear in time. The zeros are at y = 0: tan² φ = w₁/(v₁ − v₂) for P and v₂(v₁ − v₃)/(|v₃|(v₁
//! − v₂)) for Q. The zero of ω⊥ follows from ω⊥ = 2(P* Q̇ − Q Ṗ*), because both sides get the same
//! factor from z → z + iπt. θ₄ follows from |P|² + |Q|² = 1. Constant phases are rotations about
//! the vertical and about the axis.
//!
//! Source: Klein & Sommerfeld, Über die Theorie des Kreisels, ch. VI; Whittaker, Analytical
//! Dynamics, §72.

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::number::Splat;
use crate::math::quaternion::Quaternion;
use crate::motion::solve::phase::{Angle, Elapsed, Phase};
use crate::motion::solve::theta::{Lattice, SeriesArgument, Shifted, unit_of_quarters};

use super::Nods;
use super::cayley_klein::CayleyKlein;

/// Constants of a top's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Kernel {
    lattice: Lattice,
    /// Phase z of the nutation.
    nutation: Angle,
    /// Phases φ_P and φ_Q.
    turns: [Angle; 2],
    /// Theta functions N_P, N_Q and N_ω.
    series: [Shifted; 3],
    /// Factors p, q and ω of the theta functions.
    sizes: [f64; 3],
    /// Integer k of the factor e^2ikz.
    winding: i8,
    /// Matrix from (Re P, Re Q, Im Q, Im P) to the attitude.
    attitude: [[f64; 4]; 4],
    /// Matrix from (Re ω⊥, Im ω⊥, 1) to ω in body axes.
    omega: [[f64; 3]; 3],
    /// Longest time within the reach of all phases.
    reach: f64,
}

impl Kernel {
    /// Computes the constants of a motion that is not on the separatrix.
    ///
    /// `vertical`: rotation from z to the vertical. `axis`: rotation from z to the top's axis.
    /// `turning`, `spin`: ½(ω3 − a) and ω3.
    pub(super) fn of(
        nods: &Nods,
        [vertical, axis]: [Quaternion<Double>; 2],
        [turning, spin]: [Double; 2],
        unit_rate: f64,
    ) -> Self {
        let Nods { nutation, halves: [(p, p_factor), (q, q_factor)] } = nods;
        let parameter = &nutation.parameter;
        let lattice = Lattice::of(parameter);
        let [_, v2, v3] = nutation.from_top;
        let [w1, ..] = nutation.from_bottom;
        let shifts = [
            lattice.shift(w1.sqrt(), nutation.swing.sqrt()),
            lattice.shift((v2 * nutation.spread).sqrt(), (v3 * nutation.swing).sqrt()),
        ];
        let back = [p, q].map(CayleyKlein::winds_backwards);
        let sign = |back: bool| if back { -1.0 } else { 1.0 };
        // σ_ω w_ω = σ_Q w_Q − σ_P w_P − ½aπt, a = ±1
        let difference = shifts[1].scaled(sign(back[1])) - shifts[0].scaled(sign(back[0]));
        let a = sign(difference.high < 0.0);
        let across = difference - lattice.largest_shift().scaled(a);
        let across_back = across.high < 0.0;
        let winding = (a + sign(across_back) - sign(back[1]) + sign(back[0])) * 0.5;
        let series = [
            lattice.shifted(shifts[0], false, back[0]),
            lattice.shifted(shifts[1], true, back[1]),
            lattice.shifted(across.abs(), true, across_back),
        ];

        let [lowest, highest] = [0.0, 1.0].map(|quarters| lattice.place(Phase::of((quarters, 0.0), None)));
        let size = |value: f64, series: &Shifted, place: &SeriesArgument<f64>| {
            value * lattice.denominator(place) / series.at(place).abs()
        };
        let [[p_value, p_rate], [q_value, q_rate]] = [p, q].map(CayleyKlein::at_lowest);
        let at_lowest = (p_value * q_rate + q_value * p_rate) * nutation.rate;
        let sizes = [
            size(nutation.from_bottom[1].scaled(0.5).sqrt().value(), &series[0], &highest),
            size(nutation.from_top[0].scaled(0.5).sqrt().value(), &series[1], &lowest),
            size(2.0 * at_lowest.value(), &series[2], &lowest),
        ];

        let quarter = Double::TAU.scaled(0.25);
        let nods_per_unit = nutation.rate / parameter.quarter();
        let gains = [p, q].map(|half| half.whole_gain(parameter).scaled(0.5) / quarter);
        // number of nutations at the start, x₀/2K
        let begun = nutation.start / parameter.quarter();
        let rates = [turning, -turning].map(|turning| turning / quarter);
        let turns = [0, 1].map(|k| Angle::of(gains[k] * nods_per_unit + rates[k], gains[k] * begun));

        // P → e^iα P and Q → e^iβ Q are rotations by α + β about the vertical and by α − β about
        // the axis
        let both = root(p_factor.times(*q_factor));
        let about_vertical = Quaternion([both.re, Double::default(), Double::default(), both.im]);
        let other = p_factor.times(both.conjugate());
        let about_axis = Quaternion([other.re, Double::default(), Double::default(), other.im]);
        let (left, right) = (vertical.times(about_vertical), about_axis.times(axis.conjugate()));
        let column = |k: usize| {
            let mut one = [Double::default(); 4];
            one[k] = Double::ONE;
            left.times(Quaternion(one)).times(right).0.map(Double::value)
        };
        let columns = [0, 1, 2, 3].map(column);
        let to_body = right.conjugate();
        let body_axis = |k: usize, size: Double| {
            let mut one = [Double::default(); 3];
            one[k] = size;
            to_body.turned(one).map(|c| c.value() * unit_rate)
        };
        let [x, y, z] = [body_axis(0, Double::ONE), body_axis(1, Double::ONE), body_axis(2, spin)];
        let nutation = Angle::of(nods_per_unit, begun);
        Self {
            lattice,
            reach: nutation.reach.min(turns[0].reach).min(turns[1].reach),
            nutation,
            turns,
            series,
            sizes,
            winding: winding as i8,
            attitude: [0, 1, 2, 3].map(|row| columns.map(|column| column[row])),
            omega: [0, 1, 2].map(|row| [x[row], y[row], z[row]]),
        }
    }

    /// Returns quaternion and ω after a time.
    #[inline(always)]
    pub(super) fn at<T: Splat>(&self, elapsed: &Elapsed<T>) -> ([T; 4], [T; 3]) {
        if elapsed.is_within(T::splat(self.reach)) {
            self.after::<T, false>(elapsed)
        } else {
            self.after::<T, true>(elapsed)
        }
    }

    #[inline(always)]
    fn after<T: Splat, const LONG: bool>(&self, elapsed: &Elapsed<T>) -> ([T; 4], [T; 3]) {
        let place = self.lattice.place(self.nutation.at::<T, LONG>(elapsed));
        let [p_series, q_series, across_series] = &self.series;
        let bends = [p_series.bend_at(&place), q_series.bend_at(&place), across_series.bend_at(&place)];
        let p_turn = self.turns[0].at::<T, LONG>(elapsed).plus(bends[0]).unit();
        let q_turn = self.turns[1].at::<T, LONG>(elapsed).plus(bends[1]).unit();
        let [p_size, q_size, across_size] =
            [T::splat(self.sizes[0]), T::splat(self.sizes[1]), T::splat(self.sizes[2])];
        let p = p_series.at(&place).times(p_turn).scaled(p_size);
        let q = q_series.at(&place).times(q_turn).scaled(q_size);
        let scale = (p.norm_squared() + q.norm_squared()).map(|square| 1.0 / square.sqrt());

        let mut turn = p_turn.conjugate().times(q_turn);
        if let SeriesArgument::Hyperbolic { .. } = place {
            turn = turn.times(unit_of_quarters(bends[2] - bends[1] + bends[0]));
        }
        if self.winding != 0 {
            turn = turn.times(self.lattice.power(&place, self.winding));
        }
        let across = across_series.at(&place).times(turn).times_i().scaled(across_size * scale);

        let labelled = [p.re * scale, q.re * scale, q.im * scale, p.im * scale];
        let [a0, a1, a2, a3] = &self.attitude;
        let (w, x, y, z) =
            (dot4(a0, &labelled), dot4(a1, &labelled), dot4(a2, &labelled), dot4(a3, &labelled));
        // Correct the last digits of the norm by 1/√n = (3 − n)/2 for n near 1.
        let k = T::splat(1.5) - T::splat(0.5) * ((w * w + x * x) + (y * y + z * z));
        let [o0, o1, o2] = &self.omega;
        ([w * k, x * k, y * k, z * k], [omega(o0, across), omega(o1, across), omega(o2, across)])
    }
}

#[inline(always)]
fn dot4<T: Splat>(a: &[f64; 4], b: &[T; 4]) -> T {
    (T::splat(a[0]) * b[0] + T::splat(a[1]) * b[1]) + (T::splat(a[2]) * b[2] + T::splat(a[3]) * b[3])
}

#[inline(always)]
fn omega<T: Splat>(a: &[f64; 3], across: Complex<T>) -> T {
    (T::splat(a[0]) * across.re + T::splat(a[1]) * across.im) + T::splat(a[2])
}

/// Returns a square root of a complex number of absolute value 1.
fn root(z: Complex<Double>) -> Complex<Double> {
    // √z = (1 + z)/|1 + z|. If z is nearer to −1: i (1 − z)/|1 − z| and its conjugate.
    let near = z.re.high >= 0.0;
    let sum = if near {
        Complex { re: Double::ONE + z.re, im: z.im }
    } else {
        Complex { re: z.im, im: Double::ONE - z.re }
    };
    let size = sum.norm_squared().sqrt();
    Complex { re: sum.re / size, im: sum.im / size }
}
