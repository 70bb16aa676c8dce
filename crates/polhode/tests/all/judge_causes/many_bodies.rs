//! Bodies of many shapes, including nearly symmetric ones and rotations near an axis.

use polhode::infer::judge::{Cause, Scheme, Turn};
use polhode::prelude::*;

use super::methods::is_scheme;
use super::program::*;
use super::right_motions::noise;
use super::scene::*;

/// Returns a free body, its tensor and its start.
fn body_of(seed: &mut u64) -> (Scenario, M, (Q, V)) {
    let mut random = || noise(seed);
    let q = unit([random(), random(), random(), random()]);
    let spread = if random() > 0.3 { 0.05 } else { 1.0 };
    let second = [1.0 + 0.9 * spread * random(), 1.0 + 0.9 * spread * random(), 1.0 + 0.9 * random()];
    let [a, b, c] = second;
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|e| to_space(q, e));
    let diagonal = [[b + c, 0.0, 0.0], [0.0, c + a, 0.0], [0.0, 0.0, a + b]];
    // The columns of `axes`ᵀ are the principal axes.
    let tensor = product(&transposed(&axes), &product(&diagonal, &axes));
    let along = if random() > 0.3 { 0.1 } else { 1.0 };
    let w = to_space(q, [along * random(), along * random(), 1.0 + random()].map(|c| 2.0 * c));
    let attitude = unit([random(), random(), random(), random()]);
    let symmetric = [0, 1, 2].map(|k| [0, 1, 2].map(|l| 0.5 * (tensor[k][l] + tensor[l][k])));
    let inertia = InertiaTensor::from_matrix(symmetric).unwrap();
    let body = MassProperties::new(MASS, Position::from_array(CENTER), inertia).unwrap();
    let start = State {
        time: 0.0,
        attitude: Attitude::from_quaternion(attitude).unwrap(),
        omega: AngularVelocity::from_array(w),
    };
    (Scenario::new(body).starting(start).unwrap(), symmetric, (attitude, w))
}

#[test]
fn bodies_of_many_shapes() {
    let mut seed = 97;
    let (mut named, mut planted) = (0, 0);
    for _ in 0..16 {
        let (scenario, tensor, start) = body_of(&mut seed);
        let right = Equations { tensor, ..RIGHT };
        let slope = |e: Equations| move |_: f64, q: Q, w: V| (turning(q, w), e.acceleration(q, w));
        for h in [0.05, 0.01] {
            let log = run(start, h, 5, 200, |t, q, w| rk4(t, q, w, h, &slope(right)));
            require_not_accused(&scenario, &log, h);
            let log = run(start, h, 5, 200, |_, q, w| {
                let at = |s: f64, (dq, dw): (Q, V)| ([0, 1, 2, 3].map(|k| q[k] + s * dq[k]), add(w, dw, s));
                let middle = at(0.5 * h, slope(right)(0.0, q, w));
                let (q, w) = at(h, slope(right)(0.0, middle.0, middle.1));
                (unit(q), w)
            });
            require_not_accused(&scenario, &log, h);
            let noisy: Vec<_> =
                log.iter().map(|&(t, q, w)| (t, q.map(|c| c + 0.03 * noise(&mut seed)), w)).collect();
            require_not_accused(&scenario, &noisy, h);
        }
        let h = 0.01;
        let euler = run(start, h, 3, 200, |_, q, w| {
            let w = add(w, right.acceleration(q, w), h);
            (hamilton(q, exponential(w.map(|c| c * h))), w)
        });
        let without = Equations { gyroscopic: 0.0, ..right };
        let without = run(start, h, 3, 200, |t, q, w| rk4(t, q, w, h, &slope(without)));
        for step in [Some(h), None] {
            let cause = |log| found(&scenario, log, true, step).likeliest().map(|tried| tried.cause.clone());
            planted += 2;
            let (euler, without) = (cause(&euler), cause(&without));
            named += u32::from(
                euler.is_some_and(|c| is_scheme(&c, Scheme::SemiImplicitEuler(Turn::Exponential), h)),
            );
            named += u32::from(without == Some(Cause::NoGyroscopicTerm));
        }
    }
    assert_eq!(named, planted);
}
