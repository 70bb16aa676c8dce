//! Principal moments and axes in symbols.

use std::collections::BTreeSet;

use polhode_algebra::{Formula, Matrix, RationalFunction, Relation, RemainingRoots, Roots, Symbol, Vector};
use polhode_document::Section;

use super::{ROUNDING, along_axes, formula, gap, write};
use crate::symbolic::{Gap, Symbolic};

/// Largest matrix whose roots are looked for, without its common factor.
const MOST_TERMS: usize = 18;
const MOST_SYMBOLS: usize = 4;

/// Longest characteristic equation that is written, characters.
const LONGEST: usize = 160;

/// Writes the characteristic equation, its roots in ascending order, and the axes.
pub(super) fn principal(of: &Symbolic, tensor: &Matrix, moments: [f64; 3], s: &mut Section) {
    let (_, rest) = tensor.factored();
    let is_diagonal = [(0, 1), (0, 2), (1, 2)].iter().all(|&(i, j)| tensor.0[i][j].is_zero());
    if is_diagonal {
        s.say("{I} is diagonal, so the body axes are principal axes.");
        return;
    }
    let elements = || rest.0.iter().flatten();
    let terms: usize = elements().map(|e| e.numerator().term_count()).sum();
    let symbols: BTreeSet<Symbol> = elements().flat_map(RationalFunction::symbols).collect();
    if terms > MOST_TERMS || symbols.len() > MOST_SYMBOLS {
        s.say("The characteristic equation is long, with many symbols; its roots follow in numbers.");
        return;
    }
    equation(of, tensor, &rest, s);
    let roots = tensor.eigenvalues();
    if !agree(of, &roots, moments) {
        gap(s, &Gap::Differs { what: "the principal moments".to_owned() });
        return;
    }
    let mut first = 1;
    for (value, multiplicity) in sorted(of, &roots) {
        let names = (first..first + multiplicity).map(|k| Formula::named(&format!("I_{k}")));
        first += multiplicity;
        let names = names.reduce(Formula::equals).unwrap_or_else(|| Formula::named("I"));
        write(s, &names.equals(formula(of, &value)));
        axes(of, &tensor.eigenvectors(&value), s);
    }
    match &roots.rest {
        RemainingRoots::None => {}
        RemainingRoots::Pair(pair) => {
            s.say(if roots.rational.is_empty() { "Its roots:" } else { "The other two roots:" });
            write(s, &Formula::named("I").equals(pair.to_formula(&of.symbols)));
        }
        RemainingRoots::NoClosedForm(_) => {
            s.say("The cubic has no rational root, so its roots follow in numbers.");
        }
    }
}

/// Writes |{I} − I 1| = 0 as a polynomial; for λ = I/f if f is a common factor of all elements that
/// leaves numbers.
fn equation(of: &Symbolic, tensor: &Matrix, rest: &Matrix, s: &mut Section) {
    let (factor, _) = tensor.factored();
    let is_numbers = rest.0.iter().flatten().all(|element| element.as_constant().is_some());
    let (matrix, unknown) = match is_numbers {
        true => (rest, Formula::named("lambda")),
        false => (tensor, Formula::named("I")),
    };
    let polynomial = matrix.characteristic_polynomial().to_formula(&unknown, &of.symbols);
    if polynomial.to_text().chars().count() > LONGEST {
        s.say("The characteristic equation |{I} − I 1| = 0 is long; its roots:");
        return;
    }
    s.say("The characteristic equation |{I} − I 1| = 0 and its roots:");
    if is_numbers && !of.known.is_empty() {
        let scale = Formula::named("I").over(factor.to_formula(&of.symbols));
        write(s, &unknown.clone().related(Relation::Defined, scale));
    }
    write(s, &polynomial.equals(Formula::integer(0)));
}

/// Writes the axes of a root.
fn axes(of: &Symbolic, axes: &[Vector], s: &mut Section) {
    match axes {
        [axis] => {
            s.say("Its axis, from ({I} − I 1) ω = 0:");
            write(s, &Formula::vector("omega").related(Relation::To, shortest(of, axis)));
        }
        [] => {}
        [one, other, ..] => {
            s.say("A multiple root leaves the axes free: any two that are perpendicular to each other and to the first, such as");
            write(s, &Formula::List(vec![along_axes(of, one), along_axes(of, other)]));
        }
    }
}

/// Returns the multiple of an axis with the shortest formula.
fn shortest(of: &Symbolic, axis: &Vector) -> Formula {
    let divided = axis.0.iter().filter_map(|component| RationalFunction::one().over(component));
    let multiples = divided.map(|scale| axis.scaled(&scale).primitive());
    let formulas = multiples.chain([axis.clone()]).map(|axis| along_axes(of, &axis));
    formulas.min_by_key(|formula| formula.to_text().chars().count()).unwrap_or_else(|| along_axes(of, axis))
}

/// Returns the rational roots, ascending at the values of the symbols.
fn sorted(of: &Symbolic, roots: &Roots) -> Vec<(RationalFunction, usize)> {
    let mut sorted = roots.rational.clone();
    let value = |root: &RationalFunction| of.evaluate(root).unwrap_or(f64::NAN);
    sorted.sort_by(|(a, _), (b, _)| value(a).total_cmp(&value(b)));
    sorted
}

/// Returns true if the roots have the values of the computed moments.
fn agree(of: &Symbolic, roots: &Roots, moments: [f64; 3]) -> bool {
    let mut left = moments.to_vec();
    let mut take = |value: Option<f64>| {
        let near = |m: &f64| value.is_some_and(|value| (value - m).abs() <= ROUNDING * moments[2]);
        left.iter().position(near).map(|k| left.remove(k)).is_some()
    };
    let are_moments = roots.rational.iter().all(|(root, multiplicity)| {
        let value = of.evaluate(root);
        (0..*multiplicity).all(|_| take(value))
    });
    are_moments
        && match &roots.rest {
            RemainingRoots::None => true,
            RemainingRoots::Pair(pair) => {
                let center = of.evaluate(&pair.center);
                let deviation = pair.deviation.evaluate(&|symbol| of.value(symbol));
                let both = center.zip(deviation);
                take(both.map(|(a, d)| a + d)) && take(both.map(|(a, d)| a - d))
            }
            RemainingRoots::NoClosedForm(polynomial) => {
                let at = |moment: f64| {
                    let coefficients = polynomial.coefficients().iter().map(|c| of.evaluate(c));
                    let values: Option<Vec<f64>> = coefficients.collect();
                    values.map(|values| {
                        let terms: Vec<f64> =
                            values.iter().zip(0..).map(|(c, k)| c * moment.powi(k)).collect();
                        let size = terms.iter().fold(0.0, |size, term| size + term.abs());
                        terms.iter().sum::<f64>().abs() <= ROUNDING * size
                    })
                };
                moments.iter().all(|&moment| at(moment) == Some(true))
            }
        }
}
