//! A burning body that drops a part, integrated as an angular momentum in space: its rate is A
//! (N − D ω), and ω = I⁻¹ Aᵀ L.
//!
//! It uses arrays of numbers, assembles the parts at every time, and integrates the orbit as well.
//! It shares no formula with the library.

pub(super) type V = [f64; 3];
pub(super) type M = [V; 3];

pub(super) fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross([a, b, c]: V, [x, y, z]: V) -> V {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

pub(super) fn times(m: M, v: V) -> V {
    m.map(|row| dot(row, v))
}

pub(super) fn transposed(m: M) -> M {
    [0, 1, 2].map(|i| [m[0][i], m[1][i], m[2][i]])
}

/// Returns a + s b.
pub(super) fn plus(a: V, s: f64, b: V) -> V {
    [0, 1, 2].map(|k| a[k] + s * b[k])
}

/// Returns s (d² 1 − d dᵀ).
fn spread(s: f64, d: V) -> M {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| s * (if i == j { dot(d, d) } else { 0.0 } - d[i] * d[j])))
}

fn add(a: M, s: f64, b: M) -> M {
    [0, 1, 2].map(|i| plus(a[i], s, b[i]))
}

/// Solves by Cramer's rule.
fn solved(m: M, b: V) -> V {
    let [x, y, z] = transposed(m);
    let d = dot(x, cross(y, z));
    [dot(b, cross(y, z)) / d, dot(x, cross(b, z)) / d, dot(x, cross(y, b)) / d]
}

fn rotation(q: [f64; 4]) -> M {
    let n = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    let [w, x, y, z] = q.map(|c| c / n);
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

/// A part: mass, centre of mass, and tensor about it.
pub(super) type Part = (f64, V, M);

const HULL: Part =
    (1.7, [0.02, -0.05, 0.31], [[0.31, 0.012, -0.02], [0.012, 0.36, 0.03], [-0.02, 0.03, 0.14]]);
const BOOSTER: Part =
    (0.6, [-0.3, 0.2, 0.15], [[0.02, 0.001, -0.002], [0.001, 0.03, 0.004], [-0.002, 0.004, 0.025]]);
/// The charge, per kg.
const CHARGE: Part =
    (1.0, [0.13, 0.08, -0.22], [[0.021, 0.002, -0.001], [0.002, 0.034, 0.003], [-0.001, 0.003, 0.028]]);
/// Mass of the charge, initial value in kg and rate in kg/s.
pub(super) const BURN: [f64; 2] = [2.5, 0.1875];
/// Time at which the booster is dropped, and end time, s.
pub(super) const DROP: f64 = 2.5;
pub(super) const END: f64 = 6.0;
/// Exits: share, position, axis and radius.
pub(super) const EXITS: [(f64, V, V, f64); 2] =
    [(0.75, [0.05, 0.02, -0.9], [0.1, -0.2, 1.0], 0.3), (0.25, [-0.4, 0.3, 0.1], [1.0, 0.5, 0.0], 0.0)];

/// Returns mass, centre of mass and tensor about it.
pub(super) fn body(time: f64, with_booster: bool) -> Part {
    let charge = BURN[0] - BURN[1] * time;
    let all = [HULL, (charge, CHARGE.1, CHARGE.2.map(|row| row.map(|x| charge * x))), BOOSTER];
    let parts = &all[..if with_booster { 3 } else { 2 }];
    let mass: f64 = parts.iter().map(|part| part.0).sum();
    let center = parts.iter().fold([0.0; 3], |sum, part| plus(sum, part.0 / mass, part.1));
    let about =
        |sum: M, part: &Part| add(add(sum, 1.0, part.2), 1.0, spread(part.0, plus(part.1, -1.0, center)));
    (mass, center, parts.iter().fold([[0.0; 3]; 3], about))
}

/// Inputs of a torque, along body axes.
#[derive(Clone, Copy)]
pub(super) struct Now {
    pub(super) time: f64,
    pub(super) mass: f64,
    /// Point about which the body turns, and the vector from it to the centre of mass.
    pub(super) point: V,
    pub(super) lever: V,
    /// Tensor about that point.
    pub(super) tensor: M,
    pub(super) omega: V,
    /// Rotation from body to space.
    pub(super) attitude: M,
    pub(super) quaternion: [f64; 4],
    /// Vector from the attracting mass.
    pub(super) r: V,
}

pub(super) type Law = dyn Fn(&Now) -> V;

/// Motion of the burning body.
pub(super) struct Motion<'a> {
    pub(super) pivot: Option<V>,
    pub(super) law: &'a Law,
    pub(super) mu: f64,
}

type Y = [f64; 13];

impl Motion<'_> {
    fn now(&self, time: f64, y: &Y, with_booster: bool) -> Now {
        let [l0, l1, l2, q0, q1, q2, q3, x0, x1, x2, ..] = *y;
        let (mass, center, own) = body(time, with_booster);
        let point = self.pivot.unwrap_or(center);
        let lever = plus(center, -1.0, point);
        let tensor = add(own, 1.0, spread(mass, lever));
        let n = [q0, q1, q2, q3].iter().map(|x| x * x).sum::<f64>().sqrt();
        let quaternion = [q0, q1, q2, q3].map(|x| x / n);
        let attitude = rotation(quaternion);
        let omega = solved(tensor, times(transposed(attitude), [l0, l1, l2]));
        Now { time, mass, point, lever, tensor, omega, attitude, quaternion, r: [x0, x1, x2] }
    }

    fn slope(&self, time: f64, y: &Y, with_booster: bool) -> Y {
        let now = self.now(time, y, with_booster);
        let mut torque = (self.law)(&now);
        for (share, place, axis, radius) in EXITS {
            let (flow, arm) = (share * BURN[1], plus(place, -1.0, now.point));
            let n = axis.map(|x| x / dot(axis, axis).sqrt());
            let wide = plus(now.omega, dot(n, now.omega), n);
            torque = plus(torque, -flow, cross(arm, cross(now.omega, arm)));
            torque = plus(torque, -flow * 0.25 * radius * radius, wide);
        }
        let [l0, l1, l2] = times(now.attitude, torque);
        let [w, x, y_, z] = [y[3], y[4], y[5], y[6]];
        let [p, q, r] = now.omega.map(|w| 0.5 * w);
        let turning = [
            -(x * p + y_ * q + z * r),
            w * p + y_ * r - z * q,
            w * q + z * p - x * r,
            w * r + x * q - y_ * p,
        ];
        let [a0, a1, a2] = now.r.map(|x| -self.mu * x / dot(now.r, now.r).powf(1.5));
        let [q0, q1, q2, q3] = turning;
        [l0, l1, l2, q0, q1, q2, q3, y[10], y[11], y[12], a0, a1, a2]
    }

    /// Integrates from ω and the attitude at t = 0, and position and velocity on the orbit. Returns
    /// ω and the attitude at the end. The motion has corners at `corners` only.
    pub(super) fn end(&self, omega: V, attitude: [f64; 4], orbit: [V; 2], corners: &[f64]) -> (V, [f64; 4]) {
        let norm = attitude.iter().map(|x| x * x).sum::<f64>().sqrt();
        let [q0, q1, q2, q3] = attitude.map(|x| x / norm);
        let [[x0, x1, x2], [v0, v1, v2]] = orbit;
        let mut y = [0.0, 0.0, 0.0, q0, q1, q2, q3, x0, x1, x2, v0, v1, v2];
        let now = self.now(0.0, &y, true);
        y[..3].copy_from_slice(&times(now.attitude, times(now.tensor, omega)));
        let mut ends: Vec<f64> = corners.iter().copied().chain([DROP, END]).collect();
        ends.sort_by(f64::total_cmp);
        let (mut from, mut carried) = (0.0, [0.0; 13]);
        for end in ends {
            if end <= from {
                continue;
            }
            let with_booster = end <= DROP;
            let steps = ((end - from) / 0.06).ceil();
            let h = (end - from) / steps;
            for k in 0..steps as u32 {
                let more = self.increment(from + f64::from(k) * h, &y, h, with_booster);
                // Carries the rounding error of one sum to the next.
                for ((y, carried), more) in y.iter_mut().zip(&mut carried).zip(more) {
                    let (old, more) = (*y, more + *carried);
                    *y += more;
                    *carried = more - (*y - old);
                }
            }
            if end == DROP {
                // The remaining part keeps its ω.
                let omega = self.now(end, &y, true).omega;
                let left = self.now(end, &y, false);
                y[..3].copy_from_slice(&times(left.attitude, times(left.tensor, omega)));
                carried[..3].fill(0.0);
            }
            from = end;
        }
        let now = self.now(END, &y, false);
        (now.omega, now.quaternion)
    }

    /// Computes an increment by Gragg's midpoint rule with Bulirsch–Stoer extrapolation.
    /// Extrapolating differences loses fewer digits than extrapolating values. The torque at the
    /// ends of a step is the one-sided limit from inside, as there may be a corner.
    fn increment(&self, from: f64, y: &Y, h: f64, with_booster: bool) -> Y {
        const COLUMNS: usize = 8;
        let at = |a: &Y, s: f64, b: &Y| -> Y { std::array::from_fn(|k| a[k] + s * b[k]) };
        let slope = |since: f64, more: &Y| {
            let inside = since.clamp(1e-13 * h, h * (1.0 - 1e-13));
            self.slope(from + inside, &at(y, 1.0, more), with_booster)
        };
        let mut table: Vec<Y> = Vec::new();
        for column in 0..COLUMNS {
            let n = 2 * (column + 1);
            let s = h / n as f64;
            let (mut before, mut now) = ([0.0; 13], slope(0.0, &[0.0; 13]).map(|rate| s * rate));
            for i in 1..n {
                let next = at(&before, 2.0 * s, &slope(i as f64 * s, &now));
                (before, now) = (now, next);
            }
            let last = slope(h, &now);
            let mut row: Vec<Y> = vec![std::array::from_fn(|k| 0.5 * (before[k] + now[k] + s * last[k]))];
            for j in 1..=column {
                let ratio = n as f64 / (2 * (column - j + 1)) as f64;
                let (better, old) = (row[j - 1], table[j - 1]);
                row.push(std::array::from_fn(|k| better[k] + (better[k] - old[k]) / (ratio * ratio - 1.0)));
            }
            table = row;
        }
        table[COLUMNS - 1]
    }
}
