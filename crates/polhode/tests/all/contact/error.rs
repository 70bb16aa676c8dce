//! Error estimate of a motion on the ground.

use polhode::math::{Direction, Rotation};
use polhode::motion::contact::{Contact, ContactChange, ContactLaw, Friction, StartVelocity, SurfaceShape};
use polhode::motion::{Ending, ErrorEffort, GroundContact, Run, Solution, Trajectory};
use polhode::prelude::*;

use super::{generic_body, state, surface};

fn motion(contact: Contact, tolerance: f64, end: f64) -> Trajectory {
    motion_of([0.9, -1.4, 5.0], contact, tolerance, end)
}

fn motion_of(omega: [f64; 3], contact: Contact, tolerance: f64, end: f64) -> Trajectory {
    let attitude = Rotation::from_axis_angle(Direction::new(0.48, 0.6, 0.64), 0.8).unwrap();
    let ground = GroundContact { contact, at: Position::ZERO, velocity: StartVelocity::Rolling };
    let scenario = Scenario::new(generic_body()).starting(state(attitude, omega)).unwrap();
    let scenario = scenario.on_ground(ground).unwrap();
    let scenario = scenario.sampled(Run::evenly(end, 41, Method::Auto, tolerance));
    scenario.simulate_with_error(ErrorEffort::Thorough, &mut |_| true).unwrap().unwrap()
}

/// Rolling, slipping and gripping, with the loosest steps (as with a tolerance of 1e-4) and with
/// tighter ones.
#[test]
fn an_estimate_is_not_below_half_of_the_error() {
    let shape = SurfaceShape::Ellipsoid { semi_axes: [0.3, 0.25, 0.2] };
    let rolling = Contact::rolling(surface(shape, [0.01, -0.02, 0.015]));
    let friction = Friction { sticking: 0.2, kinetic: 0.2, viscous: 0.0 };
    let slipping = Contact { law: ContactLaw::with_friction(friction).unwrap(), ..rolling };
    for (contact, end) in [(rolling, 20.0), (slipping, 1.5)] {
        let reference = motion(contact, 1e-15, end);
        for tolerance in [1e-4, 1e-13] {
            let trajectory = motion(contact, tolerance, end);
            let estimate = trajectory.error().unwrap();
            let ending = trajectory.ending();
            assert_eq!(trajectory.samples().len(), reference.samples().len(), "{tolerance:e}: {ending:?}");
            let own = reference.error().unwrap();
            for (k, (sample, best)) in trajectory.samples().iter().zip(reference.samples()).enumerate() {
                let error = sample.state.attitude.angle_to(best.state.attitude);
                let [said, least] = [estimate, own].map(|error| error.computation()[k].attitude);
                assert!(
                    error <= 2.0 * said + least,
                    "{tolerance:e} at {}: {error:e} {said:e}",
                    best.state.time
                );
            }
        }
        // The estimate is not trivial: it includes rounding and its growth.
        let end = reference.error().unwrap().end().attitude;
        assert!(end > 1e-16 && end < 1e-6, "{end:e}");
    }
}

/// A ball with a fast spin leaves the ground and returns. The time of the end varies with the
/// error, but it remains an end.
#[test]
fn an_end_by_a_change_of_the_contact_has_an_error() {
    let ball = surface(SurfaceShape::Sphere { radius: 0.3 }, [0.05, -0.06, 0.04]);
    let contact = Contact { law: ContactLaw::FRICTIONLESS, ..Contact::rolling(ball) };
    let trajectory = motion_of([3.0, 25.0, 5.0], contact, 1e-13, 20.0);
    let end = trajectory.ending();
    assert!(matches!(end, Ending::Contact { change: ContactChange::Lands, .. }), "{end:?}");
    let end = trajectory.error().unwrap().end().attitude;
    assert!(end > 1e-16 && end < 1e-9, "{end:e}");
}

/// Rolling is smooth and is computed by collocation; slipping with dry friction by Taylor series.
#[test]
fn the_stated_solver_is_the_one_that_ran() {
    let shape = SurfaceShape::Ellipsoid { semi_axes: [0.3, 0.25, 0.2] };
    let rolling = Contact::rolling(surface(shape, [0.01, -0.02, 0.015]));
    let friction = Friction { sticking: 0.2, kinetic: 0.2, viscous: 0.0 };
    let slipping = Contact { law: ContactLaw::with_friction(friction).unwrap(), ..rolling };
    let solution = |contact| motion(contact, 1e-13, 1.5).solution().clone();
    let found = solution(rolling);
    assert!(matches!(found, Solution::Collocation(_)), "{found:?}");
    assert_eq!(found.name(), "collocation");
    let found = solution(slipping);
    assert!(matches!(found, Solution::Taylor(_) | Solution::CollocationAndTaylor(_)), "{found:?}");
}
