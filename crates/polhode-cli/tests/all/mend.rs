//! Repaired meshes that are written: refused cases and reports.

use crate::common::{Scratch, json, number, refused};

/// A tetrahedron with legs of 2, 3 and 1 m along the axes at x. Its vertex numbers start after
/// `after` others; its first `less` faces are omitted.
fn tetrahedron(name: &str, x: f64, after: usize, less: usize) -> String {
    let mut text = String::new();
    for [a, b, c] in [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]] {
        text += &format!("v {} {b} {c}\n", x + a);
    }
    text += &format!("g {name}\n");
    for corners in &[[1, 3, 2], [1, 2, 4], [1, 4, 3], [2, 3, 4]][less..] {
        let [a, b, c] = corners.map(|v| v + after);
        text += &format!("f {a} {b} {c}\n");
    }
    text
}

#[test]
fn sheets_that_a_weld_presses_onto_each_other_are_no_body() {
    let scratch = Scratch::new("sheets");
    // Two triangulated squares 0.5 mm apart, with different inner vertices, so that their faces do
    // not coincide after welding.
    let square = |z: f64| format!("v 0 0 {z}\nv 1 0 {z}\nv 1 1 {z}\nv 0 1 {z}\n");
    let faces = "f 5 6 9\nf 6 7 9\nf 7 8 9\nf 8 5 9\nf 1 10 2\nf 2 10 3\nf 3 10 4\nf 4 10 1\n";
    let text = format!("{}{}v 0.4 0.5 0.0005\nv 0.7 0.6 0\n{faces}", square(0.0), square(0.0005));
    scratch.write("sheets.obj", &text);
    let flags = ["inertia", "sheets.obj", "--unit", "m", "--density", "1 kg/m^3"];
    let refusal = refused(&scratch.run(&flags), 2);
    assert!(!refusal.contains("--weld"), "{refusal}");
    let welded = json(&scratch.run(&[flags.as_slice(), &["--json", "--weld", "4e-4"]].concat()));
    let said = welded["findings"][0]["message"].as_str().unwrap();
    assert!(said.contains("at most: the centre of mass"), "{said}");
    assert!(!said.contains("inf"), "{said}");
}

#[test]
fn a_fill_says_what_it_left_open() {
    let scratch = Scratch::new("left-open");
    let stray = "v 5 0 0\nv 5.1 0 0\nv 5.1 0.1 0\nv 5 0.1 0.02\nf 5 6 7\nf 5 7 8\n";
    scratch.write("stray.obj", &format!("{}{stray}", tetrahedron("a", 0.0, 0, 0)));
    let refusal = refused(&scratch.run(&["inertia", "stray.obj"]), 2);
    assert!(!refusal.contains("--fill"), "{refusal}");
    let refusal = refused(&scratch.run(&["inertia", "stray.obj", "--fill", "0.1"]), 2);
    assert!(refusal.contains("1 loop is the boundary of a sheet, not of a hole"), "{refusal}");
    scratch.write("open.obj", &tetrahedron("a", 0.0, 0, 1));
    let refusal = refused(&scratch.run(&["inertia", "open.obj", "--fill", "3 m"]), 2);
    assert!(refusal.contains("not all holes were filled: 1 hole is larger"), "{refusal}");
    scratch.write("closed.obj", &tetrahedron("a", 0.0, 0, 0));
    let closed = [
        "inertia",
        "closed.obj",
        "--unit",
        "m",
        "--density",
        "1",
        "--json",
        "--fill",
        "0.1",
        "--weld",
        "1e-5",
    ];
    let closed = json(&scratch.run(&closed));
    let said = closed["findings"].to_string();
    assert!(said.contains("nothing was filled: the mesh has no open edges"), "{said}");
    assert_eq!(closed["source"]["weld"]["volume_bound_m3"].to_string(), "0.0");
}

#[test]
fn only_parts_with_open_edges_in_common_are_joined() {
    let scratch = Scratch::new("pieces");
    let pieces = "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 1\ng a1\nf 1 2 4\nf 1 4 3\ng a2\nf 2 3 4\n";
    let text = format!("{pieces}{}{}", tetrahedron("b", 10.0, 4, 0), tetrahedron("c", 20.0, 8, 1));
    scratch.write("join.obj", &text);
    let flags = ["inertia", "join.obj", "--unit", "m", "--density", "1 kg/m^3", "--fill", "4 m", "--json"];
    let filled = json(&scratch.run(&flags));
    assert!((number(&filled["mass"]) - 3.0).abs() < 1e-13, "{}", filled["mass"]);
    assert_eq!((&filled["source"]["parts"], &filled["source"]["fill"]["holes"]), (&3.into(), &2.into()));
    assert!(
        filled["findings"].to_string().contains("2 open parts of the file form one surface"),
        "{}",
        filled["findings"]
    );
}

#[test]
fn the_fill_of_a_scenario_is_that_of_the_command() {
    let scratch = Scratch::new("fill-scenario");
    scratch.write("open.obj", &tetrahedron("a", 0.3, 0, 1));
    let command = ["inertia", "open.obj", "--unit", "m", "--mass", "4 kg", "--json", "--fill", "4 m"];
    let command = json(&scratch.run(&command));
    for (fill, fits) in
        [("fill = \"4 m\"", true), ("fill = 0.99", true), ("fill = -1", false), ("fill = \"3 m\"", false)]
    {
        let part = format!("shape = \"mesh\"\nfile = \"open.obj\"\nunit = \"m\"\n{fill}\nmass = \"4 kg\"");
        let run = "[start]\nspin = { body = [0, 0, \"1 rad/s\"] }\n[run]\nduration = \"1 s\"\n";
        scratch.write("open.toml", &format!("[[body.part]]\n{part}\n{run}"));
        if fits {
            let scenario = json(&scratch.run(&["inertia", "open.toml", "--json"]));
            assert_eq!(scenario["inertia"], command["inertia"], "{fill}");
            assert_eq!(scenario["findings"][0]["code"], "mesh.filled", "{fill}");
        } else {
            refused(&scratch.run(&["inertia", "open.toml"]), 2);
        }
    }
}

#[test]
fn a_mass_for_a_name_that_several_parts_have_is_refused() {
    let scratch = Scratch::new("shared-names");
    // OBJ merges parts of the same name into one; 3MF and COLLADA do not.
    let geometry = "<geometry id=\"g\" name=\"g\"><mesh><source id=\"p\"><float_array id=\"f\" count=\"12\">0 0 0 2 0 0 0 3 0 0 0 1</float_array><technique_common><accessor source=\"#f\" count=\"4\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor></technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices><triangles count=\"4\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles></mesh></geometry>";
    let node = |x: u8| format!("<node><translate>{x} 0 0</translate><instance_geometry url=\"#g\"/></node>");
    let text = format!(
        "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\"><asset><unit name=\"meter\" meter=\"1\"/><up_axis>Z_UP</up_axis></asset><library_geometries>{geometry}</library_geometries><library_visual_scenes><visual_scene id=\"s\">{}{}</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>",
        node(0),
        node(10)
    );
    scratch.write("wheels.dae", &text);
    let of = |what: &str| scratch.run(&["inertia", "wheels.dae", "--part", what, "--json"]);
    assert_eq!(number(&json(&of("g=3 kg/m^3"))["mass"]), 6.0);
    let refusal = refused(&scratch.run(&["inertia", "wheels.dae", "--part", "g=2 kg"]), 2);
    assert!(refusal.contains("2 parts of the mesh are named \"g\""), "{refusal}");
}

#[test]
fn rounding_that_moves_the_body_is_said_though_its_volume_is_the_same() {
    let scratch = Scratch::new("moved");
    // 2²⁴ + 1 is halfway between two f32 values: a tetrahedron (4, 4, 4) m at x moves as a whole.
    let x = 16_777_217.0;
    let text = tetrahedron("a", x, 0, 0).replace(" 1\ng", " 4\ng").replace(" 3 0", " 4 0");
    scratch.write("g.obj", &text.replace(&format!("v {}", x + 2.0), &format!("v {}", x + 4.0)));
    let flags = ["inertia", "g.obj", "--unit", "m", "--density", "1 kg/m^3", "--json", "--write-mesh"];
    let written = json(&scratch.run(&[flags.as_slice(), &["g.stl"]].concat()));
    let said = written["findings"].to_string();
    assert!(said.contains("mesh.rounded") && said.contains("its centre of mass by 1.0e0 m"), "{said}");
    let exact = json(&scratch.run(&[flags.as_slice(), &["again.obj"]].concat()));
    assert!(!exact["findings"].to_string().contains("mesh.rounded"), "{}", exact["findings"]);
}
