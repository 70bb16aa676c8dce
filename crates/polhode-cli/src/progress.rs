//! A line that shows how far a long run is, on a terminal; nothing in a pipe.

use std::io::{self, IsTerminal as _, Write as _};
use std::path::Path;
use std::time::{Duration, Instant};

use polhode_report::plain::printable;

/// A run shorter than this shows nothing, and the line changes no more often.
const PATIENCE: Duration = Duration::from_millis(500);

/// Steps between two looks at the clock.
const STRIDE: u32 = 4096;

/// How far a run is; dropped, it takes its line away.
#[derive(Debug)]
pub(crate) struct Progress {
    end: f64,
    steps: u32,
    next: Option<Instant>,
    shown: bool,
}

impl Progress {
    /// The progress of a run that ends at `end`, s.
    pub(crate) fn new(end: f64) -> Self {
        let next = io::stderr().is_terminal().then(|| Instant::now() + PATIENCE);
        Self { end, steps: 0, next, shown: false }
    }

    /// The run has reached `time`, s.
    pub(crate) fn reached(&mut self, time: f64) {
        self.steps = self.steps.wrapping_add(1);
        let Some(next) = self.next.filter(|_| self.steps.is_multiple_of(STRIDE)) else { return };
        let now = Instant::now();
        if now >= next {
            let percent = 100.0 * time / self.end;
            let _ = write!(io::stderr(), "\r\x1b[K{percent:3.0} %   t = {time:.6} of {} s", self.end);
            self.next = Some(now + PATIENCE);
            self.shown = true;
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.shown {
            let _ = write!(io::stderr(), "\r\x1b[K");
        }
    }
}

/// How many bodies of a parts list have been drawn; dropped, it takes its line away.
#[derive(Debug)]
pub(crate) struct DrawProgress {
    count: usize,
    next: Option<Instant>,
    shown: bool,
}

impl DrawProgress {
    /// The progress of `count` draws of each configuration.
    pub(crate) fn new(count: usize) -> Self {
        Self { count, next: io::stderr().is_terminal().then(|| Instant::now() + PATIENCE), shown: false }
    }

    /// So many bodies have been drawn.
    pub(crate) fn reached(&mut self, drawn: usize) {
        let now = Instant::now();
        if self.next.is_some_and(|next| now >= next) {
            let percent = 100 * drawn / self.count.max(1);
            let _ = write!(io::stderr(), "\r\x1b[K{percent:3} %   {drawn} of {} draws", self.count);
            self.next = Some(now + PATIENCE);
            self.shown = true;
        }
    }
}

impl Drop for DrawProgress {
    fn drop(&mut self) {
        if self.shown {
            let _ = write!(io::stderr(), "\r\x1b[K");
        }
    }
}

/// Which of several files is being read, and how many there are; dropped, it takes its line away.
#[derive(Debug)]
pub(crate) struct FileProgress {
    count: usize,
    done: usize,
    next: Option<Instant>,
    shown: bool,
}

impl FileProgress {
    /// The bar's width.
    const WIDTH: usize = 20;

    /// The progress through so many files; one alone shows nothing.
    pub(crate) fn new(count: usize) -> Self {
        let next = (count > 1 && io::stderr().is_terminal()).then(|| Instant::now() + PATIENCE);
        Self { count, done: 0, next, shown: false }
    }

    /// The next file's turn has come.
    pub(crate) fn next(&mut self, file: &Path) {
        let (done, count) = (self.done, self.count);
        self.done += 1;
        let now = Instant::now();
        if self.next.is_some_and(|next| now >= next) {
            let full = Self::WIDTH * done / count;
            let bar = format!("{}{}", "█".repeat(full), "░".repeat(Self::WIDTH - full));
            let name = file.file_name().map(|name| printable(&name.to_string_lossy()));
            let _ =
                write!(io::stderr(), "\r\x1b[K{bar} {} of {count}  {}", done + 1, name.unwrap_or_default());
            self.next = Some(now + PATIENCE / 5);
            self.shown = true;
        }
    }
}

impl Drop for FileProgress {
    fn drop(&mut self) {
        if self.shown {
            let _ = write!(io::stderr(), "\r\x1b[K");
        }
    }
}

/// How many values of a density have been asked for; dropped, it takes its line away.
#[derive(Debug)]
pub(crate) struct SampleProgress {
    pieces: u64,
    looked_at: u64,
    samples: u64,
    next: Option<Instant>,
    shown: bool,
}

impl SampleProgress {
    /// Pieces between two looks at the clock.
    const STRIDE: u64 = 256;

    /// The progress of a cubature over so many pieces, each of which is looked at once at least.
    pub(crate) fn new(pieces: usize) -> Self {
        let next = io::stderr().is_terminal().then(|| Instant::now() + PATIENCE);
        Self { pieces: pieces as u64, looked_at: 0, samples: 0, next, shown: false }
    }

    /// One more piece, or half of one, has been looked at with so many samples.
    pub(crate) fn looked_at(&mut self, samples: usize) {
        self.looked_at += 1;
        self.samples += samples as u64;
        let Some(next) = self.next.filter(|_| self.looked_at.is_multiple_of(Self::STRIDE)) else { return };
        let now = Instant::now();
        if now >= next {
            let state = if self.looked_at < self.pieces {
                format!("{:3} %", 100 * self.looked_at / self.pieces)
            } else {
                "refining".to_owned()
            };
            let millions = self.samples / 1_000_000;
            let _ = write!(io::stderr(), "\r\x1b[K{state}   {millions} million values of the density");
            self.next = Some(now + PATIENCE);
            self.shown = true;
        }
    }
}

impl Drop for SampleProgress {
    fn drop(&mut self) {
        if self.shown {
            let _ = write!(io::stderr(), "\r\x1b[K");
        }
    }
}
