//! Tops in Euler angles: the heavy symmetric top, and the body without torque.

use polhode::body::Symmetry;
use polhode::math::{Body, Direction, Space};
use polhode::motion::torque::UniformGravity;
use polhode::motion::{HeavyTop, MotionError, Scenario, Trajectory};
use polhode_algebra::{
    Formula, Kind, RationalFunction, Relation, RemainingRoots, RootPair, Symbol, Univariate, Variable,
};
use polhode_document::Section;
use polhode_document::unit::rate;

use super::case::{Case, n, put, second_derivative};
use super::error::LagrangianError;
use super::euler_angles::{Axes, omega};
use super::system::{BodyRates, System, at_angle, collected, cosine, half_square, sine};
use super::verify::plain;

/// Angle from the polar axis, as a sine, below which another polar axis is used.
const NEAR_POLE: f64 = 0.1;

const ANGLES: &str = "The notes' Euler angles 3-1-3 lead from the axes of space to those of the body: first the precession φ about the polar axis, then the nutation θ about the line of nodes, then the spin ψ about axis 3 of the body. \
    θ is the angle between the polar axis and axis 3. The components of ω along the axes of the body are:";

/// Returns T = ½ I₁ ω₁² + ½ I₂ ω₂² + ½ I₃ ω₃² in the Euler angles φ, θ, ψ, term by term.
pub(super) fn kinetic(moments: &[RationalFunction; 3], angles: [Symbol; 3]) -> [RationalFunction; 3] {
    let omega = omega(angles);
    std::array::from_fn(|k| half_square(&moments[k], &omega[k]))
}

/// Returns U = w cos θ for the weight w = M g l.
pub(super) fn gravity(weight: &RationalFunction, theta: Symbol) -> RationalFunction {
    weight * cosine(theta)
}

/// Returns the heavy top of a scenario that is held at a point of its symmetry axis.
pub(super) fn heavy(
    scenario: &Scenario,
    gravity_model: &UniformGravity,
    run: Option<&Trajectory>,
) -> Result<Case, LagrangianError> {
    let rotor = scenario.rotor();
    let top = HeavyTop::of(rotor, gravity_model, scenario.start()).map_err(|error| match error {
        MotionError::NoClosedForm { .. } if !rotor.is_pivoted() => {
            LagrangianError::because("gravity turns a body only if a point of it is held, and there is no pivot")
        }
        MotionError::NoClosedForm { .. } => LagrangianError::because(
            "under gravity without [pendulum], the body must be symmetric about the line from the pivot to its centre of mass, and gravity must act",
        ),
        error => error.into(),
    })?;
    let [across, axial] = top.moments();
    let g = gravity_model.acceleration;
    let e = plain(rotor.lever());
    let axes = Axes::along(-plain(g), e)?;
    if axial == 0.0 {
        return Err(LagrangianError::because(
            "the body has no moment about its axis, so ψ has no kinetic energy; [pendulum] with an axis makes it a plane pendulum",
        ));
    }
    let mut system = System::new();
    let i1 = system.constant("I_1", across, "kg·m²", "moment across the symmetry axis, about the pivot")?;
    let i3 = system.constant("I_3", axial, "kg·m²", "moment about the symmetry axis")?;
    let mass = system.constant("M", rotor.mass(), "kg", "mass")?;
    let gravity_size = system.constant("g", g.norm(), "m/s²", "gravity")?;
    let lever =
        system.constant("l", rotor.lever().norm(), "m", "distance of the centre of mass from the pivot")?;
    let angles = symmetric(&mut system, &i1, &i3)?;
    let weight = mass * gravity_size * lever;
    system.potential = gravity(&weight, angles[1]);
    let mut coordinates = Section::new(1, "Coordinates");
    coordinates.say(format!(
        "One point of the body is held: it has three degrees of freedom. The polar axis is the upward vertical, and axis 3 of the body leads from the pivot to the centre of mass, along {} in body axes. {ANGLES}",
        triple(e)
    ));
    rates(&system, angles, &mut coordinates);
    let motion = run.map(|run| axes.motion(rotor, run.samples()));
    let mut s = Section::new(5, "Effective potential, precession and nutation");
    if let Some(steady) = steady(&mut system, angles, &i1, Some(&weight), &mut s) {
        numbers(&system, &top, &steady, &mut s);
    }
    let name = "a heavy symmetric top";
    let energies = "T = ½ I₁ (ω₁² + ω₂²) + ½ I₃ ω₃², in which ψ drops out. U is the energy of the weight, zero when the centre of mass is level with the pivot:";
    Ok(Case { motion, ..Case::new(name, system, energies, [coordinates, s]) })
}

/// Returns the free motion of a scenario without torque.
pub(super) fn free(scenario: &Scenario, run: Option<&Trajectory>) -> Result<Case, LagrangianError> {
    let rotor = scenario.rotor();
    let principal = rotor.principal();
    let [a, b, c] = principal.moments();
    let axis = match principal.symmetry() {
        Symmetry::Point | Symmetry::Rod => {
            return Err(LagrangianError::because(
                "the body has no moment of inertia about some axis, so one of its Euler angles has no kinetic energy",
            ));
        }
        Symmetry::Asymmetric => None,
        Symmetry::Prolate => Some((principal.axis(0), [b, a])),
        Symmetry::Oblate => Some((principal.axis(2), [a, c])),
        Symmetry::Spherical => Some((Direction::new(0.0, 0.0, 1.0), [a, c])),
    };
    let [polar, other] = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]].map(Direction::<Space>::from_array);
    let of = |polar: Direction<Space>| match axis {
        Some((axis, _)) => Axes::along(polar, axis),
        None => Ok(Axes { body: principal.rotation(), ..Axes::along(polar, principal.axis(2))? }),
    };
    let mut axes = of(polar)?;
    let is_near_pole = axes.angles(scenario.start().attitude)[1].sin() < NEAR_POLE;
    if is_near_pole {
        axes = of(other)?;
    }
    let point = if rotor.is_pivoted() { "the pivot" } else { "the centre of mass" };
    let mut coordinates = Section::new(1, "Coordinates");
    coordinates.say(format!(
        "No torque acts. The rotation about {point} has three degrees of freedom. The polar axis is the {} axis of space{}. {} {ANGLES}",
        if is_near_pole { "x" } else { "z" },
        if is_near_pole { ", because axis 3 starts near the z axis, where φ and ψ are undefined" } else { "" },
        if axis.is_some() { "Axis 3 of the body is its symmetry axis." } else { "The axes of the body are its principal axes 1, 2, 3, with ascending moments." },
    ));
    let mut system = System::new();
    let mut s = Section::new(5, "Steady motions and small oscillations");
    let (energies, square) = match axis {
        Some((axis, [across, axial])) => {
            coordinates.line(format!("axis 3 = {} in body axes", triple(axis)));
            let i1 = system.constant("I_1", across, "kg·m²", "moment across axis 3")?;
            let i3 = system.constant("I_3", axial, "kg·m²", "moment about axis 3")?;
            let angles = symmetric(&mut system, &i1, &i3)?;
            rates(&system, angles, &mut coordinates);
            steady(&mut system, angles, &i1, None, &mut s);
            let square = momentum_square(&[i1.clone(), i1, i3], angles);
            ("T = ½ I₁ (ω₁² + ω₂²) + ½ I₃ ω₃², in which ψ drops out:", square)
        }
        None => {
            let names = [
                ("I_1", a, "least moment"),
                ("I_2", b, "intermediate moment"),
                ("I_3", c, "greatest moment"),
            ];
            let mut moments = Vec::new();
            for (name, value, meaning) in names {
                moments.push(system.constant(name, value, "kg·m²", meaning)?);
            }
            let moments: [RationalFunction; 3] = std::array::from_fn(|k| moments[k].clone());
            let angles = euler_angles(&mut system)?;
            system.kinetic = kinetic(&moments, angles).to_vec();
            let mut letters = |name: &str| -> Result<[Symbol; 3], LagrangianError> {
                let mut declared = |k: u8| system.symbols.declare(&format!("{name}_{k}"), Kind::Constant);
                Ok([declared(1)?, declared(2)?, declared(3)?])
            };
            let (rates_of_body, momenta) = (letters("omega")?, letters("L")?);
            let values = omega(angles);
            permanent(&system, angles, &moments, &mut s);
            let square = momentum_square(&moments, angles);
            system.body = Some(BodyRates { omega: rates_of_body, momenta, moments, values });
            rates(&system, angles, &mut coordinates);
            ("Along the principal axes there are no products of inertia:", square)
        }
    };
    let motion = run.map(|run| axes.motion(rotor, run.samples()));
    let name = if axis.is_some() { "a free symmetric top" } else { "a free asymmetric top" };
    Ok(Case {
        motion,
        conserved: Some((
            "L²",
            square,
            "No torque acts, so L is constant in space; p_φ is its component along the polar axis. So L² is constant too, the sum of the squares of I₁ ω₁, I₂ ω₂ and I₃ ω₃.",
        )),
        ..Case::new(name, system, energies, [coordinates, s])
    })
}

/// Returns L² = Σ (Iₖ ωₖ)².
fn momentum_square(moments: &[RationalFunction; 3], angles: [Symbol; 3]) -> RationalFunction {
    let components = omega(angles).into_iter().zip(moments).map(|(omega, moment)| omega * moment);
    components.fold(RationalFunction::zero(), |sum, l| sum + &l * &l)
}

fn euler_angles(system: &mut System) -> Result<[Symbol; 3], LagrangianError> {
    Ok([
        system.coordinate("phi", "rad", 1.0)?,
        system.coordinate("theta", "rad", 1.0)?,
        system.coordinate("psi", "rad", 1.0)?,
    ])
}

/// Adds the Euler angles and T of a symmetric body, split into ½ I₁ θ̇² + ½ I₁ φ̇² sin² θ + ½ I₃ ω₃².
fn symmetric(
    system: &mut System,
    i1: &RationalFunction,
    i3: &RationalFunction,
) -> Result<[Symbol; 3], LagrangianError> {
    let angles = euler_angles(system)?;
    let [first, second, third] = kinetic(&[i1.clone(), i1.clone(), i3.clone()], angles);
    let across = first + second;
    let without_phi = angles[0].dot().and_then(|rate| across.substituted(rate, &RationalFunction::zero()));
    let of_theta = without_phi.unwrap_or_else(RationalFunction::zero);
    let of_phi = across - &of_theta;
    system.kinetic = vec![of_theta, of_phi, third];
    Ok(angles)
}

/// Writes ω₁, ω₂ and ω₃.
fn rates(system: &System, angles: [Symbol; 3], s: &mut Section) {
    for (k, value) in omega(angles).iter().enumerate() {
        let letter = Formula::named(&format!("omega_{}", k + 1));
        put(s, &letter.equals(system.collected(value, &[])));
    }
}

/// Writes the effective potential of a symmetric top, its steady motions and small nutations.
fn steady(
    system: &mut System,
    [phi, theta, _]: [Symbol; 3],
    i1: &RationalFunction,
    weight: Option<&RationalFunction>,
    s: &mut Section,
) -> Option<Steady> {
    let [p_phi, _, p_psi] = [0, 1, 2].map(|k| system.coordinates[k].momentum);
    let precession = phi.dot()?;
    let h = system.hamiltonian()?;
    // H = p_θ²/2I₁ + U_eff + p_ψ²/2I₃
    let effective = h.terms[1].plus(&system.potential);
    s.say("p_φ and p_ψ are constant. So θ moves like a particle in one dimension, in the effective potential U_eff, with the energy E_eff = E − p_ψ²/2I₃:");
    let [u_eff, e_eff] = ["U_eff", "E_eff"].map(Formula::named);
    let mut terms = vec![h.terms[1].clone(), system.potential.clone()];
    terms.retain(|term| !term.is_zero());
    put(s, &u_eff.clone().equals(system.sum(&terms)));
    let kinetic = Formula::sum(vec![system.kinetic[0].to_formula(&system.symbols), u_eff.clone()]);
    put(s, &e_eff.equals(kinetic));
    turning(system, theta, &effective, i1, s)?;
    let letters = &system.symbols;
    // p_φ at the rate φ̇, from its definition: I₁ φ̇ sin² θ + p_ψ cos θ.
    let lagrangian = system.lagrangian();
    let [of_phi, of_psi] = [0, 2].map(|k| lagrangian.momentum(system.coordinates[k].symbol));
    let p_phi_value = of_phi - (of_psi - RationalFunction::from(p_psi)) * cosine(theta);
    let slope = effective.derivative(theta);
    let condition = slope.substituted(p_phi, &p_phi_value)?.over(&-sine(theta))?;
    s.say("Steady precession at a constant θ requires dU_eff/dθ = 0. With p_φ at the rate φ\u{307} this is a quadratic equation for the rate:");
    put(s, &system.letter(p_phi).equals(p_phi_value.to_formula(letters)));
    let collected = system.collected(&condition, &[Variable::Symbol(precession)]);
    put(s, &collected.equals(Formula::integer(0)));
    let below = RationalFunction::from(condition.denominator().clone());
    let powers = condition.numerator().coefficients_in(Variable::Symbol(precession)).into_iter();
    let powers: Option<Vec<_>> = powers.map(|c| RationalFunction::from(c).over(&below)).collect();
    let roots = Univariate::new(powers?).roots();
    let rate = || system.letter(precession);
    for (root, _) in roots.rational.iter().filter(|(root, _)| !root.is_zero()) {
        put(s, &rate().equals(root.to_formula(letters)));
    }
    let pair = match roots.rest {
        RemainingRoots::Pair(pair) => Some(pair),
        _ => None,
    };
    if let (Some(pair), Some(weight)) = (&pair, weight) {
        put(s, &rate().equals(pair.to_formula(letters)));
        s.say("For p_ψ > 0 the lower sign is the slow precession, the upper sign the fast one. For a fast top, p_ψ² ≫ 4 I₁ M g l cos θ, they are");
        let spin = RationalFunction::from(p_psi);
        let [slow, fast] = [weight.over(&spin)?, spin.over(&(i1 * cosine(theta)))?];
        let about =
            |value: &RationalFunction| rate().related(Relation::Approximate, value.to_formula(letters));
        put(s, &Formula::List(vec![about(&slow), about(&fast)]));
    }
    s.say("Small nutations about it are harmonic, with Ω² = (d²U_eff/dθ²)/I₁ at constant p_φ and p_ψ. With p_ψ from the condition:");
    // The condition is linear in p_ψ.
    let slope_in_spin = condition.derivative(p_psi);
    let rest = condition.substituted(p_psi, &RationalFunction::zero())?;
    let spin = (-rest).over(&slope_in_spin)?;
    let second = slope.derivative(theta).substituted(p_phi, &p_phi_value)?.substituted(p_psi, &spin)?;
    let square = second.over(i1)?;
    let nutation = Formula::named("Omega").squared();
    put(s, &nutation.equals(system.collected(&square, &[])));
    match weight {
        None => s.say("The nutation has the rate of the precession: in space axis 3 moves on a cone about L, whatever the polar axis."),
        Some(_) => sleeping(system, theta, &effective, [p_phi, p_psi], s)?,
    }
    Some(Steady { pair, square, precession })
}

/// Steady precession of a heavy top in symbols.
struct Steady {
    /// Slow and fast rate φ̇ at θ with p_ψ.
    pair: Option<RootPair>,
    /// Ω² of small nutations at θ with φ̇.
    square: RationalFunction,
    precession: Symbol,
}

/// Writes u̇² as a cubic in u = cos θ, whose roots are the turning points.
fn turning(
    system: &mut System,
    theta: Symbol,
    effective: &RationalFunction,
    i1: &RationalFunction,
    s: &mut Section,
) -> Option<()> {
    let mut symbols = system.symbols.clone();
    let [energy, u] = ["E_eff", "u"].map(|name| symbols.declare(name, Kind::Constant).ok());
    let (energy, u) = (energy?, u?);
    let speed = (RationalFunction::from(energy) - effective) * RationalFunction::from(2);
    let square = speed.over(i1)? * sine(theta) * sine(theta);
    let cubic = square.replaced(&|variable| {
        Some(if variable == Variable::Cosine(theta) { u.into() } else { variable.into() })
    })?;
    s.say("At the turning points θ\u{307} = 0, E_eff = U_eff. With u = cos θ, u\u{307}² = θ\u{307}² sin² θ is a polynomial in u, and u oscillates between two of its roots:");
    let letter = Formula::named("u").accented(polhode_algebra::Accent::Dot).squared();
    put(s, &letter.equals(collected(&cubic, &[Variable::Symbol(u)], &symbols)));
    Some(())
}

/// Writes the condition for a sleeping top, from U_eff at θ = 0 with p_φ = p_ψ.
fn sleeping(
    system: &System,
    theta: Symbol,
    effective: &RationalFunction,
    [p_phi, p_psi]: [Symbol; 2],
    s: &mut Section,
) -> Option<()> {
    let upright = effective.substituted(p_phi, &p_psi.into())?;
    let second = at_angle(&upright.derivative(theta).derivative(theta), theta, [0, 1])?;
    s.say("The sleeping top is upright, with p_φ = p_ψ. It is stable if U_eff has a minimum at θ = 0:");
    let derivative = second_derivative(Formula::named("U_eff"), system.letter(theta));
    let value =
        derivative.equals(system.collected(&second, &[])).related(Relation::Greater, Formula::integer(0));
    put(s, &Formula::List(vec![system.letter(theta).equals(Formula::integer(0)), value]));
    Some(())
}

/// Writes turning points, rates and the threshold of the sleeping top as numbers.
fn numbers(system: &System, top: &HeavyTop, steady: &Steady, s: &mut Section) {
    let [highest, lowest] = top.nutation_bounds();
    let middle = 0.5 * (highest + lowest);
    let [_, axial] = top.moments();
    let (theta, p_psi) = (system.coordinates[1].symbol, system.coordinates[2].momentum);
    s.line(format!(
        "turning points: θ = {}° and {}°: {}",
        n(highest.to_degrees()),
        n(lowest.to_degrees()),
        top.path().description()
    ));
    if let Some(period) = top.nutation_period() {
        s.line(format!("period of the nutation: {} s", n(period)));
    }
    let value = |symbol: Symbol| match symbol {
        symbol if symbol == theta => Some(middle),
        symbol if symbol == p_psi => Some(axial * top.spin()),
        symbol => system.constants.iter().find(|c| c.symbol == symbol).map(|c| c.value),
    };
    let rates = steady.pair.as_ref().and_then(|pair| {
        let (center, deviation) = (pair.center.evaluate(&value)?, pair.deviation.evaluate(&value)?);
        Some([center - deviation.copysign(center), center + deviation.copysign(center)])
    });
    let is_vertical = top.roots().is_none();
    if let Some(rates) = rates.filter(|_| !is_vertical) {
        for (name, precession) in ["slow", "fast"].into_iter().zip(rates) {
            let with =
                |symbol: Symbol| if symbol == steady.precession { Some(precession) } else { value(symbol) };
            let nutation =
                steady.square.evaluate(&with).map_or_else(|| "—".to_owned(), |square| n(square.sqrt()));
            s.line(format!(
                "{name} steady precession at θ = {}°: φ\u{307} = {},  nutation about it Ω = {nutation} rad/s",
                n(middle.to_degrees()),
                rate(precession)
            ));
        }
    } else if !is_vertical {
        s.line(format!("no steady precession at θ = {}° with this spin", n(middle.to_degrees())));
    }
    let threshold = top.sleeping_threshold();
    s.line(format!(
        "the top sleeps above ω3 = 2 √(I1 M g l)/I3 = {} rad/s; here ω3 = {} rad/s",
        n(threshold),
        n(top.spin())
    ));
}

/// Writes the permanent rotations about axes 2 and 1 of a free body, and small deviations from them.
fn permanent(
    system: &System,
    [_, theta, psi]: [Symbol; 3],
    moments: &[RationalFunction; 3],
    s: &mut Section,
) -> Option<()> {
    let h = system.hamiltonian()?;
    let [p_phi, p_theta, p_psi] = [0, 1, 2].map(|k| system.coordinates[k].momentum);
    let variables = [theta, psi, p_theta, p_psi];
    s.say("A rotation about a principal axis at the constant rate ω is steady. With the polar axis along it θ = 90°, and ψ = 0 for axis 2, ψ = 90° for axis 1. Small deviations of θ, ψ, p_θ and p_ψ follow the linearized canonical equations at p_φ = I ω. They grow or oscillate as exp(λ t), with:");
    let mut symbols = system.symbols.clone();
    let omega = RationalFunction::from(symbols.declare("omega", Kind::Constant).ok()?);
    for (axis, angle) in [(1, [0, 1]), (0, [1, 0])] {
        let steady = |f: &RationalFunction| {
            let f = at_angle(&at_angle(f, theta, [1, 0])?, psi, angle)?;
            let f = f
                .substituted(p_theta, &RationalFunction::zero())?
                .substituted(p_psi, &RationalFunction::zero())?;
            f.substituted(p_phi, &moments[axis].times(&omega))
        };
        // d/dt (θ, ψ, p_θ, p_ψ) = J ∇H
        let mut matrix = Vec::new();
        for row in [p_theta, p_psi, theta, psi] {
            let sign =
                if row == theta || row == psi { -RationalFunction::one() } else { RationalFunction::one() };
            let slope = h.function.derivative(row) * sign;
            if !steady(&slope)?.is_zero() {
                return None;
            }
            matrix.push(variables.iter().map(|&v| steady(&slope.derivative(v))).collect::<Option<Vec<_>>>()?);
        }
        let squares = Univariate::new(even_characteristic(&matrix)?).roots().rational;
        let square =
            |root: &RationalFunction| Formula::named("lambda").squared().equals(root.to_formula(&symbols));
        s.say(format!("About axis {}:", axis + 1));
        put(s, &Formula::List(squares.iter().map(|(root, _)| square(root)).collect()));
    }
    s.say("λ² = −ω² only means that L is not along the polar axis. The other one is negative for the axes of the least and the greatest moment, whose rotations are stable. It is positive for the intermediate axis: that rotation is unstable.");
    Some(())
}

/// Returns c₀, c₁ and 1 of the characteristic polynomial c₀ + c₁ λ² + λ⁴ of a matrix of order 4, by
/// the method of Faddeev and LeVerrier; `None` if it has odd powers of λ.
fn even_characteristic(matrix: &[Vec<RationalFunction>]) -> Option<Vec<RationalFunction>> {
    let zero = RationalFunction::zero;
    let product = |a: &[Vec<RationalFunction>], b: &[Vec<RationalFunction>]| -> Vec<Vec<RationalFunction>> {
        let element = |i: usize, j: usize| (0..4).fold(zero(), |sum, k| sum + &a[i][k] * &b[k][j]);
        (0..4).map(|i| (0..4).map(|j| element(i, j)).collect()).collect()
    };
    let mut coefficients = vec![RationalFunction::one()];
    let mut power: Vec<Vec<_>> =
        (0..4).map(|i| (0..4).map(|j| RationalFunction::from(i64::from(i == j))).collect()).collect();
    for k in 1..=4_i64 {
        power = product(matrix, &power);
        let trace = (0..4).fold(zero(), |sum, i| sum + &power[i][i]);
        let c = -trace.over(&RationalFunction::from(k))?;
        for (i, row) in power.iter_mut().enumerate() {
            row[i] = &row[i] + &c;
        }
        coefficients.push(c);
    }
    let [first, odd, second, third, last] = <[_; 5]>::try_from(coefficients).ok()?;
    (odd.is_zero() && third.is_zero()).then(|| vec![last, second, first])
}

/// Formats a unit vector.
fn triple(direction: Direction<Body>) -> String {
    polhode_document::number::vector(
        polhode_document::number::tidy(direction.direction().unwrap_or(direction).to_array()),
        6,
    )
}
