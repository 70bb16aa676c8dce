//! Findings about expanded xacro files, traced to their macros. The expansions are as those of
//! xacro 2.1.1.

use polhode_document::Report as _;
use polhode_robot::{Checked, Format, REPORT_SCHEMA, Request, compare, run};
use polhode_source::files::{Memory, Overlay};
use serde_json::Value;

use crate::common::schema::require_fits;

/// File with a literal link, a macro with a prefix, and an inclusion; the names of the joints are
/// literal, in the macro or in the file.
const ARM: &str = r#"<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find arm)/parts/hand.xacro"/>
  <xacro:property name="m" value="1.7"/>
  <link name="base">
    <inertial>
      <mass value="${m}"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1"
        iyz="0" izz="3"/>
    </inertial>
  </link>
  <xacro:macro name="upper" params="side">
    <link name="${side}_upper">
      <xacro:inertial mass="2"/>
    </link>
    <joint name="${side}_shoulder" type="fixed">
      <parent link="base"/>
      <child link="${side}_upper"/>
    </joint>
  </xacro:macro>
  <xacro:upper side="left"/>
  <xacro:hand side="left"/>
</robot>
"#;

const HAND: &str = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="hand" params="side">
    <link name="${side}_hand">
      <inertial>
        <mass value="0.3"/>
        <inertia ixx="${0.001*2}" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="-0.01"/>
      </inertial>
    </link>
    <joint name="${side}_wrist" type="fixed">
      <parent link="${side}_upper"/>
      <child link="${side}_hand"/>
    </joint>
  </xacro:macro>
</robot>
"#;

/// Expansion, with the tensor of the upper arm that a macro makes.
const EXPANDED: &str = r#"<?xml version="1.0" ?>
<robot name="arm">
  <link name="base">
    <inertial>
      <mass value="1.7"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="3"/>
    </inertial>
  </link>
  <link name="left_upper">
    <inertial>
      <mass value="2"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.4"/>
    </inertial>
  </link>
  <joint name="left_shoulder" type="fixed">
    <parent link="base"/>
    <child link="left_upper"/>
  </joint>
  <link name="left_hand">
    <inertial>
      <mass value="0.3"/>
      <inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="-0.01"/>
    </inertial>
  </link>
  <joint name="left_wrist" type="fixed">
    <parent link="left_upper"/>
    <child link="left_hand"/>
  </joint>
</robot>
"#;

const PATH: &str = "ws/arm/urdf/arm.urdf.xacro";

fn memory(arm: &str, hand: &str) -> Memory {
    Memory::from([
        (PATH, arm),
        ("ws/arm/parts/hand.xacro", hand),
        ("ws/arm/package.xml", "<package><name>arm</name></package>"),
        ("ws/arm/urdf/expanded.urdf", EXPANDED),
    ])
}

/// Checks the expansion of files with macros.
fn checked(arm: &str, hand: &str) -> Checked {
    checked_as(arm, hand, EXPANDED, Request::default())
}

fn checked_as(arm: &str, hand: &str, expanded: &str, request: Request) -> Checked {
    let memory = memory(arm, hand);
    let mut files = Overlay::new(&memory);
    files.insert(PATH, Ok(expanded.as_bytes().to_vec()));
    let checked = run(&Request { files: vec![PATH.into()], ..request }, &files).unwrap();
    require_fits(REPORT_SCHEMA, &checked.to_json());
    checked
}

/// Returns file, line and column of the finding about a link.
fn place(checked: &Checked, link: &str) -> (String, u64, u64) {
    let object = checked.to_json();
    let finding = finding(&object, link);
    let number = |key: &str| finding[key].as_u64().unwrap();
    (finding["file"].as_str().unwrap().to_owned(), number("line"), number("column"))
}

fn finding<'v>(object: &'v Value, link: &str) -> &'v Value {
    let findings = object["findings"].as_array().unwrap();
    findings.iter().find(|finding| finding["link"] == link).unwrap_or_else(|| panic!("{link}: {object}"))
}

/// Returns line and column, from 1, of a text.
fn at(text: &str, what: &str) -> (u64, u64) {
    let before = &text[..text.find(what).unwrap()];
    let line = before.matches('\n').count() as u64 + 1;
    (line, (before.len() - before.rfind('\n').map_or(0, |end| end + 1)) as u64 + 1)
}

#[test]
fn findings_are_at_the_values_and_elements_that_made_them() {
    let checked = checked(ARM, HAND);
    // A literal value, on a line of its own.
    let (line, column) = at(ARM, "3\"/>");
    assert_eq!(place(&checked, "base"), (PATH.to_owned(), line, column));
    // A link of a macro of this file whose inertial is made by another macro: the link itself.
    let (line, column) = at(ARM, "<link name=\"${side}_upper\"");
    assert_eq!(place(&checked, "left_upper"), (PATH.to_owned(), line, column));
    // A value in a macro of an included file.
    let (line, column) = at(HAND, "-0.01");
    assert_eq!(place(&checked, "left_hand"), ("ws/arm/parts/hand.xacro".to_owned(), line, column));
    for form in [Format::Text, Format::Sarif, Format::Github, Format::Junit, Format::Markdown] {
        let text = checked.to_form(form);
        assert!(text.contains(PATH) && text.contains("ws/arm/parts/hand.xacro"), "{form:?} {text}");
        assert!(!text.contains("(expanded)"), "{form:?} {text}");
    }
}

#[test]
fn the_findings_are_those_of_the_expanded_file() {
    let of_macros = checked(ARM, HAND).to_json();
    let files = memory(ARM, HAND);
    let request = Request { files: vec!["ws/arm/urdf/expanded.urdf".into()], ..Request::default() };
    let of_text = run(&request, &files).unwrap().to_json();
    for key in ["counts", "verdicts", "links", "inertials"] {
        assert_eq!(of_macros[key], of_text[key], "{key}");
    }
    for link in ["base", "left_upper", "left_hand"] {
        for key in ["code", "severity", "message", "rule", "numbers"] {
            assert_eq!(finding(&of_macros, link)[key], finding(&of_text, link)[key], "{link} {key}");
        }
    }
}

/// Requires that the finding about a link stays in the expanded text, with these words.
fn stays(checked: &Checked, link: &str, words: &str) {
    let (file, line, _) = place(checked, link);
    assert_eq!(file, format!("{PATH} (expanded)"));
    let after =
        EXPANDED[..EXPANDED.find(&format!("<link name=\"{link}\"")).unwrap()].matches('\n').count() as u64;
    assert!((after + 4..=after + 5).contains(&line), "{line} {after}");
    let object = checked.to_json();
    let message = finding(&object, link)["message"].as_str().unwrap();
    assert!(message.ends_with(words), "{message}");
}

#[test]
fn an_ambiguous_finding_stays_in_the_expanded_text() {
    // Two links of one macro.
    let twice = HAND.replace("<link name", "<link name=\"${side}_h${end}\"/><link name");
    stays(&checked(ARM, &twice), "left_hand", "; expanded from arm.urdf.xacro, macro hand");
    // Two links of two macros.
    let other = ARM.replace("side}_upper\">", "side}_${part}\">");
    stays(&checked(&other, HAND), "left_hand", "; expanded from arm.urdf.xacro");
    // Two values of a condition.
    let condition = ARM.replace(
        "<link name=\"base\">",
        "<xacro:if value=\"$(arg a)\"><link name=\"base\"/></xacro:if><xacro:unless value=\"$(arg a)\"><link name=\"base\">",
    );
    let condition = condition.replacen("</link>", "</link></xacro:unless>", 1);
    stays(&checked(&condition, HAND), "base", "; expanded from arm.urdf.xacro");
    // A file whose name has to be evaluated may have a further macro; a literal link remains certain.
    let unknown = ARM.replace("<xacro:property", "<xacro:include filename=\"$(arg f)\"/><xacro:property");
    let unknown = checked(&unknown, HAND);
    stays(&unknown, "left_hand", "; expanded from arm.urdf.xacro");
    assert_eq!(place(&unknown, "base").0, PATH);
    // Two elements of one name.
    let two = EXPANDED.replace("</robot>", "<link name=\"base\"/></robot>");
    stays(&checked_as(ARM, HAND, &two, Request::default()), "base", "; expanded from arm.urdf.xacro");
    // A literal link of an included file, which may be included under a condition.
    let hand = HAND
        .replace("${side}_hand\">", "left_hand\">")
        .replace("<xacro:macro name=\"hand\" params=\"side\">", "");
    let hand = hand.replace("</xacro:macro>", "");
    assert_eq!(place(&checked(ARM, &hand), "left_hand").0, "ws/arm/parts/hand.xacro");
    let unknown = ARM.replace("<xacro:property", "<xacro:include filename=\"$(arg f)\"/><xacro:property");
    stays(&checked(&unknown, &hand), "left_hand", "; expanded from arm.urdf.xacro");
    // No file has the link.
    stays(&checked(ARM, "<robot/>"), "left_hand", "; expanded from arm.urdf.xacro");
    for form in [Format::Text, Format::Sarif, Format::Github, Format::Junit, Format::Gitlab] {
        let text = checked(ARM, "<robot/>").to_form(form).replace("%20", " ");
        assert!(text.contains(&format!("{PATH} (expanded)")), "{form:?} {text}");
    }
}

#[test]
fn the_diff_is_of_the_expanded_text() {
    // A lost exponent; the box decides.
    let solid = EXPANDED.replace(
        "0.4\"/>\n    </inertial>",
        "1.083333e3\"/>\n    </inertial>
    <collision><geometry><box size=\"1.2 0.6 0.9\"/></geometry></collision>",
    );
    let solid = solid.replace("ixx=\"0.1\"", "ixx=\"0.195\"").replace("iyy=\"0.2\"", "iyy=\"0.375\"");
    let solid = solid.replace("1.083333e3", "300");
    let checked = checked_as(ARM, HAND, &solid, Request { fix: true, ..Request::default() });
    let diff = checked.to_diff();
    assert!(diff.contains(&format!("--- a/{PATH} (expanded)")), "{diff}");
    let object = checked.to_json();
    let edit = &finding(&object, "left_upper")["repair"]["edits"][0];
    assert_eq!(edit["file"], format!("{PATH} (expanded)"));
    assert_eq!(edit["line"], at(&solid, "300\"").0);
    let plain = checked_as(ARM, HAND, &solid, Request::default());
    assert!(
        plain.to_form(Format::Text).contains("--fix prints the correction of 1 value in the expanded text")
    );
}

#[test]
fn a_comment_of_the_expanded_text_allows_findings_of_macros() {
    let comment = "<!-- polhode: allow inertia.negative: a test -->\n  <link name=\"left_hand\"";
    let allowed = EXPANDED.replace("<link name=\"left_hand\"", comment);
    let object = checked_as(ARM, HAND, &allowed, Request::default()).to_json();
    assert_eq!(object["allowed"][0]["link"], "left_hand");
    let whole =
        EXPANDED.replace("<robot name", "<!-- polhode: allow inertia.negative: a test -->\n<robot name");
    let object = checked_as(ARM, HAND, &whole, Request::default()).to_json();
    assert_eq!(object["allowed"][0]["link"], "left_hand");
}

#[test]
fn a_comparison_is_at_the_macros_too() {
    let memory = memory(ARM, HAND);
    let mut files = Overlay::new(&memory);
    files.insert(PATH, Ok(EXPANDED.replace("<mass value=\"0.3\"/>", "<mass value=\"0.31\"/>").into_bytes()));
    let request =
        compare::Request { a: "ws/arm/urdf/expanded.urdf".into(), b: PATH.into(), ..Default::default() };
    let object = compare::run(&request, &files).unwrap().to_json();
    let difference = &object["differences"][0];
    assert_eq!(difference["code"], "compare.mass");
    assert_eq!(difference["b"]["line"], at(HAND, "0.3\"/>").0, "{object}");
}

#[test]
fn an_expansion_that_is_not_xml_has_a_place_in_it() {
    let memory = memory(ARM, HAND);
    let mut files = Overlay::new(&memory);
    files.insert(PATH, Ok(b"<robot>\n <link name=\"a\">\n</robot>".to_vec()));
    let checked = run(&Request { files: vec![PATH.into()], ..Request::default() }, &files).unwrap();
    let error = checked.files[0].report.as_ref().unwrap_err().to_string();
    assert!(error.contains(&format!("{PATH} (expanded):3:1")), "{error}");
    files.insert(PATH, Err("xacro failed".to_owned()));
    let checked = run(&Request { files: vec![PATH.into()], ..Request::default() }, &files).unwrap();
    assert!(checked.files[0].report.as_ref().unwrap_err().to_string().contains("xacro failed"));
}
