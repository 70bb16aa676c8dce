//! Errors of numbers in a report.

use polhode::math::Direction;
use polhode_budget::{Basis, GivenPart, Limit, Measure, PartUncertainty, Row, Spread, Uncertainty};
use serde_json::Value;

use super::{at, known, of_points, options, text, with_moments};

/// A mass of 1 ± 100 kg: draws miss its long tail, but first order includes it.
#[test]
fn a_mass_with_a_great_error_keeps_its_digits() {
    let doubtful =
        Row { uncertainty: known(100.0, 0.0), ..Row::part("s/a", GivenPart::point(1.0, at(0.2, 0.0, 0.0))) };
    let exact = Row::part("s/b", GivenPart::point(1.0, at(-0.3, 0.1, 0.0)));
    let report = of_points(vec![Row::frame("s"), doubtful, exact], Vec::new(), options(400));
    let text = text(&report).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("Mass 2 ± 100 kg"), "{text}");
    assert!(
        text.contains("first order is exact for the mass") && !text.contains("the draws are right"),
        "{text}"
    );
}

/// If two moments are equal, an error of one of them separates both. Derivatives cannot show this.
#[test]
fn equal_moments_have_their_errors_from_draws() {
    let spread = PartUncertainty::Separate {
        mass: 0.0,
        tensor_follows_mass: false,
        center: Spread::Exact,
        tensor: Spread::Deviations([0.05, 0.0, 0.0, 0.0, 0.0, 0.0]),
    };
    let row = Row {
        uncertainty: Uncertainty { part: spread, ..Uncertainty::default() },
        ..with_moments("a", [1.0, 1.0, 1.5], 0.0)
    };
    let drawn = of_points(vec![row.clone()], Vec::new(), options(400));
    let text_of_drawn = text(&drawn);
    let line = text_of_drawn.lines().find(|line| line.contains("Principal moments")).unwrap();
    assert!(line.contains(" by draws; ") && line.ends_with("1.5 kg·m²"), "{line}");
    let json = drawn.to_json();
    assert_eq!(json["configurations"][0]["principal"]["moment_sd"][0], Value::Null);
    let without = text(&of_points(vec![row], Vec::new(), options(0)));
    assert!(without.contains("1, no first-order error; 1, no first-order error; 1.5"), "{without}");
}

#[test]
fn axes_that_symmetry_leaves_free_are_said_to_be() {
    let row = Row { uncertainty: known(0.1, 0.0), ..with_moments("s/a", [0.001, 0.002, 0.002], 0.0) };
    let rows = vec![Row::frame("s"), row, with_moments("s/b", [0.001, 0.002, 0.002], 0.3)];
    let text = text(&of_points(rows, Vec::new(), options(20)));
    assert_eq!(text.matches("any direction perpendicular to axis 1").count(), 2, "{text}");
    assert!(text.contains("i2 = i3: axes 2 and 3 are arbitrary in their plane"), "{text}");
}

/// The tensor scales with the mass. A quantity that depends on neither has only rounding error.
#[test]
fn what_rounding_leaves_is_no_error() {
    let row = Row { uncertainty: known(0.1, 0.0), ..with_moments("a", [0.11, 0.13, 0.09], 0.0137) };
    let ratio = Limit {
        name: "spin".to_owned(),
        of: Measure::SpinRatio(Direction::new(0.0, 0.0, 1.0)),
        least: Some(0.3),
        most: None,
        basis: Basis::Basic,
    };
    let report = of_points(vec![row], vec![ratio], options(60));
    let json = report.to_json();
    let case = &json["configurations"][0];
    assert_eq!(case["limits"]["each"][0]["sd"].as_f64().unwrap(), 0.0);
    assert!(case["limits"]["each"][0]["value"].as_f64().unwrap() > 0.69);
    let text = text(&report);
    assert!(!text.contains("e-10") && !text.contains("e-17"), "{text}");
}
