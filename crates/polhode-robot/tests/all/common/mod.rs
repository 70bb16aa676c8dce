//! Helpers for the tests of the readers.

#![allow(clippy::unwrap_used, dead_code, reason = "a test may; not each of them uses all")]

pub(crate) mod schema;

use std::path::PathBuf;

use polhode_robot::LinkError;
use polhode_robot::model::{RobotModel, Slot};
use polhode_robot::read::{ReadOptions, read_text};
use polhode_source::FormatError;

pub(crate) type Matrix = [[f64; 3]; 3];

pub(crate) fn read(text: &str) -> RobotModel {
    read_text(text, "nowhere/model.xml".as_ref(), &ReadOptions::default()).unwrap()
}

pub(crate) fn refused(text: &str) -> FormatError {
    read_text(text, "nowhere/model.xml".as_ref(), &ReadOptions::default()).unwrap_err()
}

/// Asserts that an error's message contains words.
pub(crate) fn require_says(error: &LinkError, words: &str) {
    let message = error.to_string();
    assert!(message.contains(words), "{message}");
}

/// Returns the text of a number, as in the file, and its value.
pub(crate) fn written<'t>(text: &'t str, slot: &Slot) -> (&'t str, Option<f64>) {
    let Slot::Given(number) = slot else { return ("missing", None) };
    let there = &text[number.span.clone()];
    assert_eq!(there, number.text);
    (there, number.value)
}

/// Returns the matrix of a rotation about axis 0, 1 or 2.
pub(crate) fn matrix_about(axis: usize, angle: f64) -> Matrix {
    let (s, c) = angle.sin_cos();
    match axis {
        0 => [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]],
        1 => [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]],
        _ => [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]],
    }
}

/// Returns the matrix by Rodrigues' formula: R = cos φ 1 + sin φ [n]× + (1 − cos φ) n nᵀ.
pub(crate) fn matrix_about_axis(axis: [f64; 3], angle: f64) -> Matrix {
    let norm = axis.iter().map(|c| c * c).sum::<f64>().sqrt();
    let [x, y, z] = axis.map(|c| c / norm);
    let (s, c) = angle.sin_cos();
    let cross = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    let n = [x, y, z];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| f64::from(u8::from(i == j)) * c + s * cross[i][j] + (1.0 - c) * n[i] * n[j])
    })
}

pub(crate) fn times(a: Matrix, b: Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

pub(crate) fn transposed(a: Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

pub(crate) fn applied(a: Matrix, v: [f64; 3]) -> [f64; 3] {
    a.map(|row| (0..3).map(|k| row[k] * v[k]).sum())
}

pub(crate) fn plus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k] + b[k])
}

#[track_caller]
pub(crate) fn assert_near(a: &Matrix, b: &Matrix, tolerance: f64) {
    let worst = a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(worst <= tolerance, "off by {worst:e}\n{a:?}\n{b:?}");
}

#[track_caller]
pub(crate) fn assert_close(a: [f64; 3], b: [f64; 3], tolerance: f64) {
    let worst = (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max);
    assert!(worst <= tolerance, "off by {worst:e}\n{a:?}\n{b:?}");
}

/// Temporary folder with files, deleted at the end of the test.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn of(name: &str, files: &[(&str, &str)]) -> Self {
        let folder = std::env::temp_dir().join(format!("polhode-robot-{name}-{}", std::process::id()));
        for (file, text) in files {
            let path = folder.join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
        Self(std::fs::canonicalize(folder).unwrap())
    }

    pub(crate) fn path(&self, file: &str) -> PathBuf {
        self.0.join(file)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
