//! Small inputs that request excessive work: refused with the number, in bounded time and memory.
#![cfg(unix)]

use std::process::{Command, Output};

use crate::common::{Scratch, json, refused};

const BODY: &str = r#"
[[body.part]]
shape = "tensor"
mass = "3.2 kg"
inertia = [[1.1, 0.13, -0.21], [0.13, 1.7, 0.08], [-0.21, 0.08, 2.3]]
[start]
spin = { body = [0.4, 2.1, -0.3] }
"#;

/// Runs polhode with limits of 1 GiB of address space and 20 s of processor time.
fn bounded(scratch: &Scratch, arguments: &[&str]) -> Output {
    let mut command = Command::new("sh");
    command.args(["-c", "ulimit -v 1048576; ulimit -t 20; exec \"$0\" \"$@\""]);
    command.arg(env!("CARGO_BIN_EXE_polhode")).args(arguments);
    command.current_dir(&scratch.0).output().unwrap()
}

fn with_torque(pulses: &str, duration: &str) -> String {
    format!(
        "{BODY}[[torque]]\nmodel = \"constant\"\naxes = \"body\"\ntorque = [0.1, 0, 0.02]\n\
         pulses = {pulses}\n[run]\nduration = \"{duration}\"\nsamples = 11\n"
    )
}

#[test]
fn pulses_are_counted_before_they_are_waited_for() {
    let scratch = Scratch::new("pulses");
    for (name, pulses, duration, count) in [
        ("dense.toml", "{ first = 0, width = \"1e-20 s\", period = \"2e-20 s\" }", "1 s", "5.000e19"),
        ("long.toml", "{ first = 0, width = \"1 s\", period = \"3 s\" }", "1e12 s", "3.333e11"),
        (
            "count.toml",
            "{ first = 0, width = \"1 us\", period = \"3 us\", count = 200_000_000 }",
            "1 d",
            "2.000e8",
        ),
    ] {
        scratch.write(name, &with_torque(pulses, duration));
        for command in ["simulate", "explain"] {
            let text = refused(&bounded(&scratch, &[command, name]), 2);
            assert!(
                text.contains(&format!("{count} pulses"))
                    && text.contains("more than the limit of 100000000"),
                "{text}"
            );
            assert!(text.contains(&format!("{name}:12:")) && text.contains("hint: "), "{text}");
        }
    }
    assert_eq!(scratch.entries(), ["count.toml", "dense.toml", "long.toml"]);
    // A member of a sweep reports it in its row.
    let sweep = "[sweep]\nmembers = 40\nsampling = \"sobol\"\n[[sweep.vary]]\nkey = \"start.spin.body[0]\"\nuniform = { from = 0, to = 1 }\n";
    let dense = with_torque("{ first = 0, width = \"1e-20 s\", period = \"2e-20 s\" }", "1 s");
    scratch.write("sweep.toml", &format!("{dense}{sweep}"));
    let value = json(&bounded(&scratch, &["sweep", "sweep.toml", "--json"]));
    assert_eq!(value["status"]["failed"]["count"], 40);
    // Few pulses, and dense ones only in a switched-off torque.
    scratch.write("few.toml", &with_torque("{ first = 0, width = \"1 s\", period = \"3 s\" }", "9 s"));
    crate::common::stdout(&bounded(&scratch, &["simulate", "few.toml"]));
    scratch.write("off.toml", &dense.replace("model =", "name = \"a\"\non = false\nmodel ="));
    crate::common::stdout(&bounded(&scratch, &["simulate", "off.toml"]));
}

#[test]
fn events_and_steps_are_counted_too() {
    let scratch = Scratch::new("events");
    let event = "[[event]]\nmeasure = \"omega_body_x\"\nvalue = \"0.1 rad/s\"\n";
    let free = |duration: &str| format!("{BODY}{event}[run]\nduration = \"{duration}\"\nsamples = 3\n");
    let torque = "[[torque]]\nmodel = \"constant\"\naxes = \"body\"\ntorque = [1e-9, 0, 0]\n";
    let run = "[run]\nduration = \"1e12 s\"\nsamples = 3\n";
    scratch.write("free.toml", &free("1e12 s"));
    scratch.write("forced.toml", &format!("{BODY}{torque}{event}{run}"));
    scratch.write("steps.toml", &format!("{BODY}{torque}{run}"));
    scratch.write("split.toml", &format!("{BODY}{run}method = \"splitting\"\nstep = \"1 us\"\n"));
    for name in ["free", "forced", "steps", "split"] {
        let file = format!("{name}.toml");
        let output = bounded(&scratch, &["simulate", &file, "--no-page"]);
        let text = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(3), "{name}: {text}");
        assert!(text.contains("more than 100000000 steps") && text.contains("hint: "), "{name}: {text}");
    }
    // A long run with a stopping event is computed.
    let stop = "[[event]]\nmeasure = \"time\"\nvalue = \"3000 s\"\nthen = \"stop\"\n";
    scratch.write("stop.toml", &free("1e12 s").replace("[run]", &format!("{stop}[run]")));
    let value = json(&bounded(&scratch, &["simulate", "stop.toml", "--no-page", "--json"]));
    assert_eq!(value["complete"], true);
}

#[test]
fn what_is_asked_of_a_formula_a_list_or_a_sweep_is_bounded() {
    let scratch = Scratch::new("bounds");
    let form = |formula: &str| {
        format!(
            "{BODY}[[torque]]\nmodel = \"formula\"\naxes = \"body\"\ntorque = [\"{formula}\", \"0\", \"0\"]\n[run]\nduration = 1\n"
        )
    };
    let deep = |open: &str, close: &str| open.repeat(100_000) + "1[N m]" + &close.repeat(100_000);
    let run = |more: &str| format!("{BODY}[run]\n{more}\n");
    let sweep = |law: &str| {
        format!(
            "{BODY}[run]\nduration = 1\n[sweep]\nsampling = \"grid\"\n[[sweep.vary]]\nkey = \"start.spin.body[0]\"\n{law}\n"
        )
    };
    for (name, text, says) in [
        ("parens.toml", form(&deep("(", ")")), "4096 characters"),
        ("minus.toml", form(&deep("-", "")), "4096 characters"),
        ("power.toml", form(&deep("2^", "")), "4096 characters"),
        ("array.toml", format!("{BODY}x = {}{}\n", "[".repeat(100_000), "]".repeat(100_000)), "recurs"),
        ("samples.toml", run("duration = 1\nsamples = 4_000_000_000"), "10000000 samples"),
        ("every.toml", run("duration = 1\nevery = 1e-12"), "10000000 samples"),
        ("range.toml", sweep("grid = { from = 0, to = 1, count = 4_000_000_000 }"), "1000000"),
    ] {
        scratch.write(name, &text);
        let text =
            refused(&bounded(&scratch, &[if name == "range.toml" { "sweep" } else { "simulate" }, name]), 2);
        assert!(text.contains(says) && text.contains(name), "{name}: {text}");
    }
    // Nested parentheses use no stack.
    scratch.write("nested.toml", &form(&("(".repeat(2000) + "1[N m]" + &")".repeat(2000))));
    crate::common::stdout(&bounded(&scratch, &["simulate", "nested.toml", "--no-page"]));
    for run in [
        &["--duration", "1 s", "--every", "1e-12 s"][..],
        &["--duration", "1e12 s", "--curves"],
        &["--duration", "1 s", "--samples", "4000000000"],
    ] {
        refused(
            &bounded(&scratch, &[&["spin", "--moments", "1,2,3", "--omega", "0.1,1,0.2"], run].concat()),
            2,
        );
    }
}

#[test]
fn many_lists_are_counted_together_and_threads_are_no_more_than_parts() {
    let scratch = Scratch::new("lists");
    let count = 40;
    let mut plan = "[start]\nspin = { body = [0.4, 2.1, -0.3] }\n[run]\nduration = 1\n".to_owned();
    for k in 0..count {
        plan += &format!(
            "[[body.part]]\nshape = \"sphere\"\nradius = 1\nmass = 1\nposition = [{k}, {}, 0]\n",
            k * k
        );
    }
    let sweep = |values: u32| {
        let vary = |k| {
            format!(
                "[[sweep.vary]]\nkey = 'body.part[{k}].mass'\ngrid = {{ from = 1, to = 2, count = {values} }}\n"
            )
        };
        let lists: String = (0..count).map(vary).collect();
        format!("{plan}[sweep]\nmembers = 3\nsampling = \"monte carlo\"\n{lists}")
    };
    scratch.write("many.toml", &sweep(1_000_000));
    let text = refused(&bounded(&scratch, &["sweep", "many.toml"]), 2);
    assert!(text.contains("up to 10000000 values in all") && text.contains("many.toml:"), "{text}");
    scratch.write("few.toml", &sweep(10));
    crate::common::stdout(&bounded(&scratch, &["sweep", "few.toml", "--threads", "4000000000"]));
}
