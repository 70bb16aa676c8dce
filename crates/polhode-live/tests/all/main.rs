//! Tests of the server through its addresses.

mod lessons;
