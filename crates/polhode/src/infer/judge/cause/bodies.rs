//! Tensors that result from mistakes.

use super::law::Law;
use super::name::Cause;
use super::trial::Trials;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Position;
use crate::motion::task::scenario::Scenario;

/// Permutations of three items, except the identity.
const ORDERS: [[usize; 3]; 5] = [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// Threshold below which products of inertia count as zero, relative to the largest moment.
const NO_PRODUCTS: f64 = 1e-14;

impl<'a> Trials<'a> {
    /// Tries tensors along other axes, with other products of inertia, and about other points.
    pub(super) fn try_tensors(&mut self, scenario: &Scenario) {
        let law = self.law.clone();
        let tensor = *law.tensor();
        let with = |cause: Cause, tensor: Symmetric3| (cause, law.with_tensor(tensor));
        let products = [tensor.xy, tensor.xz, tensor.yz];
        let has_products = products.iter().any(|p| p.abs() > NO_PRODUCTS * tensor.max_abs());
        if has_products {
            let of = |[xy, xz, yz]: [f64; 3]| Symmetric3 { xy, xz, yz, ..tensor };
            self.try_best_law([with(Cause::ProductsReversed, of(products.map(|p| -p)))]);
            self.try_best_law([with(Cause::ProductsLeftOut, of([0.0; 3]))]);
            self.try_best_law(
                ORDERS.map(|order| with(Cause::ProductsReordered(order), of(order.map(|k| products[k])))),
            );
            self.try_best_law(transposed(&law).map(|tensor| with(Cause::TensorTransposed, tensor)));
            let moments = law.principal.map(|(moment, _)| moment);
            let along = |order: [usize; 3]| {
                let along = Symmetric3::diagonal(order.map(|k| moments[k]));
                with(Cause::PrincipalMomentsAlongBodyAxes(order), along)
            };
            self.try_best_law([[0, 1, 2]].into_iter().chain(ORDERS).map(along));
        }
        let body = scenario.body();
        if scenario.rotor().is_pivoted() {
            let about = *body.inertia().symmetric();
            self.try_best_law([with(Cause::TensorAboutCenterOfMass, about)]);
        } else if body.center_of_mass() != Position::ZERO {
            let about = *body.inertia_about(Position::ZERO).symmetric();
            self.try_best_law([with(Cause::TensorAboutOrigin, about)]);
        }
        if law.has_wheels() {
            let whole = *body.inertia_about(scenario.rotor().point()).symmetric();
            self.try_best_law([(Cause::WheelsLeftOut, law.without_wheels(whole))]);
        }
    }
}

/// Returns Rᵀ D R for every R whose columns are the principal axes, in each order and with each
/// sign.
fn transposed<'l>(law: &'l Law<'_>) -> impl Iterator<Item = Symmetric3> + 'l {
    let orders = [[0, 1, 2]].into_iter().chain(ORDERS);
    orders.flat_map(move |order| {
        (0..4).map(move |signs| {
            // Reversing an axis gives an axis again; reversing all three has no effect.
            let sign = |k: usize| if signs == k + 1 { -1.0 } else { 1.0 };
            let chosen = order.map(|k| law.principal[k]);
            let axes: [[f64; 3]; 3] = core::array::from_fn(|k| (chosen[k].1 * sign(k)).to_array());
            // Rᵀ has the axes as its rows: (Rᵀ) D (Rᵀ)ᵀ.
            Symmetric3::diagonal(chosen.map(|(moment, _)| moment)).rotated(&axes)
        })
    })
}
