//! Random scenarios as plain numbers, which transform like axes and units.

use polhode::motion::torque::{
    Drag, DragLaw, EnergySink, Magnetic, MagneticField, Schedule, Scheduled, Thruster, Torsion,
};
use polhode::motion::{Motor, Wheel};
use polhode::prelude::*;

type V = [f64; 3];
pub(crate) type M = [[f64; 3]; 3];

/// Knuth's MMIX generator with mixing: successive seeds give unrelated sequences.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self((seed ^ 0x9e37_79b9_7f4a_7c15).wrapping_mul(0xbf58_476d_1ce4_e5b9))
    }

    /// Returns a number in [0, 1).
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let mixed = (self.0 ^ (self.0 >> 31)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// Returns one of 0 … count − 1.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        (self.next() * count as f64) as usize
    }

    pub(crate) fn vector(&mut self, size: f64) -> V {
        [0; 3].map(|_| self.between(-size, size))
    }

    /// Returns a unit quaternion.
    pub(crate) fn quaternion(&mut self) -> [f64; 4] {
        loop {
            let q = [0; 4].map(|_| self.between(-1.0, 1.0));
            let n: f64 = q.iter().map(|c| c * c).sum();
            if n > 0.1 && n < 1.0 {
                return q.map(|c| c / n.sqrt());
            }
        }
    }

    /// Returns a symmetric matrix with eigenvalues in this range.
    fn symmetric(&mut self, [low, high]: [f64; 2]) -> M {
        let r = matrix(self.quaternion());
        let moments = [0; 3].map(|_| self.between(low, high));
        turned(&r, core::array::from_fn(|i| core::array::from_fn(|j| if i == j { moments[i] } else { 0.0 })))
    }
}

pub(crate) fn matrix(q: [f64; 4]) -> M {
    Attitude::from_quaternion(q).unwrap().matrix()
}

fn times(m: &M, v: V) -> V {
    core::array::from_fn(|i| (0..3).map(|j| m[i][j] * v[j]).sum())
}

fn product(a: &M, b: &M) -> M {
    core::array::from_fn(|i| core::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

fn transposed(m: &M) -> M {
    core::array::from_fn(|i| core::array::from_fn(|j| m[j][i]))
}

/// Returns R M Rᵀ, exactly symmetric.
pub(crate) fn turned(r: &M, m: M) -> M {
    let m = product(&product(r, &m), &transposed(r));
    core::array::from_fn(|i| core::array::from_fn(|j| 0.5 * (m[i][j] + m[j][i])))
}

fn scaled<const N: usize>(v: [f64; N], by: f64) -> [f64; N] {
    v.map(|x| x * by)
}

/// A part of a body: mass, centre of mass, tensor about it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lump {
    pub(crate) mass: f64,
    pub(crate) center: V,
    pub(crate) tensor: M,
}

/// A torque, given by its numbers.
#[derive(Clone, Debug)]
pub(crate) enum Push {
    Body(V),
    Space(V),
    Gravity(V),
    Drag(DragLaw, M),
    Magnet(V, V),
    Spring(f64, [f64; 4]),
    Wire(f64, [f64; 4], V),
    Thruster(V, V),
    Sink(f64),
    Window(Box<Push>, [f64; 2]),
}

/// A body, its torques, its start, and a duration.
#[derive(Clone, Debug)]
pub(crate) struct Numbers {
    pub(crate) lumps: Vec<Lump>,
    pivot: Option<V>,
    attitude: [f64; 4],
    omega: V,
    pub(crate) pushes: Vec<Push>,
    /// Wheels: axis, angular momentum, and inertia and torque of the motor.
    wheels: Vec<(V, f64, [f64; 2])>,
    pub(crate) duration: f64,
}

/// Change of axes and units: new components are R times old ones, and new numbers are old ones
/// times the factor of the unit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Change {
    /// Rotations of the body axes and of the space axes.
    pub(crate) axes: [[f64; 4]; 2],
    pub(crate) length: f64,
    pub(crate) mass: f64,
    pub(crate) time: f64,
}

impl Change {
    pub(crate) const NONE: Self = Self { axes: [[1.0, 0.0, 0.0, 0.0]; 2], length: 1.0, mass: 1.0, time: 1.0 };

    fn matrices(&self) -> [M; 2] {
        self.axes.map(matrix)
    }

    /// Converts a state to the new axes and units.
    pub(crate) fn state(&self, state: &State) -> State {
        let [body, space] = self.axes.map(|q| Attitude::from_quaternion(q).unwrap().quaternion());
        let attitude =
            quaternion_product(space, quaternion_product(state.attitude.quaternion(), conjugate(body)));
        let omega = scaled(times(&self.matrices()[0], state.omega.to_array()), 1.0 / self.time);
        State {
            time: state.time * self.time,
            attitude: Attitude::from_quaternion(attitude).unwrap(),
            omega: AngularVelocity::from_array(omega),
        }
    }
}

const fn conjugate([w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [w, -x, -y, -z]
}

fn quaternion_product([a, b, c, d]: [f64; 4], [w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

impl Push {
    fn random(random: &mut Random, is_held: bool, duration: f64) -> Self {
        let push = match random.below(if is_held { 10 } else { 9 }) {
            0 => Self::Body(random.vector(0.6)),
            1 => Self::Space(random.vector(0.6)),
            2 => Self::Drag(DragLaw::Linear, random.symmetric([0.01, 0.4])),
            3 => Self::Drag(DragLaw::Quadratic, random.symmetric([0.01, 0.2])),
            4 => Self::Magnet(random.vector(1.5), random.vector(0.7)),
            5 => Self::Spring(random.between(0.2, 2.5), random.quaternion()),
            6 => Self::Wire(random.between(0.2, 2.5), random.quaternion(), random.vector(1.0)),
            7 => Self::Thruster(random.vector(0.6), random.vector(0.9)),
            8 => Self::Sink(random.between(0.001, 0.02)),
            _ => Self::Gravity(random.vector(6.0)),
        };
        if random.next() < 0.25 && !matches!(push, Self::Sink(_)) {
            let from = random.between(0.0, 0.6) * duration;
            return Self::Window(Box::new(push), [from, from + random.between(0.1, 0.5) * duration]);
        }
        push
    }

    /// True for a function of attitude and time alone.
    fn is_splittable(&self) -> bool {
        match self {
            Self::Drag(..) | Self::Sink(_) => false,
            Self::Window(push, _) => push.is_splittable(),
            _ => true,
        }
    }

    fn changed(&self, change: &Change) -> Self {
        let [body, space] = change.matrices();
        let Change { length, mass, time, axes } = *change;
        let torque = mass * length * length / (time * time);
        let rest = |rest: [f64; 4]| quaternion_product(axes[1], quaternion_product(rest, conjugate(axes[0])));
        let matrix = |m: M, by: f64| turned(&body, m).map(|row| scaled(row, by));
        match *self {
            Self::Body(n) => Self::Body(scaled(times(&body, n), torque)),
            Self::Space(n) => Self::Space(scaled(times(&space, n), torque)),
            Self::Gravity(g) => Self::Gravity(scaled(times(&space, g), length / (time * time))),
            Self::Drag(DragLaw::Linear, m) => Self::Drag(DragLaw::Linear, matrix(m, torque * time)),
            Self::Drag(law, m) => Self::Drag(law, matrix(m, torque * time * time)),
            Self::Magnet(m, b) => Self::Magnet(scaled(times(&body, m), torque), times(&space, b)),
            Self::Spring(k, q) => Self::Spring(k * torque, rest(q)),
            Self::Wire(k, q, n) => Self::Wire(k * torque, rest(q), times(&space, n)),
            Self::Thruster(r, f) => {
                Self::Thruster(scaled(times(&body, r), length), scaled(times(&body, f), torque / length))
            }
            Self::Sink(alpha) => Self::Sink(alpha / (torque * time)),
            Self::Window(ref push, span) => Self::Window(Box::new(push.changed(change)), scaled(span, time)),
        }
    }

    fn torque(&self) -> TorqueModel {
        let rest = |q| Attitude::from_quaternion(q).unwrap();
        match *self {
            Self::Body(n) => TorqueModel::Constant(ConstantTorque::Body(Torque::from_array(n))),
            Self::Space(n) => TorqueModel::Constant(ConstantTorque::Space(Torque::from_array(n))),
            Self::Gravity(g) => {
                TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::from_array(g) })
            }
            Self::Drag(law, m) => TorqueModel::Drag(Drag::new(law, m).unwrap()),
            Self::Magnet(moment, field) => {
                let field = MagneticField::Uniform(Direction::from_array(field));
                TorqueModel::Magnetic(Box::new(Magnetic { moment: Direction::from_array(moment), field }))
            }
            Self::Spring(k, q) => TorqueModel::Torsion(Torsion::spring(k, rest(q)).unwrap()),
            Self::Wire(k, q, n) => {
                TorqueModel::Torsion(Torsion::wire(k, rest(q), Direction::from_array(n)).unwrap())
            }
            Self::Thruster(r, f) => TorqueModel::Thruster(Thruster {
                position: Position::from_array(r),
                force: Force::from_array(f),
            }),
            Self::Sink(alpha) => TorqueModel::EnergySink(EnergySink::new(alpha).unwrap()),
            Self::Window(ref push, [from, to]) => TorqueModel::Scheduled(Box::new(Scheduled {
                torque: push.torque(),
                schedule: Schedule::window(from, to).unwrap(),
            })),
        }
    }
}

impl Numbers {
    /// Returns a body of 3 to 5 parts that turns by a few radians in its duration, under up to 4
    /// torques.
    pub(crate) fn random(random: &mut Random) -> Self {
        let lump = |random: &mut Random| {
            // Moments of a tensor with positive second moments.
            let seconds = random.symmetric([0.02, 0.3]);
            let mass = random.between(0.4, 3.0);
            let trace: f64 = (0..3).map(|k| seconds[k][k]).sum();
            let tensor = core::array::from_fn(|i| {
                core::array::from_fn(|j| mass * (if i == j { trace } else { 0.0 } - seconds[i][j]))
            });
            Lump { mass, center: random.vector(0.5), tensor }
        };
        let count = 3 + random.below(3);
        let lumps = (0..count).map(|_| lump(random)).collect();
        let duration = random.between(2.0, 9.0);
        let pivot = (random.next() < 0.4).then(|| random.vector(0.6));
        let count = random.below(5);
        let pushes = (0..count).map(|_| Push::random(random, pivot.is_some(), duration)).collect();
        let wheel = |random: &mut Random| {
            let motor = [random.between(0.05, 0.3), random.between(-0.1, 0.1)];
            (random.vector(1.0), random.between(-0.8, 0.8), motor)
        };
        let count = if random.next() < 0.2 { 1 } else { 0 };
        let wheels = (0..count).map(|_| wheel(random)).collect();
        let size = random.between(0.1, 2.0);
        Self {
            lumps,
            pivot,
            attitude: random.quaternion(),
            omega: random.vector(size),
            pushes,
            wheels,
            duration,
        }
    }

    /// True if splitting can compute the motion.
    pub(crate) fn is_splittable(&self) -> bool {
        self.wheels.is_empty() && self.pushes.iter().all(Push::is_splittable)
    }

    /// Returns the scenario in other axes and units.
    pub(crate) fn changed(&self, change: &Change) -> Self {
        let [body, _] = change.matrices();
        let Change { length, mass, time, .. } = *change;
        let inertia = mass * length * length;
        let place = |v: V| scaled(times(&body, v), length);
        let lump = |lump: &Lump| Lump {
            mass: lump.mass * mass,
            center: place(lump.center),
            tensor: turned(&body, lump.tensor).map(|row| scaled(row, inertia)),
        };
        let start = change.state(&self.start());
        let wheel = |&(axis, momentum, [moment, torque]): &(V, f64, [f64; 2])| {
            let motor = [moment * inertia, torque * inertia / (time * time)];
            (times(&body, axis), momentum * inertia / time, motor)
        };
        Self {
            lumps: self.lumps.iter().map(lump).collect(),
            pivot: self.pivot.map(place),
            attitude: start.attitude.quaternion(),
            omega: start.omega.to_array(),
            pushes: self.pushes.iter().map(|push| push.changed(change)).collect(),
            wheels: self.wheels.iter().map(wheel).collect(),
            duration: self.duration * time,
        }
    }

    pub(crate) fn body(&self) -> MassProperties<Body> {
        let part = |lump: &Lump| {
            let inertia = InertiaTensor::from_matrix(lump.tensor).unwrap();
            MassProperties::new(lump.mass, Position::from_array(lump.center), inertia).unwrap()
        };
        MassProperties::combined(&self.lumps.iter().map(part).collect::<Vec<_>>()).unwrap()
    }

    pub(crate) fn rotor(&self) -> Rotor {
        let body = self.body();
        let rotor = match self.pivot {
            None => Rotor::free(&body),
            Some(pivot) => Rotor::pivoted(&body, Position::from_array(pivot)),
        };
        let wheel = |&(axis, momentum, [inertia, torque]): &(V, f64, [f64; 2])| {
            let motor = Motor::Torque { inertia, torque, schedule: None };
            Wheel::new(Direction::from_array(axis), momentum, motor).unwrap()
        };
        rotor.with_wheels(&self.wheels.iter().map(wheel).collect::<Vec<_>>()).unwrap()
    }

    pub(crate) fn torques(&self) -> Vec<TorqueModel> {
        self.pushes.iter().map(Push::torque).collect()
    }

    pub(crate) fn start(&self) -> State {
        State {
            time: 0.0,
            attitude: Attitude::from_quaternion(self.attitude).unwrap(),
            omega: AngularVelocity::from_array(self.omega),
        }
    }
}
