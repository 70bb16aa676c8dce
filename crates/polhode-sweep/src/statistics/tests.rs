#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use super::*;
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
    Plan::parse(text, "plan.toml".as_ref()).unwrap_or_else(|error| panic!("{error}"))
}

/// Of a normal and a uniform distribution, in 400 sweeps.
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
    // 380 expected of the first, some more of the others, whose ranks are whole numbers; standard deviation 4.4.
    assert!((363..=397).contains(&mean), "{mean}");
    assert!((363..400).contains(&median) && (363..400).contains(&tail), "{median} {tail}");
}
