//! Statements in titles and comments of the examples of rotors in gimbals.

use std::f64::consts::TAU;
use std::path::Path;

use polhode::motion::Mechanism;
use polhode::motion::channel::GIMBALS;
use polhode::motion::gimbal::{Base, Gimbal, GimbalState};
use polhode::prelude::*;
use polhode_scenario::read as scenario;

use crate::common::held::Held;

fn read(name: &str) -> Scenario {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    scenario::read(&path).unwrap_or_else(|e| panic!("{e}"))
}

/// Returns the motion; checks the energy balance and the absence of findings.
fn motion(scenario: &Scenario) -> Held<GimbalState> {
    let motion = scenario.simulate().unwrap().unwrap();
    let gimbals = Held::of(motion, GIMBALS);
    assert!(gimbals.energy_drift() < 1e-13, "{:e}", gimbals.energy_drift());
    assert!(scenario.findings().is_empty(), "{:?}", scenario.findings());
    gimbals
}

#[test]
fn the_gyrocompass_finds_north() {
    let scenario = read("gyrocompass.toml");
    let motion = motion(&scenario);
    let off = |t: f64| {
        let sample = motion.samples().iter().find(|s| s.state.time >= t - 1e-9).unwrap();
        sample.angles[0].to_degrees()
    };
    assert!((off(0.0) - 30.0).abs() < 1e-12);
    assert!(off(60.0).abs() < 0.05 && off(120.0).abs() < 1e-4, "{} {}", off(60.0), off(120.0));
    // The rotor axis is level and points north.
    let end = motion.samples().last().unwrap();
    let axis = end.state.attitude * polhode::math::Direction::<Body>::new(0.0, 0.0, 1.0);
    assert!(axis.y > 0.999_9 && axis.x.abs() < 0.01, "{axis:?}");
    // Period 30 s, and 0.6 of critical damping.
    let stiffness = 2e-3 * 800.0 * std::f64::consts::PI * Base::EARTH_RATE * 52_f64.to_radians().cos();
    let about = 1.3e-3 + 2.5e-3 + 1.2e-3;
    assert!((TAU * (about / stiffness).sqrt() - 30.0).abs() < 0.5);
    assert!((1.28e-3 / (2.0 * (about * stiffness).sqrt()) - 0.6).abs() < 0.01);
    // The motor keeps its rate.
    assert!(motion.samples().iter().all(|s| (s.rates[2] - 800.0 * std::f64::consts::PI).abs() < 1e-9));
}

#[test]
fn heavy_gimbals_creep_round() {
    let scenario = read("gimbals.toml");
    // Mean drift rate from the first second to the last; averages over one second remove the
    // nutation.
    let mean = |motion: &Held<GimbalState>| {
        let samples = motion.samples();
        let average =
            |part: &[GimbalState]| part.iter().map(|s| s.angles[0].to_degrees()).sum::<f64>() / 1000.0;
        (average(&samples[3000..4000]) - average(&samples[..1000])) / 3.0
    };
    let heavy = motion(&scenario);
    // The formula in the comment of the example.
    let (radius, height, mass) = (0.025_f64, 0.012_f64, 0.2);
    let (along, across) =
        (0.5 * mass * radius * radius, mass * (3.0 * radius * radius + height * height) / 12.0);
    let (momentum, (s, c)) = (along * 200.0 * std::f64::consts::PI, 30_f64.to_radians().sin_cos());
    let (outer, inner_across, inner_along, inner) = (5.78e-5, 6.14e-5, 3.07e-5, 3.07e-5);
    let phi = outer + (across + inner_across) * c * c + inner_along * s * s;
    let rate = momentum * c / (phi * (across + inner)).sqrt();
    let amplitude = 1500_f64.to_radians() / rate;
    let drift = -0.5 * momentum * amplitude * amplitude * (outer + inner_along) * s / (phi * phi);
    let said = drift.to_degrees();
    assert!((said + 14.0).abs() < 0.5, "{said}");
    assert!((mean(&heavy) / said - 1.0).abs() < 0.03, "{} {said}", mean(&heavy));
    // With massless gimbals the rotor nutates alone.
    let Mechanism::Gimbals(light) = scenario.mechanism() else { panic!("no gimbals") };
    let light = light.with_mass(Gimbal::MASSLESS, Gimbal::MASSLESS);
    let times = &scenario.run().unwrap().times;
    let light = Simulation::in_gimbals(scenario.body(), &light, 0.0, times).run().unwrap();
    let light = Held::of(light, GIMBALS);
    assert!(mean(&light).abs() < 0.1, "{}", mean(&light));
}
