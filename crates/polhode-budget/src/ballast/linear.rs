//! Small systems of linear equations.

pub(super) fn inner(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// x of A x = b, A symmetric and not negative; zero where rows depend on those before.
pub(super) fn solved(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    let diagonal: Vec<f64> = (0..n).map(|k| a[k][k]).collect();
    let mut order = Vec::with_capacity(n);
    let mut left: Vec<usize> = (0..n).collect();
    loop {
        let relative = |k: &usize| if diagonal[*k] > 0.0 { a[*k][*k] / diagonal[*k] } else { 0.0 };
        let Some(place) = (0..left.len()).max_by(|i, j| relative(&left[*i]).total_cmp(&relative(&left[*j])))
        else {
            break;
        };
        if relative(&left[place]) < 1e-12 {
            break;
        }
        let pivot = left.swap_remove(place);
        order.push(pivot);
        let row = a[pivot].clone();
        for &k in &left {
            let factor = a[k][pivot] / row[pivot];
            a[k].iter_mut().zip(&row).for_each(|(x, y)| *x -= factor * y);
            b[k] -= factor * b[pivot];
        }
    }
    let mut x = vec![0.0; n];
    for &k in order.iter().rev() {
        let known: f64 = order.iter().filter(|j| **j != k).map(|&j| a[k][j] * x[j]).sum();
        x[k] = (b[k] - known) / a[k][k];
    }
    x
}

/// z with Σ z of columns zero and some z positive, if there are more columns than their rank.
pub(super) fn null_vector(columns: &[Vec<f64>]) -> Option<Vec<f64>> {
    let rows = columns.first()?.len();
    // One column more than rows depends on the others; fewer may.
    let count = columns.len().min(rows + 1);
    let mut a: Vec<Vec<f64>> =
        (0..rows).map(|i| columns[..count].iter().map(|column| column[i]).collect()).collect();
    for row in &mut a {
        let most = row.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        if most > 0.0 {
            row.iter_mut().for_each(|x| *x /= most);
        }
    }
    let (mut pivots, mut next) = (Vec::new(), 0);
    for column in 0..count {
        let best = (next..rows).max_by(|i, j| a[*i][column].abs().total_cmp(&a[*j][column].abs()));
        let Some(best) = best.filter(|best| a[*best][column].abs() > 1e-10) else {
            // This column depends on the pivots.
            let mut z = vec![0.0; columns.len()];
            z[column] = 1.0;
            for (row, pivot) in pivots.iter().enumerate() {
                z[*pivot] = -a[row][column];
            }
            return Some(z);
        };
        a.swap(next, best);
        let factor = 1.0 / a[next][column];
        a[next].iter_mut().for_each(|x| *x *= factor);
        let row = a[next].clone();
        for (i, other) in a.iter_mut().enumerate() {
            if i != next {
                let factor = other[column];
                other.iter_mut().zip(&row).for_each(|(x, y)| *x -= factor * y);
            }
        }
        pivots.push(column);
        next += 1;
    }
    None
}
