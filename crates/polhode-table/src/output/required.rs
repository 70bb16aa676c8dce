//! The table of what a prescribed motion needs: one row per sample.
//!
//! The first columns are always there; after them come the forces on given points, numbered from 1, and those of a shaft's
//! bearings. SI units, named in the column's name.

use std::io::{self, BufWriter, Write};

use polhode::body::Particle;
use polhode::math::Body;
use polhode::motion::{MountedShaft, Required, Rotor};

use super::csv::separated;

/// A table of what a motion needs.
#[derive(Clone, Debug, PartialEq)]
pub struct RequiredTable(Vec<RequiredColumn>);

/// One column of it.
#[derive(Clone, Debug, PartialEq)]
pub struct RequiredColumn {
    /// The name, with its unit as suffix.
    pub name: String,
    /// The unit in SI symbols.
    pub unit: &'static str,
    /// What it is.
    pub description: &'static str,
    /// A number for each row.
    pub values: Vec<f64>,
}

impl RequiredTable {
    /// The table of some samples, with the forces on points of the body and on the bearings of its shaft.
    pub fn new(
        samples: &[Required],
        rotor: &Rotor,
        points: &[Particle<Body>],
        shaft: Option<&MountedShaft>,
    ) -> Self {
        let mut table = Self(Vec::new());
        let first = samples.first();
        table.number(samples, "time_s", "s", "time", |s| s.state.time);
        table.vector(samples, "omega_body", "_rad_s", "rad/s", OMEGA, |s| s.state.omega.to_array());
        table.vector(samples, "acceleration_body", "_rad_s2", "rad/s²", RATE, |s| s.acceleration.to_array());
        table.vector(samples, "torque_body", "_n_m", "N·m", TORQUE_BODY, |s| s.torque.to_array());
        table.vector(samples, "torque_space", "_n_m", "N·m", TORQUE_SPACE, |s| s.torque_space().to_array());
        table.number(samples, "power_w", "W", "power of the torque", |s| s.power);
        table.number(samples, "work_j", "J", "work of the torque since the first row", |s| {
            first.map_or(0.0, |first| s.work_since(first))
        });
        for (k, point) in points.iter().enumerate() {
            let name = format!("force_{}_body", k + 1);
            table.vector(samples, &name, "_n", "N", FORCE, |s| s.force_on(point, rotor).force.to_array());
        }
        for k in 0..shaft.map_or(0, |_| 2) {
            let name = format!("bearing_{}_body", k + 1);
            let force = |s: &Required| {
                let rate = |mounted: &MountedShaft| mounted.shaft.axis().dot(s.state.omega);
                let held = shaft.map(|mounted| mounted.reactions(rate(mounted), s.state.attitude).bearings);
                held.and_then(|held| held.get(k).copied()).map_or([0.0; 3], polhode::math::Force::to_array)
            };
            table.vector(samples, &name, "_n", "N", BEARING, force);
        }
        table
    }

    /// All columns, in order.
    pub fn columns(&self) -> &[RequiredColumn] {
        &self.0
    }

    /// How many rows there are.
    pub fn rows(&self) -> usize {
        self.0.first().map_or(0, |column| column.values.len())
    }

    /// Writes the table as text: RFC 4180 with LF line ends, numbers that read back bit for bit.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_csv(&self, out: impl Write) -> io::Result<()> {
        let mut out = BufWriter::new(out);
        separated(&mut out, &self.0, |out, column| write!(out, "{}", column.name))?;
        for row in 0..self.rows() {
            let value = |column: &RequiredColumn| column.values.get(row).copied().unwrap_or(f64::NAN);
            separated(&mut out, &self.0, |out, column| write!(out, "{:?}", value(column)))?;
        }
        out.flush()
    }

    fn number(
        &mut self,
        samples: &[Required],
        name: &str,
        unit: &'static str,
        description: &'static str,
        value: impl Fn(&Required) -> f64,
    ) {
        let values = samples.iter().map(value).collect();
        self.0.push(RequiredColumn { name: name.to_owned(), unit, description, values });
    }

    fn vector(
        &mut self,
        samples: &[Required],
        name: &str,
        suffix: &str,
        unit: &'static str,
        description: &'static str,
        value: impl Fn(&Required) -> [f64; 3],
    ) {
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            self.number(samples, &format!("{name}_{axis}{suffix}"), unit, description, |s| value(s)[k]);
        }
    }
}

const OMEGA: &str = "angular velocity relative to space, along body axes";
const RATE: &str = "rate of the angular velocity, along body axes";
const TORQUE_BODY: &str = "torque that the motion needs, along body axes";
const TORQUE_SPACE: &str = "torque that the motion needs, along space axes";
const FORCE: &str = "force on a point that the motion needs, along body axes";
const BEARING: &str = "force of a bearing on the shaft, along body axes";
