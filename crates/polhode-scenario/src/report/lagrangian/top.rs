//! Tops in Euler angles: the heavy symmetric top, and the body without torque.

use polhode::body::Symmetry;
use polhode::math::{Body, Direction, Space};
use polhode::motion::torque::UniformGravity;
use polhode::motion::{HeavyTop, MotionError, Scenario, Trajectory};
use polhode_algebra::{Formula, Kind, RationalFunction, Symbol};
use polhode_document::Section;

use super::case::Case;
use super::error::LagrangianError;
use super::euler_angles::{Axes, omega};
use super::permanent::permanent;
use super::precession::{numbers, steady};
use super::system::{BodyRates, System, cosine, half_square};
use super::verify::plain;
use super::write::put;

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
            LagrangianError::because("gravity turns a body only if a point of it is held, and this body has no pivot")
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
    let (pole, why) = match is_near_pole {
        false => ("z", ""),
        true => ("x", ", because axis 3 starts near the z axis, where φ and ψ are undefined"),
    };
    let axes_of_body = match axis {
        Some((axis, _)) => {
            format!("Axis 3 of the body is its symmetry axis, along {} in body axes.", triple(axis))
        }
        None => "The axes of the body are its principal axes 1, 2, 3, with ascending moments.".to_owned(),
    };
    coordinates.say(format!(
        "No torque acts. The rotation about {point} has three degrees of freedom. The polar axis is the {pole} axis of space{why}. {axes_of_body} {ANGLES}"
    ));
    let mut system = System::new();
    let mut s = Section::new(5, "Steady motions and small oscillations");
    let (energies, square) = match axis {
        Some((_, [across, axial])) => {
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
            ("Along the principal axes the products of inertia are zero:", square)
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

/// Formats a unit vector.
fn triple(direction: Direction<Body>) -> String {
    polhode_document::number::vector(
        polhode_document::number::tidy(direction.direction().unwrap_or(direction).to_array()),
        6,
    )
}
