//! ω, angular momentum and kinetic energy in symbols.

use polhode_algebra::{Formula, Rational, RationalFunction};
use polhode_document::Section;

use super::{along_axes, checked, formula, gap, tensor_letter, write};
use crate::symbolic::Symbolic;

/// Writes ω in step 2.
pub(crate) fn omega(of: &Symbolic, s: &mut Section) {
    match &of.omega {
        Some(Ok(omega)) => write(s, &Formula::vector("omega").equals(along_axes(of, omega))),
        Some(Err(why)) => gap(s, why),
        None => {}
    }
}

/// Writes L = {I} ω and T = ½ ω · L; `energy` is the computed T, J.
pub(crate) fn momentum(of: &Symbolic, energy: f64, s: &mut Section) {
    let Some(Ok(omega)) = &of.omega else { return };
    let momentum = of.tensor.times_vector(omega);
    let left = Formula::vector("L").equals(tensor_letter().times(Formula::vector("omega")));
    write(s, &left.equals(along_axes(of, &momentum)));
    let half = Rational::new(1, 2).map_or_else(RationalFunction::zero, RationalFunction::from);
    let value = omega.dot(&momentum) * half;
    let line = Formula::named("T_rot").equals(formula(of, &value));
    checked(s, "T", of.evaluate(&value), energy, &line);
}
