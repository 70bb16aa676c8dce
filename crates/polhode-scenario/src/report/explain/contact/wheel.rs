//! Step 5 of a wheel that rolls straight down or up a slope.

use polhode::math::{Acceleration, AngularVelocity, Body, Direction, Space};
use polhode::motion::contact::{GroundShape, SurfaceShape};
use polhode::observe::BallOnPlane;
use polhode_document::Section;

use super::{OnGround, ball};

/// Solves a wheel that stands upright on a slope with its axis horizontal; `None` for other
/// motions.
pub(crate) fn solve(g: &OnGround<'_, '_>, s: &mut Section) -> Option<String> {
    let contact = g.contact;
    if !matches!(contact.surface.shape(), SurfaceShape::Rim { thickness: 0.0, .. })
        || !matches!(contact.ground.shape(), GroundShape::Plane)
    {
        return None;
    }
    let e = g.axis()?;
    let roller = straight(g, e)?;
    let axis: Direction<Space> = g.start.state.attitude * e;
    let omega = g.start.state.omega;
    let is_small = |x: f64, size: f64| x.abs() <= 1e-9 * size;
    let upright = is_small(axis.dot(roller.normal), 1.0)
        && is_small(
            (omega - AngularVelocity::from_array((e * e.dot(omega)).to_array())).norm(),
            omega.norm().max(1.0),
        );
    let along_slope = is_small(axis.dot(contact.gravity), contact.gravity.norm());
    // Motion on level ground has its own module.
    if !(upright && along_slope && g.is_rolling() && roller.downhill().norm() > 0.0) {
        return None;
    }
    s.say("It is upright, with its axis level and perpendicular to the slope, and rotates about this axis only, so it remains so. Its motion depends on the ratio of its moment about the axis to m a², with a the height of the centre of mass:");
    s.formula("k = C/(m a²),   σ = k/(1 + k)", r"k = \frac{C}{m a^2}, \qquad \sigma = \frac{k}{1 + k}");
    ball::ratio(&roller, "C", s);
    Some(ball::rolls(g, &roller, s))
}

/// Returns the equivalent ball of a body that rolls with a fixed direction of its axis.
///
/// Its gravity is the component normal to the axis.
pub(crate) fn straight(g: &OnGround<'_, '_>, e: Direction<Body>) -> Option<BallOnPlane> {
    let contact = g.contact;
    let rows = g.w.body().inertia().matrix();
    let image = Direction::<Body>::from_array(rows.map(|row| Direction::<Body>::from_array(row).dot(e)));
    let axis: Direction<Space> = g.start.state.attitude * e;
    let along = Acceleration::from_array((axis * axis.dot(contact.gravity)).to_array());
    Some(BallOnPlane {
        mass: g.w.body().mass(),
        radius: -g.up.dot(g.arm),
        moment: e.dot(image),
        gravity: contact.gravity - along,
        normal: contact.ground.axis(),
        turning: contact.ground.turning(),
    })
}
