//! HTML page and its pictures.

use polhode_budget::report::BudgetReport;
use polhode_budget::{GivenPart, PartsList, Row};

use super::{at, near, numbers, of_points, options, report, text};

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
    // rotated by 0.12 rad about y
    let camera = solid("camera")["halves"].as_array().unwrap();
    let longest = camera.iter().map(numbers).max_by(|a, b| a[2].abs().total_cmp(&b[2].abs())).unwrap();
    near(&[longest[0] / longest[2]], &[0.12_f64.tan()], 1e-12);
}

#[test]
fn the_page_has_its_pictures_and_nothing_from_elsewhere() {
    let page = report(options(100)).to_document().to_html();
    for words in [
        "Mass breakdown",
        "Errors of the inertia tensor",
        "from aside",
        "principal axis 3",
        "bodies that the errors allow</text>",
    ] {
        assert!(page.contains(words), "{words}");
    }
    assert!(!page.contains("NaN") && !page.contains("inf"), "a place is no number");
    assert!(!page.contains("src=") && !page.replace("href=\"#s", "").contains("href="));
}

/// Bodies without extent, bodies of one part, and exact bodies have pages too.
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
fn all_the_mass_in_the_origin_has_a_page() {
    let report =
        of_points(vec![Row::part("a", GivenPart::point(1.0, at(0.0, 0.0, 0.0)))], Vec::new(), options(20));
    let page = report.to_document().to_html();
    assert!(!page.contains("NaN") && !page.contains("inf\""), "{page}");
    assert!(page.contains("a point"), "its place is still listed");
}
