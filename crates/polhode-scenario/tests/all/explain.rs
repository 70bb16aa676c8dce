//! Worked solutions: their numbers compared with formulas computed here, and their format.

use polhode::math::{Direction, Position, Rotation};
use polhode::motion::Scenario;
use polhode::motion::Suspension;
use polhode_document::SourceInfo;
use polhode_document::json::pretty;
use polhode_document::{Block, Document};
use polhode_scenario::report::{MotionReport, explain};
use polhode_shape::report::InertiaReport;

use crate::common::Solution;

/// Returns the text of one section.
fn section(document: &Document, number: usize) -> String {
    let mut one = document.clone();
    one.sections = vec![document.sections[number].clone()];
    one.answer.clear();
    one.to_text(100)
}

/// Returns the numbers that follow a text.
fn after(text: &str, marker: &str) -> Vec<f64> {
    let start = text.find(marker).unwrap_or_else(|| unreachable!("no {marker:?} in\n{text}")) + marker.len();
    let line = text[start..].lines().next().unwrap_or_default();
    // Groups of digits: a space between two digits is not a separator.
    let mut joined = String::new();
    let chars: Vec<char> = line.chars().collect();
    for (k, c) in chars.iter().enumerate() {
        let digit = |i: Option<&char>| i.is_some_and(char::is_ascii_digit);
        if !(*c == ' ' && k > 0 && digit(chars.get(k - 1)) && digit(chars.get(k + 1))) {
            joined.push(*c);
        }
    }
    joined
        .split(|c: char| !(c.is_ascii_digit() || "+-.e".contains(c)))
        .filter_map(|s| s.parse().ok())
        .collect()
}

fn near(got: f64, want: f64) {
    assert!((got - want).abs() <= 6e-6 * want.abs().max(1e-9), "{got} is not {want}");
}

#[test]
fn the_dumbbell_finds_the_torque_and_answers_the_notes_question() {
    let [m1, m2, b, omega, alpha] = crate::common::DUMBBELL;
    let document = explain(&crate::common::dumbbell()).unwrap();
    let (sin, cos) = alpha.sin_cos();
    let torque = -(m1 + m2) * b * b * omega * omega * sin * cos;
    let euler = section(&document, 4);
    let n = after(&euler, "back in body axes:\n\n    N = ");
    near(n[0], torque);
    assert_eq!(n[1..3], [0.0, 0.0]);
    // F = m ω × (ω × r): across the rod m b ω² sin α cos α, along it m b ω² sin² α inward
    for (name, m, sign) in [("F1 = ", m1, 1.0), ("F2 = ", m2, -1.0)] {
        let f = after(&euler, name);
        assert_eq!(f[0], 0.0);
        near(f[1], sign * m * b * omega * omega * sin * cos);
        near(f[2], -sign * m * b * omega * omega * sin * sin);
    }
    assert!(document.answer.iter().any(|line| line.contains("The motion requires N =")));
    assert!(euler.contains("Σ rα × Fα"));
    // The tensor of the notes, term by term; the text names the rod.
    let tensor = section(&document, 3);
    assert!(tensor.contains("Ixx = Σ m (y² + z²) = 1.2·(0² + 0.5²) + 0.7·(0² + (-0.5)²) = 0.475 kg·m²"));
    assert!(tensor.contains("a rod: axis 1 is its line"));
}

#[test]
fn the_pendulum_swings_at_the_notes_frequency() {
    let [m1, m2, b, g, angle] = crate::common::PENDULUM;
    let document = explain(&crate::common::pendulum()).unwrap();
    let solved = section(&document, 5);
    let small = ((m1 + 0.5 * m2) / (m1 + 0.25 * m2) * g / b).sqrt();
    near(after(&solved, "    ω0 = ")[0], small);
    near(after(&solved, "    ω0² = ")[4], small * small);
    // The minus sign that the notes omit.
    assert!(solved.contains("θ\u{308} ≃ −ω0² θ"));
    near(after(&solved, "-ω0² sin θ = ")[0], -small * small * angle.sin());
    // Pendulum series: P/P0 = 1 + θ²/16 + 11 θ⁴/3072 + …
    let longer = angle.powi(2) / 16.0 + 11.0 / 3072.0 * angle.powi(4);
    near(after(&solved, "°)\n    P = ")[0], std::f64::consts::TAU / small * (1.0 + longer));
}

#[test]
fn the_cube_names_its_free_plane() {
    let tensor = section(&explain(&crate::common::cube()).unwrap(), 3);
    assert!(tensor.contains("λ³ - 36 λ² + 371.25 λ - 816.75 = 0"));
    assert!(tensor.contains("i1 = 3,  i2 = 16.5,  i3 = 16.5 kg·m²"));
    assert!(tensor.contains("The root i2 = i3 is double"));
    assert!(tensor.contains("every direction in the"));
    assert!(tensor.contains("axis 1 = (0.57735, 0.57735, 0.57735)"));
}

#[test]
fn the_symmetric_top_is_solved_as_in_the_notes() {
    let solved = section(&explain(&crate::common::symmetric_top()).unwrap(), 5);
    let (axial, transverse) = (0.18, 4.0 * 0.28 / 12.0);
    let rate = (axial - transverse) / transverse * 2.0;
    near(after(&solved, "Ω   = ")[4], rate);
    near(after(&solved, "A   = |ω - ω_e e| = ")[0], 0.5);
    near(after(&solved, "body cone   half-angle ")[0], 0.25_f64.atan());
    let l = ((transverse * 0.5).powi(2) + (axial * 2.0_f64).powi(2)).sqrt();
    near(after(&solved, "= |L| / I_t = ")[0], l / transverse);
    assert!(after(&solved, "e · (ω × L) / |ω||L| = ")[0] < 1e-14);
    // A cos Ωt along x̂, A sin Ωt along ŷ, after three eighths of a period
    let row = solved.lines().rfind(|line| line.trim_start().starts_with("1.26872")).unwrap();
    let row = after(row, "    ");
    let (sin, cos) = (rate * row[0]).sin_cos();
    assert!((row[1] - 0.5 * (0.8 * cos + 0.6 * sin)).abs() < 1e-5);
    assert!((row[2] - 0.5 * (-0.6 * cos + 0.8 * sin)).abs() < 1e-5);
}

#[test]
fn the_asymmetric_body_is_classified() {
    let solved = section(&explain(&crate::common::t_handle()).unwrap(), 5);
    assert!(solved.contains("D > i2: short-axis mode"));
    assert!(solved.contains("the body flips"));
    assert!(after(&solved, "σ = ")[0] > 0.0);
    let attitude = section(&explain(&crate::common::t_handle()).unwrap(), 6);
    assert!(after(&attitude, "L constant in space to ")[0] < 1e-10);
}

#[test]
fn a_constant_torque_enters_eulers_equations() {
    let document = explain(&crate::common::thruster()).unwrap();
    let rate = after(&section(&document, 4), "ω\u{307}  = ");
    // The residual of I ω̇ = N − ω × I ω in body axes, with the printed ω̇.
    let i = [[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]];
    let (w, n) = ([0.7, -1.1, 0.4], [0.3, -0.1, 0.2]);
    let times = |v: &[f64]| i.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);
    let l = times(&w);
    let cross = [w[1] * l[2] - w[2] * l[1], w[2] * l[0] - w[0] * l[2], w[0] * l[1] - w[1] * l[0]];
    for k in 0..3 {
        assert!((times(&rate)[k] + cross[k] - n[k]).abs() < 1e-5);
    }
    let solved = section(&document, 5);
    let work = after(&solved, "work of the torque ∫ N · ω dt = ");
    near(work[0], work[1]);
}

#[test]
fn a_body_without_start_or_run_is_explained_too() {
    let point_with_a_run = crate::common::point().sampled(crate::common::run(1.0, 3));
    for scenario in [
        crate::common::cube(),
        crate::common::point(),
        point_with_a_run,
        crate::common::tensor("Bare", [3.1, 4.2, 5.3], [0.4, -0.3, 0.2], [0.0; 3]),
    ] {
        let document = explain(&scenario).unwrap();
        assert_eq!(document.sections.len(), 7);
        assert!(document.sections.iter().all(|s| !s.blocks.is_empty()));
    }
}

/// Returns all printed forms of the scenarios.
fn faces() -> Vec<(String, String)> {
    let mut faces = Vec::new();
    for Solution { scenario, trajectory, document } in crate::common::solutions() {
        let title = scenario.title().map(str::to_owned).unwrap_or_default();
        let source = SourceInfo::new("a.toml", "scenario");
        let inertia = InertiaReport::of_scenario(source.clone(), scenario);
        let mut add = |face: String| faces.push((title.clone(), face));
        add(document.to_text(100));
        add(document.to_markdown());
        add(pretty(&document.to_json()));
        add(inertia.to_text());
        add(pretty(&inertia.to_json()));
        if let Some(trajectory) = trajectory {
            let motion = MotionReport::new(source, scenario, trajectory);
            add(motion.to_text());
            add(pretty(&motion.summary_json()));
        }
    }
    faces
}

#[test]
fn nothing_prints_nan_or_infinity_or_minus_zero_or_trailing_space() {
    for (title, face) in faces() {
        for line in face.lines() {
            let words = || line.split(|c: char| !(c.is_alphanumeric() || "-.".contains(c)));
            assert!(words().all(|w| !["NaN", "-NaN", "inf", "-inf"].contains(&w)), "{title}: {line}");
            assert!(!line.contains('∞') && !line.contains('—'), "{title}: {line}");
            assert!(!line.ends_with(' '), "{title}: {line:?}");
            let is_json = line.trim_start().starts_with(['"', '[', '{', '-']) || line.contains("-0.0");
            assert!(is_json || words().all(|w| w != "-0"), "{title}: {line}");
        }
    }
}

/// Returns the number of columns on a terminal.
fn columns(line: &str) -> usize {
    line.chars().filter(|c| !('\u{300}'..='\u{36f}').contains(c)).count()
}

#[test]
fn text_fits_the_width_asked_for() {
    for Solution { document, .. } in crate::common::solutions() {
        for line in document.to_text(100).lines() {
            assert!(columns(line) <= 100, "{}: {line}", columns(line));
        }
        // Tables, matrices and graphs cannot be broken; all other lines can.
        let mut breakable = document.clone();
        for section in &mut breakable.sections {
            section
                .blocks
                .retain(|b| !matches!(b, Block::Table { .. } | Block::Matrix { .. } | Block::Graph(_)));
        }
        for width in [80, 60] {
            for line in breakable.to_text(width).lines() {
                assert!(columns(line) <= width, "{}: {line}", columns(line));
            }
        }
    }
}

#[test]
fn screens_fit_a_hundred_columns() {
    for Solution { scenario, trajectory, .. } in crate::common::solutions() {
        let source = SourceInfo::new("a.toml", "scenario");
        let turn = Rotation::from_axis_angle(Direction::new(0.3, -1.0, 0.7), 1.0 / 3.0).unwrap();
        let inertia = InertiaReport {
            axes: Some(turn),
            about: Some(Position::new(1.0 / 3.0, -1.0 / 7.0, 1.0 / 9.0)),
            ..InertiaReport::of_scenario(source.clone(), scenario)
        };
        let mut text = inertia.to_text();
        if let Some(trajectory) = trajectory {
            text.push_str(&MotionReport::new(source, scenario, trajectory).to_text());
        }
        for line in text.lines() {
            assert!(columns(line) <= 100, "{}: {line}", columns(line));
        }
    }
}

#[test]
fn names_from_a_file_stay_on_their_line_and_steer_nothing() {
    const EVIL: &str = "a\u{1b}[31mRED\nx\u{202e}y";
    const SHOWN: &str = "a\\u{1b}[31mRED\\nx\\u{202e}y";
    let scenario = crate::common::hostile(EVIL);
    let source = SourceInfo::new(EVIL, "scenario").described(EVIL);
    let document = explain(&scenario).unwrap();
    let trajectory = scenario.simulate().unwrap().unwrap();
    let text = [
        document.to_text(100),
        InertiaReport::of_scenario(source.clone(), &scenario).to_text(),
        MotionReport::new(source, &scenario, &trajectory).to_text(),
    ];
    for face in &text {
        assert!(face.lines().next().unwrap().contains(SHOWN), "{face}");
    }
    assert!(section(&document, 0).contains(&format!("    {SHOWN}  cylinder")));
    let markdown = document.to_markdown();
    assert!(markdown.starts_with("# a\\\\u{1b}\\[31mRED\\\\nx\\\\u{202e}y\n"), "{markdown}");
    for face in text.iter().chain([&markdown]) {
        assert!(!face.contains(|c: char| c != '\n' && (c.is_control() || c == '\u{202e}')));
    }
    assert_eq!(document.to_json()["title"], EVIL);
}

#[test]
fn the_elliptic_period_can_be_checked_by_hand() {
    let turning = |omega| crate::common::tensor("Tumbling", [1.0, 2.0, 3.0], [0.0; 3], omega);
    for scenario in [
        crate::common::t_handle(),
        turning([0.3, 2.0, 1.1]),
        turning([1.7, -0.4, 0.2]),
        turning([5e200, 1e200, 1e199]),
    ] {
        let solved = section(&explain(&scenario).unwrap(), 5);
        let lambda = after(&solved, "    λ = ")[0];
        let [m, m1] = [",  k² = ", ",  1 - k² = "].map(|name| after(&solved, name)[0]);
        assert!((m + m1 - 1.0).abs() < 2e-6, "{solved}");
        // K(m) by the midpoint rule, which converges fast for a periodic function.
        let points = 4000;
        let step = std::f64::consts::FRAC_PI_2 / f64::from(points);
        let quadrature: f64 = (0..points)
            .map(|k| ((f64::from(k) + 0.5) * step).sin_cos())
            .map(|(sin, cos)| step / (cos * cos + m1 * sin * sin).sqrt())
            .sum();
        let period = after(&solved, "period of ω = ")[3];
        assert!((4.0 * quadrature / lambda / period - 1.0).abs() < 2e-5, "{quadrature}: {solved}");
        let core = polhode::observe::FreeRegime::of(scenario.rotor(), &scenario.start()).period.unwrap();
        assert!((period / core - 1.0).abs() < 1e-5);
    }
}

#[test]
fn instability_is_spoken_of_near_the_intermediate_axis_only() {
    let spinning = |moments, omega| {
        let mut scenario = crate::common::tensor("Spinning", moments, [0.0; 3], omega);
        scenario = scenario.sampled(crate::common::run(2.0, 5));
        let source = SourceInfo::new("a.toml", "scenario");
        let trajectory = scenario.simulate().unwrap().unwrap();
        explain(&scenario).unwrap().to_text(100)
            + &MotionReport::new(source, &scenario, &trajectory).to_text()
    };
    let near = spinning([1.0, 2.0, 3.0], [0.0, 1.0, 0.1]);
    assert_eq!(near.matches("ω starts 5.71° from").count(), 3, "{near}");
    let far = spinning([1.0, 2.0, 3.0], [1.0, 1.0, 1.0]);
    assert!(!far.contains("σ =") && !far.contains("grows as"), "{far}");
    // With two equal moments no axis is intermediate.
    for omega in [[0.0, 2.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 2.0], [1.0, 2.0, 0.0], [0.1, 2.0, 0.0]] {
        for moments in [[2.0, 2.0, 1.0], [2.0, 2.0, 3.0], [1.0, 2.0, 2.0]] {
            let text = spinning(moments, omega);
            assert!(!text.contains("intermediate") && !text.contains("unstable"), "{text}");
        }
    }
}

#[test]
fn a_swing_over_the_top_is_told_from_one_just_below() {
    let mut scenario = crate::common::pendulum();
    let amplitude = Some(std::f64::consts::PI - 1e-12);
    scenario =
        scenario.suspended_from(Suspension { axis: Direction::new(0.0, 0.0, 1.0), amplitude }).unwrap();
    let trajectory = scenario.simulate().unwrap().unwrap();
    let source = SourceInfo::new("a.toml", "scenario");
    for text in [
        explain(&scenario).unwrap().to_text(100),
        MotionReport::new(source, &scenario, &trajectory).to_text(),
    ] {
        assert!(text.contains("just below 180°") && !text.contains("(180°)"), "{text}");
    }
}

#[test]
fn markdown_is_well_formed() {
    for Solution { document, .. } in crate::common::solutions() {
        let text = document.to_markdown();
        assert!(text.starts_with("# "));
        assert_eq!(text.lines().filter(|l| l.starts_with("## ")).count(), 7);
        assert_eq!(text.lines().filter(|l| *l == "$$").count() % 2, 0);
        assert_eq!(text.lines().filter(|l| l.starts_with("```")).count() % 2, 0);
        assert!(!text.contains('\u{a0}') || !text.contains("```text\n\u{a0}"));
        // In tables, each row has as many cells as the header.
        let cells = |line: &str| line.replace("\\|", "").matches('|').count();
        for pair in text.lines().collect::<Vec<_>>().windows(2) {
            if pair[0].starts_with('|') && pair[1].starts_with('|') {
                assert_eq!(cells(pair[0]), cells(pair[1]), "{} / {}", pair[0], pair[1]);
            }
        }
        for section in &document.sections {
            for block in &section.blocks {
                if let Block::Formula { latex, .. } = block {
                    assert_eq!(latex.matches('{').count(), latex.matches('}').count(), "{latex}");
                    assert_eq!(latex.matches("\\begin").count(), latex.matches("\\end").count());
                    assert!(latex.is_ascii(), "{latex}");
                    // In Markdown a backslash before punctuation is an escape.
                    let bytes = latex.as_bytes();
                    let eaten = bytes.windows(2).any(|w| w[0] == b'\\' && w[1].is_ascii_punctuation());
                    assert!(!eaten, "{latex}");
                }
            }
        }
    }
}

/// Wheel and friction in a body of 2, 3, 4 kg·m² that rotates at (1, 2, 3) rad/s; all numbers from
/// independent formulas.
#[test]
fn what_moves_inside_is_worked_out() {
    use polhode::body::{InertiaTensor, MassProperties};
    use polhode::math::AngularVelocity;
    use polhode::motion::torque::{EnergySink, TorqueModel};
    use polhode::motion::{Motor, Wheel};
    let inertia = InertiaTensor::diagonal([2.0, 3.0, 4.0]).unwrap();
    let held = Wheel::new(Direction::new(0.0, 0.0, 1.0), 5.0, Motor::HeldSpeed).unwrap();
    let body = Scenario::new(MassProperties::new(5.0, Position::ZERO, inertia).unwrap());
    let turning = crate::common::spinning(body, AngularVelocity::new(1.0, 2.0, 3.0));
    let sink = TorqueModel::EnergySink(EnergySink::new(0.01).unwrap());
    let scenario = turning.with_wheels(&[held]).unwrap().with_torques([sink]).unwrap();
    let document = explain(&scenario).unwrap();
    let text = document.to_text(200);
    for line in [
        "h = 5·(0, 0, 1) (held) = (0, 0, 5) kg·m²/s",
        "L = (2, 6, 17) kg·m²/s,  |L| = 18.1384 kg·m²/s",
        "L × ω = (-16, 11, -2) N·m",
        "Ω = ω + α L × ω",
        "Ω = (1, 2, 3) + 0.01·(-16, 11, -2) = (0.84, 2.11, 2.98) rad/s",
        "L × Ω = (-17.99, 8.32, -0.82) N·m",
        "dω/dt = (-8.995, 2.77333, -0.205) rad/s²",
        "T = ½ ω · {I} ω = 25 J",
        "−α |L × ω|² = -0.01·19.5192² = -3.81 W",
        "L is constant in space. T only decreases.",
    ] {
        assert!(text.contains(line), "{line} is missing in\n{text}");
    }
    // Least energy: ω is along L, on the side of the wheel, with |L| = 4 ω + 5.
    let end = section(&document, 5);
    near(after(&end, "ω = (0, 0, ")[0], (329_f64.sqrt() - 5.0) / 4.0);
    // Without friction and with a motor that stops: L stays 0, and the body rotates backwards.
    let schedule = Some(polhode::motion::torque::Schedule::window(1.0, 3.0).unwrap());
    let motor = Motor::Torque { inertia: 0.5, torque: 0.7, schedule };
    let turned = Wheel::new(Direction::new(0.0, 0.0, 1.0), 0.0, motor).unwrap();
    let scenario = Scenario::new(*scenario.body()).with_wheels(&[turned]).unwrap();
    let text = explain(&scenario).unwrap().to_text(200);
    assert!(text.contains("ω = −{I}⁻¹ h = (0, 0, -0.4) rad/s"), "{text}");
}

/// Events that did not happen, and the steady rates of a top, are in the text and in the JSON.
#[test]
fn a_run_says_what_did_not_happen_and_how_a_top_would_precess_steadily() {
    use polhode::math::{AngularVelocity, Attitude};
    use polhode::motion::torque::{TorqueModel, UniformGravity};
    use polhode::motion::{Event, EventAction, Measure, Sense, Wheel};
    let inertia = polhode::body::InertiaTensor::diagonal([0.3, 0.3, 0.2]).unwrap();
    let body = polhode::body::MassProperties::new(1.5, Position::new(0.0, 0.0, 0.4), inertia).unwrap();
    let held = Scenario::new(body).held_at(Position::ZERO).unwrap();
    let leaning = crate::common::facing(held, Attitude::from_euler313([0.3, 0.6, 0.1]).unwrap());
    let top = crate::common::spinning(leaning, AngularVelocity::new(0.0, 0.0, 60.0));
    let scenario = top.with_torques([TorqueModel::Gravity(UniformGravity::STANDARD)]).unwrap();
    let event = |name: &str, value: f64| {
        Event::new(name, Measure::Rate, value, Sense::Either, EventAction::Record).unwrap()
    };
    let scenario = scenario.watching(vec![event("nods", 60.001), event("too fast", 1e6)]).unwrap();
    let scenario = scenario.sampled(crate::common::run(10.0, 201));
    assert_eq!(scenario.wheels(), Vec::<Wheel>::new());
    let trajectory = scenario.simulate().unwrap().unwrap();
    let source = SourceInfo::new("a.toml", "scenario");
    let text = MotionReport::new(source, &scenario, &trajectory).to_text();
    // Joined to one line, independent of line breaks.
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("never happened too fast"), "{text}");
    // A cos θ φ̇² − C ω3 φ̇ + M g l = 0 at the middle of the nutation.
    let (slow, across) = (after(&text, " steady precession ")[0], 0.3 + 1.5 * 0.16);
    let middle = after(&text, "without nutation at ")[0].to_radians();
    let rest = |rate: f64| across * middle.cos() * rate * rate - 0.2 * 60.0 * rate + 1.5 * 9.80665 * 0.4;
    assert!(rest(slow).abs() < 1e-4 && slow > 0.1 && middle > 0.6, "{text}");
    let fast = after(&text, "and the fast one ")[0];
    assert!(rest(fast).abs() < 1e-3 && fast > slow, "{text}");
}

#[test]
fn what_was_noticed_is_said_in_every_form() {
    let scenario = crate::common::symmetric_top().noting([polhode::body::Finding {
        code: "mesh.unit",
        severity: polhode::body::Severity::Warning,
        message: "nobody says the unit".to_owned(),
        place: Some("part \"plate\"".to_owned()),
    }]);
    let document = explain(&scenario).unwrap();
    let said = "warning: nobody says the unit (part \"plate\") [mesh.unit]";
    assert!(document.to_text(100).ends_with(&format!("\n{said}\n")), "{}", document.to_text(100));
    assert_eq!(document.to_json()["findings"][0]["code"], "mesh.unit");
    assert!(
        document.to_markdown().contains("\n> warning: nobody says the unit"),
        "{}",
        document.to_markdown()
    );
}
