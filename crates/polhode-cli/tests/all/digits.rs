//! Numbers have the digits that they have.

use crate::common::{Scratch, example};

/// A motion that has amplified its errors beyond all it says ends in words, not in zeros.
#[test]
fn what_has_no_right_digit_is_not_printed() {
    let text = std::fs::read_to_string(example("hyperion.toml")).unwrap();
    let line = text.lines().find(|line| line.starts_with("duration")).unwrap();
    let scratch = Scratch::new("no-digit");
    scratch.write("hyperion.toml", &text.replace(line, "duration = \"700 d\""));
    let run = scratch.run(&["simulate", "hyperion.toml", "--no-page"]);
    let printed = String::from_utf8(run.stdout).unwrap();
    assert!(run.status.success(), "{printed}");
    for value in ["ω at the end", "attitude at the end", "T at the end", "work done", "angles at the end"] {
        assert!(
            printed.contains(&format!("  {value:<19} no digit is right (estimate)")),
            "{value}: {printed}"
        );
    }
    for wrong in ["(0, 0, 0)", "0, 0, 0, 0", " 0 J"] {
        assert!(!printed.contains(wrong), "{wrong}: {printed}");
    }
}
