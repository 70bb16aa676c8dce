//! Rotation of bodies on orbits: gravity gradient and magnets, compared with integrations in
//! 50 digits, published runs and closed forms (fixtures/ describes how they were computed).

use crate::common::*;
use polhode::body::Symmetry;
use polhode::math::AngularAcceleration;
use polhode::math::elliptic::EllipticParameter;
use polhode::motion::torque::{Attracted, GravityGradient, Magnetic, MagneticField};
use polhode::motion::{MU_EARTH, Motor, Orbit};
use polhode::prelude::*;

const METHODS: [Method; 2] = [Method::Dop853, Method::Taylor];

fn magnet(moment: [f64; 3], field: MagneticField) -> TorqueModel {
    TorqueModel::Magnetic(Box::new(Magnetic { moment: Direction::from_array(moment), field }))
}

fn gradient(orbit: &Orbit, attracted: Attracted) -> TorqueModel {
    TorqueModel::GravityGradient(Box::new(GravityGradient { orbit: orbit.clone(), attracted }))
}

fn generic_body() -> Rotor {
    let inertia = InertiaTensor::with_negative_products([1.3, 2.1, 2.9], [0.1, -0.2, 0.15]).unwrap();
    Rotor::free(&MassProperties::new(2.3, Position::new(0.3, -0.1, 0.2), inertia).unwrap())
}

fn generic_orbit() -> Orbit {
    Orbit::through(2.3, Position::new(1.4, -0.6, 0.9), Velocity::new(0.5, 1.1, -0.4), -0.3).unwrap()
}

fn generic_points() -> Vec<Particle<Body>> {
    [
        (1.5, [0.59, -0.02, 0.04]),
        (0.7, [0.34, 0.11, 0.03]),
        (2.2, [0.41, 0.05, -0.13]),
        (1.1, [0.32, -0.09, 0.02]),
    ]
    .map(|(m, p)| Particle::new(m, Position::from_array(p)).unwrap())
    .to_vec()
}

fn generic_start() -> State {
    State {
        time: 0.0,
        attitude: Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap(),
        omega: AngularVelocity::new(0.2, -0.3, 0.4),
    }
}

/// Returns a case of fixtures/orbits.toml.
fn case(case: &toml::Table) -> (Orbit, Rotor, TorqueModel) {
    let mu = number(&case["mu"]);
    let position = Position::from_array(numbers(&case["position"]));
    let velocity = Velocity::from_array(numbers(&case["velocity"]));
    let orbit = if case["name"].as_str().unwrap().contains("circle") {
        let (radial, motion) = (position.direction().unwrap(), velocity.direction().unwrap());
        Orbit::circular_at_rate(mu, mu.sqrt(), radial, motion).unwrap()
    } else {
        Orbit::through(mu, position, velocity, 0.0).unwrap()
    };
    if let Some(points) = case.get("points") {
        let points = points.as_array().unwrap().iter().map(|point| {
            let [mass, x, y, z] = numbers(point);
            Particle::<Body>::new(mass, Position::new(x, y, z)).unwrap()
        });
        let points: Vec<_> = points.collect();
        let rotor = Rotor::free(&mass_properties_of_particles(&points).unwrap());
        let torque = gradient(&orbit, Attracted::Points(points));
        return (orbit, rotor, torque);
    }
    let inertia = InertiaTensor::from_matrix(matrix(&case["inertia"])).unwrap();
    let rotor = Rotor::free(&MassProperties::new(1.7, Position::new(0.2, 0.1, -0.4), inertia).unwrap());
    let torque = match case.get("moment") {
        None => gradient(&orbit, Attracted::Tensor),
        Some(moment) => {
            let dipole = Direction::from_array(numbers(&case["dipole"]));
            magnet(numbers(moment), MagneticField::Dipole { dipole, orbit: orbit.clone() })
        }
    };
    (orbit, rotor, torque)
}

#[test]
fn bodies_on_orbits_follow_the_reference() {
    let table = table("orbits");
    let list = cases(&table, "case");
    assert_eq!(list.len(), 5);
    for entry in list {
        let name = entry["name"].as_str().unwrap();
        let (orbit, rotor, torque) = case(entry);
        let start = start(entry);
        let torque0 = Torque::from_array(numbers(&entry["torque0"]));
        assert!((torque.torque(&rotor, &start) - torque0).norm() < 2e-15 * (torque0.norm() + 1.0), "{name}");
        for row in cases(entry, "row") {
            let t = number(&row["t"]);
            let (r, v): ([f64; 3], [f64; 3]) = (numbers(&row["position"]), numbers(&row["velocity"]));
            assert!((orbit.position(t) - Position::from_array(r)).norm() < 1e-15 * (4.0 + t), "{name} {t}");
            assert!((orbit.velocity(t) - Velocity::from_array(v)).norm() < 1e-15 * (4.0 + t), "{name} {t}");
            for method in METHODS {
                let motion =
                    Trajectory::compute(&rotor, std::slice::from_ref(&torque), start, &[t], method, 1e-15)
                        .unwrap();
                let state = motion.samples()[0].state;
                let omega = AngularVelocity::from_array(numbers(&row["omega"]));
                let error = (state.omega - omega).norm() / omega.norm();
                let angle = state.attitude.angle_to(attitude(&row["attitude"]));
                // measured: at most 1.7e-14 (DOP853) and 3.7e-15 (Taylor) at t = 8, 6e-15 at t = 20
                let bound = 3e-15 * (2.0 + t);
                assert!(error < bound && angle < bound, "{name} t = {t} {method:?}: {error:e} {angle:e}");
            }
        }
    }
}

/// Returns `R_space_body` from a published `R_body_space`.
fn published_attitude(row: &toml::Table) -> Attitude {
    let t = matrix(&row["transform"]);
    Rotation::<Body, Space>::from_matrix(t).unwrap().inverse()
}

#[test]
fn the_cylinder_librates_as_nasa_says() {
    let table = table("nesc_gravity_gradient");
    let case = table["cylinder"].as_table().unwrap();
    let shape = Cylinder::new(number(&case["radius"]), number(&case["length"])).unwrap();
    let solid = shape.mass_properties(Substance::Mass(number(&case["mass"]))).unwrap();
    let along_x =
        Rotation::from_axis_angle(Direction::new(0.0, 1.0, 0.0), std::f64::consts::FRAC_PI_2).unwrap();
    let body = assemble(&[PlacedPart::new(solid, Position::ZERO, along_x).unwrap()]).unwrap();
    let moments: [f64; 3] = numbers(&case["moments"]);
    for (k, moment) in moments.iter().enumerate() {
        assert!((body.inertia().matrix()[k][k] / moment - 1.0).abs() < 1e-14);
    }
    let rotor = Rotor::free(&body);
    let position = Position::from_array(numbers(&case["position"]));
    let velocity = Velocity::from_array(numbers(&case["velocity"]));
    let orbit = Orbit::through(number(&table["mu"]), position, velocity, 0.0).unwrap();
    let torque = [gradient(&orbit, Attracted::Tensor)];
    let rows = cases(case, "row");
    let omega = |row: &toml::Table| AngularVelocity::<Body>::from_array(numbers(&row["omega"]));
    let start = State { time: 0.0, attitude: published_attitude(rows[0]), omega: omega(rows[0]) };
    for row in rows {
        let t = number(&row["t"]);
        if let Some(place) = row.get("position") {
            let error = orbit.position(t) - Position::from_array(numbers(place));
            assert!(error.norm() < number(&case["tolerance_position_m"]), "{t}: {error:?}");
        }
        for method in METHODS {
            let motion = Trajectory::compute(&rotor, &torque, start, &[t], method, 1e-14).unwrap();
            let state = motion.samples()[0].state;
            let error = (state.omega - omega(row)).norm();
            assert!(error < number(&case["tolerance_omega_rad_s"]), "{t} {method:?}: {error:e}");
            let angle = state.attitude.angle_to(published_attitude(row));
            assert!(angle < number(&case["tolerance_attitude_rad"]), "{t} {method:?}: {angle:e}");
            assert!(Drift::of(&motion).unwrap().work_energy < 1e-11);
            if method == Method::Dop853 {
                // ω̇ = I⁻¹ (N − ω × L), along the axes of the cylinder
                let n = motion.samples()[0].torque - state.omega.cross(rotor.angular_momentum(state.omega));
                let rate =
                    AngularAcceleration::<Body>::new(n.x / moments[0], n.y / moments[1], n.z / moments[2]);
                let want = AngularAcceleration::from_array(numbers(&row["omega_dot"]));
                assert!((rate - want).norm() < 1e-8 * want.norm(), "{t}: {rate:?} {want:?}");
            }
        }
    }
}

#[test]
fn the_sphere_keeps_its_rate() {
    let table = table("nesc_gravity_gradient");
    let case = table["sphere"].as_table().unwrap();
    let shape = Sphere::new(number(&case["radius"])).unwrap();
    let part = shape.mass_properties(Substance::Mass(number(&case["mass"]))).unwrap();
    let body = assemble(&[PlacedPart::new(part, Position::ZERO, Rotation::identity()).unwrap()]).unwrap();
    let cylinder = table["cylinder"].as_table().unwrap();
    let position = Position::from_array(numbers(&cylinder["position"]));
    let velocity = Velocity::from_array(numbers(&cylinder["velocity"]));
    let orbit = Orbit::through(number(&table["mu"]), position, velocity, 0.0).unwrap();
    let rows = cases(case, "row");
    let omega = AngularVelocity::<Body>::from_array(numbers(&rows[0]["omega"]));
    let start = State { time: 0.0, attitude: published_attitude(rows[0]), omega };
    let t = number(&rows[1]["t"]);
    // Free, and with a gravity gradient, which has no torque on a spherical body.
    let gradient = [gradient(&orbit, Attracted::Tensor)];
    for (torques, method) in
        [(&[][..], Method::Auto), (&gradient[..], Method::Taylor), (&gradient[..], Method::Dop853)]
    {
        let motion = Trajectory::compute(&Rotor::free(&body), torques, start, &[t], method, 1e-14).unwrap();
        let state = motion.samples()[0].state;
        let angle = state.attitude.angle_to(published_attitude(rows[1]));
        assert!(angle < number(&case["tolerance_attitude_rad"]), "{method:?}: {angle:e}");
        assert!((state.omega - omega).norm() < 1e-15);
    }
}

#[test]
fn energy_less_n_l_is_constant_on_a_circle() {
    // In axes that turn with the orbit, gravity is constant: T + U − n L·ẑ, ẑ along the orbit
    // normal.
    let (radial, motion) = (Direction::new(0.3, -1.2, 0.7), Direction::new(1.0, 0.4, 2.0));
    let rate = 0.45;
    let orbit = Orbit::circular_at_rate(0.4, rate, radial, motion).unwrap();
    let normal = radial.cross(motion).direction().unwrap();
    let points = generic_points();
    let body = Rotor::free(&mass_properties_of_particles(&points).unwrap());
    for (rotor, attracted) in [(generic_body(), Attracted::Tensor), (body, Attracted::Points(points))] {
        let model = GravityGradient { orbit: orbit.clone(), attracted };
        let torque = [TorqueModel::GravityGradient(Box::new(model.clone()))];
        let integral = |sample: &Sample| {
            sample.kinetic_energy + model.potential(&rotor, &sample.state)
                - rate * normal.dot(sample.momentum)
        };
        let times: Vec<f64> = (0..=40).map(f64::from).collect();
        for method in METHODS {
            let run = Trajectory::compute(&rotor, &torque, generic_start(), &times, method, 1e-14).unwrap();
            let first = integral(run.start());
            let energies = run.samples().iter().map(|sample| sample.kinetic_energy);
            let (least, most) = energies.fold((f64::MAX, f64::MIN), |(a, b), t| (a.min(t), b.max(t)));
            assert!(most > 1.1 * least);
            for sample in run.samples() {
                let error = (integral(sample) - first).abs() / most;
                assert!(error < 2e-13, "{method:?} t = {}: {error:e}", sample.state.time);
            }
        }
    }
}

#[test]
fn the_pitch_of_a_satellite_has_its_period() {
    // Axes along the track (x), the orbit normal (y) and up (z): ω² = 3 n² (Ix − Iz)/Iy for small
    // librations. For any amplitude, 2θ is a pendulum's angle: T = 4 K(sin² θ₀)/ω.
    let (ix, iy, iz) = (8.2, 9.1, 1.7);
    let inertia = InertiaTensor::diagonal([ix, iy, iz]).unwrap();
    let rotor = Rotor::free(&MassProperties::new(40.0, Position::ZERO, inertia).unwrap());
    let (up, track) = (Direction::new(0.3, -1.2, 0.7), Direction::new(1.0, 0.4, 2.0));
    let orbit = Orbit::circular(MU_EARTH, 6.9e6, up, track).unwrap();
    let n = orbit.mean_motion().unwrap();
    let up = up.direction().unwrap();
    let normal = up.cross(track).direction().unwrap();
    let track = normal.cross(up);
    let upright = |angle: f64| {
        let columns = [track, normal, up].map(Direction::to_array);
        let rows = [0, 1, 2].map(|k| columns.map(|column| column[k]));
        Rotation::<Space, Body>::from_matrix(rows).unwrap()
            * Rotation::<Body, Body>::from_axis_angle(Direction::new(0.0, 1.0, 0.0), angle).unwrap()
    };
    let frequency = n * (3.0 * (ix - iz) / iy).sqrt();
    for amplitude in [1e-3, 0.7] {
        let k = EllipticParameter::new(f64::sin(amplitude).powi(2)).unwrap().k();
        let period = 4.0 * k / frequency;
        assert!(amplitude > 0.1 || (period * frequency / std::f64::consts::TAU - 1.0).abs() < 3e-7);
        // At the end of its swing it turns with the orbit.
        let start =
            State { time: 0.0, attitude: upright(amplitude), omega: AngularVelocity::new(0.0, n, 0.0) };
        let times = [0.25, 0.5, 1.0, 3.0].map(|k| k * period);
        for method in METHODS {
            let run = Trajectory::compute(
                &rotor,
                &[gradient(&orbit, Attracted::Tensor)],
                start,
                &times,
                method,
                1e-14,
            );
            for (sample, angle) in run.unwrap().samples().iter().zip([0.0, -amplitude, amplitude, amplitude])
            {
                let state = sample.state;
                let carried = Rotation::<Space, Space>::from_axis_angle(normal, n * state.time).unwrap()
                    * upright(angle);
                let error = state.attitude.angle_to(carried);
                assert!(error < 1e-11, "{method:?} {amplitude} t = {}: {error:e}", state.time);
            }
        }
    }
}

#[test]
fn a_compass_swings_at_root_m_b_over_i() {
    let inertia = InertiaTensor::diagonal([1.3e-7, 4.1e-8, 1.6e-7]).unwrap();
    let rotor = Rotor::free(&MassProperties::new(2e-3, Position::ZERO, inertia).unwrap());
    let (moment, strength) = (0.03, 4.7e-5);
    let field = Direction::new(0.0, strength, 0.0);
    let torque = [magnet([0.0, moment, 0.0], MagneticField::Uniform(field))];
    let frequency = (moment * strength / 1.6e-7_f64).sqrt();
    let amplitude = 1e-4;
    let attitude = Attitude::from_axis_angle(Direction::new(0.0, 0.0, 1.0), amplitude).unwrap();
    let start = State { time: 0.0, attitude, omega: AngularVelocity::ZERO };
    for method in METHODS {
        let times = [0.3, 1.1, 2.7].map(|t| t / frequency);
        let run = Trajectory::compute(&rotor, &torque, start, &times, method, 1e-14).unwrap();
        for sample in run.samples() {
            let [_, _, _, z] = sample.state.attitude.canonical_quaternion();
            let want = amplitude * (frequency * sample.state.time).cos();
            // the next term is θ³/6
            assert!((2.0 * z - want).abs() < amplitude.powi(3), "{method:?}: {z} {want}");
            let energy = sample.kinetic_energy + sample.potential_energy.unwrap();
            assert!((energy + moment * strength * amplitude.cos()).abs() < 1e-15 * moment * strength);
        }
    }
}

#[test]
fn both_integrators_agree_and_the_theorems_hold() {
    let motor = Motor::Torque { inertia: 0.2, torque: 0.05, schedule: None };
    let wheel = Wheel::new(Direction::new(0.5, -0.3, 0.9), 0.6, motor).unwrap();
    let wheeled = generic_body().with_wheels(&[wheel]).unwrap();
    let points = generic_points();
    let cloud = Rotor::free(&mass_properties_of_particles(&points).unwrap());
    let orbit = generic_orbit();
    let flyby =
        Orbit::through(2.3, Position::new(3.4, -1.6, 0.9), Velocity::new(-1.5, 1.7, -0.4), 0.0).unwrap();
    assert!(orbit.period().is_some() && flyby.period().is_none());
    let dipole = Direction::new(-3e6, 5e6, 8e6);
    let circle =
        Orbit::circular(0.4, 1.2, Direction::new(0.3, -1.2, 0.7), Direction::new(1.0, 0.4, 2.0)).unwrap();
    let uniform = MagneticField::Uniform(Direction::new(0.2, -0.5, 0.3));
    for (name, rotor, torques) in [
        ("wheel", wheeled, vec![gradient(&orbit, Attracted::Tensor)]),
        ("points", cloud.clone(), vec![gradient(&orbit, Attracted::Points(points.clone()))]),
        (
            "flyby",
            cloud,
            vec![gradient(&flyby, Attracted::Points(points)), gradient(&flyby, Attracted::Tensor)],
        ),
        (
            "dipole on a circle",
            generic_body(),
            vec![magnet([0.4, 1.2, -0.7], MagneticField::Dipole { dipole, orbit: circle })],
        ),
        ("uniform field", generic_body(), vec![magnet([0.4, 1.2, -0.7], uniform)]),
    ] {
        let run = |method| {
            let motion =
                Trajectory::compute(&rotor, &torques, generic_start(), &[6.0], method, 1e-15).unwrap();
            let drift = Drift::of(&motion).unwrap();
            let sample = motion.samples()[0];
            assert!(drift.work_energy < 1e-13, "{name} {method:?}: {drift:?}");
            // the impulse on motor-driven wheels is included in L, and therefore in the drift
            assert!(drift.momentum < 1e-13, "{name} {method:?}: {drift:?}");
            assert!(sample.work.abs() > 1e-3 && sample.impulse.norm() > 1e-2, "{name}: nothing happened");
            sample.state
        };
        let [a, b] = METHODS.map(run);
        let (angle, omega) = (a.attitude.angle_to(b.attitude), (a.omega - b.omega).norm());
        assert!(angle < 1e-13 && omega < 1e-13, "{name}: {angle:e} {omega:e}");
    }
}

#[test]
fn a_rod_keeps_the_spin_that_nothing_determines() {
    let along = Direction::<Body>::new(0.3, -0.5, 0.8);
    let points: Vec<_> = [(1.0, -0.3), (2.0, 0.1), (0.7, 0.4)]
        .map(|(m, s)| Particle::new(m, Position::from_array((along * s).to_array())).unwrap())
        .to_vec();
    let rotor = Rotor::free(&mass_properties_of_particles(&points).unwrap());
    assert_eq!(rotor.principal().symmetry(), Symmetry::Rod);
    let start = State { omega: rotor_spin(&rotor), ..generic_start() };
    for attracted in [Attracted::Tensor, Attracted::Points(points)] {
        let [a, b] = METHODS.map(|method| {
            let torque = [gradient(&generic_orbit(), attracted.clone())];
            let run = Trajectory::compute(&rotor, &torque, start, &[5.0], method, 1e-14).unwrap();
            run.samples()[0].state
        });
        assert!(a.attitude.angle_to(b.attitude) < 1e-11 && (a.omega - start.omega).norm() > 0.1);
        let axis = rotor.principal().axis(0);
        assert!((axis.dot(a.omega) - axis.dot(start.omega)).abs() < 1e-14);
    }
}

fn rotor_spin(rotor: &Rotor) -> AngularVelocity<Body> {
    let [a, b, c] = rotor.principal().axes();
    AngularVelocity::from_array((a * 0.2 + b * 0.3 - c * 0.1).to_array())
}
