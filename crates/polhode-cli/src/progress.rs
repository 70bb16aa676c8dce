//! Progress lines of long runs, shown on a terminal only.

use std::io::{self, IsTerminal as _, Write as _};
use std::path::Path;
use std::time::{Duration, Instant};

use polhode_document::layout::printable;

/// Delay before the line appears, and minimum interval between changes.
const PATIENCE: Duration = Duration::from_millis(500);

/// Last line of the terminal; cleared when dropped.
#[derive(Debug)]
struct Line {
    /// Earliest time of the next change; `None` without a terminal.
    next: Option<Instant>,
    shown: bool,
}

impl Line {
    fn new(is_wanted: bool) -> Self {
        let is_wanted = is_wanted && io::stderr().is_terminal();
        Self { next: is_wanted.then(|| Instant::now() + PATIENCE), shown: false }
    }

    /// Shows a text, at most once per `pause`.
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

/// Progress of the computation of a motion.
#[derive(Debug)]
pub(crate) struct Progress {
    end: f64,
    steps: u32,
    line: Line,
}

impl Progress {
    /// Steps between two checks of the clock.
    const STRIDE: u32 = 4096;

    /// Creates the progress of a run that ends at `end`, s.
    pub(crate) fn new(end: f64) -> Self {
        Self { end, steps: 0, line: Line::new(true) }
    }

    /// Reports that the run has reached `time`, s.
    pub(crate) fn reached(&mut self, time: f64) {
        self.steps = self.steps.wrapping_add(1);
        if self.steps.is_multiple_of(Self::STRIDE) {
            let end = self.end;
            self.line.show(PATIENCE, || format!("{:3.0} %   t = {time:.6} of {end} s", 100.0 * time / end));
        }
    }
}

/// Progress of the random draws for a parts list.
#[derive(Debug)]
pub(crate) struct DrawProgress {
    line: Line,
}

impl DrawProgress {
    /// Creates the progress; it counts the draws of each configuration.
    pub(crate) fn new() -> Self {
        Self { line: Line::new(true) }
    }

    /// Reports that `drawn` of `count` bodies are drawn.
    pub(crate) fn reached(&mut self, drawn: usize, count: usize) {
        self.line.show(PATIENCE, || format!("{:3} %   {drawn} of {count} draws", 100 * drawn / count.max(1)));
    }
}

/// Progress of reading several files.
#[derive(Debug)]
pub(crate) struct FileProgress {
    count: usize,
    done: usize,
    line: Line,
}

impl FileProgress {
    /// Width of the bar, characters.
    const WIDTH: usize = 20;

    /// Creates the progress for `count` files; a single file shows nothing.
    pub(crate) fn new(count: usize) -> Self {
        Self { count, done: 0, line: Line::new(count > 1) }
    }

    /// Reports that the next file is being read.
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

/// Progress of the numerical integration of a density.
#[derive(Debug)]
pub(crate) struct SampleProgress {
    pieces: u64,
    looked_at: u64,
    samples: u64,
    line: Line,
}

impl SampleProgress {
    /// Pieces between two checks of the clock.
    const STRIDE: u64 = 256;

    /// Creates the progress for `pieces` pieces; each is sampled at least once.
    pub(crate) fn new(pieces: usize) -> Self {
        Self { pieces: pieces as u64, looked_at: 0, samples: 0, line: Line::new(true) }
    }

    /// Reports that a piece, or half of one, has been sampled at `samples` points.
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
