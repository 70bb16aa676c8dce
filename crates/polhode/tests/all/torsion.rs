//! Torsion springs and wires: pendulums that swing alike at every amplitude, and energy that is kept.

use polhode::motion::Ending;
use polhode::motion::torque::Torsion;
use polhode::prelude::*;

const METHODS: [Method; 2] = [Method::Taylor, Method::Dop853];

fn body() -> MassProperties<Body> {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap()
}

fn rest() -> Attitude {
    Attitude::from_quaternion([0.8, 0.1, -0.4, 0.5]).unwrap()
}

/// A spring, and a wire along an axis of space.
fn springs(stiffness: f64, axis: Direction<Space>) -> [TorqueModel; 2] {
    [Torsion::spring(stiffness, rest()), Torsion::wire(stiffness, rest(), axis)]
        .map(|torsion| TorqueModel::Torsion(torsion.unwrap()))
}

#[test]
fn the_period_is_the_same_at_every_amplitude() {
    let rotor = Rotor::free(&body());
    // About the intermediate axis a tilt of rounding would grow.
    let (moment, axis) = (rotor.principal().moments()[2], rest() * rotor.principal().axis(2));
    let stiffness = 1.7;
    let rate = (stiffness / moment).sqrt();
    for amplitude in [1e-9, 0.01, 1.0, 3.1] {
        let start = State {
            time: 0.0,
            attitude: Rotation::<Space, Space>::about(axis, amplitude).unwrap() * rest(),
            omega: AngularVelocity::ZERO,
        };
        for torque in springs(stiffness, axis) {
            for method in METHODS {
                let times: Vec<_> = (0..40).map(|k| f64::from(k) * 0.77).collect();
                let torques = [torque.clone()];
                let motion = Trajectory::compute(&rotor, &torques, start, &times, method, 1e-15).unwrap();
                for sample in motion.samples() {
                    // ψ = ψ₀ cos √(κ/I) t
                    let angle = amplitude * (rate * sample.state.time).cos();
                    let want = Rotation::<Space, Space>::about(axis, angle).unwrap() * rest();
                    let error = sample.state.attitude.angle_to(want);
                    // The smallest is as accurate as the tolerance, not relative to itself.
                    assert!(error < 6e-14, "{method:?} {amplitude} t = {}: {error:e}", sample.state.time);
                }
                // Angles are good to the tolerance, whatever the amplitude.
                let energy = Drift::of(&motion).unwrap().total_energy.unwrap();
                assert!(energy < 1e-13 + 2e-14 / amplitude, "{method:?} {amplitude}: {energy:e}");
            }
        }
    }
}

#[test]
fn both_integrators_keep_the_energy_and_agree() {
    let axis = Direction::new(0.3, -0.5, 0.9);
    let pivoted = Rotor::pivoted(&body(), Position::new(-0.2, 0.1, 0.05));
    let start = State {
        time: 0.0,
        attitude: Attitude::from_quaternion([0.9, -0.2, 0.1, 0.6]).unwrap(),
        omega: AngularVelocity::new(0.4, -0.7, 0.3),
    };
    let times: Vec<_> = (0..=20).map(f64::from).collect();
    for torque in springs(2.9, axis) {
        // With gravity at the pivot, so that the body tilts.
        let torques = [
            torque,
            TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(0.1, 0.3, -1.2) }),
        ];
        let [a, b] = METHODS.map(|method| {
            let motion = Trajectory::compute(&pivoted, &torques, start, &times, method, 1e-15).unwrap();
            let drift = Drift::of(&motion).unwrap();
            assert!(drift.total_energy.unwrap() < 3e-13, "{method:?}: {drift:?}");
            assert!(drift.work_energy < 3e-13 && drift.momentum < 3e-13, "{method:?}: {drift:?}");
            motion
        });
        for (a, b) in a.samples().iter().zip(b.samples()) {
            let error = (a.state.omega - b.state.omega).norm();
            assert!(error < 1e-12, "t = {}: {error:e}", a.state.time);
            assert!(a.state.attitude.angle_to(b.state.attitude) < 1e-12);
        }
    }
}

#[test]
fn a_twist_beyond_half_a_turn_is_an_error_at_its_time() {
    let rotor = Rotor::free(&body());
    let (moment, axis) = (rotor.principal().moments()[2], rotor.principal().axis(2));
    let stiffness = 1.7;
    let rate = (stiffness / moment).sqrt();
    // From rest, fast enough for an amplitude of 400°: half a turn comes when sin √(κ/I) t = 180/400.
    let amplitude = 400.0_f64.to_radians();
    let omega = axis * (amplitude * rate);
    let start = State { time: 0.0, attitude: rest(), omega: AngularVelocity::from_array(omega.to_array()) };
    let passes = 0.45_f64.asin() / rate;
    for torque in springs(stiffness, rest() * axis) {
        for method in METHODS {
            let torques = [torque.clone()];
            let before = Trajectory::compute(&rotor, &torques, start, &[0.999 * passes], method, 1e-13);
            assert!(before.is_ok());
            let motion =
                Trajectory::compute(&rotor, &torques, start, &[2.0 * passes], method, 1e-13).unwrap();
            let Ending::Failed { time, cause: error } = motion.ending().clone() else { panic!("{motion:?}") };
            assert_eq!(error, MotionError::HalfTurn { time });
            assert!(error.is_numerical() && error.hint().is_some());
            assert!(time < passes && time > 0.2 * passes, "{method:?}: {time} of {passes}");
        }
    }
}
