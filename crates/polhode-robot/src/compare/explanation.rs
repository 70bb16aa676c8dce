//! Explanation of a difference by one slip: a unit, a factor, a sign, an order, a reference point.
//!
//! An explanation is stated only if it is the only one that holds within the tolerance.

use polhode_document::number::number;

use super::mass::{length, vector, within};
use crate::check::order::Order;
use crate::check::unit::UNITS;
use crate::moments::{Elements, difference, norm, parallel_axes, scaled, trace};

/// Value of the avoirdupois pound, kg.
const POUND: f64 = 0.453_592_37;
/// Names of coordinates and of products.
const COORDINATES: [&str; 3] = ["x", "y", "z"];
const PRODUCTS: [&str; 3] = ["ixy", "ixz", "iyz"];

/// Names of the two files, and the tolerance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slips<'n> {
    pub(super) a: &'n str,
    pub(super) b: &'n str,
    pub(super) tolerance: f64,
}

impl Slips<'_> {
    /// Explains two different masses.
    pub(super) fn of_mass(&self, a: f64, b: f64) -> Option<String> {
        let units = [("g", 1e-3), ("lb", POUND), ("t", 1e3)];
        let is = |x: f64, y: f64| within((x - y).abs(), self.tolerance * f64::max(x.abs(), y.abs()));
        let stated = |(unit, factor): &(&str, f64)| {
            let of = |file: &str| format!("the mass in {file} is in {unit}");
            if is(b * factor, a) {
                // A mass in t is also a mass in g in the other file.
                (*factor < 1.0).then(|| of(self.b))
            } else {
                (*factor < 1.0 && is(a * factor, b)).then(|| of(self.a))
            }
        };
        units.iter().find_map(stated)
    }

    /// Explains two different centres in one frame.
    pub(super) fn of_center(&self, a: [f64; 3], b: [f64; 3]) -> Option<String> {
        let is = |x: [f64; 3], y: [f64; 3]| {
            within(length(vector(x, y)), self.tolerance * f64::max(length(x), length(y)))
        };
        let mut found = Vec::new();
        for (unit, factor) in [("mm", 1e-3), ("cm", 1e-2), ("inches", 0.0254)] {
            for (file, from, to) in [(self.b, b, a), (self.a, a, b)] {
                if is(from.map(|c| factor * c), to) {
                    found.push(format!("the centre in {file} is in {unit}"));
                }
            }
        }
        for signs in signs() {
            if is([0, 1, 2].map(|k| signs[k] * b[k]), a) {
                found.push(format!("{} with the opposite sign", joined(&COORDINATES, signs, b)));
            }
        }
        for [i, j] in [[0, 1], [0, 2], [1, 2]] {
            let mut swapped = b;
            swapped.swap(i, j);
            if is(swapped, a) {
                found.push(format!("{} and {} swapped", COORDINATES[i], COORDINATES[j]));
            }
        }
        only(found)
    }

    /// Explains two different tensors along the same axes. `from_origin` is the mass, and the centre
    /// of mass from the link's origin along these axes, in each file.
    pub(super) fn of_tensor(
        &self,
        a: &Elements,
        b: &Elements,
        from_origin: [(f64, [f64; 3]); 2],
    ) -> Option<String> {
        let is = |x: &Elements, y: &Elements| {
            within(norm(&difference(x, y)), self.tolerance * f64::max(norm(x), norm(y)))
        };
        let mut found = Vec::new();
        let ratio = trace(b) / trace(a);
        if ratio.is_finite() && is(&scaled(a, ratio), b) {
            let unit = UNITS.iter().find_map(|unit| {
                let in_file = |file: &str| format!("the tensor in {file} is in {}", unit.name);
                if is(&scaled(b, unit.factor), a) {
                    Some(in_file(self.b))
                } else {
                    is(&scaled(a, unit.factor), b).then(|| in_file(self.a))
                }
            });
            found.push(unit.unwrap_or_else(|| format!("all elements {} times as large", number(ratio, 6))));
        }
        let [of_a, of_b] = from_origin;
        for (file, centred, about_origin, (mass, center)) in [(self.b, a, b, of_b), (self.a, b, a, of_a)] {
            let aside = parallel_axes(mass, center);
            if norm(&aside) > 0.0 && is(centred, &difference(about_origin, &aside)) {
                found.push(format!("the tensor in {file} is about the link's origin"));
            }
        }
        let [xx, yy, zz, products @ ..] = *b;
        for signs in signs() {
            let [xy, xz, yz] = [0, 1, 2].map(|k| signs[k] * products[k]);
            if is(&[xx, yy, zz, xy, xz, yz], a) {
                found.push(format!("{} with the opposite sign", joined(&PRODUCTS, signs, products)));
            }
        }
        let orders = Order::all().filter(|order| is(&order.applied(b), a));
        found.extend(orders.map(|order| order.mistake.to_owned()));
        only(found)
    }
}

/// Returns all changes of one, two or three signs.
fn signs() -> impl Iterator<Item = [f64; 3]> {
    (1..8).map(|bits: u8| [0, 1, 2].map(|k| if bits >> k & 1 == 1 { -1.0 } else { 1.0 }))
}

/// Returns the names of the numbers whose sign changes; zeros have no sign.
fn joined(names: &[&str; 3], signs: [f64; 3], numbers: [f64; 3]) -> String {
    let changed = names.iter().zip(signs).zip(numbers);
    let changed = changed.filter(|((_, sign), number)| *sign < 0.0 && *number != 0.0);
    let names: Vec<&str> = changed.map(|((name, _), _)| *name).collect();
    match names.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} and {last}", others.join(", ")),
        _ => names.concat(),
    }
}

/// Returns the explanation if it is the only one.
fn only(mut found: Vec<String>) -> Option<String> {
    found.sort();
    found.dedup();
    if found.len() == 1 { found.pop() } else { None }
}
