//! Motions with known solutions.

use core::f64::consts::{FRAC_PI_2, TAU};

use polhode::math::{Direction, Rotation, Velocity};
use polhode::motion::Ending;
use polhode::motion::contact::{
    Contact, ContactChange, ContactLaw, ContactPhase, ContactStart, Friction, Ground, GroundShape,
    GroundSide, StartVelocity, SurfaceShape,
};
use polhode::prelude::*;

use super::{G, ball, generic_body, near, run, state, surface};

const RADIUS: f64 = 0.3;

fn sphere() -> SurfaceShape {
    SurfaceShape::Sphere { radius: RADIUS }
}

fn coulomb(kinetic: f64) -> ContactLaw {
    ContactLaw::with_friction(Friction { sticking: kinetic, kinetic, viscous: 0.0 }).unwrap()
}

/// A ball that is thrown without spin slides. It rolls after t = 2 v/(7 µ g) with 5/7 of its
/// velocity.
#[test]
fn a_sliding_ball_rolls_with_five_sevenths_of_its_velocity() {
    let (mu, v) = (0.17, 2.1);
    let contact = Contact { law: coulomb(mu), ..Contact::rolling(surface(sphere(), [0.0; 3])) };
    let start = ContactStart {
        velocity: StartVelocity::Along(Velocity::new(0.6 * v, 0.8 * v, 0.0)),
        ..ContactStart::rolling(state(Attitude::identity(), [0.0; 3]))
    };
    let motion = run(&ball(RADIUS), &contact, start, &[0.1, 3.0]);
    let [change] = motion.changes() else { panic!("{:?}", motion.changes()) };
    assert_eq!(change.change, ContactChange::Grips);
    near(change.time, 2.0 * v / (7.0 * mu * G), 1e-14);
    let [sliding, rolling] = motion.samples() else { panic!("two samples") };
    assert_eq!([sliding.phase, rolling.phase], [ContactPhase::Sliding, ContactPhase::Rolling]);
    near(sliding.velocity.x, 0.6 * (v - mu * G * 0.1), 1e-15);
    near(rolling.velocity.norm(), 5.0 / 7.0 * v, 1e-14);
    near(rolling.velocity.y / rolling.velocity.x, 4.0 / 3.0, 1e-14);
    // The work of friction is the lost energy: 2/7 of ½ m v².
    near(rolling.friction_work, -2.0 / 7.0 * 0.5 * 2.0 * v * v, 1e-14);
    assert!(motion.energy_drift() < 1e-15, "{:e}", motion.energy_drift());
}

/// A ball on a turntable moves on a circle, at 2/7 of the rate of the table.
#[test]
fn a_ball_on_a_turntable_runs_in_circles() {
    let rate = 3.7;
    let ground = Ground::LEVEL.turning_at(rate).unwrap();
    let contact = Contact { ground, ..Contact::rolling(surface(sphere(), [0.0; 3])) };
    let at = Position::new(0.4, -0.1, 0.0);
    let attitude =
        Rotation::from_axis_angle(Direction::new(0.3, 0.5, -0.7).direction().unwrap(), 1.1).unwrap();
    let omega: AngularVelocity<Body> = attitude.inverse() * AngularVelocity::new(1.9, -0.8, 0.6);
    let start = ContactStart { at, ..ContactStart::rolling(state(attitude, omega.to_array())) };
    let period = TAU / (2.0 / 7.0 * rate);
    let motion = run(&ball(RADIUS), &contact, start, &[0.0, period / 3.0, period]);
    let [first, third, last] = motion.samples() else { panic!("three samples") };
    near((last.contact - first.contact).norm(), 0.0, 2e-14);
    // v = (2/7) Ω × (x − c)
    let turn = TAU / 3.0;
    let [x, y, _] = first.velocity.to_array();
    near(third.velocity.x, x * turn.cos() - y * turn.sin(), 1e-14);
    near(third.velocity.y, x * turn.sin() + y * turn.cos(), 1e-14);
    // The table does work on the ball and takes it back.
    assert!(third.ground_work.abs() > 0.01);
    near(last.ground_work, 0.0, 1e-13);
    assert!(motion.energy_drift() < 1e-14, "{:e}", motion.energy_drift());
}

/// A ball rolls down an incline with the acceleration 5/7 g sin α, if tan α ≤ 7/2 µ.
#[test]
fn a_ball_rolls_down_an_incline_or_slips() {
    let slope = 0.6_f64;
    let normal = Direction::new(slope.sin() * 0.6, slope.sin() * 0.8, slope.cos());
    let ground = Ground::new(GroundShape::Plane, normal).unwrap();
    let attitude = Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), 0.4).unwrap();
    let start = ContactStart::rolling(state(attitude, [0.0; 3]));
    let limit = 2.0 / 7.0 * slope.tan();
    for (mu, acceleration) in [
        (limit * 1.01, 5.0 / 7.0 * G * slope.sin()),
        (limit * 0.99, G * (slope.sin() - limit * 0.99 * slope.cos())),
    ] {
        let contact = Contact { ground, law: coulomb(mu), ..Contact::rolling(surface(sphere(), [0.0; 3])) };
        let motion = run(&ball(RADIUS), &contact, start, &[0.5, 2.0]);
        let end = motion.samples()[1];
        // Slip starts with 2e-13 of the speed.
        near(end.contact.norm(), 0.5 * acceleration * 4.0, 3e-12);
        near(end.contact.dot(normal), 0.0, 1e-14);
        near(end.contact.x / end.contact.y, 0.75, 1e-12);
        near(end.normal_force, 2.0 * G * slope.cos(), 1e-13);
        let slips = !motion.changes().is_empty();
        assert_eq!(slips, mu < limit, "{:?}", motion.changes());
        assert!(motion.energy_drift() < 1e-12, "{:e}", motion.energy_drift());
    }
}

/// A ball that rolls down another ball leaves it at cos θ = 10/17, or at 2/3 without friction; then
/// its path is a parabola.
#[test]
fn a_ball_leaves_the_ball_that_it_rolls_down() {
    let big = 1.1;
    let ground = Ground::new(
        GroundShape::Sphere { radius: big, side: GroundSide::Outside },
        Direction::new(0.0, 0.0, 1.0),
    );
    let ground = ground.unwrap();
    // Released at rest at an angle of 0.1 from the top.
    let top = 0.1_f64;
    let at = Position::new(big * top.sin() * 0.8, big * top.sin() * 0.6, big * top.cos());
    for (law, share) in [(ContactLaw::ROLLING, 10.0 / 17.0), (ContactLaw::FRICTIONLESS, 2.0 / 3.0)] {
        let contact = Contact { ground, law, ..Contact::rolling(surface(sphere(), [0.0; 3])) };
        let velocity = StartVelocity::Along(Velocity::ZERO);
        let start = ContactStart { at, velocity, state: state(Attitude::identity(), [0.0; 3]) };
        let motion = run(&ball(RADIUS), &contact, start, &[0.9, 3.0]);
        let [change, ..] = motion.changes() else { panic!("it leaves") };
        assert_eq!(change.change, ContactChange::LiftsOff);
        let time = change.time;
        let [there, later] = [
            run(&ball(RADIUS), &contact, start, &[time]),
            run(&ball(RADIUS), &contact, start, &[time + 0.2]),
        ];
        let (there, later) = (there.samples()[0], later.samples()[0]);
        near(there.normal.z, share * top.cos(), 1e-14);
        near(there.normal_force, 0.0, 1e-13);
        assert_eq!(later.phase, ContactPhase::Flying);
        let fallen = there.center
            + (there.velocity.to_array().map(|v| v * 0.2)).into_position()
            + Position::new(0.0, 0.0, -0.5 * G * 0.04);
        near((later.center - fallen).norm(), 0.0, 1e-14);
        assert!(motion.energy_drift() < 1e-14, "{:e}", motion.energy_drift());
    }
}

/// The same, perpendicular to the axis of a cylinder.
#[test]
fn a_ball_leaves_the_cylinder_that_it_rolls_down() {
    let big = 1.1;
    let axis = Direction::new(0.8, -0.6, 0.0);
    let ground = Ground::new(GroundShape::Cylinder { radius: big, side: GroundSide::Outside }, axis).unwrap();
    let top = 0.1_f64;
    let at = Position::new(big * top.sin() * 0.6 + 0.24, big * top.sin() * 0.8 - 0.18, big * top.cos());
    for (law, share) in [(ContactLaw::ROLLING, 10.0 / 17.0), (ContactLaw::FRICTIONLESS, 2.0 / 3.0)] {
        let contact = Contact { ground, law, ..Contact::rolling(surface(sphere(), [0.0; 3])) };
        let velocity = StartVelocity::Along(Velocity::ZERO);
        let start = ContactStart { at, velocity, state: state(Attitude::identity(), [0.0; 3]) };
        let motion = run(&ball(RADIUS), &contact, start, &[3.0]);
        let [change, ..] = motion.changes() else { panic!("it leaves") };
        assert_eq!(change.change, ContactChange::LiftsOff);
        let there = run(&ball(RADIUS), &contact, start, &[change.time]).samples()[0];
        near(there.normal.z, share * top.cos(), 1e-14);
        near(there.normal_force, 0.0, 1e-13);
        near(axis.dot(there.center), 0.3, 1e-14);
    }
}

/// A ball near the bottom of a bowl of radius ρ that turns about the vertical at Ω, and turning
/// with it. The position x = ξ + i η of its centre satisfies ẍ = (2/7) i Ω ẋ − (5/7) g/(ρ − a) x.
#[test]
fn a_ball_in_a_bowl_that_turns_has_two_circles() {
    let (bowl, rate) = (0.9, 3.0);
    let ground = Ground::new(
        GroundShape::Sphere { radius: bowl, side: GroundSide::Inside },
        Direction::new(0.0, 0.0, 1.0),
    );
    let ground = ground.unwrap().turning_at(rate).unwrap();
    let contact = Contact { ground, ..Contact::rolling(surface(sphere(), [0.0; 3])) };
    let small = 1e-6;
    let angle: f64 = small / (bowl - RADIUS);
    let at = Position::new(bowl * angle.sin(), 0.0, -bowl * angle.cos());
    // It is at rest relative to the moving ground: v = Ω × c, and ω is along the vertical.
    let start = ContactStart { at, ..ContactStart::rolling(state(Attitude::identity(), [0.0, 0.0, rate])) };
    let motion = run(&ball(RADIUS), &contact, start, &[0.0, 0.7, 1.9, 4.0]);
    assert!(motion.energy_drift() < 1e-14, "{:e}", motion.energy_drift());
    // x = A exp(i λ₁ t) + B exp(i λ₂ t) with λ² − (2/7) Ω λ − (5/7) g/(ρ − a) = 0. At the start x
    // is real and ẋ = i v.
    let half = rate / 7.0;
    let root = (half * half + 5.0 / 7.0 * G / (bowl - RADIUS)).sqrt();
    let (first, second) = (half + root, half - root);
    let [x, v] = [motion.samples()[0].center.x, motion.samples()[0].velocity.y];
    near(motion.samples()[0].velocity.x, 0.0, 1e-20);
    let b = (v - first * x) / (second - first);
    let a = x - b;
    for sample in motion.samples() {
        let t = sample.state.time;
        let want =
            [a * (first * t).cos() + b * (second * t).cos(), a * (first * t).sin() + b * (second * t).sin()];
        near(sample.center.x / small, want[0] / small, 1e-8);
        near(sample.center.y / small, want[1] / small, 1e-8);
    }
}

/// A ball in a bowl swings like a pendulum of length 7/5 (ρ − a).
#[test]
fn a_ball_in_a_bowl_swings_as_a_pendulum() {
    let bowl = 1.3;
    let amplitude = 0.7_f64;
    for shape in [
        GroundShape::Sphere { radius: bowl, side: GroundSide::Inside },
        GroundShape::Cylinder { radius: bowl, side: GroundSide::Inside },
    ] {
        let axis = Direction::new(1.0, 0.0, 0.0);
        let ground = Ground::new(shape, axis).unwrap();
        let contact = Contact { ground, ..Contact::rolling(surface(sphere(), [0.0; 3])) };
        let at = Position::new(0.0, bowl * amplitude.sin(), -bowl * amplitude.cos());
        let start = ContactStart { at, ..ContactStart::rolling(state(Attitude::identity(), [0.0; 3])) };
        // T = 4 K(sin ½θ₀) √(l/g)
        let period = 4.0 * complete((0.5 * amplitude).sin()) * (1.4 * (bowl - RADIUS) / G).sqrt();
        let motion = run(&ball(RADIUS), &contact, start, &[0.25 * period, 0.5 * period, 20.0 * period]);
        let [quarter, half, last] = motion.samples() else { panic!("three samples") };
        near(quarter.contact.y, 0.0, 1e-14);
        near(half.contact.y, -at.y, 1e-13);
        near((last.contact - at).norm(), 0.0, 1e-12);
        assert!(motion.energy_drift() < 1e-14, "{:e}", motion.energy_drift());
    }
}

/// Returns K(k) by the arithmetic–geometric mean.
fn complete(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    FRAC_PI_2 / a
}

/// A disk rolls steadily in a circle if its rates match its inclination.
#[test]
fn a_disk_rolls_in_a_circle() {
    // A disk of radius r with its axis at θ from the vertical, precessing at Ω with spin s = ω
    // along its axis: L̇ = r × F gives Ω sin θ (A Ω cos θ − (C + m r²) s) = m g r cos θ.
    let (mass, r, theta, precession) = (1.7, 0.25, 1.1_f64, 2.3);
    let (a, c) = (0.027, 0.051);
    let inertia = InertiaTensor::diagonal([a, a, c]).unwrap();
    let body = MassProperties::new(mass, Position::ZERO, inertia).unwrap();
    let (sin, cos) = (theta.sin(), theta.cos());
    let spin = (a * precession * cos - mass * G * r * cos / (precession * sin)) / (c + mass * r * r);
    // The axis is inclined towards −y: the lowest point is at −x' in the plane of the inclination.
    let attitude: Attitude = Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), theta).unwrap();
    let axis: Direction<Space> = attitude * Direction::<Body>::new(0.0, 0.0, 1.0);
    let up = Direction::<Space>::new(0.0, 0.0, 1.0);
    // ω = Ω (z − cos θ e) + s e
    let omega = up * precession - axis * (precession * cos) + axis * spin;
    let omega: AngularVelocity<Body> = attitude.inverse() * AngularVelocity::new(omega.x, omega.y, omega.z);
    let shape = SurfaceShape::Rim { radius: r, tube: 0.0, thickness: 0.0 };
    let contact = Contact::rolling(surface(shape, [0.0; 3]));
    let start = ContactStart::rolling(state(attitude, omega.to_array()));
    let period = TAU / precession;
    let motion = run(&body, &contact, start, &[0.0, 0.3 * period, period]);
    let [first, part, last] = motion.samples() else { panic!("three samples") };
    near((last.contact - first.contact).norm(), 0.0, 1e-13);
    let tilt = part.state.attitude * Direction::<Body>::new(0.0, 0.0, 1.0);
    near(tilt.z, cos, 1e-14);
    assert!((part.contact - first.contact).norm() > 0.05);
    assert!(motion.energy_drift() < 1e-14, "{:e}", motion.energy_drift());
}

/// A cylinder rolls in a trough like a pendulum, and down an incline with 2/3 g sin α. If it is too
/// short, it tips over.
#[test]
fn a_cylinder_rolls_about_its_axis_alone() {
    let slope = 0.4_f64;
    let normal = Direction::new(slope.sin(), 0.0, slope.cos());
    let ground = Ground::new(GroundShape::Plane, normal).unwrap();
    let moment = 0.5 * 2.0 * RADIUS * RADIUS;
    let inertia = InertiaTensor::diagonal([0.06, 0.06, moment]).unwrap();
    let body = MassProperties::new(2.0, Position::ZERO, inertia).unwrap();
    // The axis z of the body is along y of space.
    let attitude = Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), -FRAC_PI_2).unwrap();
    let shape = SurfaceShape::Cylinder { radius: RADIUS, length: Some(0.5) };
    let contact = Contact { ground, ..Contact::rolling(surface(shape, [0.0; 3])) };
    let start = ContactStart::rolling(state(attitude, [0.0; 3]));
    let motion = run(&body, &contact, start, &[1.5]);
    near(motion.samples()[0].contact.norm(), 0.5 * 2.0 / 3.0 * G * slope.sin() * 2.25, 1e-14);
    assert!(motion.energy_drift() < 1e-15);
    // The axis is 0.2 rad from the level line, so gravity has a component along it. The cylinder
    // does not tip over while the line of the force passes within its length.
    let turned: Attitude = Rotation::from_axis_angle(normal, 1.3).unwrap() * attitude;
    let short = SurfaceShape::Cylinder { radius: RADIUS, length: Some(0.1) };
    for (shape, tips) in [(shape, false), (short, true)] {
        let contact = Contact { ground, ..Contact::rolling(surface(shape, [0.0; 3])) };
        let motion = run(&body, &contact, ContactStart::rolling(state(turned, [0.0; 3])), &[0.5]);
        let tipped = matches!(motion.ending(), Ending::Contact { change: ContactChange::TipsOver, .. });
        assert_eq!(tipped, tips, "{:?}", motion.ending());
    }
}

/// Without friction, the centre of mass of a body on level ground moves uniformly, and L along the
/// normal is conserved.
#[test]
fn without_friction_nothing_pushes_along_the_ground() {
    let shape = SurfaceShape::Ellipsoid { semi_axes: [0.3, 0.25, 0.2] };
    let contact =
        Contact { law: ContactLaw::FRICTIONLESS, ..Contact::rolling(surface(shape, [0.02, -0.03, 0.04])) };
    let attitude = Rotation::from_axis_angle(Direction::new(0.6, 0.0, 0.8), 0.9).unwrap();
    let velocity = StartVelocity::Along(Velocity::new(0.7, -0.4, 0.0));
    let start = ContactStart { velocity, ..ContactStart::rolling(state(attitude, [1.1, -0.7, 2.3])) };
    let body = generic_body();
    let motion = run(&body, &contact, start, &[0.0, 1.0, 5.0]);
    let spin = |k: usize| {
        let s = motion.samples()[k];
        (Rotor::free(&body).angular_momentum_space(&s.state)).z
    };
    let [first, _, last] = motion.samples() else { panic!("three samples") };
    near(last.center.x - first.center.x, 0.7 * 5.0, 1e-14);
    near(last.center.y - first.center.y, -0.4 * 5.0, 1e-14);
    near(spin(2), spin(0), 1e-16);
    assert!(motion.energy_drift() < 1e-14, "{:e}", motion.energy_drift());
}

trait IntoPosition {
    fn into_position(self) -> Position<Space>;
}

impl IntoPosition for [f64; 3] {
    fn into_position(self) -> Position<Space> {
        Position::from_array(self)
    }
}
