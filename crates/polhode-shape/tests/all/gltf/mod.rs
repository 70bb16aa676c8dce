//! glTF: one solid in every representation, and broken files.

mod broken;
mod file;

use polhode::body::Severity;
use polhode::body::mesh::ClosedMesh;
use serde_json::json;

use file::{F32, FACES, File, I8, I16, POINTS, U8, U16, U32, corners, expected};

#[test]
fn the_plain_solid() {
    let contents = File::plain().read().unwrap();
    assert_eq!((contents.unit, contents.name.as_str(), contents.findings.len()), (Some(1.0), "bench", 0));
    assert_eq!((contents.parts.len(), contents.parts[0].name.as_str()), (1, "stone"));
    assert_eq!(corners(&contents), expected());
    assert!(!ClosedMesh::from_triangles(expected()).unwrap().inverted());
}

#[test]
fn every_way_to_join_corners_gives_the_same_solid() {
    let primitives = |list: &[(u64, &[u8])]| {
        let mut file = File::new();
        let positions = file.positions();
        for &(mode, order) in list {
            let indices = file.indices(order.iter().copied());
            file.primitive(json!({"attributes": {"POSITION": positions}, "indices": indices, "mode": mode}));
        }
        file.read().unwrap()
    };
    let strips: [(u64, &[u8]); 4] =
        [(5, &[4, 0, 1, 5]), (5, &[4, 1, 2, 5]), (5, &[4, 2, 3, 5]), (5, &[4, 3, 0, 5])];
    let fans: [(u64, &[u8]); 2] = [(6, &[4, 0, 1, 2, 3, 0]), (6, &[5, 0, 3, 2, 1, 0])];
    let mixed: [(u64, &[u8]); 3] = [fans[0], (4, &[5, 1, 0, 5, 2, 1]), (5, &[3, 2, 5, 5, 5, 0, 3])];
    assert_eq!(corners(&primitives(&strips)), expected());
    assert_eq!(corners(&primitives(&fans)), expected());
    // The last strip reverses at a corner: two of its five triangles are degenerate.
    let flat = |t: &[[f64; 3]; 3]| t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    let mut joined = corners(&primitives(&mixed));
    joined.retain(|triangle| !flat(triangle));
    assert_eq!(joined, expected());
    // Primitives that share positions share vertices.
    assert_eq!(primitives(&strips).parts[0].mesh.coordinates().len(), 6);

    let soup = File::new();
    let mut soup = soup;
    let bytes: Vec<u8> =
        FACES.iter().flatten().flat_map(|&k| POINTS[usize::from(k)]).map(|c| c as u8).collect();
    let view = soup.view(&bytes);
    let positions = soup.accessor(view, I8, "VEC3", 24);
    soup.primitive(json!({"attributes": {"POSITION": positions}}));
    assert_eq!(corners(&soup.read().unwrap()), expected());
}

#[test]
fn indices_of_every_width() {
    for (component, width) in [(U8, 1), (U16, 2), (U32, 4)] {
        let mut file = File::new();
        let positions = file.positions();
        let bytes: Vec<u8> = FACES
            .iter()
            .flatten()
            .flat_map(|&k| u32::from(k).to_le_bytes().into_iter().take(width))
            .collect();
        let view = file.view(&bytes);
        let indices = file.accessor(view, component, "SCALAR", 24);
        file.primitive(json!({"attributes": {"POSITION": positions}, "indices": indices}));
        assert_eq!(corners(&file.read().unwrap()), expected());
    }
}

#[test]
fn quantised_positions() {
    // Integers without normalization: exact.
    let wide: Vec<u8> = POINTS.iter().flatten().flat_map(|&c| i16::from(c).to_le_bytes()).collect();
    let file = File::with_positions(|file| {
        let view = file.view(&wide);
        file.accessor(view, I16, "VEC3", 6)
    });
    assert_eq!(corners(&file.read().unwrap()), expected());
    // Normalized: 32767 means 1, and −32768 is limited to −1. Signs and sizes are preserved.
    for (component, one) in [(I8, 127.0), (U8, 255.0), (I16, 32767.0), (U16, 65535.0)] {
        let signed = component == I8 || component == I16;
        let least = match component {
            I8 => -128,
            I16 => -32768,
            _ => 0,
        };
        let points = [[one as i32, 0, 0], [17, 5, 99], [least, 31, 64]];
        let width = if component == I8 || component == U8 { 1 } else { 2 };
        let bytes: Vec<u8> =
            points.iter().flatten().flat_map(|c| c.to_le_bytes().into_iter().take(width)).collect();
        let mut file = File::new();
        let view = file.view(&bytes);
        let positions = file.accessor(view, component, "VEC3", 3);
        file.doc["accessors"][positions]["normalized"] = true.into();
        file.doc["nodes"] = json!([{"mesh": 0}]);
        file.primitive(json!({"attributes": {"POSITION": positions}}));
        let least = if signed { -1.0 } else { 0.0 };
        let expected =
            [[1.0, 0.0, 0.0], [17.0 / one, 5.0 / one, 99.0 / one], [least, 31.0 / one, 64.0 / one]];
        assert_eq!(file.read().unwrap().parts[0].mesh.coordinates(), expected);
    }
}

#[test]
fn interleaved_and_sparse_positions() {
    let interleaved: Vec<u8> = POINTS
        .iter()
        .flat_map(|p| [&[0xee; 4], p.map(|c| f32::from(c).to_le_bytes()).as_flattened(), &[0xff; 4]].concat())
        .collect();
    let file = File::with_positions(|file| {
        let view = file.view(&interleaved);
        // The last element ends before the stride does.
        file.doc["bufferViews"][view]["byteStride"] = 20.into();
        file.doc["bufferViews"][view]["byteLength"] = (interleaved.len() - 4).into();
        let positions = file.accessor(view, F32, "VEC3", 6);
        file.doc["accessors"][positions]["byteOffset"] = 4.into();
        positions
    });
    assert_eq!(corners(&file.read().unwrap()), expected());

    let floats = |points: &[[i8; 3]]| -> Vec<u8> {
        points.iter().flatten().flat_map(|&c| f32::from(c).to_le_bytes()).collect()
    };
    for without_base in [false, true] {
        let file = File::with_positions(|file| {
            let mut wrong = POINTS;
            (wrong[1], wrong[4]) = ([1, 2, 3], [4, 5, 6]);
            let base = file.view(&floats(&wrong));
            let places: &[u8] = if without_base { &[0, 1, 2, 3, 4, 5] } else { &[1, 4] };
            let values: Vec<[i8; 3]> = places.iter().map(|&k| POINTS[usize::from(k)]).collect();
            let (at, with) = (file.view(places), file.view(&floats(&values)));
            let positions = file.accessor(base, F32, "VEC3", 6);
            let accessor = &mut file.doc["accessors"][positions];
            accessor["sparse"] = json!({
                "count": places.len(),
                "indices": {"bufferView": at, "componentType": U8}, "values": {"bufferView": with}
            });
            if without_base {
                accessor.as_object_mut().unwrap().remove("bufferView");
            }
            positions
        });
        assert_eq!(corners(&file.read().unwrap()), expected());
    }
}

#[test]
fn a_matrix_and_the_parts_of_it_place_alike() {
    let s = 0.03125;
    // Columns of the matrix: x is mapped to y, y to z, z to x.
    let matrix = json!([0, s, 0, 0, 0, 0, s, 0, s, 0, 0, 0, 0.5, -3, 7.25, 1]);
    let file = File::plain().with(|doc| doc["nodes"] = json!([{"mesh": 0, "matrix": matrix}]));
    let contents = file.read().unwrap();
    assert_eq!((corners(&contents), contents.parts[0].name.as_str()), (expected(), "octahedron"));
}

#[test]
fn instances_and_hierarchies() {
    let file = File::plain().with(|doc| {
        doc["nodes"] = json!([
            {"name": "low", "mesh": 0, "scale": [2, 4, 8], "translation": [1, 1, 1], "children": [1]},
            {"name": "high", "mesh": 0, "translation": [10, 20, 30]},
            {"name": "elsewhere", "mesh": 0}
        ]);
    });
    let contents = file.read().unwrap();
    let names: Vec<_> = contents.parts.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["low", "high"]);
    let [x, y, z] = POINTS[3].map(f64::from);
    assert_eq!(contents.parts[0].mesh.coordinates()[3], [2.0 * x + 1.0, 4.0 * y + 1.0, 8.0 * z + 1.0]);
    assert_eq!(contents.parts[1].mesh.coordinates()[3], [2.0 * x + 21.0, 4.0 * y + 81.0, 8.0 * z + 241.0]);
    assert_eq!(contents.findings[0].code, "mesh.other_scene");

    // Without scenes, all roots are read.
    let all = file.with(|doc| {
        doc.as_object_mut().unwrap().remove("scene");
        doc.as_object_mut().unwrap().remove("scenes");
    });
    assert_eq!(all.read().unwrap().parts.len(), 3);
}

#[test]
fn instancing_on_the_gpu() {
    let mut file = File::plain();
    let floats = |list: &[f32]| -> Vec<u8> { list.iter().flat_map(|x| x.to_le_bytes()).collect() };
    let (a, b) =
        (file.view(&floats(&[1.0, 2.0, 3.0, -4.0, 5.0, 6.0])), file.view(&[0, 0, 0, 127, 0, 0, 127, 0]));
    let translations = file.accessor(a, F32, "VEC3", 2);
    let rotations = file.accessor(b, I8, "VEC4", 2);
    file.doc["accessors"][rotations]["normalized"] = true.into();
    file.doc["extensionsRequired"] = json!(["EXT_mesh_gpu_instancing"]);
    file.doc["nodes"] = json!([{"mesh": 0, "scale": [2, 2, 2], "extensions": {"EXT_mesh_gpu_instancing": {
        "attributes": {"TRANSLATION": translations, "ROTATION": rotations}}}}]);
    let contents = file.read().unwrap();
    let [x, y, z] = POINTS[2].map(f64::from);
    assert_eq!(contents.parts.len(), 2);
    assert_eq!(contents.parts[0].mesh.coordinates()[2], [2.0 * (x + 1.0), 2.0 * (y + 2.0), 2.0 * (z + 3.0)]);
    // A rotation by 180° about z.
    assert_eq!(
        contents.parts[1].mesh.coordinates()[2],
        [2.0 * (-x - 4.0), 2.0 * (-y + 5.0), 2.0 * (z + 6.0)]
    );

    file.doc["accessors"][rotations]["count"] = 1.into();
    assert_eq!(
        file.error(),
        "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes: 2 instances are declared, but the file has 1"
    );
}

#[test]
fn a_mirror_keeps_the_outside_outside() {
    for scale in [[-1.0, 2.0, 3.0], [1.0, -2.0, 3.0], [-1.0, -2.0, -3.0]] {
        let file = File::plain().with(|doc| doc["nodes"] = json!([{"mesh": 0, "scale": scale}]));
        let solid = ClosedMesh::from_triangles(corners(&file.read().unwrap())).unwrap();
        assert!(!solid.inverted());
    }
}

#[test]
fn what_is_left_out_is_found() {
    let mut file = File::plain();
    file.doc["nodes"] = json!([{"mesh": 0, "skin": 0, "translation": [1, 2, 3]}]);
    file.doc["meshes"][0]["primitives"][0]["targets"] = json!([{"POSITION": 0}]);
    file.primitive(json!({"attributes": {"POSITION": 0}, "mode": 1}));
    file.primitive(json!({"attributes": {"POSITION": 0}, "mode": 0}));
    let contents = file.read().unwrap();
    let found: Vec<_> =
        contents.findings.iter().map(|f| (f.code, f.severity, f.place.as_deref().unwrap())).collect();
    let primitive = |k: usize| ["meshes[0].primitives[0]", "meshes[0].primitives[1]"][k];
    assert_eq!(
        found,
        [
            ("mesh.morph_targets", Severity::Info, primitive(0)),
            ("mesh.not_a_surface", Severity::Info, primitive(1)),
            ("mesh.skinned", Severity::Warning, "nodes[0]"),
        ]
    );
    assert!(contents.findings[1].message.starts_with("2 primitives consist of points or lines"));
    // The bind pose, without the transformation of its node.
    assert_eq!(contents.parts[0].mesh.coordinates()[0], POINTS[0].map(f64::from));

    let file = File::plain().with(|doc| doc["nodes"][1]["rotation"] = json!([0.5, 0.5, 0.5, 0.501]));
    assert_eq!(file.read().unwrap().findings[0].code, "mesh.rotation_normalised");
}

#[test]
fn weights_of_morph_targets_are_refused_unless_they_are_zero() {
    let with = |(holder, k): (&str, usize), weights: &[f64]| {
        File::plain().with(|doc| {
            doc["meshes"][0]["primitives"][0]["targets"] = json!([{"POSITION": 0}, {"POSITION": 0}]);
            doc[holder][k]["weights"] = json!(weights);
        })
    };
    for holder in [("meshes", 0), ("nodes", 1)] {
        assert!(with(holder, &[0.0, 0.0]).read().is_ok());
        let error = with(holder, &[0.0, 0.25]).error();
        assert!(
            error.starts_with(&format!(
                "{}[{}].weights[1]: polhode does not read morph targets",
                holder.0, holder.1
            )),
            "{error}"
        );
    }
}
