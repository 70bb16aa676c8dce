//! Grades of answer files.

use polhode_course::exercise::{Exercises, REPORT_SCHEMA, Request, Solution, run, topics};
use polhode_document::Report as _;
use polhode_source::files::Memory;
use serde_json::Value;

use crate::exercises::solved;
use crate::schema::require_fits;

/// Request to grade the file `mine.toml`.
fn grading() -> Request {
    Request { answers: Some("mine.toml".into()), ..Request::default() }
}

/// Returns the report on an answer file.
fn graded(text: &str) -> Value {
    let report = run(&grading(), &Memory::from([("mine.toml", text.to_owned())]))
        .unwrap_or_else(|e| panic!("{e}\n{text}"));
    let value = report.to_json();
    require_fits(REPORT_SCHEMA, &value);
    let is_right = value["grades"].as_array().unwrap().iter().all(|grade| grade["grade"] == "right");
    assert_eq!(report.has_failed(), !is_right);
    assert!(value["solution"].is_null());
    value
}

/// Returns the grade of the only question, and its reason.
fn grade(text: &str) -> [String; 2] {
    let report = graded(text);
    let [grade] = &report["grades"].as_array().unwrap()[..] else { panic!("{report}") };
    ["grade", "reason"].map(|key| grade[key].as_str().unwrap().to_owned())
}

/// Returns the message of an answer file that is refused, with its place.
fn refused(text: &str) -> String {
    refused_by(&grading(), text)
}

fn refused_by(request: &Request, text: &str) -> String {
    run(request, &Memory::from([("mine.toml", text.to_owned())])).unwrap_err().to_string()
}

/// Returns a value with three significant digits, SI units.
fn three_digits(values: &Value, unit: &str) -> String {
    let quantity = |x: &Value| format!("\"{:.2e} {unit}\"", x.as_f64().unwrap());
    let all: Vec<String> = values.as_array().unwrap().iter().map(quantity).collect();
    match &all[..] {
        [one] => one.clone(),
        [xx, yy, zz, xy, xz, yz] => format!("[[{xx}, {xy}, {xz}], [{xy}, {yy}, {yz}], [{xz}, {yz}, {zz}]]"),
        all => format!("[{}]", all.join(", ")),
    }
}

/// Returns an answer file with the SI values of `value` for each question.
fn filled(report: &Value, value: impl Fn(&Value) -> Value) -> String {
    let mut text = format!("topic = {}\nseed = {}\n[answers]\n", report["topic"], report["seed"]);
    let all = report["questions"].as_array().unwrap().iter().zip(report["solution"].as_array().unwrap());
    for (question, answer) in all {
        let unit = match question["unit"].as_str().unwrap() {
            "deg" => "rad",
            "mN m" => "N m",
            unit => unit,
        };
        text.push_str(&format!(
            "{} = {}\n",
            question["name"].as_str().unwrap(),
            three_digits(&value(answer), unit)
        ));
    }
    text
}

#[test]
fn right_answers_with_three_digits_are_right() {
    for topic in topics() {
        for seed in 200..210 {
            let text = filled(&solved(topic, seed), |answer| answer["value"].clone());
            let report = graded(&text);
            for grade in report["grades"].as_array().unwrap() {
                assert_eq!(grade["grade"], "right", "{topic} {seed}: {grade}\n{text}");
            }
        }
    }
}

#[test]
fn mistakes_are_recognized() {
    for topic in topics() {
        let report = solved(topic, 31);
        let most = report["solution"]
            .as_array()
            .unwrap()
            .iter()
            .map(|a| a["mistakes"].as_array().unwrap().len())
            .max();
        for k in 0..most.unwrap() {
            let mistake = |answer: &Value| {
                answer["mistakes"].get(k).map_or(answer["value"].clone(), |m| m["value"].clone())
            };
            let found = graded(&filled(&report, mistake));
            let all = found["grades"].as_array().unwrap().iter().zip(report["solution"].as_array().unwrap());
            for (grade, answer) in all {
                let Some(made) = answer["mistakes"].get(k) else { continue };
                assert_eq!(grade["grade"], "wrong", "{topic} {grade} {made}");
                // Of mistakes with almost the same value the first is named.
                let known = answer["mistakes"].as_array().unwrap();
                assert!(known.iter().any(|m| m["reason"] == grade["reason"]), "{topic} {grade} {made}");
                let earlier = known.iter().position(|m| m["reason"] == grade["reason"]).unwrap();
                assert!(earlier <= k, "{topic} {grade} {made}");
            }
        }
    }
}

#[test]
fn the_template_is_an_answer_file_without_answers() {
    for topic in topics() {
        let exercises = Exercises::of(topic).unwrap();
        for exercise in [exercises.with_seed(5), exercises.in_symbols(5)].into_iter().flatten() {
            let report = graded(&exercise.template());
            assert!(
                report["grades"].as_array().unwrap().iter().all(|grade| grade["grade"] == "missing"),
                "{topic}"
            );
        }
    }
    let largest = graded(&Exercises::of("cones").unwrap().with_seed(u64::from(u32::MAX)).unwrap().template());
    assert_eq!(largest["seed"], u32::MAX);
    assert_eq!(graded("topic = \"cones\"\nseed = 2\n[answers]\n")["grades"][2]["grade"], "missing");
}

#[test]
fn a_grade_names_unit_sign_factor_and_prefix() {
    // ω₀ of seed 4
    let right = solved("two-mass-pendulum", 4)["solution"][0]["value"][0].as_f64().unwrap();
    let of = |text: String| {
        grade(&format!("topic = \"two-mass-pendulum\"\nseed = 4\n[answers]\nomega_0 = {text}\n"))
    };
    let wrong = |text: String| {
        let [grade, reason] = of(text);
        assert_eq!(grade, "wrong", "{reason}");
        reason
    };
    assert_eq!(of(format!("\"{right} rad/s\"")), ["right", ""]);
    assert_eq!(of(format!("\"{} 1/s\"", 1.0045 * right)), ["right", ""]);
    assert_eq!(of(format!("\"{} deg/s\"", right.to_degrees())), ["right", ""]);
    assert_eq!(wrong(format!("\"{} rad/s\"", 1.006 * right)), "no frequent mistake gives this value");
    assert_eq!(wrong(format!("\"{} rad/s\"", -right)), "the sign is reversed");
    assert_eq!(wrong(format!("\"{} rad/s\"", 2.0 * right)), "a factor 2 is missing or too much");
    assert_eq!(wrong(format!("\"{right} rpm\"")), "rad/s, rpm and revolutions per second are mixed up");
    let [grade, reason] = of(format!("\"{right} kg\""));
    assert_eq!(
        [grade.as_str(), &reason],
        ["wrong unit", "the unit is of a mass, but the result is an angular velocity"]
    );
    for text in [format!("{right}"), format!("\"{right}\"")] {
        let [grade, reason] = of(text);
        assert_eq!(
            [grade.as_str(), &reason],
            ["wrong unit", "the unit is missing: write it after the number, such as rad/s"]
        );
    }
    let inertia = solved("torsion-pendulum", 4)["solution"][0]["value"][0].as_f64().unwrap();
    let report =
        graded(&format!("topic = \"torsion-pendulum\"\nseed = 4\n[answers]\nI = \"{inertia} kg cm^2\"\n"));
    assert_eq!(report["grades"][0]["reason"], "the power of ten is wrong: check the prefixes of the units");
}

#[test]
fn vectors_and_tensors_have_reasons_by_component() {
    let of = |[x, y, z]: [f64; 3]| {
        grade(&format!(
            "topic = \"angular-momentum\"\nseed = 9\n[answers]\nL = [\"{x} N m s\", \"{y} N m s\", \"{z} N m s\"]\n"
        ))
    };
    let right = solved("angular-momentum", 9)["solution"][0]["value"].clone();
    let [x, y, z] = [0, 1, 2].map(|k| right[k].as_f64().unwrap());
    assert_eq!(of([x, y, z])[0], "right");
    assert_eq!(of([x, -y, z])[1], "the sign is reversed in: 2nd");
    assert_eq!(of([-x, -y, -z])[1], "the sign is reversed");
    assert_eq!(of([y, z, x])[1], "the components belong to other axes: they are permuted");
    assert_eq!(of([x, y, 1.3 * z])[1], "these elements are wrong: 3rd");
    let box_of =
        |rows: &str| grade(&format!("topic = \"box-about-corner\"\nseed = 1\n[answers]\nI = {rows}\n"));
    let asymmetric = "[[\"1 kg m^2\", \"2 kg m^2\", \"0 kg m^2\"], [\"0 kg m^2\", \"1 kg m^2\", \"0 kg m^2\"], [\"0 kg m^2\", \"0 kg m^2\", \"1 kg m^2\"]]";
    assert_eq!(box_of(asymmetric)[1], "the tensor is not symmetric: I_xy = I_yx");
}

#[test]
fn axes_have_any_length_and_sign() {
    let right = solved("principal-axes", 6)["solution"].clone();
    let axis = |k: usize, scale: f64| {
        let [x, y, z] = [0, 1, 2].map(|j| right[k]["value"][j].as_f64().unwrap() * scale);
        format!("[{x}, {y}, {z}]")
    };
    let of = |first: String, last: String| {
        let report = graded(&format!(
            "topic = \"principal-axes\"\nseed = 6\n[answers]\ne_1 = {first}\ne_3 = {last}\n"
        ));
        [0, 1].map(|k| report["grades"][k]["grade"].as_str().unwrap().to_owned())
    };
    assert_eq!(of(axis(0, -3.0), axis(1, 0.5)), ["right", "right"]);
    assert_eq!(of(axis(1, 1.0), "[0, 0, 0]".to_owned()), ["wrong", "wrong"]);
}

#[test]
fn every_form_of_a_formula_is_right() {
    let of = |formula: &str| {
        grade(&format!(
            "topic = \"two-mass-pendulum\"\nseed = 4\nsymbols = true\n[answers]\nomega_0_squared = \"{formula}\"\n"
        ))
    };
    for formula in ["(m_1 + m_2/2)/(m_1 + m_2/4)*g/b", "2*g*(2*m_1 + m_2)/(b*(4*m_1 + m_2))"] {
        assert_eq!(of(formula), ["right", ""], "{formula}");
    }
    assert_eq!(of("(m_1 + m_2)/(m_1 + m_2/4)*g/b")[1], "the torque on m₂ has the lever b/2");
    assert_eq!(
        of("(m_1 + m_2/2)/(m_1 + m_2/4)*9.81/b")[1],
        "g does not occur: if a number was inserted for it, write the symbol"
    );
    assert_eq!(of("-(m_1 + m_2/2)/(m_1 + m_2/4)*g/b")[1], "the sign is reversed");
    assert_eq!(
        of("5.2 rad/s"),
        ["wrong", "a formula in the symbols of the problem is required, not a quantity"]
    );
    let period = |formula: &str| {
        grade(&format!(
            "topic = \"physical-pendulum\"\nseed = 1\nsymbols = true\n[answers]\ntau_squared = \"{formula}\"\n"
        ))
    };
    assert_eq!(period("(2*pi)^2*(l^2 + 12*d^2)/(12*g*d)")[0], "right");
    assert_eq!(period("4*π^2*(l^2/12 + d^2)/(g*d)")[0], "right");
    assert_eq!(period("(l^2/12 + d^2)/(g*d)")[1], "a factor 2π is missing: the period is 2π/ω₀");
    let torque = "topic = \"dumbbell-torque\"\nseed = 1\nsymbols = true\n[answers]\nN_x = \"-b^2*omega^2*(m_1 + m_2)*sin(2*alpha)/2\"\n";
    assert_eq!(grade(torque)[0], "right");
    let rows = "[[\"M*(b^2+c^2)/3\", \"M*a*b/4\", \"M*a*c/4\"], [\"M*a*b/4\", \"M*(a^2+c^2)/3\", \"M*b*c/4\"], [\"M*a*c/4\", \"M*b*c/4\", \"M*(a^2+b^2)/3\"]]";
    let tensor =
        grade(&format!("topic = \"box-about-corner\"\nseed = 1\nsymbols = true\n[answers]\nI = {rows}\n"));
    assert!(tensor[1].contains("sign of the products"), "{tensor:?}");
}

#[test]
fn grades_do_not_contain_the_right_value_unless_it_is_requested() {
    let text = "topic = \"two-mass-pendulum\"\nseed = 4\n[answers]\nomega_0 = \"1 rad/s\"\n";
    let files = Memory::from([("mine.toml", text.to_owned())]);
    let right =
        solved("two-mass-pendulum", 4)["solution"][0]["text"].as_str().unwrap().replace('\u{a0}', " ");
    let without = run(&grading(), &files).unwrap();
    assert!(
        !without.to_text(None).contains(&right[..4])
            && without.to_text(None).contains("0 of 1 answers are right")
    );
    let with = run(&Request { solution: Some(Solution::After), ..grading() }, &files).unwrap();
    assert!(with.to_text(None).contains(&right), "{right}\n{}", with.to_text(None));
    assert!(with.has_failed() && !with.to_json()["solution"].is_null());
}

#[test]
fn a_wrong_answer_file_is_refused_at_its_place() {
    let head = "topic = \"two-mass-pendulum\"\nseed = 4\n";
    for (text, place, message) in [
        ("topic = \"cone\"\nseed = 1\n[answers]\n".to_owned(), "mine.toml:1:9", "did you mean \"cones\"?"),
        ("seed = 1\n[answers]\n".to_owned(), "mine.toml", "the key topic is missing"),
        ("topic = \"cones\"\n[answers]\n".to_owned(), "mine.toml", "the key seed is missing"),
        (
            "topic = \"cones\"\nseed = -1\n[answers]\n".to_owned(),
            "mine.toml:2:8",
            "a whole number, not negative",
        ),
        (format!("{head}[answer]\n"), "mine.toml:3:2", "answers"),
        (format!("{head}[answers]\nomega0 = \"1 rad/s\"\n"), "mine.toml:4:1", "omega_0"),
        (format!("{head}[answers]\nomega_0 = \"1 Hz\"\n"), "mine.toml:4:11", "write rev/s or rad/s"),
        (format!("{head}[answers]\nomega_0 = [1, 2]\n"), "mine.toml:4:11", "omega_0 must be"),
        (format!("{head}[answers]\nomega_0 = \"1 rad/s\n"), "mine.toml:4", "string"),
        (
            format!("{head}symbols = true\n[answers]\nomega_0_squared = \"G/b\"\n"),
            "mine.toml:5:20",
            "unknown symbol `G`",
        ),
        (
            format!("{head}symbols = true\n[answers]\nomega_0_squared = \"g/2*π*q\"\n"),
            "mine.toml:5:26",
            "unknown symbol `q`",
        ),
        (
            format!("{head}symbols = true\n[answers]\nomega_0_squared = 3\n"),
            "mine.toml:5:19",
            "must be a string",
        ),
        (
            "topic = \"units\"\nseed = 1\nsymbols = true\n[answers]\n".to_owned(),
            "mine.toml:3:11",
            "no problem in symbols",
        ),
        (
            "topic = \"angular-momentum\"\nseed = 1\n[answers]\nL = [1, 2]\n".to_owned(),
            "mine.toml:4:5",
            "an array of 3 components",
        ),
    ] {
        let found = refused(&text);
        assert!(found.contains(place) && found.contains(message), "{text}\n{found}");
    }
    let text = format!("{head}[answers]\nomega_0 = \"1 rad/s\"\n");
    let other = refused_by(&Request { topic: Some("cones".to_owned()), ..grading() }, &text);
    assert!(other.contains("mine.toml:1:9") && other.contains("\"cones\", the requested topic"), "{other}");
    let other = refused_by(&Request { seed: Some(5), ..grading() }, &text);
    assert!(other.contains("mine.toml:2:8") && other.contains("5, the requested seed"), "{other}");
    let other = refused_by(&Request { symbols: true, ..grading() }, &text);
    assert!(other.contains("the problem in symbols is requested"), "{other}");
    let absent = run(&grading(), &Memory::default()).unwrap_err().to_string();
    assert!(absent.contains("mine.toml"), "{absent}");
}
