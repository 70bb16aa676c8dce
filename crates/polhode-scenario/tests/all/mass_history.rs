//! Mass histories in scenario files: burning and dropped parts, tables, errors.

use std::fs;
use std::path::PathBuf;

use polhode::motion::{MassHistory, MassRow, Outflow};
use polhode::prelude::*;
use polhode_scenario::read as scenario;
use polhode_source::FormatError;

const PARTS: &str = "[[body.part]]\nname = 'hull'\nshape = 'tensor'\nmass = '3 kg'\ncenter_of_mass = [0.1, -0.05, 0.3]\n\
    inertia = [[0.31, 0.012, -0.02], [0.012, 0.36, 0.03], [-0.02, 0.03, 0.14]]\n\
    [[body.part]]\nname = 'grain'\nshape = 'cylinder'\nradius = '0.2 m'\nlength = '0.9 m'\nmass = '2 kg'\n\
    position = [0.02, 0.03, -0.4]\nrotate = { axis = [0.3, 1, 0.2], angle = '20 deg' }\n\
    [[body.part]]\nname = 'booster'\nshape = 'box'\nsize = [0.3, 0.2, 0.5]\nmass = '0.8 kg'\nposition = [-0.4, 0.1, 0]\n";
const REST: &str = "[start]\nspin = { body = [0.7, -1.1, 1.9] }\n[run]\nduration = '10 s'\nsamples = 6\n";
const EXIT: &str = "[[mass_history.exit]]\nposition = [0.05, 0, -0.9]\n";

fn parse(text: &str) -> Result<Scenario, FormatError> {
    scenario::parse(text, "test.toml".as_ref())
}

fn with(keys: &str) -> Result<Scenario, FormatError> {
    parse(&format!("{PARTS}{keys}{REST}"))
}

fn history(scenario: &Scenario) -> &MassHistory {
    scenario.history().unwrap()
}

fn mass(scenario: &Scenario, time: f64) -> f64 {
    history(scenario).at(time).unwrap().0.mass()
}

#[test]
fn parts_burn_and_are_dropped() {
    let keys = "[[mass_history.burn]]\npart = 'grain'\nfrom = '1 s'\nuntil = '5 s'\nleft = '500 g'\n\
        [[mass_history.burn]]\npart = 'booster'\nuntil = '4 s'\n[[mass_history.drop]]\npart = 'grain'\ntime = '7 s'\n";
    let scenario = with(&format!("{keys}{EXIT}")).unwrap();
    for (time, want) in [
        (0.0, 5.8),
        (0.5, 5.7),
        (2.0, 3.0 + 1.625 + 0.4),
        (4.5, 3.0 + 0.6875),
        (6.9, 3.5),
        (7.0, 3.0),
        (9.0, 3.0),
    ] {
        assert!((mass(&scenario, time) - want).abs() < 1e-14, "{time}: {}", mass(&scenario, time));
    }
    // All three parts with their remaining mass.
    let parts = scenario.parts().iter().map(|part| part.properties);
    let factors = [1.0, 0.8125, 0.5];
    let there: Vec<_> = parts
        .zip(factors)
        .map(|(part, factor)| {
            let rows = part.inertia().matrix().map(|row| row.map(|x| factor * x));
            let inertia = InertiaTensor::from_matrix(rows).unwrap();
            MassProperties::new(factor * part.mass(), part.center_of_mass(), inertia).unwrap()
        })
        .collect();
    let (found, want) = (history(&scenario).at(2.0).unwrap().0, MassProperties::combined(&there).unwrap());
    assert!((found.center_of_mass() - want.center_of_mass()).norm() < 1e-15);
    let [p, q] = [found, want].map(|body| body.inertia().matrix());
    assert!(p.as_flattened().iter().zip(q.as_flattened()).all(|(p, q)| (p - q).abs() < 1e-15));
    let motion = scenario.simulate().unwrap().unwrap();
    let drift = polhode::observe::Drift::of(&motion).unwrap();
    assert!(drift.momentum < 1e-13 && drift.work_energy < 1e-13 && motion.samples().len() == 6);
    // An initial spin given by its angular momentum refers to the whole body.
    let by_momentum = parse(&format!(
        "{PARTS}{keys}{EXIT}[start]\nspin = {{ momentum = [0.1, 0.2, 0.9] }}\n[run]\nduration = 1\nsamples = 2"
    ));
    let momentum = by_momentum.unwrap().simulate().unwrap().unwrap().samples()[0].momentum;
    assert!((momentum - AngularMomentum::new(0.1, 0.2, 0.9)).norm() < 1e-15);
}

#[test]
fn what_is_left_in_place_does_not_turn_the_rest() {
    let burn = "[[mass_history.burn]]\npart = 'grain'\nuntil = '5 s'\n";
    let in_place = with(&format!("{burn}[mass_history]\nin_place = true\n"));
    // In TOML a table precedes its subtables.
    assert!(in_place.is_err() || history(&in_place.unwrap()).outflow() == &Outflow::InPlace);
    let scenario = with(&format!("[mass_history]\nin_place = true\n{burn}")).unwrap();
    assert_eq!(history(&scenario).outflow(), &Outflow::InPlace);
    let free = with("").unwrap();
    let [a, b] = [&scenario, &free].map(|s| s.simulate().unwrap().unwrap().samples()[1].state.omega);
    assert!((a - b).norm() > 1e-3, "I is not that of the whole body");
}

/// Temporary folder, removed when dropped.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("polhode-mass-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }

    fn read(&self, table: &str, keys: &str) -> Result<Scenario, FormatError> {
        fs::write(self.0.join("mass.csv"), table).unwrap();
        let text = format!("{PARTS}[mass_history]\ntable = 'mass.csv'\n{keys}{REST}");
        scenario::parse(&text, &self.0.join("scenario.toml"))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

const HEADER: &str = "time_s,mass_kg,center_x_m,center_y_m,center_z_m,inertia_xx_kg_m2,inertia_yy_kg_m2,inertia_zz_kg_m2,\
    inertia_xy_kg_m2,inertia_xz_kg_m2,inertia_yz_kg_m2";
const RATES: &str = ",mass_rate_kg_s,center_rate_x_m_s,center_rate_y_m_s,center_rate_z_m_s,inertia_rate_xx_kg_m2_s,\
    inertia_rate_yy_kg_m2_s,inertia_rate_zz_kg_m2_s,inertia_rate_xy_kg_m2_s,inertia_rate_xz_kg_m2_s,inertia_rate_yz_kg_m2_s";

fn line(time: f64, body: &MassProperties<Body>, sign: f64) -> String {
    let [x, y, z] = body.center_of_mass().to_array();
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix();
    format!("{time},{},{x},{y},{z},{xx},{yy},{zz},{},{},{}", body.mass(), sign * xy, sign * xz, sign * yz)
}

#[test]
fn a_table_is_the_history_of_the_whole_body() {
    let folder = Folder::new("table");
    let keys = "[[mass_history.burn]]\npart = 'grain'\nuntil = '8 s'\nleft = '0.2 kg'\n[[mass_history.drop]]\npart = 'booster'\ntime = '3 s'\n";
    let by_parts = with(&format!("{keys}{EXIT}")).unwrap();
    let at = |time: f64| history(&by_parts).at(time).unwrap();
    let before = |time: f64| history(&by_parts).at(f64::next_down(time)).unwrap();
    let want = by_parts.simulate().unwrap().unwrap();
    for (sign, products) in [(1.0, ""), (-1.0, "products = 'positive_integral'\n")] {
        let rows = [
            line(0.0, &at(0.0).0, sign),
            line(3.0, &before(3.0).0, sign),
            line(3.0, &at(3.0).0, sign),
            line(8.0, &at(8.0).0, sign),
        ];
        let table = format!("{HEADER}\n{}\n", rows.join("\n"));
        let motion = folder.read(&table, &format!("{products}{EXIT}")).unwrap().simulate().unwrap().unwrap();
        for (a, b) in motion.samples().iter().zip(want.samples()) {
            assert!((a.state.omega - b.state.omega).norm() < 1e-12);
            assert!(a.state.attitude.angle_to(b.state.attitude) < 1e-12);
        }
    }
    // With rates: here those of straight lines.
    let with_rates = |time: f64, (body, rates): (MassProperties<Body>, polhode::motion::MassRates)| {
        let [x, y, z] = rates.center_of_mass.to_array();
        let more = [[rates.mass, x, y, z].as_slice(), &rates.inertia].concat();
        let more = more.iter().map(f64::to_string).collect::<Vec<_>>().join(",");
        format!("{},{more}", line(time, &body, 1.0))
    };
    let rows = [
        with_rates(0.0, at(0.0)),
        with_rates(3.0, before(3.0)),
        with_rates(3.0, at(3.0)),
        with_rates(8.0, before(8.0)),
    ];
    let table = format!("{HEADER}{RATES}\n{}\n", rows.join("\n"));
    let motion = folder.read(&table, EXIT).unwrap().simulate().unwrap().unwrap();
    for (a, b) in motion.samples().iter().zip(want.samples()) {
        assert!((a.state.omega - b.state.omega).norm() < 1e-12);
    }
}

/// Returns a body with mass and tensor multiplied by a factor.
fn scaled(body: &MassProperties<Body>, by: f64) -> MassProperties<Body> {
    let rows = body.inertia().matrix().map(|row| row.map(|x| by * x));
    let inertia = polhode::body::InertiaTensor::from_matrix(rows).unwrap();
    MassProperties::new(by * body.mass(), body.center_of_mass(), inertia).unwrap()
}

fn half(body: &MassProperties<Body>) -> MassProperties<Body> {
    scaled(body, 0.5)
}

#[test]
fn a_table_may_begin_before_the_run() {
    let folder = Folder::new("before");
    let whole = *with("").unwrap().body();
    let [first, last] = [(-3.0, 1.3), (6.0, 0.4)].map(|(time, by)| line(time, &scaled(&whole, by), 1.0));
    let table = format!("{HEADER}\n{first}\n{last}\n");
    let read = folder.read(&table, EXIT).unwrap();
    let (now, _) = history(&read).at(0.0).unwrap();
    assert!((now.mass() - whole.mass()).abs() < 1e-12 * whole.mass(), "{now:?}");
}

#[test]
fn tables_that_make_no_sense_are_refused() {
    let folder = Folder::new("refused");
    let body = *with("").unwrap().body();
    let first = line(0.0, &body, 1.0);
    let refused = |table: &str, keys: &str| folder.read(table, keys).unwrap_err().to_string();
    let table = |second: &str| format!("{HEADER}\n{first}\n{second}\n");
    for (table, keys, what) in [
        (String::new(), "", "lines"),
        (format!("{HEADER}\n"), "", "mass.csv: the file has no rows"),
        (HEADER.replace("center_z_m,", ""), "", "column center_z_m"),
        (format!("{HEADER},mass_rate_kg_s\n"), "", "column center_rate_x_m_s"),
        (table(&line(-1.0, &body, 1.0)), "", "not before the time of the previous row"),
        (table(&first.replacen('0', "5", 1).replacen("5.8", "-5.8", 1)), "", "mass"),
        (table("5,6"), "", "fields long"),
        (format!("{HEADER},mass_rate_kg_per_s\n{first},1\n"), "", "one of a mass history's"),
        (format!("{HEADER},mass_kg\n{first},1\n"), "", "there once"),
        // At t = 0 the body is halfway between the rows.
        (
            format!("{HEADER}\n{}\n{}\n", line(-2.0, &body, 1.0), line(2.0, &half(&body), 1.0)),
            EXIT,
            "a table that agrees",
        ),
        // A wrong sign is detected, because the body is given twice.
        (format!("{HEADER}\n{}\n", line(0.0, &body, -1.0)), "", "a table that agrees"),
        (
            table(&first),
            "in_place = true\n[[mass_history.burn]]\npart = 'hull'\nuntil = 2\n",
            "table and burn",
        ),
    ] {
        let message = refused(&table, keys);
        assert!(message.contains(what), "{message}");
    }
}

#[test]
fn mistakes_have_their_places() {
    let burn = "[[mass_history.burn]]\npart = 'grain'\nuntil = '5 s'\n";
    let drop = "[[mass_history.drop]]\npart = 'booster'\ntime = '3 s'\n";
    for (keys, excerpt, message, hint) in [
        (
            burn.to_owned(),
            "[[mass_history.burn]]",
            "loses mass, but its exit is not defined",
            "state where the mass",
        ),
        (
            burn.replace("grain", "grian") + EXIT,
            "part = 'grian'",
            "the name of a part",
            "did you mean \"grain\"?",
        ),
        (format!("{burn}{burn}{EXIT}"), "part = 'grain'", "named in one burn only", ""),
        (
            burn.replace("until", "from = '6 s'\nuntil") + EXIT,
            "until = '5 s'",
            "after the burn begins, at 6 s",
            "",
        ),
        (burn.replace("until", "from = '-6 s'\nuntil") + EXIT, "from = '-6 s'", "not negative", ""),
        (
            burn.replace("until", "left = '2 kg'\nuntil") + EXIT,
            "left = '2 kg'",
            "less than the available mass, 2 kg",
            "",
        ),
        (drop.replace("'3 s'", "0"), "time = 0", "after the start", ""),
        (format!("{drop}{drop}"), "part = 'booster'", "dropped once", ""),
        (
            format!("{burn}{}{EXIT}", drop.replace("booster", "grain")),
            "time = '3 s'",
            "before the part's burn ends",
            "",
        ),
        (
            "[mass_history]\nin_place = true\n".to_owned(),
            "[mass_history]",
            "the key burn is missing",
            "write",
        ),
        (
            "[mass_history]\nproducts = 'negative_integral'\n".to_owned(),
            "products = 'negative_integral'",
            "left out without a table",
            "",
        ),
        (format!("{burn}{EXIT}{EXIT}"), "[[mass_history.exit]]", "the key share is missing", "write"),
        (format!("{burn}{EXIT}share = 0.7\n"), "[[mass_history.exit]]", "the sum is 0.7", ""),
        (
            format!("{burn}{EXIT}axis = [0, 0, 1]\n"),
            "axis = [0, 0, 1]",
            "left out, because the exit has no radius",
            "an exit without a radius",
        ),
        (
            format!("{burn}{EXIT}radius = '2 cm'\n"),
            "[[mass_history.exit]]",
            "the key axis is missing",
            "write",
        ),
        (format!("{burn}{EXIT}radius = '2 cm'\naxis = [0, 0, 0]\n"), "axis = [0, 0, 0]", "a direction", ""),
        (
            format!("{drop}[[wheel]]\naxis = [0, 0, 1]\nmomentum = 1\n"),
            "[[wheel]]",
            "mass_history and wheel",
            "leave",
        ),
        (format!("{drop}[sweep]\nmembers = 3\n"), "[sweep]", "mass_history and sweep", "leave"),
    ] {
        let error = with(&keys).expect_err(&keys);
        assert!(error.to_string().contains(message), "{keys}: {error}");
        let place = error.place().unwrap();
        assert!(place.excerpt.contains(excerpt), "{keys}: {}", place.excerpt);
        let given = error.hint().unwrap_or_default();
        assert!(given.starts_with(hint) && (hint.is_empty() == given.is_empty()), "{keys}: {given}");
    }
}

#[test]
fn a_body_alone_is_not_changed_by_a_history_that_says_nothing() {
    let body = *with("").unwrap().body();
    let row = |time| MassRow { time, body, rates: None };
    let history = MassHistory::new(&[row(0.0), row(1.0)], Outflow::None).unwrap();
    let scenario = with("").unwrap().changing(history).unwrap();
    let [a, b] = [&scenario, &with("").unwrap()].map(|s| s.simulate().unwrap().unwrap().samples()[5].state);
    assert!(a.attitude.angle_to(b.attitude) < 1e-12 && (a.omega - b.omega).norm() < 1e-12);
}

#[test]
fn what_lies_outside_the_run_is_said() {
    let idle = |scenario: &Scenario| -> Vec<String> {
        let of = |finding: &&polhode::body::Finding| finding.code == "mass_history.idle";
        scenario.findings().iter().filter(of).map(|finding| finding.message.clone()).collect()
    };
    let burn = |from: f64| {
        format!("[[mass_history.burn]]\npart = 'grain'\nfrom = {from}\nuntil = {}\n{EXIT}", from + 4.0)
    };
    let drop = |time: f64| format!("[[mass_history.drop]]\npart = 'booster'\ntime = {time}\n");
    // The run ends at 10 s.
    let only = |from: &str| {
        format!(
            "the mass properties change only from t = {from} s on, and the run ends at 10 s: the body stays as it is"
        )
    };
    for (keys, want) in [
        (burn(9.5) + &drop(9.9), vec![]),
        (
            burn(3.0) + &drop(10.0),
            vec!["\"booster\" is dropped at t = 10 s, and the run ends at 10 s".to_owned()],
        ),
        (
            burn(12.5) + &drop(3.0),
            vec!["the burn of \"grain\" begins at t = 12.5 s, and the run ends at 10 s".to_owned()],
        ),
        (burn(12.5) + &drop(11.0), vec![only("11")]),
    ] {
        assert_eq!(idle(&with(&keys).unwrap()), want);
    }
    let folder = Folder::new("idle");
    let body = *with("").unwrap().body();
    let of = |rows: &[(f64, MassProperties<Body>)]| {
        let lines: Vec<String> = rows.iter().map(|(time, body)| line(*time, body, 1.0)).collect();
        idle(&folder.read(&format!("{HEADER}\n{}\n", lines.join("\n")), EXIT).unwrap())
    };
    let heavy = scaled(&body, 1.5);
    assert_eq!(of(&[(0.0, body), (11.0, half(&body))]), Vec::<String>::new());
    assert_eq!(of(&[(10.0, body), (11.0, half(&body))]), [only("10")]);
    let before = "the mass properties change only until t = -1 s, and the run starts at 0 s";
    assert_eq!(of(&[(-2.0, heavy), (-1.0, body)]), [format!("{before}: the body stays as it is")]);
    let both = format!("{before}, and from t = 12 s on, and the run ends at 10 s: the body stays as it is");
    assert_eq!(of(&[(-2.0, heavy), (-1.0, body), (12.0, body), (12.0, half(&body))]), [both]);
    let never = "the mass properties never change: all rows of their history are alike";
    assert_eq!(of(&[(0.0, body), (2.0, body), (2.0, body)]), [never]);
}

/// The flow to the exits is that during the run, in readable numbers.
#[test]
fn the_flow_is_that_in_the_run() {
    let exit = "[[mass_history.exit]]\nposition = [0.9, 0, 0.3]\n";
    let keys = format!(
        "[[mass_history.burn]]\npart = 'grain'\nfrom = 2\nuntil = 2.5\n{exit}[[mass_history.burn]]\npart = 'booster'\nfrom = 20\nuntil = 20.001\n"
    );
    let scenario = with(&keys).unwrap();
    let said: Vec<_> =
        scenario.findings().iter().filter(|finding| finding.code == "mass_history.flow").collect();
    let [flow] = said.as_slice() else { panic!("{said:?}") };
    assert!(flow.message.starts_with("at t = 2"), "{}", flow.message);
    let most = [2.0, 2.5_f64.next_down()].map(|time| history(&scenario).flow_momentum(time, None).unwrap());
    let most = format!("{:.1}", most[0].max(most[1]));
    assert!(flow.message.contains(&format!("has {most} kg·m²/s")), "{most}: {}", flow.message);
}
