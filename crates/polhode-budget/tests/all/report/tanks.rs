//! Tanks and changes over time, in reports.

use polhode_budget::report::BudgetReport;
use polhode_budget::{
    Basis, Burn, Change, Down, GivenPart, Liquid, PartsList, Row, Sequence, Tank, TankShape, Vessel,
};

use super::{at, options};

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
    // Intervals between 0, 10, 60, 70 and 90 s, with 17 rows each.
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
        // At 10 s there are two rows. One of them is before the burn.
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
    for said in ["70     c dropped", "Mass over 90 s: 70 kg to 35 kg", "water: 40 kg of 65.45 kg"] {
        assert!(text.contains(said), "{said}: {text}");
    }
    assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
    assert!(document.to_html().contains("Mass over time"));
}
