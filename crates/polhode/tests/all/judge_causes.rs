//! Causes of wrong motions, introduced by an independent program and identified; correct motions
//! are not reported.

mod bodies;
mod equations;
mod many_bodies;
mod methods;
mod program;
mod right_motions;
mod scene;
mod torques;
