//! Free motion compared with references of 40 digits, in every regime.

use crate::common::{cases, number, numbers, start, table};
use polhode::motion::FreeMotions;
use polhode::prelude::*;

/// Errors of the worst row of a case, and their times.
#[derive(Default)]
struct Worst {
    omega: (f64, f64),
    attitude: (f64, f64),
}

fn worst_of(case: &toml::Table) -> Worst {
    let motion = FreeMotion::of_moments(numbers(&case["moments"]), start(case)).unwrap();
    let mut worst = Worst::default();
    for row in cases(case, "row") {
        let t = number(&row["t"]);
        let state = motion.at(t);
        let truth = AngularVelocity::<Body>::from_array(numbers(&row["omega"]));
        let error = if truth.norm() == 0.0 {
            state.omega.norm()
        } else {
            (state.omega - truth).norm() / truth.norm()
        };
        let turned = state.attitude.angle_to(crate::common::attitude(&row["attitude"]));
        // NaN counts as worst
        if !(error <= worst.omega.0) {
            worst.omega = (error, t);
        }
        if !(turned <= worst.attitude.0) {
            worst.attitude = (turned, t);
        }
    }
    worst
}

#[test]
fn every_regime_follows_the_reference_for_a_thousand_million_periods() {
    let mut failures = Vec::new();
    for case in cases(&table("free_motion"), "case") {
        let name = case["name"].as_str().unwrap();
        let Worst { omega, attitude } = worst_of(case);
        println!(
            "{name:50} omega {:.1e} at {:.2e}   attitude {:.1e} at {:.2e}",
            omega.0, omega.1, attitude.0, attitude.1
        );
        if !(omega.0 <= 4e-15 && attitude.0 <= 4e-15) {
            failures.push(format!("{name}: omega {:e}, attitude {:e}", omega.0, attitude.0));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn many_states_have_the_bits_of_one() {
    for case in cases(&table("free_motion"), "case") {
        let motion = FreeMotion::of_moments(numbers(&case["moments"]), start(case)).unwrap();
        let unit = motion.period().unwrap_or(1.0);
        // counts 0 … 139: full blocks, full groups and remainders, including the start, and times
        // out of range
        let times: Vec<f64> =
            (0..140).map(|k| unit * (f64::from(k) - 7.0) * 0.0917 * 3f64.powi(k / 10)).collect();
        let times: Vec<f64> = times.into_iter().chain([1e300, -f64::MAX, f64::NAN, 1e20 * unit]).collect();
        for count in [0, 1, 15, 16, 17, 64, 80, 144] {
            let many = motion.at_times(&times[..count]);
            assert_eq!(many.len(), count);
            for (&time, state) in times.iter().zip(many) {
                if !(time.abs() <= motion.reach()) {
                    assert!(is_unknown(&state) && is_unknown(&motion.at(time)), "{time} {state:?}");
                    continue;
                }
                assert_eq!(state, motion.at(time), "{} at {time}", case["name"].as_str().unwrap());
                assert!(
                    state.omega.is_finite()
                        && (state.attitude.quaternion().iter().map(|c| c * c).sum::<f64>() - 1.0).abs()
                            < 1e-15
                );
            }
        }
    }
}

fn is_unknown(state: &State) -> bool {
    state.omega.to_array().iter().chain(&state.attitude.quaternion()).all(|x| x.is_nan())
}

#[test]
fn beyond_reach_nothing_is_said() {
    let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    let start = State { time: -7.5, attitude, omega: AngularVelocity::new(0.31117, -0.49321, 0.87113) };
    let rotor = turned_body([1.3, 2.1, 2.9]);
    let motion = FreeMotion::of(&rotor, start).unwrap();
    let reach = motion.reach();
    assert!((1e24..1e26).contains(&reach), "{reach:e}");
    let far = [2.0 * reach, -2.0 * reach, 1e40, 1e300, f64::INFINITY, f64::NAN];
    for time in far {
        let refused = motion.require(&[1.0, 0.5 * reach, time]);
        match refused {
            Err(MotionError::BeyondReach { time: said, reach: known }) => {
                assert!(said.to_bits() == time.to_bits() && known == reach, "{said} {known}");
            }
            other => panic!("{other:?}"),
        }
        assert!(is_unknown(&motion.at(time)));
        let all = FreeMotions::of(&[motion; 11]).at(time);
        assert!(all.len() == 11 && all.iter().all(is_unknown));
        let after = time.abs();
        let simulation = Simulation::new(&rotor, &[], start, std::slice::from_ref(&after));
        if time.is_finite() {
            assert!(matches!(simulation.states(), Err(MotionError::BeyondReach { .. })));
            assert!(matches!(simulation.run(), Err(MotionError::BeyondReach { .. })));
            let refused = Trajectory::of_motion(motion, &[time]);
            assert!(matches!(refused, Err(MotionError::BeyondReach { .. })));
        }
    }
    // One motion far away, the others near: each is independent.
    let slow = FreeMotion::of(&rotor, State { omega: start.omega * 1e-9, ..start }).unwrap();
    let states = FreeMotions::of(&[motion, slow, motion]).at(2.0 * reach);
    assert!(is_unknown(&states[0]) && is_unknown(&states[2]) && states[1] == slow.at(2.0 * reach));
    assert!(motion.require(&[0.9 * reach, -0.9 * reach]).is_ok());
    // A body at rest is known at all times.
    let rest = FreeMotion::of(&rotor, State { omega: AngularVelocity::ZERO, ..start }).unwrap();
    assert_eq!(rest.at(1e300).attitude.quaternion().map(f64::is_nan), [false; 4]);
}

#[test]
fn a_start_that_is_unit_to_rounding_keeps_its_bits() {
    let mut seed = 1_u64;
    let mut changed = 0;
    for _ in 0..20_000 {
        let mut component = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / 2f64.powi(52) - 1.0
        };
        let q: [f64; 4] = std::array::from_fn(|_| component());
        let length = q.iter().map(|c| c * c).sum::<f64>().sqrt();
        let unit = q.map(|c| c / length);
        let attitude = Attitude::from_quaternion(unit).unwrap();
        assert_eq!(attitude.quaternion(), unit);
        let start = State { time: 0.0, attitude, omega: AngularVelocity::new(0.3, 0.5, 0.9) };
        let motion = FreeMotion::of_moments([1.0, 2.0, 3.0], start).unwrap();
        assert_eq!(motion.at(0.0).attitude.quaternion(), unit);
        // repeated with more than rounding
        let longer = unit.map(|c| c * (1.0 + 1e-14));
        changed += usize::from(Attitude::from_quaternion(longer).unwrap().quaternion() != longer);
    }
    assert_eq!(changed, 20_000);
}

#[test]
fn a_motion_starts_where_it_starts() {
    for case in cases(&table("free_motion"), "case") {
        for time in [0.0, -7.3, 1e9] {
            let start = State { time, ..start(case) };
            let motion = FreeMotion::of_moments(numbers(&case["moments"]), start).unwrap();
            assert_eq!(motion.at(time), start);
            // and no jump next to it
            let beside = motion.at(if time == 0.0 { f64::MIN_POSITIVE } else { time.next_up() });
            let step = (beside.time - time) * start.omega.norm();
            if motion.require(&[beside.time]).is_err() {
                assert!(step > 1e24 && is_unknown(&beside));
                continue;
            }
            assert!(
                (beside.omega - start.omega).norm() <= (4e-15 + 4.0 * step) * start.omega.norm(),
                "{}",
                case["name"].as_str().unwrap()
            );
            assert!(
                beside.attitude.angle_to(start.attitude) <= 4e-15 + 1.1 * step,
                "{}",
                case["name"].as_str().unwrap()
            );
        }
    }
}

#[test]
fn many_bodies_have_the_bits_of_one() {
    let table = table("free_motion");
    let motions: Vec<_> = cases(&table, "case")
        .into_iter()
        .enumerate()
        .map(|(k, case)| {
            let start = State { time: if k % 3 == 0 { 12.5 } else { 0.1 * k as f64 }, ..start(case) };
            FreeMotion::of_moments(numbers(&case["moments"]), start).unwrap()
        })
        .collect();
    for count in [0, 1, 7, 8, 9, motions.len()] {
        let all = FreeMotions::of(&motions[..count]);
        assert_eq!((all.len(), all.is_empty()), (count, count == 0));
        for time in [12.5, -3.3e9, 0.1] {
            let states = all.at(time);
            assert_eq!(states.len(), count);
            for (motion, state) in motions.iter().zip(states) {
                let one = motion.at(time);
                assert!(state == one || is_unknown(&state) && is_unknown(&one), "{time} {state:?} {one:?}");
                assert_eq!(is_unknown(&one), motion.require(&[time]).is_err());
            }
        }
    }
}

/// 3 R of a rotation R with rational elements, by rows: a body rotated by it has exactly known
/// numbers.
const TURN: [[f64; 3]; 3] = [[1.0, 2.0, 2.0], [2.0, 1.0, -2.0], [-2.0, 2.0, -1.0]];

fn turned(v: [f64; 3]) -> [f64; 3] {
    TURN.map(|row| (row[0] * v[0] + row[1] * v[1] + row[2] * v[2]) / 3.0)
}

/// Returns a body with moments 9 m rotated by R, and with ω = 3 R w: exact for integers of moderate
/// size.
fn turned_body([a, b, c]: [f64; 3]) -> Rotor {
    let element = |i: usize, j: usize| {
        let t = TURN;
        t[i][0] * t[j][0] * a + t[i][1] * t[j][1] * b + t[i][2] * t[j][2] * c
    };
    let inertia = InertiaTensor::with_negative_products(
        [element(0, 0), element(1, 1), element(2, 2)],
        [element(0, 1), element(0, 2), element(1, 2)],
    );
    Rotor::free(&MassProperties::new(1.7, Position::new(0.3, -1.0, 2.0), inertia.unwrap()).unwrap())
}

#[test]
fn a_turned_tensor_loses_nothing() {
    let near = 2f64.powi(40);
    let nearer = 2f64.powi(48);
    for (name, moments, w) in [
        ("generic short", [1.0, 2.0, 2.75], [0.375, 0.5, 0.875]),
        ("generic long, order 312", [2.75, 1.0, 2.0], [-0.5, 1.25, 0.125]),
        ("near separatrix", [3.0, 4.0, 6.0], [2.0 + 2f64.powi(-38), 1.0, -1.0]),
        ("near separatrix, long", [3.0, 4.0, 6.0], [2.0 + 2f64.powi(-40), -3.0, 1.0 - 2f64.powi(-39)]),
        ("near sphere", [near, near + 1.0, near + 3.0], [0.375, 0.5, 0.875]),
        ("nearer sphere", [nearer, nearer + 1.0, nearer + 2.0], [0.375, -0.5, 0.875]),
        ("near oblate", [near, near + 1.0, near + near / 2.0], [1.0, 0.375, 2f64.powi(-23)]),
        ("near prolate", [near / 2.0, near - 1.0, near], [2f64.powi(-23), 1.0, 0.25]),
        ("oblate", [2.0, 2.0, 3.0], [0.375, 0.5, 0.875]),
        ("sphere", [2.0, 2.0, 2.0], [0.375, 0.5, 0.875]),
        ("rod", [0.0, 1.0, 1.0], [0.375, 0.5, 0.875]),
    ] {
        let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
        let plain = State { time: 0.1, attitude, omega: AngularVelocity::from_array(w.map(|w| 3.0 * w)) };
        let along = FreeMotion::of_moments(moments.map(|m| 9.0 * m), plain).unwrap();
        let r = Rotation::<Body, Body>::from_matrix(TURN.map(|row| row.map(|c| c / 3.0))).unwrap();
        let omega = AngularVelocity::from_array(turned(plain.omega.to_array()));
        let across = FreeMotion::of(&turned_body(moments), State { omega, ..plain }).unwrap();
        let scale = along.period().unwrap_or(1.0);
        for periods in [0.37, -12.3, 1.0e3, 1.0e6, -1.0e9] {
            let time = periods * scale;
            let (p, q) = (along.at(time), across.at(time));
            let truth = AngularVelocity::<Body>::from_array(turned(p.omega.to_array()));
            let error = (q.omega - truth).norm() / truth.norm();
            // Rotated body axes, the same attitude: A′(t) = A(0) R A(0)⁻¹ · A(t) · R⁻¹
            let expected = (attitude * r * attitude.inverse()) * p.attitude * r.inverse();
            let angle = q.attitude.angle_to(expected);
            assert!(angle < 6e-15, "{name} at {periods} periods: attitude {angle:e}");
            assert!(error < 6e-15, "{name} at {periods} periods: omega {error:e}");
            let [l, m] = [&along, &across].map(polhode::motion::FreeMotion::momentum);
            assert!((l.norm() / m.norm() - 1.0).abs() < 1e-14);
        }
    }
}

#[test]
fn a_start_at_any_time_keeps_the_digits() {
    // A nearly spherical body from a generic time; turn(L̂, |L| τ/i1) · turn(e, −Ω τ) with
    // 80 digits, by mpmath.
    let omega = AngularVelocity::new(0.3, 0.5, 0.9);
    let start = State { time: 1e9 / 3.0, attitude: Attitude::identity(), omega };
    let motion = FreeMotion::of_moments([1.0, 1.0, 1.0 + 1e-12], start).unwrap();
    for (time, attitude) in [
        (
            1e18,
            [
                0.933_193_469_581_852_4,
                -0.005_117_720_101_757_603,
                0.150_994_304_907_037_13,
                -0.326_074_342_990_038_2,
            ],
        ),
        (
            -1e20,
            [
                -0.062_216_663_801_365_54,
                0.397_576_686_297_361_4,
                0.053_553_438_531_236_9,
                0.913_889_432_305_527,
            ],
        ),
        (
            1e21,
            [
                0.964_266_143_755_302,
                -0.222_229_802_472_064_3,
                -0.142_059_984_107_099_16,
                0.024_973_582_362_117_795,
            ],
        ),
    ] {
        let error = motion.at(time).attitude.angle_to(Attitude::from_quaternion(attitude).unwrap());
        assert!(error < 4e-15, "{time}: {error:e}");
    }
}

#[test]
fn nothing_is_ever_undefined() {
    let tiny =
        [0.0, 5e-324, 1e-320, 1e-300, 1e-200, 1e-165, 1e-162, 1e-160, 1e-155, 1e-150, 1e-100, 1e-17, 1.0];
    for moments in [
        [1.0, 2.0, 3.0],
        [3.0, 1.0, 2.0],
        [1.0, 1.0, 2.0],
        [2.0, 3.0, 3.0],
        [1.0; 3],
        [0.0, 1.0, 1.0],
        [1e-120, 1.0, 1.0],
    ] {
        for a in tiny {
            for b in tiny {
                for (k, omega) in
                    [[a, 1.0, b], [-1.0, a, b], [b, a, 1.0], [a, b, 0.0]].into_iter().enumerate()
                {
                    for scale in [1.0, 1e-150, 1e150] {
                        let omega = AngularVelocity::from_array(omega.map(|w| w * scale));
                        let start = State { time: 0.1, attitude: Attitude::identity(), omega };
                        let motion = FreeMotion::of_moments(moments, start).unwrap();
                        let period = motion.period();
                        assert!(period.is_none_or(|p| p > 0.0 && p.is_finite()));
                        assert!(motion.reach() >= 2e9 / scale, "{moments:?} {omega:?}: {:e}", motion.reach());
                        for time in [0.0, 1.0 / scale, -1e9 / scale, 1e300, f64::MAX, f64::INFINITY] {
                            let state = motion.at(time);
                            if !((time - 0.1).abs() <= motion.reach()) {
                                assert!(is_unknown(&state));
                                continue;
                            }
                            let norm: f64 = state.attitude.quaternion().iter().map(|c| c * c).sum();
                            assert!(
                                state.omega.is_finite() && (norm - 1.0).abs() < 1e-15,
                                "{moments:?} {omega:?} case {k} at {time}: {state:?}"
                            );
                            assert!(
                                motion.angular_acceleration(&state).to_array().iter().all(|c| !c.is_nan())
                            );
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn energy_momentum_and_acceleration_are_those_of_the_definition() {
    let rotor = turned_body([1.3, 2.1, 2.9]);
    let omega = AngularVelocity::new(0.31, -0.83, 0.59);
    let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    let start = State { time: 0.3, attitude, omega };
    let motion = FreeMotion::of(&rotor, start).unwrap();
    assert!((motion.kinetic_energy() / rotor.kinetic_energy(omega) - 1.0).abs() < 1e-15);
    assert!((motion.momentum() - rotor.angular_momentum_space(&start)).norm() < 1e-14);
    for time in [0.3, -4.0, 77.7] {
        let state = motion.at(time);
        assert!((motion.angular_momentum(&state) - rotor.angular_momentum(state.omega)).norm() < 2e-14);
        let rate = motion.angular_acceleration(&state);
        assert!((rate - rotor.acceleration(state.omega, Torque::ZERO)).norm() < 1e-15);
        let h = 1e-4;
        let difference = (motion.at(time + h).omega - motion.at(time - h).omega) / (2.0 * h);
        assert!(
            (difference.to_array()[0] - rate.x).abs() < 1e-8
                && (difference.to_array()[1] - rate.y).abs() < 1e-8
        );
        assert!((difference.to_array()[2] - rate.z).abs() < 1e-8);
    }
}

#[test]
fn too_many_states_stay_as_they_are() {
    let start =
        State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.3, 0.5, 0.9) };
    let motion = FreeMotion::of_moments([1.0, 2.0, 3.0], start).unwrap();
    let other = State { time: 0.0, omega: AngularVelocity::new(9.0, 9.0, 9.0), ..start };
    let mut states = [other; 3];
    motion.fill(&[0.0], &mut states);
    assert_eq!(states, [start, other, other]);
    assert!(matches!(
        FreeMotion::of_moments([1e-200, 1.0, 1.0], start),
        Err(MotionError::ParameterOutOfRange { value: 1e-200, .. })
    ));
}
