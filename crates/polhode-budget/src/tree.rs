//! Tree of the rows of a list.

use std::collections::HashMap;

use crate::error::{BudgetError, RowName};
use crate::rows::Rows;

/// Parents of rows, and an order of the rows.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tree {
    /// Index of each row's parent; [`NONE`] for the root.
    parents: Vec<u32>,
    /// All rows, each after its parent, with the root first.
    order: Vec<u32>,
    /// Slots of rows with children: numbers from 0 in the order of the tree; [`NONE`] for all other
    /// rows.
    slots: Vec<u32>,
    /// Number of rows with children.
    pub(crate) inner: usize,
}

/// Marker for no row. 2³² rows would take 128 GiB.
const NONE: u32 = u32::MAX;

pub(crate) fn row_name(rows: &Rows, row: usize) -> RowName {
    RowName { row, name: rows.name(row).to_owned() }
}

/// Returns the indices of rows by their names.
pub(crate) fn names(rows: &Rows) -> Result<HashMap<&str, u32>, BudgetError> {
    let mut names = HashMap::with_capacity(rows.len());
    for k in 0..rows.len() {
        let name = rows.name(k);
        if name.trim().is_empty() {
            return Err(BudgetError::Nameless { row: k });
        }
        let number = u32::try_from(k).ok().filter(|number| *number != NONE);
        let number = number.ok_or(BudgetError::Rows { most: NONE })?;
        if let Some(first) = names.insert(name, number) {
            return Err(BudgetError::Duplicate { first: row_name(rows, first as usize), row: k });
        }
    }
    Ok(names)
}

impl Tree {
    pub(crate) fn new(rows: &Rows, names: &HashMap<&str, u32>) -> Result<Self, BudgetError> {
        let mut parents = Vec::with_capacity(rows.len());
        let mut root = None;
        for k in 0..rows.len() {
            let parent = match rows.frame_of(k) {
                None => NONE,
                Some(frame) => *names.get(frame).ok_or_else(|| BudgetError::MissingFrame {
                    row: row_name(rows, k),
                    frame: frame.to_owned(),
                })?,
            };
            if parent == NONE
                && let Some(first) = root.replace(k)
            {
                return Err(BudgetError::TwoRoots {
                    first: row_name(rows, first),
                    second: row_name(rows, k),
                });
            }
            parents.push(parent);
        }
        let order = order(&parents).map_err(|cycle| BudgetError::Cycle {
            rows: cycle.iter().map(|&k| row_name(rows, k as usize)).collect(),
        })?;
        let mut slots = vec![NONE; parents.len()];
        for parent in parents.iter().filter(|parent| **parent != NONE) {
            slots[*parent as usize] = 0;
        }
        let mut inner = 0;
        for &k in &order {
            if slots[k as usize] != NONE {
                slots[k as usize] = inner;
                inner += 1;
            }
        }
        Ok(Self { parents, order, slots, inner: inner as usize })
    }

    /// Returns the index of the root.
    pub(crate) fn root(&self) -> usize {
        self.order.first().map_or(0, |root| *root as usize)
    }

    /// Returns the index of a row's parent, or `None` for the root.
    pub(crate) fn parent(&self, row: usize) -> Option<usize> {
        self.parents.get(row).filter(|parent| **parent != NONE).map(|parent| *parent as usize)
    }

    /// Returns the slot of a row, or `None` if it has no children.
    pub(crate) fn slot(&self, row: usize) -> Option<usize> {
        self.slots.get(row).filter(|slot| **slot != NONE).map(|slot| *slot as usize)
    }

    /// Iterates over all rows, each after its parent.
    pub(crate) fn order(&self) -> impl DoubleEndedIterator<Item = usize> + '_ {
        self.order.iter().map(|row| *row as usize)
    }
}

/// Returns all rows, each after its parent. The error is a cycle of rows.
fn order(parents: &[u32]) -> Result<Vec<u32>, Vec<u32>> {
    let mut placed = vec![false; parents.len()];
    // Row from which the path to the root last visited each row. A path that meets itself is a
    // cycle.
    let mut seen = vec![NONE; parents.len()];
    let mut order = Vec::with_capacity(parents.len());
    let mut way = Vec::new();
    for start in 0..parents.len() as u32 {
        let mut at = start;
        while at != NONE && !placed[at as usize] {
            if seen[at as usize] == start {
                return Err(way.into_iter().skip_while(|&other| other != at).collect());
            }
            seen[at as usize] = start;
            way.push(at);
            at = parents[at as usize];
        }
        for row in way.drain(..).rev() {
            placed[row as usize] = true;
            order.push(row);
        }
    }
    Ok(order)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_comes_after_its_parent() {
        let parents = [3, 0, 0, 5, 1, NONE];
        let found = order(&parents);
        assert_eq!(found, Ok(vec![5, 3, 0, 1, 2, 4]));
    }

    #[test]
    fn a_cycle_is_found_without_what_leads_to_it() {
        assert_eq!(order(&[1, 2, 3, 1, NONE]), Err(vec![1, 2, 3]));
        assert_eq!(order(&[NONE, 1]), Err(vec![1]));
    }
}
