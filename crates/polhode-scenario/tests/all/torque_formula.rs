//! Torque formulas, compared with built-in torques, with closed forms and with each other, by both
//! integrators.

use std::path::Path;

use polhode::math::formula::Formula;
use polhode::motion::torque::{Drag, DragLaw, FormulaTorque};
use polhode::motion::{Ending, Motor};
use polhode::prelude::*;
use polhode_source::expression::formula_of_state;
use polhode_source::unit::Dimension;

const BOTH: [Method; 2] = [Method::Taylor, Method::Dop853];

fn formula(text: &str) -> Formula {
    formula_of_state(text, Some(Dimension::TORQUE)).unwrap_or_else(|e| panic!("{text}: {e}")).0
}

fn body_axes(texts: [&str; 3]) -> TorqueModel {
    TorqueModel::Formula(Box::new(FormulaTorque::Body(texts.map(formula))))
}

fn space_axes(texts: [&str; 3]) -> TorqueModel {
    TorqueModel::Formula(Box::new(FormulaTorque::Space(texts.map(formula))))
}

fn properties() -> MassProperties<Body> {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap()
}

fn start() -> State {
    let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    State { time: 0.3, attitude, omega: AngularVelocity::new(0.9, -1.3, 0.6) }
}

fn run(rotor: &Rotor, torques: &[TorqueModel], times: &[f64], method: Method) -> Trajectory {
    Trajectory::compute(rotor, torques, start(), times, method, 1e-14).unwrap()
}

/// Checks that both motions are equal, and that the second has good conserved quantities.
#[track_caller]
fn agree(one: &Trajectory, other: &Trajectory, tolerance: f64) {
    for (a, b) in one.samples().iter().zip(other.samples()) {
        let angle = a.state.attitude.angle_to(b.state.attitude);
        let omega = (a.state.omega - b.state.omega).norm();
        assert!(angle <= tolerance && omega <= tolerance, "t = {}: {angle:e} {omega:e}", a.state.time);
        let [impulse, work] = [(a.impulse - b.impulse).norm(), (a.work - b.work).abs()];
        assert!(impulse <= 10.0 * tolerance && work <= 10.0 * tolerance, "{impulse:e} {work:e}");
    }
    let drift = Drift::of(other).unwrap();
    assert!(drift.work_energy <= tolerance && drift.momentum <= tolerance, "{drift:?}");
}

#[test]
fn constant_torques_are_formulas() {
    let rotor = Rotor::free(&properties());
    let texts = ["0.3[N m]", "-200[mN m]", "0.1[N m s]*2[rad/s]/(4 - 3)"];
    for method in BOTH {
        for (formula, constant) in [
            (body_axes(texts), ConstantTorque::Body(Torque::new(0.3, -0.2, 0.2))),
            (space_axes(texts), ConstantTorque::Space(Torque::new(0.3, -0.2, 0.2))),
        ] {
            let times = [1.7, 3.4];
            let built_in = run(&rotor, &[TorqueModel::Constant(constant)], &times, method);
            agree(&built_in, &run(&rotor, &[formula], &times, method), 1e-13);
        }
    }
}

/// N = l × M g, with g in body axes from the direction cosines.
#[test]
fn gravity_at_a_pivot_is_a_formula() {
    let rotor = Rotor::pivoted(&properties(), Position::new(-0.4, 0.9, 0.2));
    let gravity = UniformGravity { acceleration: Acceleration::new(1.1, -2.2, -8.7) };
    let [x, y, z] = rotor.lever().to_array();
    let g = |k: usize| format!("(1.1[m/s^2]*r1{k} - 2.2[m/s^2]*r2{k} - 8.7[m/s^2]*r3{k})");
    let cross = |a: f64, i: usize, b: f64, j: usize| {
        format!("2.3[kg]*({a:?}[m]*{} - {b:?}[m]*{})", g(i), g(j)).replace("--", "+")
    };
    let texts = [cross(y, 3, z, 2), cross(z, 1, x, 3), cross(x, 2, y, 1)];
    let formula = body_axes([&texts[0], &texts[1], &texts[2]]);
    for method in BOTH {
        let built_in = run(&rotor, &[TorqueModel::Gravity(gravity)], &[1.0, 2.3], method);
        agree(&built_in, &run(&rotor, std::slice::from_ref(&formula), &[1.0, 2.3], method), 1e-13);
    }
}

/// N = −c L: L = L₀ exp(−c t) for any body. N = −k |L| L: L = L₀/(1 + k |L₀| t).
#[test]
fn drag_along_the_momentum_decays_as_it_must() {
    let rotor = Rotor::free(&properties());
    let first = rotor.angular_momentum_space(&start());
    let linear = body_axes(["-0.4[1/s]*Lx", "-0.4[1/s]*Ly", "-0.4[1/s]*Lz"]);
    let size = "hypot(LX, hypot(LY, LZ))";
    let quadratic = ["LX", "LY", "LZ"].map(|l| format!("-0.07[1/(kg m^2)]*{size}*{l}"));
    let quadratic = space_axes([&quadratic[0], &quadratic[1], &quadratic[2]]);
    for method in BOTH {
        for (torque, factor) in
            [(&linear, f64::exp(-0.4 * 3.0)), (&quadratic, 1.0 / (1.0 + 0.07 * first.norm() * 3.0))]
        {
            let motion = run(&rotor, std::slice::from_ref(torque), &[3.3], method);
            let last = rotor.angular_momentum_space(&motion.samples()[0].state);
            assert!((last - first * factor).norm() < 2e-13 * first.norm(), "{method:?} {last:?}");
            agree(&motion, &motion, 1e-13);
        }
    }
}

/// L − L₀ = ∫ N dt for a torque along space axes that depends on time alone.
#[test]
fn a_torque_of_time_alone_gives_its_integral() {
    let rotor = Rotor::free(&properties());
    let torque = space_axes([
        "0.4[N m]*exp(-0.7[1/s]*t)",
        "0.3[N m]*sin(2[rad/s]*t + 0.4)",
        "0.2[N m]/(1 + (t/1.5[s])^2)",
    ]);
    let (from, to) = (0.3_f64, 4.1_f64);
    let integral = AngularMomentum::<Space>::new(
        0.4 / 0.7 * ((-0.7 * from).exp() - (-0.7 * to).exp()),
        0.15 * ((2.0 * from + 0.4).cos() - (2.0 * to + 0.4).cos()),
        0.3 * ((to / 1.5).atan() - (from / 1.5).atan()),
    );
    for method in BOTH {
        let motion = run(&rotor, std::slice::from_ref(&torque), &[to], method);
        let gained = motion.samples()[0].momentum - rotor.angular_momentum_space(&start());
        assert!((gained - integral).norm() < 1e-13, "{method:?} {:e}", (gained - integral).norm());
        assert!((motion.samples()[0].impulse - integral).norm() < 1e-13);
    }
}

/// Series and values of each variable and function are computed independently. Both methods give
/// the same motion, including wheels.
#[test]
fn every_variable_has_the_series_of_its_values() {
    let plain = Rotor::free(&properties());
    let motor = Motor::Torque { inertia: 0.2, torque: 0.15, schedule: None };
    let wheels = [
        Wheel::new(Direction::new(0.3, -0.5, 0.9), 0.8, motor).unwrap(),
        Wheel::new(Direction::new(-1.0, 0.2, 0.4), -0.5, Motor::HeldSpeed).unwrap(),
    ];
    let geared = Rotor::free(&properties()).with_wheels(&wheels).unwrap();
    let torques = [
        body_axes([
            "-0.2[N m s]*wX + 0.1[N m]*qw*qz - 0.05[1/s]*LY",
            "0.1[N m s]*wy + 0.03[1/s]*(Lx - LZ) + 0.1[N m]*qx^3",
            "-0.1[N m s]*wZ - 0.05[1/s]*Lz + 0.2[N m]*qy*r12 + 0.01*T_rot",
        ]),
        space_axes([
            "0.2[N m]*(r11 - r22*r13) + 0.1[N m]*sin(phi) - 0.02[1/s]*LX",
            "0.3[N m]*(r21*r23 + r32)*cos(psi - phi) - 0.1[N m s]*wY",
            "0.1[N m]*theta*r31 + 0.2[N m]*r33*exp(-t/3[s]) - 0.1[N m s]*wx - 0.02[1/s]*Ly - 0.1[N m s]*wz",
        ]),
        body_axes([
            "0.1[N m]*log(2 + r11) + 0.2[N m]*tan(0.4*r23)",
            "0.1[N m]*asin(0.7*qx) - 0.1[N m]*acos(0.8*r31) + 0.1[N m]*(2 + r12)^r13",
            "0.05[N m]*atan(wx/wy - 2) + 0.1[N m]*atan2(wz, 5[rad/s] + wy)*(3 + r21)^-0.6 + 0.1[N m]*sqrt(2 - qz)",
        ]),
    ];
    for rotor in [&plain, &geared] {
        for torque in &torques {
            let times = [1.0, 2.6];
            let [taylor, dop853] =
                BOTH.map(|method| run(rotor, std::slice::from_ref(torque), &times, method));
            agree(&dop853, &taylor, 1e-12);
            agree(&taylor, &dop853, 1e-12);
        }
    }
}

/// ∫ N dt of an unannounced pulse: DOP853 locates its end.
#[test]
fn a_formula_may_jump() {
    let rotor = Rotor::free(&properties());
    let torque = space_axes(["if(t < 1[s], 0.2[N m], 0)", "0", "max(0, 0.1[N m/s]*(t - 1.2[s]))"]);
    let motion = run(&rotor, &[torque], &[2.0], Method::Dop853);
    let expected = AngularMomentum::new(0.2 * 0.7, 0.0, 0.1 * 0.8 * 0.8 / 2.0);
    let error = (motion.samples()[0].impulse - expected).norm();
    assert!(error < 1e-11, "{error:e}");
}

#[test]
fn what_is_no_number_ends_at_the_last_good_time() {
    let rotor = Rotor::free(&properties());
    for (text, earliest, latest) in [
        ("0.1[N m]*log(1 - t/2[s])", 1.9, 2.0),
        ("0.1[N m s]/(t - 2[s])", 1.9, 2.0),
        ("0.1[N m]*sqrt(2 - t/1[s])", 1.9, 2.0),
    ] {
        for method in BOTH {
            let torque = body_axes(["0.1[N m]", text, "0"]);
            let motion = Trajectory::compute(&rotor, &[torque], start(), &[4.0], method, 1e-12).unwrap();
            let Ending::Failed { time, cause } = motion.ending() else { panic!("{text} {method:?}") };
            assert!(cause.is_numerical(), "{text} {method:?}: {cause}");
            // A step may pass the point by an amount within its tolerance: δ^1.5 is 1e-10 past a
            // root.
            assert!((earliest..=latest + 1e-6).contains(time), "{text} {method:?}: {time}");
        }
    }
    for method in BOTH {
        // Not finite at the start already: the error names the torque and the component.
        let good = body_axes(["0.1[N m]", "0", "0"]);
        let torque = body_axes(["0.1[N m]", "0.1[N m]*sqrt(-1 - t/1[s])", "0"]);
        let refused = Trajectory::compute(&rotor, &[good, torque], start(), &[4.0], method, 1e-12);
        let Err(MotionError::TorqueNotFinite { torque: 1, value: [x, y, z] }) = refused else {
            panic!("{refused:?}")
        };
        assert!(x == 0.1 && y.is_nan() && z == 0.0);
        // The function has no power series at this corner.
        let torque = body_axes(["0", "0", "0.1[N m]*sqrt(t/1[s] - 0.3)"]);
        let end = Trajectory::compute(&rotor, &[torque], start(), &[1.0], Method::Taylor, 1e-12);
        assert!(
            matches!(
                end.as_ref().map(Trajectory::ending),
                Ok(Ending::Failed { cause: MotionError::NotFinite { time: 0.3 }, .. })
                    | Err(MotionError::NotFinite { time: 0.3 })
            ),
            "{end:?}"
        );
    }
}

/// Both laws of drag with a full matrix, as the model and as formulas.
#[test]
fn drag_is_a_formula() {
    let rotor = Rotor::free(&properties());
    let matrix = [[0.31, -0.07, 0.05], [-0.07, 0.43, 0.11], [0.05, 0.11, 0.26]];
    let row = |[a, b, c]: [f64; 3], unit: &str| {
        format!("-({a:?}{unit}*wx + {b:?}{unit}*wy + {c:?}{unit}*wz)").replace("+ -", "- ")
    };
    for (law, unit, more) in [
        (DragLaw::Linear, "[N m s]", String::new()),
        (DragLaw::Quadratic, "[N m s^2]", "*sqrt(wx^2 + wy^2 + wz^2)".to_owned()),
    ] {
        let built_in = [TorqueModel::Drag(Drag::new(law, matrix).unwrap())];
        let [x, y, z] = matrix.map(|line| row(line, unit) + &more);
        let formula = [body_axes([&x, &y, &z])];
        let times = [1.7, 6.3];
        for a in BOTH {
            for b in BOTH {
                agree(&run(&rotor, &built_in, &times, a), &run(&rotor, &formula, &times, b), 1e-12);
            }
        }
    }
}

/// A rod has no inertia about its axis. A torque across it has a component along it only by
/// rounding, whatever parts the law has.
#[test]
fn a_law_across_an_oblique_rod_does_not_spin_it() {
    // The direction of the rod is (-0.3163…, -0.4930…, 0.8104…).
    let [x, y] = [-0.493_098_606_001_781_57, 0.316_314_496_491_938_7];
    let moving = |torque: [String; 3]| {
        let torque = torque.map(|component| format!("{component:?}")).join(", ");
        let text = format!(
            "[[body.part]]\nshape = 'rod'\nlength = '1.3 m'\nmass = '0.7 kg'\n\
             rotate = {{ axis = [0.3, -0.5, 0.8], angle = '1.1 rad' }}\n\
             [start]\nspin = {{ body = [0, 0, 0] }}\n\
             [[torque]]\nmodel = 'formula'\nunits = 'SI'\naxes = 'body'\ntorque = [{torque}]\n\
             [run]\nduration = '3 s'\nsamples = 2\n"
        );
        let scenario = polhode_scenario::read::parse(&text, Path::new("rod.toml")).unwrap();
        scenario.simulate().unwrap()
    };
    for size in ["0.1", "sin(t)", "0.1+0.2*sin(t)", "0.3*(wx*wx+wy*wy)+0.1", "0.1*atan(3*t)-0.2*wz*wz"] {
        let motion = moving([format!("({size})*{x}"), format!("({size})*{y}"), "0".to_owned()]).unwrap();
        // ω is across the rod, along the torque.
        let [a, b, c] = motion.samples().last().unwrap().state.omega.to_array();
        let along = -0.316_314_496_491_938_7 * a - 0.493_098_606_001_781_57 * b + 0.810_431_307_433_363_4 * c;
        let size_of_omega = (a * a + b * b + c * c).sqrt();
        assert!(
            along.abs() < 1e-14 * size_of_omega && size_of_omega > 0.1,
            "{size}: {along} of {size_of_omega}"
        );
    }
    let error = moving(["0.1+0.2*sin(t)".to_owned(), "0".to_owned(), "0".to_owned()]).unwrap_err();
    assert!(error.to_string().contains("no inertia"), "{error}");
}
