//! Precession and nutation of a symmetric top, from its effective potential.

use polhode::motion::HeavyTop;
use polhode_algebra::{
    Accent, Formula, Kind, RationalFunction, Relation, RemainingRoots, RootPair, Symbol, Univariate, Variable,
};
use polhode_document::Section;
use polhode_document::unit::rate;

use super::system::{System, at_angle, collected, cosine, sine};
use super::write::{n, put, second_derivative};

/// Writes the effective potential of a symmetric top, its steady motions and small nutations.
pub(super) fn steady(
    system: &mut System,
    [phi, theta, _]: [Symbol; 3],
    i1: &RationalFunction,
    weight: Option<&RationalFunction>,
    s: &mut Section,
) -> Option<Steady> {
    let [p_phi, _, p_psi] = [0, 1, 2].map(|k| system.coordinates[k].momentum);
    let precession = phi.dot()?;
    let h = system.hamiltonian()?;
    // H = p_θ²/2I₁ + U_eff + p_ψ²/2I₃
    let effective = h.terms[1].plus(&system.potential);
    s.say("p_φ and p_ψ are constant. So θ moves like a particle in one dimension, in the effective potential U_eff, with the energy E_eff = E − p_ψ²/2I₃:");
    let [u_eff, e_eff] = ["U_eff", "E_eff"].map(Formula::named);
    let mut terms = vec![h.terms[1].clone(), system.potential.clone()];
    terms.retain(|term| !term.is_zero());
    put(s, &u_eff.clone().equals(system.sum(&terms)));
    let kinetic = Formula::sum(vec![system.kinetic[0].to_formula(&system.symbols), u_eff.clone()]);
    put(s, &e_eff.equals(kinetic));
    turning(system, theta, &effective, i1, s)?;
    let letters = &system.symbols;
    // p_φ at the rate φ̇, from its definition: I₁ φ̇ sin² θ + p_ψ cos θ.
    let lagrangian = system.lagrangian();
    let [of_phi, of_psi] = [0, 2].map(|k| lagrangian.momentum(system.coordinates[k].symbol));
    let p_phi_value = of_phi - (of_psi - RationalFunction::from(p_psi)) * cosine(theta);
    let slope = effective.derivative(theta);
    let condition = slope.substituted(p_phi, &p_phi_value)?.over(&-sine(theta))?;
    s.say("Steady precession at a constant θ requires dU_eff/dθ = 0. With p_φ at the rate φ\u{307} this is a quadratic equation for the rate:");
    put(s, &system.letter(p_phi).equals(p_phi_value.to_formula(letters)));
    let collected = system.collected(&condition, &[Variable::Symbol(precession)]);
    put(s, &collected.equals(Formula::integer(0)));
    let below = RationalFunction::from(condition.denominator().clone());
    let powers = condition.numerator().coefficients_in(Variable::Symbol(precession)).into_iter();
    let powers: Option<Vec<_>> = powers.map(|c| RationalFunction::from(c).over(&below)).collect();
    let roots = Univariate::new(powers?).roots();
    let rate = || system.letter(precession);
    for (root, _) in roots.rational.iter().filter(|(root, _)| !root.is_zero()) {
        put(s, &rate().equals(root.to_formula(letters)));
    }
    let pair = match roots.rest {
        RemainingRoots::Pair(pair) => Some(pair),
        _ => None,
    };
    if let (Some(pair), Some(weight)) = (&pair, weight) {
        put(s, &rate().equals(pair.to_formula(letters)));
        s.say("For p_ψ > 0 the lower sign is the slow precession, the upper sign the fast one. For a fast top, p_ψ² ≫ 4 I₁ M g l cos θ, they are");
        let spin = RationalFunction::from(p_psi);
        let [slow, fast] = [weight.over(&spin)?, spin.over(&(i1 * cosine(theta)))?];
        let about =
            |value: &RationalFunction| rate().related(Relation::Approximate, value.to_formula(letters));
        put(s, &Formula::List(vec![about(&slow), about(&fast)]));
    }
    s.say("Small nutations about it are harmonic, with Ω² = (d²U_eff/dθ²)/I₁ at constant p_φ and p_ψ. With p_ψ from the condition:");
    // The condition is linear in p_ψ.
    let slope_in_spin = condition.derivative(p_psi);
    let rest = condition.substituted(p_psi, &RationalFunction::zero())?;
    let spin = (-rest).over(&slope_in_spin)?;
    let second = slope.derivative(theta).substituted(p_phi, &p_phi_value)?.substituted(p_psi, &spin)?;
    let square = second.over(i1)?;
    let nutation = Formula::named("Omega").squared();
    put(s, &nutation.equals(system.collected(&square, &[])));
    match weight {
        None => s.say("The nutation has the rate of the precession: in space, axis 3 moves on a cone about L, whatever the polar axis."),
        Some(_) => sleeping(system, theta, &effective, [p_phi, p_psi], s)?,
    }
    Some(Steady { pair, square, precession })
}

/// Steady precession of a heavy top in symbols.
pub(super) struct Steady {
    /// Slow and fast rate φ̇ at θ with p_ψ.
    pair: Option<RootPair>,
    /// Ω² of small nutations at θ with φ̇.
    square: RationalFunction,
    precession: Symbol,
}

/// Writes u̇² as a cubic in u = cos θ, whose roots are the turning points.
fn turning(
    system: &mut System,
    theta: Symbol,
    effective: &RationalFunction,
    i1: &RationalFunction,
    s: &mut Section,
) -> Option<()> {
    let mut symbols = system.symbols.clone();
    let [energy, u] = ["E_eff", "u"].map(|name| symbols.declare(name, Kind::Constant).ok());
    let (energy, u) = (energy?, u?);
    let speed = (RationalFunction::from(energy) - effective) * RationalFunction::from(2);
    let square = speed.over(i1)? * sine(theta) * sine(theta);
    let cubic = square.replaced(&|variable| {
        Some(if variable == Variable::Cosine(theta) { u.into() } else { variable.into() })
    })?;
    s.say("At the turning points θ\u{307} = 0, E_eff = U_eff. With u = cos θ, u\u{307}² = θ\u{307}² sin² θ is a polynomial in u, and u oscillates between two of its roots:");
    let letter = Formula::named("u").accented(Accent::Dot).squared();
    put(s, &letter.equals(collected(&cubic, &[Variable::Symbol(u)], &symbols)));
    Some(())
}

/// Writes the condition for a sleeping top, from U_eff at θ = 0 with p_φ = p_ψ.
fn sleeping(
    system: &System,
    theta: Symbol,
    effective: &RationalFunction,
    [p_phi, p_psi]: [Symbol; 2],
    s: &mut Section,
) -> Option<()> {
    let upright = effective.substituted(p_phi, &p_psi.into())?;
    let second = at_angle(&upright.derivative(theta).derivative(theta), theta, [0, 1])?;
    s.say("The sleeping top is upright, with p_φ = p_ψ. It is stable if U_eff has a minimum at θ = 0:");
    let derivative = second_derivative(Formula::named("U_eff"), system.letter(theta));
    let value =
        derivative.equals(system.collected(&second, &[])).related(Relation::Greater, Formula::integer(0));
    put(s, &Formula::List(vec![system.letter(theta).equals(Formula::integer(0)), value]));
    Some(())
}

/// Writes turning points, rates and the threshold of the sleeping top as numbers.
pub(super) fn numbers(system: &System, top: &HeavyTop, steady: &Steady, s: &mut Section) {
    let [highest, lowest] = top.nutation_bounds();
    let middle = 0.5 * (highest + lowest);
    let [_, axial] = top.moments();
    let (theta, p_psi) = (system.coordinates[1].symbol, system.coordinates[2].momentum);
    s.line(format!(
        "turning points: θ = {}° and {}°: {}",
        n(highest.to_degrees()),
        n(lowest.to_degrees()),
        top.path().description()
    ));
    if let Some(period) = top.nutation_period() {
        s.line(format!("period of the nutation: {} s", n(period)));
    }
    let value = |symbol: Symbol| match symbol {
        symbol if symbol == theta => Some(middle),
        symbol if symbol == p_psi => Some(axial * top.spin()),
        symbol => system.constants.iter().find(|c| c.symbol == symbol).map(|c| c.value),
    };
    let rates = steady.pair.as_ref().and_then(|pair| {
        let (center, deviation) = (pair.center.evaluate(&value)?, pair.deviation.evaluate(&value)?);
        Some([center - deviation.copysign(center), center + deviation.copysign(center)])
    });
    let is_vertical = top.roots().is_none();
    if let Some(rates) = rates.filter(|_| !is_vertical) {
        for (name, precession) in ["slow", "fast"].into_iter().zip(rates) {
            let with =
                |symbol: Symbol| if symbol == steady.precession { Some(precession) } else { value(symbol) };
            let nutation =
                steady.square.evaluate(&with).map_or_else(|| "—".to_owned(), |square| n(square.sqrt()));
            s.line(format!(
                "{name} steady precession at θ = {}°: φ\u{307} = {},  nutation about it Ω = {nutation} rad/s",
                n(middle.to_degrees()),
                rate(precession)
            ));
        }
    } else if !is_vertical {
        s.line(format!("no steady precession at θ = {}° with this spin", n(middle.to_degrees())));
    }
    let threshold = top.sleeping_threshold();
    s.line(format!(
        "the top sleeps above ω3 = 2 √(I1 M g l)/I3 = {} rad/s; here ω3 = {} rad/s",
        n(threshold),
        n(top.spin())
    ));
}
