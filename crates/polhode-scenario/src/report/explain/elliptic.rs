//! The closed form of ω(t) of an asymmetric body: Jacobi's elliptic functions, with every constant
//! in numbers.

use polhode::motion::Regime;
use polhode::observe::{FreeRegime, JacobiForm, JacobiFunction};
use polhode_document::Section;

use super::working::{factor, n};

/// Largest modulus k for which the symmetric limit is mentioned.
const NEARLY_CIRCULAR: f64 = 0.1;

pub(crate) fn closed_form(form: &JacobiForm, free: &FreeRegime, s: &mut Section) {
    s.say(
        "With 2T and L² the squares of ω1 and ω3 are linear in ω2², so ω\u{307}2 = (i3 − i1) ω3 ω1 / i2 is the equation of \
         Jacobi's sn, and ω(t) is known in closed form, with u = λ (t − t0) + u0:",
    );
    match free.regime {
        Regime::LongAxis => s.formula(
            "ω1 = A1 dn(u, k),   ω2 = A2 sn(u, k),   ω3 = A3 cn(u, k)        (D < i2)",
            r"\omega_1 = A_1 \operatorname{dn}(u, k), \qquad \omega_2 = A_2 \operatorname{sn}(u, k), \qquad \omega_3 = A_3 \operatorname{cn}(u, k) \qquad (D < i_2)",
        ),
        Regime::Separatrix => s.formula(
            "ω1 = A1 sech u,   ω2 = A2 tanh u,   ω3 = A3 sech u        (D = i2, k = 1)",
            r"\omega_1 = A_1 \operatorname{sech} u, \qquad \omega_2 = A_2 \tanh u, \qquad \omega_3 = A_3 \operatorname{sech} u \qquad (D = i_2, k = 1)",
        ),
        _ => s.formula(
            "ω1 = A1 cn(u, k),   ω2 = A2 sn(u, k),   ω3 = A3 dn(u, k)        (D > i2)",
            r"\omega_1 = A_1 \operatorname{cn}(u, k), \qquad \omega_2 = A_2 \operatorname{sn}(u, k), \qquad \omega_3 = A_3 \operatorname{dn}(u, k) \qquad (D > i_2)",
        ),
    }
    constants(free.regime, s);
    let parameter = form.parameter();
    let [a1, a2, a3] = form.amplitudes();
    s.line(format!("A1 = {},  A2 = {},  A3 = {} rad/s", n(a1), n(a2), n(a3)));
    s.line(format!(
        "λ = {} /s,  k² = {},  1 - k² = {},  k = {}",
        n(form.rate()),
        n(parameter.m()),
        n(parameter.complement()),
        n(parameter.m().sqrt())
    ));
    let phase = form.phase();
    let names = form.functions().map(JacobiFunction::name);
    s.line(format!("u0 = {}: {} of u0 times the amplitudes are ω(t0)", n(phase), names.join(", ")));
    let written = [0, 1, 2].map(|k| {
        let name = match (free.regime, form.functions()[k]) {
            (Regime::Separatrix, JacobiFunction::Sn) => "tanh",
            (Regime::Separatrix, _) => "sech",
            (_, function) => function.name(),
        };
        let sign = if phase < 0.0 { "-" } else { "+" };
        format!(
            "ω{} = {} {name}({}·(t - t0) {sign} {})",
            k + 1,
            factor(form.amplitudes()[k]),
            n(form.rate()),
            n(phase.abs())
        )
    });
    for line in written {
        s.line(line);
    }
    if let Some(period) = free.period {
        s.formula(
            "period of ω in the body = 4 K(k) / λ,   K(k) = ∫ dx / √(1 − k² sin² x), x from 0 to π/2",
            r"\text{period of }\boldsymbol\omega\text{ in the body} = \frac{4 K(k)}{\lambda}, \qquad K(k) = \int_0^{\pi/2} \frac{dx}{\sqrt{1 - k^2 \sin^2 x}}",
        );
        s.line(format!(
            "K(k) = {},  period of ω = 4·{0} / {} = {} s",
            n(parameter.k()),
            n(form.rate()),
            n(period)
        ));
    }
    limits(form, free.regime, s);
}

/// Writes the amplitudes, λ and k² in terms of the constants of the motion.
fn constants(regime: Regime, s: &mut Section) {
    s.formula(
        "A1² = (2T i3 − L²) / (i1 (i3 − i1)),   A3² = (L² − 2T i1) / (i3 (i3 − i1))",
        r"A_1^2 = \frac{2T i_3 - L^2}{i_1 (i_3 - i_1)}, \qquad A_3^2 = \frac{L^2 - 2T i_1}{i_3 (i_3 - i_1)}",
    );
    match regime {
        Regime::LongAxis => s.formula(
            "A2² = (L² − 2T i1) / (i2 (i2 − i1)),   λ² = (i2 − i1)(2T i3 − L²) / (i1 i2 i3)\n\
             k² = (i3 − i2)(L² − 2T i1) / ((i2 − i1)(2T i3 − L²))",
            r"A_2^2 = \frac{L^2 - 2T i_1}{i_2 (i_2 - i_1)}, \qquad \lambda^2 = \frac{(i_2 - i_1)(2T i_3 - L^2)}{i_1 i_2 i_3}, \qquad k^2 = \frac{(i_3 - i_2)(L^2 - 2T i_1)}{(i_2 - i_1)(2T i_3 - L^2)}",
        ),
        _ => s.formula(
            "A2² = (2T i3 − L²) / (i2 (i3 − i2)),   λ² = (i3 − i2)(L² − 2T i1) / (i1 i2 i3)\n\
             k² = (i2 − i1)(2T i3 − L²) / ((i3 − i2)(L² − 2T i1))",
            r"A_2^2 = \frac{2T i_3 - L^2}{i_2 (i_3 - i_2)}, \qquad \lambda^2 = \frac{(i_3 - i_2)(L^2 - 2T i_1)}{i_1 i_2 i_3}, \qquad k^2 = \frac{(i_2 - i_1)(2T i_3 - L^2)}{(i_3 - i_2)(L^2 - 2T i_1)}",
        ),
    }
}

/// Writes the limits: k → 0 is the symmetric top or a small wobble, k → 1 the separatrix.
fn limits(form: &JacobiForm, regime: Regime, s: &mut Section) {
    let parameter = form.parameter();
    let k = parameter.m().sqrt();
    let circling = if regime == Regime::LongAxis { "axis 1" } else { "axis 3" };
    if regime == Regime::Separatrix {
        s.say(
            "The period is infinite: ω approaches the intermediate axis, ω2 → ±A2, without reaching it. For any other start nearby, ω comes close and the body flips, once in 2 K / λ ≃ ln(16 / (1 − k²)) / λ.",
        );
    } else if k < NEARLY_CIRCULAR {
        s.say(format!(
            "k is small: sn → sin, cn → cos, dn → 1, K → π/2. So ω circles {circling} on an ellipse at the rate λ, as that of a \
             symmetric top does on a circle, with corrections of order k²/4."
        ));
    } else {
        s.say(format!(
            "The limits: k → 0 (two equal moments, or ω close to {circling}) makes sn, cn, dn into sin, cos, 1 and the polhode \
             into an ellipse about {circling}; k → 1 (D → i2, the separatrix) makes them into tanh, sech, sech and the period \
             infinite, growing as (4/λ) ln(4 / √(1 − k²))."
        ));
    }
}
