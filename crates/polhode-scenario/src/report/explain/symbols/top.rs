//! Free motion of a symmetric top in symbols.

use polhode::observe::Cones;
use polhode_algebra::{Accent, Formula, RationalFunction, RemainingRoots};
use polhode_document::Section;

use super::{along_axes, checked, formula, write};
use crate::symbolic::{Symbolic, unit};

/// Writes the rates and the half-angles of the cones of a symmetric top.
pub(crate) fn top(of: &Symbolic, axis: [f64; 3], cones: &Cones, s: &mut Section) {
    let (Some(Ok(omega)), tensor) = (&of.omega, &of.tensor) else { return };
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
    let positive = |value: RationalFunction| match of.evaluate(&value) {
        Some(number) if number < 0.0 => -value,
        _ => value,
    };
    let rest = omega - &e.scaled(&spin);
    let spin = positive(spin);
    let amplitude = match rest.0.iter().filter(|component| !component.is_zero()).collect::<Vec<_>>()[..] {
        [only] => positive(only.clone()).to_formula(&of.symbols),
        _ => rest.dot(&rest).square_root(&of.symbols).to_formula(&of.symbols),
    };
    write(s, &Formula::named("A").equals(amplitude));
    let size = of.evaluate(&rest.dot(&rest)).map(f64::sqrt);
    cones_of(of, size, &spin, [axial, across], cones, s);
}

/// Writes tan ∠(ω, e) = A/|ω_e| and φ̇ = |L|/I_t, with |L|² = I_t² A² + I_e² ω_e².
fn cones_of(
    of: &Symbolic,
    amplitude: Option<f64>,
    spin: &RationalFunction,
    [axial, across]: [&RationalFunction; 2],
    cones: &Cones,
    s: &mut Section,
) {
    if spin.is_zero() {
        return;
    }
    let angle = Formula::List(vec![Formula::vector("omega"), Formula::vector("e")])
        .grouped(polhode_algebra::Fence::Parentheses);
    let line = angle.applied("tan").equals(Formula::named("A").over(formula(of, spin)));
    let value = amplitude.zip(of.evaluate(spin)).map(|(a, spin)| a.atan2(spin));
    checked(s, "the half-angle of the body cone", value, cones.body_half_angle, &line);
    let Some(along) = (axial * spin).over(across) else { return };
    let squares = Formula::sum(vec![
        Formula::named("A").squared(),
        formula(of, &along).grouped(polhode_algebra::Fence::Parentheses).squared(),
    ]);
    let line = Formula::named("phi").accented(Accent::Dot).equals(squares.root());
    let value = amplitude.zip(of.evaluate(&along)).map(|(a, b)| a.hypot(b));
    checked(s, "φ\u{307}", value, cones.space_rate, &line);
}
