//! Momentum sphere: the path of L in the body.
//!
//! The norm of L is constant, so L moves on a sphere fixed in the body. T is constant too, so its
//! path is a curve Σ l²/I = constant.
//!
//! The sphere is seen from far away, from the side of L, with axis 2 upward. The far side is faint.

use std::f64::consts::{FRAC_PI_2, TAU};

use polhode::body::Symmetry;
use polhode::math::{Direction, Principal};
use polhode::motion::FreeMotion;
use polhode::observe::{CurveError, MomentumTrace};
use polhode_document::figure::axes::Area;
use polhode_document::figure::legend::Key;
use polhode_document::figure::sheet::{Anchor, Colour, Mark, Pen, Point, Sheet, Text};

use super::chart::Heading;
use super::view::View;

/// Number of equal steps from an axis to the separatrix; the curves are drawn between them.
const RINGS: u32 = 5;

pub(crate) const TRACE: Pen = Pen::solid(Colour::BLACK, 2.0);
const SEPARATRIX: Pen = Pen::solid(Colour::ORANGE, 4.0);
/// Relative opacity of the far side.
pub(crate) const FAR: f64 = 0.22;

pub(crate) fn draw(motion: &FreeMotion, sheet: &mut Sheet, heading: Heading<'_>) -> Result<(), CurveError> {
    let trace = trace(motion)?;
    let symmetry = motion.principal().symmetry();
    let asymmetric = symmetry == Symmetry::Asymmetric;
    let mut keys = vec![Key::line(TRACE, "this motion")];
    if asymmetric {
        keys.push(Key::line(SEPARATRIX, "separatrix"));
    }
    let about: &[usize] = match symmetry {
        Symmetry::Asymmetric => &[0, 2],
        Symmetry::Oblate => &[2],
        Symmetry::Prolate => &[0],
        _ => &[],
    };
    for &k in about {
        keys.push(Key::line(ring_pen(k), format!("others about axis {}", k + 1)));
    }
    let area = heading(sheet, &keys);
    let view = view(area, &trace, motion.circles_least());
    sheet.marks.push(Mark::Ball { center: view.center, radius: view.radius });

    let moments = motion.principal().moments();
    let mut curves: Vec<(Pen, Vec<Direction<Principal>>)> = Vec::new();
    if asymmetric {
        curves.extend(rings(moments, 2, 1.0).map(|ring| (SEPARATRIX, ring)));
    }
    for &k in about {
        for part in (1..RINGS).map(|part| f64::from(part) / f64::from(RINGS)) {
            curves.extend(rings(moments, k, part).map(|ring| (ring_pen(k), ring)));
        }
    }
    if !asymmetric && !about.is_empty() {
        // Every axis in the equatorial plane of a symmetric body is a permanent axis.
        curves
            .extend(about.iter().flat_map(|&k| rings(moments, k, 1.0)).take(1).map(|ring| (equator(), ring)));
    }
    curves.push((TRACE, trace.clone()));
    for near in [false, true] {
        for (pen, curve) in &curves {
            let pen = if near { *pen } else { pen.faint(FAR * pen.opacity) };
            sheet.lines(view.side(near, curve), pen);
        }
    }
    for pair in trace.windows(2) {
        if let [a, b] = pair
            && a.y * b.y < 0.0
            && view.is_near(*b)
        {
            arrow(view.at(*a), view.at(*b), sheet);
        }
    }
    if let [only] = trace.as_slice() {
        let pen = Pen::solid(Colour::BLACK, 7.0);
        sheet.dots(vec![view.at(*only)], if view.is_near(*only) { pen } else { pen.faint(FAR) });
    }
    ends_of_axes(&view, sheet);
    Ok(())
}

fn ring_pen(k: usize) -> Pen {
    Pen { width: 1.1, dash: if k == 0 { &[5.0, 2.0] } else { &[] }, ..Pen::axis(k) }.faint(0.75)
}

fn equator() -> Pen {
    Pen::solid(Colour::FRAME, 1.1).dashed(&[2.0, 2.5])
}

/// Returns L/|L| over one period, principal axes.
fn trace(motion: &FreeMotion) -> Result<Vec<Direction<Principal>>, CurveError> {
    let into = motion.principal().rotation().inverse();
    let curve = MomentumTrace::of(motion, 1e-4)?.curve;
    Ok(curve.points().iter().filter_map(|l| (into * *l).direction()).collect())
}

/// Returns the two curves of constant energy on the unit sphere about axis k = 0 or 2.
///
/// `part` is 0 for the axis itself and 1 for the separatrix.
///
/// Seen along the axis the curves are ellipses, because Σ l²/I is constant; circles for two equal
/// moments.
fn rings([i1, i2, i3]: [f64; 3], k: usize, part: f64) -> [Vec<Direction<Principal>>; 2] {
    let (a, c) = if k == 2 { (i1, i3) } else { (i3, i1) };
    // The ratio of the axes of the ellipse is ((1/i2 − 1/c)/(1/a − 1/c))^½.
    let narrow = ((c - i2) / (c - a) * (a / i2)).sqrt();
    let long = (part * FRAC_PI_2).sin();
    [1.0, -1.0].map(|side| {
        let at = |step: u32| {
            let (sin, cos) = (f64::from(step) / 720.0 * TAU).sin_cos();
            let (la, l2) = (long * narrow * cos, long * sin);
            let lc = side * (1.0 - la * la - l2 * l2).max(0.0).sqrt();
            if k == 2 { Direction::new(la, l2, lc) } else { Direction::new(lc, l2, la) }
        };
        (0..=720).map(at).collect()
    })
}

/// Length of the axes from the centre, in radii.
const REACH: f64 = 1.2;
/// Distance of the axis names from the centre, in radii.
const NAME: f64 = 1.33;

/// Returns the view from the side of the path: close to the axis that L circles, slightly from
/// above.
fn view(area: Area, trace: &[Direction<Principal>], about_least: bool) -> View<Principal> {
    const ALONG: f64 = 0.82;
    const ASIDE: f64 = 0.46;
    let (x, z) = trace.iter().fold((0.0, 0.0), |(x, z), l| (x + l.x, z + l.z));
    let side = |sum: f64| if sum < 0.0 { -1.0 } else { 1.0 };
    let viewer = if about_least {
        Direction::new(ALONG * side(x), 0.34, ASIDE * side(x))
    } else {
        Direction::new(ASIDE * side(z), 0.34, ALONG * side(z))
    };
    // Axis 2 extends above the sphere; below it there is only a margin.
    let radius = (area.height() / (1.0 + NAME)).min(area.width() / (2.0 * NAME));
    let center = [0.5 * (area.left + area.right), area.bottom - radius - 3.0];
    View::new(center, radius - 3.0, viewer, Direction::new(0.0, 1.0, 0.0))
}

/// Draws the visible ends of the axes with their numbers.
fn ends_of_axes(view: &View<Principal>, sheet: &mut Sheet) {
    for (k, name) in ["1", "2", "3"].into_iter().enumerate() {
        let mut axis = [0.0; 3];
        if let Some(along) = axis.get_mut(k) {
            *along = 1.0;
        }
        let axis = Direction::from_array(axis);
        let end = if view.is_near(axis) { axis } else { -axis };
        let pen = Pen { width: 2.2, dash: &[], ..Pen::axis(k) };
        sheet.line(vec![view.at(end), view.at(end * REACH)], pen);
        let [x, y] = view.at(end * NAME);
        let text = Text::small([x, y + 5.0], Anchor::Middle, pen.colour, name);
        sheet.marks.push(Mark::Text(Text { size: 15.0, halo: true, ..text }));
    }
}

/// Draws an arrowhead between two points.
pub(crate) fn arrow([x0, y0]: Point, [x1, y1]: Point, sheet: &mut Sheet) {
    let length = (x1 - x0).hypot(y1 - y0);
    if length > 0.0 {
        let (tx, ty) = ((x1 - x0) / length, (y1 - y0) / length);
        let at = |along: f64, across: f64| [x1 + along * tx - across * ty, y1 + along * ty + across * tx];
        let corners = vec![at(-5.5, 4.4), at(6.0, 0.0), at(-5.5, -4.4)];
        sheet.marks.push(Mark::Polygon { corners, fill: Colour::BLACK, opacity: 1.0 });
    }
}
