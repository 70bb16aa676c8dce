//! The tree that rows are in.

use std::collections::HashMap;

use crate::error::{BudgetError, RowName};
use crate::row::Row;

/// In which row each row stands.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tree {
    /// `None` of the root.
    pub(crate) parents: Vec<Option<usize>>,
    /// All rows, each after that in which it stands: the root first.
    pub(crate) order: Vec<usize>,
}

pub(crate) fn row_name(rows: &[Row], row: usize) -> RowName {
    RowName { row, name: rows[row].name.clone() }
}

/// The rows by their names.
pub(crate) fn names(rows: &[Row]) -> Result<HashMap<&str, usize>, BudgetError> {
    let mut names = HashMap::with_capacity(rows.len());
    for (k, row) in rows.iter().enumerate() {
        if row.name.trim().is_empty() {
            return Err(BudgetError::Nameless { row: k });
        }
        if let Some(first) = names.insert(row.name.as_str(), k) {
            return Err(BudgetError::Duplicate { first: row_name(rows, first), row: k });
        }
    }
    Ok(names)
}

impl Tree {
    pub(crate) fn new(rows: &[Row], names: &HashMap<&str, usize>) -> Result<Self, BudgetError> {
        let mut parents = Vec::with_capacity(rows.len());
        let mut root = None;
        for (k, row) in rows.iter().enumerate() {
            let parent = match row.frame_of() {
                None => None,
                Some(frame) => Some(*names.get(frame).ok_or_else(|| BudgetError::MissingFrame {
                    row: row_name(rows, k),
                    frame: frame.to_owned(),
                })?),
            };
            if parent.is_none()
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
            rows: cycle.iter().map(|&k| row_name(rows, k)).collect(),
        })?;
        Ok(Self { parents, order })
    }
}

/// All rows, each after its parent; or rows that stand in each other.
fn order(parents: &[Option<usize>]) -> Result<Vec<usize>, Vec<usize>> {
    let mut placed = vec![false; parents.len()];
    // On the way up from the row of this number: a way that meets itself is a cycle.
    let mut seen = vec![usize::MAX; parents.len()];
    let mut order = Vec::with_capacity(parents.len());
    for start in 0..parents.len() {
        let mut way = Vec::new();
        let mut at = Some(start);
        while let Some(row) = at.filter(|&row| !placed[row]) {
            if seen[row] == start {
                return Err(way.into_iter().skip_while(|&other| other != row).collect());
            }
            seen[row] = start;
            way.push(row);
            at = parents[row];
        }
        for row in way.into_iter().rev() {
            placed[row] = true;
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
        let parents = [Some(3), Some(0), Some(0), Some(5), Some(1), None];
        let found = order(&parents);
        assert_eq!(found, Ok(vec![5, 3, 0, 1, 2, 4]));
    }

    #[test]
    fn a_cycle_is_found_without_what_leads_to_it() {
        assert_eq!(order(&[Some(1), Some(2), Some(3), Some(1), None]), Err(vec![1, 2, 3]));
        assert_eq!(order(&[None, Some(1)]), Err(vec![1]));
    }
}
