//! Torques that begin and end: a step ends exactly at each change.

use crate::common::*;
use polhode::math::formula::{Binary, Formula, Instruction};
use polhode::motion::torque::{FormulaTorque, Schedule, Scheduled, Thruster};
use polhode::motion::{Ensemble, Member, Motor, StateVariables};
use polhode::prelude::*;

const METHODS: [Method; 2] = [Method::Taylor, Method::Dop853];
const MOMENTS: [f64; 3] = [1.1, 2.3, 3.1];
const TORQUE: f64 = 0.31;

/// Returns a scheduled torque about principal axis 3.
fn at_times(schedule: Schedule) -> TorqueModel {
    let torque = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, TORQUE)));
    TorqueModel::Scheduled(Box::new(Scheduled { torque, schedule }))
}

fn start(omega: [f64; 3]) -> State {
    let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    State { time: 0.0, attitude, omega: AngularVelocity::from_array(omega) }
}

fn steps(motion: &Trajectory) -> u64 {
    motion.solution().statistics().unwrap().accepted
}

/// Compares ω about the axis with N t_on/I, relative to the largest.
fn check(schedules: &[Schedule], omega0: f64, times: &[f64], bound: f64) -> [Trajectory; 2] {
    let torques: Vec<_> = schedules.iter().copied().map(at_times).collect();
    METHODS.map(|method| {
        let rotor = free_body(MOMENTS);
        let motion =
            Trajectory::compute(&rotor, &torques, start([0.0, 0.0, omega0]), times, method, 1e-13).unwrap();
        for sample in motion.samples() {
            let on: f64 = schedules.iter().map(|schedule| schedule.time_on(sample.state.time)).sum();
            let want = omega0 + TORQUE * on / MOMENTS[2];
            let error = (sample.state.omega.z - want).abs();
            let scale = want.abs().max(omega0.abs()).max(1e-3);
            assert!(error <= bound * scale, "{method:?} t = {}: {error:e} of {want}", sample.state.time);
            let impulse = (sample.impulse.norm() - TORQUE * on).abs();
            assert!(impulse <= bound * TORQUE * on + 1e-17, "{method:?}: {impulse:e}");
        }
        motion
    })
}

#[test]
fn windows_at_irrational_times_give_the_exact_spin() {
    let sqrt = f64::sqrt;
    let schedules = [
        Schedule::window(sqrt(2.0), sqrt(7.0)).unwrap(),
        Schedule::window(sqrt(5.0), 3.0 * sqrt(3.0)).unwrap(), // overlaps the first
        Schedule::window(-1.0, sqrt(0.5)).unwrap(),
        Schedule::window(sqrt(40.0), f64::INFINITY).unwrap(),
    ];
    let times: Vec<_> = (0..=90).map(|k| f64::from(k) * 0.1).collect();
    for omega0 in [0.0, 0.9, -2.0] {
        let motions = check(&schedules, omega0, &times, 1e-14);
        // Seven changes, and only a few steps between them.
        assert!(steps(&motions[0]) < 60, "{}", steps(&motions[0]));
    }
}

#[test]
fn switching_at_the_start_and_at_the_end_is_exact() {
    let end = 7.0_f64.sqrt();
    for (from, until, on) in
        [(0.0, end, end), (0.0, 1.0, 1.0), (1.0, end, end - 1.0), (end, 9.0, 0.0), (-3.0, 0.0, 0.0)]
    {
        let schedule = Schedule::window(from, until).unwrap();
        let motions = check(&[schedule], 0.4, &[0.0, end], 1e-15);
        for motion in motions {
            let gained = motion.samples()[1].state.omega.z - 0.4;
            assert!((gained - TORQUE * on / MOMENTS[2]).abs() < 1e-15, "{from} {until}: {gained}");
            // A sample contains the torque just after its time.
            let torque = |k: usize| motion.samples()[k].torque.z;
            assert_eq!(torque(0) == TORQUE, schedule.is_on(0.0));
            assert_eq!(torque(1) == TORQUE, schedule.is_on(end));
        }
    }
}

#[test]
fn thousands_of_pulses_add_up() {
    // Each change is rounded to a double. A pulse has an error of up to an ulp of its time, and
    // 5000 pulses √5000 times that in the mean.
    let (first, width, period) = (0.3_f64.sqrt(), 2.0e-3_f64.sqrt(), 7.0e-3_f64.sqrt());
    let train = Schedule::pulses(first, width, period, Some(5000)).unwrap();
    let end = 1.01 * (first + 5000.0 * period);
    let rounding = 70.0 * f64::EPSILON * end / (5000.0 * width);
    let motions = check(&[train], 0.0, &[end], 2.0 * rounding);
    for motion in motions {
        let gained = motion.samples()[0].state.omega.z;
        let want = TORQUE * 5000.0 * width / MOMENTS[2];
        assert!((gained / want - 1.0).abs() < 2.0 * rounding, "{gained} {want}");
        assert!(steps(&motion) >= 10_000);
    }
    // If the times are exact doubles, nothing is lost.
    let binary = Schedule::pulses(0.125, 1.0 / 1024.0, 1.0 / 256.0, Some(5000)).unwrap();
    for motion in check(&[binary], 0.0, &[30.0], 1e-14) {
        assert!((motion.samples()[0].impulse.norm() / (TORQUE * 5000.0 / 1024.0) - 1.0).abs() < 1e-14);
    }
}

#[test]
fn a_pulse_narrower_than_any_step_is_not_missed() {
    // The body is free otherwise, so that a step without the pulse would take seconds.
    let width = 1e-9;
    let schedule = Schedule::window(50.0, 50.0 + width).unwrap();
    let on = schedule.time_on(100.0);
    assert!((on / width - 1.0).abs() < 1e-5);
    for method in METHODS {
        let torque = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, 1e9)));
        let torques = [TorqueModel::Scheduled(Box::new(Scheduled { torque, schedule }))];
        let rotor = free_body(MOMENTS);
        let motion =
            Trajectory::compute(&rotor, &torques, start([0.0; 3]), &[49.0, 100.0], method, 1e-13).unwrap();
        assert_eq!(motion.samples()[0].state.omega.z, 0.0);
        let gained = motion.samples()[1].state.omega.z;
        assert!((gained / (1e9 * on / MOMENTS[2]) - 1.0).abs() < 1e-13, "{method:?}: {gained}");
    }
}

#[test]
fn a_generic_body_with_pulses_in_space_keeps_the_theorems() {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
    let rotor = Rotor::pivoted(&body, Position::new(-0.4, 0.9, 0.2));
    let scheduled = |torque, schedule| TorqueModel::Scheduled(Box::new(Scheduled { torque, schedule }));
    let thruster = Thruster { position: Position::new(0.7, 0.2, -0.4), force: Force::new(1.1, -0.6, 0.8) };
    let torques = [
        TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(1.1, -2.2, -8.7) }),
        scheduled(
            TorqueModel::Constant(ConstantTorque::Space(Torque::new(0.9, 0.4, -1.3))),
            Schedule::pulses(0.21, 0.13, 0.37, Some(9)).unwrap(),
        ),
        scheduled(TorqueModel::Thruster(thruster), Schedule::window(1.0, 2.0).unwrap()),
    ];
    let times: Vec<_> = (0..=50).map(|k| f64::from(k) * 0.1).collect();
    let start = start([0.9, -1.4, 2.1]);
    let [a, b] = METHODS.map(|method| {
        let motion = Trajectory::compute(&rotor, &torques, start, &times, method, 1e-15).unwrap();
        let drift = Drift::of(&motion).unwrap();
        assert!(drift.work_energy < 1e-13 && drift.momentum < 1e-13, "{method:?}: {drift:?}");
        assert_eq!(drift.total_energy, None);
        motion
    });
    for (a, b) in a.samples().iter().zip(b.samples()) {
        assert!((a.state.omega - b.state.omega).norm() < 1e-12, "t = {}", a.state.time);
        assert!(a.state.attitude.angle_to(b.state.attitude) < 1e-12);
    }
}

/// NASA JEOD, run 9A: a torque on the ISS from 1000 s to 2000 s, eight hours in total.
#[test]
fn the_iss_turns_as_in_jeod() {
    let case = table("iss_torque");
    let inertia = InertiaTensor::from_matrix(matrix(&case["inertia"])).unwrap();
    let body = MassProperties::new(number(&case["mass"]), Position::ZERO, inertia).unwrap();
    let rotor = Rotor::free(&body);
    let [from, until] = numbers(&case["window"]);
    let torque = TorqueModel::Constant(ConstantTorque::Body(Torque::from_array(numbers(&case["torque"]))));
    let schedule = Schedule::window(from, until).unwrap();
    let torques = [TorqueModel::Scheduled(Box::new(Scheduled { torque, schedule }))];
    let rows = cases(&case, "row");
    // The published matrix converts space to body.
    let attitude = |row: &toml::Table| {
        let to_body = Rotation::<Body, Space>::from_matrix(matrix(&row["matrix_body_space"])).unwrap();
        to_body.inverse()
    };
    let start = State { time: 0.0, attitude: attitude(rows[0]), omega: AngularVelocity::ZERO };
    let times: Vec<_> = rows.iter().map(|row| number(&row["t"])).collect();
    for method in METHODS {
        let motion = Trajectory::compute(&rotor, &torques, start, &times, method, 1e-14).unwrap();
        for (row, sample) in rows.iter().zip(motion.samples()) {
            let omega = AngularVelocity::from_array(numbers(&row["omega"]));
            let error = (sample.state.omega - omega).norm();
            let angle = sample.state.attitude.angle_to(attitude(row));
            let t = sample.state.time;
            assert!(error < number(&case["tolerance_omega"]), "{method:?} t = {t}: {error:e}");
            assert!(angle < number(&case["tolerance_attitude"]), "{method:?} t = {t}: {angle:e}");
        }
    }
}

#[test]
fn more_pulses_than_steps_are_refused_before_the_first() {
    let dense = Schedule::pulses(0.0, 1e-20, 2e-20, None).unwrap();
    let few = Schedule::pulses(0.0, 0.1, 0.3, None).unwrap();
    let wheel = |schedule| {
        let motor = Motor::Torque { inertia: 0.02, torque: 0.003, schedule: Some(schedule) };
        Wheel::new(Direction::new(0.0, 0.6, 0.8), 0.4, motor).unwrap()
    };
    let plain = free_body(MOMENTS);
    let wheeled = |schedule| plain.clone().with_wheels(&[wheel(schedule)]).unwrap();
    for (rotor, schedules, want) in [
        (plain.clone(), vec![few, dense], Some(Some(1))),
        (wheeled(dense), vec![few], Some(None)),
        (wheeled(few), vec![few], None),
    ] {
        let torques: Vec<_> = schedules.into_iter().map(at_times).collect();
        let (start, times) = (start([0.3, -0.2, 0.9]), [0.5, 3.0]);
        let simulation =
            |switched_off| Simulation::new(&rotor, &torques, start, &times).switched_off(switched_off);
        let found = |error: MotionError| match error {
            MotionError::TooManyPulses { torque, count, most: 100_000_000 } if count > 1e20 => torque,
            other => panic!("{other}"),
        };
        let all = simulation(&[]);
        assert_eq!(all.run().err().map(found), want);
        assert_eq!(all.states().err().map(found), want);
        // A torque that stays off has none.
        let off = if want == Some(Some(1)) { None } else { want };
        assert_eq!(simulation(&[1]).run().err().map(found), off);
        let member = Member::new(rotor.clone(), torques.clone(), start);
        let ensemble = Ensemble::new(vec![member.clone(), member]).unwrap();
        for method in [Method::Taylor, Method::Dop853] {
            let found_states = ensemble.at(&times, method, 1e-13, std::num::NonZero::<usize>::MIN).unwrap();
            assert_eq!(found_states.failures.len(), if want.is_some() { 2 } else { 0 });
            for failure in found_states.failures {
                assert_eq!(Some(found(failure.cause)), want);
            }
        }
    }
}

/// A formula torque that is zero when it begins, on a body at rest: neither ω nor the torque gives
/// a scale for the step.
#[test]
fn a_torque_that_rises_from_zero_moves_a_body_at_rest() {
    let time = StateVariables::NAMES.iter().position(|name| *name == "t").unwrap();
    // N = k (t − 1 s), from t = 1 s on, along all three axes
    let rising = |k: f64| {
        let [one, k] = [1.0, k].map(Instruction::Constant);
        let [minus, product] = [Binary::Subtract, Binary::Multiply].map(Instruction::Binary);
        Formula::new([Instruction::Variable(time), one, minus, k, product]).unwrap()
    };
    let rates = [0.3, -0.7, 0.4];
    let torque = TorqueModel::Formula(Box::new(FormulaTorque::Space(rates.map(rising))));
    let schedule = Schedule::window(1.0, f64::INFINITY).unwrap();
    let torque = TorqueModel::Scheduled(Box::new(Scheduled { torque, schedule }));
    let rotor = free_body(MOMENTS);
    let impulse = AngularMomentum::from_array(rates.map(|rate| 0.5 * rate * 4.0));
    let error = |state: &State| (rotor.angular_momentum_space(state) - impulse).norm();
    for method in METHODS {
        let torques = std::slice::from_ref(&torque);
        let motion =
            Trajectory::compute(&rotor, torques, start([0.0; 3]), &[0.0, 3.0], method, 1e-14).unwrap();
        let error = error(&motion.samples()[1].state);
        assert!(error < 1e-13, "{method:?}: {error:e}");
        assert!(steps(&motion) < 60, "{method:?}: {} steps", steps(&motion));
    }
    let member = || Member::new(rotor.clone(), vec![torque.clone()], start([0.0; 3]));
    let ensemble = Ensemble::new((0..9).map(|_| member()).collect()).unwrap();
    let ends = ensemble.at(&[3.0], Method::Taylor, 1e-14, std::num::NonZero::<usize>::MIN).unwrap();
    assert!(ends.failures.is_empty(), "{:?}", ends.failures);
    assert!(ends.states.iter().all(|end| error(end) < 1e-13));
}
