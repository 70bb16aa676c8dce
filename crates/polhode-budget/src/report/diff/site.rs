//! Sites of ballast in the words of the file.

use polhode_document::number::number;

use super::words::{direction, point};
use crate::{BallastPlace, Round, Site};

/// Returns words such as `at (0, 0, -10) mm, radius 80 mm, normal z, rim; most 0.2 kg`.
pub(crate) fn in_words(site: &Site, digits: usize) -> String {
    let round = |round: &Round| {
        format!(
            "at {}, radius {} mm, normal {}",
            point(round.center.to_array(), digits),
            number(1e3 * round.radius, digits),
            direction(round.normal, digits)
        )
    };
    let mut words = vec![match &site.place {
        BallastPlace::Point(at) => format!("at {}", point(at.to_array(), digits)),
        BallastPlace::Line([at, to]) => {
            format!("at {} to {}", point(at.to_array(), digits), point(to.to_array(), digits))
        }
        BallastPlace::Disc(disc) => round(disc),
        BallastPlace::Circle(circle) => format!("{}, rim", round(circle)),
    }];
    words.extend(site.most.map(|most| format!("most {} kg", number(most, digits))));
    if !site.sizes.is_empty() {
        let sizes: Vec<String> = site.sizes.iter().map(|size| number(*size, digits)).collect();
        words.push(format!("sizes {} kg", sizes.join(", ")));
    }
    words.join("; ")
}
