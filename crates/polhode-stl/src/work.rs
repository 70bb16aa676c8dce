//! Blocks of a file, shared among threads.

use std::fs::File;
use std::io;
use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use fearless_simd::Level;

use crate::block::Block;
use crate::moments::{Moments, Part};
use crate::record::{Record, VERTICES};

/// Triangles that are read at once: 200 KiB, which stay in the second cache.
const PAGE: usize = 4096;

/// The fewest triangles of a block that is not the last: whole pages. To begin and end one takes half a microsecond.
const BLOCK: u64 = 4 * PAGE as u64;

/// The most blocks of a file: each thread has long stretches of it, and what is kept of them is at most 50 KiB however long it is.
const MOST_BLOCKS: u64 = 128;

/// Triangles whose corners are averaged for the reference point.
const SAMPLES: u64 = 64;

/// How to sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// How many threads; the result does not depend on it.
    pub threads: NonZeroUsize,
    /// Whether to hash the edges.
    pub edges: bool,
}

impl Default for Options {
    /// One thread; edges too.
    fn default() -> Self {
        Self { threads: NonZeroUsize::MIN, edges: true }
    }
}

/// The moments of records in memory.
pub fn moments_of_records(records: &[Record], options: &Options) -> Moments {
    moments_at_level(records, options, Level::new())
}

pub(crate) fn moments_at_level(records: &[Record], options: &Options, level: Level) -> Moments {
    let count = records.len() as u64;
    let block_length = block_length(count);
    let reference = reference(sampled(count).map(|k| records[k as usize]));
    let sum = |number: u64, _: &mut ()| {
        let mut block = Block::new();
        let from = (number * block_length) as usize;
        let length = block_length.min(count - number * block_length) as usize;
        block.add(level, &records[from..from + length], reference, options.edges);
        Ok(Part::of(&block))
    };
    // Nothing is read, so nothing fails.
    let blocks = shared(count.div_ceil(block_length), options.threads, || (), sum).unwrap_or_default();
    Moments::joined(count, block_length, reference, &blocks, options.edges)
}

/// The moments of records in a file, from a byte on: read page by page, each thread with a buffer of 200 KiB.
///
/// ```
/// use polhode_stl::{Options, moments_of_file};
/// let file = std::fs::File::open(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/bracket.stl"))?;
/// let count = (file.metadata()?.len() - 84) / 50;
/// let moments = moments_of_file(&file, 84, count, &Options::default())?;
/// assert_eq!(moments.count, 216);
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// What the system says; [`io::ErrorKind::UnexpectedEof`] if the file ends before the last record.
pub fn moments_of_file(file: &File, from: u64, count: u64, options: &Options) -> io::Result<Moments> {
    let level = Level::new();
    let block_length = block_length(count);
    let mut samples = Vec::new();
    for k in sampled(count) {
        let mut record = [0; size_of::<Record>()];
        read_exactly(file, &mut record, from + k * size_of::<Record>() as u64)?;
        samples.push(record);
    }
    let reference = reference(samples.into_iter());
    let page = (PAGE as u64).min(count) as usize;
    let sum = |number: u64, buffer: &mut Vec<Record>| {
        let mut block = Block::new();
        let (mut at, end) = (number * block_length, count.min((number + 1) * block_length));
        while at < end {
            let records = &mut buffer[..page.min((end - at) as usize)];
            read_exactly(file, records.as_flattened_mut(), from + at * size_of::<Record>() as u64)?;
            block.add(level, records, reference, options.edges);
            at += records.len() as u64;
        }
        Ok(Part::of(&block))
    };
    let buffer = || vec![[0; size_of::<Record>()]; page];
    let blocks = shared(count.div_ceil(block_length), options.threads, buffer, sum)?;
    Ok(Moments::joined(count, block_length, reference, &blocks, options.edges))
}

/// Triangles in a block.
fn block_length(count: u64) -> u64 {
    count.div_ceil(MOST_BLOCKS).next_multiple_of(BLOCK).max(BLOCK)
}

/// Every block's result in the order of the blocks; each thread takes the next block that is left.
fn shared<B>(
    blocks: u64,
    threads: NonZeroUsize,
    buffer: impl Fn() -> B + Sync,
    sum: impl Fn(u64, &mut B) -> io::Result<Part> + Sync,
) -> io::Result<Vec<Part>> {
    let next = AtomicU64::new(0);
    let work = || -> io::Result<Vec<(u64, Part)>> {
        let mut buffer = buffer();
        let mut done = Vec::new();
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= blocks {
                return Ok(done);
            }
            done.push((number, sum(number, &mut buffer)?));
        }
    };
    let helpers = threads.get().min(blocks as usize).saturating_sub(1);
    let mut done = thread::scope(|scope| {
        // Where the system gives no more threads, those that there are do it all.
        let helper = |_| thread::Builder::new().spawn_scoped(scope, work).ok();
        let helpers: Vec<_> = (0..helpers).filter_map(helper).collect();
        let mut done = work()?;
        for helper in helpers {
            done.extend(helper.join().map_err(|_| io::Error::other("a thread of the sums ended early"))??);
        }
        Ok::<_, io::Error>(done)
    })?;
    done.sort_unstable_by_key(|(number, _)| *number);
    Ok(done.into_iter().map(|(_, block)| block).collect())
}

/// Triangles at even distances.
fn sampled(count: u64) -> impl Iterator<Item = u64> {
    let samples = count.min(SAMPLES);
    (0..samples).map(move |k| (u128::from(k) * u128::from(count) / u128::from(samples)) as u64)
}

/// The mean of the first corners, rounded to `f32`: then the differences from it are as exact as those of the corners.
fn reference(samples: impl Iterator<Item = Record>) -> [f64; 3] {
    let corners = samples.map(|record| {
        let words = record[VERTICES..].as_chunks::<4>().0;
        [words[0], words[1], words[2]].map(|word| f64::from(f32::from_le_bytes(word)))
    });
    let (mut sum, mut finite) = ([0.0; 3], 0.0);
    for corner in corners.filter(|corner| corner.iter().all(|c| c.is_finite())) {
        sum = [sum[0] + corner[0], sum[1] + corner[1], sum[2] + corner[2]];
        finite += 1.0;
    }
    if finite == 0.0 { [0.0; 3] } else { sum.map(|s| f64::from((s / finite) as f32)) }
}

#[cfg(unix)]
fn read_exactly(file: &File, bytes: &mut [u8], from: u64) -> io::Result<()> {
    std::os::unix::fs::FileExt::read_exact_at(file, bytes, from)
}

#[cfg(windows)]
fn read_exactly(file: &File, bytes: &mut [u8], from: u64) -> io::Result<()> {
    let mut done = 0;
    while done < bytes.len() {
        match std::os::windows::fs::FileExt::seek_read(file, &mut bytes[done..], from + done as u64)? {
            0 => return Err(io::ErrorKind::UnexpectedEof.into()),
            read => done += read,
        }
    }
    Ok(())
}

#[cfg(not(any(unix, windows)))]
fn read_exactly(_: &File, _: &mut [u8], _: u64) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coordinates of all sizes and signs, none special.
    fn records(count: usize) -> Vec<Record> {
        let mut state = 0x9E37_79B9_7F4A_7C15_u64;
        let mut next = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            let fraction = (state >> 40) as f32 / 16_777_216.0 - 0.37;
            fraction * 2.0_f32.powi((state % 7) as i32)
        };
        let mut record = || {
            let mut bytes = [0x5A; size_of::<Record>()];
            for word in bytes[VERTICES..48].as_chunks_mut::<4>().0 {
                *word = next().to_le_bytes();
            }
            bytes
        };
        (0..count).map(|_| record()).collect()
    }

    /// The sums in plain Rust, lane by lane as the vectors have them.
    fn plain(records: &[Record], r: [f64; 3]) -> Block {
        let mut block = Block::new();
        for chunk in records.chunks(1024) {
            let mut sums = [[0.0; 8]; 11];
            for (k, record) in chunk.iter().enumerate() {
                let words = record[VERTICES..].as_chunks::<4>().0;
                let vertex = |v: usize| -> [f64; 3] {
                    core::array::from_fn(|c| f64::from(f32::from_le_bytes(words[3 * v + c])))
                };
                let (a, b, c) = (vertex(0), vertex(1), vertex(2));
                let e: [f64; 3] = core::array::from_fn(|k| b[k] - a[k]);
                let f: [f64; 3] = core::array::from_fn(|k| c[k] - a[k]);
                let less = |i: usize, j: usize| e[i].mul_add(f[j], -(e[j] * f[i]));
                let n = [less(1, 2), less(2, 0), less(0, 1)];
                let dot = |a: [f64; 3]| a[2].mul_add(n[2], a[1].mul_add(n[1], a[0] * n[0]));
                let a: [f64; 3] = core::array::from_fn(|k| a[k] - r[k]);
                let d = dot(a);
                let sum = |a: [f64; 3], b: [f64; 3]| -> [f64; 3] { core::array::from_fn(|k| a[k] + b[k]) };
                let (p, r) = (sum(sum(a, a), e), sum(sum(a, a), f));
                let q = sum(p, f);
                let s = sum(q, a);
                let lane = k % 2 * 4 + k % 8 / 2;
                sums[0][lane] += d;
                for k in 0..3 {
                    sums[1 + k][lane] = d.mul_add(s[k], sums[1 + k][lane]);
                }
                for (k, (i, j)) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].into_iter().enumerate() {
                    let product = r[i].mul_add(r[j], q[i].mul_add(q[j], p[i] * p[j]));
                    sums[4 + k][lane] = d.mul_add(product, sums[4 + k][lane]);
                }
                sums[10][lane] += dot(n).sqrt();
            }
            for (k, sums) in sums.iter().enumerate() {
                for (lane, &b) in sums.iter().enumerate() {
                    let a = block.sums[k][lane];
                    let s = a + b;
                    let bb = s - a;
                    block.errors[k][lane] += (a - (s - bb)) + (b - bb);
                    block.sums[k][lane] = s;
                }
            }
        }
        block
    }

    #[test]
    fn every_width_of_vectors_has_the_bits_of_plain_numbers() {
        let records = records(4096);
        let reference = [0.25, -1.5, 3.0];
        let plain = plain(&records, reference);
        for level in levels() {
            let block = with_room(|| {
                let mut block = Block::new();
                block.add(level, &records, reference, true);
                block
            });
            assert_eq!((block.sums, block.errors), (plain.sums, plain.errors), "{level:?}");
        }
    }

    #[test]
    fn every_width_of_vectors_has_the_same_moments() {
        for count in [1, 7, 16, 100, 5000] {
            let records = records(count);
            let of = |level| with_room(|| moments_at_level(&records, &Options::default(), level));
            let widest = of(Level::new());
            for level in levels() {
                assert_eq!(of(level), widest, "{count} {level:?}");
            }
        }
    }

    /// On a stack of 64 MiB: unoptimised, as these tests are, each of the unrolled vectors has a place of its own there.
    fn with_room<T: Send>(work: impl FnOnce() -> T + Send) -> T {
        thread::scope(|scope| {
            thread::Builder::new().stack_size(64 << 20).spawn_scoped(scope, work).unwrap().join().unwrap()
        })
    }

    /// All that this machine has.
    fn levels() -> Vec<Level> {
        let widest = Level::new();
        #[cfg(target_arch = "x86_64")]
        let narrower = [
            widest.as_sse2().map(Level::Sse2),
            widest.as_sse4_2().map(Level::Sse4_2),
            widest.as_avx2().map(Level::Avx2),
        ];
        #[cfg(not(target_arch = "x86_64"))]
        let narrower = [None];
        narrower.into_iter().flatten().chain([widest]).collect()
    }
}
