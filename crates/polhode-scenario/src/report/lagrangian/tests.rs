//! The known equations of the heavy top, and errors planted in T, U and H that the verification
//! finds.

use std::path::Path;

use polhode_algebra::{RationalFunction, Symbol, Symbols, Variable, parse};
use polhode_source::files::Memory;

use super::case::Case;
use super::verify::Course;
use super::{Formalism, LagrangianError, recognized};
use crate::read::ScenarioFile;

const TOP: &str = "
[[body.part]]
shape = 'cylinder'
radius = '80 mm'
length = '12 mm'
mass = '0.7 kg'
position = ['0 mm', '0 mm', '60 mm']
[start]
attitude = { euler313 = ['20 deg', '40 deg', '-70 deg'] }
spin = { body = ['2 rad/s', '-3 rad/s', '70 rad/s'] }
[[torque]]
model = 'gravity'
pivot = ['0 mm', '0 mm', '0 mm']
[run]
duration = '1 s'
samples = 101
";

const PENDULUM: &str = "
[[body.part]]
shape = 'box'
size = ['0.1 m', '0.2 m', '0.3 m']
mass = '2 kg'
position = ['0.25 m', '-0.1 m', '0 m']
[start]
spin = { body = ['0 rad/s', '0 rad/s', '1.3 rad/s'] }
[[torque]]
model = 'gravity'
pivot = ['0 m', '0 m', '0 m']
acceleration = ['3 m/s^2', '-9 m/s^2', '0 m/s^2']
[pendulum]
axis = [0, 0, 1]
[run]
duration = '3 s'
samples = 101
";

const TORSION: &str = "
[[body.part]]
shape = 'box'
size = ['0.3 m', '0.1 m', '0.2 m']
mass = '2 kg'
[start]
attitude = { axis = [0, 0, 1], angle = '70 deg' }
spin = { body = ['0 rad/s', '0 rad/s', '0.3 rad/s'] }
[[torque]]
model = 'torsion'
stiffness = '0.8 N m/rad'
axis = [0, 0, 1]
[run]
duration = '3 s'
samples = 101
";

const FREE: &str = "
[[body.part]]
shape = 'box'
size = ['0.1 m', '0.2 m', '0.3 m']
mass = '2 kg'
rotate = { axis = [1, 2, 3], angle = '50 deg' }
[start]
attitude = { euler313 = ['20 deg', '40 deg', '-70 deg'] }
spin = { body = ['2 rad/s', '-3 rad/s', '4 rad/s'] }
[run]
duration = '3 s'
samples = 101
";

const ROLLING: &str = "
[[body.part]]
shape = 'sphere'
radius = '0.2 m'
mass = '3 kg'
[contact]
surface = { shape = 'sphere', radius = '0.2 m' }
ground = { shape = 'plane', slope = '20 deg' }
law = 'rolling'
[start]
attitude = { axis = [1, 2, 3], angle = '50 deg' }
spin = { space = ['0 rad/s', '-3 rad/s', '0 rad/s'] }
[run]
duration = '2 s'
samples = 51
";

fn case(text: &str) -> (polhode::motion::Scenario, Case) {
    let files = Memory::from([("it.toml", text)]);
    let file = ScenarioFile::parse(&files, text.to_owned(), Path::new("it.toml")).unwrap();
    let run = file.scenario.simulate().unwrap().unwrap();
    let case = recognized(&file.scenario, Some(&run)).unwrap();
    (file.scenario, case)
}

fn value(text: &str, symbols: &Symbols) -> RationalFunction {
    parse(text, symbols).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// Goldstein, *Classical Mechanics*, 3rd edition, eqs. 5.52 to 5.62, with the moment I₁ written out:
/// his a and b are p_ψ/I₁ and p_φ/I₁.
#[test]
fn heavy_top_of_goldstein() {
    let (_, case) = case(TOP);
    let (system, symbols) = (&case.system, &case.system.symbols);
    let of = |text: &str| value(text, symbols);
    let lagrangian = of(
        "I_1/2*(theta_dot^2 + phi_dot^2*sin(theta)^2) + I_3/2*(psi_dot + phi_dot*cos(theta))^2 - M*g*l*cos(theta)",
    );
    assert_eq!(system.lagrangian(), lagrangian);
    let coordinates = system.coordinates.iter().map(|c| c.symbol).collect::<Vec<_>>();
    assert_eq!(lagrangian.energy_function(&coordinates), system.energy());
    let [phi, theta, psi] = [0, 1, 2].map(|k| system.coordinates[k].symbol);
    assert_eq!(lagrangian.momentum(psi), of("I_3*(psi_dot + phi_dot*cos(theta))"));
    assert_eq!(
        lagrangian.momentum(phi),
        of("(I_1*sin(theta)^2 + I_3*cos(theta)^2)*phi_dot + I_3*psi_dot*cos(theta)")
    );
    assert_eq!(
        lagrangian.lagrange_equation(theta, symbols),
        of(
            "I_1*theta_ddot - I_1*phi_dot^2*sin(theta)*cos(theta) + I_3*(psi_dot + phi_dot*cos(theta))*phi_dot*sin(theta) - M*g*l*sin(theta)"
        )
    );
    let h = system.hamiltonian().unwrap();
    assert_eq!(h.velocities[0], of("(p_phi - p_psi*cos(theta))/(I_1*sin(theta)^2)"));
    assert_eq!(h.velocities[2], of("p_psi/I_3 - cos(theta)*(p_phi - p_psi*cos(theta))/(I_1*sin(theta)^2)"));
    let effective = "(p_phi - p_psi*cos(theta))^2/(2*I_1*sin(theta)^2) + M*g*l*cos(theta)";
    assert_eq!(h.function, of(&format!("p_theta^2/(2*I_1) + {effective} + p_psi^2/(2*I_3)")));
    // The terms that are printed have the sum H.
    assert_eq!(h.terms.iter().fold(RationalFunction::zero(), |sum, term| sum + term), h.function);
}

/// Flips the sign of a function.
fn flipped(f: &mut RationalFunction) {
    *f = -&*f;
}

#[test]
fn planted_signs_are_found() {
    type Defect = fn(&mut Case);
    let potential: Defect = |case| flipped(&mut case.system.potential);
    let last: Defect = |case| case.system.kinetic.iter_mut().rev().take(1).for_each(flipped);
    let constant: Defect = |case| case.system.constants[0].value *= 1.0 + 1e-4;
    for (text, defects) in [
        (TOP, &[potential, last, constant][..]),
        (PENDULUM, &[potential, last, constant]),
        (TORSION, &[potential, last, constant]),
        (FREE, &[last, constant]),
        (ROLLING, &[potential, last]),
    ] {
        for formalism in [Formalism::Lagrange, Formalism::Hamilton] {
            let (scenario, right) = case(text);
            right.document(&scenario, formalism, None).unwrap();
            for (k, defect) in defects.iter().enumerate() {
                let (scenario, mut wrong) = case(text);
                defect(&mut wrong);
                let error = wrong.document(&scenario, formalism, None).unwrap_err();
                assert!(matches!(error, LagrangianError::NotVerified { .. }), "{text}: defect {k}: {error}");
            }
        }
    }
}

/// A force of friction with the other sign, in the equations with the multiplier.
#[test]
fn planted_friction_is_found() {
    let (scenario, mut wrong) = case(ROLLING);
    let motion = wrong.motion.as_mut().unwrap();
    for instant in &mut motion.instants {
        instant.others.last_mut().unwrap().1 *= -1.0;
    }
    let error = wrong.document(&scenario, Formalism::Lagrange, None).unwrap_err();
    assert!(matches!(error, LagrangianError::NotVerified { .. }), "{error}");
}

/// H is T + U of the engine, up to the level of U.
#[test]
fn hamiltonian_is_the_energy_of_the_engine() {
    for text in [TOP, PENDULUM, TORSION, FREE] {
        let (scenario, case) = case(text);
        let run = scenario.simulate().unwrap().unwrap();
        let course = Course::of(&case.system, case.motion.as_ref().unwrap()).unwrap();
        let h = case.system.hamiltonian().unwrap();
        let sample = run.samples()[0];
        let engine = sample.kinetic_energy + sample.potential_energy.unwrap_or(0.0);
        let value = course.first(&h.function).unwrap();
        assert!(
            (value - engine).abs() < 1e-13 * (engine.abs() + sample.kinetic_energy),
            "{text}: {value} {engine}"
        );
    }
}

/// The equations of the asymmetric top are printed with the letters ω₁ … and L₁ …; with their values
/// they are those that are verified.
#[test]
fn letters_stand_for_their_values() {
    let (_, case) = case(FREE);
    let system = &case.system;
    let (body, h) = (system.body.as_ref().unwrap(), system.hamiltonian().unwrap());
    let sum = |terms: Vec<RationalFunction>, letters: &[Symbol], values: &[RationalFunction]| {
        let sum = terms.iter().fold(RationalFunction::zero(), |sum, term| sum + term);
        let place = |v: Variable| letters.iter().position(|letter| v == Variable::Symbol(*letter));
        sum.replaced(&|v| Some(place(v).map_or_else(|| v.into(), |k| values[k].clone()))).unwrap()
    };
    let momenta = system.body_momenta(&h);
    for c in &system.coordinates {
        let [momentum, force] = [c.symbol.dot().unwrap(), c.symbol]
            .map(|symbol| sum(body.derivative(symbol), &body.omega, &body.values));
        let equation = system.lagrangian().lagrange_equation(c.symbol, &system.symbols);
        assert_eq!(momentum.time_derivative(&system.symbols) - force, equation);
        for symbol in [c.symbol, c.momentum] {
            let slope = sum(system.slope(&h, symbol), &body.momenta, &momenta);
            assert_eq!(slope, h.function.derivative(symbol));
        }
    }
}
