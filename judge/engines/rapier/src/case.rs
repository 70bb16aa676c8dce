//! Cases of the suite, torques on their bodies, and runs. Matrices are rows; quaternions are
//! (w, x, y, z).

use serde_json::Value;
use std::{fmt::Write, fs, path::Path};

pub type V = [f64; 3];
pub type M = [V; 3];

pub fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Returns a x + b y.
pub fn sum(a: f64, x: V, b: f64, y: V) -> V {
    std::array::from_fn(|i| a * x[i] + b * y[i])
}

pub fn apply(m: M, v: V) -> V {
    m.map(|row| dot(row, v))
}

pub fn transposed(m: M) -> M {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
}

/// Returns R_space_body of a unit quaternion.
pub fn matrix([w, x, y, z]: [f64; 4]) -> M {
    [
        [w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
}

/// Returns the principal moments, and right-handed principal axes as rows, by Jacobi rotations.
pub fn principal(mut a: M) -> (V, M) {
    let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _ in 0..20 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let (sin, cos) = (0.5 * (2.0 * a[p][q]).atan2(a[q][q] - a[p][p])).sin_cos();
            let turn = |m: M| {
                let mut turned = m;
                turned[p] = sum(cos, m[p], -sin, m[q]);
                turned[q] = sum(sin, m[p], cos, m[q]);
                turned
            };
            a = turn(transposed(turn(a)));
            axes = turn(axes);
        }
    }
    ([a[0][0], a[1][1], a[2][2]], axes)
}

enum Torque {
    Body(V),
    Space(V),
    Damping(V),
    Gradient {
        strength: f64,
        rate: f64,
        radial: V,
        motion: V,
    },
    /// Wheel with its momentum along the axis at the start, and the motor's torque on the wheel.
    Wheel {
        axis: V,
        momentum: f64,
        motor: f64,
    },
    /// Torque with the components amplitude · sin(rate t + phase) in body axes.
    Swing([(f64, f64, f64); 3]),
}

pub struct Case {
    pub name: String,
    pub mass: f64,
    pub inertia: M,
    pub center_of_mass: V,
    pub attitude: [f64; 4],
    pub omega_body: V,
    /// Acceleration of gravity, space axes; the body is then held at its origin.
    pub gravity: Option<V>,
    pub duration: f64,
    pub rows_every: f64,
    torques: Vec<Torque>,
}

pub struct Row {
    pub time: f64,
    pub attitude: [f64; 4],
    pub omega_body: V,
}

fn number(v: &Value) -> Option<f64> {
    v.as_f64()
}

fn numbers<const N: usize>(v: &Value) -> Option<[f64; N]> {
    v.as_array()?.iter().map(number).collect::<Option<Vec<_>>>()?.try_into().ok()
}

/// Parses `a*sin(b*t)` or `a*cos(b*t)`.
fn swing(text: &str) -> Option<(f64, f64, f64)> {
    let (amplitude, rest) = text.split_once('*')?;
    let (phase, rest) = match rest.strip_prefix("sin(") {
        Some(rest) => (0.0, rest),
        None => (std::f64::consts::FRAC_PI_2, rest.strip_prefix("cos(")?),
    };
    Some((amplitude.parse().ok()?, rest.strip_suffix("*t)")?.parse().ok()?, phase))
}

impl Case {
    /// Reads a case; returns `None` if something is not as in the suite's format.
    pub fn read(v: &Value) -> Option<Case> {
        let rows = v["inertia_kg_m2"].as_array()?.iter().map(numbers).collect::<Option<Vec<V>>>()?;
        let mut case = Case {
            name: v["name"].as_str()?.into(),
            mass: number(&v["mass_kg"])?,
            inertia: rows.try_into().ok()?,
            center_of_mass: numbers(&v["center_of_mass_m"]).unwrap_or_default(),
            attitude: numbers(&v["attitude"])?,
            omega_body: numbers(&v["omega_body_rad_s"])?,
            gravity: None,
            duration: number(&v["duration_s"])?,
            rows_every: number(&v["rows_every_s"])?,
            torques: Vec::new(),
        };
        for t in v["torque"].as_array()? {
            let torque = match t["kind"].as_str()? {
                "gravity" => {
                    case.gravity = Some(numbers(&t["acceleration_m_s2"])?);
                    continue;
                }
                "constant-body" => Torque::Body(numbers(&t["torque_n_m"])?),
                "constant-space" => Torque::Space(numbers(&t["torque_n_m"])?),
                "damping" => Torque::Damping(numbers(&t["coefficient_n_m_s"])?),
                "gravity-gradient" => Torque::Gradient {
                    strength: 3.0 * number(&t["mu_m3_s2"])? / number(&t["radius_m"])?.powi(3),
                    rate: number(&t["rate_rad_s"])?,
                    radial: numbers(&t["radial"])?,
                    motion: numbers(&t["motion"])?,
                },
                "wheel" => case.wheel(t)?,
                "formula" if t["axes"] == "body" => {
                    let parts = t["torque_n_m"].as_array()?.iter().map(|f| swing(f.as_str()?));
                    Torque::Swing(parts.collect::<Option<Vec<_>>>()?.try_into().ok()?)
                }
                _ => return None,
            };
            case.torques.push(torque);
        }
        Some(case)
    }

    /// Reads a wheel. With a motor, the inertia of the body excludes the wheel's moment about its
    /// axis.
    fn wheel(&mut self, t: &Value) -> Option<Torque> {
        let (axis, moment, speed): (V, _, _) =
            (numbers(&t["axis"])?, number(&t["moment_kg_m2"])?, number(&t["speed_rad_s"])?);
        let Some(motor) = number(&t["motor_torque_n_m"]) else {
            return Some(Torque::Wheel { axis, momentum: moment * speed, motor: 0.0 });
        };
        for i in 0..3 {
            self.inertia[i] = sum(1.0, self.inertia[i], -moment * axis[i], axis);
        }
        Some(Torque::Wheel { axis, momentum: moment * (speed + dot(axis, self.omega_body)), motor })
    }

    /// Returns the torque in space axes, without gravity on a held body.
    pub fn torque_space(&self, t: f64, attitude: [f64; 4], omega_body: V) -> V {
        let r = matrix(attitude);
        self.torques.iter().fold([0.0; 3], |total, torque| {
            let body = match torque {
                Torque::Space(n) => return sum(1.0, total, 1.0, *n),
                Torque::Body(n) => *n,
                Torque::Damping(c) => std::array::from_fn(|i| -c[i] * omega_body[i]),
                Torque::Gradient { strength, rate, radial, motion } => {
                    let u = apply(transposed(r), sum((rate * t).cos(), *radial, (rate * t).sin(), *motion));
                    cross(u, apply(self.inertia, u)).map(|n| strength * n)
                }
                Torque::Wheel { axis, momentum, motor } => {
                    sum(-motor, *axis, -(momentum + motor * t), cross(omega_body, *axis))
                }
                Torque::Swing(parts) => parts.map(|(a, rate, phase)| a * (rate * t + phase).sin()),
            };
            sum(1.0, total, 1.0, apply(r, body))
        })
    }

    /// Returns the number of steps of the case, and the number of steps between rows.
    pub fn steps(&self, step: f64) -> (usize, usize) {
        ((self.duration / step).round() as usize, ((self.rows_every / step).round() as usize).max(1))
    }
}

pub fn write(path: &Path, engine: &str, step: f64, rows: &[Row]) -> std::io::Result<()> {
    let mut text = format!(
        "# engine = \"{engine}\"\n# step = {step:?}\ntime_s,attitude_w,attitude_x,attitude_y,attitude_z,omega_body_x_rad_s,omega_body_y_rad_s,omega_body_z_rad_s\n"
    );
    for Row { time, attitude: [w, x, y, z], omega_body: [a, b, c] } in rows {
        let _ = writeln!(text, "{time:?},{w:?},{x:?},{y:?},{z:?},{a:?},{b:?},{c:?}");
    }
    fs::write(path, text)
}
