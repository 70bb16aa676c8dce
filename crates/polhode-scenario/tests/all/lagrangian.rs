//! Solutions by Lagrange's and Hamilton's equations: residuals along the motion, results against
//! the other reports, and scenarios without a Lagrangian.

use std::path::{Path, PathBuf};

use polhode_document::{Block, Document};
use polhode_scenario::report::{Formalism, LagrangianError, lagrangian};
use polhode_scenario::request::explain::{REPORT_SCHEMA, Request, run};
use polhode_scenario::symbolic::Exact;
use polhode_source::Failure;
use polhode_source::files::{Disk, Files, Memory};

use crate::common;
use crate::fit::misfit;

/// Bound of residuals and drifts; the runs of these scenarios have the tolerance 1e-13.
const SMALL: f64 = 1e-10;

fn solved(files: &dyn Files, file: PathBuf, is_hamiltonian: bool) -> Result<Document, Failure> {
    let request = Request { file, lagrangian: !is_hamiltonian, hamiltonian: is_hamiltonian };
    run(&request, files).map(|solution| solution.0)
}

fn of_text(text: &str, is_hamiltonian: bool) -> Result<Document, Failure> {
    solved(&Memory::from([("it.toml", text)]), "it.toml".into(), is_hamiltonian)
}

fn of_example(name: &str, is_hamiltonian: bool) -> Result<Document, Failure> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    solved(&Disk, folder.join(name), is_hamiltonian)
}

/// Returns the names and values of the table of the verification.
fn verified(document: &Document) -> Vec<(String, f64)> {
    let blocks = &document.sections.last().unwrap().blocks;
    let tables = blocks.iter().filter_map(|block| match block {
        Block::Table { rows, .. } => Some(rows),
        _ => None,
    });
    tables.flatten().map(|row| (row[0].clone(), row[2].parse().unwrap())).collect()
}

/// Returns the text of both forms after the checks that hold for all systems; `count` is the number
/// of equations and conserved quantities of each.
fn check(of: &dyn Fn(bool) -> Result<Document, Failure>, count: [usize; 2]) -> [String; 2] {
    [false, true].map(|is_hamiltonian| {
        let document = of(is_hamiltonian).unwrap_or_else(|failure| panic!("{failure}"));
        let rows = verified(&document);
        assert_eq!(rows.len(), count[usize::from(is_hamiltonian)], "{rows:?}");
        for (name, value) in rows {
            assert!(value < SMALL, "{name}: {value}");
        }
        assert_eq!(misfit(&REPORT_SCHEMA, &document.to_json()), None);
        document.to_text(400)
    })
}

fn require(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "no {part:?} in\n{text}");
    }
}

#[test]
fn pendulum_of_the_notes() {
    let [lagrange, hamilton] = check(&|h| of_example("notes/11-04-pendulum.toml", h), [2, 3]);
    require(
        &lagrange,
        &[
            "T = 1/2 I θ\u{307}²",
            "U = −M g d cos θ",
            "p_θ = ∂L/∂θ\u{307} = I θ\u{307}",
            "I θ\u{308} + M g d sin θ = 0",
            "θ\u{308} ≃ −ω₀² θ",
            "ω₀ = √(M g d/I)",
            "ω₀² = g (m₁ r₁ + m₂ r₂)/(m₁ r₁² + m₂ r₂²)",
        ],
    );
    require(&hamilton, &["H = p_θ²/(2 I) − M g d cos θ", "θ\u{307} = p_θ/I", "p\u{307}_θ = −M g d sin θ"]);
}

const BOX: &str = "
[[body.part]]
shape = 'box'
size = ['0.1 m', '0.2 m', '0.3 m']
mass = '2 kg'
rotate = { axis = [1, 2, 3], angle = '50 deg' }
position = ['0.25 m', '-0.1 m', '0.07 m']
";

/// The axis is not a principal axis, so a run leaves it; the pendulum itself is verified.
#[test]
fn physical_pendulum() {
    let text = format!(
        "{BOX}
[start]
attitude = {{ axis = [1, -2, 1], angle = '25 deg' }}
spin = {{ body = ['0.2 rad/s', '-0.4 rad/s', '0.6 rad/s'] }}
[[torque]]
model = 'gravity'
pivot = ['0.02 m', '0.05 m', '-0.03 m']
acceleration = ['3 m/s^2', '-9 m/s^2', '1 m/s^2']
[pendulum]
axis = [1, -2, 3]
[run]
duration = '3 s'
samples = 101
"
    );
    let [lagrange, _] = check(&|h| of_text(&text, h), [2, 3]);
    require(&lagrange, &["a physical pendulum", "the closed form of the pendulum"]);
    let explained = run(
        &Request { file: "it.toml".into(), ..Request::default() },
        &Memory::from([("it.toml", text.as_str())]),
    );
    // The same frequency as in the solution by Euler's equations.
    let explained = explained.unwrap().0.to_text(400);
    let after = |text: &str| text.split("ω0 = ").nth(1).unwrap().split(' ').next().unwrap().to_owned();
    assert_eq!(after(&lagrange), after(&explained));
}

/// Axis of the body, vertical and attitude along no axis.
const TOP: &str = "
[[body.part]]
shape = 'cylinder'
radius = '80 mm'
length = '12 mm'
mass = '0.7 kg'
rotate = { axis = [0, 1, 0], angle = '36.86989764584402 deg' }
position = ['60 mm', '0 mm', '80 mm']
[start]
attitude = { euler313 = ['20 deg', '40 deg', '-70 deg'] }
spin = { body = ['60 rad/s', '-3 rad/s', '70 rad/s'] }
[[torque]]
model = 'gravity'
pivot = ['0 mm', '0 mm', '0 mm']
acceleration = ['2 m/s^2', '-3 m/s^2', '-9 m/s^2']
[run]
duration = '1 s'
samples = 101
";

#[test]
fn heavy_top() {
    let [lagrange, hamilton] = check(&|h| of_text(TOP, h), [6, 9]);
    require(
        &lagrange,
        &[
            "ω₃ = φ\u{307} cos θ + ψ\u{307}",
            "φ is cyclic",
            "ψ is cyclic",
            "U_eff = (p_ψ cos θ − p_φ)²/(2 I₁ sin² θ) + M g l cos θ",
            "φ\u{307} = (p_ψ ± √(p_ψ² − 4 I₁ M g l cos θ))/(2 I₁ cos θ)",
            "d² U_eff/dθ² = p_ψ²/(4 I₁) − M g l > 0",
            "turning points",
            "slow steady precession",
        ],
    );
    require(&hamilton, &["H = p_θ²/(2 I₁) + (p_ψ cos θ − p_φ)²/(2 I₁ sin² θ) + p_ψ²/(2 I₃) + M g l cos θ"]);
    // The examples start from cusps and loops, and asleep.
    for name in ["heavy-top", "top-cusps", "top-loops", "sleeping-top"] {
        check(&|h| of_example(&format!("{name}.toml"), h), [6, 9]);
    }
}

#[test]
fn torsion_pendulum() {
    let text = format!(
        "{}
[start]
attitude = {{ axis = [0, 1, 0], angle = '36.86989764584402 deg' }}
spin = {{ space = ['0.6 rad/s', '0 rad/s', '0.8 rad/s'] }}
[[torque]]
model = 'torsion'
stiffness = '0.08 N m/rad'
rest = {{ axis = [0, 1, 0], angle = '36.86989764584402 deg' }}
axis = [0.6, 0, 0.8]
[run]
duration = '3 s'
samples = 101
",
        BOX.replace("rotate = { axis = [1, 2, 3], angle = '50 deg' }", "")
    );
    let [lagrange, hamilton] = check(&|h| of_text(&text, h), [2, 3]);
    require(&lagrange, &["U = 1/2 κ θ²", "I θ\u{308} + κ θ = 0", "ω₀ = √(κ/I)"]);
    require(&hamilton, &["p\u{307}_θ = −κ θ"]);
    // A spring turns the body about the same axis.
    check(&|h| of_text(&text.replace("axis = [0.6, 0, 0.8]\n", ""), h), [2, 3]);
    let [example, _] = check(&|h| of_example("torsion-pendulum.toml", h), [2, 3]);
    require(&example, &["period 2π/ω0 = 7.02481 s"]);
}

const BALL: &str = "
[[body.part]]
shape = 'sphere'
radius = '0.2 m'
mass = '3 kg'
[contact]
surface = { shape = 'sphere', radius = '0.2 m' }
ground = { shape = 'plane', slope = '20 deg' }
law = 'rolling'
[start]
attitude = { axis = [1, 2, 3], angle = '50 deg' }
spin = { space = ['0 rad/s', '-3 rad/s', '0 rad/s'] }
[run]
duration = '2 s'
samples = 51
";

#[test]
fn rolling_along_a_line() {
    let [lagrange, hamilton] = check(&|h| of_text(BALL, h), [4, 5]);
    require(
        &lagrange,
        &[
            "a rolling ball",
            "x = a φ",
            "x\u{308} = (M a² g sin α)/(M a² + I)",
            "M x\u{308} − M g sin α = λ",
            "I φ\u{308} = −a λ",
        ],
    );
    require(&hamilton, &["p\u{307}_x = M g sin α"]);
    let level = BALL.replace(", slope = '20 deg'", "");
    let [lagrange, _] = check(&|h| of_text(&level, h), [5, 6]);
    require(&lagrange, &["x is cyclic"]);
    let [lagrange, _] = check(&|h| of_example("hoop.toml", h), [4, 5]);
    require(&lagrange, &["a rolling disk", "a = 0.306 m"]);
}

#[test]
fn free_tops() {
    let asymmetric = format!(
        "{BOX}
[start]
attitude = {{ euler313 = ['20 deg', '40 deg', '-70 deg'] }}
spin = {{ body = ['2 rad/s', '-3 rad/s', '4 rad/s'] }}
[run]
duration = '3 s'
samples = 101
"
    );
    let [lagrange, hamilton] = check(&|h| of_text(&asymmetric, h), [6, 9]);
    require(&lagrange, &["T = 1/2 I₁ ω₁² + 1/2 I₂ ω₂² + 1/2 I₃ ω₃²", "axis 2", "λ² = −ω²", "φ is cyclic"]);
    require(&hamilton, &["H = L₁²/(2 I₁) + L₂²/(2 I₂) + L₃²/(2 I₃)"]);
    let symmetric = asymmetric.replace("'0.1 m', '0.2 m', '0.3 m'", "'0.2 m', '0.2 m', '0.3 m'");
    let [lagrange, _] = check(&|h| of_text(&symmetric, h), [7, 10]);
    require(&lagrange, &["a free symmetric top", "φ\u{307} = p_ψ/(I₁ cos θ)", "Ω² = φ\u{307}²"]);
    for name in ["notes/force-free-top", "notes/11-05-principal-axes"] {
        check(&|h| of_example(&format!("{name}.toml"), h), [7, 10]);
    }
    for name in ["t-handle", "tennis-racket"] {
        check(&|h| of_example(&format!("{name}.toml"), h), [6, 9]);
    }
}

/// Without a run the equations are printed, but not verified.
#[test]
fn without_a_run() {
    let document = of_text(&TOP[..TOP.find("[run]").unwrap()], false).unwrap();
    assert!(verified(&document).is_empty());
    require(&document.to_text(400), &["not verified, because the scenario has no [run]"]);
}

/// Euler angles are singular along the whole motion of an upright top.
#[test]
fn upright_top_is_not_verified() {
    let upright = TOP
        .replace("rotate = { axis = [0, 1, 0], angle = '36.86989764584402 deg' }", "")
        .replace("['60 mm', '0 mm', '80 mm']", "['0 mm', '0 mm', '80 mm']")
        .replace("euler313 = ['20 deg', '40 deg', '-70 deg']", "euler313 = ['20 deg', '0 deg', '0 deg']")
        .replace("['60 rad/s', '-3 rad/s', '70 rad/s']", "['0 rad/s', '0 rad/s', '70 rad/s']")
        .replace("['2 m/s^2', '-3 m/s^2', '-9 m/s^2']", "['0 m/s^2', '0 m/s^2', '-9 m/s^2']");
    let document = of_text(&upright, false).unwrap();
    assert!(verified(&document).is_empty());
    require(&document.to_text(400), &["singular at all samples", "the top sleeps above"]);
}

#[test]
fn other_scenarios_are_refused() {
    for (name, why) in [
        ("notes/11-10-dumbbell.toml", "its motion is prescribed"),
        ("shaft.toml", "its motion is prescribed"),
        ("gimbals.toml", "in gimbals"),
        ("gyrostat.toml", "momentum wheels"),
        ("drag.toml", "a torque of model drag acts"),
        ("ball-in-bowl.toml", "a plane at rest"),
        ("ball-on-turntable.toml", "a plane at rest"),
        ("coin.toml", "dissipates energy"),
        ("sliding-ball.toml", "does not roll at t = 0 s"),
        ("rattleback.toml", "a sphere, a rim or a cylinder"),
    ] {
        for is_hamiltonian in [false, true] {
            let failure = of_example(name, is_hamiltonian).expect_err(name);
            assert!(failure.message().contains(why), "{name}: {failure}");
            assert!(failure.to_string().contains("there is one for: a pendulum"), "{failure}");
        }
    }
    let with = |text: &str, old: &str, new: &str| {
        assert!(text.contains(old));
        of_text(&text.replace(old, new), false).expect_err(new).message()
    };
    // Asymmetric about the line to the centre of mass.
    let message = with(TOP, "position = ['60 mm', '0 mm', '80 mm']", "position = ['60 mm', '5 mm', '80 mm']");
    assert!(message.contains("symmetric about the line"), "{message}");
    let level = BALL.replace(", slope = '20 deg'", "");
    let message = with(&level, "'-3 rad/s', '0 rad/s']", "'-3 rad/s', '1 rad/s']");
    assert!(message.contains("ω has another direction"), "{message}");
    let message = with(BALL, "['0 rad/s', '-3 rad/s'", "['1 rad/s', '-3 rad/s'");
    assert!(message.contains("does not move along a line"), "{message}");
}

/// Rods, spheres, rest, permanent rotations, extreme numbers: verified, or refused for a reason.
#[test]
fn edge_cases_are_verified_or_refused() {
    let mut solved = 0;
    for scenario in common::all().into_iter().chain(common::ground::all()) {
        for formalism in [Formalism::Lagrange, Formalism::Hamilton] {
            let title = scenario.title().unwrap();
            match lagrangian(&scenario, formalism, &Exact::None) {
                Ok(document) => {
                    solved += 1;
                    for (name, value) in verified(&document) {
                        assert!(value < SMALL, "{title}: {name}: {value}");
                    }
                }
                Err(LagrangianError::NoSystem { .. } | LagrangianError::Motion(_)) => {}
                Err(LagrangianError::OutOfRange) if matches!(title, "Tiny" | "Huge") => {}
                Err(error) => panic!("{title}: {error}"),
            }
        }
    }
    assert!(solved >= 40, "{solved}");
}

#[test]
fn both_forms_are_refused() {
    let request = Request { file: "it.toml".into(), lagrangian: true, hamiltonian: true };
    let failure = run(&request, &Memory::from([("it.toml", TOP)])).unwrap_err();
    assert!(failure.to_string().contains("request one of them"), "{failure}");
}

#[test]
fn the_symbols_of_the_file_are_inserted() {
    // Lecture notes, example 11.4: T = ½ (m₁ + m₂/4) b² θ̇², U = −m₁ g b cos θ − m₂ g (b/2) cos θ
    let text = of_example("notes/11-04-pendulum.toml", false).unwrap().to_text(400);
    let lines = [
        "In the symbols of the file:",
        "T = 1/2 (m₁ + m₂/4) b² θ\u{307}²",
        "U = −(m₁ + m₂/2) b g cos θ",
        "(m₁ + m₂/4) b² θ\u{308} + (m₁ + m₂/2) b g sin θ = 0",
    ];
    require(&text, &lines);
    let text = of_example("notes/force-free-top.toml", true).unwrap().to_text(400);
    require(&text, &["In the symbols of the file:", "T = 1/24 M (3 R² + h²) θ\u{307}²"]);
}
