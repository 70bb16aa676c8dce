//! Rows of a least-squares problem, and their reduction to a triangle.

use nalgebra::{DMatrix, DVector};

use crate::decomposition::qr;
use crate::error::IdentifyError;

/// Rows of one group, in standard deviations: derivatives of the prediction by local and by shared
/// parameters, and the residual (measured − predicted).
#[derive(Clone, Debug)]
pub(crate) struct Rows {
    local: usize,
    shared: usize,
    elements: Vec<f64>,
    /// First row of each measurement. One measurement is one instrument at one time; it is kept or
    /// left out as a whole.
    begins: Vec<usize>,
}

impl Rows {
    pub(crate) const fn new(local: usize, shared: usize) -> Self {
        Self { local, shared, elements: Vec::new(), begins: Vec::new() }
    }

    const fn width(&self) -> usize {
        self.local + self.shared + 1
    }

    /// Returns the number of rows.
    pub(crate) fn count(&self) -> usize {
        self.elements.len() / self.width()
    }

    /// Starts a new measurement with the next row.
    pub(crate) fn begin_measurement(&mut self) {
        self.begins.push(self.count());
    }

    /// Adds a row of zeros with a residual. Returns its derivatives by local and by shared
    /// parameters, to be filled in.
    pub(crate) fn push(&mut self, residual: f64) -> (&mut [f64], &mut [f64]) {
        let start = self.elements.len();
        self.elements.resize(start + self.width(), 0.0);
        let row = &mut self.elements[start..];
        let (derivatives, last) = row.split_at_mut(self.local + self.shared);
        last[0] = residual;
        derivatives.split_at_mut(self.local)
    }

    /// Returns the derivatives of the last row; empty before the first.
    pub(crate) fn last(&mut self) -> (&mut [f64], &mut [f64]) {
        let end = self.elements.len().saturating_sub(1);
        let start = (end + 1).saturating_sub(self.width());
        self.elements[start..end].split_at_mut(self.local.min(end - start))
    }

    /// Returns the norm of each column of derivatives by a shared parameter.
    pub(crate) fn shared_norms(&self) -> Vec<f64> {
        let mut squares = vec![0.0; self.shared];
        for row in self.elements.chunks_exact(self.width()) {
            squares.iter_mut().zip(&row[self.local..]).for_each(|(sum, by)| *sum += by * by);
        }
        squares.into_iter().map(f64::sqrt).collect()
    }

    /// Sets the derivatives by a shared parameter to zero.
    pub(crate) fn clear_shared(&mut self, number: usize) {
        let (width, column) = (self.width(), self.local + number);
        self.elements.chunks_exact_mut(width).for_each(|row| row[column] = 0.0);
    }

    /// Returns the residuals of each measurement.
    pub(crate) fn measurements(&self) -> impl Iterator<Item = Vec<f64>> + '_ {
        let ends = self.begins.iter().skip(1).copied().chain([self.count()]);
        self.begins.iter().zip(ends).map(|(&from, to)| (from..to).map(|row| self.residual(row)).collect())
    }

    /// Returns the numbers of local and of shared parameters.
    pub(super) const fn sizes(&self) -> (usize, usize) {
        (self.local, self.shared)
    }

    /// Returns the rows with other residuals.
    pub(super) fn with_residuals(&self, residuals: &[f64]) -> Self {
        let mut other = self.clone();
        other.elements.chunks_exact_mut(self.width()).zip(residuals).for_each(|(row, residual)| {
            row[self.local + self.shared] = *residual;
        });
        other
    }

    fn residual(&self, row: usize) -> f64 {
        self.elements[(row + 1) * self.width() - 1]
    }

    /// Returns JᵀJ by the shared parameters for second differences (x₀ − 2 x₁ + x₂)/√6 of
    /// successive measurements with positive weight.
    pub(crate) fn information_of_differences(&self, weights: &[f64]) -> DMatrix<f64> {
        let width = self.width();
        let counted: Vec<&[f64]> = (0..self.begins.len())
            .filter(|&k| weights.get(k).is_none_or(|w| *w > 0.0))
            .map(|k| {
                let end = self.begins.get(k + 1).copied().unwrap_or_else(|| self.count());
                &self.elements[self.begins[k] * width..end * width]
            })
            .collect();
        let mut sum = DMatrix::zeros(self.shared, self.shared);
        for three in counted.windows(3) {
            for first in (0..three[0].len()).step_by(width) {
                let at = |k: usize, i: usize| three[k][first + self.local + i];
                let d = DVector::from_fn(self.shared, |i, _| at(0, i) - 2.0 * at(1, i) + at(2, i));
                sum.ger(1.0 / 6.0, &d, &d, 1.0);
            }
        }
        sum
    }

    /// Returns the derivatives by the shared parameters after elimination of the local ones.
    pub(crate) fn without_own(&self) -> Result<DMatrix<f64>, IdentifyError> {
        let triangle = self.triangle(&[])?;
        let rows = triangle.nrows().saturating_sub(self.local);
        Ok(triangle.view((triangle.nrows() - rows, self.local), (rows, self.shared)).into_owned())
    }

    /// Reduces the rows to an upper triangle with the same normal equations. Each measurement is
    /// multiplied by the square root of its weight. Columns: local parameters, shared parameters,
    /// residual.
    pub(crate) fn triangle(&self, weights: &[f64]) -> Result<DMatrix<f64>, IdentifyError> {
        let width = self.width();
        let mut triangle = DMatrix::zeros(0, width);
        let mut measurement = 0;
        let mut block: Vec<f64> = Vec::with_capacity(BLOCK * width);
        for (row, elements) in self.elements.chunks_exact(width).enumerate() {
            while self.begins.get(measurement + 1).is_some_and(|&begin| begin <= row) {
                measurement += 1;
            }
            let root = weights.get(measurement).copied().unwrap_or(1.0).sqrt();
            block.extend(elements.iter().map(|x| x * root));
            if block.len() >= BLOCK * width {
                triangle = stacked(&triangle, &DMatrix::from_row_slice(block.len() / width, width, &block))?;
                block.clear();
            }
        }
        stacked(&triangle, &DMatrix::from_row_slice(block.len() / width, width, &block))
    }
}

/// Number of rows that are reduced in one QR decomposition.
const BLOCK: usize = 128;

/// Returns the triangle of two stacked sets of rows.
pub(crate) fn stacked(above: &DMatrix<f64>, below: &DMatrix<f64>) -> Result<DMatrix<f64>, IdentifyError> {
    let width = below.ncols();
    let mut rows = DMatrix::zeros(above.nrows() + below.nrows(), width);
    rows.rows_mut(0, above.nrows()).copy_from(above);
    rows.rows_mut(above.nrows(), below.nrows()).copy_from(below);
    if rows.nrows() == 0 {
        return Ok(rows);
    }
    Ok(qr("a residual or derivative of the measurements", rows)?.r())
}
