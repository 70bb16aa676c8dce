//! Step 0 in symbols: the symbols, the mass and its centre.

use polhode_algebra::Formula;
use polhode_document::Section;

use super::{formula, write};
use crate::symbolic::Symbolic;

/// Writes the symbols with their values, the mass, and the centre of mass.
pub(crate) fn body(of: &Symbolic, s: &mut Section) {
    s.say("In symbols, with these values:");
    s.line(of.known.iter().map(|known| known.written.as_str()).collect::<Vec<_>>().join(",  "));
    let index = Formula::named("alpha");
    let masses = Formula::sum_over(index.clone(), Formula::named("m").index(index));
    write(s, &masses.equals(formula(of, &of.mass)));
    write(s, &Formula::vector("c").equals(of.center.to_formula(&of.symbols)));
}
