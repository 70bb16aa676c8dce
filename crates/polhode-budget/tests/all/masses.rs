//! Basic, predicted and allowable mass.

use polhode::math::Position;
use polhode_budget::{
    Basis, CopyErrors, GivenPart, Growth, GrowthTable, PartUncertainty, PartsList, Quantity, Row, Subtotal,
    Uncertainty,
};

fn part(name: &str, mass: f64, growth: Growth) -> Row {
    Row { growth, ..Row::part(name, GivenPart::point(mass, Position::new(0.1, 0.2, -0.3))) }
}

fn code(code: &str) -> Growth {
    Growth::Code(code.to_owned())
}

/// Returns a list: two panels of 3 kg with four hinges of 0.25 kg each, and a bus of 10 kg with a
/// battery of 4 kg.
fn list() -> PartsList {
    let many = |count, row| Row { quantity: Quantity { count, ..Quantity::ONE }, ..row };
    PartsList {
        rows: vec![
            Row { allowable: Some(28.0), ..Row::frame("sc") },
            part("sc/bus", 10.0, code("E")),
            part("sc/bus/battery", 4.0, Growth::Fraction(0.05)),
            Row { allowable: Some(8.5), ..many(2, part("sc/panel", 3.0, code("L"))) },
            many(4, part("sc/panel/hinge", 0.25, Growth::None)),
        ],
        growth: GrowthTable::new([("E".to_owned(), 0.25), ("L".to_owned(), 0.12)]).unwrap(),
        ..PartsList::default()
    }
}

#[test]
fn growth_is_by_code_and_copies_count() {
    let statements = list().budget().unwrap().mass_statements().unwrap();
    let masses = |k: usize| [statements[k].basic, statements[k].predicted];
    let close = |got: [f64; 2], want: [f64; 2]| {
        assert!(got.iter().zip(want).all(|(a, b)| (a - b).abs() < 1e-13), "{got:?} {want:?}");
    };
    close(masses(0), [22.0, 16.7 + 8.72]);
    close(masses(1), [14.0, 12.5 + 4.2]);
    close(masses(3), [8.0, 2.0 * (3.36 + 1.0)]);
    close(masses(4), [1.0, 1.0]);
    let whole = statements[0];
    assert!((whole.growth_allowance() - 3.42).abs() < 1e-13);
    assert!((whole.margin().unwrap() - 2.58).abs() < 1e-13);
    assert!((whole.relative_margin().unwrap() - 2.58 / 22.0).abs() < 1e-14);
    // the panels exceed their allowable mass
    assert!((statements[3].margin().unwrap() + 0.22).abs() < 1e-13);
    assert_eq!(statements[1].margin(), None);
}

#[test]
fn a_subtotal_counts_all_copies() {
    let mut good = list();
    good.rows[3].subtotal = Some(Subtotal { mass: 8.0, tolerance: 0.0 });
    assert!(good.clone().budget().is_ok());
    good.rows[3].subtotal = Some(Subtotal { mass: 8.04, tolerance: 0.05 });
    assert!(good.budget().is_ok());
}

#[test]
fn copies_are_alike_or_independent() {
    for (errors, factor) in [(CopyErrors::Alike, 2.0 * 4.0), (CopyErrors::Independent, 2.0 * 2.0)] {
        let mut list = list();
        list.rows[4].quantity.errors = errors;
        list.rows[4].uncertainty =
            Uncertainty { part: PartUncertainty::of_mass(0.01), ..Uncertainty::default() };
        let estimate = list.budget().unwrap().estimate(Basis::Basic).unwrap();
        assert!((estimate.sd(0) - 0.01 * factor).abs() < 1e-15);
    }
}
