//! Packages of XML in a ZIP archive, as 3MF and XLSX files are.

pub mod archive;
pub mod relation;
pub mod unfolding;
pub mod xml;
