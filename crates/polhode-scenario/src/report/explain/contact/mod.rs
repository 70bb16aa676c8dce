//! Worked solution of a body on the ground, in the same six steps.
//!
//! They are: contact, constraint and forces, {I}, equations of motion, their solutions, and the
//! computed run.
//!
//! Each kind of body with a closed form or another known law has its own module.

mod ball;
mod bowl;
mod constants;
mod cylinder;
mod disk;
mod egg;
mod ellipsoid;
mod equations;
mod rattleback;
mod run;
mod setting;
mod tippe_top;
mod vertex;
mod wheel;

use polhode::math::{AngularVelocity, Body, Direction, Position, Space};
use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{
    Contact, ContactLaw, ContactPhase, ContactStart, ContactState, Friction, Grip, GroundShape,
    StartVelocity, SurfaceShape,
};
use polhode::motion::{GroundContact, Trajectory};
use polhode::observe::{BallOnPlane, CirclingDisk, SteadyOnGround, TippeTop};
use polhode_document::{Document, Section};

use super::working::Working;
use super::{answer, body};

/// Scenario on the ground: its solution, contact and initial state.
struct OnGround<'a, 'b> {
    w: &'a Working<'b>,
    ground: &'a GroundContact,
    contact: &'a Contact,
    start: ContactState,
    /// Ground normal n, body axes.
    up: Direction<Body>,
    /// Vector from the centre of mass to the point of contact, m.
    arm: Position<Body>,
}

/// Returns the solution of a body on the ground; `None` for any other.
pub(crate) fn document(w: &Working<'_>) -> Option<Document> {
    let g = OnGround::of(w)?;
    let mut solved = Section::new(5, "Solve for the motion");
    let mut answer = vec![answer::body(w)];
    answer.extend(solve(&g, &mut solved));
    Some(Document {
        findings: w.findings(),
        title: w.title(),
        verdict: None,
        answer,
        sections: vec![
            body::section(w),
            setting::axes(&g),
            setting::forces(&g),
            equations::inertia(&g),
            equations::section(&g),
            solved,
            run::section(&g),
        ],
    })
}

/// Writes step 5, by the kind of body; returns the answer in a sentence.
fn solve(g: &OnGround<'_, '_>, s: &mut Section) -> Option<String> {
    let (body, contact) = (g.w.body(), &g.ground.contact);
    if let Some(ball) = BallOnPlane::of(body, contact) {
        return Some(ball::solve(g, &ball, s));
    }
    if let Some(answer) = wheel::solve(g, s) {
        return Some(answer);
    }
    if let Some((disk, axis)) = CirclingDisk::of(body, contact, g.up) {
        return disk::solve(g, &disk, axis, s);
    }
    if let Some((top, axis)) = TippeTop::of(body, contact) {
        return Some(tippe_top::solve(g, &top, axis, s));
    }
    match contact.surface.shape() {
        SurfaceShape::Cylinder { .. } => cylinder::solve(g, s),
        SurfaceShape::Ellipsoid { .. } => ellipsoid::solve(g, s),
        _ => bowl::solve(g, s).or_else(|| {
            unsolved(g, s);
            None
        }),
    }
}

/// Writes general statements for a motion without a known formula.
fn unsolved(g: &OnGround<'_, '_>, s: &mut Section) {
    s.say(
        "No closed form is known for this body on this ground: the equations of step 4 are integrated (step 6). Without integration, only the constants of step 4 are known.",
    );
    if matches!(g.ground.contact.ground.shape(), GroundShape::Plane) && g.is_rolling() && g.axis().is_some() {
        s.say(
            "A symmetric body that rolls on level ground has two constants more, linear in ω, as Chaplygin found (1897): but of most surfaces they are solutions of a linear equation of the \
             second order in cos θ, no formulas.",
        );
    }
}

impl<'a, 'b> OnGround<'a, 'b> {
    fn of(w: &'a Working<'b>) -> Option<Self> {
        let (ground, start) = (w.scenario.ground()?, w.contact?);
        let up = start.state.attitude.inverse() * start.normal;
        let arm = start.contact_in_body - w.body().center_of_mass();
        Some(Self { w, ground, contact: &ground.contact, start, up, arm })
    }

    fn motion(&self) -> Option<&Trajectory> {
        self.w.trajectory.as_deref()
    }

    /// Returns the contact at the end of the run.
    fn last(&self) -> Option<ContactState> {
        self.motion()?.channel(CONTACT)?.last()
    }

    /// Returns the friction law; the default, without friction, if the contact never slips.
    fn friction(&self) -> Friction {
        match *self.contact.law.grip() {
            Grip::Friction(friction) => friction,
            _ => Friction::default(),
        }
    }

    fn is_rolling(&self) -> bool {
        self.start.phase == ContactPhase::Rolling
    }

    fn is_frictionless(&self) -> bool {
        matches!(*self.contact.law.grip(), Grip::Friction(friction) if friction == Friction::default())
    }

    /// True if torques resist rolling or pivoting.
    fn is_resisted(&self) -> bool {
        let resistance = self.contact.law.resistance();
        resistance.rolling > 0.0 || resistance.pivoting > 0.0
    }

    fn axis(&self) -> Option<Direction<Body>> {
        self.contact.symmetry_axis(self.w.body())
    }

    /// Returns the contact without rolling and pivoting resistance.
    fn unresisted(&self) -> Contact {
        let law = match *self.contact.law.grip() {
            Grip::Friction(friction) => ContactLaw::with_friction(friction).unwrap_or(ContactLaw::ROLLING),
            _ => ContactLaw::ROLLING,
        };
        Contact { law, ..*self.contact }
    }

    /// Returns the steady motion near a start, ignoring resistance.
    fn steady(&self, start: &ContactStart) -> Option<SteadyOnGround> {
        SteadyOnGround::near(self.w.body(), &self.unresisted(), start).ok()
    }

    /// Returns the start with the velocity of rolling, for the steady motion that the body may
    /// approach.
    fn rolling_start(&self) -> ContactStart {
        ContactStart { state: self.start.state, at: self.ground.at, velocity: StartVelocity::Rolling }
    }
}

/// Returns a vector with these components, for a change of frame or quantity.
fn direction(components: [f64; 3]) -> Direction<Space> {
    Direction::from_array(components)
}

/// Returns the component of ω along an axis, rad/s.
fn about(omega: AngularVelocity<Body>, axis: Direction<Body>) -> f64 {
    axis.dot(omega)
}
