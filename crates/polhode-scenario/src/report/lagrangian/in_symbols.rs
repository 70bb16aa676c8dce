//! T, U and the equation of motion in the symbols of the file.

use polhode_algebra::{Formula, Kind, RationalFunction, RemainingRoots, Symbol, Symbols, Variable};
use polhode_document::Section;

use super::system::{Constant, System};
use super::write::put;
use crate::symbolic::Symbolic;

/// Largest relative difference between a formula and the value of a constant.
const ROUNDING: f64 = 1e-9;

/// Writes T and U with the symbols of the file in place of the constants of the system, and for one
/// degree of freedom the equation of motion.
pub(super) fn in_symbols(system: &System, of: &Symbolic, s: &mut Section) {
    let Some((symbols, values)) = replacements(system, of) else { return };
    let inserted = |formula: &RationalFunction| {
        formula.replaced(&|variable| {
            let of = |symbol: Symbol| {
                let base = values.iter().find(|(old, _)| same(*old, symbol));
                base.map(|(_, new)| new.clone())
            };
            match variable {
                Variable::Symbol(symbol) => derivative(of(symbol)?, symbol.order()),
                Variable::Sine(symbol) => Some(Variable::Sine(of(symbol)?.symbols().next()?).into()),
                Variable::Cosine(symbol) => Some(Variable::Cosine(of(symbol)?.symbols().next()?).into()),
                Variable::Root(_) => Some(variable.into()),
            }
        })
    };
    let kinetic: Option<Vec<RationalFunction>> = system.kinetic.iter().map(inserted).collect();
    let (Some(kinetic), Some(potential)) = (kinetic, inserted(&system.potential)) else { return };
    let written = |terms: &[RationalFunction]| {
        let terms = terms.iter().filter(|term| !term.is_zero());
        Formula::sum(terms.map(|term| term.to_formula(&symbols)).collect())
    };
    s.say("In the symbols of the file:");
    put(s, &Formula::named("T").equals(written(&kinetic)));
    put(s, &Formula::named("U").equals(written(std::slice::from_ref(&potential))));
    if let [coordinate] = &system.coordinates[..]
        && let Some(new) = symbols.find(&system.symbols.name(coordinate.symbol))
        && let Some(acceleration) = new.dot().and_then(Symbol::dot)
    {
        let lagrangian = kinetic.iter().fold(-potential, |sum, term| sum + term);
        let equation = lagrangian.lagrange_equation(new, &symbols);
        let by = [Variable::Symbol(acceleration), Variable::Sine(new), Variable::Symbol(new)];
        put(s, &equation.collected(&by, &symbols).equals(Formula::integer(0)));
    }
}

/// Returns the symbols of the file with the coordinates of a system, and for each constant and
/// coordinate of the system its formula in them; `None` if names collide.
fn replacements(system: &System, of: &Symbolic) -> Option<(Symbols, Vec<(Symbol, RationalFunction)>)> {
    let mut symbols = of.symbols.clone();
    let mut values = Vec::new();
    for constant in &system.constants {
        let formula = match formula(system, of, constant) {
            Some(formula) => formula,
            // It has no formula, so that it keeps its letter.
            None => symbols.declare(&system.symbols.name(constant.symbol), Kind::Positive).ok()?.into(),
        };
        values.push((constant.symbol, formula));
    }
    for coordinate in &system.coordinates {
        let new = symbols.declare(&system.symbols.name(coordinate.symbol), Kind::Coordinate).ok()?;
        values.push((coordinate.symbol, new.into()));
    }
    Some((symbols, values))
}

/// Returns the formula of a constant: the one of its kind that has its value.
fn formula(system: &System, of: &Symbolic, constant: &Constant) -> Option<RationalFunction> {
    let root = |square: RationalFunction| square.square_root(&of.symbols).as_rational_function();
    let lever = &of.center - of.point();
    let axis = of.pendulum.as_ref().and_then(|pendulum| Some(pendulum.as_ref().ok()?.axis.clone()));
    let candidates = match system.symbols.name(constant.symbol).as_str() {
        "M" => vec![Some(of.mass.clone())],
        "g" => {
            let gravity = of.gravity.as_ref().and_then(|gravity| gravity.as_ref().ok());
            let across = gravity.map(|g| match &axis {
                Some(n) => g - &n.scaled(&n.dot(g)),
                None => g.clone(),
            });
            vec![across.and_then(|g| root(g.dot(&g)))]
        }
        "d" | "l" => {
            let across = match &axis {
                Some(n) => &lever - &n.scaled(&n.dot(&lever)),
                None => lever,
            };
            vec![root(across.dot(&across))]
        }
        name if name == "I" || name.starts_with("I_") => {
            let about = axis.map(|n| n.dot(&of.tensor.times_vector(&n)));
            let roots = of.tensor.eigenvalues();
            let is_complete = roots.rest == RemainingRoots::None;
            let roots = roots.rational.into_iter().filter(|_| is_complete).map(|(root, _)| Some(root));
            std::iter::once(about).chain(roots).collect()
        }
        _ => Vec::new(),
    };
    let has_value = |formula: &RationalFunction| {
        of.evaluate(formula).is_some_and(|x| (x - constant.value).abs() <= ROUNDING * constant.value.abs())
    };
    candidates.into_iter().flatten().find(has_value)
}

/// Returns true if a symbol is another one or its time derivative.
fn same(symbol: Symbol, other: Symbol) -> bool {
    std::iter::successors(Some(symbol), |symbol| symbol.dot()).take(3).any(|symbol| symbol == other)
}

/// Returns the time derivative of a coordinate.
fn derivative(value: RationalFunction, order: u8) -> Option<RationalFunction> {
    if order == 0 {
        return Some(value);
    }
    let coordinate = value.symbols().next()?;
    let derivative = (0..order).try_fold(coordinate, |symbol, _| symbol.dot())?;
    Some(derivative.into())
}
