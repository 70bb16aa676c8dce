//! Step 0: the body.

use polhode::body::Particle;
use polhode_document::Section;
use polhode_document::number::tidy;

use super::symbols;
use super::working::{Working, cells, n, v};
use crate::symbolic::Exact;

/// Largest number of rows in a table.
const MOST_ROWS: usize = 20;

/// Largest number of terms in a written sum; for more, the table has the terms.
const MOST_TERMS: usize = 6;

pub(crate) fn section(w: &Working<'_>) -> Section {
    let mut s = Section::new(0, "The body");
    let masses = if w.scenario.is_all_particles() && !w.scenario.parts().is_empty() {
        particles(w, &mut s)
    } else {
        parts(w, &mut s)
    };
    if !w.scenario.parts().is_empty() {
        s.formula(
            "M = Σ mα,   c = Σ mα rα / M",
            r"M = \sum_\alpha m_\alpha, \qquad \mathbf c = \frac{1}{M} \sum_\alpha m_\alpha \mathbf r_\alpha",
        );
    }
    let mass = format!("{} kg", n(w.body().mass()));
    let terms: Vec<String> = masses.iter().map(|m| n(*m)).collect();
    if (2..=MOST_TERMS).contains(&terms.len()) {
        s.sum("M", &terms, &mass);
    } else {
        s.line(format!("M = {mass}"));
    }
    s.line(format!("c = {} m", v(w.body().center_of_mass().to_array())));
    match w.exact {
        Exact::Symbols(symbolic) => symbols::body(symbolic, &mut s),
        Exact::Gap(gap) => symbols::gap(&mut s, gap),
        Exact::Fractions(_) | Exact::None => {}
    }
    s
}

fn particles(w: &Working<'_>, s: &mut Section) -> Vec<f64> {
    let particles = w.scenario.particles();
    let count = match particles.len() {
        1 => "one particle".to_owned(),
        many => format!("{many} particles at fixed distances from each other"),
    };
    s.say(format!("A rigid body of {count}; positions in body axes, as given."));
    let rows: Vec<Vec<f64>> = particles
        .iter()
        .take(MOST_ROWS)
        .map(|p| {
            let [x, y, z] = p.position().to_array();
            vec![p.mass(), x, y, z]
        })
        .collect();
    s.table(&["α", "m (kg)", "x (m)", "y (m)", "z (m)"], numbered(cells(&rows)));
    more(particles.len(), s);
    particles.iter().map(Particle::mass).collect()
}

fn parts(w: &Working<'_>, s: &mut Section) -> Vec<f64> {
    let parts = w.scenario.parts();
    if parts.is_empty() {
        s.say("The body is defined by its mass, its centre of mass and its inertia tensor.");
        return Vec::new();
    }
    let what = match parts.len() {
        1 => "one part; c is its centre of mass".to_owned(),
        many => format!("{many} parts, rigidly joined; c is the centre of mass of each"),
    };
    s.say(format!("A body of {what}, in body axes."));
    let rows: Vec<Vec<f64>> = parts
        .iter()
        .take(MOST_ROWS)
        .map(|part| {
            let [x, y, z] = tidy(part.properties.center_of_mass().to_array());
            vec![part.properties.mass(), x, y, z]
        })
        .collect();
    let rows = cells(&rows).into_iter().zip(parts).map(|(row, part)| {
        let mut cells = vec![part.name.clone(), part.kind.to_owned()];
        cells.extend(row);
        cells
    });
    s.table(&["part", "kind", "m (kg)", "cx (m)", "cy (m)", "cz (m)"], rows.collect());
    more(parts.len(), s);
    parts.iter().map(|part| part.properties.mass()).collect()
}

/// Writes the number of rows that the table omits.
fn more(all: usize, s: &mut Section) {
    if all > MOST_ROWS {
        s.say(format!("… and {} more.", all - MOST_ROWS));
    }
}

/// Returns the rows with a first column of numbers, from 1.
pub(crate) fn numbered(rows: Vec<Vec<String>>) -> Vec<Vec<String>> {
    let with_number = |(k, row): (usize, Vec<String>)| {
        let mut cells = vec![(k + 1).to_string()];
        cells.extend(row);
        cells
    };
    rows.into_iter().enumerate().map(with_number).collect()
}
