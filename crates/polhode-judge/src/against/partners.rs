//! Rows of two logs at the same times.

/// Largest difference of equal times, as a fraction of the smallest spacing of rows. Times in
/// single precision satisfy it.
const EQUAL: f64 = 1e-3;

/// Rows of another log at the times of a run.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Partners {
    /// Row of the other log, for each row of the run.
    pub(super) rows: Vec<usize>,
    /// Largest difference of two times, including the rounding of times to f64, s.
    pub(super) apart: f64,
}

impl Partners {
    /// Finds the rows at the times of a run, both s and ascending.
    ///
    /// # Errors
    /// The first time without a row of the other log.
    pub(super) fn of(times: &[f64], other: &[f64]) -> Result<Self, f64> {
        let most = EQUAL * smallest_spacing(times).min(smallest_spacing(other));
        let mut found = Self { rows: Vec::with_capacity(times.len()), apart: 0.0 };
        for &time in times {
            let next = other.partition_point(|&one| one < time);
            let apart = |row: &usize| other.get(*row).map_or(f64::INFINITY, |one| (one - time).abs());
            let nearest =
                [next, next.saturating_sub(1)].into_iter().min_by(|a, b| apart(a).total_cmp(&apart(b)));
            let Some(row) = nearest.filter(|row| apart(row) <= most) else { return Err(time) };
            found.apart = found.apart.max(apart(&row) + time.abs() * f64::EPSILON);
            found.rows.push(row);
        }
        Ok(found)
    }
}

fn smallest_spacing(times: &[f64]) -> f64 {
    times.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min)
}
