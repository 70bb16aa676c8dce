//! Resource limits: a file that changes while it is read does not end the process, and no file can
//! exhaust the memory.
#![cfg(unix)]

use std::fs::{self, File};
use std::io::Write as _;
use std::process::{Command, Output, Stdio};
use std::thread::sleep;
use std::time::Duration;

use crate::common::{Scratch, json, number, refused};
use flate2::Compression;
use flate2::write::{DeflateEncoder, GzEncoder};

/// Returns a binary STL file of `count` triangles, all of them at the origin.
fn empty_triangles(count: u32) -> Vec<u8> {
    let mut bytes = vec![b'a'; 80];
    bytes.extend(count.to_le_bytes());
    bytes.resize(84 + 50 * count as usize, 0);
    bytes
}

/// Returns a binary PLY file that declares `count` vertices and has no faces.
fn vertices(count: usize) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {count}\nproperty float x\nproperty float y\n\
         property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    bytes.resize(bytes.len() + 12 * count, 0);
    bytes
}

/// Returns a GLB file with a binary chunk of `length` bytes.
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

/// Returns zero voxels, 256 × 256 × `layers`.
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
        ("a.stl", empty_triangles(300_000), vec!["--density", "2 kg/m^3"], 3),
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
            // The file changes before it is opened, while it is read, or afterwards.
            sleep(Duration::from_millis(attempt * 2));
            File::options().write(true).open(&path).unwrap().set_len(100).unwrap();
            let output = child.wait_with_output().unwrap();
            let error = String::from_utf8_lossy(&output.stderr);
            // A file of zeros only is refused as well, after it has been read.
            assert_eq!(output.status.code(), Some(2), "{name}: {error}");
            assert!(error.starts_with("error: ") && error.contains(name), "{error}");
        }
    }
}

/// Runs polhode in a process with this memory limit, KiB.
#[cfg(target_os = "linux")]
fn within(kib: u32, scratch: &Scratch, arguments: &[&str]) -> Output {
    let mut shell = Command::new("sh");
    shell.args(["-c", &format!("ulimit -v {kib} && exec \"$0\" \"$@\""), env!("CARGO_BIN_EXE_polhode")]);
    shell.current_dir(&scratch.0).args(arguments).output().unwrap()
}

/// Limit slightly above the needs of the program itself, with its threads and unused address space,
/// KiB.
#[cfg(target_os = "linux")]
const KIB: u32 = 80 << 10;

#[test]
#[cfg(target_os = "linux")]
fn voxels_take_no_memory_compressed_or_not() {
    let scratch = Scratch::new("voxels");
    // 96 MiB of ones as 64-bit integers, big-endian.
    let (counts, layer) = ([256, 256, 192], [0, 0, 0, 0, 0, 0, 0, 1].repeat(256 * 256));
    let header = |encoding: &str, layers: usize| {
        format!(
            "NRRD0004\ntype: int64\nendian: big\ndimension: 3\nsizes: 256 256 {layers}\nencoding: {encoding}\n\
             spacings: 1 2 3\nunits: \"mm\" \"mm\" \"mm\"\n\n"
        )
    };
    let mut raw = File::create(scratch.0.join("raw.nrrd")).unwrap();
    raw.write_all(header("raw", counts[2]).as_bytes()).unwrap();
    (0..counts[2]).for_each(|_| raw.write_all(&layer).unwrap());
    let compressed = |name: &str, declared: usize| {
        let mut file = File::create(scratch.0.join(name)).unwrap();
        file.write_all(header("gzip", declared).as_bytes()).unwrap();
        let mut encoder = GzEncoder::new(file, Compression::fast());
        (0..counts[2]).for_each(|_| encoder.write_all(&layer).unwrap());
        encoder.finish().unwrap();
    };
    compressed("gzip.nrrd", counts[2]);
    compressed("more.nrrd", 1);
    for name in ["raw.nrrd", "gzip.nrrd"] {
        let body = json(&within(KIB, &scratch, &["inertia", name, "--json"]));
        let mass = 6e-9 * counts.iter().product::<usize>() as f64;
        assert!((number(&body["mass"]) / mass - 1.0).abs() < 1e-12, "{name}");
    }
    let more = refused(&within(KIB, &scratch, &["inertia", "more.nrrd"]), 2);
    assert!(more.contains("524288 bytes of voxels are declared") && more.contains("more.nrrd"), "{more}");
}

/// Returns a 3MF package with a model of this size in MiB, which deflate compresses by a factor of
/// about 1000.
fn bomb(mebibytes: usize, declared: Option<u32>) -> Vec<u8> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::fast());
    let mut sum = flate2::Crc::new();
    let mut write = |bytes: &[u8]| {
        sum.update(bytes);
        encoder.write_all(bytes).unwrap();
    };
    write(b"<model xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources><object id=\"1\">\
        <mesh><vertices>");
    let many = b"<vertex x=\"0\" y=\"0\" z=\"0\"/>    ".repeat(1 << 15);
    (0..mebibytes).for_each(|_| write(&many));
    let (check, length) = (sum.sum(), sum.amount());
    let data = encoder.finish().unwrap();
    let name = b"3D/3dmodel.model";
    let four = u32::to_le_bytes;
    let common = [
        [20, 0, 0, 0, 8, 0, 0, 0, 33, 0].as_slice(),
        &four(check),
        &four(data.len() as u32),
        &four(declared.unwrap_or(length)),
        &[name.len() as u8, 0, 0, 0],
    ]
    .concat();
    let start = [b"PK\x03\x04", common.as_slice(), name, &data].concat();
    let directory = [b"PK\x01\x02\x14\0", common.as_slice(), &[0; 10], &four(0), name].concat();
    let size = [four(directory.len() as u32), four(start.len() as u32)].concat();
    [&start, directory.as_slice(), b"PK\x05\x06\0\0\0\0\x01\0\x01\0", &size, &[0; 2]].concat()
}

#[test]
#[cfg(target_os = "linux")]
fn a_package_that_unfolds_too_far_takes_no_memory() {
    let scratch = Scratch::new("bomb");
    fs::write(scratch.0.join("bomb.3mf"), bomb(1 << 10, None)).unwrap();
    let error = refused(&within(KIB, &scratch, &["inertia", "bomb.3mf", "--density", "2 kg/m^3"]), 2);
    assert!(error.contains("a file of this size that") && error.contains("bomb.3mf"), "{error}");
    // The entry declares a small size.
    fs::write(scratch.0.join("liar.3mf"), bomb(1 << 10, Some(1 << 16))).unwrap();
    let error = refused(&within(KIB, &scratch, &["inertia", "liar.3mf", "--density", "2 kg/m^3"]), 2);
    assert!(error.contains("the entry = ") && error.contains("liar.3mf"), "{error}");
}

/// Returns a scenario of `count` boxes in a row.
#[cfg(target_os = "linux")]
fn boxes(count: usize) -> Vec<u8> {
    let part = |k: usize| {
        format!("[[body.part]]\nshape = 'box'\nsize = [1, 2, 3]\nmass = 1\nposition = [{}, 0, 0]\n", 2 * k)
    };
    (0..count).map(part).collect::<String>().into_bytes()
}

/// Returns carbon atoms on a grid.
#[cfg(target_os = "linux")]
fn atoms(count: usize) -> Vec<u8> {
    let atom = |k: usize| format!("C {} {} {}\n", k % 100 * 2, k / 100 % 100 * 2, k / 10_000 * 2);
    format!("{count}\n\n{}", (0..count).map(atom).collect::<String>()).into_bytes()
}

/// Returns a chain of links with the same inertial.
#[cfg(target_os = "linux")]
fn links(count: usize) -> Vec<u8> {
    let link = |k: usize| {
        let joint = format!(
            "<joint name=\"j{k}\" type=\"fixed\"><parent link=\"l{}\"/><child link=\"l{k}\"/></joint>",
            k.saturating_sub(1)
        );
        format!(
            "<link name=\"l{k}\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" \
             iyz=\"0\"/></inertial></link>{}\n",
            if k == 0 { "" } else { &joint }
        )
    };
    format!("<robot name=\"r\">{}</robot>", (0..count).map(link).collect::<String>()).into_bytes()
}

/// Wherever memory runs out, in the reader or the computation, the exit status is that of an error.
#[test]
#[cfg(target_os = "linux")]
fn memory_that_cannot_be_had_is_an_error_and_no_abort() {
    let scratch = Scratch::new("no-memory");
    let runs = |kib: &u32| within(*kib, &scratch, &["--version"]).status.success();
    let least = (8 << 10..1 << 20).step_by(4 << 10).find(runs).unwrap();
    let plan = fs::read("../../examples/sweeps/tumbling-debris.toml").unwrap();
    let files: [(&str, Vec<u8>, &[&str]); 6] = [
        ("a.stl", empty_triangles(400_000), &["inertia", "--unit", "mm", "--density", "1"]),
        ("a.ply", vertices(2_000_000), &["inertia", "--unit", "mm", "--density", "1"]),
        ("a.xyz", atoms(400_000), &["inertia"]),
        ("a.toml", boxes(60_000), &["inertia"]),
        ("a.urdf", links(60_000), &["inertia", "--lump=all"]),
        ("b.toml", plan, &["sweep", "--threads", "8"]),
    ];
    for (name, bytes, arguments) in files {
        fs::write(scratch.0.join(name), bytes).unwrap();
        let arguments = [arguments, &[name]].concat();
        let mut ended = 0;
        for more in [4 << 10, 12 << 10, 24 << 10] {
            let output = within(least + more, &scratch, &arguments);
            let error = String::from_utf8_lossy(&output.stderr);
            assert!(matches!(output.status.code(), Some(0 | 2)), "{name}, {more} KiB: {output:?}");
            ended += usize::from(error.contains("memory"));
        }
        assert!(ended > 0, "{name}");
    }
}
