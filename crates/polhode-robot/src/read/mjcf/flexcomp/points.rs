//! Points that the type of a `<flexcomp>` makes: lines, grids, and what grids are bent to.

use std::f64::consts::PI;

use super::{Flex, Lattice};

/// The type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    Grid,
    Circle,
    Box,
    Cylinder,
    Ellipsoid,
    Square,
    Disc,
    Mesh,
    Gmsh,
    Direct,
}

impl Form {
    pub(super) fn of(word: &str) -> Option<Self> {
        Some(match word {
            "grid" => Self::Grid,
            "circle" => Self::Circle,
            "box" => Self::Box,
            "cylinder" => Self::Cylinder,
            "ellipsoid" => Self::Ellipsoid,
            "square" => Self::Square,
            "disc" => Self::Disc,
            "mesh" => Self::Mesh,
            "gmsh" => Self::Gmsh,
            "direct" => Self::Direct,
            _ => return None,
        })
    }

    /// How many points it makes, or a bound of it; zero if it has them from elsewhere.
    pub(super) fn number(self, dim: usize, count: [usize; 3]) -> usize {
        let [x, y, z] = count;
        let product = |all: &[usize]| all.iter().fold(1_usize, |product, n| product.saturating_mul(*n));
        match self {
            Self::Mesh | Self::Gmsh | Self::Direct => 0,
            Self::Box | Self::Cylinder | Self::Ellipsoid => {
                [[x, y], [y, z], [z, x]].iter().fold(1, |sum, side| sum + product(side).saturating_mul(2))
            }
            _ => product(count.get(..dim).unwrap_or(&count)),
        }
    }
}

/// The points of a type that makes them.
pub(super) fn made(flex: &Flex<'_>) -> Result<Lattice, String> {
    let Flex { dim, count: [x, y, z], spacing, .. } = *flex;
    let is_box = matches!(flex.form, Form::Box | Form::Cylinder | Form::Ellipsoid);
    let few = match dim {
        _ if is_box => dim < 2 || flex.count.contains(&1),
        1 => x < if flex.form == Form::Circle { 3 } else { 2 },
        2 => x < 2 || y < 2 || z != 1,
        _ => x < 2 || y < 2 || z < 2,
    };
    if few {
        return Err("count does not fit its dim, and MuJoCo refuses the file".to_owned());
    }
    let along =
        |axis: usize, number: usize, count: usize| spacing[axis] * (number as f64 - 0.5 * (count - 1) as f64);
    let mut points = Vec::new();
    match (flex.form, dim) {
        _ if is_box => points = on_box(flex),
        (Form::Circle, 1) => {
            let step = 2.0 * PI / (x - 1) as f64;
            let radius = 0.5 * spacing[0] / libm::sin(0.5 * step);
            points.extend((0..x - 1).map(|k| {
                let (sin, cos) = libm::sincos(step * k as f64);
                [radius * cos, radius * sin, 0.0]
            }));
        }
        _ => {
            let (y, z) = (if dim > 1 { y } else { 1 }, if dim > 2 { z } else { 1 });
            for i in 0..x {
                for j in 0..y {
                    points.extend((0..z).map(|k| [along(0, i, x), along(1, j, y), along(2, k, z)]));
                }
            }
        }
    }
    if flex.form == Form::Disc {
        let half = [0, 1].map(|k| 0.5 * spacing[k] * (flex.count[k] - 1) as f64);
        for point in &mut points {
            // the factor is a length, so that the disc is smaller than its square: as MuJoCo has it
            let factor = point[0].abs().max(point[1].abs());
            let [u, v, _] = unit([point[0], point[1], 0.0]);
            *point = [u * half[0] * factor, v * half[1] * factor, point[2]];
        }
    }
    Ok(Lattice { dim, points, elements: None })
}

/// The points on the surface of a box, and what they are bent to; in three dimensions its middle before them. In two the box has
/// no lid.
fn on_box(flex: &Flex<'_>) -> Vec<[f64; 3]> {
    let Flex { count: [x, y, z], form, .. } = *flex;
    let half = [0, 1, 2].map(|k| 0.5 * flex.spacing[k] * (flex.count[k] - 1) as f64);
    let place = |number: [usize; 3]| {
        let p = [0, 1, 2].map(|k| 2.0 * number[k] as f64 / (flex.count[k] - 1) as f64 - 1.0);
        let p = match form {
            Form::Cylinder => {
                let factor = p[0].abs().max(p[1].abs());
                let [u, v, _] = unit([p[0], p[1], 0.0]);
                [factor * u, factor * v, p[2]]
            }
            Form::Ellipsoid => unit(p),
            _ => p,
        };
        [0, 1, 2].map(|k| half[k] * p[k])
    };
    let mut points = Vec::new();
    let (ends, walls) = match flex.dim {
        3 => (vec![0, z - 1], 1..z - 1),
        _ => (vec![0], 1..z),
    };
    if flex.dim == 3 {
        points.push([0.0; 3]);
    }
    for k in ends {
        points.extend((0..x).flat_map(|i| (0..y).map(move |j| [i, j, k])).map(place));
    }
    for j in [0, y - 1] {
        points.extend((0..x).flat_map(|i| walls.clone().map(move |k| [i, j, k])).map(place));
    }
    for i in [0, x - 1] {
        points.extend((1..y - 1).flat_map(|j| walls.clone().map(move |k| [i, j, k])).map(place));
    }
    points
}

/// Of length 1; x for no direction.
fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    if length < super::LEAST { [1.0, 0.0, 0.0] } else { v.map(|c| c / length) }
}
