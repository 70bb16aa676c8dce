//! What became of each row.

use std::collections::{HashMap, HashSet};

use polhode::body::MassProperties;
use polhode::math::Part;

use super::change::{Change, What};
use super::errors;
use crate::report::case::Case;
use crate::{GivenTensor, Growth, Row};

/// Rounding of numbers in other units.
const ROUNDING: f64 = 1e-12;

/// In the order of the rows of the second, then what is no more.
pub(crate) fn changes([before, after]: [&Case; 2]) -> Vec<Change> {
    let (old, new) = (before.budget.rows(), after.budget.rows());
    let old_names: HashMap<&str, usize> = (0..old.len()).map(|k| (old.name(k), k)).collect();
    let new_names: HashSet<&str> = (0..new.len()).map(|k| new.name(k)).collect();
    let mut all = Vec::new();
    for k in 0..new.len() {
        let mut add = |what| all.push(Change { row: new.name(k).to_owned(), what });
        match old_names.get(new.name(k)) {
            None => add(What::Added(own(after, k))),
            Some(&other) => differences([before, after], [other, k]).into_iter().for_each(add),
        }
    }
    for k in (0..old.len()).filter(|k| !new_names.contains(old.name(*k))) {
        all.push(Change { row: old.name(k).to_owned(), what: What::Removed(own(before, k)) });
    }
    all
}

/// The mass of all copies of a row's own part.
fn own(case: &Case, row: usize) -> f64 {
    let copies = f64::from(case.budget.rows().quantity(row).count);
    case.budget.given(row).map_or(0.0, |part| copies * part.mass())
}

fn differences(cases: [&Case; 2], rows: [usize; 2]) -> Vec<What> {
    let [before, after] = [0, 1].map(|side| cases[side].budget.rows().get(rows[side]));
    let [before, after] = [&before, &after];
    let mut all = Vec::new();
    let parents = [0, 1].map(|side| {
        let budget = &cases[side].budget;
        budget.parent(rows[side]).map(|parent| budget.rows().name(parent).to_owned())
    });
    if parents[0] != parents[1] {
        all.push(What::Parent(parents));
    }
    let codes = [before, after].map(|row| match &row.growth {
        Growth::Code(code) => Some(code.clone()),
        Growth::None | Growth::Fraction(_) => None,
    });
    let counts = [before.quantity.count, after.quantity.count];
    if counts[0] != counts[1] {
        all.push(What::Quantity(counts));
    }
    let copies = [before.quantity.errors, after.quantity.errors];
    if copies[0] != copies[1] {
        all.push(What::Copies(copies));
    }
    let parts = [0, 1].map(|side| cases[side].budget.given(rows[side]));
    let mut distance = (after.place.position - before.place.position).norm();
    let size = after.place.position.max_abs().max(before.place.position.max_abs());
    let mut is_moved = distance > ROUNDING * size;
    match parts {
        [Some(was), Some(is)] => {
            if !near(was.mass(), is.mass()) {
                all.push(What::Mass([was.mass(), is.mass()]));
            }
            let by = (is.center_of_mass() - was.center_of_mass()).norm();
            let size = is.center_of_mass().max_abs().max(was.center_of_mass().max_abs());
            if by > ROUNDING * size {
                // Both together, along the axes of the frame in which it stands.
                let [was, is] = [(before, was), (after, is)]
                    .map(|(row, part)| row.place.position + row.place.rotation * part.center_of_mass());
                (is_moved, distance) = (true, (is - was).norm());
            }
            // What is only heavier has the tensor that goes with it.
            all.extend(tensor_change([before, after], [&was, &is]).map(What::Tensor));
        }
        [None, Some(is)] => all.push(What::Mass([0.0, is.mass()])),
        [Some(was), None] => all.push(What::Mass([was.mass(), 0.0])),
        [None, None] => {}
    }
    if is_moved {
        all.push(What::Moved(distance));
    }
    let angle = (after.place.rotation * before.place.rotation.inverse()).angle();
    if angle > ROUNDING {
        all.push(What::Turned(angle));
    }
    let growths = [0, 1].map(|side| cases[side].budget.growth(rows[side]));
    if !near(growths[0], growths[1]) {
        all.push(What::Growth(growths));
    }
    if before.allowable != after.allowable {
        all.push(What::Allowable([before.allowable, after.allowable]));
    }
    if codes[0] != codes[1] {
        all.push(What::Maturity(codes));
    }
    let subtotals = [0, 1].map(|side| cases[side].subtotal(rows[side]));
    if subtotals[0] != subtotals[1] {
        all.push(What::Subtotal(subtotals));
    }
    let groups = [before, after].map(|row| row.group.clone());
    if groups[0] != groups[1] {
        all.push(What::Group(groups));
    }
    all.extend(errors::changed([before, after]).map(What::Uncertainty));
    all
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= ROUNDING * a.abs().max(b.abs())
}

/// By how much the tensor of a mass of 1 kg changed, about the centre of mass or as it is given, over its greatest element; `None` where that is rounding.
fn tensor_change(rows: [&Row; 2], parts: [&MassProperties<Part>; 2]) -> Option<f64> {
    /// The way from another point to the centre of mass costs digits.
    const OF_CENTER: f64 = 1e-9;
    let own = parts.map(|part| {
        let [[xx, xy, xz], [_, yy, yz], [.., zz]] = part.inertia().matrix();
        [xx, yy, zz, xy, xz, yz].map(|x| x / part.mass())
    });
    let of_center = change(own, OF_CENTER);
    let [Some(was), Some(is)] = rows.map(|row| row.part.as_ref().map(|part| &part.tensor)) else {
        return of_center;
    };
    if was.about != is.about || was.sign != is.sign {
        return of_center;
    }
    let of = |tensor: &GivenTensor, mass: f64| {
        let ([xx, yy, zz], [xy, xz, yz]) = (tensor.moments, tensor.products);
        [xx, yy, zz, xy, xz, yz].map(|x| x / mass)
    };
    of_center.or(change([of(was, parts[0].mass()), of(is, parts[1].mass())], ROUNDING))
}

/// The greatest difference over the greatest number, if it is more than rounding.
fn change([was, is]: [[f64; 6]; 2], rounding: f64) -> Option<f64> {
    let greatest = was.iter().chain(&is).fold(0.0_f64, |most, x| most.max(x.abs()));
    let by = was.iter().zip(&is).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    (by > rounding * greatest).then(|| by / greatest)
}
