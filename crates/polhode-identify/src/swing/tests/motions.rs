//! Motions compared with exact integration and with closed forms.

use nalgebra::{Matrix3, Quaternion, Vector3};
use polhode::math::elliptic::EllipticParameter;
use polhode::math::{Direction, Position};

use super::exact::{Hanging, State};
use crate::swing::family::{Amplitudes, Family};
use crate::swing::hung_mass::{HungMass, Placement};
use crate::swing::number::{Numbers, Point};
use crate::swing::rig::{Axis, Load, Oscillator, Rig, Wire, Wires};

const G: f64 = 9.80665;

/// Generic values: mass, centre, tensor, gravity.
pub(super) const TRUTH: [f64; 11] =
    [3.2, 0.013, -0.008, 0.021, 0.041, 0.056, 0.071, 0.0043, -0.0061, 0.0052, G];

pub(super) fn numbers(values: &[f64]) -> Numbers {
    let places: Vec<_> = (0..values.len()).map(Some).collect();
    Numbers::new(values, &places)
}

pub(super) fn oscillator(rig: &Rig, numbers: &Numbers) -> Box<dyn Oscillator> {
    let mass = HungMass::of_body(numbers, &Placement::AS_IT_IS);
    let weight = mass.mass.times(numbers.at(10));
    rig.oscillator(numbers, &Load { mass, weight }).unwrap()
}

fn unequal() -> Vec<Wire> {
    let wire = |top: [f64; 3], bottom: [f64; 3], length: f64| Wire {
        top: Point::from(top),
        bottom: Point::from(bottom),
        length: length.into(),
    };
    vec![
        wire([0.21, 0.01, 0.0], [0.20, 0.0, 0.06], 0.83),
        wire([-0.17, 0.02, 0.012], [-0.19, 0.015, 0.05], 0.85),
    ]
}

fn three() -> Vec<Wire> {
    let mut all = unequal();
    all[0] = Wire { top: [0.16, -0.13, 0.0].into(), bottom: [0.17, -0.12, 0.04].into(), length: 0.84.into() };
    all[1] =
        Wire { top: [-0.17, -0.11, 0.012].into(), bottom: [-0.18, -0.10, 0.05].into(), length: 0.855.into() };
    all.push(Wire { top: [0.02, 0.22, 0.0].into(), bottom: [0.01, 0.19, 0.055].into(), length: 0.85.into() });
    all
}

fn hanging(wires: &[([f64; 3], [f64; 3])], stiffness: f64) -> Hanging {
    let t = &TRUTH;
    let center = Vector3::new(t[1], t[2], t[3]);
    Hanging {
        mass: t[0],
        inertia: Matrix3::new(t[4], t[7], t[8], t[7], t[5], t[9], t[8], t[9], t[6]),
        gravity: G,
        stiffness,
        wires: wires.iter().map(|(a, b)| (Vector3::from(*a), Vector3::from(*b) - center)).collect(),
        viscous: 0.0,
        quadratic: 0.0,
    }
}

fn coordinates(wires: &[Wire]) -> Vec<([f64; 3], [f64; 3])> {
    let numbers = numbers(&TRUTH);
    let at = |point: &Point| numbers.point(point).map(|c| c.value);
    wires.iter().map(|wire| (at(&wire.top), at(&wire.bottom))).collect()
}

/// Returns the state at a turning point.
fn turning(u: &[f64]) -> State {
    State {
        p: Vector3::new(u[0], u[1], u[2]),
        e: Quaternion::new(u[3], u[4], u[5], u[6]),
        v: Vector3::zeros(),
        w: Vector3::zeros(),
    }
}

/// Returns the distance of the exact motion from its start after one period.
fn departure(wires: Vec<Wire>, stiffness: f64, amplitude: f64) -> f64 {
    let exact = hanging(&coordinates(&wires), stiffness);
    let rig = Rig::Wires(Wires { wires, stiffness: stiffness.into() });
    let oscillator = oscillator(&rig, &numbers(&TRUTH));
    let amplitudes = Amplitudes::up_to(amplitude / 0.999_9);
    let (family, motions) = Family::new(oscillator.as_ref(), &amplitudes, &[]).unwrap();
    let last = motions.last().unwrap();
    let start: Vec<f64> = last.u.row(0).iter().copied().collect();
    let begin = turning(&start);
    // The motion's amplitude is that of the largest node.
    let end = turning(&last.u.row(last.u.nrows() - 1).iter().copied().collect::<Vec<f64>>());
    let own = 0.5 * (begin.twist() - end.twist());
    let rate = family.rate(&family.at(own)).value;
    assert!((rate / last.rate - 1.0).abs() < 1e-12, "{rate} {}", last.rate);
    let steps = 4000;
    let h = core::f64::consts::TAU / rate / f64::from(steps);
    let mut state = begin;
    for _ in 0..steps {
        state = exact.step(&state, h);
    }
    let off = (state.p - begin.p).norm() + (state.e - begin.e).norm();
    let speed = state.v.norm() + state.w.norm();
    off + speed / rate
}

#[test]
fn the_exact_motion_comes_back_after_the_period() {
    for (wires, stiffness, amplitude) in
        [(unequal(), 0.0, 0.8), (three(), 0.0, 0.8), (three(), 0.11, 0.3), (unequal(), 0.07, 1.2)]
    {
        let off = departure(wires, stiffness, amplitude);
        // The integration error is 1e-11.
        assert!(off < 1e-9, "{amplitude}: {off}");
    }
    let one = vec![Wire { top: [0.0; 3].into(), bottom: [0.01, -0.006, 0.25].into(), length: 0.6.into() }];
    let off = departure(one, 0.05, 0.6);
    assert!(off < 1e-9, "{off}");
}

#[test]
fn pendulums_have_the_period_of_the_elliptic_integral() {
    let numbers = numbers(&TRUTH);
    let axis = Direction::new(0.3, 0.9, -0.2);
    let rig = Rig::Axis(Axis::level([0.11, 0.02, 0.23], axis));
    let oscillator = oscillator(&rig, &numbers);
    let small = oscillator.rest().rate;
    let amplitudes = Amplitudes::up_to(2.9);
    let (family, _) = Family::new(oscillator.as_ref(), &amplitudes, &[]).unwrap();
    for amplitude in [0.05_f64, 0.7, 1.5, 2.2, 2.9] {
        let k = EllipticParameter::new((0.5 * amplitude).sin().powi(2)).unwrap().k();
        let exact = small * 0.5 * core::f64::consts::PI / k;
        let rate = family.rate(&family.at(amplitude)).value;
        assert!((rate / exact - 1.0).abs() < 1e-12, "{amplitude}: {rate} {exact}");
    }
    let body = polhode::body::MassProperties::new(
        TRUTH[0],
        Position::new(TRUTH[1], TRUTH[2], TRUTH[3]),
        polhode::body::InertiaTensor::with_negative_products(
            [TRUTH[4], TRUTH[5], TRUTH[6]],
            [TRUTH[7], TRUTH[8], TRUTH[9]],
        )
        .unwrap(),
    )
    .unwrap();
    let about = body.inertia_about(Position::<polhode::math::Body>::new(0.11, 0.02, 0.23));
    let n = Direction::<polhode::math::Body>::new(0.3, 0.9, -0.2).direction().unwrap();
    let d = Position::<polhode::math::Body>::new(TRUTH[1] - 0.11, TRUTH[2] - 0.02, TRUTH[3] - 0.23);
    let lever = n.cross(d).norm();
    let moment = about.about_axis(n);
    assert!((small - (TRUTH[0] * G * lever / moment).sqrt()).abs() < 1e-12 * small);
}
