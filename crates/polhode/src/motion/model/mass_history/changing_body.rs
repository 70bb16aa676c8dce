//! A body with changing mass between two jumps or breakpoints, and its equations of motion.

use super::MassHistory;
use super::instant::{Elements, Instant, difference, steiner, sum, times};
use super::moments::{Polynomial, disc};
use super::outflow::Outflow;
use crate::math::algebra::{Components, Scalar};
use crate::math::frame::{Body, Space};
use crate::math::vector::{AngularMomentum, Position, Torque, Vector};
use crate::motion::model::law::LawInput;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// Body from one breakpoint of its mass history to the next.
#[derive(Clone, Debug)]
pub(in crate::motion) struct ChangingBody {
    epoch: f64,
    /// Moments about `reference`, which is the pivot if the body is held.
    moments: Polynomial,
    rates: Polynomial,
    reference: Position<Body>,
    is_held: bool,
    loss: Loss,
}

/// Way in which the body loses mass.
#[derive(Clone, Debug)]
enum Loss {
    None,
    InPlace,
    Exits(Vec<Drain>),
}

/// An exit: its share of the flow, its position relative to the reference point, and the
/// contribution of its width.
#[derive(Clone, Copy, Debug)]
struct Drain {
    share: f64,
    place: [f64; 3],
    width: [f64; 6],
}

impl MassHistory {
    /// Returns the body just after `time`, valid until the next breakpoint.
    pub(in crate::motion) fn body(&self, time: f64, pivot: Option<Position<Body>>) -> ChangingBody {
        let piece = self.piece(time);
        let reference = pivot.unwrap_or(self.reference);
        let moments = piece.moments.about((reference - self.reference).to_array());
        let rates = moments.derivative();
        let drain = |exit: &super::Exit| Drain {
            share: exit.share,
            place: (exit.position - reference).to_array(),
            width: exit.axis.direction().map_or([0.0; 6], |axis| disc(exit.radius, axis.to_array())),
        };
        let loss = match &self.outflow {
            Outflow::None => Loss::None,
            _ if !piece.loses_mass => Loss::None,
            Outflow::InPlace => Loss::InPlace,
            Outflow::Exits(exits) => Loss::Exits(exits.iter().map(drain).collect()),
        };
        ChangingBody { epoch: piece.epoch, moments, rates, reference, is_held: pivot.is_some(), loss }
    }
}

impl ChangingBody {
    fn instant<I: LawInput>(&self, at: &I) -> Instant<I::Scalar> {
        let tau = at.time() - at.number(self.epoch);
        let value = |terms: &Polynomial, k: usize| {
            let degree = terms.0.iter().rposition(|c| c.0[k] != 0.0).unwrap_or_default();
            let coefficient = |j: usize| at.number(terms.0.get(j).map_or(0.0, |c| c.0[k]));
            (0..degree).rev().fold(coefficient(degree), |sum, j| sum * tau + coefficient(j))
        };
        let three = |terms: &Polynomial| [1, 2, 3].map(|k| value(terms, k));
        let six = |terms: &Polynomial| [4, 5, 6, 7, 8, 9].map(|k| value(terms, k));
        let (mass, mass_rate) = (value(&self.moments, 0), value(&self.rates, 0));
        let first = three(&self.moments);
        let lever = first.map(|x| x / mass);
        let (mut inertia, mut rate) = (six(&self.moments), six(&self.rates));
        if !self.is_held {
            // I = J − M (d² 1 − d dᵀ) with d the lever. In İ, the motion of the centre of mass in
            // the body is included through (M d)˙.
            inertia = difference(inertia, steiner(first, lever));
            let moved = steiner(three(&self.rates), lever).map(|x| x.scaled(2.0));
            rate = sum(difference(rate, moved), times(steiner(lever, lever), mass_rate));
        }
        let drain = match &self.loss {
            Loss::Exits(exits) => {
                let of = |exit: &Drain| -> Elements<I::Scalar> {
                    let place = exit.place.map(|x| at.number(x));
                    let arm =
                        if self.is_held { place } else { core::array::from_fn(|k| place[k] - lever[k]) };
                    let width = exit.width.map(|x| at.number(x));
                    sum(steiner(arm, arm), width).map(|x| x.scaled(-exit.share) * mass_rate)
                };
                exits.iter().map(of).reduce(sum)
            }
            Loss::None | Loss::InPlace => None,
        };
        let is_in_place = matches!(self.loss, Loss::InPlace);
        Instant { lever, first, inertia, rate, drain, is_in_place }
    }

    /// Returns ω̇ due to a torque.
    pub(in crate::motion) fn acceleration<I: LawInput>(&self, at: &I, torque: I::Vector) -> I::Vector {
        let omega = Components(at.components(at.omega()));
        let torque = Components(at.components(torque));
        at.vector(self.instant(at).acceleration(omega, torque).0)
    }

    /// Returns I v.
    pub(in crate::motion) fn inertia<I: LawInput>(&self, at: &I, v: I::Vector) -> I::Vector {
        at.vector(super::instant::image(self.instant(at).inertia, Components(at.components(v))).0)
    }

    /// Returns the point about which the body turns, its centre of mass or pivot, body axes, m.
    pub(in crate::motion) fn point<I: LawInput>(&self, at: &I) -> I::Vector {
        let reference = at.in_body(self.reference.as_quantity());
        if self.is_held { reference } else { reference + at.vector(self.instant(at).lever) }
    }

    /// Returns M l, with l from that point to the centre of mass.
    pub(in crate::motion) fn first_moment<I: LawInput>(&self, at: &I) -> I::Vector {
        if self.is_held { at.vector(self.instant(at).first) } else { at.in_body(Vector::ZERO) }
    }

    /// Returns the rotor at `time`.
    pub(in crate::motion) fn rotor(&self, time: f64) -> Option<Rotor> {
        let body = self.moments.at(time - self.epoch).properties(self.reference).ok()?;
        Some(if self.is_held { Rotor::pivoted(&body, self.reference) } else { Rotor::free(&body) })
    }

    /// Returns the power that changes ½ ω·I ω and the torque, in space axes, that changes I ω. Both
    /// include the effect of leaving mass and of mass that moves inside the body.
    pub(in crate::motion) fn balances<I>(
        &self,
        at: &I,
        state: &State,
        torque: Torque<Body>,
    ) -> (f64, AngularMomentum<Space>)
    where
        I: LawInput<Scalar = f64>,
    {
        let omega = Components(state.omega.to_array());
        let torque = Components(torque.to_array());
        let (power, torque) = self.instant(at).balances(omega, torque);
        (power, state.attitude * AngularMomentum::<Body>::from_array(torque.0))
    }
}
