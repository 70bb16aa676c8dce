//! Derivations of the results of the lecture notes.
