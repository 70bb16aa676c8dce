//! Spearman's rank correlation between inputs and outcomes.

use crate::report::SweepSample;

/// Maximum number of pairs, and of pairs with the same input.
const MOST: usize = 12;
const MOST_OF_ONE: usize = 4;
/// Threshold above which an outcome is a monotonic function of one input, which its definition
/// states already.
const FUNCTION: f64 = 1.0 - 1e-12;
/// Minimum number of rows.
const LEAST_ROWS: usize = 10;

/// Returns the pairs of an input and an outcome with the strongest correlations, strongest first.
pub(super) fn strongest(
    sample: &SweepSample,
    inputs: &[String],
    apart: &[&str],
) -> Vec<(String, String, f64)> {
    let column = |name: &String| {
        let k = sample.names.iter().position(|other| other == name)?;
        sample.columns.get(k)
    };
    let starts: Vec<_> =
        sample.names.iter().filter(|name| name.starts_with("start_")).filter_map(column).collect();
    let mut pairs = Vec::new();
    for input in inputs {
        let Some(x) = column(input) else { continue };
        for outcome in &sample.names {
            let is_outcome = !inputs.contains(outcome) && !apart.contains(&outcome.as_str());
            // Outcomes at the start are functions of the inputs by definition.
            let is_given =
                outcome.starts_with("start_") || starts.iter().any(|start| column(outcome) == Some(*start));
            let Some(y) = column(outcome).filter(|_| is_outcome && !is_given) else { continue };
            if let Some(value) = correlation(x, y).filter(|value| value.abs() < FUNCTION) {
                pairs.push((input.clone(), outcome.clone(), value));
            }
        }
    }
    pairs.sort_by(|a, b| b.2.abs().total_cmp(&a.2.abs()));
    let mut kept: Vec<(String, String, f64)> = Vec::new();
    for pair in pairs {
        let of_one: Vec<_> = kept.iter().filter(|(input, ..)| *input == pair.0).collect();
        // Identical outcomes are listed once.
        let is_new = !of_one.iter().any(|(.., value)| *value == pair.2);
        if kept.len() < MOST && of_one.len() < MOST_OF_ONE && is_new {
            kept.push(pair);
        }
    }
    kept
}

/// Returns the rank correlation over rows with both values; `None` for too few rows, or if one does
/// not vary.
fn correlation(x: &[Option<f64>], y: &[Option<f64>]) -> Option<f64> {
    let both: Vec<(f64, f64)> = x.iter().zip(y).filter_map(|(x, y)| x.zip(*y)).collect();
    if both.len() < LEAST_ROWS {
        return None;
    }
    let a = ranks(&both.iter().map(|(x, _)| *x).collect::<Vec<_>>());
    let b = ranks(&both.iter().map(|(_, y)| *y).collect::<Vec<_>>());
    let middle = 0.5 * (both.len() - 1) as f64;
    let sum = |p: &[f64], q: &[f64]| p.iter().zip(q).map(|(p, q)| (p - middle) * (q - middle)).sum::<f64>();
    let (aa, bb) = (sum(&a, &a), sum(&b, &b));
    (aa > 0.0 && bb > 0.0).then(|| sum(&a, &b) / (aa.sqrt() * bb.sqrt()))
}

/// Returns the ranks from 0; equal values share their mean rank.
fn ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    let value = |k: usize| values.get(k).copied().unwrap_or_default();
    order.sort_by(|&a, &b| value(a).total_cmp(&value(b)));
    let mut ranks = vec![0.0; values.len()];
    let mut first = 0;
    for equal in order.chunk_by(|&a, &b| value(a) == value(b)) {
        let mean = first as f64 + 0.5 * (equal.len() - 1) as f64;
        for &k in equal {
            if let Some(rank) = ranks.get_mut(k) {
                *rank = mean;
            }
        }
        first += equal.len();
    }
    ranks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranks_correlate_as_the_definition_says() {
        assert_eq!(ranks(&[3.0, -1.0, 3.0, 7.0]), [1.5, 0.0, 1.5, 3.0]);
        let x: Vec<Option<f64>> = (0..40).map(|k| Some(f64::from(k * k % 41))).collect();
        let monotonic: Vec<Option<f64>> = x.iter().map(|x| x.map(|x| -x.powi(3))).collect();
        assert!((correlation(&x, &monotonic).unwrap_or_default() + 1.0).abs() < 1e-15);
        assert_eq!(correlation(&x, &vec![Some(2.0); 40]), None);
        assert_eq!(correlation(&x, &vec![None; 40]), None);
        // Without ties: 1 − 6 Σ d² / n (n² − 1).
        let a: Vec<Option<f64>> = (0..11).map(|k| Some(f64::from(k))).collect();
        let b: Vec<Option<f64>> = (0..11).map(|k| Some(f64::from(k * 7 % 11))).collect();
        let d2: f64 = (0..11).map(|k| f64::from(k - k * 7 % 11).powi(2)).sum();
        let expected = 1.0 - 6.0 * d2 / (11.0 * 120.0);
        assert!((correlation(&a, &b).unwrap_or_default() - expected).abs() < 1e-14);
    }
}
