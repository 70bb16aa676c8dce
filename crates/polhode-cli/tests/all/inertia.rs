//! `polhode inertia` for every kind of file.

use std::path::Path;

use serde_json::Value;

use crate::common::{Scratch, example, json, number, refused, stdout};
use crate::schema::require_fits;

/// A tetrahedron with legs of 2, 3 and 1 m along the axes as OBJ, and a copy 10 m further along x
/// as a second group.
pub(crate) const TWO: &str = "\
v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 1
g near\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4
v 10 0 0\nv 12 0 0\nv 10 3 0\nv 10 0 1
g far\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8
";

pub(crate) fn near(value: &Value, want: f64) {
    let got = number(value);
    assert!((got - want).abs() <= 1e-14 * want.abs(), "{got} is not {want}");
}

#[test]
fn the_parts_of_a_mesh_have_their_own_densities() {
    let scratch = Scratch::new("parts");
    scratch.write("two.obj", TWO);
    let one = json(&scratch.run(&["inertia", "two.obj", "--density", "4 kg/m^3", "--json"]));
    near(&one["mass"], 8.0); // a volume of 1 m³ each
    near(&one["center_of_mass"][0], 5.5);
    assert_eq!(one["source"]["parts"], 2);
    let flags = ["--part", "near=250 g", "--part", "far=0.5 g/cm^3"];
    let own = json(&scratch.run(&[&["inertia", "two.obj", "--json"], flags.as_slice()].concat()));
    near(&own["parts"][0]["mass"], 0.25);
    near(&own["parts"][1]["mass"], 500.0);
    near(&own["center_of_mass"][0], (0.25 * 0.5 + 500.0 * 10.5) / 500.25);
    // The remaining mass is distributed by volume.
    let rest = ["inertia", "two.obj", "--json", "--part", "far=2 kg", "--mass", "3 kg"];
    near(&json(&scratch.run(&rest))["mass"], 5.0);
    let text = refused(&scratch.run(&["inertia", "two.obj", "--part", "wheel=steel"]), 2);
    assert!(text.contains("wheel") && text.contains("\"near\", \"far\""), "{text}");
    refused(&scratch.run(&["inertia", "two.obj", "--part", "near=3"]), 2);
}

#[test]
fn an_open_mesh_has_ways_out() {
    let scratch = Scratch::new("open");
    scratch.write("open.obj", &TWO.lines().take(7).map(|line| format!("{line}\n")).collect::<String>());
    let text = refused(&scratch.run(&["inertia", "open.obj"]), 2);
    assert!(text.contains("open") && text.contains("--hull") && text.contains("--shell"), "{text}");
    let hull = json(&scratch.run(&["inertia", "open.obj", "--hull", "--density", "4 kg/m^3", "--json"]));
    near(&hull["mass"], 4.0);
    // Two triangles of 3 m² and 1 m², and one of 1.5 m², less the missing one, 1 mm thick.
    let shell = ["inertia", "open.obj", "--shell", "1 mm", "--density", "1000 kg/m^3", "--json"];
    near(&json(&scratch.run(&shell))["mass"], 3.0 + 1.0);
    refused(&scratch.run(&["inertia", "open.obj", "--hull", "--shell", "1 mm"]), 2);
}

#[test]
fn a_density_may_be_a_formula() {
    let scratch = Scratch::new("field");
    scratch.write("near.obj", &TWO.lines().take(9).map(|line| format!("{line}\n")).collect::<String>());
    // ∫ (3 + 2x + y z) over the tetrahedron (a, b, c) = abc/6 (3 + 2a/4 + bc/20).
    let body = json(&scratch.run(&["inertia", "near.obj", "--field", "3 + 2*x + y*z", "--json"]));
    near(&body["mass"], 3.0 + 1.0 + 3.0 / 20.0);
    assert!(number(&body["error_estimate"]["mass"]) < 1e-12);
    let text = refused(&scratch.run(&["inertia", "near.obj", "--field", "3 + sqr(x)"]), 2);
    assert!(text.contains("column 5") && text.contains("sqrt"), "{text}");
    let text = refused(&scratch.run(&["inertia", "near.obj", "--field", "1 - x"]), 2);
    assert!(text.contains("density at"), "{text}");
    refused(&scratch.run(&["inertia", "near.obj", "--field", "1", "--mass", "1 kg"]), 2);
}

#[test]
fn a_centre_almost_at_the_origin_has_the_unit_of_its_body() {
    let scratch = Scratch::new("drone");
    let arm = |name: &str, x: &str, z: &str| {
        format!(
            "[[body.part]]\nname = \"{name}\"\nshape = \"box\"\nsize = [\"310 mm\", \"24 mm\", \"17 mm\"]\nmass = \"0.13 kg\"\nposition = [\"{x}\", 0, \"{z}\"]\n"
        )
    };
    // Two equal arms, one of them 0.6 nm too high: the centre is 3e-10 m from the origin in one
    // direction.
    scratch.write("drone.toml", &(arm("left", "-0.21 m", "0") + &arm("right", "0.21 m", "6e-10 m")));
    let text = stdout(&scratch.run(&["inertia", "drone.toml"]));
    let center = text.lines().find(|line| line.starts_with("centre of mass")).unwrap();
    assert!(center.ends_with("0  0  3e-7  mm"), "{center}");
    // The JSON keeps all digits.
    let body = json(&scratch.run(&["inertia", "drone.toml", "--json"]));
    near(&body["center_of_mass"][2], 3e-10);
}

#[test]
fn molecules_particles_and_voxels_are_bodies() {
    let scratch = Scratch::new("kinds");
    let water = json(&scratch.run(&["inertia", &example("water.xyz"), "--json"]));
    let constants = &water["molecule"]["rotational_constants_ghz"];
    for (k, printed) in [773.58478, 432.16330, 277.26766].into_iter().enumerate() {
        assert!((number(&constants[k]) / printed - 1.0).abs() < 5e-5);
    }
    assert_eq!(water["molecule"]["top"], "asymmetric");
    let heavier = json(&scratch.run(&["inertia", &example("water.xyz"), "--isotopes", "average", "--json"]));
    assert!(number(&heavier["mass"]) > number(&water["mass"]));

    scratch.write("cloud.csv", "mass_g,x_mm,y_mm,z_mm\n1.5,1,2,3\n2.5,-4,0,2\n");
    let cloud = json(&scratch.run(&["inertia", "cloud.csv", "--json"]));
    near(&cloud["mass"], 4e-3);
    near(&cloud["center_of_mass"][0], (1.5 - 10.0) / 4.0 * 1e-3);
    scratch.write("points.csv", "x_m,y_m,z_m\n1,2,3\n-1,0,2\n");
    near(&json(&scratch.run(&["inertia", "points.csv", "--mass", "3 kg", "--json"]))["mass"], 3.0);
    refused(&scratch.run(&["inertia", "points.csv"]), 2);

    let header =
        "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 1 1\nencoding: raw\nspacings: 2 2 2\n\n\x03\x01";
    scratch.write("grid.nrrd", header);
    let grid = ["inertia", "grid.nrrd", "--unit", "cm", "--per-value", "1 g/cm^3", "--json"];
    near(&json(&scratch.run(&grid))["mass"], 32e-3);
    let text = refused(&scratch.run(&["inertia", "grid.nrrd", "--density", "1 kg/m^3"]), 2);
    assert!(text.contains("is only for a mesh") && text.contains("a voxel grid"), "{text}");
}

#[test]
fn the_sign_of_a_report_is_proved() {
    let scratch = Scratch::new("cad");
    let report = "\
Mass = 2.50 kilograms
Center of mass: ( meters )
    X = 1.00  Y = -2.00  Z = 0.50
Moments of inertia: ( kilograms * square meters )
Taken at the center of mass and aligned with the output coordinate system.
    Lxx = 10.00  Lxy = 1.00   Lxz = -0.50
    Lyx = 1.00   Lyy = 8.00   Lyz = 0.75
    Lzx = -0.50  Lzy = 0.75   Lzz = 5.00
";
    let origin = "\
Moments of inertia: ( kilograms * square meters )
Taken at the output coordinate system.
    Ixx = 20.63  Ixy = -4.00  Ixz = 0.75
    Iyx = -4.00  Iyy = 11.13  Iyz = -1.75
    Izx = 0.75   Izy = -1.75  Izz = 17.50
";
    scratch.write("whole.txt", &format!("{report}{origin}"));
    let body = json(&scratch.run(&["inertia", "whole.txt", "--json"]));
    assert_eq!(body["products_of_inertia"]["given_as"], "positive_integral");
    near(&body["inertia"]["tensor"][0][1], -1.0);
    assert!(number(&body["products_of_inertia"]["residual_positive"]) < 1.0);
    assert!(number(&body["products_of_inertia"]["residual_negative"]) > 50.0);
    scratch.write("half.txt", report);
    let text = refused(&scratch.run(&["inertia", "half.txt"]), 2);
    assert!(text.contains("--products"), "{text}");
    let told = json(&scratch.run(&["inertia", "half.txt", "--products", "negative", "--json"]));
    near(&told["inertia"]["tensor"][0][1], 1.0);
    // polhode reads its own output in the format of SolidWorks.
    let written = stdout(&scratch.run(&["inertia", "whole.txt", "--as", "solidworks"]));
    scratch.write("again.txt", &written);
    let again = json(&scratch.run(&["inertia", "again.txt", "--json"]));
    near(&again["inertia"]["tensor"][0][1], -1.0);
    near(&again["mass"], 2.5);
}

#[test]
fn other_programs_words_state_their_frame() {
    let scratch = Scratch::new("as");
    let stl = example("bracket.stl");
    let of = |format: &str| {
        stdout(&scratch.run(&["inertia", &stl, "--unit", "mm", "--material", "steel", "--as", format]))
    };
    assert!(of("urdf").contains("<inertia ixx=") && of("urdf").contains("rpy=\"0 0 0\""));
    assert!(of("mjcf").contains("fullinertia=") && of("usd").contains("physics:principalAxes"));
    assert!(of("sdf").contains("<ixx>"));
    let both = stdout(&scratch.run(&["inertia", &stl, &example("water.xyz"), "--csv"]));
    assert_eq!(both.lines().count(), 3);
    refused(&scratch.run(&["inertia", &stl, "--csv", "--json"]), 2);
    refused(&scratch.run(&["inertia", &stl, "--as", "step"]), 2);
}

#[test]
fn overlapping_parts_are_a_finding_and_overlapping_solids_of_one_part_are_refused() {
    let scratch = Scratch::new("overlap");
    let twice = TWO.replace(
        "v 10 0 0\nv 12 0 0\nv 10 3 0\nv 10 0 1",
        "v 0.5 0.1 0.1\nv 2.5 0.1 0.1\nv 0.5 3.1 0.1\nv 0.5 0.1 1.1",
    );
    scratch.write("parts.obj", &twice);
    let parts = json(&scratch.run(&["inertia", "parts.obj", "--density", "1 kg/m^3", "--json"]));
    assert_eq!(parts["findings"][0]["code"], "mesh.parts_overlap");
    scratch.write("through.obj", &twice.replace("g near\n", "").replace("g far\n", ""));
    let text = refused(&scratch.run(&["inertia", "through.obj"]), 2);
    assert!(text.contains("triangle"), "{text}");
}

#[test]
fn a_mesh_of_no_unit_is_asked_for_it_where_metres_are_absurd() {
    let scratch = Scratch::new("unit");
    let bracket = example("bracket.stl");
    let of = |more: &[&str]| scratch.run(&[&["inertia", &bracket], more].concat());
    let text = stdout(&of(&["--material", "aluminium"]));
    assert!(text.contains("in m because no unit is given") && text.contains("[mesh.unit]"), "{text}");
    let body = json(&of(&["--material", "aluminium", "--json"]));
    assert_eq!(body["source"]["unit_assumed"], true);
    assert_eq!(body["findings"][0]["code"], "mesh.unit");
    for unit in ["mm", "m", "in"] {
        let body = json(&of(&["--material", "aluminium", "--unit", unit, "--json"]));
        assert_eq!(
            (&body["source"]["unit_assumed"], body["findings"].as_array().unwrap().len()),
            (&Value::Null, 0)
        );
    }
    // Formats without findings print them to standard error.
    for form in [&["--csv"][..], &["--as", "urdf"]] {
        let output = of(&[&["--material", "aluminium"], form].concat());
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(said.contains("[mesh.unit]") && said.contains("in m because no unit is given"), "{said}");
        let lumped =
            scratch.run(&[&["inertia", &example("robots/arm.urdf"), "--lump", "all"], form].concat());
        assert!(String::from_utf8_lossy(&lumped.stderr).contains("joints at zero"), "{form:?}");
        assert!(!stdout(&output).contains("mesh.unit"));
    }
    assert_eq!(json(&of(&["--mass", "85 g", "--json"]))["findings"][0]["code"], "mesh.unit");
}

#[test]
fn every_form_of_the_answer_says_that_a_mesh_was_taken_as_its_hull_or_as_a_sheet() {
    let scratch = Scratch::new("taken-as");
    let bracket = example("bracket.stl");
    let given = ["inertia", &bracket, "--unit", "mm", "--material", "aluminium"];
    let forms = [
        "urdf",
        "sdf",
        "mjcf",
        "mjcf-principal",
        "usd",
        "jsbsim",
        "rocketpy",
        "basilisk",
        "solidworks",
        "csv",
    ]
    .map(|name| ["--as", name]);
    let forms = forms.iter().map(|form| &form[..]).chain([&[][..], &["--csv"], &["--json"]]);
    for form in forms {
        let of = |more: &[&str]| stdout(&scratch.run(&[&given[..], form, more].concat())).replace('_', " ");
        assert!(of(&["--hull"]).contains("convex hull"), "{form:?}");
        assert!(of(&["--shell", "2 mm"]).contains("sheet"), "{form:?}");
        assert!(!of(&[]).contains("hull") && !of(&[]).contains("sheet"), "{form:?}");
    }
}

/// Returns a binary STL file of boxes whose faces are divided into n × n squares; some triangles
/// are repeated.
fn boxes(lows: &[[f32; 3]], n: u16, again: usize) -> Vec<u8> {
    let mut records: Vec<u8> = Vec::new();
    for low in lows {
        for (axis, high) in (0..3).flat_map(|axis| [(axis, false), (axis, true)]) {
            let corner = |i: u16, j: u16| {
                let mut p = *low;
                p[axis] += f32::from(u8::from(high));
                p[(axis + 1) % 3] += f32::from(i) / f32::from(n);
                p[(axis + 2) % 3] += f32::from(j) / f32::from(n);
                p
            };
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let mut square = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
                if !high {
                    square.reverse();
                }
                let [a, b, c, d] = square;
                for triangle in [[a, b, c], [a, c, d]] {
                    records.extend([0; 12]);
                    records.extend(triangle.as_flattened().iter().flat_map(|c| c.to_le_bytes()));
                    records.extend([0; 2]);
                }
            }
        }
    }
    records.extend_from_within(..50 * again);
    let count = (records.len() / 50) as u32;
    [&[0; 80][..], &count.to_le_bytes(), &records].concat()
}

#[test]
fn a_verdict_is_the_same_at_every_size() {
    let scratch = Scratch::new("sizes");
    // 6,144 and 393,216 triangles, 0.3 and 19.7 MB.
    for n in [16, 128] {
        let say = |name: &str, lows: &[[f32; 3]], again: usize, form: &[&str]| {
            std::fs::write(scratch.0.join(name), boxes(lows, n, again)).unwrap();
            scratch.run(&[&["inertia", name, "--density", "1 kg/m^3"], form].concat())
        };
        let offsets = [[0.47, 0.53, 0.51], [0.5; 3], [0.25; 3], [0.0, 0.25, 0.5]];
        for offset in &offsets[..if n == 16 { 4 } else { 2 }] {
            let text = refused(&say("overlap.stl", &[[0.0; 3], *offset], 0, &[]), 2);
            assert!(text.contains("overlap"), "{n} {offset:?}: {text}");
        }
        let text = refused(&say("twice.stl", &[[0.0; 3]], 1024, &[]), 2);
        assert!(text.contains("1024 such pairs"), "{n}: {text}");
        let touching = [[1.0, 0.25, 0.5], [1.0, 1.0, 0.5], [1.0; 3]];
        for touching in &touching[..if n == 16 { 3 } else { 1 }] {
            let report = json(&say("touch.stl", &[[0.0; 3], *touching], 0, &["--json"]));
            near(&report["mass"], 2.0);
        }
    }
}

#[test]
fn reports_of_scenarios_and_robots_fit_the_schema() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut files: Vec<String> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path().to_str().unwrap().to_owned())
        .filter(|path| path.ends_with(".toml"))
        .collect();
    files.sort();
    let arguments: Vec<&str> =
        ["inertia", "--json"].into_iter().chain(files.iter().map(String::as_str)).collect();
    let scenarios = Scratch::new("schema").run(&arguments);
    assert!(files.len() > 30);
    require_fits(polhode_shape::REPORT_SCHEMA, &json(&scenarios));
    for lump in ["all", "fixed"] {
        let robot = folder.join("robots/gripper.urdf");
        let joined =
            Scratch::new("schema").run(&["inertia", "--json", "--lump", lump, robot.to_str().unwrap()]);
        require_fits(polhode_shape::REPORT_SCHEMA, &json(&joined));
    }
}

#[test]
fn a_shape_needs_no_file() {
    let scratch = Scratch::new("shape");
    let brick = ["inertia", "--box", "62 cm, 38 cm, 14 cm", "--about", "corner"];
    let of = |more: &[&str]| scratch.run(&[&brick[..], more].concat());
    let text = stdout(&of(&["--mass", "2.3 kg"]));
    for line in [
        "box   a = 0.62 m, b = 0.38 m, c = 0.14 m; edges along x, y, z; centre at the origin",
        "mass             2.3 kg   (69.7308 kg/m³ × 0.032984 m³)",
        "inertia about (-0.31, -0.19, -0.07) m, along body axes, off-diagonal = -∫xy dm, in kg·m²",
        "    -0.135470   0.309733  -0.030590",
    ] {
        assert!(text.lines().any(|printed| printed == line), "{line} in\n{text}");
    }
    let report = json(&of(&["--mass", "2.3 kg", "--json"]));
    near(&report["inertia_about"]["tensor"][0][1], -2.3 * 0.62 * 0.38 / 4.0);
    assert_eq!(report["source"]["lengths_m"]["b"], 0.38);
    let cone = ["inertia", "--cone=3 cm, 10 cm", "--material=oak"];
    let urdf = stdout(&scratch.run(&[&cone[..], &["--as", "urdf"]].concat()));
    assert!(urdf.contains("<link name=\"cone\">") && urdf.contains("xyz=\"0 0 0.025\""), "{urdf}");
    assert_eq!(stdout(&scratch.run(&[&cone[..], &["--csv"]].concat())).lines().count(), 2);

    scratch.write("two.obj", TWO);
    for (arguments, says) in [
        (&["--box", "1 m, 2 m", "--mass", "1 kg"][..], "expected 3 lengths (a, b, c)"),
        (&["--box", "-1 m, 2 m, 3 m", "--mass", "1 kg"], "the box's size = -1 must be positive"),
        (&["--sphere", "-1 m", "--mass", "1 kg"], "the sphere's radius = -1 must be positive"),
        (&["--box", "1, 2, 3", "--mass", "1 kg"], "has no unit"),
        (&["--rod", "1e-310 m", "--mass", "1 kg"], "too small for f64"),
        (&["--rod", "nan m", "--mass", "1 kg"], "is not a number"),
        (&["--prism", "1 m", "--mass", "1 kg"], "unexpected argument '--prism'"),
        (&["--sphere", "1 m"], "the mass of --sphere is missing"),
        (&["--sphere", "1 m", "--mass", "1 kg", "--density", "5"], "cannot be used with"),
        (&["--sphere", "1 m", "--rod", "1 m", "--mass", "1 kg"], "cannot be used with"),
        (&["--sphere", "1 m", "--mass", "1 kg", "--about", "corner"], "--about corner is only for --box"),
        (&["--sphere", "1 m", "--mass", "1 kg", "--about", "centre"], "is always printed"),
        (&["--sphere", "1 m", "--mass", "1 kg", "--unit", "mm"], "but --sphere is a shape"),
        (&["--sphere", "1 m", "--mass", "1 kg", "two.obj"], "--sphere and the file two.obj"),
        (&["two.obj", "--mass", "1 kg", "--about", "corner"], "--about corner is only for --box"),
        (&["--sphere", "1 m", "--mass", "1 kg", "--table"], "--table is only for a robot model"),
        (&[], "<FILE>..."),
    ] {
        let text = refused(&scratch.run(&[&["inertia"], arguments].concat()), 2);
        assert!(text.contains(says), "{arguments:?}: {text}");
    }
}
