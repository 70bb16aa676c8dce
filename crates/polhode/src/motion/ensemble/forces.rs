//! The torques whose laws are cheap algebra, of a body in every lane.

use core::array::from_fn;

use super::Member;
use super::step::{Action, Law};
use crate::math::frame::{Body, Space};
use crate::math::number::Number;
use crate::math::vector::Vector;
use crate::motion::orbit::Orbit;
use crate::motion::torque::{Attracted, ConstantTorque, DragLaw, Magnetic, MagneticField, TorqueModel};
use crate::motion::wheel::{Motor, Wheel};

/// A body's torques as numbers, along principal axes unless they say otherwise. What does not act is `None`.
#[derive(Clone, Debug, Default)]
pub(super) struct Parts<'a> {
    moments: [f64; 3],
    /// N, fixed in the body; the motors' −ḣ too.
    constant: Option<[f64; 3]>,
    /// N, fixed in space, along its axes.
    in_space: Option<[f64; 3]>,
    /// Lever and weight, the latter along the axes of space.
    weight: Option<[f64; 6]>,
    /// N = −D ω: rows of D.
    linear: Option<[f64; 9]>,
    /// N = −|ω| D ω: rows of D.
    quadratic: Option<[f64; 9]>,
    /// α of friction inside.
    sink: Option<[f64; 1]>,
    /// h at t = 0, and ḣ.
    wheels: Option<[f64; 6]>,
    magnet: Option<(&'a Magnetic, [f64; 3])>,
    orbit: Option<&'a Orbit>,
}

impl<'a> Parts<'a> {
    /// Those of a member; `None` if some torque is not among them.
    pub(super) fn of(member: &'a Member) -> Option<Self> {
        let (rotor, principal) = (&member.rotor, member.rotor.principal());
        let to_principal = principal.rotation().inverse();
        let along = |v: Vector<_, Body>| (to_principal * v).to_array();
        let mut parts = Self { moments: principal.moments(), ..Self::default() };
        for torque in &member.torques {
            match torque {
                TorqueModel::Constant(ConstantTorque::Body(torque)) => {
                    add(&mut parts.constant, along(*torque));
                }
                TorqueModel::Constant(ConstantTorque::Space(torque)) => {
                    add(&mut parts.in_space, torque.to_array());
                }
                TorqueModel::Thruster(thruster) => add(&mut parts.constant, along(thruster.torque(rotor))),
                TorqueModel::Gravity(gravity) => {
                    let [a, b, c] = (to_principal * rotor.lever()).to_array();
                    let [x, y, z] = (gravity.acceleration * rotor.mass()).to_array();
                    let [.., u, v, w] = parts.weight.unwrap_or_default();
                    parts.weight = Some([a, b, c, u + x, v + y, w + z]);
                }
                TorqueModel::Drag(drag) => {
                    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] =
                        drag.matrix_along(&to_principal.matrix());
                    let part = match drag.law() {
                        DragLaw::Linear => &mut parts.linear,
                        DragLaw::Quadratic => &mut parts.quadratic,
                    };
                    add(part, [xx, xy, xz, yx, yy, yz, zx, zy, zz]);
                }
                TorqueModel::EnergySink(sink) => add(&mut parts.sink, [sink.coefficient()]),
                TorqueModel::Magnetic(magnetic) if parts.magnet.is_none() => {
                    parts.magnet = Some((magnetic, (to_principal * magnetic.moment).to_array()));
                }
                TorqueModel::GravityGradient(gradient) if parts.orbit.is_none() => {
                    // A wheel that turns freely adds to the inertia that gravity acts on.
                    let is_diagonal =
                        rotor.wheels().iter().all(|wheel| matches!(wheel.motor(), Motor::HeldSpeed));
                    if gradient.attracted != Attracted::Tensor || !is_diagonal {
                        return None;
                    }
                    parts.orbit = Some(&gradient.orbit);
                }
                _ => return None,
            }
        }
        if !rotor.wheels().is_empty() {
            if rotor.wheels().iter().any(is_scheduled) {
                return None;
            }
            let [momentum, rate] =
                [along(rotor.wheel_momentum(0.0).as_quantity()), along(rotor.motor_torque(0.0))];
            if rotor.wheels().iter().any(Wheel::is_driven) {
                add(&mut parts.constant, rate.map(|rate| -rate));
            }
            let ([a, b, c], [x, y, z]) = (momentum, rate);
            parts.wheels = Some([a, b, c, x, y, z]);
        }
        Some(parts)
    }

    /// What acts: bodies that agree in it go side by side.
    pub(super) fn kind(&self) -> [bool; 9] {
        [
            self.constant.is_some(),
            self.in_space.is_some(),
            self.weight.is_some(),
            self.linear.is_some(),
            self.quadratic.is_some(),
            self.sink.is_some(),
            self.wheels.is_some(),
            self.magnet.is_some(),
            self.orbit.is_some(),
        ]
    }
}

fn is_scheduled(wheel: &Wheel) -> bool {
    matches!(wheel.motor(), Motor::Torque { schedule: Some(_), .. })
}

fn add<const N: usize>(part: &mut Option<[f64; N]>, more: [f64; N]) {
    let so_far = part.unwrap_or([0.0; N]);
    *part = Some(from_fn(|k| so_far[k] + more[k]));
}

/// [`Parts`] of a kind, one in every lane.
pub(super) struct Forces<'a, T: Number> {
    zero: T,
    moments: [T; 3],
    constant: Option<[T; 3]>,
    in_space: Option<[T; 3]>,
    weight: Option<[T; 6]>,
    linear: Option<[T; 9]>,
    quadratic: Option<[T; 9]>,
    sink: Option<[T; 1]>,
    wheels: Option<[T; 6]>,
    magnet: Option<[T; 3]>,
    fields: Shared<&'a MagneticField>,
    orbits: Shared<&'a Orbit>,
}

/// What depends on the time: the field, the direction from the orbit's centre and µ/r³, and h; only what there is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scene<T> {
    field: [T; 3],
    ray: [T; 4],
    wheels: [T; 3],
}

impl<'a, T: Number> Forces<'a, T> {
    /// The parts of each lane, which are of one kind.
    #[inline(always)]
    pub(super) fn new(zero: T, parts: &[&Parts<'a>]) -> Self {
        Self {
            zero,
            moments: from_fn(|k| zero.each(|lane| at(parts, lane).moments[k])),
            constant: side_by_side(zero, parts, |parts| parts.constant),
            in_space: side_by_side(zero, parts, |parts| parts.in_space),
            weight: side_by_side(zero, parts, |parts| parts.weight),
            linear: side_by_side(zero, parts, |parts| parts.linear),
            quadratic: side_by_side(zero, parts, |parts| parts.quadratic),
            sink: side_by_side(zero, parts, |parts| parts.sink),
            wheels: side_by_side(zero, parts, |parts| parts.wheels),
            magnet: side_by_side(zero, parts, |parts| parts.magnet.map(|(_, moment)| moment)),
            fields: Shared::of(
                parts.iter().filter_map(|parts| parts.magnet.map(|(magnet, _)| &magnet.field)),
            ),
            orbits: Shared::of(parts.iter().filter_map(|parts| parts.orbit)),
        }
    }
}

#[inline(always)]
fn at<'b, 'a>(parts: &'b [&Parts<'a>], lane: usize) -> &'b Parts<'a> {
    parts[if lane < parts.len() { lane } else { 0 }]
}

#[inline(always)]
fn side_by_side<T: Number, const N: usize>(
    zero: T,
    parts: &[&Parts<'_>],
    get: impl Fn(&Parts<'_>) -> Option<[f64; N]>,
) -> Option<[T; N]> {
    get(at(parts, 0))?;
    Some(from_fn(|k| zero.each(|lane| get(at(parts, lane)).map_or(0.0, |numbers| numbers[k]))))
}

/// One thing of each lane; often they are all the same.
struct Shared<P> {
    each: Vec<P>,
}

impl<P: Copy + PartialEq> Shared<P> {
    fn of(each: impl Iterator<Item = P>) -> Self {
        let mut each: Vec<P> = each.collect();
        if each.iter().all(|one| Some(one) == each.first()) {
            each.truncate(1);
        }
        Self { each }
    }

    /// N numbers of each lane, computed once if they are the same.
    #[inline(always)]
    fn numbers<T: Number, const N: usize>(&self, zero: T, numbers: &mut [T; N], of: impl Fn(P) -> [f64; N]) {
        match self.each.as_slice() {
            [] => {}
            [one] => {
                let all = of(*one);
                for k in 0..N {
                    numbers[k] = zero.like(all[k]);
                }
            }
            [first, ..] => {
                let mut all = [[0.0; N]; 8];
                for (lane, all) in all.iter_mut().enumerate().take(T::LANES) {
                    *all = of(*self.each.get(lane).unwrap_or(first));
                }
                for k in 0..N {
                    numbers[k] = zero.each(
                        #[inline(always)]
                        |lane| all[lane][k],
                    );
                }
            }
        }
    }

    fn is_empty(&self) -> bool {
        self.each.is_empty()
    }
}

impl<T: Number> Law<T> for Forces<'_, T> {
    const ACTS: bool = true;
    type Scene = Scene<T>;

    #[inline(always)]
    fn scene(&self, time: f64) -> Scene<T> {
        let zero = self.zero;
        let mut scene = Scene { field: [zero; 3], ray: [zero; 4], wheels: [zero; 3] };
        self.change(&mut scene, time);
        scene
    }

    #[inline(always)]
    fn change(&self, scene: &mut Scene<T>, time: f64) {
        self.fields.numbers(
            self.zero,
            &mut scene.field,
            #[inline(always)]
            |field| field.at(time).to_array(),
        );
        self.orbits.numbers(
            self.zero,
            &mut scene.ray,
            #[inline(always)]
            |orbit| ray(orbit, time),
        );
        if let Some([a, b, c, x, y, z]) = &self.wheels {
            let time = self.zero.like(time);
            scene.wheels = [x.mul_add(time, *a), y.mul_add(time, *b), z.mul_add(time, *c)];
        }
    }

    #[inline(always)]
    fn act(&self, scene: &Scene<T>, q: &[T; 4], omega: &[T; 3]) -> Action<T> {
        let mut torque = match &self.constant {
            Some(torque) => *torque,
            None => [self.zero; 3],
        };
        let (is_magnetic, is_orbiting) = (!self.fields.is_empty(), !self.orbits.is_empty());
        if self.in_space.is_some() || self.weight.is_some() || is_magnetic || is_orbiting {
            let seen = Seen::new(self.zero, q);
            if let Some(fixed) = &self.in_space {
                torque = plus(torque, seen.from(fixed));
            }
            // N = l × m g
            if let Some([a, b, c, x, y, z]) = &self.weight {
                torque = cross_add(&[*a, *b, *c], &seen.from(&[*x, *y, *z]), torque);
            }
            // N = m × B
            if let Some(moment) = &self.magnet {
                torque = cross_add(moment, &seen.from(&scene.field), torque);
            }
            // N = 3 µ/r³ r̂ × I r̂
            if is_orbiting {
                let [x, y, z, strength] = scene.ray;
                let r = seen.from(&[x, y, z]);
                let three = strength + strength + strength;
                let [i1, i2, i3] = self.moments;
                let pull = [three * i1 * r[0], three * i2 * r[1], three * i3 * r[2]];
                torque = cross_add(&r, &pull, torque);
            }
        }
        // N = −D ω
        if let Some(matrix) = &self.linear {
            let [a, b, c] = apply(matrix, omega);
            torque = [torque[0] - a, torque[1] - b, torque[2] - c];
        }
        // N = −|ω| D ω
        if let Some(matrix) = &self.quadratic {
            let [a, b, c] = apply(matrix, omega);
            let [x, y, z] = *omega;
            let rate = -x.mul_add(x, y.mul_add(y, z * z)).sqrt();
            torque = [rate.mul_add(a, torque[0]), rate.mul_add(b, torque[1]), rate.mul_add(c, torque[2])];
        }
        // h × ω; −ḣ is among what is constant
        if self.wheels.is_some() {
            torque = cross_add(&scene.wheels, omega, torque);
        }
        // slip α L × ω, and L × of it
        let mut slip = None;
        if let Some([alpha]) = self.sink {
            let [i1, i2, i3] = self.moments;
            let mut l = [i1 * omega[0], i2 * omega[1], i3 * omega[2]];
            if self.wheels.is_some() {
                l = plus(l, scene.wheels);
            }
            let [a, b, c] = cross_add(&l, omega, [self.zero; 3]);
            let slipping = [alpha * a, alpha * b, alpha * c];
            torque = cross_add(&l, &slipping, torque);
            slip = Some(slipping);
        }
        Action { torque, slip }
    }
}

/// The direction from the orbit's centre, and µ/r³.
fn ray(orbit: &Orbit, time: f64) -> [f64; 4] {
    let r: Vector<_, Space> = orbit.position(time);
    let distance = r.norm();
    let [x, y, z] = (r / distance).to_array();
    [x, y, z, orbit.strength(distance)]
}

/// What is fixed in space, from the body: R_body_space of a quaternion of any length, by rows.
struct Seen<T>([[T; 3]; 3]);

impl<T: Number> Seen<T> {
    #[inline(always)]
    fn new(zero: T, &[w, x, y, z]: &[T; 4]) -> Self {
        let one = zero.like(1.0);
        let norm2 = w.mul_add(w, x.mul_add(x, y.mul_add(y, z * z)));
        let scale = (one + one) / norm2;
        let [a, b, c] = [scale * x, scale * y, scale * z];
        let (wa, wb, wc) = (w * a, w * b, w * c);
        Self([
            [one - b.mul_add(y, c * z), a.mul_add(y, wc), a.mul_add(z, -wb)],
            [a.mul_add(y, -wc), one - a.mul_add(x, c * z), b.mul_add(z, wa)],
            [a.mul_add(z, wb), b.mul_add(z, -wa), one - a.mul_add(x, b * y)],
        ])
    }

    #[inline(always)]
    fn from(&self, v: &[T; 3]) -> [T; 3] {
        let [a, b, c] = &self.0;
        [dot(a, v), dot(b, v), dot(c, v)]
    }
}

#[inline(always)]
fn dot<T: Number>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

/// M v of rows one after the other.
#[inline(always)]
fn apply<T: Number>(m: &[T; 9], v: &[T; 3]) -> [T; 3] {
    [dot(&[m[0], m[1], m[2]], v), dot(&[m[3], m[4], m[5]], v), dot(&[m[6], m[7], m[8]], v)]
}

#[inline(always)]
fn plus<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// a × b + c
#[inline(always)]
fn cross_add<T: Number>(a: &[T; 3], b: &[T; 3], c: [T; 3]) -> [T; 3] {
    [
        (-a[2]).mul_add(b[1], a[1].mul_add(b[2], c[0])),
        (-a[0]).mul_add(b[2], a[2].mul_add(b[0], c[1])),
        (-a[1]).mul_add(b[0], a[0].mul_add(b[1], c[2])),
    ]
}
