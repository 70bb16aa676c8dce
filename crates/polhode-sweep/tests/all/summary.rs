//! Report of a sweep: text, JSON and figures of artificial numbers.

use polhode_sweep::SweepFigures;
use polhode_sweep::{
    SweepAttitude, SweepCorrelation, SweepHistogram, SweepIntervals, SweepQuantile, SweepQuestion,
    SweepSample, SweepShare, SweepStatistic, SweepStep, SweepSummary,
};

/// Returns the statistics of the numbers from 1 to n, times a factor.
fn statistic(name: &str, unit: &str, n: u64, factor: f64) -> SweepStatistic {
    let at = |x: f64| factor * (1.0 + x * (n - 1) as f64);
    let quantile = |p: f64| SweepQuantile {
        probability: p,
        value: at(p),
        interval: [(p > 0.02).then(|| at(p * 0.9)), (p < 0.98).then(|| at(p * 1.01))],
    };
    SweepStatistic {
        name: name.to_owned(),
        unit: unit.to_owned(),
        description: "made by \"hand\"".to_owned(),
        count: n,
        mean: Some(at(0.5)),
        mean_interval: Some([at(0.48), at(0.52)]),
        standard_deviation: Some(0.3 * at(0.5)),
        min: Some(at(0.0)),
        max: Some(at(1.0)),
        quantiles: [0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99].map(quantile).to_vec(),
        histogram: Some(SweepHistogram {
            least: at(0.0),
            greatest: at(0.9),
            log: n > 500,
            counts: vec![0, 3, 20_000, 5],
            below: 0,
            above: n / 10,
        }),
    }
}

fn summary() -> (SweepSummary, SweepSample) {
    let share = |name: &str, count: u64| SweepShare {
        name: name.to_owned(),
        count,
        interval: Some([0.9 * count as f64 / 1000.0, (1.1 * count as f64 / 1000.0).min(1.0)]),
    };
    let constant = SweepStatistic {
        mean_interval: None,
        min: Some(3.2),
        max: Some(3.2),
        histogram: None,
        ..statistic("mass_kg", "kg", 1000, 1.0)
    };
    let none = SweepStatistic {
        count: 0,
        mean: None,
        min: None,
        max: None,
        quantiles: Vec::new(),
        histogram: None,
        ..statistic("growth_rate_per_s", "1/s", 2, 1.0)
    };
    let summary = SweepSummary {
        title: Some("Debris <script> & \u{202e}co.".to_owned()),
        digest: "0123".to_owned(),
        members: 1000,
        sampling: "monte_carlo",
        seed: Some(7),
        intervals: SweepIntervals::Given { confidence: 0.95 },
        statuses: vec![share("complete", 998), share("failed", 2)],
        regimes: vec![share("long_axis", 600), share("short_axis", 398)],
        end_regimes: vec![share("long_axis", 998)],
        questions: vec![SweepQuestion {
            name: "slow".to_owned(),
            condition: "period_s > 20 h".to_owned(),
            count: 249,
            of: 998,
            share: Some(249.0 / 998.0),
            interval: Some([0.22, 0.28]),
            convergence: (1..=10)
                .map(|k| SweepStep {
                    members: 100 * k,
                    share: 0.25 + 0.1 / k as f64,
                    interval: Some([0.2, 0.4]),
                })
                .collect(),
        }],
        attitudes: vec![SweepAttitude { name: "end_attitude".to_owned(), mean: [0.5, 0.5, -0.5, 0.5] }],
        failures: vec![(17, "its \u{1b}[31mmoments are impossible".to_owned())],
        inputs: vec![statistic("start_spin_body_x_rad_s", "rad/s", 1000, 1e-7)],
        outcomes: vec![
            statistic("period_s", "s", 998, 3600.0),
            constant,
            none,
            statistic("event_<b>_first_s", "s", 300, -2.0),
        ],
        sampled: 4,
        correlations: vec![SweepCorrelation {
            input: "start_spin_body_x_rad_s".to_owned(),
            outcome: "period_s".to_owned(),
            value: -0.754,
        }],
    };
    let sample = SweepSample {
        names: vec!["start_spin_body_x_rad_s".to_owned(), "period_s".to_owned()],
        columns: vec![
            vec![Some(1e-7), Some(2e-6), Some(5e-5), Some(1e-4)],
            vec![Some(3600.0), None, Some(1e5), Some(1e9)],
        ],
        regimes: ["long_axis", "short_axis", "short_axis", "long_axis"]
            .map(|name| Some(name.to_owned()))
            .to_vec(),
        inputs: vec!["start_spin_body_x_rad_s".to_owned()],
        answers: vec![vec![Some(false), None, Some(true), Some(true)]],
    };
    (summary, sample)
}

#[test]
fn text_fits_its_screen_and_says_what_matters() {
    let (summary, _) = summary();
    let text = summary.to_text();
    for line in text.lines() {
        assert!(line.chars().count() <= 110 && !line.contains(['\u{1b}', '\u{202e}']), "{line}");
    }
    for says in [
        "Debris <script> & \\u{202e}co.   1,000 members, Monte Carlo sampling, seed 7\n",
        "complete 998 (99.8 %, 89.82 … 100 %); failed 2 (0.2 %, 0.18 … 0.22 %)",
        "member 17: its \\u{1b}[31mmoments",
        "regime at end    long_axis 998",
        "period_s (998)",
        "constant         mass_kg 3.2",
        "-0.75  period_s with start_spin_body_x_rad_s",
        "95 % confidence: Student's t for means",
        "slow             24.95 % (22 … 28 %) have period_s > 20 h: 249 of 998; 2 members lack a value",
    ] {
        assert!(text.contains(says), "{says}\n{text}");
    }
    assert!(!text.contains("growth_rate"), "{text}");
}

#[test]
fn json_has_every_number_and_no_others() {
    let (summary, _) = summary();
    let json = summary.to_json();
    assert_eq!(json["status"]["failed"]["count"], 2);
    assert_eq!(json["outcomes"]["period_s"]["quantiles"]["0.5"]["value"], 3600.0 * 499.5);
    assert!(json["outcomes"]["period_s"]["quantiles"]["0.01"]["interval"][0].is_null());
    assert_eq!(json["outcomes"]["mass_kg"]["histogram"], serde_json::Value::Null);
    assert_eq!(json["outcomes"]["growth_rate_per_s"]["mean"], serde_json::Value::Null);
    assert_eq!(json["intervals"]["confidence"], 0.95);
    assert_eq!(json["correlations"]["strongest"][0]["value"], -0.754);
    assert_eq!(json["failures"][0]["member"], 17);
    assert_eq!(json["seed"], 7);
}

#[test]
fn pictures_are_svg_whatever_names_say() {
    let (summary, sample) = summary();
    let figures = SweepFigures::new(&summary, &sample);
    for svg in [figures.histograms().to_svg(), figures.pairs().to_svg()] {
        let document = roxmltree::Document::parse(&svg).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(document.root_element().tag_name().name(), "svg");
        assert!(
            !svg.contains("NaN") && !svg.contains("inf") && !svg.contains("<script") && !svg.contains("<b>")
        );
    }
    // The title is the column's name; the axis has quantity and unit.
    let svg = figures.histograms().to_svg();
    for words in [">period_s<", ">period (s)<", ">members (10³)<"] {
        assert!(svg.contains(words), "{words}: {svg}");
    }
    let svg = figures.pairs().to_svg();
    assert!(svg.contains("r = −0.75") && svg.contains(">start spin body x (rad/s)<"), "{svg}");
    let empty = SweepSummary { outcomes: Vec::new(), correlations: Vec::new(), ..summary.clone() };
    let figures = SweepFigures::new(&empty, &sample);
    assert!(
        figures.histograms().to_svg().contains("nothing to plot")
            && figures.pairs().to_svg().contains("nothing")
    );
}

#[test]
fn questions_have_their_answers_their_figure_and_why_they_have_none() {
    let (mut summary, sample) = summary();
    let json = summary.to_json();
    let slow = &json["questions"]["slow"];
    assert_eq!((slow["count"].as_u64(), slow["of"].as_u64()), (Some(249), Some(998)));
    assert_eq!(slow["convergence"][9]["members"], 1000);
    assert_eq!(json["mean_attitudes"]["end_attitude"][2], -0.5);
    let svg = SweepFigures::new(&summary, &sample).questions().unwrap().to_svg();
    for says in ["period_s &gt; 20 h", "24.95 % (22 … 28 %)", "members", "yes", "no"] {
        assert!(svg.contains(says), "{says}");
    }
    assert!(!svg.contains("NaN"));
    summary.intervals = SweepIntervals::OfSets { confidence: 0.95, sets: 16 };
    assert!(summary.to_text().contains("between 16 independent sets"));
    assert_eq!(summary.to_json()["intervals"]["sets"], 16);
    summary.questions[0] = SweepQuestion { share: None, of: 0, count: 0, ..summary.questions[0].clone() };
    assert!(summary.to_text().contains("no member has a value in every column of period_s > 20 h"));
    summary.questions.clear();
    assert!(SweepFigures::new(&summary, &sample).questions().is_none());
}
