//! Shapes without a file: `inertia --box` and its like.

use polhode_document::Report as _;
use polhode_shape::{Bodies, ExportFormat, Request, run};
use polhode_source::Failure;
use polhode_source::files::Memory;
use serde_json::{Value, json};

use crate::schema::require_fits;

fn answer(request: &Value) -> Result<Bodies, Failure> {
    require_fits(polhode_shape::REQUEST_SCHEMA, request);
    let request: Request = serde_json::from_value(request.clone()).unwrap();
    let bodies = run(&request, &Memory::from([("a.stl", "")]))?;
    require_fits(polhode_shape::REPORT_SCHEMA, &bodies.to_json());
    Ok(bodies)
}

fn report(request: &Value) -> Value {
    answer(request).unwrap_or_else(|failure| panic!("{request}: {failure}")).to_json()
}

fn matrix(value: &Value) -> [[f64; 3]; 3] {
    serde_json::from_value(value.clone()).unwrap()
}

/// Largest difference of elements, relative to the largest element of `want`.
fn difference(got: [[f64; 3]; 3], want: [[f64; 3]; 3]) -> f64 {
    let largest = want.as_flattened().iter().fold(0.0, |max: f64, element| max.max(element.abs()));
    let pairs = got.as_flattened().iter().zip(want.as_flattened());
    pairs.fold(0.0, |max: f64, (a, b)| max.max((a - b).abs())) / largest
}

/// Sums over `n` × `n` × `n` particles of equal mass in the cells of a box from `low` to `high`, if
/// `inside` is true there: tensor about `point`, and centre. A box without thickness has one layer.
fn particles(
    mass: f64,
    [low, high]: [[f64; 3]; 2],
    point: [f64; 3],
    inside: impl Fn([f64; 3]) -> bool,
) -> ([[f64; 3]; 3], [f64; 3]) {
    let n = [0, 1, 2].map(|k| if low[k] < high[k] { 80 } else { 1 });
    let (mut count, mut center, mut tensor) = (0.0, [0.0; 3], [[0.0; 3]; 3]);
    for cell in 0..n[0] * n[1] * n[2] {
        let cell = [cell % n[0], cell / n[0] % n[1], cell / n[0] / n[1]];
        let at =
            [0, 1, 2].map(|k| low[k] + (high[k] - low[k]) * (f64::from(cell[k]) + 0.5) / f64::from(n[k]));
        if !inside(at) {
            continue;
        }
        count += 1.0;
        let d = [0, 1, 2].map(|k| at[k] - point[k]);
        let square: f64 = d.iter().map(|x| x * x).sum();
        for i in 0..3 {
            center[i] += at[i];
            for j in 0..3 {
                tensor[i][j] += if i == j { square } else { 0.0 } - d[i] * d[j];
            }
        }
    }
    (tensor.map(|row| row.map(|element| element * mass / count)), center.map(|x| x / count))
}

#[test]
fn shapes_have_the_tensors_of_their_particles() {
    let point = [0.13, -0.21, 0.34];
    let about = |shape: &str, lengths: &str| json!({ shape: lengths, "mass": "2.3 kg", "about": "13 cm, -0.21 m, 340 mm" });
    let check = |shape: &str, lengths: &str, bounds, inside: &dyn Fn([f64; 3]) -> bool| {
        let got = report(&about(shape, lengths));
        let (tensor, center) = particles(2.3, bounds, point, inside);
        // The cells of the surface, of 80 across, limit the sum.
        let error = difference(matrix(&got["inertia_about"]["tensor"]), tensor);
        assert!(error < 2e-3, "{shape}: {error:e}");
        for (k, want) in center.into_iter().enumerate() {
            let got = got["center_of_mass"][k].as_f64().unwrap();
            assert!((got - want).abs() < 1e-3, "{shape} {k}: {got}, {want}");
        }
    };
    let around = |a: f64, b: f64, c: f64| [[-a, -b, -c], [a, b, c]];
    check("box", "62 cm, 0.38 m, 140 mm", around(0.31, 0.19, 0.07), &|_| true);
    check("sphere", "0.29 m", around(0.29, 0.29, 0.29), &|[x, y, z]| x * x + y * y + z * z < 0.29 * 0.29);
    check("ellipsoid", "(31, 19, 12) cm", around(0.31, 0.19, 0.12), &|[x, y, z]| {
        (x / 0.31).powi(2) + (y / 0.19).powi(2) + (z / 0.12).powi(2) < 1.0
    });
    check("cylinder", "0.17 m, 0.53 m", around(0.17, 0.17, 0.265), &|[x, y, _]| x.hypot(y) < 0.17);
    check("capsule", "0.17 m, 0.53 m", around(0.17, 0.17, 0.435), &|[x, y, z]| {
        x.hypot(y).hypot((z.abs() - 0.265).max(0.0)) < 0.17
    });
    check("cone", "0.23 m, 0.61 m", [[-0.23, -0.23, 0.0], [0.23, 0.23, 0.61]], &|[x, y, z]| {
        x.hypot(y) < 0.23 * (1.0 - z / 0.61)
    });
    check("torus", "0.31 m, 0.11 m", around(0.42, 0.42, 0.11), &|[x, y, z]| {
        (x.hypot(y) - 0.31).hypot(z) < 0.11
    });
    check("rod", "0.74 m", around(0.0, 0.0, 0.37), &|_| true);
    check("disk", "0.27 m", around(0.27, 0.27, 0.0), &|[x, y, _]| x.hypot(y) < 0.27);
}

#[test]
fn a_box_about_its_corner_is_that_of_the_parallel_axes() {
    // A cube: M b² (2/3, -1/4), Thornton & Marion, example 11.3.
    let cube = report(&json!({ "box": "3 m, 3 m, 3 m", "mass": "2 kg", "about": "corner" }));
    let mut want = [[-4.5; 3]; 3];
    (0..3).for_each(|k| want[k][k] = 12.0);
    assert!(difference(matrix(&cube["inertia_about"]["tensor"]), want) < 1e-15);
    assert_eq!(cube["inertia_about"]["point"], json!([-1.5, -1.5, -1.5]));

    let [a, b, c, mass] = [0.62, 0.38, 0.14, 2.3];
    let brick = report(&json!({ "box": "62 cm, 38 cm, 14 cm", "mass": "2.3 kg", "about": "corner" }));
    let want = [
        [(b * b + c * c) / 3.0, -a * b / 4.0, -a * c / 4.0],
        [-a * b / 4.0, (a * a + c * c) / 3.0, -b * c / 4.0],
        [-a * c / 4.0, -b * c / 4.0, (a * a + b * b) / 3.0],
    ];
    let want = want.map(|row| row.map(|element| mass * element));
    assert!(difference(matrix(&brick["inertia_about"]["tensor"]), want) < 1e-15);
    assert_eq!(brick["inertia_about"]["point"], json!([-0.31, -0.19, -0.07]));
    // The same point in numbers.
    let point = report(&json!({ "box": "62 cm, 38 cm, 14 cm", "mass": 2.3, "about": "-31 cm,-19 cm,-7 cm" }));
    assert_eq!(point, brick);
}

#[test]
fn a_density_gives_the_mass_of_the_volume() {
    use std::f64::consts::PI;
    for (shape, lengths, volume) in [
        ("box", "62 cm, 38 cm, 14 cm", 0.62 * 0.38 * 0.14),
        ("sphere", "29 cm", 4.0 / 3.0 * PI * 0.29 * 0.29 * 0.29),
        ("ellipsoid", "31 cm, 19 cm, 12 cm", 4.0 / 3.0 * PI * 0.31 * 0.19 * 0.12),
        ("cylinder", "17 cm, 53 cm", PI * 0.17 * 0.17 * 0.53),
        ("capsule", "17 cm, 53 cm", PI * 0.17 * 0.17 * (0.53 + 4.0 / 3.0 * 0.17)),
        ("cone", "23 cm, 61 cm", PI / 3.0 * 0.23 * 0.23 * 0.61),
        ("torus", "31 cm, 11 cm", 2.0 * PI * PI * 0.31 * 0.11 * 0.11),
    ] {
        let near = |value: &Value, want: f64| (value.as_f64().unwrap() / want - 1.0).abs() < 1e-14;
        let dense = report(&json!({ shape: lengths, "density": "1.7 g/cm^3" }));
        assert!(near(&dense["volume"], volume) && near(&dense["mass"], 1700.0 * volume), "{shape}");
        let steel = report(&json!({ shape: lengths, "material": "steel" }));
        assert!(near(&steel["mass"], 7850.0 * volume), "{shape}");
    }
}

#[test]
fn the_text_and_the_formats_name_the_shape() {
    let brick = json!({ "box": "62 cm, 38 cm, 14 cm", "mass": "2.3 kg", "about": "corner" });
    assert_eq!(
        answer(&brick).unwrap().to_text(None),
        "\
box   a = 0.62 m, b = 0.38 m, c = 0.14 m; edges along x, y, z; centre at the origin
mass             2.3 kg   (69.7308 kg/m³ × 0.032984 m³)
surface area     0.7512 m²
centre of mass   0  0  0  m

inertia about the centre of mass, along body axes, off-diagonal = -∫xy dm, in kg·m²
    0.031433  0         0
    0         0.077433  0
    0         0         0.101353
principal        0.031433  0.077433  0.101353  kg·m²   asymmetric
                 three different moments: the principal axes are unique
gyration radii   0.116905  0.183485  0.209921  m
principal axes   right-handed, unit vectors in body axes
    axis 1   1  0  0
    axis 2   0  1  0
    axis 3   0  0  1

inertia about (-0.31, -0.19, -0.07) m, along body axes, off-diagonal = -∫xy dm, in kg·m²
     0.125733  -0.135470  -0.049910
    -0.135470   0.309733  -0.030590
    -0.049910  -0.030590   0.405413
principal        0.044518  0.381102  0.415260  kg·m²   asymmetric
                 three different moments: the principal axes are unique
principal axes   right-handed, unit vectors in body axes
    axis 1    0.871513   0.463597  0.159821
    axis 2   -0.481980   0.869864  0.105033
    axis 3   -0.090330  -0.168568  0.981542
"
    );
    let torus = answer(&json!({ "torus": "31 cm, 11 cm", "material": "oak" })).unwrap();
    let source = json!({
        "path": "torus", "format": "shape", "lengths_m": { "ring_radius": 0.31, "tube_radius": 0.11 }
    });
    assert_eq!(torus.to_json()["source"], source);
    assert!(torus.to_text(None).starts_with("torus   ring radius = 0.31 m, tube radius = 0.11 m; "));
    for format in ExportFormat::ALL {
        let text = torus.to_format(*format).unwrap();
        assert!(text.contains("torus"), "{}: {text}", format.name());
    }
    // A thin shape has no volume, and a rod no area.
    let rod = report(&json!({ "rod": "74 cm", "mass": "2.3 kg" }));
    assert_eq!((&rod["volume"], &rod["surface_area"]), (&Value::Null, &Value::Null));
    let disk = report(&json!({ "disk": "20 cm", "mass": "2.3 kg" }));
    assert!((disk["surface_area"].as_f64().unwrap() - std::f64::consts::PI * 0.04).abs() < 1e-15);
}

#[test]
fn lengths_that_form_no_shape_are_refused() {
    let number = "is not a number";
    for (shape, lengths, says) in [
        ("box", "1 m, 2 m", "expected 3 lengths (a, b, c), such as \"20 cm, 10 cm, 6 cm\", but found 2"),
        ("sphere", "1 m, 2 m", "expected 1 length (radius), such as \"20 cm\", but found 2"),
        ("torus", "1 m", "expected 2 lengths (ring radius, tube radius), such as"),
        ("box", "1 m, 2 m, -3 m", "the box's size = -3 must be positive"),
        ("box", "1 m, 0 m, 3 m", "the box's size = 0 must be positive"),
        ("sphere", "-5 cm", "the sphere's radius = -0.05 must be positive"),
        ("cone", "0 m, 1 m", "must be positive"),
        ("capsule", "1 m, 0 m", "the capsule's length = 0 must be positive"),
        ("torus", "1 m, 2 m", "the torus's tube radius = 2 must be at most its ring radius"),
        ("box", "3, 2, 1", "\"3, 2, 1\" has no unit: expected 3 lengths"),
        ("box", "(3, 2, 1)", "has no unit"),
        ("sphere", "0.5", "\"0.5\" has no unit: expected 1 length (radius), such as \"20 cm\""),
        ("box", "3 m, 2, 1 m", "\"2\" has none"),
        ("sphere", "1,5 m", "\"1\" has none"),
        ("sphere", "2 kg", "\"kg\" is a mass where a length belongs"),
        ("box", "1 2 3 m", number),
        ("rod", "NaN", number),
        ("rod", "nan m", number),
        ("rod", "inf m", number),
        ("rod", "", number),
        (
            "box",
            "1e-310 m, 1 m, 1 m",
            "the volume = 1e-310 must be positive and finite: too large or too small",
        ),
        ("disk", "1e-310 m", "the area = 0 must be positive and finite: too large or too small"),
        ("rod", "1e-310 m", "must be positive and finite: too large or too small"),
        ("cylinder", "1e200 m, 1 m", "too large or too small"),
        ("ellipsoid", "1e150 m, 1e150 m, 1e150 m", "the volume = inf must be"),
    ] {
        let error = serde_json::from_value::<Request>(json!({ shape: lengths, "mass": "1 kg" })).unwrap_err();
        assert!(error.to_string().contains(says), "{shape} {lengths}: {error}");
    }
    // A number in JSON has no unit either.
    let error = serde_json::from_value::<Request>(json!({ "sphere": 0.5, "mass": 1 })).unwrap_err();
    assert!(error.to_string().contains("no unit"), "{error}");
}

#[test]
fn contradictions_and_missing_masses_are_refused() {
    let cube = "1 m, 1 m, 1 m";
    for (request, says) in [
        (json!({ "box": cube }), "the mass of --box is missing\nhint: give --mass, --density or --material"),
        (json!({ "disk": "1 m" }), "the mass of --disk is missing\nhint: give --mass\n"),
        (json!({ "box": cube, "mass": "1 kg", "density": 5 }), "--density and --mass contradict each other"),
        (
            json!({ "box": cube, "mass": "1 kg", "material": "oak" }),
            "--mass and --material contradict each other",
        ),
        (
            json!({ "rod": "1 m", "density": "1 kg/m^3" }),
            "--density and --material are only for solids, but --rod is thin\nhint: give --mass",
        ),
        (
            json!({ "box": cube, "disk": "1 m", "mass": 1 }),
            "--box and --disk contradict each other\nhint: give one shape",
        ),
        (
            json!({ "files": ["a.stl"], "box": cube, "mass": 1 }),
            "--box and the file a.stl contradict each other\nhint: give a shape or files, not both",
        ),
        (
            json!({ "sphere": "1 m", "mass": 1, "about": "corner" }),
            "--about corner is only for --box\nhint: write the point as x,y,z",
        ),
        (json!({ "sphere": "1 m", "mass": 1, "about": "1e200,0,0" }), "too large for a double"),
        (json!({ "sphere": "1 m", "mass": 1, "unit": "mm" }), "but --sphere is a shape\nhint: delete it"),
        (json!({ "sphere": "1 m", "mass": 1, "format": "stl" }), "--format is only for a file, but"),
        (json!({ "sphere": "1 m", "mass": 1, "hull": true }), "--hull is only for a mesh, but"),
        (json!({ "sphere": "1 m", "mass": 1, "tolerance": 1e-3 }), "--tolerance is only for a mesh, but"),
        (json!({ "sphere": "1 m", "mass": 1, "isotopes": "average" }), "--isotopes is only for a molecule"),
        (json!({ "box": "1e100 m, 1e100 m, 1e-100 m", "density": 1e300 }), "the mass = inf must be"),
        (json!({ "box": "1e-100 m, 1e-100 m, 1e-100 m", "mass": 1e-200 }), "the moment of inertia = "),
    ] {
        let failure = answer(&request).unwrap_err().to_string();
        assert!(failure.contains(says), "{request}: {failure}");
    }
    let center = serde_json::from_value::<Request>(json!({ "about": "centre" })).unwrap_err();
    assert!(center.to_string().contains("about the centre of mass is always printed"), "{center}");
    // A mesh has no corner, and only one substance.
    let mesh = json!({ "files": ["a.stl"], "density": 5, "mass": "1 kg" });
    assert!(answer(&mesh).unwrap_err().message().starts_with("--density and --mass contradict"));
}

#[test]
fn extreme_shapes_have_no_false_numbers() {
    // The surface overflows, the density underflows.
    let plate = report(&json!({ "box": "1e154 m, 1e154 m, 1e-100 m", "mass": "1 kg" }));
    assert_eq!(plate["surface_area"], Value::Null);
    assert!(plate["density"].as_f64().unwrap() > 0.0);
    let light = report(&json!({ "box": "1e100 m, 1e100 m, 1e-100 m", "mass": 1e-300 }));
    assert_eq!(light["density"], Value::Null);
}
