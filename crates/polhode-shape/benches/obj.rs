//! Benchmark of OBJ reading, in bytes per second, on one thread. Run with `cargo bench -p
//! polhode-shape --bench obj`.
//!
//! Each output line contains the case, the rate of the fastest run, and the unit.

use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::hint::black_box;
use std::time::Instant;

use polhode_shape::mesh::obj;

/// Size of the test mesh: a dented sphere of n × 2n rectangles with two triangles each.
const N: usize = 572;

/// Returns the processor time, s, which does not depend on other programs. Where it is not
/// available, returns the elapsed time.
fn now(begin: Instant) -> f64 {
    let nanoseconds = fs::read_to_string("/proc/thread-self/schedstat")
        .ok()
        .and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| begin.elapsed().as_secs_f64(), |ns| ns * 1e-9)
}

/// Returns the time of the fastest of many runs, s.
fn least(mut work: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    let begin = Instant::now();
    while begin.elapsed().as_secs_f64() < 3.0 {
        let start = now(begin);
        work();
        least = least.min(now(begin) - start);
    }
    least
}

fn vertices() -> Vec<[f64; 3]> {
    let at = |i: usize, j: usize| {
        let (theta, phi) = (i as f64 * 3.0 / N as f64 + 0.07, j as f64 * 3.1 / N as f64);
        let r = 1.3 + 0.2 * (5.0 * theta).sin() * (3.0 * phi).cos();
        [r * theta.sin() * phi.cos() + 0.4, 37.1 * r * theta.sin() * phi.sin(), 0.013 * r * theta.cos()]
    };
    (0..=N).flat_map(|i| (0..=2 * N).map(move |j| at(i, j))).collect()
}

fn faces() -> Vec<[usize; 4]> {
    let width = 2 * N + 1;
    let at = |i, j| {
        [i * width + j, (i + 1) * width + j, (i + 1) * width + j + 1, i * width + j + 1].map(|k| k + 1)
    };
    (0..N).flat_map(|i| (0..2 * N).map(move |j| at(i, j))).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let (vertices, faces) = (vertices(), faces());
    let lines = |write: &dyn Fn(f64) -> String| {
        vertices.iter().fold(String::new(), |text, &[x, y, z]| {
            text + &format!("v {} {} {}\n", write(x), write(y), write(z))
        })
    };
    let mut triangles = [String::new(), String::new(), String::new()];
    for &[a, b, c, d] in &faces {
        for [a, b, c] in [[a, b, c], [a, c, d]] {
            writeln!(triangles[0], "f {a} {b} {c}")?;
            writeln!(triangles[1], "f {a}/{a} {b}/{b} {c}/{c}")?;
            writeln!(triangles[2], "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}")?;
        }
    }
    let digits: [(&str, &dyn Fn(f64) -> String); 3] = [
        ("6 decimals", &|x| format!("{x:.6}")),
        ("9 digits", &|x| format!("{x:.8e}").parse::<f64>().map_or(String::new(), |x| x.to_string())),
        ("17 digits", &|x| x.to_string()),
    ];
    for (digits, write) in digits {
        let vertices = lines(write);
        for (form, faces) in ["f a b c", "f a/b", "f a/b/c"].iter().zip(&triangles) {
            let text = [vertices.as_str(), faces].concat();
            let seconds = least(|| {
                black_box(obj::read(black_box(text.as_bytes())).is_ok());
            });
            println!(
                "OBJ, {digits}, {form}, {} MB\t{:.3}\tGB/s",
                text.len() / 1_000_000,
                text.len() as f64 / seconds / 1e9
            );
        }
    }
    let normals =
        vertices.iter().fold(String::new(), |text, [x, y, z]| text + &format!("vn {x:.4} {y:.4} {z:.4}\n"));
    let quads = faces
        .iter()
        .fold(String::new(), |text, [a, b, c, d]| text + &format!("f {a}//{a} {b}//{b} {c}//{c} {d}//{d}\n"));
    let text = [lines(&|x| format!("{x:.6}")), normals, quads].concat();
    let seconds = least(|| {
        black_box(obj::read(black_box(text.as_bytes())).is_ok());
    });
    println!(
        "OBJ, 6 decimals, normals, quadrilaterals, {} MB\t{:.3}\tGB/s",
        text.len() / 1_000_000,
        text.len() as f64 / seconds / 1e9
    );
    Ok(())
}
