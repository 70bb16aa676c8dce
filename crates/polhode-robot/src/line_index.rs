//! Lines and columns of positions in a text. The line starts are computed once; each lookup is a
//! binary search. For a model with included files, a position lies in one of these files.

use std::path::Path;

use crate::model::{RobotModel, Span};

/// Start positions of the lines of a text. Lines end in `\n`, `\r\n` or `\r`, as in editors.
///
/// ```
/// use polhode_robot::line_index::LineIndex;
/// let lines = LineIndex::new("<robot>\r\n  <!-- ½ --><link/>\r\n</robot>");
/// assert_eq!(lines.place(22), (2, 13)); // <link/>: a column is a character, not a byte
/// ```
#[derive(Clone, Debug)]
pub struct LineIndex<'a> {
    text: &'a str,
    /// First byte of each line, ascending; the first is 0.
    starts: Vec<usize>,
}

impl<'a> LineIndex<'a> {
    /// Computes the line starts of a text.
    pub fn new(text: &'a str) -> Self {
        let bytes = text.as_bytes();
        let ends = |at: usize| match bytes.get(at) {
            Some(b'\n') => true,
            Some(b'\r') => bytes.get(at + 1) != Some(&b'\n'),
            _ => false,
        };
        let mut starts = vec![0];
        starts.extend((0..bytes.len()).filter(|&at| ends(at)).map(|at| at + 1));
        Self { text, starts }
    }

    /// Returns line and column of a byte, both from 1. A byte order mark does not count as a
    /// character. A byte inside a character counts as that character; a byte beyond the end counts
    /// as the end.
    pub fn place(&self, byte: usize) -> (usize, usize) {
        const MARK: char = '\u{feff}';
        let byte = self.text.floor_char_boundary(byte.min(self.text.len()));
        let line = self.starts.partition_point(|&start| start <= byte);
        let start = line.checked_sub(1).and_then(|k| self.starts.get(k)).copied().unwrap_or(0);
        let before = self.text.get(start..byte).unwrap_or_default();
        let before = if start == 0 { before.trim_start_matches(MARK) } else { before };
        (line, 1 + before.chars().count())
    }
}

/// Line indices of a model and its included files.
#[derive(Clone, Debug)]
pub struct Places<'a> {
    /// Files with the position of their first byte, ascending. The first is the model's own file.
    files: Vec<(&'a Path, usize, LineIndex<'a>)>,
}

/// File, line and column of a position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FilePlace<'a> {
    /// Model file or included file.
    pub file: &'a Path,
    /// True if the file is an included one.
    pub is_included: bool,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
}

impl<'a> Places<'a> {
    /// Computes the line indices of a model.
    pub fn of(model: &'a RobotModel) -> Self {
        let own = (model.text_path(), 0, LineIndex::new(&model.text));
        let included = model
            .included
            .iter()
            .map(|source| (source.path.as_path(), source.start, LineIndex::new(&source.text)));
        Self { files: [own].into_iter().chain(included).collect() }
    }

    /// Returns the place of a span's first byte.
    pub fn place(&self, span: &Span) -> FilePlace<'a> {
        self.at(span, span.start)
    }

    /// Returns the place after a span's last byte.
    pub fn end(&self, span: &Span) -> FilePlace<'a> {
        self.at(span, span.end)
    }

    // Returns the place of a byte of a span, in the file that contains the span's start.
    fn at(&self, span: &Span, byte: usize) -> FilePlace<'a> {
        let number = self.files.partition_point(|(_, start, _)| *start <= span.start).saturating_sub(1);
        let Some((file, start, lines)) = self.files.get(number) else {
            return FilePlace { file: Path::new(""), is_included: false, line: 1, column: 1 };
        };
        let (line, column) = lines.place(byte.saturating_sub(*start));
        FilePlace { file, is_included: number > 0, line, column }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_way_to_end_a_line_counts_once() {
        let text = "\u{feff}ab\ncd\r\ne\rµf\n";
        let lines = LineIndex::new(text);
        let at = |c: char| lines.place(text.find(c).unwrap());
        assert_eq!([at('a'), at('b'), at('c'), at('d')], [(1, 1), (1, 2), (2, 1), (2, 2)]);
        assert_eq!([at('e'), at('µ'), at('f')], [(3, 1), (4, 1), (4, 2)]);
        // Positions inside the two bytes of µ, at the end, and beyond it.
        assert_eq!(lines.place(text.find('µ').unwrap() + 1), (4, 1));
        assert_eq!(lines.place(text.len()), (5, 1));
        assert_eq!(lines.place(usize::MAX), (5, 1));
        assert_eq!(LineIndex::new("").place(0), (1, 1));
    }
}
