//! Exercises of every topic: possible bodies, readable numbers, documents, and the same text for
//! ever.

use std::path::Path;
use std::{env, fs};

use polhode_course::exercise::{
    ExerciseReport, Exercises, REPORT_SCHEMA, REQUEST_SCHEMA, Request, Solution, run, topics,
};
use polhode_document::Report as _;
use polhode_source::files::Memory;
use serde_json::{Value, json};

use crate::schema::require_fits;

/// Number of seeds of each topic.
const SEEDS: u64 = 1000;

/// Returns the JSON of an exercise with its solution.
pub(crate) fn solved(topic: &str, seed: u64) -> Value {
    let exercise = Exercises::of(topic).unwrap().with_seed(seed).unwrap();
    ExerciseReport::Exercise { exercise, solution: Some(Solution::Alone) }.to_json()
}

fn request(topic: &str, symbols: bool, solution: Option<Solution>) -> Request {
    Request { topic: Some(topic.to_owned()), symbols, solution, ..Request::default() }
}

#[test]
fn the_themes_of_the_chapter_are_there() {
    // A topic with a line that is not valid would be left out.
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/exercise/topics");
    let texts = fs::read_dir(folder).unwrap().map(|file| fs::read_to_string(file.unwrap().path()).unwrap());
    let headings: usize = texts.map(|text| text.lines().filter(|line| line.starts_with("## ")).count()).sum();
    let blocks = 3;
    assert_eq!(topics().count() + blocks, headings);
    assert!(topics().count() >= 20);
    let report = run(&Request::default(), &Memory::default()).unwrap();
    require_fits(REPORT_SCHEMA, &report.to_json());
    for topic in topics() {
        assert!(report.to_text(None).contains(topic), "{topic}");
    }
}

#[test]
fn every_seed_is_a_possible_and_readable_exercise() {
    for topic in topics() {
        let exercises =
            Exercises::of(topic).unwrap_or_else(|| panic!("{topic} has a formula that is not valid"));
        for seed in 0..SEEDS {
            let exercise = exercises.with_seed(seed).unwrap_or_else(|| panic!("{topic} {seed}"));
            let report = ExerciseReport::Exercise { exercise, solution: Some(Solution::Alone) }.to_json();
            possible(&report);
        }
    }
}

/// Panics unless bodies are possible, numbers short, and wrong values clearly different.
fn possible(report: &Value) {
    let place = format!("{} {}", report["topic"], report["seed"]);
    let datum = |name: &str| {
        let all = report["data"].as_array().unwrap();
        all.iter().find(|datum| datum["symbol"] == name).map(|datum| datum["value"].as_f64().unwrap())
    };
    for datum in report["data"].as_array().unwrap() {
        let (text, value) = (datum["text"].as_str().unwrap(), datum["value"].as_f64().unwrap());
        let digits = text.chars().take_while(|c| !c.is_whitespace()).filter(char::is_ascii_digit).count();
        assert!(digits <= 6 && value.is_finite() && value != 0.0, "{place}: {text}");
    }
    if let [Some(a), Some(b), Some(c)] = ["I_1", "I_2", "I_3"].map(datum) {
        assert!(a < b + c && b < a + c && c < a + b, "{place}: {a} {b} {c}");
    }
    if let (Some(axial), Some(across), None) = (datum("I_3"), datum("I_1"), datum("I_2")) {
        assert!(report["topic"] == "energy-lost" || axial < 2.0 * across, "{place}: {axial} {across}");
    }
    let elements = ["I_xx", "I_yy", "I_zz", "I_xy", "I_xz", "I_yz"].map(datum);
    if let [Some(xx), Some(yy), Some(zz), Some(xy), Some(xz), Some(yz)] = elements {
        solid([xx, yy, zz, xy, xz, yz], &place);
    }
    for answer in report["solution"].as_array().unwrap() {
        let numbers =
            |value: &Value| value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect::<Vec<_>>();
        let right = numbers(&answer["value"]);
        let size = right.iter().fold(0.0, |most, x| f64::max(most, x.abs()));
        assert!(
            right.iter().all(|x| x.is_finite() && x.abs() >= 0.02 * size && size > 0.0),
            "{place}: {right:?}"
        );
        if let [xx, yy, zz, xy, xz, yz] = right[..] {
            solid([xx, yy, zz, xy, xz, yz], &place);
        }
        for mistake in answer["mistakes"].as_array().unwrap() {
            let wrong = numbers(&mistake["value"]);
            let far = right.iter().zip(&wrong).any(|(a, b)| (a - b).abs() > 0.02 * size);
            assert!(far && wrong.iter().all(|x| x.is_finite()), "{place}: {mistake}");
        }
    }
}

/// Panics unless ∫ x xᵀ dm of a tensor is positive definite.
fn solid([xx, yy, zz, xy, xz, yz]: [f64; 6], place: &str) {
    let [p, q, r] = [(yy + zz - xx) / 2.0, (xx + zz - yy) / 2.0, (xx + yy - zz) / 2.0];
    let determinant = p * q * r - 2.0 * xy * xz * yz - p * yz * yz - q * xz * xz - r * xy * xy;
    assert!(p > 0.0 && p * q > xy * xy && determinant > 0.0, "{place}: {xx} {yy} {zz} {xy} {xz} {yz}");
}

#[test]
fn an_exercise_is_the_same_for_ever() {
    let line = |topic: &str| {
        let report = solved(topic, 7);
        let texts = |key: &str| {
            let all = report[key].as_array().unwrap().iter();
            all.map(|item| item["text"].as_str().unwrap()).collect::<Vec<_>>().join("; ")
        };
        format!("{topic}\n  {}\n  {}\n", texts("data"), texts("solution").replace('\u{a0}', " "))
    };
    let text: String = topics().map(line).collect();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/exercises.txt");
    if env::var_os("POLHODE_WRITE_EXERCISES").is_some() {
        fs::write(&path, &text).unwrap();
    }
    let kept = fs::read_to_string(&path).unwrap();
    assert_eq!(text, kept, "the exercises of a seed have changed; users have them on paper");
}

#[test]
fn documents_are_complete_in_every_format() {
    for topic in topics() {
        let has_symbols = Exercises::of(topic).unwrap().has_symbols();
        for symbols in [false, true].into_iter().filter(|symbols| !symbols || has_symbols) {
            let report = run(&request(topic, symbols, Some(Solution::After)), &Memory::default()).unwrap();
            require_fits(REPORT_SCHEMA, &report.to_json());
            let document = report.to_document();
            let latex = document.to_latex();
            // A letter that LaTeX does not know is replaced by its code point.
            let unknown = latex
                .lines()
                .skip_while(|line| !line.contains("maketitle"))
                .find(|line| line.contains("\\letter"));
            assert_eq!(unknown, None, "{topic}");
            for text in [document.to_text(100), document.to_markdown(), document.to_html()] {
                assert!(text.contains("Way to the solution") && text.contains(topic), "{topic}");
            }
            let problem = run(&request(topic, symbols, None), &Memory::default()).unwrap();
            assert!(problem.to_json()["solution"].is_null());
            assert!(!problem.to_document().answer.is_empty());
            assert!(!problem.to_text(None).contains("If you found"), "{topic}");
            assert!(problem.to_text(None).contains("[answers]"), "{topic}");
        }
    }
}

#[test]
fn requests_fit_their_schema_and_wrong_ones_are_refused() {
    let all = Request {
        seed: Some(3),
        answers: Some("a.toml".into()),
        ..request("cones", true, Some(Solution::After))
    };
    for request in [all, Request::default(), request("cones", false, Some(Solution::Alone))] {
        let value = serde_json::to_value(&request).unwrap();
        require_fits(REQUEST_SCHEMA, &value);
        assert_eq!(serde_json::from_value::<Request>(value).unwrap(), request);
    }
    assert!(serde_json::from_value::<Request>(json!({ "sead": 1 })).is_err());
    let refused = |request: Request| run(&request, &Memory::default()).unwrap_err().to_string();
    let text = refused(request("box-about-korner", false, None));
    assert!(
        text.contains("unknown topic \"box-about-korner\"")
            && text.contains("did you mean box-about-corner?"),
        "{text}"
    );
    let text = refused(request("principal-moments", true, None));
    assert!(text.contains("no problem in symbols") && text.contains("leave out --symbols"), "{text}");
    let text = refused(Request { seed: Some(2), ..Request::default() });
    assert!(text.contains("--seed requires a topic"), "{text}");
}
