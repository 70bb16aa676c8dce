//! Cost of free motion. `cargo bench -p polhode --bench free_motion`. `benches/speed.py` runs it
//! together with another library and with narrower vectors, and writes the page `book/speed.md`.
//!
//! Each line: name, minimum time of many runs, unit.

use std::hint::black_box;
use std::time::Instant;

use polhode::motion::{FreeMotionDerivatives, FreeMotions};
use polhode::prelude::*;

/// Returns the minimum time of many short runs, ns per item: the speed of the undisturbed machine.
fn least(items: usize, mut work: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    let begin = Instant::now();
    while begin.elapsed().as_secs_f64() < 0.25 {
        let start = Instant::now();
        work();
        least = least.min(start.elapsed().as_secs_f64());
    }
    least / items as f64 * 1e9
}

fn state(omega: [f64; 3]) -> State {
    State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::from_array(omega) }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let moments = [1.0, 2.0, 3.0];
    for (name, omega) in [
        ("generic", [0.3, 0.5, 0.9]),
        ("long-axis mode", [1.0, 0.2, 0.1]),
        ("near the separatrix", [1e-6, 1.0, 1e-6]),
    ] {
        let motion = FreeMotion::of_moments(moments, state(omega))?;
        let times: Vec<f64> = (0..1024).map(|k| f64::from(k) * 0.977 + 0.1).collect();
        let mut states = motion.at_times(&times);
        let one = least(times.len(), || {
            for (&t, s) in times.iter().zip(&mut states) {
                *s = motion.at(black_box(t));
            }
        });
        println!("{name}: one state\t{one:.1}\tns");
        let body = Rotor::free(&MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal(moments)?)?);
        let derivatives = FreeMotionDerivatives::of(&body, state(omega))?;
        let mut found = derivatives.at_times(&times);
        let with_derivatives = least(times.len(), || {
            for (&t, s) in times.iter().zip(&mut found) {
                *s = derivatives.at(black_box(t));
            }
        });
        println!("{name}: one state with its derivatives\t{with_derivatives:.1}\tns");
        println!("{name}: derivatives, in states\t{:.2}\t", with_derivatives / one);
        let many = least(times.len(), || motion.fill(black_box(&times), black_box(&mut states)));
        println!("{name}: a state of many times\t{many:.1}\tns");
        for count in [64, 1024] {
            let scaled = |k: usize| state(omega.map(|w| w * (1.0 + 1e-4 * k as f64)));
            let bodies: Vec<_> =
                (0..count).map(|k| FreeMotion::of_moments(moments, scaled(k))).collect::<Result<_, _>>()?;
            let all = FreeMotions::of(&bodies);
            let fleet = least(16 * count, || {
                for k in 0..16 {
                    all.fill(black_box(1234.5 + f64::from(k)), black_box(&mut states));
                }
            });
            println!("{name}: a state of {count} bodies\t{fleet:.1}\tns");
        }
        let setup = least(1, || {
            black_box(FreeMotion::of_moments(black_box(moments), state(black_box(omega))).ok());
        });
        println!("{name}: set-up\t{setup:.0}\tns");
    }
    let seconds: Vec<f64> = (0..=1000).map(f64::from).collect();
    let table = least(1, || {
        let motion = FreeMotion::of_moments(black_box(moments), state(black_box([0.3, 0.5, 0.9])));
        black_box(motion.map(|motion| motion.at_times(&seconds)).ok());
    });
    println!("table of 1,000 s at 1,001 times\t{table:.0}\tns");
    let motion = FreeMotion::of_moments(moments, state([0.3, 0.5, 0.9]))?;
    let last = motion.at(1000.0);
    println!("at 1,000 s\t{:?}\tquaternion", last.attitude.quaternion());
    Ok(())
}
