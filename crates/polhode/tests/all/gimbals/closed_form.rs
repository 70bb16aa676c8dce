//! Comparison with closed forms: tops and free bodies in massless gimbals, gyrocompasses, nutation,
//! precession and Magnus' drift.

use core::f64::consts::TAU;

use polhode::math::Direction;
use polhode::motion::Ending;
use polhode::motion::gimbal::{Axis, Base, Gimbals};
use polhode::prelude::*;

use super::{GRAVITY, balanced, free, generic_rotor, near, run, symmetric_rotor, upright};

/// Checks that a rotor in massless gimbals without friction moves like a body held at a point, for
/// any orientation of the axes.
fn assert_as_held_at_a_point(rotor: &MassProperties<Body>, gimbals: &Gimbals, torques: &[TorqueModel]) {
    let times: Vec<f64> = (0..=40).map(|k| 0.1 * f64::from(k)).collect();
    let motion = run(rotor, gimbals, &times);
    assert!(
        *motion.ending() == Ending::Complete && motion.energy_drift() < 1e-13,
        "{:.1e}",
        motion.energy_drift()
    );
    let held = Rotor::pivoted(rotor, gimbals.crossing());
    let other =
        Trajectory::compute(&held, torques, motion.start().state, &times, Method::Exact, 1e-13).unwrap();
    for (sample, exact) in motion.samples().iter().zip(other.samples()) {
        let turned = sample.state.attitude.angle_to(exact.state.attitude);
        let faster = (sample.state.omega - exact.state.omega).norm() / exact.state.omega.norm();
        assert!(turned < 1e-12 && faster < 1e-13, "{turned:.1e} {faster:.1e}");
        assert!((sample.torque - exact.torque).norm() < 1e-13);
    }
}

#[test]
fn a_symmetric_rotor_in_massless_gimbals_is_a_heavy_top() {
    let rotor = symmetric_rotor(0.003, 0.0021, 0.7, 0.13);
    let axes = free([0.3, -0.5, 1.1], [0.4, 0.7, 60.0]);
    let gimbals = Gimbals::new(Direction::new(0.3, 0.1, 1.0), Direction::new(0.1, -0.3, 0.0), axes).unwrap();
    let gravity = TorqueModel::Gravity(UniformGravity { acceleration: GRAVITY });
    assert_as_held_at_a_point(&rotor, &gimbals.with_gravity(GRAVITY).unwrap(), &[gravity]);
}

#[test]
fn an_asymmetric_rotor_in_massless_gimbals_is_free_though_the_base_turns() {
    let rotor = generic_rotor();
    let axes = free([0.3, -0.5, 1.1], [0.4, 0.7, 5.0]);
    let gimbals = Gimbals::new(Direction::new(0.1, 0.4, 1.0), Direction::new(0.4, -0.1, 0.0), axes).unwrap();
    let base = Base::turning(AngularVelocity::new(0.3, -0.2, 0.5)).unwrap();
    let gimbals =
        gimbals.holding(rotor.center_of_mass(), Direction::new(0.5, -0.3, 0.8)).unwrap().with_base(base);
    assert_as_held_at_a_point(&rotor, &gimbals, &[]);
}

/// A α̈ = (B − D) `ω_n`² sin α cos α − C (ν + `ω_n` cos α) `ω_n` sin α, `ω_n` = ω cos λ. A is the
/// moment of the level parts about the vertical, B across the rotor, and D that of the gimbals
/// along it.
fn assert_period_of_compass(turning: f64, spin: f64, amplitude: f64, tolerance: f64) -> f64 {
    let (a, c, latitude) = (0.012, 0.02, 0.9_f64);
    let rotor = symmetric_rotor(a, c, 3.0, 0.0);
    let axes = [Axis::free(amplitude, 0.0), Axis::locked(0.0), Axis::driven(0.4, spin)].map(Result::unwrap);
    let (outer, inner) =
        (balanced([0.004, 0.005, 0.003], [0.0; 3]), balanced([0.002, 0.003, 0.0025], [0.0; 3]));
    let (s, cosine) = latitude.sin_cos();
    let base = Base::turning(AngularVelocity::new(0.0, turning * cosine, turning * s)).unwrap();
    let gimbals = upright(axes).with_base(base).with_mass(outer, inner);
    let north = turning * cosine;
    // Along the axes of the base at zero angles: x the inner axis, y the rotor's, z up.
    let (about, across, along) = (a + 0.003 + 0.0025, a + 0.004 + 0.002, 0.005 + 0.003);
    let stiffness = (c * (spin + north) + (along - across) * north) * north;
    let period = TAU * (about / stiffness).sqrt();
    let motion = run(&rotor, &gimbals, &[0.25 * period, 0.5 * period, period]);
    let [quarter, half, whole] = [0, 1, 2].map(|k| motion.samples()[k].angles[0] / amplitude);
    near(quarter, 0.0, tolerance);
    near(half, -1.0, tolerance);
    near(whole, 1.0, tolerance);
    assert!(motion.energy_drift() < 1e-15);
    period
}

#[test]
fn a_gyrocompass_swings_about_north_with_its_period() {
    // Fast, so that the terms in ω² are significant; small, so that sin α = α.
    assert_period_of_compass(0.7, 15.0, 1e-7, 1e-12);
    let period = assert_period_of_compass(Base::EARTH_RATE, 1500.0, 1e-7, 1e-9);
    // 2π √(A/(C ν ω_E cos λ))
    let classic = TAU * (0.0175 / (0.02 * 1500.0 * Base::EARTH_RATE * 0.9_f64.cos())).sqrt();
    near(period / classic, 1.0, 1e-6);
}

#[test]
fn a_base_on_the_earth_turns_about_the_pole() {
    let omega = Base::on_earth(0.9).unwrap().angular_velocity();
    near(omega.norm(), 7.292_115e-5, 1e-19);
    near(omega.y / omega.z, 1.0 / 0.9_f64.tan(), 1e-15);
    assert!(omega.x == 0.0 && omega.y > 0.0);
}

/// Near β = 0, A_α α̇ = −H β and B β̈ = H α̇: the frequency is H/√(A_α B).
#[test]
fn nutation_in_gimbals_with_mass_has_the_rate_of_both_inertias() {
    let (a, c, spin) = (0.012, 0.02, 200.0);
    let rotor = symmetric_rotor(a, c, 3.0, 0.0);
    let (outer, inner) =
        (balanced([0.004, 0.005, 0.006], [0.0; 3]), balanced([0.002, 0.003, 0.0025], [0.0; 3]));
    let gimbals = upright(free([0.2, 0.0, 0.3], [0.0, 1e-6, spin])).with_mass(outer, inner);
    let momentum = c * spin;
    let (about, across) = (a + 0.006 + 0.0025, a + 0.002);
    let rate = momentum / (about * across).sqrt();
    let period = TAU / rate;
    let motion = run(&rotor, &gimbals, &[0.25 * period, period]);
    let [quarter, whole] = [0, 1].map(|k| motion.samples()[k]);
    near(quarter.rates[1] / 1e-6, 0.0, 1e-7);
    near(quarter.rates[0] / 1e-6, -(across / about).sqrt(), 1e-7);
    near(whole.rates[1] / 1e-6, 1.0, 1e-7);
}

/// C (γ̇ + Ω sin β) = m g l/Ω + (A + A₂ − C₂) Ω sin β keeps β constant and turns α at Ω; A₂, C₂ of
/// the inner gimbal.
#[test]
fn a_heavy_gyroscope_in_gimbals_with_mass_precesses_steadily() {
    let (a, c, mass, height, elevation, rate) = (0.012_f64, 0.02, 3.0, 0.06, 0.4_f64, 0.8);
    let about = a + mass * height * height;
    let rotor = symmetric_rotor(a, c, mass, height);
    let inner = balanced([0.002, 0.0035, 0.0025], [0.0; 3]);
    let outer = balanced([0.004, 0.005, 0.006], [0.0; 3]);
    let s = elevation.sin();
    let spin = (mass * 9.80665 * height / rate + (about + 0.0025 - 0.0035) * s * rate) / c - rate * s;
    let axes = free([0.1, elevation, 0.3], [rate, 0.0, spin]);
    let gimbals = upright(axes).with_mass(outer, inner).with_gravity(GRAVITY).unwrap();
    let motion = run(&rotor, &gimbals, &[1.0, 10.0]);
    for sample in motion.samples() {
        near(sample.angles[1], elevation, 1e-12);
        near(sample.angles[0], 0.1 + rate * sample.state.time, 1e-11);
    }
}

/// Magnus' drift: a nutation of amplitude a about β₀ turns the outer gimbal at −½ H a² (A₁ + C₂)
/// sin β₀/Φ², Φ = A₁ + (A + A₂) cos² β₀ + C₂ sin² β₀. Massless gimbals do not drift.
///
/// It follows from T of the gimbals with `p_α` = Φ(β) α̇ + H sin β and H constant, to second order
/// in a. Source: K. Magnus, Kreisel (1971).
#[test]
fn nutation_makes_gimbals_with_mass_drift() {
    let (a, c, spin, tilt, amplitude) = (0.012, 0.02, 300.0, 0.5_f64, 1e-3);
    let rotor = symmetric_rotor(a, c, 3.0, 0.0);
    let (outer, inner) =
        (balanced([0.004, 0.005, 0.006], [0.0; 3]), balanced([0.002, 0.0035, 0.0025], [0.0; 3]));
    let (s, cosine) = tilt.sin_cos();
    let momentum = c * spin;
    for (gimbals, outer_moment, along, across, inner_across) in [
        (
            upright(free([0.0, tilt, 0.0], [0.0, 0.0, spin])).with_mass(outer, inner),
            0.006,
            0.0035,
            0.0025,
            0.002,
        ),
        (upright(free([0.0, tilt, 0.0], [0.0, 0.0, spin])), 0.0, 0.0, 0.0, 0.0),
    ] {
        let phi = outer_moment + (a + across) * cosine * cosine + along * s * s;
        let rate = momentum * cosine / (phi * (a + inner_across)).sqrt();
        // At β₀ with p_α = H sin β₀, where β̇ is largest.
        let axes = free([0.0, tilt, 0.0], [0.0, amplitude * rate, spin]);
        let gimbals = Gimbals::new(gimbals.outer_axis(), gimbals.inner_axis(), axes)
            .unwrap()
            .with_mass(gimbals.masses()[0], gimbals.masses()[1]);
        // So long that the contribution of a swing at the ends is small.
        let end = 500.0 * TAU / rate;
        let motion = run(&rotor, &gimbals, &[end]);
        let drift = -0.5 * momentum * amplitude * amplitude * s * (outer_moment + along) / (phi * phi);
        let swing = amplitude * momentum * cosine / (phi * rate);
        near(motion.samples()[0].angles[0] / end, drift, 2.0 * swing * 0.01 / end + 1e-3 * drift.abs());
    }
}
