//! The book: its scenarios run, and it lists exactly the known materials, units and columns.
//! `schema.rs` compares its keys and names.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use polhode::body::Material;
use polhode::motion::{ErrorEffort, Required, Scenario};
use polhode_scenario::read as scenario;
use polhode_source::unit;
use polhode_source::unit::Dimension;
use polhode_table::output::{Table, required};
use toml::de::DeTable;

use super::common::page::{blocks, names, root, rows, scenario_pages, scenario_reference, section};

const BALL: &str = "[[body.part]]\nshape = 'sphere'\nradius = 1\nmass = 1\n";

fn read(name: &str) -> String {
    fs::read_to_string(root().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

#[test]
fn the_scenarios_of_the_pages_run() {
    // Files named in the reference are in examples/; those in start.md are relative to the root.
    let reference = scenario_pages().into_iter().map(|name| (format!("book/{name}"), "examples/book.toml"));
    let mut complete = 0;
    for (page, place) in reference.chain([("book/start.md".to_owned(), "start.toml")]) {
        for (line, fragment, text) in blocks(&read(&page)) {
            let at = format!("{page}, the block from line {line}");
            if fragment {
                DeTable::parse(&text).unwrap_or_else(|e| panic!("{at}: {e}"));
                continue;
            }
            let scenario =
                scenario::parse(&text, &root().join(place)).unwrap_or_else(|e| panic!("{at}: {e}"));
            let worse = scenario.findings().iter().filter(|f| f.severity != polhode::body::Severity::Info);
            assert_eq!(worse.count(), 0, "{at}: {:?}", scenario.findings());
            if let Some(motion) = scenario.simulate() {
                motion.unwrap_or_else(|e| panic!("{at}: {e}"));
            }
            complete += 1;
        }
    }
    assert!(complete > 20, "{complete} scenarios");
}

#[test]
fn the_book_has_every_material_with_its_density() {
    let page = scenario_reference();
    let rows = rows(section(&page, "### Substance"));
    let cells: Vec<_> = rows.iter().filter(|row| row.len() >= 6).flat_map(|row| row[..6].chunks(2)).collect();
    let in_book: BTreeSet<_> = cells.iter().filter(|pair| !pair[0].is_empty()).map(|p| p.join(" ")).collect();
    let known = Material::ALL.iter().map(|m| format!("`{}` {}", m.name, m.density)).collect();
    assert_eq!(in_book, known);
}

#[test]
fn the_book_has_every_unit_under_its_dimension() {
    let page = scenario_reference();
    let dimensions = [
        Dimension::MASS,
        Dimension::LENGTH,
        Dimension::VOLUME,
        Dimension::TIME,
        Dimension::ANGLE,
        Dimension::ANGULAR_VELOCITY,
        Dimension::ACCELERATION,
        Dimension::FORCE,
        Dimension::TORQUE,
        Dimension::ANGULAR_MOMENTUM,
        Dimension::CURRENT,
        Dimension::MAGNETIC_FIELD,
    ];
    let mut in_book = BTreeSet::new();
    for row in rows(section(&page, "### Units")) {
        let articled =
            |d: &&Dimension| [format!("a {}", row[0]), format!("an {}", row[0])].contains(&d.to_string());
        let dimension = dimensions.iter().find(articled).unwrap_or_else(|| panic!("{}", row[0]));
        assert_eq!(unit::parse(&format!("1 {}", row[1]), *dimension), Ok(1.0));
        for name in names(row[2]) {
            assert!(unit::parse(&format!("1 {name}"), *dimension).is_ok(), "{name}");
            assert!(in_book.insert(name.to_owned()), "{name} twice");
        }
    }
    // The table of units is private: its lines are `("in inch", "0.0254", Dimension::LENGTH),`.
    let table = read("crates/polhode-source/src/unit/table.rs");
    let lines = table.lines().filter(|line| line.contains("\", Dimension::"));
    let known: BTreeSet<_> = lines
        .filter_map(|line| line.split('"').nth(1))
        .flat_map(|names| names.split(' ').map(str::to_owned))
        .collect();
    assert_eq!(in_book, known);
}

#[test]
fn the_book_has_every_column_of_a_body_on_the_ground() {
    let contact = "[contact]\nsurface = { shape = 'sphere', radius = 1 }\nlaw = 'rolling'\n";
    assert_further_columns("### On the ground", contact);
}

#[test]
fn the_book_has_every_column_of_a_rotor_in_gimbals() {
    assert_further_columns("### In gimbals", "[gimbals]\nouter_axis = [0, 0, 1]\ninner_axis = [1, 0, 0]\n");
}

/// Checks that the columns added by a section of a scenario are those under a heading of the book.
#[track_caller]
fn assert_further_columns(heading: &str, section_of_file: &str) {
    let page = read("book/results-tables.md");
    let text = format!("{BALL}{section_of_file}[run]\nduration = 1\nsamples = 2");
    let scenario = scenario::parse(&text, Path::new("probe.toml")).unwrap();
    let motion = scenario.simulate().unwrap().unwrap();
    let rows = rows(section(&page, heading));
    let in_book: Vec<_> =
        rows.iter().flat_map(|row| names(row[0]).map(|name| (name.to_owned(), row[1]))).collect();
    let table = Table::of(&motion, &(&scenario).into());
    let after = table.columns().iter().skip_while(|column| column.name != "kinetic_energy_j").skip(1);
    let known: Vec<_> = after.map(|column| (column.name.to_string(), column.unit)).collect();
    assert_eq!(in_book, known);
}

#[test]
fn the_book_has_every_column_with_its_unit() {
    let page = read("book/results-tables.md");
    let top: Scenario = scenario::parse(
        &format!(
            "[orbit]\naltitude = 5e5\n[[pointing]]\nname = 'camera'\nbody = [0, 0, 1]\nto = 'nadir'\n{BALL}position = [1, 0, 0]\n[[torque]]\nmodel = 'gravity'\npivot = [0, 0, 0]\n\
             [[wheel]]\naxis = [1, 0, 0]\ninertia = 0.01\nspeed = 3\nmotor_torque = 0\n[run]\nduration = 1\nsamples = 2"
        ),
        Path::new("probe.toml"),
    )
    .unwrap();
    let motion = top.simulate_with_error(ErrorEffort::Auto, &mut |_| true).unwrap().unwrap();
    let rows = rows(section(&page, "## Trajectory"));
    let in_book: Vec<_> =
        rows.iter().flat_map(|row| names(row[0]).map(|name| (name.to_owned(), row[1]))).collect();
    let table = Table::of(&motion, &(&top).into());
    let known: Vec<_> = table.columns().iter().map(|column| (column.name.to_string(), column.unit)).collect();
    assert_eq!(in_book, known);
}

#[test]
fn the_book_has_every_column_of_what_a_motion_needs() {
    let page = read("book/results-tables.md");
    let rotor: Scenario = scenario::parse(
        "[[body.part]]\nshape = 'particles'\nparticles = [{ mass = 1, position = [0, 0, 1] }]\n\
         [shaft]\naxis = [1, 0, 1]\nbearings = [0, 1]\nrate = 1",
        Path::new("probe.toml"),
    )
    .unwrap();
    let motion = rotor.prescribed().unwrap();
    let samples = [Required::of_motion(rotor.rotor(), motion, 0.0).unwrap()];
    let points = rotor.particles();
    let table = required(&samples, rotor.rotor(), &points, rotor.shaft());
    let rows = rows(section(&page, "## Table of `polhode torque`"));
    let in_book: Vec<_> = rows.iter().flat_map(|row| names(row[0]).map(|name| (name, row[1]))).collect();
    let known: Vec<_> = table.columns().iter().map(|column| (&*column.name, column.unit)).collect();
    assert_eq!(in_book, known);
}

#[test]
fn the_pages_of_the_book_are_in_its_index() {
    let index = read("book/README.md");
    for entry in fs::read_dir(root().join("book")).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        let is_page = entry.file_type().unwrap().is_file(); // figures are in the pages
        assert!(!is_page || name == "README.md" || index.contains(&format!("]({name})")), "{name}");
    }
}
