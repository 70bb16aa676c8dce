//! What an instrument logged of a motion: rates, attitudes, or both.

use polhode::infer::judge::{AttitudeSense, OmegaAxes, QuaternionOrder};

use super::ReadColumns;
use super::choice::{Form, Plan};
use super::rows::Rows;

/// Rates and attitudes at the same times, in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredLog {
    /// s, ascending.
    pub times: Vec<f64>,
    /// rad/s; `None` if the file has none.
    pub omega: Option<Vec<[f64; 3]>>,
    /// Along which axes, if the columns' names say it.
    pub omega_axes: Option<OmegaAxes>,
    /// Four numbers that are proportional to a quaternion; `None` if the file has none.
    pub attitude: Option<Vec<[f64; 4]>>,
    /// Which of them is the scalar, if the file says it.
    pub order: Option<QuaternionOrder>,
    /// Which way it turns, if the file says it.
    pub sense: Option<AttitudeSense>,
    /// The columns that were read, and as what.
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
