//! Every torque on a body that burns and drops a part, free and held, compared with an independent
//! integration.

mod reference;

use polhode::math::VectorAlgebra;
use polhode::math::formula::{Binary, Formula, Instruction};
use polhode::motion::torque::{
    Attracted, ConstantTorque, Drag, DragLaw, FormulaTorque, GravityGradient, Interpolation, Law, LawInput,
    Magnetic, MagneticField, Schedule, Scheduled, Tabulated, Thruster, TimePolynomial, TorqueAxes, Torsion,
};
use polhode::motion::{
    Exit, MassHistory, MassRow, MethodReason, MotionError, Orbit, Outflow, StateVariables,
};
use polhode::prelude::*;

use reference::{DROP, END, EXITS, M, Motion, Now, V, body, cross, dot, plus, times, transposed};

const OMEGA: V = [0.7, -1.1, 1.9];
const ATTITUDE: [f64; 4] = [0.4, -0.7, 1.1, 0.3];
const PIVOT: V = [-0.1, 0.05, -0.6];
const MU: f64 = 2.3;
const ECCENTRIC: [V; 2] = [[1.4, -1.2, 0.3], [0.5, 0.8, -0.4]];

fn history() -> MassHistory {
    let row = |time: f64, with_booster: bool| {
        let (mass, center, tensor) = body(time, with_booster);
        let inertia = InertiaTensor::from_matrix(tensor).unwrap();
        let body = MassProperties::new(mass, Position::from_array(center), inertia).unwrap();
        MassRow { time, body, rates: None }
    };
    let exit = |(share, place, axis, radius)| Exit {
        share,
        position: Position::from_array(place),
        axis: Direction::from_array(axis),
        radius,
    };
    let rows = [row(0.0, true), row(DROP, true), row(DROP, false), row(END, false)];
    MassHistory::new(&rows, Outflow::Exits(EXITS.map(exit).to_vec())).unwrap()
}

/// A torque, the same torque written with arrays, and the times of its corners.
struct Case {
    name: &'static str,
    model: TorqueModel,
    law: Box<reference::Law>,
    orbit: [V; 2],
    corners: Vec<f64>,
}

fn case(name: &'static str, model: TorqueModel, law: impl Fn(&Now) -> V + 'static) -> Case {
    Case { name, model, law: Box::new(law), orbit: ECCENTRIC, corners: Vec::new() }
}

fn in_body(now: &Now, v: V) -> V {
    times(transposed(now.attitude), v)
}

fn eccentric() -> Orbit {
    let [r, v] = ECCENTRIC;
    Orbit::through(MU, Position::from_array(r), Velocity::from_array(v), 0.0).unwrap()
}

fn gravity_gradient(now: &Now) -> V {
    let r = in_body(now, now.r);
    cross(r, times(now.tensor, r)).map(|x| 3.0 * MU / dot(r, r).powf(2.5) * x)
}

/// Returns (w, v), w ≥ 0, of the rotation from rest.
fn turn([a, b, c, d]: [f64; 4], [w, x, y, z]: [f64; 4]) -> (f64, V) {
    let scalar = a * w + b * x + c * y + d * z;
    let vector =
        [a * x - b * w - c * z + d * y, a * y - c * w - d * x + b * z, a * z - d * w - b * y + c * x];
    let sign = if scalar < 0.0 { -1.0 } else { 1.0 };
    (sign * scalar, vector.map(|x| sign * x))
}

fn of_orbits() -> Vec<Case> {
    let circle =
        Orbit::circular(MU, 1.7, Direction::new(0.3, 0.5, -0.8), Direction::new(0.9, -0.4, 0.2)).unwrap();
    let start = [circle.position(0.0).to_array(), circle.velocity(0.0).to_array()];
    let gradient = |orbit| {
        TorqueModel::GravityGradient(Box::new(GravityGradient { orbit, attracted: Attracted::Tensor }))
    };
    let (moment, dipole) = ([0.3, -0.2, 0.5], [1e6, -2e6, 1.5e6]);
    let field = MagneticField::Dipole { dipole: Direction::from_array(dipole), orbit: eccentric() };
    let magnet = Magnetic { moment: Direction::from_array(moment), field };
    vec![
        Case { orbit: start, ..case("gravity gradient on a circle", gradient(circle), gravity_gradient) },
        case("gravity gradient on an ellipse", gradient(eccentric()), gravity_gradient),
        case("magnet in a dipole's field", TorqueModel::Magnetic(Box::new(magnet)), move |now| {
            let (r, distance) = (now.r, dot(now.r, now.r).sqrt());
            let along = plus([0.0; 3], 3.0 * dot(dipole, r) / (distance * distance), r);
            let field = plus(along, -1.0, dipole).map(|x| 1e-7 * x / distance.powi(3));
            cross(moment, in_body(now, field))
        }),
    ]
}

fn of_attitudes() -> Vec<Case> {
    let (rest, e) = ([0.5, -0.6, 1.0, 0.4], [0.3, -0.5, 0.9_f64]);
    let n = e.map(|x| x / dot(e, e).sqrt());
    let norm = rest.iter().map(|x| x * x).sum::<f64>().sqrt();
    let unit = rest.map(|x| x / norm);
    let at_rest = Attitude::from_quaternion(rest).unwrap();
    let spring = TorqueModel::Torsion(Torsion::spring(8.0, at_rest).unwrap());
    let wire = TorqueModel::Torsion(Torsion::wire(0.6, at_rest, Direction::from_array(e)).unwrap());
    let fields = [0.2, -0.5, 0.4];
    let moment = [0.3, -0.2, 0.5];
    let field = MagneticField::Uniform(Direction::from_array(fields));
    let magnet = Magnetic { moment: Direction::from_array(moment), field };
    vec![
        case("spring", spring, move |now| {
            let (w, v) = turn(unit, now.quaternion);
            let sine = dot(v, v).sqrt();
            v.map(|x| -8.0 * 2.0 * sine.atan2(w) / sine * x)
        }),
        case("wire", wire, move |now| {
            let (w, v) = turn(unit, now.quaternion);
            let e = Attitude::from_quaternion(unit).unwrap().inverse() * Direction::<Space>::from_array(n);
            let e = e.to_array();
            let s = dot(v, e);
            let b = plus(plus(e.map(|x| w * w * x), w, cross(e, v)), s, v);
            b.map(|x| -0.6 * 2.0 * s.atan2(w) * x / (w * w + s * s))
        }),
        case("magnet", TorqueModel::Magnetic(Box::new(magnet)), move |now| {
            cross(moment, in_body(now, fields))
        }),
        case(
            "gravity",
            TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(0.6, -0.3, -9.4) }),
            |now| cross(now.lever.map(|x| now.mass * x), in_body(now, [0.6, -0.3, -9.4])),
        ),
        case(
            "torque in space",
            TorqueModel::Constant(ConstantTorque::Space(Torque::new(0.1, -0.2, 0.15))),
            |now| in_body(now, [0.1, -0.2, 0.15]),
        ),
    ]
}

const MATRIX: M = [[0.1, 0.02, 0.0], [0.02, 0.2, 0.01], [0.0, 0.01, 0.3]];

fn of_rates_and_times() -> Vec<Case> {
    let drag = |law| TorqueModel::Drag(Drag::new(law, MATRIX).unwrap());
    let (place, force) = ([0.05, 0.3, -0.9], [0.3, -0.2, 2.5]);
    let thrust = Thruster { position: Position::from_array(place), force: Force::from_array(force) };
    let moment = move |now: &Now| cross(plus(place, -1.0, now.point), force);
    let window = Schedule::window(1.2, 4.3).unwrap();
    let scheduled = Scheduled { torque: TorqueModel::Thruster(thrust), schedule: window };
    let rows = [[0.1, -0.2, 0.3], [-0.2, 0.1, 0.4], [0.3, 0.3, -0.1]];
    let table = Tabulated::new(TorqueAxes::Body, Interpolation::Linear, &[0.7, 2.9, 5.1], &rows).unwrap();
    let coefficients = vec![[0.1, -0.2, 0.05], [0.03, 0.02, -0.04], [-0.01, 0.02, 0.01]];
    let polynomial = TimePolynomial { axes: TorqueAxes::Space, epoch: 0.4, coefficients };
    vec![
        case("linear drag", drag(DragLaw::Linear), |now| times(MATRIX, now.omega).map(|x| -x)),
        case("quadratic drag", drag(DragLaw::Quadratic), |now| {
            times(MATRIX, now.omega).map(|x| -x * dot(now.omega, now.omega).sqrt())
        }),
        case("thruster", TorqueModel::Thruster(thrust), moment),
        Case {
            corners: vec![1.2, 4.3],
            ..case("pulse", TorqueModel::Scheduled(Box::new(scheduled)), move |now| {
                if now.time > 1.2 && now.time < 4.3 { moment(now) } else { [0.0; 3] }
            })
        },
        Case {
            corners: vec![0.7, 2.9, 5.1],
            ..case("table", TorqueModel::Tabulated(Box::new(table)), move |now| {
                let part = (now.time - 0.7) / 2.2;
                let k = part.floor();
                if !(0.0..2.0).contains(&k) {
                    return [0.0; 3];
                }
                let [a, b] = [rows[k as usize], rows[k as usize + 1]];
                plus(a, part - k, plus(b, -1.0, a))
            })
        },
        case("polynomial", TorqueModel::Polynomial(polynomial), |now| {
            let t = now.time - 0.4;
            let falling = plus([0.03, 0.02, -0.04], t, [-0.01, 0.02, 0.01]);
            in_body(now, plus([0.1, -0.2, 0.05], t, falling))
        }),
    ]
}

const WEIGHT: V = [0.012, -0.006, -0.188];

/// Torque N = M l × w + p × ω/10 − ½ I ω, with the point p and l from it to the centre of mass.
/// Uses the rotor.
#[derive(Debug)]
struct OfRotor;

impl Law for OfRotor {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        let rotor = at.rotor();
        let [moment, point] = [rotor.lever() * rotor.mass(), rotor.point()]
            .map(|v| at.in_body(Direction::from_array(v.to_array())));
        sum(at, moment, point)
    }
}

/// The same torque, for a body with changing mass.
#[derive(Debug)]
struct OfChanging;

impl Law for OfChanging {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        match (at.moving_moment(), at.moving_point()) {
            (Some(moment), Some(point)) => sum(at, moment, point),
            _ => OfRotor.torque(at),
        }
    }
}

fn sum<I: LawInput>(at: &I, moment: I::Vector, point: I::Vector) -> I::Vector {
    moment.cross(at.in_space(Direction::from_array(WEIGHT))) + point.cross(at.omega()).scaled(0.1)
        - at.inertia(at.omega()).scaled(0.5)
}

fn of_rotor(now: &Now) -> V {
    let weight = cross(now.lever.map(|x| now.mass * x), in_body(now, WEIGHT));
    plus(plus(weight, 0.1, cross(now.point, now.omega)), -0.5, times(now.tensor, now.omega))
}

fn of_users() -> Vec<Case> {
    let place = |name| StateVariables::NAMES.iter().position(|known| *known == name).unwrap();
    // Returns −0.3 a b.
    let product = |a, b| {
        let multiply = Instruction::Binary(Binary::Multiply);
        let all = [
            Instruction::Constant(-0.3),
            Instruction::Variable(place(a)),
            multiply,
            Instruction::Variable(place(b)),
            multiply,
        ];
        Formula::new(all).unwrap()
    };
    let formulas = [product("Lx", "t"), product("Ly", "T_rot"), product("LZ", "r21")];
    let function = |rotor: &Rotor, state: &State| {
        let [moment, point] = [rotor.lever() * rotor.mass(), rotor.point()].map(Position::to_array);
        let weight = (state.attitude.inverse() * Direction::<Space>::from_array(WEIGHT)).to_array();
        let omega = state.omega.to_array();
        let about = plus(cross(moment, weight), 0.1, cross(point, omega));
        Torque::from_array(plus(about, -0.5, rotor.angular_momentum(state.omega).to_array()))
    };
    vec![
        case("law of the rotor", TorqueModel::own("law of the rotor", OfRotor), of_rotor),
        case("law", TorqueModel::own("law", OfChanging), of_rotor),
        case("function", TorqueModel::function("function", function), of_rotor),
        case("formulas", TorqueModel::Formula(Box::new(FormulaTorque::Body(formulas))), |now| {
            let momentum = times(now.tensor, now.omega);
            let in_space = times(now.attitude, momentum);
            [
                -0.3 * momentum[0] * now.time,
                -0.3 * momentum[1] * 0.5 * dot(now.omega, momentum),
                -0.3 * in_space[2] * now.attitude[1][0],
            ]
        }),
    ]
}

#[test]
fn every_torque_acts_on_the_body_as_it_is_at_the_time() {
    let history = history();
    let start = State {
        time: 0.0,
        attitude: Attitude::from_quaternion(ATTITUDE).unwrap(),
        omega: AngularVelocity::from_array(OMEGA),
    };
    let cases = [of_orbits(), of_attitudes(), of_rates_and_times(), of_users()];
    for Case { name, model, law, orbit, corners } in cases.into_iter().flatten() {
        for pivot in [None, Some(PIVOT)] {
            let (omega, attitude) =
                Motion { pivot, law: law.as_ref(), mu: MU }.end(OMEGA, ATTITUDE, orbit, &corners);
            let (omega, attitude) =
                (AngularVelocity::from_array(omega), Attitude::from_quaternion(attitude).unwrap());
            let rotor = history.rotor(0.0, pivot.map(Position::from_array)).unwrap();
            let (torques, times) = ([model.clone()], [END]);
            let simulation = Simulation::new(&rotor, &torques, start, &times).changing(Some(&history));
            let of_states = ["law of the rotor", "function"].contains(&name);
            for method in [Method::Auto, Method::Taylor, Method::Dop853] {
                let motion = match simulation.method(method).tolerance(1e-15).run() {
                    Err(MotionError::NotSmooth { .. }) if of_states && method == Method::Taylor => continue,
                    motion => motion.unwrap(),
                };
                let is_rough = matches!(motion.reason(), MethodReason::Rough { .. });
                assert_eq!(is_rough, of_states && method == Method::Auto, "{name}");
                let drift = Drift::of(&motion).unwrap();
                let state = motion.samples()[0].state;
                let (error, angle) = ((state.omega - omega).norm(), state.attitude.angle_to(attitude));
                // Gravity about the pivot is stronger than the others by two orders of magnitude,
                // and its motion is more sensitive in proportion.
                let limit = if name == "gravity" { 1e-11 } else { 1e-12 };
                assert!(error < limit && angle < limit, "{name} {pivot:?} {method:?}: {error:e} {angle:e}");
                assert!(drift.work_energy < 1e-12 && drift.momentum < 1e-12, "{name}: {drift:?}");
            }
        }
    }
}
