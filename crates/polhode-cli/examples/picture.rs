//! The README's picture, as SVG: the momentum of a T-handle in the body, and how it flips.
//!
//! `cargo run -p polhode-cli --example picture -- examples/t-handle.toml docs/t-handle.svg`

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::path::Path;

use polhode::{Direction, Drift, FreeRegime, Principal};
use polhode_formats::scenario;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scenario, picture] = arguments.as_slice() else {
        return Err("usage: picture SCENARIO.toml PICTURE.svg".into());
    };
    Ok(std::fs::write(picture, draw(Path::new(scenario))?)?)
}

/// Draws a free motion that flips; its axes, times and rates are those of the T-handle.
pub(crate) fn draw(path: &Path) -> Result<String, Box<dyn Error>> {
    let scenario = scenario::read(path)?;
    let motion = scenario.simulate().ok_or("the scenario has no [run] section")??;
    let rotor = scenario.rotor();
    let free = FreeRegime::of(&rotor, &scenario.start);
    let (period, flip) = free.period.zip(free.flip_interval).ok_or("the motion does not flip")?;
    let drift = Drift::of(&motion).ok_or("the motion has no samples")?.momentum_magnitude;

    let moments = rotor.principal().moments();
    let to_principal = rotor.principal().rotation().inverse();
    let (mut momentum, mut omega) = (Vec::new(), Vec::new());
    for sample in motion.samples() {
        let [w1, w2, w3] = (to_principal * sample.state.omega).to_array();
        omega.push([sample.state.time, w1, w2, w3]);
        if sample.state.time <= period {
            let l = Direction::new(moments[0] * w1, moments[1] * w2, moments[2] * w3);
            momentum.push(l.direction().ok_or("the body is at rest")?);
        }
    }
    let digits = (-drift.log10()).min(15.0).floor();
    let caption = format!("Flips every {flip:.2} s; |L| constant to {digits} digits.");
    Ok([HEAD, &sphere(moments, &momentum)?, &plot(&omega, &caption), "</svg>\n"].concat())
}

/// Colours by Okabe and Ito, on a white card, which GitHub's dark mode needs.
const HEAD: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 960 420" width="960" height="420" role="img">
<title>A T-handle in free fall: its momentum circles near the separatrix, and it flips over and over</title>
<style>
text { font: 13px system-ui, -apple-system, "Segoe UI", Roboto, Helvetica, Arial, sans-serif; fill: #59636e }
path { fill: none; stroke-width: 1.1; stroke-linecap: round; stroke-linejoin: round }
.title { font-size: 16px; font-weight: 600; fill: #1f2328 }
.label { font-size: 16px; font-weight: 700; text-anchor: middle; paint-order: stroke; stroke: #fff; stroke-width: 4px }
.end { text-anchor: end }
.middle { text-anchor: middle }
.ring { stroke: #818b98; opacity: .6 }
.axis1 { stroke: #0072b2 } text.axis1 { fill: #0072b2 }
.axis2 { stroke: #d55e00 } text.axis2 { fill: #d55e00 }
.axis3 { stroke: #009e73 } text.axis3 { fill: #009e73 }
text.axis1, text.axis2, text.axis3 { stroke: #fff }
.bold { stroke-width: 2.2 }
.separatrix { stroke: #e69f00; stroke-width: 5.5; opacity: .75 }
.trace { stroke: #1f2328; stroke-width: 2 }
.arrow { fill: #1f2328 }
.far { opacity: .2 }
.grid { stroke: #d8dee4; stroke-width: 1 }
.flip { stroke: #818b98; stroke-width: 1; stroke-dasharray: 0 4 }
.bar { stroke: #59636e; stroke-width: 4.5 }
.stem { stroke: #afb8c1; stroke-width: 4.5; stroke-linecap: butt }
</style>
<radialGradient id="ball" cx=".38" cy=".3" r=".8"><stop stop-color="#fff"/><stop offset="1" stop-color="#e4e9ef"/></radialGradient>
<rect x=".5" y=".5" width="959" height="419" rx="12" fill="#fff" stroke="#d1d9e0"/>
"##;
/// Base lines of the titles and of what stands below.
const TITLE: f64 = 42.0;
const FOOT: f64 = 392.0;

// The left half: the momentum sphere.

const MARGIN: f64 = 36.0;
const CENTER: [f64; 2] = [222.0, 224.0];
const RADIUS: f64 = 134.0;
/// The curves about an axis divide the way to the separatrix into so many parts.
const RINGS: u32 = 5;

fn sphere(moments: [f64; 3], momentum: &[Direction<Principal>]) -> Result<String, Box<dyn Error>> {
    let view = View::from(Direction::new(-0.46, 0.34, -0.82)).ok_or("no view")?;
    let (mut near, mut far) = (String::new(), String::new());
    let mut draw = |class: &str, curve: &[Direction<Principal>]| {
        near += &view.side(true, class, curve);
        far += &view.side(false, class, curve);
    };
    for ring in rings(moments, 3, 1.0) {
        draw("separatrix", &ring);
    }
    for k in 1..RINGS {
        for axis in [1, 3] {
            for ring in rings(moments, axis, f64::from(k) / f64::from(RINGS)) {
                draw(&format!("ring axis{axis}"), &ring);
            }
        }
    }
    draw("trace", momentum);
    let crossings = momentum.windows(2).filter(|l| l[0].y * l[1].y < 0.0);
    let arrows: String = crossings.map(|l| arrow(view.at(l[0]), view.at(l[1]))).collect();

    let mut axes = String::new();
    for (k, axis) in [(1, [1.0, 0.0, 0.0]), (2, [0.0, 1.0, 0.0]), (3, [0.0, 0.0, 1.0])] {
        let axis = view.near(Direction::from_array(axis));
        axes += &path(&format!("bold axis{k}"), &[view.at(axis), view.at(axis * 1.2)]);
        let [x, y] = view.at(axis * 1.31);
        axes += &text(&format!("label axis{k}"), [x, y + 5.5], &k.to_string());
    }
    let mut foot = String::new();
    for (k, class, name) in
        [(0.0, "trace", "this motion"), (1.0, "separatrix", "separatrix"), (2.0, "ring", "other energies")]
    {
        foot += &key(class, [MARGIN + 122.0 * k, FOOT], name);
    }
    let [x, y] = CENTER;
    Ok(format!(
        "{}<circle cx=\"{x}\" cy=\"{y}\" r=\"{RADIUS}\" fill=\"url(#ball)\" stroke=\"#d1d9e0\"/>\n\
         <g class=\"far\">\n{far}</g>\n{near}{arrows}{axes}{foot}",
        text("title", [MARGIN, TITLE], "Angular momentum in the body"),
    ))
}

/// The two curves of constant energy on the unit sphere about axis 1 or 3; `part` is 0 on the axis, 1 on the separatrix.
///
/// Σ l²/I is constant on them, so what one sees of them along the axis is an ellipse.
fn rings([i1, i2, i3]: [f64; 3], axis: u8, part: f64) -> [Vec<Direction<Principal>>; 2] {
    let (a, c) = if axis == 3 { (i1, i3) } else { (i3, i1) };
    let narrow = ((1.0 / i2 - 1.0 / c) / (1.0 / a - 1.0 / c)).sqrt();
    let long = (part * FRAC_PI_2).sin();
    [1.0, -1.0].map(|side| {
        let at = |k: u32| {
            let (sin, cos) = (f64::from(k) / 720.0 * TAU).sin_cos();
            let (la, l2) = (long * narrow * cos, long * sin);
            let lc = side * (1.0 - la * la - l2 * l2).max(0.0).sqrt();
            if axis == 3 { Direction::new(la, l2, lc) } else { Direction::new(lc, l2, la) }
        };
        (0..=720).map(at).collect()
    })
}

/// The sphere seen from far away, axis 2 upward.
struct View {
    right: Direction<Principal>,
    up: Direction<Principal>,
    toward: Direction<Principal>,
}

impl View {
    fn from(viewer: Direction<Principal>) -> Option<Self> {
        let toward = viewer.direction()?;
        let right = Direction::new(0.0, 1.0, 0.0).cross(toward).direction()?;
        Some(Self { right, up: toward.cross(right), toward })
    }

    fn at(&self, v: Direction<Principal>) -> [f64; 2] {
        [CENTER[0] + RADIUS * v.dot(self.right), CENTER[1] - RADIUS * v.dot(self.up)]
    }

    fn is_near(&self, v: Direction<Principal>) -> bool {
        v.dot(self.toward) >= 0.0
    }

    /// The end of an axis that one sees.
    fn near(&self, axis: Direction<Principal>) -> Direction<Principal> {
        if self.is_near(axis) { axis } else { -axis }
    }

    /// The parts of a curve on the near or the far side.
    fn side(&self, near: bool, class: &str, curve: &[Direction<Principal>]) -> String {
        curve
            .chunk_by(|a, b| self.is_near(*a) == self.is_near(*b))
            .filter(|part| part.first().is_some_and(|v| self.is_near(*v) == near))
            .map(|part| path(class, &part.iter().map(|v| self.at(*v)).collect::<Vec<_>>()))
            .collect()
    }
}

// The right half: ω against time.

const LEFT: f64 = 500.0;
const RIGHT: f64 = 912.0;
const ZERO: f64 = 238.0;
const PX_PER_RAD_S: f64 = 16.5;

/// Rows of `omega` are t, ω1, ω2, ω3.
fn plot(omega: &[[f64; 4]], caption: &str) -> String {
    let end = omega.last().map_or(1.0, |row| row[0]);
    let x = |t: f64| LEFT + t / end * (RIGHT - LEFT);
    let y = |w: f64| ZERO - PX_PER_RAD_S * w;
    let margin = LEFT - 26.0;
    let mut svg = text("title", [margin, TITLE], "Angular velocity along its principal axes, rad/s");
    for (k, name) in [(1, "ω₁ least"), (2, "ω₂ intermediate"), (3, "ω₃ greatest moment")] {
        svg += &key(&format!("bold axis{k}"), [margin + [0.0, 100.0, 242.0][k - 1], TITLE + 28.0], name);
    }
    for w in [-6, -3, 0, 3, 6] {
        let at = y(f64::from(w));
        svg += &path("grid", &[[LEFT, at], [RIGHT, at]]);
        svg += &text("end", [LEFT - 9.0, at + 4.5], &w.to_string().replace('-', "−"));
    }
    for t in [0, 5, 10, 15, 20] {
        svg += &text("middle", [x(f64::from(t)), y(-6.0) + 26.0], &format!("{t} s"));
    }
    svg += &text("", [margin, FOOT], caption);

    let flips = omega.windows(2).filter(|row| row[0][2] * row[1][2] < 0.0).map(|row| row[0][0]);
    let bounds: Vec<f64> = [0.0].into_iter().chain(flips).chain([end]).collect();
    for (k, stay) in bounds.windows(2).enumerate() {
        if k > 0 {
            svg += &path("flip", &[[x(stay[0]), y(7.6)], [x(stay[0]), y(-6.4)]]);
        }
        let (middle, up) = (x(0.5 * (stay[0] + stay[1])), if k % 2 == 0 { 1.0 } else { -1.0 });
        let bar = y(7.6) + 7.0 * up;
        svg += &path("stem", &[[middle, bar], [middle, bar - 16.0 * up]]);
        svg += &path("bar", &[[middle - 10.0, bar], [middle + 10.0, bar]]);
    }
    for k in [3, 1, 2] {
        let curve: Vec<_> = omega.iter().map(|row| [x(row[0]), y(row[k])]).collect();
        svg += &path(&format!("bold axis{k}"), &curve);
    }
    svg
}

// What both are drawn with.

fn text(class: &str, [x, y]: [f64; 2], content: &str) -> String {
    format!("<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{content}</text>\n")
}

/// A line of the legend.
fn key(class: &str, [x, y]: [f64; 2], name: &str) -> String {
    path(class, &[[x, y - 4.5], [x + 16.0, y - 4.5]]) + &text("", [x + 24.0, y], name)
}

/// The head of an arrow between two points.
fn arrow([x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) -> String {
    let length = (x1 - x0).hypot(y1 - y0);
    let (tx, ty) = ((x1 - x0) / length, (y1 - y0) / length);
    let at = |along: f64, across: f64| [x1 + along * tx - across * ty, y1 + along * ty + across * tx];
    path("trace arrow", &[at(-5.0, 4.0), at(5.0, 0.0), at(-5.0, -4.0)])
}

/// A curve through the points, to the tenth of a pixel: those straight ahead are left out.
fn path(class: &str, points: &[[f64; 2]]) -> String {
    let mut corners: Vec<[f64; 2]> = points.first().copied().into_iter().collect();
    for pair in points.windows(2) {
        let ([x, y], [dx, dy]) = (pair[0], [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]]);
        let bent =
            |&[x0, y0]: &[f64; 2]| ((x - x0) * dy - (y - y0) * dx).powi(2) > 0.03 * (dx * dx + dy * dy);
        if corners.last().is_some_and(bent) {
            corners.push([x, y]);
        }
    }
    corners.extend(points.last());
    let d: Vec<String> = corners.iter().map(|[x, y]| format!("{x:.1} {y:.1}")).collect();
    format!("<path class=\"{class}\" d=\"M{}\"/>\n", d.join("L"))
}
