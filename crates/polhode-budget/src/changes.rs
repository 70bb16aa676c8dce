//! First-order changes of the whole due to each error of a row.

use polhode::body::{MassProperties, MassPropertiesDerivative};
use polhode::math::{Body, Part, Position, Rotation};

use crate::budget::{Budget, PlacedPart};
use crate::error::BudgetError;
use crate::growth::Basis;
use crate::row::CopyErrors;
use crate::subtrees::Subtrees;
use crate::tank::UncertainLiquid;
use crate::tensor::{elements, plus, steiner};
use crate::uncertainty::{ErrorKind, RowError};

/// Change of the whole per unit of a standard normal variable.
pub(crate) struct Change {
    pub(crate) row: usize,
    /// Index of the first number of the row that the error changes.
    pub(crate) number: usize,
    /// Change due to the row's own variable.
    pub(crate) alone: MassPropertiesDerivative<Body>,
    /// Index of the group, and the change due to the variable that the row shares with it.
    pub(crate) shared: Option<(usize, MassPropertiesDerivative<Body>)>,
}

impl Change {
    pub(crate) const fn kind(&self) -> ErrorKind {
        ErrorKind::of(self.number)
    }
}

impl Budget {
    /// Calls `each` with all changes of the whole, row by row. `subtrees` are the sums of which
    /// `whole` consists.
    pub(crate) fn changes(
        &self,
        basis: Basis,
        subtrees: &Subtrees<'_>,
        whole: &MassProperties<Body>,
        mut each: impl FnMut(&Change),
    ) -> Result<(), BudgetError> {
        for k in 0..self.rows.len() {
            let factors = self.factors(k);
            if factors.is_empty() {
                continue;
            }
            let (place, part) = (self.frame(k), self.placed_part(k)?);
            let (own, scale) = (self.own(k, basis)?, self.factor(k, basis));
            let one = if self.has_rows_in(k) { subtrees.of(k)? } else { own };
            let parent = self.axes_around(k);
            let quantity = self.rows.quantity(k);
            let count = f64::from(quantity.count);
            let copies = match quantity.errors {
                CopyErrors::Alike => count,
                CopyErrors::Independent => count.sqrt(),
            };
            let turns = one.map(|one| MassPropertiesDerivative::by_rotation(&one, place.position));
            for factor in factors {
                let change = match (&part, &own, &one, turns) {
                    (Some(part), Some(own), ..) if !factor.kind().is_of_frame() => {
                        let by = part.change(
                            self.rows.liquid(k),
                            self.rows.tensor_follows_mass(k),
                            &factor.error,
                            scale,
                        );
                        by.in_frame(place.rotation).of_whole(own, whole)
                    }
                    (.., Some(one), Some(turns)) => moved(turns, parent, &factor.error).of_whole(one, whole),
                    // The place of a frame without mass has no effect.
                    _ => continue,
                };
                let group = self.group(k).map(|group| (group, self.groups[group].correlation(factor.kind())));
                let (rho, group) = group.map_or((0.0, None), |(group, rho)| (rho, Some(group)));
                each(&Change {
                    row: k,
                    number: factor.number,
                    alone: change * (place.frames * copies * (1.0 - rho).sqrt()),
                    shared: group
                        .filter(|_| rho > 0.0)
                        .map(|group| (group, change * (place.frames * count * rho.sqrt()))),
                });
            }
        }
        Ok(())
    }
}

const NO_CHANGE: MassPropertiesDerivative<Body> =
    MassPropertiesDerivative { mass: 0.0, center_of_mass: Position::ZERO, inertia: [0.0; 6] };

/// Returns the change of a body whose frame moves by `error`. `turns` has its change per radian
/// about each body axis. `parent` has the axes of the parent frame.
fn moved(
    turns: [MassPropertiesDerivative<Body>; 3],
    parent: Rotation<Body, Part>,
    error: &RowError,
) -> MassPropertiesDerivative<Body> {
    let translation = MassPropertiesDerivative {
        center_of_mass: parent * Position::from_array(error.position),
        ..NO_CHANGE
    };
    let angles = (parent * Position::from_array(error.rotation)).to_array();
    turns.into_iter().zip(angles).fold(translation, |sum, (by, angle)| sum + by * angle)
}

impl PlacedPart {
    /// Returns the change of the part in its own frame, with its mass multiplied by `scale`.
    ///
    /// A tensor J about a point p gives I = J − m (d² 1 − d dᵀ), with d from p to the centre of
    /// mass. If the tensor scales with the mass, both terms do, which adds δI = I δm/m.
    fn change(
        &self,
        liquid: Option<&UncertainLiquid>,
        follows: bool,
        error: &RowError,
        scale: f64,
    ) -> MassPropertiesDerivative<Part> {
        if let Some(liquid) = liquid {
            let change = liquid.change(&self.properties, [error.mass, error.density]);
            let inertia = change.inertia.map(|element| element * scale);
            return MassPropertiesDerivative { mass: change.mass * scale, inertia, ..change };
        }
        let mass = self.properties.mass();
        let mut inertia = error.tensor;
        if follows {
            let own = elements(self.properties.inertia().matrix());
            inertia = plus(inertia, own, error.mass / mass);
        }
        if let Some(point) = self.about {
            let d = (self.properties.center_of_mass() - point).to_array();
            inertia = plus(inertia, steiner(d, error.center), -2.0 * mass);
            if !follows {
                inertia = plus(inertia, steiner(d, d), -error.mass);
            }
        }
        MassPropertiesDerivative {
            mass: error.mass * scale,
            center_of_mass: Position::from_array(error.center),
            inertia: inertia.map(|element| element * scale),
        }
    }
}
