//! Every torque model at a generic point: the derivatives agree with those of whole runs, and
//! satisfy the differential equations.

use polhode::math::formula::{Binary, Formula, Instruction, Unary};
use polhode::motion::torque::{
    Attracted, Drag, DragLaw, EnergySink, FormulaTorque, GravityGradient, Interpolation, Magnetic,
    MagneticField, Schedule, Scheduled, Tabulated, Thruster, TimePolynomial, TorqueAxes, TorqueParameter,
    Torsion,
};
use polhode::motion::{Motor, Orbit, StateVariables};
use polhode::prelude::*;

use super::{Problem, between, check, columns, cross, derivative, difference};

const TIMES: [f64; 3] = [0.3, 1.4, 3.1];

fn orbit() -> Orbit {
    Orbit::through(2.3, Position::new(1.1, -1.3, 0.4), Velocity::new(0.7, 0.6, -0.5), 0.7).unwrap()
}

fn circular() -> Orbit {
    Orbit::circular(2.3, 1.4, Direction::new(1.0, 0.2, 0.1), Direction::new(-0.3, 0.9, 0.7)).unwrap()
}

fn gradient(orbit: Orbit, attracted: Attracted) -> TorqueModel {
    TorqueModel::GravityGradient(Box::new(GravityGradient { orbit, attracted }))
}

fn points() -> Attracted {
    let points =
        [(0.8, [0.9, -0.2, 0.4]), (0.7, [-0.6, 1.1, 0.3]), (0.5, [0.1, 0.5, -1.3]), (0.3, [-0.8, -0.9, 0.2])];
    Attracted::Points(points.map(|(m, p)| Particle::new(m, Position::from_array(p) * 0.4).unwrap()).to_vec())
}

fn rest() -> Attitude {
    Attitude::from_quaternion([0.5, -0.6, 1.0, 0.4]).unwrap()
}

/// Torque N = −c |ω|ᵖ ω + k sin(r₁₂) x̂ with the parameters c, p and k.
#[derive(Debug)]
struct Own {
    c: f64,
    p: f64,
    k: f64,
}

impl Law for Own {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        let omega = at.omega();
        let size = omega.norm().binary(Binary::Power, at.parameter(1, self.p));
        let [x, _, _] = at.components(at.in_space(Direction::new(0.0, 1.0, 0.0)));
        let push =
            at.in_body(Direction::new(1.0, 0.2, 0.0)) * (x.unary(Unary::Sin) * at.parameter(2, self.k));
        push - omega * (size * at.parameter(0, self.c))
    }

    fn parameters(&self) -> &'static [&'static str] {
        &["c", "p", "k"]
    }
}

/// Returns a torque by formulas with every smooth function.
fn formula() -> TorqueModel {
    let variable = |name| {
        let place = StateVariables::NAMES.iter().position(|known| *known == name).unwrap();
        Instruction::Variable(place)
    };
    let constant = Instruction::Constant;
    let unary = Instruction::Unary;
    let binary = Instruction::Binary;
    let x = Formula::new([
        variable("wx"),
        unary(Unary::Sin),
        variable("r31"),
        unary(Unary::Exp),
        binary(Binary::Multiply),
        variable("wy"),
        unary(Unary::Atan),
        binary(Binary::Add),
        variable("theta"),
        unary(Unary::Cos),
        binary(Binary::Subtract),
        variable("LX"),
        unary(Unary::Tan),
        constant(0.01),
        binary(Binary::Multiply),
        binary(Binary::Add),
        variable("qx"),
        unary(Unary::Sinh),
        variable("r32"),
        unary(Unary::Cosh),
        binary(Binary::Multiply),
        variable("wz"),
        unary(Unary::Tanh),
        binary(Binary::Multiply),
        binary(Binary::Add),
        variable("r22"),
        constant(0.4),
        binary(Binary::Multiply),
        Instruction::Local(1),
        unary(Unary::Log1p),
        Instruction::Local(1),
        unary(Unary::Expm1),
        binary(Binary::Multiply),
        Instruction::EndLocal,
        binary(Binary::Add),
    ]);
    let y = Formula::new([
        variable("r12"),
        constant(0.5),
        binary(Binary::Multiply),
        unary(Unary::Asin),
        variable("r23"),
        constant(0.6),
        binary(Binary::Multiply),
        unary(Unary::Acos),
        binary(Binary::Hypot),
        variable("T_rot"),
        unary(Unary::Log),
        binary(Binary::Multiply),
        variable("t"),
        unary(Unary::Sqrt),
        binary(Binary::Divide),
        constant(0.2),
        binary(Binary::Multiply),
    ]);
    let z = Formula::new([
        variable("qw"),
        unary(Unary::Power(3)),
        variable("wZ"),
        variable("Ly"),
        binary(Binary::Atan2),
        binary(Binary::Multiply),
        constant(2.0),
        variable("r11"),
        binary(Binary::Add),
        variable("wy"),
        binary(Binary::Power),
        binary(Binary::Add),
        constant(1.5),
        variable("qy"),
        binary(Binary::Add),
        constant(-1.3),
        binary(Binary::Power),
        binary(Binary::Subtract),
        variable("phi"),
        unary(Unary::Sin),
        binary(Binary::Add),
        variable("psi"),
        unary(Unary::Cos),
        unary(Unary::Negate),
        binary(Binary::Add),
    ]);
    TorqueModel::Formula(Box::new(FormulaTorque::Space([x, y, z].map(Result::unwrap))))
}

const MATRIX: [[f64; 3]; 3] = [[0.5, 0.1, -0.05], [0.1, 0.4, 0.2], [-0.05, 0.2, 0.7]];

fn drag(law: DragLaw) -> TorqueModel {
    TorqueModel::Drag(Drag::new(law, MATRIX).unwrap())
}

fn magnet(field: MagneticField) -> TorqueModel {
    TorqueModel::Magnetic(Box::new(Magnetic { moment: Direction::new(0.3, 1.2, -0.7), field }))
}

fn dipole() -> MagneticField {
    MagneticField::Dipole { dipole: Direction::new(3e7, -2e7, 5e7), orbit: orbit() }
}

/// Returns all models, by name.
fn models() -> Vec<(&'static str, Problem)> {
    let gravity = TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(1.1, -2.2, -8.7) });
    let uniform = MagneticField::Uniform(Direction::new(0.9, -1.1, 0.4));
    let spring = Torsion::spring(1.7, rest()).unwrap();
    let wire = Torsion::wire(1.7, rest(), Direction::new(0.3, -0.5, 0.9)).unwrap();
    let mut at_rest = Problem::free(vec![TorqueModel::Torsion(spring)]);
    at_rest.start.attitude = rest();
    let polynomial = TimePolynomial {
        axes: TorqueAxes::Space,
        epoch: 0.1,
        coefficients: vec![[0.5, -0.5, 1.0], [0.25, 0.4, -0.75]],
    };
    let table = Tabulated::new(
        TorqueAxes::Body,
        Interpolation::Spline,
        &[0.0, 0.9, 1.7, 2.2, 4.0],
        &[[1.0, -2.0, 0.5], [0.25, 3.0, -1.0], [2.0, 2.5, 0.75], [-1.0, 0.125, 4.0], [0.5, 1.0, -3.0]],
    );
    let thruster = Thruster { position: Position::new(1.5, 0.75, -1.0), force: Force::new(0.2, -0.3, 0.5) };
    let pulsed = Scheduled {
        torque: TorqueModel::Thruster(thruster),
        schedule: Schedule::pulses(0.5, 0.3, 0.7, None).unwrap(),
    };
    let sink = TorqueModel::EnergySink(EnergySink::new(0.013).unwrap());
    let constant = |n| TorqueModel::Constant(n);
    let wheels = vec![
        Wheel::new(Direction::new(0.6, -0.3, 0.9), 2.7, Motor::HeldSpeed).unwrap(),
        Wheel::new(
            Direction::new(-0.2, 1.0, 0.5),
            0.9,
            Motor::Torque { inertia: 0.2, torque: 0.4, schedule: Some(Schedule::window(0.7, 2.0).unwrap()) },
        )
        .unwrap(),
    ];
    let of = |torque| Problem::free(vec![torque]);
    vec![
        ("free", Problem::free(Vec::new())),
        ("constant in the body", of(constant(ConstantTorque::Body(Torque::new(0.5, -0.7, 1.1))))),
        ("constant in space", of(constant(ConstantTorque::Space(Torque::new(0.5, -0.7, 1.1))))),
        ("gravity", Problem::pivoted(vec![gravity.clone()])),
        ("gravity gradient", of(gradient(orbit(), Attracted::Tensor))),
        ("gravity gradient on a circle", of(gradient(circular(), Attracted::Tensor))),
        ("gravity gradient of points", of(gradient(orbit(), points()))),
        ("linear drag", of(drag(DragLaw::Linear))),
        ("quadratic drag", of(drag(DragLaw::Quadratic))),
        ("spring at rest", at_rest),
        ("spring", of(TorqueModel::Torsion(spring))),
        ("wire", of(TorqueModel::Torsion(wire))),
        ("magnet", of(magnet(uniform))),
        ("magnet on an orbit", of(magnet(dipole()))),
        ("thruster", Problem::pivoted(vec![TorqueModel::Scheduled(Box::new(pulsed))])),
        ("sink", of(sink.clone())),
        ("formula", of(formula())),
        ("polynomial", of(TorqueModel::Polynomial(polynomial))),
        ("table", of(TorqueModel::Tabulated(Box::new(table.unwrap())))),
        ("own", of(TorqueModel::own("own", Own { c: 0.2, p: 1.7, k: 0.9 }))),
        ("wheels", Problem { wheels: wheels.clone(), ..of(gradient(orbit(), Attracted::Tensor)) }),
        (
            "wheels and friction",
            Problem { wheels, ..Problem::pivoted(vec![sink, gravity, drag(DragLaw::Linear)]) },
        ),
    ]
}

#[test]
fn derivatives_are_those_of_whole_runs() {
    for (name, problem) in models() {
        check(name, &problem, &TIMES, 1e-8);
    }
}

#[test]
fn derivatives_follow_the_differential_equations() {
    // θ̇ = θ × ω + δω and I δω̇ = δL × ω + L × δω + ∂N/∂θ θ + ∂N/∂ω δω. Derivatives with respect to
    // the inertia add δL × ω − δI ω̇, for torques that do not depend on it. The Jacobians of the
    // torques are computed independently.
    for (name, problem) in models() {
        if name.contains("friction") || name == "sink" {
            continue;
        }
        let (rotor, time, h) = (problem.rotor(), 1.45, 0.02);
        let steps: Vec<f64> = (0..=128).map(|k| time + h * (f64::from(k) - 64.0) / 64.0).collect();
        let motion = problem.derivatives(&[], &steps);
        let here = &motion.states[64];
        let (state, all) = (here.state, columns(here));
        let at = |h: f64| &motion.states[(64.0 + h / 0.02 * 64.0).round() as usize];
        let acceleration = derivative(|h| at(h).state.omega.to_array().to_vec(), h);
        let tensor = rotor.inertia().matrix();
        let times =
            |m: [[f64; 3]; 3], v: [f64; 3]| m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);
        let omega = state.omega.to_array();
        let momentum = (rotor.angular_momentum(state.omega) + rotor.wheel_momentum(state.time)).to_array();
        for (column, x) in all.iter().enumerate() {
            let is_of_tensor = name.contains("gradient") || name == "wheels" || name == "formula";
            if column >= 6 && is_of_tensor {
                continue;
            }
            let rate = derivative(|h| columns(at(h))[column].to_vec(), h);
            let (theta, faster) = ([x[0], x[1], x[2]], [x[3], x[4], x[5]]);
            let mut more = times(tensor, faster);
            let mut torque = [0.0; 3];
            if column >= 6 {
                let mut unit = [[0.0; 3]; 3];
                let (i, j) = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)][column - 6];
                (unit[i][j], unit[j][i]) = (1.0, 1.0);
                let of = times(unit, omega);
                (0..3).for_each(|k| more[k] += of[k]);
                let inert = times(unit, [acceleration[0], acceleration[1], acceleration[2]]);
                (0..3).for_each(|k| torque[k] -= inert[k]);
            }
            for model in problem.torques.iter().filter(|model| model.acts_at(state.time)) {
                let jacobian = model.jacobian(&rotor, &state).unwrap();
                for k in 0..3 {
                    let by = jacobian.by_attitude[k] * theta[k] + jacobian.by_omega[k] * faster[k];
                    (0..3).for_each(|n| torque[n] += by.to_array()[n]);
                }
            }
            let (a, b) = (cross(more, omega), cross(momentum, faster));
            let change: [f64; 3] = core::array::from_fn(|k| a[k] + b[k] + torque[k]);
            let want: Vec<f64> =
                cross(theta, omega).iter().zip(faster).map(|(a, b)| a + b).chain(change).collect();
            let bent = times(tensor, [rate[3], rate[4], rate[5]]);
            let got: Vec<f64> = rate[..3].iter().copied().chain(bent).collect();
            let error = difference(&got, &want);
            assert!(error < 1e-9, "{name}, column {column}: {error:e}\n{got:?}\n{want:?}");
        }
    }
}

/// A torque with one number changed, by the name of the number.
type Changed = (&'static str, Problem, &'static str, Box<dyn Fn(f64) -> TorqueModel>);

#[test]
fn parameters_are_those_of_whole_runs() {
    let mut cases: Vec<Changed> = Vec::new();
    let names = ["x", "y", "z"];
    for (k, name) in names.into_iter().enumerate() {
        let plus = move |v: [f64; 3], h: f64| core::array::from_fn(|n| if n == k { v[n] + h } else { v[n] });
        let body = move |h| {
            TorqueModel::Constant(ConstantTorque::Body(Torque::from_array(plus([0.5, -0.7, 1.1], h))))
        };
        let space = move |h| {
            TorqueModel::Constant(ConstantTorque::Space(Torque::from_array(plus([0.5, -0.7, 1.1], h))))
        };
        let gravity = move |h| {
            TorqueModel::Gravity(UniformGravity {
                acceleration: Acceleration::from_array(plus([1.1, -2.2, -8.7], h)),
            })
        };
        cases.push(("body", Problem::free(Vec::new()), name, Box::new(body)));
        cases.push(("space", Problem::free(Vec::new()), name, Box::new(space)));
        cases.push(("gravity", Problem::pivoted(Vec::new()), name, Box::new(gravity)));
        let magnet = move |of: usize, field: [f64; 3], is_dipole: bool, h: f64| {
            let moment = if of == 0 { plus([0.3, 1.2, -0.7], h) } else { [0.3, 1.2, -0.7] };
            let field = if of == 1 { plus(field, if is_dipole { 1e7 * h } else { h }) } else { field };
            let field = Direction::from_array(field);
            let field = if is_dipole {
                MagneticField::Dipole { dipole: field, orbit: orbit() }
            } else {
                MagneticField::Uniform(field)
            };
            TorqueModel::Magnetic(Box::new(Magnetic { moment: Direction::from_array(moment), field }))
        };
        let moment = ["moment.x", "moment.y", "moment.z"][k];
        let field = ["field.x", "field.y", "field.z"][k];
        let uniform = [0.9, -1.1, 0.4];
        cases.push((
            "moment",
            Problem::free(Vec::new()),
            moment,
            Box::new(move |h| magnet(0, uniform, false, h)),
        ));
        cases.push((
            "field",
            Problem::free(Vec::new()),
            field,
            Box::new(move |h| magnet(1, uniform, false, h)),
        ));
        let far = [3e7, -2e7, 5e7];
        cases.push((
            "moment on an orbit",
            Problem::free(Vec::new()),
            moment,
            Box::new(move |h| magnet(0, far, true, h)),
        ));
        let (position, force) =
            (["position.x", "position.y", "position.z"][k], ["force.x", "force.y", "force.z"][k]);
        let thruster = move |of: usize, h: f64| {
            let position = if of == 0 { plus([1.5, 0.75, -1.0], h) } else { [1.5, 0.75, -1.0] };
            let force = if of == 1 { plus([0.2, -0.3, 0.5], h) } else { [0.2, -0.3, 0.5] };
            TorqueModel::Thruster(Thruster {
                position: Position::from_array(position),
                force: Force::from_array(force),
            })
        };
        cases.push(("position", Problem::pivoted(Vec::new()), position, Box::new(move |h| thruster(0, h))));
        cases.push(("force", Problem::free(Vec::new()), force, Box::new(move |h| thruster(1, h))));
        let slope = ["c1.x", "c1.y", "c1.z"][k];
        let ramp = move |h| {
            let coefficients = vec![[0.5, -0.5, 1.0], plus([0.25, 0.4, -0.75], h)];
            TorqueModel::Polynomial(TimePolynomial { axes: TorqueAxes::Space, epoch: 0.1, coefficients })
        };
        cases.push(("ramp", Problem::free(Vec::new()), slope, Box::new(ramp)));
        let own = move |h: f64| {
            let [c, p, k] = plus([0.2, 1.7, 0.9], h);
            TorqueModel::own("own", Own { c, p, k })
        };
        cases.push(("own", Problem::free(Vec::new()), ["c", "p", "k"][k], Box::new(own)));
    }
    for (name, (i, j)) in
        ["xx", "yy", "zz", "xy", "xz", "yz"].into_iter().zip([(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)])
    {
        for law in [DragLaw::Linear, DragLaw::Quadratic] {
            let changed = move |h: f64| {
                let mut matrix = MATRIX;
                matrix[i][j] += h;
                matrix[j][i] = matrix[i][j];
                TorqueModel::Drag(Drag::new(law, matrix).unwrap())
            };
            cases.push(("drag", Problem::free(Vec::new()), name, Box::new(changed)));
        }
    }
    let spring = |h: f64| TorqueModel::Torsion(Torsion::spring(1.7 + h, rest()).unwrap());
    let wire = |h: f64| {
        TorqueModel::Torsion(Torsion::wire(1.7 + h, rest(), Direction::new(0.3, -0.5, 0.9)).unwrap())
    };
    let sink = |h: f64| TorqueModel::EnergySink(EnergySink::new(0.033 + h).unwrap());
    cases.push(("spring", Problem::free(Vec::new()), "stiffness", Box::new(spring)));
    cases.push(("wire", Problem::free(Vec::new()), "stiffness", Box::new(wire)));
    cases.push(("sink", Problem::free(Vec::new()), "coefficient", Box::new(sink)));
    let table = |h: f64| {
        let rows =
            [[1.0, -2.0, 0.5], [0.25, 3.0, -1.0], [2.0, 2.5, 0.75]].map(|row| row.map(|x| x * (1.0 + h)));
        let table = Tabulated::new(TorqueAxes::Body, Interpolation::Linear, &[0.0, 0.9, 1.7], &rows);
        TorqueModel::Tabulated(Box::new(table.unwrap()))
    };
    cases.push(("table", Problem::free(Vec::new()), "factor", Box::new(table)));
    let timed = |h: f64| {
        let torque = TorqueModel::Constant(ConstantTorque::Space(Torque::new(0.5, -0.7, 1.1 + h)));
        TorqueModel::Scheduled(Box::new(Scheduled { torque, schedule: Schedule::window(0.9, 1.9).unwrap() }))
    };
    cases.push(("scheduled", Problem::free(Vec::new()), "z", Box::new(timed)));
    for (title, problem, name, torque) in cases {
        // Among other torques, to test the index.
        let with = |h: f64| {
            let torques = vec![gradient(orbit(), Attracted::Tensor), torque(h), drag(DragLaw::Linear)];
            Problem { torques, ..problem.clone() }
        };
        let here = with(0.0).states(&TIMES);
        let want = derivative(
            |h| here.iter().zip(with(h).states(&TIMES)).flat_map(|(a, b)| between(a, &b)).collect(),
            0.02,
        );
        let motion = with(0.0).derivatives(&[TorqueParameter { torque: 1, name }], &TIMES);
        let got: Vec<f64> = motion.by_parameters.iter().flat_map(|columns| columns[0]).collect();
        let error = difference(&got, &want);
        assert!(error < 1e-8, "{title}, {name}: {error:e}\n{got:?}\n{want:?}");
        assert!(want.iter().any(|x| x.abs() > 1e-4), "{title}, {name}");
    }
}
