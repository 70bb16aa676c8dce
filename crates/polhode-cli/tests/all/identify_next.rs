//! `polhode identify`: pictures of its page, and the next experiment.

use serde_json::Value;

use crate::common::figures::compare;
use crate::common::{Scratch, example, json, number, numbers, stdout};

const EXAMPLES: [&str; 3] = ["racket-like", "bifilar", "payload"];

fn report(scratch: &Scratch, name: &str) -> Value {
    json(&scratch.run(&["identify", &example(&format!("identify/{name}.toml")), "--json"]))
}

#[test]
fn the_place_on_the_triangle_is_that_of_the_moments() {
    let scratch = Scratch::new("identify-triangle");
    for name in EXAMPLES {
        let report = report(&scratch, name);
        let principal = &report["principal"];
        let (ratios, sd) = (numbers(&principal["ratios"]), numbers(&principal["ratio_sd"]));
        let r = number(&principal["ratio_correlation"]);
        // Masses in the corners: ∫x² dm along each axis.
        let sum = ratios[0] + ratios[1] + 1.0;
        let weights = [ratios[0], ratios[1], 1.0].map(|moment| 1.0 - 2.0 * moment / sum);
        let corners = principal["triangle"]["corners"].as_array().unwrap();
        let place = numbers(&principal["triangle"]["place"]);
        for c in 0..2 {
            let want: f64 = (0..3).map(|k| weights[k] * number(&corners[k][c])).sum();
            assert!((place[c] - want).abs() < 1e-14, "{name}");
        }
        let regions = principal["triangle"]["regions"].as_array().unwrap();
        assert_eq!(regions.len(), 2);
        for (region, probability) in regions.iter().zip([0.68, 0.95]) {
            assert_eq!(number(&region["probability"]), probability);
            for point in region["outline"].as_array().unwrap() {
                let point = numbers(point);
                let [a, b] = [0, 1].map(|k| (point[k] - ratios[k]) / sd[k]);
                let square = (a * a - 2.0 * r * a * b + b * b) / (1.0 - r * r);
                assert!((1.0 - (-0.5 * square).exp() - probability).abs() < 1e-6, "{name}: {square}");
            }
        }
    }
}

#[test]
fn moments_have_the_covariance_of_their_ratios() {
    let scratch = Scratch::new("identify-moments");
    for name in ["bifilar", "payload"] {
        let principal = &report(&scratch, name)["principal"];
        let [moments, sd, ratio_sd] =
            ["moments", "moment_sd", "ratio_sd"].map(|key| numbers(&principal[key]));
        let c: Vec<Vec<f64>> =
            principal["moment_covariance"].as_array().unwrap().iter().map(numbers).collect();
        for k in 0..3 {
            assert!((c[k][k].sqrt() / sd[k] - 1.0).abs() < 1e-12, "{name}");
        }
        for k in 0..2 {
            // δ(a/b) = (δa − (a/b) δb)/b.
            let r = moments[k] / moments[2];
            let square = c[k][k] - 2.0 * r * c[k][2] + r * r * c[2][2];
            assert!((square.sqrt() / moments[2] / ratio_sd[k] - 1.0).abs() < 1e-9, "{name}");
        }
    }
    assert!(report(&scratch, "racket-like")["principal"]["moment_covariance"].is_null());
}

#[test]
fn pages_have_the_pictures_and_texts_have_the_words() {
    let scratch = Scratch::new("identify-pages");
    let left = ["Residuals of flight", "Residuals by test", "Residuals of the torque"];
    for (name, left) in EXAMPLES.into_iter().zip(left) {
        let plan = example(&format!("identify/{name}.toml"));
        let page = stdout(&scratch.run(&["identify", &plan, "--html"]));
        for words in [
            "<title>The triangle of moments</title>",
            "no body can have",
            "<title>Correlations</title>",
            left,
            "Recommended next measurements",
        ] {
            assert!(page.contains(words), "{name}: {words}");
        }
        assert!(!page.contains("NaN") && !page.contains("<script"), "{name}");
        let text = stdout(&scratch.run(&["identify", &plan]));
        for words in [left, "Recommended next measurements", "Most useful: ", "present state"] {
            assert!(text.contains(words), "{name}: {words}");
        }
        assert!(!text.contains("triangle of moments"), "letters do not show it");
        assert!(!text.contains("\n\n\n"), "a picture that is not drawn leaves no gap: {text}");
        assert!(stdout(&scratch.run(&["identify", &plan, "--markdown"])).contains(left));
    }
}

#[test]
fn correlations_are_those_of_the_covariance() {
    let scratch = Scratch::new("identify-correlation");
    let report = report(&scratch, "bifilar");
    let all = report["estimate"]["numbers"].as_array().unwrap();
    let (covariance, correlation) = (&report["estimate"]["covariance"], &report["estimate"]["correlation"]);
    for (i, a) in all.iter().enumerate() {
        for (j, b) in all.iter().enumerate() {
            let (a, b) = (number(&a["sd"]), number(&b["sd"]));
            match correlation[i][j].as_f64() {
                Some(r) => assert!((r * a * b - number(&covariance[i][j])).abs() < 1e-12 * a * b),
                None => assert!(a == 0.0 || b == 0.0, "{i} {j}"),
            }
        }
    }
}

#[test]
fn the_best_comes_first_and_is_better_than_nothing() {
    let scratch = Scratch::new("identify-next");
    for (name, kind) in EXAMPLES.into_iter().zip(["flight", "number", "turn"]) {
        let next = &report(&scratch, name)["next"];
        let candidates = next["candidates"].as_array().unwrap();
        let sd = |known: &Value| number(&known["largest_sd"]);
        assert_eq!(candidates[0]["kind"], kind, "{name}");
        assert!(sd(&candidates[0]["then"]) < 0.95 * sd(&next["now"]), "{name}");
        for pair in candidates.windows(2) {
            assert!(sd(&pair[0]["then"]) <= sd(&pair[1]["then"]), "{name}");
        }
        // More measurements never increase the error.
        assert!(candidates.iter().all(|c| sd(&c["then"]) <= sd(&next["now"]) * (1.0 + 1e-9)), "{name}");
        let parts = next["now"]["least_known"].as_object().unwrap();
        let square: f64 = parts.values().map(|part| number(part).powi(2)).sum();
        assert!((square - 1.0).abs() < 1e-12, "{name}");
        assert_eq!(next["refused"].as_array().unwrap().len(), 0);
    }
    // All tests share the radius of the wires; its error contributes most to their errors.
    let next = &report(&scratch, "bifilar")["next"];
    assert_eq!(next["candidates"][0]["number"], "radius");
    let swing = next["candidates"].as_array().unwrap().iter().find(|c| c["kind"] == "test").unwrap();
    assert_eq!(numbers(&swing["predicted"]["swings"]), [40.0]);
    let time = numbers(&swing["predicted"]["time_s"])[0];
    assert!((48.0..66.0).contains(&time), "{time}");
}

#[test]
fn the_books_pictures_are_those_of_the_examples() {
    let scratch = Scratch::new("identify-book");
    let [racket, bifilar, payload] =
        ["racket-like", "bifilar", "payload"].map(|name| example(&format!("identify/{name}.toml")));
    let of = |plan| ["identify", plan, "--html"];
    compare(
        &scratch,
        &[
            (&of(&racket), "The triangle of moments", "identify-triangle.svg"),
            (&of(&racket), "Residuals of flight", "identify-left.svg"),
            (&of(&bifilar), "Correlations", "identify-correlations.svg"),
            (&of(&bifilar), "Residuals by test", "identify-swing-left.svg"),
            (&of(&payload), "Residuals of the torque", "identify-payload-left.svg"),
        ],
    );
}
