//! Policies: configurations, comments, baselines.

use std::collections::BTreeSet;
use std::path::Path;

use polhode_robot::finding::Severity;
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect;
use polhode_robot::policy::baseline::{self, Baseline};
use polhode_robot::policy::config::Config;
use polhode_robot::policy::date::Date;
use polhode_robot::policy::{Judged, Policy, Reason};
use polhode_robot::read::{ReadOptions, read_text};

use crate::check_common::link;

const GOOD: [&str; 6] = ["0.0123", "0.0171", "0.0219", "-0.0011", "0.0007", "0.0013"];
const BAD: [&str; 6] = ["0.0123", "0.0171", "0.219", "-0.0011", "0.0007", "0.0013"];

fn name(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

fn judged(policy: &Policy, file: &str, text: &str) -> Judged {
    let model = read_text(text, Path::new(file), &ReadOptions::default()).unwrap();
    let findings = inspect(&model, &Shapes::default()).findings;
    policy.judge(name, &model, findings)
}

/// Returns a robot with two impossible links, joined.
fn robot(before_left: &str, in_right: &str) -> String {
    let right = link("right", "1.3", BAD).replace("<inertial>", &format!("{in_right}<inertial>"));
    format!(
        "<robot name=\"r\">\n{before_left}{}{right}<joint name=\"j\" type=\"fixed\"><parent link=\"left\"/><child link=\"right\"/></joint>\n\
         </robot>\n",
        link("left", "1.7", BAD)
    )
}

fn config(text: &str) -> Policy {
    let config = Config::read(Path::new("polhode.toml"), text).unwrap();
    Policy { config, baseline: None, today: Date::new(2026, 11, 25) }
}

fn codes(judged: &Judged) -> Vec<(&str, &str)> {
    judged.open.iter().map(|finding| (finding.code, finding.subject.as_str())).collect()
}

const BOTH: [(&str, &str); 2] = [("inertia.triangle", "left"), ("inertia.triangle", "right")];

#[test]
fn without_a_policy_everything_counts() {
    let judged = judged(&Policy::default(), "r.urdf", &robot("", ""));
    assert_eq!(codes(&judged), BOTH);
    assert_eq!((judged.ids.len(), judged.settled.len(), judged.off), (2, 0, 0));
}

#[test]
fn a_comment_allows_what_it_is_at() {
    let comment = "<!-- polhode: allow inertia.triangle:  measured,\n  twice -->\n";
    for (text, left) in [(robot(comment, ""), "right"), (robot("", comment), "left")] {
        let judged = judged(&Policy::default(), "r.urdf", &text);
        assert_eq!(codes(&judged), [("inertia.triangle", left)]);
        assert_eq!(judged.settled.len(), 1);
        assert_eq!(judged.settled[0].why, Reason::Allowed("measured, twice".to_owned()));
    }
    // Before the root element it applies to the whole file, even if another comment is between
    // them.
    let whole = format!("<?xml version=\"1.0\"?><!-- a -->{comment}<!-- b -->{}", robot("", ""));
    assert_eq!(codes(&judged(&Policy::default(), "r.urdf", &whole)), []);
    // A comment may be between it and the link.
    let text = robot(&format!("{comment}<!-- the left one -->\n"), "");
    assert_eq!(codes(&judged(&Policy::default(), "r.urdf", &text)), [BOTH[1]]);
}

#[test]
fn a_comment_of_no_use_is_a_finding() {
    for (comment, code, said) in [
        ("<!-- polhode: allow inertia.triangle -->", "allow.malformed", "the reason is missing"),
        ("<!-- polhode: allow inertia.triangle:   -->", "allow.malformed", "the reason is missing"),
        ("<!-- polhode: allow inertia.triangel: why -->", "allow.malformed", "did you mean inertia.triangle"),
        ("<!-- polhode: allow: why -->", "allow.malformed", "write polhode: allow RULE"),
        ("<!-- polhode: allow : why -->", "allow.malformed", "the rule is missing"),
        ("<!-- polhode: ignore -->", "allow.malformed", "cannot be read"),
        ("<!-- polhode: allow inertia.zero: why -->", "allow.unused", "no finding inertia.zero of left"),
    ] {
        let judged = judged(&Policy::default(), "r.urdf", &robot(comment, ""));
        let finding =
            judged.open.iter().find(|f| f.code == code).unwrap_or_else(|| panic!("{comment}: {judged:#?}"));
        assert!(finding.message.contains(said), "{comment}: {}", finding.message);
        assert_eq!(judged.open.len(), 3, "{comment}");
        if let Some((_, meant)) = finding.message.split_once("did you mean ") {
            let right = comment.replace("inertia.triangel", meant.trim_end_matches('?'));
            let judged = self::judged(&Policy::default(), "r.urdf", &robot(&right, ""));
            assert!(judged.open.iter().all(|f| f.code != code), "{right}: {judged:#?}");
        }
    }
    // Of several rules, the unused one is reported.
    let two = judged(
        &Policy::default(),
        "r.urdf",
        &robot("<!-- polhode: allow inertia.zero, inertia.triangle: why -->", ""),
    );
    assert_eq!(codes(&two), [("allow.unused", "left"), BOTH[1]]);
    assert_eq!(two.open[0].message, "no finding inertia.zero of left");
    // Outside of links it applies only to findings about the model. Other comments have no effect.
    let text = robot("", "")
        .replace("</robot>", "<!-- polhode: allow inertia.triangle: why --></robot><!-- Polhode -->");
    let none = judged(&Policy::default(), "r.urdf", &text);
    assert_eq!(codes(&none), [BOTH[0], BOTH[1], ("allow.unused", "")]);
}

#[test]
fn a_configuration_has_severities_and_allowances() {
    let text = robot("", "");
    let policy = config(
        "[check]\nfail_on = \"impossible\"\nexclude = [\"old/**\"]\n[check.rules]\n\"inertia.triangle\" = \"note\"\n\
         [[check.allow]]\nrule = \"inertia.triangle\"\nfile = \"robots/*.urdf\"\nlink = \"l*\"\nreason = \"measured\"\n",
    );
    assert_eq!(policy.config.fail_on, Some(Severity::Impossible));
    assert!(policy.config.exclude[0].matches("old/a/b.urdf"));
    let found = judged(&policy, "robots/r.urdf", &text);
    assert_eq!(codes(&found), [BOTH[1]]);
    assert_eq!(found.open[0].severity, Severity::Note);
    assert_eq!(found.settled[0].why, Reason::Allowed("measured".to_owned()));
    assert_eq!(codes(&judged(&policy, "other/r.urdf", &text)), BOTH);
    let off = judged(&config("[check.rules]\n\"inertia.triangle\" = \"off\"\n"), "r.urdf", &text);
    assert_eq!((off.open.len(), off.off), (0, 2));
}

fn remarks(policy: &Policy, judged: &[(&str, &Judged)]) -> Vec<(String, usize, String)> {
    let remarks = policy.remarks(judged.iter().copied(), |file| file == "here/there.urdf");
    remarks.into_iter().map(|r| (r.code.to_owned(), r.place.0, r.message)).collect()
}

#[test]
fn an_allowance_expires_and_one_of_no_use_is_said() {
    let allow = |rule: &str, file: &str, more: &str| {
        format!("[[check.allow]]\nrule = \"{rule}\"\nfile = \"{file}\"\nreason = \"measured\"\n{more}")
    };
    let text = robot("", "");
    // The allowance ends at the start of its expiry date.
    for (day, open) in [("2026-11-26", 0), ("2026-11-25", 2), ("2020-02-29", 2)] {
        let policy = config(&allow("inertia.triangle", "r.urdf", &format!("expires = {day}\n")));
        let found = judged(&policy, "r.urdf", &text);
        assert_eq!(found.open.len(), open, "{day}");
        let said = remarks(&policy, &[("r.urdf", &found)]);
        assert_eq!(said.len(), usize::from(open > 0), "{day}: {said:?}");
        assert!(
            said.iter()
                .all(|(code, line, message)| code == "allow.expired" && *line == 1 && message.contains(day))
        );
    }
    let found = judged(&Policy::default(), "r.urdf", &text);
    for (file, count) in
        [("r.urdf", 1), ("other.urdf", 0), ("here/there.urdf", 0), ("here/gone.urdf", 1), ("here/*.urdf", 0)]
    {
        let policy = config(&allow("inertia.zero", file, ""));
        let said = remarks(&policy, &[("r.urdf", &found)]);
        assert_eq!(said.len(), count, "{file}: {said:?}");
        assert!(said.iter().all(|(code, ..)| code == "allow.unused"));
    }
}

#[test]
fn a_group_is_allowed_if_all_of_it_is() {
    let base = link("base", "3", GOOD);
    let tip = |name: &str| {
        format!(
            "<link name=\"{name}\"><collision><geometry><box size=\"0.1 0.2 0.3\"/></geometry></collision></link>\n\
             <joint name=\"to_{name}\" type=\"fixed\"><parent link=\"base\"/><child link=\"{name}\"/></joint>\n"
        )
    };
    let text = format!("<robot name=\"r\">{base}{}{}</robot>", tip("left_tip"), tip("right_tip"));
    let allow = |link: &str| {
        let policy = config(&format!(
            "[[check.allow]]\nrule = \"mass.massless_collision\"\nfile = \"*\"\nreason = \"pads\"\nlink = \"{link}\"\n"
        ));
        judged(&policy, "r.urdf", &text).open.len()
    };
    assert_eq!((allow("*_tip"), allow("left_tip"), allow("right_tip")), (0, 1, 1));
    // Entries and comments together cover the finding, and each is used.
    let entry = |link: &str| {
        format!(
            "[[check.allow]]\nrule = \"mass.massless_collision\"\nfile = \"*\"\nreason = \"pad {link}\"\nlink = \"{link}\"\n"
        )
    };
    let both = config(&(entry("left_tip") + &entry("right_tip")));
    let found = judged(&both, "r.urdf", &text);
    assert_eq!((found.open.len(), found.settled.len()), (0, 1), "{found:#?}");
    assert_eq!(found.settled[0].why, Reason::Allowed("pad left_tip; pad right_tip".to_owned()));
    assert_eq!(remarks(&both, &[("r.urdf", &found)]), []);
    let comment = "<!-- polhode: allow mass.massless_collision: a pad -->";
    let commented = text.replace("<link name=\"right_tip\">", &format!("{comment}<link name=\"right_tip\">"));
    let found = judged(&config(&entry("left_tip")), "r.urdf", &commented);
    assert_eq!((found.open.len(), found.settled.len()), (0, 1), "{found:#?}");
    // One entry alone is not sufficient, and is reported as unused.
    let one = config(&entry("left_tip"));
    let found = judged(&one, "r.urdf", &text);
    let said = remarks(&one, &[("r.urdf", &found)]);
    assert_eq!((found.open.len(), said.len()), (1, 1));
    assert!(said[0].2.ends_with("the finding is also about right_tip, which is not allowed"), "{said:?}");
    // The same holds for three links, where an equal reason is stated once, and for a comment.
    let three = text.replace("</robot>", &(tip("third_tip") + "</robot>"));
    let two = config(&(entry("left_tip") + &entry("third_tip")));
    let found = judged(&two, "r.urdf", &three);
    let said = remarks(&two, &[("r.urdf", &found)]);
    assert_eq!((found.open.len(), said.len()), (1, 2));
    assert!(
        said.iter().all(|(.., message)| message.ends_with("about right_tip, which is not allowed")),
        "{said:?}"
    );
    let same = (entry("left_tip") + &entry("third_tip") + &entry("right_tip"))
        .replace("pad third_tip", "pad left_tip");
    let found = judged(&config(&same), "r.urdf", &three);
    let Reason::Allowed(reasons) = &found.settled[0].why else { panic!("{found:#?}") };
    assert_eq!(
        reasons.split("; ").collect::<BTreeSet<_>>(),
        BTreeSet::from(["pad left_tip", "pad right_tip"])
    );
    assert_eq!(reasons.matches("pad").count(), 2, "{reasons}");
    let found = judged(&Policy::default(), "r.urdf", &commented);
    let unused = found.open.iter().find(|finding| finding.code == "allow.unused").unwrap();
    let expected = "no finding mass.massless_collision of right_tip alone: the finding is also about left_tip, which is not allowed";
    assert_eq!(unused.message, expected);
}

#[test]
fn what_a_configuration_cannot_mean_is_refused_at_its_place() {
    for (text, place, said) in [
        ("[chek]\n", (1, 2), "did you mean check?"),
        ("[check]\nfailon = \"note\"\n", (2, 1), "did you mean fail_on?"),
        ("[check]\nfail_on = \"bad\"\n", (2, 11), "one of impossible, suspect, note"),
        ("[check]\nfail_on = \"off\"\n", (2, 11), "one of impossible, suspect, note"),
        ("[check]\nexclude = \"a\"\n", (2, 11), "a list of globs"),
        ("[check]\nexclude = [\"a[b]\"]\n", (2, 12), "a glob"),
        ("[check.rules]\n\"inertia.triangel\" = \"note\"\n", (2, 1), "did you mean inertia.triangle?"),
        ("[check.rules]\n\"inertia.triangle\" = \"warn\"\n", (2, 22), "off"),
        ("[[check.allow]]\nrule = \"inertia.zero\"\nfile = \"*\"\n", (1, 1), "reason"),
        (
            "[[check.allow]]\nrule = \"inertia.zero\"\nfile = \"*\"\nreason = \" \"\n",
            (4, 10),
            "a reason in words",
        ),
        (
            "[[check.allow]]\nrule = \"inertia.zero\"\nfile = \"*\"\nreason = \"a\"\nexpires = \"2027\"\n",
            (5, 11),
            "a date",
        ),
        (
            "[[check.allow]]\nrule = \"inertia.zero\"\nfile = \"*\"\nreason = \"a\"\nexpires = 2027-01-01T00:00:00\n",
            (5, 11),
            "a date",
        ),
        (
            "[[check.allow]]\nrule = \"inertia.zero\"\nfile = \"*\"\nreason = \"a\"\nlinks = \"b\"\n",
            (5, 1),
            "did you mean link?",
        ),
        ("[check\n", (1, 7), "TOML"),
    ] {
        let error = Config::read(Path::new("polhode.toml"), text).unwrap_err();
        let told = error.place().map(|place| (place.line, place.column));
        assert_eq!(told, Some(place), "{text}: {error}");
        let all = format!("{} {}", error.message(), error.hint().unwrap_or_default());
        assert!(all.contains(said), "{text}: {all}");
    }
    assert!(Config::read(Path::new("polhode.toml"), "").is_ok());
}

#[test]
fn a_baseline_knows_findings_wherever_they_move() {
    let policy = Policy::default();
    let first = judged(&policy, "r.urdf", &robot("", ""));
    let (text, count) = baseline::text([("r.urdf", &first)].into_iter());
    assert_eq!(count, 2);
    let known = Baseline::read(Path::new("known.json"), &text).unwrap();
    let policy = Policy { baseline: Some(known), ..Policy::default() };
    // Lines, numbers and the order of links change.
    let moved = robot("\n\n<!-- moved -->\n", "").replace("0.219", "0.319");
    let found = judged(&policy, "r.urdf", &moved);
    assert_eq!((found.open.len(), found.settled.len()), (0, 2));
    assert!(found.settled.iter().all(|settled| settled.why == Reason::Known));
    assert_eq!(remarks(&policy, &[("r.urdf", &found)]), []);
    // A different file, a different link, and an additional finding of the same kind.
    assert_eq!(judged(&policy, "other.urdf", &moved).open.len(), 2);
    let renamed = moved.replace("\"right\"", "\"hand\"");
    let found = judged(&policy, "r.urdf", &renamed);
    assert_eq!(codes(&found), [("inertia.triangle", "hand")]);
    let gone = remarks(&policy, &[("r.urdf", &found)]);
    assert_eq!(gone.len(), 1, "{gone:?}");
    assert!(
        gone[0].0 == "baseline.gone" && gone[0].2.contains("inertia.triangle of right in r.urdf"),
        "{gone:?}"
    );
    // A finding in a file that was not checked is not reported as gone, unless the file is gone.
    assert_eq!(remarks(&policy, &[]).len(), 2);
    let first = judged(&Policy::default(), "here/there.urdf", &robot("", ""));
    let there = baseline::text([("here/there.urdf", &first)].into_iter()).0;
    let policy =
        Policy { baseline: Some(Baseline::read(Path::new("b"), &there).unwrap()), ..Policy::default() };
    assert_eq!(remarks(&policy, &[]), []);
    // Writing the baseline again gives the same text, for open and known findings.
    let found = judged(&policy, "here/there.urdf", &robot("", ""));
    assert_eq!(baseline::text([("here/there.urdf", &found)].into_iter()).0, there);
}

#[test]
fn ids_of_the_same_rule_and_link_differ() {
    let text = "<robot name=\"r\"><link name=\"a\"><inertial><mass value=\"1,5\"/>\
                <inertia ixx=\"x\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link></robot>";
    let found = judged(&Policy::default(), "r.urdf", text);
    let ids: BTreeSet<&String> = found.ids.iter().collect();
    assert!(found.open.len() >= 2 && ids.len() == found.open.len(), "{found:#?}");
    assert!(ids.iter().all(|id| id.len() == 16));
}

#[test]
fn what_is_no_baseline_is_refused() {
    for (text, said) in [
        ("", "JSON"),
        ("{\n  \"polhode_baseline\": 1,\n", "JSON"),
        ("{}", "polhode_baseline"),
        ("{\"polhode_baseline\": 2, \"findings\": []}", "polhode_baseline"),
        ("{\"polhode_baseline\": 1}", "findings"),
        ("{\"polhode_baseline\": 1, \"findings\": [{\"id\": 3}]}", "a finding with"),
    ] {
        let error = Baseline::read(Path::new("known.json"), text).unwrap_err();
        assert!(error.message().contains(said), "{text}: {error}");
    }
}

#[test]
fn the_configuration_of_the_book_is_one() {
    let page = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/check-ci.md"))
        .unwrap();
    let page = page.replace("\r\n", "\n");
    let (_, rest) = page.split_once("```toml\n").unwrap();
    let policy = config(rest.split_once("\n```").unwrap().0);
    assert_eq!(policy.config.fail_on, Some(Severity::Impossible));
    assert_eq!((policy.config.exclude.len(), policy.config.allowances.len()), (2, 1));
    assert!(policy.config.allowances[0].expires.is_some());
}

#[test]
fn a_finding_about_several_links_is_allowed_if_all_of_them_are() {
    let comment = "<!-- polhode: allow inertia.triangle: measured -->\n";
    for (text, is_open) in
        [(robot(comment, ""), true), (robot("", comment), true), (robot(comment, comment), false)]
    {
        let model = read_text(&text, Path::new("r.urdf"), &ReadOptions::default()).unwrap();
        let mut findings = inspect(&model, &Shapes::default()).findings;
        findings.truncate(1);
        findings[0].others = vec!["right".to_owned()];
        let judged = Policy::default().judge(name, &model, findings);
        let told = judged.open.iter().filter(|finding| finding.code == "inertia.triangle").count();
        assert_eq!((told, judged.settled.len()), (usize::from(is_open), usize::from(!is_open)));
        assert_eq!(judged.open.iter().any(|finding| finding.code == "allow.unused"), is_open);
    }
}

#[test]
fn what_is_worse_or_of_further_links_is_not_what_was_known() {
    let text = robot("", "");
    let model = read_text(&text, Path::new("r.urdf"), &ReadOptions::default()).unwrap();
    let finding = inspect(&model, &Shapes::default()).findings.remove(0);
    let id = |severity: Severity, others: &[&str]| {
        let mut finding = finding.clone();
        finding.severity = severity;
        finding.others = others.iter().map(|name| (*name).to_owned()).collect();
        Policy::default().judge(name, &model, vec![finding]).ids.remove(0)
    };
    let ids = [
        id(Severity::Suspect, &[]),
        id(Severity::Impossible, &[]),
        id(Severity::Suspect, &["right"]),
        id(Severity::Suspect, &["right", "more"]),
    ];
    assert_eq!(BTreeSet::from(ids.clone()).len(), ids.len());
    assert_eq!(id(Severity::Suspect, &["right"]), ids[2]);
}
