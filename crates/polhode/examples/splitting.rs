//! The energy error of splitting over many steps, for the page `book/splitting.md`: a line for each stretch of a run.
//!
//! `cargo run --release -p polhode --example splitting [steps]`
//!
//! Columns: problem, order, step (s), steps, stretch (1 of 10 …), the largest relative error of the energy in it, ns a step.

use std::error::Error;
use std::time::Instant;

use polhode::*;

/// Stretches that a run is divided into.
const STRETCHES: usize = 10;
/// Steps from one sample to the next: a prime, so that samples do not beat with the motion.
const APART: usize = 997;

/// A body, what turns it, where it starts, and what it conserves.
struct Problem {
    name: &'static str,
    rotor: Rotor,
    torques: Vec<TorqueModel>,
    start: State,
    energy: fn(&Problem, &Sample) -> f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let steps = std::env::args().nth(1).map_or(Ok(10_000_000), |text| text.parse())?;
    for problem in [symmetric()?, generic()?, satellite()?] {
        for (order, step) in
            [(SplittingOrder::Two, 0.01), (SplittingOrder::Four, 0.03), (SplittingOrder::Six, 0.06)]
        {
            measure(&problem, order, step, steps)?;
        }
    }
    Ok(())
}

/// The heavy top I = (1, 1, 0.5), M g l = 1, ω = (0, 0, 5), tilted by 60°.
fn symmetric() -> Result<Problem, Box<dyn Error>> {
    heavy("heavy top", [1.0, 1.0, 0.5], Direction::new(0.0, 0.0, 1.0), AngularVelocity::new(0.0, 0.0, 5.0))
}

/// A heavy body without any symmetry: its motion is chaotic.
fn generic() -> Result<Problem, Box<dyn Error>> {
    let lever = Direction::new(0.48, -0.6, 0.64);
    heavy("heavy body without symmetry", [1.0, 1.4, 1.9], lever, AngularVelocity::new(0.7, -1.1, 1.3))
}

/// A body about a pivot with these moments there, mass 1 kg, g = 1 m/s² and a lever of 1 m.
fn heavy(
    name: &'static str,
    moments: [f64; 3],
    lever: Direction<Body>,
    omega: AngularVelocity<Body>,
) -> Result<Problem, Box<dyn Error>> {
    // A mass so small beside the moments that the tensor about the centre of mass is possible too, and g as much larger.
    let (mass, g) = (1e-3, 1e3);
    let [x, y, z] = lever.to_array();
    let steiner = |a: f64, b: f64| mass * (a * a + b * b);
    let [a, b, c] = moments;
    let inertia = InertiaTensor::with_negative_products(
        [a - steiner(y, z), b - steiner(z, x), c - steiner(x, y)],
        [mass * x * y, mass * z * x, mass * y * z],
    )?;
    let body = MassProperties::new(mass, Position::new(x, y, z), inertia)?;
    let attitude = Rotation::about(Direction::new(1.0, 0.0, 0.0), std::f64::consts::FRAC_PI_3)?;
    Ok(Problem {
        name,
        rotor: Rotor::pivoted(&body, Position::ZERO),
        torques: vec![TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(0.0, 0.0, -g) })],
        start: State { time: 0.0, attitude, omega },
        energy: |_, sample| sample.kinetic_energy + sample.potential_energy.unwrap_or(f64::NAN),
    })
}

/// A satellite on the circle r = (cos nt, sin nt, 0), n = 0.5 rad/s, with I = (1, 2, 2.5) and ω = (0.3, 0.5, 0.9): what is conserved is
/// T − n L_z + 3/2 n² r · I r.
fn satellite() -> Result<Problem, Box<dyn Error>> {
    let orbit = Orbit::through(N * N, Position::new(1.0, 0.0, 0.0), Velocity::new(0.0, N, 0.0), 0.0)?;
    let torque = GravityGradient { orbit, attracted: Attracted::Tensor };
    let inertia = InertiaTensor::diagonal([1.0, 2.0, 2.5])?;
    Ok(Problem {
        name: "gravity gradient",
        rotor: Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia)?),
        torques: vec![TorqueModel::GravityGradient(Box::new(torque))],
        start: State {
            time: 0.0,
            attitude: Attitude::identity(),
            omega: AngularVelocity::new(0.3, 0.5, 0.9),
        },
        energy: |problem, sample| {
            let (sin, cos) = (N * sample.state.time).sin_cos();
            let r = sample.state.attitude.inverse() * AngularVelocity::new(cos, sin, 0.0);
            let potential = 3.0 * N * N * problem.rotor.kinetic_energy(r);
            sample.kinetic_energy - N * sample.momentum.z + potential
        },
    })
}

/// The rate of the orbit, rad/s.
const N: f64 = 0.5;

fn measure(problem: &Problem, order: SplittingOrder, step: f64, steps: usize) -> Result<(), MotionError> {
    let Problem { name, rotor, torques, start, energy } = problem;
    let energy = |sample: &Sample| energy(problem, sample);
    let times: Vec<f64> = (0..=steps).step_by(APART).map(|k| k as f64 * step).collect();
    let begin = Instant::now();
    let method = Method::Splitting { order, step };
    let motion = Trajectory::compute(rotor, torques, *start, &times, method, TIGHTEST_TOLERANCE)?;
    let cost = begin.elapsed().as_secs_f64() * 1e9 / steps as f64;
    let first = energy(motion.start());
    let scale = motion.samples().iter().map(|sample| sample.kinetic_energy).fold(0.0, f64::max);
    let errors: Vec<f64> = motion.samples().iter().map(|sample| (energy(sample) - first) / scale).collect();
    for (stretch, part) in errors.chunks(errors.len().div_ceil(STRETCHES)).enumerate() {
        let (least, most) = part.iter().fold((f64::MAX, f64::MIN), |(a, b), e| (a.min(*e), b.max(*e)));
        let mean = part.iter().sum::<f64>() / part.len() as f64;
        println!(
            "{name}\t{}\t{step}\t{steps}\t{}\t{least:.3e}\t{most:.3e}\t{mean:.3e}\t{cost:.0}",
            order.number(),
            stretch + 1
        );
    }
    Ok(())
}
