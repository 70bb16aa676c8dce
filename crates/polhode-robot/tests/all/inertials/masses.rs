//! masses
