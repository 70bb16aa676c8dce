//! Boxes in space: three orthogonal views of the same scale, and one oblique view.

use super::axes::Area;
use super::legend::{Key, heading};
use super::prefix;
use super::sheet::{Anchor, Colour, Mark, Pen, Point, SMALL, Sheet, Text};
use crate::drawing::{Solid, Solids};
use crate::layout::printable;

const WIDTH: f64 = 640.0;
const MARGIN: f64 = 10.0;
const GAP: f64 = 22.0;
/// Height of the title of a view, px.
const TITLE: f64 = 26.0;
/// Smallest height of the oblique view, px; if it would be lower, it gets a row of its own.
const LOW: f64 = 170.0;
/// Azimuth of the oblique view, rad.
const TURNED: f64 = 0.6;
const RAISED: f64 = 0.42;
/// Length of a principal axis beyond the body, relative to the longest extent.
const BEYOND: f64 = 0.05;
/// Drawn size of a part without extent, relative to the longest extent.
const POINT: f64 = 0.012;
const NAMES: [&str; 3] = ["x", "y", "z"];

/// Colours of groups, distinguishable with any colour vision; the last is for parts without a
/// group.
const COLOURS: [Colour; 8] = [
    Colour(0x56_b4_e9),
    Colour(0xe6_9f_00),
    Colour(0x44_aa_99),
    Colour(0xcc_79_a7),
    Colour(0xdd_cc_77),
    Colour(0x88_22_55),
    Colour(0x33_22_88),
    Colour(0xa8_b0_b8),
];

pub(super) fn colour(group: usize) -> Colour {
    COLOURS.get(group).copied().unwrap_or(COLOURS[7])
}

/// Viewing direction: unit vectors to the right, upward and toward the viewer.
#[derive(Clone, Copy, Debug)]
struct View([[f64; 3]; 3]);

impl View {
    fn place(&self, point: [f64; 3]) -> [f64; 3] {
        self.0.map(|axis| dot(axis, point))
    }
}

pub(super) fn sheet(all: &Solids) -> Sheet {
    let title = printable(&all.title);
    let mut sheet = Sheet::new(WIDTH, MARGIN, title.clone());
    let whole = Area { left: MARGIN, top: MARGIN, right: WIDTH - MARGIN, bottom: MARGIN };
    let named = all.groups.iter().take(COLOURS.len() - 1).enumerate();
    let mut keys: Vec<Key> =
        named.map(|(k, name)| Key::dot(Pen::solid(colour(k), 9.0), printable(name))).collect();
    keys.push(Key::dot(Pen::solid(Colour::BLACK, 6.0), "centre of mass"));
    keys.extend((0..3).map(|k| Key::line(axis_pen(k), format!("principal axis {}", k + 1))));
    let top = MARGIN + heading(&mut sheet, whole, &title, "", &keys) + 4.0;

    let box_of_all = ends(all, &View(UNIT));
    let size = |axis: usize| box_of_all[axis][1] - box_of_all[axis][0];
    let extent = (0..3).map(size).fold(0.0, f64::max);
    // The longest axis is horizontal, and z is vertical if possible.
    let a = (0..3).fold(0, |a, k| if size(k) > 1.2 * size(a) { k } else { a });
    let (b, c) = [(1, 2), (0, 2), (0, 1)][a.min(2)];
    let [front, above, side] = [view([a, c]), view([a, b]), view([b, c])];
    let aside = aside([a, b, c]);
    let [first, second] = [size(a), size(b)].map(|x| x.max(0.05 * extent));
    let scale = (WIDTH - 2.0 * MARGIN - GAP) / (first + second);
    let frame = |view: &View| {
        let [across, up, _] = ends(all, view);
        [across, up].map(|[from, to]| {
            let half = (0.5 * (to - from)).max(0.025 * extent);
            [0.5 * (from + to) - half, 0.5 * (from + to) + half]
        })
    };
    let mut place = |view: &View, words: &str, [left, top]: Point, scale: f64| {
        let [[x0, x1], [y0, y1]] = frame(view);
        let at = |[x, y, _]: [f64; 3]| [left + scale * (x - x0), top + TITLE + scale * (y1 - y)];
        sheet.text([left, top + SMALL], Anchor::Start, Colour::TEXT, words);
        draw(all, view, at, extent, &mut sheet);
        [left + scale * (x1 - x0), top + TITLE + scale * (y1 - y0)]
    };
    let [_, below_front] = place(&front, &words(a, c), [MARGIN, top], scale);
    let right = MARGIN + first * scale + GAP;
    let [_, below_side] = place(&side, &words(b, c), [right, top], scale);
    let second_row = below_front.max(below_side) + GAP;
    let [_, below_above] = place(&above, &words(a, b), [MARGIN, second_row], scale);
    let [[x0, x1], [y0, y1]] = frame(&aside);
    let room = (WIDTH - MARGIN - right, below_above - second_row - TITLE);
    let beside = (room.0 / (x1 - x0)).min(room.1 / (y1 - y0));
    let bottom = if (x1 - x0) * beside >= LOW {
        place(&aside, "from aside", [right, second_row], beside);
        below_above
    } else {
        let scale = ((WIDTH - 2.0 * MARGIN) / (x1 - x0)).min(1.4 * WIDTH / 2.0 / (y1 - y0));
        place(&aside, "from aside", [MARGIN, below_above + GAP], scale)[1]
    };
    scale_bar(extent, scale, [MARGIN + first * scale, top + SMALL], &mut sheet);
    sheet.height = bottom + MARGIN;
    sheet
}

/// Draws a scale bar with its length, right-aligned at a point.
fn scale_bar(extent: f64, scale: f64, [right, base]: Point, sheet: &mut Sheet) {
    if !(extent > 0.0) {
        return;
    }
    let power = 10_f64.powi((0.3 * extent).log10().floor() as i32);
    let length = [5.0, 2.0, 1.0].into_iter().map(|x| x * power).find(|x| *x <= 0.3 * extent).unwrap_or(power);
    let words =
        if length < 1.0 { prefix::value(1e3 * length, 3, "mm") } else { prefix::value(length, 3, "m") };
    let text = Text::small([right, base], Anchor::End, Colour::TEXT, &words);
    let end = right + text.extent()[0] - 8.0;
    sheet.marks.push(Mark::Text(text));
    let (from, middle) = (end - scale * length, base - 0.36 * SMALL);
    let pen = Pen::solid(Colour::TEXT, 1.1);
    let tick = |x: f64| vec![[x, middle - 3.0], [x, middle + 3.0]];
    sheet.lines([vec![[from, middle], [end, middle]], tick(from), tick(end)], pen);
}

const UNIT: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn view([right, up]: [usize; 2]) -> View {
    View([UNIT[right], UNIT[up], cross(UNIT[right], UNIT[up])])
}

/// Returns the oblique view, from the front, the right and above.
fn aside([a, b, c]: [usize; 3]) -> View {
    let (sin, cos) = TURNED.sin_cos();
    let right = plus(UNIT[a], cos, UNIT[b], sin);
    let level = cross(right, UNIT[c]);
    let (up, ahead) = RAISED.sin_cos();
    let eye = plus(level, ahead, UNIT[c], up);
    View([right, cross(eye, right), eye])
}

/// Returns the title of a view: `x to the right, z upward`.
fn words(right: usize, up: usize) -> String {
    format!("{} to the right, {} upward", NAMES[right], NAMES[up])
}

/// Returns the range along each axis of a view.
fn ends(all: &Solids, view: &View) -> [[f64; 2]; 3] {
    let none = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    let points = all.solids.iter().flat_map(corners).chain(axes(all).into_iter().flatten()).chain([[0.0; 3]]);
    points
        .map(|point| view.place(point))
        .fold(none, |ends, at| core::array::from_fn(|k| [ends[k][0].min(at[k]), ends[k][1].max(at[k])]))
}

/// Returns both ends of each principal axis, beyond the body.
fn axes(all: &Solids) -> [[[f64; 3]; 2]; 3] {
    let points = || all.solids.iter().flat_map(corners).chain([all.center]);
    let reach = |axis: [f64; 3]| {
        let heights = points().map(|point| dot(plus(point, 1.0, all.center, -1.0), axis));
        heights.fold([0.0; 2], |[least, most]: [f64; 2], x| [least.min(x), most.max(x)])
    };
    let all_reach = all.axes.map(reach);
    let more = BEYOND * all_reach.iter().map(|[from, to]| to - from).fold(0.0, f64::max);
    [0, 1, 2].map(|k| {
        let [from, to] = all_reach[k];
        [from - more, to + more].map(|along| plus(all.center, 1.0, all.axes[k], along))
    })
}

fn corners(solid: &Solid) -> impl Iterator<Item = [f64; 3]> + '_ {
    (0..8)
        .map(|k| corner(solid, [k & 1, (k >> 1) & 1, k >> 2].map(|side| if side == 0 { -1.0 } else { 1.0 })))
}

fn corner(solid: &Solid, sides: [f64; 3]) -> [f64; 3] {
    let mut at = solid.center;
    for (half, side) in solid.halves.iter().zip(sides) {
        at = plus(at, 1.0, *half, side);
    }
    at
}

/// Face turned to the viewer, with its depth and brightness.
struct Face {
    near: f64,
    light: f64,
    group: usize,
    corners: [[f64; 3]; 4],
}

fn faces(solid: &Solid, view: &View) -> Vec<Face> {
    let mut all = Vec::with_capacity(3);
    for k in 0..3 {
        let toward = dot(view.0[2], solid.halves[k]);
        let size = dot(solid.halves[k], solid.halves[k]).sqrt();
        // An edge-on face is invisible. A plate without thickness keeps its large faces.
        if size > 0.0 && toward.abs() < 1e-9 * size {
            continue;
        }
        let side = if toward < 0.0 { -1.0 } else { 1.0 };
        let at = |i: f64, j: f64| {
            let mut sides = [side; 3];
            (sides[(k + 1) % 3], sides[(k + 2) % 3]) = (i, j);
            view.place(corner(solid, sides))
        };
        let corners = [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)];
        let near = corners.iter().map(|corner| 0.25 * corner[2]).sum();
        let light = if size > 0.0 { toward.abs() / size } else { 1.0 };
        all.push(Face { near, light, group: solid.group, corners });
    }
    all
}

fn draw(all: &Solids, view: &View, at: impl Fn([f64; 3]) -> Point, extent: f64, sheet: &mut Sheet) {
    let least = POINT * extent;
    let solids = all.solids.iter().map(|solid| {
        let is_point = solid.halves.iter().all(|half| dot(*half, *half).sqrt() < least);
        let halves = if is_point { UNIT.map(|axis| axis.map(|x| least * x)) } else { solid.halves };
        Solid { halves, ..solid.clone() }
    });
    let mut faces: Vec<Face> = solids.flat_map(|solid| faces(&solid, view)).collect();
    faces.sort_by(|a, b| a.near.total_cmp(&b.near));
    for face in faces {
        let corners = face.corners.map(&at).to_vec();
        let outline = corners.iter().chain(&corners[..1]).copied().collect();
        let opacity = 0.28 + 0.3 * face.light;
        sheet.marks.push(Mark::Polygon { corners, fill: colour(face.group), opacity });
        sheet.line(outline, Pen::solid(Colour::TEXT, 0.6).faint(0.55));
    }
    frame_of_the_body(view, &at, extent, sheet);
    let center = at(view.place(all.center));
    for (k, ends) in axes(all).into_iter().enumerate() {
        let [far, near] = ends.map(|end| at(view.place(end)));
        sheet.line(vec![far, near], axis_pen(k));
        // An axis toward the viewer has no visible end for a name.
        if (near[0] - center[0]).hypot(near[1] - center[1]) > 14.0 {
            let name = Text::small(
                [near[0], near[1] - 4.0],
                Anchor::Middle,
                axis_pen(k).colour,
                &format!("{}", k + 1),
            );
            sheet.marks.push(Mark::Text(Text { halo: true, ..name }));
        }
    }
    sheet.dots(vec![center], Pen::solid(Colour(0xff_ff_ff), 9.0));
    sheet.dots(vec![center], Pen::solid(Colour::BLACK, 6.0));
}

/// Draws the body axes at the origin.
fn frame_of_the_body(view: &View, at: &impl Fn([f64; 3]) -> Point, extent: f64, sheet: &mut Sheet) {
    let origin = at(view.place([0.0; 3]));
    for (axis, name) in UNIT.iter().zip(NAMES) {
        let [x, y] = at(view.place(axis.map(|x| 0.09 * extent * x)));
        if (x - origin[0]).hypot(y - origin[1]) < 6.0 {
            continue;
        }
        sheet.line(vec![origin, [x, y]], Pen::solid(Colour::TEXT, 1.1));
        let [dx, dy] = [x - origin[0], y - origin[1]].map(|d| d / (x - origin[0]).hypot(y - origin[1]));
        let text =
            Text::small([x + 8.0 * dx, y + 8.0 * dy + 0.36 * SMALL], Anchor::Middle, Colour::TEXT, name);
        sheet.marks.push(Mark::Text(Text { halo: true, ..text }));
    }
}

fn axis_pen(k: usize) -> Pen {
    Pen { width: 1.8, ..Pen::axis(k) }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// Returns s a + t b.
fn plus(a: [f64; 3], s: f64, b: [f64; 3], t: f64) -> [f64; 3] {
    core::array::from_fn(|k| s * a[k] + t * b[k])
}
