//! Meshes that are printed with walls, solid layers and infill.

use crate::common::{Scratch, json, number, refused, stdout};

/// A box with sides of 40, 30 and 20 mm and a corner at x, OBJ in mm; vertex numbers start after
/// `after` others.
fn brick(name: &str, x: f64, after: usize) -> String {
    let mut text = String::new();
    for k in 0..8_u8 {
        let [a, b, c] = [k & 1, k >> 1 & 1, k >> 2].map(f64::from);
        text += &format!("v {} {} {}\n", x + 40.0 * a, 30.0 * b - 7.0, 20.0 * c + 3.0);
    }
    text += &format!("g {name}\n");
    for corners in [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]] {
        let [a, b, c, d] = corners.map(|v| v + after);
        text += &format!("f {a} {b} {c}\nf {a} {c} {d}\n");
    }
    text
}

const PRINT: [&str; 4] = ["--walls", "1.5 mm", "--infill", "15%"];

#[test]
fn a_printed_box_is_the_sum_of_two_boxes() {
    let scratch = Scratch::new("print");
    scratch.write("brick.obj", &brick("only", 5.0, 0));
    let flags = ["inertia", "brick.obj", "--unit", "mm", "--json", "--density", "1.24 g/cm^3"];
    let found = json(&scratch.run(&[flags.as_slice(), &PRINT].concat()));
    let [outer, inner] = [[0.040, 0.030, 0.020], [0.037, 0.027, 0.017]];
    let volume = |sides: [f64; 3]| sides.iter().product::<f64>();
    let mass = 1240.0 * (volume(outer) - 0.85 * volume(inner));
    let bounds = &found["bounds"];
    let off = (number(&found["mass"]) - mass).abs();
    assert!(off <= number(&bounds["mass"]) && number(&bounds["mass"]) < 2e-3 * mass, "{off} {bounds}");
    assert!((number(&found["source"]["print"]["infill_volume_m3"]) / volume(inner) - 1.0).abs() < 1e-3);
    assert!((number(&found["volume"]) / volume(outer) - 1.0).abs() < 1e-12);
    for k in 0..3 {
        let moment = |sides: [f64; 3]| {
            let others = (0..3).filter(|i| *i != k).map(|i| sides[i] * sides[i]).sum::<f64>();
            1240.0 * volume(sides) * others / 12.0
        };
        let exact = moment(outer) - 0.85 * moment(inner);
        let off = (number(&found["inertia"]["tensor"][k][k]) - exact).abs();
        assert!(off <= number(&bounds["inertia"][k][k]) && off < 2e-3 * exact, "{k}: {off} {exact}");
    }
    // A mass is that of the print.
    let flags = ["inertia", "brick.obj", "--unit", "mm", "--json", "--mass", "12 g"];
    let found = json(&scratch.run(&[flags.as_slice(), &PRINT].concat()));
    assert!((number(&found["mass"]) - 0.012).abs() < 1e-16 && number(&found["bounds"]["mass"]) == 0.0);
    let text = stdout(
        &scratch.run(&[&["inertia", "brick.obj", "--unit", "mm", "--mass", "12 g"], &PRINT[..]].concat()),
    );
    assert!(text.contains("printed with walls of 1.5 mm and an") && text.contains("error bounds"), "{text}");
}

#[test]
fn solid_layers_raise_the_center_of_a_printed_box() {
    let scratch = Scratch::new("print-layers");
    scratch.write("brick.obj", &brick("only", 5.0, 0));
    let flags = ["inertia", "brick.obj", "--unit", "mm", "--density", "1.24 g/cm^3", "--top-layers", "3 mm"];
    let found = json(&scratch.run(&[flags.as_slice(), &PRINT, &["--json"]].concat()));
    let [outer, inner] = [0.040 * 0.030 * 0.020, 0.037 * 0.027 * (0.020 - 0.003 - 0.0015)];
    let mass = 1240.0 * (outer - 0.85 * inner);
    let bounds = &found["bounds"];
    assert!((number(&found["mass"]) - mass).abs() <= number(&bounds["mass"]), "{found}");
    // The middle of the infill is at 3 + (1.5 + 17)/2 mm, and that of the box at 13 mm.
    let center = 1240.0 * (outer * 0.013 - 0.85 * inner * 0.01225) / mass;
    let off = (number(&found["center_of_mass"][2]) - center).abs();
    assert!(off <= number(&bounds["center_of_mass"][2]) && center > 0.0131, "{off:e} {center}");
    let print = &found["source"]["print"];
    assert_eq!([&print["top_layers_m"], &print["bottom_layers_m"]].map(number), [0.003, 0.0]);
    let text = stdout(&scratch.run(&[flags.as_slice(), &PRINT].concat()));
    assert!(text.contains("walls of 1.5 mm, layers of 3 mm at the top and an"), "{text}");
    let both = [flags.as_slice(), &PRINT, &["--bottom-layers", "3 mm"]].concat();
    let text = stdout(&scratch.run(&both));
    assert!(text.contains("layers of 3 mm at top and bottom"), "{text}");
    refused(&scratch.run(&flags), 2);
}

#[test]
fn parts_of_a_print_have_their_own_substances() {
    let scratch = Scratch::new("print-parts");
    scratch.write("two.obj", &format!("{}{}", brick("left", 5.0, 0), brick("right", 60.0, 8)));
    let run = |substance: &[&str]| {
        let flags = ["inertia", "two.obj", "--unit", "mm", "--json"];
        json(&scratch.run(&[flags.as_slice(), &PRINT, substance].concat()))
    };
    // Two equal parts share a mass.
    let shared = run(&["--mass", "24 g"]);
    assert!((number(&shared["parts"][1]["mass"]) - 0.012).abs() < 1e-15);
    assert!((number(&shared["mass"]) - 0.024).abs() < 1e-15 && number(&shared["bounds"]["mass"]) == 0.0);
    let each = run(&["--part", "left=12 g", "--part", "right=1.24 g/cm^3"]);
    assert!((number(&each["parts"][0]["mass"]) - 0.012).abs() < 1e-15);
    assert!(number(&each["bounds"]["mass"]) > 0.0);
}

#[test]
fn full_infills_and_thick_walls_are_the_solid_and_open_meshes_are_refused() {
    let scratch = Scratch::new("print-solid");
    scratch.write("brick.obj", &brick("only", 5.0, 0));
    let flags = ["inertia", "brick.obj", "--unit", "mm", "--json", "--mass", "12 g"];
    let solid = json(&scratch.run(&flags));
    for [walls, infill] in [["1.5 mm", "100%"], ["10.1 mm", "0"]] {
        let found = json(&scratch.run(&[flags.as_slice(), &["--walls", walls, "--infill", infill]].concat()));
        assert_eq!(
            (&found["inertia"], &found["center_of_mass"]),
            (&solid["inertia"], &solid["center_of_mass"])
        );
        assert_eq!(number(&found["bounds"]["principal_moments"]), 0.0);
    }
    let wrong: [&[&str]; 5] = [
        &["--walls", "1 mm"],
        &["--infill", "15%"],
        &["--walls", "0 mm", "--infill", "15%"],
        &["--walls", "1 mm", "--infill", "15"],
        &["--walls", "1 um", "--infill", "15%"],
    ];
    for options in wrong {
        refused(
            &scratch.run(&[&["inertia", "brick.obj", "--unit", "mm", "--mass", "12 g"], options].concat()),
            2,
        );
    }
    let open = brick("only", 5.0, 0).replacen("f 1 3 4\n", "", 1);
    scratch.write("open.obj", &open);
    let text = refused(
        &scratch.run(&[&["inertia", "open.obj", "--unit", "mm", "--mass", "12 g"], &PRINT[..]].concat()),
        2,
    );
    assert!(text.contains("the mesh is open"), "{text}");
}
