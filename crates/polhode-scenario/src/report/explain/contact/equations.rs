//! Steps 3 and 4 on the ground: {I}, also about the point of contact, and the equations of motion
//! with the constraint.

use polhode::math::{Body, Direction};
use polhode_document::Section;
use polhode_document::number::{tidy_beside, tidy_matrix};

use super::super::tensor;
use super::super::working::{exactly, n, v};
use super::{OnGround, constants};

/// Writes step 3.
pub(crate) fn inertia(g: &OnGround<'_, '_>) -> Section {
    let mut s = tensor::section(g.w, None);
    s.say("About the point of contact, by parallel axes; it holds at t0, as r changes:");
    s.formula(
        "{J} = {I} + m (r² 1 − r rᵀ)",
        r"\lbrace \mathbf J \rbrace = \lbrace \mathbf I \rbrace + m (r^2 \text{ 1} - \mathbf r \mathbf r^{\text{T}})",
    );
    let place = g.w.body().center_of_mass() + g.arm;
    s.matrix("{J}", g.w.body().inertia_about(place).matrix(), "kg·m²");
    if g.w.is_turning() || g.start.velocity.norm() > 0.0 {
        let about = constants::about_contact(g);
        let how = if g.is_rolling() && g.contact.ground.turning() == 0.0 { " = {J} ω" } else { "" };
        s.line(format!(
            "L_P = {{I}} ω − r × m v{how} = {} kg·m²/s in body axes, |L_P| = {}",
            v(about.to_array()),
            n(about.norm())
        ));
    }
    s
}

/// Writes step 4.
pub(crate) fn section(g: &OnGround<'_, '_>) -> Section {
    let mut s = Section::new(4, "The equations of motion");
    let resisted = g.is_resisted();
    s.say(
        "Newton's law for the centre of mass, and Euler's equations about it with the torque of the contact:",
    );
    if resisted {
        s.formula(
            "m v\u{307} = m g + N n + F,   {I} ω\u{307} + ω × {I} ω = r × (N n + F) + τ,   τ = −N (µr ω_t/|ω_t| + µp ω_n/|ω_n|)",
            r"m \dot{\mathbf v} = m \mathbf g + N \mathbf n + \mathbf F, \qquad \lbrace \mathbf I \rbrace \dot{\boldsymbol\omega} + \boldsymbol\omega \times \lbrace \mathbf I \rbrace \boldsymbol\omega = \mathbf r \times (N \mathbf n + \mathbf F) + \boldsymbol\tau, \qquad \boldsymbol\tau = -N \left(\mu_r \frac{\boldsymbol\omega_t}{|\boldsymbol\omega_t|} + \mu_p \frac{\boldsymbol\omega_n}{|\boldsymbol\omega_n|}\right)",
        );
        s.say("τ resists rolling and pivoting: ω_t is the turning along the ground, ω_n that about n, both relative to the ground.");
        let resistance = g.contact.law.resistance();
        s.line(format!("µr = {} m,  µp = {} m", n(resistance.rolling), n(resistance.pivoting)));
    } else {
        s.formula(
            "m v\u{307} = m g + N n + F,   {I} ω\u{307} + ω × {I} ω = r × (N n + F)",
            r"m \dot{\mathbf v} = m \mathbf g + N \mathbf n + \mathbf F, \qquad \lbrace \mathbf I \rbrace \dot{\boldsymbol\omega} + \boldsymbol\omega \times \lbrace \mathbf I \rbrace \boldsymbol\omega = \mathbf r \times (N \mathbf n + \mathbf F)",
        );
    }
    s.say("N and F are unknown. The missing equation is the constraint, differentiated once.");
    if g.is_rolling() {
        rolling(g, &mut s);
    } else {
        sliding(g, &mut s);
    }
    let start = &g.start;
    let l = g.w.rotor.angular_momentum(start.state.omega);
    let gyroscopic = start.state.omega.cross(l);
    let scale = start.torque.norm().max(gyroscopic.norm());
    s.say("With the numbers at t0, in body axes:");
    let (torque, blank) =
        if resisted { ("r × (N n + F) + τ", "        ") } else { ("r × (N n + F)", "    ") };
    s.line(format!("{torque} = {} N·m", exactly(tidy_beside(start.torque.to_array(), scale))));
    s.line(format!("ω × {{I}} ω{blank} = {} N·m", exactly(tidy_beside(gyroscopic.to_array(), scale))));
    s.line(format!(
        "ω\u{307} = {{I}}⁻¹ [torque − ω × {{I}} ω] = {} rad/s²",
        exactly(tidy_beside(g.w.acceleration.to_array(), g.w.acceleration.norm()))
    ));
    let force = Direction::from_array(start.friction.to_array()) + start.normal * start.normal_force;
    let gravity = Direction::from_array(g.contact.gravity.to_array());
    let acceleration = gravity + force * (1.0 / g.w.body().mass());
    s.line(format!(
        "v\u{307} = g + (N n + F)/m = {} m/s² in space axes",
        exactly(tidy_beside(acceleration.to_array(), g.contact.gravity.norm()))
    ));
    constants::list(g, &mut s);
    s
}

fn rolling(g: &OnGround<'_, '_>, s: &mut Section) {
    s.say("Rolling, v = w − ω × r for all time, so v\u{307} follows from ω\u{307}; put into Newton's law it gives N n + F, and with that Euler's equations have no unknown force:");
    if g.contact.ground.turning() == 0.0 {
        s.formula(
            "{J} ω\u{307} = −ω × {I} ω − m r × [g + ω × (ω × r + r\u{307})]",
            r"\lbrace \mathbf J \rbrace \dot{\boldsymbol\omega} = -\boldsymbol\omega \times \lbrace \mathbf I \rbrace \boldsymbol\omega - m \mathbf r \times \left[\mathbf g + \boldsymbol\omega \times (\boldsymbol\omega \times \mathbf r + \dot{\mathbf r})\right]",
        );
    } else {
        s.formula(
            "{J} ω\u{307} = −ω × {I} ω − m r × [g + ω × (ω × r + r\u{307}) − Ω × s]",
            r"\lbrace \mathbf J \rbrace \dot{\boldsymbol\omega} = -\boldsymbol\omega \times \lbrace \mathbf I \rbrace \boldsymbol\omega - m \mathbf r \times \left[\mathbf g + \boldsymbol\omega \times (\boldsymbol\omega \times \mathbf r + \dot{\mathbf r}) - \boldsymbol\Omega \times \mathbf s\right]",
        );
    }
    s.say("It is the same as L about P, where the force has no torque. But P moves over the ground at s, and so there is a term more than about a fixed point:");
    s.formula(
        "L_P = {I} ω − r × m v,   dL_P/dt = −r × m g − s × m v",
        r"\mathbf L_P = \lbrace \mathbf I \rbrace \boldsymbol\omega - \mathbf r \times m \mathbf v, \qquad \frac{d\mathbf L_P}{dt} = -\mathbf r \times m \mathbf g - \mathbf s \times m \mathbf v",
    );
    let [arm, weight] = [g.arm.to_array(), (g.contact.gravity * g.w.body().mass()).to_array()];
    let weight = g.start.state.attitude.inverse() * super::direction(weight);
    let torque = -Direction::<Body>::from_array(arm).cross(weight);
    s.line(format!(
        "−r × m g = {} N·m in body axes",
        v(tidy_beside(torque.to_array(), g.arm.norm() * weight.norm()))
    ));
}

fn sliding(g: &OnGround<'_, '_>, s: &mut Section) {
    s.say("P stays on the ground while it slips: d/dt [(v + ω × r) · n] = 0 is linear in N, as v\u{307} and ω\u{307} are, with F = −µ N û in them.");
    s.formula(
        "N [ 1/m + n · ({I}⁻¹ (r × f) × r) ] = −n · (g + ω\u{307}₀ × r + ω × (ω × r + r\u{307})),   f = n − µ û,   {I} ω\u{307}₀ = −ω × {I} ω",
        r"N \left[\frac{1}{m} + \mathbf n \cdot \left(\lbrace \mathbf I \rbrace^{-1} (\mathbf r \times \mathbf f) \times \mathbf r\right)\right] = -\mathbf n \cdot \left(\mathbf g + \dot{\boldsymbol\omega}_0 \times \mathbf r + \boldsymbol\omega \times (\boldsymbol\omega \times \mathbf r + \dot{\mathbf r})\right), \qquad \mathbf f = \mathbf n - \mu \hat{\mathbf u}, \qquad \lbrace \mathbf I \rbrace \dot{\boldsymbol\omega}_0 = -\boldsymbol\omega \times \lbrace \mathbf I \rbrace \boldsymbol\omega",
    );
    s.line(format!("N = {} N", n(g.start.normal_force)));
    let m = tidy_matrix(g.w.rotor.inertia().matrix());
    let is_ball = m[0][0] == m[1][1] && m[1][1] == m[2][2];
    if !is_ball && !g.is_frictionless() {
        s.say("N is not the weight: the centre of mass rises and falls.");
    }
}
