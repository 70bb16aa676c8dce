//! Pieces of a face that bound the regions with winding number at least 1, at least 2, or negative.
//!
//! The face is cut along the lines x = c through all end points and crossings of the lines on it.
//! Between two such cuts the lines have a fixed order from bottom to top, and the counts change at
//! each line. A line that rounding displaces, or puts in the wrong order with another line that it
//! touches, only affects the sliver between them. The enclosed regions are therefore correct to
//! within the rounding of the lines' positions.

use super::super::work::Work;
use super::face::{Counts, Face, Line, cross};

/// Levels whose regions are computed: winding number at least 1, at least 2, at least 0.
pub(super) const LEVELS: [i32; 3] = [1, 2, 0];

/// A piece of the surface between two lines of a face, for one level: `side` is 1 if the face's
/// outer side is outward, −1 if it is inward.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) level: usize,
    pub(super) side: i32,
    /// Corners, counter-clockwise in (x, y).
    pub(super) corners: [[f64; 2]; 4],
}

/// Returns how a place of a face bounds the region of a level: 1 if the place just below belongs to
/// it and the place just above does not, −1 in the opposite case, 0 otherwise.
pub(super) fn side_of(level: i32, [above, below, before]: Counts) -> i32 {
    if before == 0 { i32::from(below >= level) - i32::from(above >= level) } else { 0 }
}

/// Lines on a face, and the changes of the counts along its lower edge.
#[derive(Debug, Default)]
pub(super) struct Region {
    /// The face's three edges first: the lower one, the upper one up to the top corner, and the
    /// upper one behind it. All lines run from left to right; none is vertical.
    lines: Vec<Line>,
    /// Positions x where counts change just above the lower edge, and the changes; ascending.
    steps: Vec<(f64, Counts)>,
    /// Positions x of ends and crossings of lines, from the first corner to the last.
    cuts: Vec<f64>,
}

/// Cost of a crossing, in visits of a ray; it limits the number of crossings.
const CROSSING: u64 = 32;

/// Indices of a face's own edges in `lines`.
const LOWER: usize = 0;
const UPPER: [usize; 2] = [1, 2];

impl Region {
    /// Prepares the lines on a face; `None` if no work is left.
    pub(super) fn of(face: &Face, lines: &[Line], work: &Work<'_>) -> Option<Self> {
        let Face { top, end, .. } = *face;
        let edge = |from, to| Line { from, to, rise: [0; 3] };
        let origin = [0.0; 2];
        let mut region =
            Self { lines: vec![edge(origin, end), edge(origin, top), edge(top, end)], ..Self::default() };
        for &line in lines {
            let cut = Cut::of(face, line);
            region.steps.extend(cut.step);
            let inside =
                cut.above.and_then(|line| under(line, origin, top)).and_then(|line| under(line, top, end));
            region.lines.extend(inside.map(rightward).filter(|line| line.from[0] < line.to[0]));
        }
        region.steps.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        region.lines[3..].sort_by(|a, b| a.from[0].total_cmp(&b.from[0]));
        let ends = region.lines.iter().flat_map(|line| [line.from[0], line.to[0]]);
        let mut cuts: Vec<f64> = ends.chain(region.steps.iter().map(|step| step.0)).collect();
        region.add_crossings(&mut cuts, work)?;
        cuts.retain(|x| (0.0..=end[0]).contains(x));
        cuts.sort_unstable_by(f64::total_cmp);
        cuts.dedup();
        region.cuts = cuts;
        Some(region)
    }

    fn add_crossings(&self, cuts: &mut Vec<f64>, work: &Work<'_>) -> Option<()> {
        let lines = &self.lines[3..];
        let low = |line: &Line| line.from[1].min(line.to[1]);
        let high = |line: &Line| line.from[1].max(line.to[1]);
        for (k, a) in lines.iter().enumerate() {
            let next = lines[k + 1..].iter().take_while(|b| b.from[0] < a.to[0]);
            let (mut steps, mut crossings) = (1, 0);
            for b in next.inspect(|_| steps += 1).filter(|b| low(a) <= high(b) && low(b) <= high(a)) {
                let (from, to) = (b.from[0], a.to[0].min(b.to[0]));
                let [at_from, at_to] = [from, to].map(|x| height(a, x) - height(b, x));
                if at_from * at_to < 0.0 {
                    cuts.push(from + (to - from) * (at_from / (at_from - at_to)));
                    crossings += 1;
                }
            }
            if !work.take(steps + CROSSING * crossings) {
                return None;
            }
        }
        Some(())
    }

    /// Returns the middle of the widest strip, far from all end points.
    pub(super) fn middle(&self) -> f64 {
        let strips = self.cuts.windows(2).map(|strip| (strip[1] - strip[0], 0.5 * (strip[0] + strip[1])));
        strips.max_by(|a, b| a.0.total_cmp(&b.0)).map_or(0.0, |strip| strip.1)
    }

    /// Passes all boundary pieces to `piece`, given the `counts` just above the lower edge at
    /// x = `at`; `None` if no work is left.
    pub(super) fn pieces(
        &self,
        at: f64,
        counts: Counts,
        work: &Work<'_>,
        mut piece: impl FnMut(Piece),
    ) -> Option<()> {
        let before = |x: f64| self.steps.partition_point(|step| step.0 <= x);
        let mut start = counts;
        for step in &self.steps[..before(at)] {
            start = minus(start, step.1);
        }
        let mut next_step = 0;
        let (mut next_line, mut active) = (3, Vec::<usize>::new());
        let (mut open, mut kept, mut order) = (Vec::<Band>::new(), Vec::new(), Vec::new());
        for strip in self.cuts.windows(2) {
            let (from, to) = (strip[0], strip[1]);
            let x = 0.5 * (from + to);
            while let Some(step) = self.steps.get(next_step).filter(|step| step.0 <= x) {
                start = plus(start, step.1);
                next_step += 1;
            }
            active.retain(|&line| self.lines[line].to[0] > x);
            while self.lines.get(next_line).is_some_and(|line| line.from[0] <= x) {
                if self.lines[next_line].to[0] > x {
                    active.push(next_line);
                }
                next_line += 1;
            }
            if !work.take(1 + active.len() as u64) {
                return None;
            }
            order.clear();
            order.extend(active.iter().map(|&line| (height(&self.lines[line], x), line)));
            order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let upper = if x < self.lines[UPPER[0]].to[0] { UPPER[0] } else { UPPER[1] };
            kept.clear();
            for (level, &least) in LEVELS.iter().enumerate() {
                let (mut counts, mut lower, mut side) = (start, LOWER, side_of(least, start));
                for &(_, line) in &order {
                    counts = plus(counts, self.lines[line].rise);
                    let now = side_of(least, counts);
                    if now != side {
                        kept.extend((side != 0).then_some(Band { level, side, lower, upper: line, from }));
                        (lower, side) = (line, now);
                    }
                }
                kept.extend((side != 0).then_some(Band { level, side, lower, upper, from }));
            }
            kept.sort_unstable_by_key(Band::key);
            let goes_on =
                |some: &[Band], band: &Band| some.binary_search_by_key(&band.key(), Band::key).is_ok();
            open.iter().filter(|band| !goes_on(&kept, band)).for_each(|band| piece(self.piece(band, from)));
            open.retain(|band| goes_on(&kept, band));
            let continued = open.len();
            for band in kept.drain(..) {
                if !goes_on(&open[..continued], &band) {
                    open.push(band);
                }
            }
            open.sort_unstable_by_key(Band::key);
        }
        let last = *self.cuts.last()?;
        open.iter().for_each(|band| piece(self.piece(band, last)));
        Some(())
    }

    fn piece(&self, band: &Band, to: f64) -> Piece {
        let at = |line: usize, x: f64| [x, height(&self.lines[line], x)];
        let corners =
            [at(band.lower, band.from), at(band.lower, to), at(band.upper, to), at(band.upper, band.from)];
        Piece { level: band.level, side: band.side, corners }
    }
}

/// Band between two lines that belongs to the boundary, from some x on.
#[derive(Clone, Copy, Debug)]
struct Band {
    level: usize,
    side: i32,
    lower: usize,
    upper: usize,
    from: f64,
}

impl Band {
    const fn key(&self) -> (usize, i32, usize, usize) {
        (self.level, self.side, self.lower, self.upper)
    }
}

/// Effect of a line on the region above the lower edge of a face.
struct Cut {
    above: Option<Line>,
    /// Position where it crosses the line of that edge, and the change of the counts there.
    step: Option<(f64, Counts)>,
}

impl Cut {
    fn of(face: &Face, line: Line) -> Self {
        let line = rightward(line);
        let [of_from, of_to] = [line.from, line.to].map(|p| cross(face.end, p));
        match (of_from >= 0.0, of_to >= 0.0) {
            (true, true) => Self { above: Some(line), step: None },
            (false, false) => Self { above: None, step: None },
            (from_above, _) => {
                let [x, _] = between(line, of_from, of_to);
                let at = [x, face.end[1] * (x / face.end[0])];
                let (above, change) = if from_above {
                    (Line { to: at, ..line }, line.rise)
                } else {
                    (Line { from: at, ..line }, minus([0; 3], line.rise))
                };
                Self { above: Some(above), step: Some((x, change)) }
            }
        }
    }

    /// Returns its contribution to the counts summed from far below up to the lower edge at this x.
    fn below(&self, line: Line, x: f64) -> Counts {
        let line = rightward(line);
        let spans = |line: &Line| line.from[0] <= x && x < line.to[0];
        if spans(&line) && !self.above.as_ref().is_some_and(spans) { line.rise } else { [0; 3] }
    }
}

/// Returns the contribution of a line to the counts summed from far below up to the lower edge of a
/// face, at this x.
pub(super) fn rise_below(face: &Face, line: Line, x: f64) -> Counts {
    Cut::of(face, line).below(line, x)
}

/// Returns the line oriented from left to right.
fn rightward(line: Line) -> Line {
    if line.from[0] <= line.to[0] {
        return line;
    }
    Line { from: line.to, to: line.from, rise: minus([0; 3], line.rise) }
}

/// Returns the part of a line below the line through two points.
fn under(line: Line, a: [f64; 2], b: [f64; 2]) -> Option<Line> {
    let depth = |p: [f64; 2]| cross([p[0] - a[0], p[1] - a[1]], [b[0] - a[0], b[1] - a[1]]);
    let [of_from, of_to] = [line.from, line.to].map(depth);
    match (of_from >= 0.0, of_to >= 0.0) {
        (true, true) => Some(line),
        (false, false) => None,
        (true, false) => Some(Line { to: between(line, of_from, of_to), ..line }),
        (false, true) => Some(Line { from: between(line, of_from, of_to), ..line }),
    }
}

/// Returns the point of a line where a linear function vanishes, given its values of opposite sign
/// at the ends.
fn between(Line { from, to, .. }: Line, of_from: f64, of_to: f64) -> [f64; 2] {
    let part = of_from / (of_from - of_to);
    [0, 1].map(|k| (from[k] + part * (to[k] - from[k])).clamp(from[k].min(to[k]), from[k].max(to[k])))
}

/// Returns the y of a line at an x. For a vertical edge (in a strip as narrow as rounding) it
/// returns the y of its start.
fn height(Line { from, to, .. }: &Line, x: f64) -> f64 {
    let width = to[0] - from[0];
    let part = if width > 0.0 { ((x - from[0]) / width).clamp(0.0, 1.0) } else { 0.0 };
    from[1] + part * (to[1] - from[1])
}

fn plus(a: Counts, b: Counts) -> Counts {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn minus(a: Counts, b: Counts) -> Counts {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}
