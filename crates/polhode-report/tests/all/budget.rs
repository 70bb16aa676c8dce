//! The report of a mass budget, over lists that are made here.

use polhode::math::{Body, Direction, Part, Position, Rotation};
use polhode_budget::{
    Basis, Budget, Burn, Change, CopyErrors, Down, GivenPart, GivenTensor, Group, Growth, GrowthTable, Limit,
    Liquid, Measure, PartUncertainty, PartsList, Place, PrincipalAxis, ProductSign, Quantity, Row, Sequence,
    Spread, Tank, TankShape, TensorPoint, Uncertainty, Vessel,
};
use polhode_report::{BudgetDiff, BudgetOptions, BudgetReport};
use serde_json::Value;

fn options(draws: usize) -> BudgetOptions {
    BudgetOptions { basis: Basis::Predicted, about: None, along: None, draws, seed: 1 }
}

fn at(x: f64, y: f64, z: f64) -> Position<Part> {
    Position::new(x, y, z)
}

/// A box with sides in m.
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

/// A satellite of 3 units, 10 × 10 × 34 cm, with its wings out or not.
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

fn report(options: BudgetOptions) -> BudgetReport {
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

#[test]
fn json_has_what_the_core_says() {
    let report = report(options(200));
    let case = &report.to_json()["configurations"][0];
    let budget = satellite(true);
    for (key, basis) in [("basic", Basis::Basic), ("predicted", Basis::Predicted)] {
        let (found, want) = (&case[key], budget.estimate(basis).unwrap());
        assert_eq!(found["mass"], want.properties.mass());
        assert_eq!(numbers(&found["center_of_mass"]), want.properties.center_of_mass().to_array());
        for k in 0..10 {
            assert_eq!(numbers(&found["covariance"][k]), want.covariance[k]);
            assert_eq!(found["numbers"][k]["sd"], want.sd(k));
        }
    }
    assert_eq!(case["estimate"], case["predicted"]);
    assert_eq!(case["mass"]["allowable"], 4.0);
    let growth = 0.03 * 0.78 + 0.1 * (0.26 + 0.55 + 0.42) + 0.25 * (0.9 + 0.12);
    near(&[case["mass"]["growth_allowance"].as_f64().unwrap()], &[growth], 1e-14);
    // all that is told of the variance of a number is the variance
    for error in case["errors"].as_array().unwrap() {
        let told: f64 =
            error["by"].as_array().unwrap().iter().map(|by| by["variance"].as_f64().unwrap()).sum();
        let sd = error["sd"].as_f64().unwrap();
        near(&[told + error["rest"].as_f64().unwrap()], &[sd * sd], 1e-12);
    }
    // one that is not named is 0 to 1 of what a body may be
    for [a, b] in case["principal"]["triangle"]["cloud"]
        .as_array()
        .unwrap()
        .iter()
        .map(|p| [0, 1].map(|k| p[k].as_f64().unwrap()))
    {
        assert!(0.0 < a && a <= b && b <= 1.0 && a + b >= 1.0, "{a} {b}");
    }
    assert_eq!(case["rows"][3]["in"], "sat/battery");
    assert_eq!(case["rows"][3]["quantity"], 4);
}

#[test]
fn a_tensor_is_given_about_the_point_and_along_the_axes_that_are_asked_for() {
    let r = Rotation::<Body, Part>::from_roll_pitch_yaw([0.3, -0.2, 0.7]).unwrap();
    let point = polhode::math::Position::new(0.1, -0.2, 0.3);
    let asked = BudgetOptions { about: Some(point), along: Some(r), ..options(0) };
    let report = report(asked);
    let found = &report.to_json()["configurations"][0]["asked"];
    let whole = satellite(true).mass_properties(Basis::Predicted).unwrap();
    // R^T J R, with the columns of R the asked axes
    let (j, r) = (whole.inertia_about(point).matrix(), r.matrix());
    for a in 0..3 {
        let want = [0, 1, 2]
            .map(|b| (0..3).map(|i| (0..3).map(|k| r[i][a] * j[i][k] * r[k][b]).sum::<f64>()).sum::<f64>());
        near(&numbers(&found["inertia"][a]), &want, 1e-13);
    }
    assert!(text(&report).contains("About the point (0.1, -0.2, 0.3) m, along the axes that were asked for"));
}

#[test]
fn the_box_of_a_part_is_the_part_if_that_is_a_box() {
    let picture = &report(options(0)).to_json()["configurations"][0]["picture"];
    let solid =
        |name: &str| picture["solids"].as_array().unwrap().iter().find(|s| s["name"] == name).unwrap();
    let mut sides: Vec<f64> = solid("structure")["halves"]
        .as_array()
        .unwrap()
        .iter()
        .map(|half| 2.0 * numbers(half).iter().map(|x| x * x).sum::<f64>().sqrt())
        .collect();
    sides.sort_by(f64::total_cmp);
    near(&sides, &[0.1, 0.1, 0.34], 1e-12);
    assert!(numbers(&solid("harness")["halves"][0]).iter().all(|x| *x == 0.0));
    // 0.12 rad about y
    let camera = solid("camera")["halves"].as_array().unwrap();
    let longest = camera.iter().map(numbers).max_by(|a, b| a[2].abs().total_cmp(&b[2].abs())).unwrap();
    near(&[longest[0] / longest[2]], &[0.12_f64.tan()], 1e-12);
}

#[test]
fn limits_are_answered_and_broken_ones_named() {
    let report = report(options(500));
    assert!(report.is_beyond());
    let json = report.to_json();
    let limits = &json["configurations"][0]["limits"];
    let met: Vec<bool> =
        limits["each"].as_array().unwrap().iter().map(|limit| limit["met"].as_bool().unwrap()).collect();
    assert_eq!(met, [true, true, false, false]);
    assert_eq!(limits["all"]["met"], false);
    assert_eq!(limits["each"][0]["draws"]["of"], 500);
    let text = text(&report);
    assert!(text.contains("→ 2 of 4 limits are met; all in 0 % (0 … 0.7 %) of possible bodies"), "{text}");
    assert!(text.contains("these limits are not met: tilt of the long axis, spin about z"), "{text}");
}

#[test]
fn what_is_too_heavy_is_shown_and_said() {
    let mut list = satellite(true).list().clone();
    list.rows[2].allowable = Some(0.25);
    let heavy =
        BudgetReport::new(None, Vec::new(), vec![(None, list.budget().unwrap())], Vec::new(), options(0))
            .unwrap();
    assert!(heavy.is_beyond());
    let text = text(&heavy);
    assert!(text.contains("sat/battery is heavier with growth than allowed"), "{text}");
    let line = text.lines().find(|line| line.trim_start().starts_with("battery ")).unwrap();
    assert!(line.contains(" 0.25 ") && line.ends_with(" -0.036"), "{line}");
    assert!(!report(options(0)).is_beyond());
}

#[test]
fn of_a_long_list_the_upper_levels_are_shown() {
    let mut rows = vec![Row::frame("all")];
    for k in 0..40 {
        rows.push(Row::frame(format!("all/{k}")));
        rows.extend((0..10).map(|j| {
            Row::part(format!("all/{k}/{j}"), GivenPart::point(1.0, at(f64::from(k), f64::from(j), 0.3)))
        }));
    }
    let budget = PartsList { rows, ..PartsList::default() }.budget().unwrap();
    let long = BudgetReport::new(None, Vec::new(), vec![(None, budget)], Vec::new(), options(20)).unwrap();
    let text = text(&long);
    assert!(text.contains("381 more rows are in --json and --csv."), "{text}");
    assert!(text.contains("info: no part has an uncertainty"), "{text}");
    assert_eq!(long.to_json()["configurations"][0]["rows"].as_array().unwrap().len(), 441);
    assert_eq!(long.to_csv().unwrap().lines().count(), 442);
}

#[test]
fn configurations_stand_side_by_side_and_a_body_is_one_of_them() {
    let both = [("stowed", false), ("deployed", true)]
        .map(|(name, wings)| (Some(name.to_owned()), satellite(wings)));
    let both =
        BudgetReport::new(Some("A CubeSat"), Vec::new(), both.to_vec(), limits(), options(100)).unwrap();
    let text = text(&both);
    assert!(text.contains("number  stowed  ") && text.contains("3. stowed: Masses"), "{text}");
    let none = both.body(None).unwrap_err();
    assert_eq!(
        (none.to_string(), none.hint()),
        (
            "there are several configurations, and a body is one of them".to_owned(),
            "name one of \"stowed\", \"deployed\"".to_owned(),
        )
    );
    assert_eq!(both.body(Some("flying")).unwrap_err().to_string(), "there is no configuration \"flying\"");
    let body = both.body(Some("stowed")).unwrap();
    assert_eq!(body, satellite(false).mass_properties(Basis::Predicted).unwrap());
    let toml = both.to_scenario(Some("stowed")).unwrap();
    assert!(
        toml.contains(&format!("mass = {:?}", body.mass())) && toml.contains("stowed, predicted masses"),
        "{toml}"
    );
}

#[test]
fn a_difference_is_told_row_by_row() {
    let before = report(options(0));
    let mut list = satellite(true).list().clone();
    list.rows[1].part.as_mut().unwrap().mass = 0.8;
    list.rows[1].part.as_mut().unwrap().tensor.moments.iter_mut().for_each(|x| *x *= 0.8 / 0.78);
    list.rows[3].quantity.count = 5;
    list.rows[4].place.position = at(0.0, 0.003, 0.004);
    list.rows[5].growth = Growth::Fraction(0.2);
    list.rows[6].uncertainty = known(0.02, 0.001);
    list.rows.pop();
    list.rows.push(Row::part("sat/antenna", GivenPart::point(0.05, at(0.0, 0.0, 0.34))));
    let after = BudgetReport::new(
        Some("A CubeSat"),
        Vec::new(),
        vec![(None, list.budget().unwrap())],
        Vec::new(),
        options(0),
    )
    .unwrap();
    let diff = BudgetDiff::new(&before, &after);
    let json = diff.to_json();
    let changes = json["configurations"][0]["changes"].as_array().unwrap();
    let told: Vec<[&str; 2]> =
        changes.iter().map(|change| [&change["row"], &change["what"]].map(|x| x.as_str().unwrap())).collect();
    assert_eq!(
        told,
        [
            ["sat/structure", "mass"],
            ["sat/battery/cells", "quantity"],
            ["sat/boards", "moved"],
            ["sat/camera", "growth"],
            ["sat/wing left", "uncertainty"],
            ["sat/antenna", "added"],
            ["sat/harness", "removed"],
        ]
    );
    near(&[changes[2]["by"].as_f64().unwrap()], &[0.005], 1e-12);
    let text = diff.to_document().to_text(100);
    for line in [
        "heavier: 0.78 to 0.8 kg, by +0.02 kg",
        "4 to 5 of it",
        "moved by 5 mm",
        "growth allowance 25 % to 20 %",
        "removed, with 0.12 kg",
        "7 changes of 7 rows; predicted mass 3.4314 to 3.3785 kg, by -0.0529 kg",
    ] {
        assert!(text.contains(line), "{line}: {text}");
    }
    assert!(BudgetDiff::new(&before, &before).is_empty());
    assert!(!diff.is_empty());
}

#[test]
fn the_page_has_its_pictures_and_nothing_from_elsewhere() {
    let page = report(options(100)).to_document().to_html();
    for words in [
        "What the mass is made of",
        "Errors of the inertia tensor",
        "from aside",
        "principal axis 3",
        "draws</text>",
    ] {
        assert!(page.contains(words), "{words}");
    }
    assert!(!page.contains("NaN") && !page.contains("inf"), "a place is no number");
    assert!(!page.contains("src=") && !page.contains("href="));
}

/// Bodies without extent, of one part, or exact have pages too.
#[test]
fn a_point_has_a_report() {
    let point = PartsList {
        rows: vec![Row::part("one", GivenPart::point(2.0, at(0.5, 0.0, 0.0)))],
        ..PartsList::default()
    };
    let report =
        BudgetReport::new(None, Vec::new(), vec![(None, point.budget().unwrap())], Vec::new(), options(20))
            .unwrap();
    let page = report.to_document().to_html();
    assert!(!page.contains("NaN"), "{page}");
    assert!(text(&report).contains("Mass 2 kg"));
}

#[test]
fn tanks_and_what_happens_are_those_of_the_sequence() {
    let parts = [("a", at(0.4, 0.0, 0.2)), ("b", at(-0.4, 0.1, 0.2)), ("c", at(0.0, 0.3, -0.5))];
    let mut rows = vec![Row::frame("bus")];
    rows.extend(parts.map(|(name, place)| Row {
        parent: Some("bus".to_owned()),
        ..Row::part(name, GivenPart::point(10.0, place))
    }));
    let budget = PartsList { rows, ..PartsList::default() }.budget().unwrap();
    let vessel = Vessel::new(TankShape::Ellipsoid([0.25; 3]), 1000.0, Down::MinusZ).unwrap();
    let liquid = Liquid::Vessel(Box::new(vessel));
    let tank = Tank { name: "water".to_owned(), frame: "bus".to_owned(), liquid };
    let burn = Burn { tank: "water".to_owned(), from: 10.0, until: 60.0, flow: 0.5 };
    let drop = Change::Drop { time: 70.0, rows: vec!["c".to_owned()] };
    let sequence = Sequence {
        burns: vec![burn],
        changes: vec![drop],
        ..Sequence::of(&budget, Basis::Predicted, [(tank, 40.0)])
    };
    let all = vec![(None, budget.clone())];
    let report = BudgetReport::new(None, Vec::new(), all, Vec::new(), options(0)).unwrap();
    let report = report.with_sequence(None, &sequence, Some(90.0)).unwrap();
    let data = &report.to_json()["configurations"][0]["changing"];
    let rows = data["over_time"]["rows"].as_array().unwrap();
    // Stretches from 0 to 10, 60, 70 and 90 s, of 17 rows each.
    assert_eq!(rows.len(), 4 * 17);
    let mut jumps = 0;
    for row in rows.iter().filter(|row| ![60.0, 70.0, 90.0].contains(&row["time"].as_f64().unwrap())) {
        let want = sequence.at(row["time"].as_f64().unwrap()).unwrap();
        let matrix = want.properties.inertia().matrix();
        let pairs = [
            (&row["mass"], want.properties.mass()),
            (&row["center_of_mass"][1], want.properties.center_of_mass().y),
            (&row["inertia"][0][2], matrix[0][2]),
            (&row["rates"]["center_of_mass"][2], want.rates.center_of_mass.z),
            (&row["rates"]["inertia"][1][1], want.rates.inertia[1]),
        ];
        // At 10 s there are two rows, of which one is before the burn.
        let is_before = row["time"] == 10.0 && row["rates"]["mass"] == 0.0;
        jumps += usize::from(is_before);
        for (found, want) in pairs.iter().take(if is_before { 3 } else { 5 }) {
            assert!((found.as_f64().unwrap() - want).abs() < 1e-12, "{found} {want}");
        }
    }
    assert_eq!(jumps, 1);
    let by_fill = data["by_fill"][0]["rows"].as_array().unwrap();
    let half = by_fill.iter().find(|row| row["fill"] == 0.5).unwrap();
    let want = sequence.by_fill(&[0.5]).unwrap()[0].properties;
    assert!((half["mass"].as_f64().unwrap() - want.mass()).abs() < 1e-12);
    assert!((half["center_of_mass"][2].as_f64().unwrap() - want.center_of_mass().z).abs() < 1e-12);
    assert!((half["level"].as_f64().unwrap() - 0.25).abs() < 1e-12);
    let document = report.to_document();
    let text = document.to_text(100);
    for said in ["70     c dropped", "In 90 s 70 kg become 35 kg", "water: 40 kg of 65.45 kg"] {
        assert!(text.contains(said), "{said}: {text}");
    }
    assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
    assert!(document.to_html().contains("Mass over time"));
}

/// A report of one list of points.
fn of_points(rows: Vec<Row>, limits: Vec<Limit>, options: BudgetOptions) -> BudgetReport {
    let list = PartsList { rows, ..PartsList::default() };
    BudgetReport::new(None, Vec::new(), vec![(None, list.budget().unwrap())], limits, options).unwrap()
}

#[test]
fn all_the_mass_in_the_origin_has_a_page() {
    let report =
        of_points(vec![Row::part("a", GivenPart::point(1.0, at(0.0, 0.0, 0.0)))], Vec::new(), options(20));
    let page = report.to_document().to_html();
    assert!(!page.contains("NaN") && !page.contains("inf\""), "{page}");
    assert!(page.contains("a point"), "its place is still listed");
}

#[test]
fn a_point_beyond_numbers_is_refused() {
    let budget = satellite(true);
    let about = Some(Position::new(1e200, 2.0, -1.0));
    let asked = BudgetOptions { about, ..options(0) };
    let error = BudgetReport::new(None, Vec::new(), vec![(None, budget)], Vec::new(), asked).unwrap_err();
    let words = error.to_string();
    assert!(words.contains(" is 1e200, and has to be so small that") || words.contains("1000000"), "{words}");
}

#[test]
fn a_difference_has_what_is_stated_besides_the_rows() {
    let list = satellite(true).list().clone();
    let mut other = list.clone();
    other.groups[0].mass = 0.35;
    other.groups[0].rotation = 0.25;
    let of = |list: &PartsList, limits: Vec<Limit>| {
        let budget = list.clone().budget().unwrap();
        BudgetReport::new(None, Vec::new(), vec![(None, budget)], limits, options(0)).unwrap()
    };
    let mut changed = limits();
    changed[0].most = changed[0].most.map_or(Some(9.0), |most| Some(1.5 * most));
    let gone = changed.pop().unwrap().name;
    let reports = [of(&list, limits()), of(&other, changed)];
    let diff = BudgetDiff::new(&reports[0], &reports[1]);
    assert!(!diff.is_empty());
    let json = diff.to_json();
    assert_eq!(json["configurations"][0]["changes"].as_array().unwrap().len(), 0);
    let group = &json["configurations"][0]["stated"];
    assert_eq!(group[0]["what"], "group wings");
    assert_eq!(group[0]["after"], "mass 0.35, position 0.5, rotation 0.25");
    assert_eq!(json["stated"][0]["what"], format!("limit {}", limits()[0].name));
    assert_eq!(json["stated"][1]["what"], format!("limit {gone}"));
    assert_eq!(json["stated"][1]["after"], Value::Null);
    let text = diff.to_document().to_text(100);
    assert!(text.contains("changed besides the rows: group wings"), "{text}");
}

/// What stood in a frame that is gone stays with its mass.
#[test]
fn a_frame_that_is_gone_takes_no_mass_along() {
    let inside = |parent: &str| Row {
        parent: Some(parent.to_owned()),
        ..Row::part("c", GivenPart::point(1.3, at(0.1, 0.0, 0.0)))
    };
    let frame =
        |name: &str, parent: Option<&str>| Row { parent: parent.map(str::to_owned), ..Row::frame(name) };
    let before = vec![frame("s", None), frame("b", Some("s")), inside("b")];
    let after = vec![frame("s", None), inside("s")];
    let [before, after] = [before, after].map(|rows| of_points(rows, Vec::new(), options(0)));
    let text = BudgetDiff::new(&before, &after).to_document().to_text(100);
    assert!(text.contains("removed, a frame") && !text.contains("removed, with"), "{text}");
}

/// 1 ± 100 kg: draws miss the tail of the mass, and first order has it.
#[test]
fn a_mass_with_a_great_error_keeps_its_digits() {
    let doubtful =
        Row { uncertainty: known(100.0, 0.0), ..Row::part("s/a", GivenPart::point(1.0, at(0.2, 0.0, 0.0))) };
    let exact = Row::part("s/b", GivenPart::point(1.0, at(-0.3, 0.1, 0.0)));
    let report = of_points(vec![Row::frame("s"), doubtful, exact], Vec::new(), options(400));
    let text = text(&report).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("Mass 2 ± 100 kg"), "{text}");
    assert!(
        text.contains("of the mass first order is exact") && !text.contains("the draws are right"),
        "{text}"
    );
}

/// A part with this diagonal tensor about its centre.
fn with_moments(name: &str, moments: [f64; 3], x: f64) -> Row {
    let part = solid(1.3, at(x, 0.0, 0.0), [0.1; 3]);
    let tensor = GivenTensor { moments, ..part.tensor };
    Row::part(name, GivenPart { tensor, ..part })
}

/// Where two moments are equal, an error of one of them parts both, which no derivative says.
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
    assert!(
        without.contains("1, its error not to first order; 1, its error not to first order; 1.5"),
        "{without}"
    );
}

#[test]
fn axes_that_symmetry_leaves_free_are_said_to_be() {
    let row = Row { uncertainty: known(0.1, 0.0), ..with_moments("s/a", [0.001, 0.002, 0.002], 0.0) };
    let rows = vec![Row::frame("s"), row, with_moments("s/b", [0.001, 0.002, 0.002], 0.3)];
    let text = text(&of_points(rows, Vec::new(), options(20)));
    assert_eq!(text.matches("any direction across axis 1").count(), 2, "{text}");
    assert!(text.contains("i2 = i3: axes 2 and 3 are free in their plane"), "{text}");
}

/// Masses scale with the tensor: what depends on neither has no error but rounding.
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
