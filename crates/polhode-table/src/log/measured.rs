//! Motion logged by an instrument: rates, attitudes, or both.

use polhode::infer::judge::{AttitudeSense, OmegaAxes, QuaternionOrder};

use super::ReadColumns;
use super::choice::{Form, Plan};
use super::rows::Rows;

/// Angular velocities and attitudes at the same times, in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredLog {
    /// Times, s, ascending.
    pub times: Vec<f64>,
    /// Angular velocities, rad/s; `None` if the file has none.
    pub omega: Option<Vec<[f64; 3]>>,
    /// Axes of the angular velocity, if the names of its columns state them.
    pub omega_axes: Option<OmegaAxes>,
    /// Attitudes, each as four numbers proportional to a quaternion; `None` if the file has none.
    pub attitude: Option<Vec<[f64; 4]>>,
    /// Position of the scalar in the quaternion, if the file states it.
    pub order: Option<QuaternionOrder>,
    /// Direction of the rotation, if the file states it.
    pub sense: Option<AttitudeSense>,
    /// Columns that were read, with their meaning.
    pub read: Vec<ReadColumns>,
    /// Columns that were not read.
    pub ignored: Vec<String>,
}

impl MeasuredLog {
    pub(crate) fn of(plan: Plan, rows: Rows) -> Self {
        Self {
            times: rows.times,
            omega: plan.omega.is_some().then_some(rows.omega),
            omega_axes: plan.says.omega_axes,
            attitude: (!matches!(plan.form, Form::None)).then_some(rows.attitude),
            order: plan.says.order,
            sense: plan.says.sense,
            read: plan.read,
            ignored: plan.ignored,
        }
    }
}
