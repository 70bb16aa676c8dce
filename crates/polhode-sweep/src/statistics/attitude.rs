//! Distribution of attitudes: their mean, and the rotation of each from it.

use polhode::math::{Attitude, Body, Rotation};

use super::passes::Parts;
use crate::batch::{Batch, Column, Values};
use crate::error::SweepError;

/// Mean of attitudes.
#[derive(Clone, Debug)]
pub(super) struct MeanAttitude {
    /// Prefix of the columns `STEM_w`, `STEM_x`, `STEM_y`, `STEM_z`.
    pub(super) stem: String,
    mean: Attitude,
}

/// Sum of q qᵀ, which is independent of the sign of q.
type Outer = [[f64; 4]; 4];

/// Returns the mean of each attitude: the q that maximizes Σ (q · qₖ)², the eigenvector of Σ qₖ qₖᵀ
/// with the greatest eigenvalue (Markley, Cheng, Crassidis and Oshman, Averaging quaternions,
/// 2007).
pub(super) fn means(parts: &Parts<'_>, stems: &[String]) -> Result<Vec<MeanAttitude>, SweepError> {
    let of = |part| {
        let batch = (parts.read)(part)?;
        Ok(stems.iter().map(|stem| outer(&quaternions(&batch, stem))).collect::<Vec<_>>())
    };
    let merge = |a: Vec<Outer>, b: Vec<Outer>| a.iter().zip(&b).map(|(a, b)| sum(a, b)).collect();
    let sums = parts.in_order(of, merge)?.unwrap_or_default();
    let mean = |(stem, sum): (&String, Outer)| {
        let mean = Attitude::from_quaternion(greatest_eigenvector(sum)?).ok()?;
        Some(MeanAttitude { stem: stem.clone(), mean })
    };
    Ok(stems.iter().zip(sums).filter_map(mean).collect())
}

impl MeanAttitude {
    /// Returns the mean as (w, x, y, z), w ≥ 0.
    pub(super) fn quaternion(&self) -> [f64; 4] {
        self.mean.canonical_quaternion()
    }

    /// Replaces the quaternions of a table by rotations from the mean: the angle, and its
    /// components along the body axes in the mean attitude.
    pub(super) fn put(&self, batch: Batch) -> Batch {
        let turns: Vec<Option<[f64; 4]>> = quaternions(&batch, &self.stem)
            .into_iter()
            .map(|q| {
                let turn = self.mean.inverse() * Attitude::from_quaternion(q?).ok()?;
                let [w, x, y, z] = Rotation::<Body, Body>::canonical_quaternion(turn);
                // Rotation vector of length angle: 2 atan(|v|/w) v/|v|.
                let sine = libm::hypot(libm::hypot(x, y), z);
                let angle = 2.0 * libm::atan2(sine, w);
                let factor = if sine > 0.0 { angle / sine } else { 2.0 };
                Some([angle, factor * x, factor * y, factor * z])
            })
            .collect();
        let stem = &self.stem;
        let angle = format!("angle between {stem} and its mean");
        let turn = format!(
            "rotation vector of {stem} from its mean, component along a body axis in the mean attitude"
        );
        let columns = self.columns().into_iter().enumerate().map(|(k, name)| {
            let values = turns.iter().map(|turn| turn.and_then(|turn| turn.get(k).copied())).collect();
            Column::new([&name, "rad", if k == 0 { &angle } else { &turn }], Values::Perhaps(values))
        });
        let rest = batch.columns().iter().filter(|column| !components(stem).contains(&column.name)).cloned();
        // Other columns do not end in `_from_mean_rad`.
        Batch::new(rest.chain(columns).collect()).unwrap_or(batch)
    }

    /// Returns the names of the columns that [`MeanAttitude::put`] adds.
    pub(super) fn columns(&self) -> [String; 4] {
        ["", "_x", "_y", "_z"].map(|suffix| format!("{}_from_mean{suffix}_rad", self.stem))
    }
}

fn components(stem: &str) -> [String; 4] {
    ["w", "x", "y", "z"].map(|component| format!("{stem}_{component}"))
}

/// Returns the quaternion of each row; `None` if missing.
fn quaternions(batch: &Batch, stem: &str) -> Vec<Option<[f64; 4]>> {
    let columns = components(stem).map(|name| batch.column(&name).ok().map(|column| &column.values));
    let quaternion = |row: usize| {
        let [w, x, y, z] = columns.map(|column| column?.number(row));
        Some([w?, x?, y?, z?])
    };
    (0..batch.rows()).map(quaternion).collect()
}

fn outer(quaternions: &[Option<[f64; 4]>]) -> Outer {
    let each = quaternions.iter().flatten();
    each.fold([[0.0; 4]; 4], |all, q| {
        sum(&all, &std::array::from_fn(|i| std::array::from_fn(|j| q[i] * q[j])))
    })
}

fn sum(a: &Outer, b: &Outer) -> Outer {
    std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] + b[i][j]))
}

/// Returns the eigenvector of the greatest eigenvalue by repeated squaring: A², A⁴, … converges to
/// v vᵀ. `None` for an empty sum.
fn greatest_eigenvector(mut a: Outer) -> Option<[f64; 4]> {
    for _ in 0..40 {
        let trace = a[0][0] + a[1][1] + a[2][2] + a[3][3];
        if !(trace > 0.0 && trace.is_finite()) {
            return None;
        }
        let scaled: Outer = a.map(|row| row.map(|x| x / trace));
        a = std::array::from_fn(|i| {
            std::array::from_fn(|j| (0..4).map(|k| scaled[i][k] * scaled[k][j]).sum::<f64>())
        });
    }
    a.into_iter()
        .max_by(|p, q| p.iter().map(|x| x * x).sum::<f64>().total_cmp(&q.iter().map(|x| x * x).sum()))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may")]

    use super::*;

    #[test]
    fn the_mean_of_turns_about_an_axis_is_that_of_their_angles() {
        // Quaternions of either sign, about an axis without symmetry.
        let base = Attitude::from_quaternion([0.3, -0.5, 0.7, 0.2]).unwrap();
        let turn = |angle: f64| {
            let axis = polhode::math::Direction::<Body>::new(0.36, -0.48, 0.8);
            (base * Rotation::<Body, Body>::from_axis_angle(axis, angle).unwrap()).quaternion()
        };
        let angles = [-0.2, 0.1, 0.4];
        let all = angles.iter().enumerate().map(|(k, a)| {
            let q = turn(*a);
            Some(if k == 1 { q.map(|c| -c) } else { q })
        });
        let mean = Attitude::from_quaternion(greatest_eigenvector(outer(&all.collect::<Vec<_>>())).unwrap())
            .unwrap();
        assert!(mean.angle_to(Attitude::from_quaternion(turn(0.1)).unwrap()) < 1e-14);
        assert_eq!(greatest_eigenvector([[0.0; 4]; 4]), None);
    }

    #[test]
    fn turns_from_the_mean_are_rotation_vectors() {
        let column = |name: &str, x: Vec<f64>| Column::new([name, "", ""], Values::Numbers(x));
        let half = 0.15_f64;
        let q = [[1.0, 0.0, 0.0, 0.0], [half.cos(), 0.0, half.sin() * 0.6, -half.sin() * 0.8]];
        let columns = ["w", "x", "y", "z"].into_iter().enumerate();
        let columns = columns.map(|(k, c)| column(&format!("a_{c}"), q.iter().map(|q| q[k]).collect()));
        let batch = Batch::new(columns.collect()).unwrap();
        let mean = MeanAttitude { stem: "a".to_owned(), mean: Attitude::identity() };
        let turned = mean.put(batch);
        for (name, want) in mean.columns().iter().zip([0.3, 0.0, 0.18, -0.24]) {
            let Values::Perhaps(values) = &turned.column(name).unwrap().values else { unreachable!() };
            assert!((values[1].unwrap() - want).abs() < 1e-15 && values[0] == Some(0.0), "{name} {values:?}");
        }
        assert!(turned.column("a_w").is_err());
    }
}
