//! Sliding and circling bodies: closed forms compared with the motion.

use core::f64::consts::TAU;

use polhode::math::{Direction, Rotation, Velocity};
use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{
    Contact, ContactChange, ContactLaw, ContactStart, ContactState, Footing, Friction, Ground, GroundShape,
    GroundSide, Resistance, StartVelocity, SurfaceShape,
};
use polhode::observe::{BallInBowl, BallOnPlane, CirclingDisk, SlipEnd};
use polhode::prelude::*;

use crate::common::held::Held;

use super::{body, contact, leaning, start};

const MASS: f64 = 0.31;
const RADIUS: f64 = 0.043;
/// Moment of inertia, close to that of a hollow ball.
const MOMENT: f64 = 0.61 * MASS * RADIUS * RADIUS;

fn run(
    mass: &MassProperties<Body>,
    contact: &Contact,
    start: ContactStart,
    times: &[f64],
) -> Held<ContactState> {
    Held::of(Simulation::on_ground(mass, contact, start, times).run().unwrap(), CONTACT)
}

#[track_caller]
fn near(got: f64, want: f64, tolerance: f64) {
    assert!((got - want).abs() <= tolerance * want.abs().max(1e-300), "{got} is not {want}");
}

/// Returns a ball on a plane with this slope, in general motion.
fn ball(slope: f64, friction: Friction, turning: f64) -> (BallOnPlane, Contact, ContactStart) {
    let normal = Direction::new(0.6 * slope.sin(), 0.8 * slope.sin(), slope.cos());
    let ground = Ground::new(GroundShape::Plane, normal).unwrap().turning_at(turning).unwrap();
    let law = ContactLaw::with_friction(friction).unwrap();
    let shape = SurfaceShape::Sphere { radius: RADIUS };
    let contact = Contact { ground, law, ..contact(shape, [0.0; 3], Footing::Rolling) };
    let mut start = start(leaning(0.4), [11.0, -23.0, 7.0]);
    let along = Velocity::new(1.3, -0.9, 0.4);
    let away = along.dot(normal);
    start.velocity = StartVelocity::Along(along - Velocity::from_array((normal * away).to_array()));
    let ball =
        BallOnPlane { mass: MASS, radius: RADIUS, moment: MOMENT, gravity: contact.gravity, normal, turning };
    (ball, contact, start)
}

/// The slip ends at the time and velocity of the closed form: on level ground, and on slopes in a
/// general direction, also with viscous friction.
#[test]
fn slip_ends_when_it_should() {
    let dry = |kinetic| Friction { sticking: kinetic, kinetic, viscous: 0.0 };
    for (slope, friction) in
        [(0.0, dry(0.17)), (0.0, Friction { viscous: 0.23, ..dry(0.11) }), (0.25, dry(0.2)), (0.6, dry(0.31))]
    {
        let (ball, contact, start) = ball(slope, friction, 0.0);
        let mass = body(MASS, [MOMENT; 3]);
        let first = *run(&mass, &contact, start, &[]).start();
        let SlipEnd::At(time) = ball.slip_end(first.slip, &friction) else { panic!("{slope}: it grips") };
        let motion = run(&mass, &contact, start, &[time * (1.0 + 1e-13)]);
        assert_eq!(motion.changes()[0].change, ContactChange::Grips);
        near(motion.changes()[0].time, time, 1e-12);
        let there = motion.samples()[0];
        let velocity = ball.rolls_off(first.velocity, first.slip, time);
        assert!((there.velocity - velocity).norm() < 1e-11 * velocity.norm(), "{slope}: {velocity:?}");
        if slope == 0.0 {
            let moved = ball.displacement(first.velocity, first.slip, &friction, time);
            assert!((there.center - first.center - moved).norm() < 1e-11, "{moved:?}");
        }
    }
}

/// Slopes too steep for friction to stop the slip, and a slip straight uphill.
#[test]
fn slip_on_a_steep_slope_does_not_end() {
    let friction = Friction { sticking: 0.9, kinetic: 0.1, viscous: 0.0 };
    let (steep, contact, mut start) = ball(0.7, friction, 0.0);
    let mass = body(MASS, [MOMENT; 3]);
    let first = *run(&mass, &contact, start, &[]).start();
    assert_eq!(steep.slip_end(first.slip, &friction), SlipEnd::Never);
    assert!(run(&mass, &contact, start, &[20.0]).changes().is_empty());
    // A slip straight uphill stops, and a body that does not slip is held.
    start.state.omega = AngularVelocity::ZERO;
    start.velocity = StartVelocity::Along(Velocity::from_array((steep.downhill() * -0.31).to_array()));
    let first = *run(&mass, &contact, start, &[]).start();
    let SlipEnd::At(time) = steep.slip_end(first.slip, &friction) else { panic!("it stops") };
    let motion = run(&mass, &contact, start, &[2.0 * time]);
    assert_eq!(motion.changes()[0].change, ContactChange::Grips);
    near(motion.changes()[0].time, time, 1e-12);
    assert!(steep.friction_to_roll() < 0.9 && steep.friction_to_roll() > 0.1);
}

fn moved(velocity: Velocity<Space>, time: f64) -> Position<Space> {
    Position::from_array((velocity * time).to_array())
}

/// A ball on an inclined turntable moves on a circle that drifts horizontally.
#[test]
fn circles_drift_across_a_slope() {
    let (ball, contact, start) = ball(0.08, Friction::default(), 4.3);
    let contact = Contact { law: ContactLaw::ROLLING, ..contact };
    let start = ContactStart { velocity: StartVelocity::Rolling, ..start };
    let mass = body(MASS, [MOMENT; 3]);
    near(ball.share(), 0.61 / 1.61, 1e-14);
    let round = TAU / ball.circle_rate();
    let motion = run(&mass, &contact, start, &[0.0, 0.3 * round, round]);
    let [first, later, last] = motion.samples() else { panic!("three samples") };
    let drift = ball.drift();
    assert!((last.contact - first.contact - moved(drift, round)).norm() < 1e-11);
    let [from, to] = [first, later].map(|s| ball.circle_center(s.contact, s.velocity));
    assert!((to - from - moved(drift, 0.3 * round)).norm() < 1e-12, "{from:?} {to:?}");
    near((later.contact - to).norm(), (first.contact - from).norm(), 1e-11);
}

fn disk(tube: f64, thickness: f64, center: f64) -> (CirclingDisk, MassProperties<Body>, Contact) {
    let (mass, radius, across, along) = (0.42, 0.081, 7.3e-4, 1.31e-3);
    let shape = SurfaceShape::Rim { radius, tube, thickness };
    let offset = center - 0.5 * thickness;
    let gravity = 9.80665;
    (
        CirclingDisk { mass, gravity, across, along, radius, tube, offset },
        body(mass, [across, across, along]),
        contact(shape, [0.0, 0.0, center], Footing::Rolling),
    )
}

/// Steady circles persist, with the inclination, the radius and the energy of the closed form.
#[test]
fn disks_run_in_steady_circles() {
    for (tube, thickness, center) in
        [(0.0, 0.0, 0.0), (0.013, 0.0, 0.0), (0.0, 0.021, 0.0), (0.007, 0.0, 0.011)]
    {
        let (disk, mass, contact) = disk(tube, thickness, center);
        for (tilt, spin) in [(1.1, -13.0), (0.6, 9.0), (0.3, -1.7), (0.9, 0.0)] {
            let rates = disk.rates(tilt, spin);
            assert!(!rates.is_empty());
            for rate in rates {
                // ω = −Ω sin θ p + s e, where p is −y of a body that is rotated about x.
                let start = start(leaning(tilt), [0.0, rate * tilt.sin(), spin]);
                let times = [0.0, 0.23 / rate.abs(), 2.1 / rate.abs()];
                let motion = run(&mass, &contact, start, &times);
                let [first, second, third] = motion.samples() else { panic!("{:?}", motion.ending()) };
                let lean =
                    |s: &ContactState| (s.state.attitude * Direction::<Body>::new(0.0, 0.0, 1.0)).z.acos();
                near(lean(third), tilt, 1e-9);
                near(first.center.z, disk.height(tilt), 1e-12);
                near(first.kinetic_energy + first.potential_energy, disk.energy(tilt, spin, rate), 1e-12);
                near(first.velocity.norm(), disk.velocity(tilt, spin, rate).abs(), 1e-11);
                // Three points on a circle.
                let [a, b, c] = [first, second, third].map(|s| s.contact);
                let across: Direction<Space> = Direction::from_array((b - a).to_array());
                let area = 0.5 * across.cross(c - a).norm();
                let radius = (b - a).norm() * (c - b).norm() * (a - c).norm() / (4.0 * area);
                near(radius, disk.circle_radius(tilt, spin, rate).abs(), 1e-7);
            }
        }
        let rate = disk.rate_at_rest(0.4).unwrap();
        let spin = disk.spin_at_rest(0.4, rate);
        let start = start(leaning(0.4), [0.0, rate * 0.4_f64.sin(), spin]);
        let motion = run(&mass, &contact, start, &[1.3]);
        assert!((motion.samples()[0].center - motion.start().center).norm() < 1e-9);
    }
}

/// Euler's disk settles according to the formulas for small inclination.
#[test]
fn eulers_disk_lies_flat_after_its_time() {
    let (disk, mass, contact) = disk(0.0, 0.0, 0.0);
    let (tilt, lever) = (0.05, 4.0e-4);
    let resistance = Resistance { rolling: lever, pivoting: 0.0 };
    let contact = Contact { law: ContactLaw::ROLLING.resisted_by(resistance).unwrap(), ..contact };
    let rate = disk.rate_at_rest(tilt).unwrap();
    let start = start(leaning(tilt), [0.0, rate * tilt.sin(), disk.spin_at_rest(tilt, rate)]);
    let settles = disk.settling_time(rate, lever);
    let motion = run(&mass, &contact, start, &[0.5 * settles, 2.0 * settles]);
    near(motion.changes()[0].time, settles, 2e-3);
    assert_eq!(motion.changes()[0].change, ContactChange::LiesFlat);
    let half = motion.samples()[0];
    let axis: Direction<Space> = half.state.attitude * Direction::<Body>::new(0.0, 0.0, 1.0);
    // Ω = Ω₀ T/(T − t), so a quarter of the inclination remains after half of the time.
    near(axis.z.acos(), 0.25 * tilt, 5e-3);
    let turned: Rotation<Space, Body> = half.state.attitude;
    let omega = turned * half.state.omega;
    near(omega.norm(), 2.0 * rate * (0.25 * tilt).sin(), 1e-2);
}

/// A ball that rolls in a bowl moves like the axis of the corresponding top; one that rolls down
/// another ball does so until it leaves it.
#[test]
fn a_ball_in_a_bowl_is_a_top() {
    let mass = body(MASS, [MOMENT; 3]);
    for (side, up) in [(GroundSide::Inside, -1.0), (GroundSide::Outside, 1.0)] {
        let bowl = 0.37;
        let ground = Ground::new(GroundShape::Sphere { radius: bowl, side }, Direction::new(0.0, 0.0, 1.0));
        let shape = SurfaceShape::Sphere { radius: RADIUS };
        let contact = Contact { ground: ground.unwrap(), ..contact(shape, [0.0; 3], Footing::Rolling) };
        let at = Position::new(0.11 * bowl, -0.07 * bowl, up * bowl * (1.0_f64 - 0.0121 - 0.0049).sqrt());
        let start = ContactStart { at, ..start(leaning(0.8), [3.1, -1.2, 9.0]) };
        let motion = run(&mass, &contact, start, &[0.07, 0.21]);
        let first = motion.start();
        let ball = BallInBowl::of(&mass, &contact).unwrap();
        let top = ball.top(first).unwrap();
        for sample in motion.samples() {
            let axis: Direction<Space> =
                top.at(sample.state.time).attitude * Direction::<Body>::new(0.0, 0.0, 1.0);
            let center = sample.center.direction().unwrap();
            assert!((axis - center).norm() < 1e-11, "{side:?}: {axis:?} {center:?}");
            near((sample.center.norm() / ball.distance).abs(), 1.0, 1e-12);
        }
        assert!(motion.changes().is_empty(), "{:?}", motion.changes());
    }
}

/// An upright disk is the wheel with known stability.
#[test]
fn an_upright_disk_is_a_wheel() {
    let (disk, mass, contact) = disk(0.013, 0.0, 0.0);
    let wheel = disk.upright(Footing::Rolling).unwrap();
    let steady = super::steady(&mass, &contact, &start(leaning(1.5), [0.0, 0.1, 20.0]));
    assert_eq!(steady.path, polhode::observe::SteadyPath::RollingUpright(wheel));
}
