//! `polhode check --fix`: first the diff, for patch and git, then the fixed model.

use std::fs;
use std::io::Write as _;
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::common::{Scratch, example, refused};

/// Model with two links far apart, each with a decimal comma, and a third whose tensor has no fix.
fn robot(end: &str) -> String {
    let link = |name: &str, mass: &str, izz: &str| {
        format!(
            "  <link name=\"{name}\">\n    <inertial>\n      <mass value=\"{mass}\"/>\n      <inertia ixx=\"0.05\" ixy=\"0.004\" ixz=\"0\" iyy=\"0.06\" iyz=\"0\" izz=\"{izz}\"/>\n    </inertial>\n  </link>\n"
        )
    };
    let links = link("a½", "1,7", "0.053") + &link("b", "2.5", "0.053") + &link("c", "0,9", "0,071");
    format!("<robot name=\"r\">\n{links}</robot>{end}")
}

fn mended(text: &str) -> String {
    text.replace("\"1,7\"", "\"1.7\"").replace("\"0,9\"", "\"0.9\"").replace("\"0,071\"", "\"0.071\"")
}

/// Returns the diff of `--fix`; the exit status is 1, because the model has findings.
fn diff(scratch: &Scratch, arguments: &[&str]) -> String {
    let output = scratch.run(&[&["check"], arguments, &["--fix"]].concat());
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// Applies a unified diff to a text, according to the definition of the format.
fn applied(old: &str, diff: &str) -> String {
    let lines: Vec<&str> = old.split_inclusive('\n').collect();
    let (mut new, mut at) = (String::new(), 0);
    let mut rest = diff.split_inclusive('\n').skip_while(|line| !line.starts_with("@@ ")).peekable();
    while let Some(head) = rest.next() {
        let range = head.strip_prefix("@@ -").unwrap().split([' ', ',']).next().unwrap();
        let start = range.parse::<usize>().unwrap() - 1;
        new += &lines[at..start].concat();
        at = start;
        while let Some(line) = rest.next_if(|line| !line.starts_with("@@ ")) {
            let (mark, body) = line.split_at(1);
            let bare = rest.next_if(|next| next.starts_with('\\')).is_some();
            let body = if bare { body.strip_suffix('\n').unwrap() } else { body };
            if mark != "+" {
                assert_eq!(lines[at], body);
                at += 1;
            }
            if mark != "-" {
                new += body;
            }
        }
    }
    new + &lines[at..].concat()
}

/// Runs a program with this input, if it is installed; returns true on success.
fn fed(scratch: &Scratch, program: &str, arguments: &[&str], input: &str) -> bool {
    let mut command = Command::new(program);
    command.args(arguments).current_dir(&scratch.0).stdin(Stdio::piped()).stdout(Stdio::null());
    let Ok(mut child) = command.spawn() else { return false };
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    assert!(child.wait().unwrap().success(), "{program} {arguments:?}\n{input}");
    true
}

#[test]
fn the_diff_makes_the_model_that_is_written() {
    let scratch = Scratch::new("fix-diff");
    for (name, text) in [
        ("lines.urdf", robot("\n")),
        ("bare.urdf", robot("")),
        ("crlf.urdf", robot("\n").replace('\n', "\r\n")),
        ("crlf bare.urdf", format!("\u{feff}{}", robot("").replace('\n', "\r\n"))),
        ("one line.urdf", robot("").replace('\n', " ")),
        ("classic.urdf", robot("\n").replace('\n', "\r")),
    ] {
        let write = || scratch.write(name, &text);
        write();
        let diff = diff(&scratch, &[name]);
        // Nothing is written yet.
        assert_eq!(fs::read_to_string(scratch.0.join(name)).unwrap(), text);
        assert_eq!(applied(&text, &diff), mended(&text), "{name}");
        let read = || fs::read_to_string(scratch.0.join(name)).unwrap();
        if fed(&scratch, "patch", &["-p1", "--binary", "--quiet"], &diff) {
            assert_eq!(read(), mended(&text), "patch, {name}");
        }
        write();
        if fed(&scratch, "git", &["apply", "--whitespace=nowarn", "-"], &diff) {
            assert_eq!(read(), mended(&text), "git, {name}");
        }
        write();
        scratch.run(&["check", name, "--fix", "fixed.urdf", "--force"]);
        assert_eq!(fs::read_to_string(scratch.0.join("fixed.urdf")).unwrap(), mended(&text), "{name}");
    }
}

#[test]
fn each_change_is_proved_in_a_line() {
    let scratch = Scratch::new("fix-proof");
    scratch.write("r.urdf", &robot("\n"));
    let text = diff(&scratch, &["r.urdf"]);
    let lines: Vec<&str> = text.lines().collect();
    let proofs: Vec<&str> = lines.iter().copied().take_while(|line| line.starts_with("# ")).collect();
    assert_eq!(proofs.len(), 3, "{text}");
    assert!(proofs[0].starts_with("# r.urdf:4: a½ [number.malformed]: "), "{text}");
    assert!(proofs[0].contains("1,7") && proofs[0].contains("; rule: "), "{text}");
    assert_eq!(lines[3..5], ["--- a/r.urdf", "+++ b/r.urdf"]);
    // Two changes of one link share a hunk; changes far apart have separate hunks.
    let heads: Vec<&str> = lines.iter().copied().filter(|line| line.starts_with("@@")).collect();
    assert_eq!(heads, ["@@ -1,7 +1,7 @@", "@@ -13,8 +13,8 @@"], "{text}");
    assert_eq!(lines.iter().filter(|line| line.starts_with("+ ")).count(), 3);

    // The proof of a tensor's fix contains its numbers.
    let bad = diff(&scratch, &[&example("robots/bad-arm.urdf")]);
    let tensor = bad.lines().find(|line| line.contains("[inertia.")).unwrap();
    assert!(tensor.starts_with("# ") && tensor.contains("kg·m²") && tensor.contains("; rule: "), "{bad}");
}

#[test]
fn several_models_are_one_diff() {
    let scratch = Scratch::new("fix-several");
    fs::create_dir_all(scratch.0.join("src/in ner")).unwrap();
    let (one, two) = (robot("\n"), robot(""));
    scratch.write("src/one.urdf", &one);
    scratch.write("src/in ner/two.urdf", &two);
    scratch.write("src/good.urdf", &mended(&one));
    let diff = diff(&scratch, &["src"]);
    assert_eq!(diff.lines().filter(|line| line.starts_with("--- a/src/")).count(), 2);
    if fed(&scratch, "git", &["apply", "-"], &diff) {
        assert_eq!(fs::read_to_string(scratch.0.join("src/one.urdf")).unwrap(), mended(&one));
        assert_eq!(fs::read_to_string(scratch.0.join("src/in ner/two.urdf")).unwrap(), mended(&two));
        // No fixes remain; the remaining finding is that no joint connects the links.
        let again = scratch.run(&["check", "src", "--fix"]);
        assert_eq!((again.status.code(), again.stdout.as_slice()), (Some(1), b"".as_slice()));
    }
}

#[test]
fn the_diff_comes_before_the_model_is_written() {
    let scratch = Scratch::new("fix-first");
    scratch.write("r.urdf", &robot("\n"));
    let text = String::from_utf8(scratch.run(&["check", "r.urdf", "--fix", "out.urdf"]).stdout).unwrap();
    let at = |words: &str| text.find(words).unwrap_or_else(|| panic!("no {words:?} in\n{text}"));
    assert!(at("# r.urdf:4:") < at("--- a/r.urdf") && at("--- a/r.urdf") < at("findings"), "{text}");
    assert!(at("findings") < at("wrote out.urdf: 3 values corrected"), "{text}");
    // A results file contains the same, written completely or not at all.
    scratch.run(&["check", "r.urdf", "--fix", "out.urdf", "--force", "--output", "said.txt"]);
    let said = fs::read_to_string(scratch.0.join("said.txt")).unwrap();
    assert_eq!(said, text);
    // Without an output file only the diff is printed.
    scratch.run(&["check", "r.urdf", "--fix", "--output", "r.diff"]);
    assert_eq!(fs::read_to_string(scratch.0.join("r.diff")).unwrap(), diff(&scratch, &["r.urdf"]));
    let report: Value =
        serde_json::from_slice(&scratch.run(&["check", "r.urdf", "--json", "--fix"]).stdout).unwrap();
    assert_eq!(report["fix"]["out"], Value::Null);
    assert_eq!(report["fix"]["diff"], diff(&scratch, &["r.urdf"]));
    assert_eq!(report["fix"]["changes"], 3);
    // If the diff cannot be printed, nothing is written.
    #[cfg(target_os = "linux")]
    {
        let full = fs::File::options().write(true).open("/dev/full").unwrap();
        let mut command = scratch.command(&["check", "r.urdf", "--fix", "never.urdf"]);
        assert_eq!(command.stdout(full).output().unwrap().status.code(), Some(2));
        assert!(!scratch.entries().contains(&"never.urdf".to_owned()));
    }
}

#[test]
fn what_a_diff_leaves_out_is_said() {
    let scratch = Scratch::new("fix-left");
    let body = "<body name='a'><inertial pos='0 0 0' mass='1,5' diaginertia='1 1 1'/></body>";
    scratch.write("part.xml", &format!("<mujocoinclude>{body}</mujocoinclude>"));
    scratch.write("m.xml", "<mujoco><worldbody><include file='part.xml'/></worldbody></mujoco>");
    let output = scratch.run(&["check", "m.xml", "--fix"]);
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.stdout, b"");
    assert!(said.contains("m.xml") && said.contains("it is in an included file"), "{said}");
    // The included file itself can be fixed.
    assert!(diff(&scratch, &["part.xml"]).contains("+++ b/part.xml"));
}

#[test]
fn a_fix_without_a_file_writes_nothing() {
    let scratch = Scratch::new("fix-refused");
    scratch.write("r.urdf", &robot("\n"));
    let run = |flags: &[&str]| refused(&scratch.run(&[&["check"], flags].concat()), 2);
    let text = run(&["--fix", "r.urdf"]);
    assert!(text.contains("no model is named") && text.contains("polhode check r.urdf --fix"), "{text}");
    assert!(run(&["r.urdf", "--force", "--fix"]).contains("--force"));
    assert!(run(&["r.urdf", "--table", "--fix"]).contains("--table"));
    assert!(run(&["r.urdf", "--format", "sarif", "--fix"]).contains("--format"));
    assert_eq!(scratch.entries(), ["r.urdf"]);
    // A name with characters that end a header line.
    fs::create_dir(scratch.0.join("in")).unwrap();
    let odd = "in/q\"uo\te.urdf";
    scratch.write(odd, &robot("\n"));
    let quoted = diff(&scratch, &[odd]);
    assert!(quoted.contains("--- \"a/in/q\\\"uo\\011e.urdf\"\n"), "{quoted}");
    if fed(&scratch, "git", &["apply", "-"], &quoted) {
        assert_eq!(fs::read_to_string(scratch.0.join(odd)).unwrap(), mended(&robot("\n")));
    }
}
