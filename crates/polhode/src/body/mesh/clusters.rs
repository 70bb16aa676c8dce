//! Clusters of points connected by close pairs.

use super::close_pairs::distance;
use super::patches::{join, root};

/// Connected points, at least two, in ascending order of their indices.
pub(super) type Cluster = Vec<u32>;

/// Returns the clusters that the pairs form among `points` points, ordered by their lowest index.
pub(super) fn clusters(points: usize, pairs: impl IntoIterator<Item = [u32; 2]>) -> Vec<Cluster> {
    let mut parent: Vec<u32> = (0..points as u32).collect();
    pairs.into_iter().for_each(|[i, j]| join(&mut parent, i, j));
    // The root of a cluster is its lowest index.
    let roots: Vec<u32> = (0..points as u32).map(|i| root(&mut parent, i)).collect();
    let mut sizes = vec![0_u32; points];
    roots.iter().for_each(|&root| sizes[root as usize] += 1);
    let mut number = parent;
    let mut found: Vec<Cluster> = Vec::new();
    for (i, &root) in (0..).zip(&roots) {
        let size = sizes[root as usize] as usize;
        if size < 2 {
            continue;
        }
        if root == i {
            number[i as usize] = found.len() as u32;
            found.push(Vec::with_capacity(size));
        }
        found[number[root as usize] as usize].push(i);
    }
    found
}

/// Maximum number of points whose largest distance is found by comparing all pairs.
const MANY: usize = 4_096;

/// Returns the diameter of a cluster, and two of its points about that far apart. For more than
/// `MANY` points, the diagonal of the bounding box is returned instead of the diameter.
pub(super) fn across(points: &[[f64; 3]], cluster: &[u32]) -> (f64, [u32; 2]) {
    let at = |i: u32| points[i as usize];
    let farthest = |from: u32, all: &[u32]| {
        let distances = all.iter().map(|&i| (distance(at(from), at(i)), [from, i]));
        distances.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((0.0, [from; 2]))
    };
    let Some(&first) = cluster.first() else { return (0.0, [0; 2]) };
    if cluster.len() > MANY {
        let (_, [_, end]) = farthest(first, cluster);
        let (_, ends) = farthest(end, cluster);
        let bound = |k: usize, pick: fn(f64, f64) -> f64| cluster.iter().map(|&i| at(i)[k]).reduce(pick);
        let side = |k| bound(k, f64::max).unwrap_or(0.0) - bound(k, f64::min).unwrap_or(0.0);
        return (distance([side(0), side(1), side(2)], [0.0; 3]), ends);
    }
    let each = cluster.iter().enumerate().map(|(k, &i)| farthest(i, &cluster[k..]));
    each.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((0.0, [first; 2]))
}

/// Returns the mean of a cluster's points, independent of their numbering.
pub(super) fn mean(points: &[[f64; 3]], cluster: &[u32]) -> [f64; 3] {
    let mut all: Vec<[f64; 3]> = cluster.iter().map(|&i| points[i as usize]).collect();
    all.sort_unstable_by(|p, q| {
        p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])).then(p[2].total_cmp(&q[2]))
    });
    let from = all.first().copied().unwrap_or_default();
    let count = all.len().max(1) as f64;
    core::array::from_fn(|k| from[k] + all.iter().map(|p| p[k] - from[k]).sum::<f64>() / count)
}
