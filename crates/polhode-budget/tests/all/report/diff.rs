//! Differences between two lists.

use polhode_budget::report::{BudgetDiff, BudgetReport};
use polhode_budget::{GivenPart, Growth, Limit, PartsList, Row};
use serde_json::Value;

use super::{at, known, limits, near, of_points, options, report, satellite};

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
            ["sat/camera", "maturity"],
            ["sat/wing left", "uncertainty"],
            ["sat/antenna", "added"],
            ["sat/harness", "removed"],
        ]
    );
    near(&[changes[2]["by"].as_f64().unwrap()], &[0.005], 1e-12);
    let text = diff.to_document().to_text(100);
    for line in [
        "heavier: 0.78 to 0.8 kg, by +0.02 kg",
        "quantity 4 to 5",
        "moved by 5 mm",
        "growth allowance 25 % to 20 %",
        "maturity C to none",
        "sd of mass 0.012 to 0.02 kg",
        "removed, with 0.12 kg",
        "8 changes of 7 rows; predicted mass 3.4314 to 3.3785 kg, by -0.0529 kg",
    ] {
        assert!(text.contains(line), "{line}: {text}");
    }
    assert!(BudgetDiff::new(&before, &before).is_empty());
    assert!(!diff.is_empty());
}

#[test]
fn a_difference_has_what_is_stated_besides_the_rows() {
    let list = satellite(true).list().clone();
    let mut other = list.clone();
    other.groups[0].mass = 0.35;
    other.groups[0].rotation = 0.25;
    let of = |list: &PartsList, limits: Vec<Limit>| {
        let budget = list.clone().budget().unwrap();
        // A statement about both configurations is shown once.
        let configurations = ["a", "b"].map(|name| (Some(name.to_owned()), budget.clone()));
        BudgetReport::new(None, Vec::new(), configurations.to_vec(), limits, options(0)).unwrap()
    };
    let mut changed = limits();
    changed[0].most = changed[0].most.map_or(Some(9.0), |most| Some(1.5 * most));
    let gone = changed.pop().unwrap().name;
    let reports = [of(&list, limits()), of(&other, changed)];
    let diff = BudgetDiff::new(&reports[0], &reports[1]);
    assert!(!diff.is_empty());
    let json = diff.to_json();
    assert_eq!(json["configurations"][0]["changes"].as_array().unwrap().len(), 0);
    assert!(
        json["configurations"].as_array().unwrap().iter().all(|one| one["stated"] == Value::Array(vec![]))
    );
    let stated = json["stated"].as_array().unwrap();
    assert_eq!(stated.len(), 3, "{json}");
    assert_eq!(stated[0]["what"], "group wings");
    assert_eq!(stated[0]["after"], "mass 0.35, position 0.5, rotation 0.25");
    assert_eq!(stated[1]["what"], format!("limit {}", limits()[0].name));
    assert_eq!(stated[2]["what"], format!("limit {gone}"));
    assert_eq!(stated[2]["after"], Value::Null);
    let text = diff.to_document().to_text(100);
    assert!(text.contains("other changes: group wings"), "{text}");
}

/// A part keeps its mass if its frame is removed.
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
