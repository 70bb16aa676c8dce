//! Text as programs write it: separators, comments, quotes, JSON lines, and large files.

use std::fs;
use std::path::Path;

use polhode::infer::judge::{OmegaAxes, QuaternionOrder};
use polhode_source::files::Disk;
use polhode_table::log as run_log;

use super::{angle, attitudes, omega, read, refused, table, time, told};

#[test]
fn separators_quotes_comments_and_line_ends() {
    let plain = read("t,qw,qx,qy,qz\n0,1,0,0,0\n0.5,0.8,-0.6,0,0\n");
    for text in [
        "t;qw;qx;qy;qz\r\n0;1;0;0;0\r\n0.5;0.8;-0.6;0;0",
        "\u{feff}t\tqw\tqx\tqy\tqz\n0\t1\t0\t0\t0\n0.5\t0.8\t-0.6\t0\t0\n\n",
        "  t  qw qx qy  qz\n 0.0 1 0 0 0 \n  5e-1 0.8 -6.0E-1 0 0\r\n",
        "# of a test\n\n\"t\" , \"qw\",qx,qy,qz\n0, 1 ,0,0,0\n# half a second\n\n\"0.5\",\" 0.8\",-.6,+0,0\n# end",
        "# t qw qx qy qz\n0 1 0 0 0\n0.5 0.8 -0.6 0 0\n",
        "#t,qw,qx,qy,qz\n0 1 0 0 0\n0.5 0.8 -0.6 0 0\n",
    ] {
        assert_eq!(read(text), plain, "{text}");
    }
    let labelled = read("t,\"a \"\"b\"\", c\",qw,qx,qy,qz,\n0,\"x, \"\"y\",1,0,0,0,\n0.5,,0.8,-0.6,0,0,z\n");
    assert_eq!(labelled.log, plain.log);
    assert_eq!(labelled.ignored, ["a \"b\", c"]);
}

#[test]
fn the_head_says_what_the_run_is() {
    let head = "# A run of the suite.\n# scenario = \"../t-handle.toml\"\n## step = 2 ms\n# engine = MuJoCo 3.3, RK4\n# seed = 7\n\
                # units = ms, deg/s\n# it took dt = 0.1\n";
    let log = read(format!("{head}t,qw,qx,qy,qz,wx,wy,wz\n0,1,0,0,0,90,0,0\n500,0.8,0.6,0,0,0,180,0\n"));
    assert_eq!(log.scenario.as_deref(), Some(Path::new("../t-handle.toml")));
    assert_eq!((log.step, log.engine.as_deref()), (Some(0.002), Some("MuJoCo 3.3, RK4")));
    assert_eq!(log.ignored_keys, ["seed"]);
    assert_eq!(log.log.times(), [0.0, 0.5]);
    assert_eq!(log.log.omega().unwrap()[1], [0.0, std::f64::consts::PI, 0.0]);
    for (line, message) in [
        ("# step = 0", "step = 0 must be positive"),
        ("# step = 3 kg", "step = 3 kg must be the engine's time step, in s"),
        ("# units = s, kg", "units = s, kg must be units of a motion, and \"kg\" is none"),
        (
            "# units = ms, deg, s",
            "units = ms, deg, s must be units of a motion, one of each kind, and \"ms\" is given besides",
        ),
        (
            "# units = SI, deg",
            "units = SI, deg must be units of a motion, one of each kind, and \"rad\" is given besides",
        ),
        ("# units = {bad", "units = {bad must be units of a motion, and \"{bad\" is none"),
        ("# scenario =", "scenario =  must be the path of a scenario"),
        ("# columns = q", "columns = q must be what columns are"),
    ] {
        let error = refused(format!("# a\n{line}\nt,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n"));
        assert!(error.message().starts_with(message), "{error}");
        assert_eq!(error.place().unwrap().line, 2);
    }
}

#[test]
fn json_lines_have_numbers_arrays_and_objects() {
    let own = attitudes(4);
    let rows = |row: &dyn Fn(usize) -> String| (0..4).map(|k| row(k) + "\n").collect::<String>();
    let list = |numbers: &[f64]| format!("{numbers:?}");
    let head = "{\"scenario\": \"a.toml\", \"step\": 0.001, \"engine\": \"Drake\", \"seed\": [1, 2]}\n\n";
    let arrays = read(rows(&|k| {
        format!("{{\"t\":{:?},\"q\":{},\"omega\":{}}}", time(k), list(&own[k].quaternion()), list(&omega(k)))
    }));
    let named = rows(&|k| {
        let [w, x, y, z] = own[k].quaternion();
        let [a, b, c] = omega(k);
        let note = if k == 2 { ",\"contact\": true" } else { "" };
        format!(
            "{{\"orientation\": {{\"x\":{x:?},\"y\":{y:?},\"z\":{z:?},\"w\":{w:?}}}, \"time\": {:?}, \"frame\": \"map\", \
             \"gyro\": {{\"x\": {a:?}, \"y\": {b:?}, \"z\": {c:?}}}{note}}}",
            time(k)
        )
    });
    let objects = read(format!("\u{feff}{head}{named}"));
    let matrices = read(rows(&|k| format!("{{\"t\":{:?},\"R\":{:?}}}", time(k), own[k].matrix())));
    assert_eq!(arrays.log, objects.log);
    for (k, attitude) in own.iter().enumerate() {
        assert_eq!(arrays.log.attitude()[k], attitude.quaternion());
        assert_eq!(arrays.log.omega().unwrap()[k], omega(k));
    }
    assert!(angle(&matrices) < 4e-16);
    assert_eq!((arrays.says.order, objects.says.order), (None, Some(QuaternionOrder::ScalarFirst)));
    assert_eq!((arrays.says.omega_axes, objects.says.omega_axes), (None, Some(OmegaAxes::Body)));
    assert_eq!((objects.scenario.as_deref(), objects.step), (Some(Path::new("a.toml")), Some(0.001)));
    assert_eq!(
        (objects.ignored, objects.ignored_keys),
        (vec!["frame".to_owned(), "contact".to_owned()], vec!["seed".to_owned()])
    );
    let said =
        told(rows(&|k| format!("{{\"n\":{k},\"a\":{}}}", list(&own[k].quaternion()))), "t = n, q wxyz = a")
            .unwrap();
    assert_eq!(said.log.attitude()[3], own[3].quaternion());
}

#[test]
fn a_large_file_is_read_as_a_small_one_is() {
    // Several blocks, each in parts. The last line has no line break.
    let rows = 200_000;
    let mut text = String::from("time_s,attitude_w,attitude_x,attitude_y,attitude_z,note\n");
    let number = |k: usize, j: usize| ((k * 7919 + j * 104_729) % 1_000_003) as f64 / 1_000_003.0 - 0.7;
    for k in 0..rows {
        let [w, x, y, z] = [1, 2, 3, 4].map(|j| number(k, j));
        text += &format!("{:?},{w:?},{x:?},{y:?},{z:?},{}\n", k as f64 * 1e-3, "n".repeat(k % 17));
    }
    let text = text.trim_end();
    assert!(text.len() > 2 * (8 << 20), "{}", text.len());
    let path = std::env::temp_dir().join(format!("polhode-run-log-{}.csv", std::process::id()));
    fs::write(&path, text).unwrap();
    let log = run_log::read(&Disk, &path, None).unwrap();
    assert_eq!(log, read(text));
    assert_eq!(log.log.times().len(), rows);
    for k in (0..rows).step_by(97) {
        assert_eq!(
            (log.log.times()[k], log.log.attitude()[k]),
            (k as f64 * 1e-3, [1, 2, 3, 4].map(|j| number(k, j)))
        );
    }
    // A time that goes back far into the file is reported at its place, and so is an invalid
    // number.
    for (row, wrong, message) in [
        (120_001, "119.5,1,0,0,0,", "the time of row 120001 = 119.5 s"),
        (149_000, "148.999,x,0,0,0,", "expected a number as attitude_w of row 149000"),
    ] {
        let mut lines: Vec<&str> = text.lines().collect();
        lines[row] = wrong;
        fs::write(&path, lines.join("\n")).unwrap();
        let error = run_log::read(&Disk, &path, None).unwrap_err();
        assert!(error.message().starts_with(message), "{error}");
        assert_eq!(error.place().unwrap().line, row + 1);
    }
    fs::remove_file(&path).unwrap();
    assert!(run_log::read(&Disk, &path, None).unwrap_err().message().contains("the file does not exist"));
    assert!(run_log::read(&Disk, &std::env::temp_dir(), None).unwrap_err().message().contains("directory"));
}

#[test]
fn rows_are_those_of_the_file() {
    let text = table("t,qw,qx,qy,qz", 7, |k, a| [time(k)].into_iter().chain(a.quaternion()).collect());
    assert_eq!(read(&text).log.times().len(), 7);
}
