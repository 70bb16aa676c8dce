//! Conserved quantities.

use polhode::math::{Direction, Rotation, Velocity};
use polhode::motion::contact::{
    Contact, ContactLaw, ContactStart, ContactState, Friction, Resistance, StartVelocity, SurfaceShape,
};
use polhode::prelude::*;

use crate::common::held::Held;

use super::{generic_body, near, run, state, surface};

fn attitude() -> Attitude {
    Rotation::from_axis_angle(Direction::new(0.48, 0.6, 0.64), 0.8).unwrap()
}

/// Returns L about the point of contact, space axes.
fn momentum_about_contact(body: &MassProperties<Body>, motion: &Held<ContactState>, k: usize) -> [f64; 3] {
    let s = motion.samples()[k];
    let own = Rotor::free(body).angular_momentum_space(&s.state);
    let arm = s.center - s.contact;
    let [px, py, pz] = s.velocity.to_array().map(|v| v * body.mass());
    let [x, y, z] = arm.to_array();
    [own.x + y * pz - z * py, own.y + z * px - x * pz, own.z + x * py - y * px]
}

/// A rolling ball with its centre of mass at its centre and three different moments conserves its
/// angular momentum about the point of contact (Chaplygin 1903).
#[test]
fn the_chaplygin_ball_keeps_its_momentum_about_the_contact() {
    let body = generic_body();
    let contact = Contact::rolling(surface(SurfaceShape::Sphere { radius: 0.2 }, [0.0; 3]));
    let start = ContactStart::rolling(state(attitude(), [5.0, -3.0, 4.0]));
    let motion = run(&body, &contact, start, &[0.0, 30.0, 100.0]);
    let first = momentum_about_contact(&body, &motion, 0);
    for k in [1, 2] {
        for (got, want) in momentum_about_contact(&body, &motion, k).into_iter().zip(first) {
            near(got, want, 1e-14);
        }
    }
    assert!(motion.energy_drift() < 1e-13, "{:e}", motion.energy_drift());
}

/// A symmetric ball with its centre of mass on its axis conserves L · r under any friction at its
/// point of contact (Jellett 1872).
#[test]
fn a_tippe_top_keeps_jelletts_constant() {
    let inertia = InertiaTensor::diagonal([0.00045, 0.00045, 0.0005]).unwrap();
    let body = MassProperties::new(0.15, Position::ZERO, inertia).unwrap();
    let shape = SurfaceShape::Sphere { radius: 0.03 };
    let friction = Friction { sticking: 0.35, kinetic: 0.3, viscous: 0.02 };
    let law = ContactLaw::with_friction(friction).unwrap();
    let contact = Contact { law, ..Contact::rolling(surface(shape, [0.0, 0.0, 0.006])) };
    let tilted = Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), 0.3).unwrap();
    let velocity = StartVelocity::Along(Velocity::new(0.1, -0.05, 0.0));
    let start = ContactStart { velocity, ..ContactStart::rolling(state(tilted, [0.5, 2.0, 90.0])) };
    let times: Vec<f64> = (0..=20).map(|k| 0.2 * f64::from(k)).collect();
    let motion = run(&body, &contact, start, &times);
    let jellett = |k: usize| {
        let s = motion.samples()[k];
        let momentum = Rotor::free(&body).angular_momentum_space(&s.state);
        -momentum.dot(s.contact - s.center)
    };
    let size = jellett(0);
    for k in 1..motion.samples().len() {
        near(jellett(k) / size, 1.0, 1e-12);
    }
    assert!(motion.samples().len() > 15, "{:?}", motion.ending());
    let last = motion.samples().last().unwrap();
    assert!(last.friction_work < -1e-3, "{}", last.friction_work);
    assert!(motion.energy_drift() < 1e-12, "{:e}", motion.energy_drift());
}

/// Energy minus the work of friction is conserved, for each surface, with and without resistance to
/// rolling and pivoting.
#[test]
fn energy_and_work_are_in_balance() {
    let body = generic_body();
    let shapes = [
        SurfaceShape::Sphere { radius: 0.25 },
        SurfaceShape::Ellipsoid { semi_axes: [0.3, 0.25, 0.2] },
        SurfaceShape::Rim { radius: 0.25, tube: 0.0, thickness: 0.0 },
        SurfaceShape::Rim { radius: 0.22, tube: 0.03, thickness: 0.0 },
    ];
    let friction =
        ContactLaw::with_friction(Friction { sticking: 0.3, kinetic: 0.25, viscous: 0.1 }).unwrap();
    let resistance = Resistance { rolling: 0.002, pivoting: 0.001 };
    for shape in shapes {
        for law in [ContactLaw::ROLLING, friction, ContactLaw::FRICTIONLESS] {
            for law in [law, law.resisted_by(resistance).unwrap()] {
                let contact = Contact { law, ..Contact::rolling(surface(shape, [0.01, -0.02, 0.015])) };
                let start = ContactStart::rolling(state(attitude(), [0.9, -1.4, 5.0]));
                let times: Vec<f64> = (1..=20).map(|k| 0.1 * f64::from(k)).collect();
                let motion = run(&body, &contact, start, &times);
                let drift = motion.energy_drift();
                let bound = if law.grip() == friction.grip() { 1e-12 } else { 1e-13 };
                assert!(drift < bound, "{shape:?} {law:?}: {drift:e}");
                let [.., last] = motion.samples() else {
                    panic!("{:?} {shape:?} {law:?} {:?}", motion.ending(), motion.changes())
                };
                assert!(
                    last.friction_work <= 0.0 && last.state.time > 0.1,
                    "{:?} {shape:?} {law:?} {:?}",
                    motion.ending(),
                    motion.changes()
                );
            }
        }
    }
}

/// A disk that rolls on a plane has two constants in addition to its energy (Appell, Korteweg 1899;
/// Chaplygin 1897). Let x = cos θ of its axis and the vertical, y = Ω sin² θ with the rate Ω of its
/// precession, and ω₃ the rate about its axis:
///
/// dy/dx = −(C/A) ω₃,  dω₃/dx = −(m R²/(C + m R²)) y/(1 − x²),  so that (1 − x²) y″ = κ y,  κ = C m
/// R²/(A (C + m R²)):
///
/// y = c₁ y₁ + c₂ y₂, with the solutions that are even and odd in x.
#[test]
fn a_rolling_disk_keeps_the_two_constants_of_its_tilt() {
    let (radius, mass, [a, c]) = (0.3, 1.9, [0.021, 0.033]);
    let body =
        MassProperties::new(mass, Position::ZERO, InertiaTensor::diagonal([a, a, c]).unwrap()).unwrap();
    let contact =
        Contact::rolling(surface(SurfaceShape::Rim { radius, tube: 0.0, thickness: 0.0 }, [0.0; 3]));
    let tilted = Rotation::from_axis_angle(Direction::new(0.48, 0.6, 0.0), 1.1).unwrap();
    let start = ContactStart::rolling(state(tilted, [1.9, -1.4, 3.5]));
    let times: Vec<f64> = (0..=100).map(f64::from).collect();
    let motion = run(&body, &contact, start, &times);
    let kappa = c * mass * radius * radius / (a * (c + mass * radius * radius));
    let constants = |k: usize| {
        let State { attitude, omega, .. } = motion.samples()[k].state;
        let axis: Direction<Space> = attitude * Direction::new(0.0, 0.0, 1.0);
        let x = axis.z;
        // ω · z = Ω sin² θ + ω₃ cos θ.
        let y = (attitude * omega).z - omega.z * x;
        let [[y1, d1], [y2, d2]] = [0, 1].map(|first| solution(kappa, first, x));
        let dy = -c / a * omega.z;
        ([y * d2 - dy * y2, dy * y1 - y * d1], x)
    };
    let (first, at_start) = constants(0);
    let mut range: f64 = 0.0;
    for k in 1..times.len() {
        let (later, x) = constants(k);
        range = range.max((x - at_start).abs());
        for (got, want) in later.into_iter().zip(first) {
            near(got / want, 1.0, 1e-12);
        }
    }
    assert!(range > 0.2, "{range}");
}

/// Returns the even (`first` 0) or odd (1) solution of (1 − x²) y″ = κ y, and its derivative:
/// (n + 2)(n + 1) aₙ₊₂ = (n (n − 1) + κ) aₙ.
fn solution(kappa: f64, first: i32, x: f64) -> [f64; 2] {
    let mut term = 1.0;
    let [mut y, mut slope] = [0.0; 2];
    for n in (first..2000).step_by(2) {
        y += term * x.powi(n);
        slope += f64::from(n) * term * x.powi((n - 1).max(0));
        let n = f64::from(n);
        term *= (n * (n - 1.0) + kappa) / ((n + 2.0) * (n + 1.0));
    }
    [y, slope]
}
