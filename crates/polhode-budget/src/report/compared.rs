//! Comparison of first order with draws.

use polhode_document::Section;
use polhode_document::number::{count, number};

use super::case::{Case, Drawn};
use super::limits::shown_unit;
use crate::{ComparedNumber, NUMBERS};

pub(crate) fn section(case: &Case) -> Option<Section> {
    let Drawn { comparison, .. } = case.drawn.as_ref()?;
    let mut section = Section::new(5, "First-order errors compared with draws");
    let draws = count(comparison.draws as u64);
    section.say(format!(
        "Monte Carlo check with {draws} draws of physically possible bodies: masses are log-normal; centres, positions and tensors are normal. A difference shows what the linear (first-order) estimate neglects."
    ));
    let row = |(k, n): (usize, &ComparedNumber)| {
        let (unit, scale) = shown_unit(n.unit);
        let shown = |x: f64, digits: usize| number(scale * x, digits);
        vec![
            n.name.to_owned(),
            if is_comparable(case, k) { shown(n.first_order_sd, 3) } else { "none".to_owned() },
            format!("{} ± {}", shown(n.sd, 3), shown(n.sd_error, 1)),
            format!("{} ± {}", shown(n.bias(), 2), shown(n.mean_error, 1)),
            unit.to_owned(),
            if is_comparable(case, k) && n.differs() { "differs" } else { "" }.to_owned(),
        ]
    };
    let headers = ["quantity", "sd to first order", "sd of draws", "mean of draws − value", "unit", ""];
    section.table(&headers, comparison.numbers.iter().enumerate().map(row).collect());
    if comparison.moved > 0 {
        let tanks = if has_liquid(case) { ", or a tank was overfull and was set to full" } else { "" };
        section.say(format!(
            "In {} of {draws} draws, the tensor of a part was unphysical and was replaced with the nearest physical one{tanks}.",
            count(comparison.moved as u64)
        ));
    }
    Some(section)
}

/// Returns a message with the numbers for which draws differ from first order.
pub(crate) fn difference_in_words(case: &Case) -> Option<String> {
    let comparison = &case.drawn.as_ref()?.comparison;
    let differs = |(k, n): &(usize, &ComparedNumber)| is_comparable(case, *k) && n.differs();
    let names: Vec<&str> =
        comparison.numbers.iter().enumerate().filter(differs).map(|(_, n)| n.name).collect();
    (!names.is_empty()).then(|| {
        // The mass is a sum. Its mean and standard deviation are exact to first order, even if
        // draws miss its long tail. Liquids are an exception, because a tank cannot overflow.
        let of_mass = if names.contains(&"mass") && !has_liquid(case) { "; first order is exact for the mass" } else { "" };
        format!(
            "draws and first-order errors differ significantly in {}: the quantity is not linear in the errors, or there are too few draws for the tail of a distribution{of_mass}",
            names.join(", ")
        )
    })
}

/// Returns true if there is a liquid with errors.
fn has_liquid(case: &Case) -> bool {
    let rows = case.budget.rows();
    (0..rows.len()).any(|row| rows.liquid(row).is_some())
}

/// Returns true if first order is valid for the error of a number, by its index in the comparison.
fn is_comparable(case: &Case, k: usize) -> bool {
    let Some(moment) = k.checked_sub(NUMBERS.len()) else { return true };
    case.principal.is_first_order(moment)
}
