//! Worked solutions in symbols.

use polhode_document::Report as _;
use polhode_scenario::read::ScenarioFile;
use polhode_scenario::request::explain::{Request, run};
use polhode_scenario::symbolic::{Exact, Gap, Symbolic};
use polhode_source::files::Memory;

fn file(text: &str) -> ScenarioFile {
    ScenarioFile::parse(&Memory::default(), text.to_owned(), "body.toml".as_ref()).unwrap()
}

fn symbolic(text: &str) -> Result<Symbolic, Gap> {
    found(&file(text))
}

fn found(file: &ScenarioFile) -> Result<Symbolic, Gap> {
    match file.exact() {
        Exact::Symbols(symbolic) => Ok(symbolic),
        Exact::Gap(gap) => Err(gap),
        other => panic!("{other:?}"),
    }
}

fn gap(text: &str) -> String {
    symbolic(text).unwrap_err().to_string()
}

/// Returns the text of the worked solution, its lines without indentation.
fn explained(text: &str) -> Vec<String> {
    let request = Request { file: "body.toml".into(), ..Request::default() };
    let solution = run(&request, &Memory::from([("body.toml", text)])).unwrap();
    solution.to_document().to_text(100).lines().map(|line| line.trim().to_owned()).collect()
}

/// Checks that the worked solution has lines, in this order.
fn assert_lines(text: &str, lines: &[&str]) {
    let all = explained(text);
    let mut rest = all.iter();
    for line in lines {
        assert!(rest.any(|found| found == line), "no `{line}` after the others in\n{}", all.join("\n"));
    }
}

/// Symbols of generic values; unused ones are left out by [`scenario`].
const SYMBOLS: [(&str, &str); 12] = [
    ("M", "2.3 kg"),
    ("m2", "0.7 kg"),
    ("a", "0.31 m"),
    ("b", "0.17 m"),
    ("c", "0.23 m"),
    ("d", "-0.41 m"),
    ("rho", "1300 kg/m^3"),
    ("alpha", "0.6 rad"),
    ("beta", "-1.1 rad"),
    ("omega", "3.2 rad/s"),
    ("w2", "-1.7 rad/s"),
    ("g", "9.7 m/s^2"),
];

/// Returns a scenario with the symbols that occur in it.
fn scenario(text: &str) -> String {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let used =
        |name: &str| text.split('"').skip(1).step_by(2).any(|t| t.split(|c| !is_word(c)).any(|w| w == name));
    let symbols = SYMBOLS.iter().filter(|(name, _)| used(name));
    let lines: Vec<String> = symbols.map(|(name, value)| format!("{name} = \"{value}\"\n")).collect();
    format!("[symbols]\n{}{text}", lines.concat())
}

/// Shapes in symbols, at generic sizes.
const SHAPES: [&str; 22] = [
    "shape = 'box'\nsize = [\"a\", \"b\", \"2*c\"]",
    "shape = 'box_shell'\nsize = [\"a\", \"b\", \"2*c\"]",
    "shape = 'plate'\nsize = [\"a\", \"b + c/3\"]",
    "shape = 'sphere'\nradius = \"a\"",
    "shape = 'sphere'\nradius = \"a\"\ninner_radius = \"b\"",
    "shape = 'sphere_shell'\nradius = \"a\"",
    "shape = 'ellipsoid'\nsemi_axes = [\"a\", \"b\", \"c\"]",
    "shape = 'cylinder'\nradius = \"a\"\nlength = \"b\"",
    "shape = 'cylinder'\nradius = \"a\"\ninner_radius = \"b\"\nlength = \"c\"",
    "shape = 'cylinder_shell'\nradius = \"a\"\nlength = \"b\"",
    "shape = 'cylinder_shell'\nradius = \"a\"\nlength = \"b\"\nends = true",
    "shape = 'cone'\nradius = \"a\"\nheight = \"b\"",
    "shape = 'cone'\nradius = \"a\"\ntop_radius = \"b\"\nheight = \"c\"",
    "shape = 'cone'\nradius = 0\ntop_radius = \"b\"\nheight = \"c\"",
    "shape = 'cone_shell'\nradius = \"a\"\ntop_radius = \"b\"\nheight = \"c\"",
    "shape = 'capsule'\nradius = \"a\"\nlength = \"b\"",
    "shape = 'torus'\nring_radius = \"a\"\ntube_radius = \"b\"",
    "shape = 'rod'\nlength = \"a\"",
    "shape = 'disk'\nradius = \"a\"",
    "shape = 'triangular_plate'\nvertices = [[0, \"a\"], [\"b\", \"-c\"], [\"d\", 0]]",
    "shape = 'triangular_prism'\nvertices = [[0, \"a\"], [\"b\", \"-c\"], [\"d\", 0]]\nlength = \"c\"",
    "shape = 'tetrahedron'\nvertices = [[0, 0, \"a\"], [\"b\", \"c\", 0], [\"d\", 0, 0], [0, \"a\", \"b\"]]",
];

#[test]
fn every_shape_has_the_computed_tensor_about_a_generic_point() {
    // `symbolic` compares mass, centre and tensor with those of the numeric reader.
    let rotations = [
        "",
        "rotate = { axis = [1, -2, 2], angle = \"alpha\" }",
        "rotate = { axis = [0, \"sin(beta)\", \"cos(beta)\"], angle = \"alpha - 30*pi/180\" }",
        "rotate = { euler313 = [\"alpha\", \"135 deg\", \"beta + alpha\"] }",
        "rotate = { roll_pitch_yaw = [\"-15 deg\", \"beta\", \"2*alpha\"] }",
        "rotate = { quaternion = [1, -2, 3, 0.5] }",
        "rotate = { matrix = [[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]] }",
    ];
    for (k, shape) in SHAPES.iter().enumerate() {
        let rotation = rotations[k % rotations.len()];
        let part = format!(
            "[[body.part]]\n{shape}\nmass = \"M\"\nposition = [\"d\", \"b/2 - a\", \"c\"]\n{rotation}"
        );
        let text = scenario(&format!("[body]\npivot = [\"c\", 0, \"d/3\"]\n{part}"));
        let symbolic = symbolic(&text).unwrap_or_else(|gap| panic!("{gap}\n{text}"));
        assert!(symbolic.tensor.is_symmetric());
    }
    for rotation in rotations {
        let part = format!("[[body.part]]\n{}\nmass = \"M\"\n{rotation}", SHAPES[0]);
        let text = scenario(&part);
        assert!(symbolic(&text).is_ok(), "{text}");
    }
}

#[test]
fn formulas_hold_for_other_values_of_the_symbols() {
    // The formulas of one file, at the values of another one, have that file's tensor.
    let part = |shape: &str| {
        let text = scenario(&format!(
            "[body]\npivot = [\"d\", 0, \"b/3\"]\n[[body.part]]\n{shape}\nmass = \"M\"\nposition = [\"c\", \"-a\", \"d\"]\n\
             rotate = {{ axis = [2, -1, 2], angle = \"alpha\" }}"
        ));
        if shape.contains("inner") { text.replace("0.17 m", "0.11 m") } else { text }
    };
    for shape in SHAPES {
        let text = part(shape);
        let exact = symbolic(&text).unwrap_or_else(|gap| panic!("{gap}\n{text}"));
        for (k, scale) in [1.37, 0.71, 1.93].into_iter().enumerate() {
            // Every quantity changes by a factor of its own.
            let changed: Vec<String> = text
                .lines()
                .enumerate()
                .map(|(n, line)| {
                    match line
                        .split_once(" = \"")
                        .and_then(|(name, rest)| Some((name, rest.split_once(' ')?)))
                    {
                        Some((name, (number, unit))) if SYMBOLS.iter().any(|(symbol, _)| *symbol == name) => {
                            let factor = scale + 0.01 * (n * (k + 1)) as f64;
                            format!("{name} = \"{} {unit}", number.parse::<f64>().unwrap() * factor)
                        }
                        _ => line.to_owned(),
                    }
                })
                .collect();
            let other = file(&changed.join("\n"));
            let values = found(&other).unwrap().known;
            let value = |symbol| values.iter().find(|known| known.symbol == symbol).map(|known| known.value);
            let computed = other.scenario.rotor().inertia().matrix();
            for (row, numbers) in exact.tensor.0.iter().zip(computed) {
                for (formula, number) in row.iter().zip(numbers) {
                    let found = formula.evaluate(&value).unwrap();
                    let size = computed[0][0] + computed[1][1] + computed[2][2];
                    assert!((found - number).abs() < 1e-12 * size, "{shape}: {found} {number}");
                }
            }
        }
    }
}

#[test]
fn masses_follow_from_densities() {
    let solids = SHAPES.iter().filter(|shape| {
        !["box_shell", "plate", "shell", "rod", "disk", "triang", "tetra"]
            .iter()
            .any(|kind| shape.contains(kind))
    });
    let mut count = 0;
    for shape in solids {
        let text = scenario(&format!("[[body.part]]\n{shape}\ndensity = \"rho/3\""));
        symbolic(&text).unwrap_or_else(|gap| panic!("{gap}\n{text}"));
        count += 1;
    }
    assert_eq!(count, 11);
    let disk =
        scenario("[[body.part]]\nshape = 'disk'\nradius = \"a\"\nthickness = \"b\"\ndensity = \"rho\"");
    let mass = symbolic(&disk).unwrap();
    let (mass, symbols) = (mass.mass, mass.symbols);
    assert_eq!(mass.to_formula(&symbols).to_text(), "π a² b ρ");
}

#[test]
fn a_formula_with_another_value_is_refused() {
    let mut file = file(&scenario(CUBE));
    file.text = file.text.replacen("b/2", "b/3", 1);
    let gap = found(&file).unwrap_err();
    assert_eq!(gap, Gap::Differs { what: "the centre of mass".to_owned() });
    assert!(gap.to_string().contains("please report this"));
}

const CUBE: &str = r#"
[body]
pivot = [0, 0, 0]
[[body.part]]
name = "cube"
shape = "box"
size = ["b", "b", "b"]
mass = "M"
position = ["b/2", "b/2", "b/2"]
[start]
spin = { body = ["omega", "omega", "omega"] }
"#;

#[test]
fn the_cube_of_the_notes() {
    // Thornton & Marion, examples 11.3 and 11.5
    assert_lines(
        &scenario(CUBE),
        &[
            "M = 2.3 kg,  b = 0.17 m,  ω = 3.2 rad/s",
            "c = (b/2, b/2, b/2)",
            "⎧  2/3  −1/4  −1/4 ⎫",
            "{I} = M b² ⎨ −1/4   2/3  −1/4 ⎬",
            "I_xx = I_yy = I_zz = 2/3 M b²",
            "I_xy = I_xz = I_yz = −1/4 M b²",
            "λ ≡ I/(M b²)",
            "λ³ − 2 λ² + 55/48 λ − 121/864 = 0",
            "I₁ = 1/6 M b²",
            "ω → x̂ + ŷ + ẑ",
            "I₂ = I₃ = 11/12 M b²",
            "x̂ − ŷ, x̂ + ŷ − 2 ẑ",
            "T_rot = 1/4 M b² ω²",
            "In numbers:",
        ],
    );
}

#[test]
fn the_pendulum_of_the_notes() {
    let text = r#"
[[body.part]]
shape = "particles"
particles = [{ mass = "M", position = ["b", 0, 0] }, { mass = "m2", position = ["b/2", 0, 0] }]
[start]
attitude = { axis = [0, 0, 1], angle = "30 deg" }
[[torque]]
model = "gravity"
pivot = [0, 0, 0]
acceleration = ["g", 0, 0]
[pendulum]
axis = [0, 0, 1]
"#;
    assert_lines(
        &scenario(text),
        &[
            "I_yy = I_zz = M b² + 1/4 m₂ b² = (M + m₂/4) b²",
            "I = (M + m₂/4) b²",
            "ω₀ = √(M g d/I) = √((M + m₂/2)/(M + m₂/4) · g/b)",
        ],
    );
    let turned = scenario(text).replace("attitude = { axis = [0, 0, 1]", "attitude = { axis = [1, 0, 0]");
    let lines = explained(&turned);
    let said =
        "Not in symbols: the axis of the pendulum is not along the same axes in the body and in space.";
    assert!(lines.iter().any(|line| line == said), "{}", lines.join("\n"));
}

#[test]
fn the_dumbbell_of_the_notes() {
    let text = r#"
[body]
pivot = [0, 0, 0]
[[body.part]]
shape = "particles"
particles = [{ mass = "M", position = [0, 0, "b"] }, { mass = "m2", position = [0, 0, "-b"] }]
[prescribed]
axis = [0, "sin(alpha)", "cos(alpha)"]
rate = "omega"
"#;
    assert_lines(
        &scenario(text),
        &[
            "ω = ω sin α ŷ + ω cos α ẑ",
            "L = {I} ω = (M + m₂) b² ω sin α ŷ",
            "T_rot = 1/2 (M + m₂) b² ω² sin² α",
            "N = −(M + m₂) b² ω² sin α cos α x̂",
            "F₁ = M b ω² sin α cos α ŷ − M b ω² sin² α ẑ",
        ],
    );
}

#[test]
fn the_symmetric_top_of_the_notes() {
    let text = r#"
[[body.part]]
shape = "disk"
radius = "a"
mass = "M"
[start]
spin = { body = ["w2", 0, "omega"] }
"#;
    assert_lines(
        &scenario(text),
        &[
            "N_x = 1/4 M a² ω\u{307}_x + 1/4 M a² ω_y ω_z",
            "Ω = ω",
            "A = −w₂",
            "tan (ω, e) = A/ω",
            "φ\u{307} = √(A² + (2 ω)²)",
        ],
    );
}

#[test]
fn roots_of_a_quadratic_have_radicals() {
    let plate = "[body]\npivot = [0, 0, 0]\n[[body.part]]\nshape = 'plate'\nsize = [\"a\", \"2*a\"]\n\
                 mass = \"M\"\nposition = [\"a/2\", \"a\", 0]\n";
    // I_xx, I_yy, I_xy = 4/3, 1/3, −1/2 M a², so that I = M a² (5/6 ± √(1/4 + 1/4)).
    assert_lines(
        &scenario(plate),
        &["I₁ = 1/2 (5/3 − √2) M a²", "ω → x̂ + (√2 + 1) ŷ", "I₂ = 1/2 (√2 + 5/3) M a²", "I₃ = 5/3 M a²"],
    );
}

#[test]
fn a_cubic_without_rational_roots_is_left_to_numbers() {
    let text = "[body]\npivot = [0, 0, 0]\n[[body.part]]\nshape = 'box'\nsize = [\"a\", \"2*a\", \"3*a\"]\n\
                mass = \"M\"\nposition = [\"a/2\", \"a\", \"3/2*a\"]\n";
    assert_lines(&scenario(text), &["The cubic has no rational root, so its roots follow in numbers."]);
}

#[test]
fn what_is_not_a_formula_is_named() {
    let part = |lines: &str| scenario(&format!("[[body.part]]\nshape = 'sphere'\n{lines}\n"));
    let position = part("radius = \"a\"\nmass = \"M\"\nposition = [\"0.5 m\", 0, 0]");
    assert_eq!(
        gap(&position),
        "the position of part \"sphere 1\" is the number 0.5 m; give it a name under [symbols]"
    );
    let material = part("radius = \"a\"\nmaterial = \"steel\"");
    assert_eq!(
        gap(&material),
        "the mass of part \"sphere 1\" is that of a material; give mass or density a name"
    );
    let transcendental = part("radius = \"a*exp(b/c)\"\nmass = \"M\"");
    assert_eq!(gap(&transcendental), "the radius of part \"sphere 1\", a*exp(b/c), has no exact form here");
    // A formula with units would have numbers without units.
    let mixed = part("radius = \"a + 2[cm]\"\nmass = \"M\"");
    assert_eq!(gap(&mixed), "the radius of part \"sphere 1\", a + 2[cm], has no exact form here");
    let angle = part("radius = \"a\"\nmass = \"M\"\nrotate = { axis = [0, 0, 1], angle = \"20 deg\" }");
    assert!(gap(&angle).contains("use a symbol, or a multiple of 15 deg"), "{}", gap(&angle));
    let axis = part("radius = \"a\"\nmass = \"M\"\nrotate = { axis = [0, 1, 1], angle = \"beta\" }");
    assert!(symbolic(&axis).is_ok(), "√2 is exact");
    let lines = explained(&position);
    let said = "Not in symbols: the position of part \"sphere 1\" is the number 0.5 m; give it a name under [symbols].";
    assert!(lines.iter().any(|line| line == said), "{}", lines.join("\n"));
}
