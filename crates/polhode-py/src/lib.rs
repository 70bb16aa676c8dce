//! Rust side of the Python package `polhode`: the module `_native`, used by `python/polhode`.
//!
//! The Python side checks arguments and converts them to arrays (`_arrays.py`). It defines the
//! public classes and their documentation. The Rust side has plain functions of arrays and texts,
//! which compute without Python's lock. All computations are those of the library.
#![cfg_attr(
    not(feature = "default"),
    allow(dead_code, reason = "helpers may serve only functions that are left out")
)]

mod actions;
mod arrays;
mod brep;
#[cfg(feature = "budget")]
mod budget;
#[cfg(feature = "robot")]
mod check;
mod command;
#[cfg(feature = "robot")]
mod compare;
mod derivatives;
mod ensemble;
mod error;
mod explain;
mod files;
mod finding;
mod free_motion;
mod free_motions;
mod function;
#[cfg(feature = "identify")]
mod identify;
mod interrupt;
#[cfg(feature = "judge")]
mod judge;
#[cfg(feature = "live")]
mod knob;
mod mass_derivatives;
mod mass_properties;
mod mesh;
#[cfg(not(feature = "default"))]
mod missing;
mod motion;
mod nearest;
#[cfg(not(feature = "robot"))]
mod no_robot;
mod pickle;
mod required;
#[cfg(feature = "robot")]
mod robot;
mod rotation;
mod scenario;
mod shape;
mod stability;
mod substance;
#[cfg(feature = "sweep")]
mod sweep;
mod threads;
mod tumbler;
mod unit;

use pyo3::prelude::*;

/// Module `polhode._native`.
#[pymodule]
mod _native {
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::brep::step_solids;
    #[cfg(feature = "budget")]
    #[pymodule_export]
    use crate::budget::budget_list;
    #[cfg(feature = "robot")]
    #[pymodule_export]
    use crate::check::check_file;
    #[pymodule_export]
    use crate::command::run_command;
    #[cfg(feature = "robot")]
    #[pymodule_export]
    use crate::compare::compare_files;
    #[pymodule_export]
    use crate::derivatives::carried_covariance;
    #[pymodule_export]
    use crate::ensemble::PyEnsemble;
    #[pymodule_export]
    use crate::explain::explain_scenario;
    #[pymodule_export]
    use crate::files::{cad_file, molecule_file, particle_file, scenario_file, voxel_file};
    #[pymodule_export]
    use crate::free_motion::PyFreeMotion;
    #[pymodule_export]
    use crate::free_motions::free_motions;
    #[cfg(feature = "identify")]
    #[pymodule_export]
    use crate::identify::{find_flights, identify_flights, identify_plan, identify_wrenches};
    #[cfg(feature = "judge")]
    #[pymodule_export]
    use crate::judge::{judge_arrays, judge_file};
    #[cfg(feature = "live")]
    #[pymodule_export]
    use crate::knob::scenario_knobs;
    #[pymodule_export]
    use crate::mass_derivatives::{PyMeshDerivatives, body_derivatives, particle_derivatives};
    #[pymodule_export]
    use crate::mass_properties::PyMassProperties;
    #[pymodule_export]
    use crate::mesh::{mesh_arrays, mesh_corners, mesh_file};
    #[cfg(not(feature = "default"))]
    #[pymodule_export]
    use crate::missing::missing;
    #[pymodule_export]
    use crate::motion::{PyMotion, motion_page, simulate};
    #[pymodule_export]
    use crate::nearest::nearest_tensors;
    #[cfg(not(feature = "robot"))]
    #[pymodule_export]
    use crate::no_robot::is_robot;
    #[pymodule_export]
    use crate::required::required_torque;
    #[cfg(feature = "robot")]
    #[pymodule_export]
    use crate::robot::{is_robot, robot_file, robot_groups, robot_inertials, robot_links, robot_table};
    #[pymodule_export]
    use crate::rotation::{quaternion_of_text, quaternions_of_matrices};
    #[pymodule_export]
    use crate::scenario::{PyScenario, scenario_tables};
    #[pymodule_export]
    use crate::shape::shape;
    #[pymodule_export]
    use crate::stability::scenario_stability;
    #[pymodule_export]
    use crate::substance::materials;
    #[cfg(feature = "sweep")]
    #[pymodule_export]
    use crate::sweep::{PyDataset, PyPlan};
    #[pymodule_export]
    use crate::threads::available_threads;
    #[pymodule_export]
    use crate::tumbler::tumbling_spins;
    #[pymodule_export]
    use crate::unit::{quantity, unit};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("VERSION", polhode_document::VERSION)
    }
}
