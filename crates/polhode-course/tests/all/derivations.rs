//! Derivations: every equation is checked, a wrong sign is found, and all forms of output are sound.

use polhode_course::derivation::{Derivation, EvaluationError, Ground, Step, all, find, list};
use polhode_document::Block;

/// Calls a function with each formula: derivation, number of earlier steps, notation and reason.
fn for_each_formula(mut function: impl FnMut(&Derivation, usize, &str, Ground)) {
    for derivation in all() {
        for (k, step) in derivation.steps().iter().enumerate() {
            if let Step::Formula { notation, ground, .. } = step {
                function(derivation, k, notation, *ground);
            }
        }
    }
}

#[test]
fn every_identity_holds() {
    let (mut count, mut failures) = (0, Vec::new());
    for_each_formula(|derivation, k, notation, ground| {
        if ground.is_identity() {
            let sides = derivation.sides(notation, k).map_or(0, |sides| sides.len());
            count += sides;
            let holds = derivation.holds(notation, k);
            if holds != Ok(true) || sides == 0 {
                failures.push(format!("{}: {notation}: {holds:?}", derivation.name));
            }
        }
    });
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(count > 200, "{count} components");
}

/// A formula with another reason than algebra is either the definition of a symbol, or its equations
/// do not hold for generic values: nothing is assumed that could be shown.
#[test]
fn nothing_is_assumed_that_can_be_shown() {
    let mut failures = Vec::new();
    for_each_formula(|derivation, k, notation, ground| {
        if !ground.is_identity() {
            match derivation.holds(notation, k) {
                Ok(false) => {}
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
    for_each_formula(|derivation, k, notation, ground| {
        if !ground.is_identity() {
            return;
        }
        for wrong in with_wrong_signs(notation) {
            count += 1;
            let holds = derivation.holds(&wrong, k);
            if holds != Ok(false) {
                failures.push(format!("{}: {wrong}: {holds:?}", derivation.name));
            }
        }
    });
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(count > 300, "{count} wrong formulas");
}

/// Returns the formula with one sign changed, for each sign and each right side.
fn with_wrong_signs(notation: &str) -> Vec<String> {
    let mut wrong = Vec::new();
    for (at, sign) in notation.char_indices() {
        let (before, after) = (&notation[..at], &notation[at + sign.len_utf8()..]);
        match sign {
            '+' => wrong.push(format!("{before}−{after}")),
            '−' if before.trim_end().is_empty()
                || before.trim_end().ends_with(['=', '(', '[', '{', ',', ';']) =>
            {
                wrong.push(format!("{before}{after}"));
            }
            '−' => wrong.push(format!("{before}+{after}")),
            '=' if after.trim_start().starts_with('0') => wrong.push(format!("{before}= 1")),
            '=' if after.trim_start().starts_with('−') => {}
            '=' => wrong.push(format!("{before}= −{}", after.trim_start())),
            _ => {}
        }
    }
    wrong
}

#[test]
fn print() {
    for derivation in all() {
        println!("{}", derivation.document().to_text(100));
    }
}
