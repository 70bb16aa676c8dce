//! Cost of Taylor's method for batches of bodies, in ns per step of a body, on one core.
//!
//! `cargo bench -p polhode --bench ensemble_taylor -- [BODIES]`; the default is 1024 bodies.
//! `benches/ensemble_taylor.py` also runs heyoka's batches of eight with the same bodies.
//!
//! Each line: problem, tolerance, steps per body, ns per step of a body in the ensemble and alone.
//! Times are the minimum of many runs.

use std::error::Error;
use std::hint::black_box;
use std::num::NonZero;
use std::time::Instant;

use polhode::motion::torque::{Attracted, GravityGradient};
use polhode::motion::{Ensemble, Member, Orbit};
use polhode::prelude::*;

/// Moments about the point about which the bodies turn, kg·m².
const MOMENTS: [f64; 3] = [3.1, 4.2, 5.3];

/// End time, s.
const END: f64 = 100.0;

/// Tolerances that correspond to orders 24 and 20.
const TOLERANCES: [f64; 2] = [1e-15, 1e-8];

fn main() -> Result<(), Box<dyn Error>> {
    let count = std::env::args().find_map(|argument| argument.parse().ok()).unwrap_or(1024);
    for (name, rotor, torques) in problems()? {
        let member = |k: usize| Member::new(rotor.clone(), torques.clone(), start(k));
        let ensemble = Ensemble::new((0..count).map(member).collect())?;
        for tolerance in TOLERANCES {
            let mut steps = 0;
            for member in ensemble.members() {
                let run = alone(member, tolerance).run()?;
                steps += run.solution().statistics().map_or(0, |statistics| statistics.accepted);
            }
            let mut states = vec![start(0); count];
            let together = least(|| {
                let all = ensemble.fill(
                    &[END],
                    (Method::Taylor, tolerance),
                    NonZero::<usize>::MIN,
                    &mut states,
                    &mut |_| true,
                );
                black_box(all.is_ok());
            });
            let few = ensemble.members().get(..8).unwrap_or_default();
            let apart = least(|| {
                for member in few {
                    black_box(alone(member, tolerance).states().is_ok());
                }
            });
            let (steps, per_body) = (steps as f64, steps as f64 / count as f64);
            let (together, apart) = (together / steps, apart / (few.len() as f64 * per_body));
            println!("{name}\t{tolerance:e}\t{per_body:.1}\t{together:.1}\t{apart:.1}");
        }
    }
    Ok(())
}

/// A name, a body, and its torques.
type Problem = (&'static str, Rotor, Vec<TorqueModel>);

/// Returns three problems: no torque; gravity at a pivot with M g l = 1 N·m; the gravity gradient
/// on a circle at 0.5 rad/s.
fn problems() -> Result<[Problem; 3], Box<dyn Error>> {
    let free = Rotor::free(&MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal(MOMENTS)?)?);
    // A small mass hardly affects the tensor; gravity is larger in proportion.
    let (mass, g, [i1, i2, i3]) = (1e-3, 1e3, MOMENTS);
    let about_center = InertiaTensor::diagonal([i1 - mass, i2 - mass, i3])?;
    let body = MassProperties::new(mass, Position::new(0.0, 0.0, 1.0), about_center)?;
    let gravity = TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(0.0, 0.0, -g) });
    let orbit = Orbit::circular(0.25, 1.0, Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 1.0, 0.0))?;
    let gradient = GravityGradient { orbit, attracted: Attracted::Tensor };
    Ok([
        ("free", free.clone(), Vec::new()),
        ("heavy top", Rotor::pivoted(&body, Position::ZERO), vec![gravity]),
        ("gravity gradient", free, vec![TorqueModel::GravityGradient(Box::new(gradient))]),
    ])
}

/// Returns a start tilted by 1 rad about x.
fn start(k: usize) -> State {
    let attitude =
        Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), 1.0).unwrap_or(Rotation::identity());
    State { time: 0.0, attitude, omega: AngularVelocity::new(0.3, 0.5 - 3e-4 * k as f64, 0.9) }
}

fn alone(member: &Member, tolerance: f64) -> Simulation<'_> {
    let simulation = Simulation::new(&member.rotor, &member.torques, member.start, &[END]);
    simulation.method(Method::Taylor).tolerance(tolerance)
}

/// Returns the minimum time of many runs, ns.
fn least(mut work: impl FnMut()) -> f64 {
    let (mut least, begin) = (f64::INFINITY, Instant::now());
    while begin.elapsed().as_secs_f64() < 1.0 {
        let start = Instant::now();
        work();
        least = least.min(start.elapsed().as_secs_f64());
    }
    least * 1e9
}
