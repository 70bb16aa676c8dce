//! Positions in a text.

use std::ops::Range;

/// Byte range in a model's text.
pub type Span = Range<usize>;
