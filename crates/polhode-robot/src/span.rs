//! Places in a text.

use std::ops::Range;

/// Bytes of a model's text.
pub type Span = Range<usize>;
