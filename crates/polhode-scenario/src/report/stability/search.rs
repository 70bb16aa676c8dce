//! Search for the intended equilibrium, and for torques that prevent one.

use polhode::math::{AngularVelocity, Direction, Space};
use polhode::motion::torque::TorqueModel;
use polhode::motion::{HeavyTop, MotionError, Rotor, State};
use polhode::observe::{OrbitalEquilibrium, SmallOscillations, SteadyTop};

use super::Acting;

/// Small oscillations, and the kind of their equilibrium.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub start: State,
    pub place: Place,
    /// Rotation angle from the start's attitude, rad; for a top, angle of its axis.
    pub turned: f64,
    /// Difference of ω from the start's, space axes, rad/s.
    pub omega_off: f64,
    pub oscillations: SmallOscillations,
    /// The body as a heavy symmetric top, if it is one and gravity alone acts.
    pub heavy: Option<HeavyTop>,
    /// All attitudes at rest relative to a circular orbit, the nearest first.
    pub on_orbit: Vec<(OrbitalEquilibrium, SmallOscillations)>,
}

#[derive(Clone, Debug)]
pub(crate) enum Place {
    /// The start itself.
    Start,
    /// The nearest equilibrium relative to the orbit.
    Orbit(Box<OrbitalEquilibrium>),
    /// Steady motions of a heavy symmetric top: the one with the start's momenta, and the upright
    /// one with the start's spin if it differs.
    Top(Box<SteadyTop>, Option<Box<SteadyTop>>),
    /// The nearest equilibrium with the start's ω in space.
    Nearest,
    /// The nearest equilibrium that rotates about the vertical with the start's component of ω.
    Vertical,
    /// The nearest equilibrium at rest.
    Rest,
}

/// Reasons why no equilibrium was found.
#[derive(Clone, Debug)]
pub(crate) struct Prevented {
    /// Error that ended the search.
    pub error: MotionError,
    /// Names of the torques without which there is one; empty if leaving out any two does not help.
    pub by: Vec<String>,
    /// Equilibrium under the other torques.
    pub of_the_rest: Option<Found>,
}

/// Finds the oscillations under all torques. Leaves out one or two torques if no equilibrium is
/// found.
pub(crate) fn search(rotor: &Rotor, torques: &[&Acting], start: State) -> Result<Found, Box<Prevented>> {
    let without = |left_out: &[usize]| {
        let kept = torques.iter().enumerate().filter(|(k, _)| !left_out.contains(k));
        let kept: Vec<TorqueModel> = kept.map(|(_, torque)| torque.model.clone()).collect();
        if kept.is_empty() { None } else { found(rotor, &kept, start).ok() }
    };
    let all: Vec<TorqueModel> = torques.iter().map(|torque| torque.model.clone()).collect();
    found(rotor, &all, start).map_err(|error| {
        let ones = (0..torques.len()).map(|k| vec![k]);
        let twos = (0..torques.len()).flat_map(|k| (0..k).map(move |j| vec![j, k]));
        let rest = ones.chain(twos).find_map(|left_out| Some((without(&left_out)?, left_out)));
        let name = |k: usize| torques[k].name.clone();
        let (by, of_the_rest) = match rest {
            Some((rest, left_out)) => (left_out.into_iter().map(name).collect(), Some(rest)),
            // No other torques remain.
            None if torques.len() == 1 => (vec![name(0)], None),
            None => (Vec::new(), None),
        };
        Box::new(Prevented { error, by, of_the_rest })
    })
}

/// Finds the oscillations about the start if it is an equilibrium, else about the most likely
/// intended one. Candidates, in order: at rest relative to an orbit, the steady motion of a top,
/// and the nearest equilibrium with the start's ω, with its rotation about the vertical, or at
/// rest.
fn found(rotor: &Rotor, torques: &[TorqueModel], start: State) -> Result<Found, MotionError> {
    let about = |state: State| SmallOscillations::about_equilibrium(rotor, torques, state);
    let near = |omega: AngularVelocity<Space>| {
        let omega = start.attitude.inverse() * omega;
        about(SmallOscillations::equilibrium_near(rotor, torques, State { omega, ..start })?)
    };
    let on_orbit: Vec<(OrbitalEquilibrium, SmallOscillations)> =
        OrbitalEquilibrium::all(rotor, torques, start)
            .ok()
            .flatten()
            .unwrap_or_default()
            .into_iter()
            .filter_map(|equilibrium| Some((equilibrium.clone(), about(equilibrium.state).ok()?)))
            .collect();
    let found = |place: Place, oscillations: SmallOscillations| {
        let equilibrium = oscillations.equilibrium;
        Found {
            start,
            place,
            turned: equilibrium.attitude.angle_to(start.attitude),
            omega_off: (equilibrium.omega_space() - start.omega_space()).norm(),
            oscillations,
            heavy: heavy(rotor, torques, start),
            on_orbit: on_orbit.clone(),
        }
    };
    if let Ok(oscillations) = about(start) {
        return Ok(found(Place::Start, oscillations));
    }
    if let Some((equilibrium, oscillations)) = on_orbit.first() {
        return Ok(found(Place::Orbit(Box::new(equilibrium.clone())), oscillations.clone()));
    }
    if let Some(found) = top(rotor, torques, start) {
        return Ok(found);
    }
    let spin = start.omega_space();
    if let Ok(oscillations) = near(spin) {
        return Ok(found(Place::Nearest, oscillations));
    }
    if let Some(up) = vertical(torques)
        && let Ok(oscillations) = near(AngularVelocity::from_array((up * up.dot(spin)).to_array()))
    {
        return Ok(found(Place::Vertical, oscillations));
    }
    near(AngularVelocity::ZERO).map(|oscillations| found(Place::Rest, oscillations))
}

/// Finds the steady motion of a heavy symmetric top that rotates.
fn top(rotor: &Rotor, torques: &[TorqueModel], start: State) -> Option<Found> {
    let [TorqueModel::Gravity(gravity)] = torques else { return None };
    if start.omega.norm() == 0.0 {
        return None;
    }
    let steady = SteadyTop::with_momenta_of(rotor, gravity, start).ok()?;
    let upright =
        SteadyTop::upright(rotor, gravity, start).ok().filter(|upright| upright.angle != steady.angle);
    // An axis that starts upright is meant to be upright, even if that motion is unstable.
    let lever = start.attitude * rotor.lever();
    let is_upright = lever.angle_to(-gravity.acceleration) < UPRIGHT;
    let (steady, other) = match upright {
        Some(upright) if is_upright => (upright, Some(steady)),
        upright => (steady, upright),
    };
    let [turned, omega_off] = steady.distance_from(rotor, &start);
    let oscillations = steady.oscillations.clone();
    let place = Place::Top(Box::new(steady), other.map(Box::new));
    let heavy = heavy(rotor, torques, start);
    Some(Found { start, place, turned, omega_off, oscillations, heavy, on_orbit: Vec::new() })
}

fn heavy(rotor: &Rotor, torques: &[TorqueModel], start: State) -> Option<HeavyTop> {
    let [TorqueModel::Gravity(gravity)] = torques else { return None };
    HeavyTop::of(rotor, gravity, start).ok()
}

/// Threshold of the angle between an upright axis and the vertical, rad.
const UPRIGHT: f64 = 1e-6;

/// Returns the upward direction, opposite to gravity; `None` without gravity.
fn vertical(torques: &[TorqueModel]) -> Option<Direction<Space>> {
    torques.iter().find_map(|torque| match torque {
        TorqueModel::Gravity(gravity) => (-gravity.acceleration).direction(),
        _ => None,
    })
}
