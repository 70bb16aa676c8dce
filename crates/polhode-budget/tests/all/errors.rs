//! Errors of parts lists, with their messages.

use polhode::body::BodyError;
use polhode::math::Position;
use polhode_budget::{
    Basis, BudgetError, CopyErrors, GivenPart, GivenTensor, Group, Growth, GrowthTable, PartUncertainty,
    PartsList, ProductSign, Quantity, Row, Spread, Subtotal, TensorPoint, Uncertainty,
};

fn point(name: &str) -> Row {
    Row::part(name, GivenPart::point(1.5, Position::new(0.1, -0.2, 0.3)))
}

fn within(parent: &str, row: Row) -> Row {
    Row { parent: Some(parent.to_owned()), ..row }
}

fn error(rows: Vec<Row>) -> BudgetError {
    PartsList { rows, ..PartsList::default() }.budget().unwrap_err()
}

fn with_part(part: PartUncertainty) -> Row {
    Row { uncertainty: Uncertainty { part, ..Uncertainty::default() }, ..point("a") }
}

#[test]
fn trees_that_are_none() {
    let cases = [
        (vec![], "no row has a mass"),
        (vec![Row::frame("a"), Row::frame("a/b")], "no row has a mass"),
        (vec![point("a"), point(" ")], "row 2 has no name"),
        (vec![point("a"), point("a/b"), point("a")], "rows 1 and 3 have the same name, \"a\""),
        (
            vec![point("a"), point("a/b"), point("c")],
            "\"a\" and \"c\" both have no parent: only one row can be the root",
        ),
        (vec![point("a"), point("b/c")], "\"b/c\" refers to the frame \"b\", which is not a row"),
        (vec![point("a"), within("d", point("c"))], "\"c\" refers to the frame \"d\", which is not a row"),
        (
            vec![
                point("r"),
                within("r", point("x")),
                within("c", point("a")),
                within("a", point("b")),
                within("b", point("c")),
            ],
            "parents form a cycle: \"a\" in \"c\" in \"b\" in \"a\"",
        ),
        (vec![within("a", point("a"))], "parents form a cycle: \"a\" in \"a\""),
    ];
    for (rows, text) in cases {
        assert_eq!(error(rows).to_string(), text);
    }
}

#[test]
fn parts_that_cannot_exist() {
    let thin = GivenTensor { moments: [1.0, 2.0, 3.5], ..GivenTensor::ZERO };
    let row = |mass, tensor| {
        vec![Row::frame("a"), Row::part("a/b", GivenPart { mass, center_of_mass: Position::ZERO, tensor })]
    };
    let BudgetError::Part { row: name, error: BodyError::TriangleInequality { .. } } =
        error(row(1.0, thin.clone()))
    else {
        unreachable!()
    };
    assert_eq!((name.row, name.name.as_str()), (1, "a/b"));
    assert_eq!(
        error(row(-2.0, GivenTensor::ZERO)).to_string(),
        "\"a/b\" cannot exist: the mass = -2 must be positive and finite"
    );
    // Impossible about this point: at this distance, 2 kg have a greater moment.
    let about = TensorPoint::At(Position::new(2.0, 0.0, 0.0));
    let far = GivenTensor { moments: [1.0, 2.0, 2.5], about, ..GivenTensor::ZERO };
    assert!(matches!(
        error(row(2.0, far)),
        BudgetError::Part { error: BodyError::ImpossibleAtCenter { .. }, .. }
    ));
    // The sign of the products decides if this is possible: about its centre, all mass is in one
    // plane.
    let signed = |sign| GivenTensor {
        moments: [2.0, 2.0, 2.0],
        products: [0.95, 0.95, 0.95],
        sign,
        about: TensorPoint::CenterOfMass,
    };
    assert!(
        PartsList { rows: row(1.0, signed(ProductSign::NegativeIntegral)), ..PartsList::default() }
            .budget()
            .is_err()
    );
    let elsewhere = GivenTensor { about: TensorPoint::OriginOf("c".to_owned()), ..thin };
    assert_eq!(
        error(row(1.0, elsewhere)).to_string(),
        "\"a/b\" refers to the frame \"c\", which is not a row"
    );
}

#[test]
fn uncertainties_that_are_none() {
    let exact = || Spread::Exact;
    let separate =
        |mass, center, tensor| PartUncertainty::Separate { mass, tensor_follows_mass: false, center, tensor };
    let cases = [
        (with_part(PartUncertainty::of_mass(-0.1)), "the mass of \"a\" is -0.1"),
        (
            with_part(separate(0.0, Spread::Deviations([0.0, -1.0, 0.0]), exact())),
            "the centre of mass of \"a\" is -1",
        ),
        (
            with_part(separate(0.0, Spread::Exact, Spread::Deviations([0.1, 0.1, 0.1, 0.0, f64::NAN, 0.0]))),
            "the inertia tensor of \"a\" is NaN",
        ),
        (
            Row {
                uncertainty: Uncertainty {
                    rotation: Spread::Deviations([-1e-3; 3]),
                    ..Uncertainty::default()
                },
                ..point("a")
            },
            "the rotation of \"a\" is -0.001",
        ),
    ];
    for (row, text) in cases {
        let said = error(vec![row]).to_string();
        assert_eq!(
            said,
            format!("the standard deviation of {text}, but must be zero or positive, and finite")
        );
    }
    let bent = Spread::Covariance(Box::new([[1.0, 0.9, -0.9], [0.9, 1.0, 0.9], [-0.9, 0.9, 1.0]]));
    let row = Row { uncertainty: Uncertainty { position: bent, ..Uncertainty::default() }, ..point("a") };
    assert_eq!(
        error(vec![row]).to_string(),
        "the covariance of the position of \"a\" is not a covariance matrix: check element 3, 3"
    );
}

/// An overflow is refused. No standard deviation becomes zero or missing because of it.
#[test]
fn variances_that_are_none() {
    let of = |mass: f64, place: f64, sd: f64| {
        let at = Position::new(place, 0.3, -0.2);
        let part = PartUncertainty::Separate {
            mass: sd,
            tensor_follows_mass: true,
            center: Spread::Exact,
            tensor: Spread::Exact,
        };
        let row = Row::part("a", GivenPart::point(mass, at));
        let row = Row { uncertainty: Uncertainty { part, ..Uncertainty::default() }, ..row };
        PartsList {
            rows: vec![Row::frame("all"), within("all", row), within("all", point("b"))],
            ..PartsList::default()
        }
        .budget()
        .unwrap()
    };
    assert!(of(2.0, 1e30, 0.1).estimate(Basis::Basic).is_ok());
    for budget in [of(2.0, 1e90, 0.1), of(1e200, 0.1, 1e160)] {
        let error = budget.estimate(Basis::Basic).unwrap_err();
        assert!(matches!(error, BudgetError::Variance { .. }), "{error}");
        assert!(error.to_string().ends_with("of the total overflows") && error.hint().is_some());
    }
}

#[test]
fn numbers_and_names_that_are_none() {
    let none = Quantity { count: 0, errors: CopyErrors::Alike };
    let cases = [
        (Row { quantity: none, ..point("a") }, "the quantity of \"a\" is 0, but must be at least 1"),
        (
            Row { growth: Growth::Fraction(-0.1), ..point("a") },
            "the growth allowance of \"a\" is -0.1, but must be a fraction, zero or positive",
        ),
        (
            Row { growth: Growth::Code("X".to_owned()), ..point("a") },
            "\"a\" has the maturity code \"X\", which has no growth allowance",
        ),
        (
            Row { allowable: Some(0.0), ..point("a") },
            "the allowable mass of \"a\" is 0, but must be positive and finite",
        ),
        (
            Row { group: Some("g".to_owned()), ..point("a") },
            "\"a\" is in the group \"g\", which is not declared",
        ),
        (
            Row { subtotal: Some(Subtotal { mass: 1.4, tolerance: 0.05 }), ..point("a") },
            "\"a\" states 1.4 kg, but its rows add up to 1.5 kg, which differs by more than 0.05 kg",
        ),
        (
            Row { subtotal: Some(Subtotal { mass: f64::NAN, tolerance: 0.05 }), ..point("a") },
            "\"a\" states NaN kg, but its rows add up to 1.5 kg, which differs by more than 0.05 kg",
        ),
    ];
    for (row, text) in cases {
        assert_eq!(error(vec![row]).to_string(), text);
    }
    let copies = Quantity { count: 3, errors: CopyErrors::Independent };
    assert_eq!(
        error(vec![Row { quantity: copies, ..point("a") }, point("a/b")]).to_string(),
        "copies of \"a\" have independent errors, but \"a/b\" is inside it"
    );
    let groups =
        |groups| PartsList { rows: vec![point("a")], groups, ..PartsList::default() }.budget().unwrap_err();
    assert_eq!(
        groups(vec![Group::of_masses("g", 1.2)]).to_string(),
        "the correlation of masses of \"g\" is 1.2, but must be from 0 to 1"
    );
    assert_eq!(
        groups(vec![Group::of_masses("g", 1.0), Group::of_masses("g", 0.5)]).to_string(),
        "duplicate group \"g\""
    );
    let table = |codes: [(&str, f64); 2]| GrowthTable::new(codes.map(|(code, x)| (code.to_owned(), x)));
    assert!(table([("A", 0.1), ("A", 0.1)]).is_ok());
    assert_eq!(
        table([("A", 0.1), ("A", 0.2)]).unwrap_err().to_string(),
        "the growth allowance of \"A\" is 0.2, but must be the same everywhere"
    );
    assert!(table([("A", 0.1), ("B", -0.2)]).is_err());
    let budget = PartsList { rows: vec![point("a")], ..PartsList::default() }.budget().unwrap();
    assert_eq!(budget.draws(Basis::Basic, 1, 9), Err(BudgetError::Draws { given: 9, needed: 10 }));
}
