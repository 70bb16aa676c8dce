//! Tests of charts: constants in words, curves, and scales.

use super::*;

#[test]
fn what_is_rounding_is_drawn_as_nothing() {
    let scenario = gyrostat();
    let trajectory = scenario.simulate().unwrap().unwrap();
    let figures = MotionFigures::of_scenario(&scenario, &trajectory);
    // L is not exactly zero; its relative deviation from zero is 1.
    assert!(trajectory.samples().iter().any(|s| s.momentum.norm() > 0.0));
    let picture = figures.draw(Figure::Momentum).unwrap();
    let texts: Vec<String> = boxes(&picture).into_iter().map(|(text, _)| text).collect();
    for name in ["Lx = 0, to ", "Ly = 0, to ", "Lz = 0, to ", "|L| = 0, to "] {
        assert!(texts.iter().any(|text| text.starts_with(name)), "{name}: {texts:?}");
    }
    // Nothing is drawn, and the sheet is small.
    assert!(lines(&picture).next().is_none() && picture.sheet.height < 120.0, "{}", picture.sheet.height);
    let largest = balances(&trajectory, figures.motion.driven)
        .into_iter()
        .map(|d| d.values.into_iter().fold(0.0, f64::max));
    assert!(largest.into_iter().all(|d| d < 1e-12));
    // Constants are stated with their values.
    let steady = thrust().starting(State { omega: AngularVelocity::ZERO, ..scenario.start() }).unwrap();
    let trajectory = steady.simulate().unwrap().unwrap();
    let picture = MotionFigures::of_scenario(&steady, &trajectory).draw(Figure::Torque).unwrap();
    let texts: Vec<String> = boxes(&picture).into_iter().map(|(text, _)| text).collect();
    for name in ["Nx = 0.3\u{a0}N·m, constant", "Ny = −0.2\u{a0}N·m, constant", "Nz = 0.5\u{a0}N·m, constant"]
    {
        assert!(texts.iter().any(|text| text == name), "{name}: {texts:?}");
    }
}

#[test]
fn a_torque_of_nothing_takes_no_room_in_the_overview() {
    let sink = TorqueModel::EnergySink(EnergySink::new(0.01).unwrap());
    let scenario = scenario([0.7, -1.1, 0.3]).with_torques([sink]).unwrap();
    let trajectory = scenario.simulate().unwrap().unwrap();
    let figures = MotionFigures::of_scenario(&scenario, &trajectory);
    assert!(trajectory.samples().iter().all(|s| s.torque == Torque::ZERO));
    let has = |picture: &Picture| boxes(picture).iter().any(|(text, _)| text == "Torque in body axes");
    assert!(has(&figures.draw(Figure::Torque).unwrap()));
    assert!(!has(&figures.overview().unwrap()));
}

#[test]
fn a_run_away_leaves_the_plot_where_it_says_so() {
    let scenario = run_away();
    let trajectory = scenario.simulate().unwrap().unwrap();
    assert!(!trajectory.ending().is_complete());
    let last = trajectory.samples().last().unwrap();
    assert!(last.state.omega.z > 300.0 * scenario.start().omega.z, "{:?}", last.state.omega);
    let figures = MotionFigures::of_scenario(&scenario, &trajectory);
    for figure in [Figure::Omega, Figure::Energy, Figure::Momentum, Figure::Torque] {
        let picture = figures.draw(figure).unwrap();
        readable(&picture, figure.name());
        let texts = boxes(&picture);
        assert!(texts.iter().any(|(text, _)| text.starts_with("beyond the frame: to ")), "{texts:?}");
        assert!(picture.sheet.marks.iter().any(|mark| matches!(mark, Mark::Polygon { .. })));
    }
    // The scale of ω(t) = 1/(2 s − t) ends at its last regular sample, 20 rad/s.
    let texts = boxes(&figures.draw(Figure::Omega).unwrap());
    assert!(texts.iter().any(|(text, _)| text == "20") && !texts.iter().any(|(text, _)| text == "50"));
    readable(&figures.overview().unwrap(), "run away");
}

#[test]
fn events_are_named_where_they_happen() {
    let along = Measure::OmegaBody(Direction::new(0.0, 0.0, 1.0));
    let event = |name: &str, value| {
        Event::new(name, along.clone(), value, Sense::Either, EventAction::Record).unwrap()
    };
    let events = vec![event("ω_z = 0.6", 0.6), event("ω_z = 0.601", 0.601), event("never", 1e3)];
    let scenario = thrust().watching(events).unwrap();
    let trajectory = scenario.simulate().unwrap().unwrap();
    let picture = MotionFigures::of_scenario(&scenario, &trajectory).draw(Figure::Omega).unwrap();
    readable(&picture, "events");
    // The legend has the letter and the number of crossings of each event, except events without
    // crossings.
    let texts = boxes(&picture);
    let count = |event: usize| trajectory.events().iter().filter(|crossing| crossing.event == event).count();
    for (k, key) in
        [format!("a: {} × ω_z = 0.6", count(0)), format!("b: {} × ω_z = 0.601", count(1))].iter().enumerate()
    {
        assert!(count(k) > 1 && texts.iter().any(|(text, _)| text == key), "{key}: {texts:?}");
    }
    assert!(!texts.iter().any(|(text, _)| text.contains("never")));
    // Each crossing has a dotted vertical line over the full height of the frame, with letters
    // above. Crossings at one place share a line.
    let frame = frame(&picture);
    let upright = |line: &&Vec<Point>| line.len() == 2 && line[0][0] == line[1][0];
    let lines: Vec<f64> = lines(&picture)
        .filter(|(_, pen)| pen.dash == [2.0, 3.0])
        .filter_map(|(lines, _)| lines.iter().find(upright))
        .map(|line| line[0][0])
        .collect();
    let across = |time: f64| frame[0][0] + time / 13.7 * (frame[2][0] - frame[0][0]);
    for crossing in trajectory.events() {
        let x = across(crossing.state.time);
        assert!(lines.iter().any(|line| (line - x).abs() < 0.6), "{}", crossing.state.time);
    }
    let letters: Vec<_> =
        texts.iter().filter(|(text, _)| ["a", "b", "a,b", "b,a"].contains(&text.as_str())).collect();
    assert!(
        !letters.is_empty() && letters.iter().all(|(_, [.., bottom])| *bottom < frame[0][1]),
        "{letters:?}"
    );
}

/// Fast top: ω₁ is constant, ω₂ and ω₃ vary with the nutation, the torque with the spin.
#[test]
fn what_oscillates_fast_has_an_envelope_and_a_beginning_in_full() {
    let scenario = top(0.7, [0.3, -0.2, 240.0]).sampled(Run::evenly(3.0, 6001, Method::Auto, 1e-12));
    let trajectory = scenario.simulate().unwrap().unwrap();
    let figures = MotionFigures::of_scenario(&scenario, &trajectory);
    let picture = figures.draw(Figure::Torque).unwrap();
    readable(&picture, "stripes");
    let texts = boxes(&picture);
    let has =
        |texts: &[(String, [f64; 4])], start: &str| texts.iter().any(|(text, _)| text.starts_with(start));
    assert!(has(&texts, "whole run: envelope") && has(&texts, "0 to ") && !has(&texts, "dots"), "{texts:?}");
    let bands = picture.sheet.marks.iter().filter(|mark| matches!(mark, Mark::Polygon { .. })).count();
    assert_eq!(bands, 2);
    // The second frame shows about four periods of the spin.
    let frames = lines(&picture).filter(|(lines, _)| lines[0].len() == 5).count();
    assert_eq!(frames, 2);
    // These samples of the same motion are too far apart.
    let coarse = scenario.sampled(Run::evenly(3.0, 401, Method::Auto, 1e-12));
    let trajectory = coarse.simulate().unwrap().unwrap();
    let figures = MotionFigures::of_scenario(&coarse, &trajectory);
    let texts = boxes(&figures.draw(Figure::Torque).unwrap());
    assert!(has(&texts, "dots: samples; the body turns by up to 1.8 rad"), "{texts:?}");
}

#[test]
fn what_samples_miss_is_not_said_to_be_constant() {
    // ω₁ = 0.3 cos(Ω t) with Ω = (1.5 − 1) 4π rad/s = 2π rad/s, which has the same value every
    // second.
    let (motion, _) = moments([1.0, 1.0, 1.5], [0.3, 0.0, 4.0 * std::f64::consts::PI], 1.0);
    let seconds: Vec<f64> = (0..12).map(f64::from).collect();
    let trajectory = Trajectory::of_motion(motion, &seconds).unwrap();
    assert!((motion.at(0.5).omega.x + 0.3).abs() < 1e-12);
    let figures = MotionFigures::of_motion("aliased", &motion, &trajectory);
    for figure in [Figure::Omega, Figure::Energy, Figure::Momentum] {
        let picture = figures.draw(figure).unwrap();
        readable(&picture, "aliased");
        let texts = boxes(&picture);
        let all = texts.iter().map(|(text, _)| text.as_str()).collect::<Vec<_>>().join(" ");
        assert!(!all.contains("constant") && all.contains("the same at all samples"), "{all}");
        assert!(all.contains("the body turns by up to 12.6 rad from one sample to the next"), "{all}");
    }
}

#[test]
fn what_would_be_squashed_has_a_panel_of_its_own() {
    // ω_z grows from 0.3 to 30 rad/s, while the other components remain small.
    let torque = ConstantTorque::Body(Torque::new(0.0, 0.0, 12.0));
    let start = State { omega: AngularVelocity::new(0.02, -0.01, 0.3), ..scenario([0.0; 3]).start() };
    let inertia = InertiaTensor::diagonal([3.1, 4.2, 5.3]).unwrap();
    let body = MassProperties::new(2.3, Position::ZERO, inertia).unwrap();
    let scenario =
        Scenario::new(body).starting(start).unwrap().with_torques([TorqueModel::Constant(torque)]).unwrap();
    let scenario = scenario.sampled(Run::evenly(13.7, 4001, Method::Auto, 1e-12));
    let trajectory = scenario.simulate().unwrap().unwrap();
    let picture = MotionFigures::of_scenario(&scenario, &trajectory).draw(Figure::Omega).unwrap();
    readable(&picture, "scales");
    let texts = boxes(&picture);
    for label in ["ω₁, ω₂ (rad/s)", "ω₃ (rad/s)", "time t (s)"] {
        assert!(texts.iter().any(|(text, _)| text == label), "{label}: {texts:?}");
    }
}
