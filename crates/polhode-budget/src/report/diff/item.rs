//! Statements in words.

/// Statement about an item, in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Item {
    /// Name of the item in two parts. If several items have the same name, their number is between
    /// the parts.
    pub name: [String; 2],
    pub value: String,
}

impl Item {
    pub(crate) fn new(name: impl Into<String>, value: impl Into<String>) -> Self {
        Self { name: [name.into(), String::new()], value: value.into() }
    }

    /// Returns a statement about one of possibly several items, such as `burn` and
    /// ` of the tank fuel`.
    pub(crate) fn of_several(name: &str, of: impl Into<String>, value: impl Into<String>) -> Self {
        Self { name: [name.to_owned(), of.into()], value: value.into() }
    }
}
