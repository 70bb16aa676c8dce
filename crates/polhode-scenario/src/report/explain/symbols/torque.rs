//! Step 4 in symbols: Euler's equations, and the torque of a prescribed motion.

use polhode_algebra::{Accent, Formula, Vector};
use polhode_document::Section;

use super::{ROUNDING, along_axes, formula, gap, write};
use crate::symbolic::{Gap, Symbolic};

/// Largest number of particles whose forces are written.
const MOST_PARTICLES: usize = 6;

/// Writes Euler's equations with the moments of a diagonal tensor in place.
pub(crate) fn euler(of: &Symbolic, s: &mut Section) {
    let tensor = &of.tensor;
    let moments = [0, 1, 2].map(|k| tensor.0[k][k].clone());
    let is_diagonal = [(0, 1), (0, 2), (1, 2)].iter().all(|&(i, j)| tensor.0[i][j].is_zero());
    if !is_diagonal {
        return;
    }
    s.say("In symbols, along the body axes:");
    let omega = |k: usize| Formula::named(&format!("omega_{}", ["x", "y", "z"][k]));
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let mut terms = Vec::new();
        if !moments[i].is_zero() {
            terms.push(formula(of, &moments[i]).times(omega(i).accented(Accent::Dot)));
        }
        let difference = &moments[j] - &moments[k];
        if !difference.is_zero() {
            terms.push(formula(of, &difference).times(omega(j)).times(omega(k)).negative());
        }
        let torque = Formula::named(&format!("N_{}", ["x", "y", "z"][i]));
        write(s, &torque.equals(Formula::sum(terms)));
    }
}

/// Writes the torque N = {I} ω̇ + ω × L of a prescribed motion, and the forces on its particles.
pub(crate) fn needed(of: &Symbolic, computed: [f64; 3], s: &mut Section) {
    let (Some(Ok(omega)), tensor) = (&of.omega, &of.tensor) else { return };
    let acceleration = match &of.acceleration {
        Some(Ok(acceleration)) => acceleration,
        Some(Err(why)) => return gap(s, why),
        None => return,
    };
    let torque = tensor.times_vector(acceleration) + omega.cross(&tensor.times_vector(omega));
    let size = computed.iter().fold(0.0, |most, x| f64::max(most, x.abs()));
    let is_computed = of
        .evaluate_vector(&torque)
        .is_some_and(|value| (0..3).all(|k| (value[k] - computed[k]).abs() <= ROUNDING * size));
    if !is_computed {
        return gap(s, &Gap::Differs { what: "N".to_owned() });
    }
    s.say("In symbols:");
    write(s, &Formula::vector("N").equals(along_axes(of, &torque)));
    forces(of, omega, acceleration, &torque, s);
}

/// Writes F = m [ω̇ × r + ω × (ω × r)] of each particle, r from the reference point.
fn forces(of: &Symbolic, omega: &Vector, acceleration: &Vector, torque: &Vector, s: &mut Section) {
    let Some(particles) = of.body.particles() else { return };
    if particles.len() > MOST_PARTICLES {
        return;
    }
    let forces = particles.iter().map(|particle| {
        let r = &particle.position - of.point();
        let force = (acceleration.cross(&r) + omega.cross(&omega.cross(&r))).scaled(&particle.mass);
        (r, force)
    });
    let forces: Vec<(Vector, Vector)> = forces.collect();
    // N = Σ r × F holds exactly.
    if forces.iter().fold(Vector::zero(), |sum, (r, force)| sum + r.cross(force)) != *torque {
        return gap(s, &Gap::Differs { what: "the forces".to_owned() });
    }
    s.say("The forces on the particles, F = m [ω\u{307} × r + ω × (ω × r)]:");
    for (k, (_, force)) in forces.iter().enumerate() {
        write(s, &Formula::vector(&format!("F_{}", k + 1)).equals(along_axes(of, force)));
    }
    let sum = forces.iter().fold(Vector::zero(), |sum, (_, force)| sum + force);
    let total = Formula::vector("F");
    let index = Formula::named("alpha");
    let left = Formula::sum_over(index.clone(), total.index(index));
    let right = if sum.is_zero() { Formula::integer(0) } else { along_axes(of, &sum) };
    write(s, &left.equals(right));
}
