//! Differences of the mass properties of two links, or of two sums of links.

use polhode_document::number::number;

use super::difference::{CENTER, MASS, Sides, TENSOR, distance, two, two_lists, two_points};
use super::explanation::Slips;
use super::mass::{Mass, length, vector};
use crate::finding::Finding;
use crate::model::{Inertial, Link, Pose, Slot, Span, Tensor};
use crate::moments::{Elements, difference, elements, matrix, norm};

/// Names of the elements.
const ELEMENTS: [&str; 6] = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"];

/// Mass properties of both models in one frame, with the links that state them.
#[derive(Debug)]
pub(super) struct Compared<'s> {
    pub(super) subject: &'s str,
    /// Further links of a sum.
    pub(super) others: Vec<String>,
    /// Link of the second model and of the first; `None` for a sum.
    pub(super) links: [Option<&'s Link>; 2],
    pub(super) a: Mass,
    pub(super) b: Mass,
    /// Words at the end of each message: agreement of the sums above.
    pub(super) remark: &'s str,
}

impl Compared<'_> {
    /// Returns the differences of mass, centre and tensor.
    pub(super) fn differences(&self, sides: &Sides<'_, '_>, tolerance: f64) -> Vec<Finding> {
        let [mass, center, tensor] = self.a.agrees(&self.b, tolerance);
        let slips = Slips { a: &sides.name_a, b: &sides.name_b, tolerance };
        let mut found = Vec::new();
        found.extend((!mass).then(|| self.mass(sides, slips)));
        found.extend((!center).then(|| self.center(sides, slips)));
        found.extend((!tensor).then(|| self.tensor(sides, slips)));
        found
    }

    /// Returns the message about a quantity that one of the files states in a form that cannot be
    /// read; `index` counts mass, centre and tensor.
    fn unreadable(&self, sides: &Sides<'_, '_>, index: usize, what: &str) -> Option<String> {
        match [&self.a, &self.b].map(|body| body.readable()[index]) {
            [true, true] => None,
            [true, false] => Some(format!("the {what} cannot be read, unlike that in {}", sides.name_a)),
            _ => Some(format!("the {what} cannot be read in {}", sides.name_a)),
        }
    }

    fn mass(&self, sides: &Sides<'_, '_>, slips: Slips<'_>) -> Finding {
        let (a, b) = (self.a.mass, self.b.mass);
        let [of_a, of_b] = two(a, b);
        let explanation = slips.of_mass(a, b);
        let ratio = ratio(b / a).filter(|_| explanation.is_none());
        let unreadable = self.unreadable(sides, 0, "mass");
        let message = format!("mass {of_b} kg, in {} {of_a} kg", sides.name_a);
        let message = unreadable.unwrap_or(message);
        let spans = self.spans(|inertial| inertial.mass.span());
        let found = self.finding(sides, MASS, spans, &message, ratio, explanation);
        Finding { numbers: vec![("a", a), ("b", b)], ..found }
    }

    fn center(&self, sides: &Sides<'_, '_>, slips: Slips<'_>) -> Finding {
        let (a, b) = (self.a.center, self.b.center);
        let apart = length(vector(a, b));
        let [of_a, of_b] = two_points(a, b);
        let unreadable = self.unreadable(sides, 1, "centre of mass");
        let words = unreadable.is_none().then(|| format!("{} apart", distance(apart)));
        let message = format!("centre of mass {of_b} m, in {} {of_a} m", sides.name_a);
        let message = unreadable.unwrap_or(message);
        let spans = self.spans(|inertial| inertial.pose.span.clone().unwrap_or(inertial.span.clone()));
        let found = self.finding(sides, CENTER, spans, &message, words, slips.of_center(a, b));
        Finding { numbers: vec![("distance", apart)], ..found }
    }

    fn tensor(&self, sides: &Sides<'_, '_>, slips: Slips<'_>) -> Finding {
        // The numbers of the second file are along the axes of its inertial's frame.
        let inertial = self.links[0].and_then(|link| link.inertial.as_ref()).filter(|_| !self.is_computed());
        let frame = inertial.map_or(Pose::IDENTITY, |inertial| inertial.pose.inverse());
        let along = |tensor: &Elements| elements(&frame.turned_tensor(matrix(tensor)));
        let (a, b) = (along(&self.a.tensor), along(&self.b.tensor));
        let change = difference(&b, &a);
        let size = f64::max(norm(&a), norm(&b));
        let largest = change.iter().fold(0.0, |max, c| f64::max(max, c.abs()));
        // Elements that differ by less are equal next to the others.
        let least = f64::max(slips.tolerance * size, 1e-9 * largest);
        let differ: Vec<usize> = (0..6).filter(|&k| change[k].abs() > 0.5 * least).collect();
        let shown = |&k: &usize| {
            let [of_a, of_b] = two(a[k], b[k]);
            format!("{} {of_b} kg·m², in {} {of_a} kg·m²", ELEMENTS[k], sides.name_a)
        };
        let message = match differ.as_slice() {
            few @ ([_] | [_, _]) => few.iter().map(shown).collect::<Vec<_>>().join("; "),
            _ => {
                let [of_a, of_b] = two_lists(&a, &b, " ");
                format!("ixx iyy izz ixy ixz iyz = {of_b} kg·m², in {} {of_a} kg·m²", sides.name_a)
            }
        };
        let relative = norm(&change) / size;
        let unreadable = self.unreadable(sides, 2, "tensor");
        let is_readable = unreadable.is_none();
        let message = unreadable.unwrap_or(message);
        let center = |body: &Mass| (body.mass, frame.turned(body.center));
        let explanation = slips.of_tensor(&a, &b, [center(&self.a), center(&self.b)]);
        let relative_words = || format!("the tensor differs by {} (relative)", number(relative, 3));
        let of_one = match differ.as_slice() {
            [k] => ratio(b[*k] / a[*k]),
            _ => None,
        };
        let is_plain = is_readable && explanation.is_none();
        let words = is_plain.then(|| of_one.unwrap_or_else(relative_words));
        let first = differ.first().copied();
        let spans = self.spans(|inertial| tensor_span(inertial, first));
        let found = self.finding(sides, TENSOR, spans, &message, words, explanation);
        Finding { numbers: vec![("relative", relative)], ..found }
    }

    fn is_computed(&self) -> bool {
        self.links[0].is_some_and(|link| link.computed.is_some())
    }

    /// Returns the positions of a number in both files; the link where it is computed.
    fn spans(&self, of: impl Fn(&Inertial) -> Span) -> [Option<Span>; 2] {
        self.links.map(|link| {
            let link = link?;
            let stated = link.inertial.as_ref().filter(|_| link.computed.is_none());
            Some(stated.map_or_else(|| link.name.span.clone(), &of))
        })
    }

    fn finding(
        &self,
        sides: &Sides<'_, '_>,
        code: &'static str,
        spans: [Option<Span>; 2],
        message: &str,
        words: Option<String>,
        explanation: Option<String>,
    ) -> Finding {
        let words: Vec<String> = words.into_iter().chain(explanation).collect();
        let words = if words.is_empty() { String::new() } else { format!(": {}", words.join("; ")) };
        let message = format!("{message}{words}{}", self.remark);
        let found = sides.finding(code, self.subject, spans, message);
        Finding { others: self.others.clone(), ..found }
    }
}

/// Returns the ratio in words.
fn ratio(ratio: f64) -> Option<String> {
    let near = (ratio - 1.0).abs() < 1e-3;
    let words = if near {
        format!("{} (relative)", signed(ratio - 1.0))
    } else {
        format!("{} times", number(ratio, 4))
    };
    (ratio.is_finite() && ratio != 0.0).then_some(words)
}

fn signed(x: f64) -> String {
    let text = number(x, 3);
    if x > 0.0 { format!("+{text}") } else { text }
}

/// Returns the position of an element of the tensor, or of its first number.
fn tensor_span(inertial: &Inertial, element: Option<usize>) -> Span {
    let given = |slot: &Slot| matches!(slot, Slot::Given(_)).then(|| slot.span());
    let of_element = match (&inertial.tensor, element) {
        (Tensor::Six(slots), Some(k)) => slots.get(k).and_then(given),
        _ => None,
    };
    let first = || inertial.tensor.slots()?.filter_map(given).min_by_key(|span| span.start);
    of_element.or_else(first).unwrap_or_else(|| inertial.span.clone())
}
