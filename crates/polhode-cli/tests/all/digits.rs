//! Numbers are printed only with their correct digits.

use crate::common::{Scratch, example};

/// Runs an example for longer, and returns what it prints.
fn printed(name: &str, duration: &str) -> String {
    let text = std::fs::read_to_string(example(name)).unwrap();
    let line = text.lines().find(|line| line.starts_with("duration")).unwrap();
    let scratch = Scratch::new("no-digit");
    scratch.write(name, &text.replace(line, &format!("duration = \"{duration}\"")));
    let run = scratch.run(&["simulate", name, "--no-page"]);
    let printed = String::from_utf8(run.stdout).unwrap();
    assert!(run.status.success(), "{printed}");
    printed
}

/// A motion that has amplified its errors to the size of its values ends in words, not in zeros.
#[test]
fn a_value_without_a_right_digit_is_not_printed() {
    let tumbling: &[&str] = &["ω", "attitude", "T", "work done", "angles"];
    let on_ground: &[&str] = &["ω", "attitude", "T", "U", "centre", "force"];
    for (name, duration, values) in
        [("hyperion.toml", "700 d", tumbling), ("rattleback.toml", "300 s", on_ground)]
    {
        let printed = printed(name, duration);
        for value in values {
            let label =
                if *value == "work done" { (*value).to_owned() } else { format!("{value} at the end") };
            let line = format!("  {label:<19} no digit is right (estimate)");
            assert!(printed.contains(&line), "{name}, {value}: {printed}");
        }
        for wrong in ["(0, 0, 0)", "0, 0, 0, 0", " 0 J", "the centre of mass rises"] {
            assert!(!printed.contains(wrong), "{name}, {wrong}: {printed}");
        }
    }
}
