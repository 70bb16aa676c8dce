//! Shafts: bearing reactions and balance, compared with sums over mass points.

use polhode::motion::{Prescribed, Required, Shaft, Unbalance};
use polhode::prelude::*;

/// Returns mass points without symmetry.
fn points() -> Vec<Particle<Body>> {
    [
        (1.5, [0.5, -1.0, 0.25]),
        (2.0, [-0.75, 0.5, 2.0]),
        (0.5, [1.0, 1.5, -0.5]),
        (0.9, [0.1, 0.2, 0.3]),
        (1.1, [-0.6, -0.8, 0.9]),
    ]
    .map(|(m, p)| Particle::new(m, Position::from_array(p)).unwrap())
    .to_vec()
}

const AXIS: [f64; 3] = [0.3, -0.5, 0.9];
const BEARINGS: [f64; 2] = [-0.8, 1.7];

fn point() -> Position<Body> {
    Position::new(0.2, -0.1, 0.35)
}

fn shaft() -> Shaft {
    let body = mass_properties_of_particles(&points()).unwrap();
    Shaft::new(body, point(), Direction::from_array(AXIS), BEARINGS).unwrap()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k] + b[k])
}

fn scaled(a: [f64; 3], s: f64) -> [f64; 3] {
    a.map(|x| s * x)
}

fn length(a: [f64; 3]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Newton's law for every mass point: returns Σ m (a − g) and Σ r × m (a − g) about P.
fn needed(rate: f64, acceleration: f64, gravity: [f64; 3]) -> ([f64; 3], [f64; 3]) {
    let n = scaled(AXIS, 1.0 / length(AXIS));
    let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
    for p in points() {
        let r = (p.position() - point()).to_array();
        let (omega, alpha) = (scaled(n, rate), scaled(n, acceleration));
        let a = add(cross(alpha, r), cross(omega, cross(omega, r)));
        let f = scaled(add(a, scaled(gravity, -1.0)), p.mass());
        force = add(force, f);
        moment = add(moment, cross(r, f));
    }
    (force, moment)
}

#[test]
fn the_bearings_and_the_drive_make_what_every_mass_point_needs() {
    let (rate, acceleration, gravity) = (-13.0, 4.7, [1.1, -8.0, 5.3]);
    let shaft = shaft();
    let held = shaft.reactions(rate, acceleration, Acceleration::from_array(gravity));
    let (force, moment) = needed(rate, acceleration, gravity);
    let n = shaft.axis().to_array();
    let [f1, f2] = held.bearings.map(Force::to_array);
    let sum = add(add(f1, f2), scaled(n, held.thrust));
    let scale = length(force);
    assert!(length(add(sum, scaled(force, -1.0))) < 1e-14 * scale, "{sum:?} {force:?}");
    let lever = add(cross(scaled(n, BEARINGS[0]), f1), cross(scaled(n, BEARINGS[1]), f2));
    let all = add(lever, scaled(n, held.torque));
    assert!(length(add(all, scaled(moment, -1.0))) < 3e-15 * length(moment), "{all:?} {moment:?}");
    // Bearings support forces normal to the line only.
    for f in held.bearings {
        assert!(f.dot(shaft.axis()).abs() < 1e-14 * scale);
    }
    // The drive torque consists of the parts of the moment of inertia and of the weight.
    let without = shaft.reactions(rate, acceleration, Acceleration::ZERO);
    assert!((without.torque - shaft.moment() * acceleration).abs() < 1e-12);
    // Work theorem: the motion about the point on the line needs the same torque about the line.
    let rotor = Rotor::pivoted(shaft.body(), point());
    let turn = Prescribed::fixed_axis(Attitude::identity(), shaft.axis(), rate, acceleration).unwrap();
    let needed = Required::of_motion(&rotor, &turn, 0.0).unwrap();
    assert!((needed.torque.dot(shaft.axis()) - without.torque).abs() < 1e-12);
    assert!((needed.power - without.torque * rate).abs() < 1e-11);
}

#[test]
fn a_mass_on_the_other_side_is_at_half_a_turn() {
    let inertia = InertiaTensor::with_negative_products([0.4, 0.5, 0.2], [0.0; 3]).unwrap();
    let body = MassProperties::new(3.7, Position::new(0.002, 0.0, 0.31), inertia).unwrap();
    let axis = Direction::from_array([0.0, 0.0, 1.0]);
    let shaft = Shaft::new(body, Position::ZERO, axis, BEARINGS).unwrap();
    assert_eq!(shaft.balance_in_plane(0.1, 0.08).unwrap().angle, std::f64::consts::PI);
}

#[test]
fn two_masses_in_two_planes_balance_any_shaft() {
    let shaft = shaft();
    assert_eq!(shaft.unbalance(), Unbalance::Dynamic);
    let before = shaft.reactions(21.0, -3.0, Acceleration::ZERO);
    let masses = shaft.balance_in_planes([-0.3, 1.2], [0.7, 0.45]).unwrap();
    for mass in masses {
        // The stated position: in its plane, at its radius and angle.
        let r = mass.position - point();
        assert!((shaft.axis().dot(r) - mass.plane).abs() < 1e-14);
        let across = r - Position::from_array((shaft.axis() * mass.plane).to_array());
        assert!((across.norm() - mass.radius).abs() < 1e-14 && mass.mass > 0.1);
        let mark = shaft.zero_mark();
        let turned: Rotation<Body, Body> = Rotation::from_axis_angle(shaft.axis(), mass.angle).unwrap();
        assert!((turned * mark).angle_to(across) < 1e-14);
    }
    let balanced = shaft.with(&masses).unwrap();
    let after = balanced.reactions(21.0, -3.0, Acceleration::ZERO);
    for (before, after) in before.bearings.iter().zip(after.bearings) {
        assert!(after.norm() < 1e-13 * before.norm(), "{after:?}");
    }
    assert_eq!(balanced.unbalance(), Unbalance::None);
    // The same for the mass points.
    let mut all = points();
    all.extend(masses.map(|mass| Particle::new(mass.mass, mass.position).unwrap()));
    let body = mass_properties_of_particles(&all).unwrap();
    let again = Shaft::new(body, point(), Direction::from_array(AXIS), BEARINGS).unwrap();
    for force in again.reactions(21.0, -3.0, Acceleration::ZERO).bearings {
        assert!(force.norm() < 1e-13 * before.bearings[0].norm());
    }
    // The remaining reaction at rest is that of the weight, which balancing does not remove.
    let hung = balanced.reactions(0.0, 0.0, Acceleration::new(0.0, 0.0, -9.81));
    let sum = hung.bearings[0] + hung.bearings[1];
    let [x, y, z] = (shaft.axis() * hung.thrust).to_array();
    assert!((sum + Force::new(x, y, z) - Force::new(0.0, 0.0, 9.81 * balanced.body().mass())).norm() < 1e-12);
    assert!(hung.torque.abs() < 1e-12);
}

#[test]
fn one_mass_in_a_plane_takes_the_static_unbalance_only() {
    let shaft = shaft();
    let mass = shaft.balance_in_plane(0.9, 0.6).unwrap();
    let balanced = shaft.with(&[mass]).unwrap();
    assert_eq!(balanced.unbalance(), Unbalance::Couple);
    assert!(balanced.static_unbalance().norm() < 1e-14);
    // The forces of the bearings are now a pure couple.
    let held = balanced.reactions(9.0, 0.0, Acceleration::ZERO).bearings;
    assert!((held[0] + held[1]).norm() < 1e-13 * held[0].norm() && held[0].norm() > 1.0);
    // For a body whose axis is parallel to a principal axis, one mass in the plane of the centre of
    // mass is sufficient.
    let inertia = InertiaTensor::diagonal([0.3, 0.4, 0.6]).unwrap();
    let body = MassProperties::new(3.0, Position::new(0.02, -0.05, 0.4), inertia).unwrap();
    let disk = Shaft::new(body, Position::ZERO, Direction::new(0.0, 0.0, -2.0), [0.1, -1.0]).unwrap();
    assert_eq!(disk.unbalance(), Unbalance::Static);
    let mass = disk.balance_in_plane(-0.4, 0.3).unwrap();
    assert_eq!(disk.with(&[mass]).unwrap().unbalance(), Unbalance::None);
}

/// Two equal masses at distance d along a shaft, on opposite sides: a pure couple, whose force on
/// the bearings is m r d Ω²/l.
#[test]
fn the_couple_of_two_opposite_masses() {
    let (m, r, d, l, omega) = (0.7, 0.2, 0.5, 1.6, 30.0);
    let pair = [[r, 0.0, 0.5 * l + 0.5 * d], [-r, 0.0, 0.5 * l - 0.5 * d]]
        .map(|p| Particle::new(m, Position::from_array(p)).unwrap());
    let body = mass_properties_of_particles(&pair).unwrap();
    let shaft = Shaft::new(body, Position::ZERO, Direction::new(0.0, 0.0, 1.0), [0.0, l]).unwrap();
    assert_eq!(shaft.unbalance(), Unbalance::Couple);
    let held = shaft.reactions(omega, 0.0, Acceleration::ZERO);
    let expected = m * r * d * omega * omega / l;
    assert!((held.bearings[1] - Force::new(-expected, 0.0, 0.0)).norm() < 1e-12 * expected);
    assert!((held.bearings[0] - Force::new(expected, 0.0, 0.0)).norm() < 1e-12 * expected);
    assert!(held.torque.abs() < 1e-13 && held.thrust.abs() < 1e-13);
}

#[test]
fn a_shaft_without_line_or_lever_is_refused() {
    let body = mass_properties_of_particles(&points()).unwrap();
    let z = Direction::new(0.0, 0.0, 1.0);
    assert!(Shaft::new(body, Position::ZERO, Direction::ZERO, BEARINGS).is_err());
    assert!(Shaft::new(body, Position::new(f64::NAN, 0.0, 0.0), z, BEARINGS).is_err());
    for bearings in [[0.3, 0.3], [0.0, f64::INFINITY], [f64::NAN, 1.0]] {
        assert!(Shaft::new(body, Position::ZERO, z, bearings).is_err());
    }
    let shaft = shaft();
    assert!(shaft.balance_in_planes([0.2, 0.2], [1.0, 1.0]).is_err());
    assert!(shaft.balance_in_planes([0.2, 0.3], [0.0, 1.0]).is_err());
    assert!(shaft.balance_in_plane(f64::NAN, 1.0).is_err());
}
