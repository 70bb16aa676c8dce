//! Axes, edges and air, compared with motions integrated here from Newton's and Euler's equations
//! with constraint forces.

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use polhode::math::{Body, Direction, Position, Rotation, Space};

use super::motions::{TRUTH, numbers};
use crate::decomposition::lu;
use crate::swing::family::{Amplitudes, Family};
use crate::swing::*;

const G: f64 = 9.80665;
const AIR: [f64; 2] = [2.3e-3, 0.041];
const PIVOT: [f64; 3] = [0.11, 0.02, 0.23];

/// Returns the library's period of the generic body in air at an amplitude, s.
fn period(rig: Rig, amplitude: f64) -> f64 {
    let nothing = Measurement::Counted(Counted::new(1.0, (1.0, 0.1), [0.1; 2], 0.1));
    let mut test = SwingTest::new("one", Placement::AS_IT_IS, rig, nothing);
    test.air = Air { moment: AIR[0].into(), displaced: AIR[1].into() };
    let oscillator = test.oscillator(&numbers(&TRUTH)).unwrap();
    let (family, _) = Family::new(oscillator.as_ref(), &Amplitudes::up_to(1.1 * amplitude), &[]).unwrap();
    core::f64::consts::TAU / family.rate(&family.at(amplitude)).value
}

fn inertia() -> Matrix3<f64> {
    let t = &TRUTH;
    Matrix3::new(t[4], t[7], t[8], t[7], t[5], t[9], t[8], t[9], t[6])
}

/// Returns the distance of a state from its start after a time, integrated with classical
/// Runge–Kutta steps.
fn departure(begin: &DVector<f64>, time: f64, slope: impl Fn(&DVector<f64>) -> DVector<f64>) -> f64 {
    const STEPS: u32 = 4000;
    let h = time / f64::from(STEPS);
    let mut s = begin.clone();
    for _ in 0..STEPS {
        let a = slope(&s);
        let b = slope(&(&s + &a * (0.5 * h)));
        let c = slope(&(&s + &b * (0.5 * h)));
        let d = slope(&(&s + &c * h));
        s += (a + b * 2.0 + c * 2.0 + d) * (h / 6.0);
    }
    (s - begin).norm()
}

/// Motion in three dimensions along body axes: θ about n and the rate w. A force holds the pivot,
/// and a torque across n restricts rotation to n.
#[test]
fn a_body_about_a_held_axis() {
    let n = Vector3::new(0.3, 0.9, -0.2).normalize();
    let e1 = n.cross(&Vector3::x()).normalize();
    let e2 = n.cross(&e1);
    let mass = TRUTH[0];
    let lever = Vector3::from(PIVOT) - Vector3::new(TRUTH[1], TRUTH[2], TRUTH[3]);
    let heavy = inertia() + n * n.transpose() * AIR[0];
    for (is_level, stiffness, amplitude) in [(true, 0.0, 1.3), (true, 1.7, 0.8), (false, 1.7, 0.9)] {
        // At rest the centre is at its lowest position.
        let rest = (lever - n * n.dot(&lever)).normalize();
        let slope = |s: &DVector<f64>| {
            let (angle, w) = (s[0], Vector3::new(s[1], s[2], s[3]));
            // The upward direction at this angle, body axes.
            let up = if is_level { rest * angle.cos() - n.cross(&rest) * angle.sin() } else { n };
            // Unknowns: v̇, ẇ, force, torque across n.
            let mut a = DMatrix::zeros(11, 11);
            let mut b = DVector::zeros(11);
            let cross = lever.cross_matrix();
            a.view_mut((0, 0), (3, 3)).copy_from(&(Matrix3::identity() * mass));
            a.view_mut((0, 6), (3, 3)).copy_from(&-Matrix3::identity());
            b.rows_mut(0, 3).copy_from(&(up * (-(mass - AIR[1]) * G)));
            a.view_mut((3, 3), (3, 3)).copy_from(&heavy);
            a.view_mut((3, 6), (3, 3)).copy_from(&-cross);
            a.view_mut((3, 9), (3, 1)).copy_from(&-e1);
            a.view_mut((3, 10), (3, 1)).copy_from(&-e2);
            b.rows_mut(3, 3).copy_from(&(n * (-stiffness * angle) - w.cross(&(heavy * w))));
            // The pivot does not move.
            a.view_mut((6, 0), (3, 3)).copy_from(&Matrix3::identity());
            a.view_mut((6, 3), (3, 3)).copy_from(&-cross);
            b.rows_mut(6, 3).copy_from(&-w.cross(&w.cross(&lever)));
            a.view_mut((9, 3), (1, 3)).copy_from(&e1.transpose());
            a.view_mut((10, 3), (1, 3)).copy_from(&e2.transpose());
            let x = lu("a test matrix", a).unwrap().solve(&b).unwrap();
            DVector::from_vec(vec![n.dot(&w), x[3], x[4], x[5]])
        };
        let direction = Direction::new(n.x, n.y, n.z);
        let axis = match is_level {
            true => Axis::level(PIVOT, direction).with_stiffness(stiffness),
            false => Axis::upright(PIVOT, direction, stiffness),
        };
        let begin = DVector::from_vec(vec![amplitude, 0.0, 0.0, 0.0]);
        let off = departure(&begin, period(Rig::Axis(axis), amplitude), slope);
        assert!(off < 1e-9, "{is_level} {stiffness}: {off}");
    }
}

/// Motion in the plane normal to the axis: centre of mass and angle, with the force at the line of
/// contact.
#[test]
fn an_edge_that_rolls() {
    let n = Vector3::new(0.3, 0.9, -0.2).normalize();
    let lever = Vector3::from(PIVOT) - Vector3::new(TRUTH[1], TRUTH[2], TRUTH[3]);
    let below = (lever - n * n.dot(&lever)).norm();
    let (mass, moment) = (TRUTH[0], n.dot(&(inertia() * n)) + AIR[0]);
    for (radius, amplitude) in [(0.004, 0.5), (0.06, 1.2)] {
        let h = below + radius;
        let slope = |s: &DVector<f64>| {
            let (angle, rate) = (s[0], s[1]);
            // Vector from the centre of mass to the centre of the edge; the line of contact lies
            // below it.
            let (x, y) = (-h * angle.sin(), h * angle.cos());
            let a = DMatrix::from_row_slice(
                5,
                5,
                &[
                    mass,
                    0.0,
                    0.0,
                    -1.0,
                    0.0, //
                    0.0,
                    mass,
                    0.0,
                    0.0,
                    -1.0, //
                    0.0,
                    0.0,
                    moment,
                    y - radius,
                    -x, //
                    // The centre of the edge moves horizontally by −radius × angle.
                    1.0,
                    0.0,
                    -y + radius,
                    0.0,
                    0.0, //
                    0.0,
                    1.0,
                    x,
                    0.0,
                    0.0,
                ],
            );
            let square = rate * rate;
            let b = DVector::from_vec(vec![0.0, -(mass - AIR[1]) * G, 0.0, square * x, square * y]);
            DVector::from_vec(vec![rate, lu("a test matrix", a).unwrap().solve(&b).unwrap()[2]])
        };
        let rig = Rig::Axis(Axis::level(PIVOT, Direction::new(n.x, n.y, n.z)).with_edge(radius));
        let off = departure(&DVector::from_vec(vec![amplitude, 0.0]), period(rig, amplitude), slope);
        assert!(off < 1e-9, "{radius}: {off}");
    }
}

#[test]
fn a_body_that_would_turn_over_is_refused() {
    // Three wires that spread upwards, or converge.
    let on = |above: f64, below: f64, high: f64| {
        let mut plan = SwingPlan::new(Measured::exact(2.0), [0.0, 0.0, high].map(Measured::exact));
        let rig = Rig::Wires(Wires::trifilar(above, below, 0.9));
        let mut counted = Counted::new(20.0, (25.0, 0.05), [0.1; 2], 0.01);
        counted.damping = Damping::None;
        plan.add(SwingTest::new("platform", Placement::AS_IT_IS, rig, Measurement::Counted(counted)));
        identify_swings(&plan)
    };
    for (above, below, high) in [(0.17, 0.15, 0.05), (0.15, 0.15, 0.4), (0.15, 0.17, -0.1)] {
        assert!(on(above, below, high).is_ok(), "{above} {below} {high}");
    }
    for (above, below, high) in [(0.25, 0.15, 4.0), (0.05, 0.17, 2.0)] {
        let error = on(above, below, high).unwrap_err().to_string();
        assert!(
            error.contains("its centre of mass is too high for these wires"),
            "{above} {below} {high}: {error}"
        );
    }
    // One wire attached below the centre.
    let mut plan = SwingPlan::new(Measured::exact(2.0), [0.0, 0.0, 0.1].map(Measured::exact));
    let mut counted = Counted::new(20.0, (25.0, 0.05), [0.1; 2], 0.01);
    counted.damping = Damping::None;
    let rig = Rig::Wires(Wires::torsion([0.0; 3], 0.9, 0.4));
    plan.add(SwingTest::new("one", Placement::AS_IT_IS, rig, Measurement::Counted(counted)));
    let error = identify_swings(&plan).unwrap_err().to_string();
    assert!(error.contains("too high") || error.contains("cosine"), "{error}");
}

/// Small swings. The formula is slightly inaccurate for a body that does not swing about a
/// principal axis.
#[test]
fn rods_on_wires_are_found() {
    let size = 0.0127;
    let mut plan = SwingPlan::new(Measured::exact(1.7), [0.0; 3].map(Measured::exact));
    // The rod is along x. Each test rotates the body; rows are the rig's axes in the body.
    let c = core::f64::consts::FRAC_1_SQRT_2;
    for (rows, radius) in [
        ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], 0.15),
        ([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]], 0.15),
        ([[1.0, 0.0, 0.0], [0.0, c, -c], [0.0, c, c]], 0.15),
        ([[c, c, 0.0], [0.0, 0.0, -1.0], [-c, c, 0.0]], 0.1),
        ([[c, 0.0, c], [0.0, 1.0, 0.0], [-c, 0.0, c]], 0.1),
        ([[0.6, 0.0, -0.8], [0.0, 1.0, 0.0], [0.8, 0.0, 0.6]], 0.1),
        // Swing about the rod itself.
        ([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]], 0.05),
    ] {
        let up = rows[2];
        let moment = size * (1.0 - up[0] * up[0]) + 6e-7;
        let length = 2.0;
        let time = 20.0 * core::f64::consts::TAU * (moment * length / (1.7 * G)).sqrt() / radius;
        let rotation: Rotation<Space, Body> = Rotation::from_matrix(rows).unwrap();
        // Suspended 40 mm below the wires.
        let placement = Placement { rotation, origin: Position::new(0.0, 0.0, -0.04) };
        let mut counted = Counted::new(20.0, (time, 0.02), [0.05; 2], 0.01);
        counted.damping = Damping::None;
        let rig = Rig::Wires(Wires::bifilar(radius, radius, length));
        plan.add(SwingTest::new(format!("{up:?}"), placement, rig, Measurement::Counted(counted)));
    }
    let found = identify_swings(&plan).unwrap();
    let truth = [0.0, size, size, 0.0, 0.0, 0.0];
    for (number, truth) in found.estimate.numbers[4..10].iter().zip(truth) {
        assert!((number.value - truth).abs() < 3.0 * number.sd.unwrap(), "{number:?} {truth}");
    }
}
