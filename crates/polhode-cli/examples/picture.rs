//! Draws the SVG picture of the README: the angular momentum of a T-handle in body axes, and its
//! flips.
//!
//! `cargo run -p polhode-cli --example picture -- examples/t-handle.toml docs/t-handle.svg`

use std::error::Error;
use std::path::Path;

use polhode_scenario::read as scenario;
use polhode_scenario::report::{Figure, MotionFigures};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scenario, picture] = arguments.as_slice() else {
        return Err("usage: picture SCENARIO.toml PICTURE.svg".into());
    };
    Ok(std::fs::write(picture, draw(Path::new(scenario))?)?)
}

/// Draws a free motion: the momentum sphere with ω next to it.
pub(crate) fn draw(path: &Path) -> Result<String, Box<dyn Error>> {
    let scenario = scenario::read(path)?;
    let trajectory = scenario.simulate().ok_or("the scenario has no [run] section")??;
    let figures = MotionFigures::of_scenario(&scenario, &trajectory);
    Ok(figures.side_by_side(&[Figure::Polhodes, Figure::Omega])?.to_svg())
}
