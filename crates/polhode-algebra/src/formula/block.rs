//! Blocks of text: lines, one of which is the base line.

use super::Fence;

/// Lines of text; the base line is that of the letters next to it.
#[derive(Clone, Debug)]
pub(super) struct Block {
    lines: Vec<String>,
    base: usize,
}

/// Position of a cell in its column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Align {
    Left,
    Center,
    Right,
}

impl Block {
    pub(super) fn line(text: impl Into<String>) -> Self {
        Self { lines: vec![text.into()], base: 0 }
    }

    /// Returns the text without spaces at the ends of lines.
    pub(super) fn into_text(self) -> String {
        let lines: Vec<&str> = self.lines.iter().map(|line| line.trim_end()).collect();
        lines.join("\n")
    }

    /// Returns blocks side by side, their base lines at the same height.
    pub(super) fn row(blocks: impl IntoIterator<Item = Self>) -> Self {
        blocks.into_iter().reduce(|left, right| left.joined(&right)).unwrap_or_else(|| Self::line(""))
    }

    fn joined(self, other: &Self) -> Self {
        let base = self.base.max(other.base);
        let below = (self.lines.len() - self.base).max(other.lines.len() - other.base);
        let (left, right) = (self.width(), other.width());
        let lines = (0..base + below).map(|k| {
            let part = |block: &Self, width| {
                let line = (k + block.base).checked_sub(base).and_then(|k| block.lines.get(k));
                padded(line.map_or("", String::as_str), width, Align::Left)
            };
            part(&self, left) + &part(other, right)
        });
        Self { lines: lines.collect(), base }
    }

    /// Returns cells in columns that are two spaces apart.
    pub(super) fn grid(rows: Vec<Vec<Self>>, align: impl Fn(usize) -> Align, gap: &str) -> Self {
        let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
        let width = |k: usize| rows.iter().filter_map(|row| row.get(k)).map(Self::width).max().unwrap_or(0);
        let widths: Vec<usize> = (0..columns).map(width).collect();
        let mut lines = Vec::new();
        for row in rows {
            let cells = row.into_iter().enumerate().flat_map(|(k, mut cell)| {
                for line in &mut cell.lines {
                    *line = padded(line, widths[k], align(k));
                }
                let gap = (k > 0).then(|| Self::line(gap));
                gap.into_iter().chain([cell])
            });
            lines.extend(Self::row(cells).lines);
        }
        let base = lines.len().saturating_sub(1) / 2;
        Self { lines, base }
    }

    /// Returns the block in brackets of its height.
    pub(super) fn fenced(self, fence: Fence) -> Self {
        let [left, right] = [0, 1].map(|side| self.bracket(fence, side));
        Self::row([left, self, right])
    }

    /// Returns the block after a left brace.
    pub(super) fn braced(self) -> Self {
        Self::row([self.bracket(Fence::Braces, 0), Self::line(" "), self])
    }

    /// Returns the left (0) or right (1) bracket of a block.
    fn bracket(&self, fence: Fence, side: usize) -> Self {
        // Single line; then top, middle, bottom and, for braces, their extension.
        let [one, top, middle, bottom, extension] = match fence {
            Fence::Parentheses => [["(", ")"], ["⎛", "⎞"], ["⎜", "⎟"], ["⎝", "⎠"], ["⎜", "⎟"]],
            Fence::Brackets => [["[", "]"], ["⎡", "⎤"], ["⎢", "⎥"], ["⎣", "⎦"], ["⎢", "⎥"]],
            Fence::Braces if self.lines.len() == 2 => [["{", "}"], ["⎰", "⎱"], [""; 2], ["⎱", "⎰"], [""; 2]],
            Fence::Braces => [["{", "}"], ["⎧", "⎫"], ["⎨", "⎬"], ["⎩", "⎭"], ["⎪", "⎪"]],
            Fence::Bars => [["|", "|"], ["│", "│"], ["│", "│"], ["│", "│"], ["│", "│"]],
        }
        .map(|sides| sides[side]);
        let last = self.lines.len() - 1;
        let piece = |k: usize| match k {
            _ if last == 0 => one,
            0 => top,
            _ if k == last => bottom,
            _ if k == last / 2 => middle,
            _ => extension,
        };
        Self { lines: (0..=last).map(|k| piece(k).to_owned()).collect(), base: self.base }
    }

    fn width(&self) -> usize {
        self.lines.iter().map(|line| width(line)).max().unwrap_or(0)
    }
}

/// Returns the number of columns; combining marks such as the dot of ω̇ need none.
fn width(text: &str) -> usize {
    text.chars()
        .filter(|c| !('\u{300}'..='\u{36f}').contains(c) && !('\u{20d0}'..='\u{20f0}').contains(c))
        .count()
}

fn padded(text: &str, columns: usize, align: Align) -> String {
    let free = columns.saturating_sub(width(text));
    let left = match align {
        Align::Left => 0,
        Align::Center => free / 2,
        Align::Right => free,
    };
    format!("{}{text}{}", " ".repeat(left), " ".repeat(free - left))
}
