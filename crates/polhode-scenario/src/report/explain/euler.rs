//! Step 4: Euler's equations.

use polhode::body::{Particle, Symmetry};
use polhode::math::{Body, Principal, Torque, Vector};
use polhode::motion::ParticleForce;
use polhode_document::Section;
use polhode_document::number::{tidy, tidy_beside};

use super::body::numbered;
use super::symbols;
use super::working::{Working, cells, exactly, factor, n, v};
use crate::report::forces;

/// Largest number of particles whose forces are listed.
const MOST_PARTICLES: usize = 12;

pub(crate) fn section(w: &Working<'_>) -> Section {
    let mut s = Section::new(4, "Euler's equations");
    if w.rotor.principal().symmetry() == Symmetry::Point {
        s.say("Without inertia they say only N = 0.");
        return s;
    }
    s.say(
        "N = dL/dt holds in space axes. In the rotating body axes it becomes N = {I} ω\u{307} + ω × L; along the principal axes, these are Euler's equations:",
    );
    s.formula(
        "N1 = i1 ω\u{307}1 − (i2 − i3) ω2 ω3\n\
         N2 = i2 ω\u{307}2 − (i3 − i1) ω3 ω1\n\
         N3 = i3 ω\u{307}3 − (i1 − i2) ω1 ω2",
        "\\begin{aligned}\nN_1 &= i_1 \\dot\\omega_1 - (i_2 - i_3) \\omega_2 \\omega_3 \\cr\nN_2 &= i_2 \\dot\\omega_2 - (i_3 - i_1) \\omega_3 \\omega_1 \\cr\nN_3 &= i_3 \\dot\\omega_3 - (i_1 - i_2) \\omega_1 \\omega_2\n\\end{aligned}",
    );
    if let Some(symbolic) = w.exact.symbols() {
        match &w.needed {
            Some(_) => symbols::needed(symbolic, w.torque.to_array(), &mut s),
            None => symbols::euler(symbolic, &mut s),
        }
    }
    if w.needed.is_some() {
        torque_needed(w, &mut s);
    } else {
        acceleration(w, &mut s);
    }
    condition(w, &mut s);
    if w.needed.is_some() {
        particles(w, &mut s);
    }
    s
}

/// Index triples (k, a, b) of the three equations: component k, and the two components in its
/// product.
const CYCLES: [(usize, usize, usize); 3] = [(0, 1, 2), (1, 2, 0), (2, 0, 1)];

/// Writes the angular acceleration that follows from the torque.
fn acceleration(w: &Working<'_>, s: &mut Section) {
    if !w.is_turning() && w.torque.norm() == 0.0 {
        s.say("With ω = 0 and N = 0 they give ω\u{307} = 0.");
        return;
    }
    let principal = w.rotor.principal();
    let into = principal.rotation().inverse();
    let (omega, torque) = ((into * w.start.omega).to_array(), tidy((into * w.torque).to_array()));
    let rate = (into * w.acceleration).to_array();
    let i = principal.moments();
    let scale = largest_rate(w);
    let rate = tidy_beside(rate, scale);
    s.say("At t0, along the principal axes:");
    // A small component across a principal axis is kept, unless it is rounding of the change of
    // axes.
    let omega = tidy_beside(omega, 0.1 * w.start.omega.norm());
    s.line(format!("ω  = {} rad/s", exactly(omega)));
    s.line(format!("N  = {} N·m", v(torque)));
    for (k, a, b) in CYCLES {
        let name = k + 1;
        let numerator = format!(
            "({} - {})·{}·{} + {}",
            n(i[a]),
            n(i[b]),
            factor(omega[a]),
            factor(omega[b]),
            factor(torque[k])
        );
        if i[k] == 0.0 {
            s.line(format!(
                "ω\u{307}{name}: no inertia about axis {name}, so its rate is undetermined; taken as 0"
            ));
        } else {
            let quotient = format!("[{numerator}] / {}", n(i[k]));
            s.sum(&format!("ω\u{307}{name}"), &[quotient], &format!("{} rad/s²", n(rate[k])));
        }
    }
    s.line(format!("ω\u{307}  = {} rad/s² in body axes", v(tidy_beside(w.acceleration.to_array(), scale))));
}

/// Returns the largest possible angular acceleration, rad/s²; rounding errors relative to it are
/// set to 0.
fn largest_rate(w: &Working<'_>) -> f64 {
    let [_, _, i3] = w.rotor.principal().moments();
    let omega = w.start.omega.norm();
    (omega * omega).max(w.torque.norm() / i3)
}

/// Writes the torque that the given motion needs.
fn torque_needed(w: &Working<'_>, s: &mut Section) {
    let Some(needed) = &w.needed else { return };
    let principal = w.rotor.principal();
    let into = principal.rotation().inverse();
    let (omega, rate) = ((into * needed.state.omega).to_array(), (into * needed.acceleration).to_array());
    let torque: Vector<_, Principal> = into * needed.torque;
    let scale = largest_torque(w);
    let torque = tidy_beside(torque.to_array(), scale);
    let i = principal.moments();
    s.say("At t0, along the principal axes:");
    s.line(format!("ω  = {} rad/s", v(omega)));
    s.line(format!("ω\u{307}  = {} rad/s²", v(rate)));
    for (k, a, b) in CYCLES {
        let [wa, wb] = [a, b].map(|j| factor(tidy(omega)[j]));
        let terms = format!("{}·{} - ({} - {})·{wa}·{wb}", n(i[k]), factor(rate[k]), n(i[a]), n(i[b]));
        s.sum(&format!("N{}", k + 1), &[terms], &format!("{} N·m", n(torque[k])));
    }
    s.say(format!("The torque required for this motion, about {}, back in body axes:", w.point_name()));
    let body = tidy_beside(needed.torque.to_array(), scale);
    s.line(format!("N = {} N·m,  |N| = {} N·m", exactly(body), n(needed.torque.norm())));
    if w.start.attitude != polhode::math::Attitude::identity() {
        let space = (w.start.attitude * needed.torque).to_array();
        s.line(format!("  = {} N·m in space axes", exactly(tidy_beside(space, scale))));
    }
    s.line(format!(
        "power N · ω = {} W",
        n(tidy_beside([needed.power, 0.0, 0.0], scale * w.start.omega.norm())[0])
    ));
}

/// Returns the largest possible torque, N·m; rounding errors relative to it are set to 0.
fn largest_torque(w: &Working<'_>) -> f64 {
    let [_, _, i3] = w.rotor.principal().moments();
    let omega = w.start.omega.norm();
    i3 * (omega * omega).max(w.acceleration.norm())
}

/// Writes whether N = {I} ω̇ is valid, from the size of ω × L.
fn condition(w: &Working<'_>, s: &mut Section) {
    if !w.is_turning() {
        return;
    }
    let gyroscopic: Torque<_> = w.start.omega.cross(w.rotor.angular_momentum(w.start.omega));
    let size = gyroscopic.norm();
    let scale = w.start.omega.norm() * w.rotor.angular_momentum(w.start.omega).norm();
    if size <= 1e-14 * scale {
        s.say(
            "Here ω × L = 0 at t0 (ω lies along a principal axis), so N = {I} ω\u{307} holds; it does only then, or in axes \
             that do not turn.",
        );
    } else {
        s.say(format!(
            "The simplified equation N = {{I}} ω\u{307} holds only where ω × L = 0, that is with ω along a principal axis. Here \
             |ω×L| = {} N·m, so it would be wrong.",
            n(size)
        ));
    }
}

/// Writes the forces on the particles that produce the torque.
fn particles(w: &Working<'_>, s: &mut Section) {
    let Some(needed) = &w.needed else { return };
    let forces = forces::on_particles(w.scenario, needed);
    if forces.is_empty() || forces.len() > MOST_PARTICLES {
        return;
    }
    s.say("The forces: each particle needs the force that gives it its acceleration:");
    s.formula(
        "Fα = mα [ ω\u{307} × rα + ω × (ω × rα) ]",
        r"\mathbf F_\alpha = m_\alpha \left[ \dot{\boldsymbol\omega} \times \mathbf r_\alpha + \boldsymbol\omega \times (\boldsymbol\omega \times \mathbf r_\alpha) \right]",
    );
    for (k, f) in forces.iter().enumerate() {
        s.line(format!("F{} = {} N", k + 1, v(f.force.to_array())));
    }
    s.say(
        "Components along rα and perpendicular to it: the parallel component (negative: tension toward the origin) has no torque; the perpendicular component produces the whole torque.",
    );
    let row = |(f, p): (&ParticleForce, &Particle<Body>)| {
        let scale = f.force.norm();
        let outward = (p.position() - w.point()).dot(f.along);
        let along = f.along.norm().copysign(outward);
        let [x, y, z] = tidy_beside(f.across.to_array(), scale);
        vec![tidy_beside([along, 0.0, 0.0], scale)[0], x, y, z]
    };
    let rows: Vec<Vec<f64>> = forces.iter().zip(&w.scenario.particles()).map(row).collect();
    let headers = ["α", "along r (N)", "across x (N)", "across y (N)", "across z (N)"];
    s.table(&headers, numbered(cells(&rows)));
    let largest = forces.iter().map(|f| f.torque.norm()).fold(0.0, f64::max);
    let total = forces.iter().fold(Torque::ZERO, |sum, f| sum + f.torque);
    s.line(format!("Σ rα × Fα = {} N·m: the torque above", exactly(tidy_beside(total.to_array(), largest))));
    let force = forces.iter().fold(polhode::math::Force::ZERO, |sum, f| sum + f.force);
    let scale = forces.iter().map(|f| f.force.norm()).fold(0.0, f64::max);
    let force = tidy_beside(force.to_array(), scale);
    if force == [0.0; 3] {
        s.line("Σ Fα = 0: the torque is a pure couple");
    } else {
        s.line(format!("Σ Fα = {} N: M times the acceleration of the centre of mass", exactly(force)));
    }
    s.say(
        "A rigid body transmits forces: any other external forces with the same sum and torque have the same effect, for instance at the bearings of a shaft.",
    );
}
