//! What a file may cost: it may change while it is read, but not end the process, and memory is not its to take.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod common;

use std::fs::{self, File};
use std::process::Stdio;
use std::thread::sleep;
use std::time::Duration;

use common::Scratch;

/// A binary STL file of so many triangles, all of them at the origin.
fn empty_triangles(count: u32) -> Vec<u8> {
    let mut bytes = vec![b'a'; 80];
    bytes.extend(count.to_le_bytes());
    bytes.resize(84 + 50 * count as usize, 0);
    bytes
}

/// A binary PLY file that declares so many vertices and has no face.
fn vertices(count: usize) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {count}\nproperty float x\nproperty float y\n\
         property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    bytes.resize(bytes.len() + 12 * count, 0);
    bytes
}

/// A GLB file whose binary chunk has so many bytes.
fn glb(length: usize) -> Vec<u8> {
    let mut json = format!("{{\"asset\":{{\"version\":\"2.0\"}},\"buffers\":[{{\"byteLength\":{length}}}]}}");
    json += &" ".repeat(json.len().next_multiple_of(4) - json.len());
    let words = |words: &[u32]| words.iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<u8>>();
    let mut bytes = b"glTF".to_vec();
    bytes.extend(words(&[2, (28 + json.len() + length) as u32, json.len() as u32, 0x4E4F_534A]));
    bytes.extend(json.as_bytes());
    bytes.extend(words(&[length as u32, 0x004E_4942]));
    bytes.resize(bytes.len() + length, 0);
    bytes
}

/// Voxels of zero, 256 × 256 × so many.
fn voxels(layers: usize) -> Vec<u8> {
    let mut bytes = format!(
        "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 256 256 {layers}\nencoding: raw\nspacings: 1 1 1\n\
         units: \"mm\" \"mm\" \"mm\"\n\n"
    )
    .into_bytes();
    bytes.resize(bytes.len() + 65_536 * layers, 0);
    bytes
}

#[test]
fn a_file_that_is_shortened_while_it_is_read_is_refused_and_no_signal_ends_the_process() {
    let scratch = Scratch::new("shortened");
    let files = [
        ("a.stl", empty_triangles(600_000), vec!["--quick", "--density", "2 kg/m^3"], 20),
        ("b.stl", empty_triangles(300_000), vec!["--density", "2 kg/m^3"], 3),
        ("a.ply", vertices(1_000_000), vec!["--density", "2 kg/m^3"], 3),
        ("a.glb", glb(16 << 20), vec!["--density", "2 kg/m^3"], 3),
        ("a.nrrd", voxels(256), vec![], 3),
    ];
    for (name, bytes, flags, tries) in files {
        let path = scratch.0.join(name);
        for attempt in 0..tries {
            fs::write(&path, &bytes).unwrap();
            let mut command = scratch.command(&["inertia", name]);
            let command = command.args(&flags).stdout(Stdio::piped()).stderr(Stdio::piped());
            let child = command.spawn().unwrap();
            // Now before it is opened, now while it is read, now afterwards.
            sleep(Duration::from_millis(attempt * 2));
            File::options().write(true).open(&path).unwrap().set_len(100).unwrap();
            let output = child.wait_with_output().unwrap();
            let error = String::from_utf8_lossy(&output.stderr);
            // Nothing but zeros is refused too, when it has been read.
            assert_eq!(output.status.code(), Some(2), "{name}: {error}");
            assert!(error.starts_with("error: ") && error.contains(name), "{error}");
        }
    }
}
