//! Ensembles: each member has the same bits as when computed alone, and satisfies the equations of
//! motion.

use std::num::NonZero;

use polhode::math::formula::{Binary, Formula, Instruction};
use polhode::motion::torque::{
    Attracted, Drag, DragLaw, EnergySink, FormulaTorque, GravityGradient, Magnetic, MagneticField, Thruster,
    Torsion,
};
use polhode::motion::{Ensemble, Member, MemberFailure, Motor, Orbit, StateVariables};
use polhode::prelude::*;

const ONE: NonZero<usize> = NonZero::<usize>::MIN;

fn body() -> MassProperties<Body> {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap()
}

/// Returns every torque model, each with a body; generic numbers.
pub(crate) fn every_torque() -> Vec<(&'static str, Rotor, Vec<TorqueModel>)> {
    let body = body();
    let (free, held) = (Rotor::free(&body), Rotor::pivoted(&body, Position::new(-0.4, 0.9, 0.2)));
    let matrix = [[0.11, 0.02, -0.03], [0.02, 0.17, 0.05], [-0.03, 0.05, 0.09]];
    let drag = |law| TorqueModel::Drag(Drag::new(law, matrix).unwrap());
    let constant = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.3, -0.7, 0.5)));
    let fixed = TorqueModel::Constant(ConstantTorque::Space(Torque::new(-0.4, 0.6, 0.8)));
    let weight = TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(0.3, -0.4, -1.1) });
    let thruster = TorqueModel::Thruster(Thruster {
        position: Position::new(0.5, 0.2, -0.7),
        force: Force::new(0.4, -0.9, 0.3),
    });
    let magnet =
        |field| TorqueModel::Magnetic(Box::new(Magnetic { moment: Direction::new(0.9, -0.4, 1.3), field }));
    let uniform = magnet(MagneticField::Uniform(Direction::new(0.5, -0.2, 0.8)));
    let position = Position::new(3.0, -4.0, 1.0);
    let circle =
        Orbit::circular_at_rate(0.7, 0.6, Direction::new(0.2, 0.5, 0.9), Direction::new(1.0, -0.3, 0.2))
            .unwrap();
    let ellipse = Orbit::through(70.0, position, Velocity::new(0.4, 0.3, -3.5), 0.7).unwrap();
    let dipole =
        magnet(MagneticField::Dipole { dipole: Direction::new(-3e8, 2e8, -7.5e8), orbit: ellipse.clone() });
    let gradient = |orbit: &Orbit, attracted| {
        TorqueModel::GravityGradient(Box::new(GravityGradient { orbit: orbit.clone(), attracted }))
    };
    let points: Vec<_> =
        [(0.5, [0.9, -0.2, 0.4]), (0.7, [-0.6, 1.1, 0.3]), (0.4, [0.1, 0.5, -1.3]), (0.7, [-0.8, -0.9, 0.2])]
            .map(|(m, p)| Particle::new(m, Position::from_array(p)).unwrap())
            .to_vec();
    let rest = Attitude::from_quaternion([0.5, -0.5, 0.8, 0.6]).unwrap();
    let spring = TorqueModel::Torsion(Torsion::spring(0.7, rest).unwrap());
    let wire = TorqueModel::Torsion(Torsion::wire(0.7, rest, Direction::new(0.3, -0.5, 0.9)).unwrap());
    let sink = TorqueModel::EnergySink(EnergySink::new(0.02).unwrap());
    let axis = Direction::new(0.5, -0.3, 0.9);
    let wheeled = |motor| free.clone().with_wheels(&[Wheel::new(axis, 1.3, motor).unwrap()]).unwrap();
    let driven = Motor::Torque { inertia: 0.2, torque: 0.35, schedule: None };
    vec![
        ("free", free.clone(), vec![]),
        ("constant", free.clone(), vec![constant.clone()]),
        ("constant in space", free.clone(), vec![fixed.clone()]),
        ("gravity", held.clone(), vec![weight.clone()]),
        ("thruster", free.clone(), vec![thruster.clone()]),
        ("linear drag", free.clone(), vec![drag(DragLaw::Linear)]),
        ("quadratic drag", free.clone(), vec![drag(DragLaw::Quadratic)]),
        ("magnet", free.clone(), vec![uniform.clone()]),
        ("dipole", free.clone(), vec![dipole]),
        ("gravity gradient on a circle", free.clone(), vec![gradient(&circle, Attracted::Tensor)]),
        ("gravity gradient on an ellipse", free.clone(), vec![gradient(&ellipse, Attracted::Tensor)]),
        ("gravity gradient on points", free.clone(), vec![gradient(&ellipse, Attracted::Points(points))]),
        ("spring", free.clone(), vec![spring]),
        ("wire", free.clone(), vec![wire]),
        ("energy sink", free.clone(), vec![sink.clone()]),
        ("held wheel", wheeled(Motor::HeldSpeed), vec![]),
        ("driven wheel", wheeled(driven), vec![]),
        ("gravity gradient on wheels", wheeled(driven), vec![gradient(&circle, Attracted::Tensor)]),
        (
            "gravity gradient on a held wheel",
            wheeled(Motor::HeldSpeed),
            vec![gradient(&circle, Attracted::Tensor)],
        ),
        (
            "many at once",
            wheeled(driven),
            vec![
                constant.clone(),
                drag(DragLaw::Linear),
                thruster,
                uniform.clone(),
                drag(DragLaw::Quadratic),
                fixed,
                sink,
                drag(DragLaw::Linear),
            ],
        ),
        ("two magnets", free, vec![uniform.clone(), uniform]),
        ("two weights", held, vec![weight.clone(), weight]),
    ]
}

/// Returns a different start for each k.
pub(crate) fn start(k: usize) -> State {
    let k = k as f64;
    let attitude = Attitude::from_quaternion([0.4 + 0.01 * k, -0.7, 1.1 - 0.003 * k, 0.3]).unwrap();
    State { time: 0.25, attitude, omega: AngularVelocity::new(0.7 + 0.002 * k, -1.1, 0.4 - 0.005 * k) }
}

fn ensemble(members: &[Member]) -> Ensemble {
    Ensemble::new(members.to_vec()).unwrap()
}

/// Returns the distance of two states: angle, and relative difference of ω.
fn distance(a: &State, b: &State) -> f64 {
    let omega = (a.omega - b.omega).norm() / b.omega.norm();
    a.attitude.angle_to(b.attitude).max(omega)
}

fn bits(states: &[State]) -> Vec<[u64; 8]> {
    states.iter().map(|state| <[f64; 8]>::from(*state).map(f64::to_bits)).collect()
}

/// Integrates by the classical Runge–Kutta method, in arbitrary body axes: I ω̇ = L × Ω + N − ḣ and
/// q̇ = ½ q ∘ Ω.
fn textbook(member: &Member, until: f64, steps: usize) -> State {
    let Member { rotor, torques, start, .. } = member;
    let inverse = inverse(rotor);
    let slope = |t: f64, y: &[f64; 7]| -> [f64; 7] {
        let [w, x, y, z, a, b, c] = *y;
        let attitude = Attitude::from_quaternion([w, x, y, z]).unwrap();
        let omega = AngularVelocity::new(a, b, c);
        let state = State { time: t, attitude, omega };
        let l = rotor.angular_momentum(omega) + rotor.wheel_momentum(t);
        let sink: f64 = torques
            .iter()
            .map(|torque| match torque {
                TorqueModel::EnergySink(sink) => sink.coefficient(),
                _ => 0.0,
            })
            .sum();
        let cross = |[a, b, c]: [f64; 3], [x, y, z]: [f64; 3]| [b * z - c * y, c * x - a * z, a * y - b * x];
        let bending = cross(l.to_array(), [a, b, c]);
        let turning = [a + sink * bending[0], b + sink * bending[1], c + sink * bending[2]];
        let torque = torques.iter().fold(Torque::ZERO, |sum, torque| sum + torque.torque(rotor, &state))
            - rotor.motor_torque(t);
        let gyroscopic = cross(l.to_array(), turning);
        let n = torque.to_array();
        let total = [n[0] + gyroscopic[0], n[1] + gyroscopic[1], n[2] + gyroscopic[2]];
        let alpha = inverse.map(|row| row[0] * total[0] + row[1] * total[1] + row[2] * total[2]);
        let [p, q, r] = turning;
        [
            -0.5 * (x * p + y * q + z * r),
            0.5 * (w * p + y * r - z * q),
            0.5 * (w * q + z * p - x * r),
            0.5 * (w * r + x * q - y * p),
            alpha[0],
            alpha[1],
            alpha[2],
        ]
    };
    let ([w, x, y, z], [a, b, c]) = (start.attitude.quaternion(), start.omega.to_array());
    let mut y = [w, x, y, z, a, b, c];
    let h = (until - start.time) / steps as f64;
    let plus = |y: &[f64; 7], k: &[f64; 7], h: f64| -> [f64; 7] { std::array::from_fn(|i| y[i] + h * k[i]) };
    for n in 0..steps {
        let t = start.time + n as f64 * h;
        let k1 = slope(t, &y);
        let k2 = slope(t + 0.5 * h, &plus(&y, &k1, 0.5 * h));
        let k3 = slope(t + 0.5 * h, &plus(&y, &k2, 0.5 * h));
        let k4 = slope(t + h, &plus(&y, &k3, h));
        for i in 0..7 {
            y[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
    }
    let [w, x, y, z, a, b, c] = y;
    let attitude = Attitude::from_quaternion([w, x, y, z]).unwrap();
    State { time: until, attitude, omega: AngularVelocity::new(a, b, c) }
}

/// Returns I⁻¹, by cofactors.
fn inverse(rotor: &Rotor) -> [[f64; 3]; 3] {
    let unit = |k: usize| AngularVelocity::from_array(std::array::from_fn(|i| f64::from(u8::from(i == k))));
    let [a, b, c] = [0, 1, 2].map(|k| rotor.angular_momentum(unit(k)).to_array());
    let cross = |[a, b, c]: [f64; 3], [x, y, z]: [f64; 3]| [b * z - c * y, c * x - a * z, a * y - b * x];
    let (bc, ca, ab) = (cross(b, c), cross(c, a), cross(a, b));
    let determinant = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
    [bc, ca, ab].map(|row| row.map(|x| x / determinant))
}

#[test]
fn every_torque_moves_a_member_as_the_textbook_does() {
    for (name, rotor, torques) in every_torque() {
        let member = Member::new(rotor, torques, start(3));
        for method in [Method::Auto, Method::Taylor] {
            let found = ensemble(std::slice::from_ref(&member)).at(&[1.0, 2.25], method, 1e-13, ONE).unwrap();
            assert_eq!(found.failures, [], "{name}");
            for state in &found.states {
                // Steps of 1 ms, with an error of about 1e-12.
                let steps = ((state.time - 0.25) / 0.001).round() as usize;
                let error = distance(state, &textbook(&member, state.time, steps));
                assert!(error < 2e-11, "{name}: {error:e} at {} s", state.time);
            }
        }
    }
}

/// Returns members of every kind, with different starts and starting times.
fn some_members(count: usize) -> Vec<Member> {
    let zoo = every_torque();
    (0..count)
        .map(|k| {
            let (_, rotor, torques) = zoo[k * 7 % zoo.len()].clone();
            let mut start = start(k);
            if k % 5 == 0 {
                start.time = -0.125;
            }
            Member::new(rotor, torques, start)
        })
        .collect()
}

#[test]
fn a_member_has_the_bits_that_it_has_alone() {
    let times = [0.25, 0.5, 1.1];
    for (method, tolerance) in [(Method::Auto, 1e-9), (Method::Taylor, 1e-6), (Method::Dop853, 1e-6)] {
        let members = some_members(160);
        let together = ensemble(&members).at(&times, method, tolerance, ONE).unwrap();
        assert_eq!(together.failures, []);
        let wanted = bits(&together.states);
        for threads in [2, 3, 7] {
            let again =
                ensemble(&members).at(&times, method, tolerance, NonZero::new(threads).unwrap()).unwrap();
            assert_eq!(bits(&again.states), wanted);
        }
        for size in [1, 7, 8, 9, 33] {
            for (k, batch) in members.chunks(size).enumerate() {
                let few = ensemble(batch).at(&times, method, tolerance, ONE).unwrap();
                assert_eq!(bits(&few.states), wanted[3 * size * k..][..3 * batch.len()], "{size}");
            }
        }
        // 160 and 37 are coprime.
        let order: Vec<usize> = (0..160).map(|k| k * 37 % 160).collect();
        let shuffled: Vec<_> = order.iter().map(|&k| members[k].clone()).collect();
        let states = ensemble(&shuffled).at(&times, method, tolerance, ONE).unwrap().states;
        for (place, &k) in order.iter().enumerate() {
            assert_eq!(bits(&states[3 * place..][..3]), wanted[3 * k..][..3]);
        }
    }
}

/// Returns the FNV hash of all bits.
fn hash(states: &[State]) -> u64 {
    let bytes = bits(states).into_iter().flatten().flat_map(u64::to_le_bytes);
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

#[test]
fn the_bits_are_those_of_every_machine() {
    // The same with AVX-512 and with AVX2 (`--cfg no_avx512`); different without a fused
    // multiply–add (`--no-default-features`).
    let fused = cfg!(any(target_arch = "aarch64", target_feature = "fma", feature = "simd"));
    let expected = if fused { 11_719_673_269_111_080_085 } else { 17_287_364_926_795_790_716 };
    let members = some_members(160);
    let found = ensemble(&members).at(&[0.5, 1.1], Method::Auto, 1e-12, ONE).unwrap();
    assert_eq!(hash(&found.states), expected);
}

#[test]
fn many_of_a_kind_are_what_each_is() {
    for torque in [0, 3, 9] {
        let (name, rotor, torques) = every_torque()[torque].clone();
        let members: Vec<_> =
            (0..1000).map(|k| Member::new(rotor.clone(), torques.clone(), start(k))).collect();
        let at = |members: &[Member], threads| {
            ensemble(members).at(&[0.75, 2.0], Method::Taylor, 1e-10, NonZero::new(threads).unwrap()).unwrap()
        };
        let all = at(&members, 2);
        for k in [0, 1, 7, 8, 63, 64, 500, 999] {
            assert_eq!(bits(&all.states[2 * k..][..2]), bits(&at(&members[k..=k], 1).states), "{name} {k}");
        }
    }
}

#[test]
fn exact_members_have_the_bits_of_the_closed_form() {
    let times: Vec<f64> = (0..700).map(|k| 0.25 + 0.37 * f64::from(k)).collect();
    let members: Vec<_> = (0..70).map(|k| Member::new(Rotor::free(&body()), vec![], start(k))).collect();
    let all = ensemble(&members);
    // Closed forms are cached from the second call on.
    for (count, threads) in [(700, 1), (700, 2), (700, 1), (5, 1), (4, 2), (1, 1)] {
        let times = &times[..count];
        let threads = NonZero::new(threads).unwrap();
        let found = all.at(times, Method::Auto, 1e-3, threads).unwrap();
        for (member, states) in members.iter().zip(found.states.chunks(count)) {
            let motion = FreeMotion::of(&member.rotor, member.start).unwrap();
            let wanted: Vec<_> = times.iter().map(|&time| motion.at(time)).collect();
            assert_eq!(bits(states), bits(&wanted));
        }
    }
}

#[test]
fn other_members_have_the_bits_of_a_simulation() {
    let times = [0.25, 0.75, 1.5];
    for (name, rotor, torques) in every_torque() {
        let member = Member::new(rotor, torques, start(11));
        for method in [Method::Auto, Method::Taylor, Method::Dop853] {
            let found = ensemble(std::slice::from_ref(&member)).at(&times, method, 1e-11, ONE).unwrap();
            let simulation = Simulation::new(&member.rotor, &member.torques, member.start, &times)
                .method(method)
                .tolerance(1e-11);
            assert_eq!(bits(&found.states), bits(&simulation.states().unwrap()), "{name} {method:?}");
        }
    }
}

#[test]
fn one_that_fails_leaves_the_others_alone() {
    let times = [0.5, 1.0, 1.5];
    for (method, tolerance) in [(Method::Auto, 1e-9), (Method::Dop853, 1e-9)] {
        let mut members = some_members(40);
        let good = ensemble(&members).at(&times, method, tolerance, ONE).unwrap();
        // A wire that is released beyond half a turn from its rest attitude, and a body whose spin
        // overflows.
        let rest = Attitude::identity();
        members[11] = Member::new(
            Rotor::free(&body()),
            vec![TorqueModel::Torsion(Torsion::wire(1e-3, rest, Direction::new(0.0, 0.0, 1.0)).unwrap())],
            State { time: 0.0, attitude: rest, omega: AngularVelocity::new(0.0, 0.0, 5.0) },
        );
        let bad = ensemble(&members).at(&times, method, tolerance, NonZero::new(2).unwrap()).unwrap();
        assert_eq!(bad.failures.len(), 1);
        assert_eq!(bad.failures[0].member, 11);
        assert!(matches!(bad.failures[0].cause, MotionError::HalfTurn { .. }), "{:?}", bad.failures);
        // The wire reaches half a turn after about π/5 s. The first of the times is before that.
        let [known, stuck, same] = bad.states[33..36] else { panic!() };
        assert_eq!(known.time, 0.5);
        assert!(stuck == same && (0.5..0.64).contains(&stuck.time), "{stuck:?}");
        for k in (0..40).filter(|k| *k != 11) {
            assert_eq!(bits(&bad.states[3 * k..][..3]), bits(&good.states[3 * k..][..3]));
        }
    }
}

#[test]
fn rods_keep_their_spin_and_take_no_torque_along_it() {
    let rod = MassProperties::new(
        1.3,
        Position::new(0.6, 0.0, 0.0),
        InertiaTensor::diagonal([0.0, 0.2, 0.2]).unwrap(),
    );
    let rod = rod.unwrap();
    let weight = TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(0.3, -0.4, -1.1) });
    let torque = |x: f64| TorqueModel::Constant(ConstantTorque::Body(Torque::new(x, 0.2, -0.1)));
    let member = |rotor: &Rotor, torques: Vec<TorqueModel>| Member::new(rotor.clone(), torques, start(4));
    let (free, held) = (Rotor::free(&rod), Rotor::pivoted(&rod, Position::ZERO));
    let good = [member(&free, vec![]), member(&held, vec![weight]), member(&free, vec![torque(0.0)])];
    for member in good {
        let one = ensemble(&[member]);
        let truth = one.at(&[1.25], Method::Auto, 1e-13, ONE).unwrap();
        let stepped = one.at(&[1.25], Method::Dop853, 1e-13, ONE).unwrap();
        assert_eq!((&truth.failures, &stepped.failures), (&vec![], &vec![]));
        assert!(distance(&stepped.states[0], &truth.states[0]) < 1e-9);
    }
    let bad = ensemble(&[member(&free, vec![torque(0.01)])]).at(&[1.25], Method::Auto, 1e-9, ONE).unwrap();
    let cause = &bad.failures[0].cause;
    assert!(
        matches!(cause, MotionError::TorqueWithoutInertia { torque, .. } if *torque == 0.01),
        "{cause:?}"
    );
}

#[test]
fn what_runs_away_ends_there() {
    // Negative drag: ω grows as exp(t).
    let matrix = [[-3.0, 0.0, 0.0], [0.0, -4.0, 0.0], [0.0, 0.0, -5.0]];
    let formula = |k: usize| {
        let omega = StateVariables::NAMES.iter().position(|name| *name == ["wx", "wy", "wz"][k]).unwrap();
        Formula::new([
            Instruction::Constant(-matrix[k][k]),
            Instruction::Variable(omega),
            Instruction::Binary(Binary::Multiply),
        ])
        .unwrap()
    };
    let push = TorqueModel::Formula(Box::new(FormulaTorque::Body([formula(0), formula(1), formula(2)])));
    let mut members = some_members(9);
    members[4] = Member::new(Rotor::free(&body()), vec![push], start(4));
    let found = ensemble(&members).at(&[0.5, 300.0, 400.0], Method::Auto, 1e-9, ONE).unwrap();
    let failure = found.failures.iter().find(|failure| failure.member == 4).unwrap();
    assert!(matches!(failure.cause, MotionError::RunAway { .. }), "{failure}");
    assert!(found.states[12].time == 0.5 && found.states[14] == found.states[13]);
    assert!(found.states.iter().all(|state| <[f64; 8]>::from(*state).iter().all(|x| x.is_finite())));
}

#[test]
fn a_closed_form_ends_at_its_reach() {
    let free = |omega: f64| {
        Member::new(
            Rotor::free(&body()),
            Vec::new(),
            State { omega: AngularVelocity::new(omega, 0.1 * omega, -0.2 * omega), ..start(0) },
        )
    };
    let found = ensemble(&[free(1.0), free(1e-9)]).at(&[1.0, 1e20, 1e30, 1e31], Method::Auto, 1e-13, ONE);
    let found = found.unwrap();
    assert_eq!(found.failures.len(), 1);
    assert!(
        matches!(
            found.failures[0],
            MemberFailure { member: 0, cause: MotionError::BeyondReach { time: 1e30, .. } }
        ),
        "{:?}",
        found.failures
    );
    assert!(found.states[2] == found.states[1] && found.states[3] == found.states[1]);
    assert!(found.states[1].time == 1e20 && found.states[7].time == 1e31);
    assert!(found.states.iter().all(|state| <[f64; 8]>::from(*state).iter().all(|x| x.is_finite())));
}

#[test]
fn what_cannot_be_is_refused() {
    let member = |omega: f64| Member {
        start: State { omega: AngularVelocity::new(omega, 0.1, 0.2), ..start(0) },
        ..some_members(1)[0].clone()
    };
    let failure = Ensemble::new(vec![member(1.0), member(f64::NAN)]).unwrap_err();
    assert!(failure.member == 1 && failure.cause.is_parameter(), "{failure}");
    let point = MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([0.0; 3]).unwrap()).unwrap();
    let nothing = Member { rotor: Rotor::free(&point), ..member(1.0) };
    assert_eq!(Ensemble::new(vec![nothing]).unwrap_err().cause, MotionError::NotSpinnable);
    let all = ensemble(&[member(1.0)]);
    for (times, tolerance) in [
        (vec![1.0, 0.5], 1e-9),
        (vec![0.0], 1e-9),
        (vec![f64::NAN], 1e-9),
        (vec![1.0], 1.0),
        (vec![1.0], 0.0),
        (vec![1.0], f64::NAN),
    ] {
        let refused = all.at(&times, Method::Auto, tolerance, ONE);
        assert!(
            matches!(refused, Err(ref error) if error.is_parameter()),
            "{times:?} {tolerance} {refused:?}"
        );
    }
    let endless = all.at(&[1e12], Method::Taylor, 1e-9, ONE).unwrap();
    assert!(matches!(endless.failures[0].cause, MotionError::TooManySteps { .. }));
    assert_eq!(all.at(&[], Method::Auto, 1e-9, ONE).unwrap().states, []);
    let nobody = ensemble(&[]);
    assert!(nobody.is_empty() && nobody.at(&[1.0], Method::Auto, 1e-9, ONE).unwrap().states.is_empty());
    let mut few = [start(0); 3];
    assert!(all.fill(&[1.0], (Method::Auto, 1e-9), ONE, &mut few, &mut |_| true).is_err());
}

#[test]
fn work_tells_how_far_it_is_and_can_be_ended() {
    let all = ensemble(&some_members(300));
    let mut rows = vec![[0.0; 8]; 300];
    let mut told = Vec::new();
    let outcome = all.fill(&[1.0], (Method::Auto, 1e-9), ONE, &mut rows, &mut |done| {
        told.push(done);
        true
    });
    // Some of them have springs that are twisted too far.
    let found = all.at(&[1.0], Method::Auto, 1e-9, ONE).unwrap();
    assert_eq!(outcome.map(|outcome| outcome.failures), Ok(found.failures));
    assert!(told.is_sorted() && told.last() == Some(&300) && told.len() > 4, "{told:?}");
    assert!(found.states.iter().zip(&rows).all(|(state, row)| <[f64; 8]>::from(*state) == *row));
    for threads in [1, 2] {
        let threads = NonZero::new(threads).unwrap();
        let ended = all.fill(&[1.0], (Method::Auto, 1e-9), threads, &mut rows, &mut |done| done < 100);
        assert!(
            matches!(ended, Err(MotionError::Cancelled { done }) if (100..=300).contains(&done)),
            "{ended:?}"
        );
    }
}
