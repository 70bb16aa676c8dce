//! Progress line of a sweep, shown on a terminal only.

use std::io::{self, IsTerminal as _, Write as _};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use polhode_sweep::Progress;

/// Delay before the line appears.
const PATIENCE: Duration = Duration::from_millis(500);

/// Progress of a sweep; its line is cleared when dropped.
#[derive(Debug)]
pub(super) struct SweepProgress {
    line: Option<Mutex<Line>>,
}

#[derive(Debug)]
struct Line {
    began: Instant,
    next: Instant,
    /// Number of finished members when the first part was reported.
    first: Option<u64>,
    shown: bool,
}

impl SweepProgress {
    const WIDTH: u64 = 24;

    pub(super) fn new() -> Self {
        let now = Instant::now();
        let line = Line { began: now, next: now + PATIENCE, first: None, shown: false };
        Self { line: io::stderr().is_terminal().then(|| Mutex::new(line)) }
    }

    /// Reports a finished part.
    pub(super) fn reached(&self, Progress { done, members, .. }: Progress) {
        let Some(Ok(mut line)) = self.line.as_ref().map(Mutex::lock) else { return };
        let now = Instant::now();
        let first = *line.first.get_or_insert(done);
        if now < line.next {
            return;
        }
        let full = done.saturating_mul(Self::WIDTH).checked_div(members).unwrap_or(0).min(Self::WIDTH);
        let bar = format!("{}{}", "█".repeat(full as usize), "░".repeat((Self::WIDTH - full) as usize));
        let rate = done.saturating_sub(first) as f64 / (now - line.began).as_secs_f64();
        let left = if rate > 0.0 { remaining((members - done) as f64 / rate) } else { String::new() };
        let _ = write!(io::stderr(), "\r\x1b[K{bar} {done} of {members} members{left}");
        line.next = now + PATIENCE / 5;
        line.shown = true;
    }
}

impl Drop for SweepProgress {
    fn drop(&mut self) {
        if let Some(Ok(line)) = self.line.as_ref().map(Mutex::lock)
            && line.shown
        {
            let _ = write!(io::stderr(), "\r\x1b[K");
        }
    }
}

/// Formats the remaining time: `, 3 min left`.
fn remaining(seconds: f64) -> String {
    match seconds {
        s if s < 100.0 => format!(", {s:.0} s left"),
        s if s < 6000.0 => format!(", {:.0} min left", s / 60.0),
        s => format!(", {:.1} h left", s / 3600.0),
    }
}
