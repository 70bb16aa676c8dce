//! Cost of calls of free motion in Rust. `benches/python/calls.py` has the same calls in Python.
//!
//! Each line: name of the call, minimum time of many runs, unit.

use std::hint::black_box;
use std::time::{Duration, Instant};

use polhode::prelude::*;

const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];

/// Returns the minimum time of many short runs, ns.
fn least(mut work: impl FnMut()) -> f64 {
    let mut least = Duration::MAX;
    let begin = Instant::now();
    while begin.elapsed() < Duration::from_millis(300) {
        let start = Instant::now();
        work();
        least = least.min(start.elapsed());
    }
    least.as_secs_f64() * 1e9
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let omega = AngularVelocity::from_array([0.3, 0.5, 0.9]);
    let start = State { time: 0.0, attitude: Attitude::identity(), omega };
    let motion = FreeMotion::of_moments(MOMENTS, start)?;
    let set_up = least(|| {
        for _ in 0..100 {
            black_box(FreeMotion::of_moments(black_box(MOMENTS), start).ok());
        }
    });
    println!("construction\t{:.1}\tns", set_up / 100.0);
    let one = least(|| {
        for _ in 0..1000 {
            black_box(motion.at(black_box(3.7)));
        }
    });
    println!("one state\t{:.1}\tns", one / 1000.0);
    for count in [1_000_u32, 10_000, 100_000, 1_000_000] {
        let times: Vec<f64> = (0..count).map(|k| 1e3 * f64::from(k) / f64::from(count - 1)).collect();
        let mut states = motion.at_times(&times);
        let each = f64::from(count);
        println!("{count} states, filled\t{:.2}\tns", least(|| motion.fill(&times, &mut states)) / each);
        let fresh = least(|| {
            black_box(motion.at_times(black_box(&times)));
        });
        println!("{count} states, fresh\t{:.2}\tns", fresh / each);
        let mut others = states.clone();
        let two = least(|| {
            std::thread::scope(|scope| {
                scope.spawn(|| motion.fill(&times, &mut states));
                motion.fill(&times, &mut others);
            });
        });
        println!("{count} states, filled by each of two threads\t{:.2}\tns", two / each);
    }
    Ok(())
}
