//! Meshes that do not bound a solid: each defect is marked at its place.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use polhode_web::RefusalKind;
use serde_json::Value;

use crate::page::{Folder, Page, f32s, repository, u32s};

pub(crate) type Point = [f32; 3];

/// Returns a binary STL file with these triangles.
pub(crate) fn stl(triangles: &[[Point; 3]]) -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes.extend(u32::try_from(triangles.len()).unwrap().to_le_bytes());
    for triangle in triangles {
        bytes.extend([0; 12]);
        bytes.extend(triangle.iter().flatten().flat_map(|x| x.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

/// Returns the triangles of a binary STL file.
fn triangles(bytes: &[u8]) -> Vec<[Point; 3]> {
    let number =
        |record: &[u8], k: usize| f32::from_le_bytes(record[12 + 4 * k..16 + 4 * k].try_into().unwrap());
    let of = |record: &[u8]| -> [Point; 3] {
        std::array::from_fn(|i| std::array::from_fn(|k| number(record, 3 * i + k)))
    };
    bytes[84..].chunks_exact(50).map(of).collect()
}

fn points(value: &Value) -> Vec<Point> {
    f32s(value).chunks(3).map(|p| p.try_into().unwrap()).collect()
}

fn bits(p: Point) -> [u32; 3] {
    p.map(f32::to_bits)
}

/// Returns the triangles as sets of corners, independent of the order of corners.
fn set(triangles: impl IntoIterator<Item = [Point; 3]>) -> BTreeSet<[[u32; 3]; 3]> {
    let sorted = |triangle: [Point; 3]| {
        let mut corners = triangle.map(bits);
        corners.sort_unstable();
        corners
    };
    triangles.into_iter().map(sorted).collect()
}

fn faces(finding: &Value) -> Vec<[Point; 3]> {
    points(&finding["faces"]).chunks(3).map(|corners| corners.try_into().unwrap()).collect()
}

/// Returns the only finding with this code.
fn finding<'a>(mesh: &'a Value, code: &str) -> &'a Value {
    let found: Vec<_> =
        mesh["findings"].as_array().unwrap().iter().filter(|finding| finding["code"] == code).collect();
    assert_eq!(found.len(), 1, "{code}: {}", mesh["findings"]);
    found[0]
}

fn codes(mesh: &Value) -> Vec<&str> {
    mesh["findings"].as_array().unwrap().iter().map(|finding| finding["code"].as_str().unwrap()).collect()
}

/// Converts from millimetres, the unit of the file, to metres.
fn metres(p: Point) -> Point {
    p.map(|x| (f64::from(x) * 0.001) as f32 + 0.0)
}

#[test]
fn a_triangle_taken_out_leaves_its_three_edges_open() {
    let whole = triangles(&std::fs::read(repository("examples/bracket.stl")).unwrap());
    let page = Page::open(&[]);
    for removed in [0, whole.len() / 3, whole.len() - 1] {
        let mut torn = whole.clone();
        let gone = torn.remove(removed).map(metres);
        let content = page.dropped(7, &format!("torn {removed}.stl"), &stl(&torn));
        assert_eq!(content["kind"], "mesh");
        let mesh = &content["mesh"];
        assert_eq!((&mesh["name"], &mesh["of"]), (&format!("torn {removed}.stl").into(), &torn.len().into()));
        assert_eq!(codes(mesh), ["mesh.open", "mesh.unit"]);
        let open = finding(mesh, "mesh.open");
        assert_eq!(open["severity"], "error");
        let hint =
            "close the mesh in the tool that made it; vertices that only nearly coincide count as different";
        assert_eq!(open["hint"], hint);
        let message = open["message"].as_str().unwrap();
        assert!(
            message.starts_with("the mesh is open, so it has no volume: 3 edges in 1 loop belong"),
            "{message}"
        );
        let edge = |a: Point, b: Point| BTreeSet::from([bits(a), bits(b)]);
        let marked: BTreeSet<_> =
            points(&open["edges"]).chunks(2).map(|ends| edge(ends[0], ends[1])).collect();
        let expected = BTreeSet::from([0, 1, 2].map(|k| edge(gone[k], gone[(k + 1) % 3])));
        assert_eq!(marked, expected);
        assert!(faces(open).is_empty());
        // The page shows the remaining triangles, with each vertex once.
        let vertices: Vec<Point> = points(&mesh["vertices"]);
        assert_eq!(vertices.iter().map(|&p| bits(p)).collect::<BTreeSet<_>>().len(), vertices.len());
        let corner = |k: u32| vertices[k as usize];
        let shown = u32s(&mesh["triangles"]);
        let shown = shown.chunks(3).map(|c| [corner(c[0]), corner(c[1]), corner(c[2])]);
        assert_eq!(set(shown), set(torn.iter().map(|t| t.map(metres))));
    }
}

/// Returns the twelve triangles of a box between two corners, normals outward.
fn cuboid(low: Point, high: Point) -> Vec<[Point; 3]> {
    let corner =
        |k: usize| -> Point { std::array::from_fn(|i| if k >> i & 1 == 1 { high[i] } else { low[i] }) };
    let squares = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    squares.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).map(|t| t.map(corner)).collect()
}

#[test]
fn of_boxes_that_cross_the_faces_on_the_crossing_are_marked() {
    let boxes = [[[0.1, 0.2, 0.3], [1.3, 1.1, 1.5]], [[0.83, 0.57, 0.64], [2.1, 0.95, 1.17]]];
    let [a, b] = boxes.map(|[low, high]| cuboid(low, high));
    // A triangle intersects a box if some of its points are inside and others outside.
    let crosses = |triangle: &[Point; 3], [low, high]: [Point; 2]| {
        let n = 150;
        let grid = (0..=n).flat_map(|i| (0..=n - i).map(move |j| [i, j, n - i - j]));
        let is_inside = |weights: [i32; 3]| {
            (0..3).all(|k| {
                let x: f32 =
                    weights.iter().zip(triangle).map(|(&w, corner)| w as f32 / n as f32 * corner[k]).sum();
                low[k] < x && x < high[k]
            })
        };
        let inside = grid.clone().filter(|&weights| is_inside(weights)).count();
        inside > 0 && inside < grid.count()
    };
    let expected: Vec<[Point; 3]> = a
        .iter()
        .filter(|t| crosses(t, boxes[1]))
        .chain(b.iter().filter(|t| crosses(t, boxes[0])))
        .copied()
        .collect();
    assert!(expected.len() > 8 && expected.len() < 20, "{}", expected.len());
    let page = Page::open(&[]);
    let content = page.dropped(1, "crossed.stl", &stl(&[a, b].concat()));
    let crossing = finding(&content["mesh"], "mesh.parts_cross");
    assert_eq!(set(faces(crossing)), set(expected));
    assert!(f32s(&crossing["edges"]).is_empty());
}

#[test]
fn every_kind_of_fault_is_found_at_once_and_marked() {
    let mut soup = cuboid([0.0, 0.1, 0.2], [1.0, 1.2, 1.3]);
    let twice = soup[5];
    soup.push(twice);
    // A second box with one side wound inward, and a third one that lacks a triangle.
    let mut second = cuboid([3.0, 0.1, 0.2], [4.0, 1.2, 1.3]);
    second[2].swap(0, 1);
    second[3].swap(0, 1);
    let turned = [second[2], second[3]];
    let mut third = cuboid([6.0, 0.1, 0.2], [7.0, 1.2, 1.3]);
    let lost = third.pop().unwrap();
    let inner = cuboid([3.2, 0.4, 0.5], [3.6, 0.8, 0.9]);
    soup.extend(second.iter().chain(&third).chain(&inner));
    soup.push([lost[0], lost[0], lost[1]]);
    let page = Page::open(&[]);
    let content = page.dropped(1, "all.stl", &stl(&soup));
    let mesh = &content["mesh"];
    assert_eq!(set(faces(finding(mesh, "mesh.duplicate"))), set([twice.map(metres)]));
    assert_eq!(points(&finding(mesh, "mesh.open")["edges"]).len(), 6);
    assert_eq!(set(faces(finding(mesh, "mesh.flipped"))), set(turned.map(|t| t.map(metres))));
    let hint = "make the normals consistent in the tool that made the mesh";
    assert_eq!(finding(mesh, "mesh.flipped")["hint"], hint);
    assert_eq!(finding(mesh, "mesh.components")["hint"], Value::Null);
    assert_eq!(set(faces(finding(mesh, "mesh.nested_solid"))), set(inner.iter().map(|t| t.map(metres))));
    assert_eq!(points(&finding(mesh, "mesh.degenerate")["edges"]), [metres(lost[0]), metres(lost[1])]);
    let severities: Vec<_> =
        mesh["findings"].as_array().unwrap().iter().map(|f| f["severity"].as_str().unwrap()).collect();
    assert!(severities.is_sorted_by_key(|s| ["error", "warning", "info"].iter().position(|t| t == s)));
}

#[test]
fn groups_of_one_surface_are_taken_together() {
    let mut soup = cuboid([0.0, 0.1, 0.2], [1.0, 1.2, 1.3]);
    soup.pop();
    let mut obj = String::new();
    for (k, triangle) in soup.iter().enumerate() {
        if k % 6 == 0 {
            let _ = writeln!(obj, "g side{k}");
        }
        triangle.iter().for_each(|[x, y, z]| {
            let _ = writeln!(obj, "v {x} {y} {z}");
        });
        obj += "f -3 -2 -1\n";
    }
    let page = Page::open(&[]);
    let content = page.dropped(1, "box.obj", obj.as_bytes());
    assert_eq!(points(&finding(&content["mesh"], "mesh.open")["edges"]).len(), 6);
    assert_eq!(codes(&content["mesh"]), ["mesh.open", "mesh.joined", "mesh.unit"]);
}

#[test]
fn bodies_of_one_file_that_cross_are_no_body_and_the_part_is_named() {
    let boxes = [cuboid([0.1, 0.2, 0.3], [1.3, 1.1, 1.5]), cuboid([0.83, 0.57, 0.64], [2.1, 0.95, 1.17])];
    let mut obj = String::new();
    for (name, triangles) in ["housing", "lid"].iter().zip(&boxes) {
        let _ = writeln!(obj, "g {name}");
        for triangle in triangles {
            triangle.iter().for_each(|[x, y, z]| {
                let _ = writeln!(obj, "v {x} {y} {z}");
            });
            obj += "f -3 -2 -1\n";
        }
    }
    let page = Page::open(&[]);
    let mesh = &page.dropped(1, "two.obj", obj.as_bytes())["mesh"];
    assert_eq!(codes(mesh), ["mesh.parts_cross", "mesh.components", "mesh.joined", "mesh.unit"]);
    let message = finding(mesh, "mesh.parts_cross")["message"].as_str().unwrap();
    assert!(message.ends_with("; that is in part \"housing\""), "{message}");
}

#[test]
fn many_triangles_are_shown_and_no_more_is_marked_than_is_said() {
    // A wavy sheet of 200,000 triangles; all edges at its rim are open.
    let (m, n) = (20_000, 5);
    let at = |i: i32, j: i32| [i as f32 * 1e-4, j as f32 * 1e-3, (0.01 * i as f32).sin() * 0.01];
    let quads = (0..m).flat_map(|i| (0..n).map(move |j| (i, j)));
    let sheet: Vec<[Point; 3]> = quads
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    assert_eq!(sheet.len(), 200_000);
    let page = Page::open(&[]);
    let content = page.dropped(1, "sheet.stl", &stl(&sheet));
    let mesh = &content["mesh"];
    assert_eq!((mesh["of"].as_u64(), u32s(&mesh["triangles"]).len()), (Some(200_000), 600_000));
    let open = finding(mesh, "mesh.open");
    assert_eq!(points(&open["edges"]).len(), 40_000);
    let message = open["message"].as_str().unwrap();
    assert!(message.ends_with("; 20000 edges of 40010 are marked"), "{message}");
}

#[test]
fn what_has_no_triangles_or_no_numbers_is_refused_and_what_f32_does_not_hold_is_not_shown() {
    let page = Page::open(&[]);
    let not_finite = stl(&[[[0.0; 3], [1.0, 0.0, f32::NAN], [0.0, 1.0, 0.0]]]);
    for (name, bytes) in [
        ("empty.stl", Vec::new()),
        ("none.stl", stl(&[])),
        ("nan.stl", not_finite),
        ("text.obj", b"v 1 2\nf 1 2 3\n".to_vec()),
        ("short.ply", b"ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n".to_vec()),
        ("bad.gltf", b"{\"asset\":{\"version\":\"2.0\"},\"meshes\":7}".to_vec()),
        ("bad.3mf", b"PK\x03\x04".to_vec()),
    ] {
        page.drop_file(1, name, &bytes);
        let refused = page.open_dropped(1, name, &|| true).unwrap_err();
        assert_eq!(refused.kind, RefusalKind::Unprocessable, "{name}: {}", refused.message);
    }
    let far = "v 0 0 0\nv 1e200 0 0\nv 0 1e200 0\nf 1 2 3\n";
    let mesh = &page.dropped(2, "far.obj", far.as_bytes())["mesh"];
    assert!(codes(mesh).contains(&"mesh.not_shown") && f32s(&mesh["vertices"]).is_empty());
    assert!(f32s(&finding(mesh, "mesh.open")["edges"]).iter().all(|x| x.is_finite()));
}

#[test]
fn a_file_that_the_user_names_is_inspected_as_it_is_now() {
    let folder = Folder::new("now");
    let whole = cuboid([0.0, 0.1, 0.2], [1.0, 1.2, 1.3]);
    let path = folder.file("a.stl", &stl(&whole[1..]));
    let page = Page::open(std::slice::from_ref(&path));
    let stamp = || page.documents()[0]["stamp"].clone();
    let before = stamp();
    assert_eq!(points(&finding(&page.document(&0.into())["mesh"], "mesh.open")["edges"]).len(), 6);
    folder.file("a.stl", &stl(&whole[2..]));
    assert_ne!(stamp(), before);
    assert_eq!(points(&finding(&page.document(&0.into())["mesh"], "mesh.open")["edges"]).len(), 8);
    folder.file("a.stl", &stl(&whole));
    let mended = &page.document(&0.into())["mesh"];
    assert_eq!(codes(mended), ["mesh.unit"]);
    assert_eq!((u32s(&mended["triangles"]).len(), &mended["of"]), (36, &12.into()));
}

#[test]
fn a_mesh_that_turns_is_looked_at_too() {
    let folder = Folder::new("turns");
    let mut whole = cuboid([0.0, 0.1, 0.2], [1.0, 1.2, 1.3]);
    let turned = [whole[4], whole[7]];
    for k in [4, 7] {
        whole[k].swap(1, 2);
    }
    let page = Page::open(&[folder.file("turned.stl", &stl(&whole)), repository("examples/t-handle.toml")]);
    let documents = page.documents();
    assert_eq!(
        [&documents[0]["kind"], &documents[0]["mesh"]],
        [&Value::from("scenario"), &Value::from(true)]
    );
    assert_eq!(documents[1]["mesh"], false);
    let mesh = |id: u32| page.ask(&serde_json::json!({ "mesh": { "id": id } }));
    let answer = mesh(0);
    let inspected = &answer["mesh"];
    assert_eq!(set(faces(finding(inspected, "mesh.flipped"))), set(turned));
    assert_eq!((u32s(&inspected["triangles"]).len(), &inspected["of"]), (36, &12.into()));
    assert!(inspected["findings"].as_array().unwrap().iter().all(|finding| finding["severity"] != "error"));
    // A scenario is not served as a mesh.
    assert_eq!([1, 2].map(|id| mesh(id)["refusal"]["kind"].clone()), ["not_found"; 2]);
}

#[test]
fn what_was_not_written_to_is_looked_at_once() {
    let folder = Folder::new("once");
    let whole = cuboid([0.0, 0.1, 0.2], [1.0, 1.2, 1.3]);
    let torn = folder.file("torn.stl", &stl(&whole[1..]));
    let sound = folder.file("sound.stl", &stl(&whole));
    // A file replaced by other bytes with the same length and time is not read again.
    let replaced = |path: &std::path::Path| {
        let told = std::fs::metadata(path).unwrap();
        let noughts = vec![b'0'; told.len().try_into().unwrap()];
        std::fs::write(path, noughts).unwrap();
        let file = std::fs::File::options().write(true).open(path).unwrap();
        file.set_modified(told.modified().unwrap()).unwrap();
    };
    let page = Page::open(&[torn.clone(), sound.clone()]);
    [&torn, &sound].into_iter().for_each(|path| replaced(path));
    assert_eq!(points(&finding(&page.document(&0.into())["mesh"], "mesh.open")["edges"]).len(), 6);
    let motion = || {
        let text = page.document(&1.into())["text"].clone();
        page.motion(1, text.as_str().unwrap())
    };
    assert_eq!(motion()["errors"], serde_json::json!([]));
    std::fs::write(&sound, "solid nothing").unwrap();
    assert_eq!(motion()["motion"], Value::Null);
}

#[test]
fn a_dropped_mesh_reads_no_file_outside_its_set() {
    let folder = Folder::new("buffers");
    // Nine floats are one triangle.
    let numbers = [[0.0_f32, 0.0, 0.0], [1.0, 0.1, 0.0], [0.2, 1.0, 0.3]];
    let bytes: Vec<u8> = numbers.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    let secret = folder.file("secret.bin", &bytes);
    let page = Page::open(&[]);
    let gltf = |uri: &str| {
        serde_json::json!({
            "asset": { "version": "2.0" }, "scene": 0, "scenes": [{ "nodes": [0] }], "nodes": [{ "mesh": 0 }],
            "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
            "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0.3] }],
            "bufferViews": [{ "buffer": 0, "byteLength": 36 }],
            "buffers": [{ "byteLength": 36, "uri": uri }],
        })
        .to_string()
    };
    page.drop_file(1, "own.bin", &bytes);
    page.drop_file(2, "other.bin", &bytes);
    assert_eq!(page.dropped(1, "own.gltf", gltf("own.bin").as_bytes())["kind"], "mesh");
    let absolute = secret.to_string_lossy().into_owned();
    let up = format!("../../..{absolute}");
    for uri in [
        absolute.clone(),
        format!("file://{absolute}"),
        up.clone(),
        up.replace("..", "%2e%2e"),
        "../2/other.bin".to_owned(),
        "..\\2\\other.bin".to_owned(),
    ] {
        page.drop_file(1, "bad.gltf", gltf(&uri).as_bytes());
        let refused = page.open_dropped(1, "bad.gltf", &|| true).unwrap_err();
        assert_eq!(refused.kind, RefusalKind::Unprocessable, "{uri}: {}", refused.message);
    }
}
