//! Free motion of a symmetric top in symbols.

use polhode::observe::Cones;
use polhode_algebra::{Accent, Formula, RationalFunction, RemainingRoots, Vector};
use polhode_document::Section;

use super::{along_axes, checked, formula, write};
use crate::symbolic::{Symbolic, unit};

/// Writes the rates and the half-angles of the cones of a symmetric top.
pub(crate) fn top(of: &Symbolic, axis: [f64; 3], cones: &Cones, s: &mut Section) {
    let (Some(Ok(omega)), Some(tensor)) = (&of.omega, of.tensor()) else { return };
    let roots = tensor.eigenvalues();
    let (RemainingRoots::None, [_, _]) = (&roots.rest, &roots.rational[..]) else { return };
    let find = |n| roots.rational.iter().find(|(_, multiplicity)| *multiplicity == n);
    let (Some((axial, _)), Some((across, _))) = (find(1), find(2)) else { return };
    let Some(e) = tensor.eigenvectors(axial).first().and_then(|e| unit(e, &of.symbols)) else { return };
    // The same end of the axis as in the numbers.
    let value = of.evaluate_vector(&e).unwrap_or_default();
    let is_opposite = value.iter().zip(axis).map(|(a, b)| a * b).sum::<f64>() < 0.0;
    let e = if is_opposite { -e } else { e };
    let spin = e.dot(omega);
    let rate = (axial - across).over(across).map(|ratio| ratio * &spin);
    let Some(rate) = rate else { return };
    s.say("In symbols:");
    write(
        s,
        &Formula::List(vec![
            Formula::vector("e").equals(along_axes(of, &e)),
            Formula::named("I_e").equals(formula(of, axial)),
            Formula::named("I_t").equals(formula(of, across)),
        ]),
    );
    let line = Formula::named("Omega").equals(formula(of, &rate));
    checked(s, "Ω", of.evaluate(&rate), cones.body_rate, &line);
    angles(of, &e, omega, [axial, across], cones, s);
}

/// Writes tan ∠(ω, e) = A/|ω_e| and φ̇ = |L|/I_t.
fn angles(
    of: &Symbolic,
    e: &Vector,
    omega: &Vector,
    [axial, across]: [&RationalFunction; 2],
    cones: &Cones,
    s: &mut Section,
) {
    let spin = e.dot(omega);
    let rest = omega - &e.scaled(&spin);
    let amplitude = rest.dot(&rest);
    // L² = I_t² A² + I_e² ω_e²
    let momentum = across * across * &amplitude + axial * axial * &spin * &spin;
    let Some(square) = momentum.over(&(across * across)) else { return };
    let root = square.square_root(&of.symbols);
    let line = Formula::named("phi").accented(Accent::Dot).equals(root.to_formula(&of.symbols));
    let value = root.evaluate(&|symbol| of.value(symbol));
    checked(s, "φ\u{307}", value, cones.space_rate, &line);
    let Some(square) = amplitude.over(&(&spin * &spin)) else { return };
    let root = square.square_root(&of.symbols);
    let value = root.evaluate(&|symbol| of.value(symbol)).map(f64::atan);
    let angle = Formula::List(vec![Formula::vector("omega"), Formula::vector("e")])
        .grouped(polhode_algebra::Fence::Parentheses);
    let line = angle.applied("tan").equals(root.to_formula(&of.symbols));
    checked(s, "the half-angle of the body cone", value, cones.body_half_angle, &line);
}
