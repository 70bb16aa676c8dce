//! Cost of heavy tops and swinging bodies: closed form and Taylor's method. `cargo bench -p polhode
//! --bench tops`; table of `book/tops.md`.

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use polhode::motion::ClosedForm;
use polhode::prelude::*;

/// Returns the minimum time of many short runs, s.
fn least(mut work: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    let begin = Instant::now();
    while begin.elapsed().as_secs_f64() < 0.3 {
        let start = Instant::now();
        work();
        least = least.min(start.elapsed().as_secs_f64());
    }
    least
}

fn main() -> Result<(), Box<dyn Error>> {
    let inertia = InertiaTensor::diagonal([0.3125, 0.3125, 0.21875])?;
    let body = MassProperties::new(1.5, Position::new(0.0, 0.0, 0.375), inertia)?;
    let rotor = Rotor::pivoted(&body, Position::ZERO);
    let torques = [TorqueModel::Gravity(UniformGravity::STANDARD)];
    let times: Vec<f64> = (0..=2000).map(|k| f64::from(k) * 0.001).collect();
    println!(
        "motion\tset-up, µs\ta state, ns\tof many, ns\t2,001 states, µs\tTaylor, µs\t2,001 samples, µs\tTaylor, µs"
    );
    for (name, angles, omega) in [
        ("a fast top", [0.4, 0.7, -0.7], [0.3, -0.4, 31.5]),
        ("next to the separatrix", [0.4, 0.1, -0.7], [0.001, 0.0, 11.3]),
        ("loops", [0.4, 1.3, -0.7], [0.5, 0.2, 3.0]),
        ("a pendulum", [0.0, 0.7, 0.0], [0.9, 0.0, 0.0]),
    ] {
        let (attitude, omega) = (Attitude::from_euler313(angles)?, AngularVelocity::from_array(omega));
        let start = State { time: 0.0, attitude, omega };
        let motion = ClosedForm::of(&rotor, &torques, start)?;
        let made = least(|| {
            black_box(ClosedForm::of(&rotor, &torques, black_box(start)).ok());
        });
        let one = least(|| {
            for &t in &times {
                black_box(motion.at(black_box(t)));
            }
        });
        let many = least(|| drop(black_box(motion.at_times(black_box(&times)))));
        let [exact, taylor] = [Method::Exact, Method::Taylor].map(|method| {
            let simulation = Simulation::new(&rotor, &torques, start, &times).method(method);
            // The run with more memory is first: the allocator then keeps it.
            let samples = least(|| drop(black_box(simulation.run().ok())));
            [least(|| drop(black_box(simulation.states().ok()))), samples]
        });
        let (count, us) = (times.len() as f64, 1e6);
        println!(
            "{name}\t{:.0}\t{:.0}\t{:.0}\t{:.0}\t{:.0}\t{:.0}\t{:.0}",
            made * us,
            one / count * 1e9,
            many / count * 1e9,
            exact[0] * us,
            taylor[0] * us,
            exact[1] * us,
            taylor[1] * us,
        );
    }
    Ok(())
}
