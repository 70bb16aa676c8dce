//! Lines that show the progress of a long run, on a terminal; nothing in a pipe.

use std::io::{self, IsTerminal as _, Write as _};
use std::path::Path;
use std::time::{Duration, Instant};

use polhode_document::layout::printable;

/// A run shorter than this shows nothing, and the line changes no more often.
const PATIENCE: Duration = Duration::from_millis(500);

/// The last line of a terminal; dropped, it is cleared.
#[derive(Debug)]
struct Line {
    /// The time from which it may change; `None` without a terminal.
    next: Option<Instant>,
    shown: bool,
}

impl Line {
    fn new(is_wanted: bool) -> Self {
        let is_wanted = is_wanted && io::stderr().is_terminal();
        Self { next: is_wanted.then(|| Instant::now() + PATIENCE), shown: false }
    }

    /// Shows a text, if the last one was shown long enough, `pause`.
    fn show(&mut self, pause: Duration, text: impl FnOnce() -> String) {
        let now = Instant::now();
        if self.next.is_some_and(|next| now >= next) {
            let _ = write!(io::stderr(), "\r\x1b[K{}", text());
            (self.next, self.shown) = (Some(now + pause), true);
        }
    }
}

impl Drop for Line {
    fn drop(&mut self) {
        if self.shown {
            let _ = write!(io::stderr(), "\r\x1b[K");
        }
    }
}

/// Progress of a motion.
#[derive(Debug)]
pub(crate) struct Progress {
    end: f64,
    steps: u32,
    line: Line,
}

impl Progress {
    /// Steps between two looks at the clock.
    const STRIDE: u32 = 4096;

    /// The progress of a run that ends at `end`, s.
    pub(crate) fn new(end: f64) -> Self {
        Self { end, steps: 0, line: Line::new(true) }
    }

    /// The run has reached `time`, s.
    pub(crate) fn reached(&mut self, time: f64) {
        self.steps = self.steps.wrapping_add(1);
        if self.steps.is_multiple_of(Self::STRIDE) {
            let end = self.end;
            self.line.show(PATIENCE, || format!("{:3.0} %   t = {time:.6} of {end} s", 100.0 * time / end));
        }
    }
}

/// Progress of the draws of a parts list.
#[derive(Debug)]
pub(crate) struct DrawProgress {
    line: Line,
}

impl DrawProgress {
    /// The progress of the draws of each configuration.
    pub(crate) fn new() -> Self {
        Self { line: Line::new(true) }
    }

    /// `drawn` of `count` bodies have been drawn.
    pub(crate) fn reached(&mut self, drawn: usize, count: usize) {
        self.line.show(PATIENCE, || format!("{:3} %   {drawn} of {count} draws", 100 * drawn / count.max(1)));
    }
}

/// Progress through several files.
#[derive(Debug)]
pub(crate) struct FileProgress {
    count: usize,
    done: usize,
    line: Line,
}

impl FileProgress {
    /// Width of the bar, characters.
    const WIDTH: usize = 20;

    /// The progress through `count` files; a single one shows nothing.
    pub(crate) fn new(count: usize) -> Self {
        Self { count, done: 0, line: Line::new(count > 1) }
    }

    /// The next file is being read.
    pub(crate) fn next(&mut self, file: &Path) {
        let (done, count) = (self.done, self.count);
        self.done += 1;
        self.line.show(PATIENCE / 5, || {
            let full = Self::WIDTH * done / count;
            let bar = format!("{}{}", "█".repeat(full), "░".repeat(Self::WIDTH - full));
            let name = file.file_name().map(|name| printable(&name.to_string_lossy()));
            format!("{bar} {} of {count}  {}", done + 1, name.unwrap_or_default())
        });
    }
}

/// Progress of the cubature of a density.
#[derive(Debug)]
pub(crate) struct SampleProgress {
    pieces: u64,
    looked_at: u64,
    samples: u64,
    line: Line,
}

impl SampleProgress {
    /// Pieces between two looks at the clock.
    const STRIDE: u64 = 256;

    /// The progress of a cubature over `pieces` pieces, each of which is sampled at least once.
    pub(crate) fn new(pieces: usize) -> Self {
        Self { pieces: pieces as u64, looked_at: 0, samples: 0, line: Line::new(true) }
    }

    /// One more piece, or half of one, has been sampled at `samples` points.
    pub(crate) fn looked_at(&mut self, samples: usize) {
        self.looked_at += 1;
        self.samples += samples as u64;
        if !self.looked_at.is_multiple_of(Self::STRIDE) {
            return;
        }
        let (done, pieces, millions) = (self.looked_at, self.pieces, self.samples / 1_000_000);
        self.line.show(PATIENCE, || {
            let state =
                if done < pieces { format!("{:3} %", 100 * done / pieces) } else { "refining".to_owned() };
            format!("{state}   {millions} million values of the density")
        });
    }
}
