//! Wrong tensors.

use polhode::infer::judge::Cause;
use polhode::prelude::*;

use super::program::*;
use super::scene::*;

#[test]
fn wrong_tensors() {
    let principal = body().principal();
    let axes: M = principal.axes().map(Direction::to_array);
    let [a, b, c] = principal.moments();
    let diagonal = [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]];
    // The right tensor is axesᵀ D axes: the rows of `axes` are the principal axes.
    let transposed_one = product(&axes, &product(&diagonal, &transposed(&axes)));
    let reversed = [axes[2], axes[0].map(|c| -c), axes[1]];
    let reversed =
        product(&reversed, &product(&[[c, 0.0, 0.0], [0.0, a, 0.0], [0.0, 0.0, b]], &transposed(&reversed)));
    let [x, y, z] = CENTER;
    let r2 = x * x + y * y + z * z;
    let moved = |k: usize, l: usize| MASS * (if k == l { r2 } else { 0.0 } - CENTER[k] * CENTER[l]);
    let about_origin = [0, 1, 2].map(|k| [0, 1, 2].map(|l| tensor(MOMENTS, PRODUCTS)[k][l] + moved(k, l)));
    let [p, q, r] = PRODUCTS;
    type Named = fn(&Cause) -> bool;
    let cases: [(M, Named); 7] = [
        (transposed_one, |c| *c == Cause::TensorTransposed),
        (reversed, |c| *c == Cause::TensorTransposed),
        (diagonal, |c| *c == Cause::PrincipalMomentsAlongBodyAxes([0, 1, 2])),
        (tensor(MOMENTS, [-p, -q, -r]), |c| *c == Cause::ProductsReversed),
        (tensor(MOMENTS, [0.0; 3]), |c| *c == Cause::ProductsLeftOut),
        (tensor(MOMENTS, [r, q, p]), |c| *c == Cause::ProductsReordered([2, 1, 0])),
        (about_origin, |c| *c == Cause::TensorAboutOrigin),
    ];
    for (tensor, is_it) in cases {
        require_named(&free(), &Equations { tensor, ..right() }.log(), 0.005, is_it);
        require_named(&driven(), &Equations { tensor, ..right_driven() }.log(), 0.005, is_it);
    }
}

#[test]
fn the_tensor_of_another_body() {
    let tensor = tensor([1.6, 1.9, 2.6], [-0.1, -0.2, 0.3]);
    for (scenario, right, scale) in [(free(), right(), false), (driven(), right_driven(), true)] {
        let log = Equations { tensor, ..right }.log();
        require_named(&scenario, &log, 0.005, |cause| {
            let Cause::OtherTensor { tensor: found, has_scale } = cause else { return false };
            let times = if scale { 1.0 } else { 6.3 / 6.1 };
            let error = (0..3)
                .flat_map(|k| (0..3).map(move |l| (k, l)))
                .map(|(k, l)| (found[k][l] / times - tensor[k][l]).abs());
            // If ω is from differences of the attitudes, its accuracy is the square of the spacing.
            *has_scale == scale && error.fold(0.0, f64::max) < 0.03
        });
    }
}

/// Half a per cent, with rows far apart: the fit of the motion finds it with and without ω, and
/// more accurately than differences of rows.
#[test]
fn the_tensor_of_a_body_that_is_a_little_different() {
    let tensor = tensor([1.305, 2.094, 2.912], [0.248, -0.353, 0.1512]);
    for (scenario, right, scale) in [(free(), right(), false), (driven(), right_driven(), true)] {
        let log: Vec<_> = Equations { tensor, ..right }.log().into_iter().step_by(4).collect();
        require_named(&scenario, &log, 0.005, |cause| {
            let Cause::OtherTensor { tensor: found, .. } = cause else { return false };
            let times = if scale { 1.0 } else { 6.3 / 6.311 };
            let error = (0..3)
                .flat_map(|k| (0..3).map(move |l| (k, l)))
                .map(|(k, l)| (found[k][l] / times - tensor[k][l]).abs());
            error.fold(0.0, f64::max) < 1e-5
        });
    }
}

fn pivoted_torque(q: Q) -> V {
    let weight = to_body(q, [0.0, 0.0, -9.80665 * MASS]);
    cross(CENTER, weight)
}

#[test]
fn the_tensor_about_the_wrong_point_of_a_top() {
    let top = free().held_at(Position::ZERO).unwrap();
    let top = top.with_torques([TorqueModel::Gravity(UniformGravity::STANDARD)]).unwrap();
    let log = Equations { torque: pivoted_torque, ..right() }.log();
    require_named(&top, &log, 0.005, |c| *c == Cause::TensorAboutCenterOfMass);
}
