//! Pages of reports: verdict and answer first, contents, legible pictures, no external reference.

use crate::common::{Scratch, example};

/// Smallest size of letters on a page, px.
const LEAST: f64 = 12.0;

/// Returns the value of an attribute of the first tag of a text, or the number in it.
fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let from = tag.find(&format!(" {name}=\""))? + name.len() + 3;
    tag[from..].split('"').next()
}

/// Returns the parts of a text between two marks, the first mark included.
fn between<'a>(text: &'a str, from: &'a str, to: &'a str) -> impl Iterator<Item = &'a str> {
    text.match_indices(from).map(move |(at, _)| &text[at..at + text[at..].find(to).unwrap()])
}

fn number(tag: &str, name: &str) -> f64 {
    attribute(tag, name).unwrap().parse().unwrap()
}

/// Requires a page whose summary has a class and a word, and returns it.
fn page(scratch: &Scratch, arguments: &[&str], [class, word]: [&str; 2]) -> String {
    let output = scratch.run(arguments);
    let page = String::from_utf8(output.stdout).unwrap();
    let place = |what: &str| page.find(what).unwrap_or_else(|| panic!("{arguments:?}: {what}"));
    // The verdict and the answer come first.
    assert!(place(&format!("<div class=\"summary {class}\">")) < place(&format!("{word}</b>")));
    assert!(place(&format!("{word}</b>")) < place("<ul class=\"answer\">"));
    assert!(place("<ul class=\"answer\">") < place("<nav ") && place("<nav ") < place("<main>"));
    // Each section has a link, and each link a section.
    let links: Vec<&str> = between(&page, "href=\"#", "\">").map(|link| &link[7..]).collect();
    let sections: Vec<&str> = between(&page, "<section id=\"", "\">").map(|section| &section[13..]).collect();
    assert_eq!(links, sections, "{arguments:?}");
    // The names of SVG and MathML are the only addresses.
    assert_eq!(page.matches("://").count(), page.matches("xmlns=\"http://www.w3.org/").count());
    for wrong in ["<script", "<link", "<img", " src=", "@import", "NaN"] {
        assert!(!page.contains(wrong), "{arguments:?}: {wrong}");
    }
    for svg in between(&page, "<svg ", "</svg>") {
        let width: f64 = attribute(svg, "viewBox").unwrap().split(' ').nth(2).unwrap().parse().unwrap();
        let scale = number(svg, "width") / width;
        for tag in between(svg, " font-size=\"", ">") {
            assert!(scale * number(tag, "font-size") >= LEAST, "{arguments:?}: {tag}");
        }
    }
    page
}

#[test]
fn budgets_have_a_page() {
    let list = example("budget/cubesat.csv");
    let scratch = Scratch::new("page-budget");
    let page = page(&scratch, &["budget", &list, "--draws", "300", "--html"], ["fail", "✗ Fail"]);
    assert!(page.contains("<td class=\"fail\">not met</td>") && page.contains("<td class=\"ok\">met</td>"));
    // Numbers that are wider than the page scroll.
    assert_eq!(
        page.matches("<table>").count(),
        page.matches("<div class=\"scroll\" tabindex=\"0\">\n<table>").count()
    );
}

#[test]
fn identified_bodies_have_a_page() {
    let scratch = Scratch::new("page-identify");
    let plan = example("identify/racket-like.toml");
    let racket = page(&scratch, &["identify", &plan, "--html"], ["ok", "✓ OK"]);
    for words in [
        "rod, axis 1",
        "thin plate",
        "sphere, cube",
        "no body can have",
        "this body: i1/i3 = 0.09066 ± 0.00015",
    ] {
        assert!(racket.contains(words), "{words}");
    }
    let plan = example("identify/rod-logs.toml");
    page(&scratch, &["identify", &plan, "--html"], ["warning", "! Warning"]);
}

#[test]
fn judged_runs_have_a_page() {
    let scratch = Scratch::new("page-judge");
    page(&scratch, &["judge", &example("judge/mujoco-rk4.csv"), "--html"], ["ok", "✓ OK"]);
    let run = example("judge/pybullet-default.csv");
    let page = page(&scratch, &["judge", &run, "--html"], ["fail", "✗ Fail"]);
    assert!(page.contains("<td class=\"warning\">likely</td>") && page.contains("not likely"));
}

#[test]
fn checked_models_have_a_page() {
    let scratch = Scratch::new("page-check");
    let bad = page(&scratch, &["check", &example("robots/bad-arm.urdf"), "--html"], ["fail", "✗ Fail"]);
    // The worst come first, each with its place, its rule and its fix.
    assert!(bad.find("Impossible: ").unwrap() < bad.find("Suspect: ").unwrap());
    for words in [
        "mass 1,2 → 1.2",
        "bad-arm.urdf:24:77",
        "the sum of any two principal moments is at least the third",
        "<td class=\"fail\">impossible</td>",
    ] {
        assert!(bad.contains(words), "{words}");
    }
    let robots = example("robots");
    let html = scratch.run(&["check", &robots, "--html"]).stdout;
    assert_eq!(html, scratch.run(&["check", &robots, "--format", "html"]).stdout);
    let good = scratch.run(&["check", &example("robots/arm.urdf"), "--html"]);
    assert!(String::from_utf8(good.stdout).unwrap().contains("<b>✓ OK</b> No impossible or suspect finding"));
}

#[test]
fn sweeps_have_a_page() {
    let scratch = Scratch::new("page-sweep");
    let plan = std::fs::read_to_string(example("sweeps/cubesat-pointing.toml")).unwrap();
    let plan = plan.replace("members = 2048", "members = 32").replace("\"2 orbits\"", "\"0.1 orbits\"");
    scratch.write("plan.toml", &plan);
    let page = page(&scratch, &["sweep", "plan.toml", "--html"], ["ok", "✓ OK"]);
    for words in
        ["<li>lost: ", "confidence interval", "2. Outcomes", "3. Inputs", "sampling = &quot;sobol&quot;"]
    {
        assert!(page.contains(words), "{words}");
    }
    // A finished sweep prints the same page again.
    let again = scratch.run(&["sweep", "plan.toml", "--resume", "--html"]);
    assert_eq!(String::from_utf8(again.stdout).unwrap(), page);
}
