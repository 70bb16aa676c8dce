//! Step 3 in symbols: the tensor of each part, its shift, their sum.

use polhode_algebra::{Fence, Formula, Matrix, RationalFunction, Vector};
use polhode_document::Section;

use super::{formula, principal, tensor_letter, write};
use crate::symbolic::{OwnTensor, Symbolic, SymbolicPart, SymbolicParticle, shift};

/// Elements of a tensor: indices and names.
const ELEMENTS: [(usize, usize, &str); 6] =
    [(0, 0, "xx"), (1, 1, "yy"), (2, 2, "zz"), (0, 1, "xy"), (0, 2, "xz"), (1, 2, "yz")];

/// Largest number of particles in a written sum.
const MOST_TERMS: usize = 6;

/// Widest matrix, characters.
const WIDEST: usize = 90;

/// Largest number of parts whose tensors are written.
const MOST_PARTS: usize = 8;

/// Writes the tensor about the reference point, with its principal moments and axes.
pub(crate) fn tensor(of: &Symbolic, about: &str, moments: [f64; 3], s: &mut Section) {
    let (point, tensor) = (of.point(), &of.tensor);
    match of.body.particles().filter(|particles| particles.len() <= MOST_TERMS) {
        Some(particles) => {
            s.say(format!("In symbols, with the particles measured from {about}:"));
            sums(of, &particles, point, s);
        }
        None => parts(of, point, about, s),
    }
    if !is_written(of, tensor) {
        matrix(of, tensor_letter(), tensor, s);
    }
    if of.body.particles().is_none_or(|particles| particles.len() > MOST_TERMS) {
        for (value, names) in grouped(|i, j| tensor.0[i][j].clone()) {
            write(s, &names.equals(formula(of, &value)));
        }
    }
    principal::principal(of, tensor, moments, s);
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
        for particle in &part.particles {
            let whole = match &part.own {
                Some(whole) => {
                    own(of, part, particle, whole, s);
                    "It"
                }
                None => "A particle",
            };
            let d = &particle.position - point;
            if d.is_zero() {
                continue;
            }
            s.say(format!("{whole} is moved to {about} by the parallel-axis theorem, with"));
            write(s, &Formula::vector("d").equals(d.to_formula(&of.symbols)));
            let left = Formula::named("m").times(
                Formula::sum(vec![
                    Formula::named("d").squared().times(Formula::integer(1).bold()),
                    Formula::vector("d").times(Formula::vector("d")).negative(),
                ])
                .grouped(Fence::Parentheses),
            );
            matrix(of, left, &shift(&particle.mass, &d), s);
        }
    }
    if all.len() > MOST_PARTS {
        s.say(format!("… and {} more parts in the same way.", all.len() - MOST_PARTS));
    }
    match &all[..] {
        [_] if is_written(of, &of.tensor) => {}
        [_] => s.say("Together:"),
        _ => s.say("The sum over the parts:"),
    }
}

/// Writes a matrix, unless it is wider than a line: then only its elements are readable.
fn matrix(of: &Symbolic, left: Formula, matrix: &Matrix, s: &mut Section) {
    let formula = left.equals(matrix.factored_formula(Fence::Braces, &of.symbols));
    if formula.to_text().lines().all(|line| line.chars().count() <= WIDEST) {
        write(s, &formula);
    } else {
        s.say("(a matrix wider than a line; the elements of the sum follow)");
    }
}

/// Returns true if the tensor is that of a single shape about its own centre of mass.
fn is_written(of: &Symbolic, tensor: &Matrix) -> bool {
    matches!(&of.body.parts[..], [part] if part.own.as_ref().is_some_and(|own| own.along_body_axes() == *tensor))
}

fn own(of: &Symbolic, part: &SymbolicPart, particle: &SymbolicParticle, own: &OwnTensor, s: &mut Section) {
    let axes = match own.rotation {
        Some(_) => ", along its own axes and, with R, along body axes",
        None => "",
    };
    s.say(format!("In symbols, {}: its mass, and its tensor about its centre of mass{axes}:", part.name));
    write(s, &Formula::named("m").equals(formula(of, &particle.mass)));
    let letter = tensor_letter().index(Formula::text("own"));
    matrix(of, letter.clone(), &own.tensor, s);
    if let Some(rotation) = &own.rotation {
        write(s, &Formula::vector("R").equals(rotation.to_formula(Fence::Braces, &of.symbols)));
        let transposed = Formula::vector("R").power(Formula::text("T"));
        let turned = Formula::vector("R").times(letter).times(transposed);
        matrix(of, turned, &own.along_body_axes(), s);
    }
}
