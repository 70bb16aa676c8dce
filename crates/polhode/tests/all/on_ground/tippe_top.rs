//! Final motions of a tippe top under sliding friction.

use polhode::math::Velocity;
use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{
    Contact, ContactLaw, ContactStart, Footing, Friction, StartVelocity, SurfaceShape,
};
use polhode::observe::{Place, SteadyOnGround, SteadyPath, TippeTop};
use polhode::prelude::*;

use crate::common::held::Held;

use super::{body, contact, leaning, start};

const RADIUS: f64 = 0.017;

fn top(across: f64, along: f64, eccentricity: f64) -> TippeTop {
    TippeTop { mass: 0.006, gravity: 9.80665, radius: RADIUS, eccentricity, across, along }
}

/// Returns the motion at an inclination without slip, if the search finds it.
fn at(top: &TippeTop, jellett: f64, cosine: f64) -> SteadyOnGround {
    let (body, contact) = (
        body(top.mass, [top.across, top.across, top.along]),
        contact(
            SurfaceShape::Sphere { radius: RADIUS },
            [0.0, 0.0, top.eccentricity * RADIUS],
            Footing::Viscous,
        ),
    );
    // ω = J ζ/(R D), ζ = n − α e
    let (sine, from) = ((1.0 - cosine * cosine).max(0.0).sqrt(), cosine - top.eccentricity);
    let moment = top.across * sine * sine + top.along * from * from;
    let attitude = leaning(cosine.clamp(-1.0, 1.0).acos());
    let up: Direction<Body> = attitude.inverse() * Direction::new(0.0, 0.0, 1.0);
    let rate = jellett / (RADIUS * moment);
    let omega = [up.x * rate, up.y * rate, (up.z - top.eccentricity) * rate];
    let start: ContactStart = start(attitude, omega);
    SteadyOnGround::near(&body, &contact, &start).unwrap()
}

/// A motion is stable with viscous friction if and only if it is a minimum of the energy at its
/// Jellett constant.
#[test]
fn minima_of_the_energy_are_what_friction_leads_to() {
    let mut seen = [0; 4];
    for (across, along, eccentricity, group) in [
        (4.1e-7, 6.3e-7, 0.2, 1),
        (5.6e-7, 6.3e-7, 0.2, 2),
        (6.9e-7, 6.3e-7, 0.3, 2),
        (5.0e-7, 6.3e-7, 0.3, 2),
        (8.1e-7, 6.3e-7, 0.2, 3),
        (7.2e-7, 6.3e-7, 0.1, 3),
    ] {
        let top = top(across, along, eccentricity);
        assert_eq!(top.group(), group);
        for k in 1..60 {
            let jellett = top.jellett_of_bottom(3.7 * f64::from(k));
            for state in top.all(jellett) {
                let steady = at(&top, jellett, state.cosine);
                let is_tilted = matches!(steady.path, SteadyPath::Tilted);
                assert_eq!(is_tilted, state.place == Place::Tilted, "{k} {state:?} {:?}", steady.path);
                assert!((steady.jellett.unwrap() / jellett - 1.0).abs() < 1e-12);
                assert_eq!(steady.is_stable(), state.is_minimum, "{k} {state:?} {:?}", steady.modes);
                assert!(steady.turned_from_start < 1e-7, "{}", steady.turned_from_start);
                if is_tilted {
                    assert_eq!(steady.neutral, steady.neutral_ways().len(), "{:?}", steady.modes);
                }
                let place = match state.place {
                    Place::Bottom => 0,
                    Place::Tilted if state.is_minimum => 1,
                    Place::Tilted => 2,
                    Place::Inverted => 3,
                };
                seen[place] += usize::from(state.is_minimum || place == 2);
            }
        }
        // The thresholds in J agree with those in spin.
        for (limit, cosine, of_spin) in [
            (top.bottom_up_to(), 1.0, top.jellett_of_bottom(1.0)),
            (top.inverted_from(), -1.0, top.jellett_of_inverted(1.0)),
        ] {
            let steady = at(&top, of_spin * 10.0, cosine);
            let threshold = steady.stable_spins.unwrap().nearest(10.0);
            assert_eq!(threshold.is_some(), limit.is_some());
            if let (Some(threshold), Some(limit)) = (threshold, limit) {
                assert!((threshold * of_spin / limit - 1.0).abs() < 1e-13);
            }
        }
    }
    assert!(seen.iter().all(|count| *count > 3), "{seen:?}");
}

/// The inclination minimises the energy: slope of W by differences.
#[test]
fn tilts_are_extrema_of_the_energy() {
    let top = top(8.1e-7, 6.3e-7, 0.2);
    let jellett = top.jellett_of_bottom(300.0);
    let [tilt] = top.minima(jellett)[..] else { panic!("one minimum") };
    assert_eq!(tilt.place, Place::Tilted);
    assert!(tilt.energy < top.all(jellett)[0].energy);
    let (a, c, alpha) = (top.across, top.along, top.eccentricity);
    let energy = |u: f64| {
        let moment = a * (1.0 - u * u) + c * (u - alpha) * (u - alpha);
        0.5 * (jellett / RADIUS).powi(2) / moment + top.mass * top.gravity * RADIUS * (1.0 - alpha * u)
    };
    assert!((energy(tilt.cosine) / tilt.energy - 1.0).abs() < 1e-14);
    for step in [1e-3, -1e-3] {
        assert!(energy(tilt.cosine + step) > tilt.energy);
    }
}

/// One top turns over. Another, of group III, rises to the inclination of least energy for its
/// Jellett constant.
#[test]
fn friction_leads_to_the_minimum() {
    for (across, place) in [(1.9e-6, Place::Inverted), (2.5e-6, Place::Tilted)] {
        let body = body(0.015, [across, across, 2.0e-6]);
        let sphere = SurfaceShape::Sphere { radius: 0.018 };
        let friction = Friction { sticking: 0.0, kinetic: 0.0, viscous: 0.3 };
        let law = ContactLaw::with_friction(friction).unwrap();
        let contact = Contact { law, ..contact(sphere, [0.0, 0.0, 0.004], Footing::Viscous) };
        let attitude = leaning(0.1);
        let omega: AngularVelocity<Body> = attitude.inverse() * AngularVelocity::new(0.0, 0.0, 150.0);
        let start = ContactStart {
            velocity: StartVelocity::Along(Velocity::ZERO),
            ..start(attitude, omega.to_array())
        };
        let steady = SteadyOnGround::near(&body, &contact, &start).unwrap();
        let [end] = steady.tippe_top.unwrap().minima(steady.jellett.unwrap())[..] else { panic!("one end") };
        assert_eq!(end.place, place);
        let motion = Held::of(Simulation::on_ground(&body, &contact, start, &[80.0]).run().unwrap(), CONTACT);
        let axis = motion.samples()[0].state.attitude * Direction::<Body>::new(0.0, 0.0, 1.0);
        // Remaining oscillation after 80 s.
        assert!((axis.z - end.cosine).abs() < 5e-4, "{} {end:?}", axis.z);
    }
}
