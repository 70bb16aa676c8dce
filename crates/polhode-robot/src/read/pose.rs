//! Poses as they are written: numbers that are none are kept, and count as zero.

use crate::model::{Number, Pose, Span};
use crate::read::xml::Written;

/// Numbers of a pose on their way into it.
#[derive(Debug, Default)]
pub(super) struct Reading {
    unreadable: Vec<Number>,
    span: Option<Span>,
}

impl Reading {
    /// `N` numbers of an attribute; `default` if it is not there. What is not a finite number, is kept and counts as zero, and so
    /// is the whole text if it has fewer numbers or more.
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

    /// An attitude that is no rotation: a quaternion of length zero.
    pub(super) fn refuse(&mut self, written: &Written<'_>) {
        self.unreadable.push(Number {
            text: written.value.to_owned(),
            span: written.span.clone(),
            value: None,
        });
    }

    /// The pose stands here, among others.
    pub(super) fn covers(&mut self, span: &Span) {
        let all =
            self.span.take().map_or(span.clone(), |own| own.start.min(span.start)..own.end.max(span.end));
        self.span = Some(all);
    }

    /// The pose.
    pub(super) fn pose(self, position: [f64; 3], rotation: [f64; 4]) -> Pose {
        Pose { position, rotation, unreadable: self.unreadable, span: self.span }
    }
}
