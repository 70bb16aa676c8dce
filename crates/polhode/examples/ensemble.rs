//! A thousand identical satellites with different angular velocities after separation: how far
//! apart they point after one orbit.
//!
//! `cargo run --release -p polhode --example ensemble`

use std::error::Error;
use std::num::NonZero;
use std::thread::available_parallelism;

use polhode::motion::torque::{Attracted, GravityGradient};
use polhode::motion::{Ensemble, EnsembleStates, MU_EARTH, Member, Orbit};
use polhode::prelude::*;

fn main() -> Result<(), Box<dyn Error>> {
    let inertia = InertiaTensor::with_negative_products([0.031, 0.042, 0.053], [0.004, -0.003, 0.002])?;
    let body = Rotor::free(&MassProperties::new(4.0, Position::ZERO, inertia)?);
    let orbit =
        Orbit::circular(MU_EARTH, 6.9e6, Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 0.6, 0.8))?;
    let period = orbit.period().ok_or("a circle is closed")?;
    let gradient = GravityGradient { orbit, attracted: Attracted::Tensor };
    let member = |k: u32| {
        // Rates spread over ±0.01 rad/s: multiples of the golden ratio fill the interval evenly.
        let spread = |ratio: f64| 0.02 * ((f64::from(k) * ratio).fract() - 0.5);
        let omega = AngularVelocity::new(spread(0.618_034), spread(0.754_878), spread(0.569_840));
        Member::new(
            body.clone(),
            vec![TorqueModel::GravityGradient(Box::new(gradient.clone()))],
            State { time: 0.0, attitude: Attitude::identity(), omega },
        )
    };
    let ensemble = Ensemble::new((0..1000).map(member).collect())?;
    let threads = available_parallelism().unwrap_or(NonZero::<usize>::MIN);
    let times: Vec<f64> = (0..=4).map(|k| 0.25 * period * f64::from(k)).collect();
    let tight = ensemble.at(&times, Method::Taylor, 1e-12, threads)?;
    let loose = ensemble.at(&times, Method::Taylor, 1e-6, threads)?;
    println!("orbits  tumbling beyond 90°  largest error at a tolerance of 1e-6, rad");
    for (n, time) in times.iter().enumerate() {
        let of = |found: &EnsembleStates| -> Vec<State> {
            found.states.iter().skip(n).step_by(times.len()).copied().collect()
        };
        let (truth, loose) = (of(&tight), of(&loose));
        let far = truth.iter().filter(|state| state.attitude.angle() > 0.5 * std::f64::consts::PI).count();
        let errors = truth.iter().zip(&loose).map(|(a, b)| a.attitude.angle_to(b.attitude));
        println!("{:6.2}  {far:19}  {:.1e}", time / period, errors.fold(0.0, f64::max));
    }
    if let Some(failure) = tight.failures.first() {
        return Err(failure.to_string().into());
    }
    Ok(())
}
