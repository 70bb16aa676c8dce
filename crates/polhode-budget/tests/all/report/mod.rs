//! Report of a mass budget, for lists that are made here.

mod body;
mod diff;
mod errors;
mod pictures;
mod tanks;
mod whole;

use polhode::math::{Direction, Part, Position, Rotation};
use polhode_budget::read::Questions;
use polhode_budget::report::BudgetReport;
use polhode_budget::{
    Basis, Budget, CopyErrors, GivenPart, GivenTensor, Group, Growth, GrowthTable, Limit, Measure,
    PartUncertainty, PartsList, Place, PrincipalAxis, ProductSign, Quantity, Row, Spread, TensorPoint,
    Uncertainty,
};
use serde_json::Value;

fn options(draws: usize) -> Questions {
    Questions { draws: Some(draws), ..Questions::default() }
}

fn at(x: f64, y: f64, z: f64) -> Position<Part> {
    Position::new(x, y, z)
}

/// Returns a box with sides in m.
fn solid(mass: f64, center: Position<Part>, [a, b, c]: [f64; 3]) -> GivenPart {
    let moment = |x: f64, y: f64| mass / 12.0 * (x * x + y * y);
    GivenPart {
        mass,
        center_of_mass: center,
        tensor: GivenTensor {
            moments: [moment(b, c), moment(a, c), moment(a, b)],
            products: [0.0; 3],
            sign: ProductSign::NegativeIntegral,
            about: TensorPoint::CenterOfMass,
        },
    }
}

fn known(mass: f64, place: f64) -> Uncertainty {
    Uncertainty {
        part: PartUncertainty::of_mass(mass),
        position: Spread::Deviations([place; 3]),
        ..Uncertainty::default()
    }
}

/// Returns a satellite of 3 units, 10 × 10 × 34 cm, with its wings stowed or deployed.
fn satellite(wings: bool) -> Budget {
    let row = |name: &str, part: GivenPart, code: &str, uncertainty| Row {
        growth: Growth::Code(code.to_owned()),
        uncertainty,
        ..Row::part(name, part)
    };
    let far = if wings { 0.13 } else { 0.05 };
    let wing = |name: &str, x: f64, side: f64| {
        let plate = if wings { [0.16, 0.08, 0.003] } else { [0.003, 0.08, 0.32] };
        Row {
            place: Place { position: at(x, 0.0, 0.15), ..Place::default() },
            group: Some("wings".to_owned()),
            ..row(name, solid(0.21, at(0.5 * side * 0.01, 0.002, 0.0), plate), "B", known(0.012, 0.001))
        }
    };
    let structure = Row {
        allowable: Some(0.9),
        ..row("sat/structure", solid(0.78, at(0.0, 0.0, 0.17), [0.1, 0.1, 0.34]), "A", known(0.01, 0.0002))
    };
    let cells = Row {
        quantity: Quantity { count: 4, errors: CopyErrors::Independent },
        ..row(
            "sat/battery/cells",
            solid(0.065, at(0.004, -0.002, 0.0), [0.07, 0.02, 0.07]),
            "B",
            known(0.001, 0.001),
        )
    };
    let camera = Row {
        place: Place {
            position: at(0.012, -0.006, 0.27),
            rotation: Rotation::from_roll_pitch_yaw([0.0, 0.12, 0.0]).unwrap(),
        },
        ..row("sat/camera", solid(0.9, Position::ZERO, [0.08, 0.08, 0.12]), "C", known(0.06, 0.003))
    };
    let list = PartsList {
        rows: vec![
            Row { allowable: Some(4.0), ..Row::frame("sat") },
            structure,
            Row {
                place: Place { position: at(0.0, 0.0, 0.08), ..Place::default() },
                allowable: Some(0.3),
                ..Row::frame("sat/battery")
            },
            cells,
            row(
                "sat/boards",
                solid(0.55, at(-0.003, 0.001, 0.16), [0.09, 0.09, 0.08]),
                "B",
                known(0.02, 0.001),
            ),
            camera,
            wing("sat/wing left", far, 1.0),
            wing("sat/wing right", -far, -1.0),
            row("sat/harness", GivenPart::point(0.12, at(0.01, 0.015, 0.2)), "C", known(0.03, 0.01)),
        ],
        groups: vec![Group { position: 0.5, ..Group::of_masses("wings", 0.9) }],
        growth: GrowthTable::new(
            [("A", 0.03), ("B", 0.1), ("C", 0.25)].map(|(name, x)| (name.to_owned(), x)),
        )
        .unwrap(),
    };
    list.budget().unwrap()
}

fn limits() -> Vec<Limit> {
    let limit = |name: &str, of, least, most| Limit {
        name: name.to_owned(),
        of,
        least,
        most,
        basis: Basis::Predicted,
    };
    let z = Direction::new(0.0, 0.0, 1.0);
    vec![
        limit("mass", Measure::Mass, None, Some(3.6)),
        limit(
            "centre from the z axis",
            Measure::CenterFromLine { point: polhode::math::Position::ZERO, along: z },
            None,
            Some(0.005),
        ),
        limit(
            "tilt of the long axis",
            Measure::Tilt { axis: PrincipalAxis::Nearest, from: z },
            None,
            Some(0.1),
        ),
        limit("spin about z", Measure::SpinRatio(z), Some(1.0), None),
    ]
}

fn report(options: Questions) -> BudgetReport {
    let sources = vec!["satellite.csv: the list is complete".to_owned()];
    BudgetReport::new(Some("A CubeSat"), sources, vec![(None, satellite(true))], limits(), options).unwrap()
}

fn text(report: &BudgetReport) -> String {
    report.to_document().to_text(100)
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn near(got: &[f64], want: &[f64], tolerance: f64) {
    assert_eq!(got.len(), want.len());
    let size = want.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (a, b) in got.iter().zip(want) {
        assert!((a - b).abs() <= tolerance * size, "{got:?} is not {want:?}");
    }
}

/// Returns a report of one list of points.
fn of_points(rows: Vec<Row>, limits: Vec<Limit>, options: Questions) -> BudgetReport {
    let list = PartsList { rows, ..PartsList::default() };
    BudgetReport::new(None, Vec::new(), vec![(None, list.budget().unwrap())], limits, options).unwrap()
}

/// Returns a part with this diagonal tensor about its centre.
fn with_moments(name: &str, moments: [f64; 3], x: f64) -> Row {
    let part = solid(1.3, at(x, 0.0, 0.0), [0.1; 3]);
    let tensor = GivenTensor { moments, ..part.tensor };
    Row::part(name, GivenPart { tensor, ..part })
}
