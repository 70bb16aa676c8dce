//! Correspondence of the groups of two models.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::names::{Names, joints, links};
use super::robot::{Member, Robot};

/// Corresponding groups of two models.
#[derive(Debug)]
pub(super) struct Pairs {
    /// Pairs in the order of the first model's groups: parents before children.
    pub(super) list: Vec<Pair>,
    /// Number of each pair by its groups.
    numbers: BTreeMap<(usize, usize), usize>,
    /// Joint of the second model with the name of each joint of the first.
    joints: Vec<Option<usize>>,
}

/// Group of the first model and group of the second that share a link, or the joint above, or the
/// group above or below.
#[derive(Debug)]
pub(super) struct Pair {
    pub(super) a: usize,
    pub(super) b: usize,
    /// Links in both groups: index of the member in each group.
    pub(super) shared: Vec<(usize, usize)>,
    /// True if neither group corresponds to a second one.
    pub(super) is_whole: bool,
}

impl Pairs {
    pub(super) fn of(a: &Robot<'_>, b: &Robot<'_>, names: &Names) -> Self {
        let mut found: BTreeMap<(usize, usize), Vec<(usize, usize)>> = BTreeMap::new();
        let mut places: HashMap<usize, (usize, usize)> = HashMap::new();
        for (k, group) in b.groups.iter().enumerate() {
            places.extend(group.members.iter().enumerate().map(|(m, member)| (member.link, (k, m))));
        }
        let partners = names.links.partners(&links(a.model), &links(b.model));
        for (k, group) in a.groups.iter().enumerate() {
            for (m, member) in group.members.iter().enumerate() {
                let other = partners.get(member.link).copied().flatten().and_then(|link| places.get(&link));
                if let Some(&(other, n)) = other {
                    found.entry((k, other)).or_default().push((m, n));
                }
            }
        }
        let mut open = Open::of(a, b, &found);
        // Groups whose links were merged away are found by the joint above them.
        let namesakes = names.joints.partners(&joints(a.model), &joints(b.model));
        let above: HashMap<usize, usize> =
            b.groups.iter().enumerate().filter_map(|(k, group)| Some((group.joint?, k))).collect();
        for (k, group) in a.groups.iter().enumerate() {
            let joint = group.joint.and_then(|joint| namesakes.get(joint).copied().flatten());
            if let Some(&other) = joint.and_then(|joint| above.get(&joint))
                && open.take(k, other)
            {
                found.insert((k, other), Vec::new());
            }
        }
        let mut waiting: Vec<(usize, usize)> = found.keys().copied().collect();
        while let Some((k, other)) = waiting.pop() {
            let parents = a
                .groups
                .get(k)
                .and_then(|own| own.parent)
                .zip(b.groups.get(other).and_then(|own| own.parent));
            if let Some((k, other)) = parents
                && open.take(k, other)
            {
                found.insert((k, other), Vec::new());
                waiting.push((k, other));
            }
        }
        Self::listed(found, namesakes)
    }

    fn listed(found: BTreeMap<(usize, usize), Vec<(usize, usize)>>, joints: Vec<Option<usize>>) -> Self {
        let (mut of_a, mut of_b): (BTreeMap<usize, usize>, BTreeMap<usize, usize>) = Default::default();
        for &(a, b) in found.keys() {
            *of_a.entry(a).or_default() += 1;
            *of_b.entry(b).or_default() += 1;
        }
        let numbers = found.keys().enumerate().map(|(k, &pair)| (pair, k)).collect();
        let is_one = |counts: &BTreeMap<usize, usize>, k: usize| counts.get(&k) == Some(&1);
        let pair = |((a, b), shared)| Pair { a, b, shared, is_whole: is_one(&of_a, a) && is_one(&of_b, b) };
        Self { list: found.into_iter().map(pair).collect(), numbers, joints }
    }

    /// Returns the number of a pair.
    pub(super) fn number(&self, a: usize, b: usize) -> Option<usize> {
        self.numbers.get(&(a, b)).copied()
    }

    /// Returns the joint of the second model with the name of a joint of the first.
    pub(super) fn namesake(&self, joint: usize) -> Option<usize> {
        self.joints.get(joint).copied().flatten()
    }

    /// Returns true if a joint of the second model has the name of one of the first.
    pub(super) fn is_namesake(&self, joint: usize) -> bool {
        self.joints.contains(&Some(joint))
    }

    /// Returns the groups of the second model that correspond to a group of the first.
    pub(super) fn of_a(&self, a: usize) -> impl Iterator<Item = usize> {
        self.numbers.range((a, 0)..=(a, usize::MAX)).map(|(&(_, b), _)| b)
    }

    /// Returns the groups of the first model that correspond to each group of the second.
    pub(super) fn of_b(&self) -> BTreeMap<usize, Vec<usize>> {
        let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        self.list.iter().for_each(|pair| groups.entry(pair.b).or_default().push(pair.a));
        groups
    }

    /// Returns for each pair the pairs below it: those whose joints hang at both of its groups.
    pub(super) fn below(&self, a: &Robot<'_>, b: &Robot<'_>) -> Vec<Vec<usize>> {
        let mut below = vec![Vec::new(); self.list.len()];
        for (k, pair) in self.list.iter().enumerate() {
            if let Some(slot) = self.above(pair, a, b).and_then(|above| below.get_mut(above)) {
                slot.push(k);
            }
        }
        below
    }

    /// Returns the pair of the groups above a pair.
    pub(super) fn above(&self, pair: &Pair, a: &Robot<'_>, b: &Robot<'_>) -> Option<usize> {
        self.number(a.groups.get(pair.a)?.parent?, b.groups.get(pair.b)?.parent?)
    }
}

/// Groups without a pair.
struct Open {
    a: BTreeSet<usize>,
    b: BTreeSet<usize>,
}

impl Open {
    fn of(a: &Robot<'_>, b: &Robot<'_>, found: &BTreeMap<(usize, usize), Vec<(usize, usize)>>) -> Self {
        let mut open = Self { a: (0..a.groups.len()).collect(), b: (0..b.groups.len()).collect() };
        for (a, b) in found.keys() {
            open.a.remove(a);
            open.b.remove(b);
        }
        open
    }

    /// Takes two groups; returns false if one of them has a pair already.
    fn take(&mut self, a: usize, b: usize) -> bool {
        self.a.contains(&a) && self.b.contains(&b) && self.a.remove(&a) && self.b.remove(&b)
    }
}

impl Pair {
    /// Returns the shared links as members of both groups.
    pub(super) fn members<'r>(
        &self,
        a: &'r Robot<'_>,
        b: &'r Robot<'_>,
    ) -> impl Iterator<Item = (&'r Member, &'r Member)> {
        let (a, b) = (a.groups.get(self.a), b.groups.get(self.b));
        let member = move |&(m, n): &(usize, usize)| Some((a?.members.get(m)?, b?.members.get(n)?));
        self.shared.iter().filter_map(member)
    }

    /// Returns true if the same links have mass in both groups. A link alone in its group counts even
    /// if one side has no mass.
    pub(super) fn has_same_masses(&self, a: &Robot<'_>, b: &Robot<'_>) -> bool {
        let count = |robot: &Robot<'_>, group: usize| {
            let members = robot.groups.get(group).into_iter().flat_map(|group| &group.members);
            members.filter(|member| member.mass.is_some()).count()
        };
        let both = self.members(a, b).filter(|(a, b)| a.mass.is_some() && b.mass.is_some()).count();
        let either = self.members(a, b).filter(|(a, b)| a.mass.is_some() || b.mass.is_some()).count();
        let (of_a, of_b) = (count(a, self.a), count(b, self.b));
        both == of_a && both == of_b || self.shared.len() == 1 && either == 1 && of_a + of_b == 1
    }
}
