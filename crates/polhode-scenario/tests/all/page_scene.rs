//! Content of a page's 3-D view other than the body: tops, gravity, and a caption for each picture.

use polhode::motion::torque::{Attracted, EnergySink, GravityGradient};
use polhode::motion::{Anomaly, HeavyTop, MU_EARTH, Orbit, OrbitalElements, Sample, TopPath};
use polhode::prelude::*;
use serde_json::Value;

use crate::page::{floats, number, page_of};

/// An inclined cylinder on its tip under gravity along a generic direction, with this spin about
/// its axis, rad/s.
pub(crate) fn top(spin: f64) -> Scenario {
    let disc = Cylinder::new(0.11, 0.05).unwrap();
    let part = crate::common::solid("disc", "cylinder", &disc, 1.7, [0.0, 0.0, 0.14], 0.0);
    let scenario = crate::common::scenario("A top", vec![part]).held_at(Position::ZERO).unwrap();
    let scenario = crate::common::facing(scenario, Attitude::from_quaternion([0.9, 0.2, -0.1, 0.3]).unwrap());
    let scenario = crate::common::spinning(scenario, AngularVelocity::new(0.3, -0.2, 10.0 * spin));
    let gravity = UniformGravity { acceleration: Acceleration::new(1.1, -0.7, -9.2) };
    scenario.with_torques(vec![TorqueModel::Gravity(gravity)]).unwrap().sampled(crate::common::run(3.0, 601))
}

#[test]
fn the_equivalent_box_and_ellipsoid_have_the_body_s_tensor() {
    // Two inclined boxes, free and suspended; their shapes are about the centre of mass in both
    // cases.
    let part = |size, place: [f64; 3], angle| {
        let shape = BoxShape::new(size).unwrap();
        crate::common::solid("part", "box", &shape, 1.3, place, angle)
    };
    let parts =
        || vec![part([0.2, 0.5, 0.3], [0.1, -0.2, 0.4], 0.7), part([0.4, 0.1, 0.15], [-0.3, 0.2, 0.1], -0.4)];
    let free = crate::common::scenario("free", parts());
    let held = crate::common::scenario("held", parts()).held_at(Position::new(0.3, 0.2, -0.5)).unwrap();
    for scenario in [free, held] {
        let omega = AngularVelocity::new(0.3, -0.2, 1.0);
        let scenario = crate::common::spinning(scenario, omega).sampled(crate::common::run(0.1, 3));
        let (data, _) = page_of(&scenario);
        let numbers = |value: &Value| -> Vec<f64> { value.as_array().unwrap().iter().map(number).collect() };
        // I = R diag(m (b² + c²) / n, …) Rᵀ, with n = 12 for the edges of a box, and n = 5 for the
        // semi-axes of an ellipsoid.
        for (shape, key, n) in [("box", "size", 12.0), ("ellipsoid", "half", 5.0)] {
            let [size, turn] = [key, "quaternion"].map(|key| numbers(&data["body"][shape][key]));
            let rotation = Attitude::from_quaternion(turn.try_into().unwrap()).unwrap().matrix();
            let (body, square) = (scenario.body(), |k: usize| size[k % 3] * size[k % 3]);
            let moment = |k: usize| body.mass() / n * (square(k + 1) + square(k + 2));
            for (i, row) in body.inertia().matrix().iter().enumerate() {
                for (j, element) in row.iter().enumerate() {
                    let found: f64 = (0..3).map(|k| moment(k) * rotation[i][k] * rotation[j][k]).sum();
                    assert!((found - element).abs() < 1e-14, "{shape} {i} {j}: {found} {element}");
                }
            }
        }
    }
}

#[test]
fn the_orbit_is_that_of_the_gravity_gradient() {
    let elements = OrbitalElements {
        semi_major_axis: 9.1e6,
        eccentricity: 0.23,
        inclination: 0.9,
        node: 2.1,
        periapsis: -0.7,
        anomaly: Anomaly::Mean(0.4),
    };
    let ellipse = Orbit::of_elements(MU_EARTH, &elements).unwrap();
    let radial = Direction::new(0.48, -0.6, 0.64);
    let circle = Orbit::circular(4.2e13, 5.1e6, radial, Direction::new(0.8, 0.0, -0.6)).unwrap();
    let hyperbola = OrbitalElements { semi_major_axis: -8.0e6, eccentricity: 1.9, ..elements };
    let hyperbola = Orbit::of_elements(MU_EARTH, &hyperbola).unwrap();
    for (orbit, central) in [(ellipse, Some(6.378137e6)), (circle, None), (hyperbola, Some(6.378137e6))] {
        let gradient = GravityGradient { orbit: orbit.clone(), attracted: Attracted::Tensor };
        let scenario = crate::common::thruster().in_orbit(orbit.clone()).unwrap();
        let scenario = scenario.with_torques(vec![TorqueModel::GravityGradient(Box::new(gradient))]).unwrap();
        let (data, trajectory) = page_of(&scenario.sampled(crate::common::run(4000.0, 41)));
        let found = &data["scene"]["orbit"];
        let three = |key: &str| std::array::from_fn::<f64, 3, _>(|k| number(&found[key][k]));
        let [e, normal] = ["eccentricity", "normal"].map(|key| Direction::<Space>::from_array(three(key)));
        assert_eq!(found["central"].as_f64(), central);
        assert!((e.norm() - orbit.eccentricity()).abs() < 1e-14 && e.dot(normal).abs() < 1e-14);
        // r = p/(1 + e · r̂) at the nadir of each sample, which is rounded to f32.
        let nadir = floats(&data["motion"]["directions"][0]["values"]);
        for (sample, nadir) in trajectory.samples().iter().zip(nadir.chunks_exact(3)) {
            let out = Direction::<Space>::from_array(std::array::from_fn(|k| -f64::from(nadir[k])));
            let place = (out * (number(&found["parameter"]) / (1.0 + e.dot(out)))).to_array();
            let wanted = orbit.position(sample.state.time).to_array();
            let size = wanted.iter().map(|x| x * x).sum::<f64>().sqrt();
            for (found, wanted) in place.iter().zip(wanted) {
                assert!((found - wanted).abs() < 5e-7 * size, "{found} {wanted}");
            }
            assert!(normal.dot(out).abs() < 2e-7);
        }
    }
    assert!(page_of(&crate::common::thruster()).0["scene"]["orbit"].is_null());
}

#[test]
fn a_top_has_its_axis_its_bounds_and_gravity() {
    let (data, trajectory) = page_of(&top(9.0));
    let scene = &data["scene"];
    let three = |value: &Value| -> [f64; 3] { std::array::from_fn(|k| number(&value[k])) };
    let g = three(&scene["gravity"]);
    assert_eq!(g, [1.1, -0.7, -9.2]);
    let axis = polhode::math::Direction::<polhode::math::Body>::from_array(three(&data["top"]["axis"]));
    assert!((axis.norm() - 1.0).abs() < 1e-15 && axis.z > 0.999_999);
    // The samples lie between the bounds, and come close to both.
    let size = g.iter().map(|x| x * x).sum::<f64>().sqrt();
    let leaning = |sample: &Sample| {
        let e = (sample.state.attitude * axis).to_array();
        (-e.iter().zip(g).map(|(x, g)| x * g).sum::<f64>() / size).acos()
    };
    let angles: Vec<f64> = trajectory.samples().iter().map(leaning).collect();
    let [least, most] =
        [angles.iter().copied().fold(9.0, f64::min), angles.iter().copied().fold(0.0, f64::max)];
    let bounds = &data["top"]["bounds"];
    let [first, second] = [number(&bounds[0]), number(&bounds[1])];
    assert!(first <= least + 1e-12 && most <= second + 1e-12, "{first} {least} {most} {second}");
    assert!(least - first < 1e-3 && second - most < 1e-3, "{first} {least} {most} {second}");
    // The period is that of the precession: the axis returns to its azimuth about the vertical,
    // except for the nutation.
    let period = number(&scene["period"]);
    let up = polhode::math::Direction::<polhode::math::Space>::from_array(g.map(|x| -x / size));
    let flat = |sample: &Sample| {
        let e = sample.state.attitude * axis;
        e - up * up.dot(e)
    };
    let mut turned = 0.0;
    for pair in trajectory.samples().windows(2) {
        let [a, b] = [flat(&pair[0]), flat(&pair[1])];
        turned += up.dot(a.cross(b)).atan2(a.dot(b));
    }
    let mean = turned.abs() / (2.0 * std::f64::consts::PI) * period / 3.0;
    assert!((mean - 1.0).abs() < 0.05, "{mean} turns in {period} s");
    let caption = scene["captions"]["body"].as_str().unwrap();
    let shown = format!("θ₁ = {:.2}", first.to_degrees());
    assert!(caption.contains(&shown) && caption.contains("precesses once in"), "{caption}");
    assert!(scene["captions"]["cones"].is_null());
}

#[test]
fn a_top_through_the_vertical_has_no_precession_to_be_seen() {
    let inertia = InertiaTensor::diagonal([0.021, 0.021, 0.034]).unwrap();
    let body = MassProperties::new(1.3, Position::new(0.0, 0.0, 0.13), inertia).unwrap();
    let attitude = Attitude::from_euler313([0.4, 0.0, -0.7]).unwrap();
    let start = State { time: 0.0, attitude, omega: AngularVelocity::new(0.7, -0.4, 5.0) };
    let gravity = [TorqueModel::Gravity(UniformGravity::STANDARD)];
    let scenario =
        Scenario::new(body).titled("Through").held_at(Position::ZERO).unwrap().starting(start).unwrap();
    let scenario = scenario.with_torques(gravity).unwrap().sampled(crate::common::run(3.0, 601));
    let top = HeavyTop::of(scenario.rotor(), &UniformGravity::STANDARD, start).unwrap();
    assert_eq!(top.path(), TopPath::ThroughVertical);
    let (data, _) = page_of(&scenario);
    let caption = data["scene"]["captions"]["body"].as_str().unwrap();
    assert!(caption.contains("The axis nutates between") && !caption.contains("precesses"), "{caption}");
    assert_eq!(number(&data["scene"]["period"]), top.nutation_period().unwrap());
}

#[test]
fn a_rods_inertia_ellipsoid_is_a_cylinder() {
    let rod = crate::common::rod();
    let of = |scenario: &Scenario| page_of(scenario).0["scene"]["captions"].clone();
    let moving = of(&rod);
    let text = |captions: &Value, picture: &str| captions[picture].as_str().unwrap().to_owned();
    let poinsot = text(&moving, "poinsot");
    assert!(poinsot.contains("is a cylinder") && poinsot.contains("along a line"), "{poinsot}");
    assert!(!poinsot.contains("rolls") && poinsot.contains("traces the polhode"), "{poinsot}");
    assert!(text(&moving, "sphere").contains("great circle across the rod"), "{moving}");
    // (0.3, −0.4, 1.2) is along the rod.
    let across = AngularVelocity::new(0.4, 0.9, 0.2);
    let permanent = of(&crate::common::spinning(rod, across));
    let poinsot = text(&permanent, "poinsot");
    assert!(
        poinsot.contains("is a cylinder") && poinsot.ends_with("along a line: ω stays along L."),
        "{poinsot}"
    );
    assert!(text(&permanent, "cones").starts_with("A permanent rotation"), "{permanent}");
    assert!(text(&permanent, "sphere").starts_with("L is constant in the body"), "{permanent}");
}

#[test]
fn captions_say_what_is_seen() {
    let caption = |scenario: &Scenario, picture: &str| {
        page_of(scenario).0["scene"]["captions"][picture].as_str().unwrap().to_owned()
    };
    let wheel = crate::common::symmetric_top();
    // Cylinder of radius 0.3 m and length 0.1 m: I_e/I_t = r²/2 / (r²/4 + l²/12). Its axis is
    // rotated by 0.7 rad about z.
    let cones = caption(&wheel, "cones");
    let ratio = 0.045 / (0.0225 + 0.01 / 12.0);
    let gamma = 0.5_f64.atan2(2.0);
    let between = gamma - (gamma.tan() / ratio).atan();
    for angle in [gamma, between] {
        let shown = format!("{:.2}°", angle.to_degrees());
        assert!(cones.contains(&shown), "{cones}: {shown}");
    }
    assert!(cones.contains("inside it: retrograde precession"), "{cones}");
    let handle = crate::common::t_handle();
    assert!(caption(&handle, "cones").contains("neither is circular"));
    assert!(caption(&handle, "sphere").contains("separatrices"));
    assert!(!caption(&wheel, "sphere").contains("separatrices"));
    for scenario in [&wheel, &handle] {
        assert!(caption(scenario, "poinsot").contains("2T/|L| = "));
        assert!(caption(scenario, "body").contains("L is constant in space"));
    }
    let inside = caption(&crate::common::gyrostat(), "body");
    assert!(
        inside.contains("L = Iω + h") && inside.contains("held at its speed") && inside.contains("from 1.5"),
        "{inside}"
    );
    assert!(caption(&crate::common::gyroscope(), "body").contains("prescribed"));
    // Internal friction is not an external torque. Together with another torque it is not listed
    // among the external ones.
    let sink = TorqueModel::EnergySink(EnergySink::new(0.01).unwrap());
    let push = TorqueModel::Constant(ConstantTorque::Body(Torque::new(1e-5, 2e-5, -3e-5)));
    let inside = caption(&handle.clone().with_torques(vec![sink.clone()]).unwrap(), "body");
    let cause =
        "No torque from outside: L is constant in space. Friction inside the body takes kinetic energy.";
    assert!(inside.starts_with("|ω| goes from 12 to ") && inside.ends_with(cause), "{inside}");
    let both = caption(&handle.with_torques(vec![push, sink]).unwrap(), "body");
    assert!(both.contains(" Torque N: constant in body axes; dL/dt = N. Friction inside"), "{both}");
}
