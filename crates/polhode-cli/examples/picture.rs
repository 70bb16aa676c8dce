//! The README's picture, as SVG: a T-handle's momentum in the body, and how it flips.
//!
//! `cargo run -p polhode-cli --example picture -- examples/t-handle.toml docs/t-handle.svg`

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::path::Path;

use polhode::{Direction, Drift, FreeRegime, Principal, Trajectory};
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
    let _ = Trajectory::samples;
    let digits = (-drift.log10()).min(15.0).floor();
    let caption = format!("A flip every {flip:.2} s; |L| constant to {digits} digits");
    Ok([
        HEAD,
        &sphere(moments, &momentum),
        &plot(&omega, flip),
        &text("end", [924.0, 398.0], &caption),
        "</svg>\n",
    ]
    .concat())
}
