//! Contacts with smooth equations: rolling without resistance, or sliding without dry friction, on
//! a surface without an edge.

use super::equations::{OMEGA, PLACE, Pivot, Regime, VELOCITY, axes_rates};
use super::model::{Model, SurfaceForm};
use super::watch::{Sides, Watch};
use crate::math::algebra::Field;
use crate::motion::solve::collocation::{OUTPUTS, ROOM, System, Variables};

/// Phase of a smooth contact, with its watched functions.
pub(super) struct Smooth<'a> {
    pub(super) of: Sides<'a>,
    pub(super) regime: Regime,
    pub(super) pivot: Pivot,
    pub(super) watches: &'a [Watch],
}

impl Model {
    /// True if the equations are analytic: no direction of slip, of rolling or of an edge occurs.
    pub(super) fn is_smooth(&self, regime: Regime) -> bool {
        let has_edge = matches!(self.surface, SurfaceForm::Rim { radius, .. } if radius != 0.0);
        !has_edge && self.rolling == 0.0 && (regime == Regime::Rolling || self.kinetic == 0.0)
    }
}

impl System for Smooth<'_> {
    fn variables(&self) -> Variables {
        let slides = self.regime == Regime::Sliding;
        let by_place = self.of.model.depends_on_place();
        let at = |first: usize, has: bool| [first, first + 1, first + 2].map(|k| has.then_some(k));
        let [[a, b, c], [d, e, f], [g, h, i]] = [at(OMEGA, true), at(VELOCITY, slides), at(PLACE, by_place)];
        let [k, l, m] = at(PLACE, !by_place);
        let count = Model::count(self.regime);
        Variables {
            count,
            kinematic: core::array::from_fn(Some),
            dynamic: [a, b, c, d, e, f, g, h, i],
            quadratures: [k, l, m, Some(count - 2), Some(count - 1)],
            outputs: self.watches.len(),
        }
    }

    #[inline(always)]
    fn kinematic<S: Field>(&self, y: &[S; ROOM]) -> [S; 6] {
        let [[a, b, c], [d, e, f]] = axes_rates(y);
        [a, b, c, d, e, f]
    }

    #[inline(always)]
    fn dynamic<S: Field>(&self, one: S, y: &[S; ROOM]) -> [S; 9] {
        if self.of.model.is_plain(self.regime) {
            let at = self.of.model.kinetics_of::<S, true>(one, y, self.regime, self.pivot);
            let ([a, b, c], none) = (at.omega_rate.0, one);
            return [a, b, c, none, none, none, none, none, none];
        }
        let at = self.of.model.kinetics_of::<S, false>(one, y, self.regime, self.pivot);
        let ([a, b, c], [d, e, f]) = (at.omega_rate.0, at.velocity_rate.0);
        let [g, h, i] = self.of.model.place_rate(one, &at);
        [a, b, c, d, e, f, g, h, i]
    }

    #[inline(always)]
    fn quadratures<S: Field>(&self, one: S, y: &[S; ROOM]) -> ([S; 5], [S; OUTPUTS]) {
        let at = self.of.model.kinetics_of::<S, false>(one, y, self.regime, self.pivot);
        let ([a, b, c], [friction, ground]) = (self.of.model.place_rate(one, &at), at.powers());
        let mut outputs = [one; OUTPUTS];
        for (place, watch) in outputs.iter_mut().zip(self.watches) {
            *place = self.of.model.watched(one, &at, *watch, self.of.law, self.of.length, self.pivot);
        }
        ([a, b, c, friction, ground], outputs)
    }
}
