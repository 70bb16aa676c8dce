//! The integration tests of `polhode`, as one program: each links the whole library.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod accuracy;
mod common;
mod curves;
mod density;
mod drag;
mod edges;
mod elliptic;
mod energy_sink;
mod ensemble;
mod equilibria;
mod event;
mod free_motion;
mod heavy_top;
mod inverse;
mod mesh;
mod mesh_diagnosis;
mod mesh_hull;
mod mesh_shapes;
mod motion;
mod orbits;
mod own_torque;
mod pendulum_motion;
mod properties;
mod published;
mod rotational_constants;
mod scenario;
mod schedule;
mod shaft;
mod shapes;
mod splitting;
mod stability;
mod taylor_layouts;
mod torsion;
mod tumbling;
mod wheels;
