//! Balls, disks and cylinders that roll along a line.

use polhode::math::{AngularVelocity, Direction, Space};
use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{ContactPhase, ContactStart, ContactState, GroundShape, SurfaceShape};
use polhode::motion::{GroundContact, Scenario, Simulation, Trajectory};
use polhode_algebra::{Formula, Kind, RationalFunction, Symbol, Variable};
use polhode_document::Section;
use polhode_document::number::tidy_beside;

use super::case::Case;
use super::error::LagrangianError;
use super::system::{Constant, System, half_square, velocity};
use super::verify::{Instant, Motion, plain};
use super::write::{n, put};

/// Relative departure from a line up to which a body moves along it.
const STRAIGHT: f64 = 1e-9;

/// Returns T = ½ M ẋ² + ½ I φ̇².
pub(super) fn kinetic(
    mass: &RationalFunction,
    moment: &RationalFunction,
    [x, phi]: [Symbol; 2],
) -> [RationalFunction; 2] {
    [half_square(mass, &velocity(x)), half_square(moment, &velocity(phi))]
}

/// Line along which a body rolls.
struct Line {
    /// Direction of x.
    along: Direction<Space>,
    /// Axis of the angle φ.
    axis: Direction<Space>,
    /// Distance of the centre from the ground, m.
    radius: f64,
}

/// Returns the system of a body that rolls along a line.
pub(super) fn rolling(
    scenario: &Scenario,
    ground: &GroundContact,
    run: Option<&Trajectory>,
) -> Result<Case, LagrangianError> {
    let states: Vec<ContactState> = match run.and_then(|run| run.channel(CONTACT)) {
        Some(states) => states.iter().collect(),
        None => {
            let start = ContactStart { state: scenario.start(), at: ground.at, velocity: ground.velocity };
            let motion = Simulation::on_ground(scenario.body(), &ground.contact, start, &[]).run()?;
            motion.channel(CONTACT).map(|states| states.start()).into_iter().collect()
        }
    };
    let Some(start) = states.first() else {
        return Err(LagrangianError::because("the run has no samples"));
    };
    let line = Line::of(scenario, ground, start)?;
    for state in &states {
        line.check(state)?;
    }
    let rotor = scenario.rotor();
    let body_axis = start.state.attitude.inverse() * line.axis;
    let g = ground.contact.gravity;
    let slope = line.along.dot(g) / g.norm();
    let is_sloping = slope.abs() > STRAIGHT;
    let mut system = System::new();
    let mass = system.constant("M", rotor.mass(), "kg", "mass")?;
    let about = rotor.inertia().about_axis(body_axis);
    let momentum = plain(rotor.angular_momentum(AngularVelocity::from_array(body_axis.to_array())));
    if (momentum - body_axis * about).norm() > STRAIGHT * about {
        return Err(LagrangianError::because(
            "the axis of rolling is not a principal axis, so the body wobbles",
        ));
    }
    let moment = system.constant("I", about, "kg·m²", "moment about the axis of rolling")?;
    let radius = system.constant("a", line.radius, "m", "distance of the centre from the ground")?;
    let mut weight = RationalFunction::zero();
    if is_sloping {
        let size = system.constant("g", g.norm(), "m/s²", "gravity")?;
        let alpha = system.symbols.declare("alpha", Kind::Constant)?;
        let (value, unit, meaning) = (slope.asin(), "rad", "slope of the plane");
        system.constants.push(Constant { symbol: alpha, value, unit, meaning });
        weight = &mass * size * RationalFunction::from(Variable::Sine(alpha));
    }
    let x = system.coordinate("x", "m", line.radius)?;
    let phi = system.symbols.declare("phi", Kind::Coordinate)?;
    let lambda = system.symbols.declare("lambda", Kind::Constant)?;
    let free = kinetic(&mass, &moment, [x, phi]);
    system.potential = -(&weight * RationalFunction::from(x));
    let mut coordinates = Section::new(1, "Coordinates");
    coordinates.say("The centre moves along a line, by x, and the body turns by φ about an axis with a constant direction. It rolls without slipping, v + ω × r = 0, where r leads from the centre to the point of contact. Along the line this is the constraint");
    let rolled = RationalFunction::from(phi) * &radius;
    put(&mut coordinates, &system.letter(x).equals(rolled.to_formula(&system.symbols)));
    coordinates.say("It is holonomic, because it can be integrated. So one reduced coordinate is enough: x, with φ = x/a put into T. The multiplier λ then gives the force of friction.");
    let rate = velocity(x).over(&radius);
    let reduced = |f: &RationalFunction| f.substituted(phi.dot()?, rate.as_ref()?);
    system.kinetic = free.iter().filter_map(reduced).collect();
    let mut s = Section::new(5, "Solution and force of constraint");
    let multiplier = multiplier(&system, &free, [x, phi], &radius, lambda, &mut s);
    let others = multiplier.unwrap_or_default();
    if is_sloping {
        s.say("The body has no equilibrium on the slope: its acceleration is constant.");
    } else {
        s.say("The ground is level: every position is an equilibrium, a neutral one without oscillations, and the velocity is constant.");
    }
    let instant = |state: &ContactState| line.instant(scenario, ground, start, state, [phi, lambda]);
    let motion = run.map(|_| Motion { instants: states.iter().map(instant).collect(), left_out: 0 });
    let [friction, ..] = tidy_beside([line.along.dot(start.friction), 0.0, 0.0], start.normal_force);
    s.line(format!("friction along x at the start: λ = {} N", n(friction)));
    let name = match ground.contact.surface.shape() {
        SurfaceShape::Rim { .. } => "a rolling disk",
        SurfaceShape::Cylinder { .. } => "a rolling cylinder",
        _ => "a rolling ball",
    };
    let energies = "T is the energy of the centre of mass and of the rotation about it, ½ M x\u{307}² + ½ I φ\u{307}², with φ\u{307} = x\u{307}/a. U decreases down the slope:";
    Ok(Case { motion, others, ..Case::new(name, system, energies, [coordinates, s]) })
}

/// Writes Lagrange's equations of x and φ with the multiplier λ of the constraint x − a φ = 0, and
/// their solution; returns the equations.
fn multiplier(
    system: &System,
    free: &[RationalFunction; 2],
    [x, phi]: [Symbol; 2],
    radius: &RationalFunction,
    lambda: Symbol,
    s: &mut Section,
) -> Option<Vec<(String, RationalFunction)>> {
    let symbols = &system.symbols;
    let acceleration = x.dot()?.dot()?;
    // The reduced equation is linear in ẍ.
    let equation = system.lagrangian().lagrange_equation(x, symbols);
    let rest = equation.substituted(acceleration, &RationalFunction::zero())?;
    let solved = (-rest).over(&equation.derivative(acceleration))?;
    s.say("The equation of motion gives the acceleration:");
    put(s, &system.letter(acceleration).equals(solved.to_formula(symbols)));
    s.say("With both coordinates and the multiplier λ of the constraint f = x − a φ = 0, Lagrange's equations are (d/dt) ∂L/∂q\u{307} − ∂L/∂q = λ ∂f/∂q:");
    let lagrangian = free[0].plus(&free[1]) - &system.potential;
    let constraint = RationalFunction::from(x) - radius.times(&phi.into());
    let mut equations = Vec::new();
    for q in [x, phi] {
        let left = lagrangian.lagrange_equation(q, symbols);
        let right = RationalFunction::from(lambda) * constraint.derivative(q);
        put(s, &system.collected(&left, &[]).equals(right.to_formula(symbols)));
        equations.push((format!("equation of {} with λ", system.letter(q).to_text()), left - right));
    }
    let force = lagrangian.lagrange_equation(x, symbols).substituted(acceleration, &solved)?;
    s.say("λ is the force of friction along x:");
    put(s, &Formula::named("lambda").equals(force.to_formula(symbols)));
    Some(equations)
}

impl Line {
    fn of(
        scenario: &Scenario,
        ground: &GroundContact,
        start: &ContactState,
    ) -> Result<Self, LagrangianError> {
        let contact = &ground.contact;
        let because = |why: &str| Err(LagrangianError::because(why));
        if !matches!(contact.ground.shape(), GroundShape::Plane) || contact.ground.turning() != 0.0 {
            return because("the body must roll on a plane at rest");
        }
        if matches!(contact.surface.shape(), SurfaceShape::Ellipsoid { .. }) {
            return because("the body must roll on a sphere, a rim or a cylinder");
        }
        let resistance = contact.law.resistance();
        if resistance.rolling > 0.0 || resistance.pivoting > 0.0 {
            return because("rolling or pivoting friction dissipates energy");
        }
        let normal = start.normal;
        let arm = plain(start.center - start.contact);
        let radius = normal.dot(arm);
        if (arm - normal * radius).norm() > STRAIGHT * radius {
            return because(
                "the centre of mass is not above the point of contact: the body is tilted or unbalanced",
            );
        }
        let offset: Direction<Space> =
            start.state.attitude * plain(contact.surface.center() - scenario.body().center_of_mass());
        if normal.dot(offset).abs() > STRAIGHT * radius {
            return because("the centre of mass is not on the axis of the surface: the body is unbalanced");
        }
        let g = plain(contact.gravity);
        let downhill = g - normal * normal.dot(g);
        let velocity = plain(start.velocity);
        let along = if downhill.norm() > STRAIGHT * g.norm() { downhill } else { velocity };
        let Some(along) = along.direction() else {
            return because("the body is at rest on level ground, which determines no line");
        };
        Ok(Self { along, axis: normal.cross(along), radius })
    }

    /// Checks that a state is one of rolling along the line.
    fn check(&self, state: &ContactState) -> Result<(), LagrangianError> {
        let because = |why: String| Err(LagrangianError::because(why));
        let time = n(state.state.time);
        if state.phase != ContactPhase::Rolling {
            return because(format!("the body does not roll at t = {time} s: {}", state.phase.name()));
        }
        let speed = state.velocity.norm();
        let across = plain(state.velocity) - self.along * self.along.dot(state.velocity);
        if across.norm() > STRAIGHT * speed {
            return because(format!(
                "the centre does not move along a line: at t = {time} s its velocity has another direction"
            ));
        }
        let omega = state.state.omega_space();
        let across = plain(omega) - self.axis * self.axis.dot(omega);
        if across.norm() > STRAIGHT * omega.norm() {
            return because(format!(
                "the body does not only roll along its line: at t = {time} s ω has another direction"
            ));
        }
        Ok(())
    }

    /// Returns x, ẋ and ẍ, where ẍ follows from the forces, with φ̈ and λ.
    fn instant(
        &self,
        scenario: &Scenario,
        ground: &GroundContact,
        start: &ContactState,
        state: &ContactState,
        [phi, lambda]: [Symbol; 2],
    ) -> Instant {
        let mass = scenario.rotor().mass();
        let moved = self.along.dot(state.center - start.center);
        let friction = self.along.dot(state.friction);
        let acceleration = friction / mass + self.along.dot(ground.contact.gravity);
        let turning = scenario.rotor().acceleration(state.state.omega, state.torque);
        let axis = state.state.attitude.inverse() * self.axis;
        let second = phi.dot().and_then(Symbol::dot).map(|symbol| (symbol, axis.dot(turning)));
        let others = second.into_iter().chain([(lambda, friction)]).collect();
        let coordinates = vec![[moved, self.along.dot(state.velocity), acceleration]];
        Instant { time: state.state.time, coordinates, others }
    }
}
