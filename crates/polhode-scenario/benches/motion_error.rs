//! Time of the error estimate of a motion, relative to the time of the motion itself.
//!
//! `cargo bench -p polhode-scenario --bench motion_error` prints one line per motion: its name, its
//! time, ms, and the times of the two estimates relative to it.

use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use polhode::motion::ErrorEffort;
use polhode_scenario::read as scenario;

const BODY: &str = "[[body.part]]\nshape = 'tensor'\nmass = '2.3 kg'\ncenter_of_mass = [0.02, -0.03, 0.11]
inertia = [[0.31, 0.02, -0.03], [0.02, 0.45, 0.05], [-0.03, 0.05, 0.52]]\n[start]\nspin = { body = [0.3, -1.5, 0.9] }\n";
const GRADIENT: &str = "[orbit]\nrate = '0.5 rad/s'\nmu = '4e10 m^3/s^2'
[[torque]]\nmodel = 'gravity_gradient'\n";
const DRAG: &str = "[[torque]]\nmodel = 'drag'\nlaw = 'quadratic'\ncoefficient = '2e-3 N m s^2'\n";
fn least<T>(mut work: impl FnMut() -> T) -> f64 {
    let (mut least, begin) = (f64::INFINITY, Instant::now());
    while begin.elapsed().as_secs_f64() < 1.0 {
        let start = Instant::now();
        black_box(work());
        least = least.min(start.elapsed().as_secs_f64());
    }
    least
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("{:32} {:>10} {:>8} {:>8}", "motion of 1,000 s", "own, ms", "cheap", "thorough");
    let cases = [
        ("free, Taylor", "", "method = 'taylor'"),
        ("gravity gradient, Taylor", GRADIENT, "method = 'taylor'"),
        ("quadratic drag, Taylor", DRAG, "method = 'taylor'"),
        ("gravity gradient, DOP853", GRADIENT, "method = 'dop853'"),
        ("quadratic drag, DOP853", DRAG, "method = 'dop853'"),
        ("gravity gradient, splitting", GRADIENT, "method = 'splitting'\nstep = '10 ms'"),
        ("free, closed form", "", ""),
    ];
    for (what, torque, method) in cases {
        let text = format!("{BODY}{torque}[run]\nduration = '1000 s'\nsamples = 2001\n{method}\n");
        let scenario = scenario::parse(&text, Path::new("bench.toml"))?;
        let timed = |effort: Option<ErrorEffort>| {
            least(|| match effort {
                None => scenario.simulate(),
                Some(effort) => scenario.simulate_with_error(effort, &mut |_| true),
            })
        };
        let (own, cheap, thorough) =
            (timed(None), timed(Some(ErrorEffort::Cheap)), timed(Some(ErrorEffort::Thorough)));
        println!("{what:32} {:10.3} {:8.2} {:8.1}", 1e3 * own, (cheap - own) / own, (thorough - own) / own);
    }
    Ok(())
}
