//! Large amplitudes, logs of the exact motion, wrong models, shared numbers, and unobservable
//! directions.

use nalgebra::{Matrix3, Quaternion, Vector3};
use polhode::math::{Direction, Position, Rotation};

use super::exact::{Hanging, State};
use super::statistics::Noise;
use crate::ResidualTest;
use crate::swing::*;

const G: f64 = 9.80665;

/// Returns a bifilar pendulum of a body about its axis of symmetry, with mass, moments, wire
/// distance r and length L.
fn bifilar(mass: f64, moments: [f64; 3], r: f64, length: f64) -> (Hanging, State) {
    let top = |x| Vector3::new(x, 0.0, length);
    let hanging = Hanging {
        mass,
        inertia: Matrix3::from_diagonal(&Vector3::from(moments)),
        gravity: G,
        stiffness: 0.0,
        wires: vec![(top(r), Vector3::new(r, 0.0, 0.0)), (top(-r), Vector3::new(-r, 0.0, 0.0))],
        viscous: 0.0,
        quadratic: 0.0,
    };
    let still =
        State { p: Vector3::zeros(), e: Quaternion::identity(), v: Vector3::zeros(), w: Vector3::zeros() };
    (hanging, still)
}

/// Returns the state rotated by an angle, at the height that the wires require.
fn turned(still: State, angle: f64, r: f64, length: f64) -> State {
    let chord = 2.0 * r * (0.5 * angle).sin();
    let rise = length - (length * length - chord * chord).sqrt();
    State {
        p: Vector3::new(0.0, 0.0, rise),
        e: Quaternion::new((0.5 * angle).cos(), 0.0, 0.0, (0.5 * angle).sin()),
        ..still
    }
}

/// Returns the time after which the exact motion is back at its turning point.
fn period(hanging: &Hanging, start: State, about: f64) -> f64 {
    let steps = 4000;
    let h = about / f64::from(steps);
    let (mut state, mut t) = (start, 0.0);
    while t < 0.75 * about || state.twist_rate() > 0.0 {
        state = hanging.step(&state, h);
        t += h;
    }
    // Near the turning point the rate is linear in time, to second order.
    for _ in 0..4 {
        let small = 1e-4 * about;
        let there = hanging.step(&state, small);
        let slope = (there.twist_rate() - state.twist_rate()) / small;
        let back = -state.twist_rate() / slope;
        state = hanging.step(&state, back);
        t += back;
    }
    t
}

#[test]
fn at_45_degrees_the_small_angle_formula_is_some_eight_percent_off_and_this_is_not() {
    // Uniform rod of 30 cm, held at its ends by wires of 2 m. For long wires the error is 8.15 %.
    let (mass, r, length) = (1.7, 0.15, 2.0);
    let inertia = mass * r * r / 3.0;
    let (hanging, still) = bifilar(mass, [1e-5, inertia, inertia], r, length);
    let amplitude = core::f64::consts::FRAC_PI_4;
    let about = core::f64::consts::TAU * (inertia * length / (mass * G * r * r)).sqrt();
    let time = period(&hanging, turned(still, amplitude, r, length), about);
    let by_formula = mass * G * r * r * time * time / (core::f64::consts::TAU.powi(2) * length);
    assert!((by_formula / inertia - 1.085).abs() < 5e-4, "{}", by_formula / inertia);
    let mut plan = SwingPlan::new(Measured::exact(mass), [Measured::exact(0.0); 3]);
    let rig = Rig::Wires(Wires::bifilar(r, r, length));
    let mut counted = Counted::new(1.0, (time, 1e-6), [amplitude; 2], 1e-9);
    counted.damping = Damping::None;
    plan.add(SwingTest::new("rod", Placement::AS_IT_IS, rig, Measurement::Counted(counted)));
    let found = identify_swings(&plan).unwrap();
    let moment = found.tests[0].moment.as_ref().unwrap();
    assert!((moment.value / inertia - 1.0).abs() < 1e-10, "{moment:?}");
}

/// Returns the moment and a plan with a log of the exact damped motion.
fn log(viscous: f64, quadratic: f64, sd: f64, signal: Signal, seed: u64) -> (f64, SwingPlan) {
    let (mass, r, length) = (2.3, 0.17, 0.9);
    let moments = [0.031, 0.052, 0.047];
    let (mut hanging, still) = bifilar(mass, moments, r, length);
    (hanging.viscous, hanging.quadratic) = (2.0 * viscous, quadratic);
    let mut state = turned(still, 0.6, r, length);
    let mut noise = Noise::new(seed, 1.0);
    let (h, mut times, mut values) = (0.01, Vec::new(), Vec::new());
    for k in 0..4000 {
        if k >= 37 && k % 5 == 0 {
            times.push(f64::from(k) * h + 12.5);
            let exact = if signal == Signal::Angle { state.twist() } else { state.twist_rate() };
            values.push(exact + 0.02 + sd * noise.normal());
        }
        state = hanging.step(&state, h);
    }
    let mut plan = SwingPlan::new(Measured::exact(mass), [Measured::exact(0.0); 3]);
    let rig = Rig::Wires(Wires::bifilar(r, r, length));
    let logged = Logged { times, values, sd, signal, damping: Damping::Both };
    plan.add(SwingTest::new("log", Placement::AS_IT_IS, rig, Measurement::Logged(logged)));
    (moments[2], plan)
}

#[test]
fn logs_of_the_exact_damped_motion_are_fitted_to_their_noise() {
    for (viscous, quadratic, signal) in
        [(0.012, 0.0, Signal::Angle), (0.004, 0.03, Signal::Angle), (0.008, 0.02, Signal::Rate)]
    {
        let seeds = 12;
        let mut squares = 0.0;
        for seed in 0..seeds {
            let (truth, plan) = log(viscous, quadratic, 1e-3, signal, seed);
            let found = identify_swings(&plan).unwrap();
            let moment = found.tests[0].moment.as_ref().unwrap();
            let sd = moment.sd.unwrap();
            // The Cramér–Rao bound of a sinusoid with this decay is 8e-6 for an angle.
            assert!(sd < 1e-5 * truth, "{moment:?}");
            squares += ((moment.value - truth) / sd).powi(2) / seeds as f64;
            let test = &found.tests[0].residuals;
            assert!(!test.is_too_large() && !test.is_correlated(), "{test:?}");
            let own = |name: &str| found.tests[0].own.iter().find(|n| n.name == name).unwrap().value;
            // The rise contributes to the motion but not to its damping.
            assert!((own("viscous damping") - viscous).abs() < 0.07 * viscous + 5e-4);
            assert!((own("quadratic damping") - quadratic).abs() < 0.03 * quadratic + 8e-4);
        }
        // The mean of 12 squares is 1 ± 0.4.
        assert!((0.2..2.4).contains(&squares), "{squares}");
    }
}

#[test]
fn wrong_damping_shows_in_the_residuals_of_a_log() {
    let (_, mut plan) = log(0.0, 0.06, 1e-3, Signal::Angle, 6);
    let mut test = plan.tests()[0].clone();
    if let Measurement::Logged(logged) = &mut test.measurement {
        logged.damping = Damping::Viscous;
    }
    plan = SwingPlan::new(Measured::exact(2.3), [Measured::exact(0.0); 3]);
    plan.add(test);
    let found = identify_swings(&plan).unwrap();
    let test = &found.tests[0].residuals;
    assert!(test.is_too_large() && test.is_correlated() && found.widening > 2.0, "{test:?}");
}

/// Returns the estimate from counted swings of a bifilar pendulum at two amplitudes, with times of
/// the exact motion.
fn two_amplitudes(said: [f64; 2]) -> SwingEstimate {
    let (mass, r, length) = (2.3, 0.17, 0.9);
    let (hanging, still) = bifilar(mass, [0.031, 0.052, 0.047], r, length);
    let mut plan = SwingPlan::new(Measured::exact(mass), [Measured::exact(0.0); 3]);
    for (amplitude, said) in [0.15, 0.75].into_iter().zip(said) {
        let about = core::f64::consts::TAU * (0.047 * length / (mass * G * r * r)).sqrt();
        let time = period(&hanging, turned(still, amplitude, r, length), about);
        let mut counted = Counted::new(50.0, (50.0 * time, 0.05), [said; 2], 0.01);
        counted.damping = Damping::None;
        let rig = Rig::Wires(Wires::bifilar(r, r, length));
        plan.add(SwingTest::new("one", Placement::AS_IT_IS, rig, Measurement::Counted(counted)));
    }
    identify_swings(&plan).unwrap()
}

#[test]
fn amplitudes_that_are_ignored_show() {
    let right = two_amplitudes([0.15, 0.75]);
    assert_eq!(right.widening, 1.0);
    let moment = right.tests[0].moment.as_ref().unwrap();
    assert!((moment.value - 0.047).abs() < 0.1 * moment.sd.unwrap(), "{moment:?}");
    let wrong = two_amplitudes([0.05, 0.05]);
    assert!(wrong.counted.as_ref().is_some_and(ResidualTest::is_too_large) && wrong.widening > 5.0);
}

#[test]
fn what_tests_share_correlates_their_moments() {
    let mut plan = SwingPlan::new(Measured::new(2.3, 1e-4), [Measured::exact(0.0); 3]);
    let r = plan.number("radius", "m", Measured::new(0.17, 1e-3));
    let length = plan.number("length", "m", Measured::new(0.9, 1e-3));
    let up = |axis: [f64; 3]| {
        let (n, z) = (Direction::from_array(axis), Direction::new(0.0, 0.0, 1.0));
        let rotation = Rotation::from_axis_angle(n.cross(z), n.angle_to(z)).unwrap_or(Rotation::identity());
        Placement { rotation, origin: Position::ZERO }
    };
    for (axis, time) in [([0.0, 0.0, 1.0], 71.0), ([1.0, 0.0, 0.0], 59.0)] {
        let rig = Rig::Wires(Wires::bifilar(r, r, length));
        let swings = Measurement::Counted(Counted::new(50.0, (time, 0.02), [0.3, 0.25], 5e-3));
        plan.add(SwingTest::new("one", up(axis), rig, swings));
    }
    let found = identify_swings(&plan).unwrap().estimate;
    let correlation = found.correlation(4, 6).unwrap();
    // Errors of r and L are fully shared, errors of the times are small:
    // (2 σ_r/r)² against (2 σ_t/t)².
    assert!(correlation > 0.98, "{correlation}");
    let relative = found.get("Izz").unwrap().sd.unwrap() / found.get("Izz").unwrap().value;
    let expected = ((2.0_f64 * 1e-3 / 0.17).powi(2) + (1e-3_f64 / 0.9).powi(2)).sqrt();
    assert!((relative / expected - 1.0).abs() < 0.02, "{relative} {expected}");
}

#[test]
fn one_axis_says_nothing_of_the_others() {
    let mut plan = SwingPlan::new(Measured::exact(2.3), [Measured::exact(0.0); 3]);
    let axis = Direction::new(0.3, -0.5, 0.8);
    let swings = Measurement::Counted(Counted::new(50.0, (66.0, 0.02), [0.3, 0.25], 5e-3));
    let rig = Rig::Axis(Axis::level([0.2, 0.1, 0.05], axis));
    plan.add(SwingTest::new("one", Placement::AS_IT_IS, rig, swings));
    let found = identify_swings(&plan).unwrap();
    assert_eq!(found.estimate.unknown.len(), 5);
    assert!((4..10).all(|k| found.estimate.numbers[k].sd.is_none()), "{:?}", found.estimate);
    let moment = found.tests[0].moment.as_ref().unwrap();
    assert!(moment.sd.is_some_and(|sd| sd > 0.0 && sd < 0.01 * moment.value), "{moment:?}");
}

#[test]
fn what_cannot_be_is_refused() {
    let plan = |rig: Rig, counted: Counted| {
        let mut plan = SwingPlan::new(Measured::exact(2.3), [Measured::exact(0.0); 3]);
        plan.add(SwingTest::new("one", Placement::AS_IT_IS, rig, Measurement::Counted(counted)));
        identify_swings(&plan)
    };
    let swings = || Counted::new(50.0, (66.0, 0.02), [0.3, 0.25], 5e-3);
    let good = || Rig::Wires(Wires::bifilar(0.1, 0.1, 1.0));
    assert!(plan(good(), swings()).is_ok());
    // No wire, a wire too short, a slack one, one without stiffness, too large an amplitude, no
    // reading.
    assert!(plan(Rig::Wires(Wires::new(Vec::new())), swings()).is_err());
    assert!(plan(Rig::Wires(Wires::bifilar(0.5, 0.1, 0.3)), swings()).is_err());
    let wire = |x: f64, y: f64, bottom: f64| Wire {
        top: [x, y, 0.0].into(),
        bottom: [bottom, y, 0.0].into(),
        length: 1.0.into(),
    };
    let beside = vec![wire(0.1, -0.1, 0.1), wire(0.1, 0.1, 0.1), wire(0.3, 0.0, 0.3)];
    assert!(plan(Rig::Wires(Wires::new(beside)), swings()).is_err());
    assert!(plan(Rig::Wires(Wires::new(vec![wire(0.0, 0.0, 0.0)])), swings()).is_err());
    assert!(plan(good(), Counted::new(50.0, (66.0, 0.02), [2.3, 0.25], 5e-3)).is_err());
    assert!(plan(good(), Counted { amplitudes: Vec::new(), ..swings() }).is_err());
    assert!(plan(good(), Counted::new(50.0, (66.0, 0.0), [0.3, 0.25], 5e-3)).is_err());
}

#[test]
fn plates_are_possible_bodies() {
    use polhode::math::elliptic::EllipticParameter;
    let axes = [
        [1.0, 0.1, 0.2],
        [0.1, 1.0, -0.2],
        [-0.15, 0.2, 1.0],
        [0.7, 0.7, 0.1],
        [0.1, 0.6, 0.8],
        [0.8, -0.1, 0.6],
    ];
    let (mass, amplitude) = (1.3, 0.4_f64);
    let k = EllipticParameter::new((0.5 * amplitude).sin().powi(2)).unwrap().k();
    let moments = [0.02, 0.035, 0.055];
    let mut squares = 0.0;
    for seed in 0..10 {
        let mut noise = Noise::new(seed, 1.0);
        let mut plan = SwingPlan::new(Measured::exact(mass), [Measured::exact(0.0); 3]);
        for axis in axes.iter().chain(&axes) {
            let n = Direction::<polhode::math::Space>::from_array(*axis).direction().unwrap();
            let across = n.cross(Direction::new(0.2, -0.3, 0.9)).direction().unwrap();
            let about = n.x * n.x * moments[0] + n.y * n.y * moments[1] + n.z * n.z * moments[2];
            let reach = 0.2;
            let moment = about + mass * reach * reach;
            let period = 4.0 * k * (moment / (mass * G * reach)).sqrt();
            let time = 60.0 * period + 0.01 * noise.normal();
            let mut counted = Counted::new(60.0, (time, 0.01), [amplitude; 2], 1e-4);
            counted.damping = Damping::None;
            let rig = Rig::Axis(Axis::level((across * reach).to_array(), n));
            plan.add(SwingTest::new("one", Placement::AS_IT_IS, rig, Measurement::Counted(counted)));
        }
        let found = identify_swings(&plan).unwrap();
        let [i1, i2, i3] = found.body.principal().moments();
        assert!(i1 >= 0.0 && i1 + i2 >= i3 * (1.0 - 1e-12), "{i1} {i2} {i3}");
        for (k, truth) in moments.into_iter().enumerate() {
            let number = &found.estimate.numbers[4 + k];
            squares += ((number.value - truth) / number.sd.unwrap()).powi(2) / 30.0;
        }
    }
    // At the boundary errors can only point inwards, so they are below the bound.
    assert!(squares < 1.6, "{squares}");
}

/// Returns a plan with counted swings of a body with this tensor, one axis each. `noise` scales the
/// noise of the times.
fn swung(tensor: [f64; 6], noise: f64, seed: u64) -> SwingPlan {
    let mut draw = Noise::new(seed, 1.0);
    let mut plan = SwingPlan::new(Measured::exact(1.7), [Measured::exact(0.0); 3]);
    let axes = [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.6, 0.64, 0.48],
        [-0.6, 0.64, 0.48],
        [0.36, -0.48, 0.8],
        [0.8, 0.48, -0.36],
    ];
    for axis in axes {
        let [x, y, z] = axis;
        let own = [x * x, y * y, z * z, 2.0 * x * y, 2.0 * x * z, 2.0 * y * z];
        let moment: f64 = own.iter().zip(&tensor).map(|(a, b)| a * b).sum();
        // A torsion spindle through the centre has the period 2π √(I/κ).
        let stiffness = 0.35;
        let time = core::f64::consts::TAU * ((moment + 4e-3) / stiffness).sqrt();
        let read = 20.0 * time + 0.01 * noise * draw.normal();
        let mut counted = Counted::new(20.0, (read, 0.01), [0.2; 2], 0.01);
        counted.damping = Damping::None;
        let rig = Rig::Axis(Axis::upright([0.0; 3], Direction::from_array(axis), stiffness));
        let mut test = SwingTest::new("axis", Placement::AS_IT_IS, rig, Measurement::Counted(counted));
        // Moment of the spindle itself.
        test.air.moment = 4e-3.into();
        plan.add(test);
    }
    plan
}

#[test]
fn rods_along_any_direction_are_found() {
    for direction in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.48, -0.6, 0.64]] {
        let [x, y, z] = direction;
        let size = 0.0127;
        let tensor = [1.0 - x * x, 1.0 - y * y, 1.0 - z * z, -x * y, -x * z, -y * z].map(|e| size * e);
        let found =
            identify_swings(&swung(tensor, 0.0, 1)).unwrap_or_else(|error| panic!("{direction:?}: {error}"));
        for (number, truth) in found.estimate.numbers[4..10].iter().zip(tensor) {
            let sd = number.sd.unwrap();
            assert!(
                (number.value - truth).abs() < 0.3 * sd && sd < 0.02 * size,
                "{direction:?}: {number:?} {truth}"
            );
        }
        assert!(found.widening < 1.0 + 1e-9);
        // With noise the estimate is at the boundary, because some of these times are inconsistent
        // with any body.
        for seed in 0..10 {
            let found = identify_swings(&swung(tensor, 1.0, seed))
                .unwrap_or_else(|e| panic!("{direction:?} {seed}: {e}"));
            for (number, truth) in found.estimate.numbers[4..10].iter().zip(tensor) {
                let sd = number.sd.unwrap();
                assert!((number.value - truth).abs() < 5.0 * sd, "{direction:?} {seed}: {number:?} {truth}");
            }
        }
    }
}

#[test]
fn mistakes_show_as_far_as_is_said() {
    let tensor = [0.0132, 0.0178, 0.0241, 0.0011, -0.0007, 0.0013];
    let right = identify_swings(&swung(tensor, 0.0, 1)).unwrap();
    let of = |kind: &MistakeKind, test: Option<usize>| {
        right.mistakes.iter().find(|mistake| mistake.kind == *kind && mistake.test == test).unwrap().clone()
    };
    let chi = |found: &SwingEstimate| {
        let test = found.counted.as_ref().unwrap();
        (test.reduced_chi_square * test.degrees_of_freedom).sqrt()
    };
    assert!(chi(&right) < 1e-3);
    let mut hidden = 0;
    for k in 0..7 {
        let mut plan = swung(tensor, 0.0, 1);
        let Measurement::Counted(counted) = &mut plan.tests[k].measurement else { unreachable!() };
        // 21 swings counted as 20.
        counted.intervals[0].time *= 21.0 / 20.0;
        let said = of(&MistakeKind::Miscount, Some(k));
        let found = identify_swings(&plan).unwrap();
        assert!((chi(&found) / said.left - 1.0).abs() < 0.08, "{said:?} {}", chi(&found));
        assert_eq!(found.counted.as_ref().unwrap().is_too_large(), said.shows(), "{said:?}");
        hidden += usize::from(said.is_hidden());
        // The period of a spindle does not depend on the amplitude.
        let said = of(&MistakeKind::SideToSide, Some(k));
        assert!(!said.matters() && !said.shows(), "{said:?}");
    }
    assert_eq!(hidden, 0);
    // A fast clock shifts the estimate, as does a wrong stiffness.
    let said = of(&MistakeKind::Clock, None);
    assert!(said.matters(), "{said:?}");
    let mut plan = swung(tensor, 0.0, 1);
    for test in &mut plan.tests {
        let Measurement::Counted(counted) = &mut test.measurement else { unreachable!() };
        counted.intervals[0].time *= 1.01;
    }
    let found = identify_swings(&plan).unwrap();
    assert!((chi(&found) - said.left).abs() < 0.1 * said.left + 0.2, "{said:?} {}", chi(&found));
    // Without a seventh axis only the amplitudes are redundant: no miscount is detectable.
    let mut plan = swung(tensor, 0.0, 1);
    plan.tests.pop();
    let found = identify_swings(&plan).unwrap();
    let miscounts = found.mistakes.iter().filter(|mistake| mistake.kind == MistakeKind::Miscount);
    assert!(
        miscounts.clone().count() == 6 && miscounts.clone().all(Mistake::is_hidden),
        "{:?}",
        found.mistakes
    );
}
