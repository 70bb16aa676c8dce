//! glTF document under construction.

use std::path::Path;

use base64::prelude::{BASE64_STANDARD, Engine as _};
use polhode_shape::mesh::{MeshContents, gltf};
use polhode_source::ContentError;
use polhode_source::files::Disk;
use serde_json::{Value, json};

pub(super) const I8: u64 = 5120;
pub(super) const U8: u64 = 5121;
pub(super) const I16: u64 = 5122;
pub(super) const U16: u64 = 5123;
pub(super) const U32: u64 = 5125;
pub(super) const F32: u64 = 5126;

/// Irregular octahedron: the points 0 to 3 form a ring, 4 is above it and 5 below.
pub(super) const POINTS: [[i8; 3]; 6] =
    [[90, 3, -7], [4, 70, -9], [-80, 5, 11], [-6, -60, 13], [8, -2, 50], [10, 12, -40]];
/// Faces, counter-clockwise as seen from outside.
pub(super) const FACES: [[u8; 3]; 8] =
    [[4, 0, 1], [4, 1, 2], [4, 2, 3], [4, 3, 0], [5, 1, 0], [5, 2, 1], [5, 3, 2], [5, 0, 3]];

pub(super) type Corners = Vec<[[f64; 3]; 3]>;

/// Returns the triangles in a canonical order: each starts with its smallest corner. Equal surfaces
/// give equal lists.
pub(super) fn canonical(corners: impl IntoIterator<Item = [[f64; 3]; 3]>) -> Corners {
    let order = |a: &[f64; 3], b: &[f64; 3]| a.partial_cmp(b).unwrap();
    let mut all: Corners = corners.into_iter().collect();
    for triangle in &mut all {
        let least = (0..3).min_by(|&a, &b| order(&triangle[a], &triangle[b])).unwrap();
        triangle.rotate_left(least);
    }
    all.sort_by(|a, b| a.partial_cmp(b).unwrap());
    all
}

/// Returns the solid as placed by the nodes of [`File::nodes`]: scaled by 1/32, x → y → z → x, then
/// displaced.
pub(super) fn expected() -> Corners {
    let placed = |k: u8| {
        let [x, y, z] = POINTS[usize::from(k)].map(|c| f64::from(c) / 32.0);
        [z + 0.5, x - 3.0, y + 7.25]
    };
    canonical(FACES.map(|face| face.map(placed)))
}

pub(super) fn corners(contents: &MeshContents) -> Corners {
    canonical(contents.parts.iter().flat_map(|part| part.mesh.corners()))
}

/// Document under construction, and its only buffer.
#[derive(Clone)]
pub(super) struct File {
    pub(super) doc: Value,
    pub(super) bytes: Vec<u8>,
}

impl File {
    /// Creates two nodes, one the parent of the other, that place mesh 0.
    pub(super) fn new() -> Self {
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

    pub(super) fn push(&mut self, list: &str, value: Value) -> usize {
        let list = self.doc[list].as_array_mut().unwrap();
        list.push(value);
        list.len() - 1
    }

    pub(super) fn view(&mut self, bytes: &[u8]) -> usize {
        let value = json!({"buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len()});
        self.bytes.extend(bytes);
        self.doc["buffers"][0]["byteLength"] = self.bytes.len().into();
        self.push("bufferViews", value)
    }

    pub(super) fn accessor(&mut self, view: usize, component: u64, kind: &str, count: usize) -> usize {
        let value = json!({"bufferView": view, "componentType": component, "type": kind, "count": count});
        self.push("accessors", value)
    }

    pub(super) fn positions(&mut self) -> usize {
        let bytes: Vec<u8> = POINTS.iter().flatten().flat_map(|&c| f32::from(c).to_le_bytes()).collect();
        let view = self.view(&bytes);
        self.accessor(view, F32, "VEC3", 6)
    }

    pub(super) fn indices(&mut self, indices: impl IntoIterator<Item = u8>) -> usize {
        let bytes: Vec<u8> = indices.into_iter().collect();
        let view = self.view(&bytes);
        self.accessor(view, U8, "SCALAR", bytes.len())
    }

    pub(super) fn primitive(&mut self, value: Value) {
        self.doc["meshes"][0]["primitives"].as_array_mut().unwrap().push(value);
    }

    /// Returns the plain solid with floats and bytes.
    pub(super) fn plain() -> Self {
        let mut file = Self::new();
        let positions = file.positions();
        let indices = file.indices(FACES.into_iter().flatten());
        file.primitive(json!({"attributes": {"POSITION": positions}, "indices": indices}));
        file
    }

    /// Returns the plain faces with other positions.
    pub(super) fn with_positions(positions: impl FnOnce(&mut Self) -> usize) -> Self {
        let mut file = Self::new();
        let positions = positions(&mut file);
        let indices = file.indices(FACES.into_iter().flatten());
        file.primitive(json!({"attributes": {"POSITION": positions}, "indices": indices}));
        file
    }

    pub(super) fn with(mut self, change: impl FnOnce(&mut Value)) -> Self {
        change(&mut self.doc);
        self
    }

    pub(super) fn embedded(&self) -> Vec<u8> {
        let mut doc = self.doc.clone();
        doc["buffers"][0]["uri"] =
            format!("data:application/gltf-buffer;base64,{}", BASE64_STANDARD.encode(&self.bytes)).into();
        serde_json::to_vec_pretty(&doc).unwrap()
    }

    pub(super) fn glb(&self) -> Vec<u8> {
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

    pub(super) fn read(&self) -> Result<MeshContents, ContentError> {
        let (embedded, glb) = (
            gltf::read(&Disk, &self.embedded(), Path::new(".")),
            gltf::read(&Disk, &self.glb(), Path::new(".")),
        );
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

    pub(super) fn error(&self) -> String {
        self.read().unwrap_err().to_string()
    }
}
