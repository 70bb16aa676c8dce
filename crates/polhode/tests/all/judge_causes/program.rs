//! An independent program for rigid bodies, right or wrong: plain arrays and its own steps.

pub(super) type V = [f64; 3];
pub(super) type Q = [f64; 4];
pub(super) type M = [[f64; 3]; 3];

pub(super) fn add(a: V, b: V, s: f64) -> V {
    [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]]
}

pub(super) fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn norm(a: V) -> f64 {
    (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt()
}

pub(super) fn times(m: &M, v: V) -> V {
    m.map(|r| r[0] * v[0] + r[1] * v[1] + r[2] * v[2])
}

pub(super) fn transposed(m: &M) -> M {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| m[j][i]))
}

pub(super) fn product(a: &M, b: &M) -> M {
    let b = transposed(b);
    a.map(|row| times(&b, row))
}

pub(super) fn inverse(m: &M) -> M {
    let [a, b, c] = *m;
    let columns = [cross(b, c), cross(c, a), cross(a, b)];
    let det = a[0] * columns[0][0] + a[1] * columns[0][1] + a[2] * columns[0][2];
    transposed(&columns.map(|v| v.map(|x| x / det)))
}

/// Returns the quaternion product p q.
pub(super) fn hamilton(p: Q, q: Q) -> Q {
    let ([a, b, c, d], [w, x, y, z]) = (p, q);
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

pub(super) fn unit(q: Q) -> Q {
    let n = q.iter().map(|c| c * c).sum::<f64>().sqrt();
    q.map(|c| c / n)
}

/// Returns `R_space_body` v.
pub(super) fn to_space([w, x, y, z]: Q, v: V) -> V {
    let [_, a, b, c] = hamilton(hamilton([w, x, y, z], [0.0, v[0], v[1], v[2]]), [w, -x, -y, -z]);
    [a, b, c]
}

/// Returns Rᵀ v.
pub(super) fn to_body([w, x, y, z]: Q, v: V) -> V {
    to_space([w, -x, -y, -z], v)
}

/// Returns the rotation by the angle |r| about r.
pub(super) fn exponential(r: V) -> Q {
    let half = 0.5 * norm(r);
    let s = if half == 0.0 { 0.5 } else { half.sin() / (2.0 * half) };
    [half.cos(), s * r[0], s * r[1], s * r[2]]
}

/// Returns q + ½ q ω h, normalised.
pub(super) fn first_order(q: Q, w: V, h: f64) -> Q {
    let d = hamilton(q, [0.0, w[0], w[1], w[2]]);
    unit([0, 1, 2, 3].map(|k| q[k] + 0.5 * h * d[k]))
}

/// Runs with step h. Every `each`-th step is a row; there are `rows` rows in addition to the start.
pub(super) fn run(
    start: (Q, V),
    h: f64,
    each: usize,
    rows: usize,
    step: impl Fn(f64, Q, V) -> (Q, V),
) -> Vec<(f64, Q, V)> {
    let (mut q, mut w) = start;
    let mut log = vec![(0.0, q, w)];
    for k in 0..each * rows {
        (q, w) = step(k as f64 * h, q, w);
        if (k + 1) % each == 0 {
            log.push(((k + 1) as f64 * h, q, w));
        }
    }
    log
}

/// Performs one step of RK4 for q̇ and ω̇.
pub(super) fn rk4(t: f64, q: Q, w: V, h: f64, slope: &impl Fn(f64, Q, V) -> (Q, V)) -> (Q, V) {
    let at = |s: f64, (dq, dw): (Q, V)| ([0, 1, 2, 3].map(|k| q[k] + s * dq[k]), add(w, dw, s));
    let go = |t: f64, (q, w): (Q, V)| slope(t, q, w);
    let a = go(t, (q, w));
    let b = go(t + 0.5 * h, at(0.5 * h, a));
    let c = go(t + 0.5 * h, at(0.5 * h, b));
    let d = go(t + h, at(h, c));
    let q = [0, 1, 2, 3].map(|k| q[k] + h / 6.0 * (a.0[k] + 2.0 * b.0[k] + 2.0 * c.0[k] + d.0[k]));
    let w = [0, 1, 2].map(|k| w[k] + h / 6.0 * (a.1[k] + 2.0 * b.1[k] + 2.0 * c.1[k] + d.1[k]));
    (unit(q), w)
}

/// Returns ½ q ω.
pub(super) fn turning(q: Q, w: V) -> Q {
    hamilton(q, [0.0, w[0], w[1], w[2]]).map(|c| 0.5 * c)
}
