//! Plans of swing tests: content, and places of mistakes.

use std::fs;
use std::path::Path;

use polhode_identify::read as identify;
use polhode_identify::read::{Measurement, Plan};
use polhode_identify::swing::{Damping, Measurement as Measured, Rig, identify_swings};
use polhode_source::FormatError;
use polhode_source::files::Disk;

use crate::obey;

const GOOD: &str = r#"title = "A plate"
[swing]
mass = { value = "3.2 kg", sd = "1 g" }
center = ["1 mm", { about = 0 }, { value = "2 mm", sd = "0.2 mm" }]
gravity = "9.81 m/s^2"

[swing.numbers]
r = { value = "0.2 m", sd = "0.5 mm" }
l = "1.5 m"
platform = { about = "0.004 kg m^2" }

[[swing.test]]
name = "on a platform"
rig = "trifilar"
up = [0, 0, 1]
across = [1, 0, 0]
radius = "r"
length = { number = "l", plus = "5 mm" }
fixture = { mass = "0.5 kg", center = [0, 0, 0], moments = [0, 0, "platform"] }
air = { moment = { value = "1e-5 kg m^2", sd = "5e-6 kg m^2" } }
counted = { swings = 20, time = "31.42 s", sd = "0.05 s", amplitude = ["12 deg", "9 deg"], amplitude_sd = "0.5 deg" }

[[swing.test]]
name = "as a pendulum"
rig = "compound"
axis = [1, 0, 0]
pivot = { at = [0, 0, "1 cm"], along = [0, 0, 2], distance = "r" }
edge = "1 mm"
counted = { swings = 20, time = "20.1 s", sd = "0.05 s", amplitude = "5 deg", amplitude_sd = "0.5 deg", damping = "none" }
"#;

fn read(name: &str, text: &str) -> Result<Plan, FormatError> {
    let path = std::env::temp_dir().join(format!("polhode-swing-{name}-{}.toml", std::process::id()));
    fs::write(&path, text).unwrap();
    let plan = identify::read(&Disk, &path);
    fs::remove_file(&path).unwrap();
    plan
}

#[test]
fn a_plan_is_read() {
    let plan = read("good", GOOD).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(plan.title.as_deref(), Some("A plate"));
    let Measurement::Swing(swing) = plan.measurement else { panic!("a plan of swings") };
    let [platform, pendulum] = swing.tests() else { panic!("two tests") };
    assert!(matches!(&platform.rig, Rig::Wires(wires) if wires.wires.len() == 3));
    assert!(platform.fixture.is_some() && pendulum.fixture.is_none());
    let Measured::Counted(counted) = &pendulum.measurement else { panic!("counted") };
    assert_eq!((counted.damping, counted.amplitudes.len()), (Damping::None, 1));
    assert!((counted.amplitudes[0].amplitude - 5_f64.to_radians()).abs() < 1e-15);
}

/// The moment about the vertical is that of `up`, whatever the orientation of the rig in the body.
/// Numbers keep their names.
#[test]
fn a_plan_says_what_it_means() {
    let plan = r#"[swing]
mass = "2 kg"
center = ["3 mm", "-4 mm", "12 mm"]
[swing.numbers]
half = "0.15 m"
l = { value = "1.2 m", sd = "1 mm" }
[[swing.test]]
name = "tilted"
rig = "bifilar"
up = [3, 0, 4]
across = [4, 0, -3]
point = ["3 mm", "-4 mm", "12 mm"]
radius = "half"
length = "l"
counted = { swings = 50, time = "103.2 s", sd = "0.2 s", amplitude = ["0.31 rad", "0.26 rad"], amplitude_sd = "0.005 rad" }
"#;
    let Measurement::Swing(bifilar) = read("bifilar", plan).unwrap().measurement else { panic!() };
    let wires = r#"rig = "wires"
wires = [{ top = ["half", 0, "l"], bottom = ["half", 0, 0], length = "l" }, { top = ["-half", 0, "l"], bottom = ["-half", 0, 0], length = "l" }]
"#;
    let one_by_one =
        plan.replace("rig = \"bifilar\"\n", wires).replace("radius = \"half\"\nlength = \"l\"\n", "");
    let Measurement::Swing(one_by_one) = read("wires", &one_by_one).unwrap().measurement else { panic!() };
    let found = identify_swings(&bifilar).unwrap();
    let moment = found.tests[0].moment.as_ref().unwrap();
    // T = 2π √(I L/(W r²)), and slightly more at this amplitude.
    let about = (103.2 / 50.0 / std::f64::consts::TAU).powi(2) * 2.0 * 9.80665 * 0.15 * 0.15 / 1.2;
    assert!((moment.value / about - 1.0).abs() < 0.02 && moment.value < about, "{moment:?} {about}");
    let of = |i: usize| found.estimate.numbers[i].value;
    let along_up = 0.36 * of(4) + 0.64 * of(6) + 2.0 * 0.48 * of(8);
    assert!((along_up / moment.value - 1.0).abs() < 1e-12);
    assert_eq!(found.estimate.get("half").unwrap().sd, Some(0.0));
    assert!((found.estimate.get("l").unwrap().sd.unwrap() - 1e-3).abs() < 1e-9);
    let same = identify_swings(&one_by_one).unwrap();
    let other = same.tests[0].moment.as_ref().unwrap();
    assert!((other.value / moment.value - 1.0).abs() < 1e-9, "{other:?} {moment:?}");
}

/// Checks that the plan with a replaced part is refused at that part.
#[track_caller]
fn refuses(from: &str, to: &str, cited: &str, says: &str, hint: &str) {
    assert!(GOOD.contains(from), "{from}");
    let text = GOOD.replacen(from, to, 1);
    let name = format!("{:?}", std::panic::Location::caller().line());
    let error = read(&name, &text).expect_err(to);
    let place = error.place().unwrap_or_else(|| panic!("{error}"));
    let offset = text.find(cited).unwrap_or_else(|| panic!("{cited}"));
    let before = &text[..offset];
    let line = before.matches('\n').count() + 1;
    let column = offset - before.rfind('\n').map_or(0, |end| end + 1) + 1;
    assert_eq!((place.line, place.column), (line, column), "{error}");
    assert!(error.message().contains(says), "{error}");
    let given = error.hint().unwrap_or_default();
    assert!(given.contains(hint), "{given:?}");
    let parts = |error: &FormatError| (error.message(), error.place().map(|place| place.span.clone()));
    obey::check(&text, (&error.message(), &place.span, &given), |text| read(&name, text).map(drop), parts);
}

#[test]
fn mistakes_are_shown_where_they_are() {
    refuses("radius = \"r\"", "radius = \"R\"", "\"R\"", "[swing.numbers]: r, l, platform", "\"r\"");
    refuses("[0, 0, \"platform\"]", "[0, 0, \"l\"]", "\"l\"]", "l is a length", "same dimension");
    refuses("edge = ", "egde = ", "egde", "egde", "edge");
    refuses("edge = ", "length = ", "length = \"1 mm\"", "length", "");
    refuses("\"trifilar\"", "\"trifillar\"", "\"trifillar\"", "one of bifilar", "trifilar");
    refuses("across = [1, 0, 0]", "across = [1, 0, 1]", "[1, 0, 1]", "perpendicular", "");
    refuses("l = \"1.5 m\"", "l = 1.5", "1.5\n", "unit", "0.2 m");
    refuses("l = \"1.5 m\"", "l = \"1.5 m\"\nspare = \"1 m\"", "\"1 m\"\n", "used in a test", "spare");
    refuses("l = \"1.5 m\"", "l = \"1.5 m/s\"", "\"1.5 m/s\"", "a length, a stiffness", "");
    refuses("l = \"1.5 m\"", "l = \"1.5 m\"\nmass = \"1 m\"", "\"1 m\"\n", "body's own", "rename");
    refuses("sd = \"1 g\"", "sd = \"1 mm\"", "\"1 mm\"", "a length where a mass belongs", "");
    refuses("\"3.2 kg\"", "\"-3.2 kg\"", "{ value = \"-3.2", "above zero", "");
    refuses("\"5 deg\", ", "\"5 deg\", sd = 1, ", "sd = 1", "", "");
    refuses(", damping = \"none\"", "", "\"5 deg\"", "2 amplitudes", "none");
    refuses("swings = 20, time = \"31", "swings = 0, time = \"31", "0, time = \"31", "positive", "");
    refuses(
        "name = \"as a pendulum\"",
        "name = \"on a platform\"",
        "\"on a platform\"\nrig = \"comp",
        "different from the names",
        "",
    );
    refuses("rig = \"compound\"", "rig = \"compound\"\nbody = false", "false", "fixture", "");
    refuses(
        "amplitude = [\"12 deg\", \"9 deg\"]",
        "amplitude = [\"12 deg\", \"10 deg\", \"9 deg\"]",
        "\"12 deg\"",
        "a table",
        "after",
    );
    refuses("radius = \"r\"", "radius = \"r\"\nabove = \"r\"", "\"r\"\nlength", "above", "");
    refuses("{ about = 0 }", "{ about = 0, sd = 1 }", "1 }", "about", "");
}

/// A centre above the lower ends of two wires indicates a wrong sign.
#[test]
fn a_body_on_two_wires_hangs() {
    let of = |point: &str| {
        let two = GOOD.replacen("\"trifilar\"", &format!("\"bifilar\"\npoint = {point}"), 1);
        let two = two.replacen(
            "fixture = { mass = \"0.5 kg\", center = [0, 0, 0], moments = [0, 0, \"platform\"] }\n",
            "",
            1,
        );
        read(
            "hangs",
            &two.replacen("platform = { about = \"0.004 kg m^2\" }\n", "", 1).replacen(
                "{ about = 0 }",
                "0",
                1,
            ),
        )
    };
    assert!(of("[0, 0, \"3 cm\"]").is_ok());
    let error = of("[0, 0, \"-3 cm\"]").expect_err("the centre is above");
    assert!(error.message().contains("32.000 mm above"), "{error}");
    assert_eq!(error.place().map(|place| (place.line, place.column)), Some((14, 9)));
}

#[test]
fn what_is_missing_is_said() {
    let missing = |piece: &str, key: &str| {
        assert!(GOOD.contains(piece), "{piece}");
        let error = read(&format!("without-{key}"), &GOOD.replacen(piece, "", 1)).expect_err(piece);
        assert!(error.message().contains(key) && error.place().is_some(), "{error}");
    };
    missing("radius = \"r\"\n", "radius");
    missing("across = [1, 0, 0]\n", "across");
    missing("up = [0, 0, 1]\n", "up");
    missing("axis = [1, 0, 0]\n", "axis");
    missing(", sd = \"1 g\"", "sd");
    missing(", amplitude_sd = \"0.5 deg\"", "amplitude_sd");
    assert!(identify::read(&Disk, Path::new("/nowhere/plan.toml")).is_err());
}

#[test]
fn logs_of_swings_are_read() {
    let folder = std::env::temp_dir().join(format!("polhode-swing-log-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let csv = "time_ms,theta [deg],rate_rad_s,note\n0,10,0.5,1\n50,20,0.25,2\n100,5,-0.5,3\n";
    fs::write(folder.join("log.csv"), csv).unwrap();
    let plan = |logged: &str| {
        let (head, tail) = GOOD.split_at(GOOD.find("counted").unwrap());
        let rest = &tail[tail.find('\n').unwrap()..];
        fs::write(folder.join("plan.toml"), format!("{head}{logged}{rest}")).unwrap();
        identify::read(&Disk, &folder.join("plan.toml"))
    };
    let logged = |keys: &str| {
        let read = plan(&format!("logged = {{ log = \"log.csv\", {keys} }}"))?;
        let Measurement::Swing(swing) = read.measurement else { panic!("a plan of swings") };
        let Measured::Logged(logged) = swing.tests()[0].measurement.clone() else { panic!("logged") };
        Ok::<_, FormatError>((logged, read.logs))
    };
    let (angle, logs) = logged("signal = \"angle\", sd = \"0.1 deg\"").unwrap();
    assert_eq!(angle.times, [0.0, 0.05, 0.1]);
    assert!((angle.values[1] - 20_f64.to_radians()).abs() < 1e-15 && angle.damping == Damping::Viscous);
    assert_eq!(logs[0].ignored, ["rate_rad_s", "note"]);
    let (rate, _) =
        logged("signal = \"rate\", sd = \"0.1 rad/s\", from = \"20 ms\", damping = \"both\"").unwrap();
    assert_eq!((rate.times, rate.values, rate.damping), (vec![0.05, 0.1], vec![0.25, -0.5], Damping::Both));
    for (keys, says) in [
        ("signal = \"rate\", sd = \"0.1 deg\"", "an angle where"),
        ("signal = \"both\", sd = \"0.1 deg\"", "one of angle, rate"),
        ("signal = \"rate\"", "the key sd is missing"),
        ("signal = \"angle\", sd = \"1 deg\", columns = { rate = \"note\" }", "unknown key \"rate\""),
        ("signal = \"angle\", sd = \"1 deg\", columns = { angle = \"note\" }", "in which unit is note?"),
        ("signal = \"angle\", sd = \"1 deg\", from = \"2 s\"", "within the log"),
    ] {
        let error = logged(keys).unwrap_err();
        assert!(error.message().contains(says), "{keys}: {error}");
    }
    let lists = |keys: &str| {
        let Measurement::Swing(swing) = plan(&format!("logged = {{ sd = \"1 deg\", {keys} }}"))?.measurement
        else {
            panic!("a plan of swings")
        };
        let Measured::Logged(logged) = swing.tests()[0].measurement.clone() else { panic!("logged") };
        Ok::<_, FormatError>(logged)
    };
    let listed = lists(
        "signal = \"angle\", times = [\"0 s\", \"50 ms\", \"0.1 s\"], values = [\"10 deg\", \"20 deg\", \"5 deg\"]",
    );
    let listed = listed.unwrap();
    assert_eq!((&listed.times, &listed.values), (&angle.times, &angle.values));
    for (keys, says) in [
        ("signal = \"angle\", times = [0, 1], values = [\"10 deg\"]", "as many as the times: 2, not 1"),
        ("signal = \"angle\", times = [0, 1, 1], values = [0, 1, 2]", "later than the previous time"),
        ("signal = \"angle\", times = [0, 1]", "the key values is missing"),
        (
            "signal = \"angle\", times = [0, 1], values = [0, 1], units = { angle = \"deg\" }",
            "it applies to a log file",
        ),
        ("signal = \"angle\", times = [0, 1], values = [0, 1], log = \"log.csv\"", "a log is either a file"),
        ("signal = \"angle\", log = \"log.csv\", values = [0, 1]", "the log is a file"),
    ] {
        let error = lists(keys).unwrap_err();
        assert!(format!("{error}").contains(says), "{keys}: {error}");
    }
    let both =
        plan("logged = { log = \"log.csv\", signal = \"angle\", sd = \"1 deg\" }\ncounted = { swings = 3 }");
    assert!(both.unwrap_err().message().contains("counted swings or a log"));
    fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn what_has_no_effect_on_swings_is_refused() {
    let spindle = r#"[swing]
mass = "2 kg"
center = [0, 0, 0]
gravity = "9.81 m/s^2"
[[swing.test]]
name = "spindle"
rig = "spindle"
axis = [0, 0, 1]
pivot = [0, 0, 0]
stiffness = "0.3 N m/rad"
air = { displaced = "1 g" }
counted = { swings = 20, time = "20.1 s", sd = "0.05 s", amplitude = "5 deg", amplitude_sd = "0.5 deg", damping = "none" }
"#;
    let error = read("displaced", spindle).unwrap_err();
    assert!(error.message().contains("the weight has no effect"), "{error}");
    let still = spindle.replace("air = { displaced = \"1 g\" }\n", "");
    let error = read("gravity", &still).unwrap_err();
    assert_eq!(error.place().unwrap().line, 4, "{error}");
    assert!(read("spindle", &still.replace("gravity = \"9.81 m/s^2\"\n", "")).is_ok());
    let error = read("air", &still.replace("axis =", "air = {}\naxis =")).unwrap_err();
    assert!(error.message().contains("moment is missing"), "{error}");
}
