//! Liquids in tanks with errors in every form, and tables of tanks in separate files and sheets.

use polhode_budget::read::{Access, BudgetFile};
use polhode_budget::{Basis, LiquidErrors, Measured, PartUncertainty};
use polhode_source::files::Memory;

use super::workbook_file::Book;
use super::{Folder, csv};

const TANK: &str = "# coverage_factor = 2\n# [[group]]\n# name = \"fuels\"\n# density = 0.9\n# [[tank]]\n# name = \"fuel\"\n\
# shape = \"sphere\"\n# radius = \"200 mm\"\n# settles = \"-z\"\n# density = \"0.9 g/cm^3\"\n# mass = \"12 kg\"\nname,mass,x,y,z\na,5 ± 0.2,0,0,0.1\nb,7,0.3,0,0\nc,7,0,-0.2,0\n";

fn list(density: &str, contents: &str) -> String {
    let text = TANK.replace("# density = \"0.9 g/cm^3\"", density).replace("# mass = \"12 kg\"", contents);
    // A group that no row refers to is refused.
    if contents.contains("group") {
        text
    } else {
        text.replace("# [[group]]\n# name = \"fuels\"\n# density = 0.9\n", "")
    }
}

fn errors(file: &BudgetFile) -> (f64, Option<LiquidErrors>) {
    let list = file.configurations[0].budget.list();
    let row = list.rows.iter().find(|row| row.name == "fuel").unwrap();
    let errors = match &row.uncertainty.part {
        PartUncertainty::Liquid(liquid) => Some(liquid.errors),
        _ => None,
    };
    (row.part.as_ref().unwrap().mass, errors)
}

#[test]
fn errors_are_read_in_every_form() {
    let capacity = 900.0 * 4.0 / 3.0 * std::f64::consts::PI * 0.2_f64.powi(3);
    let fill = 0.7 * capacity;
    // Density, contents, mass, measured quantity, error of the amount, error of the density.
    let known = "# density = \"0.9 g/cm^3\"";
    let weighed = Measured::Mass;
    for (density, contents, mass, measured, amount, of_density) in [
        (known, "# mass = \"12 ± 0.3 kg\"", 12.0, weighed, 0.15, 0.0),
        (known, "# mass = \"12 kg ± 300 g\"", 12.0, weighed, 0.15, 0.0),
        (known, "# mass = \"(12 +- 0.3) kg\"", 12.0, weighed, 0.15, 0.0),
        (known, "# mass = \"12 kg ± 5 %\"", 12.0, weighed, 0.3, 0.0),
        (known, "# mass = \"12 ± 0.3\"", 12.0, weighed, 0.15, 0.0),
        (known, "# mass = \"12 kg\"\n# mass_sd = \"150 g\"", 12.0, weighed, 0.15, 0.0),
        (known, "# mass = 12\n# mass_sd = 0.15", 12.0, weighed, 0.15, 0.0),
        (known, "# mass = \"12 kg\"\n# mass_sd = \"2.5 %\"", 12.0, weighed, 0.3, 0.0),
        // A fill, as a fraction of a full tank.
        (known, "# fill = \"70 % ± 3 %\"", fill, Measured::Fill, 0.015 * capacity, 0.0),
        (known, "# fill = \"(70 ± 3) %\"", fill, Measured::Fill, 0.015 * capacity, 0.0),
        (known, "# fill = \"0.7 ± 0.03\"", fill, Measured::Fill, 0.015 * capacity, 0.0),
        (known, "# fill = 0.7\n# fill_sd = \"3 %\"", fill, Measured::Fill, 0.03 * capacity, 0.0),
        ("# density = \"0.9 ± 0.036 g/cm^3\"", "# fill = 0.7", fill, Measured::Fill, 0.0, 0.02),
        ("# density = \"0.9 g/cm^3 ± 4 %\"", "# mass = 12", 12.0, weighed, 0.0, 0.02),
        (
            "# density = 900\n# density_sd = \"18 kg/m^3\"",
            "# mass = \"12 ± 0.3 kg\"\n# group = \"fuels\"",
            12.0,
            weighed,
            0.15,
            0.02,
        ),
    ] {
        let text = list(density, contents);
        let file = csv(&text).unwrap_or_else(|error| panic!("{text}\n{error} {:?}", error.hint()));
        let (found, errors) = errors(&file);
        let errors = errors.unwrap();
        assert!((found / mass - 1.0).abs() < 1e-12 && errors.measured == measured, "{text}");
        assert!((errors.amount - amount).abs() < 1e-12, "{text}: {}", errors.amount);
        assert!((errors.density - of_density).abs() < 1e-14, "{text}: {}", errors.density);
        // The error of the whole mass includes the errors of the parts.
        let of_mass = if measured == Measured::Fill { mass * of_density } else { 0.0 };
        let sd = (0.01 + amount * amount + of_mass * of_mass).sqrt();
        let whole = file.configurations[0].budget.estimate(Basis::Basic).unwrap();
        assert!((whole.sd(0) / sd - 1.0).abs() < 1e-12, "{text}: {} {sd}", whole.sd(0));
    }
    let exact = csv(&list(known, "# mass = \"12 kg\"")).unwrap();
    assert_eq!(errors(&exact), (12.0, None));
    let said = |text: &str| csv(text).unwrap().sources().join("\n");
    assert!(said(&list(known, "# mass = \"12 kg\"")).contains("12 kg in \"fuel\", exactly"));
    let both = list("# density = \"0.9 g/cm^3 ± 4 %\"", "# mass = \"12 ± 0.3 kg\"").replace("5 ± 0.2", "5");
    assert!(said(&both).contains("12 ± 0.15 kg in \"fuel\", its density ± 2 %"), "{}", said(&both));
    assert!(said(&both).contains("± is 2 standard deviations"), "{}", said(&both));
}

#[test]
fn errors_that_are_none_are_refused_where_they_are() {
    let known = "# density = \"0.9 g/cm^3\"";
    for (density, contents, expected) in [
        (
            known,
            "# mass = \"12 ± -0.3 kg\"",
            "mass = \"12 ± -0.3 kg\" must be with an error that is zero or positive",
        ),
        (known, "# mass = \"12 kg ± 0.3\"", "mass = 12 kg ± 0.3 must be a number and an error in one unit"),
        (known, "# mass = \"12 ± 0.3 mm\"", "\"mm\" is a length where a mass belongs"),
        (
            known,
            "# mass = \"12 ± 1 kg\"\n# mass_sd = 1",
            "mass_sd = 1 must be left out, because mass already has an error",
        ),
        (known, "# mass = 12\n# mass_sd = -1", "mass_sd = -1 must be with an error that is zero or positive"),
        (known, "# mass = 12\n# fill_sd = 0.1", "fill_sd = 0.1 must be left out, because mass is given"),
        (known, "# fill = 0.5\n# mass_sd = 0.1", "mass_sd = 0.1 must be left out, because fill is given"),
        (
            known,
            "# fill = \"75 ± 2 %\"",
            "fill = \"75 ± 2 %\" must be in percent on both sides of ±, or on neither",
        ),
        (known, "# fill = \"1.2 ± 0.1\"", "fill = \"1.2 ± 0.1\" must be from 0 to 100 %"),
        (known, "# fill = \"x % ± 2 %\"", "\"x"),
        (
            known,
            "# mass = \"0 ± 1 kg\"",
            "mass = \"0 ± 1 kg\" must be without an error, because the tank is empty",
        ),
        (
            known,
            "# mass = 0\n# mass_sd = \"5 %\"",
            "mass_sd = \"5 %\" must be an absolute value: a percentage of zero is zero",
        ),
        (
            known,
            "# mass = 12\n# group = \"fules\"",
            "group = \"fules\" must be the name of a [[group]] | did you mean \"fuels\"?",
        ),
        (
            known,
            "# mass = 12\n# group = \"fuels\"",
            "group = \"fuels\" must be left out: the tank has no errors",
        ),
        (
            known,
            "# mass = \"12 ± 1e101 kg\"",
            "mass = \"12 ± 1e101 kg\" must be with a standard deviation of 1e100 at most, in SI: it is 5e100 | the value after ± is divided by coverage_factor, 2e0",
        ),
        (
            known,
            "# mass = \"0.5 kg\"\n# mass_sd = 7e99",
            "mass_sd = 7e99 must be with a standard deviation of 5e99 at most, in SI: it is 7e99",
        ),
        (
            known,
            "# fill = 0.5\n# fill_sd = 1e101",
            "fill_sd = 1e101 must be with a standard deviation of 5e99",
        ),
        (
            "# density = \"0.9 g/cm^3 ± 1e105 %\"",
            "# mass = 12",
            "density = \"0.9 g/cm^3 ± 1e105 %\" must be with a standard deviation of 1e100 at most",
        ),
        ("# density = \"0.9 ± 0.1 kg\"", "# mass = 12", "\"kg\" is a mass where a density belongs"),
        (
            "# density = \"-0.9 g/cm^3 ± 5 %\"",
            "# mass = 12",
            "density = \"-0.9 g/cm^3 ± 5 %\" must be from 1e-6",
        ),
    ] {
        let error = csv(&list(density, contents)).unwrap_err();
        let hint = error.hint().map_or_else(String::new, |hint| format!(" | {hint}"));
        let found = format!("{}{hint}", error.message());
        assert!(found.starts_with(expected), "{contents}\n{found}\n{expected}");
        assert!(error.place().is_some_and(|place| (6..=14).contains(&place.line)), "{contents}");
    }
    let unused = TANK.replace("\"fuels\"", "\"fuel\"");
    assert!(csv(&unused).unwrap_err().message().contains("must be the group of a row, or of a tank"));
}

const GRAIN: &str = "mass [kg],level [mm],x [mm],y [mm],z [cm],ixx,iyy,izz,ixy,ixz,iyz\n4,10,0,1,10,0.1,0.12,0.05,0.01,0,-0.02\n10,25,2,0,12,0.3,0.31,0.2,0.01,0.02,0\n";

fn plan(table: &str) -> String {
    format!(
        "parts = \"parts.csv\"\nproducts = \"positive integrals\"\n[[tank]]\nname = \"grain\"\nmass = \"7 ± 0.5 kg\"\n{table}\n"
    )
}

const INLINE: &str = "[[tank.table]]\nmass = \"4 kg\"\nlevel = \"10 mm\"\ncenter = [0, 0.001, 0.1]\nmoments = [0.1, 0.12, 0.05]\nproducts = [0.01, 0, -0.02]\n\
[[tank.table]]\nmass = \"10 kg\"\nlevel = \"25 mm\"\ncenter = [0.002, 0, 0.12]\nmoments = [0.3, 0.31, 0.2]\nproducts = [0.01, 0.02, 0]";

#[test]
fn a_table_may_be_a_file_or_a_sheet() {
    let folder = Folder::new("tank-table");
    folder.write("parts.csv", "name,mass\na,5\nb,6\n");
    folder.write("grain.csv", GRAIN);
    let read = |name: &str, text: &str| folder.read(name, text).unwrap_or_else(|error| panic!("{error}"));
    let inline = read("a.toml", &plan(INLINE));
    // All rows scale with the density.
    let dense = plan(INLINE).replace("mass = \"7 ± 0.5 kg\"", "fill = 1\ndensity_sd = \"2 %\"");
    let estimate = read("a.toml", &dense).configurations[0].budget.estimate(Basis::Basic).unwrap();
    assert!((estimate.sd(0) - 0.2).abs() < 1e-12 && (estimate.properties.mass() - 21.0).abs() < 1e-12);
    let found = folder.read("a.toml", dense.replace("2 %", "2 kg/m^3")).unwrap_err();
    assert!(
        found.contains("density_sd = \"2 kg/m^3\" must be in percent: a table has no density"),
        "{found}"
    );
    let of_file = read("a.toml", &plan("table = \"grain.csv\""));
    assert_eq!(inline.configurations, of_file.configurations);
    let estimate = inline.configurations[0].budget.estimate(Basis::Basic).unwrap();
    assert!((estimate.properties.mass() - 18.0).abs() < 1e-12 && (estimate.sd(0) - 0.5).abs() < 1e-12);
    // The table is among the files that were read, so it is never overwritten.
    assert!(of_file.read.iter().any(|read| read.path.ends_with("grain.csv")));
    let lines = of_file.sources();
    let said = "grain.csv: 2 rows of tank contents";
    assert!(lines.iter().any(|line| line.ends_with(said)), "{lines:?}");
    // Columns in any order, without levels, with or without units in the cells, in another form.
    let other = "z [m];mass;izz;iyy;ixx;y;x [m];ixy;iyz;ixz\n0.1;4;0.05;0.12;0.1;0.001;0;0.01;-0.02;0\n0.12;10 kg;0.2;0.31;0.3;0;0.002;0.01;0;0.02\n";
    folder.write("grain.csv", other);
    let found = folder.read("a.toml", plan("table = \"grain.csv\"")).unwrap_err();
    assert!(
        found.contains("grain.csv:3:6: mass = 10 kg must be with a unit or without, like the numbers above"),
        "{found}"
    );
    folder.write("grain.csv", other.replace("10 kg", "10"));
    let other = read("a.toml", &plan("table = \"grain.csv\""));
    let of = |file: &BudgetFile| file.configurations[0].budget.mass_properties(Basis::Basic).unwrap();
    assert_eq!(of(&other), of(&inline));
    let comma = "mass [kg];x;y;z\n4;0,5;0;0,25\n10;1;0;0,75\n";
    folder.write("grain.csv", comma);
    let found = folder.read("a.toml", plan("table = \"grain.csv\"")).unwrap_err();
    assert!(found.contains("grain.csv:2:3: ") && found.contains("decimal = \"comma\""), "{found}");
    let commas = read("a.toml", &format!("decimal = \"comma\"\n{}", plan("table = \"grain.csv\"")));
    // Half of each row, with the parts at the origin.
    assert!((of(&commas).center_of_mass().z - 4.25 / 18.0).abs() < 1e-15);

    let rows: Vec<Vec<&str>> = GRAIN.lines().map(|line| line.split(',').collect()).collect();
    let rows: Vec<&[&str]> = rows.iter().map(Vec::as_slice).collect();
    let book = |sheet: &str, rows: &[&[&str]]| {
        Book::new()
            .sheet("parts", &[&["name", "mass"], &["a", "5"], &["b", "6"]])
            .sheet("plan", &[&["products", "positive integrals"]])
            .sheet("tank", &[&["name", "mass", "table"], &["grain", "7 ± 0.5 kg", sheet]])
            .sheet("grain", rows)
            .bytes()
    };
    let of_sheet = folder.read("a.xlsx", book("grain", &rows)).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(of_sheet.configurations, inline.configurations);
    assert!(of_sheet.read[0].lines.contains(&"the sheet grain: 2 rows of tank contents".to_owned()));
    for (sheet, expected) in [
        (
            "gravel",
            "a.xlsx: tank!C2: table = \"gravel\" must be a file of CSV, or the name of a sheet | or write",
        ),
        (
            "tank",
            "a.xlsx: tank!C2: table = \"tank\" must be a file of CSV, or the name of a sheet | or write",
        ),
        (
            "gravel.csv",
            "a.xlsx: tank!C2: cannot read \"gravel.csv\": the file does not exist | paths are relative",
        ),
    ] {
        let found = folder.read("a.xlsx", book(sheet, &rows)).unwrap_err();
        assert!(found.replace(&format!("{}/", folder.0.display()), "").starts_with(expected), "{found}");
    }
    let falls: Vec<&[&str]> = vec![rows[0], rows[2], rows[1]];
    let found = folder.read("a.xlsx", book("grain", &falls)).unwrap_err();
    assert!(found.contains("grain!A3: mass = 4 must be greater than in the row before"), "{found}");
}

#[test]
fn a_table_that_is_none_is_refused_where_it_is() {
    let folder = Folder::new("tank-table-refused");
    folder.write("parts.csv", "name,mass\na,5\nb,6\n");
    let refused = |from: &str, to: &str| {
        assert!(GRAIN.contains(from), "{from}");
        folder.write("grain.csv", GRAIN.replacen(from, to, 1));
        folder.read("a.toml", plan("table = \"grain.csv\"")).unwrap_err()
    };
    for (from, to, expected) in [
        ("level [mm]", "lvel [mm]", ":1:11: unknown key \"lvel [mm]\" in the table of a tank"),
        ("mass [kg]", "masses [kg]", ":1:1: unknown key \"masses [kg]\""),
        ("mass [kg]", "mass [mm]", ":1:1: \"mm\" is a length where a mass belongs"),
        ("y [mm]", "x [mm]", ":1:29: the heading = x [mm] must be different from the headings before"),
        ("ixx,iyy,izz", "ixx,iyy,mass", ":1:"),
        ("10,25", "4,25", ":3:1: mass = 4 must be greater than in the row before"),
        ("10,25", "10,10", ":3:4: level = 10 must be greater than in the row before"),
        ("4,10,", "-4,10,", ":2:1: mass = -4 must be positive"),
        ("4,10,", "4,-10,", ":2:3: level = -10 must be zero or positive"),
        ("4,10,", "4,,", ":2:1: the file has no level in this row"),
        ("0.3,0.31,0.2", "0.3,0.31,0.9", ":3:1: the inertia tensor is impossible"),
        ("0.3,0.31,0.2", "0.3,x,0.2", ":3:"),
        ("0.02,0\n", "0.02,0,7\n", ":3:"),
    ] {
        let found = refused(from, to);
        assert!(found.contains(&format!("grain.csv{expected}")), "{to}: {found}");
    }
    // Without a sign of the products, and without a required column.
    folder.write("grain.csv", GRAIN);
    let unsigned = plan("table = \"grain.csv\"").replace("products = \"positive integrals\"\n", "");
    let found = folder.read("a.toml", unsigned).unwrap_err();
    assert!(
        found.starts_with("grain.csv:2:27: products = 0.01 must be given with their sign convention"),
        "{found}"
    );
    assert!(found.contains("| set products = "), "{found}");
    for (text, missing) in [
        ("", "column with the heading mass"),
        ("x,y,z\n1,2,3\n", "column with the heading mass"),
        ("mass,level\n1,2\n", "column x, y or z"),
        ("mass,z,ixx\n1,2,3\n", "column of three, ixx, iyy and izz"),
        ("mass,z,ixy\n1,2,3\n", "column of three, ixx, iyy and izz"),
        ("mass,z\n", "the table of a liquid has no rows"),
    ] {
        folder.write("grain.csv", text);
        let found = folder.read("a.toml", plan("table = \"grain.csv\"")).unwrap_err();
        assert!(found.contains("grain.csv") && found.contains(missing), "{text:?}: {found}");
    }
    let found = folder.read("a.toml", plan("table = \"nowhere.csv\"")).unwrap_err();
    assert!(found.starts_with("a.toml:6:9: ") && found.contains("paths are relative"), "{found}");
    let found = folder.read("a.toml", plan("table = \"grain\"")).unwrap_err();
    assert!(
        found.contains("a.toml:6:9: table = \"grain\" must be a file of CSV | or write its rows here"),
        "{found}"
    );
    // If the text is not trusted, it opens no other file.
    let head: String =
        plan("table = \"grain.csv\"").lines().skip(1).map(|line| format!("# {line}\n")).collect();
    let list = format!("{head}name,mass\na,5\nb,6\n");
    let alone = Access { files: &Memory::default(), roots: &[] };
    let error =
        polhode_budget::read::from_bytes(alone, &folder.0.join("a.csv"), list.as_bytes()).unwrap_err();
    assert!(error.to_string().contains("a file that was opened or dropped together"), "{error}");
}

/// A tank that exists only in a later configuration cannot drain from the beginning.
#[test]
fn a_tank_of_a_later_configuration_is_said_to_be_that() {
    let text = "# configurations = [\"stowed\", \"open\", \"far\"]\n# [[tank]]\n# name = \"gas\"\n# configuration = [\"open\", \"far\"]\n# shape = \"sphere\"\n# radius = 0.2\n\
# density = 100\n# settles = \"-z\"\n# fill = 0.5\n# [sequence]\n# configuration = \"stowed\"\n# until = 9\n# in_place = true\n# [[burn]]\n# tank = \"gas\"\n# until = 5\n# flow = 0.1\nname,mass\na,5\nb,6\n";
    let error = csv(text).unwrap_err();
    assert_eq!(
        error.to_string(),
        "list.csv:15:10: tank = \"gas\" must be in the configuration \"stowed\", in which the body begins"
    );
    assert_eq!(error.hint().as_deref(), Some("it is in \"open\", \"far\""));
    csv(&text.replace("# configuration = \"stowed\"", "# configuration = \"far\"")).unwrap();
    // The configurations follow from the tank's frame.
    let framed = text.replace("# configuration = [\"open\", \"far\"]", "# frame = \"b\"").replace(
        "name,mass\na,5\nb,6\n",
        "name,parent,configuration,mass\na,,,5\nb,a,open,6\nc,a,\"stowed, far\",6\n",
    );
    let error = csv(&framed).unwrap_err();
    assert_eq!(error.hint().as_deref(), Some("it is in \"open\""), "{error}");
}
