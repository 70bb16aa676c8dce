//! ω(t) in Jacobi elliptic functions, compared with the free motion and with its constants.

use polhode::motion::{FreeMotion, Regime};
use polhode::observe::{JacobiForm, JacobiFunction};
use polhode::prelude::*;

fn motion(omega: [f64; 3]) -> FreeMotion {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
    let state =
        State { time: -1.5, attitude: Attitude::identity(), omega: AngularVelocity::from_array(omega) };
    FreeMotion::of(&Rotor::free(&body), state).unwrap()
}

#[test]
fn the_form_is_the_motion_in_every_octant_of_both_modes() {
    let mut seen = [0; 2];
    for bits in 0..8 {
        let sign = |k: u32| if bits >> k & 1 == 0 { 1.0 } else { -1.0 };
        for size in [[0.9, 0.2, 0.3], [0.2, 0.3, 0.8], [0.3, 1.1, 0.2], [0.4, 1.0, 0.35], [1e-9, 1.0, 1e-8]] {
            let omega = [0, 1, 2].map(|k| sign(k as u32) * size[k]);
            let motion = motion(omega);
            let form = JacobiForm::of(&motion).unwrap();
            let is_short = motion.regime() == Regime::ShortAxis;
            seen[usize::from(is_short)] += 1;
            let dn = if is_short { 2 } else { 0 };
            assert_eq!(form.functions()[dn], JacobiFunction::Dn);
            for t in [0.0, 0.3, 7.7, -4.1, 60.0] {
                let want = motion.at(motion.start().time + t).omega;
                let got = motion.principal().rotation() * form.omega(t);
                let near = 1e-14 * (1.0 + form.rate() * t.abs()) * (1.0 + (form.rate() * t).exp().min(1e3));
                assert!((got - want).norm() < near, "{omega:?} at {t}: {got:?} {want:?}");
            }
        }
    }
    assert!(seen.iter().all(|n| *n >= 8), "{seen:?}");
}

#[test]
fn amplitudes_are_those_of_the_two_constants() {
    let motion = motion([0.4, -1.0, 0.35]);
    let [i1, i2, i3] = motion.principal().moments();
    let (t2, l2) = (2.0 * motion.kinetic_energy(), motion.momentum().dot(motion.momentum()));
    let form = JacobiForm::of(&motion).unwrap();
    let [a1, a2, a3] = form.amplitudes().map(|a| a * a);
    let both = [(t2 * i3 - l2) / (i2 * (i3 - i2)), (l2 - t2 * i1) / (i2 * (i2 - i1))];
    for (got, want) in [
        (a1, (t2 * i3 - l2) / (i1 * (i3 - i1))),
        (a3, (l2 - t2 * i1) / (i3 * (i3 - i1))),
        (a2, both[0].min(both[1])),
    ] {
        assert!((got / want - 1.0).abs() < 1e-12, "{got} {want}");
    }
    assert!((4.0 * form.parameter().k() / form.rate() / motion.period().unwrap() - 1.0).abs() < 1e-14);
}

#[test]
fn on_the_separatrix_it_is_hyperbolic_with_any_signs() {
    // i = 1, 2, 3: L² − 2T i2 = −ω1² + 3 ω3² = 0 exactly
    let inertia = InertiaTensor::diagonal([3.0, 4.0, 6.0]).unwrap();
    let body = MassProperties::new(1.7, Position::ZERO, inertia).unwrap();
    for [a, b, c] in [[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, -1.0, -1.0]] {
        // 3 (3 − 4) ω1² + 6 (6 − 4) ω3² = 0: ω1 = 2 ω3
        let omega = AngularVelocity::new(a * 0.5, b * 0.375, c * 0.25);
        let state = State { time: 0.0, attitude: Attitude::identity(), omega };
        let motion = FreeMotion::of(&Rotor::free(&body), state).unwrap();
        assert_eq!(motion.regime(), Regime::Separatrix);
        let form = JacobiForm::of(&motion).unwrap();
        for t in [0.0, 1.3, -2.4, 30.0] {
            let (got, want) = (motion.principal().rotation() * form.omega(t), motion.at(t).omega);
            assert!((got - want).norm() < 1e-13, "{got:?} {want:?}");
        }
    }
}

#[test]
fn there_is_none_of_equal_moments_and_permanent_rotations() {
    assert!(JacobiForm::of(&motion([0.0; 3])).is_none());
    let wheel =
        MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([1.0, 1.0, 1.5]).unwrap()).unwrap();
    let omega = AngularVelocity::new(0.2, 0.3, 0.4);
    let state = State { time: 0.0, attitude: Attitude::identity(), omega };
    assert!(JacobiForm::of(&FreeMotion::of(&Rotor::free(&wheel), state).unwrap()).is_none());
}
