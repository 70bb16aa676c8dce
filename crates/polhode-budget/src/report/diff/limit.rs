//! Limits in the words of the file.

use polhode_document::number::number;

use super::words::{direction, point};
use crate::report::limits::shown_unit;
use crate::{About, Limit, Measure, PrincipalAxis};

/// Returns words such as `center distance along z: most 2 mm, of predicted masses`.
pub(crate) fn in_words(limit: &Limit, digits: usize) -> String {
    let (unit, scale) = shown_unit(limit.of.unit());
    let bound = |word: &str, bound: Option<f64>| {
        bound.map(|x| format!("{word} {} {unit}", number(scale * x, digits)).trim_end().to_owned())
    };
    let bounds: Vec<String> =
        bound("least", limit.least).into_iter().chain(bound("most", limit.most)).collect();
    let of = measure(&limit.of, digits);
    format!("{of}: {}, of {} masses", bounds.join(", "), limit.basis.name())
}

fn measure(of: &Measure, digits: usize) -> String {
    let line = |what: &str, at: [f64; 3], along| {
        let from = if at == [0.0; 3] { String::new() } else { format!(" from {}", point(at, digits)) };
        format!("{what} along {}{from}", direction(along, digits))
    };
    match of {
        Measure::Mass => "mass".to_owned(),
        Measure::Center { along, from } => line("center", from.to_array(), *along),
        Measure::CenterFromPoint(from) => format!("center distance from {}", point(from.to_array(), digits)),
        Measure::CenterFromLine { point, along } => line("center distance", point.to_array(), *along),
        Measure::StaticUnbalance { point, along } => line("static unbalance", point.to_array(), *along),
        Measure::CoupleUnbalance { point, along } => line("couple unbalance", point.to_array(), *along),
        Measure::Moment { axis, about } => {
            format!("moment along {}{}", direction(*axis, digits), about_in_words(about, digits))
        }
        Measure::Product { axes: [a, b], sign, about } => {
            let axes = format!("{} and {}", direction(*a, digits), direction(*b, digits));
            format!("product of {axes}{}, {}", about_in_words(about, digits), sign.name())
        }
        Measure::PrincipalMoment(k) => format!("principal moment {}", k + 1),
        Measure::PrincipalRatio([a, b]) => format!("principal ratio of {} and {}", a + 1, b + 1),
        Measure::Tilt { axis, from } => {
            let axis = match axis {
                PrincipalAxis::Nearest => "the nearest axis".to_owned(),
                PrincipalAxis::Number(k) => format!("axis {}", k + 1),
            };
            format!("tilt of {axis} along {}", direction(*from, digits))
        }
        Measure::SpinRatio(along) => format!("spin ratio along {}", direction(*along, digits)),
        Measure::SpinStability(along) => format!("spin stability along {}", direction(*along, digits)),
    }
}

fn about_in_words(about: &About, digits: usize) -> String {
    match about {
        About::CenterOfMass => " about center".to_owned(),
        About::Point(at) => format!(" about {}", point(at.to_array(), digits)),
    }
}
