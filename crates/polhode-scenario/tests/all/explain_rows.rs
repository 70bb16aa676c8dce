//! The table of step 5 does not alias with the motion. Zeros and angles of step 6 are those that
//! the attitude determines.

use std::f64::consts::{FRAC_PI_4, PI, TAU};

use polhode::math::{AngularVelocity, Attitude, Body, Direction};
use polhode::motion::torque::{TorqueModel, Torsion};
use polhode::motion::{FreeMotion, Scenario};
use polhode_document::Block;
use polhode_scenario::report::explain;

use crate::common::{pendulum, run, spinning, symmetric_top, tensor};

/// Returns the rows t, ωx, ωy, ωz of the last table of step 5; a table of modes may precede it.
fn rows(scenario: &Scenario) -> Vec<[f64; 4]> {
    let document = explain(scenario).unwrap();
    let table = document.sections[5].blocks.iter().rev().find_map(|block| match block {
        Block::Table { rows, .. } => Some(rows),
        _ => None,
    });
    let number = |cell: &String| cell.parse::<f64>().unwrap();
    let rows = table.unwrap().iter();
    rows.map(|row| [number(&row[0]), number(&row[1]), number(&row[2]), number(&row[3])]).collect()
}

fn text(scenario: &Scenario, section: usize) -> String {
    let mut document = explain(scenario).unwrap();
    document.sections = vec![document.sections[section].clone()];
    document.to_text(120)
}

fn near(got: f64, want: f64, size: f64) {
    assert!((got - want).abs() < 1e-5 * size, "{got} is not {want}");
}

#[test]
fn a_pendulum_is_shown_over_one_period() {
    // Rows at the samples of the run would alias with the period.
    for duration in [10.0, 100.0] {
        let scenario = pendulum().sampled(run(duration, 7));
        let axis = Direction::<Body>::new(0.0, 0.0, 1.0);
        let found = scenario.pendulum().unwrap().unwrap();
        let amplitude = found.angle().abs();
        let period = found.period(amplitude);
        let rows = rows(&scenario);
        assert_eq!(rows.len(), 9);
        // ½ I θ̇² = M g d (1 − cos θ): at the bottom |θ̇| = 2 ω0 sin ½θmax
        let most = 2.0 * found.small_frequency() * (0.5 * amplitude).sin();
        let sign = -(found.angle() * axis.z).signum();
        for (k, row) in rows.iter().enumerate() {
            near(row[0], period * k as f64 / 8.0, period);
        }
        for (k, want) in [(0, 0.0), (2, sign * most), (4, 0.0), (6, -sign * most), (8, 0.0)] {
            near(rows[k][3], want, most);
        }
        assert!(text(&scenario, 5).contains("one period of ω in the body"));
    }
}

#[test]
fn a_free_top_turns_forward_by_an_eighth_a_row() {
    for duration in [10.0, 1000.0] {
        let scenario = symmetric_top().sampled(run(duration, 201));
        let motion = FreeMotion::of(scenario.rotor(), scenario.start()).unwrap();
        let top = polhode::observe::SymmetricTop::of_motion(&motion).unwrap();
        let rows = rows(&scenario);
        assert_eq!(rows.len(), 9);
        let e = top.axis();
        let across = |row: &[f64; 4]| {
            let omega = Direction::<Body>::new(row[1], row[2], row[3]);
            omega - e * omega.dot(e)
        };
        for pair in rows.windows(2) {
            let (a, b) = (across(&pair[0]), across(&pair[1]));
            let turned = a.cross(b).dot(e).atan2(a.dot(b));
            near(turned, FRAC_PI_4 * top.body_rate().signum(), 1.0);
        }
        near(rows[8][0], TAU / top.body_rate().abs(), rows[8][0]);
    }
}

#[test]
fn without_a_period_a_turn_has_several_rows() {
    // Slowly rotating asymmetric body on a stiff torsion spring: ω oscillates much faster than the
    // body rotates.
    let body = tensor("spring", [0.31, 0.47, 0.58], [0.02, -0.03, 0.05], [0.0, 0.0, 0.02]);
    let torsion = Torsion::spring(40.0, Attitude::identity()).unwrap();
    for duration in [0.05, 60.0] {
        let scenario =
            body.clone().with_torques(vec![TorqueModel::Torsion(torsion)]).unwrap().sampled(run(duration, 7));
        let rows = rows(&scenario);
        assert_eq!(rows.len(), 9);
        // the fastest oscillation is below √(k/i1)
        let fastest = TAU / (40.0_f64 / 0.28).sqrt();
        let step = rows[1][0] - rows[0][0];
        assert!(step < fastest / 3.0, "{step} {fastest}");
        if duration < fastest {
            near(rows[8][0], duration, duration);
        }
    }
}

#[test]
fn noise_of_the_attitude_is_zero() {
    // half a turn about x and back: rounding of π leaves 6e-17 of the cosine
    let half = Attitude::from_axis_angle(Direction::new(1.0, 0.0, 0.0), PI).unwrap();
    let still = tensor("still", [0.3, 0.4, 0.5], [0.0; 3], [0.0; 3]);
    let at = |attitude: Attitude| crate::common::facing(still.clone(), attitude);
    let shown = text(&at(half), 6);
    assert!(!shown.contains("e-1"), "{shown}");
    assert!(shown.contains("w, x, y, z = 0, 1, 0, 0"), "{shown}");
    assert!(shown.contains("θ = π: only φ − ψ is determined, φ − ψ = 0 rad"), "{shown}");

    let about_z = Attitude::from_euler313([0.4, 0.0, 0.3]).unwrap();
    let shown = text(&at(about_z), 6);
    assert!(shown.contains("θ = 0: only φ + ψ is determined, φ + ψ = 0.7 rad"), "{shown}");
    let turned_over = Attitude::from_euler313([0.4, PI, 0.3]).unwrap();
    let shown = text(&at(turned_over), 6);
    assert!(shown.contains("θ = π: only φ − ψ is determined, φ − ψ = 0.1 rad"), "{shown}");
    let generic = Attitude::from_euler313([0.4, 0.9, -0.3]).unwrap();
    let shown = text(&at(generic), 6);
    assert!(shown.contains("φ, θ, ψ = 0.4, 0.9, -0.3 rad"), "{shown}");
}

#[test]
fn a_steady_turn_ends_without_noise() {
    // 3 turns about z in closed form: the final attitude is the initial one, except for rounding.
    let spun =
        spinning(tensor("spun", [0.3, 0.4, 0.5], [0.0; 3], [0.0; 3]), AngularVelocity::new(0.0, 0.0, TAU));
    let shown = text(&spun.sampled(run(3.0, 31)), 6);
    assert!(shown.contains("θ = 0: only φ + ψ is determined, φ + ψ = 0 rad"), "{shown}");
    assert!(shown.contains("w, x, y, z = 1, 0, 0, 0"), "{shown}");
}

#[test]
fn a_run_that_is_shorter_than_the_period_is_shown_whole() {
    // A wobble of 304.5 turns; the run covers a third of it.
    let body = tensor("Earth", [1.0, 1.0, 1.003_284_548_3], [0.0; 3], [1e-6, 0.0, 1.0]);
    let duration = 640.0;
    let scenario = body.sampled(run(duration, 11));
    let rows = rows(&scenario);
    for (k, row) in rows.iter().enumerate() {
        near(row[0], duration * k as f64 / 8.0, duration);
        // ω₁ = A cos Ωt with Ω = (i3 − i1) ω₃/i1
        near(row[1], 1e-6 * (0.003_284_548_3 * row[0]).cos(), 1e-6);
    }
    assert!(text(&scenario, 5).contains("the run in eighths (a period of ω in the body takes 1912"));
}
