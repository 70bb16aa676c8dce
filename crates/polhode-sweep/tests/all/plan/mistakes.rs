//! Error messages for every mistake in a plan.

use polhode_source::FormatError;
use polhode_source::files::Disk;
use polhode_sweep::Plan;

use super::{SCENARIO, SPIN};
use crate::obey;

/// Checks that a plan is refused with a message, and a hint that begins with this text. « and »
/// mark the place of the mistake.
#[track_caller]
fn refuses(sweep: &str, message: &str, hint: &str) {
    let marked = format!("{SCENARIO}{sweep}");
    let start = marked.find('«').unwrap();
    let end = marked.find('»').unwrap() - '«'.len_utf8();
    let error = match Plan::parse(&Disk, marked.replace(['«', '»'], ""), "plan.toml".as_ref()) {
        Ok(_) => panic!("it is accepted:\n{sweep}"),
        Err(error) => error,
    };
    assert_eq!(error.message(), message, "{sweep}");
    assert_eq!(error.place().unwrap().span, start..end, "{error}");
    let given = error.hint().unwrap_or_default();
    assert!(given.starts_with(hint) && hint.is_empty() == given.is_empty(), "hint: {given}");
    let plain = marked.replace(['«', '»'], "");
    let read = |text: &str| Plan::parse(&Disk, text.to_owned(), "plan.toml".as_ref()).map(drop);
    let parts = |error: &FormatError| (error.message(), error.place().map(|place| place.span.clone()));
    obey::check(&plain, (message, &(start..end), &given), read, parts);
}

/// Calls [`refuses`] for one variable of a Monte Carlo plan.
#[track_caller]
pub(super) fn refuses_vary(vary: &str, message: &str, hint: &str) {
    refuses(
        &format!("[sweep]\nmembers = 10\nsampling = 'monte carlo'\n[[sweep.vary]]\n{vary}"),
        message,
        hint,
    );
}

#[test]
fn a_plan_says_how_many_and_how() {
    let rest = "sampling = 'sobol'\n[[sweep.vary]]\nkey = 'run.duration'\nuniform = { from = 1, to = 2 }\n";
    refuses(&format!("«[sweep]»\n{rest}"), "the key members is missing in [sweep]", "write members = 1000");
    refuses(
        &format!("[sweep]\nmembers = «0»\n{rest}"),
        "members = 0 must be at least 1",
        "write members = 1000",
    );
    refuses(
        &format!("[sweep]\nmembers = «'many'»\n{rest}"),
        "members must be a whole number, not a string",
        "write members = 1000",
    );
    refuses(
        &format!("[sweep]\nmembers = «5_000_000_000»\n{rest}"),
        "members = 5_000_000_000 must be at most 4294967296",
        "Sobol's points repeat beyond",
    );
    refuses(
        "[sweep]\nmembers = 9\nsampling = «'sobal'»\nvary = []\n",
        "sampling = 'sobal' must be one of monte carlo, latin hypercube, sobol, grid",
        "did you mean \"sobol\"?",
    );
    refuses(
        "[sweep]\nmembers = 9\nsampling = 'sobol'\n«sede» = 3\nvary = []\n",
        "unknown key \"sede\" in [sweep]",
        "did you mean seed?",
    );
    refuses(
        "«[sweep]»\nmembers = 9\nsampling = 'sobol'\n",
        "the key vary is missing in [sweep]",
        "write [[sweep.vary]]",
    );
    refuses(
        "«[sweep]»\nmembers = 9\nsampling = 'sobol'\nvary = []\n",
        "the key vary is missing in [sweep]",
        "write [[sweep.vary]]",
    );
    let scenario = Plan::parse(&Disk, SCENARIO.to_owned(), "plan.toml".as_ref()).unwrap_err();
    assert_eq!(scenario.message(), "the key sweep is missing in the file");
}

#[test]
fn where_one_motion_is_asked_for_a_plan_is_its_scenario_as_written_and_says_so() {
    let text = format!("{SCENARIO}[sweep]\nmembers = 10\nsampling = 'monte carlo'\n{SPIN}");
    let path = "plan.toml".as_ref();
    let scenario = polhode_scenario::read::parse(&text, path).unwrap();
    let finding = scenario.findings().last().unwrap();
    assert_eq!(finding.code, "sweep.nominal");
    assert!(finding.message.starts_with("this is a sweep plan with 10 members"));
    assert_eq!(scenario, polhode_scenario::read::parse(SCENARIO, path).unwrap().noting([finding.clone()]));
    // All entries are checked.
    let wrong = polhode_scenario::read::parse(&text.replace("= 10", "= 0"), path).unwrap_err();
    assert_eq!(wrong.to_string(), "plan.toml:19:11: members = 0 must be at least 1");
}

#[test]
fn keys_lead_to_numbers_of_the_scenario() {
    let law = "uniform = { from = 0, to = 1 }\n";
    for (key, rule, hint) in [
        (
            "start.spin.bdy[0]",
            "a key of the scenario; start.spin has no key \"bdy\"",
            "did you mean \"start.spin.body[0]\"?",
        ),
        (
            "start.omega",
            "a key of the scenario; start has no key \"omega\"",
            "the keys of start are attitude, spin; a varying number must be written in the file",
        ),
        (
            "strat.spin",
            "a key of the scenario; the scenario has no key \"strat\"",
            "did you mean \"start.spin\"?",
        ),
        ("run.duration.s", "a key of the scenario; run.duration has no key \"s\"", ""),
        (
            "start.spin.body[3]",
            "a key of the scenario; start.spin.body[3] does not exist",
            "start.spin.body has 3 elements, from start.spin.body[0]",
        ),
        ("start.spin[0]", "a key of the scenario; start.spin is not an array", ""),
        ("start.spin.body[0", "a key; the bracket after start.spin.body is not closed", ""),
        ("start.spin.body[0]x", "a key: write a dot or a bracket after start.spin.body[0]", ""),
        (
            "body.part[\"bsu\"].mass",
            "a key of the scenario; no body.part is named \"bsu\"",
            "did you mean 'body.part[\"bus\"].mass'?",
        ),
        ("start.spin.body", "a single number of the scenario", "write key = \"start.spin.body[0]\""),
        ("start.spin", "a single number of the scenario", "write key = \"start.spin.body[0]\""),
        (
            "title",
            "a number of the scenario: words, formulas and counts cannot vary",
            "if it is a constant formula, write",
        ),
        (
            "run.samples",
            "a number of the scenario: words, formulas and counts cannot vary",
            "if it is a constant formula, write",
        ),
        ("", "a key of the scenario", "write key = \"start.spin.body[0]\""),
        ("[0]", "a key that starts with the name of a table", ""),
    ] {
        refuses_vary(&format!("key = «'{key}'»\n{law}"), &format!("key = '{key}' must be {rule}"), hint);
    }
    refuses_vary(
        "key = «'start.spin'»\nrandom = 'uniform'\n",
        "key = 'start.spin' must be a rotation of the scenario",
        "write key = \"start.attitude\"",
    );
    refuses_vary(
        "key = «'run.duration'»\ndirection = 'uniform'\n",
        "key = 'run.duration' must be an array of three numbers: only a vector has a direction",
        "write key = \"start.spin.body\"",
    );
    refuses_vary(
        "key = «'run'»\ndispersion = '10 %'\n",
        "key = 'run' must be the body, a part of it, or the inertia of either",
        "write key = \"body\"",
    );
    refuses_vary(
        "key = «'body.part'»\ndispersion = '10 %'\n",
        "key = 'body.part' must be the body, a part of it, or the inertia of either",
        "write key = \"body\"",
    );
}

#[test]
fn a_law_fits_its_number() {
    let spin = |law: &str| format!("key = 'start.spin.body[0]'\n{law}\n");
    let cases = [
        (
            "normal = { mean = «'3 m/s'», sd = '1 m/s' }",
            "\"m/s\" is a velocity where an angular velocity belongs",
            "write an angular velocity, such as",
        ),
        ("normal = { mean = 1, sd = «-0.1» }", "sd = -0.1 must be positive", "it is a standard deviation"),
        ("normal = { mean = 1, sd = «0» }", "sd = 0 must be positive", "it is a standard deviation"),
        ("normal = «{ mean = 1 }»", "the key sd is missing in normal", "write sd = 0.05"),
        (
            "normal = { mean = 1, sd = 1, from = 2, to = «1» }",
            "to = 1 must be greater than from",
            "the numbers are between them",
        ),
        (
            "normal = { mean = 1, sd = 0.1, from = «9» }",
            "from = 9 must be within 30 sd of the mean",
            "the probability beyond it is negligible",
        ),
        (
            "uniform = { from = 3, to = «2» }",
            "to = 2 must be greater than from",
            "the numbers are between them",
        ),
        (
            "uniform = { from = 3, to = «3» }",
            "to = 3 must be greater than from",
            "the numbers are between them",
        ),
        (
            "uniform = { from = -1.7e308, to = «1.7e308» }",
            "to = 1.7e308 must be nearer to from",
            "their difference is larger",
        ),
        (
            "log_uniform = { from = «-1», to = 2 }",
            "from = -1 must be positive",
            "only positive numbers have a logarithm",
        ),
        ("log_normal = { median = «0», sigma = 2 }", "median = 0 must be positive", "only positive numbers"),
        (
            "log_normal = { median = 1, sigma = «'2 rad/s'» }",
            "\"rad/s\" is an angular velocity where a plain number belongs",
            "write a plain number, such as",
        ),
        (
            "log_normal = { median = 1, sd = «2» }",
            "median and sd are both given: use median with sigma, or mean with sd",
            "leave one of them out",
        ),
        (
            "triangular = { from = 1, to = 2, mode = «3» }",
            "mode = 3 must be between from and to",
            "it is the likeliest value",
        ),
        ("list = «[]»", "list = [] must be at least one number", "write list = [0.1, 0.2, 0.5]"),
        (
            "list = [«'2 kg'»]",
            "\"kg\" is a mass where an angular velocity belongs",
            "write an angular velocity",
        ),
        (
            "grid = { from = 1, to = 2, count = «1» }",
            "count = 1 must be from 2 to 1000000",
            "both ends are among the values",
        ),
        (
            "grid = { from = «-1», to = 2, count = 5, spacing = 'log' }",
            "from = -1 must be positive",
            "only positive numbers have a logarithm",
        ),
        ("relative = «'5 percent'»", "relative = '5 percent' must be a percentage", "write \"5 %\", or 0.05"),
        ("relative = «'-5 %'»", "relative = '-5 %' must be above 0", "it is a standard deviation"),
        (
            "uniform = { from = 0, to = 1 }\nnormal = «{ mean = 0, sd = 1 }»",
            "uniform and normal are both given: give each number one distribution only",
            "leave one of them out",
        ),
        (
            "uniform = { from = 0, to = 1 }\nmagnitude = «{ list = [3] }»",
            "uniform and magnitude are both given: magnitude is used only with direction",
            "leave one of them out",
        ),
        (
            "«unifrom» = { from = 0, to = 1 }",
            "unknown key \"unifrom\" in [[sweep.vary]]",
            "did you mean uniform?",
        ),
        ("uniform = { «form» = 0, to = 1 }", "unknown key \"form\" in uniform", "did you mean from?"),
    ];
    for (law, message, hint) in cases {
        refuses_vary(&spin(law), message, hint);
    }
    let zero = SCENARIO.replace("\"0.1 m\", \"-40 mm\"", "0, \"-40 mm\"");
    let text = format!(
        "{zero}[sweep]\nmembers = 3\nsampling = 'sobol'\n[[sweep.vary]]\nkey = 'body.part[0].center_of_mass[0]'\nrelative = 0.1\n"
    );
    let error = Plan::parse(&Disk, text, "plan.toml".as_ref()).unwrap_err();
    assert_eq!(error.message(), "relative = 0.1 must be left out, since the number is written as zero");
}

#[test]
fn what_is_dispersed_stays_within_reason() {
    for (law, message, hint) in [
        (
            "key = 'start.attitude'\nrandom = «'normal'»",
            "random = 'normal' must be one of uniform",
            "write random = \"uniform\"",
        ),
        (
            "key = 'start.attitude'\nrandom = { sd = «'-2 deg'» }",
            "sd = '-2 deg' must be positive",
            "it is measured to both sides",
        ),
        (
            "key = 'start.spin.body'\ndirection = { within = «'200 deg'» }",
            "within = '200 deg' must be at most 180 deg",
            "which is direction = \"uniform\"",
        ),
        (
            "key = 'start.spin.body'\ndirection = 'uniform'\nmagnitude = { normal = «{ mean = 1, sd = 0.1 }» }",
            "normal = { mean = 1, sd = 0.1 } must be nonnegative: a magnitude has no sign",
            "add from = 0 to a normal distribution",
        ),
        (
            "key = 'body'\ndispersion = «'60 %'»",
            "dispersion = '60 %' must be above 0 and at most 50 %",
            "a standard deviation, relative",
        ),
        (
            "key = 'body.inertia'\ndispersion = «{ mass = '10 %' }»",
            "dispersion = { mass = '10 %' } must be one number, for a tensor",
            "write dispersion = \"10 %\"",
        ),
        (
            "key = 'body'\ndispersion = «{}»",
            "the key inertia is missing in dispersion",
            "write dispersion = { mass = \"2 %\"",
        ),
    ] {
        refuses_vary(law, message, hint);
    }
}

#[test]
fn a_number_varies_once() {
    let part = "[[sweep.vary]]\nkey = 'body.part[0].mass'\nrelative = 0.1\n";
    for (first, second) in [
        (SPIN, "key = «'start.spin.body[0]'»\nrelative = 0.1\n"),
        (SPIN, "key = «'start.spin.body'»\ndirection = 'uniform'\n"),
        (part, "key = «'body'»\ndispersion = 0.1\n"),
        (part, "key = «'body.inertia'»\ndispersion = 0.1\n"),
        (part, "key = «'body.part[0].inertia'»\ndispersion = 0.1\n"),
        (part, "key = «'body.part[\"bus\"].mass'»\nrelative = 0.2\n"),
        (
            "[[sweep.vary]]\nkey = 'start.attitude'\nrandom = 'uniform'\n",
            "key = «'start.attitude.angle'»\nrelative = 0.1\n",
        ),
    ] {
        let key = second.split(['«', '»']).nth(1).unwrap();
        refuses(
            &format!("[sweep]\nmembers = 10\nsampling = 'monte carlo'\n{first}[[sweep.vary]]\n{second}"),
            &format!("key = {key} must be a number that does not already vary by line 22"),
            "a number varies once",
        );
    }
}

#[test]
fn a_column_has_one_name() {
    let part =
        |name: &str| format!("[[body.part]]\nname = '{name}'\nshape = 'sphere'\nradius = 1\nmass = 1\n");
    let vary = |name: &str| format!("[[sweep.vary]]\nkey = 'body.part[\"{name}\"].mass'\nrelative = 0.1\n");
    let parts = format!("{}{}", part("tank 1"), part("tank-1"));
    let sweep = format!("[sweep]\nmembers = 3\nsampling = 'sobol'\n{}{}", vary("tank 1"), vary("tank-1"));
    let error = Plan::parse(&Disk, format!("{parts}{sweep}"), "plan.toml".as_ref()).unwrap_err();
    let expected = "plan.toml:18:7: key = 'body.part[\"tank-1\"].mass' must be of another name: line 15 has the column \
                    body_part_tank_1_mass_kg already";
    assert_eq!(error.to_string(), expected);
}

#[test]
fn a_grid_has_values_and_no_distributions() {
    let vary = |key: &str, law: &str| format!("[[sweep.vary]]\nkey = '{key}'\n{law}\n");
    let list = vary("run.duration", "list = [1, 2]");
    refuses(
        &format!("[sweep]\nsampling = 'grid'\n{}", vary("run.duration", "uniform = «{ from = 1, to = 2 }»")),
        "uniform = { from = 1, to = 2 } must be list or grid: a grid has no distributions",
        "write grid =",
    );
    refuses(
        &format!("[sweep]\nmembers = «4»\nsampling = 'grid'\n{list}"),
        "members = 4 must be left out of a grid",
        "the size of a grid is the number of combinations of its values",
    );
    refuses(
        &format!("[sweep]\nseed = «4»\nsampling = 'grid'\n{list}"),
        "seed = 4 must be left out",
        "a grid is not random",
    );
    let many = "grid = { from = 1, to = 2, count = 1_000_000 }";
    let three: String = (0..3).map(|k| vary(&format!("start.spin.body[{k}]"), many)).collect();
    let message = "sweep.vary = 1000000 × 1000000 × 1000000 must be at most 1000000000000 combinations";
    let text = format!("{SCENARIO}[sweep]\nsampling = 'grid'\n{three}");
    let error = Plan::parse(&Disk, text, "plan.toml".as_ref()).unwrap_err();
    assert_eq!((error.message().as_str(), error.place().unwrap().line), (message, 20));
}

#[test]
fn sobol_has_so_many_dimensions_and_no_more() {
    // 16 numbers for a body.
    let part = "[[body.part]]\nshape = 'tensor'\nmass = 1\nmoments = [1, 2, 2.5]\n";
    let body: String = (0..5).map(|_| part).collect();
    let vary: String =
        (0..5).map(|k| format!("[[sweep.vary]]\nkey = 'body.part[{k}]'\ndispersion = 0.1\n")).collect();
    let text = |sampling: &str| format!("{body}[sweep]\nmembers = 8\nsampling = '{sampling}'\n{vary}");
    let error = Plan::parse(&Disk, text("sobol"), "plan.toml".as_ref()).unwrap_err();
    let expected =
        "plan.toml:37:7: key = 'body.part[4]' must be among the first 64 numbers that are drawn for a member";
    assert_eq!(error.to_string(), expected);
    assert!(Plan::parse(&Disk, text("latin hypercube"), "plan.toml".as_ref()).is_ok());
}

#[test]
fn members_that_are_no_bodies_are_a_finding_unless_all_are() {
    let mass = |from: &str, to: &str| {
        format!(
            "{SCENARIO}[sweep]\nmembers = 40\nsampling = 'latin hypercube'\n[[sweep.vary]]\nkey = 'body.part[0].mass'\n\
             uniform = {{ from = {from}, to = {to} }}\n"
        )
    };
    let plan = Plan::parse(&Disk, mass("-1", "1"), "plan.toml".as_ref()).unwrap();
    let finding = plan.findings().pop().unwrap();
    assert_eq!((finding.code, finding.severity), ("sweep.members", polhode::body::Severity::Warning));
    assert!(
        finding.message.starts_with("20 of 40 tested members are invalid; member "),
        "{}",
        finding.message
    );
    assert!(finding.message.ends_with("must be positive"), "{}", finding.message);
    assert_eq!(finding.place.as_deref(), Some("line 7"));

    let error = Plan::parse(&Disk, mass("-2", "-1"), "plan.toml".as_ref()).unwrap_err();
    assert!(error.message().starts_with("mass = -1."), "{error}");
    assert_eq!(error.place().unwrap().line, 7);
    let good = Plan::parse(&Disk, mass("1", "2"), "plan.toml".as_ref()).unwrap();
    assert!(good.findings().is_empty());
}
