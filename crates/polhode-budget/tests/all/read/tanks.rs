//! Tanks and changes over time, in all three forms, and refusals.

use polhode::motion::Outflow;
use polhode_budget::{Basis, Sequence};

use super::workbook_file::Book;
use super::{Folder, csv};

const HEAD: &str = "# about = \"center\"\n# products = \"positive integrals\"\n# configurations = [\"stowed\", \"deployed\"]\n\
# [[tank]]\n# name = \"fuel\"\n# frame = \"tank\"\n# shape = \"cylinder\"\n# radius = \"150 mm\"\n# length = \"300 mm\"\n# ends = [\"0 mm\", \"100 mm\"]\n\
# density = \"0.9 g/cm^3\"\n# settles = \"-x\"\n# fill = \"75 %\"\n\
# [[tank]]\n# name = \"grain\"\n# mass = \"8 kg\"\n# frame = \"booster\"\n# [[tank.table]]\n# mass = \"4 kg\"\n# center = [0, 0, \"10 cm\"]\n# moments = [0.1, 0.1, 0.05]\n\
# [[tank.table]]\n# mass = \"10 kg\"\n# center = [0, \"5 mm\", \"12 cm\"]\n# moments = [0.3, 0.3, 0.2]\n# products = [0.01, 0, -0.02]\n\
# [sequence]\n# configuration = \"stowed\"\n# until = \"60 s\"\n# spin = [0, 0, \"30 rpm\"]\n\
# [[burn]]\n# tank = \"grain\"\n# until = \"4 s\"\n# mass = \"8 kg\"\n\
# [[burn]]\n# tank = \"fuel\"\n# from = \"10 s\"\n# until = \"30 s\"\n# flow = \"0.2 kg/s\"\n\
# [[drop]]\n# time = \"6 s\"\n# rows = [\"booster\"]\n# [[deploy]]\n# time = \"8 s\"\n# configuration = \"deployed\"\n\
# [[exit]]\n# position = [0, 0, \"-1 m\"]\n";

const ROWS: &str = "name,parent,configuration,mass,x,y,z,ixx,iyy,izz,at x,at y,at z,yaw\n\
craft,,,,,,,,,,,,,\nbus,craft,,20 ± 0.1,0.1,0,0.2,1,1,1,,,,\ntank,craft,,1,0,0,0,0.1,0.1,0.1,0.1,-0.2,0.4,0.3\n\
booster,craft,,3,0,0,0,0.1,0.2,0.2,0,0,-0.8,\narm,craft,stowed,2,0.1,0,0,0.1,0.1,0.1,0,0,0,\narm,craft,deployed,2,0.9,0,0,0.1,0.1,0.1,0,0,0,\n";

fn text(from: &str, to: &str) -> String {
    let whole = format!("{HEAD}{ROWS}");
    assert!(from.is_empty() || whole.contains(from), "{from}");
    if from.is_empty() { whole } else { whole.replacen(from, to, 1) }
}

#[test]
fn liquids_count_and_go() {
    let file = csv(&text("", "")).unwrap_or_else(|error| panic!("{error} {:?}", error.hint()));
    let prescribed = file.prescribed.as_ref().unwrap();
    let sequence: Sequence<'_> = prescribed.sequence(Some("stowed"), Basis::Basic).unwrap();
    let volume = std::f64::consts::PI * 0.15_f64.powi(2) * (0.3 + 2.0 / 3.0 * 0.1);
    let masses: Vec<f64> = sequence.tanks.iter().map(|(_, mass)| *mass).collect();
    assert!((masses[0] - 0.75 * 900.0 * volume).abs() < 1e-12 && masses[1] == 8.0, "{masses:?}");
    // The main result is the body with its liquids, with the errors of its parts.
    for configuration in &file.configurations {
        let name = configuration.name.as_deref();
        let at_first = prescribed.sequence(name, Basis::Basic).unwrap().at(0.0).unwrap().properties;
        let whole = configuration.budget.estimate(Basis::Basic).unwrap();
        assert!((whole.properties.mass() - (26.0 + masses[0] + 8.0)).abs() < 1e-12);
        assert!((whole.properties.center_of_mass() - at_first.center_of_mass()).norm() < 1e-14);
        let [a, b] = [whole.properties, at_first].map(|body| body.inertia().matrix());
        let apart =
            a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-12, "{apart:e}");
        assert!((whole.sd(0) - 0.1).abs() < 1e-12);
    }
    let after = sequence.at(40.0).unwrap().properties.mass();
    assert!((after - (23.0 + masses[0] - 4.0)).abs() < 1e-12);
    // Products have the sign of the file: Ixy of the tensor is negative if the integral is
    // positive.
    let full = sequence.tanks[1].0.liquid.at(10.0).unwrap().properties.unwrap();
    assert_eq!(full.inertia().matrix()[0][1], -0.01);
    let over_time = prescribed.over_time.as_ref().unwrap();
    assert_eq!((over_time.until, over_time.configuration.as_deref()), (60.0, Some("stowed")));
    assert!((over_time.spin.unwrap().z - std::f64::consts::PI).abs() < 1e-15);
    assert!(matches!(&over_time.outflow, Outflow::Exits(exits) if exits[0].position.z == -1.0));
    assert!(prescribed.sequence(Some("deployed"), Basis::Basic).unwrap().burns.is_empty());
    let said = file.sources().join("\n");
    assert!(
        said.contains("8 kg in \"grain\", exactly") && said.contains("without growth allowance"),
        "{said}"
    );
}

#[test]
fn a_workbook_has_sheets_of_them() {
    let folder = Folder::new("tanks");
    let parts: &[&[&str]] = &[&["name", "mass"], &["case", "5"], &["payload", "7"]];
    let book = |flow: &str, row: &str| {
        Book::new()
            .sheet("parts", parts)
            .sheet(
                "tank",
                &[
                    &["name", "frame", "shape", "radius", "density", "settles", "mass"],
                    &["water", "case", "sphere", "0.1 m", "1000", "-z", "2"],
                ],
            )
            .sheet("sequence", &[&["until", "20 s"]])
            .sheet("burn", &[&["tank", "until", "flow"], &["water", "10 s", flow]])
            .sheet("drop", &[&["time", "rows"], &["15 s", row]])
    };
    let file = folder.read("a.xlsx", book("0.1 kg/s", "case").bytes()).unwrap();
    let sequence = file.prescribed.as_ref().unwrap().sequence(None, Basis::Basic).unwrap();
    let masses = [0.0, 10.0, 16.0].map(|time| sequence.at(time).unwrap().properties.mass());
    assert!(masses.iter().zip([14.0, 13.0, 7.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{masses:?}");
    for (flow, row, expected) in [
        ("0.3 kg/s", "case", "a.xlsx: burn!C2: at t = 10 s there would be -1 kg in the tank \"water\""),
        (
            "0.1 kg/s",
            "cases",
            "a.xlsx: drop!B2: a change refers to the row \"cases\", which is not in the list",
        ),
        ("0.1 m/s", "case", "a.xlsx: burn!C2: \"m/s\" is a velocity where a quantity in kg s^-1 belongs"),
    ] {
        let found = folder.read("a.xlsx", book(flow, row).bytes()).unwrap_err();
        assert!(found.starts_with(expected), "{found}");
    }
}

/// Old text, new text, and the line with the start of the message; after the bar, the start of the
/// hint.
const REFUSED: &[(&str, &str, &str)] = &[
    (
        "# shape = \"cylinder\"",
        "# shape = \"tube\"",
        "shape = \"tube\" must be one of box, sphere, ellipsoid, cylinder",
    ),
    (
        "# shape = \"cylinder\"",
        "# shape = \"sphere\"",
        "length = \"300 mm\" must be left out: the tank is a sphere | its sizes are radius",
    ),
    ("# shape = \"cylinder\"\n", "", "the key shape is missing in [[tank]]"),
    ("# settles = \"-x\"\n", "", "the key settles is missing in [[tank]]"),
    ("# settles = \"-x\"", "# settles = \"down\"", "settles = \"down\" must be one of -x, -y, -z, x, y, z"),
    ("# radius = \"150 mm\"", "# radius = \"-1 mm\"", "radius = \"-1 mm\" must be positive"),
    ("# length = \"300 mm\"", "# length = \"-1 mm\"", "length = \"-1 mm\" must be zero or positive"),
    ("0.9 g/cm^3", "1e9 g/cm^3", "density = \"1e9 g/cm^3\" must be from 1e-6 to 1e6, in SI"),
    ("0.9 g/cm^3", "0.9 g", "\"g\" is a mass where a density belongs"),
    ("# fill = \"75 %\"", "# fill = \"175 %\"", "fill = \"175 %\" must be from 0 to 100 %"),
    (
        "# fill = \"75 %\"",
        "# mass = \"900 kg\"",
        "mass = \"900 kg\" must be from 0 to the capacity of the tank, ",
    ),
    ("# fill = \"75 %\"\n", "", "the key mass is missing in [[tank]]"),
    ("# fill = \"75 %\"", "# fill = 0.5\n# mass = 2", "fill and mass are both given"),
    (
        "# frame = \"tank\"",
        "# frame = \"tnak\"",
        "frame = \"tnak\" must be the name of a row, in whose frame the tank is | did you mean \"tank\"?",
    ),
    (
        "# frame = \"tank\"",
        "# frame = \"arm\"\n# configuration = \"stwed\"",
        "configuration = \"stwed\" must be a configuration | did you mean \"stowed\"?",
    ),
    ("# frame = \"tank\"", "# frmae = \"tank\"", "unknown key \"frmae\" in [[tank]] | did you mean frame?"),
    ("# name = \"fuel\"", "# name = \"grain\"", "name = \"grain\" must be unique among the tanks"),
    ("# mass = \"10 kg\"", "# mass = \"4 kg\"", "mass = \"4 kg\" must be greater than in the row before"),
    (
        "# moments = [0.3, 0.3, 0.2]",
        "# moments = [0.3, 0.3, 0.9]",
        "the inertia tensor is impossible: i1 + i2 = ",
    ),
    ("# moments = [0.3, 0.3, 0.2]\n", "", "the key moments is missing"),
    ("# mass = \"4 kg\"", "# mass = \"4 kg\"\n# level = \"1 cm\"", "the key level is missing"),
    (
        "# products = \"positive integrals\"\n",
        "",
        "products = [0.01, 0, -0.02] must be given with their sign convention",
    ),
    (
        "# [sequence]\n# configuration = \"stowed\"\n# until = \"60 s\"\n# spin = [0, 0, \"30 rpm\"]\n",
        "",
        "burn = [[burn]] must be with [sequence] | write [sequence]",
    ),
    ("# configuration = \"stowed\"\n", "", "the key configuration is missing in [sequence]"),
    (
        "# configuration = \"stowed\"",
        "# configuration = \"stoved\"",
        "configuration = \"stoved\" must be a configuration | did you mean \"stowed\"?",
    ),
    ("# until = \"60 s\"\n", "", "the key until is missing in [sequence]"),
    ("# until = \"60 s\"", "# until = \"60 m\"", "\"m\" is a length where a time belongs"),
    (
        "# tank = \"grain\"",
        "# tank = \"grian\"",
        "tank = \"grian\" must be the name of a [[tank]] | did you mean \"grain\"?",
    ),
    (
        "# until = \"60 s\"",
        "# until = \"29 s\"",
        "until = \"30 s\" must be within the sequence, which ends at 29 s",
    ),
    (
        "# time = \"8 s\"",
        "# time = \"60 s\"",
        "time = \"60 s\" must be after 0, when the sequence starts, and before 60 s, when it ends",
    ),
    (
        "# frame = \"tank\"",
        "# frame = \"tank\"\n# configuration = \"stowed\"",
        "configuration = \"stowed\" must be such that the tank \"fuel\" is in \"stowed\" and \"deployed\", or in neither",
    ),
    ("# until = \"4 s\"", "# until = \"0 s\"", "until = \"0 s\" must be after the burn begins, at 0 s"),
    ("# mass = \"8 kg\"\n# [[burn]]", "# mass = \"8.1 kg\"\n# [[burn]]", "at t = 4 s there would be -0.0999"),
    ("# from = \"10 s\"", "# from = \"-1 s\"", "from = \"-1 s\" must be not negative"),
    ("# flow = \"0.2 kg/s\"", "# flow = \"-0.2 kg/s\"", "flow = \"-0.2 kg/s\" must be positive"),
    ("# flow = \"0.2 kg/s\"", "# flow = \"2 kg/s\"", "at t = "),
    ("# flow = \"0.2 kg/s\"\n", "", "the key flow is missing in [[burn]]"),
    (
        "# rows = [\"booster\"]",
        "# rows = [\"boster\"]",
        "a change refers to the row \"boster\", which is not in the list",
    ),
    ("# rows = [\"booster\"]", "# rows = [\"craft\"]", "after t = 6 s the body has no mass left"),
    ("# rows = [\"booster\"]", "# rows = [\"tank\"]", "at t = 10 s \"fuel\" has already been removed"),
    ("# time = \"6 s\"", "# time = \"3 s\"", "at t = 3 s \"grain\" has already been removed"),
    (
        "# time = \"8 s\"",
        "# time = \"6 s\"",
        "time = \"6 s\" must be different from the times of the other changes",
    ),
    (
        "# time = \"8 s\"\n# configuration = \"deployed\"",
        "# time = \"8 s\"\n# configuration = \"open\"",
        "configuration = \"open\" must be a configuration",
    ),
    (
        "arm,craft,deployed,2",
        "arm,craft,deployed,2.5",
        "the deployment at t = 8 s changes the mass from 23 kg to 23.5 kg",
    ),
    ("# position = [0, 0, \"-1 m\"]\n", "", "the key position is missing in [[exit]]"),
];

#[test]
fn what_is_wrong_is_refused_where_it_is() {
    let mut wrong = Vec::new();
    for (from, to, expected) in REFUSED {
        let list = text(from, to);
        let found = match csv(&list) {
            Ok(_) => "it is read".to_owned(),
            Err(error) => {
                let hint = error.hint().map_or_else(String::new, |hint| format!(" | {hint}"));
                let line = error.place().map_or(0, |place| place.line);
                let is_there = line > 0 && line <= HEAD.lines().count() + 2;
                format!("{}{}{hint}", if is_there { "" } else { "without its line: " }, error.message())
            }
        };
        if !found.starts_with(expected) {
            wrong.push(format!("{to:?}\n  found    {found}\n  expected {expected}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // A tank in one of several copies is ambiguous.
    let several = "# [[tank]]\n# name = \"t\"\n# frame = \"a\"\n# shape = \"sphere\"\n# radius = 1\n# density = 1\n# settles = \"z\"\n# fill = 1\nname,mass,quantity\na,1,2\nb,1,1\n";
    let error = csv(several).unwrap_err();
    let named = csv(&several.replace("name = \"t\"", "name = \"b\"")).unwrap_err();
    assert!(
        named.to_string().contains("the tank = \"b\" must be different from the names of all rows"),
        "{named}"
    );
    assert_eq!(error.to_string(), "list.csv:3:11: the tank \"t\" is in \"a\", which has several copies");
}
