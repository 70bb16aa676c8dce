//! States of a free body and their derivatives. (Stands in for the closed form's own derivatives.)

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{AngularVelocity, Attitude, Body, Direction, Position, Rotation};
use polhode::motion::{FreeMotion, Rotor, State};

use crate::error::IdentifyError;

/// A state with its derivatives: rows θ1 θ2 θ3 ω1 ω2 ω3 (attitude = R exp θ), columns the elements of the tensor, and ω at the reference.
pub(crate) struct Derived {
    pub(crate) state: State,
    pub(crate) by_tensor: [[f64; 6]; 6],
    pub(crate) by_omega: [[f64; 3]; 6],
    pub(crate) by_attitude: [[f64; 3]; 6],
}

fn motion(tensor: &[f64; 6], start: State) -> Result<FreeMotion, IdentifyError> {
    let [xx, yy, zz, xy, xz, yz] = *tensor;
    let tensor = InertiaTensor::from_matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])?;
    let body = MassProperties::new(1.0, Position::ZERO, tensor)?;
    Ok(FreeMotion::of(&Rotor::free(&body), start)?)
}

/// At each of the times.
pub(crate) fn derived(tensor: &[f64; 6], start: State, times: &[f64]) -> Result<Vec<Derived>, IdentifyError> {
    let here = motion(tensor, start)?;
    let trace = tensor[0] + tensor[1] + tensor[2];
    let rate = start.omega.norm().max(1e-3);
    let mut pairs = Vec::new();
    for k in 0..9 {
        let h = 1e-6 * if k < 6 { trace } else { rate };
        let moved = |sign: f64| {
            let (mut tensor, mut omega) = (*tensor, start.omega.to_array());
            if k < 6 {
                tensor[k] += sign * h
            } else {
                omega[k - 6] += sign * h
            }
            motion(&tensor, State { omega: AngularVelocity::from_array(omega), ..start })
        };
        match (moved(1.0), moved(-1.0)) {
            (Ok(a), Ok(b)) => pairs.push((a, b, 2.0 * h)),
            (Ok(a), Err(_)) => pairs.push((a, here, h)),
            (Err(_), Ok(b)) => pairs.push((here, b, h)),
            (Err(e), Err(_)) => return Err(e),
        }
    }
    Ok(times
        .iter()
        .map(|&t| {
            let state = here.at(t);
            let (mut by_tensor, mut by_omega, mut by_attitude) =
                ([[0.0; 6]; 6], [[0.0; 3]; 6], [[0.0; 3]; 6]);
            for (k, (a, b, h)) in pairs.iter().enumerate() {
                let (a, b) = (a.at(t), b.at(t));
                let turn = |s: &State| (state.attitude.inverse() * s.attitude).log().to_array();
                let (ta, tb) = (turn(&a), turn(&b));
                let (wa, wb) = (a.omega.to_array(), b.omega.to_array());
                for i in 0..3 {
                    let (up, down) = ((ta[i] - tb[i]) / h, (wa[i] - wb[i]) / h);
                    if k < 6 {
                        by_tensor[i][k] = up;
                        by_tensor[3 + i][k] = down;
                    } else {
                        by_omega[i][k - 6] = up;
                        by_omega[3 + i][k - 6] = down;
                    }
                }
            }
            // R0 exp(θ0) (R0⁻¹ R) = R exp(R⁻¹ R0 θ0)
            let back: Rotation<Body, Body> = state.attitude.inverse() * start.attitude;
            for (k, row) in back.matrix().iter().enumerate() {
                by_attitude[k] = *row;
            }
            Derived { state, by_tensor, by_omega, by_attitude }
        })
        .collect())
}

/// R exp(θ)
pub(crate) fn turned(attitude: Attitude, theta: [f64; 3]) -> Attitude {
    attitude * turn(theta)
}

/// exp(θ); where θ is not finite none, which a step that far does not get.
pub(crate) fn turn(theta: [f64; 3]) -> Rotation<Body, Body> {
    Rotation::exp(Direction::from_array(theta)).unwrap_or_else(|_| Rotation::identity())
}

/// The state at another time.
pub(crate) fn state_at(tensor: &[f64; 6], start: State, time: f64) -> Result<State, IdentifyError> {
    Ok(motion(tensor, start)?.at(time))
}
