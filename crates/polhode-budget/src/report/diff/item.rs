//! What is said of something, in words.

/// Something that is stated, in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Item {
    /// What it is called; where several are called alike their number stands between.
    pub name: [String; 2],
    pub value: String,
}

impl Item {
    pub(crate) fn new(name: impl Into<String>, value: impl Into<String>) -> Self {
        Self { name: [name.into(), String::new()], value: value.into() }
    }

    /// One of perhaps several: `burn`, ` of the tank fuel`.
    pub(crate) fn of_several(name: &str, of: impl Into<String>, value: impl Into<String>) -> Self {
        Self { name: [name.to_owned(), of.into()], value: value.into() }
    }
}
