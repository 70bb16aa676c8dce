//! The README's picture, as SVG: a T-handle's momentum in the body, and how it flips.
//!
//! `cargo run -p polhode-cli --example picture -- examples/t-handle.toml docs/t-handle.svg`

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::path::Path;

use polhode::{Direction, Drift, FreeRegime, Principal};
use polhode_formats::scenario;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scenario, picture] = &arguments[..] else {
        return Err("usage: picture SCENARIO.toml PICTURE.svg".into());
    };
    Ok(std::fs::write(picture, draw(Path::new(scenario))?)?)
}

/// Colours by Okabe and Ito; GitHub's dark mode gets the white card, too.
const HEAD: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 960 424" width="960" height="424" role="img">
<title>The momentum of a T-handle in free fall, in the body, and its angular velocity: it flips over and over</title>
<style>
text { font: 13px system-ui, -apple-system, "Segoe UI", Roboto, Helvetica, Arial, sans-serif; fill: #59636e }
.title { font-size: 16px; font-weight: 600; fill: #1f2328 }
.end { text-anchor: end }
.middle { text-anchor: middle }
.bold { font-weight: 700 }
path { fill: none; stroke-width: 1.1; stroke-linecap: round; stroke-linejoin: round }
.axis1 { stroke: #0072b2 } text .axis1, text.axis1 { stroke: none; fill: #0072b2 }
.axis2 { stroke: #d55e00 } text .axis2, text.axis2 { stroke: none; fill: #d55e00 }
.axis3 { stroke: #009e73 } text .axis3, text.axis3 { stroke: none; fill: #009e73 }
.wide { stroke-width: 2.2 }
.family { opacity: .62 }
.separatrix { stroke: #f0b429; stroke-width: 5 }
.trace { stroke: #1f2328; stroke-width: 2.2 }
.head { fill: #1f2328; stroke: #1f2328 }
.back { opacity: .16 }
.grid { stroke: #d8dee4; stroke-width: 1; stroke-linecap: butt }
.flip { stroke: #818b98; stroke-width: 1; stroke-dasharray: 2 3; stroke-linecap: butt }
.bar { stroke: #59636e; stroke-width: 4.5 }
.stem { stroke: #aeb6bf; stroke-width: 4.5; stroke-linecap: butt }
</style>
<radialGradient id="ball" cx=".38" cy=".3" r=".75"><stop stop-color="#fff"/><stop offset="1" stop-color="#e6eaef"/></radialGradient>
<rect x=".5" y=".5" width="959" height="423" rx="12" fill="#fff" stroke="#d1d9e0"/>
"##;

/// Draws the motion of a scenario with three different moments.
pub(crate) fn draw(path: &Path) -> Result<String, Box<dyn Error>> {
    let scenario = scenario::read(path)?;
    let rotor = scenario.rotor();
    let motion = scenario.simulate().ok_or("no [run] section")??;
    let free = FreeRegime::of(&rotor, &scenario.start);
    let (period, flip) = free.period.zip(free.flip_interval).ok_or("it does not flip")?;
    let drift = Drift::of(&motion).ok_or("no samples")?.momentum_magnitude;

    let moments = rotor.principal().moments();
    let to_principal = rotor.principal().rotation().inverse();
    let mut omega = Vec::new();
    let mut momentum = Vec::new();
    for sample in motion.samples() {
        let [w1, w2, w3] = (to_principal * sample.state.omega).to_array();
        omega.push([sample.state.time, w1, w2, w3]);
        if sample.state.time <= period {
            momentum.push(Direction::new(moments[0] * w1, moments[1] * w2, moments[2] * w3));
        }
    }
    let digits = (-drift.log10()).min(15.0).floor();
    let caption = format!("A flip every {flip:.2} s; |L| constant to {digits} digits");
    Ok([
        HEAD,
        &sphere(moments, &momentum)?,
        &plot(&omega, flip),
        &text("end", [924.0, 398.0], &caption),
        "</svg>\n",
    ]
    .concat())
}

// The left half: the momentum sphere.

const CENTER: [f64; 2] = [222.0, 238.0];
const RADIUS: f64 = 136.0;

/// An orthographic view of the sphere, axis 2 upward.
struct View {
    right: Direction<Principal>,
    up: Direction<Principal>,
    toward: Direction<Principal>,
}

impl View {
    fn from(x: f64, y: f64, z: f64) -> Option<Self> {
        let toward = Direction::new(x, y, z).direction()?;
        let right = Direction::new(0.0, 1.0, 0.0).cross(toward).direction()?;
        Some(Self { right, up: toward.cross(right), toward })
    }

    fn at(&self, v: Direction<Principal>) -> [f64; 2] {
        [CENTER[0] + RADIUS * v.dot(self.right), CENTER[1] - RADIUS * v.dot(self.up)]
    }

    /// A curve on the sphere, as the parts on its near side or on its far side.
    fn side(&self, near: bool, class: &str, curve: &[Direction<Principal>]) -> String {
        let is_near = |v: &Direction<Principal>| v.dot(self.toward) >= 0.0;
        curve
            .chunk_by(|a, b| is_near(a) == is_near(b))
            .filter(|part| part.first().is_some_and(is_near) == near)
            .map(|part| path(class, &part.iter().map(|v| self.at(*v)).collect::<Vec<_>>()))
            .collect()
    }
}

fn sphere(moments: [f64; 3], momentum: &[Direction<Principal>]) -> Result<String, Box<dyn Error>> {
    let view = View::from(0.42, 0.36, 0.83).ok_or("no view")?;
    let mut curves = Vec::new();
    for axis in [1, 3] {
        for k in 1..RINGS {
            curves.extend(
                rings(moments, axis, f64::from(k) / f64::from(RINGS))
                    .map(|r| (format!("family axis{axis}"), r)),
            );
        }
    }
    curves.extend(rings(moments, 3, 1.0).map(|r| ("separatrix".to_owned(), r)));
    curves.push(("trace".to_owned(), momentum.iter().filter_map(|l| l.direction()).collect()));

    let [x, y] = CENTER;
    let mut far = String::new();
    let mut near = String::new();
    for (class, curve) in &curves {
        far += &view.side(false, class, curve);
        near += &view.side(true, class, curve);
    }
    let mut axes = String::new();
    for (k, name) in [(0, "least"), (1, "intermediate"), (2, "greatest")] {
        let mut axis = [0.0; 3];
        axis[k] = 1.0;
        let axis = Direction::from_array(axis);
        let class = format!("axis{}", k + 1);
        axes += &path(&format!("wide {class}"), &[view.at(axis), view.at(axis * AXIS)]);
        let [x, y] = view.at(axis * (AXIS + 0.1));
        axes += &text(&format!("middle {class}"), [x, y + 4.0], &format!("{} {name}", k + 1));
    }
    Ok(format!(
        "{}<circle cx=\"{x}\" cy=\"{y}\" r=\"{RADIUS}\" fill=\"url(#ball)\"/>\n<g class=\"back\">\n{far}</g>\n{near}{axes}",
        text("title", [36.0, 42.0], "Angular momentum in the body"),
    ))
}

/// Half of the curves of constant energy about an axis: so many between it and the separatrix.
const RINGS: u32 = 5;
/// How long the axes are, in radii.
const AXIS: f64 = 1.2;

/// The two curves of constant energy about an axis, 1 or 3, on the unit sphere; `part` is how near they are to the
/// separatrix: 0 is the axis itself, 1 the separatrix.
///
/// Σ l²/I is constant on them, so their shadow along the axis is an ellipse.
fn rings(moments: [f64; 3], axis: u8, part: f64) -> [Vec<Direction<Principal>>; 2] {
    let [i1, i2, i3] = moments;
    let (a, c) = if axis == 3 { (i1, i3) } else { (i3, i1) };
    let flatness = ((1.0 / i2 - 1.0 / c) / (1.0 / a - 1.0 / c)).sqrt();
    let reach = (part * FRAC_PI_2).sin();
    [1.0, -1.0].map(|sign| {
        (0..=720)
            .map(|k| {
                let (sin, cos) = (f64::from(k) / 720.0 * TAU).sin_cos();
                let (la, l2) = (reach * flatness * cos, reach * sin);
                let lc = sign * (1.0 - la * la - l2 * l2).max(0.0).sqrt();
                if axis == 3 { Direction::new(la, l2, lc) } else { Direction::new(lc, l2, la) }
            })
            .collect()
    })
}

// The right half: ω against time.

const LEFT: f64 = 500.0;
const RIGHT: f64 = 924.0;
const MIDDLE: f64 = 232.0;
/// px per rad/s
const SCALE: f64 = 18.0;

/// Rows of `omega` are t, ω1, ω2, ω3.
fn plot(omega: &[[f64; 4]], flip: f64) -> String {
    let end = omega.last().map_or(1.0, |row| row[0]);
    let x = |t: f64| LEFT + t / end * (RIGHT - LEFT);
    let y = |w: f64| MIDDLE - SCALE * w;
    let mut svg = text("title", [LEFT - 34.0, 42.0], "Angular velocity along its principal axes");
    for w in [-6, -3, 0, 3, 6] {
        let at = y(f64::from(w));
        svg += &path("grid", &[[LEFT, at], [RIGHT, at]]);
        svg += &text("end", [LEFT - 10.0, at + 4.5], &w.to_string().replace('-', "−"));
    }
    for t in [0, 5, 10, 15, 20] {
        svg += &text("middle", [x(f64::from(t)), y(-6.0) + 32.0], &t.to_string());
    }
    let turns: Vec<f64> =
        omega.windows(2).filter(|w| w[0][2] * w[1][2] < 0.0).map(|w| 0.5 * (w[0][0] + w[1][0])).collect();
    for t in &turns {
        svg += &path("flip", &[[x(*t), y(7.2)], [x(*t), y(-6.6)]]);
    }
    let mut bounds = vec![0.0];
    bounds.extend(&turns);
    bounds.push(end);
    for (k, bound) in bounds.windows(2).enumerate() {
        let sign = if k % 2 == 0 { 1 } else { -1 };
        let middle = x(0.5 * (bound[0] + bound[1]));
        svg += &format!(
            "<g transform=\"translate({middle:.1} {:.1}) scale(1 {sign})\"><path class=\"stem\" d=\"M0 6V-9\"/><path class=\"bar\" d=\"M-9 6H9\"/></g>\n",
            y(7.9)
        );
    }
    for k in [3, 1, 2] {
        let curve: Vec<_> = omega.iter().map(|row| [x(row[0]), y(row[k])]).collect();
        svg += &path(&format!("wide axis{k}"), &curve);
    }
    let _ = flip;
    svg
}

fn text(class: &str, [x, y]: [f64; 2], content: &str) -> String {
    format!("<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{content}</text>\n")
}

/// A line through the points, without those that would not be seen.
fn path(class: &str, points: &[[f64; 2]]) -> String {
    let mut d = String::new();
    let mut last = [f64::NEG_INFINITY; 2];
    for (k, &[x, y]) in points.iter().enumerate() {
        if (x - last[0]).abs() + (y - last[1]).abs() > 2.5 || k + 1 == points.len() {
            d += &format!("{}{x:.1} {y:.1}", if k == 0 { 'M' } else { 'L' });
            last = [x, y];
        }
    }
    format!("<path class=\"{class}\" d=\"{d}\"/>\n")
}
