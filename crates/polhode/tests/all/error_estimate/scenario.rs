//! Random scenarios, each as the library's input and as the equations of its true motion.

use polhode::motion::torque::{
    Attracted, ConstantTorque, Drag, DragLaw, GravityGradient, Schedule, Scheduled,
};
use polhode::motion::{Motor, Orbit, Wheel};
use polhode::prelude::*;

use super::double::Double;
use super::reference::{Polynomial, Polynomials, System, cross, image, scaled, sum, variables};

/// Random numbers from a seed.
pub(super) struct Random(u64);

impl Random {
    pub(super) const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Returns a uniform number from 0 to 1 (SplitMix64).
    pub(super) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(super) fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }

    fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.unit()
    }

    pub(super) fn log(&mut self, a: f64, b: f64) -> f64 {
        self.between(a.ln(), b.ln()).exp()
    }

    fn vector(&mut self, size: f64) -> [f64; 3] {
        loop {
            let v = [0; 3].map(|_| self.between(-1.0, 1.0));
            let norm = v[0].hypot(v[1]).hypot(v[2]);
            if norm > 0.1 && norm < 1.0 {
                return v.map(|x| x * size / norm);
            }
        }
    }

    pub(super) fn attitude(&mut self) -> Attitude {
        loop {
            let q = [0; 4].map(|_| self.between(-1.0, 1.0));
            if let (true, Ok(attitude)) =
                (q.iter().map(|x| x * x).sum::<f64>() < 1.0, Attitude::from_quaternion(q))
            {
                return attitude;
            }
        }
    }

    /// Returns a tensor about the centre of mass: distinct moments, two nearly equal, or all three.
    pub(super) fn inertia(&mut self) -> InertiaTensor<Body> {
        let near = self.log(1e-9, 1e-2);
        let [a, b, c] = [0; 3].map(|_| self.between(0.15, 1.5));
        let [a, b, c] = match self.below(4) {
            0 => [a, a * (1.0 + near), c],
            1 => [a, a * (1.0 + near), a * (1.0 - 0.7 * near)],
            _ => [a, b, c],
        };
        // second moments are given, so that the tensor is physical
        let moments = [b + c, a + c, a + b];
        let rows = self.attitude().matrix();
        let of = |i: usize, j: usize| (0..3).map(|k| rows[i][k] * rows[j][k] * moments[k]).sum::<f64>();
        InertiaTensor::with_negative_products([of(0, 0), of(1, 1), of(2, 2)], [of(0, 1), of(0, 2), of(1, 2)])
            .unwrap()
    }
}

/// Torque of the true motion: its times, and its value along body axes.
struct Acting {
    window: [f64; 2],
    own: Own,
}

enum Own {
    Body([f64; 3]),
    /// Vector fixed in space, and the arm of the force if it is one.
    Space([f64; 3], Option<[Double; 3]>),
    Damping([[f64; 3]; 3]),
    Gradient {
        rate: f64,
        radial: [f64; 3],
        along: [f64; 3],
    },
}

/// A random scenario.
pub(super) struct RandomScenario {
    pub(super) rotor: Rotor,
    pub(super) torques: Vec<TorqueModel>,
    pub(super) start: State,
    pub(super) end: f64,
    acting: Vec<Acting>,
    inertia: [[Double; 3]; 3],
    /// Angular momentum of the wheels, body axes.
    wheels: [Double; 3],
}

/// A true state.
pub(super) struct True {
    attitude: [Double; 4],
    omega: [Double; 3],
}

const OMEGA: usize = 1;
const TURN: usize = 4;
const VECTORS: usize = 8;

impl RandomScenario {
    /// Creates a random scenario; `most` is the largest number of turns of the body, the smallest
    /// is some hundredths.
    pub(super) fn new(random: &mut Random, most: f64) -> Self {
        let tensor = random.inertia();
        let mass = random.log(0.3, 3.0);
        let omega = random.vector(1.0).map(|x| x * 1.3);
        let omega = if random.below(4) == 0 { omega.map(|x| 20.0 * x) } else { omega };
        let speed = omega[0].hypot(omega[1]).hypot(omega[2]);
        let end = 2.0 * std::f64::consts::PI / speed * random.log(0.01, most);
        let is_held = random.below(3) == 0;
        let [center, pivot] = [0.4, 0.3].map(|size| random.vector(size));
        let body = MassProperties::new(mass, Position::from_array(center), tensor).unwrap();
        let rotor =
            if is_held { Rotor::pivoted(&body, Position::from_array(pivot)) } else { Rotor::free(&body) };
        let lever: [Double; 3] = std::array::from_fn(|k| {
            if is_held { Double::of(center[k]) - Double::of(pivot[k]) } else { Double::ZERO }
        });
        // I + m (l·l 1 − l lᵀ)
        let square = lever.iter().fold(Double::ZERO, |sum, l| sum + *l * *l);
        let rows = tensor.matrix();
        let inertia = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let diagonal = if i == j { square } else { Double::ZERO };
                Double::of(rows[i][j]) + Double::of(mass) * (diagonal - lever[i] * lever[j])
            })
        });
        let start =
            State { time: 0.0, attitude: random.attitude(), omega: AngularVelocity::from_array(omega) };
        let mut scenario = Self {
            rotor,
            torques: Vec::new(),
            start,
            end,
            acting: Vec::new(),
            inertia,
            wheels: [Double::ZERO; 3],
        };
        let size = speed * speed;
        if random.below(5) == 0 {
            let (axis, momentum) = (random.vector(1.0), random.between(-1.5, 1.5) * speed);
            scenario.wheels = normalised(axis.map(Double::of)).map(|x| x * Double::of(momentum));
            let wheel = Wheel::new(Direction::from_array(axis), momentum, Motor::HeldSpeed).unwrap();
            scenario.rotor = scenario.rotor.with_wheels(&[wheel]).unwrap();
        }
        if is_held {
            let strength = random.log(0.1, 10.0) * size;
            let g = random.vector(strength);
            let torque = TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::from_array(g) });
            let pull = lever.map(|l| l * Double::of(mass));
            scenario.act(&torque, Own::Space(g, Some(pull)), None);
        }
        for _ in 0..random.below(3) + usize::from(!is_held) {
            let strength = random.log(0.003, 0.5) * size;
            let v = random.vector(strength);
            let (torque, own) = match random.below(4) {
                0 => (TorqueModel::Constant(ConstantTorque::Body(Torque::from_array(v))), Own::Body(v)),
                1 => {
                    (TorqueModel::Constant(ConstantTorque::Space(Torque::from_array(v))), Own::Space(v, None))
                }
                2 => {
                    let damping =
                        random.inertia().matrix().map(|row| row.map(|x| x * 0.1 * strength / speed));
                    (TorqueModel::Drag(Drag::new(DragLaw::Linear, damping).unwrap()), Own::Damping(damping))
                }
                _ => scenario.gradient(random, speed),
            };
            let window = (random.below(3) == 0).then(|| {
                let from = random.between(-0.2, 0.7) * end;
                [from, from + random.between(0.1, 0.8) * end]
            });
            scenario.act(&torque, own, window);
        }
        scenario
    }

    /// Creates a free body with a diagonal tensor, one element of which is changed by a number.
    pub(super) fn of_diagonal(moments: [f64; 3], omega: [f64; 3], end: f64, off: ([usize; 2], f64)) -> Self {
        let body =
            MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal(moments).unwrap()).unwrap();
        let start =
            State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::from_array(omega) };
        let ([j, k], by) = off;
        let inertia = std::array::from_fn(|r| {
            std::array::from_fn(|c| {
                let element = if r == c { Double::of(moments[r]) } else { Double::ZERO };
                if [r, c] == [j, k] || [r, c] == [k, j] { element + Double::of(by) } else { element }
            })
        });
        let (torques, acting, wheels) = (Vec::new(), Vec::new(), [Double::ZERO; 3]);
        Self { rotor: Rotor::free(&body), torques, start, end, acting, inertia, wheels }
    }

    /// Returns the scenario without torques and wheels, with exactly the tensor of the rotor.
    pub(super) fn free(mut self) -> Self {
        self.rotor = self.rotor.clone().with_wheels(&[]).unwrap();
        self.inertia = self.rotor.inertia().matrix().map(|row| row.map(Double::of));
        self.torques.clear();
        self.acting.clear();
        self.wheels = [Double::ZERO; 3];
        self
    }

    fn act(&mut self, torque: &TorqueModel, own: Own, window: Option<[f64; 2]>) {
        let scheduled = |[from, until]: [f64; 2]| {
            let schedule = Schedule::window(from, until).unwrap();
            TorqueModel::Scheduled(Box::new(Scheduled { torque: torque.clone(), schedule }))
        };
        self.torques.push(window.map_or_else(|| torque.clone(), scheduled));
        let window = window.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        self.acting.push(Acting { window, own });
    }

    fn gradient(&self, random: &mut Random, speed: f64) -> (TorqueModel, Own) {
        let rate = speed * random.log(0.05, 0.7);
        let [radial, along] = [0; 2].map(|_| random.vector(1.0));
        let [toward, motion] = [radial, along].map(Direction::from_array);
        let orbit = Orbit::circular_at_rate(self.rotor.mass(), rate, toward, motion).unwrap();
        let gradient = GravityGradient { orbit, attracted: Attracted::Tensor };
        (TorqueModel::GravityGradient(Box::new(gradient)), Own::Gradient { rate, radial, along })
    }

    /// Returns the true states at times.
    pub(super) fn truth(&self, times: &[f64]) -> Vec<True> {
        let attitude = normalised(self.start.attitude.quaternion().map(Double::of));
        let mut y = vec![Double::of(1.0)];
        y.extend(self.start.omega.to_array().map(Double::of));
        y.extend(attitude);
        for acting in &self.acting {
            let vectors: Vec<[Double; 3]> = match &acting.own {
                Own::Space(v, _) => vec![v.map(Double::of)],
                Own::Gradient { radial, along, .. } => orthonormal(*radial, *along).to_vec(),
                Own::Body(_) | Own::Damping(_) => Vec::new(),
            };
            y.extend(vectors.into_iter().flat_map(|v| in_body(attitude, v)));
        }
        let changes = self.acting.iter().flat_map(|acting| acting.window);
        let mut stops: Vec<f64> =
            changes.chain(times.iter().copied()).filter(|t| *t > 0.0 && *t <= self.end).collect();
        stops.sort_by(f64::total_cmp);
        stops.dedup();
        let (mut now, mut states) = (0.0, Vec::new());
        let known = |y: &[Double]| {
            let omega = std::array::from_fn(|k| y[OMEGA + k]);
            True { attitude: normalised(std::array::from_fn(|k| y[TURN + k])), omega }
        };
        for stop in stops {
            self.system(now).advance(&mut y, now, stop);
            now = stop;
            if times.contains(&now) {
                states.push(known(&y));
            }
        }
        states
    }

    /// Returns the equations from a time until a torque begins or ends.
    fn system(&self, time: f64) -> System {
        let omega = variables(OMEGA);
        let wheels = self.wheels.map(Polynomial::constant);
        let mut torque = cross(&sum(&image(&self.inertia, &omega), &wheels), &omega);
        let mut vectors: Vec<Polynomial> = Vec::new();
        for Acting { window: [from, until], own, .. } in &self.acting {
            let first = VECTORS + vectors.len();
            let own: Polynomials = match own {
                Own::Body(v) => v.map(|x| Polynomial::constant(Double::of(x))),
                Own::Space(_, arm) => {
                    let v = variables(first);
                    vectors.extend(cross(&v, &omega));
                    arm.map_or_else(|| v.clone(), |arm| cross(&arm.map(Polynomial::constant), &v))
                }
                Own::Damping(c) => {
                    scaled(&image(&c.map(|row| row.map(Double::of)), &omega), Double::of(-1.0))
                }
                Own::Gradient { rate, .. } => {
                    let (n, [radial, along]) = (Double::of(*rate), [variables(first), variables(first + 3)]);
                    vectors.extend(sum(&cross(&radial, &omega), &scaled(&along, n)));
                    vectors.extend(sum(&cross(&along, &omega), &scaled(&radial, -n)));
                    // 3 n² r × I r
                    scaled(&cross(&radial, &image(&self.inertia, &radial)), Double::of(3.0) * n * n)
                }
            };
            if *from <= time && time < *until {
                torque = sum(&torque, &own);
            }
        }
        let acceleration = image(&inverse(&self.inertia), &torque);
        System::new(&[acceleration.to_vec(), turning().to_vec(), vectors].concat())
    }
}

/// q̇ = ½ q ∘ ω
fn turning() -> [Polynomial; 4] {
    let half = Double::of(0.5);
    let term = |q: usize, w: usize, sign: f64| {
        let [q, w] = [Polynomial::variable(TURN + q), Polynomial::variable(OMEGA + w)];
        q.product(&w).times(half * Double::of(sign))
    };
    let of = |terms: [(usize, usize, f64); 3]| {
        terms.into_iter().fold(Polynomial::default(), |sum, (q, w, sign)| sum.plus(&term(q, w, sign)))
    };
    [
        of([(1, 0, -1.0), (2, 1, -1.0), (3, 2, -1.0)]),
        of([(0, 0, 1.0), (2, 2, 1.0), (3, 1, -1.0)]),
        of([(0, 1, 1.0), (3, 0, 1.0), (1, 2, -1.0)]),
        of([(0, 2, 1.0), (1, 1, 1.0), (2, 0, -1.0)]),
    ]
}

impl True {
    /// Returns (θ, ω) minus (θ, ω) of a nearby state, θ along body axes.
    pub(super) fn beyond(&self, other: &Self) -> [f64; 6] {
        let ([a, b, c, d], [w, x, y, z]) = (other.attitude, self.attitude);
        // the vector part of conj(other) ∘ self is half of θ
        let half =
            [a * x - b * w - c * z + d * y, a * y + b * z - c * w - d * x, a * z - b * y + c * x - d * w];
        std::array::from_fn(
            |k| if k < 3 { 2.0 * half[k].0 } else { (self.omega[k - 3] - other.omega[k - 3]).0 },
        )
    }
    /// Returns the angle to an attitude, rad, and |Δω|/|ω|.
    pub(super) fn off(&self, state: &State) -> [f64; 2] {
        let q = normalised(state.attitude.quaternion().map(Double::of));
        let dot = q.iter().zip(self.attitude).fold(Double::ZERO, |sum, (a, b)| sum + *a * b);
        let sign = Double::of(dot.0.signum());
        let square = q.iter().zip(self.attitude).map(|(a, b)| (*a * sign - b).0.powi(2)).sum::<f64>();
        let omega = state.omega.to_array();
        let delta = (0..3).map(|k| (Double::of(omega[k]) - self.omega[k]).0.powi(2)).sum::<f64>().sqrt();
        // the distance of unit quaternions is 2 sin(θ/4)
        [
            4.0 * (0.5 * square.sqrt()).min(1.0).asin(),
            delta / self.omega.map(|w| w.0).iter().fold(0.0, |s: f64, w| s.hypot(*w)),
        ]
    }
}

fn normalised<const N: usize>(v: [Double; N]) -> [Double; N] {
    let norm = v.iter().fold(Double::ZERO, |sum, x| sum + *x * *x).sqrt();
    v.map(|x| x / norm)
}

/// Returns two orthonormal directions, the first along a.
fn orthonormal(a: [f64; 3], b: [f64; 3]) -> [[Double; 3]; 2] {
    let (a, b) = (normalised(a.map(Double::of)), b.map(Double::of));
    let dot = (0..3).fold(Double::ZERO, |sum, k| sum + a[k] * b[k]);
    [a, normalised(std::array::from_fn(|k| b[k] - a[k] * dot))]
}

/// Returns Rᵀ v.
fn in_body([w, x, y, z]: [Double; 4], v: [Double; 3]) -> [Double; 3] {
    let two = Double::of(2.0);
    // v + 2 u × (u × v) − 2 w u × v
    let u = [x, y, z];
    let cross = |a: [Double; 3], b: [Double; 3]| {
        std::array::from_fn(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            a[i] * b[j] - a[j] * b[i]
        })
    };
    let once: [Double; 3] = cross(u, v);
    let twice: [Double; 3] = cross(u, once);
    std::array::from_fn(|k| v[k] + two * (twice[k] - w * once[k]))
}

fn inverse(m: &[[Double; 3]; 3]) -> [[Double; 3]; 3] {
    let cofactor = |i: usize, j: usize| {
        let [a, b] = [(i + 1) % 3, (i + 2) % 3];
        let [c, d] = [(j + 1) % 3, (j + 2) % 3];
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    let determinant = (0..3).fold(Double::ZERO, |sum, k| sum + m[0][k] * cofactor(0, k));
    std::array::from_fn(|i| std::array::from_fn(|j| cofactor(j, i) / determinant))
}
