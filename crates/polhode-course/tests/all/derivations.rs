//! Derivations: every equation is checked, a wrong sign is found, and all forms of output are sound.

mod evaluate;
mod name;
mod scope;
mod value;

use polhode_course::derivation::{Derivation, Ground, Step, all, find, list, notation};
use polhode_document::{Block, mathml};

use scope::{EvaluationError, Scope};

/// Calls a function with each formula and the definitions of the steps before it.
fn for_each_formula(mut function: impl FnMut(&Derivation, &str, Ground, Scope)) {
    for derivation in all() {
        for (k, step) in derivation.steps().iter().enumerate() {
            if let Step::Formula { notation, ground, .. } = step {
                let mut scope = Scope::default();
                let earlier = derivation.steps()[..k].iter();
                earlier.filter_map(Step::definition).for_each(|definition| scope.define(&definition));
                function(derivation, notation, *ground, scope);
            }
        }
    }
}

/// Returns the number of equations that were compared, and true if all of them hold.
fn compared(notation: &str, scope: &mut Scope) -> Result<(usize, bool), EvaluationError> {
    let sides = scope.sides(notation)?;
    Ok((sides.len(), sides.iter().all(|sides| scope.are_equal(sides))))
}

#[test]
fn every_identity_holds() {
    let (mut count, mut failures) = (0, Vec::new());
    for_each_formula(|derivation, notation, ground, mut scope| {
        if ground == Ground::Shown {
            match compared(notation, &mut scope) {
                Ok((number @ 1.., true)) => count += number,
                other => failures.push(format!("{}: {notation}: {other:?}", derivation.name)),
            }
        }
    });
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(count > 240, "{count} equations");
}

/// The equations of a formula with another reason than algebra do not hold for generic values.
#[test]
fn nothing_is_assumed_that_can_be_shown() {
    let mut failures = Vec::new();
    for_each_formula(|derivation, notation, ground, mut scope| {
        if ground != Ground::Shown {
            match compared(notation, &mut scope) {
                Ok((_, false)) => {}
                Err(EvaluationError::Unsupported(_)) if notation.contains(['≡', '≃', '≤', '∫']) => {}
                other => failures.push(format!("{}: {notation}: {other:?}", derivation.name)),
            }
        }
    });
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn each_wrong_sign_is_found() {
    let (mut count, mut failures) = (0, Vec::new());
    for_each_formula(|derivation, notation, ground, mut scope| {
        if ground == Ground::Shown {
            for wrong in with_wrong_signs(notation) {
                count += 1;
                let compared = compared(&wrong, &mut scope);
                if !matches!(compared, Ok((_, false))) {
                    failures.push(format!("{}: {wrong}: {compared:?}", derivation.name));
                }
            }
        }
    });
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(count > 350, "{count} wrong formulas");
}

/// Returns the formula with one sign changed, for each sign and each right side.
fn with_wrong_signs(notation: &str) -> Vec<String> {
    let mut wrong = Vec::new();
    for (at, sign) in notation.char_indices() {
        let (before, after) = (&notation[..at], &notation[at + sign.len_utf8()..]);
        let is_first =
            before.trim_end().is_empty() || before.trim_end().ends_with(['=', '(', '[', '{', ',', ';']);
        match sign {
            '+' => wrong.push(format!("{before}−{after}")),
            '−' if is_first => wrong.push(format!("{before}{after}")),
            '−' => wrong.push(format!("{before}+{after}")),
            '=' if after.starts_with(" 0") => wrong.push(format!("{before}= 1{}", &after[2..])),
            '=' if !after.starts_with(" −") => wrong.push(format!("{before}= −{after}")),
            _ => {}
        }
    }
    wrong
}

#[test]
fn the_notation_is_read() {
    for (notation, text, latex) in [
        (
            "~ω̇_1 = ~ω × r̂",
            "ω̇₁ = ω × r̂",
            r"\dot{\boldsymbol{\omega}}_1 = \boldsymbol{\omega} \times \hat{\mathbf{r}}",
        ),
        ("1/2 (a + b)/c x'_αi²", "1/2 · (a + b)/c · x'_αi²", r"\frac{1}{2} \frac{a + b}{c} x'_{\alpha i}^2"),
        ("d/dt ~L = d/dt (a b)", "dL/dt = d/dt (a b)", r"\frac{d\mathbf{L}}{dt} = \frac{d}{dt} (a b)"),
        ("Σ_ij a_i b_j ≡ T_rot", "Σᵢⱼ aᵢ bⱼ ≡ T_rot", r"\sum_{ij} a_i b_j \equiv T_{\mathrm{rot}}"),
        ("sin² θ ≤ cos (Ω t)", "sin² θ ≤ cos(Ω t)", r"\sin^2 \theta \le \cos(\Omega t)"),
    ] {
        let formula = notation::read(notation).unwrap();
        assert_eq!((formula.to_text().as_str(), formula.to_latex().as_str()), (text, latex));
    }
    for wrong in
        ["", "a +", "a = ", "(a", "a)", "{I", "(a; b", "a_", "~", "~2", "a b × c × d", "Σ_", "a^", "a\n", "?"]
    {
        assert_eq!(notation::read(wrong), None, "{wrong}");
    }
}

#[test]
fn every_paragraph_is_read() {
    for derivation in all() {
        assert!(matches!(
            derivation.steps().iter().find(|s| !matches!(s, Step::Setting(_))),
            Some(Step::Part(_))
        ));
        for step in derivation.steps() {
            match step {
                Step::Formula { text, notation, .. } => {
                    assert!(!text.is_empty() && !text.contains(['~', '#']), "{text}");
                    assert!(step.formula().is_some(), "{notation}");
                }
                Step::Remark(text) => assert!(!text.contains(['~', '#']) && !text.contains(": ~"), "{text}"),
                Step::Setting(notation) => assert!(step.definition().is_some(), "{notation}"),
                Step::Part(_) => {}
            }
        }
    }
}

#[test]
fn all_forms_of_output_are_sound() {
    for derivation in all() {
        let document = derivation.document();
        assert!(!document.answer.is_empty(), "{}", derivation.name);
        let text = document.to_text(100);
        assert!(text.lines().all(|line| width(line) <= 100), "{text}");
        assert!(!text.contains('~'), "{text}");
        let blocks = document.sections.iter().flat_map(|section| &section.blocks);
        for latex in blocks
            .filter_map(|block| if let Block::Formula { latex, .. } = block { Some(latex) } else { None })
        {
            let count = |part: &str| latex.matches(part).count();
            assert_eq!(count("{"), count("}"), "{latex}");
            assert_eq!(count(r"\begin"), count(r"\end"), "{latex}");
            assert_eq!(count(r"\left"), count(r"\right"), "{latex}");
            assert!(latex.is_ascii(), "{latex}");
            assert!(!mathml::formula(latex, "unreadable").contains("unreadable"), "{latex}");
        }
    }
}

/// Returns the number of columns; accents take none.
fn width(line: &str) -> usize {
    line.chars().filter(|c| !('\u{300}'..='\u{36f}').contains(c)).count()
}

#[test]
fn derivations_are_found_by_name() {
    let names: Vec<&str> = all().iter().map(|derivation| derivation.name).collect();
    assert_eq!(
        names,
        [
            "kinetic-energy",
            "inertia-tensor",
            "cube",
            "angular-momentum",
            "torque",
            "pendulum-frequency",
            "parallel-axes",
            "change-of-axes",
            "principal-axes",
            "cube-axes",
            "euler-equations",
            "six-steps",
            "dumbbell",
            "symmetric-top",
            "energy-and-momentum",
            "coplanar",
            "cones",
        ]
    );
    let topics = list().to_text(100);
    for derivation in all() {
        assert_eq!(find(derivation.name), Some(derivation));
        assert!(topics.contains(derivation.name) && topics.contains(derivation.title), "{topics}");
    }
    assert_eq!(find("nutation"), None);
    for (name, message) in [
        ("euler-equation", "unknown derivation `euler-equation`; did you mean `euler-equations`?"),
        (
            "axes",
            "unknown derivation `axes`; did you mean `parallel-axes` or `change-of-axes` or `principal-axes` or `cube-axes`?",
        ),
        ("inertia", "unknown derivation `inertia`; did you mean `inertia-tensor`?"),
    ] {
        assert_eq!(name.parse::<&Derivation>().unwrap_err().to_string(), message);
    }
    let all_names = "x".parse::<&Derivation>().unwrap_err().to_string();
    assert_eq!(all_names, format!("unknown derivation `x`; the derivations are {}", names.join(", ")));
}
