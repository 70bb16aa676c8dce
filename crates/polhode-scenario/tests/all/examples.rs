//! The examples are read and computed; those of the lecture notes give the numbers of the notes.

use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};

use polhode::body::Symmetry;
use polhode::math::elliptic::EllipticParameter;
use polhode::motion::Run;
use polhode::prelude::*;
use polhode_scenario::read as scenario;

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

fn read(name: &str) -> Scenario {
    scenario::read(&examples().join(name)).unwrap_or_else(|e| panic!("{e}"))
}

fn close(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance * expected.abs().max(1.0), "{value} is not {expected}");
}

#[test]
fn every_example_is_read_and_computed() {
    let mut count = 0;
    for folder in ["", "notes"] {
        for entry in fs::read_dir(examples().join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|extension| extension == "toml") {
                let scenario = scenario::read(&path).unwrap_or_else(|e| panic!("{e}"));
                assert!(scenario.title().is_some());
                if let Some(motion) = scenario.simulate() {
                    motion.unwrap_or_else(|e| panic!("{}: {e}", path.display()));
                }
                count += 1;
            }
        }
    }
    assert!(count >= 10, "{count}");
}

/// A truncated file is either read, or refused at an existing place.
#[test]
fn a_file_cut_anywhere_is_answered() {
    for name in ["t-handle.toml", "bracket.toml", "notes/11-04-pendulum.toml", "notes/11-10-dumbbell.toml"] {
        let path = examples().join(name);
        let text = fs::read_to_string(&path).unwrap();
        for end in (0..text.len()).filter(|&end| text.is_char_boundary(end)) {
            if let Err(error) = scenario::parse(&text[..end], &path) {
                let place = error.place().expect("a place");
                assert!(place.span.end <= end && place.line <= text[..end].matches('\n').count() + 1);
            }
        }
    }
}

#[test]
fn example_11_3_the_cube_about_its_corner() {
    let tensor = read("notes/11-03-cube.toml").rotor().inertia().matrix();
    for (i, row) in tensor.iter().enumerate() {
        for (j, &element) in row.iter().enumerate() {
            close(element, if i == j { 2.0 / 3.0 } else { -0.25 }, 1e-15);
        }
    }
}

#[test]
fn example_11_4_the_pendulum() {
    let scenario = read("notes/11-04-pendulum.toml");
    let [m1, m2, b, g] = [0.3, 0.5, 0.8, 9.81];
    let pendulum = scenario.pendulum().unwrap().unwrap();
    let squared = (m1 + m2 / 2.0) / (m1 + m2 / 4.0) * (g / b);
    close(pendulum.small_frequency().powi(2), squared, 1e-14);
    close(pendulum.moment(), (m1 + m2 / 4.0) * b * b, 1e-15);
    close(pendulum.angle(), PI / 6.0, 1e-15);
    // Sign that the notes omit: the torque is restoring.
    let samples = scenario.simulate().unwrap().unwrap();
    let first = samples.samples().first().unwrap();
    close(first.torque.z, -(m1 + m2 / 2.0) * b * g * 0.5, 1e-14);
    // The swing agrees with the closed form: it returns after one period.
    let period = pendulum.period(PI / 6.0);
    let mut once = scenario.clone();
    once = once.sampled(Run { times: vec![0.0, period], method: Method::Auto, tolerance: 1e-14 });
    let end = once.simulate().unwrap().unwrap().samples()[1].state;
    assert!(end.attitude.angle_to(scenario.start().attitude) < 1e-11);
    // The run stays on the axis, so no warning is reported.
    assert_eq!(scenario.findings().iter().map(|f| f.code).collect::<Vec<_>>(), ["body.rod"]);
}

#[test]
fn example_11_5_the_principal_axes() {
    let scenario = read("notes/11-05-principal-axes.toml");
    let rotor = scenario.rotor();
    let principal = rotor.principal();
    for (moment, expected) in principal.moments().iter().zip([1.0 / 6.0, 11.0 / 12.0, 11.0 / 12.0]) {
        close(*moment, expected, 1e-15);
    }
    assert_eq!(principal.symmetry(), Symmetry::Prolate);
    let diagonal = Direction::new(1.0, 1.0, 1.0);
    assert!(principal.axis(0).angle_to(diagonal) < 1e-15);
    // The axes chosen in the notes lie in the plane of the degenerate pair.
    for axis in [Direction::new(1.0, -1.0, 0.0), Direction::new(-1.0, -1.0, 2.0)] {
        close(rotor.inertia().about_axis(axis), 11.0 / 12.0, 1e-15);
        assert!(principal.axis(0).dot(axis).abs() < 1e-15);
    }
    // A spin about the diagonal is permanent.
    let motion = scenario.simulate().unwrap().unwrap();
    let last = motion.samples().last().unwrap();
    assert!((last.state.omega - AngularVelocity::new(2.0, 2.0, 2.0)).norm() < 1e-14);
}

#[test]
fn example_11_10_the_dumbbell() {
    let scenario = read("notes/11-10-dumbbell.toml");
    let [m1, m2, b, omega, alpha] = [2.0, 3.0, 0.5, PI, PI / 6.0];
    let expected = -(m1 + m2) * b * b * omega * omega * alpha.sin() * alpha.cos();
    let motion = scenario.simulate().unwrap().unwrap();
    for sample in motion.samples() {
        let [x, y, z] = sample.torque.to_array();
        close(x, expected, 1e-14);
        assert!(y.abs() < 1e-14 && z.abs() < 1e-14);
    }
    // One turn in two seconds.
    let last = motion.samples().last().unwrap().state;
    assert!((last.time - 2.0).abs() < 1e-15 && last.attitude.angle_to(scenario.start().attitude) < 1e-14);
    assert!(scenario.is_all_particles());
}

#[test]
fn the_symmetric_top_goes_round_its_two_cones() {
    let scenario = read("notes/force-free-top.toml");
    let (i1, i3) = (3.0 * (3.0 * 0.01 + 0.0016) / 12.0, 3.0 * 0.01 / 2.0);
    let rate: f64 = (i3 - i1) / i1 * 10.0;
    let motion = scenario.simulate().unwrap().unwrap();
    for sample in motion.samples() {
        let (sin, cos) = (rate * sample.state.time).sin_cos();
        let [x, y, z] = sample.state.omega.to_array();
        close(x, 1.5 * cos + 0.8 * sin, 1e-13);
        close(y, 1.5 * sin - 0.8 * cos, 1e-13);
        close(z, 10.0, 1e-15);
        // L, ω and the symmetry axis stay in a plane.
        let l = sample.state.attitude.inverse() * sample.momentum;
        let [lx, ly, _] = l.to_array();
        assert!((lx * y - ly * x).abs() < 1e-14);
    }
}

#[test]
fn the_t_handle_flips() {
    let scenario = read("t-handle.toml");
    let principal = *scenario.rotor().principal();
    assert!(principal.axis(1).angle_to(Direction::new(0.0, 0.0, 1.0)) < 1e-12);
    let motion = scenario.simulate().unwrap().unwrap();
    assert_eq!(motion.samples().len(), 2001);
    let flips = motion.samples().windows(2).filter(|s| s[0].state.omega.z * s[1].state.omega.z < 0.0).count();
    assert!(flips >= 4, "{flips}");
}

#[test]
fn the_bracket_has_no_symmetry() {
    let scenario = read("bracket.toml");
    let part = &scenario.parts()[0];
    // A plate and an upright with a slope, minus a hole approximated by a 48-gon.
    let hole = 24.0 * 8.0_f64.powi(2) * (2.0 * PI / 48.0).sin() * 5.0;
    let volume = (60.0 * 40.0 * 5.0 + 5.0 * 40.0 * (22.5) - hole) * 1e-9;
    close(part.extent.unwrap().measure() / volume, 1.0, 1e-7);
    close(scenario.body().mass() / (2700.0 * volume), 1.0, 1e-7);
    assert_eq!(scenario.body().principal().symmetry(), Symmetry::Asymmetric);
    assert!(scenario.findings().is_empty());
}

#[test]
fn the_gyroscope_nods_between_its_bounds() {
    let motion = read("heavy-top.toml").simulate().unwrap().unwrap();
    let tilt = motion.samples().iter().map(|s| s.state.attitude.euler313()[1].to_degrees());
    let (least, most) = tilt.fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
    assert!((least - 30.0).abs() < 1e-6 && (most - 32.9).abs() < 0.05, "{least} {most}");
}

#[test]
fn curtis_tube_precesses_at_the_rate_of_the_book() {
    let scenario = read("curtis-tube.toml");
    let rotor = scenario.rotor();
    assert_eq!(rotor.inertia().matrix(), [[125.0, 0.0, 0.0], [0.0, 125.0, 0.0], [0.0, 0.0, 100.0]]);
    let momentum = rotor.angular_momentum_space(&scenario.start());
    close(momentum.norm() / 125.0 * 60.0, 26.7457, 5e-5);
    // Spin relative to the precessing frame: ω_z − φ' cos θ.
    let rate = momentum.norm() / 125.0;
    close(scenario.start().omega.z - rate * 20_f64.to_radians().cos(), 2.0 * PI / 60.0, 1e-14);
    assert!(momentum.angle_to(Direction::<Space>::new(0.0, 0.0, 1.0)) < 1e-15);
}

#[test]
fn the_satellite_librates_about_the_vertical() {
    let scenario = read("gravity-gradient.toml");
    let [[ix, ..], [_, iy, _], [.., iz]] = scenario.rotor().inertia().matrix();
    assert!(iz < 0.1 * ix && (ix / iy - 1.0).abs() < 0.02);
    let n = 1.106_816_5e-3;
    let motion = scenario.simulate().unwrap().unwrap();
    // Angles of the boom from the vertical: in the plane, forward, and out of the plane.
    let angles = motion.samples().iter().map(|sample| {
        let boom = sample.state.attitude * Direction::<Body>::new(0.0, 0.0, 1.0);
        let (sin, cos) = (n * sample.state.time).sin_cos();
        let [up, forward] = [boom.x * cos + boom.y * sin, boom.y * cos - boom.x * sin];
        (sample.state.time, forward.atan2(up), boom.z.asin())
    });
    let angles: Vec<_> = angles.collect();
    let most = |f: fn(&(f64, f64, f64)) -> f64| angles.iter().map(f).fold(0.0, f64::max).to_degrees();
    let (pitch, roll) = (most(|a| a.1.abs()), most(|a| a.2.abs()));
    assert!((25.0..26.0).contains(&pitch) && (10.0..10.5).contains(&roll), "{pitch} {roll}");
    // Mean period: twice the mean interval between passages of the vertical.
    let period = |f: fn(&(f64, f64, f64)) -> f64| {
        let crossings = angles.windows(2).filter(|w| f(&w[0]) * f(&w[1]) < 0.0);
        let times: Vec<f64> = crossings
            .map(|w| {
                let (a, b) = (f(&w[0]), f(&w[1]));
                w[0].0 + (w[1].0 - w[0].0) * a / (a - b)
            })
            .collect();
        2.0 * (times[times.len() - 1] - times[0]) / (times.len() - 1) as f64
    };
    // Small librations: 3 n² (Ix − Iz)/Iy in the plane, n² + 3 n² (Ix − Iz)/Iy out of it. Large
    // ones are slower by the factor 2 K(sin² θ₀)/π.
    let small = 3.0 * (ix - iz) / iy;
    let wide = EllipticParameter::new(25_f64.to_radians().sin().powi(2)).unwrap().k() / (PI / 2.0);
    close(period(|a| a.1) / (2.0 * PI * wide / (n * small.sqrt())), 1.0, 0.005);
    close(period(|a| a.2) / (2.0 * PI / (n * (1.0 + small).sqrt())), 1.0, 0.01);
}

#[test]
fn the_magnet_swings_about_the_field() {
    let scenario = read("magnet.toml");
    let moment = scenario.rotor().inertia().matrix()[0][0];
    let (dip, strength) = (f64::atan2(44.0, 19.0), f64::hypot(44e-6, 19e-6));
    let small = (4.5 * strength / moment).sqrt();
    let period = 4.0 * EllipticParameter::new((0.5 * dip).sin().powi(2)).unwrap().k() / small;
    let mut whole = scenario.clone();
    whole = whole.sampled(Run { times: vec![0.5 * period, period], method: Method::Auto, tolerance: 1e-14 });
    let motion = whole.simulate().unwrap().unwrap();
    let [half, end] = [0, 1].map(|k| motion.samples()[k].state.attitude);
    assert!(end.angle_to(scenario.start().attitude) < 1e-11);
    close(half.angle_to(scenario.start().attitude), 2.0 * dip, 1e-11);
}

#[test]
fn the_thruster_adds_what_its_torque_says() {
    let scenario = read("thruster.toml");
    let moments = scenario.rotor().principal().moments();
    assert!(moments[0] < 0.99 * moments[1] && moments[1] < 0.99 * moments[2]);
    let motion = scenario.simulate().unwrap().unwrap();
    let (first, last) = (motion.samples()[0], *motion.samples().last().unwrap());
    // The work of the torque equals the gain in energy.
    close((last.kinetic_energy - first.kinetic_energy) / last.work, 1.0, 1e-10);
}

#[test]
fn drag_turns_the_spin_to_the_axis_that_it_brakes_least() {
    let motion = read("drag.toml").simulate().unwrap().unwrap();
    let [first, last] = [motion.start(), motion.samples().last().unwrap()].map(|sample| sample.state.omega);
    assert!((0.03..0.06).contains(&(last.norm() / first.norm())), "{last:?}");
    assert!(last.z > 0.95 * last.norm(), "{last:?}");
    let drift = Drift::of(&motion).unwrap();
    assert!(drift.work_energy < 1e-12 && drift.momentum < 1e-12, "{drift:?}");
}

#[test]
fn the_air_brake_and_the_motor_balance() {
    let scenario = read("air-brake.toml");
    let motion = scenario.simulate().unwrap().unwrap();
    // ω = w coth(√(N D) t/I + arcoth(ω₀/w)), w = √(N/D)
    let [n, d, i] = [0.5_f64, 8e-4, scenario.rotor().inertia().about_axis(Direction::new(0.0, 0.0, 1.0))];
    let w = (n / d).sqrt();
    let start = (w / (200.0 * PI)).atanh();
    for sample in motion.samples() {
        let want = w / ((n * d).sqrt() * sample.state.time / i + start).tanh();
        close(sample.state.omega.z, want, 1e-12);
    }
    let last = motion.samples().last().unwrap().state.omega.z;
    assert!((last / w - 1.0).abs() < 1e-3);
}

#[test]
fn the_torsion_pendulum_comes_back_after_its_period() {
    let scenario = read("torsion-pendulum.toml");
    let motion = scenario.simulate().unwrap().unwrap();
    let moment = scenario.rotor().inertia().about_axis(Direction::new(0.0, 0.0, 1.0));
    let rate = (0.8e-3 / moment).sqrt();
    for sample in motion.samples() {
        let angle = 170.0_f64.to_radians() * (rate * sample.state.time).cos();
        let want = Attitude::from_axis_angle(Direction::new(0.0, 0.0, 1.0), angle).unwrap();
        assert!(sample.state.attitude.angle_to(want) < 1e-11);
    }
    assert!(Drift::of(&motion).unwrap().total_energy.unwrap() < 1e-12);
}

#[test]
fn thirty_pulses_spin_the_spacecraft_up() {
    let motion = read("thruster-pulses.toml").simulate().unwrap().unwrap();
    let omega = |t: f64| motion.samples().iter().find(|s| s.state.time >= t).unwrap().state.omega;
    close(omega(160.0).z, 30.0 * 0.2 * 1.2 / 30.0, 1e-13);
    assert!(omega(160.0).x == 0.0 && omega(160.0).y == 0.0);
    // r × F = (0.3, −0.2, 0) N·m for 3 s
    let l = motion.samples().last().unwrap().momentum;
    assert!((0.8..1.1).contains(&l.x.hypot(l.y)) && (l.z - 7.2).abs() < 0.1, "{l:?}");
}

#[test]
fn the_minor_axis_spinner_ends_in_a_flat_spin() {
    let scenario = read("flat-spin.toml");
    let motion = scenario.simulate().unwrap().unwrap();
    let (first, last) = (motion.samples()[0], *motion.samples().last().unwrap());
    // 0.4 rad/s about a transverse axis, and 96 % of the energy lost: L/5 and 1 − 0.2/5, except for
    // the initial tilt.
    close(first.state.omega.norm(), 10.0, 1e-7);
    close(last.state.omega.norm(), 0.4, 2e-5);
    close(1.0 - last.kinetic_energy / first.kinetic_energy, 0.96, 5e-6);
    let drift = (last.momentum - first.momentum).norm();
    assert!(last.state.omega.z.abs() < 1e-4 && drift < 1e-11, "{last:?} {drift:e}");
    // In between it follows the closed form: tan θ = tan θ0 exp(α L² (1/0.2 − 1/5) t).
    let tangent = |s: &Sample| 5.0 * s.state.omega.x.hypot(s.state.omega.y) / (0.2 * s.state.omega.z);
    let rate = 0.002 * first.momentum.dot(first.momentum) * (1.0 / 0.2 - 1.0 / 5.0);
    for sample in motion.samples().iter().take_while(|s| s.state.time < 200.0) {
        // Steps are accurate to 1e-13 of 10 rad/s, and the tilt is 0.0035 rad/s.
        close(tangent(sample) / (tangent(&first) * (rate * sample.state.time).exp()), 1.0, 1e-9);
    }
}

#[test]
fn the_gyrostat_turns_itself() {
    let scenario = read("gyrostat.toml");
    let [wheel] = scenario.wheels()[..] else { panic!("{:?}", scenario.wheels()) };
    // 15 mN·m for 20 s
    close(wheel.momentum_at(60.0), 0.3, 1e-15);
    let motion = scenario.simulate().unwrap().unwrap();
    let last = motion.samples().last().unwrap();
    assert!(last.momentum.norm() < 1e-15);
    // L = 0: I ω = −h
    let balance = scenario.rotor().angular_momentum(last.state.omega) + scenario.rotor().wheel_momentum(60.0);
    assert!(balance.norm() < 1e-15 && last.state.omega.z < -0.15, "{last:?}");
}
