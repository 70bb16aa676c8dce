//! Robots as read from their files, their findings, and their fixes.

use serde_json::Value;

use crate::page::{Folder, Page, repository};

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let values: Vec<f64> = value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    values.try_into().unwrap()
}

fn links(robot: &Value) -> &Vec<Value> {
    robot["links"].as_array().unwrap()
}

fn link<'a>(robot: &'a Value, name: &str) -> &'a Value {
    links(robot).iter().find(|link| link["name"] == name).unwrap()
}

/// Rotates v by a quaternion (w, x, y, z): v + 2 w (u × v) + 2 u × (u × v).
fn turned([w, x, y, z]: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let u = [x, y, z];
    let (once, twice) = (cross(u, v), cross(u, cross(u, v)));
    std::array::from_fn(|k| v[k] + 2.0 * w * once[k] + 2.0 * twice[k])
}

fn is_near(a: &[f64], b: &[f64], tolerance: f64) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance)
}

fn example(name: &str) -> Value {
    let page = Page::open(&[repository("examples/robots").join(name)]);
    let content = page.document(&0.into());
    assert_eq!(content["kind"], "robot");
    content["robot"].clone()
}

#[test]
fn an_arm_stands_where_its_joints_say_in_each_language() {
    let robots = ["arm.urdf", "arm.sdf", "arm.xml"].map(example);
    let center = |robot: &Value, name: &str| {
        let link = link(robot, name);
        let (position, turn) = (numbers::<3>(&link["position"]), numbers::<4>(&link["quaternion"]));
        let center = turned(turn, numbers(&link["inertial"]["center"]));
        [0, 1, 2].map(|k| position[k] + center[k])
    };
    let weighed: Vec<&str> = links(&robots[0])
        .iter()
        .filter(|link| !link["inertial"].is_null())
        .map(|link| link["name"].as_str().unwrap())
        .collect();
    assert!(weighed.len() >= 5, "{weighed:?}");
    for name in weighed {
        for robot in &robots[1..] {
            let [a, b] = [center(&robots[0], name), center(robot, name)];
            assert!(is_near(&a, &b, 1e-12), "{name}: {a:?} and {b:?}");
            let mass = |robot: &Value| link(robot, name)["inertial"]["mass"].as_f64().unwrap();
            assert_eq!(mass(&robots[0]), mass(robot));
        }
    }
    let urdf = &robots[0];
    assert_eq!(numbers::<3>(&link(urdf, "forearm")["position"]), [0.0, 0.0, 0.5]);
    assert!(is_near(&numbers::<3>(&link(urdf, "camera")["position"]), &[0.2, 0.0, 0.55], 1e-15));
    for robot in &robots {
        assert!(links(robot).iter().all(|link| ["ok", "none"].contains(&link["verdict"].as_str().unwrap())));
        assert!(robot["repair"].is_null());
    }
    // 3.6 kg, 0.24 × 0.20 × 0.10 m: the longest edge is along the axis of the least moment.
    let base = &link(urdf, "base")["inertial"]["box"];
    assert!(is_near(&numbers::<3>(&base["size"]), &[0.24, 0.20, 0.10], 1e-12), "{base}");
}

#[test]
fn a_bad_arm_has_its_verdicts_its_places_and_its_repair_and_is_not_written_to() {
    let path = repository("examples/robots/bad-arm.urdf");
    let before = std::fs::read_to_string(&path).unwrap();
    let robot = example("bad-arm.urdf");
    let verdicts: Vec<_> =
        links(&robot).iter().map(|l| (l["name"].as_str().unwrap(), l["verdict"].as_str().unwrap())).collect();
    let expected = [
        ("base", "suspect"),
        ("upper_arm", "impossible"),
        ("forearm", "impossible"),
        ("camera", "impossible"),
        ("hand", "suspect"),
        ("tool", "none"),
    ];
    assert_eq!(verdicts, expected);
    assert!(link(&robot, "upper_arm")["inertial"].is_null(), "its mass is \"1,2\"");
    let forearm = &link(&robot, "forearm")["inertial"];
    assert_eq!((forearm["mass"].as_f64(), forearm["box"].is_null()), (Some(0.9), true));
    let lines: Vec<&str> = before.lines().collect();
    for finding in robot["findings"].as_array().unwrap() {
        let (line, column) = (finding["line"].as_u64().unwrap(), finding["column"].as_u64().unwrap());
        assert!(line >= 1 && column >= 1 && lines.len() as u64 >= line, "{finding}");
        if let Some(k) = finding["link"].as_u64() {
            assert!(k < 6, "{finding}");
        }
    }
    let number = robot["findings"].as_array().unwrap().iter().find(|finding| finding["link"] == 1).unwrap();
    assert!(lines[number["line"].as_u64().unwrap() as usize - 1].contains("1,2"), "{number}");
    // The fix is the text with its changed lines only.
    let repair = &robot["repair"];
    let mut repaired: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
    let changes = repair["changes"].as_array().unwrap();
    assert!(changes.len() >= 3, "{changes:?}");
    for change in changes {
        let line = change["line"].as_u64().unwrap() as usize - 1;
        assert_eq!(repaired[line], change["before"].as_str().unwrap());
        repaired[line] = change["after"].as_str().unwrap().to_owned();
        assert_ne!(repaired[line], lines[line]);
    }
    assert_eq!(repaired.join("\n") + "\n", repair["text"].as_str().unwrap());
    assert!(repair["text"].as_str().unwrap().contains("mass value=\"1.2\""));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), before);
}

#[test]
fn the_equivalent_box_has_the_tensor() {
    // Box of edges a, b, c, rotated by roll, pitch and yaw, with its tensor computed from the
    // definition.
    let (mass, edges, angles) = (2.7, [0.13, 0.31, 0.22_f64], [0.4, -0.7, 1.1_f64]);
    let squares = edges.map(|edge| edge * edge);
    let moments = [1, 2, 0].map(|k| mass / 12.0 * (squares[k] + squares[(k + 1) % 3]));
    let [roll, pitch, yaw] = angles;
    let text = format!(
        "<robot name=\"r\"><link name=\"a\"><inertial><origin xyz=\"0.3 -0.2 0.7\" rpy=\"{roll} {pitch} {yaw}\"/>\
         <mass value=\"{mass}\"/><inertia ixx=\"{}\" ixy=\"0\" ixz=\"0\" iyy=\"{}\" iyz=\"0\" izz=\"{}\"/></inertial></link></robot>",
        moments[0], moments[1], moments[2]
    );
    // R = Rz Ry Rx, and I = R diag R^T.
    let about = |axis: usize, angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut matrix = [[0.0; 3]; 3];
        (matrix[axis][axis], matrix[j][j], matrix[k][k]) = (1.0, cos, cos);
        (matrix[j][k], matrix[k][j]) = (-sin, sin);
        matrix
    };
    let product = |a: [[f64; 3]; 3], b: [[f64; 3]; 3]| -> [[f64; 3]; 3] {
        std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
    };
    let tensor = |rotation: [[f64; 3]; 3], moments: [f64; 3]| -> [[f64; 3]; 3] {
        std::array::from_fn(|i| {
            std::array::from_fn(|j| (0..3).map(|k| moments[k] * rotation[i][k] * rotation[j][k]).sum())
        })
    };
    let expected = tensor(product(about(2, yaw), product(about(1, pitch), about(0, roll))), moments);
    let page = Page::open(&[]);
    let robot = page.dropped(1, "a.urdf", text.as_bytes())["robot"].clone();
    let inertial = &link(&robot, "a")["inertial"];
    assert_eq!(numbers::<3>(&inertial["center"]), [0.3, -0.2, 0.7]);
    let found = &inertial["box"];
    let size = numbers::<3>(&found["size"]).map(|edge| edge * edge);
    let moments = [1, 2, 0].map(|k| mass / 12.0 * (size[k] + size[(k + 1) % 3]));
    let quaternion = numbers::<4>(&found["quaternion"]);
    let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|e| turned(quaternion, e));
    let rotation: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|k| columns[k][i]));
    let rebuilt = tensor(rotation, moments);
    assert!(is_near(rebuilt.as_flattened(), expected.as_flattened(), 1e-15), "{rebuilt:?} {expected:?}");
}

#[test]
fn links_that_hang_on_nothing_or_on_themselves_stand_at_the_origin_and_say_so() {
    let joint = |name: &str, parent: &str, child: &str, at: &str| {
        format!(
            "<joint name=\"{name}\" type=\"fixed\"><parent link=\"{parent}\"/><child link=\"{child}\"/><origin xyz=\"{at}\"/></joint>"
        )
    };
    let mut text = "<robot name=\"r\">".to_owned();
    for name in ["root", "a", "b", "c", "lost", "far", "farther"] {
        text += &format!("<link name=\"{name}\"/>");
    }
    text += &joint("1", "c", "a", "1 0 0");
    text += &joint("2", "a", "b", "1 0 0");
    text += &joint("3", "b", "c", "1 0 0");
    text += &joint("4", "nowhere", "lost", "5 0 0");
    text += &joint("5", "root", "far", "1e308 0 0");
    text += &joint("6", "far", "farther", "1e308 0 0");
    text += "</robot>";
    let page = Page::open(&[]);
    let robot = page.dropped(1, "round.urdf", text.as_bytes())["robot"].clone();
    let noted: Vec<&str> = robot["findings"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|finding| finding["code"] == "page.unplaced")
        .map(|finding| links(&robot)[finding["link"].as_u64().unwrap() as usize]["name"].as_str().unwrap())
        .collect();
    assert_eq!(noted, ["a", "b", "c", "lost", "farther"]);
    for name in noted {
        assert_eq!(numbers::<3>(&link(&robot, name)["position"]), [0.0; 3]);
    }
    // A chain of many links is not processed recursively.
    let count = 20_000;
    let mut chain = "<robot name=\"chain\"><link name=\"0\"/>".to_owned();
    for k in 1..count {
        chain += &format!("<link name=\"{k}\"/>");
        chain += &joint(&format!("j{k}"), &(k - 1).to_string(), &k.to_string(), "0 0 0.001");
    }
    chain += "</robot>";
    let robot = page.dropped(1, "chain.urdf", chain.as_bytes())["robot"].clone();
    let top = numbers::<3>(&link(&robot, "19999")["position"]);
    assert!((top[2] - 19.999).abs() < 1e-9, "{top:?}");
}

#[test]
fn a_dropped_robot_reads_no_file_outside_its_set() {
    // A valid mesh outside the folder, which would be measured if it were read.
    let folder = Folder::new("robot");
    let bracket = std::fs::read(repository("examples/bracket.stl")).unwrap();
    let secret = folder.file("secret.stl", &bracket).to_string_lossy().into_owned();
    let page = Page::open(&[]);
    page.drop_file(3, "meshes/own.stl", &bracket);
    page.drop_file(4, "other.stl", &bracket);
    // A package file does not make its surroundings a root folder.
    let package = b"<package><name>x</name></package>";
    page.drop_file(3, "urdf/package.xml", package);
    let robot = |uri: &str| {
        let text = format!(
            "<robot name=\"r\"><link name=\"a\"><inertial><mass value=\"1.3\"/>\
             <inertia ixx=\"1.1\" ixy=\"0\" ixz=\"0\" iyy=\"1.2\" iyz=\"0\" izz=\"1.3\"/></inertial>\
             <visual><geometry><mesh filename=\"{uri}\" scale=\"0.001 0.001 0.001\"/></geometry></visual></link></robot>"
        );
        let robot = page.dropped(3, "urdf/r.urdf", text.as_bytes())["robot"].clone();
        let findings = robot["findings"].as_array().unwrap().clone();
        let unread = findings.iter().find(|finding| finding["code"] == "geometry.unreadable");
        unread.map(|finding| finding["message"].as_str().unwrap().to_owned())
    };
    assert_eq!(robot("../meshes/own.stl"), None);
    assert_eq!(robot("package://x/../meshes/own.stl"), None);
    for uri in [
        "../../etc/passwd".to_owned(),
        "../../../../../../../../etc/passwd".to_owned(),
        "/etc/passwd".to_owned(),
        "file:///etc/passwd".to_owned(),
        "package://../../etc/passwd".to_owned(),
        "package://x/../../../../../../etc/passwd".to_owned(),
        "model://x/../../../../../../etc/passwd".to_owned(),
        "http://127.0.0.1/secret.stl".to_owned(),
        "../../4/other.stl".to_owned(),
        "package://4/other.stl".to_owned(),
        "package://../4/other.stl".to_owned(),
        secret.clone(),
        format!("file://{secret}"),
        format!("package://x/../../../../../../../../..{secret}"),
        format!("../../../../../../../../..{secret}"),
    ] {
        let why = robot(&uri).unwrap_or_else(|| panic!("{uri} was read"));
        let is_refused = ["outside the roots", "no root contains it", "does not exist", "are not opened"];
        assert!(is_refused.iter().any(|words| why.contains(words)), "{uri}: {why}");
    }
}
