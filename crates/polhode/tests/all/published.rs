//! Published results, compared to the tolerance of their printed digits.

use crate::common::*;
use polhode::body::Symmetry;
use polhode::body::shape::{CylinderShell, Plate};
use polhode::motion::{KineticEnergySplit, MovingParticle, angular_momentum, momentum};
use polhode::observe::{Cones, SymmetricTop};
use polhode::prelude::*;

const DEG: f64 = std::f64::consts::PI / 180.0;

fn assert_matrix(got: [[f64; 3]; 3], want: [[f64; 3]; 3], tolerance: f64, what: &str) {
    assert!(matrix_error(got, want) <= tolerance, "{what}: {got:?} is not {want:?}");
}

/// Returns a box with its edges; a plate if one edge is zero.
fn box_or_plate(size: [f64; 3], mass: f64) -> MassProperties<Part> {
    let shape: Box<dyn Shape> = if size[1] == 0.0 {
        Box::new(Plate::new([size[0], size[2]]).unwrap())
    } else {
        Box::new(BoxShape::new(size).unwrap())
    };
    let part = shape.mass_properties(Substance::Mass(mass)).unwrap();
    if size[1] != 0.0 {
        return part;
    }
    // the y axis of the plate is z of the case
    part.in_frame(Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), 90.0 * DEG).unwrap())
}

#[test]
fn jeod_composite_bodies() {
    for case in cases(&table("composite_bodies"), "case") {
        let id = case["id"].as_str().unwrap();
        let parts: Vec<_> = cases(case, "part")
            .into_iter()
            .map(|part| {
                let mass = number(&part["mass"]);
                let properties = if part["shape"].as_str() == Some("tensor") {
                    let inertia = InertiaTensor::from_matrix(matrix(&part["inertia"])).unwrap();
                    MassProperties::new(mass, Position::ZERO, inertia).unwrap()
                } else {
                    box_or_plate(numbers(&part["size"]), mass)
                };
                let position = Position::from_array(numbers(&part["position"]));
                PlacedPart::new(properties, position, Rotation::identity()).unwrap()
            })
            .collect();
        let body = assemble(&parts).unwrap();
        assert!((body.mass() / number(&case["mass"]) - 1.0).abs() < 1e-12, "{id}");
        let center = Position::from_array(numbers(&case["center_of_mass"]));
        assert!((body.center_of_mass() - center).norm() < 1e-12, "{id}: {:?}", body.center_of_mass());
        let tensor = match case.get("about") {
            Some(point) => body.inertia_about(Position::from_array(numbers(point))).matrix(),
            None => body.inertia().matrix(),
        };
        assert_matrix(tensor, matrix(&case["inertia"]), 1e-12, id);
    }
}

fn cloud(table: &toml::Value) -> Vec<Particle<Body>> {
    let masses = table["masses"].as_array().unwrap().iter().map(number);
    let positions = table["positions"].as_array().unwrap().iter().map(numbers);
    masses.zip(positions).map(|(m, p)| Particle::new(m, Position::from_array(p)).unwrap()).collect()
}

#[test]
fn thornton_and_marion_particles_and_cube() {
    let textbook = table("textbook");
    let case = &textbook["tm_11_13"];
    let body = mass_properties_of_particles(&cloud(case)).unwrap();
    let about = body.inertia_about(Position::ZERO);
    let tolerance = number(&case["tolerance"]);
    assert_matrix(about.matrix(), matrix(&case["inertia_about_origin"]), tolerance, "11-13");
    for (got, want) in
        PrincipalFrame::about_pivot(&about).moments().iter().zip(numbers::<3>(&case["principal_moments"]))
    {
        assert!((got / want - 1.0).abs() < tolerance);
    }

    let case = &textbook["tm_cube_corner"];
    let side = number(&case["side"]);
    let cube =
        BoxShape::new([side; 3]).unwrap().mass_properties(Substance::Mass(number(&case["mass"]))).unwrap();
    let corner = cube.inertia_about(Position::new(-side / 2.0, -side / 2.0, -side / 2.0));
    assert_matrix(corner.matrix(), matrix(&case["inertia_about_corner"]), 1e-15, "cube");
    let principal = PrincipalFrame::about_pivot(&corner);
    for (got, want) in principal.moments().iter().zip(numbers::<3>(&case["principal_moments"])) {
        assert!((got - want).abs() < 1e-15);
    }
    // the diagonal, and an arbitrary pair perpendicular to it
    assert_eq!(principal.symmetry(), Symmetry::Prolate);
    assert!(principal.axis(0).angle_to(Direction::<Part>::new(1.0, 1.0, 1.0)) < 1e-15);
}

#[test]
fn curtis_precessing_tube() {
    let textbook = table("textbook");
    let case = &textbook["curtis_10_2"];
    let value = |key: &str| number(&case[key]);
    let tube = CylinderShell::new(value("radius"), value("length"), false).unwrap();
    let tube = tube.mass_properties(Substance::Mass(value("mass"))).unwrap();
    let [a, _, c] = [0, 1, 2].map(|k| tube.inertia().matrix()[k][k]);
    assert!((a - value("moment_transverse")).abs() < 1e-12 && (c - value("moment_axial")).abs() < 1e-12);
    // The book's spin ψ̇ is relative to the precessing frame: minus Ω here. With precession φ̇
    // about L at the angle θ from e: ω_e = ψ̇ + φ̇ cos θ, ω_t = φ̇ sin θ.
    let (theta, spin) = (value("nutation_deg") * DEG, value("spin_rad_per_min"));
    let phi = c / (a - c) * spin / theta.cos();
    let omega = AngularVelocity::new(phi * theta.sin(), 0.0, spin + phi * theta.cos());
    let rotor = free_body([a, a, c]);
    let start = State { time: 0.0, attitude: Attitude::identity(), omega };
    let top = SymmetricTop::of_motion(&FreeMotion::of(&rotor, start).unwrap()).expect("is symmetric");
    let cones = Cones::of(&top);
    assert!((cones.space_rate - value("precession_rad_per_min")).abs() < value("tolerance_precession"));
    assert!((cones.body_rate + spin).abs() < 1e-12);
    assert!((cones.nutation - theta).abs() < 1e-14);
    assert!(
        (std::f64::consts::PI / cones.space_rate * 60.0 - value("half_turn_s")).abs()
            < value("tolerance_half_turn")
    );
}

#[test]
fn schaub_momentum_axes_and_energy() {
    let textbook = table("textbook");
    let case = &textbook["schaub"];
    let inertia = InertiaTensor::<Body>::from_matrix(matrix(&case["inertia"])).unwrap();
    let [yaw, pitch, roll] = numbers::<3>(&case["yaw_pitch_roll_deg"]).map(|a| a * DEG);
    let turn = |axis: [f64; 3], angle| {
        Rotation::<Space, Space>::from_axis_angle(Direction::from_array(axis), angle).unwrap()
    };
    let attitude: Attitude = turn([0.0, 0.0, 1.0], yaw)
        * turn([0.0, 1.0, 0.0], pitch)
        * Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), roll).unwrap();

    let part = &case["angular_momentum"];
    let omega = attitude.inverse() * AngularVelocity::from_array(numbers(&part["omega_space"]));
    let want = AngularMomentum::from_array(numbers(&part["momentum_body"]));
    assert!((inertia * omega - want).max_abs() < number(&part["tolerance"]));

    let part = &case["parallel_axis"];
    let center = attitude.inverse() * Position::from_array(numbers(&part["center_of_mass_from_p_space"]));
    let body = MassProperties::new(number(&case["mass"]), center, inertia).unwrap();
    let about = body.inertia_about(Position::ZERO);
    assert_matrix(
        about.matrix(),
        matrix(&part["inertia_about_p_body"]),
        number(&part["tolerance"]),
        "parallel axis",
    );
    let again = MassProperties::from_inertia_about(body.mass(), center, &about).unwrap();
    assert_matrix(again.inertia().matrix(), inertia.matrix(), 1e-14, "and back");

    let part = &case["rotated"];
    // [DB] of the MRP σ converts body to D components: the transpose of the rotation with that
    // quaternion.
    let [x, y, z] = numbers::<3>(&part["mrp_db"]);
    let s2 = x * x + y * y + z * z;
    let r = Rotation::<Body, Part>::from_quaternion([1.0 - s2, 2.0 * x, 2.0 * y, 2.0 * z]).unwrap();
    assert_matrix(inertia.in_frame(r.inverse()).matrix(), matrix(&part["inertia_d"]), 1e-12, "rotated");

    let part = &case["principal"];
    for (got, want) in body.principal().moments().iter().zip(numbers::<3>(&part["moments"])) {
        assert!((got - want).abs() < number(&part["tolerance"]));
    }
    for (got, want) in body.principal().moments().iter().zip(numbers::<3>(&part["moments_computed"])) {
        assert!((got / want - 1.0).abs() < 1e-15);
    }
    let part = &case["kinetic_energy"];
    let omega = AngularVelocity::from_array(numbers(&part["omega_body"]));
    assert!((Rotor::free(&body).kinetic_energy(omega) - number(&part["kinetic_energy"])).abs() < 1e-15);
}

#[test]
fn schaub_cloud_of_moving_particles() {
    let textbook = table("textbook");
    let case = &textbook["schaub_cloud"];
    let velocities = case["velocities"].as_array().unwrap().iter().map(numbers);
    let moving: Vec<_> = cloud(case)
        .into_iter()
        .zip(velocities)
        .map(|(particle, v)| MovingParticle { particle, velocity: Velocity::from_array(v) })
        .collect();
    let body = mass_properties_of_particles(&cloud(case)).unwrap();
    let v = momentum(&moving) / body.mass();
    let v = Velocity::from_array(v.to_array());
    let split = KineticEnergySplit::of(&moving, v);
    assert!((split.translation - number(&case["kinetic_energy_translation"])).abs() < 1e-12);
    assert!((split.rotation - number(&case["kinetic_energy_relative"])).abs() < 1e-12);
    assert!((split.total() - number(&case["kinetic_energy_total"])).abs() < 1e-12);
    assert!(split.cross.abs() < 1e-12);
    let about = |point, velocity| angular_momentum(&moving, point, velocity);
    let h0 = AngularMomentum::from_array(numbers(&case["momentum_about_origin"]));
    assert!((about(Position::ZERO, Velocity::ZERO) - h0).norm() < 1e-12);
    let hc = AngularMomentum::from_array(numbers(&case["momentum_about_center_of_mass"]));
    assert!((about(body.center_of_mass(), v) - hc).norm() < 1e-12);
}

#[test]
fn gazebo_tensors_are_judged() {
    let textbook = table("textbook");
    for case in cases(&textbook, "gz") {
        let id = case["id"].as_str().unwrap();
        let tensor = InertiaTensor::<Body>::with_negative_products(
            numbers(&case["diagonal"]),
            numbers(&case["off_diagonal"]),
        );
        let computed = numbers::<3>(&case["principal_moments_computed"]);
        let printed = numbers::<3>(&case["principal_moments"]);
        let moments = match tensor {
            Ok(tensor) => {
                assert!(case["possible"].as_bool().unwrap(), "{id} was accepted");
                PrincipalFrame::of(&tensor).moments()
            }
            Err(BodyError::TriangleInequality { moments }) => {
                assert!(!case["possible"].as_bool().unwrap(), "{id} was refused");
                moments
            }
            Err(other) => panic!("{id}: {other}"),
        };
        for k in 0..3 {
            assert!((moments[k] - computed[k]).abs() <= 2e-15 * computed[2], "{id}: {moments:?}");
            assert!((moments[k] - printed[k]).abs() <= number(&case["tolerance"]), "{id}: {moments:?}");
        }
        if let Some(tolerance) = case.get("tolerance_least") {
            assert!((moments[0] - printed[0]).abs() < number(tolerance), "{id}: {moments:?}");
        }
    }
}

/// Returns the attitude after t as modified Rodrigues parameters (x, y, z)/(1 + w), w ≥ 0.
fn mrp(attitude: Attitude) -> [f64; 3] {
    let [w, x, y, z] = attitude.canonical_quaternion();
    [x, y, z].map(|c| c / (1.0 + w))
}

#[test]
fn basilisk_free_rotation() {
    for case in cases(&table("free_top"), "basilisk") {
        let rotor = free_body(numbers(&case["moments"]));
        let motion =
            Trajectory::compute(&rotor, &[], start(case), &[number(&case["t"])], Method::Auto, 1e-14)
                .unwrap();
        let got = mrp(motion.samples()[0].state.attitude);
        let want = numbers::<3>(&case["mrp"]);
        let norm = want.iter().map(|c| c * c).sum::<f64>().sqrt();
        for k in 0..3 {
            assert!((got[k] - want[k]).abs() < number(&case["tolerance"]) * norm, "{got:?} {want:?}");
        }
    }
}

#[test]
fn orekit_torque_free() {
    let fixture = table("free_top");
    let case = fixture["orekit"].as_table().unwrap();
    let (rotor, start) = (free_body(numbers(&case["moments"])), start(case));
    // compared with a rotation at the initial ω: the angle grows as t²
    for row in cases(case, "linear") {
        let window = number(&row["window_s"]);
        let motion = Trajectory::compute(&rotor, &[], start, &[window], Method::Auto, 1e-14).unwrap();
        let linear = start.attitude
            * Rotation::from_axis_angle(
                Direction::from_array(start.omega.to_array()),
                start.omega.norm() * window,
            )
            .unwrap();
        let angle = motion.samples()[0].state.attitude.angle_to(linear);
        assert!((angle - number(&row["angle_rad"])).abs() < number(&row["tolerance"]));
        assert!((angle / number(&row["angle_computed_rad"]) - 1.0).abs() < 1e-6);
    }
    // The direction of L is constant, for every order and sign of moments and rates. The published
    // result is a closed form; this motion is integrated.
    let tolerance = 3.0 * number(&case["momentum_direction_tolerance_rad"]);
    let times: Vec<f64> = (0..=40).map(f64::from).collect();
    let (i, w) = (numbers::<3>(&case["moments"]), [0.05, -0.02, 0.04]);
    for [a, b, c] in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        for signs in 0..8 {
            let sign = |k: usize| if signs >> k & 1 == 0 { 1.0 } else { -1.0 };
            let omega = AngularVelocity::new(sign(0) * w[0], sign(1) * w[1], sign(2) * w[2]);
            let rotor = free_body([i[a], i[b], i[c]]);
            let motion =
                Trajectory::compute(&rotor, &[], State { omega, ..start }, &times, Method::Auto, 1e-15)
                    .unwrap();
            let l0 = motion.samples()[0].momentum;
            for sample in motion.samples() {
                assert!(sample.momentum.angle_to(l0) < tolerance, "{:e}", sample.momentum.angle_to(l0));
            }
        }
    }
}

#[test]
fn principia_symmetric_tops() {
    for case in cases(&table("free_top"), "symmetric") {
        let moments = numbers::<3>(&case["moments"]);
        let l = numbers::<3>(&case["momentum0_body"]);
        let omega = AngularVelocity::from_array([0, 1, 2].map(|k| l[k] / moments[k]));
        let start = State { time: 0.0, attitude: Attitude::identity(), omega };
        if moments == [3.0, 3.0, 9.0] {
            // These moments are not physical; a test next to the closed form uses them.
            assert!(matches!(
                InertiaTensor::<Body>::diagonal(moments),
                Err(BodyError::TriangleInequality { .. })
            ));
            continue;
        }
        let rotor = free_body(moments);
        let motion = FreeMotion::of(&rotor, start).unwrap();
        let axis = case["axis"].as_integer().unwrap() as usize;
        let (transverse, rate) = (number(&case["transverse"]), number(&case["rate_rad_s"]));
        for t in [-12.5, -0.7, 0.0, 0.3, 4.0, 100.0] {
            let got = rotor.angular_momentum(motion.at(t).omega).to_array();
            let mut want = l;
            want[(axis + 1) % 3] = transverse * (rate * t).sin();
            want[(axis + 2) % 3] = transverse * (rate * t).cos();
            for k in 0..3 {
                assert!((got[k] - want[k]).abs() < 1e-13, "t = {t}: {got:?} {want:?}");
            }
        }
    }
}

#[test]
fn geradin_and_cardona_fast_heavy_top() {
    let case = table("heavy_top");
    let inertia = InertiaTensor::from_matrix(matrix(&case["inertia"])).unwrap();
    let arm = Position::from_array(numbers(&case["arm"]));
    let rotor =
        Rotor::pivoted(&MassProperties::new(number(&case["mass"]), arm, inertia).unwrap(), Position::ZERO);
    let acceleration = Acceleration::from_array(numbers(&case["gravity"]));
    let gravity = [TorqueModel::Gravity(UniformGravity { acceleration })];
    for row in cases(&case, "row") {
        let t = number(&row["t"]);
        let motion = Trajectory::compute(&rotor, &gravity, start(&case), &[t], Method::Auto, 1e-13).unwrap();
        let got = motion.samples()[0].state.attitude.continuous_with(attitude(&row["attitude"])).quaternion();
        for (got, want) in got.iter().zip(numbers::<4>(&row["attitude"])) {
            assert!((got - want).abs() < number(&row["tolerance"]), "{got} {want}");
        }
    }
}

#[test]
fn nesc_tumbling_brick() {
    let case = table("nesc_tumbling_brick");
    let rotor =
        free_body(numbers::<3>(&case["moments_slug_ft2"]).map(|i| i * number(&case["slug_ft2_in_kg_m2"])));
    let omega = AngularVelocity::from_array(numbers::<3>(&case["omega0_deg_s"]).map(|w| w * DEG));
    let start = State { time: 0.0, attitude: Attitude::identity(), omega };
    for row in cases(&case, "row") {
        let t = number(&row["t"]);
        let motion = Trajectory::compute(&rotor, &[], start, &[t], Method::Auto, 1e-14).unwrap();
        let state = motion.samples()[0].state;
        for (got, want) in state.omega.to_array().iter().zip(numbers::<3>(&row["rates_deg_s"])) {
            assert!((got / DEG - want).abs() < number(&case["tolerance_rates_deg_s"]), "t = {t}");
        }
        // Local axes (north, east, down) on the equator turn with the Earth and with the brick's
        // longitude about north, which is x of the published axes.
        let turn = number(&case["earth_rate_rad_s"]) * t + number(&row["longitude_deg"]) * DEG;
        let local = Rotation::<Space, Space>::from_axis_angle(Direction::new(-1.0, 0.0, 0.0), turn).unwrap();
        let r = (local * state.attitude).matrix();
        let got = [r[1][0].atan2(r[0][0]), (-r[2][0]).asin(), r[2][1].atan2(r[2][2])];
        for (got, want) in got.iter().zip(numbers::<3>(&row["euler_ypr_deg"])) {
            assert!(
                (got / DEG - want).abs() < number(&case["tolerance_euler_deg"]),
                "t = {t}: {} {want}",
                got / DEG
            );
        }
    }
}

#[test]
fn the_earth_wobbles_in_305_days() {
    let case = table("earth_wobble");
    let check = |excess: f64, turns: f64, ratio: f64| {
        // A rigid Earth with C/A = 1 + excess, its spin slightly off the axis; time in sidereal
        // days.
        let [a, c] = [1.0, 1.0 + excess];
        let omega = AngularVelocity::new(1e-6, 0.0, 2.0 * std::f64::consts::PI);
        let start = State { time: 0.0, attitude: Attitude::identity(), omega };
        let rotor = free_body([a, a, c]);
        let earth = SymmetricTop::of_motion(&FreeMotion::of(&rotor, start).unwrap()).expect("is symmetric");
        let cones = Cones::of(&earth);
        let period = 2.0 * std::f64::consts::PI / cones.body_rate;
        assert!((period / turns - 1.0).abs() < 1e-12, "{period}");
        // this is not the Chandler wobble
        let [low, high] = numbers::<2>(&case["observed_chandler_days"]);
        assert!(!(low..=high).contains(&period));
        let space = 2.0 * std::f64::consts::PI / cones.space_rate;
        assert!((space - ratio).abs() < number(&case["space_period"]["tolerance"]), "{space}");
        period
    };
    let ratio = |key: &str| number(&case["space_period"][key]);
    let period = check(
        number(&case["c_minus_a_over_a"]),
        number(&case["euler_period_turns"]),
        ratio("a_over_c_from_0_00327"),
    );
    assert!((period - number(&case["euler_period_days_printed"])).abs() < number(&case["tolerance_days"]));
    let h = number(&case["from_dynamical_ellipticity"]["h"]);
    // H = (C − A)/C, so (C − A)/A = H/(1 − H)
    check(
        h / (1.0 - h),
        number(&case["from_dynamical_ellipticity"]["euler_period_turns"]),
        ratio("a_over_c_from_h"),
    );
}
