//! `polhode explain`: its output formats, and the derivation of every result.

use crate::common::{Scratch, example, json, refused, stdout};

#[test]
fn it_speaks_text_markdown_html_latex_and_json() {
    let scratch = Scratch::new("explain");
    let dumbbell = example("notes/11-10-dumbbell.toml");
    let text = stdout(&scratch.run(&["explain", &dumbbell]));
    assert!(text.contains("Euler"), "{text}");
    let markdown = stdout(&scratch.run(&["explain", &dumbbell, "--markdown"]));
    assert!(markdown.starts_with("# ") && markdown.contains("$$"), "{markdown}");
    let page = stdout(&scratch.run(&["explain", &dumbbell, "--html"]));
    assert!(
        page.starts_with("<!doctype html>") && page.contains("<math") && page.ends_with("</html>\n"),
        "{page}"
    );
    let article = stdout(&scratch.run(&["explain", &dumbbell, "--latex"]));
    assert!(article.starts_with("\\documentclass") && article.ends_with("\\end{document}\n"), "{article}");
    let document = json(&scratch.run(&["explain", &dumbbell, "--json"]));
    assert!(document["sections"].as_array().unwrap().len() >= 6);
    let forms = ["--json", "--markdown", "--html", "--latex"];
    for (k, one) in forms.iter().enumerate() {
        for other in &forms[k + 1..] {
            refused(&scratch.run(&["explain", &dumbbell, one, other]), 2);
        }
    }
}

/// Keys of each shape, with generic sizes.
const SHAPES: [(&str, &str); 20] = [
    ("box", "size = ['0.31 m', '0.47 m', '0.83 m']"),
    ("box_shell", "size = ['0.31 m', '0.47 m', '0.83 m']"),
    ("sphere", "radius = '0.37 m'"),
    ("sphere_shell", "radius = '0.37 m'"),
    ("ellipsoid", "semi_axes = ['0.31 m', '0.47 m', '0.83 m']"),
    ("cylinder", "radius = '0.37 m'\nlength = '0.91 m'"),
    ("cylinder_shell", "radius = '0.37 m'\nlength = '0.91 m'"),
    ("cylinder_shell", "radius = '0.37 m'\nlength = '0.91 m'\nends = true"),
    ("cone", "radius = '0.37 m'\ntop_radius = '0.12 m'\nheight = '0.91 m'"),
    ("cone", "radius = '0.37 m'\ntop_radius = '0.37 m'\nheight = '0.91 m'"),
    ("cone", "radius = '0.37 m'\nheight = '0.91 m'"),
    ("cylinder", "radius = '0.37 m'\ninner_radius = '0.29 m'\nlength = '0.91 m'"),
    ("sphere", "radius = '0.37 m'\ninner_radius = '0.29 m'"),
    ("cone_shell", "radius = '0.37 m'\ntop_radius = '0.12 m'\nheight = '0.91 m'"),
    ("cone_shell", "radius = '0.37 m'\nheight = '0.91 m'\nends = true"),
    ("cone_shell", "radius = '0.12 m'\ntop_radius = '0.37 m'\nheight = '0.91 m'\nends = true"),
    ("capsule", "radius = '0.37 m'\nlength = '0.91 m'"),
    ("torus", "ring_radius = '0.91 m'\ntube_radius = '0.37 m'"),
    ("rod", "length = '0.91 m'"),
    ("plate", "size = ['0.31 m', '0.47 m']"),
];

/// The explanation of each shape contains the integral of its tensor with the correct numbers.
#[test]
fn the_tensor_of_every_shape_is_derived() {
    let scratch = Scratch::new("derived");
    for (shape, keys) in SHAPES.into_iter().chain([("disk", "radius = '0.37 m'")]) {
        let body = format!(
            "[[body.part]]\nname = 'it'\nshape = '{shape}'\n{keys}\nmass = '1.7 kg'\n\
             position = ['0.2 m', '-0.1 m', '0.4 m']\n"
        );
        scratch.write("it.toml", &body);
        let text = stdout(&scratch.run(&["explain", "it.toml", "--width", "400"]));
        assert!(
            text.contains("is an integral over it") && text.contains("it: m = 1.7 kg,"),
            "{shape}:\n{text}"
        );
        let tensor = json(&scratch.run(&["inertia", "it.toml", "--json"]))["inertia"]["tensor"].clone();
        for (k, name) in ["Ixx", "Iyy", "Izz"].into_iter().enumerate() {
            let line = text
                .lines()
                .find(|line| line.starts_with("      ") && line.contains(&format!("{name} = ")))
                .unwrap();
            let number = line.rsplit(" = ").next().unwrap().replace(" kg·m²", "");
            let (got, want): (f64, f64) = (number.parse().unwrap(), tensor[k][k].as_f64().unwrap());
            assert!((got - want).abs() <= 6e-6 * want, "{shape}: {line}, not {want}");
        }
    }
}

/// A triangle has products of inertia: their formula, and the numbers along the axes of the part.
#[test]
fn the_tensor_of_a_triangle_is_derived_with_its_product() {
    let scratch = Scratch::new("triangle");
    for (shape, length) in [("triangular_plate", ""), ("triangular_prism", "length = '0.83 m'\n")] {
        let body = format!(
            "[[body.part]]\nname = 'it'\nshape = '{shape}'\nmass = '1.7 kg'\n{length}\
             vertices = [['0.2 m', '-0.3 m'], ['1.1 m', '0.1 m'], ['0.4 m', '0.9 m']]\n"
        );
        scratch.write("it.toml", &body);
        let text = stdout(&scratch.run(&["explain", "it.toml", "--width", "400"]));
        let tensor = json(&scratch.run(&["inertia", "it.toml", "--json"]))["inertia"]["tensor"].clone();
        let line = text
            .lines()
            .find(|line| line.contains("Ixx, Iyy, Izz, Ixy = "))
            .unwrap_or_else(|| panic!("{text}"));
        let numbers = line.rsplit(" = ").next().unwrap().replace(" kg·m²", "");
        let numbers: Vec<f64> = numbers.split(", ").map(|x| x.parse().unwrap()).collect();
        for (got, (i, j)) in numbers.into_iter().zip([(0, 0), (1, 1), (2, 2), (0, 1)]) {
            let want = tensor[i][j].as_f64().unwrap();
            assert!((got - want).abs() <= 6e-6 * want.abs() && want != 0.0, "{shape}: {line}, not {want}");
        }
    }
}

#[test]
fn parts_without_a_formula_say_where_their_tensor_is_from() {
    let scratch = Scratch::new("others");
    let bracket = example("bracket.stl");
    scratch.write(
        "it.toml",
        &format!(
            "[[body.part]]\nname = 'bracket'\nshape = 'mesh'\nfile = '{bracket}'\nunit = 'mm'\nmass = '0.3 kg'\n\
             rotate = {{ axis = [1, 2, 3], angle = '40 deg' }}\n\
             [[body.part]]\nname = 'block'\nshape = 'box'\nsize = ['0.1 m', '0.2 m', '0.3 m']\ndensity = '1000 + 500*z'\n\
             [[body.part]]\nname = 'weights'\nshape = 'particles'\n\
             particles = [{{ mass = '1 kg', position = [0, 0, '0.5 m'] }}, {{ mass = '2 kg', position = [0, '0.1 m', 0] }}]\n\
             [[body.part]]\nname = 'wedge'\nshape = 'tetrahedron'\nmass = '0.4 kg'\n\
             vertices = [[0, 0, 0], ['0.3 m', 0, 0], ['0.1 m', '0.4 m', 0], [0, '0.1 m', '0.5 m']]\n\
             [[body.part]]\nname = 'given'\nshape = 'tensor'\nmass = '2 kg'\nmoments = ['1 kg m^2', '2 kg m^2', '2.5 kg m^2']\n"
        ),
    );
    let text = stdout(&scratch.run(&["explain", "it.toml", "--width", "400"]));
    for said in [
        "bracket: a mesh is the sum of tetrahedra",
        "ρ = m/V = 19357",
        "wedge: a tetrahedron",
        "block: its density varies",
        "weights: the sum over its 2 particles.",
        "given: the tensor is given.",
    ] {
        assert!(text.contains(said), "{said} is missing in\n{text}");
    }
}

/// Every derivation that worked solutions name is printed, and only those.
#[test]
fn derivations_are_listed_and_printed() {
    let scratch = Scratch::new("derivations");
    let list = json(&scratch.run(&["explain", "--derive", "--json"]));
    let rows = list["sections"][0]["blocks"][0]["rows"].as_array().unwrap();
    let names: Vec<&str> = rows.iter().map(|row| row[0].as_str().unwrap()).collect();
    assert!(names.len() >= 15, "{names:?}");
    for name in &names {
        let text = stdout(&scratch.run(&["explain", "--derive", name]));
        assert!(text.lines().count() > 20 && text.contains(" = "), "{name}: {text}");
    }
    let mut count = 0;
    for file in [
        "notes/11-04-pendulum.toml",
        "notes/11-10-dumbbell.toml",
        "notes/force-free-top.toml",
        "t-handle.toml",
    ] {
        let text = stdout(&scratch.run(&["explain", &example(file), "--width", "400"]));
        let named = text
            .lines()
            .filter_map(|line| line.strip_prefix("Derivations (polhode explain --derive NAME): "));
        for name in named.flat_map(|line| line.trim_end_matches('.').split(", ")) {
            assert!(names.contains(&name), "{file}: {name}");
            count += 1;
        }
    }
    assert!(count >= 20, "{count}");
    let error = refused(&scratch.run(&["explain", "--derive", "euler-equation"]), 2);
    assert!(error.contains("did you mean `euler-equations`?"), "{error}");
    refused(&scratch.run(&["explain"]), 2);
    refused(&scratch.run(&["explain", &example("t-handle.toml"), "--derive", "cones"]), 2);
}

/// `inertia --symbols` prints exact formulas after the numbers, or refuses.
#[test]
fn inertia_has_exact_formulas() {
    let scratch = Scratch::new("inertia-symbols");
    let text = stdout(&scratch.run(&["inertia", &example("notes/11-03-cube.toml"), "--symbols"]));
    assert!(text.contains("I_xx = I_yy = I_zz = 2/3 M b²"), "{text}");
    scratch.write("cube.toml", "[body]\npivot = [0, 0, 0]\n[[body.part]]\nshape = 'box'\nsize = [1, 1, 1]\nmass = 1\nposition = [0.5, 0.5, 0.5]\n");
    let text = stdout(&scratch.run(&["inertia", "cube.toml", "--symbols"]));
    assert!(text.contains("I₂ = I₃ = 11/12") && text.contains("Exactly, in kg·m²"), "{text}");
    scratch.write(
        "steel.toml",
        "[symbols]\nr = '2 cm'\n[[body.part]]\nshape = 'sphere'\nradius = 'r'\nmaterial = 'steel'\n",
    );
    let error = refused(&scratch.run(&["inertia", "steel.toml", "--symbols"]), 2);
    assert!(error.contains("is that of a material"), "{error}");
    let error = refused(&scratch.run(&["inertia", &example("t-handle.toml"), "--symbols"]), 2);
    assert!(error.contains("t-handle.toml has no [symbols]"), "{error}");
    refused(&scratch.run(&["inertia", "cube.toml", "--symbols", "--json"]), 2);
}

/// `exercise` lists topics, makes problems with solutions, and grades answers.
#[test]
fn exercises_are_made_and_graded() {
    let scratch = Scratch::new("exercises");
    let list = json(&scratch.run(&["exercise", "--json"]));
    assert!(list["topics"].as_array().unwrap().len() >= 20);
    let make = ["exercise", "box-about-corner", "--seed", "7"];
    let problem = stdout(&scratch.run(&make));
    assert!(problem.contains("I = [") && !problem.contains("0.114467"), "{problem}");
    let solution = stdout(&scratch.run(&[&make[..], &["--solution"]].concat()));
    assert!(solution.contains("0.114467"), "{solution}");
    let page = stdout(&scratch.run(&[&make[..], &["--html"]].concat()));
    assert!(page.starts_with("<!doctype html>"), "{page}");
    // M = 6.8 kg and the edges 37, 19, 12 cm: I_xx = M (b² + c²)/3, I_xy = −M a b/4
    let answers = |sign: &str| {
        format!(
            "topic = 'box-about-corner'\nseed = 7\n[answers]\nI = [\n['0.11447 kg m^2', '{sign}0.11951 kg m^2', '{sign}754.8 kg cm^2'],\n\
             ['{sign}0.11951 kg m^2', '0.34295 kg m^2', '{sign}0.03876 kg m^2'],\n\
             ['{sign}0.07548 kg m^2', '{sign}0.03876 kg m^2', '0.39213 kg m^2'],\n]\n"
        )
    };
    scratch.write("right.toml", &answers("-"));
    let grades = stdout(&scratch.run(&["exercise", "--answers", "right.toml"]));
    assert!(grades.contains("The answer is right"), "{grades}");
    scratch.write("wrong.toml", &answers(""));
    let output = scratch.run(&["exercise", "--answers", "wrong.toml"]);
    assert_eq!(output.status.code(), Some(1));
    let grades = String::from_utf8(output.stdout).unwrap();
    assert!(grades.contains("the sign of the products of inertia is reversed"), "{grades}");
    scratch.write("bad.toml", "topic = 'box-about-corner'\nseed = 7\n[answers]\nI = 3\n");
    let error = refused(&scratch.run(&["exercise", "--answers", "bad.toml"]), 2);
    assert!(error.contains("bad.toml:4:5"), "{error}");
    let error = refused(&scratch.run(&["exercise", "box-about-corners"]), 2);
    assert!(error.contains("did you mean box-about-corner?"), "{error}");
}
