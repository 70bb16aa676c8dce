//! What repairs of a mesh may be off, together.

use super::MeshRepair;

/// What a repair leaves open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RepairBound {
    /// How much more or less the mesh may enclose, m³.
    pub volume: f64,
    /// How much farther out than its corners that may be, m.
    pub beyond: f64,
}

impl RepairBound {
    /// Of several repairs, one after another.
    ///
    /// Welding by up to d moves the rim of a hole by no more, so that what is missing there lies in a ball of r + d. By Minkowski,
    /// Σ (r + d)³ ≤ (³√Σr³ + d ³√N)³ of N holes. A ball has a corner of the mesh on it, and so is nowhere farther out than 2 r.
    pub fn of(repairs: &[MeshRepair]) -> Self {
        let (mut all, mut moved) = (Self { volume: 0.0, beyond: 0.0 }, 0.0_f64);
        for repair in repairs {
            let (volume, beyond) = match *repair {
                MeshRepair::Welded { bound, .. } => {
                    moved = moved.max(bound.beyond);
                    (bound.volume, bound.beyond)
                }
                MeshRepair::Filled { bound, .. } if moved == 0.0 => (bound.volume, bound.beyond),
                MeshRepair::Filled { holes, bound, .. } => {
                    let unit = 4.0 / 3.0 * std::f64::consts::PI;
                    let radii = libm::cbrt(bound.volume / unit) + moved * libm::cbrt(holes as f64);
                    (unit * radii.powi(3), bound.beyond + moved)
                }
            };
            all = Self { volume: all.volume + volume, beyond: all.beyond.max(beyond) };
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of balls that a weld made larger; as large as each other they have the sum, and otherwise less than the bound.
    #[test]
    fn a_weld_widens_the_balls_of_the_holes_that_are_filled_after_it() {
        let (welded, moved) = (2e-5, 0.03);
        let weld = MeshRepair::Welded {
            vertices: 3,
            points: 1,
            largest_distance: 0.05,
            vanished: 0,
            bound: RepairBound { volume: welded, beyond: moved },
        };
        let ball = |r: f64| 4.0 / 3.0 * std::f64::consts::PI * r * r * r;
        for radii in [vec![0.7], vec![0.2, 0.2, 0.2], vec![0.9, 0.1], vec![1.3, 0.4, 0.2, 0.05]] {
            let largest = radii.iter().copied().fold(0.0, f64::max);
            let fill = MeshRepair::Filled {
                holes: radii.len(),
                triangles: 7,
                largest,
                left: polhode::body::mesh::HolesLeft::default(),
                bound: RepairBound { volume: radii.iter().copied().map(ball).sum(), beyond: 2.0 * largest },
            };
            assert_eq!(RepairBound::of(&[fill]), fill.bound());
            let both = RepairBound::of(&[weld, fill]);
            let exact: f64 = welded + radii.iter().map(|r| ball(r + moved)).sum::<f64>();
            let excess = both.volume / exact - 1.0;
            let are_equal = radii.iter().all(|r| *r == largest);
            assert!(excess > -1e-14 && excess < if are_equal { 1e-14 } else { 0.2 }, "{radii:?}: {excess}");
            assert_eq!(both.beyond, 2.0 * largest + moved);
        }
    }
}
