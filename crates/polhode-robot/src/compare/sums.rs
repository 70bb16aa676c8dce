//! Sums of the mass properties of groups, and of the groups with everything below them, in the
//! frames of the second model's groups.

use super::frames::{Aligned, Alignment};
use super::mass::Mass;
use super::pairs::Pair;
use super::robot::{Member, Robot};
use crate::model::Pose;

/// Sums of both models.
pub(super) type Both = [Option<Mass>; 2];

/// Returns true if both sums exist and agree.
pub(super) fn agree(both: &Both, tolerance: f64) -> bool {
    match both {
        [Some(a), Some(b)] => a.agrees(b, tolerance) == [true; 3],
        _ => false,
    }
}

/// Returns the sum of a pair's groups.
pub(super) fn own(pair: &Pair, alignment: &Alignment, a: &Robot<'_>, b: &Robot<'_>) -> Both {
    [(a, pair.a, &alignment.pose), (b, pair.b, &Pose::IDENTITY)].map(|(robot, group, pose)| {
        let members = robot.groups.get(group).into_iter().flat_map(|group| &group.members);
        let masses: Vec<Mass> = members.filter_map(Member::in_group).map(|mass| mass.placed(pose)).collect();
        Mass::sum(&masses)
    })
}

/// Returns for each pair the sum of its groups and of all groups below them; `None` if a group
/// below has no partner.
pub(super) fn subtrees(aligned: &Aligned<'_, '_>, alignments: &[Alignment]) -> Vec<Option<Both>> {
    let Aligned { a, b, pairs, .. } = aligned;
    let below = pairs.below(a, b);
    let children = |robot: &Robot<'_>| {
        let mut counts = vec![0_usize; robot.groups.len()];
        for parent in robot.groups.iter().filter_map(|group| group.parent) {
            counts.get_mut(parent).into_iter().for_each(|count| *count += 1);
        }
        counts
    };
    let (of_a, of_b) = (children(a), children(b));
    let mut sums: Vec<Option<Both>> = vec![None; pairs.list.len()];
    for (k, (pair, alignment)) in pairs.list.iter().zip(alignments).enumerate().rev() {
        let below = below.get(k).map_or(&[][..], Vec::as_slice);
        let has_all = |counts: &[usize], group: usize| counts.get(group) == Some(&below.len());
        if !(pair.is_whole && has_all(&of_a, pair.a) && has_all(&of_b, pair.b)) {
            continue;
        }
        let mut parts: [Vec<Mass>; 2] = own(pair, alignment, a, b).map(|mass| mass.into_iter().collect());
        let mut is_complete = true;
        for &child in below {
            let (Some(Some(sum)), Some(place)) = (sums.get(child), in_parent(aligned, alignments, child))
            else {
                is_complete = false;
                continue;
            };
            for (parts, mass) in parts.iter_mut().zip(sum) {
                parts.extend(mass.map(|mass| mass.placed(&place)));
            }
        }
        if let Some(slot) = sums.get_mut(k).filter(|_| is_complete) {
            *slot = Some(parts.map(|parts| Mass::sum(&parts)));
        }
    }
    sums
}

/// Returns the pose of a pair's second group in its parent at the zero of the first model's joint.
fn in_parent(aligned: &Aligned<'_, '_>, alignments: &[Alignment], pair: usize) -> Option<Pose> {
    let (pair, alignment) = (aligned.pairs.list.get(pair)?, alignments.get(pair)?);
    let rest = &aligned.b.groups.get(pair.b)?.pose;
    Some(match aligned.b.axis(pair.b) {
        Some(axis) => rest.then(&axis.motion(alignment.zero)),
        None => rest.clone(),
    })
}
