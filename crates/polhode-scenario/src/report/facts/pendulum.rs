//! Facts about a body suspended from an axis: its small oscillation and its actual swing.

use polhode::motion::{Pendulum, Swing};
use polhode_document::fact::{Fact, Quantity};
use polhode_document::unit;

pub(super) fn facts((pendulum, swing): &(Pendulum, Swing)) -> Vec<Fact> {
    let (kind, words, amplitude, period) = match *swing {
        Swing::Rest => ("rest", "at rest", Some(0.0), None),
        Swing::Oscillation { amplitude, period } => {
            ("oscillation", "to and fro", Some(amplitude), Some(period))
        }
        Swing::Separatrix => ("separatrix", "comes to rest upside down, after infinite time", None, None),
        Swing::Revolution { period } => ("revolution", "over the top", None, Some(period)),
    };
    let fact = |key: &str, label: &str, value: Quantity| Fact::new(format!("pendulum.{key}"), label, value);
    vec![
        fact("moment", "", Quantity::Number(pendulum.moment(), "kg·m²")),
        fact("arm_m", "", Quantity::Number(pendulum.arm(), "m")),
        fact("gravity_m_s2", "", Quantity::Number(pendulum.gravity(), "m/s²")),
        fact("angle_rad", "", Quantity::Angle(pendulum.angle())),
        fact("small_frequency_rad_s", "ω0", Quantity::Rate(pendulum.small_frequency()))
            .note("√(M g d / I), of small swings"),
        fact("small_period_s", "small swing", Quantity::Duration(pendulum.period(0.0))).note("period"),
        fact("swing", "this swing", Quantity::Word(kind, words.to_owned())),
        fact("amplitude_rad", "", amplitude.map(Quantity::Angle).into()),
        Fact::shown("amplitude", amplitude.map(|rad| Quantity::Text(format!("±{}", unit::amplitude(rad))))),
        fact("period_s", "period", period.map(Quantity::Duration).into()),
    ]
}
