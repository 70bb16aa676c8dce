//! Correct motions, noise, few digits and other starts: no cause must be reported.

use polhode::infer::judge::{Cause, Scheme, TriedStart, Untried};
use polhode::prelude::*;

use super::methods::is_scheme;
use super::program::*;
use super::scene::*;

/// Returns reproducible numbers between −1 and 1.
pub(super) fn noise(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

fn changed(log: &[(f64, Q, V)], mut q: impl FnMut(f64) -> f64) -> Vec<(f64, Q, V)> {
    log.iter().map(|&(t, p, w)| (t, p.map(&mut q), w.map(&mut q))).collect()
}

/// Returns the motion computed by polhode.
fn own_log(scenario: &Scenario) -> Vec<(f64, Q, V)> {
    let times: Vec<f64> = (0..400).map(|k| 0.05 * f64::from(k)).collect();
    let (rotor, torques) = (scenario.rotor(), scenario.torques());
    let run = Trajectory::compute(rotor, torques, scenario.start(), &times, Method::Taylor, 1e-13).unwrap();
    let row = |sample: &Sample| {
        let State { time, attitude, omega } = sample.state;
        (time, attitude.quaternion(), omega.to_array())
    };
    run.samples().iter().map(row).collect()
}

#[test]
fn rows_of_few_digits() {
    for scenario in [free(), driven()] {
        let log = own_log(&scenario);
        let single = changed(&log, |x| f64::from(x as f32));
        require_named(&scenario, &single, 0.005, |c| *c == Cause::RoundedRows(None));
        let written = changed(&log, |x| format!("{}", x as f32).parse().unwrap());
        require_named(&scenario, &written, 0.005, |c| *c == Cause::RoundedRows(None));
        let short = changed(&log, |x| (x * 1e5).round() / 1e5);
        require_named(&scenario, &short, 0.005, |c| *c == Cause::RoundedRows(Some(5)));
    }
}

#[test]
fn steps_in_single_precision() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        let h = 0.005;
        let single = |x: f64| f64::from(x as f32);
        let log = run(start(), h, 10, 400, |t, q, w| {
            let (q, w) = rk4(t, q, w, h, &|_, q, w| (turning(q, w), right.acceleration(q, w)));
            (q.map(single), w.map(single))
        });
        require_named(&scenario, &log, h, |c| *c == Cause::SinglePrecisionArithmetic);
    }
}

#[test]
fn noise_is_no_mistake() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        for size in [1e-6, 1e-3, 0.1] {
            let mut seed = 12_345;
            let noisy = changed(&right.log(), |x| x + size * noise(&mut seed));
            require_not_accused(&scenario, &noisy, 0.005);
        }
    }
}

#[test]
fn another_start() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        let (q, w) = start();
        let h = 0.005;
        let from = |start: (Q, V), right: Equations| {
            run(start, h, 10, 400, |t, q, w| {
                rk4(t, q, w, h, &|_, q, w| (turning(q, w), right.acceleration(q, w)))
            })
        };
        let turned = (hamilton(q, exponential([0.02, -0.03, 0.01])), w);
        require_named(&scenario, &from(turned, right), h, |c| matches!(c, Cause::OtherStart { .. }));
        require_named(&scenario, &from((q, to_body(q, w)), right), h, |c| *c == Cause::StartOmegaAlongSpace);
        // Another ω: known from the log; otherwise no cause is reported.
        let faster = from((q, [0.71, -1.08, 1.57]), right);
        let said = found(&scenario, &faster, true, None);
        assert!(
            matches!(said.likeliest().unwrap().cause, Cause::OtherStart { .. }),
            "{:?}",
            said.likeliest()
        );
        let said = found(&scenario, &faster, false, None);
        assert!(said.mistake().is_none(), "{:?}", said.likeliest());
        // Another start, and a mistake in addition.
        let turned = hamilton(q, exponential([0.2, -0.3, 0.1]));
        let both = from((turned, [0.71, -1.08, 1.57]), Equations { gyroscopic: 0.0, ..right });
        let said = found(&scenario, &both, true, None);
        assert_eq!(said.likeliest().unwrap().cause, Cause::NoGyroscopicTerm);
        assert_eq!(said.start, TriedStart::FirstRow);
    }
}

/// Returns a log of Fehlberg's pair with adaptive steps, at a tolerance as loose as in some
/// programs.
fn adaptive_log(right: Equations, tolerance: f64) -> Vec<(f64, Q, V)> {
    let slope = |_: f64, q: Q, w: V| (turning(q, w), right.acceleration(q, w));
    let (mut q, mut w) = start();
    let mut log = vec![(0.0, q, w)];
    for k in 0..400 {
        let (row, mut t, mut h) = (0.05 * f64::from(k + 1), 0.05 * f64::from(k), 0.05_f64);
        while row - t > 1e-12 {
            h = h.min(row - t);
            let one = rk4(t, q, w, h, &slope);
            let half = rk4(t, q, w, 0.5 * h, &slope);
            let two = rk4(t + 0.5 * h, half.0, half.1, 0.5 * h, &slope);
            let error = norm(add(one.1, two.1, -1.0));
            if error < tolerance {
                (q, w) = two;
                t += h;
            }
            h *= if error < 0.1 * tolerance { 1.5 } else { 0.7 };
        }
        log.push((row, q, w));
    }
    log
}

/// Half a kick of L, rotations about the principal axes forward and backward, half a kick; along
/// body axes.
fn split_log(right: Equations, each: usize, h: f64, order: [usize; 5]) -> Vec<(f64, Q, V)> {
    let (moments, axes) = (body().principal().moments(), body().principal().axes().map(Direction::to_array));
    let inertia = right.tensor;
    run(start(), h, each, 300, |_, q, w| {
        let mut l = add(times(&inertia, w), (right.torque)(q), 0.5 * h);
        let mut q = q;
        for (place, axis) in order.into_iter().enumerate() {
            let along = times(&[axes[axis], axes[axis], axes[axis]], l)[0];
            let angle = along / moments[axis] * if place == 2 { h } else { 0.5 * h };
            let turn = exponential(axes[axis].map(|c| c * angle));
            q = hamilton(q, turn);
            l = to_body(turn, l);
        }
        let l = add(l, (right.torque)(q), 0.5 * h);
        (unit(q), times(&inverse(&inertia), l))
    })
}

#[test]
fn right_motions_are_not_accused() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        for tolerance in [1e-3, 1e-5, 1e-7, 1e-9] {
            require_not_accused(&scenario, &adaptive_log(right, tolerance), 0.05);
        }
        for h in [0.05, 0.01, 0.002] {
            require_not_accused(&scenario, &split_log(right, 5, h, [1, 2, 0, 2, 1]), h);
            require_named(&scenario, &split_log(right, 5, h, [0, 1, 2, 1, 0]), h, |c| {
                is_scheme(c, Scheme::Splitting, h)
            });
        }
        let log = own_log(&scenario);
        let said = found(&scenario, &log, true, None);
        assert_eq!((said.untried, said.tried.len()), (Some(Untried::Exact), 0));
    }
}

#[test]
fn rows_of_other_times() {
    let mut log = right_driven().log();
    let shifted: Vec<_> = log.iter().skip(1).map(|&(t, q, w)| (t - 0.03, q, w)).collect();
    log.truncate(1);
    log.extend(shifted);
    require_named(
        &driven(),
        &log,
        0.005,
        |c| matches!(c, Cause::TimeShift { shift } if (shift - 0.03).abs() < 1e-4),
    );
}
