//! Tumblers: observed periods, spins with given periods, phases, and final states of dissipation.

use crate::common::{number, numbers, table};
use core::f64::consts::{PI, TAU};
use polhode::motion::Regime;
use polhode::observe::{
    AxisConvention, GeometricPhase, LeastEnergySpin, TumblerError, TumblingPeriods, TumblingSolution,
};
use polhode::prelude::*;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

const CONVENTIONS: [AxisConvention; 2] = [AxisConvention::LongAxis, AxisConvention::ShortAxis];

fn motion(moments: [f64; 3], omega: [f64; 3]) -> FreeMotion {
    let attitude = Attitude::from_euler313([0.3, 1.1, -2.0]).unwrap();
    let start = State { time: 0.0, attitude, omega: AngularVelocity::from_array(omega) };
    FreeMotion::of_moments(moments, start).unwrap()
}

/// Returns generic motions of both modes, with ascending moments.
fn generic() -> Vec<FreeMotion> {
    let motions = vec![
        motion([1.0, 2.0, 2.7], [0.9, -0.3, 0.2]),
        motion([1.0, 2.0, 2.7], [-0.4, 0.5, 0.1]),
        motion([1.0, 2.0, 2.7], [0.2, 0.3, -0.9]),
        motion([1.0, 2.0, 2.7], [0.1, 1.0, 0.4]),
        motion([0.3, 2.0, 2.1], [4.0, 0.2, 0.2]),
        motion([0.3, 2.0, 2.1], [0.1, 0.6, 0.9]),
        motion([1.0, 3.0836, 3.235], [-98.709, 14.51, 33.529]),
        motion([0.9, 1.0, 1.1], [0.5, 0.1, -0.4]),
        motion([0.9, 1.0, 1.1], [-0.4, 0.1, 0.5]),
    ];
    let long = motions.iter().filter(|m| m.regime() == Regime::LongAxis).count();
    let short = motions.iter().filter(|m| m.regime() == Regime::ShortAxis).count();
    assert_eq!((long, short), (5, 4));
    motions
}

/// Returns the increase of the azimuth about L of a body-fixed axis until `end`, rad.
fn winding(motion: &FreeMotion, axis: Direction<Body>, end: f64, steps: u32) -> f64 {
    let pole: Direction<Space> = motion.momentum().direction().unwrap();
    let seed = if pole.x.abs() < 0.6 { Direction::new(1.0, 0.0, 0.0) } else { Direction::new(0.0, 1.0, 0.0) };
    let x: Direction<Space> = pole.cross(seed).direction().unwrap();
    let y = pole.cross(x);
    let azimuth = |time: f64| {
        let axis = motion.at(time).attitude * axis;
        axis.dot(y).atan2(axis.dot(x))
    };
    let mut last = azimuth(0.0);
    let mut turned = 0.0;
    for k in 1..=steps {
        let now = azimuth(end * f64::from(k) / f64::from(steps));
        let step = now - last;
        turned += step - TAU * (step / TAU).round();
        last = now;
    }
    turned
}

#[test]
fn the_precession_is_the_winding_of_the_axis_about_the_momentum() {
    let mut worst: f64 = 0.0;
    for motion in generic() {
        for (convention, axis) in [(AxisConvention::LongAxis, 0), (AxisConvention::ShortAxis, 2)] {
            let periods = TumblingPeriods::of(&motion, convention).unwrap();
            assert_eq!(Some(periods.rotation), motion.period());
            let end = 40.0 * periods.rotation;
            let turned = winding(&motion, motion.principal().axis(axis), end, 8000);
            let error = turned * periods.precession / (TAU * end) - 1.0;
            worst = worst.max(error.abs());
            assert!(error.abs() < 2e-14, "{:?} {convention:?}: {error:e}", motion.regime());
            assert!(
                (periods.ratio() - periods.rotation / periods.precession).abs() < 1e-15 * periods.ratio()
            );
        }
        // the intermediate axis follows the convention of the axis that L does not circle
        let circled =
            if motion.circles_least() { AxisConvention::ShortAxis } else { AxisConvention::LongAxis };
        let periods = TumblingPeriods::of(&motion, circled).unwrap();
        let turned = winding(&motion, motion.principal().axis(1), 10.0 * periods.rotation, 4000);
        assert!((turned / (TAU * 10.0 * periods.ratio()) - 1.0).abs() < 1e-13);
    }
    println!("worst winding {worst:.1e}");
}

/// Returns ψ, the angle of the body about one of its axes from the plane of that axis and L,
/// continued through one period of ω.
fn turns_about(motion: &FreeMotion, axis: usize) -> f64 {
    let frame = motion.principal();
    let [a, b] = [(axis + 1) % 3, (axis + 2) % 3].map(|k| frame.axis(k));
    let (period, steps) = (motion.period().unwrap(), 2000);
    let angle = |k: i32| {
        let l = motion.angular_momentum(&motion.at(period * f64::from(k) / f64::from(steps)));
        a.dot(l).atan2(b.dot(l))
    };
    let step = |k: i32| {
        let step = angle(k + 1) - angle(k);
        step - TAU * (step / TAU).round()
    };
    (0..steps).map(step).sum::<f64>() / TAU
}

#[test]
fn the_body_rotates_about_the_axis_that_the_momentum_circles_and_oscillates_about_the_other() {
    for motion in generic() {
        let (circled, other) = if motion.circles_least() { (0, 2) } else { (2, 0) };
        assert!((turns_about(&motion, circled).abs() - 1.0).abs() < 1e-12);
        assert!(turns_about(&motion, other).abs() < 1e-12);
    }
}

#[test]
fn a_symmetric_body_has_periods_in_both_conventions() {
    for (moments, omega, circled) in [
        ([1.0, 1.0, 1.8], [0.3, 0.1, 0.9], AxisConvention::ShortAxis),
        ([1.0, 2.0, 2.0], [0.9, 0.1, 0.4], AxisConvention::LongAxis),
    ] {
        let motion = motion(moments, omega);
        assert_eq!(motion.regime(), Regime::Symmetric);
        for convention in CONVENTIONS {
            let periods = TumblingPeriods::of(&motion, convention).unwrap();
            // the middle axis is always normal to the symmetry axis
            let symmetry = if circled == AxisConvention::ShortAxis { 2 } else { 0 };
            let axis = motion.principal().axis(if convention == circled { symmetry } else { 1 });
            let turned = winding(&motion, axis, 20.0 * periods.rotation, 4000);
            assert!((turned / (TAU * 20.0 * periods.ratio()) - 1.0).abs() < 1e-13);
        }
        // L/i with the transverse moment
        let periods = TumblingPeriods::of(&motion, circled).unwrap();
        let rate = motion.momentum().norm() / moments[1];
        assert!((periods.precession * rate / TAU - 1.0).abs() < 1e-15);
    }
}

#[test]
fn what_does_not_circle_has_no_tumbling_periods() {
    for (moments, omega) in [
        ([1.0, 2.0, 3.0], [0.0; 3]),
        ([1.0, 2.0, 3.0], [0.0, 0.0, 1.0]),
        ([1.0, 2.0, 3.0], [0.0, 1.0, 0.0]),
        ([1.0, 1.0, 1.0], [0.3, 0.2, 1.0]),
        ([1.0, 1.0, 2.0], [0.3, 0.2, 0.0]),
        ([0.0, 2.0, 2.0], [0.0, 0.2, 0.1]),
    ] {
        let motion = motion(moments, omega);
        for convention in CONVENTIONS {
            assert!(TumblingPeriods::of(&motion, convention).is_none(), "{moments:?} {omega:?}");
        }
        assert!(GeometricPhase::of(&motion).is_none());
    }
    // moments whose separatrix is at simple numbers: i1 (i2 − i1) = i3 (i3 − i2) = 6
    let separatrix = motion([2.0, 5.0, 6.0], [1.0, 0.5, 1.0]);
    assert_eq!(separatrix.regime(), Regime::Separatrix);
    assert!(TumblingPeriods::of(&separatrix, AxisConvention::LongAxis).is_none());
    assert!(GeometricPhase::of(&separatrix).is_none());
}

#[test]
fn toutatis_has_its_published_periods() {
    let fixture = table("tumblers");
    let toutatis = fixture["toutatis"].as_table().unwrap();
    let moments = numbers(&toutatis["moments"]);
    let omega = numbers::<3>(&toutatis["omega_deg_per_day"]).map(f64::to_radians);
    let motion = motion(moments, omega); // in days
    assert_eq!(motion.regime(), Regime::LongAxis);
    let periods = TumblingPeriods::of(&motion, AxisConvention::LongAxis).unwrap();
    let values = |key: &str| [number(&toutatis[key]["p_phi_days"]), number(&toutatis[key]["p_psi_days"])];
    let found = [periods.precession, periods.rotation];
    for (x, truth) in found.into_iter().zip(values("computed")) {
        assert!((x / truth - 1.0).abs() <= number(&toutatis["computed"]["tolerance"]), "{x}");
    }
    for key in ["zhao_2015", "hudson_ostro_1995"] {
        for (x, printed) in found.into_iter().zip(values(key)) {
            assert!((x - printed).abs() < number(&toutatis[key]["tolerance_days"]), "{key}: {x} {printed}");
        }
        // inverse: the printed periods have one spin, close to the one fitted to other data
        let [precession, rotation] = values(key);
        let printed = TumblingPeriods { precession, rotation };
        let spins = TumblingSolution::all(moments, printed, AxisConvention::LongAxis).unwrap();
        let [spin] = spins[..] else { panic!("{spins:?}") };
        assert_eq!(spin.regime, Regime::LongAxis);
        let truth = LeastEnergySpin::of(&motion).unwrap().energy_ratio;
        assert!((spin.energy_ratio / truth - 1.0).abs() < 0.02, "{} {truth}", spin.energy_ratio);
        assert!((spin.momentum / motion.momentum().norm() - 1.0).abs() < 0.01);
    }
}

/// Generates physical moments in any order and a spin: bricks, and approximate slabs and needles.
fn tumbler() -> impl Strategy<Value = ([f64; 3], [f64; 3])> {
    (prop::array::uniform3(0.02..1.0_f64), prop::array::uniform3(-1.0..1.0_f64))
        .prop_map(|([a, b, c], omega)| ([b + c, a + c, a + b], omega))
        .prop_filter("generic", |([x, y, z], omega)| {
            let apart = (x - y).abs().min((y - z).abs()).min((z - x).abs());
            apart > 1e-4 && omega.iter().any(|w| w.abs() > 0.01)
        })
}

fn scale() -> impl Strategy<Value = f64> {
    prop_oneof![4 => 1e-3..1e3_f64, 1 => Just(1e-140), 1 => Just(1e140)]
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 1000, failure_persistence: None, rng_seed: RngSeed::Fixed(11), ..ProptestConfig::default()
    })]

    #[test]
    fn every_spin_is_found_from_its_periods((moments, omega) in tumbler(), scale in scale()) {
        let motion = motion(moments.map(|i| i * scale), omega);
        let truth = LeastEnergySpin::of(&motion).unwrap().energy_ratio;
        for convention in CONVENTIONS {
            let periods = TumblingPeriods::of(&motion, convention).unwrap();
            let spins = TumblingSolution::all(moments.map(|i| i * scale), periods, convention).unwrap();
            prop_assert!(spins.len() <= 2 && spins.is_sorted_by(|a, b| a.energy_ratio < b.energy_ratio));
            let same: Vec<_> = spins.iter().filter(|s| s.regime == motion.regime()).collect();
            prop_assert_eq!(same.len(), 1);
            prop_assert!((same[0].energy_ratio / truth - 1.0).abs() < 1e-13, "{:e}", same[0].energy_ratio / truth - 1.0);
            prop_assert!((same[0].momentum / motion.momentum().norm() - 1.0).abs() < 1e-12);
            for spin in spins {
                let again = self::motion(moments.map(|i| i * scale), spin.omega.to_array());
                prop_assert_eq!(again.regime(), spin.regime);
                // rounding of ω limits the accuracy of 1 − m to about ε/(1 − m)
                let held = 1e-13 + 1e-14 / again.parameter()[1];
                let achieved = spin.periods.unwrap();
                prop_assert!((achieved.precession / periods.precession - 1.0).abs() < held);
                prop_assert!((achieved.rotation / periods.rotation - 1.0).abs() < held);
                let energy = LeastEnergySpin::of(&again).unwrap().energy_ratio;
                prop_assert!((energy / spin.energy_ratio - 1.0).abs() < 1e-13);
                prop_assert!((again.momentum().norm() / spin.momentum - 1.0).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn the_phase_is_the_turn_about_the_momentum((moments, omega) in tumbler()) {
        let motion = motion(moments, omega);
        let phase = GeometricPhase::of(&motion).unwrap();
        let parts = phase.dynamic + phase.geometric;
        prop_assert!((parts / phase.total - 1.0).abs() < 1e-13, "{:e}", parts / phase.total - 1.0);
        let sign = phase.geometric * if motion.circles_least() { 1.0 } else { -1.0 };
        prop_assert!((0.0..TAU).contains(&sign) && phase.total > 0.0);
        let axis: Direction<Space> = motion.momentum().direction().unwrap();
        let turned = Rotation::<Space, Space>::from_axis_angle(axis, phase.total).unwrap() * motion.start().attitude;
        let after = motion.at(motion.period().unwrap()).attitude;
        // near the separatrix, rounding of the period changes the phase
        let held = 1e-14 * (1.0 + phase.total);
        prop_assert!(after.angle_to(turned) < held, "{:e}", after.angle_to(turned));
    }
}

#[test]
fn two_modes_may_share_their_periods() {
    // slab-like: 1/√((i3/i1 − 1)(i3/i2 − 1)) is slightly above 1, so a long-axis mode near the
    // separatrix has the same ratio
    let moments = [1.0, 1.6, 2.5];
    let periods = TumblingPeriods { precession: 3600.0, rotation: 7200.0 };
    let spins = TumblingSolution::all(moments, periods, AxisConvention::LongAxis).unwrap();
    assert_eq!(spins.iter().map(|s| s.regime).collect::<Vec<_>>(), [Regime::ShortAxis, Regime::LongAxis]);
    for spin in spins {
        let achieved = spin.periods.unwrap();
        assert!((achieved.precession / 3600.0 - 1.0).abs() < 1e-13, "{spin:?}");
        assert!((achieved.rotation / 7200.0 - 1.0).abs() < 1e-13, "{spin:?}");
        assert_eq!(spin.omega.y, 0.0);
    }
}

#[test]
fn a_symmetric_spin_is_found_from_its_periods() {
    for (moments, omega) in [([1.0, 1.0, 1.8], [0.3, 0.1, 0.9]), ([2.0, 1.0, 2.0], [0.1, 0.8, 0.4])] {
        let motion = motion(moments, omega);
        let truth = LeastEnergySpin::of(&motion).unwrap().energy_ratio;
        for convention in CONVENTIONS {
            let periods = TumblingPeriods::of(&motion, convention).unwrap();
            let spins = TumblingSolution::all(moments, periods, convention).unwrap();
            assert_eq!(spins.len(), 1);
            assert_eq!(spins[0].regime, Regime::Symmetric);
            assert!((spins[0].energy_ratio / truth - 1.0).abs() < 1e-14);
            let achieved = spins[0].periods.unwrap();
            assert!((achieved.precession / periods.precession - 1.0).abs() < 1e-14);
            assert!((achieved.rotation / periods.rotation - 1.0).abs() < 1e-14);
        }
    }
}

#[test]
fn a_spin_on_the_verge_of_the_separatrix_is_found() {
    // a period so long that 1 − m is far below the rounding of a double: the energy is still
    // correct, ω is not
    let moments = [1.0, 2.0, 2.7];
    let periods = TumblingPeriods { precession: 1.0, rotation: 60.0 };
    for convention in CONVENTIONS {
        let spins = TumblingSolution::all(moments, periods, convention).unwrap();
        assert_eq!(spins.len(), 2);
        for spin in spins {
            assert!((spin.energy_ratio / (2.7 / 2.0) - 1.0).abs() < 1e-14);
            // the motion is nearly always along the intermediate axis, with ω = L/i2
            assert!((spin.momentum / (2.0 * TAU) - 1.0).abs() < 0.05);
        }
    }
}

#[test]
fn impossible_questions_say_what_is_possible() {
    let all = |moments, precession, rotation| {
        let periods = TumblingPeriods { precession, rotation };
        TumblingSolution::all(moments, periods, AxisConvention::LongAxis)
    };
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(all([1.0, 2.0, 2.5], bad, 1.0), Err(TumblerError::Period { what: "P_phi", .. })));
        assert!(matches!(all([1.0, 2.0, 2.5], 1.0, bad), Err(TumblerError::Period { what: "P_psi", .. })));
    }
    assert!(matches!(all([1.0, 2.0, 3.5], 1.0, 1.0), Err(TumblerError::Body(_))));
    let error = all([1.0, 2.0, 2.5], 1.0, 0.2).unwrap_err();
    let TumblerError::NoSolution { ratio, long_axis: Some([long, _]), short_axis: Some([short, most]) } =
        error
    else {
        panic!("{error:?}")
    };
    assert_eq!(ratio, 0.2);
    assert!((long - (1.0 / (0.5 * 0.6_f64).sqrt() - 1.0)).abs() < 1e-15);
    assert!((short - 1.0 / (1.5 * 0.25_f64).sqrt()).abs() < 1e-15 && most > 100.0);
    assert!(error.to_string().contains("long-axis mode has more than 0.825742, at most"), "{error}");
    for moments in [[1.0; 3], [0.0, 1.0, 1.0]] {
        let error = all(moments, 1.0, 1.0).unwrap_err();
        assert!(matches!(error, TumblerError::NoSolution { long_axis: None, short_axis: None, .. }));
        assert!(
            error.to_string().ends_with("it has no long-axis mode; it has no short-axis mode"),
            "{error}"
        );
    }
    assert!(matches!(all([1.0, 1.0, 1.5], 1.0, 0.2), Err(TumblerError::NoSolution { long_axis: None, .. })));
}

/// Computes S = ∮ (1 − cos θ) dφ about the axis that L circles, by the trapezoidal rule in time.
fn solid_angle(motion: &FreeMotion) -> f64 {
    let frame = motion.principal();
    let (steps, period) = (4000, motion.period().unwrap());
    let circled = frame.axis(if motion.circles_least() { 0 } else { 2 });
    let side = circled.dot(motion.angular_momentum(&motion.start())).signum();
    let along = circled * side;
    let rate = |k: u32| {
        let state = motion.at(period * f64::from(k) / f64::from(steps));
        let l: Direction<Body> = motion.angular_momentum(&state).direction().unwrap();
        let change = l.cross(Direction::from_array(state.omega.to_array())); // dL/dt in the body is L × ω
        let cosine = along.dot(l);
        (1.0 - cosine) * along.dot(l.cross(change)) / (1.0 - cosine * cosine)
    };
    (0..steps).map(rate).sum::<f64>() * period / f64::from(steps)
}

#[test]
fn the_geometric_part_is_the_solid_angle_of_the_momentums_path() {
    let mut worst: f64 = 0.0;
    for motion in generic() {
        let phase = GeometricPhase::of(&motion).unwrap();
        let signed = solid_angle(&motion);
        assert_eq!(signed > 0.0, !motion.circles_least());
        worst = worst.max((phase.geometric + signed).abs());
        assert!((phase.geometric + signed).abs() < 1e-13, "{} {signed}", phase.geometric);
        // the azimuth gained in one period by an axis that L does not circle
        let other = motion.principal().axis(if motion.circles_least() { 2 } else { 0 });
        let wound = winding(&motion, other, motion.period().unwrap(), 1000);
        assert!((wound - phase.total).abs() < 1e-13 * (1.0 + phase.total), "{wound} {}", phase.total);
    }
    println!("worst solid angle {worst:.1e}");
}

#[test]
fn the_phase_of_a_symmetric_top_is_a_cap() {
    for (moments, omega) in [([1.0, 1.0, 1.8], [0.3, 0.1, 0.9]), ([1.0, 2.0, 2.0], [0.9, 0.1, 0.4])] {
        let motion = motion(moments, omega);
        let phase = GeometricPhase::of(&motion).unwrap();
        let sign = if motion.circles_least() { 1.0 } else { -1.0 };
        let [nutation, _] = motion.nutation_range();
        assert!((phase.geometric - sign * TAU * (1.0 - nutation.cos())).abs() < 1e-14);
        assert!((phase.dynamic + phase.geometric - phase.total).abs() < 1e-14 * phase.total);
    }
    // a rod with a formal spin: half of the sphere
    let rod = motion([0.0, 2.0, 2.0], [1.0, 0.2, 0.1]);
    assert!((GeometricPhase::of(&rod).unwrap().geometric - TAU).abs() < 1e-14);
}

#[test]
fn the_smallest_wobble_has_a_phase_with_digits() {
    let (moments, tilt) = ([1.0, 1.6, 2.5], 1e-9);
    let motion = motion(moments, [tilt * 2.5 / 1.0, 0.0, 1.0]);
    let phase = GeometricPhase::of(&motion).unwrap();
    // an ellipse of semi-axes θ and θ √(δ1/δ2)
    let area = PI * tilt * tilt * (1.5 / 1.0 / (0.9_f64 / 1.6)).sqrt();
    assert!((phase.geometric / -area - 1.0).abs() < 1e-14, "{:e}", phase.geometric / -area - 1.0);
    assert!((phase.total / motion.period().unwrap() - 1.0).abs() < 1e-14);
}

#[test]
fn dissipation_ends_about_the_axis_of_greatest_moment() {
    for motion in generic() {
        let end = LeastEnergySpin::of(&motion).unwrap();
        let moments = motion.principal().moments();
        assert!(end.axis.dot(motion.principal().axis(2)) == 1.0);
        assert!((end.rate * moments[2] / motion.momentum().norm() - 1.0).abs() < 1e-15);
        let sum = (end.kinetic_energy + end.energy_lost) / motion.kinetic_energy();
        assert!((sum - 1.0).abs() < 1e-15, "{sum}");
        assert!((end.energy_ratio * end.kinetic_energy / motion.kinetic_energy() - 1.0).abs() < 1e-15);
        assert!(end.energy_ratio <= moments[2] / moments[0]);
        assert_eq!(end.energy_ratio > moments[2] / moments[1], motion.circles_least());
    }
    // remaining energy loss near the end: ½ i1 (i3 − i1)/i3 ω1² = 0.6 ω1² / 2
    let end = LeastEnergySpin::of(&motion([1.0, 2.0, 2.5], [1e-20, 0.0, 3.0])).unwrap();
    assert!((end.energy_lost / 0.3e-40 - 1.0).abs() < 1e-15, "{:e}", end.energy_lost);
    // permanent rotations and bodies with equal moments
    for (moments, omega, ratio) in [
        ([1.0, 2.0, 2.5], [1.0, 0.0, 0.0], 2.5),
        ([2.0, 1.0, 2.5], [1.0, 0.0, 0.0], 1.25),
        ([1.0, 2.0, 2.5], [0.0, 0.0, -4.0], 1.0),
        ([1.0, 1.0, 1.0], [0.2, 0.1, 0.3], 1.0),
        ([1.0, 2.0, 2.0], [0.0, 0.1, 0.3], 1.0),
        ([0.0, 2.0, 2.0], [7.0, 0.1, 0.3], 1.0),
        ([0.0, 2.0, 2.0], [0.0, 0.1, 0.3], 1.0),
    ] {
        let end = LeastEnergySpin::of(&motion(moments, omega)).unwrap();
        assert!((end.energy_ratio - ratio).abs() < 1e-15, "{moments:?} {omega:?} {}", end.energy_ratio);
    }
    assert!(LeastEnergySpin::of(&motion([1.0, 2.0, 2.5], [0.0; 3])).is_none());
}
