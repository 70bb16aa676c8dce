//! Bodies with changing mass properties, compared with closed forms, with
//! fixtures/mass_history.toml, and with a body that loses drops.

use crate::common::*;
use polhode::motion::torque::{ConstantTorque, Drag, DragLaw, EnergySink, Thruster};
use polhode::motion::{
    ErrorEffort, Event, EventAction, Exit, MassHistory, MassRates, MassRow, Measure, Outflow, Sense,
    Solution, Wheel,
};
use polhode::prelude::*;

const METHODS: [Method; 2] = [Method::Taylor, Method::Dop853];

fn row(time: f64, body: MassProperties<Body>) -> MassRow {
    MassRow { time, body, rates: None }
}

fn at(omega: [f64; 3]) -> State {
    let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    State { time: 0.0, attitude, omega: AngularVelocity::from_array(omega) }
}

fn run(simulation: Simulation<'_>) -> Trajectory {
    let motion = simulation.run().unwrap();
    let drift = Drift::of(&motion).unwrap();
    assert!(drift.work_energy < 2e-13 && drift.momentum < 2e-13, "{drift:?}");
    motion
}

fn optional<T>(case: &toml::Table, key: &str, read: impl Fn(&toml::Value) -> T) -> Option<T> {
    case.get(key).map(read)
}

fn history_of(case: &toml::Table) -> MassHistory {
    let rows: Vec<MassRow> = cases(case, "body")
        .into_iter()
        .map(|body| {
            let inertia = InertiaTensor::from_matrix(matrix(&body["inertia"])).unwrap();
            let center = Position::from_array(numbers(&body["center"]));
            let rates = optional(body, "mass_rate", |mass| MassRates {
                mass: number(mass),
                center_of_mass: Velocity::from_array(numbers(&body["center_rate"])),
                inertia: numbers(&body["inertia_rate"]),
            });
            let body_then = MassProperties::new(number(&body["mass"]), center, inertia).unwrap();
            MassRow { time: number(&body["t"]), body: body_then, rates }
        })
        .collect();
    let exit = |exit: &toml::Table| Exit {
        share: number(&exit["share"]),
        position: Position::from_array(numbers(&exit["place"])),
        axis: Direction::from_array(numbers(&exit["axis"])),
        radius: number(&exit["radius"]),
    };
    let outflow = if case.contains_key("in_place") {
        Outflow::InPlace
    } else if case.contains_key("exit") {
        Outflow::Exits(cases(case, "exit").into_iter().map(exit).collect())
    } else {
        Outflow::None
    };
    MassHistory::new(&rows, outflow).unwrap()
}

fn torques_of(case: &toml::Table) -> Vec<TorqueModel> {
    let mut torques = Vec::new();
    torques.extend(optional(case, "gravity", |g| {
        TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::from_array(numbers(g)) })
    }));
    torques.extend(optional(case, "torque", |n| {
        TorqueModel::Constant(ConstantTorque::Body(Torque::from_array(numbers(n))))
    }));
    torques.extend(optional(case, "force", |force| {
        let (position, force) = (Position::from_array(numbers(&case["place"])), numbers(force));
        TorqueModel::Thruster(Thruster { position, force: Force::from_array(force) })
    }));
    torques
}

#[test]
fn changing_bodies_follow_the_reference() {
    for case in cases(&table("mass_history"), "case") {
        let name = case["name"].as_str().unwrap();
        let (history, torques) = (history_of(case), torques_of(case));
        let pivot = optional(case, "pivot", |point| Position::from_array(numbers(point)));
        let rotor = history.rotor(0.0, pivot).unwrap();
        let rows = cases(case, "row");
        let times: Vec<f64> = rows.iter().map(|row| number(&row["t"])).collect();
        for method in METHODS {
            let simulation = Simulation::new(&rotor, &torques, start(case), &times);
            let motion = run(simulation.changing(Some(&history)).method(method).tolerance(1e-15));
            for (sample, row) in motion.samples().iter().zip(&rows) {
                let omega = AngularVelocity::from_array(numbers(&row["omega"]));
                let error = (sample.state.omega - omega).norm() / start(case).omega.norm();
                let angle = sample.state.attitude.angle_to(attitude(&row["attitude"]));
                let t = sample.state.time;
                assert!(error < 1e-13 && angle < 1e-13, "{name} {method:?} t = {t}: {error:e} {angle:e}");
            }
        }
    }
}

/// Thomson's jet damping: a body of revolution that burns uniformly about its centre, with a nozzle
/// on its axis.
#[test]
fn a_body_of_revolution_has_a_closed_form() {
    // I = I₀ − a t, J = J₀ − b t along the axis. Mass that leaves at distance l behind, through a
    // disc of radius r, carries away µ (l² + r²/4) Ω and µ r²/2 ω_z.
    let ([i0, j0], [a, b], mu, l, r) = ([2.3, 0.7], [0.11, 0.05], 0.13, 1.4, 0.35);
    let mass = |t: f64| 3.0 - mu * t;
    let body = |t: f64| {
        let inertia = InertiaTensor::diagonal([i0 - a * t, i0 - a * t, j0 - b * t]).unwrap();
        row(t, MassProperties::new(mass(t), Position::new(0.4, -0.2, 0.9), inertia).unwrap())
    };
    let position = Position::new(0.4, -0.2, 0.9 - l);
    let exit = Exit { share: 1.0, position, axis: Direction::new(0.0, 0.0, -2.0), radius: r };
    let history = MassHistory::new(&[body(0.0), body(9.0)], Outflow::Exits(vec![exit])).unwrap();
    let rotor = history.rotor(0.0, None).unwrap();
    let start = at([0.3, -0.4, 2.5]);
    let times = [0.5, 3.0, 9.0];
    for method in METHODS {
        let simulation = Simulation::new(&rotor, &[], start, &times).method(method).tolerance(1e-15);
        for sample in run(simulation.changing(Some(&history))).samples() {
            let t = sample.state.time;
            let [x, y, z] = sample.state.omega.to_array();
            let spin = |t: f64| 2.5 * ((j0 - b * t) / j0).powf(0.5 * mu * r * r / b - 1.0);
            let transverse = 0.5 * ((i0 - a * t) / i0).powf(mu * (l * l + 0.25 * r * r) / a - 1.0);
            assert!((z - spin(t)).abs() < 1e-13, "{z} {}", spin(t));
            assert!((x.hypot(y) - transverse).abs() < 1e-13, "{} {transverse}", x.hypot(y));
            // φ̇ = (J/I − 1) ω_z, by Simpson's rule
            let n = 2000;
            let rate = |t: f64| ((j0 - b * t) / (i0 - a * t) - 1.0) * spin(t);
            let h = t / f64::from(n);
            let weight = |k: i32| if k == 0 || k == n { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
            let turned: f64 = (0..=n).map(|k| weight(k) * rate(f64::from(k) * h)).sum::<f64>() * h / 3.0;
            let angle = (-0.4_f64).atan2(0.3) + turned;
            assert!((x - transverse * angle.cos()).abs() + (y - transverse * angle.sin()).abs() < 1e-12);
        }
    }
}

/// Each drop is moved to the exit inside the body at constant L, and released there at constant ω.
/// The equations of motion are the limit of this process.
#[test]
fn what_leaves_drop_by_drop_is_the_limit() {
    let hull = {
        let inertia =
            InertiaTensor::with_negative_products([0.31, 0.36, 0.14], [0.012, -0.02, 0.03]).unwrap();
        MassProperties::new(1.7, Position::new(0.02, -0.05, 0.31), inertia).unwrap()
    };
    let charge = |m: f64| {
        let inertia = InertiaTensor::with_negative_products(
            [0.021 * m, 0.034 * m, 0.028 * m],
            [0.002 * m, -0.001 * m, 0.003 * m],
        );
        MassProperties::new(m, Position::new(0.13, 0.08, -0.22), inertia.unwrap()).unwrap()
    };
    let place = Position::new(0.05, 0.2, -0.9);
    let drop = |m: f64| MassProperties::new(m, place, InertiaTensor::diagonal([0.0; 3]).unwrap()).unwrap();
    let (m0, m1, end) = (2.5, 1.0, 4.0);
    let joined = |parts: &[MassProperties<Body>]| MassProperties::combined(parts).unwrap();
    let exits =
        Outflow::Exits(vec![Exit { share: 1.0, position: place, axis: Direction::ZERO, radius: 0.0 }]);
    let ends = [row(0.0, joined(&[hull, charge(m0)])), row(end, joined(&[hull, charge(m1)]))];
    let history = MassHistory::new(&ends, exits).unwrap();
    let rotor = history.rotor(0.0, None).unwrap();
    let start = at([0.7, -1.1, 1.9]);
    let smooth = run(Simulation::new(&rotor, &[], start, &[end]).changing(Some(&history)));
    let by_drops = |n: u32| {
        let (h, mut state) = (end / f64::from(n), start);
        let mass = |k: f64| m0 + (m1 - m0) * k / f64::from(n);
        // A drop leaves in the middle of each time interval.
        for k in 0..n {
            let (before, after) = (mass(f64::from(k)), mass(f64::from(k) + 1.0));
            let whole = Rotor::free(&joined(&[hull, charge(before)]));
            let rest = Rotor::free(&joined(&[hull, charge(after)]));
            let filled = Rotor::free(&joined(&[hull, charge(after), drop(before - after)]));
            let free = |rotor: &Rotor, start: State, time: f64| {
                Trajectory::compute(rotor, &[], start, &[time], Method::Exact, 1e-13).unwrap().samples()[0]
                    .state
            };
            let time = f64::from(k) * h;
            state = free(&whole, State { time, ..state }, time + 0.5 * h);
            let momentum = whole.angular_momentum(state.omega);
            let [a, b, c] = filled.inertia().matrix();
            state.omega = solved([a, b, c], momentum.to_array());
            state = free(&rest, state, time + h);
        }
        state
    };
    let [coarse, fine] = [200, 400].map(|n| by_drops(n).omega - smooth.samples()[0].state.omega);
    // of first order, and zero after its extrapolation
    assert!(coarse.norm() < 3e-3 && fine.norm() > 1e-5, "{coarse:?} {fine:?}");
    assert!((fine * 2.0 - coarse).norm() < 2e-5, "{:?}", fine * 2.0 - coarse);
}

/// Solves by Cramer's rule.
fn solved(m: [[f64; 3]; 3], b: [f64; 3]) -> AngularVelocity<Body> {
    let v = |k: usize| Direction::<Body>::new(m[0][k], m[1][k], m[2][k]);
    let (x, y, z) = (v(0), v(1), v(2));
    let b = Direction::<Body>::from_array(b);
    let determinant = x.dot(y.cross(z));
    AngularVelocity::new(b.dot(y.cross(z)), x.dot(b.cross(z)), x.dot(y.cross(b))) / determinant
}

fn generic(mass: f64) -> MassProperties<Body> {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    MassProperties::new(mass, Position::new(0.11, -0.07, 0.23), inertia).unwrap()
}

#[test]
fn a_body_that_stays_as_it_is_moves_as_without_a_history() {
    let body = generic(2.3);
    let history = MassHistory::new(&[row(1.0, body), row(2.0, body)], Outflow::None).unwrap();
    let drag = Drag::new(DragLaw::Linear, [[0.1, 0.02, 0.0], [0.02, 0.2, 0.01], [0.0, 0.01, 0.3]]).unwrap();
    let torques = [
        TorqueModel::Gravity(UniformGravity::STANDARD),
        TorqueModel::Drag(drag),
        TorqueModel::Thruster(Thruster {
            position: Position::new(0.5, 0.1, -0.3),
            force: Force::new(0.2, 0.4, -0.1),
        }),
        TorqueModel::function("a push", |_, state| Torque::new(0.1 * state.time, 0.0, -0.2)),
    ];
    let times = [0.4, 1.7, 5.0];
    for pivot in [None, Some(Position::new(-0.4, 0.9, 0.2))] {
        // The function requires DOP853; without it Taylor's method is possible too.
        for (method, torques) in [(Method::Dop853, &torques[..]), (Method::Taylor, &torques[..3])] {
            let rotor = history.rotor(0.0, pivot).unwrap();
            let plain = Simulation::new(&rotor, torques, at([0.3, -0.5, 1.4]), &times).method(method);
            let (plain, changing) = (run(plain), run(plain.changing(Some(&history))));
            for (a, b) in plain.samples().iter().zip(changing.samples()) {
                let angle = a.state.attitude.angle_to(b.state.attitude);
                assert!(
                    angle < 1e-13 && (a.state.omega - b.state.omega).norm() < 1e-13,
                    "{pivot:?} {angle:e}"
                );
                assert!((a.work - b.work).abs() < 1e-12 && (a.impulse - b.impulse).norm() < 1e-12);
                assert!((a.torque - b.torque).norm() < 1e-12);
            }
        }
    }
}

#[test]
fn the_best_method_an_error_and_events_come_with_it() {
    let table = table("mass_history");
    let case = cases(&table, "case")[1];
    let (history, torques) = (history_of(case), torques_of(case));
    let rotor = history.rotor(0.0, None).unwrap();
    let last = cases(case, "row")[2];
    let fast = Event::new("fast", Measure::Rate, 3.0, Sense::Rising, EventAction::Record).unwrap();
    let (times, events) = ([8.0], [fast]);
    let simulation = Simulation::new(&rotor, &torques, start(case), &times)
        .changing(Some(&history))
        .events(&events)
        .tolerance(1e-9);
    for effort in [ErrorEffort::Cheap, ErrorEffort::Thorough] {
        let motion = simulation.run_with_error(effort, &mut |_| true).unwrap();
        assert!(matches!(motion.solution(), Solution::Taylor(_)));
        let angle = motion.samples()[0].state.attitude.angle_to(attitude(&last["attitude"]));
        let said = motion.error().unwrap().computation()[0].attitude;
        assert!(angle < 2.0 * said && said < 1e-6, "{angle:e} {said:e}");
        assert!(!motion.events().is_empty());
        for crossing in motion.events() {
            assert!((crossing.state.omega.norm() - 3.0).abs() < 1e-12);
        }
    }
    assert_eq!(simulation.states().unwrap()[0].time, 8.0);
}

/// Mass leaves from b: h = µ b × ρ, with ρ from the centre of mass, and b the mean position of the
/// lost mass relative to it.
#[test]
fn the_flow_that_is_left_out_is_known() {
    let dry = generic(2.0);
    let at = |m: f64| {
        MassProperties::new(m, Position::new(0.4, 0.3, -0.2), InertiaTensor::diagonal([0.1 * m; 3]).unwrap())
    };
    let whole = |m: f64| MassProperties::combined(&[dry, at(m).unwrap()]).unwrap();
    let position = Position::new(0.1, -0.2, -1.1);
    let exit = Exit { share: 1.0, position, axis: Direction::ZERO, radius: 0.0 };
    let rows = [row(0.0, whole(1.5)), row(5.0, whole(0.5))];
    let history = MassHistory::new(&rows, Outflow::Exits(vec![exit])).unwrap();
    let of_center = |center: Position<Body>| {
        let [b, r] = [Position::new(0.4, 0.3, -0.2) - center, position - center]
            .map(|v| Direction::<Body>::from_array(v.to_array()));
        0.2 * b.cross(r).norm()
    };
    let found = history.flow_momentum(0.0, None).unwrap();
    assert!((found - of_center(whole(1.5).center_of_mass())).abs() < 1e-14);
    let pivot = Position::new(0.3, 0.1, 0.5);
    assert!((history.flow_momentum(2.0, Some(pivot)).unwrap() - of_center(pivot)).abs() < 1e-14);
    assert_eq!(history.flow_momentum(5.0, None).unwrap(), 0.0);
    let said = |omega: f64| {
        let start = at_rate(omega);
        let scenario = Scenario::new(whole(1.5)).starting(start).unwrap().changing(history.clone()).unwrap();
        scenario.check().iter().any(|finding| finding.code == "mass_history.flow")
    };
    assert!(said(0.1) && !said(10.0));
}

fn at_rate(omega: f64) -> State {
    at([0.0, 0.6 * omega, 0.8 * omega])
}

#[test]
fn what_is_no_history_or_not_known_is_refused() {
    let whole = generic(2.3);
    let lighter = |mass: f64| MassProperties::new(mass, whole.center_of_mass(), *whole.inertia()).unwrap();
    let why = |rows: &[MassRow], outflow: Outflow| MassHistory::new(rows, outflow).unwrap_err().to_string();
    let exit =
        Exit { share: 1.0, position: Position::ZERO, axis: Direction::new(0.0, 0.0, 1.0), radius: 0.1 };
    let exits = |share: f64, radius: f64| Outflow::Exits(vec![Exit { share, radius, ..exit }]);
    let two = |a: MassRow, b: MassRow| vec![a, b];
    let rod =
        MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([0.0, 1.0, 1.0]).unwrap()).unwrap();
    let dive = MassRates { mass: -0.1, center_of_mass: Velocity::new(0.0, 0.0, 90.0), inertia: [0.0; 6] };
    let with_rates = |row: MassRow| MassRow { rates: Some(dive), ..row };
    for (rows, outflow, what) in [
        (vec![], Outflow::None, "has no rows"),
        (two(row(1.0, whole), row(0.5, whole)), Outflow::None, "at t = 0.5 s"),
        (vec![row(1.0, whole); 3], Outflow::None, "more than two rows"),
        (two(row(0.0, whole), row(1.0, rod)), Outflow::InPlace, "without inertia"),
        (two(row(0.0, whole), row(1.0, lighter(2.0))), Outflow::None, "loses mass, but its"),
        (two(row(0.0, lighter(2.0)), row(1.0, whole)), exits(1.0, 0.1), "gains mass"),
        (two(row(1.0, lighter(2.0)), row(1.0, whole)), exits(1.0, 0.1), "gains mass"),
        // A loss with this tensor would leave a body without inertia about its centre, but the
        // remainder is smaller.
        (two(row(0.0, whole), row(1.0, bulky())), Outflow::InPlace, "loses mass that is"),
        (two(row(1.0, whole), row(1.0, bulky())), Outflow::None, "loses mass that is"),
        (two(row(0.0, whole), row(f64::NAN, whole)), Outflow::None, "not finite"),
        (two(row(0.0, whole), row(1.0, lighter(2.0))), exits(0.5, 0.1), "shares"),
        (two(row(0.0, whole), row(1.0, lighter(2.0))), exits(1.0, -0.1), "radius"),
        (
            two(with_rates(row(0.0, whole)), with_rates(row(1.0, lighter(2.2)))),
            exits(1.0, 0.1),
            "has unphysical bodies",
        ),
    ] {
        let message = why(&rows, outflow);
        assert!(message.contains(what), "{message}");
    }

    let rows = [row(0.0, whole), row(4.0, lighter(1.3))];
    let history = MassHistory::new(&rows, exits(1.0, 0.1)).unwrap();
    let rotor = history.rotor(0.0, None).unwrap();
    let wheel = Wheel::new(Direction::new(1.0, 0.0, 0.0), 0.3, polhode::motion::Motor::HeldSpeed).unwrap();
    let with_wheel = rotor.clone().with_wheels(&[wheel]).unwrap();
    let other = Rotor::free(&lighter(2.0));
    let sink = [TorqueModel::EnergySink(EnergySink::new(0.1).unwrap())];
    let energy = [Event::new("e", Measure::KineticEnergy, 1.0, Sense::Either, EventAction::Record).unwrap()];
    let start = at([0.3, -0.5, 1.4]);
    let plain = Simulation::new(&rotor, &[], start, &[1.0]).changing(Some(&history));
    let splitting = Method::Splitting { order: polhode::motion::SplittingOrder::Six, step: 0.01 };
    assert!(plain.run().is_ok());
    for refused in [
        Simulation::new(&with_wheel, &[], start, &[1.0]).changing(Some(&history)),
        Simulation::new(&other, &[], start, &[1.0]).changing(Some(&history)),
        Simulation::new(&rotor, &sink, start, &[1.0]).changing(Some(&history)),
        plain.events(&energy),
        plain.method(splitting),
        plain.method(Method::Exact),
    ] {
        assert!(refused.run().is_err() && refused.states().is_err());
    }
    assert!(plain.run_with_derivatives(&[]).is_err());
}

/// Returns a body lighter than the generic one, but larger.
fn bulky() -> MassProperties<Body> {
    let inertia = InertiaTensor::with_negative_products([6.1, 7.2, 8.3], [0.4, -0.3, 0.2]).unwrap();
    MassProperties::new(2.0, Position::new(0.11, -0.07, 0.23), inertia).unwrap()
}
