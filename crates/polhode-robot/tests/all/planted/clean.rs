//! Two thousand correct bodies of each kind, with realistic numbers of digits. Nothing above a note
//! is found.

use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::finding::Severity;
use polhode_robot::inspect::Inspection;
use polhode_robot::model::Link;

use super::inspected;
use super::language::Language;
use super::solid::{Solid, Spec};
use crate::check_common::{Matrix, conjugated, turn};

const BODIES: usize = 2000;

/// Random number generator SplitMix64.
struct Random(u64);

impl Random {
    fn word(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.word() >> 11) as f64 / (1_u64 << 53) as f64)
    }

    fn three(&mut self, low: f64, high: f64) -> [f64; 3] {
        std::array::from_fn(|_| self.between(low, high))
    }

    fn attitude(&mut self) -> Matrix {
        turn([self.between(-3.1, 3.1), self.between(-1.5, 1.5), self.between(-3.1, 3.1)])
    }

    /// Returns a box that contains two heavier boxes: a generic tensor, and a centre different from
    /// the box's.
    fn solid(&mut self) -> Solid {
        let size = 10_f64.powf(self.between(-1.7, -0.1));
        let edges = self.three(0.3, 1.0).map(|edge| edge * size);
        let (place, attitude) = (self.three(-0.7, 0.7).map(|c| c * size), self.attitude());
        let volume: f64 = edges.iter().product();
        let mass = volume * 10_f64.powf(self.between(2.5, 3.9));
        let shares = [self.between(0.5, 0.8), self.between(0.05, 0.2)];
        let shares = [shares[0], shares[1], 1.0 - shares[0] - shares[1]];
        let parts = shares.map(|share| {
            let inner = if share == shares[0] { [1.0; 3] } else { self.three(0.1, 0.3) };
            let shift: [f64; 3] =
                std::array::from_fn(|k| 0.5 * (1.0 - inner[k]) * edges[k] * self.between(-1.0, 1.0));
            let shift = attitude.map(|row| (0..3).map(|k| row[k] * shift[k]).sum::<f64>());
            let own = std::array::from_fn(|k| inner[k] * edges[k]);
            let at = std::array::from_fn(|k| place[k] + shift[k]);
            Solid::uniform(share * mass, own, at, attitude)
        });
        let mut whole = Solid::uniform(mass, edges, place, attitude);
        whole.center =
            std::array::from_fn(|k| parts.iter().map(|part| part.mass * part.center[k]).sum::<f64>() / mass);
        whole.tensor = [[0.0; 3]; 3];
        for mut part in parts {
            part.center = std::array::from_fn(|k| part.center[k] - whole.center[k]);
            let moved = part.about_origin();
            whole.tensor = std::array::from_fn(|i| std::array::from_fn(|j| whole.tensor[i][j] + moved[i][j]));
        }
        whole
    }

    /// Formats a number as people write it: significant digits, as a decimal or with an exponent.
    fn written(&mut self, x: f64, digits: usize, with_exponent: bool) -> String {
        let text = format!("{x:.*e}", digits - 1);
        if with_exponent { text } else { text.parse::<f64>().unwrap().to_string() }
    }

    /// Returns the rounded numbers of the body, in axes that the language supports.
    fn spec(&mut self, language: Language, solid: &Solid, name: &str) -> Spec {
        let mut spec = match language {
            Language::Usd => principal(solid, name),
            Language::Urdf | Language::Sdf | Language::UrdfOfMeshes => solid.framed(name, &self.attitude()),
            Language::Mjcf | Language::Osim => solid.full(name),
        };
        let digits = 3 + (self.word() % 6) as usize;
        let with_exponent = self.word().is_multiple_of(2);
        spec.mass = self.written(solid.mass, digits, with_exponent);
        let own = conjugated(&solid.tensor, &crate::check_common::transposed(&spec.frame));
        let six = crate::check_common::six(&own);
        let largest = six.iter().fold(0.0_f64, |max, x| max.max(x.abs()));
        for (text, x) in spec.six.iter_mut().zip(six) {
            let is_zero = x.abs() < 1e-12 * largest;
            *text = if is_zero { "0".to_owned() } else { self.written(x, digits, with_exponent) };
        }
        spec
    }
}

/// Returns the moments along the principal axes, by Jacobi rotations.
fn principal(solid: &Solid, name: &str) -> Spec {
    let mut frame = turn([0.0; 3]);
    for _ in 0..30 {
        let own = conjugated(&solid.tensor, &crate::check_common::transposed(&frame));
        let (i, j) = [(0, 1), (0, 2), (1, 2)]
            .into_iter()
            .max_by(|a, b| own[a.0][a.1].abs().total_cmp(&own[b.0][b.1].abs()))
            .unwrap();
        let angle = 0.5 * (2.0 * own[i][j]).atan2(own[i][i] - own[j][j]);
        let (sin, cos) = angle.sin_cos();
        let mut step = turn([0.0; 3]);
        (step[i][i], step[j][j], step[i][j], step[j][i]) = (cos, cos, -sin, sin);
        frame = super::solid::product(&frame, &step);
    }
    solid.framed(name, &frame)
}

#[test]
fn right_bodies_of_every_language_are_not_accused() {
    for language in Language::ALL {
        let mut random = Random(0x0517_2026 + language as u64);
        let specs: Vec<Spec> = (0..BODIES)
            .map(|k| {
                let solid = random.solid();
                random.spec(language, &solid, &format!("body_{k}"))
            })
            .collect();
        let (model, Inspection { findings, geometry }) =
            inspected(language, &language.model(&specs), &format!("clean-{language:?}"));
        let is_body = |link: &&Link| matches!(link_mass(model.format, link), Ok(LinkMass::Body(_)));
        assert_eq!(model.links.iter().filter(is_body).count(), BODIES, "{language:?}");
        let shapes = geometry.iter().filter(|geometry| !geometry.volumes.is_empty()).count();
        assert_eq!(shapes, if language == Language::Osim { 0 } else { BODIES }, "{language:?}");
        let accused: Vec<_> = findings.iter().filter(|finding| finding.severity > Severity::Note).collect();
        assert!(accused.is_empty(), "{language:?}: {} of {BODIES}: {:#?}", accused.len(), accused[0]);
    }
}
