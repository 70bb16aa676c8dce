//! Data of a page, in the format of `viewer/src/data.ts`.

use serde_json::{Value, json};

use super::motion::Shown;
use super::rows::Rows;
use super::shapes::{self, Budget};
use super::turning::Turning;
use super::{PageInput, PageSubject, body, contact, explanation, facts, free, motion, scene, top};
use crate::report::facts::Known;
use crate::report::motion::findings as motion_findings;

/// Target size of a page with a large mesh, bytes.
const PAGE: usize = 2_000_000;

/// Size that a mesh may have on any page, bytes.
const LEAST_MESH: usize = 240_000;

/// Limit on the size of meshes.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Room {
    /// Remainder of [`PAGE`]; the argument is the size of the page without data, bytes.
    Beside(usize),
    /// Fixed size, bytes.
    Of(usize),
}

/// Returns the data of a page.
pub(crate) fn json(input: &PageInput<'_>, room: Room, rows: &mut Rows) -> Value {
    let turning = Turning::of(&input.subject);
    let shown = Shown::of(input.trajectory, &input.subject);
    let free_facts = free::facts(input);
    let contact = contact::json(input.trajectory, &input.subject, &shown, rows);
    let motion = motion::json(&shown, &contact, rows);
    let free = free_facts.as_ref().map_or(Value::Null, |free| free::json(free, &shown, input.whole, rows));
    let explanation = input.explanation.map_or_else(|| json!([]), explanation::page_blocks);
    let mut left = match room {
        Room::Beside(_) => LEAST_MESH,
        Room::Of(bytes) => bytes,
    };
    if let (true, Room::Beside(frame)) = (input.whole && shapes::has_triangles(&turning), room) {
        let others =
            [&motion, &free, &explanation].map(|value| value.to_string().len()).iter().sum::<usize>()
                + input.scenario_text.map_or(0, str::len)
                + rows.beside();
        left = left.max(PAGE.saturating_sub(frame + others));
    }
    let mut budget = Budget::new(left);
    let body = body::json(&turning, input.whole.then_some(&mut budget));
    let known = match input.subject {
        PageSubject::Scenario(scenario) => Known::of(scenario, input.trajectory),
        PageSubject::Moments(principal) => Known::of_moments(principal, free_facts, input.trajectory),
    };
    json!({
        "version": 1,
        "title": input.title,
        "source": input.source,
        "scenario": input.scenario_text,
        "body": body,
        "motion": motion,
        "free": free,
        "scene": scene::json(&known, free_facts.as_ref()),
        "top": top::json(&input.subject),
        "facts": facts::json(&known, &turning, &shown, budget.notes()),
        "findings": findings(input),
        "explanation": explanation,
    })
}

fn findings(input: &PageInput<'_>) -> Value {
    let PageSubject::Scenario(scenario) = input.subject else { return json!([]) };
    let one = |f: &polhode::body::Finding| {
        let place = f.place.as_ref().map_or_else(String::new, |place| format!(" ({place})"));
        json!({ "severity": f.severity.name(), "message": format!("{}{place}", f.message) })
    };
    motion_findings(scenario, input.trajectory).iter().map(one).collect()
}
