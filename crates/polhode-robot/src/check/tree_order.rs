//! Topological order of links.
//!
//! Kahn's algorithm (Comm. ACM 5 (1962) 558) takes a link when all its parents are taken. Each
//! remaining link has a remaining parent, so following parents must end in a cycle.

/// Returns the links in an order with parents first, and the cycles that cannot be ordered.
pub(super) fn sorted(
    holders: &[Vec<(usize, Option<usize>)>],
    hanging: &[Vec<(usize, bool)>],
) -> (Vec<usize>, Vec<Vec<usize>>) {
    let mut open: Vec<usize> =
        holders.iter().map(|h| h.iter().filter(|(_, p)| p.is_some()).count()).collect();
    let mut order: Vec<usize> = (0..open.len()).filter(|k| open[*k] == 0).collect();
    let mut next = 0;
    while let Some(&k) = order.get(next) {
        next += 1;
        for &(child, _) in &hanging[k] {
            open[child] -= 1;
            if open[child] == 0 {
                order.push(child);
            }
        }
    }
    // Each remaining link has a remaining parent. `walk` stores the walk that visited a link.
    let mut cycles = Vec::new();
    let mut walk = vec![0; open.len()];
    for start in 0..open.len() {
        if open[start] == 0 || walk[start] != 0 {
            continue;
        }
        let mut chain = Vec::new();
        let mut at = start;
        while walk[at] == 0 {
            walk[at] = start + 1;
            chain.push(at);
            let Some(up) = holders[at].iter().filter_map(|(_, p)| *p).find(|p| open[*p] > 0) else { break };
            at = up;
        }
        if walk[at] == start + 1
            && let Some(begin) = chain.iter().position(|k| *k == at)
        {
            let mut cycle = chain.split_off(begin);
            cycle.reverse();
            cycles.push(cycle);
        }
    }
    (order, cycles)
}
