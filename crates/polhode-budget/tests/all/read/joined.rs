//! Plans that refer to a file of parts, joined with the statements of that file.

use super::workbook_file::Book;
use super::{Folder, csv, same};

#[test]
fn a_plan_names_the_file_of_its_parts() {
    let folder = Folder::new("plan");
    folder.write("parts.csv", "name,mass [g],maturity,supplier code\na,12 ± 0.2,E,x1\nb,7,E,x2\n");
    let plan = "title = \"Two parts\"\nparts = \"parts.csv\"\ncoverage_factor = 2\nignore = [\"supplier code\"]\n[growth]\nE = 0.25\n[result]\nseed = 7\n";
    let file = folder.read("plan.toml", plan).unwrap();
    assert_eq!((file.title.as_deref(), file.questions.seed), (Some("Two parts"), 7));
    let head = csv("# title = \"Two parts\"\n# coverage_factor = 2\n# growth = { E = 0.25 }\nname,mass [g],maturity\na,12 ± 0.2,E\nb,7,E\n").unwrap();
    same(&head.configurations[0].budget, &file.configurations[0].budget, "a head and a plan");
    for (plan, message) in [
        ("parts = \"lost.csv\"\n", "plan.toml:1:9: cannot read"),
        (
            "parts = \"plan.toml\"\n",
            "plan.toml:1:9: parts = \"plan.toml\" must be a file of parts, CSV or XLSX",
        ),
        (
            "title = \"x\"\n",
            "plan.toml:1:1: the key parts is missing in the file | write parts = \"parts.csv\"",
        ),
        (
            "parts = \"parts.csv\"\n",
            "parts.csv:1:24: unknown key \"supplier code\" in the headings (named in plan.toml:1:9)",
        ),
        ("partz = \"parts.csv\"\n", "plan.toml:1:1: unknown key \"partz\" in the file | did you mean parts?"),
    ] {
        let error = folder.read("plan.toml", plan).unwrap_err();
        assert!(error.starts_with(message), "{error}");
    }
}

const HEAD: &str = "## for people\n# growth = { E = 0.25 }\n# [[group]]\n# name = \"wheels\"\n# mass = 0.5\n# [[site]]\n# name = \"m\"\n# at = [0, 0, \"1 m\"]\n";
const PARTS: &str = "name,mass [g],x [mm],y [mm],z [mm],Ixy [g mm^2],Ixx [g mm^2],Iyy [g mm^2],Izz [g mm^2],maturity,group\na,12 ± 0.2,0,0,0,3,60,50,40,E,wheels\nb,7 ± 0.1,0,0,0,,,,,E,wheels\n";
const PLAN: &str = "title = \"Two\"\nparts = \"parts.csv\"\nproducts = \"tensor elements\"\n[ballast]\nmost = \"1 kg\"\n[[limit]]\nof = \"mass\"\nmost = \"2 kg\"\n";

/// Related keys may be in either file: ballast is in the plan, and its sites are in the head.
#[test]
fn a_plan_and_the_head_of_its_file_are_one_set_of_keys() {
    let folder = Folder::new("joined");
    folder.write("parts.csv", format!("{HEAD}{PARTS}"));
    let file = folder.read("plan.toml", PLAN).unwrap();
    let (keys, sections) = PLAN.split_at(PLAN.find('[').unwrap());
    let head: String =
        format!("{}growth = {{ E = 0.25 }}\n{sections}", keys.replace("parts = \"parts.csv\"\n", ""))
            .lines()
            .map(|line| format!("# {line}\n"))
            .collect();
    let groups = HEAD.split_once("# [[group]]").unwrap().1;
    let all = csv(&format!("{head}# [[group]]{groups}{PARTS}")).unwrap();
    same(&all.configurations[0].budget, &file.configurations[0].budget, "a head and a plan");
    assert_eq!((&file.title, &file.ballast, &file.limits), (&all.title, &all.ballast, &all.limits));
    assert_eq!(file.ballast.unwrap().sites.len(), 1);
}

#[test]
fn errors_of_a_plan_and_a_head_are_where_they_stand() {
    let folder = Folder::new("joined-errors");
    for (head, plan, message) in [
        (
            "## a\n# title = \"other\"\n",
            PLAN,
            "parts.csv:2:3: title = \"other\" must be given only once: the plan has it too (named in plan.toml:1:1) | write a key or a section in the plan",
        ),
        (
            "# [[limit]]\n# of = \"mass\"\n# least = 0\n",
            PLAN,
            "parts.csv:1:5: limit = [[limit]] must be given only once: the plan has it too (named in plan.toml:6:3)",
        ),
        ("# parts = \"more.csv\"\n", PLAN, "parts.csv:1:3: parts = \"more.csv\" must be given only once"),
        (
            "# growth = { E = 0.25 }\n# [result]\n# draws = 0\n",
            PLAN,
            "parts.csv:3:11: draws = 0 must be from 10 to 10000000 (named in plan.toml:2:9)",
        ),
        (
            "# growth = { E = 0.25 }\n# [result]\n# draw = 9\n",
            PLAN,
            "parts.csv:3:3: unknown key \"draw\" in [result] (named in plan.toml:2:9) | did you mean draws?",
        ),
        ("# growth = 0.25 %\n", PLAN, "parts.csv:1:"),
        (
            "# [[group]]\n# name = \"weels\"\n# mass = 0.5\n",
            &PLAN.replacen(
                "[ballast]",
                "[growth]\nE = 0.1\n[[group]]\nname = \"wheels\"\nmass = 1\n[ballast]",
                1,
            ),
            "parts.csv:1:5: group = [[group]] must be given only once",
        ),
        (
            HEAD,
            &PLAN.replace("most = \"2 kg\"", "most = \"2 mm\""),
            "plan.toml:8:8: \"mm\" is a length where a mass belongs",
        ),
        (&HEAD.replace("wheels", "weels"), PLAN, "parts.csv:10:"),
    ] {
        folder.write("parts.csv", format!("{head}{PARTS}"));
        let error = folder.read("plan.toml", plan).unwrap_err();
        assert!(error.starts_with(message), "{error} is not {message}");
    }
    // Unused declarations, in either file.
    folder.write("parts.csv", format!("{HEAD}name,mass,maturity\na,1,E\n"));
    let error = folder.read("plan.toml", PLAN).unwrap_err();
    assert!(
        error.starts_with(
            "parts.csv:4:10: group = \"wheels\" must be the group of a row, or of a tank (named in"
        ),
        "{error}"
    );
    folder.write("parts.csv", format!("{HEAD}{PARTS}"));
    let error = folder
        .read("plan.toml", PLAN.replace("[ballast]", "[cad]\nmass_unit = \"g\"\n[ballast]"))
        .unwrap_err();
    assert!(error.starts_with("plan.toml:4:1: cad = \"[cad]\" must be given with a column cad"), "{error}");
    let error = folder.read("plan.toml", format!("ignore = [\"size\"]\n{PLAN}")).unwrap_err();
    assert!(error.starts_with("plan.toml:1:11: ignore = \"size\" must be the heading"), "{error}");
}

#[test]
fn a_plan_and_the_sheets_of_its_workbook_are_one_set_of_keys() {
    let folder = Folder::new("joined-workbook");
    let book = |plan: &[&[&str]], groups: &[&[&str]]| {
        Book::new()
            .sheet("parts", &[&["name", "mass [g]", "group", "maturity"], &["a", "12 ± 0.2", "wheels", "E"]])
            .sheet("plan", plan)
            .sheet("group", groups)
            .bytes()
    };
    let group: &[&[&str]] = &[&["name", "mass"], &["wheels", "0.5"]];
    let plan = "parts = \"b.xlsx\"\n[growth]\nE = 0.25\n";
    folder.write("b.xlsx", book(&[&["title", "A book"]], group));
    let file = folder.read("plan.toml", plan).unwrap();
    let list = file.configurations[0].budget.list();
    assert_eq!(
        (file.title.as_deref(), list.groups[0].mass, list.growth.get("E")),
        (Some("A book"), 0.5, Some(0.25))
    );
    for (sheet, groups, plan, message) in [
        (
            &[&["title", "A book"][..]][..],
            group,
            format!("title = \"x\"\n{plan}"),
            "b.xlsx: plan!A1: title = \"A book\" must be given only once: the plan has it too (named in plan.toml:1:1)",
        ),
        (
            &[&["title", "A book"]],
            group,
            format!("{plan}[[group]]\nname = \"g\"\nmass = 1\n"),
            "b.xlsx: group!A2: group = [[group]] must be given only once",
        ),
        (
            &[&["coverage_factor", "-1"]],
            group,
            plan.to_owned(),
            "b.xlsx: plan!B1: coverage_factor = -1 must be positive",
        ),
        (
            &[&["title", "A book"]],
            &[&["name", "mass"], &["wheel", "0.5"]],
            plan.to_owned(),
            "b.xlsx: parts!C2: ",
        ),
        (
            &[&["ignore", "[\"size\"]"]],
            group,
            plan.to_owned(),
            "b.xlsx: plan!B1: ignore = \"size\" must be the heading of a column, or the name of a sheet",
        ),
        (
            &[&["title", "A book"]],
            group,
            format!("{plan}[cad]\nmass_unit = \"g\"\n"),
            "plan.toml:4:1: cad = \"[cad]\" must be given with",
        ),
    ] {
        folder.write("b.xlsx", book(sheet, groups));
        let error = folder.read("plan.toml", plan).unwrap_err();
        assert!(error.starts_with(message), "{error} is not {message}");
    }
    // In a workbook alone, the error of an unused section is at its first cell.
    let cad =
        Book::new().sheet("parts", &[&["name", "mass"], &["a", "1"]]).sheet("cad", &[&["mass_unit", "g"]]);
    let error = folder.read("b.xlsx", cad.bytes()).unwrap_err();
    assert!(error.starts_with("b.xlsx: cad!A1: cad = \"[cad]\" must be given with a column cad"), "{error}");
}

const GRAIN: &[&[&str]] = &[&["mass [kg]", "z [mm]"], &["4", "612"], &["10", "655"]];

/// A name in a head is relative to its file, not to the plan. A plan may name a sheet of its
/// workbook.
#[test]
fn tables_of_tanks_are_of_the_file_that_names_them() {
    let folder = Folder::new("joined-tables");
    std::fs::create_dir_all(folder.0.join("lists")).unwrap();
    let grain = GRAIN.iter().map(|row| row.join(",") + "\n").collect::<String>();
    let head = "# [[tank]]\n# name = \"grain\"\n# mass = \"7 kg\"\n# table = \"grain.csv\"\nname,mass\na,5\n";
    folder.write("lists/parts.csv", head);
    folder.write("lists/grain.csv", &grain);
    let plan = "parts = \"lists/parts.csv\"\n[growth]\nE = 0.25\n";
    let read = |plan: &str| folder.read("plan.toml", plan).unwrap_or_else(|error| panic!("{error}"));
    let of_head = read(plan);
    assert!(of_head.read.iter().any(|read| read.path == folder.0.join("lists/grain.csv")));
    let book = Book::new().sheet("parts", &[&["name", "mass"], &["a", "5"]]).sheet("grain", GRAIN);
    folder.write("lists/b.xlsx", book.bytes());
    let tank = "[[tank]]\nname = \"grain\"\nmass = \"7 kg\"\n";
    let of_plan = plan.replace("parts.csv", "b.xlsx") + tank;
    let of_sheet = read(&format!("{of_plan}table = \"grain\"\n"));
    assert_eq!(of_sheet.configurations, of_head.configurations);
    for (table, plan, message) in [
        (
            "mass,z\n4,1\n3,2\n",
            plan,
            "lists/grain.csv:3:1: mass = 3 must be greater than in the row before (named in lists/parts.csv:4:11)",
        ),
        (
            &grain,
            &of_plan.replace("7 kg", "11 kg").replace("[[tank]]", "[[tank]]\ntable = \"grain\""),
            "plan.toml:7:8: mass = \"11 kg\" must be from 0 to the capacity of the tank, 10 kg",
        ),
        (
            &grain,
            &format!("{of_plan}table = \"gravel\"\n"),
            "plan.toml:7:9: table = \"gravel\" must be a file of CSV, or the name of a sheet",
        ),
        (
            &grain,
            &format!("{of_plan}table = \"grain.csv\"\n"),
            "plan.toml:7:9: cannot read \"grain.csv\": the file does not exist",
        ),
    ] {
        folder.write("lists/grain.csv", table);
        let error = folder.read("plan.toml", plan).unwrap_err();
        assert!(error.starts_with(message), "{error} is not {message}");
    }
    folder.write("lists/parts.csv", head.replace("grain.csv", "gravel.csv"));
    let error = folder.read("plan.toml", plan).unwrap_err();
    assert!(
        error.starts_with("lists/parts.csv:4:11: cannot read \"lists/gravel.csv\": the file does not exist"),
        "{error}"
    );
    // In a sheet of the workbook that the plan refers to.
    let tanks: &[&[&str]] = &[&["name", "mass", "table"], &["grain", "7 kg", "grain.csv"]];
    let book = Book::new().sheet("parts", &[&["name", "mass"], &["a", "5"]]).sheet("tank", tanks);
    folder.write("lists/b.xlsx", book.bytes());
    let plan = plan.replace("parts.csv", "b.xlsx");
    folder.write("lists/grain.csv", &grain);
    assert_eq!(read(&plan).configurations, of_head.configurations);
    folder.write("lists/grain.csv", "mass,z\n4,1\n3,2\n");
    let error = folder.read("plan.toml", plan).unwrap_err();
    assert!(
        error.starts_with("lists/grain.csv:3:1: mass = 3 must be greater than in the row before (named in lists/b.xlsx: tank!C2)"),
        "{error}"
    );
}
