//! `polhode inertia` for measurements of shapes without a mass: from MeshLab and FreeCAD, and point
//! clouds.

use crate::common::{Scratch, json, number, refused, stdout};
use crate::inertia::{TWO, near};

const MESHLAB: &str = "\
Opened mesh base.stl
Mesh Bounding Box Size 5.000000 4.982923 2.230000
Mesh Bounding Box Diag 7.404000
Mesh Surface Area is 98.211000
Mesh Volume is 36.789902
Center of Mass is 0.012000 -0.000300 0.941000
Inertia Tensor is :
| 68.811394  0.000714  0.918281 |
| 0.000714  66.050369  0.000911 |
| 0.918281  0.000911  103.803253 |
";

#[test]
fn measures_without_a_mass_need_a_substance() {
    let scratch = Scratch::new("measures");
    scratch.write("meshlab.txt", MESHLAB);
    let text = refused(&scratch.run(&["inertia", "meshlab.txt"]), 2);
    assert!(text.contains("mass") && text.contains("--density"), "{text}");
    let body =
        json(&scratch.run(&["inertia", "meshlab.txt", "--unit", "mm", "--density", "1240 kg/m^3", "--json"]));
    near(&body["mass"], 1240.0 * 36.789_902e-9);
    near(&body["volume"], 36.789_902e-9);
    near(&body["center_of_mass"][2], 0.941e-3);
    assert!((number(&body["inertia"]["tensor"][0][2]) / (1240.0 * 0.918_281e-15) - 1.0).abs() < 1e-13);
    assert_eq!(body["source"]["product"], "MeshLab");
    let weighed = json(&scratch.run(&["inertia", "meshlab.txt", "--unit", "cm", "--mass", "85 g", "--json"]));
    near(&weighed["mass"], 0.085);
    let want = 0.085 / 36.789_902e-6 * 103.803_253e-10;
    assert!((number(&weighed["inertia"]["tensor"][2][2]) / want - 1.0).abs() < 1e-13);
    // Without a unit, metres are assumed, and the first line reports this, as for a mesh.
    let metres = stdout(&scratch.run(&["inertia", "meshlab.txt", "--density", "1240 kg/m^3"]));
    assert!(metres.contains("in m because no unit is given") && metres.contains("mesh.unit"), "{metres}");
    for flags in [["--products", "negative"], ["--decimal", "point"], ["--mass-unit", "g"]] {
        let run = [["inertia", "meshlab.txt", "--mass", "85 g"].as_slice(), &flags].concat();
        let text = refused(&scratch.run(&run), 2);
        assert!(text.contains(flags[0]) && text.contains("measures of a shape"), "{text}");
    }
    scratch.write(
        "freecad.txt",
        ">>> s.Volume\n6000.0\n>>> s.CenterOfMass\nVector (5.0, 10.0, 15.0)\n>>> s.MatrixOfInertia\n\
         Matrix ((650000.0,0.0,0.0,0.0),(0.0,500000.0,0.0,0.0),(0.0,0.0,250000.0,0.0),(0.0,0.0,0.0,1.0))\n",
    );
    let brick = json(&scratch.run(&["inertia", "freecad.txt", "--mass", "12 g", "--json"]));
    near(&brick["inertia"]["tensor"][0][0], 0.012 * 1300e-6 / 12.0);
    near(&brick["center_of_mass"][1], 0.01);
    let text = refused(&scratch.run(&["inertia", "freecad.txt", "--mass", "12 g", "--unit", "mm"]), 2);
    assert!(text.contains("--unit is only for a file that states no unit"), "{text}");
    // A report with a mass accepts no other mass.
    scratch.write(
        "creo.txt",
        "MASS = 2.5 KILOGRAM\nINERTIA at CENTER OF GRAVITY with respect to _A coordinate frame:  (KILOGRAM * M^2)\n\
         INERTIA TENSOR:\nIxx Ixy Ixz  1.0 0.0 0.0\nIyx Iyy Iyz  0.0 2.0 0.0\nIzx Izy Izz  0.0 0.0 2.5\n",
    );
    near(&json(&scratch.run(&["inertia", "creo.txt", "--json"]))["inertia"]["tensor"][2][2], 2.5);
    let text = refused(&scratch.run(&["inertia", "creo.txt", "--density", "2700 kg/m^3"]), 2);
    assert!(text.contains("has a mass"), "{text}");
}

/// Corners of a box of 2, 3 and 5 m with interior points; the hull depends on the corners only.
#[test]
fn a_cloud_of_points_is_taken_as_its_hull() {
    let scratch = Scratch::new("cloud");
    let corners = (0..8).map(|k| [2 * (k & 1), 3 * (k >> 1 & 1), 5 * (k >> 2)]);
    let inside = [[1, 1, 1], [1, 2, 3], [0, 1, 4]];
    let points: Vec<[i32; 3]> = corners.chain(inside).collect();
    let rows =
        |before: &str| points.iter().map(|[x, y, z]| format!("{before}{x} {y} {z}\n")).collect::<String>();
    let header =
        "ply\nformat ascii 1.0\nelement vertex 11\nproperty float x\nproperty float y\nproperty float z\n";
    scratch.write("cloud.ply", &format!("{header}end_header\n{}", rows("")));
    scratch.write(
        "empty.ply",
        &format!("{header}element face 0\nproperty list uchar int vertex_indices\nend_header\n{}", rows("")),
    );
    scratch.write("cloud.obj", &rows("v "));
    scratch.write("cloud.xyz", &format!("# x y z\n{}", rows("")));
    scratch.write("cloud.asc", &rows("").replace(' ', ","));
    for (file, flags) in [
        ("cloud.ply", &[][..]),
        ("empty.ply", &[]),
        ("cloud.obj", &[]),
        ("cloud.xyz", &[]),
        ("cloud.asc", &["--format", "points"]),
    ] {
        let run = |more: &[&str]| scratch.run(&[["inertia", file].as_slice(), flags, more].concat());
        let body = json(&run(&["--hull", "--unit", "cm", "--density", "2700 kg/m^3", "--json"]));
        near(&body["volume"], 30e-6);
        near(&body["mass"], 0.081);
        near(&body["center_of_mass"][2], 0.025);
        near(&body["inertia"]["tensor"][0][0], 0.081 * (9.0 + 25.0) * 1e-4 / 12.0);
        assert_eq!(body["source"]["taken_as"], "convex_hull");
        let text = stdout(&run(&["--hull", "--density", "2700 kg/m^3"]));
        assert!(text.contains("the convex hull of 11 points"), "{file}: {text}");
        if file != "cloud.xyz" {
            let text = refused(&run(&["--density", "2700 kg/m^3"]), 2);
            assert!(text.contains("faces") && text.contains("--hull"), "{file}: {text}");
        }
    }
    // A molecule is not a point cloud, a flat cloud has no volume, and faces have priority over
    // points.
    scratch.write("water.xyz", "3\nwater\nO 0 0 0\nH 0.76 0.59 0\nH -0.76 0.59 0\n");
    let text = refused(&scratch.run(&["inertia", "water.xyz", "--hull"]), 2);
    assert!(text.contains("three coordinates"), "{text}");
    scratch.write("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0.3 0.4 0\n");
    refused(&scratch.run(&["inertia", "flat.xyz", "--hull", "--mass", "1 kg"]), 2);
    scratch.write("bad.xyz", "0 0 0\n1 0 0\n0 1 nan\n1 1 2\n");
    let text = refused(&scratch.run(&["inertia", "bad.xyz", "--hull", "--mass", "1 kg"]), 2);
    assert!(text.contains("bad.xyz:3"), "{text}");
    scratch.write("two.obj", TWO);
    near(
        &json(&scratch.run(&["inertia", "two.obj", "--hull", "--density", "4 kg/m^3", "--json"]))["mass"],
        8.0,
    );
}
