//! Dummy links, such as the frame of an IMU or a fingertip. Their mass properties are invented and
//! have no effect.

use super::body::Body;
use super::tree::Tree;

/// Upper bound on the mass of frames that have a mass only because a simulator requires one, kg.
pub(super) const FRAME: f64 = 1e-3;

/// Moments below this fraction of the moments of the fixed group are negligible.
const NOT_FELT: f64 = 0.01;

/// Attachment of a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Held {
    /// Moved by a joint, or the first link of its group.
    Free,
    /// Attached by a fixed joint.
    Fixed,
    /// Attached by a fixed joint, with negligible mass and moments compared with its group.
    Dummy,
}

/// Returns the attachment of each link. `bodies` are the bodies of the model.
pub(super) fn held(tree: &Tree, bodies: &[Option<Body>]) -> Vec<Held> {
    let moment =
        |k: usize| bodies.get(k).and_then(Option::as_ref).map_or(0.0, |body| body.moments.values[2].max(0.0));
    let mut of_group = vec![0.0; bodies.len()];
    for k in 0..bodies.len() {
        if let Some(sum) = of_group.get_mut(tree.group(k)) {
            *sum += moment(k);
        }
    }
    let held = |k: usize| {
        if !tree.is_carried(k) {
            return Held::Free;
        }
        let others = of_group.get(tree.group(k)).map_or(0.0, |sum| sum - moment(k));
        let is_light = bodies.get(k).and_then(Option::as_ref).is_some_and(|body| body.mass <= FRAME);
        if is_light && moment(k) <= NOT_FELT * others { Held::Dummy } else { Held::Fixed }
    };
    (0..bodies.len()).map(held).collect()
}
