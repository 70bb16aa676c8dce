//! Step 5 of a disk, a hoop or a coin on level ground: steady circles, upright wheels, and Euler's
//! disk.

use std::f64::consts::{FRAC_PI_2, TAU};

use polhode::math::{Body, Direction};
use polhode::motion::contact::{ContactChange, Footing};
use polhode::observe::{CirclingDisk, StableSpins, SteadyOnGround};
use polhode_document::Section;
use polhode_document::number::tidy_beside;
use polhode_document::unit::{angle, rate};

use super::super::free::once_in;
use super::super::tensor::along_body_axis;
use super::super::working::{cells, factor, n, v};
use super::{OnGround, about};

/// Tilt, rad, and rates about e, about q and of the precession, rad/s, at t0.
struct Motion {
    tilt: f64,
    spin: f64,
    nodding: f64,
    precession: f64,
}

impl Motion {
    fn of(g: &OnGround<'_, '_>, e: Direction<Body>) -> Self {
        let omega = g.start.state.omega;
        let tilt = e.angle_to(g.up);
        let p = (e * e.dot(g.up) - g.up) * (1.0 / tilt.sin());
        let size = omega.norm();
        let tidy = |x: f64| tidy_beside([x, 0.0, 0.0], size)[0];
        Self {
            tilt,
            spin: tidy(about(omega, e)),
            nodding: tidy(about(omega, e.cross(p))),
            precession: tidy(-about(omega, p) / tilt.sin()),
        }
    }
}

pub(crate) fn solve(
    g: &OnGround<'_, '_>,
    disk: &CirclingDisk,
    e: Direction<Body>,
    s: &mut Section,
) -> Option<String> {
    let at = Motion::of(g, e);
    s.say(
        "The body is symmetric about e, which is tilted by θ from n, as its plane is from the ground. p points downhill in its plane, towards P, and q = e × p is level. With Ω the rate at which e goes round the vertical, and s the \
         rate about e,",
    );
    s.formula(
        "ω = −Ω sin θ p + θ\u{307} q + s e,   L = −A Ω sin θ p + A θ\u{307} q + C s e",
        r"\boldsymbol\omega = -\Omega \sin\theta \mathbf p + \dot\theta \mathbf q + s \mathbf e, \qquad \mathbf L = -A \Omega \sin\theta \mathbf p + A \dot\theta \mathbf q + C s \mathbf e",
    );
    let name = along_body_axis(e).map_or_else(String::new, |name| format!(" = {name}"));
    s.line(format!("e = {}{name},  A = {},  C = {} kg·m²", v(e.to_array()), n(disk.across), n(disk.along)));
    let tube = if disk.tube > 0.0 { format!(",  τ = {} m", n(disk.tube)) } else { String::new() };
    let offset =
        if disk.offset == 0.0 { String::new() } else { format!(",  d = {} m along e", n(disk.offset)) };
    s.line(format!("R = {} m{tube}{offset}", n(disk.radius)));
    s.line(format!("θ = {} at t0", angle(at.tilt)));
    s.line(format!(
        "s = {},  Ω = {} rad/s,  θ\u{307} = {} rad/s",
        rate(at.spin),
        n(at.precession),
        n(at.nodding)
    ));
    if !g.is_rolling() && g.is_frictionless() {
        s.say("Without friction the centre of mass only rises and falls, and L · n and ω · e are constant: θ moves like that of a top with its tip at the point of contact, in the effective potential of both constants. The motion is integrated (step 6).");
        upright(disk, at.tilt, Footing::Frictionless, s);
        return None;
    }
    if !g.is_rolling() {
        s.say("It slips at first, and friction changes θ, s and Ω until it rolls: no closed form is known for this phase. The following applies to rolling.");
    }
    let answer = circles(g, disk, &at, s);
    upright(disk, at.tilt, Footing::Rolling, s);
    let settled = euler(g, disk, &at, s);
    if !is_steady(disk, &at) {
        s.say("Between these steady motions it nutates. A rolling disk has two constants in addition to T + U, linear in ω (Appell, Korteweg 1900), but they are hypergeometric functions of cos θ and give no formula for θ(t): the motion is integrated (step 6).");
    }
    settled.or(answer)
}

/// Returns true if θ is constant up to rounding of the start.
fn is_steady(disk: &CirclingDisk, at: &Motion) -> bool {
    let near = |rate: f64| (rate - at.precession).abs() <= 1e-3 * at.precession.abs().max(1e-300);
    at.nodding.abs() <= 1e-3 * at.precession.abs().max(at.spin.abs())
        && (disk.rates(at.tilt, at.spin).into_iter().any(near)
            || at.tilt == FRAC_PI_2 && at.precession == 0.0)
}

/// Writes the steady circular motions with this tilt and this spin rate.
fn circles(g: &OnGround<'_, '_>, disk: &CirclingDisk, at: &Motion, s: &mut Section) -> Option<String> {
    s.say("For constant θ the whole configuration rotates about the vertical, so L\u{307} = Ω n × L and v\u{307} = Ω n × v. Of L\u{307} = r × m (v\u{307} − g) only the component along q remains:");
    s.formula(
        "Ω² sin θ (A cos θ − m r_e H) − Ω s (C sin θ + m r_p H) = m g D",
        r"\Omega^2 \sin\theta (A \cos\theta - m r_e H) - \Omega s (C \sin\theta + m r_p H) = m g D",
    );
    s.say(
        "with r = r_p p + r_e e, H = r_p sin θ − r_e cos θ the height of the centre of mass, and D = r_p cos θ + r_e sin θ its distance from P along the ground. The left side is the rate of change of L and v, the right side the tipping torque. A thin disk with a sharp \
         edge has r_p = R, r_e = 0:",
    );
    s.formula(
        "Ω sin θ [A Ω cos θ − (C + m R²) s] = m g R cos θ",
        r"\Omega \sin\theta \left[A \Omega \cos\theta - (C + m R^2) s\right] = m g R \cos\theta",
    );
    let [square, linear, weight] = disk.balance(at.tilt);
    s.line(format!(
        "H = {} m,  D = {} m",
        n(disk.height(at.tilt)),
        n(tidy(disk.reach(at.tilt), disk.radius))
    ));
    s.line(format!(
        "{} Ω² − {}·{} Ω = {} N·m",
        n(tidy(square, disk.across)),
        n(linear),
        factor(at.spin),
        n(tidy(weight, disk.mass * disk.gravity * disk.radius))
    ));
    let upright = (at.tilt - FRAC_PI_2).abs() < 1e-9;
    if upright && disk.offset == 0.0 {
        s.say("Upright, D = 0: it rolls straight (Ω = 0) or spins in place (s = 0).");
        return Some(format!("It rolls upright at {} m/s.", n(disk.velocity(at.tilt, at.spin, 0.0).abs())))
            .filter(|_| at.precession == 0.0);
    }
    let rates = disk.rates(at.tilt, at.spin);
    if rates.is_empty() {
        s.say("No root exists: at this tilt it rolls too slowly for a circle, and the tilt changes from the start.");
        return None;
    }
    let names = if rates.len() == 2 { ["the slower", "the faster"] } else { ["the one", ""] };
    for (rate, name) in rates.iter().zip(names) {
        s.line(format!(
            "{name}: Ω = {} rad/s{}, P on a circle of the radius {} m, the centre of mass of {} m",
            n(*rate),
            once_in(*rate),
            n(disk.circle_radius(at.tilt, at.spin, *rate).abs()),
            n(tidy(disk.velocity(at.tilt, at.spin, *rate) / rate, disk.radius).abs())
        ));
    }
    if !is_steady(disk, at) {
        let nearest = rates
            .iter()
            .copied()
            .min_by(|a, b| (a - at.precession).abs().total_cmp(&(b - at.precession).abs()))?;
        s.say(format!(
            "The start has Ω = {} rad/s and θ\u{307} = {} rad/s, not the {} rad/s of a circle: θ does not stay constant.",
            n(at.precession),
            n(at.nodding),
            n(nearest)
        ));
        return None;
    }
    s.say("The start is such a steady circle.");
    if let Some(steady) = g.steady(&g.rolling_start()) {
        departures(g, &steady, s);
    }
    let radius = disk.circle_radius(at.tilt, at.spin, at.precession).abs();
    Some(format!(
        "It rolls in a circle of radius {} m at Ω = {} rad/s, tilted {}°.",
        n(radius),
        n(at.precession),
        n(at.tilt.to_degrees())
    ))
}

/// Writes the eigenvalues of the linearized motion about a steady motion.
pub(crate) fn departures(g: &OnGround<'_, '_>, steady: &SteadyOnGround, s: &mut Section) {
    let without = if g.is_resisted() { ", without the resisting torques," } else { "" };
    s.say(format!("A small deviation from it{without} obeys linear equations with the eigenvalues σ ± iϖ:"));
    let rows: Vec<Vec<f64>> =
        steady.modes.iter().map(|mode| vec![mode.frequency, mode.growth_rate]).collect();
    if rows.is_empty() {
        s.line("only zero: every deviation is another steady motion");
        return;
    }
    let rows = cells(&rows).into_iter().zip(&steady.modes).map(|(row, mode)| {
        let period = if mode.frequency > 0.0 { n(TAU / mode.frequency) } else { String::new() };
        [row, vec![period]].concat()
    });
    s.table(&["ϖ (rad/s)", "σ (/s)", "period (s)"], rows.collect());
    let while_held =
        if g.friction().sticking > 0.0 { ", as long as friction holds the point of contact" } else { "" };
    s.say(match steady.is_stable() {
        true => format!("No mode grows: the motion is stable{while_held}."),
        false => "One mode grows: the motion is unstable.".to_owned(),
    });
}

/// Writes the rolling and spinning rates above which an upright wheel is stable.
fn upright(disk: &CirclingDisk, tilt: f64, footing: Footing, s: &mut Section) {
    let Some(wheel) = disk.upright(footing) else {
        s.say("Upright, with θ = 90°, it would stand on both rims, or its centre of mass is outside the plane of the rim: the stability criterion of a thin wheel does not apply.");
        return;
    };
    let (Some(rolling), Some(spinning)) = (wheel.rolling(), wheel.spinning()) else { return };
    s.say(
        "Upright it falls unless it is fast enough. With the lean φ = 90° − θ and the heading ψ small, a wheel that rolls straight at s steers into the lean and so moves under its centre of mass; one that spins in place is a top:",
    );
    if footing == Footing::Rolling {
        s.formula(
            "(A + m ρ²) φ\u{308} = (C + m ρ²) s ψ\u{307} + m g (ρ − κ) φ,   A ψ\u{307} = −C s φ",
            r"(A + m \rho^2) \ddot\varphi = (C + m \rho^2) s \dot\psi + m g (\rho - \kappa) \varphi, \qquad A \dot\psi = -C s \varphi",
        );
        s.formula(
            "rolling: s² > A m g (ρ − κ) / [C (C + m ρ²)];   spinning: Ω² > m g (ρ − κ) / (A + m ρ²)",
            r"s^2 > \frac{A m g (\rho - \kappa)}{C (C + m \rho^2)}, \qquad \Omega^2 > \frac{m g (\rho - \kappa)}{A + m \rho^2}",
        );
    } else {
        s.formula(
            "rolling: s² > A m g (ρ − κ) / C²;   spinning: Ω² > m g (ρ − κ) / A",
            r"s^2 > \frac{A m g (\rho - \kappa)}{C^2}, \qquad \Omega^2 > \frac{m g (\rho - \kappa)}{A}",
        );
    }
    s.line(format!(
        "ρ = {} m, its height upright;  κ = {} m, the radius of its edge",
        n(wheel.height),
        n(wheel.profile)
    ));
    let limit = |spins: &StableSpins| spins.thresholds().into_iter().fold(0.0, f64::max);
    let [roll, spin] = [&rolling, &spinning].map(limit);
    s.line(format!("rolling straight: |s| > {} rad/s, {} m/s", n(roll), n(roll * wheel.height)));
    s.line(format!("spinning:         |Ω| > {} rad/s{}", n(spin), once_in(spin)));
    if (tilt - FRAC_PI_2).abs() > 0.35 {
        s.say("It starts far from that.");
    }
}

/// Solves Euler's disk: the whirling motion at small tilt.
fn euler(g: &OnGround<'_, '_>, disk: &CirclingDisk, at: &Motion, s: &mut Section) -> Option<String> {
    let lever = g.contact.law.resistance().rolling;
    // Close to vertical or faster than a whirl, it is another motion. With rolling friction,
    // however, it becomes Euler's disk in the end.
    if lever == 0.0 && at.tilt > 1.0 {
        return None;
    }
    let here = disk.rate_at_rest(at.tilt)?;
    let moves = disk.velocity(at.tilt, at.spin, at.precession).abs()
        / (at.precession.abs() * disk.radius).max(1e-300);
    s.say(
        "Euler's disk is the steady motion with the centre of mass at rest, V = 0, while P moves in a circle below it. Then ω is along r, and the equation becomes",
    );
    s.formula(
        "thin: s = 0,  Ω² sin θ = m g R/A,  T + U = 3/2 m g R sin θ",
        r"s = 0, \qquad \Omega^2 \sin\theta = \frac{m g R}{A}, \qquad T + U = \tfrac32 m g R \sin\theta \qquad \text{(thin)}",
    );
    s.say(
        "As the disk becomes flatter, the horizontal component of L, A Ω sin θ cos θ, decreases, but the torque of N that rotates it, m g R cos θ, does not. So Ω increases although the energy decreases. The sound comes from P, at Ω/2π, so its pitch rises. The body itself rotates slowly, at Ω (1 − cos θ) if it is thin, because P returns to nearly the same point of it.",
    );
    let rows: Vec<Vec<f64>> = tilts(at.tilt)
        .into_iter()
        .filter_map(|tilt| {
            let rate = disk.rate_at_rest(tilt)?;
            let spin = disk.spin_at_rest(tilt, rate);
            let turned = rate * (1.0 - tilt.cos()) + spin;
            Some(vec![tilt.to_degrees(), rate, rate / TAU, turned, disk.energy(tilt, spin, rate)])
        })
        .collect();
    s.table(&["θ (°)", "Ω (rad/s)", "Ω/2π (Hz)", "turns at (rad/s)", "T + U (J)"], cells(&rows));
    if moves < 0.05 {
        s.say(format!(
            "The start is one: Ω = {} rad/s, and with this tilt it is {}.",
            n(at.precession),
            n(here)
        ));
    } else {
        s.say(format!(
            "At its tilt that would take Ω = {} rad/s; the start has {}, and its centre of mass moves.",
            n(here),
            n(at.precession)
        ));
    }
    let answer = (lever > 0.0).then(|| settles(g, disk, lever, here, s));
    answer.filter(|_| moves < 0.05)
}

/// Returns some tilts for a table, from that of the start downward, rad.
fn tilts(from: f64) -> Vec<f64> {
    let first = from.min(std::f64::consts::FRAC_PI_4);
    [1.0, 0.5, 0.2, 0.1, 0.04, 0.01].map(|part| part * first).to_vec()
}

fn settles(g: &OnGround<'_, '_>, disk: &CirclingDisk, lever: f64, here: f64, s: &mut Section) -> String {
    s.say(
        "Rolling friction dissipates the power µr N |ω_t| = µr m g Ω sin θ cos θ. At small tilts of a thin disk this is proportional to √θ, and E ∝ θ, so √θ decreases linearly to zero in a finite time:",
    );
    s.formula(
        "T_flat = 3 R/(µr Ω0),   θ = θ0 (1 − t/T_flat)²,   Ω = Ω0/(1 − t/T_flat)",
        r"T_{\text{flat}} = \frac{3 R}{\mu_r \Omega_0}, \qquad \theta = \theta_0 \left(1 - \frac{t}{T_{\text{flat}}}\right)^2, \qquad \Omega = \frac{\Omega_0}{1 - t/T_{\text{flat}}}",
    );
    let settles = disk.settling_time(here, lever);
    s.line(format!(
        "T_flat = 3·{}/({}·{}) = {} s from a whirl at the start's tilt",
        n(disk.radius),
        n(lever),
        n(here),
        n(settles)
    ));
    let flat = g.motion().and_then(|motion| {
        motion.changes().iter().find(|event| event.change == ContactChange::LiesFlat).map(|event| event.time)
    });
    s.say("It also reduces the rate about e, so in the run the centre of mass is not exactly at rest, and Ω is slightly lower than in the table.");
    match flat {
        Some(time) => {
            s.line(format!("in the run it lies flat after {} s", n(time - g.start.state.time)));
            format!(
                "It becomes flatter and whirls faster, and lies flat after {} s.",
                n(time - g.start.state.time)
            )
        }
        None => {
            format!("It whirls faster and faster; a thin disk at this tilt lies flat after {} s.", n(settles))
        }
    }
}

fn tidy(x: f64, scale: f64) -> f64 {
    tidy_beside([x, 0.0, 0.0], scale)[0]
}
