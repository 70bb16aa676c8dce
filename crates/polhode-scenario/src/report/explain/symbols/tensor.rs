//! Step 3 in symbols: the tensor of each part, its shift, their sum.

use polhode_algebra::{Fence, Formula, Matrix, RationalFunction, Vector};
use polhode_document::Section;

use super::{formula, principal, tensor_letter, write};
use crate::symbolic::{Symbolic, SymbolicPart, SymbolicParticle, shift};

/// Elements of a tensor: indices and names.
const ELEMENTS: [(usize, usize, &str); 6] =
    [(0, 0, "xx"), (1, 1, "yy"), (2, 2, "zz"), (0, 1, "xy"), (0, 2, "xz"), (1, 2, "yz")];

/// Largest number of particles in a written sum.
const MOST_TERMS: usize = 6;

/// Largest number of parts whose tensors are written.
const MOST_PARTS: usize = 8;

/// Writes the tensor about the reference point, with its principal moments and axes.
pub(crate) fn tensor(of: &Symbolic, about: &str, moments: [f64; 3], s: &mut Section) {
    let (Some(point), Some(tensor)) = (of.point(), of.tensor()) else { return };
    match of.body.particles().filter(|particles| particles.len() <= MOST_TERMS) {
        Some(particles) => {
            s.say(format!("In symbols, with the particles measured from {about}:"));
            sums(of, &particles, &point, s);
        }
        None => parts(of, &point, about, s),
    }
    // The tensor of a single part at the reference point has been written.
    let is_written = matches!(&of.body.parts[..], [part] if part.particles.is_empty() && part.own == tensor);
    if !is_written {
        write(s, &tensor_letter().equals(tensor.factored_formula(Fence::Braces, &of.symbols)));
    }
    if of.body.particles().is_none_or(|particles| particles.len() > MOST_TERMS) {
        for (value, names) in grouped(|i, j| tensor.0[i][j].clone()) {
            write(s, &names.equals(formula(of, &value)));
        }
    }
    principal::principal(of, &tensor, moments, s);
}

/// Writes each element as the sum over the particles, and its value.
fn sums(of: &Symbolic, particles: &[&SymbolicParticle], point: &Vector, s: &mut Section) {
    let tensors: Vec<Matrix> = particles.iter().map(|p| shift(&p.mass, &(&p.position - point))).collect();
    let terms = |i: usize, j: usize| -> Vec<RationalFunction> {
        tensors.iter().map(|tensor| tensor.0[i][j].clone()).filter(|term| !term.is_zero()).collect()
    };
    for (terms, name) in grouped(terms) {
        let sum = terms.iter().fold(RationalFunction::zero(), |sum, term| sum + term);
        let line = match terms.len() {
            0 | 1 => name,
            _ => name.equals(Formula::sum(terms.iter().map(|term| formula(of, term)).collect())),
        };
        write(s, &line.equals(formula(of, &sum)));
    }
}

/// Returns the distinct elements of a tensor, each with the names of the equal ones: I_xx = I_yy.
fn grouped<T: PartialEq>(element: impl Fn(usize, usize) -> T) -> Vec<(T, Formula)> {
    let mut groups: Vec<(T, Formula)> = Vec::new();
    for (i, j, name) in ELEMENTS {
        let (value, name) = (element(i, j), Formula::named(&format!("I_{name}")));
        match groups.iter_mut().find(|(other, _)| *other == value) {
            Some((_, names)) => *names = names.clone().equals(name),
            None => groups.push((value, name)),
        }
    }
    groups
}

/// Writes the tensor of each part about its own centre of mass, along body axes, and its shift to
/// the reference point.
fn parts(of: &Symbolic, point: &Vector, about: &str, s: &mut Section) {
    let all = &of.body.parts;
    for part in all.iter().take(MOST_PARTS) {
        own(of, part, s);
        let d = &part.center - point;
        if d.is_zero() {
            continue;
        }
        s.say(format!(
            "It is shifted from its centre of mass to {about}, by the parallel-axis theorem, with"
        ));
        write(s, &Formula::vector("d").equals(d.to_formula(&of.symbols)));
        let left = Formula::named("m").times(
            Formula::sum(vec![
                Formula::named("d").squared().times(Formula::integer(1).bold()),
                Formula::vector("d").times(Formula::vector("d")).negative(),
            ])
            .grouped(Fence::Parentheses),
        );
        write(s, &left.equals(shift(&part.mass, &d).factored_formula(Fence::Braces, &of.symbols)));
    }
    if all.len() > MOST_PARTS {
        s.say(format!("… and {} more parts in the same way.", all.len() - MOST_PARTS));
    }
    match &all[..] {
        [part] if part.center == *point => {}
        [_] => s.say("Together:"),
        _ => s.say("The sum over the parts:"),
    }
}

fn own(of: &Symbolic, part: &SymbolicPart, s: &mut Section) {
    s.say(format!(
        "In symbols, {}: its mass, and its tensor about its centre of mass{}:",
        part.name,
        match part.rotation {
            Some(_) => ", along its own axes, and with R along body axes",
            None => "",
        }
    ));
    write(s, &Formula::named("m").equals(formula(of, &part.mass)));
    let letter = tensor_letter().index(Formula::text("own"));
    write(s, &letter.equals(part.own.factored_formula(Fence::Braces, &of.symbols)));
    if let Some(rotation) = &part.rotation {
        write(s, &Formula::vector("R").equals(rotation.to_formula(Fence::Braces, &of.symbols)));
        let turned = Formula::vector("R")
            .times(tensor_letter().index(Formula::text("own")))
            .times(Formula::vector("R").power(Formula::text("T")));
        write(s, &turned.equals(part.along_body_axes().factored_formula(Fence::Braces, &of.symbols)));
    }
}
