//! Closed forms in worked solutions: printed numbers, compared with Euler's equations or an
//! integral.

use std::f64::consts::PI;

use polhode::motion::Suspension;
use polhode::motion::torque::{Attracted, Drag, DragLaw, GravityGradient, UniformGravity};
use polhode::prelude::*;
use polhode_document::Block;
use polhode_scenario::report::explain;

use crate::common;

/// Returns the text of one step, with each block on separate lines.
fn step(scenario: &Scenario, number: usize) -> String {
    let mut document = explain(scenario).unwrap();
    document.sections = vec![document.sections.swap_remove(number)];
    document.answer.clear();
    document.to_text(400)
}

/// Returns the first number after a name: `A1 = -5.86444` or `(-5.86444)`. The name may occur
/// before, in a formula.
fn value(text: &str, name: &str) -> f64 {
    let numbers = text.match_indices(name).filter_map(|(start, _)| {
        let rest = text[start + name.len()..].trim_start_matches('(');
        let end = rest.find(|c: char| !(c.is_ascii_digit() || "-+.e".contains(c))).unwrap_or(rest.len());
        rest[..end].trim_end_matches('e').parse().ok()
    });
    numbers.into_iter().next().unwrap_or_else(|| panic!("no number after {name:?} in\n{text}"))
}

fn near(got: f64, want: f64, tolerance: f64) {
    assert!((got - want).abs() <= tolerance * want.abs().max(1e-300), "{got} is not {want}");
}

/// Integrates Euler's equations without torque by RK4.
fn euler(i: [f64; 3], mut omega: [f64; 3], time: f64, steps: u32) -> [f64; 3] {
    let rate = |w: [f64; 3]| {
        [
            (i[1] - i[2]) * w[1] * w[2] / i[0],
            (i[2] - i[0]) * w[2] * w[0] / i[1],
            (i[0] - i[1]) * w[0] * w[1] / i[2],
        ]
    };
    let moved = |w: [f64; 3], r: [f64; 3], h: f64| std::array::from_fn(|k| w[k] + h * r[k]);
    let h = time / f64::from(steps);
    for _ in 0..steps {
        let a = rate(omega);
        let b = rate(moved(omega, a, 0.5 * h));
        let c = rate(moved(omega, b, 0.5 * h));
        let d = rate(moved(omega, c, h));
        omega = std::array::from_fn(|k| omega[k] + h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]));
    }
    omega
}

/// Returns sn, cn, dn of u by the descending Gauss transformation (arithmetic-geometric mean;
/// Abramowitz & Stegun 16.4).
fn jacobi(u: f64, m1: f64) -> [f64; 3] {
    let (mut a, mut b, mut ratios) = (1.0_f64, m1.sqrt(), Vec::new());
    while (a - b).abs() > 1e-15 {
        ratios.push((a - b) / (a + b));
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    let mut phi = 2.0_f64.powi(i32::try_from(ratios.len()).unwrap()) * a * u;
    for ratio in ratios.into_iter().rev() {
        phi = 0.5 * (phi + (ratio * phi.sin()).asin());
    }
    let (sn, cn) = phi.sin_cos();
    [sn, cn, (cn * cn + m1 * sn * sn).sqrt()]
}

#[test]
fn the_printed_closed_form_solves_eulers_equations() {
    for (omega, order) in [([0.9, -0.4, 0.3], [2, 0, 1]), ([0.3, -0.5, 1.2], [1, 0, 2])] {
        let scenario = common::tensor("Tumbling", [3.1, 4.2, 5.3], [0.4, -0.3, 0.2], omega);
        let principal = scenario.rotor().principal();
        let start = (principal.rotation().inverse() * scenario.start().omega).to_array();
        let text = step(&scenario, 5);
        let amplitudes = ["A1 = ", "A2 = ", "A3 = "].map(|name| value(&text, name));
        let [rate, m, m1, phase] =
            ["    λ = ", ",  k² = ", "1 - k² = ", "    u0 = "].map(|name| value(&text, name));
        near(m + m1, 1.0, 2e-6);
        for time in [0.0, 1.7, -2.6] {
            let want = euler(principal.moments(), start, time, 4000);
            let of_phase = jacobi(rate * time + phase, m1);
            // Long-axis mode: dn, sn, cn; short-axis mode: cn, sn, dn.
            for k in 0..3 {
                let got = amplitudes[k] * of_phase[order[k]];
                assert!(
                    (got - want[k]).abs() < 2e-5,
                    "{omega:?} at {time}: ω{} = {got}, not {}\n{text}",
                    k + 1,
                    want[k]
                );
            }
        }
        // The functions with their numbers.
        let name = |k: usize| ["sn", "cn", "dn"][order[k]];
        for (k, amplitude) in amplitudes.into_iter().enumerate() {
            let line = text.lines().rfind(|line| line.contains(&format!("ω{} = ", k + 1))).unwrap();
            assert!(line.contains(&format!(" {}(", name(k))), "{line}");
            near(value(line, &format!("ω{} = ", k + 1)), amplitude, 1e-12);
        }
    }
}

#[test]
fn how_far_d_is_from_i2_has_its_own_digits() {
    // Next to the separatrix, where D and i2 have the same printed digits.
    let scenario = common::tensor("Nearly", [1.0, 2.0, 3.0], [0.0; 3], [1e-4, 1.5, 2e-4]);
    let text = step(&scenario, 5);
    // [i1 (i1 − i2) ω1² + i3 (i3 − i2) ω3²] / 2T
    let want = (3.0 * 4e-8 - 1e-8) / (1e-8 + 2.0 * 2.25 + 3.0 * 4e-8);
    let line = text.lines().find(|line| line.contains("D - i2 = ")).unwrap();
    near(value(line, "4.5 = "), want, 1e-5);
    assert!(text.contains("D > i2: short-axis mode"), "{text}");
}

/// Top inclined by 0.9 rad, with its centre of mass off all body axes and ω in a generic direction.
fn leaning() -> Scenario {
    let e = Direction::<Body>::new(2.0, -3.0, 6.0) * (1.0 / 7.0);
    // A = 0.4 normal to e, C = 0.15 along it, about the centre of mass; M = 1.7 kg, l = 0.3 m.
    let [across, along, mass, arm] = [0.4, 0.15, 1.7, 0.3];
    let e_ = e.to_array();
    let element = |i: usize, j: usize| (if i == j { across } else { 0.0 }) + (along - across) * e_[i] * e_[j];
    let rows = std::array::from_fn(|i| std::array::from_fn(|j| element(i, j)));
    let inertia = InertiaTensor::from_matrix(rows).unwrap();
    let center = Position::from_array(e_.map(|c| arm * c));
    let body = MassProperties::new(mass, center, inertia).unwrap();
    let mut s = Scenario::new(body).held_at(Position::ZERO).unwrap();
    let tilt = Rotation::from_axis_angle(Direction::new(0.48, 0.6, 0.64), 0.9).unwrap();
    s = common::facing(s, tilt);
    s = common::spinning(
        s,
        AngularVelocity::from_array([0, 1, 2].map(|k| 45.0 * e_[k] + [0.7, -0.4, 0.9][k])),
    );
    let gravity = UniformGravity { acceleration: Acceleration::new(1.2, -0.7, -9.3) };
    s.with_torques([TorqueModel::Gravity(gravity)]).unwrap()
}

#[test]
fn the_tops_constants_roots_period_and_precession_are_those_of_its_integrals() {
    let scenario = leaning();
    let text = step(&scenario, 5);
    // A and C about the pivot, independently, from the numbers of `leaning`.
    let (a, c) = (0.4 + 1.7 * 0.09, 0.15);
    let g = Acceleration::<Space>::new(1.2, -0.7, -9.3);
    let weight = 1.7 * 0.3 * g.norm();
    near(value(&text, "M g l = "), weight, 1e-5);
    near(value(&text, ",  A = "), a, 1e-5);
    near(value(&text, ",  C = "), c, 1e-5);
    let e = Direction::<Body>::new(2.0, -3.0, 6.0) * (1.0 / 7.0);
    let (start, up) = (scenario.start(), -g.direction().unwrap());
    let omega = start.omega.to_array();
    let spin: f64 = (0..3).map(|k| omega[k] * e.to_array()[k]).sum();
    // L = A (ω − ω_e e) + C ω_e e
    let l: [f64; 3] = std::array::from_fn(|k| a * omega[k] + (c - a) * spin * e.to_array()[k]);
    let up_in_body = (start.attitude.inverse() * up).to_array();
    let dot = |x: [f64; 3], y: [f64; 3]| (0..3).map(|k| x[k] * y[k]).sum::<f64>();
    let (p_phi, p_psi) = (dot(l, up_in_body), c * spin);
    near(value(&text, "p_φ = L · k̂ = "), p_phi, 1e-5);
    assert!(text.contains(&format!("C ω_e = {}", "0.15·")), "{text}");
    let height = dot(e.to_array(), up_in_body);
    let energy = 0.5 * dot(l, omega) + weight * height - p_psi * p_psi / (2.0 * c);
    near(value(&text, "    E′ = "), energy, 1e-5);
    // f(u) = (1 − u²)(2E′ − 2 M g l u)/A − (p_φ − p_ψ u)²/A²
    let f =
        |u: f64| (1.0 - u * u) * (2.0 * energy - 2.0 * weight * u) / a - ((p_phi - p_psi * u) / a).powi(2);
    let [u1, u2, u3] = ["    u1 = ", ",  u2 = ", ",  u3 = "].map(|name| value(&text, name));
    let slope = |u: f64| (f(u + 1e-6) - f(u - 1e-6)) / 2e-6;
    for u in [u1, u2, u3] {
        assert!((f(u) / slope(u)).abs() < 2e-5 * u.abs().max(1.0), "f({u}) = {}", f(u));
    }
    assert!(u1 < height && height < u2 && u2 < 1.0 && u3 > 1.0);
    // Newton's method, so that the quadrature below has more than six digits.
    let polished = |u: f64| (0..3).fold(u, |u, _| u - f(u) / slope(u));
    let [u1, u2] = [polished(u1), polished(u2)];
    // With u = (u1 + u2)/2 + (u2 − u1)/2 sin s, ∫ du/√f is smooth in s at both ends; one period is
    // down and up.
    const POINTS: u32 = 2000;
    let (mut period, mut precession) = (0.0, 0.0);
    for k in 0..POINTS {
        let s = PI * ((f64::from(k) + 0.5) / f64::from(POINTS) - 0.5);
        let u = 0.5 * (u1 + u2) + 0.5 * (u2 - u1) * s.sin();
        let time = 2.0 * PI / f64::from(POINTS) * 0.5 * (u2 - u1) * s.cos() / f(u).sqrt();
        period += time;
        precession += time * (p_phi - p_psi * u) / (a * (1.0 - u * u));
    }
    near(value(&text, "2 K(k) / λ = "), period, 2e-4);
    near(value(&text, "precession in a nutation = "), precession.to_degrees(), 2e-4);
    near(value(&text, "φ\u{307} on average = "), precession / period, 2e-4);
    let bounds = text.lines().find(|line| line.contains("θ = ") && line.contains(" … ")).unwrap();
    near(value(bounds, "θ = "), u2.acos().to_degrees(), 1e-5);
    near(value(bounds, " … "), u1.acos().to_degrees(), 1e-5);
}

#[test]
fn the_effective_potential_is_drawn_between_its_turning_points() {
    let scenario = leaning();
    let document = explain(&scenario).unwrap();
    let graph = document.sections[5].blocks.iter().find_map(|block| match block {
        Block::Graph(graph) => Some(graph.clone()),
        _ => None,
    });
    let graph = graph.unwrap();
    let text = step(&scenario, 5);
    let ([from, to, energy], _) = graph.level;
    near(energy, value(&text, "    E′ = "), 1e-5);
    // θ̇ = 0 at the turning points, where U_eff = E′. U_eff is smaller between them and larger
    // outside.
    for [theta, potential] in &graph.points {
        let inside = from < *theta && *theta < to;
        assert_eq!(*potential < energy, inside, "U_eff({theta}°) = {potential} beside {energy}");
    }
    assert!(graph.points.iter().any(|p| p[0] < from) && graph.points.iter().any(|p| p[0] > to));
    let page = document.to_html();
    assert!(page.contains("<svg") && page.contains("</svg>"));
    assert!(document.to_latex().contains("\\begin{tikzpicture}"));
    assert!(document.to_markdown().contains("U_eff (J)"));
}

#[test]
fn the_pendulums_series_sum_to_its_period() {
    let amplitude = 1.3_f64;
    let axis = Direction::new(0.0, 0.0, 1.0);
    let scenario =
        common::pendulum().suspended_from(Suspension { axis, amplitude: Some(amplitude) }).unwrap();
    let text = step(&scenario, 5);
    // P ω0 / 2π = (2/π) K(k), by the arithmetic-geometric mean.
    let (mut a, mut b) = (1.0, (0.5 * amplitude).cos());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    let ratio = 1.0 / a;
    for name in [", in k: ", ", in θmax: "] {
        let line = text.lines().find(|line| line.contains(name)).unwrap();
        let sum = value(&line[line.rfind(" = ").unwrap()..], " = ");
        let rest = value(&line[line.rfind(", ").unwrap()..], ", ");
        // The printed remainder of the series has two digits.
        assert!((1.0 + sum + rest - ratio).abs() < 0.06 * rest && rest < 0.01, "{line}: {ratio}");
    }
    // The swing test returns the original moment.
    let [m1, m2, b, ..] = common::PENDULUM;
    let moment = b * b * (m1 + 0.25 * m2);
    let mass = m1 + m2;
    let arm = b * (m1 + 0.5 * m2) / mass;
    near(value(&text, "/ 2π)² = "), moment, 1e-5);
    let line = text.lines().rfind(|line| line.contains("I_c = ")).unwrap();
    near(value(&line[line.rfind(" = ").unwrap()..], " = "), moment - mass * arm * arm, 1e-4);
}

/// Body of 2, 3 and 4 kg·m² under linear drag.
fn resisted(matrix: [[f64; 3]; 3]) -> Scenario {
    let drag = Drag::new(DragLaw::Linear, matrix).unwrap();
    let body = common::tensor("Resisted", [2.0, 3.0, 4.0], [0.0; 3], [0.3, -0.2, 0.5]);
    body.with_torques([TorqueModel::Drag(drag)]).unwrap()
}

#[test]
fn drag_has_its_decay_times_or_its_matrix() {
    let text = step(&resisted([[0.02, 0.0, 0.0], [0.0, 0.033, 0.0], [0.0, 0.0, 0.05]]), 5);
    for (k, time) in [(1, 100.0), (2, 3.0 / 0.033), (3, 80.0)] {
        let line = text.lines().find(|line| line.contains(&format!("about axis {k}: "))).unwrap();
        near(value(&line[line.rfind(" = ").unwrap()..], " = "), time, 1e-5);
    }
    // {I}⁻¹ C: its rows are divided by the moments.
    let text = step(&resisted([[0.02, 0.003, 0.0], [0.003, 0.03, 0.0], [0.0, 0.0, 0.05]]), 5);
    assert!(text.contains("C is not along the principal axes"), "{text}");
    assert!(text.contains("⎡ 0.0100  0.0015  0      ⎤"), "{text}");
    assert!(text.contains("⎢ 0.0010  0.0100  0      ⎥"), "{text}");
}

#[test]
fn the_gradient_has_the_librations_of_its_equations() {
    // n² = µ/r³; axis 1 is along the radius, 2 along the flight direction, 3 along the normal.
    let (mu, radius) = (3.986e14_f64, 7.0e6_f64);
    let n = (mu / radius.powi(3)).sqrt();
    let [yaw, roll, pitch] = [2.0, 5.0, 6.0];
    let orbit = polhode::motion::Orbit::circular(
        mu,
        radius,
        Direction::new(1.0, 0.0, 0.0),
        Direction::new(0.0, 1.0, 0.0),
    );
    let gradient = GravityGradient { orbit: orbit.unwrap(), attracted: Attracted::Tensor };
    let body = common::tensor("Facing the Earth", [yaw, roll, pitch], [0.0; 3], [0.0, 0.0, n]);
    let text = step(&body.with_torques([TorqueModel::GravityGradient(Box::new(gradient))]).unwrap(), 5);
    let line = text.lines().find(|line| line.contains("pitch: ")).unwrap();
    near(value(line, "/Ip) = "), n * (3.0 * (roll - yaw) / pitch).sqrt(), 1e-5);
    let line = text.lines().find(|line| line.contains("roll and yaw: ")).unwrap();
    for frequency in [value(line, "roll and yaw: "), value(line, " and ")] {
        // [Ir s² + 4n² (Ip − Iy)] [Iy s² + n² (Ip − Ir)] + n² (Ir + Iy − Ip)² s² = 0, s² = −ϖ²
        let s2 = -(frequency / n).powi(2);
        let first = (roll * s2 + 4.0 * (pitch - yaw)) * (yaw * s2 + (pitch - roll));
        let coupling = (roll + yaw - pitch).powi(2) * s2;
        assert!((first + coupling).abs() < 4e-4 * coupling.abs(), "{frequency}: {first} {coupling}\n{text}");
    }
}

/// A top released at rest without spin swings in a plane: no precession is printed, and nothing is
/// divided by it.
#[test]
fn a_top_that_swings_in_a_plane_does_not_precess() {
    let text = step(&common::spinning(leaning(), AngularVelocity::ZERO), 5);
    assert!(!text.contains("precession in a nutation") && !text.contains('—'), "{text}");
    assert!(text.contains("u1 ≤ u2 ≤ 1 ≤ u3"));
}

/// θ refers to the axis in the formula, also if L points against it.
#[test]
fn theta_is_the_angle_of_its_formula() {
    for sign in [1.0, -1.0] {
        let omega = [0.3, -0.2, 1.3 * sign];
        let scenario = common::tensor("Tumbling", [2.0, 3.0, 4.0], [0.0; 3], omega);
        let text = step(&scenario, 6);
        let line = text.lines().find(|line| line.contains("θ = ") && line.contains(" … ")).unwrap();
        let [least, most] = [value(line, "θ = "), value(line, " … ")];
        let l = [2.0 * omega[0], 3.0 * omega[1], 4.0 * omega[2]];
        let theta = (l[2] / l.iter().map(|x| x * x).sum::<f64>().sqrt()).acos().to_degrees();
        assert!(least <= theta && theta <= most && most - least > 0.1, "{line}: {theta}");
    }
}

/// Drag with other torques has no separate decay; the line of a rod has none at all.
#[test]
fn drag_is_solved_alone_and_across_a_rod() {
    // Normal to the rod along (0.3, −0.4, 1.2): C = 0.1 p pᵀ + 0.3 q qᵀ + 0.05 (p qᵀ + q pᵀ).
    let (p, q) = ([0.8, 0.6, 0.0], [-0.72 / 1.3, 0.96 / 1.3, 0.5 / 1.3]);
    let element =
        |i: usize, j: usize| 0.1 * p[i] * p[j] + 0.3 * q[i] * q[j] + 0.05 * (p[i] * q[j] + q[i] * p[j]);
    let matrix = std::array::from_fn(|i| std::array::from_fn(|j| element(i, j)));
    let drag = TorqueModel::Drag(Drag::new(DragLaw::Linear, matrix).unwrap());
    let push = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.1, 0.2, -0.3)));
    let body = common::tensor("Pushed", [2.0, 3.0, 4.0], [0.0; 3], [0.3, -0.2, 0.5]);
    assert!(!step(&body.with_torques([drag.clone(), push]).unwrap(), 5).contains("exp(−t/τk)"));
    let text = step(&common::rod().with_torques([drag]).unwrap(), 5);
    assert!(text.contains("Without inertia about axis 1"), "{text}");
    assert!(text.contains("C22 / i2 = ") && text.contains("C23 / i2 = ") && !text.contains('—'), "{text}");
}

/// Letters unknown to pdfLaTeX are written by their code points, and special characters in names
/// are escaped.
#[test]
fn latex_holds_any_name() {
    let scenario = common::hostile("Größe 慣性 100 % a_b^c {x} \\end{document} $1 & #2 ~ <tag> ½ ω\u{307}");
    let latex = explain(&scenario).unwrap().to_latex();
    let body = latex.split_once("\\begin{document}").unwrap().1;
    assert_eq!(body.matches("\\end{document}").count(), 1, "{body}");
    assert!(
        body.contains("Größe \\letter{6163}{慣}\\letter{6027}{性} 100 \\% a\\_b\\textasciicircum{}c \\{x\\}"),
        "{body}"
    );
    assert!(body.contains("\\textbackslash{}end\\{document\\} \\$1 \\& \\#2 \\textasciitilde{} $<$tag$>$ $\\tfrac12$ $\\dot{\\omega}$"));
}

/// LaTeX has every character of a solution.
/// LaTeX takes a `[` after the end of a line for an argument of that end.
#[test]
fn a_line_may_begin_with_a_bracket_in_latex() {
    let document = polhode_document::Document::of_text("It", "topic = \"box\"\n[answers]\n* 3");
    let latex = document.to_latex();
    assert!(latex.contains("\\\\{}\n[answers]\\\\{}\n"), "{latex}");
}

#[test]
fn latex_has_every_sign_of_a_solution() {
    let leaning = explain(&leaning()).unwrap();
    for document in common::solutions().iter().map(|solution| &solution.document).chain([&leaning]) {
        let latex = document.to_latex();
        let (_, body) = latex.split_once("\\begin{document}").unwrap();
        assert!(!body.contains("\\letter{"), "{body}");
        for c in body.chars() {
            assert!(c <= '\u{17f}' && !('\u{a0}'..='\u{bf}').contains(&c), "{c:?} in\n{body}");
        }
        assert_eq!(body.matches("\\begin{").count(), body.matches("\\end{").count() - 1);
    }
}
