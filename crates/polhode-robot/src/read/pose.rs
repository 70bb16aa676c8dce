//! Poses as written. Unreadable numbers are kept, and count as zero.

use crate::model::{Number, Pose, Span};
use crate::read::xml::Written;

/// Numbers of a pose while it is read.
#[derive(Debug, Default)]
pub(super) struct Reading {
    unreadable: Vec<Number>,
    span: Option<Span>,
}

impl Reading {
    /// Reads `N` numbers of an attribute; `default` if it is missing. A number that is not finite
    /// is recorded and counts as zero. The whole text is recorded if it has the wrong number of
    /// values.
    pub(super) fn numbers<const N: usize>(
        &mut self,
        written: Option<&Written<'_>>,
        default: [f64; N],
    ) -> [f64; N] {
        let Some(written) = written else { return default };
        self.covers(&written.span);
        let mut values = [0.0; N];
        let mut count = 0;
        for number in written.numbers() {
            match (number.value.filter(|value| value.is_finite()), values.get_mut(count)) {
                (Some(value), Some(slot)) => *slot = value,
                (None, Some(_)) => self.unreadable.push(number),
                (_, None) => {}
            }
            count += 1;
        }
        if count != N {
            self.unreadable.push(Number {
                text: written.value.to_owned(),
                span: written.span.clone(),
                value: None,
            });
        }
        values
    }

    /// Records an attitude that is not a rotation: a quaternion of norm zero.
    pub(super) fn refuse(&mut self, written: &Written<'_>) {
        self.unreadable.push(Number {
            text: written.value.to_owned(),
            span: written.span.clone(),
            value: None,
        });
    }

    /// Extends the span of the pose.
    pub(super) fn covers(&mut self, span: &Span) {
        let all =
            self.span.take().map_or(span.clone(), |own| own.start.min(span.start)..own.end.max(span.end));
        self.span = Some(all);
    }

    /// Returns the pose.
    pub(super) fn pose(self, position: [f64; 3], rotation: [f64; 4]) -> Pose {
        Pose { position, rotation, unreadable: self.unreadable, span: self.span }
    }
}
