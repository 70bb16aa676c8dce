//! A body with wheels or friction inside: its equations, which are not those of the steps for one rigid body.

use polhode::{Scenario, TorqueModel};

use super::document::{Document, Section};
use crate::torque::Description;

/// The equations, if something moves inside the body; the steps of the notes would leave it out.
pub(super) fn solved(scenario: &Scenario) -> Option<Document> {
    let sinks = scenario.torques.iter().filter(|torque| matches!(torque, TorqueModel::EnergySink(_)));
    let sinks: Vec<String> = sinks.map(|sink| Description::of(sink).text()).collect();
    if scenario.wheels.is_empty() && sinks.is_empty() {
        return None;
    }
    let mut section = Section::new(1, "What moves inside");
    for wheel in &scenario.wheels {
        section.say(format!("Inside is {}.", Description::of_wheel(wheel).text()));
    }
    for sink in &sinks {
        section.say(format!("Inside is {sink}."));
    }
    section.say(
        "h is the angular momentum of the wheels, I the inertia tensor without what wheels with a motor have about their axes, and α the \
         coefficient of the energy sink. In body axes, which turn at Ω:",
    );
    section.formula(
        "L = {I} ω + h,   Ω = ω + α L × ω,   {I} dω/dt = L × Ω + N − dh/dt",
        r"\mathbf L = \lbrace \mathbf I \rbrace \cdot \boldsymbol\omega + \mathbf h, \qquad \boldsymbol\Omega = \boldsymbol\omega + \alpha\, \mathbf L \times \boldsymbol\omega, \qquad \lbrace \mathbf I \rbrace \cdot \dot{\boldsymbol\omega} = \mathbf L \times \boldsymbol\Omega + \mathbf N - \dot{\mathbf h}",
    );
    section.say("Without a torque N from outside L is constant in space; the kinetic energy changes as motors work and friction heats.");
    let answer = "The steps of the notes are those of one rigid body. In this one something moves inside: here are its equations; \
                  simulate computes its motion, and stability says which of its steady motions last.";
    Some(Document {
        title: scenario.title.clone().unwrap_or_else(|| "A rigid body".to_owned()),
        answer: vec![answer.to_owned()],
        sections: vec![section],
    })
}
