//! Step 5 of an ellipsoid: a rattleback, an egg, or another body that spins on a point below its
//! centre of mass.

use polhode::observe::{SpinningEgg, SteadyPath};
use polhode_document::Section;

use super::{OnGround, egg, rattleback, unsolved, vertex};

pub(crate) fn solve(g: &OnGround<'_, '_>, s: &mut Section) -> Option<String> {
    let steady = g.steady(&g.rolling_start());
    let vertex = steady.as_ref().and_then(|steady| match steady.path {
        SteadyPath::OnVertex(vertex) => Some(vertex),
        _ => None,
    });
    if let (Some(steady), Some(vertex)) = (&steady, &vertex)
        && let Some(rattle) = vertex.rattleback()
    {
        return Some(rattleback::solve(g, steady, vertex, &rattle, s));
    }
    if let Some((egg, axis)) = SpinningEgg::of(g.w.body(), g.contact) {
        return egg::solve(g, &egg, axis, s);
    }
    match (&steady, &vertex) {
        (Some(steady), Some(vertex)) => Some(vertex::stands(g, steady, vertex, s)),
        _ => {
            unsolved(g, s);
            None
        }
    }
}
