//! Shapes of a robot's links: their geometry, placed in the frame of the link.

use serde_json::Value;

use crate::page::{Page, f32s, u32s};

type Point = [f64; 3];

/// Open surface of three triangles at generic points.
const SURFACE: [[Point; 3]; 3] = [
    [[0.12, -0.31, 0.47], [0.83, 0.21, 0.36], [0.29, 0.94, 0.15]],
    [[0.12, -0.31, 0.47], [0.41, 0.18, 1.27], [0.83, 0.21, 0.36]],
    [[0.12, -0.31, 0.47], [0.29, 0.94, 0.15], [0.41, 0.18, 1.27]],
];

/// Scale with a reflection and a different factor along each axis.
const SCALE: Point = [0.7, -1.6, 2.3];

/// Placements of the mesh, the box and the cylinder: position, m, and roll, pitch and yaw, rad.
const PLACES: [[Point; 2]; 3] = [
    [[0.31, -0.72, 1.13], [0.4, -0.9, 1.7]],
    [[-0.27, 0.53, 0.19], [-1.1, 0.6, 0.3]],
    [[0.64, 0.38, -0.81], [0.2, 1.2, -2.4]],
];

const BOX: Point = [0.23, 0.41, 0.57];
const CYLINDER: [f64; 2] = [0.17, 0.63];

/// Applies R_z(yaw) R_y(pitch) R_x(roll) to a vector.
fn turned([roll, pitch, yaw]: Point, v: Point) -> Point {
    let about = |axis: usize, angle: f64, v: Point| {
        let (sin, cos) = angle.sin_cos();
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut turned = v;
        (turned[j], turned[k]) = (cos * v[j] - sin * v[k], sin * v[j] + cos * v[k]);
        turned
    };
    about(2, yaw, about(1, pitch, about(0, roll, v)))
}

/// Returns the same rotation as a quaternion (w, x, y, z).
fn quaternion([roll, pitch, yaw]: Point) -> [f64; 4] {
    let about = |axis: usize, angle: f64| {
        let mut q = [(0.5 * angle).cos(), 0.0, 0.0, 0.0];
        q[axis + 1] = (0.5 * angle).sin();
        q
    };
    let product = |[w, x, y, z]: [f64; 4], [a, b, c, d]: [f64; 4]| {
        [
            w * a - x * b - y * c - z * d,
            w * b + x * a + y * d - z * c,
            w * c - x * d + y * a + z * b,
            w * d + x * c - y * b + z * a,
        ]
    };
    product(about(2, yaw), product(about(1, pitch), about(0, roll)))
}

/// Rotates a vector by a quaternion (w, x, y, z): v + 2 w u × v + 2 u × (u × v).
fn turned_by([w, x, y, z]: [f64; 4], v: Point) -> Point {
    let cross = |a: Point, b: Point| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let once = cross([x, y, z], v);
    let twice = cross([x, y, z], once);
    std::array::from_fn(|k| v[k] + 2.0 * w * once[k] + 2.0 * twice[k])
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let values: Vec<f64> = value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    values.try_into().unwrap()
}

/// Transforms a point from the frame of a shape to that of its link.
fn in_link(shape: &Value, point: Point) -> Point {
    let (position, turn) =
        (numbers::<3>(&shape["position"]), turned_by(numbers(&shape["quaternion"]), point));
    std::array::from_fn(|k| position[k] + turn[k])
}

/// Returns the triangles of a mesh shape in the frame of its link.
fn triangles(shape: &Value) -> Vec<[Point; 3]> {
    let vertices: Vec<Point> =
        f32s(&shape["vertices"]).chunks(3).map(|p| [p[0], p[1], p[2]].map(f64::from)).collect();
    let corner = |k: u32| in_link(shape, vertices[k as usize]);
    u32s(&shape["triangles"]).chunks(3).map(|c| [corner(c[0]), corner(c[1]), corner(c[2])]).collect()
}

fn is_near(a: &[f64], b: &[f64], tolerance: f64) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(x, y)| (x - y).abs() <= tolerance)
}

fn ply(triangles: &[[Point; 3]]) -> String {
    let mut text = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        3 * triangles.len(),
        triangles.len()
    );
    for [x, y, z] in triangles.as_flattened() {
        text += &format!("{x} {y} {z}\n");
    }
    (0..triangles.len()).for_each(|k| text += &format!("3 {} {} {}\n", 3 * k, 3 * k + 1, 3 * k + 2));
    text
}

fn row(numbers: &[f64]) -> String {
    numbers.iter().map(|x| format!("{x}")).collect::<Vec<_>>().join(" ")
}

fn urdf() -> String {
    let shapes = [
        format!("<mesh filename=\"part.ply\" scale=\"{}\"/>", row(&SCALE)),
        format!("<box size=\"{}\"/>", row(&BOX)),
        format!("<cylinder radius=\"{}\" length=\"{}\"/>", CYLINDER[0], CYLINDER[1]),
    ];
    let visual = |(shape, [at, turn]): (&String, [Point; 2])| {
        let (at, turn) = (row(&at), row(&turn));
        format!("<visual><origin xyz=\"{at}\" rpy=\"{turn}\"/><geometry>{shape}</geometry></visual>")
    };
    let visuals: String = shapes.iter().zip(PLACES).map(visual).collect();
    format!(
        "<robot name=\"r\"><link name=\"base\"/><link name=\"arm\">{visuals}\
         <collision><geometry><sphere radius=\"1\"/></geometry></collision></link>\
         <link name=\"hand\"><collision><geometry><sphere radius=\"0.37\"/></geometry></collision></link></robot>"
    )
}

fn sdf() -> String {
    let shapes = [
        format!("<mesh><uri>part.ply</uri><scale>{}</scale></mesh>", row(&SCALE)),
        format!("<box><size>{}</size></box>", row(&BOX)),
        format!("<cylinder><radius>{}</radius><length>{}</length></cylinder>", CYLINDER[0], CYLINDER[1]),
    ];
    let visual = |(k, (shape, [at, turn])): (usize, (&String, [Point; 2]))| {
        let pose = row(&[at, turn].concat());
        format!("<visual name=\"v{k}\"><pose>{pose}</pose><geometry>{shape}</geometry></visual>")
    };
    let visuals: String = shapes.iter().zip(PLACES).enumerate().map(visual).collect();
    format!(
        "<sdf version=\"1.9\"><model name=\"r\"><link name=\"arm\"><pose>3 -2 1 0.3 0.2 0.1</pose>{visuals}\
         <collision name=\"c\"><geometry><sphere><radius>1</radius></sphere></geometry></collision></link>\
         <link name=\"hand\"><collision name=\"c\"><geometry><sphere><radius>0.37</radius></sphere></geometry></collision></link>\
         </model></sdf>"
    )
}

fn mjcf() -> String {
    let shapes = [
        "type=\"mesh\" mesh=\"part\"".to_owned(),
        format!("type=\"box\" size=\"{}\"", row(&BOX.map(|edge| 0.5 * edge))),
        format!("type=\"cylinder\" size=\"{}\"", row(&[CYLINDER[0], 0.5 * CYLINDER[1]])),
    ];
    let geom = |(shape, [at, turn]): (&String, [Point; 2])| {
        let (at, turn) = (row(&at), row(&quaternion(turn)));
        format!("<geom contype=\"0\" conaffinity=\"0\" pos=\"{at}\" quat=\"{turn}\" {shape}/>")
    };
    let geoms: String = shapes.iter().zip(PLACES).map(geom).collect();
    format!(
        "<mujoco model=\"r\"><asset><mesh name=\"part\" file=\"part.ply\" scale=\"{}\"/></asset><worldbody>\
         <body name=\"arm\" pos=\"3 -2 1\" euler=\"10 20 30\">{geoms}<geom type=\"sphere\" size=\"1\"/></body>\
         <body name=\"hand\"><geom type=\"sphere\" size=\"0.37\"/></body></worldbody></mujoco>",
        row(&SCALE)
    )
}

fn shapes<'a>(robot: &'a Value, name: &str) -> &'a Vec<Value> {
    let links = robot["links"].as_array().unwrap();
    links.iter().find(|link| link["name"] == name).unwrap()["shapes"].as_array().unwrap()
}

#[test]
fn visuals_are_at_their_places_in_each_language_and_collisions_where_there_are_none() {
    let page = Page::open(&[]);
    for (set, name, text) in [(1, "r.urdf", urdf()), (2, "r.sdf", sdf()), (3, "r.xml", mjcf())] {
        page.drop_file(set, "part.ply", ply(&SURFACE).as_bytes());
        let robot = page.dropped(set, name, text.as_bytes())["robot"].clone();
        let arm = shapes(&robot, "arm");
        let kinds: Vec<_> = arm.iter().map(|shape| shape["kind"].as_str().unwrap()).collect();
        assert_eq!(kinds, ["mesh", "box", "cylinder"], "{name}");
        // The mesh is scaled, rotated and translated. Its outer side stays outside despite the
        // reflection.
        let [at, turn] = PLACES[0];
        let place = |p: Point| -> Point {
            let turned = turned(turn, std::array::from_fn(|k| SCALE[k] * p[k]));
            std::array::from_fn(|k| at[k] + turned[k])
        };
        let expected: Vec<[Point; 3]> = SURFACE.iter().map(|&[a, b, c]| [a, c, b].map(place)).collect();
        let found = triangles(&arm[0]);
        assert!(
            is_near(found.as_flattened().as_flattened(), expected.as_flattened().as_flattened(), 1e-6),
            "{name}: {found:?} {expected:?}"
        );
        assert_eq!(arm[0]["of"], 3);
        // For the other shapes: their origins and axes.
        for (shape, [at, turn]) in arm.iter().zip(PLACES).skip(1) {
            for v in [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
                let turned = turned(turn, v);
                let expected: Point = std::array::from_fn(|k| at[k] + turned[k]);
                assert!(is_near(&in_link(shape, v), &expected, 1e-12), "{name}: {shape}");
            }
        }
        assert!(is_near(&numbers::<3>(&arm[1]["size"]), &BOX, 1e-15), "{name}");
        let cylinder = ["radius", "height", "inner"].map(|key| arm[2][key].as_f64().unwrap());
        assert!(is_near(&cylinder, &[CYLINDER[0], CYLINDER[1], 0.0], 1e-15), "{name}: {cylinder:?}");
        let hand = shapes(&robot, "hand");
        assert_eq!((hand.len(), numbers::<3>(&hand[0]["half"])), (1, [0.37; 3]), "{name}");
    }
}

#[test]
fn collada_is_shown_in_metres() {
    let dae = "<COLLADA version=\"1.4.1\"><asset><unit meter=\"0.01\"/><up_axis>Z_UP</up_axis></asset>\
        <library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"a\" count=\"9\">\
        1 2 3 40 5 6 7 80 9</float_array><technique_common><accessor source=\"#a\" count=\"3\" stride=\"3\"/>\
        </technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>\
        <triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 2</p></triangles></mesh>\
        </geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\"><node>\
        <instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes>\
        <scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";
    let page = Page::open(&[]);
    page.drop_file(1, "meshes/flat.dae", dae.as_bytes());
    let text = "<robot name=\"r\"><link name=\"a\"><visual><geometry><mesh filename=\"meshes/flat.dae\"/></geometry></visual></link></robot>";
    let robot = page.dropped(1, "r.urdf", text.as_bytes())["robot"].clone();
    let found = triangles(&shapes(&robot, "a")[0]);
    let expected = [[0.01, 0.02, 0.03], [0.4, 0.05, 0.06], [0.07, 0.8, 0.09]];
    assert!(is_near(found.as_flattened().as_flattened(), expected.as_flattened(), 1e-7), "{found:?}");
}

#[test]
fn many_triangles_are_made_coarser_together() {
    // A wavy sheet of 80,000 triangles, twice, and one of three triangles, twice.
    let (m, n) = (400, 100);
    let at = |i: i32, j: i32| {
        let (x, y) = (f64::from(i) * 0.01, f64::from(j) * 0.013);
        [x, y, 0.3 * (3.0 * x).sin() * (2.0 * y).cos()]
    };
    let quads = (0..m).flat_map(|i| (0..n).map(move |j| (i, j)));
    let sheet: Vec<[Point; 3]> = quads
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let page = Page::open(&[]);
    page.drop_file(1, "sheet.ply", ply(&sheet).as_bytes());
    page.drop_file(1, "part.ply", ply(&SURFACE).as_bytes());
    let visual = |file: &str| format!("<visual><geometry><mesh filename=\"{file}\"/></geometry></visual>");
    let link = |name: &str| {
        format!("<link name=\"{name}\">{}{}</link>", visual("sheet.ply"), visual("part.ply").repeat(2))
    };
    let text = format!("<robot name=\"r\">{}{}</robot>", link("a"), link("b"));
    let robot = page.dropped(1, "r.urdf", text.as_bytes())["robot"].clone();
    let sheets = ["a", "b"].map(|name| shapes(&robot, name)[0].clone());
    let shown = sheets.each_ref().map(|sheet| triangles(sheet).len());
    assert_eq!(shown[0], shown[1]);
    assert!(shown[0] > 20_000 && shown[0] < 75_000, "{shown:?}");
    assert_eq!(sheets.map(|sheet| sheet["of"].as_u64()), [Some(80_000); 2]);
}

#[test]
fn what_is_not_shown_is_said_once() {
    let page = Page::open(&[]);
    let flat = ply(&SURFACE);
    page.drop_file(1, "part.ply", flat.as_bytes());
    page.drop_file(1, "broken.ply", &flat.as_bytes()[..flat.len() - 9]);
    let links = [
        ("gone", "<mesh filename=\"gone.stl\"/>"),
        ("broken", "<mesh filename=\"broken.ply\"/>"),
        ("huge", "<mesh filename=\"part.ply\" scale=\"1e45 1e45 1e45\"/>"),
        ("bad", "<box size=\"0.1 -0.2 0.3\"/>"),
        ("good", "<mesh filename=\"part.ply\"/>"),
    ];
    let link = |(name, shape): (&str, &str)| {
        format!("<link name=\"{name}\"><visual><geometry>{shape}</geometry></visual></link>")
    };
    let text = format!("<robot name=\"r\">{}</robot>", links.map(link).concat());
    let robot = page.dropped(1, "r.urdf", text.as_bytes())["robot"].clone();
    let said = |name: &str| -> Vec<String> {
        let number = links.iter().position(|link| link.0 == name).unwrap();
        let findings = robot["findings"].as_array().unwrap().iter();
        let own = findings.filter(|finding| finding["link"] == number && finding["severity"] == "note");
        let codes = own.map(|finding| finding["code"].as_str().unwrap().to_owned());
        codes.filter(|code| code == "page.mesh" || code == "geometry.unreadable").collect()
    };
    for (name, count, codes) in [
        ("gone", 0, vec!["geometry.unreadable"]),
        ("broken", 0, vec!["geometry.unreadable"]),
        ("huge", 0, vec!["page.mesh"]),
        ("bad", 0, vec!["geometry.unreadable"]),
        ("good", 1, vec![]),
    ] {
        assert_eq!(
            (shapes(&robot, name).len(), said(name)),
            (count, codes.iter().map(|c| (*c).to_owned()).collect()),
            "{name}"
        );
    }
}
