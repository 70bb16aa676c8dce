//! What the user says of a run's numbers.

use clap::{Args, ValueEnum};
use polhode::infer::judge::{AttitudeSense, DeclaredReading, OmegaAxes, QuaternionOrder, SignedAxes};
use polhode_source::unit::Dimension;
use polhode_table::log::Columns;

use crate::numbers::quantity;

/// What the user says of a run's numbers; the rest is found.
#[derive(Debug, Args)]
pub(super) struct ReadAs {
    /// Which columns are what: time, quaternion wxyz|xyzw, matrix or euler 3-2-1 [deg], and omega body|space [deg/s].
    #[arg(long, value_name = "WHAT=NAMES, …", value_parser = |text: &str| Columns::parse(text).map_err(|error| format!("{error} (hint: {})", error.hint())))]
    pub(super) columns: Option<Columns>,
    /// The order of quaternions [default: found].
    #[arg(long, value_enum)]
    quaternion: Option<Order>,
    /// Which way rotations go: body components to space, or the inverse [default: found].
    #[arg(long, value_enum)]
    sense: Option<Sense>,
    /// Along which axes the angular velocity is [default: found].
    #[arg(long, value_enum)]
    omega: Option<Axes>,
    /// The run's axes x, y, z as axes of the scenario, such as x,z,-y [default: found].
    #[arg(long, value_name = "A,B,C", value_parser = signed_axes, allow_hyphen_values = true)]
    axes: Option<SignedAxes>,
    /// The run's time at the scenario's time 0, s or with its unit [default: found].
    #[arg(long, value_name = "T", value_parser = |text: &str| quantity(text, Dimension::TIME), allow_hyphen_values = true)]
    time_origin: Option<f64>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Order {
    Wxyz,
    Xyzw,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Sense {
    BodyToSpace,
    SpaceToBody,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Axes {
    Body,
    Space,
}

impl ReadAs {
    /// With what the run itself says; the user's word counts more.
    pub(super) fn declared(&self, says: &DeclaredReading) -> DeclaredReading {
        let order = self.quaternion.map(|order| match order {
            Order::Wxyz => QuaternionOrder::ScalarFirst,
            Order::Xyzw => QuaternionOrder::ScalarLast,
        });
        let sense = self.sense.map(|sense| match sense {
            Sense::BodyToSpace => AttitudeSense::BodyToSpace,
            Sense::SpaceToBody => AttitudeSense::SpaceToBody,
        });
        let omega_axes = self.omega.map(|axes| match axes {
            Axes::Body => OmegaAxes::Body,
            Axes::Space => OmegaAxes::Space,
        });
        let said = DeclaredReading {
            order,
            sense,
            omega_axes,
            axes: self.axes,
            time_origin: self.time_origin,
            ..DeclaredReading::default()
        };
        said.or(says)
    }
}

/// `x,z,-y`
fn signed_axes(text: &str) -> Result<SignedAxes, String> {
    SignedAxes::parse(text).ok_or_else(|| {
        "three axes of x, y and z, each once, that are right-handed belong here (hint: y upwards is x,z,-y; of left-handed axes reverse all three, \
         as for rotations that is the same)"
            .to_owned()
    })
}
