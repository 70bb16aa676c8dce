//! From a binary STL file to its moments, beside summing the bytes of the same file, in one run.
//!
//! `cargo bench -p polhode-stl` makes spheres of 1.3 and 5.2 million triangles in the system's folder for temporary
//! files, written at once, which the system then keeps in pages of megabytes, and in pieces, as most programs write, which
//! it keeps in smaller pages; measures, and prints a table. Each number is the least of many turns in which everything has its turn, so that a
//! busy machine slows all alike. Every turn opens the file anew. `-- cache` measures one page of records in the second
//! cache only; `-- table FILE` takes a file of yours; `-- read FILE` does it once, for somebody who watches memory from
//! outside.

use std::fs::File;
use std::hint::black_box;
use std::io::{self, Write as _};
use std::num::NonZeroUsize;
use std::os::unix::fs::FileExt as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

use fearless_simd::{Level, Simd as _, dispatch};
use polhode_stl::{Options, Record, moments_of_file, moments_of_records};

const HEADER: usize = 84;
const TURNS: usize = 60;

fn main() -> io::Result<()> {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match words[..] {
        ["cache"] => in_cache(4096),
        ["memory"] => in_cache(20 << 18),
        ["read", path] => once(|| read(Path::new(path), options(1, true))),
        ["table", path] => table(Path::new(path), "as it is"),
        _ => {
            println!(
                "| triangles | written | threads | what | ms | ns a triangle | times the floor |\n|---|---|---|---|---|---|---|"
            );
            for (piece, written) in [(usize::MAX, "at once"), (1 << 16, "in pieces")] {
                for levels in [8, 9] {
                    table(&sphere(levels, piece)?.0, written)?;
                }
            }
            Ok(())
        }
    }
}

fn options(threads: usize, edges: bool) -> Options {
    Options { threads: NonZeroUsize::new(threads).unwrap_or(NonZeroUsize::MIN), edges }
}

fn once(work: impl Fn() -> io::Result<f64>) -> io::Result<()> {
    let begin = Instant::now();
    println!("{:e} in {:.2} ms", work()?, begin.elapsed().as_secs_f64() * 1e3);
    Ok(())
}

/// A piece of work and its name.
type Case<'a> = (&'static str, Box<dyn Fn() -> io::Result<f64> + 'a>);

fn table(path: &Path, written: &str) -> io::Result<()> {
    let triangles = (path.metadata()?.len() as usize - HEADER) / 50;
    for threads in [1, 2] {
        let cases: Vec<Case> = vec![
            ("sum of the bytes", Box::new(move || sum_read(path, threads))),
            ("moments", Box::new(move || read(path, options(threads, false)))),
            ("moments and edges", Box::new(move || read(path, options(threads, true)))),
        ];
        let mut least = vec![f64::INFINITY; cases.len()];
        for _ in 0..TURNS {
            for (least, (_, work)) in least.iter_mut().zip(&cases) {
                let begin = Instant::now();
                black_box(work()?);
                *least = least.min(begin.elapsed().as_secs_f64());
            }
        }
        for (seconds, (name, _)) in least.iter().zip(&cases) {
            let each = seconds * 1e9 / triangles as f64;
            let ratio = seconds / least[0];
            println!(
                "| {triangles} | {written} | {threads} | {name} | {:.2} | {each:.2} | {ratio:.2} |",
                seconds * 1e3
            );
        }
    }
    Ok(())
}

fn in_cache(count: usize) -> io::Result<()> {
    let sphere = sphere(9, usize::MAX)?;
    let bytes = std::fs::read(&sphere.0)?;
    let records: &[Record] = &bytes[HEADER..].as_chunks::<50>().0[..count];
    let cases: Vec<Case> = vec![
        ("sum of the bytes", Box::new(|| Ok(sum(records.as_flattened()) as f64))),
        ("moments", Box::new(|| Ok(moments_of_records(records, &options(1, false)).six_volume))),
        ("moments and edges", Box::new(|| Ok(moments_of_records(records, &options(1, true)).six_volume))),
    ];
    let mut least = vec![f64::INFINITY; cases.len()];
    for _ in 0..(200 * TURNS * 4096).div_ceil(count) {
        for (least, (_, work)) in least.iter_mut().zip(&cases) {
            let begin = Instant::now();
            black_box(work()?);
            *least = least.min(begin.elapsed().as_secs_f64());
        }
    }
    for (seconds, (name, _)) in least.iter().zip(&cases) {
        println!("| {name} | {:.2} ns a triangle |", seconds * 1e9 / count as f64);
    }
    Ok(())
}

fn read(path: &Path, options: Options) -> io::Result<f64> {
    let file = File::open(path)?;
    let count = (file.metadata()?.len() - HEADER as u64) / 50;
    Ok(moments_of_file(&file, HEADER as u64, count, &options)?.six_volume)
}

/// The sum of bytes, in the widest vectors.
fn sum(bytes: &[u8]) -> u64 {
    #[inline(always)]
    fn plain(bytes: &[u8]) -> u64 {
        bytes.chunks(1 << 16).map(|part| u64::from(part.iter().map(|&b| u32::from(b)).sum::<u32>())).sum()
    }
    dispatch!(Level::new(), simd => simd.vectorize(
        #[inline(always)]
        || plain(bytes)
    ))
}

fn sum_read(path: &Path, threads: usize) -> io::Result<f64> {
    let file = File::open(path)?;
    let length = file.metadata()?.len();
    let part = length.div_ceil(threads as u64);
    let read = |number: u64| -> io::Result<u64> {
        let mut buffer = vec![0; 1 << 18];
        let (mut at, end, mut total) = (number * part, length.min((number + 1) * part), 0);
        while at < end {
            let bytes = (buffer.len() as u64).min(end - at) as usize;
            file.read_exact_at(&mut buffer[..bytes], at)?;
            total += sum(&buffer[..bytes]);
            at += bytes as u64;
        }
        Ok(total)
    };
    let total = std::thread::scope(|scope| {
        let read = &read;
        let helpers: Vec<_> = (1..threads as u64).map(|k| scope.spawn(move || read(k))).collect();
        let own = read(0);
        helpers
            .into_iter()
            .filter_map(|helper| helper.join().ok())
            .try_fold(own?, |sum, part| Ok::<_, io::Error>(sum + part?))
    })?;
    Ok(total as f64)
}

/// A file that is removed when it has been measured: while it lies there the system may take its pages apart.
struct Temporary(PathBuf);

impl Drop for Temporary {
    fn drop(&mut self) {
        // Somebody else has removed it.
        let _ = std::fs::remove_file(&self.0);
    }
}

/// The file of an icosahedron divided so many times, on an ellipsoid off the origin, written in pieces of so many bytes.
fn sphere(levels: u32, piece: usize) -> io::Result<Temporary> {
    let triangles = 20 * 4_usize.pow(levels);
    let mut bytes = vec![b' '; 80];
    bytes.extend((triangles as u32).to_le_bytes());
    let t = 0.5 + 0.5 * 5.0_f64.sqrt();
    #[rustfmt::skip]
    let corners = [[-1.0, t, 0.0], [1.0, t, 0.0], [-1.0, -t, 0.0], [1.0, -t, 0.0], [0.0, -1.0, t], [0.0, 1.0, t],
        [0.0, -1.0, -t], [0.0, 1.0, -t], [t, 0.0, -1.0], [t, 0.0, 1.0], [-t, 0.0, -1.0], [-t, 0.0, 1.0]];
    #[rustfmt::skip]
    let faces = [[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2],
        [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11],
        [6, 2, 10], [8, 6, 7], [9, 8, 1]];
    for face in faces {
        divide(face.map(|k: usize| unit(corners[k])), levels, &mut bytes);
    }
    let path = std::env::temp_dir().join(format!("polhode-bench-{}-{levels}.stl", std::process::id()));
    let file = Temporary(path);
    let mut writer = File::create(&file.0)?;
    for piece in bytes.chunks(piece) {
        writer.write_all(piece)?;
    }
    Ok(file)
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / length)
}

fn divide([a, b, c]: [[f64; 3]; 3], levels: u32, bytes: &mut Vec<u8>) {
    if levels == 0 {
        bytes.extend([0; 12]);
        for [x, y, z] in [a, b, c] {
            for coordinate in [3.0 + 1.3 * x, -2.0 + 0.7 * y, 1.0 + z] {
                bytes.extend((coordinate as f32).to_le_bytes());
            }
        }
        bytes.extend([0; 2]);
        return;
    }
    let middle = |p: [f64; 3], q: [f64; 3]| unit([p[0] + q[0], p[1] + q[1], p[2] + q[2]]);
    let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
    for part in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
        divide(part, levels - 1, bytes);
    }
}
