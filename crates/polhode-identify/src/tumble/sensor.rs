//! Model of a gyro.

use crate::six::PLACES;

/// Gyro errors that are estimated with the body: reading = (1 + S) ω + b.
///
/// The body is expressed in the gyro's axes. A rotation of the whole gyro changes only these axes,
/// so it is not an error.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GyroErrors {
    /// True if the bias b is estimated, rad/s.
    pub bias: bool,
    /// True if the scale errors are estimated: the diagonal of S.
    pub scale: bool,
    /// True if the skew is estimated: the off-diagonal elements of S, which is symmetric.
    pub skew: bool,
    /// True if the clock offset τ, s, is estimated: a reading at gyro time t is the rate at t + τ
    /// on the clock of the attitudes.
    pub clock: bool,
}

/// Values of the gyro errors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Gyro {
    bias: [f64; 3],
    /// Elements xx, yy, zz, xy, xz, yz of S.
    matrix: [f64; 6],
    /// Clock offset τ, s.
    pub(crate) clock: f64,
}

impl GyroErrors {
    /// Returns the number of estimated parameters.
    pub(crate) const fn count(self) -> usize {
        3 * (self.bias as usize + self.scale as usize + self.skew as usize) + self.clock as usize
    }

    pub(crate) fn names(self) -> Vec<(String, &'static str)> {
        let axes = ["x", "y", "z"];
        let mut names = Vec::new();
        if self.bias {
            names.extend(axes.map(|axis| (format!("gyro bias {axis}"), "rad/s")));
        }
        if self.scale {
            names.extend(axes.map(|axis| (format!("gyro scale {axis}"), "1")));
        }
        if self.skew {
            names.extend(["xy", "xz", "yz"].map(|axes| (format!("gyro skew {axes}"), "1")));
        }
        if self.clock {
            names.push(("gyro clock".to_owned(), "s"));
        }
        names
    }

    /// Returns the gyro errors for these estimated parameters; the others are 0.
    pub(crate) fn gyro(self, numbers: &[f64]) -> Gyro {
        let mut gyro = Gyro::default();
        let mut threes = numbers.chunks_exact(3);
        let mut fill = |wanted: bool, place: &mut [f64]| {
            if wanted && let Some(three) = threes.next() {
                place.copy_from_slice(three);
            }
        };
        fill(self.bias, &mut gyro.bias);
        let (diagonal, rest) = gyro.matrix.split_at_mut(3);
        fill(self.scale, diagonal);
        fill(self.skew, rest);
        if self.clock {
            gyro.clock = numbers.last().copied().unwrap_or(0.0);
        }
        gyro
    }

    /// Returns ∂reading/∂parameters, rows x, y, z.
    pub(crate) fn derivatives(self, gyro: &Gyro, omega: [f64; 3], acceleration: [f64; 3]) -> [Vec<f64>; 3] {
        let mut rows = [Vec::new(), Vec::new(), Vec::new()];
        if self.bias {
            for (i, row) in rows.iter_mut().enumerate() {
                row.extend((0..3).map(|k| if k == i { 1.0 } else { 0.0 }));
            }
        }
        let mut elements = |places: &[(usize, usize)]| {
            for (i, row) in rows.iter_mut().enumerate() {
                row.extend(places.iter().map(|&(a, b)| {
                    if i == a {
                        omega[b]
                    } else if i == b {
                        omega[a]
                    } else {
                        0.0
                    }
                }));
            }
        };
        if self.scale {
            elements(&PLACES[..3]);
        }
        if self.skew {
            elements(&PLACES[3..]);
        }
        if self.clock {
            for (row, change) in rows.iter_mut().zip(gyro.times_matrix(acceleration)) {
                row.push(change);
            }
        }
        rows
    }
}

impl Gyro {
    /// Returns 1 + S.
    pub(crate) fn matrix(&self) -> [[f64; 3]; 3] {
        let mut m = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for (&(i, j), &s) in PLACES.iter().zip(&self.matrix) {
            m[i][j] += s;
            if i != j {
                m[j][i] += s;
            }
        }
        m
    }

    /// Returns the predicted reading (1 + S) ω + b.
    pub(crate) fn reading(&self, omega: [f64; 3]) -> [f64; 3] {
        let read = self.times_matrix(omega);
        core::array::from_fn(|i| read[i] + self.bias[i])
    }

    fn times_matrix(&self, v: [f64; 3]) -> [f64; 3] {
        self.matrix().map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }
}
