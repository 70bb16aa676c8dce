//! Figures of every kind of motion, read back from their SVG and PNG.

mod chart;

use polhode::math::formula::{Binary, Formula, Instruction, Unary};
use polhode::motion::torque::{EnergySink, FormulaTorque};
use polhode::motion::{EventAction, Measure, Motor, Prescribed, Run, Sense, StateVariables};
use polhode::prelude::*;
use polhode_document::Picture;
use polhode_document::figure::axes::{Area, Axes, Axis};
use polhode_document::figure::line::{SEEN, distance};
use polhode_document::figure::sheet::{self, Mark, Point};
use polhode_document::figure::svg;

use super::*;
use crate::report::balance::balances;

/// Returns a body with three different moments, products of both signs, and a centre off the
/// origin.
fn body() -> MassProperties<Body> {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    MassProperties::new(2.3, Position::new(0.1, -0.2, 0.4), inertia).unwrap()
}

fn scenario(omega: [f64; 3]) -> Scenario {
    let attitude = Attitude::from_quaternion([0.9, 0.3, -0.2, 0.1]).unwrap();
    let omega = AngularVelocity::from_array(omega);
    Scenario::new(body())
        .titled("A <tumbling> \"body\" & 'more'")
        .starting(State { time: 0.0, attitude, omega })
        .unwrap()
        .sampled(Run::evenly(13.7, 501, Method::Auto, 1e-12))
}

fn heavy() -> Scenario {
    let gravity = UniformGravity { acceleration: Acceleration::new(0.3, -0.2, -9.7) };
    let torques = vec![TorqueModel::Gravity(gravity)];
    scenario([0.7, -1.1, 2.3]).held_at(Position::ZERO).unwrap().with_torques(torques).unwrap()
}

/// Returns a symmetric top with its tip at the origin, at an inclination `tilt`, rad.
fn top(tilt: f64, omega: [f64; 3]) -> Scenario {
    let inertia = InertiaTensor::diagonal([0.021, 0.021, 0.034]).unwrap();
    let body = MassProperties::new(1.3, Position::new(0.0, 0.0, 0.13), inertia).unwrap();
    let attitude = Attitude::from_euler313([0.4, tilt, -0.3]).unwrap();
    let start = State { time: 0.0, attitude, omega: AngularVelocity::from_array(omega) };
    let torques = vec![TorqueModel::Gravity(UniformGravity::STANDARD)];
    let top = Scenario::new(body).titled("A top").held_at(Position::ZERO).unwrap().starting(start).unwrap();
    top.with_torques(torques).unwrap().sampled(Run::evenly(2.0, 801, Method::Auto, 1e-12))
}

/// Returns a body at rest with two wheels, one of them driven by a motor; L is zero.
fn gyrostat() -> Scenario {
    let motor = Motor::Torque { inertia: 0.21, torque: 0.35, schedule: None };
    let turned = Wheel::new(Direction::new(0.6, -0.3, 0.8), 0.0, motor).unwrap();
    let held = Wheel::new(Direction::new(0.2, 0.9, -0.4), 0.0, Motor::HeldSpeed).unwrap();
    scenario([0.0; 3]).with_wheels(&[held, turned]).unwrap()
}

/// Returns a diverging motion, ω = 1/(t* − t), whose computation fails.
fn run_away() -> Scenario {
    let inertia = InertiaTensor::diagonal([2.0, 3.0, 4.0]).unwrap();
    let body = MassProperties::new(1.0, Position::ZERO, inertia).unwrap();
    // The torque N = 4 ω_z² along z gives ω̇ = ω², so that t* = 2 s for 0.5 rad/s.
    let place = StateVariables::NAMES.iter().position(|name| *name == "wz").unwrap();
    let square = [Instruction::Variable(place), Instruction::Unary(Unary::Power(2))];
    let times = [Instruction::Constant(4.0), Instruction::Binary(Binary::Multiply)];
    let along = Formula::new(square.into_iter().chain(times)).unwrap();
    let torque = FormulaTorque::Body([Formula::constant(0.0), Formula::constant(0.0), along]);
    let torques = vec![TorqueModel::Formula(Box::new(torque))];
    let start = scenario([0.0, 0.0, 0.5]).start();
    let away = Scenario::new(body).starting(start).unwrap().with_torques(torques).unwrap();
    away.sampled(Run::evenly(4.0, 81, Method::Auto, 1e-12))
}

fn thrust() -> Scenario {
    let torque = ConstantTorque::Body(Torque::new(0.3, -0.2, 0.5));
    scenario([0.7, -1.1, 0.3]).with_torques([TorqueModel::Constant(torque)]).unwrap()
}

fn moments(moments: [f64; 3], omega: [f64; 3], span: f64) -> (FreeMotion, Trajectory) {
    let omega = AngularVelocity::from_array(omega);
    let start = State { time: 0.0, attitude: Attitude::identity(), omega };
    let motion = FreeMotion::of_moments(moments, start).unwrap();
    let times = Run::evenly(span, 301, Method::Exact, 0.0).times;
    (motion, Trajectory::of_motion(motion, &times).unwrap())
}

/// Returns every text of a picture with its bounding box: least x, greatest x, least y, greatest y.
fn boxes(picture: &Picture) -> Vec<(String, [f64; 4])> {
    let texts = picture.sheet.marks.iter().filter_map(|mark| match mark {
        Mark::Text(text) => Some(text),
        _ => None,
    });
    texts
        .map(|text| {
            let ([x, y], [from, to], high) = (text.at, text.extent(), 0.75 * text.size);
            let place =
                if text.upward { [x - high, x, y - to, y - from] } else { [x + from, x + to, y - high, y] };
            (text.content.clone(), place)
        })
        .collect()
}

/// Asserts that a picture is valid XML, with all texts and points on the sheet, and no overlapping
/// texts.
fn readable(picture: &Picture, name: &str) {
    let svg = picture.to_svg();
    assert!(svg.len() < 400_000, "{name}: {} bytes", svg.len());
    let tree = roxmltree::Document::parse(&svg).unwrap_or_else(|error| panic!("{name}: {error}"));
    let (width, height) = (picture.sheet.width, picture.sheet.height);
    let view = tree.root_element().attribute("viewBox").unwrap();
    assert_eq!(view, format!("0 0 {width} {height}"));
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
    let inside = |[x, y]: Point| (-0.5..=width + 0.5).contains(&x) && (-0.5..=height + 0.5).contains(&y);
    for mark in &picture.sheet.marks {
        let points: Vec<Point> = match mark {
            Mark::Lines { lines, .. } => lines.iter().flatten().copied().collect(),
            Mark::Dots { dots, .. } => dots.clone(),
            Mark::Polygon { corners, .. } => corners.clone(),
            _ => Vec::new(),
        };
        assert!(points.into_iter().all(inside), "{name}: a mark leaves the sheet");
    }
    let texts = boxes(picture);
    for (k, (text, [x0, x1, y0, y1])) in texts.iter().enumerate() {
        assert!(inside([*x0, *y0]) && inside([*x1, *y1]), "{name}: {text} leaves the sheet");
        for (other, [u0, u1, v0, v1]) in &texts[..k] {
            let apart = x1 <= u0 || u1 <= x0 || y1 <= v0 || v1 <= y0;
            assert!(apart, "{name}: {text:?} lies on {other:?}");
        }
    }
}

/// Returns all curves with their pens.
fn lines(picture: &Picture) -> impl Iterator<Item = (&Vec<Vec<Point>>, &sheet::Pen)> {
    picture.sheet.marks.iter().filter_map(|mark| match mark {
        Mark::Lines { lines, pen } => Some((lines, pen)),
        _ => None,
    })
}

/// Returns the corners of the first frame, the only closed line of five points.
fn frame(picture: &Picture) -> &[Point] {
    lines(picture).map(|(lines, _)| &lines[0]).find(|line| line.len() == 5).unwrap()
}

#[test]
fn every_kind_of_motion_has_its_figures_and_is_refused_the_others() {
    use Figure::{Axis, Drift, Energy, Euler, Herpolhode, Momentum, Omega, Polhodes, Torque, Wheels};
    let free = [Omega, Euler, Polhodes, Herpolhode, Energy, Momentum, Drift];
    let driven = [Omega, Euler, Energy, Momentum, Torque, Drift];
    let on_a_pivot = [Omega, Euler, Axis, Energy, Momentum, Torque, Drift];
    let about = Direction::new(0.3, -0.5, 0.8);
    let turn = Prescribed::fixed_axis(Attitude::identity(), about, 2.1, -0.05).unwrap();
    let prescribed = scenario([0.0; 3]).prescribed_as(turn).unwrap();
    let dop853 = Run::evenly(13.7, 501, Method::Dop853, 1e-12);
    let cases: [(&str, Scenario, &[Figure]); 8] = [
        ("asymmetric", scenario([0.7, -1.1, 0.3]), &free),
        ("integrated", scenario([0.1, 0.9, -1.3]).sampled(dop853), &free),
        ("at rest", scenario([0.0; 3]), &[Omega, Euler, Energy, Momentum, Drift]),
        ("heavy", heavy(), &on_a_pivot),
        ("top", top(0.7, [0.3, -0.2, 38.0]), &on_a_pivot),
        ("gyrostat", gyrostat(), &[Omega, Euler, Energy, Momentum, Wheels, Drift]),
        ("thrust", thrust(), &driven),
        ("prescribed", prescribed, &[Omega, Euler, Energy, Momentum, Torque]),
    ];
    for (name, scenario, expected) in &cases {
        let trajectory = scenario.simulate().unwrap().unwrap();
        check(name, &MotionFigures::of_scenario(scenario, &trajectory), expected);
    }
    let still = [Omega, Euler, Polhodes, Energy, Momentum, Drift];
    type Thrown<'a> = (&'a str, [f64; 3], [f64; 3], &'a [Figure]);
    let cases: [Thrown<'_>; 9] = [
        ("long axis", [1.3, 2.7, 3.1], [2.1, -0.3, 0.4], &free),
        ("separatrix", [1.0, 2.0, 3.0], [3.0_f64.sqrt(), 0.5, 1.0], &free),
        ("oblate", [2.2, 2.2, 3.7], [0.4, -0.3, 2.0], &free),
        ("prolate", [1.1, 2.9, 2.9], [1.4, -0.3, 0.6], &free),
        ("sphere", [1.7; 3], [0.4, -0.3, 0.6], &still),
        ("rod", [0.0, 1.9, 1.9], [0.0, -0.3, 0.6], &still),
        ("permanent", [1.3, 2.7, 3.1], [0.0, 0.0, -2.0], &still),
        ("plate", [1.3e-9, 2.7, 2.7 + 1.3e-9], [900.0, -0.3, 0.4], &free),
        ("tiny", [1.3e-40, 2.7e-40, 3.1e-40], [2.1e-9, -0.3e-9, 0.4e-9], &free),
    ];
    for (name, moments_of, omega, expected) in cases {
        let speed = omega.iter().fold(0.0, |a: f64, w| a.hypot(*w));
        let (motion, trajectory) = moments(moments_of, omega, 40.0 / speed);
        check(name, &MotionFigures::of_motion(name, &motion, &trajectory), expected);
    }
}

fn check(name: &str, figures: &MotionFigures<'_>, expected: &[Figure]) {
    assert_eq!(figures.figures(), expected, "{name}");
    for figure in Figure::ALL {
        match figures.draw(figure) {
            Ok(picture) => {
                assert!(expected.contains(&figure), "{name}: {}", figure.name());
                readable(&picture, &format!("{name}, {}", figure.name()));
            }
            Err(PlotError::NotThere { figure: refused, why }) => {
                assert!(!expected.contains(&figure) && refused == figure && !why.is_empty(), "{name}");
            }
            Err(error) => panic!("{name}: {error}"),
        }
    }
    readable(&figures.overview().unwrap(), name);
}

#[test]
fn a_curve_is_its_data() {
    let scenario = scenario([0.7, -1.1, 0.3]);
    let trajectory = scenario.simulate().unwrap().unwrap();
    let picture = MotionFigures::of_scenario(&scenario, &trajectory).draw(Figure::Omega).unwrap();
    // The left and right edges of the frame are the first and last time; the tick labels give the
    // vertical scale.
    let frame = frame(&picture);
    let ([left, top], [right, bottom]) = (frame[0], frame[2]);
    let marks: Vec<(f64, f64)> = boxes(&picture)
        .into_iter()
        .filter(|(_, [_, to, ..])| *to < left && *to > left - 8.0)
        .filter_map(|(text, [.., y0, y1])| {
            text.replace('−', "-").parse().ok().map(|value: f64| (value, 0.5 * (y0 + y1)))
        })
        .collect();
    let ((v0, y0), (v1, y1)) = (marks[0], marks[marks.len() - 1]);
    let up = |value: f64| y0 + (value - v0) / (v1 - v0) * (y1 - y0);
    let across = |time: f64| left + time / 13.7 * (right - left);
    let into = scenario.rotor().principal().rotation().inverse();
    for k in 0..3 {
        let colour = sheet::Colour::AXES[k];
        let is_curve =
            |(lines, pen): &(&Vec<Vec<Point>>, &sheet::Pen)| pen.colour == colour && lines[0].len() > 9;
        let curve = &lines(&picture).find(is_curve).unwrap().0[0];
        for sample in trajectory.samples() {
            let value = (into * sample.state.omega).to_array()[k];
            let place = [across(sample.state.time), up(value)];
            assert!((top..bottom).contains(&place[1]));
            let off = curve.windows(2).map(|w| distance(place, w[0], w[1])).fold(f64::INFINITY, f64::min);
            // The vertical positions of the labels are known to some tenths of a pixel only.
            assert!(off < SEEN + 0.5, "ω{} at {}: {off} px", k + 1, sample.state.time);
        }
    }
}

#[test]
fn axes_map_values_to_their_places() {
    let area = Area { left: 10.0, top: 20.0, right: 410.0, bottom: 320.0 };
    let x = Axis::linear([0.0, 8.0], 0.0, 5.0, "t", "s");
    let y = Axis::linear([-2.5e-6, 7.5e-6], 0.0, 5.0, "T", "J");
    let axes = Axes::within(area, x, y, Some(40.0));
    let frame = axes.area;
    let [px, py] = axes.at([3.0, 1.25e-6]);
    assert!((px - (frame.left + 0.375 * frame.width())).abs() < 1e-9);
    assert!((py - (frame.bottom - 0.375 * frame.height())).abs() < 1e-9);
    let log = Axes::within(
        area,
        Axis::linear([0.0, 8.0], 0.0, 5.0, "t", "s"),
        Axis::powers(-16, -11, 5, "drift"),
        None,
    );
    let [_, py] = log.at([0.0, 1e-13]);
    assert!((py - (log.area.bottom - 0.6 * log.area.height())).abs() < 1e-9);
    assert_eq!(log.at([0.0, 0.0])[1], log.area.bottom);
}

#[test]
fn the_drift_that_is_drawn_is_the_drift_that_is_reported() {
    for scenario in [scenario([0.7, -1.1, 0.3]), heavy(), thrust()] {
        let trajectory = scenario.simulate().unwrap().unwrap();
        let drift = Drift::of(&trajectory).unwrap();
        let figures = MotionFigures::of_scenario(&scenario, &trajectory);
        let largest: Vec<f64> = balances(&trajectory, figures.motion.driven)
            .iter()
            .map(|d| d.values.iter().copied().fold(0.0, f64::max))
            .collect();
        let expected = match drift.total_energy {
            _ if !figures.motion.driven.at_all() => {
                vec![drift.kinetic_energy, drift.momentum_magnitude, drift.momentum]
            }
            Some(total) => vec![drift.work_energy, drift.momentum, total],
            None => vec![drift.work_energy, drift.momentum],
        };
        assert_eq!(largest.len(), expected.len());
        for (drawn, reported) in largest.iter().zip(expected) {
            assert_eq!(*drawn, reported);
        }
    }
}

/// The angles θ and φ read back from the diagram agree with the attitudes.
#[test]
fn the_path_of_an_axis_is_where_it_points() {
    let scenario = top(0.7, [0.0, 0.0, 38.0]);
    let trajectory = scenario.simulate().unwrap().unwrap();
    let picture = MotionFigures::of_scenario(&scenario, &trajectory).draw(Figure::Axis).unwrap();
    readable(&picture, "top");
    let (svg, texts) = (picture.to_svg(), boxes(&picture));
    assert!(svg.contains("radialGradient"));
    assert!(texts.iter().any(|(text, _)| text.starts_with("θ from 40.107° to ")), "{texts:?}");
    // The bounds are dashed horizontal lines. The path touches both, and starts with a cusp at the
    // upper one.
    let lines: Vec<_> = picture
        .sheet
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Lines { lines, pen } => Some((lines, pen)),
            _ => None,
        })
        .collect();
    let level =
        |line: &[Point]| line.len() == 2 && line[0][1] == line[1][1] && line[1][0] - line[0][0] > 100.0;
    let bounds: Vec<f64> = lines
        .iter()
        .filter(|(lines, pen)| pen.colour == sheet::Colour::AXES[0] && level(&lines[0]))
        .map(|(lines, _)| lines[0][0][1])
        .collect();
    let [upper, lower] = bounds[..] else { panic!("{bounds:?}") };
    let (path, _) = lines.last().unwrap();
    let path = &path[0];
    let (top, bottom) = path.iter().fold((f64::MAX, f64::MIN), |(a, b), p| (a.min(p[1]), b.max(p[1])));
    assert!((top - upper).abs() < 0.3 && (bottom - lower).abs() < 0.3, "{top} {upper} {bottom} {lower}");
    assert!((path[0][1] - upper).abs() < 0.3);
    // Upright tops are viewed from above, hanging ones from below.
    for (tilt, words) in [(0.0, "from above, a circle every "), (3.1, "from below, a circle every ")] {
        let scenario = self::top(tilt, [0.3, -0.2, 38.0]);
        let trajectory = scenario.simulate().unwrap().unwrap();
        let picture = MotionFigures::of_scenario(&scenario, &trajectory).draw(Figure::Axis).unwrap();
        readable(&picture, words);
        assert!(boxes(&picture).iter().any(|(text, _)| text.starts_with(words)), "{words}");
    }
}

#[test]
fn a_hostile_title_is_text() {
    let hostile = "</svg><script>alert('x')</script> & \"q\" \u{1b}[31m \u{202e} ]]> <!-- --> ω";
    let mut scenario = scenario([0.7, -1.1, 0.3]);
    scenario = scenario.titled(hostile.repeat(5));
    let trajectory = scenario.simulate().unwrap().unwrap();
    let figures = MotionFigures::of_scenario(&scenario, &trajectory);
    for picture in [figures.draw(Figure::Omega).unwrap(), figures.overview().unwrap()] {
        readable(&picture, "hostile");
        let svg = picture.to_svg();
        let tree = roxmltree::Document::parse(&svg).unwrap();
        assert!(tree.descendants().all(|node| !node.has_tag_name("script")));
        assert!(!svg.contains('\u{1b}') && !svg.contains('\u{202e}'));
        let title = tree.descendants().find(|n| n.tag_name().name() == "title").unwrap().text().unwrap();
        assert!(title.contains("</svg><script>alert('x')"), "{title}");
    }
    assert_eq!(svg::escaped("a\u{0}b\u{ffff}<"), "a\u{fffd}b\u{fffd}&lt;");
}

#[test]
fn fewer_than_two_samples_are_refused() {
    let mut scenario = scenario([0.7, -1.1, 0.3]);
    scenario = scenario.sampled(Run::evenly(1.0, 1, Method::Auto, 1e-12));
    let trajectory = scenario.simulate().unwrap().unwrap();
    let figures = MotionFigures::of_scenario(&scenario, &trajectory);
    assert_eq!(figures.draw(Figure::Euler), Err(PlotError::TooFewSamples { count: 1 }));
    readable(&figures.draw(Figure::Polhodes).unwrap(), "one sample");
    // The body turns by about 2 rad between samples, so its rotation would be drawn too slow.
    scenario = scenario.sampled(Run::evenly(30.0, 21, Method::Auto, 1e-12));
    let trajectory = scenario.simulate().unwrap().unwrap();
    let figures = MotionFigures::of_scenario(&scenario, &trajectory);
    assert!(
        matches!(figures.draw(Figure::Euler), Err(PlotError::TooCoarse { figure: Figure::Euler, turn }) if turn > 1.9)
    );
    readable(&figures.overview().unwrap(), "coarse");
}

#[cfg(feature = "png")]
#[test]
fn a_png_shows_what_the_svg_says() {
    let scenario = scenario([0.7, -1.1, 0.3]);
    let trajectory = scenario.simulate().unwrap().unwrap();
    let picture = MotionFigures::of_scenario(&scenario, &trajectory).draw(Figure::Omega).unwrap();
    let file = picture.to_png().unwrap();
    let mut reader = ::png::Decoder::new(std::io::Cursor::new(&file)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), (2016, (3.0 * picture.sheet.height).round() as u32));
    let at = |x: f64, y: f64| {
        let k = 3 * ((3.0 * y) as usize * 2016 + (3.0 * x) as usize);
        [pixels[k], pixels[k + 1], pixels[k + 2]]
    };
    assert_eq!(at(1.0, 1.0), [255; 3]);
    for colour in sheet::Colour::AXES {
        let count = pixels.chunks(3).filter(|p| **p == colour.rgb()).count();
        assert!(count > 2000, "{count} pixels of {colour:?}");
    }
    // The letters of the title are drawn as dark pixels, even on a machine without fonts.
    let (title, [x0, x1, y0, y1]) = boxes(&picture).swap_remove(0);
    assert!(title.starts_with("Angular velocity"));
    let grid = |a: f64, b: f64| (0..200).map(move |k| a + (b - a) * f64::from(k) / 200.0);
    let dark = grid(x0, x1).flat_map(|x| grid(y0, y1).map(move |y| (x, y)));
    let dark = dark.filter(|(x, y)| at(*x, *y)[0] < 100).count();
    assert!((2000..20_000).contains(&dark), "{dark}");
}
