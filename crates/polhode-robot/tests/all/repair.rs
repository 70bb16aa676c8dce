//! Repairs apply their edits and change nothing else.

use std::convert::Infallible;

use polhode_robot::finding::{Finding, Repair, Severity};
use polhode_robot::model::{ModelFormat, RobotModel};
use polhode_robot::repair::{Left, LeftReason, proved, repaired};

/// Text with a byte order mark, both kinds of line ends, trailing spaces, a comment with the same
/// number, and µ.
const TEXT: &str =
    "\u{feff}<robot>\r\n<!-- 0,5 µ -->  \n\t<mass value='0,5'/><mass value=\"1kg\"/>\r\n</robot>\n\n";

fn model() -> RobotModel {
    RobotModel {
        path: "robot.urdf".into(),
        folder: None,
        format: ModelFormat::Urdf,
        text: TEXT.to_owned(),
        is_si: true,
        is_editable: true,
        included: Vec::new(),
        expansion: None,
        name: None,
        links: Vec::new(),
        joints: Vec::new(),
        unread_bodies: Vec::new(),
        notes: Vec::new(),
    }
}

fn finding(code: &'static str, edits: Vec<(std::ops::Range<usize>, &str)>) -> Finding {
    let edits = edits.into_iter().map(|(span, new)| (span, new.to_owned())).collect();
    Finding {
        code,
        others: Vec::new(),
        severity: Severity::Impossible,
        subject: "link".to_owned(),
        span: 0..0,
        message: String::new(),
        rule: String::new(),
        numbers: Vec::new(),
        repair: Some(Repair { description: String::new(), edits }),
        nearest: None,
        related: None,
    }
}

/// Returns the byte range of the last occurrence of a text.
fn span(what: &str) -> std::ops::Range<usize> {
    let start = TEXT.rfind(what).unwrap();
    start..start + what.len()
}

#[test]
fn every_other_byte_is_kept() {
    // The second edit comes first in the text.
    let findings = [finding("a", vec![(span("1kg"), "1"), (span("0,5"), "0.5")])];
    let result = repaired(&model(), &findings);
    assert_eq!(result.text, TEXT.replace("'0,5'", "'0.5'").replace("1kg", "1"));
    assert_eq!((result.applied.as_slice(), result.changes), ([0].as_slice(), 2));
    assert!(result.left.is_empty());
    // Without a repair the text is unchanged.
    let nothing = Finding { repair: None, ..findings[0].clone() };
    assert_eq!(repaired(&model(), &[nothing]).text, TEXT);
}

#[test]
fn of_two_repairs_of_one_place_the_second_is_left_whole() {
    let (comma, unit) = (span("0,5"), span("1kg"));
    let findings = [
        finding("a", vec![(comma.clone(), "0.5")]),
        finding("b", vec![(unit.clone(), "1"), (comma.start..comma.end - 1, "7")]),
        finding("c", vec![(comma.clone(), "0.5")]), // the same edit again
        finding("d", vec![(comma.start + 1..comma.start + 1, "9")]), // within the first
        finding("e", vec![(unit.end - 2..unit.end, "")]),
    ];
    let result = repaired(&model(), &findings);
    assert_eq!(result.text, TEXT.replace("'0,5'", "'0.5'").replace("1kg", "1"));
    assert_eq!(result.applied, [0, 2, 4]);
    let left = |finding| Left { finding, why: LeftReason::Overlaps };
    assert_eq!(result.left, [left(1), left(3)]);
    // Adjacent edits do not overlap: an insertion before, and one after.
    let around = [
        finding("a", vec![(comma.clone(), "0.5")]),
        finding("b", vec![(comma.end..comma.end, "!"), (comma.start..comma.start, "+")]),
    ];
    assert!(repaired(&model(), &around).text.contains("'+0.5!'"));
    // The order of two insertions at one place is undefined.
    let twice = [finding("a", vec![(7..7, "x")]), finding("b", vec![(7..7, "y")])];
    assert_eq!(repaired(&model(), &twice).left, [left(1)]);
}

#[test]
fn edits_that_do_not_fit_are_left() {
    let micro = span("µ");
    #[expect(clippy::reversed_empty_ranges, reason = "that is what does not fit")]
    let wrong = [
        vec![(TEXT.len()..TEXT.len() + 1, "x")],
        vec![(5..4, "x")],
        vec![(micro.start + 1..micro.end, "x")],
        vec![(9..12, "x"), (11..14, "y")],
    ];
    for edits in wrong {
        let result = repaired(&model(), &[finding("a", edits)]);
        assert_eq!(result.text, TEXT);
        assert_eq!(result.left, [Left { finding: 0, why: LeftReason::Misplaced }]);
    }
}

#[test]
fn only_repairs_that_remove_their_finding_are_made() {
    let findings = [
        finding("comma", vec![(span("0,5"), "0.5")]),
        finding("unit", vec![(span("1kg"), "1 kg")]), // does not remove the finding
    ];
    let mut calls = 0;
    // A checker that still reports the unit for every "kg".
    let result = proved(&model(), &findings, |text| {
        calls += 1;
        let mut found = Vec::new();
        if text.contains("'0,5'") {
            found.push(findings[0].clone());
        }
        if text.contains("kg") {
            found.push(findings[1].clone());
        }
        Ok::<_, Infallible>(found)
    });
    let (result, remaining) = result.unwrap();
    assert_eq!(remaining, findings[1..]);
    assert_eq!(result.text, TEXT.replace("'0,5'", "'0.5'"));
    assert_eq!(result.left, [Left { finding: 1, why: LeftReason::Fails }]);
    assert_eq!(calls, 2);
    // An error of the checker is passed on.
    assert_eq!(proved(&model(), &findings, |_| Err("unreadable")), Err("unreadable"));
}
