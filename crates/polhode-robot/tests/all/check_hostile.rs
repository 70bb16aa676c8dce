//! Arbitrary numbers cause no panic, no NaN, and no edit outside the text.

use crate::check_common::{SLAB, findings, findings_with, is_clean, number, read};
use polhode_robot::finding::{Finding, Severity};

/// Pseudo-random number generator.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    /// Returns a number between 0 and 1.
    fn part(&mut self) -> f64 {
        self.roll() as f64 / (1_u64 << 31) as f64
    }
}

const TEXTS: [&str; 24] = [
    "0",
    "-0",
    "1",
    "-1",
    "1e308",
    "-1e308",
    "1.7e308",
    "5e-324",
    "1e-320",
    "1e400",
    "nan",
    "-inf",
    "0,5",
    "1kg",
    "",
    "é",
    "1e",
    "1e99999999999",
    ".",
    "+",
    "0x10",
    "000000000000000000000000001",
    "1.0E-6",
    "−1",
];

#[test]
fn hostile_numbers() {
    let mut dice = Dice(7);
    for _ in 0..20_000 {
        let six: [&str; 6] = std::array::from_fn(|_| TEXTS[dice.roll() as usize % TEXTS.len()]);
        let mass = TEXTS[dice.roll() as usize % TEXTS.len()];
        let text = SLAB.robot_of(&six).replace("value=\"1.37\"", &format!("value=\"{mass}\""));
        let all = findings_with(&text, SLAB.geometry());
        for found in &all {
            assert!(found.numbers.iter().all(|(_, x)| x.is_finite()), "{found:#?}");
            assert!(text.get(found.span.clone()).is_some(), "{found:#?}");
            for (span, new) in found.repair.iter().flat_map(|r| &r.edits) {
                assert!(text.get(span.clone()).is_some() && new.parse::<f64>().is_ok(), "{found:#?}");
            }
        }
        if all.iter().any(|f| f.repair.is_some()) {
            let mut spans: Vec<_> = all
                .iter()
                .flat_map(|f| f.repair.iter().flat_map(|r| r.edits.iter().map(|e| e.0.clone())))
                .collect();
            spans.sort_by_key(|span| span.start);
            assert!(spans.windows(2).all(|w| w[0].end <= w[1].start), "{all:#?}");
        }
    }
}

/// Bodies of random points within the slab's bounds, with any mass. They are physical, but never
/// equal to the geometry. Only those with points so close to each other that the sum of the moments
/// is below a third of the slab's are suspect.
#[test]
fn bodies_of_any_kind_are_neither_impossible_nor_suspect() {
    let mut dice = Dice(11);
    let (mut suspect, mut dense) = (Vec::new(), 0);
    for k in 0..4000 {
        let edges = [0.1 + 0.1 * dice.part(), 0.1 + 0.2 * dice.part(), 0.1 + 0.3 * dice.part()];
        let slab = crate::check_common::Slab {
            // Densities of 20 to 20,000 kg/m³.
            mass: 20.0 * 10f64.powf(3.0 * dice.part()) * edges.iter().product::<f64>(),
            edges,
            attitude: [6.0 * dice.part(), 3.0 * dice.part(), 6.0 * dice.part()],
            frame: if k % 2 == 0 {
                [0.0; 3]
            } else {
                [6.0 * dice.part(), 3.0 * dice.part(), 6.0 * dice.part()]
            },
            ..SLAB
        };
        // Points in the slab's own frame, centred, and I = Σ m (r² 1 − r rᵀ).
        let points: Vec<[f64; 3]> =
            (0..2 + k % 9).map(|_| slab.edges.map(|edge| edge * (dice.part() - 0.5))).collect();
        let mean: [f64; 3] =
            std::array::from_fn(|j| points.iter().map(|p| p[j]).sum::<f64>() / points.len() as f64);
        let mut tensor = [[0.0; 3]; 3];
        for p in &points {
            let r: [f64; 3] = std::array::from_fn(|j| p[j] - mean[j]);
            let square: f64 = r.iter().map(|x| x * x).sum();
            for (i, row) in tensor.iter_mut().enumerate() {
                for (j, e) in row.iter_mut().enumerate() {
                    let one = if i == j { square } else { 0.0 };
                    *e += (one - r[i] * r[j]) * slab.mass / points.len() as f64;
                }
            }
        }
        let texts = crate::check_common::six(&tensor).map(|x| format!("{x:.*e}", 2 + k % 5));
        let all = findings_with(&slab.robot_of(&texts.each_ref().map(String::as_str)), slab.geometry());
        assert!(all.iter().all(|f| f.severity < Severity::Impossible), "{all:#?}");
        let is_dense = |f: &Finding| f.code == "inertia.geometry" && number(f, "ratio") < 1.0 / 3.0;
        if all.iter().any(|f| f.severity == Severity::Suspect && is_dense(f)) {
            dense += 1;
        } else if !is_clean(&all) {
            suspect.push(all);
        }
    }
    assert!(suspect.is_empty(), "{} of 4000: {suspect:#?}", suspect.len());
    assert!((1..1000).contains(&dense), "{dense}");
}

/// Names and texts in other alphabets, in every place.
#[test]
fn names_of_other_alphabets() {
    for name in ["élan_l", "左_l", "l_左", "lé", "L", "l", "FL", "ﬂ_left", "Left🤖Right"] {
        let text = SLAB.robot(SLAB.tensor()).replace("slab", name);
        assert_eq!(findings(&text), [], "{name}");
        assert_eq!(read(&text).links[0].name.text, name);
    }
}
