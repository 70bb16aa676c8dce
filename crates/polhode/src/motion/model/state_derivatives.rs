//! Derivatives of a state with respect to the start and to the inertia tensor.

use super::rotor::Rotor;
use super::state::State;
use crate::body::MassPropertiesGradient;
use crate::math::frame::Body;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Direction;

/// Derivatives of a state, with rows θ1 θ2 θ3 ω1 ω2 ω3. The attitude is R exp(θ), with θ a small
/// rotation vector along body axes (rad). ω is along body axes (rad/s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateDerivatives {
    /// The state itself.
    pub state: State,
    /// Derivatives with respect to θ and ω of the start, body axes: the state transition matrix
    /// Φ(t, t0). Columns θ1 θ2 θ3 ω1 ω2 ω3.
    pub by_start: [[f64; 6]; 6],
    /// Derivatives with respect to the elements of the inertia tensor, kg·m²: columns xx, yy, zz,
    /// xy, xz, yz. `I_xy` = `I_yx` is one variable, an element of the tensor: minus the integral of
    /// xy.
    pub by_inertia: [[f64; 6]; 6],
}

impl StateDerivatives {
    /// Returns the first-order covariance J C Jᵀ of the state from the joint covariance C of all
    /// inputs, which may be correlated. Rows and columns are in the order of the derivatives.
    ///
    /// The inputs of `joint` are θ1 … ω3 of the start, xx … yz, and then the parameters of torques.
    /// `by_parameters` has the derivatives with respect to the parameters, as in
    /// [`TrajectoryDerivatives::by_parameters`](crate::motion::TrajectoryDerivatives::by_parameters).
    /// Returns `None` if the size of `joint` does not match.
    ///
    /// ```
    /// use polhode::prelude::*;
    /// use polhode::motion::FreeMotionDerivatives;
    /// let body = MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([1.0, 2.0, 3.0])?)?;
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.0, 0.0, 0.5) };
    /// let after = FreeMotionDerivatives::of(&Rotor::free(&body), start)?.at(7.0);
    /// // ω about the axis of the spin is known to 0.01 rad/s, and the angle at the start to
    /// // 0.03 rad, both too large if one is.
    /// let mut joint = vec![vec![0.0; 12]; 12];
    /// (joint[2][2], joint[5][5], joint[2][5], joint[5][2]) = (9e-4, 1e-4, 3e-4, 3e-4);
    /// let covariance = after.joint_covariance(&[], &joint).ok_or("not of 12 numbers")?;
    /// assert!((covariance[2][2].sqrt() - (0.03 + 7.0 * 0.01)).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn joint_covariance(&self, by_parameters: &[[f64; 6]], joint: &[Vec<f64>]) -> Option<[[f64; 6]; 6]> {
        let count = 12 + by_parameters.len();
        if joint.len() != count || joint.iter().any(|row| row.len() != count) {
            return None;
        }
        let columns = |i: usize| {
            let known = self.by_start[i].iter().chain(&self.by_inertia[i]).copied();
            known.chain(by_parameters.iter().map(|column| column[i])).collect()
        };
        let rows: [Vec<f64>; 6] = core::array::from_fn(columns);
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let half = rows.each_ref().map(|row| joint.iter().map(|c| dot(c, row)).collect::<Vec<f64>>());
        Some(rows.each_ref().map(|row| half.each_ref().map(|half| dot(row, half))))
    }

    /// Returns the first-order covariance Φ P Φᵀ + G Q Gᵀ of the state from the covariances of the
    /// start and of the inertia tensor, which are uncorrelated. Rows and columns are in the order
    /// of the derivatives.
    #[must_use]
    pub fn covariance(&self, start: &[[f64; 6]; 6], inertia: &[[f64; 6]; 6]) -> [[f64; 6]; 6] {
        let (of_start, of_inertia) = (carried(&self.by_start, start), carried(&self.by_inertia, inertia));
        let mut sum = of_start;
        for (row, other) in sum.iter_mut().zip(of_inertia) {
            for (element, x) in row.iter_mut().zip(other) {
                *element += x;
            }
        }
        sum
    }

    /// Returns the derivatives of θ1 θ2 θ3 ω1 ω2 ω3 with respect to the mass properties of the
    /// body.
    ///
    /// They act through the inertia tensor about the rotor's reference point. For a free body this
    /// is complete. The tensor about a pivot depends on the mass and on the centre of mass,
    ///
    /// ∂`I_p` = ∂I + (a² 1 − a aᵀ) ∂M + M (2 a·∂c 1 − a ∂cᵀ − ∂c aᵀ),  a from the pivot to the
    /// centre of mass.
    ///
    /// A torque that depends on the mass properties, such as gravity, adds its own derivatives: see
    /// its parameters
    /// ([`Simulation::run_with_derivatives`](crate::motion::Simulation::run_with_derivatives)).
    ///
    /// ```
    /// use polhode::body::mesh::MeshDerivatives;
    /// use polhode::motion::FreeMotionDerivatives;
    /// use polhode::prelude::*;
    /// let [o, x, y, z] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
    /// let mesh = ClosedMesh::from_triangles(vec![[o, y, x], [o, x, z], [o, z, y], [x, y, z]])?;
    /// let solid = MeshDerivatives::of(&mesh, Substance::Density(4.0))?;
    /// let rotor = Rotor::free(&solid.properties().into_body());
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.3, 0.5, 0.9) };
    /// let after = FreeMotionDerivatives::of(&rotor, start)?.at(7.0);
    /// // How each vertex changes ω₁ after 7 s, rad/s per m: one pass over the triangles.
    /// let by_vertices = solid.gradient(&after.by_mass_properties(&rotor)[3].in_part());
    /// assert_eq!(by_vertices.len(), 4);
    /// // The mesh moved as a whole turns as it did.
    /// assert!(by_vertices.iter().map(|by| by[0]).sum::<f64>().abs() < 1e-13);
    /// // Nor does a denser solid turn otherwise.
    /// let by_density = after.by_mass_properties(&rotor)[3].in_part().derivative_along(&solid.by_density());
    /// assert!(by_density.abs() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn by_mass_properties(&self, rotor: &Rotor) -> [MassPropertiesGradient<Body>; 6] {
        let lever = rotor.lever().to_array();
        self.by_inertia.map(|by_inertia| {
            let along = |change: Symmetric3| {
                let elements = change.inertia_of_second_moments().elements();
                by_inertia.iter().zip(elements).map(|(by, x)| by * x).sum::<f64>()
            };
            let by_center = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
                .map(|axis| along(Symmetric3::twice_outer(lever, axis) * rotor.mass()));
            MassPropertiesGradient {
                by_mass: along(Symmetric3::outer(lever)),
                by_center_of_mass: Direction::from_array(by_center),
                by_inertia,
            }
        })
    }

    /// Returns NaN derivatives, for a time at which nothing is known.
    #[cold]
    pub(crate) fn unknown(time: f64) -> Self {
        let none = [[f64::NAN; 6]; 6];
        Self { state: State::unknown(time), by_start: none, by_inertia: none }
    }
}

/// Returns D C Dᵀ.
fn carried(derivatives: &[[f64; 6]; 6], covariance: &[[f64; 6]; 6]) -> [[f64; 6]; 6] {
    let dot = |a: &[f64; 6], b: &[f64; 6]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let half = derivatives.map(|row| [0, 1, 2, 3, 4, 5].map(|k| dot(&row, &covariance.map(|c| c[k]))));
    half.map(|row| derivatives.map(|other| dot(&row, &other)))
}
