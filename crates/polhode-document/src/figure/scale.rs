//! Grouping of curves on common vertical axes, so that no curve is squashed by the range of
//! another.

/// Smallest spread of a curve relative to the common range; below it the curve is squashed.
const SQUASHED: f64 = 1.0 / 20.0;

/// Groups curves, given their least and greatest values, into at most `most` groups with a common
/// axis. Returns curve numbers. Groups are merged if no curve is squashed; they are ordered by
/// their first curve.
pub fn groups(ranges: &[[f64; 2]], most: usize) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = (0..ranges.len()).map(|k| vec![k]).collect();
    loop {
        let mut best: Option<(f64, usize, usize)> = None;
        for j in 1..groups.len() {
            for i in 0..j {
                let both = groups.get(i).into_iter().chain(groups.get(j)).flatten();
                let part = smallest_part(both.filter_map(|&k| ranges.get(k).copied()));
                if best.is_none_or(|(largest, ..)| part > largest) {
                    best = Some((part, i, j));
                }
            }
        }
        match best {
            Some((part, i, j)) if part >= SQUASHED || groups.len() > most.max(1) => {
                let second = groups.remove(j);
                if let Some(first) = groups.get_mut(i) {
                    first.extend(second);
                    first.sort_unstable();
                }
            }
            _ => return groups,
        }
    }
}

/// Returns the smallest spread of a curve relative to the common range.
fn smallest_part(ranges: impl Iterator<Item = [f64; 2]> + Clone) -> f64 {
    let [least, greatest] = ranges
        .clone()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], [a, b]| [least.min(a), most.max(b)]);
    let smallest = ranges.map(|[a, b]| b - a).fold(f64::INFINITY, f64::min);
    smallest / (greatest - least)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_of_one_size_share_an_axis() {
        assert_eq!(groups(&[[-6.1, 5.9], [-5.8, 6.0], [-4.3, 0.2]], 3), [vec![0, 1, 2]]);
        assert_eq!(groups(&[], 3), Vec::<Vec<usize>>::new());
        assert_eq!(groups(&[[0.3, 0.9]], 3), [vec![0]]);
    }

    #[test]
    fn what_would_be_squashed_has_an_axis_of_its_own() {
        // The spread is just below and just above 1/20 of the common range.
        assert_eq!(groups(&[[0.0, 20.0], [3.0, 3.97]], 3), [vec![0], vec![1]]);
        assert_eq!(groups(&[[0.0, 20.0], [3.0, 4.03]], 3), [vec![0, 1]]);
        // Small spreads, far apart.
        assert_eq!(groups(&[[3.61, 3.66], [0.07, 0.11]], 3), [vec![0], vec![1]]);
        // Groups are ordered by their first curve.
        assert_eq!(groups(&[[-0.2, 0.3], [0.0, 90.0], [-0.3, 0.1]], 3), [vec![0, 2], vec![1]]);
    }

    #[test]
    fn there_are_no_more_groups_than_asked_for() {
        let ranges = [[0.0, 1.0], [0.0, 1e2], [0.0, 1e4], [0.0, 1e6]];
        let three = groups(&ranges, 3);
        assert_eq!(three.len(), 3);
        assert_eq!(three.concat().len(), 4);
        assert_eq!(groups(&ranges, 1), [vec![0, 1, 2, 3]]);
    }
}
