//! Lagrange's top in closed form: references of 32 digits, the integrators, and the kinds of
//! motion.

use crate::common::{cases, number, numbers, table};
use polhode::motion::{ClosedForm, HeavyTop, TopPath};
use polhode::prelude::*;
use std::f64::consts::PI;

const DOWN: UniformGravity = UniformGravity { acceleration: Acceleration::new(0.0, 0.0, -9.81) };

/// Returns the top with A = 0.5234375, C = 0.21875 kg·m², M g l = 5.518125 N·m.
fn top() -> Rotor {
    let inertia = InertiaTensor::diagonal([0.3125, 0.3125, 0.21875]).unwrap();
    Rotor::pivoted(
        &MassProperties::new(1.5, Position::new(0.0, 0.0, 0.375), inertia).unwrap(),
        Position::ZERO,
    )
}

fn leaning(angle: f64, omega: [f64; 3]) -> State {
    let attitude = Attitude::from_euler313([0.4, angle, -0.7]).unwrap();
    State { time: 0.0, attitude, omega: AngularVelocity::from_array(omega) }
}

#[test]
fn thousand_nutations_have_the_digits_of_the_reference() {
    let table = table("heavy_tops");
    let mut worst = [0.0_f64; 2];
    let mut seen = 0;
    for case in cases(&table, "case") {
        let name = case["name"].as_str().unwrap();
        let inertia = case["inertia"].as_array().unwrap();
        let inertia = [0, 1, 2].map(|k| numbers::<3>(&inertia[k]));
        let arm = Position::from_array(numbers(&case["arm"]));
        let inertia = InertiaTensor::from_matrix(inertia).unwrap();
        let rotor = Rotor::pivoted(
            &MassProperties::new(number(&case["mass"]), arm, inertia).unwrap(),
            Position::ZERO,
        );
        let gravity = UniformGravity { acceleration: Acceleration::from_array(numbers(&case["gravity"])) };
        let attitude = Attitude::from_quaternion(numbers(&case["attitude0"])).unwrap();
        assert_eq!(attitude.quaternion(), numbers::<4>(&case["attitude0"]));
        let omega = AngularVelocity::from_array(numbers(&case["omega0"]));
        let motion = HeavyTop::of(&rotor, &gravity, State { time: 0.0, attitude, omega }).unwrap();
        for row in cases(case, "row") {
            let state = motion.at(number(&row["t"]));
            let want = Attitude::from_quaternion(numbers(&row["attitude"])).unwrap();
            let rates = AngularVelocity::from_array(numbers(&row["omega"]));
            let error = [
                state.attitude.angle_to(want),
                (state.omega - rates).norm() / rates.norm().max(omega.norm()),
            ];
            println!("{name} {:?}: {:.1e} {:.1e}", row["nutations"], error[0], error[1]);
            assert!(error[0] < 1e-15 && error[1] < 1e-15, "{name} {:?}: {error:?}", row["nutations"]);
            worst = [worst[0].max(error[0]), worst[1].max(error[1])];
            seen += 1;
        }
        let near = |what: &str, got: f64, want: f64| {
            assert!((got / want - 1.0).abs() < 1e-15, "{name}, {what}: {got} {want}");
        };
        near("period", motion.nutation_period().unwrap(), number(&case["nutation_period"]));
        near("1 - m", motion.parameter().unwrap()[1], number(&case["one_minus_m"]));
        if let (Some(precession), Some(spin)) = (case.get("precession"), case.get("spin")) {
            let scale = omega.norm();
            let got = [motion.mean_precession().unwrap(), motion.mean_spin().unwrap()];
            for (got, want) in got.iter().zip([number(precession), number(spin)]) {
                assert!((got - want).abs() < 1e-15 * scale, "{name}: {got} {want}");
            }
        }
        let [lowest, highest] = numbers::<2>(&case["cosines"]);
        let bounds = motion.nutation_bounds().map(f64::cos);
        // the cosine rounds the angle: by at most half an ulp of π
        assert!((bounds[0] - highest).abs() < 4.5e-16 && (bounds[1] - lowest).abs() < 4.5e-16, "{name}");
    }
    println!("{seen} rows; worst {worst:?}");
    assert!(seen > 130);
}

#[test]
fn far_away_it_is_where_it_should_be_or_nowhere() {
    // By `legendre` and `state` of fixtures/heavy_tops.py with 110 digits: about 10⁹, 10¹³ and
    // 2 · 10¹⁵ nutations.
    let inertia = InertiaTensor::diagonal([0.625, 0.09375, 0.625]).unwrap();
    let prolate = MassProperties::new(2.25, Position::new(0.0, -0.4375, 0.0), inertia).unwrap();
    let tops = [
        (
            top(),
            DOWN,
            [0.8212150138980858, 0.3182208178855082, -0.23609931649569965, 0.4106075069490429],
            [-0.6, 0.35, 31.5],
            [
                (
                    514873126.35308045,
                    [-0.06787013585851093, 0.6912985198758874, 31.5],
                    [0.15339078222932703, 0.3169027522211713, -0.23786555403124174, 0.9052424491632795],
                ),
                (
                    5148731263530.805,
                    [-0.4816920806209979, -0.49891909480834323, 31.5],
                    [0.9163265481427757, 0.37976563683222037, 0.11290979197551344, 0.05809558611641412],
                ),
                (
                    1029746252706160.9,
                    [0.7823754656921708, -0.4365126257437204, 31.5],
                    [0.4156878478328935, -0.3603525264080267, -0.18640206148733976, 0.8140048779636887],
                ),
            ],
        ),
        (
            Rotor::pivoted(&prolate, Position::ZERO),
            UniformGravity { acceleration: Acceleration::new(1.1, -2.2, -8.7) },
            [0.5157106231293968, -0.4125684985035174, 0.7219948723811553, 0.2062842492517587],
            [0.8, 21.5, -0.7],
            [
                (
                    1254959823.289051,
                    [1.0615542673222935, 21.5, -0.05570616001069399],
                    [0.4027358694143378, 0.24192170070103286, 0.8734419282495637, -0.1279722946292723],
                ),
                (
                    12549598232890.512,
                    [-1.0578539117415646, 21.5, -0.012112000884623886],
                    [0.8693799501168262, -0.1299150780886442, -0.37823874588276274, -0.2902344327145232],
                ),
                (
                    2509919646578102.0,
                    [1.8208128828994319, 21.5, -1.664706218182573],
                    [-0.6861975562530713, -0.3940360135850957, -0.5898637958751707, 0.1610255759375333],
                ),
            ],
        ),
    ];
    for (rotor, gravity, attitude, omega, rows) in tops {
        let attitude = Attitude::from_quaternion(attitude).unwrap();
        let start = State { time: 0.0, attitude, omega: AngularVelocity::from_array(omega) };
        let motion = HeavyTop::of(&rotor, &gravity, start).unwrap();
        for (time, omega, attitude) in rows {
            assert!(motion.reach() > time, "{:e}", motion.reach());
            let state = motion.at(time);
            let error = (state.omega - AngularVelocity::from_array(omega)).norm() / state.omega.norm();
            let turned = state.attitude.angle_to(Attitude::from_quaternion(attitude).unwrap());
            let law = 4e-15 + 1e-23 * time / motion.nutation_period().unwrap();
            assert!(error.max(turned) < law, "{time}: {error:e} {turned:e}");
        }
        for far in [1.01 * motion.reach(), -1e300, f64::INFINITY, f64::NAN] {
            let state = motion.at(far);
            assert!(state.omega.x.is_nan() && state.attitude.quaternion().iter().all(|c| c.is_nan()));
        }
        let torques = [TorqueModel::Gravity(gravity)];
        let closed = ClosedForm::of(&rotor, &torques, start).unwrap();
        let refused = closed.require(&[1.0, 1e30]);
        assert_eq!(refused, Err(MotionError::BeyondReach { time: 1e30, reach: motion.reach() }));
    }
}

#[test]
fn both_integrators_follow_every_kind_of_path() {
    let threshold = 2.0 * (5.518125_f64 * 0.5234375).sqrt() / 0.21875;
    let steady = |angle: f64, spin: f64, fast: bool| {
        let motion = HeavyTop::of(&top(), &DOWN, leaning(angle, [0.0, 0.0, spin])).unwrap();
        let rates = motion.steady_precession(angle, spin).unwrap();
        let rate = if fast { rates.fast.unwrap() } else { rates.slow };
        // ω of a steady precession: φ̇ along the vertical and ψ̇ along the axis, which is rotated
        // by ψ = −0.7
        let (s, c) = (-0.7_f64).sin_cos();
        leaning(angle, [rate * angle.sin() * s, rate * angle.sin() * c, spin])
    };
    let generic = leaning(0.9, [0.2, 0.3, 27.0]);
    let starts = [
        (leaning(0.7, [0.0, 0.0, 25.0]), TopPath::Cusps),
        (leaning(0.7, [0.9, 1.3, 25.0]), TopPath::Loops),
        (generic, TopPath::Waves),
        (steady(0.8, 25.0, false), TopPath::SteadySlow),
        (steady(0.8, 25.0, true), TopPath::SteadyFast),
        (steady(2.1, 12.0, false), TopPath::SteadySlow),
        (leaning(1e-3, [1e-3, 0.0, 1.1 * threshold]), TopPath::Loops),
        (leaning(1e-3, [1e-3, 0.0, 0.9 * threshold]), TopPath::Loops),
        (leaning(2.6, [0.8, 1.9, 0.0]), TopPath::Waves),
        (leaning(2.6, [0.8, 1.9, -4.0]), TopPath::Waves),
        (leaning(0.0, [0.7, -0.4, 9.0]), TopPath::ThroughVertical),
        (leaning(PI, [0.7, -1.4, 3.0]), TopPath::ThroughVertical),
    ];
    for (start, path) in starts {
        let exact = HeavyTop::of(&top(), &DOWN, start).unwrap();
        println!("{path:?} {:?} {:?}", exact.path(), exact.nutation_bounds());
        let times = [0.3, 1.7, 4.9];
        for method in [Method::Taylor, Method::Dop853] {
            let gravity = [TorqueModel::Gravity(DOWN)];
            let run = Trajectory::compute(&top(), &gravity, start, &times, method, 1e-14).unwrap();
            for sample in run.samples() {
                let state = exact.at(sample.state.time);
                let errors = [
                    state.attitude.angle_to(sample.state.attitude),
                    (state.omega - sample.state.omega).norm() / start.omega.norm(),
                ];
                println!("  {method:?} {}: {errors:?}", sample.state.time);
                // An upright top below the sleeping threshold multiplies errors by e^λt, here by
                // some thousands.
                assert!(errors.iter().all(|e| *e < 2e-11), "{path:?} {method:?}: {errors:?}");
            }
        }
        assert_eq!(exact.path(), path);
    }
}

#[test]
fn the_peers_problem_agrees_with_taylor_to_twelve_digits() {
    // I = (1, 1, ½) about the pivot, M g l = 1, inclined by 60° about x, ω = (0, 0, 5), for 100 s
    let inertia = InertiaTensor::diagonal([0.75, 0.75, 0.5]).unwrap();
    let body = MassProperties::new(1.0, Position::new(0.0, 0.0, 0.5), inertia).unwrap();
    let rotor = Rotor::pivoted(&body, Position::ZERO);
    let gravity = UniformGravity { acceleration: Acceleration::new(0.0, 0.0, -2.0) };
    let attitude = Attitude::from_quaternion([0.75_f64.sqrt(), 0.5, 0.0, 0.0]).unwrap();
    let start = State { time: 0.0, attitude, omega: AngularVelocity::new(0.0, 0.0, 5.0) };
    let exact = HeavyTop::of(&rotor, &gravity, start).unwrap();
    let run =
        Trajectory::compute(&rotor, &[TorqueModel::Gravity(gravity)], start, &[100.0], Method::Taylor, 1e-15)
            .unwrap();
    let error = exact.at(100.0).attitude.angle_to(run.samples()[0].state.attitude);
    println!("problem B: {error:e}");
    assert!(error < 1e-12, "{error:e}");
}

#[test]
fn the_benchmark_of_geradin_and_cardona() {
    let case = table("heavy_top");
    let inertia = InertiaTensor::from_matrix(crate::common::matrix(&case["inertia"])).unwrap();
    let arm = Position::from_array(numbers(&case["arm"]));
    let rotor =
        Rotor::pivoted(&MassProperties::new(number(&case["mass"]), arm, inertia).unwrap(), Position::ZERO);
    let gravity = UniformGravity { acceleration: Acceleration::from_array(numbers(&case["gravity"])) };
    let exact = HeavyTop::of(&rotor, &gravity, crate::common::start(&case)).unwrap();
    for row in cases(&case, "row") {
        let want = crate::common::attitude(&row["attitude"]);
        let got = exact.at(number(&row["t"])).attitude.continuous_with(want).quaternion();
        for (got, want) in got.iter().zip(numbers::<4>(&row["attitude"])) {
            assert!((got - want).abs() < number(&row["tolerance"]), "{got} {want}");
        }
    }
}

#[test]
fn vertical_tops_sleep_hang_and_fall() {
    let threshold = HeavyTop::of(&top(), &DOWN, leaning(0.3, [0.0; 3])).unwrap().sleeping_threshold();
    assert!((threshold - 2.0 * (5.518125_f64 * 0.5234375).sqrt() / 0.21875).abs() < 1e-14);
    for (angle, spin, path) in [
        (0.0, 1.01 * threshold, TopPath::Sleeping { stable: true }),
        (0.0, 0.99 * threshold, TopPath::Sleeping { stable: false }),
        (PI, 3.0, TopPath::Hanging),
    ] {
        let start = State {
            attitude: if angle == 0.0 {
                Attitude::identity()
            } else {
                Attitude::from_quaternion([0.0, 1.0, 0.0, 0.0]).unwrap()
            },
            ..leaning(0.0, [0.0, 0.0, spin])
        };
        let motion = HeavyTop::of(&top(), &DOWN, start).unwrap();
        assert_eq!(motion.path(), path);
        let state = motion.at(2.5);
        let turned = start.attitude
            * Rotation::<Body, Body>::from_axis_angle(Direction::new(0.0, 0.0, 1.0), 2.5 * spin).unwrap();
        assert!(state.attitude.angle_to(turned) < 1e-14 && state.omega == start.omega);
    }
    // Just below the sleeping-top threshold, a perturbed top nutates slightly; far below it falls.
    for (part, least, most) in [(1.01, 0.0, 0.01), (0.95, 0.1, 1.0), (0.5, 1.0, PI)] {
        let motion = HeavyTop::of(&top(), &DOWN, leaning(0.0, [1e-4, 0.0, part * threshold])).unwrap();
        let [_, lowest] = motion.nutation_bounds();
        assert!(lowest > least && lowest < most, "{part}: {lowest}");
    }
}

#[test]
fn a_tiny_push_falls_from_upright_as_the_linear_law_says() {
    // θ = (ω/κ) sinh κt for small angles, κ² = M g l/A without spin; 10⁻³⁰ rad/s keeps full
    // relative accuracy.
    let motion = HeavyTop::of(&top(), &DOWN, leaning(0.0, [1e-30, 0.0, 0.0])).unwrap();
    let kappa = (5.518125_f64 / 0.5234375).sqrt();
    for t in [0.1, 3.0, 15.0] {
        let state = motion.at(t);
        let leaning = state.attitude.matrix();
        let theta = leaning[0][2].hypot(leaning[1][2]);
        let want = 1e-30 / kappa * (kappa * t).sinh();
        assert!((theta / want - 1.0).abs() < 1e-12, "{t}: {theta:e} {want:e}");
    }
}

#[test]
fn a_body_that_is_no_such_top_is_refused_with_the_reason() {
    let refused = |inertia: [f64; 3], arm: [f64; 3], g: f64| {
        let inertia = InertiaTensor::diagonal(inertia).unwrap();
        let body = MassProperties::new(1.5, Position::from_array(arm), inertia).unwrap();
        let gravity = UniformGravity { acceleration: Acceleration::new(0.0, 0.0, -g) };
        let rotor = Rotor::pivoted(&body, Position::ZERO);
        HeavyTop::of(&rotor, &gravity, leaning(0.3, [0.1, 0.2, 3.0])).unwrap_err()
    };
    let why = |error| if let MotionError::NoClosedForm { why } = error { why } else { panic!("{error:?}") };
    assert!(why(refused([0.3, 0.31, 0.2], [0.0, 0.0, 0.4], 9.8)).contains("not symmetric"));
    assert!(why(refused([0.3, 0.3, 0.2], [0.0, 0.1, 0.4], 9.8)).contains("not symmetric"));
    assert!(why(refused([0.3, 0.3, 0.2], [0.0; 3], 9.8)).contains("at the pivot"));
    assert!(why(refused([0.3, 0.3, 0.2], [0.0, 0.0, 0.4], 0.0)).contains("gravity is zero"));
}

#[test]
fn a_body_swings_about_a_principal_axis_as_the_integrators_say() {
    // Three different moments; the axis, y, is level and perpendicular to the arm.
    let inertia = InertiaTensor::diagonal([0.3125, 0.4375, 0.21875]).unwrap();
    let body = MassProperties::new(1.5, Position::new(0.3, 0.0, 0.375), inertia).unwrap();
    let pivot = Position::new(0.3, 0.0, 0.0);
    let rotor = Rotor::pivoted(&body, pivot);
    let gravity = UniformGravity { acceleration: Acceleration::new(-3.1, 0.0, -8.7) };
    let attitude = Attitude::from_quaternion([0.9, 0.0, -0.4, 0.0]).unwrap();
    for rate in [0.0, 1.3, -9.5, 31.0] {
        let start = State { time: 0.4, attitude, omega: AngularVelocity::new(0.0, rate, 0.0) };
        let torques = [TorqueModel::Gravity(gravity)];
        let motion = ClosedForm::of(&rotor, &torques, start).unwrap();
        assert!(matches!(motion, ClosedForm::Swinging(_)));
        let times = [1.1, 2.9];
        let run = Trajectory::compute(&rotor, &torques, start, &times, Method::Taylor, 1e-15).unwrap();
        for sample in run.samples() {
            let state = motion.at(sample.state.time);
            let error = state.attitude.angle_to(sample.state.attitude);
            assert!(error < 1e-13, "{rate}: {error:e}");
            assert!((state.omega - sample.state.omega).norm() < 1e-12, "{rate}");
        }
    }
    let off_plane = State { time: 0.0, attitude, omega: AngularVelocity::new(0.1, 1.0, 0.0) };
    assert!(ClosedForm::of(&rotor, &[TorqueModel::Gravity(gravity)], off_plane).is_err());
}

/// Azimuth of the axis from one turning point to the next of the same kind: for tops that pass
/// through the vertical, up or down, and for one that does not.
#[test]
fn how_far_a_top_precesses_in_a_nutation_is_seen_at_its_turning_points() {
    let motion = |angle, omega| HeavyTop::of(&top(), &DOWN, leaning(angle, omega)).unwrap();
    let through = [
        motion(0.0, [1.9, -0.7, 11.0]),
        motion(0.0, [4.1, 2.2, -7.3]),
        motion(0.0, [0.2, 0.1, 5.0]),
        motion(PI, [3.1, 0.4, 6.0]),
        motion(PI, [0.5, -1.1, -4.0]),
        motion(PI, [2.0, 2.1, 0.3]),
        motion(PI, [-1.0, 0.4, 19.0]),
    ];
    for (top, passes) in
        through.iter().map(|top| (top, true)).chain([(&motion(0.7, [0.4, -0.9, 21.0]), false)])
    {
        assert_eq!(top.path() == TopPath::ThroughVertical, passes, "{:?}", top.path());
        let period = top.nutation_period().unwrap();
        let axis = |t: f64| (top.at(t).attitude * Direction::<Body>::new(0.0, 0.0, 1.0)).to_array();
        // The lowest point, or the highest for a top that passes through the bottom, by
        // golden-section search about the best of some samples.
        let down = if top.nutation_bounds()[1] > PI - 1e-6 { -1.0 } else { 1.0 };
        let height = |t: f64| down * axis(t)[2];
        let count = 400;
        let at = |k: i32| f64::from(k) * period / f64::from(count);
        let least = (0..count).min_by(|a, b| height(at(*a)).total_cmp(&height(at(*b)))).unwrap();
        let (mut from, mut to) = (at(least - 1), at(least + 1));
        for _ in 0..60 {
            let [a, b] = [0.382, 0.618].map(|part| from + part * (to - from));
            if height(a) < height(b) { to = b } else { from = a }
        }
        let azimuth = |t: f64| axis(t)[1].atan2(axis(t)[0]);
        let turned = azimuth(from + period) - azimuth(from);
        let got = top.precession_in_a_nutation().unwrap();
        let apart = (got - turned) / (2.0 * PI);
        assert!(
            (apart - apart.round()).abs() < 1e-6,
            "{got} {turned} {:?} {:?}",
            top.path(),
            top.nutation_bounds()
        );
        assert!(!passes || got.abs() <= PI);
        assert_eq!(top.mean_precession().is_none(), passes);
        assert_eq!(top.mean_spin().is_none(), passes);
    }
}
