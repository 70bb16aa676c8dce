//! Inconsistent documents, truncated or modified files, and separate buffers.

use std::fs;
use std::path::{Path, PathBuf};

use polhode_shape::mesh::gltf;
use polhode_source::files::Disk;
use serde_json::{Value, json};

use crate::gltf::file::{F32, File, corners, expected};

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
            "nodes[0].children[1]: the child = 1 must be the child of only one node: it is also a child of nodes[0]"
                .into(),
        ),
        (
            "/nodes/1/children",
            json!([0]),
            "nodes[0]: the node = 0 must be part of a tree: it is its own ancestor, or below such a node"
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
            "nodes[1].rotation: this = [0.5,0.5,0.5,0.5] must be absent if there is a matrix".into(),
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
        ("/accessors/0/count", json!(7), "accessors[0]: 7 elements are declared, but the file has 6".into()),
        (
            "/accessors/0/count",
            json!(5),
            "accessors[1], element 12: vertex 5 does not exist: there are 5".into(),
        ),
        (
            "/accessors/0/count",
            json!(4294967295_u32),
            "accessors[0]: 4294967295 elements are declared, but the file has 6".into(),
        ),
        (
            "/accessors/0/count",
            json!(u64::MAX),
            "accessors[0]: 18446744073709551615 elements are declared, but the file has 6".into(),
        ),
        (
            "/accessors/0/byteOffset",
            json!(u64::MAX),
            "accessors[0]: 6 elements are declared, but the file has 0".into(),
        ),
        (
            "/accessors/0",
            json!({"componentType": F32, "type": "VEC3", "count": u64::MAX}),
            "accessors[0]: polhode does not read a file of this size that expands to more than 256 MiB"
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
            "bufferViews[0]: 1000 bytes of the view are declared, but the file has 96".into(),
        ),
        (
            "/bufferViews/0/byteOffset",
            json!(u64::MAX),
            "bufferViews[0]: 72 bytes of the view are declared, but the file has 0".into(),
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
            "buffers[0]: 1000 bytes are declared, but the file has 96".into(),
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

/// Children cannot multiply a mesh, since a node has one parent; instancing can.
#[test]
fn a_mesh_that_unfolds_too_far_is_refused() {
    let mut file = File::plain();
    file.doc["accessors"][0] = json!({"componentType": F32, "type": "VEC3", "count": 9_000_000});
    file.doc["nodes"] = (0..500).map(|_| json!({"mesh": 0})).collect();
    file.doc["scenes"] = json!([{"nodes": (0..500).collect::<Vec<_>>()}]);
    assert!(file.error().contains("expands to more than 256 MiB"), "{}", file.error());
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
        gltf::read(&Disk, &serde_json::to_vec(&file.doc).unwrap(), &inner)
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
        "buffers[0]: 96 bytes are declared, but the file has 95"
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
    assert_eq!(gltf::read(&Disk, &mute, &inner).unwrap_err().to_string(), "buffers[0]: the file has no uri");
}

#[test]
fn containers_that_are_broken() {
    let glb = File::plain().glb();
    let error = |bytes: &[u8]| gltf::read(&Disk, bytes, Path::new(".")).unwrap_err().to_string();
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
    assert_eq!(error(b"glTF\x02\0\0\0"), "byte 0: 12 bytes of the header are declared, but the file has 8");
    assert_eq!(patched(4, &[1]), "the header, byte 4: polhode does not read version 1 of the GLB container");
    assert!(
        patched(8, &u32::MAX.to_le_bytes()).starts_with("byte 8: 4294967295 bytes in the file are declared")
    );
    assert!(
        patched(12, &u32::MAX.to_le_bytes())
            .starts_with("byte 12: 4294967295 bytes of the chunk are declared")
    );
    assert_eq!(patched(16, b"BIN\0"), "byte 12: the file has no JSON chunk after the header");
    assert_eq!(
        patched(20, b"!"),
        "the chunk of JSON, line 1, column 1: expected JSON, found \"expected value\""
    );
    let text = b"{\n  \"asset\": {\"version\": \"2.0\"},\n  \"nodes\": [1 2]\n}";
    let error = gltf::read(&Disk, text, Path::new(".")).unwrap_err();
    assert_eq!(error.place, polhode_source::ContentPlace::Text(47..48));
    assert_eq!(&text[47..48], b"2");
    assert!(gltf::read(&Disk, &[b'['; 100_000], Path::new(".")).is_err());
    assert!(
        gltf::read(&Disk, format!("{{\"a\":{}", "[".repeat(100_000)).as_bytes(), Path::new(".")).is_err()
    );
}

/// Files truncated at any byte, or with any byte changed, give a result or an error. Memory use is
/// limited by their size.
#[test]
fn no_bytes_do_harm() {
    let glb = File::plain().glb();
    for length in 0..glb.len() {
        assert!(gltf::read(&Disk, &glb[..length], Path::new(".")).is_err());
    }
    let embedded = File::plain().embedded();
    for length in 0..embedded.len() {
        assert!(gltf::read(&Disk, &embedded[..length], Path::new(".")).is_err());
    }
    let mut read = 0;
    for k in 0..glb.len() {
        for mask in [0x01, 0x04, 0x10, 0x80, 0xff] {
            let mut bytes = glb.clone();
            bytes[k] ^= mask;
            if let Ok(contents) = gltf::read(&Disk, &bytes, Path::new(".")) {
                read += 1;
                let made: usize = contents
                    .parts
                    .iter()
                    .map(|p| p.mesh.coordinates().len() + p.mesh.triangles().len())
                    .sum();
                assert!(made < glb.len());
            }
        }
    }
    assert!(read > 100);
}

/// Documents with any value replaced give a result or an error.
#[test]
fn no_value_does_harm() {
    fn pointers(value: &Value, at: &str, all: &mut Vec<String>) {
        all.push(at.to_owned());
        match value {
            Value::Array(list) => {
                list.iter().enumerate().for_each(|(k, value)| pointers(value, &format!("{at}/{k}"), all));
            }
            Value::Object(members) => {
                members.iter().for_each(|(key, value)| pointers(value, &format!("{at}/{key}"), all));
            }
            _ => {}
        }
    }
    let file = File::plain().with(|doc| {
        doc["nodes"][1]["extensions"] = json!({"EXT_mesh_gpu_instancing": {"attributes": {"SCALE": 0}}});
        let sparse = json!({
            "count": 1, "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 0}
        });
        doc["accessors"][0]["sparse"] = sparse;
    });
    assert_eq!(file.read().unwrap().parts.len(), 6);
    let others = [
        json!(null),
        json!(0),
        json!(1),
        json!(-1),
        json!(0.5),
        json!(1e308),
        json!(u64::MAX),
        json!(""),
        json!("é%"),
        json!(true),
        json!([]),
        json!({}),
        json!([[]]),
        json!([0, 0, 0]),
    ];
    let (mut all, mut answers) = (Vec::new(), 0);
    pointers(&file.doc, "", &mut all);
    for pointer in &all {
        for other in &others {
            let mut doc = file.doc.clone();
            *doc.pointer_mut(pointer).unwrap() = other.clone();
            let file = File { doc, bytes: file.bytes.clone() };
            answers += usize::from(gltf::read(&Disk, &file.glb(), Path::new(".")).is_ok());
        }
    }
    assert!(answers > 20 && answers < all.len() * others.len() / 2);
}

/// A text with `data:` URIs of 1 GB is refused by its length, before it is read.
#[test]
fn a_text_has_a_limit() {
    let path = std::env::temp_dir().join(format!("polhode-large-{}.gltf", std::process::id()));
    fs::File::create(&path).unwrap().set_len(1 << 30).unwrap();
    let read = |path: &Path| {
        polhode_shape::mesh::MeshContents::read(&Disk, path, polhode_shape::mesh::MeshFormat::Gltf)
    };
    let error = read(&path).unwrap_err();
    assert!(error.to_string().contains("it has more than 268435456 bytes"), "{error}");
    fs::remove_file(&path).unwrap();
}

#[test]
fn a_key_stands_once() {
    let text = br#"{"asset": {"version": "2.0"}, "scene": 0, "scene": 1}"#;
    let error = gltf::read(&Disk, text, Path::new("")).unwrap_err();
    assert!(error.kind.to_string().contains("duplicate key"), "{}", error.kind);
}
