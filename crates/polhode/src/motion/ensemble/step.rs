//! One step of the classical Runge–Kutta method, of ω and q.
//!
//! Along the principal axes
//!
//! i1 ω̇1 = (i2 − i3) ω2 ω3 + N1 and so on,  q̇ = ½ q ∘ Ω
//!
//! where Ω is ω, or with friction inside ω + α L × ω. The step h is taken into the numbers: with x = ¼ h ω and f = ½ h d/dt
//!
//! f(x1) = 2 (i2 − i3)/i1 x2 x3 + h²/(8 i1) N1,  f(q) = q ∘ ¼ h Ω
//!
//! k1 = f(y),  k2 = f(y + k1),  k3 = f(y + k2),  k4 = f(y + 2 k3),  y′ = y + (k1 + 2 k2 + 2 k3 + k4)/3
//!
//! of y = (x, q). No stage multiplies by h: of the 198 operations of the textbook's form 28 multiplications are gone.
//!
//! The equation of q is linear and torques see q/|q|, so that the length of q changes nothing. It is brought back to one where a state is
//! given out, and every [`STRETCH`] steps lest it leave the range of f64.

use core::array::from_fn;

use crate::math::fused::Fused;

/// Steps after which |q| = 1 again.
pub(super) const STRETCH: u64 = 256;

/// ¼ h ω and q, along principal axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moving<T> {
    pub(super) x: [T; 3],
    pub(super) q: [T; 4],
}

/// What acts on a body, along principal axes.
pub(super) trait Law<T: Fused> {
    /// False if nothing does.
    const ACTS: bool;
    /// What depends on the time alone.
    type Scene;

    fn scene(&self, time: f64) -> Self::Scene;

    /// The same at another time, without moving what stays.
    fn change(&self, scene: &mut Self::Scene, time: f64);

    /// In a scene, with q of any length, at ω.
    fn act(&self, scene: &Self::Scene, q: &[T; 4], omega: &[T; 3]) -> Action<T>;
}

/// The torque N, and the rate Ω − ω at which the axes turn faster than ω.
#[derive(Clone, Copy, Debug)]
pub(super) struct Action<T> {
    pub(super) torque: [T; 3],
    pub(super) slip: Option<[T; 3]>,
}

/// The numbers of a body in steps of a length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gait<T> {
    /// 2 (i2 − i3)/i1 and so on.
    pub(super) coupling: [T; 3],
    /// h²/(8 i1) and so on.
    pub(super) gain: [T; 3],
    /// ¼ h
    pub(super) quarter: T,
    /// 4/h
    pub(super) rate: T,
    pub(super) two: T,
    pub(super) third: T,
}

impl<T: Fused> Gait<T> {
    /// Steps of h; an axis without inertia keeps its ω.
    #[inline(always)]
    pub(super) fn new(machine: T::Machine, moments: impl Fn(usize) -> [f64; 3], h: f64) -> Self {
        let over = |numerator: f64, i: f64| if i == 0.0 { 0.0 } else { numerator / i };
        let coupling = |k: usize, lane: usize| {
            let i = moments(lane);
            over(2.0 * (i[(k + 1) % 3] - i[(k + 2) % 3]), i[k])
        };
        Self {
            coupling: from_fn(|k| T::from_fn(machine, |lane| coupling(k, lane))),
            gain: from_fn(|k| T::from_fn(machine, |lane| over(0.125 * h * h, moments(lane)[k]))),
            quarter: T::splat(machine, 0.25 * h),
            rate: T::splat(machine, 4.0 / h),
            two: T::splat(machine, 2.0),
            third: T::splat(machine, 1.0 / 3.0),
        }
    }

    /// One step: the scenes are those at its start, its middle and its end.
    #[inline(always)]
    pub(super) fn step<L: Law<T>>(
        &self,
        law: &L,
        [start, middle, end]: [&L::Scene; 3],
        y: &Moving<T>,
    ) -> Moving<T> {
        let k = self.slope(law, start, y);
        let mut sum = k;
        let k = self.slope(
            law,
            middle,
            &y.zip(
                &k,
                #[inline(always)]
                |y, k| y + k,
            ),
        );
        sum = k.zip(
            &sum,
            #[inline(always)]
            |k, sum| self.two.mul_add(k, sum),
        );
        let k = self.slope(
            law,
            middle,
            &y.zip(
                &k,
                #[inline(always)]
                |y, k| y + k,
            ),
        );
        sum = k.zip(
            &sum,
            #[inline(always)]
            |k, sum| self.two.mul_add(k, sum),
        );
        let k = self.slope(
            law,
            end,
            &k.zip(
                y,
                #[inline(always)]
                |k, y| k.mul_add(self.two, y),
            ),
        );
        sum = sum.zip(
            &k,
            #[inline(always)]
            |sum, k| sum + k,
        );
        sum.zip(
            y,
            #[inline(always)]
            |sum, y| self.third.mul_add(sum, y),
        )
    }

    /// f(y)
    #[inline(always)]
    fn slope<L: Law<T>>(&self, law: &L, scene: &L::Scene, y: &Moving<T>) -> Moving<T> {
        let [x1, x2, x3] = y.x;
        let [c1, c2, c3] = self.coupling;
        let mut x = [c1 * x2 * x3, c2 * x3 * x1, c3 * x1 * x2];
        let mut turning = y.x;
        if L::ACTS {
            let Action { torque, slip } =
                law.act(scene, &y.q, &[x1 * self.rate, x2 * self.rate, x3 * self.rate]);
            for k in 0..3 {
                x[k] = torque[k].mul_add(self.gain[k], x[k]);
            }
            if let Some(slip) = slip {
                for k in 0..3 {
                    turning[k] = slip[k].mul_add(self.quarter, turning[k]);
                }
            }
        }
        Moving { x, q: product(&y.q, &turning) }
    }
}

/// q ∘ (0, v)
#[inline(always)]
fn product<T: Fused>(&[w, x, y, z]: &[T; 4], &[a, b, c]: &[T; 3]) -> [T; 4] {
    [
        -z.mul_add(c, y.mul_add(b, x * a)),
        (-z).mul_add(b, y.mul_add(c, w * a)),
        (-x).mul_add(c, z.mul_add(a, w * b)),
        (-y).mul_add(a, x.mul_add(b, w * c)),
    ]
}

impl<T: Fused> Moving<T> {
    #[inline(always)]
    fn zip(&self, other: &Self, f: impl Fn(T, T) -> T) -> Self {
        let mut sum = *self;
        for k in 0..3 {
            sum.x[k] = f(self.x[k], other.x[k]);
        }
        for k in 0..4 {
            sum.q[k] = f(self.q[k], other.q[k]);
        }
        sum
    }

    /// With q of length 1.
    #[inline(always)]
    pub(super) fn with_unit(self) -> Self {
        let [w, x, y, z] = self.q;
        let length = w.mul_add(w, x.mul_add(x, y.mul_add(y, z * z))).sqrt();
        Self { x: self.x, q: self.q.map(|c| c / length) }
    }
}

/// Nothing acts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Free;

impl<T: Fused> Law<T> for Free {
    const ACTS: bool = false;
    type Scene = ();

    #[inline(always)]
    fn scene(&self, _: f64) {}

    #[inline(always)]
    fn change(&self, (): &mut (), _: f64) {}

    #[inline(always)]
    fn act(&self, (): &(), _: &[T; 4], omega: &[T; 3]) -> Action<T> {
        Action { torque: *omega, slip: None } // never asked: ACTS is false
    }
}
