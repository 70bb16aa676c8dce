//! Results of a list, and their text in the report.

use polhode::math::{Body, Part, Position, Rotation};
use polhode_budget::read::Questions;
use polhode_budget::report::BudgetReport;
use polhode_budget::{Basis, GivenPart, PartsList, Row};

use super::{at, near, numbers, options, report, satellite, text};

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
    // the listed contributions and the rest add up to the variance
    for error in case["errors"].as_array().unwrap() {
        let told: f64 =
            error["by"].as_array().unwrap().iter().map(|by| by["variance"].as_f64().unwrap()).sum();
        let sd = error["sd"].as_f64().unwrap();
        near(&[told + error["rest"].as_f64().unwrap()], &[sd * sd], 1e-12);
    }
    // the points of the cloud are possible ratios of moments
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
    let asked = Questions { about: Some(point), axes: Some(r), ..options(0) };
    let report = report(asked);
    let found = &report.to_json()["configurations"][0]["asked"];
    let whole = satellite(true).mass_properties(Basis::Predicted).unwrap();
    // Rᵀ J R, with the requested axes as columns of R
    let (j, r) = (whole.inertia_about(point).matrix(), r.matrix());
    for a in 0..3 {
        let want = [0, 1, 2]
            .map(|b| (0..3).map(|i| (0..3).map(|k| r[i][a] * j[i][k] * r[k][b]).sum::<f64>()).sum::<f64>());
        near(&numbers(&found["inertia"][a]), &want, 1e-13);
    }
    assert!(text(&report).contains("About the point (0.1, -0.2, 0.3) m, along the requested axes"));
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
    assert!(
        text.contains("→ 2 of 4 limits are met; probability that all are met: 0 % (0 … 0.7 %)"),
        "{text}"
    );
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
    assert!(text.contains("sat/battery is heavier than allowed, including the growth allowance"), "{text}");
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
    let mut csv = Vec::new();
    long.write_csv(&mut csv).unwrap();
    assert_eq!(String::from_utf8(csv).unwrap().lines().count(), 442);
}

#[test]
fn a_point_beyond_numbers_is_refused() {
    let budget = satellite(true);
    let about = Some(Position::new(1e200, 2.0, -1.0));
    let asked = Questions { about, ..options(0) };
    let error = BudgetReport::new(None, Vec::new(), vec![(None, budget)], Vec::new(), asked).unwrap_err();
    let words = error.to_string();
    assert!(words.contains(" is 1e200, but must be so small that") || words.contains("1000000"), "{words}");
}
