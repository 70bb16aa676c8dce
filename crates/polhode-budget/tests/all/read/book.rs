//! The pages about parts lists: their examples are read, and they have exactly the columns and keys
//! that the reader knows.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use polhode_budget::read::from_text;
use polhode_source::FormatErrorKind;

use super::{Folder, csv};

fn page(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book").join(name)).unwrap()
}

/// Returns the code blocks of a language.
fn blocks(page: &str, language: &str) -> Vec<String> {
    let fence = format!("```{language}\n");
    page.split(&fence).skip(1).map(|rest| rest.split("```").next().unwrap().to_owned()).collect()
}

/// Returns the `names` in the first cells of all tables between two headings.
fn named(page: &str, from: &str, to: &str) -> BTreeSet<String> {
    let section =
        page.split(&format!("\n{from}\n")).nth(1).unwrap().split(&format!("\n{to}\n")).next().unwrap();
    let cells = section.lines().filter_map(|line| line.strip_prefix("| ")?.split(" | ").next());
    cells.flat_map(|cell| cell.split('`').skip(1).step_by(2)).map(str::to_owned).collect()
}

/// Returns the keys that the reader knows at the place of an unknown key.
fn known(text: &str) -> BTreeSet<String> {
    match csv(text).unwrap_err().kind() {
        FormatErrorKind::UnknownKey { known, .. } => known.iter().map(|&key| key.to_owned()).collect(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn lists_of_the_pages_are_read() {
    let page = ["budget-file.md", "budget-keys.md", "budget-tanks.md"].map(page).concat();
    let lists = blocks(&page, "csv");
    assert_eq!(lists.len(), 4);
    for list in &lists {
        let read = from_text(Path::new("list.csv"), list)
            .unwrap_or_else(|error| panic!("{error} {:?}", error.hint()));
        assert!(read.configurations[0].budget.list().rows.len() >= 3);
    }
    let tables = blocks(&page, "text");
    assert_eq!(tables.len(), 1);
    let folder = Folder::new("book-table");
    folder.write("grain.csv", &tables[0]);
    folder.write("parts.csv", "name,mass\na,5\nb,6\n");
    let plan = "parts = \"parts.csv\"\nproducts = \"tensor elements\"\n[[tank]]\nname = \"grain\"\ntable = \"grain.csv\"\nfill = \"80 % ± 1 %\"\n";
    let read = folder.read("a.toml", plan).unwrap();
    assert!(
        (read.configurations[0].budget.estimate(polhode_budget::Basis::Basic).unwrap().sd(0) - 0.1).abs()
            < 1e-12
    );
    let plans = blocks(&page, "toml");
    assert_eq!(plans.len(), 1);
    let folder = Folder::new("book");
    folder.write(
        "probe.csv",
        "name;mass [g];configuration;maturity;group;Drawing no.;cad\na;12,5;stowed;B 1;wheels;7;\nb;1,5;;E;;8;\n",
    );
    let file = folder.read("plan.toml", &plans[0]).unwrap();
    let names: Vec<_> = file.configurations.iter().map(|one| one.name.as_deref().unwrap()).collect();
    assert_eq!(names, ["stowed", "deployed"]);
    assert_eq!((file.questions.draws, file.questions.seed), (Some(20_000), 7));
}

#[test]
fn the_pages_have_every_column_and_key() {
    let mut columns = named(&page("budget-file.md"), "## Columns", "## Errors");
    columns.extend(["rotate x", "rotate y", "rotate z"].map(str::to_owned));
    assert_eq!(columns, known("name,zzz\na,1\n"));
    let mut keys = known("# zzz = 1\nname,mass\na,1\n");
    keys.insert("parts".to_owned());
    let page = page("budget-keys.md");
    assert_eq!(named(&page, "## Keys", "## Limits"), keys);
    for (table, head) in [
        ("group", "# [[group]]\n# zzz = 1\nname\na\n"),
        ("cad", "# [cad]\n# zzz = 1\nname\na\n"),
        ("result", "# [result]\n# zzz = 1\nname\na\n"),
        (
            "ballast",
            "# [[limit]]\n# of = \"mass\"\n# most = 1\n# [[site]]\n# name = \"a\"\n# at = [0, 0, 0]\n# [ballast]\n# zzz = 1\nname\na\n",
        ),
    ] {
        let keys = page.split("\n## Keys\n").nth(1).unwrap();
        let row = keys.lines().find(|line| line.starts_with(&format!("| `{table}` | "))).unwrap();
        let said: BTreeSet<&str> = row.split('`').skip(1).step_by(2).collect();
        for key in known(head) {
            assert!(said.contains(key.as_str()), "{table}: {key}");
        }
    }
}

#[test]
fn the_page_has_every_key_of_tanks_and_sequences() {
    let (keys, tanks) = (page("budget-keys.md"), page("budget-tanks.md"));
    for (text, head) in [
        (&tanks, "# [[tank]]\n# zzz = 1\nname\na\n"),
        (&tanks, "# [[tank]]\n# name = \"a\"\n# [[tank.table]]\n# zzz = 1\nname\na\n"),
        (&keys, "# [sequence]\n# zzz = 1\nname\na\n"),
        (&tanks, "# [sequence]\n# until = 1\n# [[burn]]\n# zzz = 1\nname\na\n"),
        (&tanks, "# [sequence]\n# until = 1\n# [[drop]]\n# zzz = 1\nname\na\n"),
        (&tanks, "# [sequence]\n# until = 1\n# [[deploy]]\n# zzz = 1\nname\na\n"),
    ] {
        for key in known(head) {
            assert!(text.contains(&format!("`{key}`")), "{key} of {head}");
        }
    }
}

#[test]
fn examples_are_read() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/budget");
    for (name, configurations, rows) in [
        ("cubesat.csv", ["stowed", "deployed"], 30..=45),
        ("sounding-rocket.xlsx", ["lift-off", "burnout"], 20..=30),
    ] {
        let file = polhode_budget::read::read(&folder.join(name)).unwrap_or_else(|error| panic!("{error}"));
        assert!(file.title.is_some() && file.questions.about.is_some());
        let names: Vec<_> = file.configurations.iter().map(|one| one.name.as_deref().unwrap()).collect();
        assert_eq!(names, configurations);
        for one in &file.configurations {
            assert!(rows.contains(&one.budget.list().rows.len()), "{}", one.budget.list().rows.len());
            let whole = one.budget.estimate(file.questions.basis).unwrap();
            assert!(
                whole.sd(0) > 0.005 * whole.properties.mass() && whole.sd(0) < 0.03 * whole.properties.mass()
            );
            assert!(one.budget.mass_statements().unwrap()[one.budget.root()].margin().unwrap() > 0.0);
        }
    }
}
