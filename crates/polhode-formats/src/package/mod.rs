//! Packages of XML in a ZIP archive, as 3MF and XLSX files are.

pub(crate) mod archive;
pub(crate) mod relation;
pub(crate) mod xml;
