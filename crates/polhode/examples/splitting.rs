//! Energy error of splitting over many steps: writes the page `book/splitting.md`.
//!
//! `cargo run --release -p polhode --example splitting [steps] > book/splitting.md`

use std::error::Error;
use std::time::Instant;

use polhode::motion::torque::{Attracted, GravityGradient};
use polhode::motion::{Orbit, SplittingOrder, TIGHTEST_TOLERANCE};
use polhode::prelude::*;

/// Number of stretches into which a run is divided.
const STRETCHES: usize = 10;
/// Steps between samples: a prime, so that samples are not in phase with the motion.
const APART: usize = 997;

/// A body, its torques, its start, and its conserved quantity.
struct Problem {
    name: &'static str,
    rotor: Rotor,
    torques: Vec<TorqueModel>,
    start: State,
    energy: fn(&Problem, &Sample) -> f64,
}

/// A method, its step, and its results.
struct Run {
    order: SplittingOrder,
    step: f64,
    /// Largest and mean energy error in each stretch, relative to the largest kinetic energy.
    stretches: Vec<[f64; 2]>,
    /// Cost, s per step.
    cost: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let steps = std::env::args().nth(1).map_or(Ok(10_000_000), |text| text.parse())?;
    print!("{ESSAY}");
    println!("## {} steps\n\n{}", steps, READING);
    for problem in [symmetric()?, generic()?, satellite()?] {
        let runs = [(SplittingOrder::Two, 0.01), (SplittingOrder::Four, 0.05), (SplittingOrder::Six, 0.125)]
            .map(|(order, step)| measure(&problem, order, step, steps));
        let runs = runs.into_iter().collect::<Result<Vec<_>, _>>()?;
        print(&problem, &runs);
    }
    Ok(())
}

const ESSAY: &str = "\
# Splitting: integration without energy drift

Written by `crates/polhode/examples/splitting.rs`.

`method = \"splitting\"` alternates, with fractions a and b of a step h:

1. a kick, L ← L + b h N(attitude, t), at one attitude and time;
2. free motion for a h, exact to rounding.

- `order = 2`: half a kick, free motion, half a kick.
- `order = 4`, `order = 6`: SRKN₆ᵇ and SRKN₁₁ᵇ of Blanes and Moan, with 6 and 11 kicks per step.

S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313: Runge–Kutta–Nyström methods. The coefficients are cited from memory; `tests/all/splitting.rs` confirms each order on a heavy body without symmetry.

**Use.** Long runs under torques with a potential. Every step is symplectic and reversible, so the error of the energy stays at the level of the first turns;
the phase error grows in every method. For short runs, `taylor` is cheaper at equal accuracy ([measurements](work-precision.md)).

**Allowed torques.** `constant`, `gravity`, `gravity_gradient`, `torsion`, `magnetic`, `thruster`, and these on a schedule. Steps are shortened
where a torque begins or ends; if that happens often, the error of the energy is no longer bounded.

**Checks.** Work and impulse hold to rounding for any step. To check the step, use the drift of T + U, or half the step.

";

const READING: &str = "\
Error of the conserved quantity, relative to the largest kinetic energy: the largest in a tenth of the run, and in brackets its mean. Errors of about 1e-14
are rounding, a random walk. Times include other load on the machine.

The step of order 6 is a binary fraction, so its times are exact. With 0.1 s the rounding of the time, 6e-11 s after 10⁶ s, is visible in the last
table, where the torque depends on the time: 1.4e-11 at the end. The other tables do not change.
";

/// Returns the heavy top I = (1, 1, 0.5), M g l = 1, ω = (0, 0, 5), tilted by 60°.
fn symmetric() -> Result<Problem, Box<dyn Error>> {
    heavy(
        "Heavy top: I = (1, 1, 0.5), M g l = 1, ω = (0, 0, 5), tilted by 60°",
        [1.0, 1.0, 0.5],
        Direction::new(0.0, 0.0, 1.0),
        AngularVelocity::new(0.0, 0.0, 5.0),
    )
}

/// Returns a heavy body without symmetry: its motion is chaotic.
fn generic() -> Result<Problem, Box<dyn Error>> {
    let lever = Direction::new(0.48, -0.6, 0.64);
    heavy(
        "Heavy body without symmetry: I = (1, 1.4, 1.9), M g = 1, lever (0.48, −0.6, 0.64), ω = (0.7, −1.1, 1.3)",
        [1.0, 1.4, 1.9],
        lever,
        AngularVelocity::new(0.7, -1.1, 1.3),
    )
}

/// Returns a body about a pivot with these moments there, mass 1 kg, g = 1 m/s² and a lever of 1 m.
fn heavy(
    name: &'static str,
    moments: [f64; 3],
    lever: Direction<Body>,
    omega: AngularVelocity<Body>,
) -> Result<Problem, Box<dyn Error>> {
    // A small mass keeps the tensor about the centre of mass physical; g is larger in proportion.
    let (mass, g) = (1e-3, 1e3);
    let [x, y, z] = lever.to_array();
    let steiner = |a: f64, b: f64| mass * (a * a + b * b);
    let [a, b, c] = moments;
    let inertia = InertiaTensor::with_negative_products(
        [a - steiner(y, z), b - steiner(z, x), c - steiner(x, y)],
        [mass * x * y, mass * z * x, mass * y * z],
    )?;
    let body = MassProperties::new(mass, Position::new(x, y, z), inertia)?;
    let attitude = Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), std::f64::consts::FRAC_PI_3)?;
    Ok(Problem {
        name,
        rotor: Rotor::pivoted(&body, Position::ZERO),
        torques: vec![TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(0.0, 0.0, -g) })],
        start: State { time: 0.0, attitude, omega },
        energy: |_, sample| sample.kinetic_energy + sample.potential_energy.unwrap_or(f64::NAN),
    })
}

/// Returns a satellite on the circle r = (cos nt, sin nt, 0), n = 0.5 rad/s, with I = (1, 2, 2.5)
/// and ω = (0.3, 0.5, 0.9). It conserves T − n `L_z` + 3/2 n² r · I r.
fn satellite() -> Result<Problem, Box<dyn Error>> {
    let orbit = Orbit::through(N * N, Position::new(1.0, 0.0, 0.0), Velocity::new(0.0, N, 0.0), 0.0)?;
    let torque = GravityGradient { orbit, attracted: Attracted::Tensor };
    let inertia = InertiaTensor::diagonal([1.0, 2.0, 2.5])?;
    Ok(Problem {
        name: "Gravity gradient: I = (1, 2, 2.5), ω = (0.3, 0.5, 0.9), n = 0.5 on a circle; T − n L_z + 3/2 n² r · I r is conserved",
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

/// Rate of the orbit, rad/s.
const N: f64 = 0.5;

fn measure(problem: &Problem, order: SplittingOrder, step: f64, steps: usize) -> Result<Run, MotionError> {
    let Problem { rotor, torques, start, .. } = problem;
    let times: Vec<f64> = (0..=steps).step_by(APART).map(|k| k as f64 * step).collect();
    let begin = Instant::now();
    let method = Method::Splitting { order, step };
    let motion = Trajectory::compute(rotor, torques, *start, &times, method, TIGHTEST_TOLERANCE)?;
    let cost = begin.elapsed().as_secs_f64() / steps as f64;
    let energy = |sample: &Sample| (problem.energy)(problem, sample);
    let first = energy(motion.start());
    let scale = motion.samples().iter().map(|sample| sample.kinetic_energy).fold(0.0, f64::max);
    let errors: Vec<f64> = motion.samples().iter().map(|sample| (energy(sample) - first) / scale).collect();
    let stretches = errors.chunks(errors.len().div_ceil(STRETCHES)).map(|part| {
        let most = part.iter().fold(0.0, |most: f64, error| most.max(error.abs()));
        [most, part.iter().sum::<f64>() / part.len() as f64]
    });
    Ok(Run { order, step, stretches: stretches.collect(), cost })
}

/// Prints the tables of one problem.
fn print(problem: &Problem, runs: &[Run]) {
    println!("### {}\n", problem.name);
    let cells = |cell: &dyn Fn(&Run) -> String| runs.iter().map(cell).collect::<Vec<_>>().join(" | ");
    println!("| | {} |", cells(&|run| format!("order {}, {} s", run.order.number(), run.step)));
    println!("|---|{}", "---|".repeat(runs.len()));
    for k in [0, STRETCHES - 1] {
        let error = |run: &Run| {
            let [most, mean] = run.stretches.get(k).copied().unwrap_or([f64::NAN; 2]);
            format!("{most:.2e} ({mean:.1e})")
        };
        println!("| tenth {} | {} |", k + 1, cells(&error));
    }
    println!("| µs per step | {} |\n", cells(&|run| format!("{:.2}", run.cost * 1e6)));
}
