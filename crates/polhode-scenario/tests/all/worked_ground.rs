//! Worked solutions of bodies on the ground: printed numbers, compared with the motion.

use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{ContactLaw, ContactState, Friction, GroundSide, StartVelocity};
use polhode::prelude::*;
use polhode_document::Block;
use polhode_scenario::report::explain;

use crate::common::Solution;
use crate::common::ground::{
    self, G, Setting, UP, ball, disk, dry, egg, leaning, marble, rattleback, slope, tippe_top,
};
use crate::common::held::Held;

/// Returns the text of one step, with each block on separate lines.
fn step(scenario: &Scenario, number: usize) -> String {
    let mut document = explain(scenario).unwrap();
    document.sections = vec![document.sections.swap_remove(number)];
    document.answer.clear();
    document.to_text(400)
}

/// Returns the numbers after the first occurrence of a name that a number follows. Spaces between
/// groups of digits are allowed.
#[track_caller]
fn numbers(text: &str, name: &str) -> Vec<f64> {
    let rests = text.match_indices(name).map(|(at, _)| &text[at + name.len()..]);
    let mut numbered =
        rests.filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit() || "-(".contains(c)));
    let rest = numbered.next().unwrap_or_else(|| panic!("no number after {name:?} in\n{text}"));
    let line = rest.lines().next().unwrap();
    let chars: Vec<char> = line.chars().collect();
    let digit = |k: usize| chars.get(k).is_some_and(char::is_ascii_digit);
    let joined: String = (0..chars.len())
        .filter(|&k| !(chars[k] == ' ' && k > 0 && digit(k - 1) && digit(k + 1)))
        .map(|k| chars[k])
        .collect();
    joined
        .split(|c: char| !(c.is_ascii_digit() || "+-.e".contains(c)))
        .filter_map(|word| word.parse().ok())
        .collect()
}

#[track_caller]
fn number(text: &str, name: &str) -> f64 {
    numbers(text, name)[0]
}

#[track_caller]
fn near(got: f64, want: f64, tolerance: f64) {
    assert!((got - want).abs() <= tolerance * want.abs().max(1e-300), "{got} is not {want}");
}

fn motion(scenario: &Scenario) -> Held<ContactState> {
    Held::of(scenario.simulate().unwrap().unwrap(), CONTACT)
}

/// Returns the angle between z and the vertical.
fn tilt(sample: &ContactState) -> f64 {
    (sample.state.attitude * Direction::<Body>::new(0.0, 0.0, 1.0)).angle_to(UP)
}

/// The slip of a ball ends at the printed time with the printed velocity: on level ground, with
/// viscous friction, and on a slope, where the slip turns.
#[test]
fn the_ball_grips_when_it_is_said_to() {
    let viscous = Friction { sticking: 0.2, kinetic: 0.13, viscous: 0.31 };
    for setting in [
        ball(),
        Setting { law: ContactLaw::with_friction(viscous).unwrap(), ..ball() },
        Setting {
            ground: slope(0.27),
            velocity: StartVelocity::Along(Velocity::new(0.8, 0.6, 0.0)),
            ..ball()
        },
    ] {
        let text = step(&setting.scenario("Slides", 1.0, 3), 5);
        let time = number(&text, "\n    T = ");
        let run = setting.scenario("Slides", time, 2);
        let motion = motion(&setting.scenario("Slides", 1.5 * time, 4));
        near(motion.changes()[0].time, time, 1e-5);
        near(number(&text, "the run finds T = "), time, 1e-5);
        let there = crate::worked_ground::motion(&run).samples()[1];
        let speed = there.velocity.norm();
        near(number(&text, "|v(T)| = "), speed, 1e-4);
        let line = numbers(&text, "    v(T) = (");
        let [.., x, y, z] = line[..] else { panic!("{text}") };
        for (got, want) in [x, y, z].into_iter().zip(there.velocity.to_array()) {
            assert!((got - want).abs() < 1e-4 * speed, "{line:?} {:?}", there.velocity);
        }
        if text.contains("its displacement is ") {
            let moved = there.center - motion.start().center;
            near(numbers(&text, "its displacement is ")[3], moved.norm(), 1e-4);
            near(number(&text, "½ σ m u0² = "), -there.friction_work, 1e-4);
        }
    }
}

/// 2 v/(7 µ g) and 5/7, the textbook results.
#[test]
fn a_homogeneous_ball_keeps_five_sevenths() {
    let setting = Setting { moments: [0.4 * 0.31 * 0.043 * 0.043; 3], omega: [0.0; 3], ..ball() };
    let text = step(&setting.scenario("Thrown", 1.0, 3), 5);
    let speed = 1.3_f64.hypot(0.9);
    near(number(&text, "\n    T = "), 2.0 * speed / (7.0 * 0.21 * G), 1e-5);
    near(number(&text, "|v(T)| = "), 5.0 / 7.0 * speed, 1e-5);
    assert!(
        text.contains("2/5 and 2/7, those of a homogeneous ball") && text.contains(": 5/7, as for every"),
        "{text}"
    );
    // A slope that is too steep.
    let steep = Setting { ground: slope(0.9), velocity: StartVelocity::Along(Velocity::ZERO), ..setting };
    assert!(step(&steep.scenario("Steep", 1.0, 3), 5).contains("the slip grows without limit"));
}

/// Circle of a ball on a turntable: all samples are at the radius from its centre.
#[test]
fn the_turntable_has_its_circle() {
    let setting = Setting {
        ground: polhode::motion::contact::Ground::LEVEL.turning_at(3.1).unwrap(),
        law: ContactLaw::ROLLING,
        velocity: StartVelocity::Rolling,
        at: Position::new(0.2, 0.3, 0.0),
        ..ball()
    };
    let scenario = setting.scenario("Turns", 2.0, 9);
    let text = step(&scenario, 5);
    let (radius, middle) = (number(&text, "|σ Ω| = "), numbers(&text, "(σ Ω) = "));
    for sample in motion(&scenario).samples() {
        let [x, y, _] = sample.contact.to_array();
        near((x - middle[0]).hypot(y - middle[1]), radius, 1e-5);
    }
    near(numbers(&text, "σ Ω = ")[2], 3.1 * 0.53 / 1.53, 1e-5);
}

/// A disk with the printed initial Ω keeps its tilt, and P moves on the printed circle.
#[test]
fn the_disk_runs_in_the_circle_that_is_printed() {
    for (tilted, spin) in [(1.1, -13.0), (0.7, 6.0)] {
        let text = step(&disk(tilted, [1.0, spin]).scenario("Falls", 0.1, 3), 5);
        assert!(text.contains("θ does not stay"), "{text}");
        for name in ["the slower: Ω = ", "the faster: Ω = "] {
            let (rate, radius) = (number(&text, name), numbers(&text, name)[2]);
            let setting = disk(tilted, [rate, spin]);
            let scenario = setting.scenario("Circles", 0.9 / rate.abs(), 3);
            let motion = motion(&scenario);
            let [a, b, c] = motion.samples() else { panic!("three samples") };
            assert!((tilt(c) - tilted).abs() < 1e-4, "{name}: {} {tilted}", tilt(c));
            let corners = [b.contact - a.contact, c.contact - b.contact, a.contact - c.contact];
            let [p, q, r] = corners.map(Vector::norm);
            let half = 0.5 * (p + q + r);
            let area = (half * (half - p) * (half - q) * (half - r)).sqrt();
            near(p * q * r / (4.0 * area), radius, 2e-3);
            let text = step(&scenario, 5);
            assert!(text.contains("The start is such a steady circle."), "{text}");
        }
    }
}

/// An upright disk falls or stays upright according to the thresholds.
#[test]
fn wheels_fall_below_the_rate_that_is_printed() {
    let text = step(&disk(1.5, [0.0, 3.0]).scenario("Rolls", 0.1, 3), 5);
    let threshold = number(&text, "rolling straight: |s| > ");
    // A m g ρ/(C (C + m ρ²)), independently.
    let (m, a, c, r) = (0.42, 7.3e-4, 1.31e-3, 0.081_f64);
    near(threshold, (a * m * G * r / (c * (c + m * r * r))).sqrt(), 1e-5);
    near(number(&text, "spinning:         |Ω| > "), (m * G * r / (a + m * r * r)).sqrt(), 1e-5);
    for (part, falls) in [(0.9, true), (1.1, false)] {
        let setting = disk(std::f64::consts::FRAC_PI_2 - 1e-4, [0.0, part * threshold]);
        let end = motion(&setting.scenario("Rolls", 3.0, 30)).samples().iter().map(tilt).fold(2.0, f64::min);
        assert_eq!(end < 1.5, falls, "{part}: {end}");
    }
}

#[test]
fn eulers_disk_lies_flat_when_it_is_said_to() {
    let lever = 3e-4;
    // Ω² sin θ = m g R/A
    let rate = (0.42 * G * 0.081 / (7.3e-4 * 0.06_f64.sin())).sqrt();
    let setting = Setting { law: ground::resisted(ContactLaw::ROLLING, lever), ..disk(0.06, [rate, 0.0]) };
    let text = step(&setting.scenario("Whirls", 20.0, 5), 5);
    let settles = numbers(&text, "T_flat = 3·");
    near(settles[3], 3.0 * 0.081 / (lever * rate), 1e-4);
    near(number(&text, "in the run it lies flat after "), settles[3], 3e-3);
    // The table: the rate at each tilt.
    let document = explain(&setting.scenario("Whirls", 1.0, 5)).unwrap();
    let rows = document.sections[5].blocks.iter().find_map(|block| match block {
        Block::Table { headers, rows } if headers[1].starts_with('Ω') => Some(rows.clone()),
        _ => None,
    });
    for row in rows.unwrap() {
        let cell = |k: usize| row[k].parse::<f64>().unwrap();
        let tilt = cell(0).to_radians();
        near(cell(1), (0.42 * G * 0.081 / (7.3e-4 * tilt.sin())).sqrt(), 1e-3);
        near(cell(4), 1.5 * 0.42 * G * 0.081 * tilt.sin(), 1e-3);
    }
}

/// Jellett's constant, the torque of friction, the power and the energy of a tippe top.
#[test]
fn the_tippe_tops_numbers_are_those_of_its_motion() {
    let setting = tippe_top();
    let short = 2e-6;
    let scenario = setting.scenario("Turns over", short, 3);
    let text = step(&scenario, 5);
    let samples = motion(&scenario);
    let [first, _, last] = samples.samples() else { panic!("three samples") };
    let power =
        (last.kinetic_energy + last.potential_energy - first.kinetic_energy - first.potential_energy) / short;
    near(number(&text, "F · u = "), power, 1e-3);
    // d(L · n)/dt, d(L · e)/dt
    let momentum = |s: &ContactState| {
        let l = s.state.omega.to_array();
        Direction::<Body>::new(1.93e-6 * l[0], 1.93e-6 * l[1], 2.04e-6 * l[2])
    };
    let vertical = |s: &ContactState| (s.state.attitude * momentum(s)).z;
    let line = numbers(&text, "(r × F) · n = -");
    near(-line[0], (vertical(last) - vertical(first)) / short, 1e-3);
    near(line[1], (momentum(last).z - momentum(first).z) / short, 1e-3);
    near(-line[0], -0.32 * first.normal_force * 0.0041 * 0.12_f64.sin(), 1e-3);
    // J = L · (R n − d e), independently.
    let jellett = 0.0187 * vertical(first) - 0.0041 * momentum(first).z;
    near(number(&text, "    J = "), jellett, 1e-5);
    near(numbers(&text, "T + U = ")[0], first.kinetic_energy + first.potential_energy, 1e-5);
    // Below the printed spin it stays at the bottom, above it leaves. Friction is viscous, because
    // dry friction would hold it.
    let needed = numbers(&text, "leaves the bottom if it is spun there at more than ")[0];
    let viscous = Friction { sticking: 0.0, kinetic: 0.0, viscous: 3.0 };
    for (part, leaves) in [(0.93, false), (1.07, true)] {
        let spin: f64 = part * needed;
        let omega = [0.0, spin * 0.01_f64.sin(), spin * 0.01_f64.cos()];
        let law = ContactLaw::with_friction(viscous).unwrap();
        let slow =
            Setting { law, attitude: leaning(0.01), omega, velocity: StartVelocity::Rolling, ..setting };
        let end = motion(&slow.scenario("Spins", 6.0, 4));
        assert_eq!(tilt(&end.samples()[3]) > 0.01, leaves, "{part}: {}", tilt(&end.samples()[3]));
    }
    let answer = explain(&scenario).unwrap().answer;
    assert!(answer.iter().any(|line| line.contains("brings it to the inverted position")), "{answer:?}");
}

/// Oscillations of a rattleback from the determinant, and the growth of a small tilt in the run.
#[test]
fn the_rattleback_rattles_as_it_is_said_to() {
    let text = step(&rattleback(-0.8, 1e-5).scenario("Rattles", 0.1, 3), 5);
    let (m, h, ixx, iyy, ixy) = (0.9, 0.01, 2.1e-4, 1.57e-3, -3.1e-5);
    // R = a²/c, b²/c at the lower vertex, 21 mm below a centre that is 11 mm above the centre of
    // mass.
    let [long, short] = [0.19_f64.powi(2) / 0.021 - h, 0.031_f64.powi(2) / 0.021 - h];
    // Tilts about x and y: M = I + m h²; a tilt about x is towards y.
    let [a, b, d] = [ixx + m * h * h, ixy, iyy + m * h * h];
    let determinant = |x: f64| (m * G * short - x * a) * (m * G * long - x * d) - x * x * b * b;
    let frequencies: Vec<f64> = text
        .lines()
        .filter(|line| line.contains(", once in ") && line.contains("    ϖ = "))
        .map(|line| number(line, "ϖ = "))
        .collect();
    assert_eq!(frequencies.len(), 2, "{text}");
    for frequency in frequencies {
        let x = frequency * frequency;
        assert!(determinant(x).abs() < 3e-5 * x * x * a * d, "{frequency}: {}", determinant(x));
    }
    // Growth at a slow spin, compared with the run: the largest tilts in two intervals of the fast
    // oscillation.
    let pitched = Attitude::from_axis_angle(Direction::new(0.0, 1.0, 0.0), 1e-5).unwrap();
    let setting = Setting { attitude: pitched, ..rattleback(-0.8, 0.0) };
    let line = text.lines().find(|line| line.contains("it grows, σ = ")).unwrap();
    let growth = number(line, "it grows, σ = ");
    let samples = motion(&setting.scenario("Rattles", 9.0, 9001)).samples().to_vec();
    let most = |from: f64| {
        let inside = samples.iter().filter(|s| s.state.time >= from && s.state.time < from + 1.0);
        inside.map(tilt).fold(0.0, f64::max)
    };
    near((most(7.5) / most(4.5)).ln() / 3.0, growth, 0.05);
    let answer = explain(&setting.scenario("Rattles", 0.1, 3)).unwrap().answer;
    assert!(answer[1].contains("spun with the clock, against its sense"), "{answer:?}");
    // Both directions are equal if the principal axes are those of the underside.
    let even = Setting { products: [0.0; 3], ..setting };
    assert!(!step(&even.scenario("Even", 0.1, 3), 5).contains("rattle"));
}

/// Turning points of a marble in its bowl, and its period.
#[test]
fn the_marble_turns_between_its_bounds() {
    let setting = marble(GroundSide::Inside);
    let text = step(&setting.scenario("Rolls", 0.1, 3), 5);
    let period = number(&text, "period 2 K(k)/λ = ");
    let bounds = numbers(&text, "from the lowest point:\n\n    ");
    let samples = motion(&setting.scenario("Rolls", period, 4001)).samples().to_vec();
    let angle = |s: &ContactState| s.normal.angle_to(UP).to_degrees();
    near(samples.iter().map(angle).fold(f64::INFINITY, f64::min), bounds[0], 1e-4);
    near(samples.iter().map(angle).fold(0.0, f64::max), bounds[1], 1e-4);
    near(angle(&samples[4000]), angle(&samples[0]), 1e-4);
    let turned = number(&text, "goes round by ");
    let azimuth = |s: &ContactState| s.contact.y.atan2(s.contact.x).to_degrees();
    let gone = samples.windows(2).map(|pair| (azimuth(&pair[1]) - azimuth(&pair[0]) + 540.0) % 360.0 - 180.0);
    near(gone.sum::<f64>(), turned, 1e-4);
}

/// Condition for the egg to rise, computed independently; the egg then rises.
#[test]
fn the_egg_rises_if_it_is_said_to() {
    let setting = egg();
    let text = step(&setting.scenario("Rises", 0.1, 3), 5);
    let (m, a, c_moment, b, c) = (0.055, 1.37e-5, 1.01e-5, 0.021, 0.028_f64);
    near(number(&text, "√(A m g h³) = "), (a * m * G * c.powi(3)).sqrt(), 1e-5);
    let jellett = number(&text, "    J = ");
    near(number(&text, "J/(C c) = "), jellett / (c_moment * c), 1e-4);
    let height = (b * 1.51_f64.sin()).hypot(c * 1.51_f64.cos());
    near(number(&text, "√(m g h/A) = "), (m * G * height / a).sqrt(), 1e-5);
    let samples = motion(&setting.scenario("Rises", 1.5, 4));
    assert!(tilt(&samples.samples()[3]) < 0.4, "{}", tilt(&samples.samples()[3]));
    near(samples.samples()[3].state.omega.norm(), number(&text, "J/(C c) = "), 0.03);
    // The law for a peg, with the radius b²/c.
    let radius = b * b / c;
    let law = 4.0 * (a + m * c * c) * m * G * (c - radius) / (c_moment + m * c * radius).powi(2);
    near(number(&text, ", and above "), law.sqrt(), 1e-4);
}

/// Each listed constant has the same value later in the motion.
#[test]
fn constants_are_constant() {
    let rolling = StartVelocity::Rolling;
    let mut names = Vec::new();
    for setting in [
        Setting { law: ContactLaw::ROLLING, velocity: rolling, ..tippe_top() },
        tippe_top(),
        Setting { law: ContactLaw::FRICTIONLESS, ..tippe_top() },
        Setting { law: ContactLaw::FRICTIONLESS, ..egg() },
        Setting { law: ContactLaw::FRICTIONLESS, ..disk(1.1, [2.0, -13.0]) },
        disk(1.1, [2.0, -13.0]),
        Setting {
            moments: [1e-4, 2e-4, 2.5e-4],
            products: [1e-5, 0.0, -2e-5],
            law: ContactLaw::ROLLING,
            velocity: rolling,
            ..ball()
        },
        marble(GroundSide::Inside),
        Setting { ground: slope(0.2), velocity: StartVelocity::Along(Velocity::ZERO), ..ball() },
        rattleback(4.0, 0.3),
    ] {
        let constants = |setting: &Setting| {
            let document = explain(&setting.scenario("Goes on", 0.1, 2)).unwrap();
            let table = document.sections[4].blocks.iter().find_map(|block| match block {
                Block::Table { headers, rows } if headers[0] == "constant" => Some(rows.clone()),
                _ => None,
            });
            table.unwrap_or_default()
        };
        let (before, after) = (
            constants(&setting),
            constants(&setting.from(motion(&setting.scenario("Goes on", 0.13, 2)).samples().last().unwrap())),
        );
        assert!(!before.is_empty());
        assert_eq!(before.len(), after.len(), "{before:?} {after:?}");
        for (one, other) in before.iter().zip(&after) {
            let [a, b] = [one, other].map(|row| numbers(&row[1], ""));
            let size = a.iter().map(|x| x.abs()).fold(1e-9, f64::max);
            assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 2e-5 * size), "{one:?} {other:?}");
            names.push(one[0].clone());
        }
    }
    for name in [
        "T + U",
        "L · n",
        "ω · e",
        "ω · n",
        "J = −L · r",
        "ω_e √(A C + m r · {I} r)",
        "L_P in space",
        "v along the ground",
    ] {
        assert!(names.iter().any(|known| known == name), "{name}: {names:?}");
    }
}

/// Numbers of the steps before: the constraint, N, and the accelerations, from differences of the
/// run.
#[test]
fn accelerations_are_those_of_the_run() {
    for setting in [disk(1.1, [5.0, -13.0]), egg(), rattleback(4.0, 0.3), marble(GroundSide::Inside)] {
        let short = 1e-6;
        let scenario = setting.scenario("Begins", short, 2);
        let text = step(&scenario, 4);
        let run = motion(&scenario);
        let [first, last] = run.samples() else { panic!("two samples") };
        let [omega, velocity] = [numbers(&text, "torque − ω × {I} ω] = "), numbers(&text, "(N n + F)/m = ")];
        for k in 0..3 {
            let got = (last.state.omega.to_array()[k] - first.state.omega.to_array()[k]) / short;
            assert!((got - omega[k]).abs() < 1e-2 + 1e-3 * omega[k].abs(), "ω̇ {k}: {got} {omega:?}");
            let got = (last.velocity.to_array()[k] - first.velocity.to_array()[k]) / short;
            assert!((got - velocity[k]).abs() < 1e-3 + 1e-3 * velocity[k].abs(), "v̇ {k}: {got} {velocity:?}");
        }
        near(number(&step(&scenario, 2), "    N   = "), first.normal_force, 1e-5);
    }
}

/// All formulas are converted to MathML, so that no page shows them as letters.
#[test]
fn every_formula_is_typeset() {
    for Solution { document, .. } in
        crate::common::solutions().iter().filter(|one| one.scenario.ground().is_some())
    {
        let formulas = document.sections.iter().flat_map(|section| &section.blocks);
        let count = formulas.filter(|block| matches!(block, Block::Formula { .. })).count();
        let page = document.to_html();
        for block in document.sections.iter().flat_map(|section| &section.blocks) {
            if let Block::Formula { text, .. } = block {
                let first = text.lines().next().unwrap();
                assert!(!page.contains(&format!("<mtext>{}", first.replace('<', "&lt;"))), "{first}");
            }
        }
        assert!(count > 5);
        assert!(!document.answer.is_empty());
    }
}

#[test]
fn dry_friction_is_told_from_what_rolls_anyway() {
    let text = step(&Setting { law: dry(0.4), ..disk(1.1, [2.0, -13.0]) }.scenario("Held", 0.1, 3), 2);
    assert!(text.contains("it is held"), "{text}");
    let text = step(&disk(1.1, [2.0, -13.0]).scenario("Rolls", 0.1, 3), 2);
    assert!(text.contains("It rolls without slipping") && !text.contains("held"), "{text}");
}
