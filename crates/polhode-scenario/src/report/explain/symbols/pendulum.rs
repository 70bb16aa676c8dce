//! Step 5 of a pendulum in symbols.

use polhode::motion::Pendulum;
use polhode_algebra::{Formula, SquareRoot};
use polhode_document::Section;

use super::{checked, gap};
use crate::symbolic::Symbolic;

/// Writes the moment about the axis and the frequency ω0 = √(M g d/I).
pub(crate) fn pendulum(of: &Symbolic, computed: &Pendulum, s: &mut Section) {
    let symbolic = match &of.pendulum {
        Some(Ok(pendulum)) => pendulum,
        Some(Err(why)) => return gap(s, why),
        None => return,
    };
    let axis = &symbolic.axis;
    let moment = axis.dot(&of.tensor.times_vector(axis));
    let lever = &of.center - of.point();
    let across = &lever - &axis.scaled(&axis.dot(&lever));
    let arm = across.dot(&across).square_root(&of.symbols);
    s.say("In symbols:");
    let value = |root: &SquareRoot| root.evaluate(&|symbol| of.value(symbol));
    let moment_formula = moment.to_formula(&of.symbols);
    let line = Formula::named("I").equals(moment_formula);
    checked(s, "the moment about the axis", of.evaluate(&moment), computed.moment(), &line);
    let line = Formula::named("d").equals(arm.to_formula(&of.symbols));
    checked(s, "the distance of the centre of mass", value(&arm), computed.arm(), &line);
    // ω0² = M g d/I
    let square = SquareRoot {
        outside: &of.mass * &symbolic.gravity.outside * &arm.outside,
        inside: &symbolic.gravity.inside * &arm.inside,
    };
    let Some(outside) = square.outside.over(&moment) else { return };
    let square = SquareRoot { outside, ..square };
    let value = value(&square).map(f64::sqrt);
    let general = Formula::product(vec![Formula::named("M"), Formula::named("g"), Formula::named("d")])
        .over(Formula::named("I"))
        .root();
    let line = Formula::named("omega_0").equals(general).equals(square.to_formula(&of.symbols).root());
    checked(s, "ω0", value, computed.small_frequency(), &line);
}
