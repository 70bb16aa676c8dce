//! The book's page on plans: its plan is readable, and its tables contain exactly the keys of the
//! reader.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use polhode_source::FormatErrorKind;
use polhode_source::files::Disk;
use polhode_sweep::Plan;

const BALL: &str = "[[body.part]]\nshape = 'sphere'\nradius = 1\nmass = 1\n";

fn page() -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/sweep.md")).unwrap()
}

/// Returns the `names` in the first cells of the tables between two headings.
fn first_cells(page: &str, from: &str, to: &str) -> BTreeSet<String> {
    let start = page.find(from).unwrap_or_else(|| panic!("no {from}"));
    let end = start + page[start..].find(to).unwrap_or_else(|| panic!("no {to}"));
    page[start..end]
        .lines()
        .filter_map(|line| line.strip_prefix("| `")?.split('`').next().map(str::to_owned))
        .collect()
}

/// Returns the keys that the reader accepts in place of `zzz`.
fn known(sweep: &str) -> BTreeSet<String> {
    let error = Plan::parse(&Disk, format!("{BALL}{sweep}"), "probe.toml".as_ref()).unwrap_err();
    match error.kind() {
        FormatErrorKind::UnknownKey { key, known, .. } if key == "zzz" => {
            known.iter().map(|key| (*key).to_owned()).collect()
        }
        _ => panic!("{error}"),
    }
}

#[test]
fn the_plans_of_the_page_are_read() {
    let page = page();
    let blocks: Vec<_> =
        page.split("```toml\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    assert!(!blocks.is_empty());
    for block in blocks {
        let plan = Plan::parse(&Disk, block.to_owned(), "book.toml".as_ref())
            .unwrap_or_else(|error| panic!("{error}"));
        assert!(plan.findings().is_empty());
    }
}

#[test]
fn the_page_has_every_key_and_no_other() {
    let page = page();
    assert_eq!(first_cells(&page, "| key of `[sweep]`", "\n### "), known("[sweep]\nzzz = 1"));
    let vary = "[sweep]\nmembers = 1\nsampling = 'sobol'\nvary = [{ key = 'body.part[0].mass', zzz = 1 }]";
    let mut laws = first_cells(&page, "### Distributions of a number", "\n### Mass");
    laws.extend(["key", "dispersion", "correlated"].map(str::to_owned));
    assert_eq!(laws, known(vary));
    let rows = first_cells(&page, "### Sampling", "\n### ");
    let samplings: BTreeSet<String> =
        rows.iter().filter_map(|name| Some(name.strip_prefix('"')?.strip_suffix('"')?.to_owned())).collect();
    let error =
        Plan::parse(&Disk, format!("{BALL}[sweep]\nsampling = 'zzz'"), "probe.toml".as_ref()).unwrap_err();
    let rule = error.message();
    let names = rule.split("one of ").nth(1).unwrap().split(", ").map(str::to_owned).collect();
    assert_eq!(samplings, names);
}

#[test]
fn the_columns_are_those_of_the_page() {
    let text = "[[body.part]]\nname = 'bus'\nshape = 'tensor'\nmass = 3\ninertia = [[1, 0.1, 0], [0.1, 2, 0], [0, 0, 2.5]]\n\
                [start]\nspin = { body = [1, 2, 3] }\n[sweep]\nmembers = 1\nsampling = 'sobol'\n";
    let columns = |key: &str, law: &str| -> Vec<String> {
        let plan = Plan::parse(
            &Disk,
            format!("{text}[[sweep.vary]]\nkey = '{key}'\n{law}\n"),
            "probe.toml".as_ref(),
        );
        plan.unwrap().variables().iter().map(|variable| variable.name.clone()).collect()
    };
    let page = page();
    for (key, law) in [
        ("start.spin.body[2]", "relative = 0.1"),
        ("body.part[\"bus\"].inertia[0][1]", "relative = 0.1"),
        ("body.inertia", "dispersion = 0.1"),
        ("body", "dispersion = 0.1"),
    ] {
        let row = page.lines().find(|line| line.starts_with(&format!("| `{key}` | `"))).unwrap();
        let named: Vec<&str> =
            row.split('`').skip(3).step_by(2).filter(|name| !name.starts_with('…')).collect();
        let columns = columns(key, law);
        assert!(
            named.iter().all(|name| *name == "body.inertia" || columns.iter().any(|column| column == name)),
            "{row}"
        );
        assert_eq!(named[0], columns[0]);
    }
}
