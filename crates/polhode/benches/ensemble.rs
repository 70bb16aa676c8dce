//! Cost of ensembles of many bodies. `cargo bench -p polhode --bench ensemble`.
//! `benches/ensemble.py` runs it together with other libraries and with narrower vectors, and
//! writes the numbers of `book/ensembles.md`.
//!
//! Each line: name, number, unit. Times are the minimum of many runs, each so short that some are
//! undisturbed.

use std::error::Error;
use std::hint::black_box;
use std::num::NonZero;
use std::time::Instant;

use polhode::math::formula::{Binary, Formula, FormulaError, Instruction, Unary};
use polhode::motion::torque::{
    Attracted, Drag, DragLaw, FormulaTorque, GravityGradient, Magnetic, MagneticField, Torsion,
};
use polhode::motion::{Ensemble, FreeMotions, MU_EARTH, Member, MemberFailure, Orbit, StateVariables};
use polhode::prelude::*;

fn main() -> Result<(), Box<dyn Error>> {
    // Restricts the run to torques whose names contain the argument, if one is given.
    let wanted = std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    if wanted.is_none() {
        scaling("fused multiply–add", "GFLOP/s", |threads| Ok(peak(threads)))?;
        exact()?;
    }
    for (name, rotor, torques) in subjects()? {
        if wanted.as_ref().is_some_and(|wanted| !name.contains(wanted)) {
            continue;
        }
        let [together, alone] = taylor(&rotor, &torques)?;
        println!("Taylor {name}\t{together:.0}\tns per body-step");
        println!("Taylor {name}, alone\t{alone:.0}\tns per step");
    }
    Ok(())
}

/// Prints a rate on one thread and on two, and their ratio; returns the rate on one thread.
fn scaling(
    name: &str,
    unit: &str,
    rate: impl Fn(usize) -> Result<f64, Box<dyn Error>>,
) -> Result<f64, Box<dyn Error>> {
    let (one, two) = (rate(1)?, rate(2)?);
    println!("{name}, 1 at a time\t{one:.1}\t{unit}");
    println!("{name}, 2 at a time\t{two:.1}\t{unit}");
    println!("{name}, two threads\t{:.2}\ttimes one", two / one);
    Ok(one)
}

/// Returns the minimum time of many short runs, s.
fn least(mut work: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    let begin = Instant::now();
    while begin.elapsed().as_secs_f64() < 0.5 {
        let start = Instant::now();
        work();
        least = least.min(start.elapsed().as_secs_f64());
    }
    least
}

fn generic() -> Result<MassProperties<Body>, BodyError> {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
    MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia)
}

/// Returns a different start for each k.
fn start(k: usize) -> State {
    let omega = AngularVelocity::new(0.3 + 1e-4 * k as f64, 0.5, 0.9);
    State { time: 0.0, attitude: Attitude::identity(), omega }
}

/// A name, a body, and its torques.
type Subject = (&'static str, Rotor, Vec<TorqueModel>);

fn subjects() -> Result<Vec<Subject>, Box<dyn Error>> {
    let body = generic()?;
    let (free, held) = (Rotor::free(&body), Rotor::pivoted(&body, Position::new(-0.04, 0.02, 0.01)));
    let drag = Drag::new(DragLaw::Linear, [[0.11, 0.02, -0.03], [0.02, 0.17, 0.05], [-0.03, 0.05, 0.09]])?;
    let orbit =
        Orbit::circular(MU_EARTH, 6.9e6, Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 0.6, 0.8))?;
    let gradient = GravityGradient { orbit, attracted: Attracted::Tensor };
    let magnetic = Magnetic {
        moment: Direction::new(0.9, -0.4, 1.3),
        field: MagneticField::Uniform(Direction::new(2e-5, -1.1e-5, 4.3e-5)),
    };
    let constant = ConstantTorque::Body(Torque::new(0.1, -0.2, 0.3));
    let quadratic = Drag::new(DragLaw::Quadratic, drag.matrix())?;
    let ellipse =
        Orbit::through(MU_EARTH, Position::new(6.9e6, 1e5, -8e5), Velocity::new(0.4e3, 6.3e3, 4.5e3), 0.0)?;
    let of_ellipse = |attracted| GravityGradient { orbit: ellipse.clone(), attracted };
    let points: Vec<_> =
        [(0.5, [0.9, -0.2, 0.4]), (0.7, [-0.6, 1.1, 0.3]), (0.4, [0.1, 0.5, -1.3]), (0.7, [-0.8, -0.9, 0.2])]
            .into_iter()
            .map(|(m, p)| Particle::new(m, Position::from_array(p)))
            .collect::<Result<_, _>>()?;
    let dipole = Magnetic {
        moment: Direction::new(0.9, -0.4, 1.3),
        field: MagneticField::Dipole { dipole: Direction::new(-3e21, 2e21, -7.5e22), orbit: ellipse.clone() },
    };
    let rest = Attitude::from_quaternion([0.5, -0.5, 0.8, 0.6])?;
    let spring = Torsion::spring(0.07, rest)?;
    let wire = Torsion::wire(0.07, rest, Direction::new(0.3, -0.5, 0.9))?;
    Ok(vec![
        ("free", free.clone(), vec![]),
        ("constant torque", free.clone(), vec![TorqueModel::Constant(constant)]),
        ("drag", free.clone(), vec![TorqueModel::Drag(drag)]),
        ("gravity at a pivot", held, vec![TorqueModel::Gravity(UniformGravity::STANDARD)]),
        ("gravity gradient", free.clone(), vec![TorqueModel::GravityGradient(Box::new(gradient))]),
        ("magnet", free.clone(), vec![TorqueModel::Magnetic(Box::new(magnetic))]),
        ("quadratic drag", free.clone(), vec![TorqueModel::Drag(quadratic)]),
        (
            "gravity gradient on an ellipse",
            free.clone(),
            vec![TorqueModel::GravityGradient(Box::new(of_ellipse(Attracted::Tensor)))],
        ),
        (
            "gravity gradient of four points",
            free.clone(),
            vec![TorqueModel::GravityGradient(Box::new(of_ellipse(Attracted::Points(points))))],
        ),
        ("dipole", free.clone(), vec![TorqueModel::Magnetic(Box::new(dipole))]),
        ("spring", free.clone(), vec![TorqueModel::Torsion(spring)]),
        ("wire", free.clone(), vec![TorqueModel::Torsion(wire)]),
        ("formulas", free, vec![TorqueModel::Formula(Box::new(formulas()?))]),
    ])
}

/// Formula torque (0.2 sin(2 t) − 0.1 ωx, 0.3 r31 ωy, −0.05 ωz²).
fn formulas() -> Result<FormulaTorque, FormulaError> {
    use Instruction as I;
    let place = |name| StateVariables::NAMES.iter().position(|known| *known == name).unwrap_or_default();
    let variable = |name| I::Variable(place(name));
    let times = I::Binary(Binary::Multiply);
    let x = [I::Constant(0.2), I::Constant(2.0), variable("t"), times, I::Unary(Unary::Sin), times];
    let damping = [I::Constant(0.1), variable("wx"), times, I::Binary(Binary::Subtract)];
    let y = [I::Constant(0.3), variable("r31"), times, variable("wy"), times];
    let z = [I::Constant(-0.05), variable("wz"), variable("wz"), times, times];
    Ok(FormulaTorque::Body([Formula::new(x.into_iter().chain(damping))?, Formula::new(y)?, Formula::new(z)?]))
}

fn ensemble(rotor: &Rotor, torques: &[TorqueModel], count: usize) -> Result<Ensemble, MemberFailure> {
    let member = |k| Member::new(rotor.clone(), torques.to_vec(), start(k));
    Ensemble::new((0..count).map(member).collect())
}

/// Measures ns per body and step, in batches of at least eight bodies with individual steps.
fn taylor(rotor: &Rotor, torques: &[TorqueModel]) -> Result<[f64; 2], Box<dyn Error>> {
    let (bodies, tolerance, times) = (64, 1e-9, [100.0]);
    let all = ensemble(rotor, torques, bodies)?;
    let mut steps = 0;
    for member in all.members() {
        let run = Trajectory::compute(rotor, torques, member.start, &times, Method::Taylor, tolerance)?;
        steps += run.solution().statistics().map_or(0, |statistics| statistics.accepted);
    }
    let mut states = vec![start(0); bodies];
    let seconds = least(|| {
        let method = (Method::Taylor, tolerance);
        black_box(all.fill(&times, method, NonZero::<usize>::MIN, &mut states, &mut |_| true).ok());
    });
    let one = least(|| {
        for member in all.members().iter().take(8) {
            let simulation = Simulation::new(rotor, torques, member.start, &times);
            let run = simulation.method(Method::Taylor).tolerance(tolerance).states();
            black_box(run.is_ok());
        }
    });
    let per_body = steps as f64 / bodies as f64;
    Ok([seconds / steps as f64 * 1e9, one / (8.0 * per_body) * 1e9])
}

/// Measures free motions in closed form.
fn exact() -> Result<(), Box<dyn Error>> {
    let rotor = Rotor::free(&generic()?);
    let times: Vec<f64> = (0..1024).map(|k| f64::from(k) * 0.977 + 0.1).collect();
    scaling("exact, 1,024 times of each body", "million states/s", |threads| {
        let bodies = 1024 * threads;
        let all = ensemble(&rotor, &[], bodies)?;
        let mut rows = vec![start(0); bodies * times.len()];
        let threads = NonZero::new(threads).ok_or("no thread")?;
        let method = (Method::Auto, 1e-12);
        let seconds = least(|| {
            black_box(all.fill(&times, method, threads, &mut rows, &mut |_| true).ok());
        });
        Ok((bodies * times.len()) as f64 / seconds * 1e-6)
    })?;
    let motion = FreeMotion::of(&rotor, start(7))?;
    let mut states = motion.at_times(&times);
    let seconds = least(|| motion.fill(black_box(&times), black_box(&mut states)));
    println!("exact, one body, prepared\t{:.1}\tmillion states/s", times.len() as f64 / seconds * 1e-6);
    // With many fleets the bodies come from memory: each fleet waits until all others have been
    // computed. The states are also written to memory: each to its own place, or to places that
    // stay in the cache, as in a reduction.
    for (fleets, count, places, whither) in
        [(1, 1_000, 1, ""), (10, 100_000, 10, ""), (100, 10_000, 1, ", states that stay near")]
    {
        let motion = |k: usize| FreeMotion::of(&rotor, start(k));
        let fleet =
            |f: usize| Ok(FreeMotions::of(&(f..f + count).map(motion).collect::<Result<Vec<_>, _>>()?));
        let all = (0..fleets).map(fleet).collect::<Result<Vec<_>, MotionError>>()?;
        let mut states = vec![vec![start(0); count]; places];
        let (mut time, mut turn) = (1234.5, (0..fleets).cycle());
        let seconds = least(|| {
            time += 1.0;
            if let Some((f, fleet)) = turn.next().and_then(|f| Some((f, all.get(f)?))) {
                fleet.fill(black_box(time), black_box(&mut states[f % places]));
            }
        });
        let rate = count as f64 / seconds * 1e-6;
        println!("exact, {} prepared bodies at a time{whither}\t{rate:.1}\tmillion states/s", fleets * count);
    }
    let seconds = least(|| {
        black_box(FreeMotion::of(black_box(&rotor), start(7)).ok());
    });
    println!("exact, to prepare a body\t{:.1}\tµs", seconds * 1e6);
    println!("a prepared body\t{}\tbytes", size_of::<FreeMotion>());
    Ok(())
}

/// Rate of fused multiply–adds in registers on this many threads, GFLOP/s.
#[cfg(all(feature = "simd", target_arch = "x86_64"))]
fn peak(threads: usize) -> f64 {
    let mut best: f64 = 0.0;
    let begin = Instant::now();
    while begin.elapsed().as_secs_f64() < 0.5 {
        let start = Instant::now();
        let operations: f64 = std::thread::scope(|scope| {
            let others: Vec<_> = (1..threads).map(|_| scope.spawn(multiply_and_add)).collect();
            multiply_and_add() + others.into_iter().filter_map(|other| other.join().ok()).sum::<f64>()
        });
        best = best.max(operations / start.elapsed().as_secs_f64());
    }
    best * 1e-9
}

/// Runs for about ten milliseconds; returns the number of operations.
#[cfg(all(feature = "simd", target_arch = "x86_64"))]
fn multiply_and_add() -> f64 {
    let level = fearless_simd::Level::new();
    #[cfg(not(no_avx512))]
    if let Some(avx512) = level.as_avx512() {
        return chains::<_, 12>(avx512);
    }
    level.as_avx2().map_or(0.0, chains::<_, 6>)
}

/// Computes independent sums of eight lanes, so that each waits only for itself.
#[cfg(all(feature = "simd", target_arch = "x86_64"))]
fn chains<S: fearless_simd::Simd, const CHAINS: usize>(simd: S) -> f64 {
    const ROUNDS: usize = 6_000_000;
    simd.vectorize(
        #[inline(always)]
        || {
            let (a, b) = (simd.splat_f64x8(black_box(0.999_999)), simd.splat_f64x8(black_box(1e-9)));
            let mut sums = [a; CHAINS];
            for _ in 0..ROUNDS {
                for sum in &mut sums {
                    *sum = simd.mul_add_f64x8(*sum, a, b);
                }
            }
            black_box(sums.into_iter().fold(a, |all, sum| simd.add_f64x8(all, sum))[0]);
        },
    );
    (8 * 2 * CHAINS * ROUNDS) as f64
}

#[cfg(not(all(feature = "simd", target_arch = "x86_64")))]
fn peak(_: usize) -> f64 {
    f64::NAN
}
