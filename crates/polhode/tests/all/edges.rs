//! Thresholds from both sides, signs and ties, and evidence that must not be zero, each compared
//! with its definition.

use std::f64::consts::{PI, TAU};

use crate::common::free_body;
use polhode::body::Symmetry;
use polhode::motion::{Pendulum, Prescribed, Regime, Swing, TIGHTEST_TOLERANCE};
use polhode::observe::{Cones, SymmetricTop};
use polhode::prelude::*;

pub(super) const TURN: [f64; 4] = [0.4, -0.7, 1.1, 0.3];

/// Returns a body of 2.3 kg with these principal moments and rotated principal axes.
pub(super) fn turned(moments: [f64; 3], q: [f64; 4]) -> MassProperties<Body> {
    let r = Rotation::<Body, Part>::from_quaternion(q).unwrap();
    let inertia = InertiaTensor::<Part>::diagonal(moments).unwrap().in_frame(r);
    MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap()
}

fn state(time: f64, omega: [f64; 3]) -> State {
    let attitude = Attitude::from_quaternion([0.7, 0.2, -0.5, 0.6]).unwrap();
    State { time, attitude, omega: AngularVelocity::from_array(omega) }
}

fn gravity(g: [f64; 3]) -> TorqueModel {
    TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::from_array(g) })
}

/// Returns a heavy top: an asymmetric body held away from its centre of mass.
fn heavy() -> Rotor {
    Rotor::pivoted(&turned([1.3, 2.1, 2.9], TURN), Position::new(-0.4, 0.9, 0.2))
}

pub(super) fn relative(got: f64, want: f64) -> f64 {
    (got / want - 1.0).abs()
}

/// Returns an oblate and a prolate top, spinning in either sense: [`i_axial`, `i_transverse`],
/// rotor and start.
fn tops() -> impl Iterator<Item = ([f64; 2], Rotor, State)> {
    let kinds = [([2.0, 2.0, 3.1], [3.1, 2.0]), ([1.3, 2.9, 2.9], [1.3, 2.9])];
    kinds.into_iter().flat_map(|(moments, pair)| {
        let rotor = Rotor::free(&turned(moments, TURN));
        [[0.7, -1.1, 0.4], [-0.7, 1.1, -0.4], [0.2, 0.9, 1.6]]
            .map(|omega| (pair, rotor.clone(), state(0.0, omega)))
    })
}

fn symmetric_top(rotor: &Rotor, start: State) -> SymmetricTop {
    SymmetricTop::of(rotor.principal(), start).unwrap()
}

#[test]
fn a_symmetric_tops_period_is_one_round_of_its_body_cone() {
    for ([axial, transverse], rotor, start) in tops() {
        let free = FreeRegime::of(&rotor, &start);
        assert_eq!(free.regime, Regime::Symmetric);
        let period = free.period.unwrap();
        let rate = Cones::of(&symmetric_top(&rotor, start)).body_rate;
        assert!(relative(period, TAU / rate.abs()) < 4e-15);
        let axis = if axial > transverse { rotor.principal().axis(2) } else { rotor.principal().axis(0) };
        let by_euler = (axial - transverse) / transverse * axis.dot(start.omega);
        assert!(relative(rate, by_euler) < 4e-15);
        // integrated: after half the period the transverse ω is reversed, but not before
        let times = [0.5 * period, period];
        for method in [Method::Dop853, Method::Taylor] {
            let motion = Trajectory::compute(&rotor, &[], start, &times, method, 1e-14).unwrap();
            let [half, whole] = [0, 1].map(|k| motion.samples()[k].state.omega);
            let along = AngularVelocity::<Body>::from_array((axis * axis.dot(start.omega)).to_array());
            assert!((half - along * 2.0 + start.omega).norm() < 1e-11);
            assert!((whole - start.omega).norm() < 1e-11);
        }
    }
}

#[test]
fn the_cones_have_the_angles_between_the_vectors() {
    for (_, rotor, start) in tops() {
        let top = symmetric_top(&rotor, start);
        let cones = Cones::of(&top);
        let momentum = rotor.angular_momentum(start.omega);
        let axis = if top.spin() < 0.0 { -top.axis() } else { top.axis() };
        for (got, want) in [
            (cones.body_half_angle, start.omega.angle_to(axis)),
            (cones.space_half_angle, start.omega.angle_to(momentum)),
            (cones.nutation, momentum.angle_to(axis)),
        ] {
            assert!(want > 0.05 && relative(got, want) < 1e-14, "{got} {want}");
        }
        assert!(relative(cones.space_rate, momentum.norm() / top.moments()[1]) < 1e-14);
        assert!(
            (top.momentum_direction() - rotor.angular_momentum_space(&start).direction().unwrap()).norm()
                < 1e-15
        );
        // L, ω and e are coplanar, but not for a state of another motion
        assert!(Cones::coplanarity(&top, &FreeMotion::of(&rotor, start).unwrap().at(3.0)) < 1e-15);
        let r = Rotation::<Space, Space>::from_axis_angle(Direction::new(0.3, -2.0, 0.9), 0.8).unwrap();
        let wrong = State { attitude: r * start.attitude, ..start };
        let [e, w, l] = [
            (wrong.attitude * top.axis()).to_array(),
            (wrong.attitude * wrong.omega.direction().unwrap()).to_array(),
            top.momentum_direction().to_array(),
        ];
        let volume = e[0] * (w[1] * l[2] - w[2] * l[1])
            + e[1] * (w[2] * l[0] - w[0] * l[2])
            + e[2] * (w[0] * l[1] - w[1] * l[0]);
        assert!(volume.abs() > 0.01 && relative(Cones::coplanarity(&top, &wrong), volume.abs()) < 1e-12);
    }
}

#[test]
fn rotation_about_the_intermediate_axis_decays_at_its_growth_rate() {
    let rotor = free_body([1.3, 2.1, 2.9]);
    let start = state(0.0, [1e-7, -1.7, 0.0]);
    let rate = FreeRegime::of(&rotor, &start).growth_rate.unwrap();
    let times = [3.0 / rate, 7.0 / rate];
    for method in [Method::Dop853, Method::Taylor] {
        let motion = Trajectory::compute(&rotor, &[], start, &times, method, 1e-15).unwrap();
        // linearised: ω1 = ω1(0) cosh σt
        let [early, late] = [0, 1].map(|k| (motion.samples()[k].state.omega.x / 1e-7).acosh());
        assert!(relative((late - early) / (times[1] - times[0]), rate) < 1e-6);
    }
}

/// Checks every field of a drift by its definition.
fn assert_drift(motion: &Trajectory, at_least: f64) {
    let drift = Drift::of(motion).unwrap();
    let first = motion.start();
    let worst = |f: &dyn Fn(&Sample) -> f64| motion.samples().iter().map(f).fold(0.0, f64::max);
    let (t, l) = (worst(&|s| s.kinetic_energy), worst(&|s| s.momentum.norm()));
    let norm = |s: &Sample| s.momentum.norm();
    let mut fields = vec![
        (drift.kinetic_energy, worst(&|s| (s.kinetic_energy - first.kinetic_energy).abs()) / t),
        (drift.work_energy, worst(&|s| (s.kinetic_energy - first.kinetic_energy - s.work).abs()) / t),
        (drift.momentum, worst(&|s| (s.momentum - first.momentum - s.impulse).norm()) / l),
        (drift.momentum_magnitude, worst(&|s| (norm(s) - norm(first)).abs()) / l),
    ];
    if let (Some(total), Some(u0)) = (drift.total_energy, first.potential_energy) {
        let rise = |s: &Sample| s.potential_energy.unwrap() - u0;
        let departure = worst(&|s| (s.kinetic_energy - first.kinetic_energy + rise(s)).abs());
        fields.push((total, departure / t.max(worst(&|s| rise(s).abs()))));
    }
    for (k, (got, want)) in fields.into_iter().enumerate() {
        assert!(want > at_least && (got - want).abs() < 1e-15, "field {k}: {got:e} {want:e}");
    }
}

#[test]
fn a_loose_solution_drifts_and_says_so() {
    let start = state(0.0, [0.7, -1.1, 0.4]);
    let times: Vec<f64> = (0..=40).map(f64::from).collect();
    let run = |rotor: &Rotor, torques: &[TorqueModel], tolerance| {
        Trajectory::compute(rotor, torques, start, &times, Method::Dop853, tolerance).unwrap()
    };
    let free = Rotor::free(&turned([1.3, 2.1, 2.9], TURN));
    let thrust = [TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.1, -0.3, 0.2)))];
    let wind = [TorqueModel::Constant(ConstantTorque::Space(Torque::new(0.1, -0.3, 0.2)))];
    let weight = [gravity([1.1, -2.2, -8.7])];
    for tolerance in [1e-2, 1e-3] {
        assert_drift(&run(&free, &[], tolerance), 1e-6);
        assert_drift(&run(&free, &thrust, tolerance), 1e-9);
        assert_drift(&run(&free, &wind, tolerance), 1e-9);
        assert_drift(&run(&heavy(), &weight, tolerance), 1e-9);
    }
    // Work equals the change of T, and impulse that of L.
    for (rotor, torques) in [(free.clone(), &thrust[..]), (free, &wind), (heavy(), &weight)] {
        let drift = Drift::of(&run(&rotor, torques, 1e-14)).unwrap();
        assert!(drift.kinetic_energy > 0.1 && drift.momentum_magnitude > 0.1, "{drift:?}");
        assert!(drift.work_energy < 1e-12 && drift.momentum < 1e-12, "{drift:?}");
    }
}

#[test]
fn a_pendulum_started_anywhere_has_the_period_of_its_energy() {
    let pendulum =
        Pendulum::hung(&heavy(), Direction::new(0.2, -0.3, 1.0), Acceleration::new(9.0, 1.0, -3.0)).unwrap();
    let w0 = pendulum.small_frequency();
    let n = 2000;
    for (angle, factor) in [(1.0, 0.5), (-1.0, 0.5), (1.0, -1.3), (2.5, 0.2)] {
        let rate: f64 = factor * w0;
        let Swing::Oscillation { amplitude, period } = pendulum.swing(angle, rate) else { panic!("{angle}") };
        // ½ θ̇² − ω0² cos θ is conserved
        let top = (f64::cos(angle) - 0.5 * factor * factor).acos();
        assert!(relative(amplitude, top) < 1e-14);
        // dt = dθ/θ̇ with θ = top · sin u: smooth and periodic in u
        let by_quadrature: f64 = (0..n)
            .map(|k| {
                let u = TAU * (f64::from(k) + 0.5) / f64::from(n);
                let theta = top * u.sin();
                let rise = 2.0 * (0.5 * (top + theta)).sin() * (0.5 * (top - theta)).sin(); // cos θ − cos top
                top * u.cos().abs() / (2.0 * w0 * w0 * rise).sqrt() * TAU / f64::from(n)
            })
            .sum();
        assert!(relative(period, by_quadrature) < 1e-12, "{angle} {factor}: {period} {by_quadrature}");
    }
    for (angle, factor) in [(1.0, 9.0), (1.0, -2.2), (-2.5, 1.1)] {
        let rate: f64 = factor * w0;
        let Swing::Revolution { period } = pendulum.swing(angle, rate) else { panic!("{angle}") };
        let speed = |theta: f64| (rate * rate + 2.0 * w0 * w0 * (theta.cos() - angle.cos())).sqrt();
        let step = TAU / f64::from(n);
        let by_quadrature: f64 = (0..n).map(|k| step / speed(f64::from(k) * step)).sum();
        assert!(relative(period, by_quadrature) < 1e-12, "{angle} {factor}: {period} {by_quadrature}");
    }
}

#[test]
fn a_pendulums_arm_is_one_or_is_refused() {
    let body = |center| MassProperties::new(2.3, center, InertiaTensor::diagonal([1.3, 2.1, 2.9]).unwrap());
    let z = Direction::new(0.0, 0.0, 1.0);
    let hung = |arm: f64, across: f64| {
        let rotor = Rotor::pivoted(&body(Position::new(arm, 0.0, 1.0)).unwrap(), Position::ZERO);
        Pendulum::hung(&rotor, z, Acceleration::new(9.81 * across, 0.0, 9.81))
    };
    assert!(hung(2e-12, 1.0).is_ok() && hung(1.0, 2e-12).is_ok());
    for refused in
        [hung(0.5e-12, 1.0), hung(1.0, 0.5e-12), hung(0.0, 1.0), hung(1.0, 0.0), hung(1.0, f64::NAN)]
    {
        assert!(matches!(refused, Err(ref error) if error.is_parameter()), "{refused:?}");
    }
    for axis in [Direction::ZERO, Direction::new(f64::NAN, 0.0, 1.0)] {
        assert!(Pendulum::hung(&heavy(), axis, Acceleration::new(9.0, 1.0, -3.0)).is_err());
    }
}

#[test]
fn a_motion_does_not_depend_on_when_it_starts() {
    let weight = [gravity([1.1, -2.2, -8.7])];
    let symmetric = Rotor::free(&turned([2.0, 2.0, 3.1], TURN));
    let generic = [0.7, -1.1, 0.4];
    let axis = symmetric.principal().axis(2).to_array().map(|c| 1.9 * c);
    let free = Rotor::free(&turned([1.3, 2.1, 2.9], TURN));
    for (rotor, torques, omega) in [
        (symmetric.clone(), &[][..], generic),
        (symmetric, &[], axis),
        (free, &[], generic),
        (heavy(), &weight, generic),
    ] {
        let run = |time: f64| {
            let times = [0.0, 0.4, 1.9, 6.3].map(|t| time + t);
            Trajectory::compute(&rotor, torques, state(time, omega), &times, Method::Auto, 1e-14).unwrap()
        };
        let (early, late) = (run(0.0), run(7.3));
        assert_eq!(early.solution().name(), late.solution().name());
        assert_eq!(late.samples()[0].state, state(7.3, omega));
        for (a, b) in early.samples().iter().zip(late.samples()) {
            assert_eq!(b.state.time, 7.3 + a.state.time);
            assert!(a.state.attitude.angle_to(b.state.attitude) < 1e-12);
            assert!((a.state.omega - b.state.omega).norm() < 1e-12);
            assert!((a.work - b.work).abs() < 1e-11 && (a.impulse - b.impulse).norm() < 1e-11);
        }
    }
}

#[test]
fn two_weights_are_their_sum() {
    let two = [gravity([1.1, -2.2, -8.7]), gravity([-0.4, 0.9, 2.3])];
    let sum = [gravity([1.1 - 0.4, -2.2 + 0.9, -8.7 + 2.3])];
    let run = |torques: &[TorqueModel]| {
        let start = state(0.0, [0.7, -1.1, 0.4]);
        Trajectory::compute(&heavy(), torques, start, &[0.0, 1.7], Method::Auto, 1e-14).unwrap()
    };
    for (a, b) in run(&two).samples().iter().zip(run(&sum).samples()) {
        let (u, v) = (a.potential_energy.unwrap(), b.potential_energy.unwrap());
        assert!(v.abs() > 0.1 && (u - v).abs() < 1e-11, "{u} {v}");
        assert!(b.torque.norm() > 0.1 && (a.torque - b.torque).norm() < 1e-11);
    }
}

#[test]
fn quaternions_stay_on_their_side_from_sample_to_sample() {
    // 0.8 turns between samples: the quaternion of the half angle changes its hemisphere each time
    let start = state(0.0, [0.05, 0.02, 3.0]);
    let shaft = Prescribed::fixed_axis(start.attitude, Direction::new(1.0, -2.0, 0.5), 3.0, 0.0).unwrap();
    let coin = Prescribed::euler_rates([0.4, 0.9, -1.2], [3.0, 0.01, 0.02]).unwrap();
    let times: Vec<f64> = (0..20).map(|k| 0.8 * TAU / 3.0 * f64::from(k)).collect();
    let mut motions = vec![];
    for given in [shaft, coin] {
        motions.push(Trajectory::prescribed(&heavy(), &given, &times).unwrap());
    }
    for moments in [[1.3, 2.1, 2.9], [2.0, 2.0, 3.1]] {
        let motion =
            Trajectory::compute(&free_body(moments), &[], start, &times, Method::Auto, 1e-12).unwrap();
        motions.push(motion);
    }
    for motion in motions {
        for pair in motion.samples().windows(2) {
            let [p, q] = [pair[0], pair[1]].map(|s| s.state.attitude.quaternion());
            let cosine: f64 = p.iter().zip(q).map(|(a, b)| a * b).sum();
            assert!(cosine > 0.5, "{cosine}");
        }
    }
}

#[test]
fn attitudes_on_the_edge_of_their_charts() {
    let q = |wxyz| Attitude::from_quaternion(wxyz).unwrap();
    for [x, y] in [[0.6, 0.8], [0.6, -0.8], [-0.6, 0.8], [-0.8, -0.6], [1.0, 0.0], [0.0, 1.0], [0.0, -1.0]] {
        let r = q([0.0, x, y, 0.0]);
        let [phi, theta, psi] = r.euler313();
        assert_eq!([theta, psi], [PI, 0.0]);
        assert!(phi > -PI && phi <= PI);
        assert!(Attitude::from_euler313([phi, theta, psi]).unwrap().angle_to(r) < 1e-15);
    }
    // the first nonzero component is positive
    for (given, canonical) in [
        ([-0.6, 0.0, 0.8, 0.0], [0.6, 0.0, -0.8, 0.0]),
        ([0.0, -0.6, 0.8, 0.0], [0.0, 0.6, -0.8, 0.0]),
        ([0.0, 0.0, -0.6, 0.8], [0.0, 0.0, 0.6, -0.8]),
        ([0.0, 0.0, 0.0, -1.0], [0.0, 0.0, 0.0, 1.0]),
        ([-0.0, 0.6, -0.8, 0.0], [0.0, 0.6, -0.8, 0.0]),
    ] {
        for (got, want) in q(given).canonical_quaternion().into_iter().zip(canonical) {
            assert!((got - want).abs() < 1e-15, "{given:?}: {got} {want}");
        }
    }
    // the deviation of RᵀR is 2d for a changed diagonal element, and d for an off-diagonal one
    let matrix = |i: usize, j: usize, d: f64| {
        let mut m = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        m[i][j] += d;
        Attitude::from_matrix(m)
    };
    for sign in [1.0, -1.0] {
        assert!(matrix(1, 1, sign * 0.48e-7).is_ok() && matrix(1, 1, sign * 0.52e-7).is_err());
        assert!(matrix(0, 2, sign * 0.98e-7).is_ok() && matrix(0, 2, sign * 1.02e-7).is_err());
        assert!(matrix(1, 0, sign * 0.98e-7).is_ok() && matrix(1, 0, sign * 1.02e-7).is_err());
    }
}

#[test]
fn an_axis_need_not_be_a_unit_vector() {
    let rows = [[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]];
    let tensor = InertiaTensor::<Body>::from_matrix(rows).unwrap();
    let n = [2.1, -14.0, 6.3];
    let (mut sum, n2) = (0.0, n.iter().map(|c| c * c).sum::<f64>());
    for (i, row) in rows.iter().enumerate() {
        for (j, element) in row.iter().enumerate() {
            sum += n[i] * element * n[j] / n2;
        }
    }
    let about = |n| tensor.about_axis(Direction::from_array(n));
    assert!(relative(about(n), sum) < 1e-15 && relative(about(n.map(|c| -1e-200 * c)), sum) < 1e-15);
}

/// Returns `Σ i_k n_k n_kᵀ` with rounding noise of a few ε on every element; `k` selects the
/// sample.
fn noisy(axes: [[f64; 3]; 3], moments: [f64; 3], k: u32) -> PrincipalFrame<Body> {
    let element = |i: usize, j: usize| {
        let exact: f64 = (0..3).map(|n| moments[n] * axes[n][i] * axes[n][j]).sum();
        let (low, high) = (i.min(j) as u32, i.max(j) as u32);
        let noise = f64::from((7 * k + 5 * low + 11 * high + k * low * high) % 9) - 4.0;
        exact + noise * 2e-16
    };
    let rows = std::array::from_fn(|i| std::array::from_fn(|j| element(i, j)));
    PrincipalFrame::of(&InertiaTensor::from_matrix(rows).unwrap())
}

#[test]
fn rounding_does_not_choose_between_tied_components() {
    let (h, t, s) = (0.5_f64.sqrt(), 3_f64.sqrt().recip(), 6_f64.sqrt().recip());
    let z = [0.0, 0.0, 1.0];
    for k in 0..60 {
        // axis 1 along ±(1, −1, 0), axis 2 along ±(1, 1, 0): the first component is positive
        let p = noisy([[h, -h, 0.0], [h, h, 0.0], z], [1.3, 2.1, 2.9], k);
        assert!((p.axis(0) - Direction::new(h, -h, 0.0)).norm() < 1e-14, "{k}: {:?}", p.axis(0));
        assert!((p.axis(1) - Direction::new(h, h, 0.0)).norm() < 1e-14, "{k}: {:?}", p.axis(1));
        let p = noisy([[t, -t, -t], [2.0 * s, s, s], [0.0, h, -h]], [1.3, 2.1, 2.9], k);
        assert!((p.axis(0) - Direction::new(t, -t, -t)).norm() < 1e-14, "{k}: {:?}", p.axis(0));
    }
    // The axis of an oblate body is equally close to two or three body axes: the last one is left
    // out.
    let flat = |n: [f64; 3], k: u32| {
        let noise = |c: usize| 1e-15 * (f64::from((3 * k + 5 * c as u32) % 7) - 3.0);
        let n =
            Direction::<Part>::new(n[0] + noise(0), n[1] + noise(1), n[2] + noise(2)).direction().unwrap();
        let about = n.cross(Direction::new(0.0, 0.0, 1.0));
        let r = Rotation::<Part, Part>::from_axis_angle(
            -about,
            n.angle_to(Direction::<Part>::new(0.0, 0.0, 1.0)),
        )
        .unwrap();
        let body = InertiaTensor::<Part>::diagonal([1.3, 1.3, 2.1]).unwrap().in_frame(r);
        let p = PrincipalFrame::of(&body);
        assert_eq!(p.symmetry(), Symmetry::Oblate);
        assert!((p.axis(2).dot(n).abs() - 1.0).abs() < 1e-14);
        p.axes()
    };
    for n in [[t, t, t], [0.1, 0.7, 0.7], [0.7, 0.1, 0.7], [0.7, 0.7, 0.1]] {
        let first = flat(n, 0);
        for k in 1..40 {
            for (a, b) in flat(n, k).into_iter().zip(first) {
                assert!((a - b).norm() < 1e-12, "{n:?} {k}: {a:?} {b:?}");
            }
        }
    }
}

#[test]
fn free_axes_are_the_nearest_to_the_bodys_own() {
    for n in [[0.2, 0.3, 0.93], [0.25, 0.9, -0.2], [-0.2, -0.8, 0.3], [0.9, 0.2, 0.3], [-0.8, 0.1, -0.3]] {
        let n = Direction::<Body>::from_array(n).direction().unwrap();
        let z = Direction::new(0.0, 0.0, 1.0);
        let r = Rotation::<Body, Body>::from_axis_angle(z.cross(n), z.angle_to(n)).unwrap();
        let tensor = |moments| InertiaTensor::<Body>::diagonal(moments).unwrap().in_frame(r);
        let flat = PrincipalFrame::of(&tensor([1.3, 1.3, 2.1]));
        let long = PrincipalFrame::of(&tensor([2.1, 2.1, 1.3]));
        let along = n.to_array().map(f64::abs);
        let out = (0..3).fold(0, |best, k| if along[k] > along[best] { k } else { best });
        let (a, b) = ([1, 0, 0][out], [2, 2, 1][out]);
        // axes named by the body axis they are near; u · a + v · b over all rotations of the pair
        // in its plane
        let nearness = |u: Direction<Body>, v: Direction<Body>| u.to_array()[a].abs() + v.to_array()[b].abs();
        let [u, v, _] = flat.axes();
        let best = (0..3600)
            .map(|k| {
                let (s, c) = (f64::from(k) * 1e-3 * TAU / 3.6).sin_cos();
                nearness(u * c + v * s, v * c - u * s)
            })
            .fold(0.0, f64::max);
        assert!(nearness(u, v) > best - 1e-12, "{n:?}: {} {best}", nearness(u, v));
        // the same for a prolate body
        let [_, v, w] = long.axes();
        assert!((v - u).norm() < 1e-14 && w.dot(flat.axis(1)).abs() > 1.0 - 1e-14);
    }
}

#[test]
fn no_torque_spins_a_rod_about_its_line() {
    let rod = free_body([0.0, 1.2, 1.2]);
    let alpha = rod.acceleration(AngularVelocity::new(0.9, -0.4, 0.7), Torque::new(0.3, 0.6, -1.1));
    // the torque along the rod has no effect; about a line without inertia ω × Iω = i (ω3, −ω2) ω1
    assert_eq!(alpha.x, 0.0);
    assert!(
        (alpha.y - (0.5 + 0.7 * 0.9)).abs() < 1e-15 && (alpha.z - (-1.1 / 1.2 + 0.4 * 0.9)).abs() < 1e-15
    );
    for line in [[0.3, -0.5, 0.8], [-1.0, 0.2, 0.1], [0.577, 0.577, 0.577]] {
        let line = Direction::<Body>::from_array(line).direction().unwrap();
        let rotor = Rotor::free(&dumbbell(line));
        let across = line.cross(Direction::new(0.4, 0.9, -0.3));
        let torque = Torque::<Body>::from_array(across.to_array());
        let alpha = rotor.acceleration(AngularVelocity::new(0.9, -0.4, 0.7), torque);
        assert!(alpha.norm() > 0.1 && line.dot(alpha).abs() < 1e-15 * alpha.norm());
    }
}

/// Returns masses of 0.8 kg and 1.3 kg on a line through a generic point.
fn dumbbell(line: Direction<Body>) -> MassProperties<Body> {
    let at = |x: f64| Position::new(0.3, -0.2, 0.7) + Position::from_array((line * x).to_array());
    let masses = [(0.8, 0.4), (1.3, 1.1)].map(|(m, x)| Particle::new(m, at(x)).unwrap());
    mass_properties_of_particles(&masses).unwrap()
}

#[test]
fn dumbbells_hang_and_swing_in_any_direction() {
    for line in
        [[0.3, -0.5, 0.8], [-1.0, 0.2, 0.1], [0.577, 0.577, 0.577], [0.1, 1.0, -1e-3], [0.0, 0.6, -0.8]]
    {
        let line = Direction::<Body>::from_array(line).direction().unwrap();
        let rotor = Rotor::pivoted(&dumbbell(line), Position::new(0.3, -0.2, 0.7));
        assert_eq!(rotor.principal().symmetry(), Symmetry::Rod);
        let weight = [gravity(line.to_array().map(|c| 9.81 * c))];
        let axis = line.cross(Direction::new(0.4, 0.9, -0.3));
        // T = 2π √(i/Mgd) with i = Σ m x², Md = Σ m x
        let period = TAU * ((0.8 * 0.16 + 1.3 * 1.21) / (9.81 * (0.8 * 0.4 + 1.3 * 1.1_f64))).sqrt();
        for angle in [0.0, 1e-6, 0.3] {
            let attitude = Rotation::from_axis_angle(Direction::from_array(axis.to_array()), angle).unwrap();
            let start = State { time: 0.0, attitude, omega: AngularVelocity::ZERO };
            let times: Vec<f64> = (0..=32).map(|k| 0.25 * period * f64::from(k)).collect();
            let motion = Trajectory::compute(&rotor, &weight, start, &times, Method::Auto, 1e-13).unwrap();
            for (k, sample) in motion.samples().iter().enumerate() {
                let spin = line.dot(sample.state.omega).abs();
                assert!(spin < 1e-15, "{line:?} {angle}: spin {spin:e}");
                if angle < 0.1 && k % 2 == 0 {
                    let side = if k % 4 == 0 { angle } else { -angle };
                    let want =
                        Rotation::from_axis_angle(Direction::from_array(axis.to_array()), side).unwrap();
                    let off = sample.state.attitude.angle_to(want);
                    assert!(off < 1e-13, "{line:?} {angle} sample {k}: {off:e}");
                }
            }
            let drift = Drift::of(&motion).unwrap();
            if angle > 0.1 {
                assert!(drift.work_energy < 1e-11 && drift.momentum < 1e-11, "{line:?} {angle}: {drift:?}");
            }
        }
    }
}

#[test]
fn the_carried_rounding_keeps_long_runs() {
    let rotor = free_body([1.0, 2.0, 3.0]);
    let start = state(0.0, [0.3, 0.5, 0.9]);
    let motion =
        Trajectory::compute(&rotor, &[], start, &[1600.0], Method::Dop853, TIGHTEST_TOLERANCE).unwrap();
    let statistics = motion.solution().statistics().unwrap();
    let drift = Drift::of(&motion).unwrap();
    assert!(statistics.accepted > 20_000);
    assert!(
        drift.momentum_magnitude < 2e-14 && drift.kinetic_energy < 5e-14 && drift.momentum < 2e-14,
        "{drift:?}"
    );
}

#[test]
fn numbers_that_are_not_are_refused() {
    let tensor = InertiaTensor::<Body>::diagonal([1.3, 2.1, 2.9]).unwrap();
    let rotor = free_body([1.3, 2.1, 2.9]);
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(MassProperties::new(value, Position::ZERO, tensor).is_err());
        assert!(MassProperties::new(1.0, Position::new(0.0, value, 0.0), tensor).is_err());
        assert!(InertiaTensor::<Body>::diagonal([1.0, value, 1.0]).is_err());
        assert!(InertiaTensor::<Body>::with_positive_products([1.0; 3], [0.0, 0.0, value]).is_err());
        assert!(Attitude::from_euler313([0.1, value, 0.2]).is_err());
        assert!(Attitude::from_axis_angle(Direction::new(0.0, value, 0.0), 1.0).is_err());
        let axis = Direction::new(0.0, 0.0, 1.0);
        assert!(Prescribed::fixed_axis(Attitude::identity(), axis, value, 0.0).is_err());
        assert!(Prescribed::fixed_axis(Attitude::identity(), axis, 0.0, value).is_err());
        assert!(Prescribed::euler_rates([0.0, value, 0.0], [0.0; 3]).is_err());
        for method in [Method::Auto, Method::Dop853, Method::Taylor] {
            let start = state(0.0, [0.3, value, 0.9]);
            assert!(Trajectory::compute(&rotor, &[], start, &[1.0], method, 1e-9).is_err());
            let start = state(0.0, [0.3, 0.5, 0.9]);
            assert!(Trajectory::compute(&rotor, &[], start, &[value], method, 1e-9).is_err());
        }
    }
    assert!(MassProperties::new(-1.0, Position::ZERO, tensor).is_err());
    assert!(MassProperties::new(0.0, Position::ZERO, tensor).is_err());
    let before = Trajectory::compute(&rotor, &[], state(7.3, [0.3, 0.5, 0.9]), &[7.2], Method::Auto, 1e-9);
    assert!(matches!(before, Err(ref error) if error.is_parameter()));
}
