//! Cost of rolling bodies: `cargo bench -p polhode --bench rolling`; numbers of `book/contact.md`.

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use polhode::math::Rotation;
use polhode::motion::Energy;
use polhode::motion::channel::ENERGY;
use polhode::motion::contact::{BodySurface, Contact, ContactStart, SurfaceShape};
use polhode::prelude::*;

/// Returns the minimum time of many runs, s.
fn least(mut work: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    let begin = Instant::now();
    while begin.elapsed().as_secs_f64() < 1.0 {
        let start = Instant::now();
        work();
        least = least.min(start.elapsed().as_secs_f64());
    }
    least
}

fn main() -> Result<(), Box<dyn Error>> {
    // body of `examples/rattleback.toml`
    let inertia = InertiaTensor::from_matrix([[2e-4, -2e-5, 0.0], [-2e-5, 1.6e-3, 0.0], [0.0, 0.0, 1.7e-3]])?;
    let body = MassProperties::new(1.0, Position::ZERO, inertia)?;
    let shape = SurfaceShape::Ellipsoid { semi_axes: [0.2, 0.03, 0.02] };
    let surface = BodySurface::new(shape, Position::new(0.0, 0.0, 0.01), Rotation::identity())?;
    let contact = Contact::rolling(surface);
    let attitude = Attitude::from_roll_pitch_yaw([0.5_f64, -0.5, 0.0].map(f64::to_radians))?;
    let omega = attitude.inverse() * AngularVelocity::<Space>::new(0.0, 0.0, -5.0);
    let start = ContactStart::rolling(State { time: 0.0, attitude, omega });
    println!("a rattleback of 20 s\tms\tsteps\trounds\tenergy drift");
    for (samples, tolerance) in [(1, 1e-10), (1, 1e-13), (1, 1e-15), (2001, 1e-13)] {
        let times: Vec<f64> = (1..=samples).map(|k| 20.0 * f64::from(k) / f64::from(samples)).collect();
        let simulation = Simulation::on_ground(&body, &contact, start, &times).tolerance(tolerance);
        let run = simulation.run()?;
        let energies = run.channel(ENERGY).ok_or("every system has energy")?;
        let total = |energy: Energy| energy.kinetic + energy.potential.unwrap_or_default();
        let drift = energies.last().map_or(f64::NAN, |last| total(last) / total(energies.start()) - 1.0);
        let statistics = run.solution().statistics().unwrap_or_default();
        let time = least(|| drop(black_box(simulation.run().ok())));
        println!(
            "{samples} samples, {tolerance:.0e}\t{:.2}\t{}\t{}\t{drift:.1e}",
            time * 1e3,
            statistics.accepted,
            statistics.evaluations / 16
        );
    }
    Ok(())
}
