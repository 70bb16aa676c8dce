//! Bodies that turn about a fixed axis: the pendulum and the torsion pendulum.

use polhode::math::{Acceleration, AngularVelocity, Body, Direction, Rotation};
use polhode::motion::torque::{TorqueModel, Torsion};
use polhode::motion::{Pendulum, Sample, Scenario, State, Swing, Trajectory};
use polhode_algebra::{Formula, Kind, RationalFunction, Relation, Symbol, Symbols};
use polhode_document::Section;
use polhode_document::unit::amplitude;

use super::case::Case;
use super::error::LagrangianError;
use super::system::{System, at_angle, cosine, half_square, velocity};
use super::verify::{Instant, Motion, plain};
use super::write::{n, put, second_derivative};

/// Angle between vectors, rad, up to which they count as parallel.
const PARALLEL: f64 = 1e-9;
/// Largest number of particles whose sum Σ m r² is written.
const MOST_PARTICLES: usize = 4;

/// Returns T = ½ I θ̇².
pub(super) fn kinetic(moment: &RationalFunction, angle: Symbol) -> RationalFunction {
    half_square(moment, &velocity(angle))
}

/// Returns U = −w cos θ for the weight w = M g d.
pub(super) fn gravity(weight: &RationalFunction, angle: Symbol) -> RationalFunction {
    -(weight * cosine(angle))
}

/// Returns U = ½ κ θ².
pub(super) fn torsion(stiffness: &RationalFunction, angle: Symbol) -> RationalFunction {
    half_square(stiffness, &angle.into())
}

/// Returns the pendulum of a scenario with a fixed axis.
pub(super) fn pendulum(
    scenario: &Scenario,
    pendulum: &Pendulum,
    axis: Direction<Body>,
    run: Option<&Trajectory>,
) -> Result<Case, LagrangianError> {
    let mut system = System::new();
    let mass = system.constant("M", scenario.rotor().mass(), "kg", "mass")?;
    let g = system.constant("g", pendulum.gravity(), "m/s²", "gravity across the axis")?;
    let d = system.constant("d", pendulum.arm(), "m", "distance of the centre of mass from the axis")?;
    let moment = system.constant("I", pendulum.moment(), "kg·m²", "moment of inertia about the axis")?;
    let theta = system.coordinate("theta", "rad", 1.0)?;
    system.kinetic = vec![kinetic(&moment, theta)];
    system.potential = gravity(&(mass * g * d), theta);
    let mut s = Section::new(5, "Equilibrium and small oscillations");
    s.say("In equilibrium ∂U/∂θ = 0: θ = 0, where the body hangs, and θ = π, where it is upright. The second derivative of U decides on stability:");
    for (text, cosine) in [("0", 1), ("π", -1)] {
        put(&mut s, &stiffness_at(&system, theta, cosine, text));
    }
    s.say("At θ = 0 it is positive: the equilibrium is stable, and small oscillations are harmonic. At θ = π it is negative: the equilibrium is unstable.");
    let square = frequency(&system, theta, &moment, Relation::Approximate, &mut s);
    particles(scenario, axis, &square, &mut system, &mut s)?;
    s.line(format!(
        "ω0 = {} rad/s,  period 2π/ω0 = {} s",
        n(pendulum.small_frequency()),
        n(pendulum.period(0.0))
    ));
    let rate = axis.dot(scenario.start().omega);
    let stated = scenario.suspension().and_then(|hanging| hanging.amplitude);
    let swing =
        stated.map_or_else(|| pendulum.swing(pendulum.angle(), rate), |angle| pendulum.swing(angle, 0.0));
    if let Swing::Oscillation { amplitude: largest, period } = swing {
        s.line(format!("at the amplitude {} the period is {} s", amplitude(largest), n(period)));
    }
    let stays = run.is_none_or(|run| stays_on(scenario, axis, run));
    let motion = run.map(|run| swinging(scenario, pendulum, axis, run, stays)).transpose()?;
    let mut coordinates = Section::new(1, "Coordinates");
    coordinates.say("The body turns about a fixed axis: it has one degree of freedom. The coordinate θ is the angle of the centre of mass from its lowest position, positive by the right-hand rule about the axis.");
    if !stays {
        coordinates.say("A run holds only the pivot, and this body leaves the axis. So the motion below is the closed form of the pendulum, with the torque of gravity at each position.");
    }
    let name = if scenario.is_all_particles() && !scenario.particles().is_empty() {
        "a pendulum of particles"
    } else {
        "a physical pendulum"
    };
    let energies = "All points move on circles about the axis. U is the energy of the weight, zero when the centre of mass is level with the axis:";
    Ok(Case { motion, ..Case::new(name, system, energies, [coordinates, s]) })
}

/// Returns the torsion pendulum of a scenario: a body that a spring or wire turns about a fixed axis.
pub(super) fn torsion_pendulum(
    scenario: &Scenario,
    wire: &Torsion,
    run: Option<&Trajectory>,
) -> Result<Case, LagrangianError> {
    let rotor = scenario.rotor();
    let start = scenario.start();
    let twist = |state: &State| -> Direction<Body> {
        let turn: Rotation<Body, Body> = wire.rest().inverse() * state.attitude;
        turn.log()
    };
    let of_wire = wire.axis().map(|axis| wire.rest().inverse() * axis);
    let at_start = Some(twist(&start)).filter(|twist| twist.norm() > PARALLEL);
    let axis = of_wire.or(at_start).unwrap_or_else(|| plain(start.omega)).direction();
    let Some(axis) = axis else {
        return Err(LagrangianError::because("the body is at rest without twist, which determines no axis"));
    };
    let across = |v: Direction<Body>| (v - axis * axis.dot(v)).norm();
    let along = AngularVelocity::from_array(axis.to_array());
    let moment = rotor.inertia().about_axis(axis);
    if across(plain(rotor.angular_momentum(along))) > PARALLEL * moment {
        return Err(LagrangianError::because(
            "the axis of the torsion is not a principal axis of the body, so that it wobbles",
        ));
    }
    let stays = |state: &State| {
        across(twist(state)) <= PARALLEL
            && across(plain(state.omega)) <= PARALLEL * (1.0 + state.omega.norm())
    };
    let states = run.into_iter().flat_map(Trajectory::samples).map(|sample| sample.state);
    if !stays(&start) || !states.into_iter().all(|state| stays(&state)) {
        return Err(LagrangianError::because("the body does not only turn about the axis of the torsion"));
    }
    let mut system = System::new();
    let stiffness = system.constant("kappa", wire.stiffness(), "N·m/rad", "stiffness")?;
    let inertia = system.constant("I", moment, "kg·m²", "moment of inertia about the axis")?;
    let theta = system.coordinate("theta", "rad", 1.0)?;
    system.kinetic = vec![kinetic(&inertia, theta)];
    system.potential = torsion(&stiffness, theta);
    let mut s = Section::new(5, "Equilibrium and small oscillations");
    s.say("In equilibrium ∂U/∂θ = 0: θ = 0, without twist. There the second derivative of U is positive, so the equilibrium is stable:");
    put(&mut s, &stiffness_at(&system, theta, 1, "0"));
    s.say("U is quadratic, so the oscillation is harmonic at every amplitude:");
    let square = frequency(&system, theta, &inertia, Relation::Equal, &mut s);
    let values = |symbol: Symbol| system.constants.iter().find(|c| c.symbol == symbol).map(|c| c.value);
    if let Some(omega) = square.evaluate(&values).map(f64::sqrt).filter(|omega| *omega > 0.0) {
        s.line(format!("ω0 = {} rad/s,  period 2π/ω0 = {} s", n(omega), n(std::f64::consts::TAU / omega)));
    }
    let instant = |sample: &Sample| {
        let acceleration = rotor.acceleration(sample.state.omega, sample.torque);
        let coordinates =
            vec![[axis.dot(twist(&sample.state)), axis.dot(sample.state.omega), axis.dot(acceleration)]];
        Instant { time: sample.state.time, coordinates, others: Vec::new() }
    };
    let motion = run.map(|run| Motion { instants: run.samples().iter().map(instant).collect(), left_out: 0 });
    let mut coordinates = Section::new(1, "Coordinates");
    coordinates.say("The body turns about a fixed axis, which is a principal axis. The coordinate θ is the twist from the attitude at rest, positive by the right-hand rule about the axis.");
    let name = "a torsion pendulum";
    let energies = "U is the energy of the twisted spring or wire:";
    Ok(Case { motion, ..Case::new(name, system, energies, [coordinates, s]) })
}

/// Returns `θ = angle, d²U/dθ² = …`.
fn stiffness_at(system: &System, theta: Symbol, cosine: i64, angle: &str) -> Formula {
    let second = system.potential.derivative(theta).derivative(theta);
    let value = at_angle(&second, theta, [0, cosine]).unwrap_or_else(RationalFunction::zero);
    let derivative = second_derivative(Formula::named("U"), system.letter(theta));
    let at = system.letter(theta).equals(Formula::named(angle));
    Formula::List(vec![at, derivative.equals(value.to_formula(&system.symbols))])
}

/// Writes ω₀² = (d²U/dθ²)/I at θ = 0 and ω₀; returns ω₀².
fn frequency(
    system: &System,
    theta: Symbol,
    moment: &RationalFunction,
    sign: Relation,
    s: &mut Section,
) -> RationalFunction {
    let second = system.potential.derivative(theta).derivative(theta);
    let square = at_angle(&second, theta, [0, 1]).and_then(|stiffness| stiffness.over(moment));
    let square = square.unwrap_or_else(RationalFunction::zero);
    let omega = || Formula::named("omega_0");
    let letter = |order: u8| (0..order).try_fold(theta, |symbol, _| symbol.dot());
    let acceleration = letter(2).map_or_else(|| Formula::text("?"), |symbol| system.letter(symbol));
    let right = Formula::product(vec![omega().squared(), system.letter(theta)]).negative();
    put(s, &acceleration.related(sign, right));
    let root = square.square_root(&system.symbols).to_formula(&system.symbols);
    put(s, &omega().equals(root));
    square
}

/// Writes I, M d and ω₀ of a few particles in their masses and their distances from the axis.
fn particles(
    scenario: &Scenario,
    axis: Direction<Body>,
    square: &RationalFunction,
    system: &mut System,
    s: &mut Section,
) -> Result<(), LagrangianError> {
    let particles = scenario.particles();
    if !scenario.is_all_particles() || !(1..=MOST_PARTICLES).contains(&particles.len()) {
        return Ok(());
    }
    let across = |v: Direction<Body>| v - axis * axis.dot(v);
    let Some(arm) = across(plain(scenario.rotor().lever())).direction() else { return Ok(()) };
    let (mut mass, mut moment, mut static_moment) =
        (RationalFunction::zero(), RationalFunction::zero(), RationalFunction::zero());
    let mut values = Vec::new();
    let mut symbols = system.symbols.clone();
    for (k, particle) in particles.iter().enumerate() {
        let from_axis = across(plain(particle.position() - scenario.rotor().point()));
        let distance = arm.dot(from_axis);
        // The sum M d = Σ m r needs particles in the plane of the axis and the centre of mass.
        if (from_axis - arm * distance).norm() > PARALLEL * from_axis.norm() {
            return Ok(());
        }
        let declared =
            |name: &str, symbols: &mut Symbols| symbols.declare(&format!("{name}_{}", k + 1), Kind::Positive);
        let m = RationalFunction::from(declared("m", &mut symbols)?);
        let r = RationalFunction::from(declared("r", &mut symbols)?);
        mass = mass + &m;
        static_moment = static_moment + &m * &r;
        moment = moment + &m * &r * &r;
        let [m_letter, r_letter] = [&m, &r].map(|letter| letter.to_formula(&symbols).to_text());
        values.push(format!("{m_letter} = {} kg,  {r_letter} = {} m", n(particle.mass()), n(distance)));
    }
    s.say("The body consists of particles of masses m_k at the distances r_k from the axis, negative on the other side of it. So:");
    let arm = static_moment.over(&mass).unwrap_or_else(RationalFunction::zero);
    let with = |name: &str, f: &RationalFunction, value: &RationalFunction| {
        f.substituted(symbols.find(name)?, value)
    };
    let square =
        with("M", square, &mass).and_then(|f| with("d", &f, &arm)).and_then(|f| with("I", &f, &moment));
    put(s, &Formula::named("I").equals(moment.to_formula(&symbols)));
    put(
        s,
        &Formula::product(vec![Formula::named("M"), Formula::named("d")])
            .equals(static_moment.to_formula(&symbols)),
    );
    if let Some(square) = square {
        put(s, &Formula::named("omega_0").squared().equals(square.to_formula(&symbols)));
    }
    values.iter().for_each(|line| s.line(line));
    Ok(())
}

/// Returns true if a body stays on an axis along its run, which holds the pivot only.
fn stays_on(scenario: &Scenario, axis: Direction<Body>, run: &Trajectory) -> bool {
    let start = scenario.start().attitude * axis;
    let fastest = run.samples().iter().map(|sample| sample.state.omega.norm()).fold(0.0, f64::max);
    let stays = |State { attitude, omega, .. }: &State| {
        omega.cross(axis).norm() <= PARALLEL * fastest && (*attitude * axis).cross(start).norm() <= PARALLEL
    };
    run.samples().iter().all(|sample| stays(&sample.state))
}

/// Returns the motion of a pendulum: that of the run, or the closed form if the body leaves its axis
/// there.
fn swinging(
    scenario: &Scenario,
    pendulum: &Pendulum,
    axis: Direction<Body>,
    run: &Trajectory,
    stays: bool,
) -> Result<Motion, LagrangianError> {
    let rotor = scenario.rotor();
    let Some(TorqueModel::Gravity(gravity)) = scenario.torques().first() else {
        return Err(LagrangianError::because("a pendulum needs gravity"));
    };
    let start = scenario.start();
    let closed = pendulum.motion(pendulum.angle(), axis.dot(start.omega))?;
    let mut instants = Vec::new();
    for sample in run.samples() {
        let (state, acceleration) = if stays {
            (sample.state, axis.dot(rotor.acceleration(sample.state.omega, sample.torque)))
        } else {
            let (angle, rate) = closed.at(sample.state.time - start.time);
            let turn: Rotation<Body, Body> = Rotation::from_axis_angle(axis, angle - pendulum.angle())
                .map_err(|_| LagrangianError::because("its angle is not finite"))?;
            let omega = AngularVelocity::from_array((axis * rate).to_array());
            let state = State { time: sample.state.time, attitude: start.attitude * turn, omega };
            let torque = TorqueModel::Gravity(*gravity).torque(rotor, &state);
            (state, axis.dot(torque) / pendulum.moment())
        };
        let g: Acceleration<Body> = state.attitude.inverse() * gravity.acceleration;
        let angle = Pendulum::hung(rotor, axis, g)?.angle();
        let coordinates = vec![[angle, axis.dot(state.omega), acceleration]];
        instants.push(Instant { time: state.time, coordinates, others: Vec::new() });
    }
    Ok(Motion { instants, left_out: 0 })
}
