//! Exercises: problems, grades, errors in the text of answers, solutions.

use serde_json::{Value, json};

use crate::session::Session;

/// Right answer to box-about-corner with seed 7; products of inertia are negative.
const RIGHT: &str = "I = [\n  [\"0.1144 kg m^2\", \"-0.1195 kg m^2\", \"-0.0755 kg m^2\"],\n  \
    [\"-0.1195 kg m^2\", \"0.343 kg m^2\", \"-0.0388 kg m^2\"],\n  \
    [\"-0.0755 kg m^2\", \"-0.0388 kg m^2\", \"0.392 kg m^2\"],\n]\n";

fn ask(topic: &str, seed: u64, symbols: bool, answers: Option<&str>, solution: bool) -> Value {
    let request =
        json!({ "topic": topic, "seed": seed, "symbols": symbols, "answers": answers, "solution": solution });
    Session::default().ask(&json!({ "exercise": request })).json
}

fn graded(answers: &str) -> Value {
    ask("box-about-corner", 7, false, Some(answers), false)
}

#[test]
fn topics_and_a_problem_without_grades_and_solution() {
    let topics = Session::default().ask(&json!("exercises")).json["topics"].clone();
    assert_eq!(topics.as_array().unwrap().len(), polhode_course::exercise::topics().count());
    assert!(topics.as_array().unwrap().iter().any(|one| one["topic"] == "box-about-corner"));
    let asked = ask("box-about-corner", 7, false, None, false);
    assert_eq!(asked["problem"][0]["kind"], "heading");
    assert!(asked["problem"][0]["text"].as_str().unwrap().contains("box-about-corner, seed 7"), "{asked:#}");
    assert!(!asked["problem"].to_string().contains("polhode exercise"), "the page has a field: {asked:#}");
    let blank = "  [\"? kg m^2\", \"? kg m^2\", \"? kg m^2\"],\n".repeat(3);
    assert_eq!(asked["template"], format!("I = [\n{blank}]\n"));
    assert_eq!(
        (&asked["grades"], &asked["errors"], &asked["solution"]),
        (&Value::Null, &json!([]), &Value::Null)
    );
}

#[test]
fn answers_are_graded_and_the_solution_is_typeset() {
    assert_eq!(graded(RIGHT)["grades"], json!([{ "name": "I", "grade": "right", "reason": "" }]));
    let wrong = graded(&RIGHT.replace('-', ""))["grades"][0].clone();
    assert_eq!(wrong["grade"], "wrong");
    assert!(wrong["reason"].as_str().unwrap().contains("sign of the products"), "{wrong}");
    let template = ask("box-about-corner", 7, false, None, false)["template"].as_str().unwrap().to_owned();
    assert_eq!(graded(&template)["grades"][0]["grade"], "missing");
    let solved = ask("box-about-corner", 7, false, None, true)["solution"].to_string();
    assert!(solved.contains("<math") && solved.contains("0.392133"), "{solved}");
    // Another seed has other numbers.
    assert_eq!(ask("box-about-corner", 8, false, Some(RIGHT), false)["grades"][0]["grade"], "wrong");
    let formula = "omega_0_squared = \"2*g*(2*m_1 + m_2)/(b*(4*m_1 + m_2))\"\n";
    let symbolic = ask("two-mass-pendulum", 4, true, Some(formula), false);
    assert_eq!(symbolic["grades"][0]["grade"], "right", "{symbolic:#}");
}

#[test]
fn an_error_is_at_its_place_in_the_answers() {
    // ß and 𝛚 have one and two UTF-16 units.
    let answer = graded("# ß 𝛚\nI = [1, 2]\n");
    assert_eq!((&answer["grades"], answer["errors"].as_array().unwrap().len()), (&Value::Null, 1));
    let error = &answer["errors"][0];
    assert_eq!([&error["line"], &error["column"], &error["from"], &error["to"]], [2, 5, 11, 17], "{error}");
    let error =
        ask("two-mass-pendulum", 4, true, Some("omega_0_squared = \"G/b\"\n"), false)["errors"][0].clone();
    assert_eq!([&error["line"], &error["column"], &error["from"]], [1, 20, 19], "{error}");
    assert!(error["hint"].as_str().is_some_and(|hint| hint.contains("g")), "{error}");
    // The text cannot choose another exercise.
    for (line, words) in
        [("seed = 8\n", "seed"), ("[symbols]\n", "symbols"), ("[answers]\n", "duplicate key")]
    {
        let error = graded(&format!("{RIGHT}{line}"))["errors"][0].clone();
        assert!(error["message"].as_str().unwrap().contains(words), "{error}");
        assert_eq!(error["line"], 6, "{error}");
    }
}

#[test]
fn an_exercise_that_does_not_exist_is_refused() {
    for (topic, symbols, part) in
        [("box-about-korner", false, "unknown topic"), ("principal-moments", true, "no problem in symbols")]
    {
        let refusal = ask(topic, 7, symbols, None, false)["refusal"].clone();
        assert_eq!(refusal["kind"], "not_found");
        assert!(refusal["message"].as_str().unwrap().contains(part), "{refusal}");
    }
    let negative = json!({ "topic": "box-about-corner", "seed": -1, "symbols": false, "answers": null, "solution": false });
    let refusal = Session::default().ask(&json!({ "exercise": negative })).json["refusal"].clone();
    assert_eq!(refusal["kind"], "bad_request");
}
