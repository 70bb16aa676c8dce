//! Cost of derivatives: the Taylor problems of `book/work-precision.md`, without and with
//! derivatives with respect to start and inertia.
//!
//! `cargo run --release -p polhode --example derivatives`. `benches/derivatives.py` runs it
//! together with heyoka.
//!
//! Columns: problem, tolerance, seconds without and with derivatives (the minimum of many runs), Φ
//! at the end row by row.

use std::error::Error;
use std::time::{Duration, Instant};

use polhode::motion::Orbit;
use polhode::motion::torque::{Attracted, Drag, DragLaw, GravityGradient};
use polhode::prelude::*;

/// Duration for which each run is repeated.
const PATIENCE: Duration = Duration::from_millis(60);

/// A body, its torques, its start, and the end time.
struct Problem {
    name: &'static str,
    rotor: Rotor,
    torques: Vec<TorqueModel>,
    start: State,
    end: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    for problem in [free()?, heavy_top()?, gravity_gradient()?, damped()?] {
        for exponent in [3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15] {
            measure(&problem, 10_f64.powi(-exponent))?;
        }
    }
    Ok(())
}

/// Problem A: I = (1, 2, 3), ω = (0.3, 0.5, 0.9), no torque.
fn free() -> Result<Problem, Box<dyn Error>> {
    let rotor = Rotor::free(&body([1.0, 2.0, 3.0])?);
    Ok(Problem { name: "A", rotor, torques: Vec::new(), start: start([0.3, 0.5, 0.9]), end: 100.0 })
}

/// Problem B: a heavy top about its tip, I = (1, 1, 0.5) there, M g l = 1, ω = (0, 0, 5), tilted by
/// 60°.
fn heavy_top() -> Result<Problem, Box<dyn Error>> {
    // A small mass keeps the tensor about its centre physical; gravity is larger in proportion.
    let (mass, g) = (1.0 / 1024.0, 1024.0);
    let inertia = InertiaTensor::diagonal([1.0 - mass, 1.0 - mass, 0.5])?;
    let body = MassProperties::new(mass, Position::new(0.0, 0.0, 1.0), inertia)?;
    let attitude = Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), std::f64::consts::FRAC_PI_3)?;
    let torques =
        vec![TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(0.0, 0.0, -g) })];
    let start = State { attitude, ..start([0.0, 0.0, 5.0]) };
    Ok(Problem { name: "B", rotor: Rotor::pivoted(&body, Position::ZERO), torques, start, end: 100.0 })
}

/// Problem C-gg: I = (1, 2, 2.5), ω = (0.3, 0.5, 0.9), N = 3n² r × I r on the circle r = (cos nt,
/// sin nt, 0), n = 0.5.
fn gravity_gradient() -> Result<Problem, Box<dyn Error>> {
    let orbit = Orbit::through(0.25, Position::new(1.0, 0.0, 0.0), Velocity::new(0.0, 0.5, 0.0), 0.0)?;
    let torque = GravityGradient { orbit, attracted: Attracted::Tensor };
    let torques = vec![TorqueModel::GravityGradient(Box::new(torque))];
    let rotor = Rotor::free(&body([1.0, 2.0, 2.5])?);
    Ok(Problem { name: "C-gg", rotor, torques, start: start([0.3, 0.5, 0.9]), end: 20.0 })
}

/// Problem C-damp: I = (1, 2, 3), ω = (0.3, 0.5, 0.9), N = −0.05 ω.
fn damped() -> Result<Problem, Box<dyn Error>> {
    let c = 0.05;
    let drag = Drag::new(DragLaw::Linear, [[c, 0.0, 0.0], [0.0, c, 0.0], [0.0, 0.0, c]])?;
    let rotor = Rotor::free(&body([1.0, 2.0, 3.0])?);
    let torques = vec![TorqueModel::Drag(drag)];
    Ok(Problem { name: "C-damp", rotor, torques, start: start([0.3, 0.5, 0.9]), end: 100.0 })
}

fn body(moments: [f64; 3]) -> Result<MassProperties<Body>, BodyError> {
    MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal(moments)?)
}

fn start(omega: [f64; 3]) -> State {
    State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::from_array(omega) }
}

fn measure(problem: &Problem, tolerance: f64) -> Result<(), MotionError> {
    let Problem { name, rotor, torques, start, end } = problem;
    let times = [*end];
    let simulation =
        Simulation::new(rotor, torques, *start, &times).method(Method::Taylor).tolerance(tolerance);
    let without = least(|| simulation.states().map(|_| ()))?;
    let with = least(|| simulation.run_with_derivatives(&[]).map(|_| ()))?;
    let motion = simulation.run_with_derivatives(&[])?;
    for derivatives in motion.states {
        let numbers: Vec<String> =
            derivatives.by_start.as_flattened().iter().map(|x| format!("{x:?}")).collect();
        println!("{name}\t{tolerance:e}\t{without:e}\t{with:e}\t{}", numbers.join(" "));
    }
    Ok(())
}

/// Returns the minimum time of many runs, s.
fn least(run: impl Fn() -> Result<(), MotionError>) -> Result<f64, MotionError> {
    let (mut least, begin) = (f64::INFINITY, Instant::now());
    while begin.elapsed() < PATIENCE {
        let once = Instant::now();
        run()?;
        least = least.min(once.elapsed().as_secs_f64());
    }
    Ok(least)
}
