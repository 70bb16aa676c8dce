//! Packed rows are equal to the given rows, bit for bit.

use polhode::math::{Direction, Position, Rotation};
use polhode_budget::{
    Basis, Budget, BudgetError, CopyErrors, GivenPart, GivenTensor, Group, Growth, GrowthTable,
    PartUncertainty, PartsList, Place, ProductSign, Quantity, Row, Rows, Spread, Subtotal, TensorPoint,
    Uncertainty,
};

/// Returns numbers without short decimals.
fn numbers<const N: usize>(from: f64) -> [f64; N] {
    core::array::from_fn(|k| (from + k as f64).sin())
}

fn covariance<const N: usize>(from: f64) -> Box<[[f64; N]; N]> {
    Box::new(core::array::from_fn(|k| numbers(from + 10.0 * k as f64)))
}

/// Returns a row with all kinds of data.
fn full() -> Row {
    let tensor = GivenTensor {
        moments: numbers(1.0),
        products: numbers(2.0),
        sign: ProductSign::PositiveIntegral,
        about: TensorPoint::At(Position::from_array(numbers(3.0))),
    };
    Row {
        name: "bus/µ".repeat(70),
        parent: Some("a frame".to_owned()),
        quantity: Quantity { count: 7, errors: CopyErrors::Independent },
        place: Place {
            position: Position::from_array(numbers(4.0)),
            rotation: Rotation::exp(Direction::from_array(numbers(5.0))).unwrap(),
        },
        part: Some(GivenPart { mass: 0.1, center_of_mass: Position::from_array(numbers(6.0)), tensor }),
        uncertainty: Uncertainty {
            part: PartUncertainty::Separate {
                mass: 0.3,
                tensor_follows_mass: false,
                center: Spread::Deviations(numbers(7.0)),
                tensor: Spread::Covariance(covariance(8.0)),
            },
            position: Spread::Covariance(covariance(9.0)),
            rotation: Spread::Deviations(numbers(10.0)),
        },
        group: Some("scale".to_owned()),
        growth: Growth::Code("E".to_owned()),
        subtotal: Some(Subtotal { mass: 1.1, tolerance: 0.7 }),
        allowable: Some(2.3),
    }
}

/// Returns rows that each have one kind of data.
fn all() -> Vec<Row> {
    let plain = || Row::frame("f");
    let part =
        |tensor: GivenTensor| Row::part("p", GivenPart { tensor, ..GivenPart::point(0.7, Position::ZERO) });
    let about = |about| part(GivenTensor { about, ..GivenTensor::ZERO });
    let uncertain = |part| Row { uncertainty: Uncertainty { part, ..Uncertainty::default() }, ..plain() };
    vec![
        full(),
        plain(),
        Row { parent: Some(String::new()), ..plain() },
        Row { group: Some("g".to_owned()), growth: Growth::Fraction(0.0), ..plain() },
        Row { growth: Growth::Fraction(-0.0), allowable: Some(f64::INFINITY), ..full() },
        about(TensorPoint::CenterOfMass),
        about(TensorPoint::At(Position::ZERO)),
        about(TensorPoint::OriginOf("f".to_owned())),
        part(GivenTensor { products: [0.0, -0.0, 1e-300], ..GivenTensor::ZERO }),
        uncertain(PartUncertainty::of_mass(f64::MIN_POSITIVE)),
        uncertain(PartUncertainty::Joint(covariance(11.0))),
        Row { subtotal: Some(Subtotal { mass: 0.0, tolerance: 0.0 }), ..plain() },
    ]
}

#[test]
fn packed_rows_are_the_rows_that_were_given() {
    let given = all();
    let rows: Rows = given.clone().into_iter().collect();
    assert_eq!((rows.len(), rows.is_empty()), (given.len(), false));
    for (k, row) in given.iter().enumerate() {
        // Compared as text, in which -0.0 differs from 0.0.
        assert_eq!(format!("{:?}", rows.get(k)), format!("{row:?}"), "row {k}");
        assert_eq!(rows.name(k), row.name);
        assert_eq!(rows.mass(k), row.part.as_ref().map(|part| part.mass));
        assert_eq!(rows.is_exact(k), row.uncertainty == Uncertainty::default());
    }
    assert_eq!(rows.position("p"), Some(5));
    // Beyond the last row, an empty frame is returned.
    assert_eq!(rows.get(given.len()), Row::frame(""));
}

#[test]
fn a_row_that_encloses_all_is_their_parent() {
    let point = |name: &str| Row::part(name, GivenPart::point(2.0, Position::new(0.1, 0.2, 0.3)));
    let mut rows: Rows = [point("a"), point("a/b"), point("c")].into_iter().collect();
    rows.enclose(Row::frame("whole"));
    let budget = Budget::new(rows, Vec::new(), GrowthTable::default()).unwrap();
    assert_eq!((0..4).map(|k| budget.parent(k)).collect::<Vec<_>>(), [Some(3), Some(0), Some(3), None]);
    let list = budget.list();
    assert_eq!(list.rows[0].parent.as_deref(), Some("whole"));
    assert_eq!(list.rows[1].parent, None);
    // The copy makes the same body.
    assert_eq!(list.budget().unwrap().mass_properties(Basis::Basic), budget.mass_properties(Basis::Basic));
    assert_eq!(budget.mass_properties(Basis::Basic).unwrap().mass(), 6.0);
}

/// Rows of short lists are prepared once. Rows of long lists are prepared in each draw.
#[test]
fn long_lists_are_drawn_as_short_ones() {
    const PARTS: usize = 10_010;
    let row = |k: usize| Row {
        parent: Some("whole".to_owned()),
        uncertainty: Uncertainty { part: PartUncertainty::of_mass(0.02), ..Uncertainty::default() },
        ..Row::part(
            format!("{k}"),
            GivenPart::point(1.0 + k as f64 / PARTS as f64, Position::new(k as f64, 1.0, 2.0)),
        )
    };
    let exact = |k: usize| Row { uncertainty: Uncertainty::default(), ..row(k) };
    let body = |rows: Vec<Row>| {
        let frame = Row::frame("whole");
        PartsList { rows: [frame].into_iter().chain(rows).collect(), ..PartsList::default() }
            .budget()
            .unwrap()
    };
    // The random variables of a row depend only on its index in the list. Rows that are uncertain
    // in both lists therefore have the same draws.
    let short = body((0..PARTS).map(|k| if k < 100 { row(k) } else { exact(k) }).collect());
    let long = body((0..PARTS).map(row).collect());
    let masses = |budget: &Budget| -> Vec<f64> {
        budget
            .draws(Basis::Basic, 3, 10)
            .unwrap()
            .bodies
            .iter()
            .map(polhode::body::MassProperties::mass)
            .collect()
    };
    let (short, long, nominal) =
        (masses(&short), masses(&long), short.mass_properties(Basis::Basic).unwrap().mass());
    let sd = |masses: &[f64], count: usize| {
        let squares: f64 = masses.iter().map(|mass| (mass - nominal).powi(2)).sum();
        (squares / masses.len() as f64).sqrt() / (0.02 * (count as f64).sqrt())
    };
    // √(χ²/10) of ten draws is outside this interval once in a thousand times.
    assert!(
        (0.4..1.8).contains(&sd(&short, 100)) && (0.4..1.8).contains(&sd(&long, PARTS)),
        "{short:?} {long:?}"
    );
}

#[test]
fn errors_of_packed_rows_have_their_names() {
    let rows = all().into_iter().take(1).collect();
    let error = Budget::new(rows, vec![Group::of_masses("scale", 0.5)], GrowthTable::default()).unwrap_err();
    assert!(matches!(error, BudgetError::MissingFrame { ref frame, .. } if frame == "a frame"), "{error}");
}
