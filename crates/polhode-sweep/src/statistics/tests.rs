#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use super::*;
use polhode_source::files::Disk;

use crate::rows::inputs;

fn plan(seed: u32) -> Plan {
    let text = format!(
        r#"
[[body.part]]
shape = "sphere"
radius = "1 m"
mass = "1 kg"
[sweep]
members = 200
sampling = "monte carlo"
seed = {seed}
[[sweep.vary]]
key = "start.spin.body[0]"
normal = {{ mean = 0.3, sd = 0.9 }}
[[sweep.vary]]
key = "start.spin.body[2]"
uniform = {{ from = -2, to = 3 }}
[start]
spin = {{ body = [0, 0, 0] }}
"#
    );
    Plan::parse(&Disk, text, "plan.toml".as_ref()).unwrap_or_else(|error| panic!("{error}"))
}

/// Coverage of intervals for a normal and a uniform distribution, in 400 sweeps.
#[test]
fn intervals_hold_the_truth_as_often_as_they_say() {
    let (mut mean, mut median, mut tail) = (0, 0, 0);
    for seed in 0..400 {
        let plan = plan(seed);
        let read = |part: u64| Ok(inputs(&plan, 50 * part..50 * (part + 1)));
        let (summary, sample) = of(&plan, 4, 1, &read).unwrap();
        assert_eq!((sample.rows(), summary.inputs.len()), (200, 2));
        let holds = |[low, high]: [f64; 2], truth: f64| u32::from(low <= truth && truth <= high);
        let (normal, uniform) = (&summary.inputs[0], &summary.inputs[1]);
        mean += holds(normal.mean_interval.unwrap(), 0.3);
        let quantile = |k: usize| uniform.quantiles[k].interval.map(Option::unwrap);
        median += holds(quantile(3), 0.5);
        tail += holds(quantile(5), 2.75);
    }
    // 380 are expected for the mean, slightly more for quantiles, whose ranks are integers;
    // standard deviation 4.4.
    assert!((363..=397).contains(&mean), "{mean}");
    assert!((363..400).contains(&median) && (363..400).contains(&tail), "{median} {tail}");
}

/// Returns a plan with known truth: z is uniform on −2 … 3, and the probability of each question is
/// known.
fn asked(sampling: &str, replicates: u64, seed: u32) -> Plan {
    let text = format!(
        r#"
[[body.part]]
shape = "box"
size = [1, 2, 3]
mass = "1 kg"
[sweep]
members = 320
sampling = "{sampling}"
seed = {seed}
{}
[sweep.questions]
fast = "start_spin_body_z_rad_s > 1.8 rad/s"
none = "sqrt(-1 - start_attitude_w^2) < 2 or start_spin_body_z_rad_s > 0"
both = "start_spin_body_z_rad_s > 0 and start_spin_body_x_rad_s > 0.3 rad/s"
[[sweep.vary]]
key = "start.spin.body[0]"
normal = {{ mean = 0.3, sd = 0.9 }}
[[sweep.vary]]
key = "start.spin.body[2]"
uniform = {{ from = -2, to = 3 }}
[[sweep.vary]]
key = "start.attitude"
random = {{ sd = "10 deg" }}
[start]
spin = {{ body = [0, 0, 0] }}
attitude = {{ roll_pitch_yaw = [0.3, -0.4, 0.5] }}
"#,
        if replicates > 1 { format!("replicates = {replicates}") } else { String::new() }
    );
    Plan::parse(&Disk, text, "plan.toml".as_ref()).unwrap_or_else(|error| panic!("{error}"))
}

/// Coverage for probabilities and means, in 100 sweeps of each kind, with sets and with independent
/// members.
#[test]
fn probabilities_are_where_their_intervals_say() {
    for (sampling, replicates) in [("monte carlo", 1), ("latin hypercube", 16), ("sobol", 16)] {
        let mut held = [0_u32; 3];
        for seed in 0..100 {
            let plan = asked(sampling, replicates, seed);
            let read = |part: u64| Ok(inputs(&plan, 80 * part..80 * (part + 1)));
            let (summary, _) = of(&plan, 4, 1, &read).unwrap();
            let holds = |[low, high]: [f64; 2], truth: f64| u32::from(low <= truth && truth <= high);
            let [fast, none, both] = summary.questions.as_slice() else { panic!("three questions") };
            // A condition that is NaN has no answer.
            assert_eq!((none.of, none.share, none.interval), (0, None, None));
            held[0] += holds(fast.interval.unwrap(), 0.24);
            held[1] += holds(both.interval.unwrap(), 0.3);
            // The components of the rotations have mean 0; their mean angle is not compared here.
            let turned = summary.inputs.iter().find(|s| s.name == "start_attitude_from_mean_y_rad").unwrap();
            held[2] += u32::from(turned.mean.unwrap().abs() < 0.05);
            let last = fast.convergence.last().unwrap();
            assert_eq!((last.members, Some(last.share)), (320, fast.share));
            assert_eq!(fast.of, 320);
        }
        // 95 or slightly more are expected; standard deviation 2.2.
        assert!(held[..2].iter().all(|held| (88..=100).contains(held)), "{sampling}: {held:?}");
        assert_eq!(held[2], 100, "{sampling}");
    }
}

#[test]
fn a_single_set_and_a_grid_have_answers_without_intervals() {
    let plan = asked("sobol", 1, 0);
    let read = |part: u64| Ok(inputs(&plan, 80 * part..80 * (part + 1)));
    let (summary, sample) = of(&plan, 4, 3, &read).unwrap();
    let fast = &summary.questions[0];
    assert!(fast.interval.is_none() && (fast.share.unwrap() - 0.24).abs() < 0.01);
    assert_eq!((sample.answers.len(), sample.answers[0].len()), (3, 320));
    // Results do not depend on threads, and the mean attitude is close to that in the plan.
    let (again, _) = of(&plan, 4, 1, &read).unwrap();
    assert_eq!(summary, again);
    let mean = polhode::math::Attitude::from_quaternion(summary.attitudes[0].mean).unwrap();
    let written = plan.nominal().start().attitude;
    assert!(mean.angle_to(written) < 0.02, "{}", mean.angle_to(written));
    let angles = summary.inputs.iter().find(|s| s.name == "start_attitude_from_mean_rad").unwrap();
    // Mean length of a normal vector: σ √(8/π).
    let expected = 10_f64.to_radians() * (8.0 / std::f64::consts::PI).sqrt();
    assert!((angles.mean.unwrap() / expected - 1.0).abs() < 0.05);
    assert!(!summary.inputs.iter().any(|s| s.name == "start_attitude_w"));
}
