//! Causes of wrong motions, planted by a program of the test's own, and named; and right motions, which are not accused.

mod bodies;
mod equations;
mod many_bodies;
mod methods;
mod program;
mod right_motions;
mod scene;
mod torques;
