//! `polhode budget --diff`: all contents of a list are compared.

mod cases;
mod rich;

use std::collections::BTreeSet;

use polhode_budget::read::from_text;
use polhode_source::FormatErrorKind;
use serde_json::{Value, json};

use crate::common::{Scratch, json, stdout};
use cases::CASES;
use rich::{GRAINS, PARTS, RICH};

/// Keys that only control reading; a change is visible only in the values read.
const OF_READING: [&str; 3] = ["decimal", "ignore", "cad"];

fn list(rich: &str) -> String {
    let (head, parts) = rich.split_once("name,parent,").unwrap();
    let head: String = head.lines().map(|line| format!("# {line}\n")).collect();
    format!("{head}name,parent,{parts}")
}

#[test]
fn every_key_and_column_is_compared() {
    let scratch = Scratch::new("budget-diff-rich");
    let rich = format!("{RICH}{PARTS}");
    GRAINS.iter().for_each(|(name, table)| scratch.write(name, table));
    scratch.write("before.csv", &list(&rich));
    let diff = |text: &str| {
        scratch.write("after.csv", &list(text));
        let said = stdout(&scratch.run(&["budget", "after.csv", "--diff", "before.csv", "--markdown"]));
        let plain = said.replace(['|', '\u{a0}'], " ").replace('\\', "");
        plain.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let same = diff(&rich);
    assert!(same.contains("no row changed; mass unchanged") && !same.contains("other changes"), "{same}");
    for (section, key, changes, expected) in CASES {
        let changed = changes.iter().fold(rich.clone(), |text, (from, to)| {
            assert!(text.contains(from), "{section} {key}: {from}");
            text.replace(from, to)
        });
        let said = diff(&changed);
        for words in *expected {
            assert!(said.contains(words), "{section} {key}: {words}: {said}");
        }
    }
}

/// Repeated events are matched by content, not by position in the file. Names that contain commas
/// are distinguished.
#[test]
fn what_is_called_alike_is_told_apart() {
    let scratch = Scratch::new("budget-diff-alike");
    let list = |sections: &str, rows: &str| {
        let head: String = sections.lines().map(|line| format!("# {line}\n")).collect();
        let parts = "bus,,5,0,1,2\nbox,,2,9,-7,4\narm,a,1,100,0,3\narm,b,1,200,0,3\n";
        format!(
            "# configurations = [\"a\", \"b\"]\n# [sequence]\n# configuration = \"a\"\n# until = \"90 s\"\n\
             {head}name,configuration,mass [kg],x [mm],y [mm],z [mm]\n{parts}{rows}"
        )
    };
    let deploys = |all: &[(f64, &str)]| -> String {
        let one = |(time, to): &(f64, &str)| format!("[[deploy]]\ntime = {time}\nconfiguration = \"{to}\"\n");
        all.iter().map(one).collect()
    };
    let diff = |before: &str, after: &str| {
        scratch.write("before.csv", before);
        scratch.write("after.csv", after);
        let said = json(&scratch.run(&["budget", "after.csv", "--diff", "before.csv", "--json"]));
        assert!(said["configurations"][0]["changes"].as_array().unwrap().is_empty());
        let one = |one: &Value| {
            let value = |key| one[key].as_str().unwrap_or("none").to_owned();
            [value("what"), value("before"), value("after")].join("|")
        };
        said["stated"].as_array().unwrap().iter().map(one).collect::<Vec<_>>()
    };
    let of = |all: &[(f64, &str)]| list(&deploys(all), "");
    let before = of(&[(10.0, "b"), (20.0, "a"), (30.0, "b")]);
    assert!(diff(&before, &before).is_empty());
    assert!(diff(&before, &of(&[(30.0, "b"), (20.0, "a"), (10.0, "b")])).is_empty());
    assert_eq!(
        diff(&before, &of(&[(10.0, "b"), (20.0, "a"), (41.5, "b")])),
        ["deployment 2 to b|30 s|41.5 s"]
    );
    assert_eq!(
        diff(&before, &of(&[(20.0, "a"), (30.0, "b")])),
        ["deployment 1 to b|10 s|none"],
        "the first is gone, and the second is as it was"
    );
    assert_eq!(
        diff(&of(&[(10.0, "b")]), &of(&[(10.0, "b"), (20.0, "a"), (30.0, "b")])),
        ["deployment 2 to b|none|30 s", "deployment to a|none|20 s"]
    );
    // The drop of one row differs from that of two rows.
    let rows = "\"u, v\",,0.1,1,2,3\nu,,0.1,3,2,1\nv,,0.1,3,1,2\n";
    let drop = |rows_of: &str| list(&format!("[[drop]]\ntime = 7\nrows = {rows_of}\n"), rows);
    assert!(diff(&drop("[\"u\", \"v\"]"), &drop("[\"v\", \"u\"]")).is_empty());
    assert_eq!(
        diff(&drop("[\"u\", \"v\"]"), &drop("[\"u, v\"]")),
        ["drop of \"u, v\"|none|7 s", "drop of u, v|7 s|none"]
    );
}

/// The contents of a tank have a row of their own, so a change appears once.
#[test]
fn a_change_of_what_is_in_a_tank_shows_once() {
    let scratch = Scratch::new("budget-diff-tank");
    GRAINS.iter().for_each(|(name, table)| scratch.write(name, table));
    let rich = format!("{RICH}{PARTS}");
    scratch.write("before.csv", &list(&rich));
    for (from, to, row, kinds) in [
        ("fill_sd = \"2 %\"", "fill_sd = \"3 %\"", "fuel", &["uncertainty"][..]),
        ("fill = \"75 %\"", "fill = \"74 %\"", "fuel", &["mass", "tensor", "moved"]),
        ("mass_sd = \"20 g\"", "mass_sd = \"25 g\"", "ball", &["uncertainty"]),
        ("group = \"arms\"\n", "", "fuel", &["group"]),
    ] {
        scratch.write("after.csv", &list(&rich.replace(from, to)));
        let said = json(&scratch.run(&["budget", "after.csv", "--diff", "before.csv", "--json"]));
        assert_eq!(said["stated"], json!([]), "{from}");
        for configuration in said["configurations"].as_array().unwrap() {
            let changes = configuration["changes"].as_array().unwrap();
            let found: Vec<_> =
                changes.iter().map(|one| (one["row"].as_str(), one["what"].as_str())).collect();
            let all: Vec<_> = kinds.iter().map(|kind| (Some(row), Some(*kind))).collect();
            let is_there = row == "ball" || configuration["name"] != "stored";
            assert_eq!(found, if is_there { all } else { Vec::new() }, "{from}");
            assert_eq!(configuration["stated"], json!([]), "{from}");
        }
    }
}

/// An empty tank has no row; changes of its contents appear with the tank.
#[test]
fn what_is_said_of_an_empty_tank_is_compared() {
    let scratch = Scratch::new("budget-diff-empty");
    let list = |density: &str| {
        format!(
            "# [[tank]]\n# name = \"fuel\"\n# shape = \"sphere\"\n# radius = \"10 cm\"\n# density = \"{density}\"\n# settles = \"-z\"\n# mass = 0\n\
             name,mass [kg],x [mm],y [mm],z [mm]\nbus,5,0,1,2\nbox,2,9,-7,4\nrod,1,2,30,-9\n"
        )
    };
    scratch.write("before.csv", &list("900 ± 9 kg/m^3"));
    scratch.write("after.csv", &list("900 ± 18 kg/m^3"));
    let said = json(&scratch.run(&["budget", "after.csv", "--diff", "before.csv", "--json"]));
    let all = said["stated"].as_array().unwrap();
    assert_eq!(all.len(), 1, "{said}");
    assert_eq!(all[0]["what"], "tank fuel");
    for (key, expected) in [("before", "density_sd 1 %"), ("after", "density_sd 2 %")] {
        assert!(all[0][key].as_str().unwrap().ends_with(expected), "{said}");
    }
}

/// A list without configurations is compared with each configuration of the other list.
#[test]
fn a_list_without_configurations_is_compared_with_each() {
    let scratch = Scratch::new("budget-diff-unnamed");
    let head =
        "name,configuration,mass [kg],x [mm],y [mm],z [mm]\nbus,,5,0,1,2\nbox,,2,9,-7,4\nrod,,1,2,30,-9\n";
    scratch.write("one.csv", &format!("{head}arm,,1,100,0,3\n"));
    scratch.write("two.csv", &format!("{head}arm,a,1,100,0,3\narm,b,1,200,0,3\n"));
    for (after, before) in [("one.csv", "two.csv"), ("two.csv", "one.csv")] {
        let said = json(&scratch.run(&["budget", after, "--diff", before, "--json"]));
        let all = said["configurations"].as_array().unwrap();
        let of = |one: &Value| (one["name"].clone(), one["changes"].as_array().unwrap().len());
        assert_eq!(all.iter().map(of).collect::<Vec<_>>(), [(json!("a"), 0), (json!("b"), 1)], "{after}");
        assert_eq!((&said["only_before"], &said["only_after"]), (&json!([]), &json!([])));
    }
}

/// Checks that the cases cover all keys known to the reader, except sections, which contain keys.
#[test]
fn no_key_is_left_out() {
    let scratch = Scratch::new("budget-diff-keys");
    GRAINS.iter().for_each(|(name, table)| scratch.write(name, table));
    let rich = format!("{RICH}{PARTS}");
    let sections: BTreeSet<&str> = RICH.lines().filter(|line| line.starts_with('[')).collect();
    for section in sections.iter().copied().filter(|section| *section != "[growth]").chain([""]) {
        let text = match section {
            "" => format!("zzz = 1\n{rich}"),
            section => rich.replacen(&format!("{section}\n"), &format!("{section}\nzzz = 1\n"), 1),
        };
        let error = from_text(&scratch.0.join("rich.csv"), &list(&text)).unwrap_err();
        let FormatErrorKind::UnknownKey { known, .. } = error.kind() else { panic!("{section}: {error}") };
        for key in known.iter().filter(|key| !section.is_empty() || !OF_READING.contains(*key)) {
            let is_section = |name: &str| {
                sections.contains(format!("[{name}]").as_str())
                    || sections.contains(format!("[[{name}]]").as_str())
            };
            let is_changed = CASES.iter().any(|(of, name, ..)| *of == section && name == key);
            assert!(is_changed || (section.is_empty() && is_section(key)), "{section} {key}");
        }
    }
}
