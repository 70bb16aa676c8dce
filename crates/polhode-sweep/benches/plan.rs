//! Cost of a member without its motion: drawing of its values, and construction of its scenario.

#![allow(clippy::unwrap_used, reason = "a measurement may")]

use std::time::Instant;

use polhode_source::files::Disk;
use polhode_sweep::Plan;

const SCENARIO: &str = r#"
title = "debris"
[[body.part]]
shape = "tensor"
mass = "3.2 kg"
inertia = [[1.1, 0.13, -0.21], [0.13, 1.7, 0.08], [-0.21, 0.08, 2.3]]
[start]
attitude = { axis = [1, -2, 3], angle = "50 deg" }
spin = { body = ["0.3 rad/s", "-1.2 rad/s", "40 deg/s"] }
[run]
duration = "20 s"
samples = 11
[sweep]
members = 1_000_000
"#;

const START: &str = r#"
[[sweep.vary]]
key = "start.attitude"
random = "uniform"
[[sweep.vary]]
key = "start.spin.body"
direction = "uniform"
magnitude = { log_normal = { median = "2 deg/s", sigma = 0.7 } }
"#;

const BODY: &str = r#"
[[sweep.vary]]
key = "body"
dispersion = "10 %"
"#;

fn main() {
    for (what, sampling, vary) in [
        ("start, monte carlo", "monte carlo", START.to_owned()),
        ("start and body, monte carlo", "monte carlo", format!("{START}{BODY}")),
        ("start and body, latin hypercube", "latin hypercube", format!("{START}{BODY}")),
        ("start and body, sobol", "sobol", format!("{START}{BODY}")),
    ] {
        let text = format!("{SCENARIO}sampling = \"{sampling}\"\n{vary}");
        let plan = Plan::parse(&Disk, text, "bench.toml".as_ref()).unwrap();
        const MEMBERS: u64 = 100_000;
        let begin = Instant::now();
        let values: Vec<_> = (0..MEMBERS).map(|member| plan.values(member)).collect();
        let drawn = begin.elapsed();
        let begin = Instant::now();
        let sum: f64 = values.iter().map(|values| plan.scenario(values).unwrap().start().omega.norm()).sum();
        let read = begin.elapsed();
        let each = |time: std::time::Duration| time.as_secs_f64() * 1e6 / MEMBERS as f64;
        println!("{what:32} values {:.2} µs, scenario {:.2} µs  ({sum:.3})", each(drawn), each(read));
    }
}
