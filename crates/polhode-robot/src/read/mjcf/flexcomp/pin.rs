//! `<pin>`: the points that do not move.

use super::points::Form;
use super::{Flex, integers};

/// Whether each point is pinned.
pub(super) fn pinned(flex: &Flex<'_>, dim: usize, points: usize) -> Result<Vec<bool>, String> {
    let mut pinned = vec![flex.is_rigid; points];
    if flex.freedom == super::Freedom::Radial
        && let Some(center) = pinned.first_mut()
    {
        *center = true;
    }
    let out_of_range = || "a pin is out of range, and MuJoCo refuses the file".to_owned();
    let [_, y, z] = flex.count;
    let number = |at: &[usize]| match *at {
        [i, j] => Some(i * y + j),
        [i, j, k] => Some((i * y + j) * z + k),
        _ => None,
    };
    for pin in flex.element.named("pin") {
        let named = ["id", "range", "grid", "gridrange"];
        if let Some(name) = pin.attribute_names().find(|name| !named.contains(name)) {
            return Err(format!("{name}=… is no attribute of <pin>"));
        }
        let [ids, ranges, grid, boxes] = named.map(|name| integers(pin, name));
        let (ids, ranges, grid, boxes) = (ids?, ranges?, grid?, boxes?);
        let on_grid = !grid.is_empty() || !boxes.is_empty();
        if on_grid && (flex.form != Form::Grid || dim == 1) {
            return Err("grid pins are of grids alone, and MuJoCo refuses the file".to_owned());
        }
        let is_whole = ranges.len().is_multiple_of(2)
            && grid.len().is_multiple_of(dim)
            && boxes.len().is_multiple_of(2 * dim);
        if !is_whole {
            return Err("a pin has too few numbers, and MuJoCo refuses the file".to_owned());
        }
        let mut all: Vec<[usize; 2]> = ids.iter().map(|id| [*id, *id]).collect();
        all.extend(ranges.as_chunks::<2>().0);
        let counts = flex.count.get(..dim).unwrap_or_default();
        let fits = |at: &[usize]| at.iter().zip(counts).all(|(at, count)| at < count);
        for at in grid.chunks_exact(dim) {
            let id = number(at).filter(|_| fits(at)).ok_or_else(out_of_range)?;
            all.push([id, id]);
        }
        for corners in boxes.chunks_exact(2 * dim) {
            let (low, high) = corners.split_at(dim);
            if !fits(low) || !fits(high) {
                return Err(out_of_range());
            }
            let span = |axis: usize| {
                let first = low.get(axis).copied().unwrap_or(0);
                first..=high.get(axis).copied().unwrap_or(0)
            };
            for i in span(0) {
                for j in span(1) {
                    let ends = match (low.get(2), high.get(2)) {
                        (Some(&first), Some(&last)) if first <= last => {
                            number(&[i, j, first]).zip(number(&[i, j, last]))
                        }
                        (None, None) => number(&[i, j]).map(|id| (id, id)),
                        _ => None,
                    };
                    all.extend(ends.map(|(first, last)| [first, last]));
                }
            }
        }
        for [first, last] in all {
            if first >= points || last >= points {
                return Err(out_of_range());
            }
            for point in pinned.get_mut(first..=last).unwrap_or_default() {
                *point = true;
            }
        }
    }
    Ok(pinned)
}
