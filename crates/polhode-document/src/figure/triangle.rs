//! Triangle of moments: all physical bodies, and an enlarged part around the body found.

use polhode::body::{MOMENT_TRIANGLE, place_in_moment_triangle, possible_ratios};

use super::axes::Area;
use super::legend::{Key, heading};
use super::sheet::{Anchor, Colour, Mark, Pen, Point, SMALL, Sheet, Text};
use super::ticks::Ticks;
use crate::drawing::Triangle;
use crate::number::with_error;

const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 408.0;
const MARGIN: f64 = 10.0;
/// Side of the triangle, px.
const SIDE: f64 = 280.0;
const PART: f64 = 226.0;
/// Left and lower edge of the triangle, px.
const FOOT: [f64; 2] = [MARGIN + 8.0, 366.0];
/// Name of the region outside the triangle.
const FORBIDDEN: [&str; 2] = ["no body can have", "these moments"];
/// Largest region that is enlarged, relative to the triangle.
const WIDE: f64 = 0.45;
/// Size of the enlarged part relative to the largest region.
const ROOM: f64 = 1.35;

const DOT: Pen = Pen::solid(Colour::BLACK, 5.0);
const CLOUD: Pen = Pen::solid(Colour::FAINT, 1.8).faint(0.6);
const OUTLINE: Pen = Pen::solid(Colour::AXES[0], 1.3);
const FIRST: Pen = Pen::solid(Colour::AXES[1], 0.9).faint(0.75);
const SECOND: Pen = Pen::solid(Colour::AXES[2], 0.9).faint(0.75);
const NO_BODY: Colour = Colour(0xe6_e9_ed);
const WHITE: Colour = Colour(0xff_ff_ff);

pub(super) fn sheet(triangle: &Triangle) -> Sheet {
    let title = "The triangle of moments";
    let mut sheet = Sheet::new(WIDTH, HEIGHT, title.to_owned());
    let whole = Area { left: MARGIN, top: MARGIN, right: WIDTH - MARGIN, bottom: HEIGHT - MARGIN };
    let regions: Vec<(f64, Vec<Point>)> = triangle
        .regions
        .iter()
        .map(|(p, outline)| {
            (*p, outline.iter().map(|&[a, b]| place_in_moment_triangle([a, b, 1.0])).collect())
        })
        .collect();
    let cloud: Vec<Point> =
        triangle.cloud.iter().map(|&[a, b]| place_in_moment_triangle([a, b, 1.0])).collect();
    let [first, second] = triangle.ratios;
    let body = place_in_moment_triangle([first, second, 1.0]);
    let window = regions.last().and_then(|(_, outline)| window(outline));
    let sd = triangle.sd.unwrap_or_default();
    let ratio = |k: usize| with_error(triangle.ratios[k], sd[k]);
    let mut keys =
        vec![Key::dot(DOT, format!("this body: i1/i3 = {}, i2/i3 = {} (no unit)", ratio(0), ratio(1)))];
    if let [(small, _), .., (large, _)] = regions[..] {
        let [small, large] = [small, large].map(|p| format!("{:.0} %", 100.0 * p));
        keys.push(Key::line(
            OUTLINE,
            format!("true ratios: {small} inside the inner curve, {large} inside the outer"),
        ));
    }
    if !cloud.is_empty() {
        keys.push(Key::dot(CLOUD, "bodies that the errors allow"));
    }
    if window.is_some() {
        keys.extend([
            Key::line(FIRST, "i1/i3: least over greatest moment"),
            Key::line(SECOND, "i2/i3: middle over greatest"),
        ]);
    }
    heading(&mut sheet, whole, "The triangle of moments: rod, plate or sphere?", "", &keys);

    let at = |[x, y]: Point| [FOOT[0] + SIDE * x, FOOT[1] - SIDE * y];
    all_bodies(&mut sheet, at);
    if window.is_none() {
        sheet.dots(cloud.iter().map(|&point| at(point)).collect(), CLOUD);
        draw_regions(&mut sheet, &regions, at);
    }
    sheet.dots(vec![at(body)], DOT);
    let [x, y] = at(body);
    let name = Text::small([x + 8.0, y - 8.0], Anchor::Start, Colour::BLACK, "this body");
    sheet.marks.push(Mark::Text(Text { halo: true, ..name }));
    if let Some(window) = window {
        window.mark(&mut sheet, at);
        window.draw(&mut sheet, &regions, &cloud, body);
    }
    sheet
}

/// Draws the whole triangle with the meaning of its corners and edges.
fn all_bodies(sheet: &mut Sheet, at: impl Fn(Point) -> Point) {
    let corners = MOMENT_TRIANGLE.map(&at);
    let ([left, right], [top, bottom]) = ([corners[0][0], corners[1][0]], [corners[2][1], corners[0][1]]);
    let outside = vec![[left, top], [right, top], [right, bottom], [left, bottom]];
    sheet.marks.push(Mark::Polygon { corners: outside, fill: NO_BODY, opacity: 1.0 });
    sheet.marks.push(Mark::Polygon { corners: corners.to_vec(), fill: WHITE, opacity: 1.0 });
    forbidden(sheet, [left + 6.0, top + 16.0], Anchor::Start);
    let middle = place_in_moment_triangle([1.0; 3]);
    let median =
        |k: usize| vec![corners[k], at([0, 1].map(|c| 1.5 * middle[c] - 0.5 * MOMENT_TRIANGLE[k][c]))];
    sheet.lines([0, 1, 2].map(median), Pen::solid(Colour::GRID, 0.9));
    sheet.line(vec![corners[0], corners[1], corners[2], corners[0]], Pen::solid(Colour::FRAME, 1.1));
    let mut say = |[x, y]: Point, down: f64, anchor, words| {
        sheet.marks.push(Mark::Text(Text {
            halo: true,
            ..Text::small([x, y + down], anchor, Colour::FAINT, words)
        }));
    };
    say(corners[0], 16.0, Anchor::Start, "rod, axis 1");
    say(corners[1], 16.0, Anchor::End, "rod, axis 2");
    say(corners[2], -6.0, Anchor::Middle, "rod, axis 3");
    say(at([0.5, 0.0]), 16.0, Anchor::Middle, "thin plate");
    say(at([0.75, 0.5 * MOMENT_TRIANGLE[2][1]]), 0.0, Anchor::Middle, "thin plate");
    say(at([0.25, 0.5 * MOMENT_TRIANGLE[2][1]]), 0.0, Anchor::Middle, "thin plate");
    say(at(middle), -7.0, Anchor::Middle, "sphere, cube");
    sheet.dots(vec![at(middle)], Pen::solid(Colour::FRAME, 4.0));
}

/// Names the region where no body exists, from a position downward.
fn forbidden(sheet: &mut Sheet, [x, y]: Point, anchor: Anchor) {
    for (k, words) in FORBIDDEN.into_iter().enumerate() {
        sheet.text([x, y + 15.0 * k as f64], anchor, Colour::TEXT, words);
    }
}

fn draw_regions(sheet: &mut Sheet, regions: &[(f64, Vec<Point>)], at: impl Fn(Point) -> Point) {
    for (_, outline) in regions.iter().rev() {
        let corners: Vec<Point> = outline.iter().map(|&point| at(point)).collect();
        sheet.marks.push(Mark::Polygon { corners: corners.clone(), fill: OUTLINE.colour, opacity: 0.22 });
        sheet.line(corners.iter().chain(corners.first()).copied().collect(), OUTLINE);
    }
}

/// Square part of the triangle: centre and half side.
#[derive(Clone, Copy, Debug)]
struct Window {
    middle: Point,
    half: f64,
}

/// Returns the square around an outline; `None` if it covers a large part of the triangle.
fn window(outline: &[Point]) -> Option<Window> {
    let ends = |c: usize| {
        outline
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], point| [a.min(point[c]), b.max(point[c])])
    };
    let [[left, right], [low, high]] = [ends(0), ends(1)];
    let half = 0.5 * ROOM * (right - left).max(high - low);
    let middle = [0.5 * (left + right), 0.5 * (low + high)];
    (half > 0.0 && 2.0 * half < WIDE).then_some(Window { middle, half })
}

/// Returns i1/i3 and i2/i3 at a position in the triangle, also slightly outside.
fn ratios([x, y]: Point) -> [f64; 2] {
    let third = y / MOMENT_TRIANGLE[2][1];
    let second = x - 0.5 * third;
    [(second + third) / (1.0 - third), (1.0 - second) / (1.0 - third)]
}

impl Window {
    fn corners(self) -> [Point; 4] {
        let Self { middle: [x, y], half } = self;
        [[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half]]
    }

    /// Marks the square on the whole triangle.
    fn mark(self, sheet: &mut Sheet, at: impl Fn(Point) -> Point) {
        let [x, y] = at(self.middle);
        let half = (self.half * SIDE).max(5.0);
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]];
        let corners = square.map(|[a, b]| [x + half * a, y + half * b]);
        sheet.line(corners.to_vec(), Pen::solid(Colour::TEXT, 0.9));
    }

    fn draw(self, sheet: &mut Sheet, regions: &[(f64, Vec<Point>)], cloud: &[Point], body: Point) {
        let scale = PART / (2.0 * self.half);
        let (left, bottom) = (WIDTH - MARGIN - 48.0 - PART, FOOT[1] - 8.0);
        let [[x0, y0], ..] = self.corners();
        let at = |[x, y]: Point| [left + scale * (x - x0), bottom - scale * (y - y0)];
        let frame = self.corners().map(at);
        let fill = |corners: Vec<Point>, fill| Mark::Polygon { corners, fill, opacity: 1.0 };
        sheet.marks.push(fill(frame.to_vec(), NO_BODY));
        let possible = possible_ratios(&self.corners().map(ratios));
        let possible = possible.into_iter().map(|[a, b]| at(place_in_moment_triangle([a, b, 1.0])));
        sheet.marks.push(fill(possible.collect(), WHITE));
        let mut feet: Vec<f64> = Vec::new();
        for (k, pen) in [(0, FIRST), (1, SECOND)] {
            self.level_lines(sheet, k, pen, at, &mut feet);
        }
        let inside =
            cloud.iter().filter(|point| (0..2).all(|c| (point[c] - self.middle[c]).abs() < self.half));
        sheet.dots(inside.map(|&point| at(point)).collect(), CLOUD);
        draw_regions(sheet, regions, at);
        sheet.dots(vec![at(body)], DOT);
        sheet.line(frame.iter().chain(&frame[..1]).copied().collect(), Pen::solid(Colour::TEXT, 0.9));
        let words = format!("enlarged {} times", crate::number::number(scale / SIDE, 2));
        let [x, y] = frame[3];
        sheet.text([x + PART, y - 5.0], Anchor::End, Colour::FAINT, &words);
        // A corner of the square without physical bodies.
        if let Some([x, y]) = self
            .corners()
            .into_iter()
            .map(|[x, y]| [0.9 * x + 0.1 * self.middle[0], 0.93 * y + 0.07 * self.middle[1]])
            .find(|&place| possible_ratios(&[ratios(place)]).is_empty())
        {
            let [x, y] = at([x, y]);
            let anchor = if x < left + 0.5 * PART { Anchor::Start } else { Anchor::End };
            forbidden(sheet, [x, y + 0.36 * SMALL], anchor);
        }
    }

    /// Draws lines of constant ratio with their values: i1/i3 labelled at the right edge of the
    /// square, i2/i3 at the left.
    fn level_lines(
        self,
        sheet: &mut Sheet,
        k: usize,
        pen: Pen,
        at: impl Fn(Point) -> Point,
        feet: &mut Vec<f64>,
    ) {
        let corners = self.corners();
        let values = corners.map(|corner| ratios(corner)[k]);
        let ends = values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(*v), b.max(*v)]);
        let Ticks { values: levels, labels } = Ticks::linear(ends[0], ends[1], 6.0);
        for (level, label) in levels.iter().zip(&labels) {
            // (r − level) times a positive factor is linear in the position.
            let height = |place: Point| (ratios(place)[k] - level) * (1.0 - place[1] / MOMENT_TRIANGLE[2][1]);
            let mut line: Vec<Point> = Vec::new();
            for (i, &here) in corners.iter().enumerate() {
                let there = corners[(i + 1) % 4];
                let (from, to) = (height(here), height(there));
                if (from < 0.0) != (to < 0.0) {
                    let part = from / (from - to);
                    line.push([0, 1].map(|c| here[c] + part * (there[c] - here[c])));
                }
            }
            line.sort_by(|a, b| a[0].total_cmp(&b[0]));
            let [first, .., last] = line[..] else { continue };
            sheet.line(vec![at(first), at(last)], pen);
            let end = if k == 0 { last } else { first };
            let [x, y] = at(end);
            let is_foot = (end[1] - corners[0][1]).abs() < 1e-9 * self.half;
            let is_side = (end[0] - corners[usize::from(k == 0)][0]).abs() < 1e-9 * self.half;
            let ink = Colour(if k == 0 { 0xb0_4c_00 } else { 0x00_7a_58 });
            if is_side {
                let (anchor, away) = if k == 0 { (Anchor::Start, 5.0) } else { (Anchor::End, -5.0) };
                sheet.text([x + away, y + 0.36 * SMALL], anchor, ink, label);
            } else if is_foot && feet.iter().all(|other| (other - x).abs() > 38.0) {
                feet.push(x);
                sheet.text([x, y + 15.0], Anchor::Middle, ink, label);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_those_of_the_place() {
        for [a, b] in [[0.3, 0.9], [0.55, 0.6], [0.99, 1.0]] {
            let [first, second] = ratios(place_in_moment_triangle([a, b, 1.0]));
            assert!((first - a).abs() < 1e-14 && (second - b).abs() < 1e-14, "{first} {second}");
        }
    }

    #[test]
    fn no_region_leaves_the_possible_part() {
        let outline = vec![[0.29, 0.71], [0.33, 0.72], [0.31, 0.75], [0.28, 0.72]];
        let triangle = Triangle {
            ratios: [0.305, 0.715],
            sd: Some([0.004, 0.003]),
            regions: vec![(0.68, outline.clone()), (0.95, outline)],
            cloud: vec![[0.3, 0.72]],
        };
        let svg = super::super::svg::write(&sheet(&triangle));
        for words in
            [FORBIDDEN[0], "enlarged", "rod, axis 1", "95 % inside the outer", "i1/i3 = 0.3050 ± 0.0040"]
        {
            assert!(svg.contains(words), "{words}: {svg}");
        }
        // Without regions there is nothing to enlarge.
        let svg = super::super::svg::write(&sheet(&Triangle {
            ratios: [0.5, 0.8],
            sd: None,
            regions: Vec::new(),
            cloud: Vec::new(),
        }));
        assert!(svg.contains("thin plate") && !svg.contains("enlarged"));
    }
}
