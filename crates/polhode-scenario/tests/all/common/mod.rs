//! Scenarios for the tests.
#![allow(dead_code, unreachable_pub, reason = "each test file uses some of them")]

pub mod ground;
pub mod held;
pub mod page;

use std::sync::OnceLock;

use polhode::body::{BodyPart, Finding, PlacedForm, Severity};
use polhode::motion::torque::Schedule;
use polhode::motion::{Motor, Prescribed, Run, Suspension};
use polhode::prelude::*;
use polhode_document::Document;
use polhode_scenario::report::{explain, explain_motion};
use polhode_scenario::symbolic::Exact;

/// Returns a part that consists of particles.
pub fn particles(list: &[(f64, [f64; 3])]) -> BodyPart {
    let particles: Vec<_> =
        list.iter().map(|(m, p)| Particle::new(*m, Position::from_array(*p)).unwrap()).collect();
    BodyPart {
        name: "masses".to_owned(),
        kind: "particles",
        properties: mass_properties_of_particles(&particles).unwrap(),
        extent: None,
        surface_area: None,
        particles,
        form: None,
    }
}

/// Returns a solid part at a position, rotated about z.
pub fn solid(
    name: &str,
    kind: &'static str,
    shape: &dyn Shape,
    mass: f64,
    at: [f64; 3],
    turn: f64,
) -> BodyPart {
    let properties = shape.mass_properties(Substance::Mass(mass)).unwrap();
    let rotation = Rotation::from_axis_angle(Direction::new(0.0, 0.0, 1.0), turn).unwrap();
    BodyPart {
        name: name.to_owned(),
        kind,
        properties: PlacedPart::new(properties, Position::from_array(at), rotation).unwrap().in_body(),
        extent: Some(shape.spread().extent()),
        surface_area: Some(shape.surface_area()),
        particles: Vec::new(),
        form: shape.form().map(|form| PlacedForm { form, position: Position::from_array(at), rotation }),
    }
}

/// Returns a scenario without motion.
pub fn scenario(title: &str, parts: Vec<BodyPart>) -> Scenario {
    let properties: Vec<_> = parts.iter().map(|part| part.properties).collect();
    let body = MassProperties::combined(&properties).unwrap();
    at_rest(title, body, parts)
}

fn at_rest(title: &str, body: MassProperties<Body>, parts: Vec<BodyPart>) -> Scenario {
    Scenario::new(body).titled(title).made_of(parts)
}

/// Replaces the initial ω.
pub fn spinning(s: Scenario, omega: AngularVelocity<Body>) -> Scenario {
    let start = State { omega, ..s.start() };
    s.starting(start).unwrap()
}

/// Replaces the initial attitude.
pub fn facing(s: Scenario, attitude: Attitude) -> Scenario {
    let start = State { attitude, ..s.start() };
    s.starting(start).unwrap()
}

/// Returns a scenario of a body given by its tensor, with initial ω.
pub fn tensor(title: &str, moments: [f64; 3], products: [f64; 3], omega: [f64; 3]) -> Scenario {
    let inertia = InertiaTensor::with_negative_products(moments, products).unwrap();
    let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
    let mut s = at_rest(title, body, Vec::new());
    s = spinning(s, AngularVelocity::from_array(omega));
    s
}

pub fn run(duration: f64, samples: usize) -> Run {
    Run::evenly(duration, samples, Method::Auto, 1e-13)
}

/// Example 11.10 of the notes, with different masses: m1, m2, b, ω, α.
pub const DUMBBELL: [f64; 5] = [1.2, 0.7, 0.5, 3.0, 0.6];

pub fn dumbbell() -> Scenario {
    let [m1, m2, b, omega, alpha] = DUMBBELL;
    let mut s = scenario(
        "The dumbbell of example 11.10",
        vec![particles(&[(m1, [0.0, 0.0, b]), (m2, [0.0, 0.0, -b])])],
    );
    s = s.held_at(Position::ZERO).unwrap();
    let axis = Direction::new(0.0, alpha.sin(), alpha.cos());
    s = s.prescribed_as(Prescribed::fixed_axis(Attitude::identity(), axis, omega, 0.0).unwrap()).unwrap();
    s = s.sampled(run(2.0, 21));
    s
}

/// Example 11.4: m1, m2, b, g, θ0.
pub const PENDULUM: [f64; 5] = [0.9, 0.4, 1.3, 9.81, 0.2];

pub fn pendulum() -> Scenario {
    let [m1, m2, b, g, angle] = PENDULUM;
    let masses = particles(&[(m1, [b, 0.0, 0.0]), (m2, [0.5 * b, 0.0, 0.0])]);
    let mut s = scenario("The pendulum of example 11.4", vec![masses]);
    s = s.held_at(Position::ZERO).unwrap();
    s = facing(s, Rotation::from_axis_angle(Direction::new(0.0, 0.0, 1.0), angle).unwrap());
    s = s
        .with_torques(vec![TorqueModel::Gravity(UniformGravity {
            acceleration: Acceleration::new(g, 0.0, 0.0),
        })])
        .unwrap();
    s = s.suspended_from(Suspension { axis: Direction::new(0.0, 0.0, 1.0), amplitude: None }).unwrap();
    s = s.sampled(run(5.0, 101));
    s
}

/// Examples 11.3 and 11.5: a cube of 2 kg and edge 3 m about its corner.
pub fn cube() -> Scenario {
    let cube = BoxShape::new([3.0; 3]).unwrap();
    let mut s = scenario("A cube about its corner", vec![solid("cube", "box", &cube, 2.0, [1.5; 3], 0.0)]);
    s = s.held_at(Position::ZERO).unwrap();
    s
}

/// Force-free symmetric top: a rotated cylinder in free flight.
pub fn symmetric_top() -> Scenario {
    let wheel = Cylinder::new(0.3, 0.1).unwrap();
    let mut s =
        scenario("A wheel thrown", vec![solid("wheel", "cylinder", &wheel, 4.0, [0.1, 0.2, -0.3], 0.7)]);
    s = spinning(s, AngularVelocity::new(0.4, -0.3, 2.0));
    s = facing(s, Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap());
    s = s.moving(Velocity::new(1.0, 2.0, -0.5)).unwrap();
    s = s.sampled(run(10.0, 201));
    s
}

/// T-handle of two bars that flips.
pub fn t_handle() -> Scenario {
    let (bar, stem) = (Cylinder::new(0.004, 0.04).unwrap(), BoxShape::new([0.006, 0.02, 0.006]).unwrap());
    let bar = solid("bar", "cylinder", &bar, 5.4e-3, [0.0, 0.0, 0.0], 0.0);
    let stem = solid("stem", "box", &stem, 1.9e-3, [0.0, 0.013, 0.0], 0.2);
    let mut s = scenario("T-handle in free fall", vec![bar, stem]);
    s = spinning(s, AngularVelocity::new(0.01, 12.0, 0.02));
    s = s.sampled(run(8.0, 801));
    s = s.noting(vec![Finding {
        code: "shape.overlap",
        severity: Severity::Warning,
        message: "parts overlap: their common volume counts twice".to_owned(),
        place: Some("bar, stem".to_owned()),
    }]);
    s
}

/// T-handle whose names and findings contain arbitrary text from outside.
pub fn hostile(text: &str) -> Scenario {
    let handle = t_handle();
    let mut parts = handle.parts().to_vec();
    parts[0].name = text.to_owned();
    let finding = handle.findings()[0].clone();
    let plain = Scenario::new(*handle.body()).titled(text).made_of(parts).starting(handle.start()).unwrap();
    plain.sampled(handle.run().unwrap().clone()).noting([Finding {
        message: text.to_owned(),
        place: Some(text.to_owned()),
        ..finding
    }])
}

/// Spacecraft with a thruster: constant torque in body axes.
pub fn thruster() -> Scenario {
    let mut s = tensor("A thruster fires", [3.1, 4.2, 5.3], [0.4, -0.3, 0.2], [0.7, -1.1, 0.4]);
    s = s
        .with_torques(vec![TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.3, -0.1, 0.2)))])
        .unwrap();
    s = s.sampled(run(6.0, 61));
    s
}

/// Inertia, kg·m², torque, N·m, and starting time, s, of the motor of the second wheel of
/// [`gyrostat`].
pub const MOTOR: [f64; 3] = [0.21, -0.35, 1.5];

/// Body with two wheels: one has a held speed, the other is driven by a motor.
pub fn gyrostat() -> Scenario {
    let [inertia, torque, from] = MOTOR;
    let mut s = tensor("Two wheels inside", [3.1, 4.2, 5.3], [0.4, -0.3, 0.2], [0.7, -1.1, 0.4]);
    let schedule = Some(Schedule::window(from, f64::INFINITY).unwrap());
    let motor = Motor::Torque { inertia, torque, schedule };
    let turned = Wheel::turning(Direction::new(0.6, -0.3, 0.8), 12.0, motor, s.start().omega).unwrap();
    s = s
        .with_wheels(&[Wheel::new(Direction::new(0.2, 0.9, -0.4), 1.3, Motor::HeldSpeed).unwrap(), turned])
        .unwrap();
    s = s.sampled(run(6.0, 61));
    s
}

/// Prescribed steady precession of a solid body.
pub fn gyroscope() -> Scenario {
    let wheel = Cylinder::new(0.3, 0.1).unwrap();
    let mut s =
        scenario("A gyroscope led round", vec![solid("wheel", "cylinder", &wheel, 4.0, [0.0; 3], 0.0)]);
    s = s.prescribed_as(Prescribed::euler_rates([0.0, 1.1, 0.3], [0.5, 0.0, 30.0]).unwrap()).unwrap();
    s = s.sampled(run(1.0, 11));
    s
}

pub fn rod() -> Scenario {
    let mut s = scenario("A rod", vec![particles(&[(1.0, [0.0; 3]), (2.5, [0.3, -0.4, 1.2])])]);
    s = spinning(s, AngularVelocity::new(0.2, 1.0, -0.4));
    s = s.sampled(run(3.0, 4));
    s
}

pub fn point() -> Scenario {
    let mut s = scenario("A point", vec![particles(&[(1.7, [0.2, 0.0, -1.0])])]);
    s = s.moving(Velocity::new(3.0, 0.0, 0.0)).unwrap();
    s
}

/// Particles with numbers of many digits, in the widest sums that are written out.
pub fn many_particles() -> Scenario {
    let list: Vec<_> = (1..=6)
        .map(|k| {
            let x = f64::from(k) / 7.0;
            (1.0 / x.sqrt(), [x.sin() - 1.0, (3.0 * x).cos(), 1e-3 * (5.0 * x).tan()])
        })
        .collect();
    let mut s = scenario("Six particles", vec![particles(&list)]);
    s = spinning(s, AngularVelocity::new(1.0 / 3.0, -2.0 / 3.0, 1.0 / 7.0));
    s = facing(s, Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap());
    s = s.moving(Velocity::new(1.0 / 3.0, 2.0, -1.0 / 9.0)).unwrap();
    let led = Prescribed::fixed_axis(s.start().attitude, Direction::new(1.0, -2.0, 0.5), 3.0, -0.4).unwrap();
    s = s.prescribed_as(led).unwrap();
    s = s.sampled(run(1.0, 11));
    s
}

/// Scenario, its motion if it has a run, and its worked solution.
pub struct Solution {
    pub scenario: Scenario,
    pub trajectory: Option<Trajectory>,
    pub document: Document,
}

/// Returns the worked solutions of all scenarios that have one. They take some seconds, once for
/// all tests.
pub fn solutions() -> &'static [Solution] {
    static SOLUTIONS: OnceLock<Vec<Solution>> = OnceLock::new();
    let solve = |scenario: Scenario| {
        let trajectory = scenario.simulate().transpose().unwrap();
        let document = match &trajectory {
            Some(trajectory) => explain_motion(&scenario, trajectory, &Exact::None),
            None => explain(&scenario),
        };
        Solution { document: document.unwrap(), scenario, trajectory }
    };
    SOLUTIONS.get_or_init(|| all().into_iter().chain(ground::all()).map(solve).collect())
}

/// Returns all scenarios above, and edge cases.
pub fn all() -> Vec<Scenario> {
    let over_the_top =
        Suspension { axis: Direction::new(0.0, 0.0, 2.0), amplitude: Some(std::f64::consts::PI) };
    let still = |title: &str| tensor(title, [3.1, 4.2, 5.3], [0.0; 3], [0.0; 3]);
    vec![
        dumbbell(),
        pendulum(),
        cube(),
        symmetric_top(),
        t_handle(),
        thruster(),
        gyroscope(),
        rod(),
        point(),
        many_particles(),
        still("At rest"),
        spinning(still("Permanent"), AngularVelocity::new(0.0, 0.0, 2.0)),
        spinning(still("Unstable"), AngularVelocity::new(0.0, 2.0, 0.0)).sampled(run(3.0, 7)),
        tensor("Sphere", [2.0; 3], [0.0; 3], [1.0, 2.0, 3.0]).sampled(run(3.0, 7)),
        tensor("Separatrix", [1.0, 2.0, 3.0], [0.0; 3], [1.0, 0.5, (1.0_f64 / 3.0).sqrt()])
            .sampled(run(30.0, 31)),
        tensor("Closed cones", [1.2, 1.2, 2.0], [0.0; 3], [3e-17, 0.0, 1.0]),
        tensor("Crosswise", [2.0, 2.0, 1.0], [0.0; 3], [1.0, 2.0, 0.0]),
        tensor("Molecule", [1e-46, 2e-46, 2.5e-46], [1e-47, 0.0, -2e-47], [1e12, 2e12, -1e11]),
        tensor("Tiny", [1e-150, 2e-150, 2.5e-150], [1e-151, 0.0, -2e-151], [1.0, 2.0, 3.0]),
        tensor("Huge", [1e120, 2e120, 2.5e120], [1e119, 0.0, -2e119], [1.0, 2.0, 3.0]),
        pendulum().not_sampled().suspended_from(over_the_top).unwrap(),
        spinning(pendulum(), AngularVelocity::new(0.0, 0.0, 20.0)),
        facing(pendulum(), Attitude::identity()),
        thruster().not_sampled(),
        thruster()
            .with_torques([
                thruster().torques()[0].clone(),
                TorqueModel::Constant(ConstantTorque::Space(Torque::new(0.0, 0.0, 0.1))),
                TorqueModel::Gravity(UniformGravity::STANDARD),
            ])
            .unwrap()
            .sampled(Run { times: Vec::new(), method: Method::Auto, tolerance: 1e-10 }),
    ]
}
