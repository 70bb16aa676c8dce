//! The book: its scenarios run, and it has every key, name and unit that the parser knows, and no other.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use polhode::body::Material;
use polhode::motion::{ErrorEffort, Required, Scenario};
use polhode_scenario::read as scenario;
use polhode_source::FormatErrorKind;
use polhode_source::unit;
use polhode_source::unit::Dimension;
use polhode_table::output::columns;
use polhode_table::output::required::RequiredTable;
use toml::de::DeTable;

const BALL: &str = "[[body.part]]\nshape = 'sphere'\nradius = 1\nmass = 1\n";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(name: &str) -> String {
    fs::read_to_string(root().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// The ```toml blocks of a page: the number of the first line, whether it is a fragment, the text.
fn blocks(page: &str) -> Vec<(usize, bool, String)> {
    let mut found: Vec<(usize, bool, String)> = Vec::new();
    let mut inside = None;
    for (number, line) in (1..).zip(page.lines()) {
        match (inside, line.strip_prefix("```")) {
            (None, Some(language)) => {
                inside = Some(language);
                match language {
                    "toml" | "toml fragment" => found.push((number + 1, language != "toml", String::new())),
                    _ => assert!(!language.starts_with("toml"), "line {number}: {line}"),
                }
            }
            (Some(_), Some(_)) => inside = None,
            (Some("toml" | "toml fragment"), None) => {
                let (.., text) = found.last_mut().unwrap();
                *text += &format!("{line}\n");
            }
            _ => {}
        }
    }
    assert!(inside.is_none(), "a block is not closed");
    found
}

/// The text from a heading to the next one, whatever its level.
fn section<'a>(page: &'a str, heading: &str) -> &'a str {
    let start = page.find(&format!("\n{heading}\n")).unwrap_or_else(|| panic!("no heading {heading:?}"));
    let text = &page[start + 1 + heading.len()..];
    &text[..text.find("\n#").unwrap_or(text.len())]
}

/// The cells of the tables of a text, without their headers.
fn rows(text: &str) -> Vec<Vec<&str>> {
    let mut rows = Vec::new();
    let mut above = "";
    for line in text.lines() {
        if line.starts_with("|---") {
            rows.pop();
        } else if let Some(row) = line.strip_prefix("| ").or(line.strip_prefix('|')) {
            rows.push(row.split('|').map(str::trim).collect());
        }
        assert!(!line.starts_with("|---") || above.starts_with("| "), "{line}");
        above = line;
    }
    rows
}

/// The `names` in a cell.
fn names(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

/// The keys that the parser knows where `zzz` stands.
fn known(text: &str) -> BTreeSet<&'static str> {
    let error = scenario::parse(text, Path::new("probe.toml")).expect_err(text);
    match error.kind() {
        FormatErrorKind::UnknownKey { key, known, .. } if key == "zzz" => known.iter().copied().collect(),
        _ => panic!("{error}\n{text}"),
    }
}

/// The names that the parser offers instead of `zzz`.
fn choices(text: &str) -> Vec<String> {
    let error = scenario::parse(text, Path::new("probe.toml")).expect_err(text);
    match error.kind() {
        FormatErrorKind::Value { rule, .. } if rule.starts_with("one of ") => {
            rule["one of ".len()..].split(", ").map(str::to_owned).collect()
        }
        _ => panic!("{error}\n{text}"),
    }
}

#[track_caller]
fn same<'a>(book: impl IntoIterator<Item = &'a str>, known: impl IntoIterator<Item = &'a str>, place: &str) {
    let [book, known]: [BTreeSet<&str>; 2] = [book.into_iter().collect(), known.into_iter().collect()];
    assert_eq!(book, known, "{place}");
}

#[test]
fn the_scenarios_of_the_pages_run() {
    // Files that they name are those of the examples; the README's are named from the root.
    for (page, place) in [("book/scenario.md", "examples/book.toml"), ("README.md", "README.toml")] {
        let mut complete = 0;
        for (line, fragment, text) in blocks(&read(page)) {
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
        assert!(complete > 0, "{page} has no scenario");
    }
}

#[test]
fn a_block_is_found_where_it_is() {
    let page = "a\n```toml\nx = 1\n\n[y]\n```\n```console\n$ z\n```\n```toml fragment\nw = 2\n```\n";
    assert_eq!(blocks(page), [(3, false, "x = 1\n\n[y]\n".into()), (11, true, "w = 2\n".into())]);
}

#[test]
fn the_book_has_every_key_and_no_other() {
    let page = read("book/scenario.md");
    let tables = [
        ("body", "## Body", "[body]\nzzz = 1"),
        ("start", "## Start", "[start]\nzzz = 1"),
        ("start", "### Spin", "[start]\nspin = { zzz = 1 }"),
        ("start", "## Rotations", "[start]\nattitude = { zzz = 1 }"),
        ("torque", "### Torque `constant`", "[[torque]]\nmodel = 'constant'\nzzz = 1"),
        ("torque", "### Torque `formula`", "[[torque]]\nmodel = 'formula'\nzzz = 1"),
        ("torque", "### Torque `gravity`", "[[torque]]\nmodel = 'gravity'\nzzz = 1"),
        ("torque", "### Torque `gravity_gradient`", "[[torque]]\nmodel = 'gravity_gradient'\nzzz = 1"),
        ("orbit", "## Orbit", "[orbit]\nzzz = 1"),
        ("pointing", "## Pointing", "[[pointing]]\nzzz = 1"),
        ("torque", "### Torque `magnetic`", "[[torque]]\nmodel = 'magnetic'\nzzz = 1"),
        ("event", "## Events", "[run]\nduration = 1\n[[event]]\nmeasure = 'time'\nzzz = 1"),
        ("torque", "### Torque `drag`", "[[torque]]\nmodel = 'drag'\nzzz = 1"),
        ("torque", "### Torque `torsion`", "[[torque]]\nmodel = 'torsion'\nzzz = 1"),
        ("torque", "### Torque `thruster`", "[[torque]]\nmodel = 'thruster'\nzzz = 1"),
        ("torque", "### Torque `energy_sink`", "[[torque]]\nmodel = 'energy_sink'\nzzz = 1"),
        ("wheel", "## Wheels", "[[wheel]]\nzzz = 1"),
        ("mass_history", "## Mass history", "[mass_history]\nzzz = 1"),
        ("mass_history", "### Burns", "[[mass_history.burn]]\nzzz = 1"),
        ("mass_history", "### Drops", "[[mass_history.drop]]\nzzz = 1"),
        ("mass_history", "### Exits", "[[mass_history.exit]]\nzzz = 1"),
        ("contact", "## Contact", "[contact]\nzzz = 1"),
        ("contact", "### Surface", "[contact]\nsurface = { zzz = 1 }"),
        (
            "contact",
            "### Ground",
            "[contact]\nsurface = { shape = 'sphere', radius = 1 }\nground = { zzz = 1 }",
        ),
        ("gimbals", "## Gimbals", "[gimbals]\nzzz = 1"),
        (
            "gimbals",
            "### Axes",
            "[gimbals]\nouter_axis = [0, 0, 1]\ninner_axis = [1, 0, 0]\nouter = { zzz = 1 }",
        ),
        (
            "gimbals",
            "### Base",
            "[gimbals]\nouter_axis = [0, 0, 1]\ninner_axis = [1, 0, 0]\nbase = { zzz = 1 }",
        ),
        ("prescribed", "## Prescribed", "[prescribed]\nzzz = 1"),
        ("prescribed", "### Angular velocity", "[prescribed]\nomega = { zzz = 1 }"),
        ("shaft", "## Shaft", "[shaft]\nzzz = 1"),
        (
            "shaft",
            "### Balance",
            "[shaft]\naxis = [0, 0, 1]\nbearings = [0, 1]\nrate = 1\nbalance = { zzz = 1 }",
        ),
        ("pendulum", "## Pendulum", "[pendulum]\nzzz = 1"),
        ("run", "## Run", "[run]\nzzz = 1"),
    ];
    let in_book =
        |heading| rows(section(&page, heading)).iter().flat_map(|row| names(row[0])).collect::<Vec<_>>();
    let every_torque = [in_book("## Torques"), in_book("### When a torque acts")].concat();
    for (_, heading, text) in tables {
        let common = if heading.starts_with("### Torque ") { every_torque.as_slice() } else { &[] };
        // Two of an event's keys are for one measure each.
        let mut own = in_book(heading);
        own.retain(|key| heading != "## Events" || !["between", "formula"].contains(key));
        same(own.iter().chain(common).copied(), known(&format!("{BALL}{text}")), heading);
    }
    let events = in_book("## Events");
    for measure in ["angle", "formula"] {
        let keys = known(&format!("{BALL}[run]\nduration = 1\n[[event]]\nmeasure = '{measure}'\nzzz = 1"));
        assert!(keys.iter().all(|key| events.contains(key)) && keys.len() == 6, "{keys:?}");
    }
    let pulses = "[[torque]]\nmodel = 'constant'\naxes = 'body'\ntorque = [1, 0, 0]\npulses = { zzz = 1 }";
    same(in_book("### Pulses"), known(&format!("{BALL}{pulses}")), "### Pulses");
    let top = known(&format!("zzz = 1\n{BALL}"));
    // A sweep has a page of its own, which is held to the reader in its own crate.
    for key in top.iter().filter(|key| !["title", "sweep"].contains(key)) {
        assert!(tables.iter().any(|(table, ..)| table == key), "the test has no probe for {key}");
    }
    same(in_book("## The file"), top, "## The file");
    let particle = "[[body.part]]\nshape = 'particles'\nparticles = [{ zzz = 1 }]";
    same(in_book("### Particles"), known(particle), "### Particles");
    let models = choices(&format!("{BALL}[[torque]]\nmodel = 'zzz'"));
    let headings: Vec<_> = page.lines().filter_map(|line| line.strip_prefix("### Torque `")).collect();
    same(
        headings.iter().map(|heading| heading.trim_end_matches('`')),
        models.iter().map(String::as_str),
        "models",
    );
}

#[test]
fn the_book_has_every_measure() {
    let page = read("book/scenario.md");
    let rows = rows(section(&page, "### Measures"));
    let in_file = choices(&format!("{BALL}[run]\nduration = 1\n[[event]]\nmeasure = 'zzz'"));
    same(rows.iter().flat_map(|row| names(row[0])), in_file.iter().map(String::as_str), "### Measures");
}

#[test]
fn the_book_has_every_shape_with_its_keys() {
    let page = read("book/scenario.md");
    let in_book = |heading| {
        let rows = rows(section(&page, heading));
        rows.iter().flat_map(|row| names(row[0])).map(str::to_owned).collect::<BTreeSet<_>>()
    };
    let (common, substance) = (in_book("## Parts"), in_book("### Substance"));
    let shapes = rows(section(&page, "### Shapes"));
    let all = choices("[[body.part]]\nshape = 'zzz'");
    same(shapes.iter().flat_map(|row| names(row[0])), all.iter().map(String::as_str), "### Shapes");
    for row in &shapes {
        let shape = names(row[0]).next().unwrap();
        let keys = known(&format!("[[body.part]]\nshape = '{shape}'\nzzz = 1"));
        let given = matches!(shape, "molecule" | "particles" | "tensor");
        let elsewhere =
            |key: &str| common.contains(key) || !given && key != "thickness" && substance.contains(key);
        assert!(common.iter().all(|key| keys.contains(key.as_str())), "{shape}");
        same(names(row[1]), keys.iter().copied().filter(|key| !elsewhere(key)), shape);
        // Keys with a table of their own.
        match shape {
            "mesh" => same(names(row[1]), in_book("### Mesh").iter().map(String::as_str), shape),
            "molecule" => same(names(row[1]), in_book("### Molecule").iter().map(String::as_str), shape),
            "tensor" => same(names(row[1]), in_book("### Tensor").iter().map(String::as_str), shape),
            _ => {}
        }
    }
}

#[test]
fn the_book_has_every_name_that_is_a_value() {
    let page = read("book/scenario.md");
    for (heading, text) in [
        ("### Torque `constant`", "[[torque]]\nmodel = 'constant'\naxes = 'zzz'"),
        (
            "### Torque `gravity_gradient`",
            "[orbit]\nradius = 7e6\n[[torque]]\nmodel = 'gravity_gradient'\nmass = 'zzz'",
        ),
        ("### Torque `drag`", "[[torque]]\nmodel = 'drag'\nlaw = 'zzz'"),
        ("## Prescribed", "[prescribed]\ntable = 'x.csv'\ncolumns = 'zzz'"),
        ("### Torque `formula`", "[[torque]]\nmodel = 'formula'\naxes = 'zzz'"),
        ("## Run", "[run]\nduration = 1\nmethod = 'zzz'"),
        ("## Events", "[run]\nduration = 1\n[[event]]\nmeasure = 'time'\nvalue = 1\ndirection = 'zzz'"),
        ("## Events", "[run]\nduration = 1\n[[event]]\nmeasure = 'time'\nvalue = 1\nthen = 'zzz'"),
        ("### Tensor", "[[body.part]]\nshape = 'tensor'\nmass = 1\nmoments = [1, 1, 1]\nabout = 'zzz'"),
        (
            "### Tensor",
            "[[body.part]]\nshape = 'tensor'\nmass = 1\ninertia = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nproducts = 'zzz'",
        ),
    ] {
        for name in choices(&format!("{BALL}{text}")) {
            assert!(section(&page, heading).contains(&format!("`\"{name}\"`")), "{heading}: {name}");
        }
    }
}

#[test]
fn the_book_has_every_material_with_its_density() {
    let page = read("book/scenario.md");
    let rows = rows(section(&page, "### Substance"));
    let cells: Vec<_> = rows.iter().filter(|row| row.len() >= 6).flat_map(|row| row[..6].chunks(2)).collect();
    let in_book: BTreeSet<_> = cells.iter().filter(|pair| !pair[0].is_empty()).map(|p| p.join(" ")).collect();
    let known = Material::ALL.iter().map(|m| format!("`{}` {}", m.name, m.density)).collect();
    assert_eq!(in_book, known);
}

#[test]
fn the_book_has_every_unit_under_its_dimension() {
    let page = read("book/scenario.md");
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

/// The columns that a section of a scenario adds are those that the book has under a heading.
#[track_caller]
fn assert_further_columns(heading: &str, section_of_file: &str) {
    let page = read("book/results.md");
    let text = format!("{BALL}{section_of_file}[run]\nduration = 1\nsamples = 2");
    let scenario = scenario::parse(&text, Path::new("probe.toml")).unwrap();
    let motion = scenario.simulate().unwrap().unwrap();
    let rows = rows(section(&page, heading));
    let in_book: Vec<_> =
        rows.iter().flat_map(|row| names(row[0]).map(|name| (name.to_owned(), row[1]))).collect();
    let columns = columns(&motion, &(&scenario).into()).into_iter();
    let after = columns.skip_while(|column| column.name != "kinetic_energy_j").skip(1);
    let known: Vec<_> = after.map(|column| (column.name.into_owned(), column.unit)).collect();
    assert_eq!(in_book, known);
}

#[test]
fn the_book_has_every_column_with_its_unit() {
    let page = read("book/results.md");
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
    let known: Vec<_> = columns(&motion, &(&top).into())
        .into_iter()
        .map(|column| (column.name.into_owned(), column.unit))
        .collect();
    assert_eq!(in_book, known);
}

#[test]
fn the_book_has_every_column_of_what_a_motion_needs() {
    let page = read("book/results.md");
    let rotor: Scenario = scenario::parse(
        "[[body.part]]\nshape = 'particles'\nparticles = [{ mass = 1, position = [0, 0, 1] }]\n\
         [shaft]\naxis = [1, 0, 1]\nbearings = [0, 1]\nrate = 1",
        Path::new("probe.toml"),
    )
    .unwrap();
    let motion = rotor.prescribed().unwrap();
    let samples = [Required::by(rotor.rotor(), motion, 0.0).unwrap()];
    let table = RequiredTable::new(&samples, rotor.rotor(), &rotor.particles(), rotor.shaft());
    let rows = rows(section(&page, "## Table of `polhode torque`"));
    let in_book: Vec<_> = rows.iter().flat_map(|row| names(row[0]).map(|name| (name, row[1]))).collect();
    let known: Vec<_> = table.columns().iter().map(|column| (column.name.as_str(), column.unit)).collect();
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
