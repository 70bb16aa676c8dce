//! User-supplied torques: laws and functions from outside the crate.

use polhode::math::formula::Unary;
use polhode::math::{Scalar, VectorAlgebra};
use polhode::motion::Orbit;
use polhode::motion::torque::{Drag, DragLaw, Law, LawInput, OrbitPosition};
use polhode::prelude::*;

/// Torque N = −|ω| C ω, as in the crate.
#[derive(Debug)]
struct QuadraticDrag([f64; 6]);

impl Law for QuadraticDrag {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        let omega = at.omega();
        -(at.symmetric(self.0, omega) * omega.norm())
    }
}

/// A gravity gradient with a sine and the attitude, different from all laws of the crate.
#[derive(Debug)]
struct Swarm {
    orbit: Orbit,
    rest: Attitude,
}

impl Law for Swarm {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        let OrbitPosition { direction, square, strength, .. } = at.orbit(&self.orbit);
        let gravity = direction.cross(at.inertia(direction)) * (square.power(-2.5) * strength).scaled(3.0);
        let (w, v) = at.turn_from(self.rest);
        let spring = v * (w * at.time().unary(Unary::Sin)).scaled(-0.3);
        let [x, y, _] = at.components(at.in_space(Direction::new(0.2, -0.5, 0.9)));
        let push = at.vector([x * y, y.scaled(0.1), x.atan2(y + at.number(3.0))]);
        gravity + spring + push.scaled(0.2) + at.in_body(Direction::new(0.01, 0.02, -0.03))
    }
}

/// Returns the same torque in one state.
fn swarm(orbit: &Orbit, rest: Attitude, rotor: &Rotor, state: &State) -> Torque<Body> {
    let r = (state.attitude.inverse() * orbit.position(state.time)).to_array();
    let distance = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt();
    let inertia = |v: [f64; 3]| rotor.angular_momentum(AngularVelocity::from_array(v)).to_array();
    let gravity = Torque::from_array(cross(r, inertia(r))) * (3.0 * orbit.mu() / distance.powi(5));
    let [w, x, y, z] = (rest.inverse() * state.attitude).canonical_quaternion();
    let spring = Torque::new(x, y, z) * (-0.3 * w * state.time.sin());
    let [x, y, _] = (state.attitude.inverse() * Direction::<Space>::new(0.2, -0.5, 0.9)).to_array();
    let push = Torque::new(x * y, 0.1 * y, x.atan2(y + 3.0)) * 0.2;
    gravity + spring + push + Torque::new(0.01, 0.02, -0.03)
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn rotor() -> Rotor {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    Rotor::free(&MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap())
}

fn start() -> State {
    let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    State { time: 0.25, attitude, omega: AngularVelocity::new(0.7, -1.1, 0.4) }
}

fn run(torque: TorqueModel, method: Method, tolerance: f64) -> Trajectory {
    let times = [0.25, 1.0, 2.5, 6.0];
    Trajectory::compute(&rotor(), &[torque], start(), &times, method, tolerance).unwrap()
}

fn last(run: &Trajectory) -> State {
    run.samples().last().unwrap().state
}

fn distance(a: &State, b: &State) -> f64 {
    a.attitude.angle_to(b.attitude).max((a.omega - b.omega).norm() / b.omega.norm())
}

#[test]
fn a_law_of_the_user_is_as_good_as_one_of_the_crate() {
    let elements = [0.11, 0.17, 0.09, 0.02, -0.03, 0.05];
    let [xx, yy, zz, xy, xz, yz] = elements;
    let own = TorqueModel::own("drag of mine", QuadraticDrag(elements));
    let matrix = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let known = TorqueModel::Drag(Drag::new(DragLaw::Quadratic, matrix).unwrap());
    assert_eq!(own.name(), "drag of mine");
    let (own, known) = (run(own, Method::Auto, 1e-11), run(known, Method::Auto, 1e-11));
    assert_eq!(own.samples(), known.samples());
}

#[test]
fn a_law_is_integrated_as_what_it_says() {
    let orbit =
        Orbit::through(70.0, Position::new(3.0, -4.0, 1.0), Velocity::new(0.4, 0.3, -3.5), 0.7).unwrap();
    let circle =
        Orbit::circular_at_rate(0.7, 0.6, Direction::new(0.2, 0.5, 0.9), Direction::new(1.0, -0.3, 0.2))
            .unwrap();
    let rest = Attitude::from_quaternion([0.5, -0.5, 0.8, 0.6]).unwrap();
    for orbit in [orbit, circle] {
        let law = TorqueModel::own("swarm", Swarm { orbit: orbit.clone(), rest });
        let torque = law.torque(&rotor(), &start()) - swarm(&orbit, rest, &rotor(), &start());
        assert!(torque.norm() < 1e-14, "{torque:?}");
        let function = TorqueModel::function("swarm", move |rotor, state| swarm(&orbit, rest, rotor, state));
        let (law, function) = (run(law, Method::Taylor, 1e-13), run(function, Method::Auto, 1e-13));
        assert_eq!(function.solution().name(), "dop853");
        let error = distance(&last(&law), &last(&function));
        assert!(error < 1e-11, "{error:e}");
    }
}

/// Torque N = −c (|ωx|, ωy, ωz).
#[derive(Debug)]
struct Corner;

impl Law for Corner {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        let [x, y, z] = at.components(at.omega());
        -at.vector([x.unary(Unary::Abs), y, z]).scaled(0.1)
    }
}

#[test]
fn what_has_corners_has_no_series() {
    let corner = || TorqueModel::own("corner", Corner);
    assert_eq!(run(corner(), Method::Auto, 1e-10).solution().name(), "dop853");
    let refused = Trajectory::compute(&rotor(), &[corner()], start(), &[1.0], Method::Taylor, 1e-10);
    assert!(matches!(refused, Err(MotionError::NotSmooth { torque: 0, .. })), "{refused:?}");
}
