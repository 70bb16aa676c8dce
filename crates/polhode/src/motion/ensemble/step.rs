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
//! of y = (x, q). No stage multiplies by h, and 21 of its 121 instructions are plain additions, which many processors do beside
//! multiplications.
//!
//! The equation of q is linear and torques see q/|q|, so that the length of q changes nothing. It is brought back to one where a state is
//! given out, and every [`STRETCH`] steps lest it leave the range of f64.

use core::array::from_fn;

use crate::math::number::Number;

/// Steps after which |q| = 1 again.
pub(super) const STRETCH: u64 = 256;

/// ¼ h ω and q, along principal axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moving<T> {
    pub(super) x: [T; 3],
    pub(super) q: [T; 4],
}

/// What acts on a body, along principal axes.
pub(super) trait Law<T: Number> {
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

impl<T: Number> Gait<T> {
    /// Steps of h; an axis without inertia keeps its ω.
    #[inline(always)]
    pub(super) fn new(zero: T, moments: impl Fn(usize) -> [f64; 3], h: f64) -> Self {
        let over = |numerator: f64, i: f64| if i == 0.0 { 0.0 } else { numerator / i };
        let coupling = |k: usize, lane: usize| {
            let i = moments(lane);
            over(2.0 * (i[(k + 1) % 3] - i[(k + 2) % 3]), i[k])
        };
        Self {
            coupling: from_fn(|k| zero.each(|lane| coupling(k, lane))),
            gain: from_fn(|k| zero.each(|lane| over(0.125 * h * h, moments(lane)[k]))),
            quarter: zero.like(0.25 * h),
            rate: zero.like(4.0 / h),
            two: zero.like(2.0),
            third: zero.like(1.0 / 3.0),
        }
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

/// One step of bodies abreast, stage by stage: while one waits for its own numbers, the others go on. The scenes are those at its start,
/// its middle and its end.
#[inline(always)]
pub(super) fn step<T: Number, L: Law<T>, const ABREAST: usize>(
    gaits: &[Gait<T>; ABREAST],
    laws: &[L; ABREAST],
    [start, middle, end]: [&[L::Scene; ABREAST]; 3],
    bodies: &mut [Moving<T>; ABREAST],
) {
    let (mut sums, mut stages) = (*bodies, *bodies);
    for row in 0..ABREAST {
        let (gait, y, sum, stage) = (&gaits[row], &bodies[row], &mut sums[row], &mut stages[row]);
        let k1 = gait.slope(&laws[row], &start[row], y);
        *stage = k1.plus(y);
        *sum = k1;
    }
    for row in 0..ABREAST {
        let (gait, y, sum, stage) = (&gaits[row], &bodies[row], &mut sums[row], &mut stages[row]);
        let k2 = gait.slope(&laws[row], &middle[row], stage);
        *stage = k2.plus(y);
        *sum = k2.times_plus(gait.two, sum);
    }
    for row in 0..ABREAST {
        let (gait, y, sum, stage) = (&gaits[row], &bodies[row], &mut sums[row], &mut stages[row]);
        let k3 = gait.slope(&laws[row], &middle[row], stage);
        *stage = k3.times_plus(gait.two, y);
        *sum = k3.times_plus(gait.two, sum);
    }
    for row in 0..ABREAST {
        let (gait, y, sum, stage) = (&gaits[row], &mut bodies[row], &sums[row], &stages[row]);
        let k4 = gait.slope(&laws[row], &end[row], stage);
        *y = sum.plus(&k4).times_plus(gait.third, y);
    }
}

/// q ∘ (0, v)
#[inline(always)]
fn product<T: Number>(&[w, x, y, z]: &[T; 4], &[a, b, c]: &[T; 3]) -> [T; 4] {
    [
        -z.mul_add(c, y.mul_add(b, x * a)),
        (-z).mul_add(b, y.mul_add(c, w * a)),
        (-x).mul_add(c, z.mul_add(a, w * b)),
        (-y).mul_add(a, x.mul_add(b, w * c)),
    ]
}

impl<T: Number> Moving<T> {
    /// self + other
    #[inline(always)]
    fn plus(&self, other: &Self) -> Self {
        let ([a, b, c], [d, e, f, g]) = (self.x, self.q);
        let ([p, q, r], [s, t, u, v]) = (other.x, other.q);
        Self { x: [a + p, b + q, c + r], q: [d + s, e + t, f + u, g + v] }
    }

    /// self · factor + other, rounded once
    #[inline(always)]
    fn times_plus(&self, factor: T, other: &Self) -> Self {
        let ([a, b, c], [d, e, f, g]) = (self.x, self.q);
        let ([p, q, r], [s, t, u, v]) = (other.x, other.q);
        let x = [a.mul_add(factor, p), b.mul_add(factor, q), c.mul_add(factor, r)];
        let q = [d.mul_add(factor, s), e.mul_add(factor, t), f.mul_add(factor, u), g.mul_add(factor, v)];
        Self { x, q }
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

impl<T: Number> Law<T> for Free {
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
