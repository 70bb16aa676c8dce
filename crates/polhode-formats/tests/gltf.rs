//! glTF: one solid through every route, and every way to be broken.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::fs;
use std::path::{Path, PathBuf};

use polhode::{ClosedMesh, Severity};
use polhode_formats::ContentError;
use polhode_formats::mesh::{MeshContents, gltf};
use serde_json::{Value, json};

const I8: u64 = 5120;
const U8: u64 = 5121;
const I16: u64 = 5122;
const U16: u64 = 5123;
const U32: u64 = 5125;
const F32: u64 = 5126;

/// A crooked octahedron: its axes at 0 to 3 are a ring, 4 is above it and 5 below.
const POINTS: [[i8; 3]; 6] =
    [[90, 3, -7], [4, 70, -9], [-80, 5, 11], [-6, -60, 13], [8, -2, 50], [10, 12, -40]];
/// Its faces, seen from outside counter-clockwise.
const FACES: [[u8; 3]; 8] =
    [[4, 0, 1], [4, 1, 2], [4, 2, 3], [4, 3, 0], [5, 1, 0], [5, 2, 1], [5, 3, 2], [5, 0, 3]];

type Corners = Vec<[[f64; 3]; 3]>;

/// Every triangle from its least corner on, in order: the same for the same surface.
fn canonical(corners: impl IntoIterator<Item = [[f64; 3]; 3]>) -> Corners {
    let order = |a: &[f64; 3], b: &[f64; 3]| a.partial_cmp(b).unwrap();
    let mut all: Corners = corners.into_iter().collect();
    for triangle in &mut all {
        let least = (0..3).min_by(|&a, &b| order(&triangle[a], &triangle[b])).unwrap();
        triangle.rotate_left(least);
    }
    all.sort_by(|a, b| a.partial_cmp(b).unwrap());
    all
}

/// The solid where the nodes of [`File::nodes`] place it: 1/32 of its size, x → y → z → x, then moved.
fn expected() -> Corners {
    let placed = |k: u8| {
        let [x, y, z] = POINTS[usize::from(k)].map(|c| f64::from(c) / 32.0);
        [z + 0.5, x - 3.0, y + 7.25]
    };
    canonical(FACES.map(|face| face.map(placed)))
}

fn corners(contents: &MeshContents) -> Corners {
    canonical(contents.parts.iter().flat_map(|part| part.mesh.corners()))
}

/// A document under construction, and its one buffer.
#[derive(Clone)]
struct File {
    doc: Value,
    bytes: Vec<u8>,
}

impl File {
    /// Two nodes, one above the other, that place mesh 0.
    fn new() -> Self {
        let doc = json!({
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"name": "bench", "nodes": [0]}],
            "nodes": [
                {"translation": [0.5, -3, 7.25], "children": [1]},
                {"name": "stone", "mesh": 0, "rotation": [0.5, 0.5, 0.5, 0.5], "scale": [0.03125, 0.03125, 0.03125]}
            ],
            "meshes": [{"name": "octahedron", "primitives": []}],
            "accessors": [], "bufferViews": [], "buffers": [{"byteLength": 0}]
        });
        Self { doc, bytes: Vec::new() }
    }

    fn push(&mut self, list: &str, value: Value) -> usize {
        let list = self.doc[list].as_array_mut().unwrap();
        list.push(value);
        list.len() - 1
    }

    fn view(&mut self, bytes: &[u8]) -> usize {
        let value = json!({"buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len()});
        self.bytes.extend(bytes);
        self.doc["buffers"][0]["byteLength"] = self.bytes.len().into();
        self.push("bufferViews", value)
    }

    fn accessor(&mut self, view: usize, component: u64, kind: &str, count: usize) -> usize {
        let value = json!({"bufferView": view, "componentType": component, "type": kind, "count": count});
        self.push("accessors", value)
    }

    fn positions(&mut self) -> usize {
        let bytes: Vec<u8> = POINTS.iter().flatten().flat_map(|&c| f32::from(c).to_le_bytes()).collect();
        let view = self.view(&bytes);
        self.accessor(view, F32, "VEC3", 6)
    }

    fn indices(&mut self, indices: impl IntoIterator<Item = u8>) -> usize {
        let bytes: Vec<u8> = indices.into_iter().collect();
        let view = self.view(&bytes);
        self.accessor(view, U8, "SCALAR", bytes.len())
    }

    fn primitive(&mut self, value: Value) {
        self.doc["meshes"][0]["primitives"].as_array_mut().unwrap().push(value);
    }

    /// The plain solid: floats and bytes.
    fn plain() -> Self {
        let mut file = Self::new();
        let positions = file.positions();
        let indices = file.indices(FACES.into_iter().flatten());
        file.primitive(json!({"attributes": {"POSITION": positions}, "indices": indices}));
        file
    }

    /// The plain faces with other positions.
    fn with_positions(positions: impl FnOnce(&mut Self) -> usize) -> Self {
        let mut file = Self::new();
        let positions = positions(&mut file);
        let indices = file.indices(FACES.into_iter().flatten());
        file.primitive(json!({"attributes": {"POSITION": positions}, "indices": indices}));
        file
    }

    fn with(mut self, change: impl FnOnce(&mut Value)) -> Self {
        change(&mut self.doc);
        self
    }

    fn embedded(&self) -> Vec<u8> {
        let mut doc = self.doc.clone();
        doc["buffers"][0]["uri"] =
            format!("data:application/gltf-buffer;base64,{}", base64(&self.bytes)).into();
        serde_json::to_vec_pretty(&doc).unwrap()
    }

    fn glb(&self) -> Vec<u8> {
        let mut json = serde_json::to_vec(&self.doc).unwrap();
        json.resize(json.len().next_multiple_of(4), b' ');
        let mut bin = self.bytes.clone();
        bin.resize(bin.len().next_multiple_of(4), 0);
        let word = |n: usize| (n as u32).to_le_bytes();
        let length = 12 + 8 + json.len() + 8 + bin.len();
        let head = [b"glTF".as_slice(), &word(2), &word(length)].concat();
        [
            head,
            word(json.len()).to_vec(),
            b"JSON".to_vec(),
            json,
            word(bin.len()).to_vec(),
            b"BIN\0".to_vec(),
            bin,
        ]
        .concat()
    }

    fn read(&self) -> Result<MeshContents, ContentError> {
        let (embedded, glb) =
            (gltf::read(&self.embedded(), Path::new(".")), gltf::read(&self.glb(), Path::new(".")));
        match (embedded, glb) {
            (Ok(embedded), Ok(glb)) => {
                assert_eq!((embedded.encoding, glb.encoding), ("json", "binary"));
                assert_eq!((&embedded.parts, &embedded.findings), (&glb.parts, &glb.findings));
                Ok(glb)
            }
            (Err(embedded), Err(glb)) => {
                assert_eq!(embedded.to_string(), glb.to_string());
                Err(glb)
            }
            (embedded, glb) => panic!("{embedded:?}\n{glb:?}"),
        }
    }

    fn error(&self) -> String {
        self.read().unwrap_err().to_string()
    }
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for three in bytes.chunks(3) {
        let word = three.iter().chain(&[0, 0]).take(3).fold(0_usize, |word, &b| word << 8 | usize::from(b));
        for i in 0..4 {
            text.push(if i <= three.len() { char::from(DIGITS[word >> (18 - 6 * i) & 63]) } else { '=' });
        }
    }
    text
}

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
    // The last strip turns a corner: two of its five triangles are flat.
    let flat = |t: &[[f64; 3]; 3]| t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    let mut joined = corners(&primitives(&mixed));
    joined.retain(|triangle| !flat(triangle));
    assert_eq!(joined, expected());
    // Primitives that share positions share vertices.
    assert_eq!(primitives(&strips).parts[0].mesh.vertices().len(), 6);

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
    // Integers as they are: exact.
    let wide: Vec<u8> = POINTS.iter().flatten().flat_map(|&c| i16::from(c).to_le_bytes()).collect();
    let file = File::with_positions(|file| {
        let view = file.view(&wide);
        file.accessor(view, I16, "VEC3", 6)
    });
    assert_eq!(corners(&file.read().unwrap()), expected());
    // Normalised: 32767 stands for 1, and −32768 for no less than −1. Signs and sizes survive.
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
        assert_eq!(file.read().unwrap().parts[0].mesh.vertices(), expected);
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
    // Columns: x goes to y, y to z, z to x.
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
    assert_eq!(contents.parts[0].mesh.vertices()[3], [2.0 * x + 1.0, 4.0 * y + 1.0, 8.0 * z + 1.0]);
    assert_eq!(contents.parts[1].mesh.vertices()[3], [2.0 * x + 21.0, 4.0 * y + 81.0, 8.0 * z + 241.0]);
    assert_eq!(contents.findings[0].code, "mesh.other_scene");

    // Without scenes, all roots.
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
    assert_eq!(contents.parts[0].mesh.vertices()[2], [2.0 * (x + 1.0), 2.0 * (y + 2.0), 2.0 * (z + 3.0)]);
    // Half a turn about z.
    assert_eq!(contents.parts[1].mesh.vertices()[2], [2.0 * (-x - 4.0), 2.0 * (-y + 5.0), 2.0 * (z + 6.0)]);

    file.doc["accessors"][rotations]["count"] = 1.into();
    assert_eq!(
        file.error(),
        "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes: 2 instances are declared, and 1 are there"
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
    assert!(contents.findings[1].message.starts_with("2 primitives are made of points or lines"));
    // As it was bound, without the place of its node.
    assert_eq!(contents.parts[0].mesh.vertices()[0], POINTS[0].map(f64::from));

    let file = File::plain().with(|doc| doc["nodes"][1]["rotation"] = json!([0.5, 0.5, 0.5, 0.501]));
    assert_eq!(file.read().unwrap().findings[0].code, "mesh.rotation_normalised");
}

#[test]
fn a_document_that_contradicts_itself() {
    let position = "meshes[0].primitives[0].attributes.POSITION";
    let cases: Vec<(&str, Value, String)> = vec![
        ("/asset/version", json!("1.0"), "asset.version: polhode does not read glTF 1.0".into()),
        ("/scene", json!(3), "scene: scene 3 does not exist: there are 1".into()),
        ("/scenes/0/nodes/0", json!(2), "scenes[0].nodes[0]: node 2 does not exist: there are 2".into()),
        (
            "/scenes/0/nodes/0",
            json!(1),
            "scenes[0].nodes[0]: the node = 1 must be a root, and named once".into(),
        ),
        (
            "/scenes/0/nodes",
            json!([0, 0]),
            "scenes[0].nodes[1]: the node = 0 must be a root, and named once".into(),
        ),
        (
            "/nodes/0/children",
            json!([1, 1]),
            "nodes[0].children[1]: the child = 1 must be the child of one node only: nodes[0] has it too"
                .into(),
        ),
        (
            "/nodes/1/children",
            json!([0]),
            "nodes[0]: the node = 0 must be a tree: it is, or hangs under, a node that is its own ancestor"
                .into(),
        ),
        ("/nodes/1/mesh", json!(1), "nodes[1].mesh: mesh 1 does not exist: there are 1".into()),
        ("/nodes/1/mesh", json!(-1), "nodes[1].mesh: expected a whole number from 0, found \"-1\"".into()),
        (
            "/nodes/1/rotation",
            json!([0, 0, 0, 0]),
            "nodes[1].rotation: rotation = [0,0,0,0] must be a quaternion of length 1".into(),
        ),
        ("/nodes/1/scale", json!([1, 2]), "nodes[1].scale: expected 3 numbers, found \"[1,2]\"".into()),
        (
            "/nodes/1/matrix",
            json!([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]),
            "nodes[1].rotation: this = [0.5,0.5,0.5,0.5] must be left out where there is a matrix".into(),
        ),
        (
            "/nodes/1/scale",
            json!([1e300, 1e300, 1e308]),
            "nodes[1]: the coordinate of a placed vertex [inf, 8e300, -2e300] is not finite".into(),
        ),
        (
            "/meshes/0/primitives/0/attributes/POSITION",
            json!(7),
            format!("{position}: accessor 7 does not exist: there are 2"),
        ),
        (
            "/meshes/0/primitives/0/mode",
            json!(9),
            "meshes[0].primitives[0].mode: mode = 9 must be from 0 to 6".into(),
        ),
        ("/accessors/0/type", json!("VEC2"), "accessors[0].type: type = VEC2 must be VEC3 here".into()),
        (
            "/accessors/0/componentType",
            json!(5130),
            "accessors[0].componentType: componentType = 5130 must be 5120, 5121, 5122, 5123, 5125 or 5126"
                .into(),
        ),
        (
            "/accessors/0/componentType",
            json!(5125),
            "accessors[0].componentType: componentType = 5125 must be of 8 or 16 bits, or a float".into(),
        ),
        ("/accessors/0/count", json!(7), "accessors[0]: 7 elements are declared, and 6 are there".into()),
        (
            "/accessors/0/count",
            json!(5),
            "accessors[1], element 12: vertex 5 does not exist: there are 5".into(),
        ),
        (
            "/accessors/0/count",
            json!(4294967295_u32),
            "accessors[0]: 4294967295 elements are declared, and 6 are there".into(),
        ),
        (
            "/accessors/0/count",
            json!(u64::MAX),
            "accessors[0]: 18446744073709551615 elements are declared, and 6 are there".into(),
        ),
        (
            "/accessors/0/byteOffset",
            json!(u64::MAX),
            "accessors[0]: 6 elements are declared, and 0 are there".into(),
        ),
        (
            "/accessors/0",
            json!({"componentType": F32, "type": "VEC3", "count": u64::MAX}),
            "accessors[0]: polhode does not read a file of this size that unfolds to more than 256 MiB"
                .into(),
        ),
        (
            "/accessors/1/count",
            json!(23),
            "meshes[0].primitives[0]: the number of corners = 23 must be divisible by 3".into(),
        ),
        (
            "/accessors/1/componentType",
            json!(5120),
            "accessors[1].componentType: componentType = 5120 must be unsigned for indices".into(),
        ),
        ("/accessors/1/type", json!("VEC3"), "accessors[1].type: type = VEC3 must be SCALAR here".into()),
        (
            "/bufferViews/0/byteLength",
            json!(1000),
            "bufferViews[0]: 1000 bytes of the view are declared, and 96 are there".into(),
        ),
        (
            "/bufferViews/0/byteOffset",
            json!(u64::MAX),
            "bufferViews[0]: 72 bytes of the view are declared, and 0 are there".into(),
        ),
        (
            "/bufferViews/0/byteStride",
            json!(8),
            "accessors[0]: byteStride = 8 must be at least the 12 bytes of an element".into(),
        ),
        (
            "/bufferViews/0/buffer",
            json!(2),
            "bufferViews[0].buffer: buffer 2 does not exist: there are 1".into(),
        ),
        (
            "/buffers/0/byteLength",
            json!(1000),
            "buffers[0]: 1000 bytes are declared, and 96 are there".into(),
        ),
        (
            "/extensionsRequired",
            json!(["KHR_materials_unlit", "KHR_draco_mesh_compression"]),
            "extensionsRequired[1]: polhode does not read compressed meshes (KHR_draco_mesh_compression)"
                .into(),
        ),
        (
            "/extensionsRequired",
            json!(["EXT_meshopt_compression"]),
            "extensionsRequired[0]: polhode does not read compressed meshes (EXT_meshopt_compression)".into(),
        ),
        (
            "/extensionsRequired",
            json!(["ACME_other"]),
            "extensionsRequired[0]: polhode does not read files that need the extension ACME_other".into(),
        ),
        ("/nodes", json!([{}, {}]), "the file has no triangles in its scene".into()),
        ("/nodes", json!({}), "nodes: expected an array, found \"an object\"".into()),
    ];
    for (pointer, value, message) in cases {
        let file = File::plain().with(|doc| {
            let (parent, key) = pointer.rsplit_once('/').unwrap();
            match doc.pointer_mut(parent).unwrap() {
                Value::Array(list) => list[key.parse::<usize>().unwrap()] = value,
                object => object[key] = value,
            }
        });
        assert_eq!(file.error(), message, "{pointer}");
    }
    let mut file = File::plain();
    file.bytes[4..8].copy_from_slice(&f32::NAN.to_le_bytes());
    assert_eq!(file.error(), "accessors[0], element 0: the vector [90.0, NaN, -7.0] is not finite");
}

#[test]
fn a_compressed_primitive_without_a_way_around_is_refused() {
    let mut file = File::plain();
    file.doc["meshes"][0]["primitives"][0]["extensions"] =
        json!({"KHR_draco_mesh_compression": {"bufferView": 0}});
    assert_eq!(corners(&file.read().unwrap()), expected());
    file.doc["accessors"][0].as_object_mut().unwrap().remove("bufferView");
    let place = "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression";
    assert_eq!(
        file.error(),
        format!("{place}: polhode does not read compressed meshes (KHR_draco_mesh_compression)")
    );
}

/// Ten doublings by children are no bomb here, as a node has one parent; instancing is what unfolds.
#[test]
fn a_mesh_that_unfolds_too_far_is_refused() {
    let mut file = File::plain();
    file.doc["accessors"][0] = json!({"componentType": F32, "type": "VEC3", "count": 9_000_000});
    file.doc["nodes"] = (0..500).map(|_| json!({"mesh": 0})).collect();
    file.doc["scenes"] = json!([{"nodes": (0..500).collect::<Vec<_>>()}]);
    assert!(file.error().contains("unfolds to more than 256 MiB"), "{}", file.error());
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("gltf-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(folder.join("inner/parts")).unwrap();
    folder
}

#[test]
fn buffers_beside_the_document_and_nowhere_else() {
    let (file, top) = (File::plain(), folder("beside"));
    let inner = top.join("inner");
    fs::write(inner.join("my solid.bin"), &file.bytes).unwrap();
    fs::write(inner.join("parts/solid.bin"), [file.bytes.as_slice(), b"more"].concat()).unwrap();
    fs::write(inner.join("short.bin"), &file.bytes[..95]).unwrap();
    fs::write(top.join("outside.bin"), &file.bytes).unwrap();
    let read = |uri: &str| {
        let file = file.clone().with(|doc| doc["buffers"][0]["uri"] = uri.into());
        gltf::read(&serde_json::to_vec(&file.doc).unwrap(), &inner)
    };
    for good in ["my%20solid.bin", "my solid.bin", "./my%20solid.bin", "parts/solid.bin"] {
        assert_eq!(corners(&read(good).unwrap()), expected(), "{good}");
    }
    let absolute = inner.join("my solid.bin");
    for bad in [
        "../outside.bin",
        "%2e%2e/outside.bin",
        "parts/../../outside.bin",
        "file:///etc/hostname",
        "http://example.org/a.bin",
        absolute.to_str().unwrap(),
    ] {
        let error = read(bad).unwrap_err();
        assert!(
            error.to_string().ends_with("must be a file in the folder of the document, or below it"),
            "{error}"
        );
        assert!(error.to_string().starts_with("buffers[0].uri: "), "{error}");
    }
    assert_eq!(
        read("short.bin").unwrap_err().to_string(),
        "buffers[0]: 96 bytes are declared, and 95 are there"
    );
    assert!(read("none.bin").unwrap_err().to_string().contains("must be a file that can be read ("));
    assert_eq!(
        read("parts").unwrap_err().to_string(),
        "buffers[0].uri: uri = parts must be an ordinary file"
    );
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(top.join("outside.bin"), inner.join("link.bin")).unwrap();
        assert!(read("link.bin").unwrap_err().to_string().contains("in the folder of the document"));
        std::os::unix::fs::symlink(inner.join("my solid.bin"), inner.join("alias.bin")).unwrap();
        assert_eq!(corners(&read("alias.bin").unwrap()), expected());
    }
    let mute = serde_json::to_vec(&file.doc).unwrap();
    assert_eq!(gltf::read(&mute, &inner).unwrap_err().to_string(), "buffers[0]: the file has no uri");
}

#[test]
fn containers_that_are_broken() {
    let glb = File::plain().glb();
    let error = |bytes: &[u8]| gltf::read(bytes, Path::new(".")).unwrap_err().to_string();
    let patched = |at: usize, with: &[u8]| {
        let mut bytes = glb.clone();
        bytes[at..at + with.len()].copy_from_slice(with);
        error(&bytes)
    };
    assert_eq!(
        error(b""),
        "byte 0: expected the { of a .gltf or the \"glTF\" of a .glb, found the end of the file"
    );
    assert!(error(b"solid x").ends_with("found \"solid x\""));
    assert_eq!(error(b"glTF\x02\0\0\0"), "byte 0: 12 bytes of the header are declared, and 8 are there");
    assert_eq!(patched(4, &[1]), "the header, byte 4: polhode does not read version 1 of the GLB container");
    assert!(
        patched(8, &u32::MAX.to_le_bytes()).starts_with("byte 8: 4294967295 bytes in the file are declared")
    );
    assert!(
        patched(12, &u32::MAX.to_le_bytes())
            .starts_with("byte 12: 4294967295 bytes of the chunk are declared")
    );
    assert_eq!(patched(16, b"BIN\0"), "byte 12: the file has no chunk of JSON behind the header");
    assert_eq!(
        patched(20, b"!"),
        "the chunk of JSON, line 1, column 1: expected JSON, found \"expected value\""
    );
    let text = b"{\n  \"asset\": {\"version\": \"2.0\"},\n  \"nodes\": [1 2]\n}";
    let error = gltf::read(text, Path::new(".")).unwrap_err();
    assert_eq!(error.place, polhode_formats::ContentPlace::Text(47..48));
    assert_eq!(&text[47..48], b"2");
    assert!(gltf::read(&[b'['; 100_000], Path::new(".")).is_err());
    assert!(gltf::read(format!("{{\"a\":{}", "[".repeat(100_000)).as_bytes(), Path::new(".")).is_err());
}

/// Cut anywhere, and with any byte changed: an answer or an error, and never more than the bytes carry.
#[test]
fn no_bytes_do_harm() {
    let glb = File::plain().glb();
    for length in 0..glb.len() {
        assert!(gltf::read(&glb[..length], Path::new(".")).is_err());
    }
    let embedded = File::plain().embedded();
    for length in 0..embedded.len() {
        assert!(gltf::read(&embedded[..length], Path::new(".")).is_err());
    }
    let mut read = 0;
    for k in 0..glb.len() {
        for mask in [0x01, 0x04, 0x10, 0x80, 0xff] {
            let mut bytes = glb.clone();
            bytes[k] ^= mask;
            if let Ok(contents) = gltf::read(&bytes, Path::new(".")) {
                read += 1;
                let made: usize =
                    contents.parts.iter().map(|p| p.mesh.vertices().len() + p.mesh.triangles().len()).sum();
                assert!(made < glb.len());
            }
        }
    }
    assert!(read > 100);
}
