//! Search for the steady motion nearest to a start.

use super::stable_spins::StableSpins;
use super::{SteadyOnGround, SteadyPath, TippeTop, UprightWheel, VertexSpin};
use crate::math::frame::{Body, Part};
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Direction;
use crate::motion::contact::reduced::{Reading, Reduced, cross, dot, tangents};
use crate::motion::contact::{Contact, ContactStart, Footing, StartVelocity};
use crate::motion::error::MotionError;

/// Largest accepted distance of a start from a steady motion: in rad, and relative to the rate.
const NEAR: f64 = 0.35;

/// Largest accepted unsteadiness of a candidate: rounding of decimal input.
const STEADY: f64 = 1e-8;

/// Distance below which two motions count as the same.
const SAME: f64 = 1e-7;

/// Relative threshold below which a value counts as zero.
const EXACT: f64 = 1e-9;

/// Candidate for the steady motion.
struct Candidate {
    path: SteadyPath,
    at: Reading,
    spin: f64,
    stable_spins: Option<StableSpins>,
}

pub(super) fn near(
    reduced: &Reduced,
    contact: &Contact,
    start: &ContactStart,
) -> Result<SteadyOnGround, MotionError> {
    let up: Direction<Body> = start.state.attitude.inverse() * contact.ground.axis();
    let here = reduced.reading(up, start.state.omega.to_array());
    let tippe_top = tippe_top(reduced);
    let jellett = tippe_top.map(|_| -dot(reduced.image(here.omega), reduced.arm(here.normal)));
    let mut candidates = on_vertices(reduced, &here);
    if is_ball(reduced) && reduced.axis().is_some() && is_isotropic(reduced) {
        let why = "a ball with its centre of mass in its middle and three equal moments moves steadily however it starts";
        return Err(MotionError::NoSteadyMotion { why });
    }
    candidates.extend(upright(reduced, &here));
    if let (Some(top), Some(jellett)) = (&tippe_top, jellett) {
        candidates.extend(tilted(reduced, &here, top, jellett));
    }
    candidates.extend(circling(reduced, &here));
    let rate = reduced.rate(&here);
    let from = |candidate: &Candidate| {
        let angle = angle(here.normal, candidate.at.normal);
        let off: [f64; 3] = core::array::from_fn(|k| here.omega[k] - candidate.at.omega[k]);
        [angle, dot(off, off).sqrt()]
    };
    let distance = |candidate: &Candidate| {
        let [angle, off] = from(candidate);
        // If several candidates equal the start to rounding, the first one is used, because a
        // circle may also be another kind of motion.
        angle.max(off / rate).max(SAME)
    };
    let nearest = candidates
        .into_iter()
        .filter(|candidate| reduced.unsteadiness(&candidate.at) <= STEADY)
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))
        .filter(|candidate| distance(candidate) <= NEAR)
        .ok_or(MotionError::NoSteadyMotion {
            why: "attitude and ω of the start are farther than 0.35 rad and 0.35 of the rate from all that are known here",
        })?;
    let slip = slip(reduced, contact, start, &here);
    let arm = reduced.arm(here.normal);
    if slip > NEAR * rate * dot(arm, arm).sqrt() {
        let why = "its point of contact slips, and friction changes the motion until it does not";
        return Err(MotionError::NoSteadyMotion { why });
    }
    let [turned_from_start, omega_from_start] = from(&nearest);
    let (modes, neutral) = SteadyOnGround::modes(reduced, &nearest.at)?;
    let in_body = |v: [f64; 3]| reduced.in_body() * Direction::<Part>::from_array(v);
    Ok(SteadyOnGround {
        path: nearest.path,
        footing: reduced.footing(),
        normal: in_body(nearest.at.normal),
        omega: in_body(nearest.at.omega).as_quantity(),
        spin: nearest.spin,
        axis: reduced.axis().map(in_body),
        turned_from_start,
        omega_from_start,
        modes,
        neutral,
        stable_spins: nearest.stable_spins,
        tippe_top,
        jellett,
        slip_at_start: slip,
    })
}

/// Returns spins about the vertical if it is a principal axis through the point of contact.
fn on_vertices(reduced: &Reduced, here: &Reading) -> Vec<Candidate> {
    // The vertical is a principal axis.
    let images = [0, 1, 2].map(|k| reduced.image(unit(k)));
    let [[xx, xy, xz], [_, yy, yz], [.., zz]] = images;
    let principal = Symmetric3 { xx, yy, zz, xy, xz, yz }.eigen().vectors;
    let normals: Vec<[f64; 3]> = match reduced.axis() {
        // For points around the axis, `upright` gives more information.
        Some(e) => vec![e],
        None => [0, 1, 2].map(unit).into_iter().chain(principal).collect(),
    };
    if !reduced.touches_in_a_point() {
        return Vec::new();
    }
    let both = normals.iter().flat_map(|n| [*n, n.map(|x| -x)]);
    both.filter_map(|normal| {
        let spin = vertex(reduced, normal)?;
        let rate = dot(here.omega, normal);
        let at = Reading { normal, omega: normal.map(|x| x * rate) };
        Some(Candidate {
            path: SteadyPath::OnVertex(spin),
            at,
            spin: rate,
            stable_spins: spin.stable_spins(),
        })
    })
    .collect()
}

/// Returns the spin on a point, if the centre of mass is vertically above it and the vertical is a
/// principal axis.
fn vertex(reduced: &Reduced, normal: [f64; 3]) -> Option<VertexSpin> {
    let tangents = tangents(normal, reduced.axis());
    let (arm, image) = (reduced.arm(normal), reduced.image(normal));
    let height = -dot(arm, normal);
    let is_along = |v: [f64; 3], size: f64| tangents.iter().all(|t| dot(*t, v).abs() <= EXACT * size);
    if !(height > 0.0 && is_along(arm, height) && is_along(image, dot(image, image).sqrt())) {
        return None;
    }
    let images = tangents.map(|t| reduced.image(t));
    let is_symmetric = reduced.axis().is_some_and(|e| dot(e, normal).abs() > 1.0 - EXACT);
    Some(VertexSpin {
        mass: reduced.mass(),
        gravity: reduced.gravity(),
        height,
        along: dot(normal, image),
        across: core::array::from_fn(|i| core::array::from_fn(|j| dot(tangents[i], images[j]))),
        radii: reduced.radii(normal, tangents),
        is_symmetric,
        footing: reduced.footing(),
    })
}

/// Returns straight rolling and spinning about the vertical, for a mirror-symmetric body of
/// revolution with a level axis.
fn upright(reduced: &Reduced, here: &Reading) -> Vec<Candidate> {
    let Some(e) = reduced.axis() else { return Vec::new() };
    let offset = reduced.offset();
    let Some(normal) = across(here.normal, e) else { return Vec::new() };
    let arm = reduced.arm(normal);
    let height = -dot(arm, normal);
    if dot(offset, offset).sqrt() > EXACT * height {
        return Vec::new();
    }
    let radii = reduced.radii(normal, [cross(normal, e), e]);
    let wheel = UprightWheel {
        mass: reduced.mass(),
        gravity: reduced.gravity(),
        across: dot(normal, reduced.image(normal)),
        along: dot(e, reduced.image(e)),
        height,
        profile: radii[1][1],
        footing: reduced.footing(),
    };
    let (rolling, spinning) = (dot(here.omega, e), dot(here.omega, normal));
    let along = |v: [f64; 3], rate: f64| Reading { normal, omega: v.map(|x| x * rate) };
    vec![
        Candidate {
            path: SteadyPath::RollingUpright(wheel),
            at: along(e, rolling),
            spin: rolling,
            stable_spins: wheel.rolling(),
        },
        Candidate {
            path: SteadyPath::SpinningUpright(wheel),
            at: along(normal, spinning),
            spin: spinning,
            stable_spins: wheel.spinning(),
        },
    ]
}

/// Returns the motions of a tippe top at the tilts that its Jellett constant allows.
fn tilted(reduced: &Reduced, here: &Reading, top: &TippeTop, jellett: f64) -> Vec<Candidate> {
    let Some(e) = reduced.axis() else { return Vec::new() };
    let Some(level) = across(here.normal, e) else { return Vec::new() };
    let states = top.all(jellett).into_iter().filter(|state| state.cosine.abs() < 1.0);
    states
        .map(|state| {
            let u = state.cosine;
            let sine = ((1.0 - u) * (1.0 + u)).sqrt();
            let [along, beside] = top.omega(jellett, u);
            let joined = |a: f64, b: f64| core::array::from_fn(|k| a * e[k] + b * level[k]);
            let at = Reading { normal: joined(u, sine), omega: joined(along, beside) };
            let spin = dot(at.omega, at.normal);
            Candidate { path: SteadyPath::Tilted, at, spin, stable_spins: None }
        })
        .collect()
}

/// Returns the start itself as a circling motion, for a symmetric body.
fn circling(reduced: &Reduced, here: &Reading) -> Option<Candidate> {
    let e = reduced.axis()?;
    across(here.normal, e)?;
    let spin = dot(here.omega, e);
    // Upright motions, straight rolling and pure spinning are separate kinds.
    let is_upright = dot(here.normal, e).abs() <= EXACT;
    (!is_upright).then_some(Candidate { path: SteadyPath::Circling, at: *here, spin, stable_spins: None })
}

/// Returns the tippe top, for a symmetric ball with its centre of mass inside but off-centre.
fn tippe_top(reduced: &Reduced) -> Option<TippeTop> {
    let (radius, e, offset) = (reduced.sphere()?, reduced.axis()?, reduced.offset());
    let eccentricity = dot(offset, offset).sqrt() / radius;
    let [across, _] = tangents(e, None);
    (eccentricity > EXACT && eccentricity < 1.0).then(|| TippeTop {
        mass: reduced.mass(),
        gravity: reduced.gravity(),
        radius,
        eccentricity,
        across: dot(across, reduced.image(across)),
        along: dot(e, reduced.image(e)),
    })
}

fn is_ball(reduced: &Reduced) -> bool {
    let offset = reduced.offset();
    reduced.sphere().is_some_and(|radius| dot(offset, offset).sqrt() <= EXACT * radius)
}

fn is_isotropic(reduced: &Reduced) -> bool {
    let images = [0, 1, 2].map(|k| reduced.image(unit(k)));
    let size = images[0][0];
    let is_unit = |i: usize, j: usize| (images[i][j] - if i == j { size } else { 0.0 }).abs() <= EXACT * size;
    (0..3).all(|i| (0..3).all(|j| is_unit(i, j)))
}

/// Returns the slip speed of the point of contact, m/s.
fn slip(reduced: &Reduced, contact: &Contact, start: &ContactStart, here: &Reading) -> f64 {
    let (StartVelocity::Along(velocity), true) = (start.velocity, reduced.footing() != Footing::Frictionless)
    else {
        return 0.0;
    };
    let in_body: Direction<Body> = start.state.attitude.inverse() * velocity.as_quantity();
    let reading = reduced.reading(start.state.attitude.inverse() * contact.ground.axis(), in_body.to_array());
    // Velocity along the axes of the surface.
    let turned = cross(here.omega, reduced.arm(here.normal));
    let slip: [f64; 3] = core::array::from_fn(|k| reading.omega[k] + turned[k]);
    let up = dot(slip, here.normal);
    let slip: [f64; 3] = core::array::from_fn(|k| slip[k] - up * here.normal[k]);
    dot(slip, slip).sqrt()
}

/// Returns the unit vector along the component of n perpendicular to an axis.
fn across(n: [f64; 3], axis: [f64; 3]) -> Option<[f64; 3]> {
    let along = dot(n, axis);
    let across: [f64; 3] = core::array::from_fn(|k| n[k] - along * axis[k]);
    let length = dot(across, across).sqrt();
    (length > 1e-6).then(|| across.map(|x| x / length))
}

fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    let c = cross(a, b);
    libm::atan2(dot(c, c).sqrt(), dot(a, b))
}

fn unit(k: usize) -> [f64; 3] {
    core::array::from_fn(|i| if i == k { 1.0 } else { 0.0 })
}
