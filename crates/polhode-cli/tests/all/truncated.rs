//! Files that end early, or shrink while they are read.
#![cfg(unix)]

use std::fs::{self, File};
use std::process::Stdio;
use std::thread::sleep;
use std::time::Duration;

use crate::common::{Scratch, example};

/// File of each kind, and the command that reads it.
const READ: [(&str, &[&str]); 12] = [
    ("bracket.stl", &["inertia"]),
    ("t-handle.toml", &["explain"]),
    ("sweeps/tumbling-debris.toml", &["stability"]),
    ("water.xyz", &["inertia"]),
    ("water.mol", &["inertia"]),
    ("water.pdb", &["inertia"]),
    ("robots/bad-arm.urdf", &["check"]),
    ("two.obj", &["inertia"]),
    ("two.ply", &["inertia"]),
    ("cloud.csv", &["inertia"]),
    ("grid.npy", &["inertia", "--spacing", "1 m"]),
    ("grid.nrrd", &["inertia", "--unit", "m"]),
];

/// Returns the contents of an example, or of a small file made here.
fn whole(name: &str) -> Vec<u8> {
    let numbers: Vec<u8> = (1..9_u8).flat_map(|k| f32::from(k).to_le_bytes()).collect();
    let text = match name {
        "two.obj" => "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n".to_owned(),
        "two.ply" => {
            let corners = "0 0 0\n2 0 0\n0 3 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
            let vertex = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
            let face = "element face 4\nproperty list uchar int vertex_indices\n";
            format!("ply\nformat ascii 1.0\n{vertex}{face}end_header\n{corners}")
        }
        "cloud.csv" => "mass_kg,x_m,y_m,z_m\n1.5,1,2,3\n2.5,-4,0,2\n0.5,1,1,7\n".to_owned(),
        "grid.nrrd" => {
            let header = "NRRD0004\ntype: float\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nendian: little\n";
            return [header.as_bytes(), b"spacings: 1 1 1\n\n", &numbers].concat();
        }
        "grid.npy" => {
            let header = "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 2, 2), }";
            let header = format!("{header:<117}\n");
            return [b"\x93NUMPY\x01\x00\x76\x00", header.as_bytes(), &numbers].concat();
        }
        name => return fs::read(example(name)).unwrap(),
    };
    text.into_bytes()
}

#[test]
fn a_file_that_ends_early_is_an_error_or_another_file() {
    let scratch = Scratch::new("short");
    for (name, command) in READ {
        let bytes = whole(name);
        let file = name.rsplit('/').next().unwrap();
        let run = [&command[..1], &[file], &command[1..]].concat();
        for part in 0..=12 {
            let kept = bytes.len() * part / 12;
            fs::write(scratch.0.join(file), &bytes[..kept]).unwrap();
            let output = scratch.run(&run);
            let text = String::from_utf8_lossy(&output.stderr);
            // Exit status 1 means that `check` has findings.
            let is_read = matches!(output.status.code(), Some(0 | 1));
            let is_refused = output.status.code() == Some(2) && text.contains(file) && kept < bytes.len();
            assert!(is_read || is_refused, "{name} {kept}: {:?} {text}", output.status);
        }
    }
}

#[test]
fn a_file_that_shrinks_while_it_is_read_is_an_error_or_the_whole() {
    let scratch = Scratch::new("shrinking");
    let bracket = fs::read(example("bracket.stl")).unwrap();
    let records = bracket[84..].repeat(1000);
    let stl = [&bracket[..80], &(records.len() as u32 / 50).to_le_bytes(), &records].concat();
    let rows = "1.5,1,2,3\n2.5,-4,0,2\n0.5,1,1,7\n".repeat(30_000);
    let cloud = format!("mass_kg,x_m,y_m,z_m\n{rows}").into_bytes();
    for (name, bytes) in [("many.stl", &stl), ("cloud.csv", &cloud)] {
        for k in 0..6 {
            fs::write(scratch.0.join(name), bytes).unwrap();
            let mut command = scratch.command(&["inertia", name]);
            let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
            sleep(Duration::from_millis(4 * k));
            let file = File::options().write(true).open(scratch.0.join(name)).unwrap();
            file.set_len(bytes.len() as u64 / 2).unwrap();
            let output = child.wait_with_output().unwrap();
            assert!(matches!(output.status.code(), Some(0 | 2)), "{name} {k}: {output:?}");
        }
    }
}
