//! `polhode budget`: results for a parts list in every format.

use std::fs;

use polhode::math::Position;
use serde_json::Value;

use crate::common::figures::compare;
use crate::common::recipe::follow;
use crate::common::{Scratch, example, json, number, numbers, refused, stdout};

/// A satellite with two wing configurations; one part exceeds its mass limit.
pub(crate) const CUBESAT: &str = r#"# title = "A CubeSat"
# growth = { A = "3 %", B = "10 %", C = "25 %" }
# [[group]]
# name = "wings"
# mass = 0.9
# [result]
# draws = 100
name,parent,quantity,copies,mass [g],x [mm],y [mm],z [mm],shape,size,at x [mm],at y [mm],at z [mm],at x sd [mm],at y sd [mm],at z sd [mm],maturity,group,allowable [g],configuration
sat,,,,,,,,,,,,,,,,,,4000,
structure,sat,,,780 ± 10,,,,box,"100 mm, 100 mm, 340 mm",0,0,170,0.2,0.2,0.2,A,,900,
battery,sat,,,,,,,,,0,0,80,,,,,,280,
cells,battery,4,independent,65 ± 1,,,,box,"70 mm, 20 mm, 70 mm",4,-2,0,1,1,1,B,,,
camera,sat,,,900 ± 60,,,,box,"80 mm, 80 mm, 120 mm",12,-6,270,3,3,3,C,,,
wing left,sat,,,210 ± 12,,,,box,"160 mm, 80 mm, 3 mm",135,2,150,1,1,1,B,wings,,deployed
wing right,sat,,,210 ± 12,,,,box,"160 mm, 80 mm, 3 mm",-135,2,150,1,1,1,B,wings,,deployed
wing left,sat,,,210 ± 12,,,,box,"3 mm, 80 mm, 320 mm",52,2,150,1,1,1,B,wings,,stowed
wing right,sat,,,210 ± 12,,,,box,"3 mm, 80 mm, 320 mm",-52,2,150,1,1,1,B,wings,,stowed
harness,sat,,,120 ± 30,10,15,200,,,,,,10,10,10,C,,,
"#;

/// The earlier list: one part is lighter, and one does not exist yet.
pub(crate) fn before() -> String {
    CUBESAT
        .replace("900 ± 60", "860 ± 60")
        .lines()
        .filter(|line| !line.starts_with("harness"))
        .collect::<Vec<_>>()
        .join("\n")
        + "\n"
}

fn scratch(name: &str) -> Scratch {
    let scratch = Scratch::new(name);
    scratch.write("cubesat.csv", CUBESAT);
    scratch.write("before.csv", &before());
    scratch
}

#[test]
fn the_forms_say_the_same() {
    let scratch = scratch("budget-forms");
    let run = |flags: &[&str]| stdout(&scratch.run(&[&["budget", "cubesat.csv"], flags].concat()));
    let report: Value = serde_json::from_str(&run(&["--json"])).unwrap();
    let mass = number(&report["configurations"][0]["estimate"]["mass"]);
    let want = 1.03 * 0.78 + 1.1 * (0.26 + 0.42) + 1.25 * (0.9 + 0.12);
    assert!((mass / want - 1.0).abs() < 1e-14, "{mass} {want}");
    let text = run(&[]);
    assert!(text.starts_with("A CubeSat\n") && text.contains("deployed: predicted mass 2.826 ± "), "{text}");
    assert!(run(&["--markdown"]).starts_with("# A CubeSat\n"));
    let page = run(&["--html"]);
    assert!(page.starts_with("<!") && page.contains("Parts, centre of mass and principal axes"));
    let table = run(&["--csv"]);
    let heads: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let cell = |row: &str, head: &str| {
        let row = table.lines().find(|line| line.starts_with(row)).unwrap();
        let at = heads.iter().position(|name| *name == head).unwrap();
        row.split(',').nth(at).unwrap().to_owned()
    };
    assert_eq!(cell("stowed,sat,", "predicted_mass_kg").parse(), Ok(mass));
    assert_eq!(cell("stowed,cells,", "parent"), "battery");
    let z = number(&report["configurations"][0]["estimate"]["center_of_mass"][2]);
    assert_eq!(cell("deployed,sat,", "center_of_mass_z_m").parse(), Ok(z));
}

#[test]
fn a_body_goes_on_to_other_commands() {
    let scratch = scratch("budget-body");
    let asked = ["budget", "cubesat.csv", "--configuration", "deployed"];
    let report = json(&scratch.run(&[&asked[..], &["--json"]].concat()));
    scratch.write("whole.toml", &stdout(&scratch.run(&[&asked[..], &["--body"]].concat())));
    let read = polhode_scenario::read::read(&scratch.0.join("whole.toml")).unwrap();
    let estimate = &report["configurations"][0]["estimate"];
    assert_eq!(read.body().mass(), number(&estimate["mass"]));
    let rows: Vec<Vec<f64>> = estimate["inertia"].as_array().unwrap().iter().map(numbers).collect();
    let got = read.body().inertia().matrix();
    for (got, want) in got.iter().flatten().zip(rows.iter().flatten()) {
        assert!((got - want).abs() < 1e-16, "{got} {want}");
    }
    let off = read.body().center_of_mass()
        - Position::from_array(numbers(&estimate["center_of_mass"]).try_into().unwrap());
    assert!(off.norm() < 1e-16);
    assert!(stdout(&scratch.run(&["stability", "whole.toml"])).contains("Steady spins"));
    let error = refused(&scratch.run(&["budget", "cubesat.csv", "--body"]), 2);
    assert!(error.contains("name one of \"deployed\", \"stowed\""), "{error}");
    let error = refused(&scratch.run(&["budget", "cubesat.csv", "--configuration", "flying"]), 2);
    assert!(
        error.contains("unknown configuration \"flying\"") && error.contains("the file has \"deployed\""),
        "{error}"
    );
}

#[test]
fn a_workbook_is_written_whole_and_replaces_nothing() {
    let scratch = scratch("budget-xlsx");
    let asked = ["budget", "cubesat.csv", "--xlsx", "out.xlsx"];
    assert_eq!(stdout(&scratch.run(&asked)), "");
    let bytes = fs::read(scratch.0.join("out.xlsx")).unwrap();
    assert!(bytes.starts_with(b"PK"));
    // The reader of parts lists accepts the workbook, but its parts sheet is not a list; the error
    // names a cell.
    let error = refused(&scratch.run(&["budget", "out.xlsx"]), 2);
    assert!(error.contains("covariance") && error.contains("out.xlsx"), "{error}");
    assert!(refused(&scratch.run(&asked), 2).contains("out.xlsx"));
    assert_eq!(stdout(&scratch.run(&[&asked[..], &["--force", "--basis", "basic"]].concat())), "");
    assert_ne!(fs::read(scratch.0.join("out.xlsx")).unwrap(), bytes);
}

#[test]
fn strict_is_about_what_is_too_heavy() {
    let scratch = scratch("budget-strict");
    let output = scratch.run(&["budget", "cubesat.csv", "--strict"]);
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("battery is heavier than allowed, including the growth allowance"), "{text}");
    scratch.write("light.csv", &CUBESAT.replace(",280,", ",290,"));
    assert_eq!(scratch.run(&["budget", "light.csv", "--strict"]).status.code(), Some(0));
}

#[test]
fn what_changed_is_said_of_each_configuration() {
    let scratch = scratch("budget-diff");
    let asked = ["budget", "cubesat.csv", "--diff", "before.csv"];
    let text = stdout(&scratch.run(&asked));
    assert!(
        text.contains("→ deployed: 2 changes of 2 rows; predicted mass 2.6264 to 2.8264 kg, by +0.2 kg"),
        "{text}"
    );
    assert!(
        text.contains("heavier: 0.86 to 0.9 kg, by +0.04 kg") && text.contains("added, with 0.12 kg"),
        "{text}"
    );
    let diff = json(&scratch.run(&[&asked[..], &["--json", "--configuration", "stowed"]].concat()));
    assert_eq!(diff["configurations"].as_array().unwrap().len(), 1);
    assert_eq!(diff["configurations"][0]["changes"][0]["row"], "camera");
    let same = stdout(&scratch.run(&["budget", "cubesat.csv", "--diff", "cubesat.csv"]));
    assert!(same.contains("no row changed; mass unchanged"), "{same}");
}

#[test]
fn draws_are_those_of_the_seed() {
    let scratch = scratch("budget-draws");
    let run = |flags: &[&str]| json(&scratch.run(&[&["budget", "cubesat.csv", "--json"], flags].concat()));
    let usual = run(&[]);
    assert_eq!(usual["configurations"][0]["draws"]["count"], 100);
    assert_eq!(usual, run(&["--seed", "1", "--draws", "100"]));
    assert_ne!(usual["configurations"][0]["draws"], run(&["--seed", "2"])["configurations"][0]["draws"]);
    assert!(run(&["--draws", "0"])["configurations"][0]["draws"].is_null());
    let error = refused(&scratch.run(&["budget", "cubesat.csv", "--draws", "5"]), 2);
    assert!(error.contains("0, or from 10 to 10000000"), "{error}");
}

#[test]
fn limits_are_answered_and_strict_is_about_them() {
    let scratch = Scratch::new("budget-limits");
    let list = "name,mass [kg],x [mm],y [mm],z [mm]\na,2 ± 0.1,1,0,0\nb,1 ± 0.1,-5,2,300\n";
    let limit = |most: &str| {
        format!("# [[limit]]\n# of = \"mass\"\n# most = \"{most}\"\n# [result]\n# draws = 400\n{list}")
    };
    scratch.write("light.csv", &limit("3.1 kg"));
    scratch.write("heavy.csv", &limit("2.9 kg"));
    let said = json(&scratch.run(&["budget", "light.csv", "--json", "--strict"]));
    let one = &said["configurations"][0]["limits"]["each"][0];
    assert_eq!((one["met"].as_bool(), number(&one["draws"]["of"])), (Some(true), 400.0));
    // 0.1 kg of √2 · 0.1 kg, as a one-sided normal probability.
    let p = number(&one["draws"]["probability"]);
    assert!((number(&one["first_order"]) - 0.760_25).abs() < 1e-5 && (p - 0.76).abs() < 0.08, "{p}");
    for form in [&[][..], &["--csv"], &["--body"]] {
        let output = scratch.run(&[&["budget", "heavy.csv", "--strict"], form].concat());
        assert_eq!(output.status.code(), Some(1), "{form:?}");
    }
    let error = refused(&scratch.run(&["budget", "light.csv", "--draws", "0"]), 2);
    assert!(error.contains("--draws is 0"), "{error}");
}

#[test]
fn ballast_meets_the_limits_or_there_is_none() {
    let scratch = Scratch::new("budget-ballast");
    let plan = |most: &str| {
        format!(
            "# [[limit]]\n# of = \"center distance\"\n# along = \"z\"\n# most = \"1 mm\"\n# [[limit]]\n# of = \"tilt\"\n# along = \"z\"\n# most = \"9 deg\"\n\
             # [[site]]\n# name = \"rim\"\n# at = [0, 0, \"10 cm\"]\n# radius = \"20 cm\"\n# normal = \"z\"\n# rim = true\n# [ballast]\n# most = \"{most}\"\n# [result]\n# draws = 20\n\
             name,mass [kg],x [mm],y [mm],z [mm]\na,2 ± 0.1,12,9,0\nb,1 ± 0.1,12,9,300\n"
        )
    };
    scratch.write("some.csv", &plan("1 kg"));
    let said = json(&scratch.run(&["budget", "some.csv", "--json"]));
    let ballast = &said["configurations"][0]["ballast"];
    // 3 kg at 15 mm from the axis, m at 200 mm on the other side: (45 − 200 m)/(3 + m) = 1.
    let mass = number(&ballast["mass"]);
    assert!((mass - 42.0 / 201.0).abs() < 1e-8, "{ballast}");
    assert!(number(&ballast["gap"]) < 1e-9 && number(&ballast["bound"]) <= mass);
    assert_eq!(ballast["not_sought_for"][0], "tilt along z");
    let text = stdout(&scratch.run(&["budget", "some.csv"]));
    assert!(text.contains("→ Minimum ballast 0.209 kg, in ") && text.contains("(proved)"), "{text}");
    scratch.write("little.csv", &plan("100 g"));
    let text = stdout(&scratch.run(&["budget", "little.csv"]));
    assert!(
        text.contains("No ballast at these sites, up to 0.1 kg, meets center distance along z."),
        "{text}"
    );
    assert_eq!(ballast["proved"], true);
    // Two sizes: a result that is not proved optimal is reported with its bound.
    let sizes = plan("1 kg").replace("# rim = true", "# rim = true\n# sizes = [\"70 g\", \"0.11313 kg\"]");
    scratch.write("sizes.csv", &sizes);
    let said = json(&scratch.run(&["budget", "sizes.csv", "--json"]));
    let sizes = &said["configurations"][0]["ballast"];
    assert!(sizes["proved"] == false && number(&sizes["mass"]) > mass, "{sizes}");
    let text = stdout(&scratch.run(&["budget", "sizes.csv"]));
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("(minimum not proved, lower bound 0.209 kg)"), "{text}");
}

#[test]
fn the_guide_is_what_its_commands_print() {
    let scratch = Scratch::new("budget-guide");
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    fs::create_dir_all(scratch.0.join("examples/budget")).unwrap();
    for name in ["cubesat.csv", "sounding-rocket.xlsx"] {
        let name = format!("examples/budget/{name}");
        fs::copy(root.join(&name), scratch.0.join(&name)).unwrap();
    }
    let followed = follow(&root.join("book/budget.md"), &scratch);
    assert!(followed.commands >= 5 && followed.excerpts >= 5);
}

#[test]
fn the_books_pictures_of_budgets_are_those_of_the_example() {
    let scratch = Scratch::new("budget-book");
    let list = example("budget/cubesat.csv");
    let page = ["budget", &list, "--configuration", "deployed", "--draws", "1000", "--html"];
    compare(
        &scratch,
        &[
            (&page, "Mass breakdown", "budget-mass.svg"),
            (&page, "Errors of mass", "budget-errors.svg"),
            (&page, "Parts, centre of mass", "budget-parts.svg"),
            (&page, "The triangle of moments", "budget-triangle.svg"),
        ],
    );
}

/// The report states only if a limit is met with the ballast, for limits that it was not sought
/// for.
#[test]
fn ballast_says_what_it_was_not_sought_for() {
    let scratch = Scratch::new("budget-ballast-left-out");
    let plan = |most: &str| {
        format!(
            "# about = \"center\"\n# [[limit]]\n# of = \"spin ratio\"\n# along = \"z\"\n# least = 1.1\n# [[limit]]\n# of = \"center\"\n# along = \"z\"\n# most = \"{most}\"\n\
             # [[site]]\n# name = \"m\"\n# at = [0, 0, \"-200 mm\"]\n# [result]\n# draws = 20\n\
             name,mass [kg],z [mm],Ixx [kg m^2],Iyy [kg m^2],Izz [kg m^2]\na,10 ± 0.1,20,0.11,0.13,0.09\n"
        )
    };
    scratch.write("some.csv", &plan("1 mm"));
    let text = stdout(&scratch.run(&["budget", "some.csv"])).replace("\n  ", " ");
    assert!(
        text.contains(
            "kg, in 1 piece for center along z (proved); spin ratio along z (not in the search) is not met with it"
        ),
        "{text}"
    );
    scratch.write("none.csv", &plan("30 mm"));
    let text = stdout(&scratch.run(&["budget", "none.csv"])).replace("\n  ", " ");
    assert!(!text.contains("all limits are met"), "{text}");
    assert!(text.contains("spin ratio along z (not in the search) is not met without"), "{text}");
}

/// A list without configurations has the same value in each configuration.
#[test]
fn a_configuration_is_compared_with_a_list_that_has_none() {
    let scratch = scratch("budget-diff-configuration");
    scratch.write("plain.csv", "name,mass [kg],x [mm]\nbox,1.5,20\n");
    let run = |flags: &[&str]| scratch.run(&[&["budget"], flags].concat());
    let text = stdout(&run(&["cubesat.csv", "--diff", "plain.csv", "--configuration", "stowed"]));
    assert!(text.contains("predicted mass 1.5 to 2.8264 kg"), "{text}");
    let error = refused(&run(&["plain.csv", "--diff", "cubesat.csv", "--configuration", "stowed"]), 2);
    assert!(error.contains("plain.csv") && error.contains("the file has no configurations"), "{error}");
}
