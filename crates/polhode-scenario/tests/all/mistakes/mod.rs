//! Errors in scenario files: message, place and hint of each.

mod bodies;
mod hints;
mod motion;
mod together;

use std::path::Path;

use polhode::body::Material;
use polhode::motion::Scenario;
use polhode_scenario::read as scenario;
use polhode_source::{FormatError, FormatErrorKind};

use crate::obey;

const BALL: &str = "[[body.part]]\nshape = 'sphere'\nradius = '20 mm'\nmass = '0.5 kg'\n";
const RUN: &str = "[run]\nduration = '1 s'\n";

fn parse(text: &str) -> Result<Scenario, FormatError> {
    scenario::parse(text, Path::new("test.toml"))
}

/// Checks that `text` is refused with this message, and with a hint that starts with `hint`. The
/// characters « and » enclose the place of the error. The hint is followed: it removes the error.
#[track_caller]
fn refuses(text: &str, message: &str, hint: &str) -> FormatError {
    let error = refuses_alone(text, message, hint);
    let plain = text.replace(['«', '»'], "");
    let (place, given) = (error.place().expect("a place"), error.hint().unwrap_or_default());
    let parts = |error: &FormatError| (error.message(), error.place().map(|place| place.span.clone()));
    obey::check(&plain, (message, &place.span, &given), |text| parse(text).map(drop), parts);
    error
}

/// [`refuses`] for a hint whose example does not suit the rest of the file.
#[track_caller]
fn refuses_alone(text: &str, message: &str, hint: &str) -> FormatError {
    let start = text.find('«').expect("a mark");
    let before = &text[..start];
    let plain = text.replace(['«', '»'], "");
    let end = text.find('»').map_or(start, |end| end - '«'.len_utf8());
    let error = parse(&plain).expect_err(&plain);
    let place = error.place().expect("a place");
    let line = before.lines().count().max(1) + usize::from(before.ends_with('\n'));
    let line = if before.is_empty() { 1 } else { line };
    let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
    assert_eq!(error.message(), message, "{plain}");
    assert_eq!((place.line, place.column), (line, column), "{error}");
    assert_eq!(place.span, start..end, "{error}");
    assert_eq!(error.to_string(), format!("test.toml:{line}:{column}: {message}"));
    let shown: String =
        place.excerpt.chars().skip(place.marked.start).take(place.marked.end - place.marked.start).collect();
    assert!(
        start == end || plain[start..end].starts_with(shown.trim_end()),
        "{shown:?} of {:?}",
        &plain[start..end]
    );
    let given = error.hint().unwrap_or_default();
    assert!(given.starts_with(hint) && hint.is_empty() == given.is_empty(), "hint: {given}");
    error
}

#[test]
fn keys_that_mean_nothing_are_refused() {
    refuses(
        &BALL.replace("radius", "«raduis»"),
        "unknown key \"raduis\" in [[body.part]] of shape \"sphere\"",
        "did you mean radius? the known keys are name, shape",
    );
    refuses(
        &format!("{BALL}«colour» = 3"),
        "unknown key \"colour\" in [[body.part]] of shape \"sphere\"",
        "the known keys are name, shape, position, rotate, radius, inner_radius, density, mass, material",
    );
    refuses(
        &format!("«simulation»=1\n{BALL}"),
        "unknown key \"simulation\" in the file",
        "the known keys are",
    );
    refuses(
        &format!("{BALL}[start]\n«omega»=1"),
        "unknown key \"omega\" in [start]",
        "write spin = { body =",
    );
    refuses(
        &format!("{BALL}[start]\nspin={{«world»=[0,0,1]}}"),
        "unknown key \"world\" in spin",
        "the known keys are",
    );
    refuses(
        &format!("{BALL}«thickness» = '2 mm'"),
        "unknown key \"thickness\" in [[body.part]] of shape \"sphere\"",
        "the known keys are",
    );
    refuses(
        "[[body.part]]\nshape='disk'\nradius=1\nmass=1\nthickness=«1»",
        "mass and thickness are both given: the mass alone is sufficient",
        "leave",
    );
}

#[test]
fn keys_that_are_missing_are_named() {
    let part = "[[body.part]]";
    for empty in ["", "# nothing\n"] {
        refuses(&format!("«»{empty}"), "the key body is missing in the file", "write [[body.part]]");
    }
    refuses("«[body]»\npivot=[0,0,0]", "the key part is missing in [body]", "write [[body.part]]");
    refuses_alone("«[body]»\npart=[]", "the key part is missing in [body]", "write [[body.part]]");
    refuses(
        &format!("«{part}»\nradius=1"),
        "the key shape is missing in [[body.part]]",
        "write shape = \"box\"",
    );
    refuses(
        &BALL.replace(part, &format!("«{part}»")).replace("radius = '20 mm'\n", ""),
        "the key radius is missing in [[body.part]] of shape \"sphere\"",
        "write radius = \"4 mm\"",
    );
    refuses(
        &BALL.replace(part, &format!("«{part}»")).replace("mass = '0.5 kg'\n", ""),
        "the key density is missing in [[body.part]] of shape \"sphere\"",
        "write density = \"2700 kg/m^3\", or mass",
    );
    refuses(
        &format!("{BALL}«[[torque]]»\nmodel='gravity'"),
        "the key pivot is missing in [[torque]] of model \"gravity\"",
        "write pivot = [\"0 mm\"",
    );
    refuses(&format!("{BALL}«[run]»"), "the key duration is missing in [run]", "write duration");
    refuses(
        &format!("{BALL}«[pendulum]»\naxis=[1,0,0]"),
        "the key torque is missing in [pendulum]",
        "a pendulum",
    );
}

#[test]
fn quantities_have_units_signs_and_sizes() {
    let sphere =
        |radius: &str, mass: &str| format!("[[body.part]]\nshape='sphere'\nradius={radius}\nmass={mass}");
    refuses(
        &sphere("«\"20 deg\"»", "1"),
        "\"deg\" is an angle where a length belongs",
        "write a length, such as \"25 mm\"",
    );
    refuses(
        &sphere("«\"20 m m\"»", "1"),
        "\"m m\" is a quantity in m^2 where a length belongs",
        "write a length",
    );
    refuses(&sphere("«'20 mn'»", "1"), "unknown unit \"mn\"", "did you mean");
    refuses(&sphere("«'-4 mm'»", "1"), "radius = '-4 mm' must be positive", "a size is positive;");
    refuses(&sphere("«0»", "1"), "radius = 0 must be positive", "a size is positive;");
    refuses(&sphere("1", "«\"-12 g\"»"), "mass = \"-12 g\" must be positive", "negative mass");
    for number in ["nan", "-inf", "+inf", "+nan"] {
        refuses(
            &sphere("1", &format!("«{number}»")),
            &format!("mass = {number} must be finite"),
            "write a finite number",
        );
    }
    refuses(&sphere("1", "«1e400»"), "\"1e400\" is larger than any double", "");
    refuses(&sphere("1", "«'NaN kg'»"), "\"NaN kg\" is not a number", "write a decimal number");
    refuses(&sphere("«true»", "1"), "radius must be a length, not true or false", "write radius = \"25 mm\"");
    refuses(&sphere("«[1]»", "1"), "radius must be a length, not an array", "write radius");
    refuses(
        &sphere("«'1e200 m'»", "'1e300 kg'").replace("'1e300 kg'", "1"),
        "the volume = inf must be positive and finite: too large or too small for f64",
        "it is larger than the largest double,",
    );
}

#[test]
fn values_of_the_wrong_type_or_length_are_refused() {
    let position = |value: &str| format!("{BALL}position = {value}");
    refuses(
        &position("«[1, 2]»"),
        "position must be an array of 3 numbers or strings with units, not an array of 2",
        "write position = [..., ..., ...]",
    );
    refuses(
        &position("«'1 m'»"),
        "position must be an array of 3 numbers or strings with units, not a string",
        "write position = [0, 0, '1 m']",
    );
    refuses(
        "[[body.part]]\nshape = 'box'\nsize = «\"1 m\"»\nmass = 1\n",
        "size must be an array of 3 numbers or strings with units, not a string",
        "write size = [\"1 m\", \"1 m\", \"1 m\"]",
    );
    refuses(&position("[1, 2, «{}»]"), "position must be a length, not a table", "write \"25 mm\"");
    refuses(
        &position("['1 m', '«é»']").replace("['1 m', '«é»']", "['é', «'1 kg'», 0]").replace("'é'", "'1 μm'"),
        "\"kg\" is a mass where a length belongs",
        "write a length",
    );
    refuses(
        &format!("{BALL}rotate = {{ quaternion = [1, 0, 0, «\"1\"»] }}"),
        "quaternion must be a number, not a string",
        "write a plain number, without unit and quotes",
    );
    refuses(&format!("title = «3»\n{BALL}"), "title must be a string, not a number", "put it in quotes");
    refuses("body = «3»", "body must be a table, not a number", "write [body] on a line");
    refuses(
        "[body]\npart = «'x'»",
        "part must be an array of tables: [[body.part]], not a string",
        "write [[body.part]]",
    );
    refuses(
        &format!("{BALL}{RUN}samples = «'9'»"),
        "samples must be a whole number, not a string",
        "write samples",
    );
    refuses(
        &format!("{BALL}{RUN}samples = «9.5»"),
        "samples must be a whole number, not a number",
        "write samples",
    );
    refuses(
        &format!("{BALL}{RUN}tolerance = «1979-05-27»"),
        "tolerance must be a number, not a date",
        "write a plain number, without unit and quotes",
    );
}

#[test]
fn names_are_known_ones() {
    refuses(
        &BALL.replace("'sphere'", "«'shpere'»"),
        "shape = 'shpere' must be one of box, sphere, ellipsoid, cylinder, capsule, cone, torus, tetrahedron, \
         triangular_prism, rod, disk, plate, triangular_plate, sphere_shell, box_shell, cylinder_shell, cone_shell, mesh, molecule, particles, tensor",
        "did you mean \"sphere\"?",
    );
    let error = refuses(
        &BALL.replace("mass = '0.5 kg'", "material = «\"aluminum alloy\"»"),
        &format!(
            "material = \"aluminum alloy\" must be a known material: {}",
            Material::ALL.iter().map(|m| m.name).collect::<Vec<_>>().join(", ")
        ),
        "give density = ",
    );
    assert!(matches!(error.kind(), FormatErrorKind::Value { .. }));
    let steel = parse(&BALL.replace("mass = '0.5 kg'", "material = 'stel'")).unwrap_err();
    assert_eq!(steel.hint().unwrap(), "did you mean \"steel\"?");
    refuses(
        &format!("{BALL}{RUN}method = «'euler'»"),
        "method = 'euler' must be one of auto, exact, taylor, dop853, splitting",
        "",
    );
    refuses(
        &format!("{BALL}{RUN}method = 'splitting'\nstep = 0.1\norder = «3»"),
        "order = 3 must be 2, 4 or 6",
        "halving the step",
    );
    refuses(
        &format!("{BALL}{RUN}method = 'splitting'\nstep = «0»"),
        "step = 0 must be positive",
        "time runs",
    );
    refuses(
        &format!("{BALL}[[torque]]\nmodel = «'dragg'»"),
        "model = 'dragg' must be one of constant, gravity, gravity_gradient, drag, torsion, magnetic, thruster, \
         energy_sink, formula, table",
        "did you mean \"drag\"?",
    );
}

#[test]
fn a_fixed_step_has_no_tolerance_and_a_tolerance_no_step() {
    refuses(
        &format!("{BALL}{RUN}method = 'splitting'\nstep = '5 ms'\ntolerance = «1e-9»"),
        "tolerance = 1e-9 must be left out of a run by splitting",
        "the step determines the accuracy: leave out tolerance",
    );
    for (key, value, own) in [
        ("order", "4", "this method has its own order: leave out order"),
        ("step", "'5 ms'", "this method chooses its steps from the tolerance: leave out step"),
    ] {
        let message = format!("{key} = {value} must be left out without method = \"splitting\"");
        refuses(&format!("{BALL}{RUN}method = 'taylor'\n{key} = «{value}»"), &message, own);
        let splitting = "other methods choose their steps from the tolerance: add method = \"splitting\"";
        refuses(&format!("{BALL}{RUN}{key} = «{value}»"), &message, splitting);
        refuses(
            &format!("{BALL}[prescribed]\naxis=[0,0,1]\nrate=1\n{RUN}{key}=«{value}»"),
            &format!("{key} = {value} must be left out"),
            "a prescribed motion is not computed",
        );
    }
    let error = parse(&format!("{BALL}{RUN}method = 'splitting'")).unwrap_err();
    assert!(matches!(error.kind(), FormatErrorKind::MissingKey { key: "step", .. }), "{error}");
}

#[test]
fn keys_that_exclude_each_other_are_refused() {
    refuses(
        &format!("{BALL}density = «'1 kg/m^3'»"),
        "mass and density are both given: each of them alone defines the mass of the part",
        "leave one of them out",
    );
    refuses(
        &format!("{BALL}{RUN}every=0.1\nsamples=«11»"),
        "every and samples are both given: both define the sample times",
        "leave",
    );
    refuses(
        &format!("{BALL}[start]\nspin={{body=[0,0,1],space=«[0,0,1]»}}"),
        "body and space are both given: give the spin in one way only",
        "leave",
    );
    refuses(
        &format!("{BALL}[prescribed]\naxis=[0,0,1]\nrate=1\n«[[torque]]»\nmodel='gravity'"),
        "prescribed and torque are both given: the torque of a prescribed motion is computed, not given",
        "leave",
    );
    refuses(
        &format!("{BALL}[prescribed]\naxis=[0,0,1]\nrate=1\n«[pendulum]»\naxis=[0,0,1]"),
        "prescribed and pendulum are both given: gravity alone moves a pendulum",
        "leave",
    );
    refuses(
        &format!("{BALL}[prescribed]\naxis=[0,0,1]\nrate=1\n{RUN}method=«'exact'»"),
        "method = 'exact' must be left out",
        "a prescribed motion is not computed",
    );
    refuses(
        &format!("{BALL}rotate={{axis=[0,0,1],angle=1,matrix=«[[1,0,0],[0,1,0],[0,0,1]]»}}"),
        "axis and matrix are both given: give the rotation in one way only",
        "leave",
    );
    refuses(
        &format!("{BALL}[body]\npivot=[0,0,1]\n[[torque]]\nmodel='gravity'\npivot=«[0,0,2]»"),
        "pivot = [0,0,2] must be the pivot of line 6: a body is held at one point",
        "leave one",
    );
    refuses(
        &format!("{BALL}[start]\nvelocity=«[0,0,2]»\n[body]\npivot=[0,0,0]"),
        "velocity = [0,0,2] must be left out, since a point of the body is held at a pivot",
        "a body with a pivot only",
    );
    let prescribed = format!("{BALL}[prescribed]\neuler313=[0,0,0]\nrates=[1,0,0]\n[start]\n");
    refuses(
        &format!("{prescribed}spin=«{{body=[0,0,1]}}»"),
        "spin = {body=[0,0,1]} must be left out, since the prescribed motion has its own",
        "leave out spin",
    );
    refuses(
        &format!("{prescribed}attitude=«{{quaternion=[1,0,0,0]}}»"),
        "attitude = {quaternion=[1,0,0,0]} must be left out, since the Euler angles of the prescribed motion are the attitude",
        "leave out attitude",
    );
}

#[test]
fn rotations_have_a_direction() {
    refuses(
        &format!("{BALL}rotate={{quaternion=«[0,0,0,0.0]»}}"),
        "the quaternion (0, 0, 0, 0) has no direction: it must be finite and not zero",
        "the identity is",
    );
    refuses(
        &format!("{BALL}[start]\nattitude={{axis=«[0,0,0]»,angle=1}}"),
        "the axis (0, 0, 0) has no direction: it must be finite and not zero",
        "the z axis",
    );
    refuses(
        &format!("{BALL}rotate={{matrix=«[[1,0,0],[0,1,0],[0,0,-1]]»}}"),
        "the matrix is not a rotation: it departs from orthogonality and determinant +1 by 2e0, more than 1e-7",
        "its columns are the rotated axes:",
    );
    refuses(&format!("{BALL}rotate=«{{}}»"), "the key axis is missing in rotate", "write { axis");
    refuses(
        &format!("{BALL}[prescribed]\naxis=«[0,0,0]»\nrate=1"),
        "the length of the axis = 0 must be a direction: finite and not zero",
        "the z axis",
    );
}

#[test]
fn runs_have_an_end_and_a_size() {
    let run = |text: &str| format!("{BALL}[run]\n{text}");
    for zero in ["0", "'-3 s'", "-0.0"] {
        let text = run(&format!("duration=«{zero}»"));
        refuses(&text, &format!("duration = {zero} must be positive"), "time runs forward");
    }
    refuses(&run("duration=1\nevery=«'2 s'»"), "every = '2 s' must be at most the duration, 1 s", "give");
    refuses(&run("duration=1\nsamples=«1»"), "samples = 1 must be at least 2", "the first sample is");
    refuses(
        &run("duration=1\nsamples=«-1»"),
        "samples = -1 must be a whole number, not negative, below 2^64",
        "write samples = 1000",
    );
    for many in ["samples=«1000000000000»", "every=«1e-300»"] {
        let (key, value) = many.split_once('=').unwrap();
        let value = value.replace(['«', '»'], "");
        let message = format!("{key} = {value} must be such that there are at most 10000000 samples");
        refuses(&run(&format!("duration=1\n{many}")), &message, "all samples are held in memory");
    }
    refuses(
        &run("duration=1\ntolerance=«1e-20»"),
        "tolerance = 1e-20 must be from 1e-15 to 1e-2",
        "it bounds",
    );
}

#[test]
fn the_grammar_of_toml_is_kept() {
    refuses(&format!("{BALL}«mass» = 1\n"), "duplicate key", "use each key once per table; another");
    refuses(
        "title = «»\n",
        "string values must be quoted, expected literal string",
        "a quantity with a unit",
    );
    refuses("[body]\nx = [1,\n2«»", "unclosed array, expected `]`", "a line is key = value");
    refuses("# ä ö\nx = «1 y»", "string values must be quoted, expected literal string", "a quantity");
    // A byte order mark does not count as a column.
    let error = parse("\u{feff}x = 1").unwrap_err();
    assert_eq!(error.to_string(), "test.toml:1:1: unknown key \"x\" in the file");
    // Lines may end with CR LF.
    let error = parse(&BALL.replace('\n', "\r\n").replace("20 mm", "20 kg")).unwrap_err();
    assert_eq!(
        error.place().map(|p| (p.line, p.column, p.excerpt.as_str())),
        Some((3, 10, "radius = '20 kg'"))
    );
    // A long line is shown in part.
    let error = parse(&format!("x = [{} 'y z' ]", "1, ".repeat(1000))).unwrap_err();
    assert_eq!(error.place().unwrap().column, 1);
    let error = parse(&format!("{BALL}position = [{}'1 kg', 0, 0]", " ".repeat(5000))).unwrap_err();
    let place = error.place().unwrap();
    assert_eq!((place.column, &place.excerpt[place.marked.clone()]), (5013, "'1 kg'"));
}

#[test]
fn tables_that_come_in_arrays_have_two_brackets() {
    refuses(
        &format!("{BALL}«[torque]»\nmodel='gravity'"),
        "torque must be an array of tables: [[torque]], not a table",
        "write [[torque]]",
    );
    refuses(
        "«[body.part]»\nshape='box'",
        "part must be an array of tables: [[body.part]], not a table",
        "write [[body.part]]",
    );
    refuses(
        "torque=[«1»]\n[body]\npart=[{shape='sphere',radius=1,mass=1}]",
        "torque must be a table, not a number",
        "write [[torque]]",
    );
    refuses(
        "[[body.part]]\nshape='particles'\nparticles=[«3»]",
        "particles must be a table, not a number",
        "write { mass = \"1 kg\", position",
    );
    refuses(
        "[[body.part]]\nshape='tetrahedron'\nvertices=[«[1,2]»,[1,2,3],[1,2,3],[1,2,3]]",
        "vertices must be an array of 3 values, not an array of 2",
        "write [..., ..., ...]",
    );
}

#[test]
fn a_key_in_another_table_is_told_its_own() {
    refuses(
        &format!("{BALL}[start]\n«title» = 'x'"),
        "unknown key \"title\" in [start]",
        "write title above the first table",
    );
    refuses(
        &format!("{BALL}«run» = {{ duration = 3 }}"),
        "unknown key \"run\" in [[body.part]] of shape \"sphere\"",
        "write [run]",
    );
    refuses(
        &format!("{RUN}«torque» = {{ model = 'drag' }}\n{BALL}"),
        "unknown key \"torque\" in [run]",
        "write [[torque]]",
    );
    assert!(!parse("").unwrap_err().hint().unwrap().contains('\n'));
    // If the shape is not stated, the keys of all shapes are listed.
    let many = parse("[[body.part]]\nzzz=1").unwrap_err().hint().unwrap();
    assert!(
        !many.contains('…')
            && many.contains("semi_axes")
            && many.contains("union")
            && many.ends_with("vertices, weld"),
        "{many}"
    );
}

#[test]
fn a_pendulum_swings_under_gravity_alone() {
    let gravity = "[[torque]]\nmodel='gravity'\npivot=[0,0,1]\n";
    let constant = "[[torque]]\nmodel=«'constant'»\naxes='body'\ntorque=[1,0,0]\n";
    for text in [
        format!("{BALL}{gravity}{constant}[pendulum]\naxis=[1,0,0]"),
        format!("{BALL}{constant}[pendulum]\naxis=[1,0,0]"),
    ] {
        let message = "model = 'constant' must be \"gravity\": gravity is the only torque on a pendulum";
        refuses(&text, message, "leave out this torque");
    }
    for (times, value) in [("from=«1»", "from = 1"), ("until=«'2 s'»", "until = '2 s'")] {
        refuses(
            &format!("{BALL}[[torque]]\nmodel='gravity'\npivot=[0,0,1]\n{times}\n[pendulum]\naxis=[1,0,0]"),
            &format!("{value} must be left out: a pendulum needs gravity at all times"),
            "leave out the times of this torque",
        );
    }
    refuses(
        &format!(
            "{BALL}[[torque]]\nmodel='gravity'\nname='weight'\npivot=[0,0,1]\non=«false»\n[pendulum]\naxis=[1,0,0]"
        ),
        "on = false must be true: a pendulum needs gravity at all times",
        "leave out on",
    );
}

#[test]
fn what_others_wrote_does_not_reach_the_terminal() {
    for c in ['\u{1b}', '\u{9b}', '\u{202a}', '\u{202e}', '\u{2066}', '\u{2069}', '\u{200f}', '\u{7f}'] {
        // TOML allows control characters in escapes only, and not all of these are control
        // characters.
        let plain = format!("{BALL}# {c}\n{RUN}method = 'a{c}b' # {c}");
        let quoted = format!("{BALL}\"a\\u{:04X}b\" = 1", u32::from(c));
        for text in [plain, quoted] {
            let error = parse(&text).unwrap_err();
            let place = error.place().unwrap();
            let said = format!("{error}{}{}", place.excerpt, error.hint().unwrap_or_default());
            assert!(!said.contains(c), "{said:?}");
        }
    }
    let error =
        parse(&format!("{BALL}name = '\u{202e}x' # \u{2066}\n{RUN}method = '\u{202e}x' # \t\u{2066}"))
            .unwrap_err();
    let place = error.place().unwrap();
    assert_eq!(error.message(), "method = '\u{fffd}x' must be one of auto, exact, taylor, dop853, splitting");
    assert_eq!((place.excerpt.as_str(), &place.marked), ("method = '\u{fffd}x' #  \u{fffd}", &(9..13)));

    let long = "x".repeat(500);
    let shown = format!("{}…", &long[..60]);
    let key = parse(&format!("{long} = 1")).unwrap_err();
    assert_eq!(key.message(), format!("unknown key {shown:?} in the file"));
    let value = parse(&format!("{BALL}{RUN}method = '{long}'")).unwrap_err().message();
    assert!(value.starts_with(&format!("method = '{}… must be one of", &long[..59])), "{value}");
    let unit = parse(&format!("{BALL}position = [0, 0, '1 {long}']")).unwrap_err().message();
    assert_eq!(unit, format!("unknown unit {shown:?}"));
}

#[test]
fn a_mesh_is_no_scenario() {
    let hint = "this is a mesh, not a scenario: polhode";
    refuses("solid «»cube\nfacet normal 0 0 1\n", &parse("solid cube").unwrap_err().message(), hint);
    let named = scenario::parse("not TOML", Path::new("cube.STL")).unwrap_err();
    assert!(named.hint().unwrap().starts_with(hint));
    assert!(!parse("not TOML").unwrap_err().hint().unwrap().starts_with(hint));
}
