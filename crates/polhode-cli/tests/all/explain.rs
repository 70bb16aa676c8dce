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
