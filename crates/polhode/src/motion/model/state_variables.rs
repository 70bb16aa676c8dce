//! Variables of formulas of a state.

use super::law::LawInput;
use super::rotor::Rotor;
use super::state::State;
use crate::math::algebra::{Scalar, VectorAlgebra};
use crate::math::formula::Binary;
use crate::math::vector::Direction;

/// Variables of formulas of a state, in SI units: names and values.
///
/// | variable | value |
/// |---|---|
/// | `t` | time |
/// | `wx`, `wy`, `wz` | ω along body axes |
/// | `wX`, `wY`, `wZ` | ω along space axes |
/// | `Lx`, `Ly`, `Lz` | L along body axes, wheels included |
/// | `LX`, `LY`, `LZ` | L along space axes, wheels included |
/// | `T_rot` | ½ ω · I ω, without wheels |
/// | `qw`, `qx`, `qy`, `qz` | quaternion of the attitude, continuous from the start; its sign is arbitrary |
/// | `r11` … `r33` | R_space_body, row by row: `r31` is the cosine between space z and body x |
/// | `phi`, `theta`, `psi` | 3-1-3 Euler angles: φ and ψ in −π … π, with a jump there; θ in 0 … π |
///
/// ```
/// use polhode::math::formula::{Binary, Formula, Instruction};
/// use polhode::motion::StateVariables;
/// let place = |name| StateVariables::NAMES.iter().position(|n| *n == name).map(Instruction::Variable);
/// let (wx, qw) = (place("wx").ok_or("wx")?, place("qw").ok_or("qw")?);
/// let product = Formula::new([wx, qw, Instruction::Binary(Binary::Multiply)])?;
/// # let inertia = polhode::body::InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
/// # let body = polhode::body::MassProperties::new(2.0, polhode::math::Position::ZERO, inertia)?;
/// # let rotor = polhode::motion::Rotor::free(&body);
/// # let omega = polhode::math::AngularVelocity::new(1.5, 2.0, 3.0);
/// # let state = polhode::motion::State { time: 0.0, attitude: polhode::math::Attitude::identity(), omega };
/// assert_eq!(product.evaluate(&StateVariables::of(&rotor, &state)), 1.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct StateVariables;

impl StateVariables {
    /// Number of variables.
    pub const COUNT: usize = 30;

    /// Names, in the order of the values.
    #[rustfmt::skip]
    pub const NAMES: [&'static str; Self::COUNT] = [
        "t",
        "wx", "wy", "wz", "wX", "wY", "wZ",
        "Lx", "Ly", "Lz", "LX", "LY", "LZ",
        "T_rot",
        "qw", "qx", "qy", "qz",
        "r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33",
        "phi", "theta", "psi",
    ];

    /// Returns the indices of the variables that depend on the mass properties.
    pub(crate) fn of_inertia() -> impl Iterator<Item = usize> {
        let names = Self::NAMES.into_iter().enumerate();
        names.filter(|(_, name)| name.starts_with('L') || *name == "T_rot").map(|(k, _)| k)
    }

    /// Returns the values in a state.
    pub fn of(rotor: &Rotor, state: &State) -> [f64; Self::COUNT] {
        let momentum = rotor.angular_momentum(state.omega) + rotor.wheel_momentum(state.time);
        let [wx, wy, wz] = state.omega.to_array();
        let [w_x, w_y, w_z] = state.omega_space().to_array();
        let [lx, ly, lz] = momentum.to_array();
        let [l_x, l_y, l_z] = (state.attitude * momentum).to_array();
        let [qw, qx, qy, qz] = state.attitude.quaternion();
        let [[r11, r12, r13], [r21, r22, r23], [r31, r32, r33]] = state.attitude.matrix();
        let [phi, theta, psi] = state.attitude.euler313();
        let energy = rotor.kinetic_energy(state.omega);
        [
            state.time, wx, wy, wz, w_x, w_y, w_z, lx, ly, lz, l_x, l_y, l_z, energy, qw, qx, qy, qz, r11,
            r12, r13, r21, r22, r23, r31, r32, r33, phi, theta, psi,
        ]
    }

    /// Returns one variable, for any input of a law.
    pub(crate) fn variable<I: LawInput>(k: usize, at: &I) -> I::Scalar {
        let momentum = || at.inertia(at.omega()) + at.wheel_momentum();
        let quaternion = || {
            let (w, v) = at.attitude();
            let [x, y, z] = at.components(v);
            [w, x, y, z]
        };
        // φ = atan2(z, w) + atan2(y, x), ψ = atan2(z, w) − atan2(y, x)
        let half_angles = || {
            let [w, x, y, z] = quaternion();
            [z.atan2(w), y.atan2(x)]
        };
        match Self::NAMES.get(k).copied().unwrap_or_default() {
            "t" => at.time(),
            "T_rot" => at.omega().dot(at.inertia(at.omega())).scaled(0.5),
            "phi" => {
                let [sum, difference] = half_angles();
                (sum + difference).wrapped()
            }
            "psi" => {
                let [sum, difference] = half_angles();
                (sum - difference).wrapped()
            }
            "theta" => {
                // θ = 2 atan2(√(x² + y²), √(w² + z²))
                let [w, x, y, z] = quaternion();
                x.binary(Binary::Hypot, y).atan2(w.binary(Binary::Hypot, z)).scaled(2.0)
            }
            name => match *name.as_bytes() {
                [b'w', axis @ b'x'..=b'z'] => component(at, at.omega(), axis - b'x'),
                [b'L', axis @ b'x'..=b'z'] => component(at, momentum(), axis - b'x'),
                [b'w', axis @ b'X'..=b'Z'] => at.omega().dot(space_axis(at, axis - b'X')),
                [b'L', axis @ b'X'..=b'Z'] => momentum().dot(space_axis(at, axis - b'X')),
                [b'q', b'w'] => at.attitude().0,
                [b'q', axis @ b'x'..=b'z'] => component(at, at.attitude().1, axis - b'x'),
                // A row of `R_space_body` is an axis of space along body axes.
                [b'r', row @ b'1'..=b'3', column @ b'1'..=b'3'] => {
                    component(at, space_axis(at, row - b'1'), column - b'1')
                }
                _ => at.number(f64::NAN),
            },
        }
    }
}

fn component<I: LawInput>(at: &I, v: I::Vector, axis: u8) -> I::Scalar {
    let [x, y, z] = at.components(v);
    match axis {
        0 => x,
        1 => y,
        _ => z,
    }
}

fn space_axis<I: LawInput>(at: &I, axis: u8) -> I::Vector {
    at.in_space(Direction::from_array([0, 1, 2].map(|k| f64::from(u8::from(k == axis)))))
}
