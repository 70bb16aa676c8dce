//! Meshes with cracks, holes, several pieces or overlaps: welded, filled, united and written.

use crate::common::{Scratch, json, number, refused};
use crate::inertia::{TWO, near};

/// A tetrahedron of 1 m³ with one corner split into three vertices about 1e-6 of its size apart.
const TORN: &str = "\
v 0.1 0 0\nv 2.1 0 0\nv 0.1 3 0\nv 0.1 0 1\nv 0.1000021 0 1\nv 0.1 0.0000013 1
f 1 3 2\nf 1 2 4\nf 1 5 3\nf 2 3 6
";

#[test]
fn a_torn_mesh_names_the_weld_that_closes_it_and_is_not_welded_unasked() {
    let scratch = Scratch::new("weld");
    scratch.write("torn.obj", TORN);
    let text = refused(&scratch.run(&["inertia", "torn.obj", "--mass", "4 kg"]), 2);
    assert!(
        text.contains(
            "it closes if vertices are welded within 6.6e-7 of its size: --weld 7e-7 (3 vertices become 1)"
        ),
        "{text}"
    );
    let mesh = ["inertia", "torn.obj", "--density", "4 kg/m^3", "--json"];
    for tolerance in ["7e-7", "3 um"] {
        let welded = json(&scratch.run(&[mesh.as_slice(), &["--weld", tolerance]].concat()));
        let bound = number(&welded["source"]["weld"]["volume_bound_m3"]);
        assert!((number(&welded["volume"]) - 1.0).abs() <= bound && bound < 2e-5, "{bound}");
        assert_eq!(
            (&welded["source"]["weld"]["vertices"], &welded["source"]["weld"]["points"]),
            (&3.into(), &1.into())
        );
        let finding = &welded["findings"][0];
        assert_eq!((&finding["code"], &finding["severity"]), (&"mesh.welded".into(), &"warning".into()));
        let message = finding["message"].as_str().unwrap();
        assert!(
            message.contains("weld: 3 vertices were welded to 1 point, at most 2.47e-6 m apart"),
            "{message}"
        );
        assert!(message.contains("no triangle vanished; the volume may be off by"), "{message}");
    }
    let refusal = |flags: &[&str]| refused(&scratch.run(&[&["inertia", "torn.obj"], flags].concat()), 2);
    let too_little = refusal(&["--weld", "1 um"]);
    assert!(too_little.contains("the mesh is open"), "{too_little}");
    let too_much = refusal(&["--weld", "1 m"]);
    assert!(too_much.contains("a hundredth"), "{too_much}");
    refusal(&["--weld", "7e-7", "--hull"]);
    refusal(&["--weld", "-1"]);
}

#[test]
fn the_weld_of_a_scenario_is_that_of_the_command() {
    let scratch = Scratch::new("weld-scenario");
    scratch.write("torn.obj", TORN);
    let command = json(&scratch.run(&["inertia", "torn.obj", "--mass", "4 kg", "--json", "--weld", "1e-6"]));
    for (weld, fits) in [("weld = 1e-6", true), ("weld = \"3 um\"", true), ("weld = 0", false), ("", false)] {
        let part = format!("shape = \"mesh\"\nfile = \"torn.obj\"\nunit = \"m\"\n{weld}\nmass = \"4 kg\"");
        let text = format!(
            "[[body.part]]\n{part}\n[start]\nspin = {{ body = [0, 0, \"1 rad/s\"] }}\n[run]\nduration = \"1 s\"\n"
        );
        scratch.write("torn.toml", &text);
        if fits {
            let scenario = json(&scratch.run(&["inertia", "torn.toml", "--json"]));
            assert_eq!(scenario["inertia"], command["inertia"], "{weld}");
            assert_eq!(scenario["findings"][0]["code"], "mesh.welded", "{weld}");
        } else {
            refused(&scratch.run(&["inertia", "torn.toml"]), 2);
        }
    }
}

#[test]
fn torn_parts_nearer_to_each_other_than_the_tolerance_are_welded_each_by_itself() {
    let scratch = Scratch::new("weld-parts");
    // A mirror image at a distance of 3 µm.
    let mirrored = |line: &str| -> String {
        let words: Vec<&str> = line.split(' ').collect();
        match words[..] {
            ["v", x, y, z] => format!("v {:?} {y} {z}\n", 0.2 - 3e-6 - x.parse::<f64>().unwrap()),
            ["f", a, b, c] => {
                let [a, b, c] = [a, b, c].map(|k| k.parse::<usize>().unwrap() + 6);
                format!("f {a} {c} {b}\n")
            }
            _ => panic!("{line}"),
        }
    };
    let two = format!("g a\n{TORN}g b\n{}", TORN.lines().map(mirrored).collect::<String>());
    scratch.write("two.obj", &two);
    let command = ["inertia", "two.obj", "--unit", "m", "--density", "4 kg/m^3", "--json", "--weld", "5 um"];
    let command = json(&scratch.run(&command));
    near(&command["mass"], 8.0);
    let part = "shape = \"mesh\"\nfile = \"two.obj\"\nunit = \"m\"\nweld = \"5 um\"\ndensity = \"4 kg/m^3\"";
    scratch.write("two.toml", &format!("[[body.part]]\n{part}\n[start]\nspin = {{ body = [0, 0, \"1 rad/s\"] }}\n[run]\nduration = \"1 s\"\n"));
    let scenario = json(&scratch.run(&["inertia", "two.toml", "--json"]));
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    for (row, other) in (0..3).flat_map(|i| (0..3).map(move |k| (i, k))) {
        let [a, b] = [&command, &scenario].map(|of| number(&of["inertia"]["tensor"][row][other]));
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }
}

#[test]
fn a_hole_is_filled_if_asked_and_what_that_may_change_is_said() {
    let scratch = Scratch::new("fill");
    let open: String =
        TWO.lines().filter(|line| *line != "f 1 3 2").map(|line| format!("{line}\n")).collect();
    scratch.write("open.obj", &open);
    refused(&scratch.run(&["inertia", "open.obj", "--mass", "4 kg"]), 2);
    let of =
        |size: &str| scratch.run(&["inertia", "open.obj", "--density", "4 kg/m^3", "--json", "--fill", size]);
    for size in ["3.7 m", "0.3"] {
        let filled = json(&of(size));
        near(&filled["mass"], 8.0);
        let said = &filled["source"]["fill"];
        assert_eq!((&said["holes"], &said["triangles"]), (&1.into(), &1.into()));
        let triangles = (&filled["source"]["triangles"], &filled["source"]["triangles_in_file"]);
        assert_eq!(triangles, (&8.into(), &7.into()));
        near(&said["largest_m"], 13_f64.sqrt());
        // The ball around a right triangle.
        near(&said["volume_bound_m3"], std::f64::consts::PI / 6.0 * 13_f64.powf(1.5));
        let finding = &filled["findings"][0];
        assert_eq!(finding["code"], "mesh.filled");
        let message = finding["message"].as_str().unwrap();
        assert!(
            message.contains("fill: 1 hole of up to 3.61e0 m across was filled with 1 triangle; if the missing surface lies"),
            "{message}"
        );
    }
    // Options without effect give no warning.
    scratch.write("two.obj", TWO);
    let closed = ["inertia", "two.obj", "--density", "4 kg/m^3", "--json", "--weld", "1e-6", "--fill", "0.5"];
    let closed = json(&scratch.run(&closed));
    for (k, code) in ["mesh.welded", "mesh.filled"].into_iter().enumerate() {
        let finding = &closed["findings"][k];
        assert_eq!((&finding["code"], &finding["severity"]), (&code.into(), &"info".into()));
        let message = finding["message"].as_str().unwrap();
        assert!(message.starts_with("nothing was") && !message.contains("may be off"), "{message}");
    }
    let refusal = |size: &str| refused(&scratch.run(&["inertia", "open.obj", "--fill", size]), 2);
    assert!(refusal("3 m").contains("the mesh is open"));
    refusal("-3 m");
}

#[test]
fn the_pieces_of_one_surface_are_filled_together() {
    let scratch = Scratch::new("fill-pieces");
    // A tetrahedron in two groups; one of its four triangles is missing. No group is closed, and
    // only three edges are open in both.
    let text = "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 1\ng a\nf 1 2 4\nf 1 4 3\ng b\nf 2 3 4\n";
    scratch.write("open.obj", text);
    let filled =
        json(&scratch.run(&["inertia", "open.obj", "--density", "4 kg/m^3", "--json", "--fill", "4 m"]));
    near(&filled["mass"], 4.0);
    assert_eq!(filled["source"]["fill"]["holes"], 1);
    assert!(filled["findings"].to_string().contains("2 open parts of the file form one surface"));
    // A closed part wound inward is turned outward as usual, and is not a cavity of them.
    let inner = "v 0.2 0.2 0.2\nv 0.4 0.2 0.2\nv 0.2 0.5 0.2\nv 0.2 0.2 0.3\ng c\nf 5 6 7\nf 5 8 6\nf 5 7 8\nf 6 8 7\n";
    scratch.write("open.obj", &format!("{text}{inner}"));
    let filled =
        json(&scratch.run(&["inertia", "open.obj", "--density", "4 kg/m^3", "--json", "--fill", "4 m"]));
    near(&filled["mass"], 4.004);
    let findings = filled["findings"].to_string();
    assert!(findings.contains("mesh.inverted") && findings.contains("mesh.parts_overlap"), "{findings}");
}

/// Returns a cube of 3 m away from the origin, with n × n squares per face, as triangles.
fn squares(n: usize) -> Vec<[[f64; 3]; 3]> {
    let mut triangles = Vec::new();
    for axis in 0..3 {
        let at = |i: usize, k: usize, far: bool| {
            let step = 3.0 / n as f64;
            let mut p = [0.3, -1.7, 0.9];
            p[axis] += if far { 3.0 } else { 0.0 };
            p[(axis + 1) % 3] += i as f64 * step;
            p[(axis + 2) % 3] += k as f64 * step;
            p
        };
        for (i, k) in (0..n * n).map(|at| (at / n, at % n)) {
            for far in [false, true] {
                let [a, b, c, d] =
                    [at(i, k, far), at(i + 1, k, far), at(i + 1, k + 1, far), at(i, k + 1, far)];
                triangles.extend(if far { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] });
            }
        }
    }
    triangles
}

fn obj(triangles: &[[[f64; 3]; 3]]) -> String {
    let vertices = triangles.iter().flatten().map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect::<String>();
    let faces = (0..triangles.len()).map(|k| format!("f {} {} {}\n", 3 * k + 1, 3 * k + 2, 3 * k + 3));
    vertices + &faces.collect::<String>()
}

#[test]
fn an_open_mesh_names_the_fill_that_closes_it_and_weld_and_fill_have_one_bound() {
    let scratch = Scratch::new("fill-hint");
    let mut triangles = squares(12);
    triangles.remove(501);
    scratch.write("holed.obj", &obj(&triangles));
    let flags = ["inertia", "holed.obj", "--unit", "m", "--density", "2 kg/m^3", "--json"];
    let refusal = refused(&scratch.run(&flags[..6]), 2);
    let size = refusal.split("--fill ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
    assert!(refusal.contains("(1 hole, 1 triangle)"), "{refusal}");
    let filled = json(&scratch.run(&[flags.as_slice(), &["--fill", size]].concat()));
    near(&filled["mass"], 54.0);

    // The centre may be off by ΔV R/(V − ΔV); the farthest point is a ball's diameter beyond the
    // farthest corner.
    let r = 0.25 * f64::sqrt(2.0) / 2.0;
    let ball = 4.0 / 3.0 * std::f64::consts::PI * r.powi(3);
    near(&filled["source"]["volume_bound_m3"], ball);
    let center = ball * (1.5 * f64::sqrt(3.0) + 2.0 * r) / (27.0 - ball);
    let message = filled["findings"][0]["message"].as_str().unwrap();
    assert!(message.contains(&format!("the centre of mass by {center:.1e} m")), "{center} {message}");

    // With a crack as well: the weld is reported, and the bound covers both.
    let torn = triangles[40][1];
    let moved = [torn[0] + 2e-6, torn[1], torn[2] - 1e-6];
    triangles[40][1] = moved;
    scratch.write("holed.obj", &obj(&triangles));
    let mended = [flags.as_slice(), &["--weld", "1e-5", "--fill", size]].concat();
    let mended = json(&scratch.run(&mended));
    let said = |k: usize| mended["findings"][k]["message"].as_str().unwrap();
    assert!(said(0).contains("were welded") && !said(0).contains("may be off"), "{}", said(0));
    assert!(said(1).contains("was filled") && said(1).contains("at most all together"), "{}", said(1));
    let source = &mended["source"];
    let each = number(&source["weld"]["volume_bound_m3"]) + number(&source["fill"]["volume_bound_m3"]);
    let both = number(&source["volume_bound_m3"]);
    assert!(both > each && both < 1.01 * each, "{both} {each}");
}

#[test]
fn exact_shapes_are_refused_with_what_makes_a_mesh_of_them() {
    let scratch = Scratch::new("brep");
    scratch.write("part.step", "ISO-10303-21;\nHEADER;\n");
    scratch.write("part.dat", "ISO-10303-21;\nHEADER;\n");
    scratch.write("part.stl", "ISO-10303-21;\nHEADER;\n");
    scratch.write("part.igs", &format!("{:<72}S{:>7}\n", "a part", 1));
    for (file, says) in [
        ("part.step", "gmsh part.step -2 -o part.stl, or python -c"),
        ("part.dat", "rename it to part.step, convert it to a mesh in mm: gmsh part.step"),
        ("part.step", "polhode.inertia in Python, after pip install cadquery-ocp"),
        ("part.stl", "a STEP file contains exact shapes"),
        ("part.igs", "gmsh part.igs -2 -o part.stl, and read the result with --unit mm"),
    ] {
        let text = refused(&scratch.run(&["inertia", file, "--density", "2 kg/m^3"]), 2);
        assert!(text.contains(says), "{file}: {text}");
    }
    scratch.write("empty.step", "");
    for (file, says) in [("empty.step", "the file is empty"), ("none.step", "cannot read")] {
        let text = refused(&scratch.run(&["inertia", file, "--density", "2 kg/m^3"]), 2);
        assert!(text.contains(says) && !text.contains("exact shapes"), "{file}: {text}");
    }
    // The format stated by the user has priority over the file name, and the content over both.
    scratch.write("wedge.step", "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    let answer =
        scratch.run(&["inertia", "wedge.step", "--format", "obj", "--unit", "m", "--density", "2 kg/m^3"]);
    assert!(answer.status.success());
    let text =
        refused(&scratch.run(&["inertia", "part.step", "--format", "dae", "--density", "2 kg/m^3"]), 2);
    assert!(text.contains("a STEP file contains exact shapes"), "{text}");
    let part = "shape = \"mesh\"\nfile = \"part.stl\"\nmass = \"4 kg\"";
    scratch.write("stl.toml", &format!("[[body.part]]\n{part}\n[start]\nspin = {{ body = [0, 0, \"1 rad/s\"] }}\n[run]\nduration = \"1 s\"\n"));
    let text = refused(&scratch.run(&["inertia", "stl.toml"]), 2);
    assert!(text.contains("polhode does not read STEP") && text.contains("gmsh part.step"), "{text}");
    let part = "shape = \"mesh\"\nfile = \"part.step\"\nmass = \"4 kg\"";
    scratch.write("part.toml", &format!("[[body.part]]\n{part}\n[start]\nspin = {{ body = [0, 0, \"1 rad/s\"] }}\n[run]\nduration = \"1 s\"\n"));
    let text = refused(&scratch.run(&["inertia", "part.toml"]), 2);
    assert!(text.contains("gmsh part.step"), "{text}");
}

#[test]
fn a_mesh_that_rounding_would_break_is_not_written() {
    let scratch = Scratch::new("write-rounded");
    let moved = |by: f64| {
        let triangles: Vec<_> = squares(2).iter().map(|t| t.map(|p| p.map(|c| 1.0371 * c + by))).collect();
        obj(&triangles)
    };
    scratch.write("near.obj", &moved(4321.0));
    scratch.write("far.obj", &moved(1e8));
    let of = |file: &str, rest: &[&str]| {
        scratch.run(&[&["inertia", file, "--unit", "m", "--density", "2 kg/m^3", "--json"], rest].concat())
    };
    let text = |file: &str, rest: &[&str]| {
        scratch.run(&[&["inertia", file, "--unit", "m", "--density", "2 kg/m^3"], rest].concat())
    };
    let near = json(&of("near.obj", &["--write-mesh", "near.stl"]));
    assert!(near["findings"].to_string().contains("mesh.rounded"), "{}", near["findings"]);
    let refusal = refused(&text("far.obj", &["--write-mesh", "far.stl"]), 2);
    assert!(refusal.contains("this is the mesh as it would be written; OBJ keeps all digits"), "{refusal}");
    json(&of("far.obj", &["--write-mesh", "far.ply"]));
    // A result that is not finite writes no mesh either.
    let refusal = refused(&text("near.obj", &["--about", "1e160 m, 0, 0", "--write-mesh", "none.obj"]), 2);
    assert!(refusal.contains("too large"), "{refusal}");
    assert!(!scratch.entries().iter().any(|name| name == "far.stl" || name == "none.obj"));
}

#[test]
fn the_mesh_is_written_as_it_was_used_and_replaces_nothing_unasked() {
    let scratch = Scratch::new("write-mesh");
    scratch.write("torn.obj", TORN);
    let mend =
        ["inertia", "torn.obj", "--unit", "mm", "--mass", "4 g", "--json", "--weld", "1e-6", "--write-mesh"];
    let used = json(&scratch.run(&[mend.as_slice(), &["whole.obj"]].concat()));
    let refusal = |rest: &[&str]| {
        let mend = ["inertia", "torn.obj", "--unit", "mm", "--weld", "1e-6", "--write-mesh"];
        refused(&scratch.run(&[mend.as_slice(), rest].concat()), 2)
    };
    for (name, tolerance) in [("whole.obj", 1e-14), ("whole.ply", 1e-14), ("whole.stl", 1e-6)] {
        if name != "whole.obj" {
            json(&scratch.run(&[mend.as_slice(), &[name]].concat()));
        }
        let again = json(&scratch.run(&["inertia", name, "--unit", "mm", "--mass", "4 g", "--json"]));
        for element in 0..9 {
            let [a, b] =
                [&used, &again].map(|body| number(&body["inertia"]["tensor"][element / 3][element % 3]));
            assert!((a - b).abs() <= tolerance * number(&used["inertia"]["tensor"][0][0]), "{name}: {a} {b}");
        }
        assert!(again["findings"].as_array().unwrap().is_empty(), "{name}: {}", again["findings"]);
        let there = refusal(&[name]);
        assert!(there.contains("already exists") && there.contains("--force"), "{there}");
        json(&scratch.run(&[mend.as_slice(), &[name, "--force"]].concat()));
    }
    // Inward winding is reversed on output, and parts keep their names.
    scratch.write(
        "two.obj",
        &TWO.replace(
            "g near\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4",
            "g near\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3",
        ),
    );
    let two = ["inertia", "two.obj", "--density", "4 kg/m^3", "--json", "--write-mesh"];
    json(&scratch.run(&[two.as_slice(), &["out.obj"]].concat()));
    let out =
        json(&scratch.run(&["inertia", "out.obj", "--part", "near=1 kg", "--part", "far=2 kg", "--json"]));
    near(&out["mass"], 3.0);
    assert!(!out["findings"].to_string().contains("mesh.inverted"), "{}", out["findings"]);
    for wrong in ["whole.3mf", "whole", "torn.obj"] {
        refusal(&[wrong]);
    }
    refusal(&["new.obj", "two.obj"]);
    assert!(!scratch.entries().contains(&"new.obj".to_owned()));
}

/// Two bricks of 2 × 1 × 1 m that share a cube of 1 m, and a copy of the second; as one part or as
/// three.
fn three_bricks(groups: bool) -> String {
    let mut text = String::new();
    for (k, x) in [0.0, 1.0, 1.0].into_iter().enumerate() {
        if groups {
            text += &format!("g brick{k}\n");
        }
        for corner in 0..8 {
            let [i, j, l] = [0, 1, 2].map(|axis| f64::from(corner >> axis & 1));
            text += &format!("v {} {j} {l}\n", x + 2.0 * i);
        }
        for [a, b, c, d] in
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
        {
            let [a, b, c, d] = [a, b, c, d].map(|v| v + 8 * k + 1);
            text += &format!("f {a} {b} {c}\nf {a} {c} {d}\n");
        }
    }
    text
}

#[test]
fn parts_that_overlap_are_united_where_that_is_asked() {
    let scratch = Scratch::new("union");
    scratch.write("one.obj", &three_bricks(false));
    scratch.write("three.obj", &three_bricks(true));
    let run = |arguments: &[&str]| {
        scratch.run(&[&["inertia"], arguments, &["--unit", "m", "--density", "4 kg/m^3", "--json"]].concat())
    };
    let refusal = |arguments: &[&str]| refused(&scratch.run(&[&["inertia"], arguments].concat()), 2);
    let error = refusal(&["one.obj"]);
    assert!(error.contains("hint: use --union, or union = true in a scenario"), "{error}");
    let warned = json(&run(&["three.obj"]));
    near(&warned["mass"], 24.0);
    let overlap =
        warned["findings"].as_array().unwrap().iter().find(|f| f["code"] == "mesh.parts_overlap").unwrap();
    assert!(overlap["message"].as_str().unwrap().contains("--union"), "{overlap}");
    for file in ["one.obj", "three.obj"] {
        let united = json(&run(&[file, "--union"]));
        near(&united["mass"], 12.0);
        near(&united["volume"], 3.0);
        near(&united["inertia"]["tensor"][0][0], 12.0 * (1.0 + 1.0) / 12.0);
        near(&united["inertia"]["tensor"][1][1], 12.0 * (9.0 + 1.0) / 12.0);
        near(&united["center_of_mass"][0], 1.5);
        let said = &united["source"]["union"];
        near(&said["shared_m3"], 2.0);
        assert!(number(&said["volume_error_m3"]) < 1e-14 && united["source"]["taken_as"] == "union");
        let finding = &united["findings"][0];
        assert_eq!((&finding["code"], &finding["severity"]), (&"mesh.united".into(), &"warning".into()));
        let message = finding["message"].as_str().unwrap();
        assert!(
            message.contains("2.0000e0 m³ (6.7e-1 of the volume) were covered more than once"),
            "{message}"
        );
    }
    // The key of a scenario gives the same result.
    for (union, code) in [("true", "mesh.united"), ("false", "")] {
        let part = format!(
            "[[body.part]]\nshape = \"mesh\"\nfile = \"one.obj\"\nunit = \"m\"\nunion = {union}\ndensity = 4\n"
        );
        scratch.write("body.toml", &part);
        if code.is_empty() {
            assert!(refusal(&["body.toml"]).contains("union = true"));
            continue;
        }
        let scenario = json(&scratch.run(&["inertia", "body.toml", "--json"]));
        near(&scenario["mass"], 12.0);
        assert_eq!(scenario["findings"][0]["code"], code);
    }
    // An open mesh cannot be united, and no hint suggests it.
    scratch.write("open.obj", &three_bricks(false).replacen("f 1 3 4\n", "", 1));
    for arguments in [&["open.obj"] as &[&str], &["open.obj", "--union"]] {
        let error = refusal(arguments);
        assert!(!error.contains("use --union"), "{error}");
    }
    assert!(refusal(&["open.obj", "--union"]).contains("the mesh is open"));
    let both = refusal(&["one.obj", "--union", "--write-mesh", "whole.stl"]);
    assert!(both.contains("--union") && both.contains("--write-mesh"), "{both}");
    // Without overlaps the result is unchanged.
    scratch
        .write("sound.obj", three_bricks(false).split_inclusive('\n').take(20).collect::<String>().as_str());
    let (plain, united) = (json(&run(&["sound.obj"])), json(&run(&["sound.obj", "--union"])));
    assert_eq!((&plain["inertia"], &plain["mass"]), (&united["inertia"], &united["mass"]));
    assert!(united["findings"][0]["message"].as_str().unwrap().starts_with("union had no effect"));
}

#[test]
fn points_without_a_hull_are_refused_by_where_they_lie() {
    let scratch = Scratch::new("flat-points");
    for (points, place) in [
        ("0 0 0\n1 0 0\n0 1 0\n1 1 0\n", "4 points lie in one plane"),
        ("0 0 0\n1 1 1\n2 2 2\n3 3 3\n", "4 points lie on one line"),
        ("0 0 0\n1 0 0\n0 1 0\n", "3 points lie in one plane"),
    ] {
        scratch.write("flat.xyz", points);
        let text = refused(&scratch.run(&["inertia", "flat.xyz", "--hull", "--mass", "1"]), 2);
        assert!(text.contains(place) && !text.contains("--density"), "{text}");
    }
}
