//! Run time of 10,000 rows: `cargo run --release -p polhode-identify --example payload_time`.

use std::time::Instant;

use polhode::math::{Acceleration, AngularAcceleration, AngularVelocity, Force, Position, Torque};
use polhode_identify::payload::{
    MotionNoise, PayloadLog, PayloadRow, WrenchNoise, WrenchSense, identify_payload,
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut state = 1_u64;
    let mut noise = |sd: f64| {
        let mut sum = -6.0;
        for _ in 0..12 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            sum += (state >> 11) as f64 / (1_u64 << 53) as f64;
        }
        sd * sum
    };
    let rows: Vec<PayloadRow> = (0..10_000)
        .map(|k| {
            let t = 0.001 * f64::from(k);
            let (u, v) = (5.0 * t, 7.0 * t);
            let omega = AngularVelocity::new(2.0 * u.sin(), 1.5 * v.cos(), (u + v).sin());
            let alpha = AngularAcceleration::new(10.0 * u.cos(), -10.5 * v.sin(), 12.0 * (u + v).cos());
            let gravity =
                Acceleration::new(-9.81 * u.sin(), 9.81 * u.cos() * v.sin(), -9.81 * u.cos() * v.cos());
            let c = Position::new(0.03, -0.02, 0.1);
            let at_center = alpha.cross(c) + omega.cross(omega.cross(c)) - gravity;
            let force = Force::from_array((at_center * 2.0).to_array());
            let torque = Torque::from_array((alpha * 0.012).to_array()) + c.cross(force);
            PayloadRow {
                time: t,
                omega: omega + AngularVelocity::new(noise(0.01), noise(0.01), noise(0.01)),
                alpha: alpha + AngularAcceleration::new(noise(0.2), noise(0.2), noise(0.2)),
                acceleration: Acceleration::new(noise(0.05), noise(0.05), noise(0.05)),
                gravity,
                force: force + Force::new(noise(0.1), noise(0.1), noise(0.1)),
                torque: torque + Torque::new(noise(0.01), noise(0.01), noise(0.01)),
            }
        })
        .collect();
    let known = WrenchNoise::Deviations { force: 0.1, torque: 0.01 };
    let moving = MotionNoise { omega: 0.01, alpha: 0.2, acceleration: 0.05 };
    for (name, noise, motion) in [
        ("noise of the wrench known", known, MotionNoise::default()),
        ("noise of the wrench unknown", WrenchNoise::Unknown, MotionNoise::default()),
        ("noise of the motion too", known, moving),
        ("noise of the motion, that of the wrench unknown", WrenchNoise::Unknown, moving),
    ] {
        let log = PayloadLog::new(rows.clone(), WrenchSense::OnPayload)?
            .with_bias()
            .with_noise(noise)?
            .with_motion_noise(motion)?;
        let start = Instant::now();
        let payload = identify_payload(&log)?;
        println!("{name}: {:.3} s", start.elapsed().as_secs_f64());
        for number in payload.about_center.numbers.iter().take(10) {
            println!(
                "  {} {:.5} ± {:.5} {}",
                number.name,
                number.value,
                number.sd.unwrap_or(f64::NAN),
                number.unit
            );
        }
        println!("  {:?} {:?}", payload.tests.map(|test| test.reduced_chi_square), payload.findings);
    }
    Ok(())
}
