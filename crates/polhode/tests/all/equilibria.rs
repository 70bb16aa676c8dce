//! Steady motions near a start: on a circular orbit, of a heavy top, with an energy sink.

use polhode::motion::torque::{Attracted, EnergySink, GravityGradient, Schedule, Torsion};
use polhode::motion::{HeavyTop, MU_EARTH, Motor, Orbit, TopPath};
use polhode::observe::{
    DissipativeLimit, Libration, OrbitalEquilibrium, PermanentRotation, SmallOscillations, SteadyTop,
};
use polhode::prelude::*;

fn turned() -> Rotation<Body, Body> {
    Rotation::from_axis_angle(Direction::new(0.3, -0.8, 0.5), 1.1).unwrap()
}

fn free(moments: [f64; 3]) -> Rotor {
    let inertia = InertiaTensor::diagonal(moments).unwrap().in_frame(turned());
    Rotor::free(&MassProperties::new(2.3, Position::new(0.1, -0.2, 0.3), inertia).unwrap())
}

fn at(attitude: Attitude, omega: AngularVelocity<Body>) -> State {
    State { time: 40.0, attitude, omega }
}

fn generic_attitude() -> Attitude {
    Attitude::from_euler313([1.1, 0.8, -2.3]).unwrap()
}

fn on_orbit() -> (Orbit, [TorqueModel; 1]) {
    let (radial, motion) = (Direction::new(0.3, -1.2, 0.7), Direction::new(1.0, 0.4, 2.0));
    let orbit = Orbit::circular(MU_EARTH, 6.9e6, radial, motion).unwrap();
    let attracted = Attracted::Tensor;
    (orbit.clone(), [TorqueModel::GravityGradient(Box::new(GravityGradient { orbit, attracted }))])
}

/// The start turns nearly with the orbit, or arbitrarily: all 24 equilibria are found, with the
/// libration of the scalar equations.
#[test]
fn all_attitudes_at_rest_on_an_orbit_are_found() {
    let (orbit, gravity) = on_orbit();
    let n = orbit.mean_motion().unwrap();
    let moments = [1.7, 5.1, 6.2];
    let rotor = free(moments);
    let normal: Direction<Space> =
        orbit.position(40.0).direction().unwrap().cross(orbit.velocity(40.0).direction().unwrap());
    for omega in [generic_attitude().inverse() * normal * (n * 1.0001), Direction::new(0.3, -0.1, 0.2)] {
        let start = at(generic_attitude(), AngularVelocity::from_array(omega.to_array()));
        let all = OrbitalEquilibrium::all(&rotor, &gravity, start).unwrap().unwrap();
        assert_eq!(all.len(), 24);
        let away: Vec<f64> = all.iter().map(|e| e.state.attitude.angle_to(start.attitude)).collect();
        assert!(away.is_sorted_by(|a, b| *a < b + 2e-6) && away[0] < 1.2, "{away:?}");
        for e in &all {
            let spin = e.state.omega_space();
            assert!((spin.norm() / n - 1.0).abs() < 1e-14 && spin.angle_to(normal) < 1e-14);
            assert!(e.up.angle_to(e.state.attitude.inverse() * orbit.position(40.0)) < 1e-14);
            let [up, ahead, across] = e.axes.map(|(k, _)| k);
            assert!(up != ahead && ahead != across && up != across && e.tilt < 1e-7, "{e:?}");
            let found = SmallOscillations::about_equilibrium(&rotor, &gravity, e.state).unwrap();
            let expected = Libration::of([ahead, across, up].map(|k| moments[k]), n).unwrap();
            assert_eq!(found.is_stable(), expected.is_stable(), "{e:?}");
            let has = |f: f64| found.modes.iter().any(|m| (m.frequency / f - 1.0).abs() < 1e-8);
            assert!(
                expected.pitch.is_none_or(has)
                    && expected.roll_yaw.is_none_or(|both| both.into_iter().all(has))
            );
        }
        // The Lagrange equilibrium (the long axis up, the greatest moment
        // across the orbit), or the DeBra–Delp equilibrium.
        assert!(all.iter().any(|e| e.axes.map(|(k, _)| k) == [0, 1, 2]));
    }
    let none = OrbitalEquilibrium::all(&rotor, &[], at(generic_attitude(), AngularVelocity::ZERO)).unwrap();
    assert!(none.is_none());
}

/// A wheel turns the equilibrium attitudes away from the principal axes; none of them is displaced.
#[test]
fn a_wheel_tilts_what_rests_on_an_orbit() {
    let (orbit, gravity) = on_orbit();
    let n = orbit.mean_motion().unwrap();
    let wheel = Wheel::new(Direction::new(0.3, 0.9, -0.4), 0.4 * n, Motor::HeldSpeed).unwrap();
    let rotor = free([1.7, 5.1, 6.2]).with_wheels(&[wheel]).unwrap();
    let all =
        OrbitalEquilibrium::all(&rotor, &gravity, at(generic_attitude(), AngularVelocity::ZERO)).unwrap();
    let all = all.unwrap();
    assert!(all.len() >= 8 && all.iter().all(|e| e.tilt > 1e-3), "{}", all.len());
    let period = orbit.period().unwrap();
    for e in &all {
        let time = 40.0 + 0.1 * period;
        let motion = Trajectory::compute(&rotor, &gravity, e.state, &[time], Method::Auto, 1e-14).unwrap();
        let end = motion.samples()[0].state;
        let up = end.attitude.inverse() * orbit.position(time);
        assert!(up.angle_to(e.up) < 1e-6, "{}", up.angle_to(e.up));
    }
}

/// Returns a symmetric top about its pivot, with a generic axis in the body.
fn top() -> Rotor {
    let axis = turned() * Direction::new(0.0, 0.0, 1.0);
    let inertia = InertiaTensor::diagonal([0.4, 0.4, 0.33]).unwrap().in_frame(turned());
    let arm: Position<Body> = Position::from_array((axis * 0.37).to_array());
    Rotor::pivoted(&MassProperties::new(2.3, arm, inertia).unwrap(), Position::ZERO)
}

fn gravity() -> UniformGravity {
    UniformGravity { acceleration: Acceleration::new(1.3, -2.2, 8.1) }
}

/// Returns an attitude with the top's axis at an angle from the vertical.
fn leaning(angle: f64) -> Attitude {
    let up: Direction<Space> = -gravity().acceleration.direction().unwrap();
    let across = up.cross(Direction::new(0.2, 0.9, -0.3)).direction().unwrap();
    let e = generic_attitude() * (turned() * Direction::new(0.0, 0.0, 1.0));
    let upright =
        Rotation::<Space, Space>::from_axis_angle(e.cross(up), e.angle_to(up)).unwrap() * generic_attitude();
    Rotation::<Space, Space>::from_axis_angle(across, angle).unwrap() * upright
}

#[test]
fn a_top_off_its_steady_precession_nods_about_it() {
    let (rotor, gravity) = (top(), gravity());
    let up: Direction<Space> = -gravity.acceleration.direction().unwrap();
    let e = turned() * Direction::new(0.0, 0.0, 1.0);
    for (angle, spin, across) in [(0.6, 90.0, 0.0), (1.4, -70.0, 1.3), (2.5, 30.0, -2.0), (0.9, 0.0, 2.2)] {
        let attitude = leaning(angle);
        let omega = e * spin + (attitude.inverse() * up) * across;
        let start = at(attitude, AngularVelocity::from_array(omega.to_array()));
        let steady = SteadyTop::with_momenta_of(&rotor, &gravity, start).unwrap();
        // The same angular momenta about the vertical and about the axis.
        let momenta = |s: &State| {
            let l = rotor.angular_momentum(s.omega);
            [l.dot(e), (s.attitude * l).dot(up)]
        };
        for (now, then) in momenta(&steady.state).into_iter().zip(momenta(&start)) {
            assert!((now - then).abs() < 1e-12 * (1.0 + then.abs()), "{now} {then}");
        }
        // It keeps its angle, about which the axis of the start nutates.
        let top = HeavyTop::of(&rotor, &gravity, steady.state).unwrap();
        let [highest, lowest] = top.nutation_bounds();
        assert!(lowest - highest < 1e-12 && (highest - steady.angle).abs() < 1e-12, "{steady:?}");
        assert!(matches!(steady.path, TopPath::SteadySlow | TopPath::SteadyFast | TopPath::Conical));
        let [high, low] = HeavyTop::of(&rotor, &gravity, start).unwrap().nutation_bounds();
        assert!(high - 1e-12 < steady.angle && steady.angle < low + 1e-12, "{high} {low} {}", steady.angle);
        // Small nutations have the limiting period of the elliptic functions.
        let frequency = std::f64::consts::TAU / top.nutation_period().unwrap();
        let modes = &steady.oscillations.modes;
        assert_eq!((modes.len(), steady.oscillations.is_stable()), (1, true), "{modes:?}");
        assert!((modes[0].frequency / frequency - 1.0).abs() < 1e-8, "{modes:?} {frequency}");
        let [turned, slower] = steady.distance_from(&rotor, &start);
        assert!((turned - (steady.angle - angle).abs()).abs() < 1e-12 && slower.is_finite());
    }
}

#[test]
fn an_upright_top_sleeps_or_leans() {
    let (rotor, gravity) = (top(), gravity());
    let e = turned() * Direction::new(0.0, 0.0, 1.0);
    let start = |spin: f64| at(leaning(0.0), AngularVelocity::from_array((e * spin).to_array()));
    let threshold = HeavyTop::of(&rotor, &gravity, start(1.0)).unwrap().sleeping_threshold();
    for (part, sleeps) in [(0.7, false), (1.2, true)] {
        let touched = State {
            omega: start(part * threshold).omega + AngularVelocity::new(1e-3, 2e-3, 1e-3),
            ..start(0.0)
        };
        let upright = SteadyTop::upright(&rotor, &gravity, touched).unwrap();
        assert_eq!((upright.oscillations.is_stable(), upright.angle), (sleeps, 0.0));
        let [turned, slower] = upright.distance_from(&rotor, &touched);
        assert!(turned < 1e-7 && slower > 1e-3 && slower < 3e-3, "{turned} {slower}");
        let steady = SteadyTop::with_momenta_of(&rotor, &gravity, touched).unwrap();
        assert!(steady.oscillations.is_stable());
        // Below the threshold it would be inclined where (1 + cos θ)² A M g l = (C ω3)².
        let x: f64 = 2.0 * part;
        let lean = if sleeps { 0.0 } else { (x - 1.0).acos() };
        assert!((steady.angle - lean).abs() < 2e-3, "{} {lean}", steady.angle);
    }
    // Hanging, with spin: it remains so.
    let hangs = at(leaning(std::f64::consts::PI), start(3.0).omega);
    let steady = SteadyTop::with_momenta_of(&rotor, &gravity, hangs).unwrap();
    assert_eq!(steady.path, TopPath::Hanging);
}

/// The roots of friction.rs are those of the six equations of a small perturbation.
#[test]
fn friction_ends_every_spin_but_those_of_least_energy() {
    let sink = EnergySink::new(0.013).unwrap();
    let plain = free([1.3, 2.9, 3.7]);
    let wheel = Wheel::new(Direction::new(0.5, -0.7, 0.3), 0.6, Motor::HeldSpeed).unwrap();
    for rotor in [plain.clone(), plain.with_wheels(&[wheel]).unwrap()] {
        let all = PermanentRotation::all(&rotor, 5.0).unwrap();
        let names: Vec<&str> = all.iter().map(|one| one.with_friction(&sink).name()).collect();
        assert_eq!(names, ["settles", "settles", "leaves", "leaves", "leaves", "leaves"]);
        for one in &all {
            assert_eq!(one.is_ended_by_friction(), one.with_friction(&sink).name() == "leaves");
            let state = at(generic_attitude(), one.omega);
            let six = SmallOscillations::about_equilibrium(&rotor, &[TorqueModel::EnergySink(sink)], state)
                .unwrap();
            // Excludes the roots that only turn the axis in space and are conserved.
            let rates = six.modes.iter().map(|mode| mode.growth_rate).filter(|rate| *rate != 0.0);
            let fastest = rates.fold(f64::NEG_INFINITY, f64::max);
            let rate = match one.with_friction(&sink) {
                DissipativeLimit::Leaves { rate, .. } => rate,
                DissipativeLimit::Settles { rate, .. } => -rate,
                _ => panic!("{one:?}"),
            };
            assert!((rate / fastest - 1.0).abs() < 1e-8, "{rate} {fastest} {one:?}");
        }
    }
    // A flat spin of a body with two equal moments settles onto one point of their circle.
    let flat = free([0.2, 5.0, 5.0]);
    for k in [1, 2] {
        let omega = AngularVelocity::from_array((flat.principal().axis(k) * 0.4).to_array());
        let DissipativeLimit::Settles { rate, .. } =
            PermanentRotation::of(&flat, omega).unwrap().with_friction(&sink)
        else {
            panic!("{k}")
        };
        assert!((rate / (0.013 * 4.0 * (5.0 - 0.2)) - 1.0).abs() < 1e-12, "{rate}");
    }
}

/// A motor that runs for a while changes the angular momentum of its wheel; then another axis may
/// be stable.
#[test]
fn permanent_rotations_are_those_of_the_wheels_of_the_time() {
    let body = free([1.3, 2.9, 3.7]);
    let schedule = Some(Schedule::window(3.0, 8.0).unwrap());
    let motor = Motor::Torque { inertia: 0.1, torque: 0.9, schedule };
    let rotor = body.with_wheels(&[Wheel::new(Direction::new(0.2, 0.5, -0.4), 0.0, motor).unwrap()]).unwrap();
    assert_eq!(PermanentRotation::times(&rotor), [0.0, 8.0]);
    let [before, after] = [0.0, 8.0].map(|time| PermanentRotation::all_at(&rotor, 2.0, time).unwrap());
    assert_eq!((before.len(), after.len()), (6, 2)); // at the end the wheel, 4.5 kg·m²/s, dominates
    for one in after {
        assert!((one.momentum.norm() / 2.0 - 1.0).abs() < 1e-13);
        let motion = [TorqueModel::EnergySink(EnergySink::new(1e-9).unwrap())];
        let state = State { time: 8.0, attitude: generic_attitude(), omega: one.omega };
        let later = Trajectory::compute(&rotor, &motion, state, &[20.0], Method::Auto, 1e-13).unwrap();
        assert!((later.samples()[0].state.omega - one.omega).norm() < 1e-10);
    }
    assert!(PermanentRotation::all_at(&rotor, 2.0, 5.0).is_err());
    let always = Motor::Torque { inertia: 0.1, torque: 0.9, schedule: None };
    let driven = free([1.3, 2.9, 3.7])
        .with_wheels(&[Wheel::new(Direction::new(0.2, 0.5, -0.4), 0.0, always).unwrap()])
        .unwrap();
    assert!(PermanentRotation::times(&driven).is_empty());
}

#[test]
fn modes_of_one_frequency_are_a_basis() {
    // Hanging from a point with two equal moments, it swings about any horizontal axis.
    let (rotor, gravity) = (top(), [TorqueModel::Gravity(gravity())]);
    let down = at(leaning(std::f64::consts::PI), AngularVelocity::ZERO);
    let swings = SmallOscillations::about_equilibrium(&rotor, &gravity, down).unwrap();
    let [a, b] = swings.modes.as_slice() else { panic!("{swings:?}") };
    assert_eq!((a.multiplicity, b.multiplicity), (2, 2));
    let e = turned() * Direction::<Body>::new(0.0, 0.0, 1.0);
    for (u, v) in [(a.axis, b.axis), (b.axis, e), (e, a.axis)] {
        assert!(u.dot(v).abs() < 1e-9 && (u.norm() - 1.0).abs() < 1e-12);
    }
    assert_eq!((a.minor_axis, b.minor_axis), (Direction::ZERO, Direction::ZERO));
    // Upside down it falls about any of them and swings back up.
    let over =
        SmallOscillations::about_equilibrium(&rotor, &gravity, at(leaning(0.0), AngularVelocity::ZERO))
            .unwrap();
    assert!(
        over.modes.len() == 4 && over.modes.iter().all(|m| m.multiplicity == 2 && m.axis.dot(e).abs() < 1e-9)
    );
    // A spring that resists every rotation equally, on a spherical body.
    let rest = generic_attitude();
    let spring = [TorqueModel::Torsion(Torsion::spring(0.7, rest).unwrap())];
    let ball =
        SmallOscillations::about_equilibrium(&free([2.1; 3]), &spring, at(rest, AngularVelocity::ZERO))
            .unwrap();
    assert!(ball.modes.len() == 3 && ball.modes.iter().all(|m| m.multiplicity == 3));
    // Three different moments: three separate modes.
    let one = SmallOscillations::about_equilibrium(
        &free([1.3, 2.9, 3.7]),
        &spring,
        at(rest, AngularVelocity::ZERO),
    )
    .unwrap();
    assert!(one.modes.len() == 3 && one.modes.iter().all(|m| m.multiplicity == 1));
}
