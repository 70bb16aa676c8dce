//! `report.html` of the command: with the summary or on its own, complete or not at all.

use std::fs;

use serde_json::Value;

use crate::common::{Scratch, entries, number, refused, stdout};

const HANDLE: &str = r#"
title = "</script><b>A handle"
[[body.part]]
name = "bar"
shape = "cylinder"
radius = "6 mm"
length = "120 mm"
mass = "106 g"
rotate = { axis = [0, 1, 0], angle = "80 deg" }
[[body.part]]
name = "stem"
shape = "rod"
length = "60 mm"
mass = "32 g"
position = ["3 mm", "-2 mm", "36 mm"]
[start]
spin = { body = [0.02, 0.01, 6.0] }
[run]
duration = "3 s"
samples = 31
"#;

impl Scratch {
    fn page(&self, name: &str) -> (String, Value) {
        let html = fs::read_to_string(self.0.join(name)).unwrap();
        let (_, rest) = html.split_once("<script id=\"polhode-data\" type=\"application/json\">").unwrap();
        let data = serde_json::from_str(rest.split_once("</script").unwrap().0).unwrap();
        (html, data)
    }
}

#[test]
fn simulate_writes_a_page_beside_the_summary() {
    let scratch = Scratch::new("page-simulate");
    scratch.write("handle.toml", HANDLE);
    let text = stdout(&scratch.run(&["simulate", "handle.toml"]));
    let wrote = "wrote handle/: summary.json, trajectory.parquet, report.html\nopen handle/report.html in a browser to see the motion";
    assert!(text.contains(wrote), "{text}");
    assert_eq!(entries(&scratch.0.join("handle")), ["report.html", "summary.json", "trajectory.parquet"]);
    let (html, data) = scratch.page("handle/report.html");
    assert!(html.contains("<title>&lt;/script&gt;&lt;b&gt;A handle</title>"));
    assert_eq!(data["scenario"], HANDLE);
    assert_eq!(data["title"], "</script><b>A handle");
    assert!(data["source"].as_str().unwrap().ends_with("simulate handle.toml"));
    assert_eq!(number(&data["motion"]["count"]), 31.0);
    assert_eq!(data["body"]["shapes"].as_array().unwrap().len(), 2);
    assert!(data["free"].is_object() && !data["explanation"].as_array().unwrap().is_empty());
    // The page loads nothing from elsewhere.
    assert!(!html.contains("src=\"http") && !html.contains("<link"));

    let text = stdout(&scratch.run(&["simulate", "handle.toml", "--force", "--no-page"]));
    assert!(!text.contains("report.html"), "{text}");
    assert_eq!(entries(&scratch.0.join("handle")), ["summary.json", "trajectory.parquet"]);
    // An earlier page is removed with the folder that is replaced.
    stdout(&scratch.run(&["simulate", "handle.toml", "--force"]));
    stdout(&scratch.run(&["simulate", "handle.toml", "--force"]));
    assert_eq!(scratch.entries(), ["handle", "handle.toml"]);
}

#[test]
fn spin_writes_a_page_on_its_own() {
    let scratch = Scratch::new("page-spin");
    scratch.write("handle.toml", HANDLE);
    let top = ["spin", "--moments", "3,1,2.5", "--omega", "0.01,0.02,1"];
    let text = stdout(&scratch.run(&[&top[..], &["--html"]].concat()));
    assert!(text.ends_with("wrote report.html\n"), "{text}");
    let (_, data) = scratch.page("report.html");
    assert_eq!((&data["body"]["mass"], &data["scenario"]), (&Value::Null, &Value::Null));
    assert_eq!(number(&data["motion"]["count"]), 2001.0);

    // An existing page is kept, unless it may be replaced; nothing else is left.
    let before = fs::read(scratch.0.join("report.html")).unwrap();
    let text = refused(&scratch.run(&[&top[..], &["--html"]].concat()), 2);
    assert!(text.contains("report.html already exists") && text.contains("hint: "), "{text}");
    assert_eq!(fs::read(scratch.0.join("report.html")).unwrap(), before);
    stdout(&scratch.run(&[&top[..], &["--html", "--force", "--at", "7"]].concat()));
    assert_ne!(fs::read(scratch.0.join("report.html")).unwrap(), before);

    stdout(&scratch.run(&["spin", "handle.toml", "--omega", "1,2,3", "--html=a page.html"]));
    let (_, data) = scratch.page("a page.html");
    assert_eq!(data["scenario"], HANDLE);
    refused(&scratch.run(&["spin", "handle.toml", "--html=no/such/folder.html"]), 2);
    refused(&scratch.run(&["spin", "handle.toml", "--html=.", "--force"]), 2);
    stdout(&scratch.run(&["spin", "handle.toml", "-o", "out", "--no-page"]));
    assert_eq!(entries(&scratch.0.join("out")), ["summary.json"]);
    stdout(&scratch.run(&["spin", "handle.toml", "-o", "out", "--force"]));
    assert_eq!(entries(&scratch.0.join("out")), ["report.html", "summary.json"]);
    assert_eq!(scratch.entries(), ["a page.html", "handle.toml", "out", "report.html"]);
}

#[test]
fn every_spin_has_a_page() {
    let scratch = Scratch::new("page-every");
    for (k, omega) in
        ["0,0,0", "0,2,0", "1,0.5,0.5773502691896258", "1e-9,0,0", "1e9,3,2e-5"].iter().enumerate()
    {
        let file = format!("--html={k}.html");
        stdout(&scratch.run(&["spin", "--moments", "1,2,3", "--omega", omega, &file]));
        let (_, data) = scratch.page(&format!("{k}.html"));
        assert_eq!(number(&data["motion"]["count"]), 2001.0, "{omega}");
    }
}

#[test]
fn a_molecule_has_its_mass_and_its_bonds() {
    let scratch = Scratch::new("page-molecule");
    // Formaldehyde in an asymmetric position; bonds C=O 1.21 Å and C–H 1.1 Å, but H…H 1.87 Å is not
    // a bond.
    let atoms = "4\n\nC 0.1 0.2 0.3\nO 0.1 0.2 1.51\nH 0.1 1.13 -0.28\nH 0.1 -0.73 -0.28\n";
    fs::write(scratch.0.join("m.xyz"), atoms).unwrap();
    let scenario = "[[body.part]]\nshape = 'molecule'\nfile = 'm.xyz'\nposition = ['3e-9 m', 0, '-1e-9 m']\n\
        rotate = { axis = [1, 2, 0.5], angle = '40 deg' }\n[start]\nspin = { body = [1e12, 2e12, -3e12] }\n\
        [run]\nduration = '1e-12 s'\nsamples = 11\n";
    fs::write(scratch.0.join("m.toml"), scenario).unwrap();
    stdout(&scratch.run(&["simulate", "m.toml", "-o", "m"]));
    let (_, data) = scratch.page("m/report.html");
    let balls = &data["body"]["shapes"][0];
    assert_eq!(balls["labels"], serde_json::json!(["C", "O", "H", "H"]));
    assert_eq!(balls["sticks"], serde_json::json!([[0, 1], [0, 2], [0, 3]]));
    // `polhode inertia` of the file gives the same moments, independent of the placement.
    let own: Value = serde_json::from_slice(&scratch.run(&["inertia", "m.xyz", "--json"]).stdout).unwrap();
    let moments = |value: &Value| -> Vec<f64> { serde_json::from_value(value.clone()).unwrap() };
    let placed = moments(&data["body"]["principal"]["moments"]);
    let alone = moments(&own["principal"]["moments"]);
    for (a, b) in placed.iter().zip(&alone) {
        assert!((a - b).abs() < 1e-13 * alone[2], "{placed:?} {alone:?}");
    }
    let mass = data["body"]["mass"].as_f64().unwrap();
    // Mass of ¹²C ¹H₂ ¹⁶O: 30.010 564 684 u.
    assert!((mass / (30.010_564_684 * 1.660_539_066_6e-27) - 1.0).abs() < 1e-8, "{mass:e}");
}
