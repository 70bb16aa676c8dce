//! Inertials of USD prims.
