//! Runs the stored corpora of the fuzz targets (`fuzz/README.md`), with each input truncated and
//! with single bits flipped.

#[path = "../../../../fuzz/src/lib.rs"]
mod targets;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use targets::{TARGETS, Target};

/// Number of truncations of each input.
const CUTS: usize = 20;
const FLIPS: usize = 20;

#[test]
fn every_stored_input_holds_cut_short_and_with_a_bit_turned_over() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus");
    let mut inputs: Vec<(&str, Target, PathBuf)> = Vec::new();
    for (name, target) in TARGETS {
        let stored = files(&corpus.join(name));
        assert!(!stored.is_empty(), "fuzz/corpus/{name} is empty");
        let all = stored.into_iter().chain(files(&corpus.join("regressions").join(name)));
        inputs.extend(all.map(|path| (name, target, path)));
    }
    let next = AtomicUsize::new(0);
    let work = || {
        while let Some((name, target, path)) = inputs.get(next.fetch_add(1, Ordering::Relaxed)) {
            for_variants(&fs::read(path).unwrap(), &mut |what, data| {
                let outcome = catch_unwind(AssertUnwindSafe(|| target(data)));
                assert!(outcome.is_ok(), "{name}, {}{what}", path.display());
            });
        }
    };
    std::thread::scope(|scope| (0..2).for_each(|_| drop(scope.spawn(work))));
}

#[test]
fn corpora_and_programs_have_the_names_of_targets() {
    let fuzz = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz");
    for folder in ["corpus", "corpus/regressions", "fuzz_targets"] {
        for path in files(&fuzz.join(folder)) {
            let name = path.file_stem().and_then(|name| name.to_str()).unwrap();
            assert!(name == "regressions" || targets::target(name).is_some(), "{name} is no target");
        }
    }
    let manifest = fs::read_to_string(fuzz.join("Cargo.toml")).unwrap();
    for (name, _) in TARGETS {
        assert!(fuzz.join("fuzz_targets").join(name).with_extension("rs").is_file(), "{name} has no program");
        assert!(manifest.contains(&format!("name = \"{name}\"")), "cargo fuzz does not know {name}");
    }
}

/// Fuzzes targets for a given time, and prints a line for each target.
///
/// `POLHODE_FUZZ="identify live" POLHODE_FUZZ_SECONDS=60 cargo test -p polhode-cli --test all
/// mutations -- --ignored --nocapture` runs two targets for 60 s each. The seed is in
/// `POLHODE_FUZZ_SEED`.
#[test]
#[ignore = "random search for as long as POLHODE_FUZZ_SECONDS says; the gate runs the stored inputs"]
fn mutations_of_the_stored_inputs_hold() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus");
    let told = |name: &str, default: &str| std::env::var(name).unwrap_or_else(|_| default.to_owned());
    let seconds: f64 = told("POLHODE_FUZZ_SECONDS", "10").parse().unwrap();
    let mut random = Random(told("POLHODE_FUZZ_SEED", "1").parse::<u64>().unwrap().max(1));
    for name in told("POLHODE_FUZZ", "").split_whitespace() {
        let target = targets::target(name).unwrap();
        let seeds: Vec<Vec<u8>> =
            files(&corpus.join(name)).iter().map(|path| fs::read(path).unwrap()).collect();
        let (start, mut count, mut longest) = (std::time::Instant::now(), 0_u64, 0.0_f64);
        while start.elapsed().as_secs_f64() < seconds {
            let data = random.mutated(&seeds);
            let before = start.elapsed();
            let outcome = catch_unwind(AssertUnwindSafe(|| target(&data)));
            assert!(outcome.is_ok(), "{name}: {:?}", String::from_utf8_lossy(&data));
            longest = longest.max((start.elapsed() - before).as_secs_f64());
            count += 1;
        }
        println!("{name}: {count} inputs in {seconds} s, the longest {longest:.3} s");
    }
}

/// Random generator xorshift64.
struct Random(u64);

impl Random {
    fn below(&mut self, most: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % most.max(1)
    }

    /// Returns a seed with up to eight changes: bits, bytes, words of its format, truncations,
    /// repetitions, parts of another seed.
    fn mutated(&mut self, seeds: &[Vec<u8>]) -> Vec<u8> {
        const WORDS: [&str; 16] = [
            "0",
            "-1",
            "1e308",
            "nan",
            "inf",
            "1e-320",
            "9007199254740993",
            "\"",
            "[",
            "]",
            "{",
            "}",
            ",",
            "\n",
            "=",
            "\\u0000",
        ];
        let mut data = seeds[self.below(seeds.len())].clone();
        for _ in 0..=self.below(8) {
            let at = self.below(data.len() + 1);
            let end = at + self.below((data.len() - at).min(40) + 1);
            match self.below(6) {
                0 if at < data.len() => data[at] ^= 1 << self.below(8),
                1 if at < data.len() => data[at] = self.below(256) as u8,
                2 => drop(data.splice(at..end, WORDS[self.below(WORDS.len())].bytes())),
                3 => drop(data.drain(at..end)),
                4 => {
                    let part = data[at..end].to_vec();
                    let to = self.below(data.len() + 1);
                    drop(data.splice(to..to, part));
                }
                _ => {
                    let other = &seeds[self.below(seeds.len())];
                    let from = self.below(other.len() + 1);
                    let to = from + self.below((other.len() - from).min(200) + 1);
                    drop(data.splice(at..end, other[from..to].iter().copied()));
                }
            }
        }
        data
    }
}

/// Runs the input, its first k/20, and copies with one flipped bit. The positions depend only on
/// the length of the input.
fn for_variants(data: &[u8], run: &mut dyn FnMut(String, &[u8])) {
    run(String::new(), data);
    for k in 0..CUTS {
        let length = data.len() * k / CUTS;
        run(format!(", first {length} bytes"), &data[..length]);
    }
    let mut random = 0x9e37_79b9_7f4a_7c15_u64 ^ data.len() as u64;
    let mut turned = data.to_vec();
    for _ in 0..FLIPS.min(8 * data.len()) {
        // Xorshift64.
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        let (byte, bit) = (random as usize % data.len(), random >> 61);
        turned[byte] ^= 1 << bit;
        run(format!(", bit {bit} of byte {byte}"), &turned);
        turned[byte] ^= 1 << bit;
    }
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
}
