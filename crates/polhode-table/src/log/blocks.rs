//! Text in blocks of whole lines. The parts of a block are read in parallel, so a log does not have
//! to fit in memory as text.

use std::io::{self, Read};
use std::thread;

use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::choice::Plan;
use super::rows::{RowError, Rows};

/// Size of a block, bytes, and least size of a part for which a thread is started.
const BLOCK: usize = 8 << 20;
const PART: usize = 1 << 18;
/// Largest number of threads. More threads would wait for the file.
const MOST_THREADS: usize = 8;
/// Largest length of a line, bytes. No line of a log is longer.
const LONGEST_LINE: usize = 64 << 20;

/// Reason why rows could not be read.
#[derive(Debug)]
pub(crate) enum Failure {
    Io(io::Error),
    Content(ContentError),
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

impl From<ContentError> for Failure {
    fn from(error: ContentError) -> Self {
        Self::Content(error)
    }
}

/// Reader of whole lines as rows.
pub(crate) trait Lines: Sync {
    /// Reads the rows of a text at an offset in the file.
    fn rows(&self, text: &[u8], offset: usize) -> Result<Rows, RowError>;
}

/// Text of which a part is in memory.
pub(crate) struct Blocks<R> {
    stream: R,
    bytes: Vec<u8>,
    /// Offset of these bytes in the file.
    offset: usize,
    ended: bool,
}

impl<R: Read> Blocks<R> {
    /// Reads the first block.
    pub(crate) fn new(stream: R) -> io::Result<Self> {
        let mut blocks = Self { stream, bytes: Vec::new(), offset: 0, ended: false };
        blocks.refill()?;
        Ok(blocks)
    }

    /// Returns the first block, or the whole text if that is shorter.
    pub(crate) fn first(&self) -> &[u8] {
        &self.bytes
    }

    /// Reads all rows from byte `start` of the first block on, where a line begins. `length` is the
    /// number of bytes of the text, if known.
    pub(crate) fn rows(
        mut self,
        start: usize,
        length: Option<u64>,
        plan: &Plan,
        lines: &impl Lines,
    ) -> Result<Rows, Failure> {
        let mut rows = Rows::default();
        self.pass(start);
        loop {
            let whole = match self.ended {
                true => self.bytes.len(),
                false => self.bytes.iter().rposition(|b| *b == b'\n').map_or(0, |end| end + 1),
            };
            if whole > 0 {
                let is_first = rows.times.is_empty();
                for part in side_by_side(&self.bytes[..whole], self.offset, lines) {
                    let before = rows.times.len();
                    let added = part.and_then(|part| rows.append(part));
                    added.map_err(|error| RowError { row: before + error.row, ..error }.told(plan))?;
                }
                if let Some(length) = length.filter(|_| is_first) {
                    // One percent is added, because lines become longer with the digits of the
                    // time.
                    let expected = rows.times.len() as f64 * (length as f64 / whole as f64) * 1.01;
                    rows.reserve(plan, expected as usize);
                }
                self.pass(whole);
            }
            if self.ended {
                return Ok(rows);
            }
            if self.bytes.len() > LONGEST_LINE {
                let kind = ContentErrorKind::Unsupported {
                    what: format!("lines of more than {LONGEST_LINE} bytes"),
                };
                return Err(ContentError::new(kind, ContentPlace::Whole).into());
            }
            self.refill()?;
        }
    }

    fn pass(&mut self, count: usize) {
        self.bytes.drain(..count);
        self.offset += count;
    }

    /// Reads more bytes: up to a block, or to twice as many if a block is in memory already.
    fn refill(&mut self) -> io::Result<()> {
        let room = if self.bytes.len() < BLOCK { BLOCK - self.bytes.len() } else { self.bytes.len() };
        self.bytes.reserve_exact(room);
        let read = self.stream.by_ref().take(room as u64).read_to_end(&mut self.bytes)?;
        self.ended = read < room;
        Ok(())
    }
}

/// Returns the rows of the parts of a text, in their order.
fn side_by_side(text: &[u8], offset: usize, lines: &impl Lines) -> Vec<Result<Rows, RowError>> {
    let threads = thread::available_parallelism().map_or(1, usize::from).min(MOST_THREADS);
    let parts = (text.len() / PART).clamp(1, threads);
    let line_end =
        |at: usize| text[at..].iter().position(|b| *b == b'\n').map_or(text.len(), |end| at + end + 1);
    let mut cuts: Vec<usize> = (1..parts).map(|k| line_end(text.len() * k / parts)).collect();
    cuts.push(text.len());
    let starts = [vec![0], cuts.clone()].concat();
    let part = |k: usize| lines.rows(&text[starts[k]..cuts[k]], offset + starts[k]);
    thread::scope(|scope| {
        let part = &part;
        let others: Vec<_> = (1..parts).map(|k| scope.spawn(move || part(k))).collect();
        let mut all = vec![part(0)];
        all.extend(
            others.into_iter().map(|other| other.join().unwrap_or_else(|p| std::panic::resume_unwind(p))),
        );
        all
    })
}
