//! Cost of accuracy: problems of `book/work-precision.md` by each method, one line per run.
//!
//! `cargo run --release -p polhode --example work_precision`
//!
//! Columns: problem, method, its tolerance or step, seconds (the minimum of many runs), steps, the
//! quaternion at the end.

use std::error::Error;
use std::time::{Duration, Instant};

use polhode::motion::torque::{Attracted, Drag, DragLaw, FormulaTorque, GravityGradient};
use polhode::motion::{Orbit, SplittingOrder, TIGHTEST_TOLERANCE};
use polhode::prelude::*;

/// Duration for which each run is repeated.
const PATIENCE: Duration = Duration::from_millis(60);

/// A body, its torques, its start, and the end time.
struct Problem {
    name: String,
    rotor: Rotor,
    torques: Vec<TorqueModel>,
    start: State,
    end: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    for problem in [free()?, heavy_top()?, gravity_gradient()?, damped()?, own_law()?] {
        let measure = |method: &str, size: f64, how: Method| run(&problem, method, size, how);
        for exponent in 2..=15 {
            let tolerance = 10_f64.powi(-exponent);
            measure("taylor", tolerance, Method::Taylor)?;
            measure("dop853", tolerance, Method::Dop853)?;
        }
        if problem.torques.is_empty() {
            // Splitting would be exact for every step.
            measure("exact", 0.0, Method::Exact)?;
            continue;
        }
        for (order, halvings) in
            [(SplittingOrder::Two, 9), (SplittingOrder::Four, 8), (SplittingOrder::Six, 6)]
        {
            let name = format!("splitting {}", order.number());
            for halving in 0..halvings {
                let step = 0.5 * 0.5_f64.powi(halving);
                match measure(&name, step, Method::Splitting { order, step }) {
                    // Splitting cannot integrate drag.
                    Err(MotionError::NotSplittable { .. }) => break,
                    result => result?,
                }
            }
        }
    }
    // Only rounding remains, and one start is one sample of it.
    for k in 0..12 {
        let mut problem = Problem { name: format!("top {k}"), ..heavy_top()? };
        problem.start.omega = AngularVelocity::new(0.0, 0.0, 5.0 + 0.01 * f64::from(k));
        for exponent in [6, 9, 12, 15] {
            run(&problem, "taylor", 10_f64.powi(-exponent), Method::Taylor)?;
        }
    }
    Ok(())
}

/// Problem A: I = (1, 2, 3), ω = (0.3, 0.5, 0.9), no torque.
fn free() -> Result<Problem, Box<dyn Error>> {
    let rotor = Rotor::free(&body([1.0, 2.0, 3.0])?);
    let start = start([0.3, 0.5, 0.9]);
    Ok(Problem { name: "A".to_owned(), rotor, torques: Vec::new(), start, end: 100.0 })
}

/// Problem B: a heavy top about its tip, I = (1, 1, 0.5) there, M g l = 1, ω = (0, 0, 5), tilted by
/// 60°.
fn heavy_top() -> Result<Problem, Box<dyn Error>> {
    // A small mass keeps the tensor about its centre physical; gravity is larger in proportion.
    let (mass, g) = (1.0 / 1024.0, 1024.0);
    let inertia = InertiaTensor::diagonal([1.0 - mass, 1.0 - mass, 0.5])?;
    let rotor =
        Rotor::pivoted(&MassProperties::new(mass, Position::new(0.0, 0.0, 1.0), inertia)?, Position::ZERO);
    let attitude = Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), std::f64::consts::FRAC_PI_3)?;
    let torques =
        vec![TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(0.0, 0.0, -g) })];
    let start = State { attitude, ..start([0.0, 0.0, 5.0]) };
    Ok(Problem { name: "B".to_owned(), rotor, torques, start, end: 100.0 })
}

/// Problem C-gg: I = (1, 2, 2.5), ω = (0.3, 0.5, 0.9), N = 3n² r × I r on the circle r = (cos nt,
/// sin nt, 0), n = 0.5.
fn gravity_gradient() -> Result<Problem, Box<dyn Error>> {
    let orbit = Orbit::through(0.25, Position::new(1.0, 0.0, 0.0), Velocity::new(0.0, 0.5, 0.0), 0.0)?;
    let torque = GravityGradient { orbit, attracted: Attracted::Tensor };
    Ok(Problem {
        name: "C-gg".to_owned(),
        rotor: Rotor::free(&body([1.0, 2.0, 2.5])?),
        torques: vec![TorqueModel::GravityGradient(Box::new(torque))],
        start: start([0.3, 0.5, 0.9]),
        end: 20.0,
    })
}

/// Problem C-damp: I = (1, 2, 3), ω = (0.3, 0.5, 0.9), N = −0.05 ω.
fn damped() -> Result<Problem, Box<dyn Error>> {
    let c = 0.05;
    let drag = Drag::new(DragLaw::Linear, [[c, 0.0, 0.0], [0.0, c, 0.0], [0.0, 0.0, c]])?;
    let rotor = Rotor::free(&body([1.0, 2.0, 3.0])?);
    let torques = vec![TorqueModel::Drag(drag)];
    Ok(Problem { name: "C-damp".to_owned(), rotor, torques, start: start([0.3, 0.5, 0.9]), end: 100.0 })
}

/// Problem C-law: I = (1, 2, 3), ω = (0.3, 0.5, 0.9), N = −0.05 ω + (0.1 sin t, 0, 0), as formulas.
fn own_law() -> Result<Problem, Box<dyn Error>> {
    use polhode::math::formula::{Binary, Formula, Instruction, Unary};
    // −0.05 ωₖ + amplitude sin t; variables 0 to 3 are t and ω.
    let component = |k: usize, amplitude: f64| {
        let multiply = Instruction::Binary(Binary::Multiply);
        Formula::new([
            Instruction::Constant(-0.05),
            Instruction::Variable(k),
            multiply,
            Instruction::Constant(amplitude),
            Instruction::Variable(0),
            Instruction::Unary(Unary::Sin),
            multiply,
            Instruction::Binary(Binary::Add),
        ])
    };
    let law = FormulaTorque::Body([component(1, 0.1)?, component(2, 0.0)?, component(3, 0.0)?]);
    let torques = vec![TorqueModel::Formula(Box::new(law))];
    Ok(Problem { name: "C-law".to_owned(), torques, ..damped()? })
}

fn body(moments: [f64; 3]) -> Result<MassProperties<Body>, BodyError> {
    MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal(moments)?)
}

fn start(omega: [f64; 3]) -> State {
    State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::from_array(omega) }
}

fn run(problem: &Problem, name: &str, size: f64, method: Method) -> Result<(), MotionError> {
    let Problem { rotor, torques, start, end, .. } = problem;
    let tolerance = if size > 0.0 { size } else { TIGHTEST_TOLERANCE };
    let times = [*end];
    let simulation = Simulation::new(rotor, torques, *start, &times).method(method).tolerance(tolerance);
    let motion = simulation.run()?;
    let (mut least, begin) = (f64::INFINITY, Instant::now());
    while begin.elapsed() < PATIENCE {
        let once = Instant::now();
        // States only, as the other programs compute them: without an error estimate.
        let again = simulation.states()?;
        least = least.min(once.elapsed().as_secs_f64());
        std::hint::black_box(again);
    }
    let steps = motion.solution().statistics().map_or(0, |statistics| statistics.accepted);
    for sample in motion.samples() {
        let [w, x, y, z] = sample.state.attitude.quaternion();
        println!("{}\t{name}\t{size:e}\t{least:e}\t{steps}\t{w:?} {x:?} {y:?} {z:?}", problem.name);
    }
    Ok(())
}
