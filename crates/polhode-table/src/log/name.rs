//! Parser for names of columns. For example, `robot.angularVelocity_y [deg/s]` is the y component
//! of an angular velocity, in deg/s.

use polhode::infer::judge::{AttitudeSense, OmegaAxes};

/// Parts of the name of a column.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Name {
    /// Common part of the names of a group: without the label and without the unit.
    pub group: String,
    /// Possible meaning of the numbers.
    pub kind: Kind,
    /// Label within its group: `x`, `11`; empty for a time.
    pub label: String,
    /// Axes of an angular velocity.
    pub axes: Option<OmegaAxes>,
    /// Direction of a rotation.
    pub sense: Option<AttitudeSense>,
    /// Unit in its usual spelling.
    pub unit: Option<String>,
    /// Distance from the plain name of a quantity: 0 for the plain name. It is greater with
    /// preceding words, and for a sensor.
    pub distance: u8,
}

/// Possible meaning of the numbers in a group of columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Time,
    /// Quaternion or matrix. The number of columns decides.
    Attitude,
    Omega,
    Euler,
}

/// Words for a time, without blanks. The last ones have no obvious default unit.
const TIMES: &str = "t time simtime simulationtime elapsed elapsedtime seconds timestamp stamp";
/// Words for times that programs write in milliseconds, microseconds or nanoseconds.
const STAMPS: &str = "timestamp stamp";
const ATTITUDES: &str = "q quat quaternion attitude att orientation orient rotation rot r rotmat rotationmatrix rmat dcm \
                         directioncosinematrix cosinematrix matrix mat xmat xquat m c a";
const OMEGAS: &str =
    "omega w gyro gyroscope angvel angularvel angularvelocity angvelocity angularrate angular rate rates om";
/// Words for sensors. Their axes are those of the body, and another column may have the angular
/// velocity itself.
const GYROS: &str = "gyro gyroscope";
const EULERS: &str = "euler eulerangle eulerangles eul rpy";
const ANGLES: &str = "roll pitch yaw phi theta psi precession nutation spin";
/// Words that change the meaning of a name.
const OTHERS: &str = "target desired des cmd command commanded ref reference setpoint error err delta dot wheel rotor orbit initial \
                      cpu wall compute step solver std sigma cov covariance var variance accel acceleration torque moment";
const SPACE: &str = "space world inertial global eci";

/// Units as written at the end of names, and as read by [`polhode_source::unit`]. Longer ones are
/// first.
const UNITS: [(&str, &str); 33] = [
    ("rad per sec", "rad/s"),
    ("deg per sec", "deg/s"),
    ("rad per s", "rad/s"),
    ("deg per s", "deg/s"),
    ("rad sec", "rad/s"),
    ("deg sec", "deg/s"),
    ("mrad s", "mrad/s"),
    ("rad s", "rad/s"),
    ("deg s", "deg/s"),
    ("radps", "rad/s"),
    ("degps", "deg/s"),
    ("rads", "rad/s"),
    ("degs", "deg/s"),
    ("dps", "deg/s"),
    ("rpm", "rpm"),
    ("radians", "rad"),
    ("radian", "rad"),
    ("degrees", "deg"),
    ("degree", "deg"),
    ("mrad", "mrad"),
    ("rad", "rad"),
    ("deg", "deg"),
    ("seconds", "s"),
    ("second", "s"),
    ("secs", "s"),
    ("sec", "s"),
    ("milliseconds", "ms"),
    ("ms", "ms"),
    ("us", "us"),
    ("µs", "us"),
    ("usec", "us"),
    ("ns", "ns"),
    ("s", "s"),
];

impl Name {
    /// Parses a name. Returns `None` if it does not belong to a motion.
    pub(crate) fn of(text: &str) -> Option<Self> {
        let (text, bracketed) = split_bracket(text.trim());
        let mut words = words(text);
        let unit = match bracketed {
            Some("" | "-" | "1") => None,
            Some(unit) => Some(spelt_unit(unit)),
            None => take_unit(&mut words),
        };
        if words.iter().any(|word| has(OTHERS, word)) {
            return None;
        }
        let group = words.join("_");
        let plain = Self {
            group,
            kind: Kind::Time,
            label: String::new(),
            axes: None,
            sense: None,
            unit,
            distance: 0,
        };
        if let Some((distance, word)) = stem(&words, TIMES) {
            return (word != "t" || distance == 0).then_some(Self { distance, ..plain });
        }
        let label = take_label(&mut words)?;
        let (axes, sense, stems) = qualifiers(&words);
        let group = words.join("_");
        let is_letter = label.len() == 1 && "wxyz".contains(&label);
        let named = Self { group, label, sense, ..plain };
        if has(ANGLES, &named.label) {
            let distance = u8::try_from(stems.len()).unwrap_or(u8::MAX);
            return Some(Self { kind: Kind::Euler, distance, ..named });
        }
        if let Some((distance, word)) = stem(&stems, OMEGAS) {
            let is_sensor = has(GYROS, &word);
            let axes = axes.or(is_sensor.then_some(OmegaAxes::Body));
            let distance = distance.saturating_add(u8::from(is_sensor));
            return Some(Self { kind: Kind::Omega, axes, distance, ..named });
        }
        if let Some((distance, _)) = stem(&stems, EULERS) {
            return Some(Self { kind: Kind::Euler, distance, ..named });
        }
        // Plain w, x, y, z are a quaternion if all four exist.
        let (distance, word) =
            if stems.is_empty() && is_letter { (2, String::new()) } else { stem(&stems, ATTITUDES)? };
        // After other words, one letter is not enough: `kg_m2`.
        let is_said = distance == 0 || !has("m c a", &word);
        is_said.then_some(Self { kind: Kind::Attitude, distance, ..named })
    }

    /// Returns true if a time with this name needs a unit.
    pub(crate) fn is_stamp(&self) -> bool {
        self.kind == Kind::Time && self.group.rsplit('_').next().is_some_and(|word| has(STAMPS, word))
    }
}

/// Returns a unit in the spelling of [`polhode_source::unit`].
pub(crate) fn spelt_unit(text: &str) -> String {
    let joined = words(text).join(" ");
    let known = UNITS.iter().find(|(written, _)| *written == joined);
    known.map_or_else(|| text.to_owned(), |(_, unit)| (*unit).to_owned())
}

fn has(list: &str, word: &str) -> bool {
    list.split_whitespace().any(|known| known == word)
}

/// Splits a name from the text in brackets at its end, unless that is an index.
fn split_bracket(text: &str) -> (&str, Option<&str>) {
    let split = text.strip_suffix([']', ')']).and_then(|open| open.rsplit_once(['[', '(']));
    match split {
        Some((name, unit)) if !unit.chars().all(|c| c.is_ascii_digit()) || unit.is_empty() => {
            (name.trim(), Some(unit.trim()))
        }
        _ => (text, None),
    }
}

/// Splits a name into words, in lower case. Words end at a character that is not a letter or a
/// digit, before a capital after a small letter, and between letters and digits.
fn words(text: &str) -> Vec<String> {
    let spelt = text.replace(['ω', 'Ω'], " omega ").replace(['φ', 'ϕ', 'Φ'], " phi ");
    let spelt = spelt.replace('°', " deg ").replace(['θ', 'ϑ', 'Θ'], " theta ").replace(['ψ', 'Ψ'], " psi ");
    let mut words = vec![String::new()];
    let mut before = ' ';
    for c in spelt.chars() {
        let parts = before.is_lowercase() && c.is_uppercase()
            || before.is_alphabetic() && c.is_ascii_digit()
            || before.is_ascii_digit() && c.is_alphabetic();
        if parts || !c.is_alphanumeric() {
            words.push(String::new());
        }
        if let Some(word) = words.last_mut().filter(|_| c.is_alphanumeric()) {
            word.extend(c.to_lowercase());
        }
        before = c;
    }
    words.retain(|word| !word.is_empty());
    words
}

/// Removes the unit from the end. A single word is not a unit.
fn take_unit(words: &mut Vec<String>) -> Option<String> {
    let joined = words.join(" ");
    let (written, unit) = UNITS
        .iter()
        .find(|(written, _)| joined.strip_suffix(written).is_some_and(|rest| rest.ends_with(' ')))?;
    words.truncate(words.len() - written.split(' ').count());
    Some((*unit).to_owned())
}

/// Returns the axes and the sense that words state, and the remaining words.
fn qualifiers(words: &[String]) -> (Option<OmegaAxes>, Option<AttitudeSense>, Vec<String>) {
    let is_space = |word: &str| has(SPACE, word);
    let (mut axes, mut sense, mut rest) = ([false; 2], None, Vec::new());
    let mut at = 0;
    while at < words.len() {
        let three = [0, 1, 2].map(|k| words.get(at + k).map_or("", String::as_str));
        match three {
            ["body", "to" | "2", to] if is_space(to) => {
                (sense, at) = (Some(AttitudeSense::BodyToSpace), at + 3);
            }
            [from, "to" | "2", "body"] if is_space(from) => {
                (sense, at) = (Some(AttitudeSense::SpaceToBody), at + 3);
            }
            // `R_body_space` has different meanings in different programs.
            ["body", other, _] if is_space(other) => at += 2,
            [other, "body", _] if is_space(other) => at += 2,
            ["body", ..] => (axes[0], at) = (true, at + 1),
            [word, ..] if is_space(word) => (axes[1], at) = (true, at + 1),
            [word, ..] => {
                rest.push(word.to_owned());
                at += 1;
            }
        }
    }
    let axes = match axes {
        [true, false] => Some(OmegaAxes::Body),
        [false, true] => Some(OmegaAxes::Space),
        _ => None,
    };
    (axes, sense, rest)
}

/// Finds the last words, written as one, in a list. Returns the number of preceding words, and the
/// word of the list.
fn stem(words: &[String], list: &str) -> Option<(u8, String)> {
    (0..words.len()).find_map(|start| {
        let joined = words[start..].concat();
        has(list, &joined).then(|| (u8::try_from(start).unwrap_or(u8::MAX), joined))
    })
}

/// Removes the label from the end: `x`, `11`, or the w of `qw`.
fn take_label(words: &mut Vec<String>) -> Option<String> {
    let last = words.pop()?;
    if has("w x y z i j k real", &last) || is_pair(&last) || has(ANGLES, &last) {
        return Some(last);
    }
    if last.bytes().all(|b| b.is_ascii_digit()) {
        let first =
            words.pop_if(|word| last.len() == 1 && word.len() == 1 && word.as_bytes()[0].is_ascii_digit());
        return Some(first.unwrap_or_default() + &last);
    }
    let length = [2, 1].into_iter().find(|length| {
        let at = last.len().saturating_sub(*length);
        at > 0 && last.get(at..).is_some_and(|end| is_pair(end) || has("w x y z", end))
    })?;
    let label = last.get(last.len() - length..)?.to_owned();
    words.push(last.get(..last.len() - length)?.to_owned());
    Some(label)
}

/// Returns true for two letters of axes, as for elements of matrices.
fn is_pair(text: &str) -> bool {
    text.len() == 2 && text.bytes().all(|b| b"xyz".contains(&b))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(text: &str) -> Option<(Kind, String, Option<String>, u8)> {
        Name::of(text).map(|name| (name.kind, name.label, name.unit, name.distance))
    }

    #[test]
    fn names_are_taken_apart() {
        for (text, kind, label, unit, distance) in [
            ("time_s", Kind::Time, "", "s", 0),
            ("Time (ms)", Kind::Time, "", "ms", 0),
            ("simTime", Kind::Time, "", "", 0),
            ("seconds", Kind::Time, "", "", 0),
            ("robot.timestamp_us", Kind::Time, "", "us", 1),
            ("qw", Kind::Attitude, "w", "", 0),
            ("attitude_w", Kind::Attitude, "w", "", 0),
            ("/imu/orientation/w", Kind::Attitude, "w", "", 1),
            ("orientation.x", Kind::Attitude, "x", "", 0),
            ("quat_3", Kind::Attitude, "3", "", 0),
            ("q[0]", Kind::Attitude, "0", "", 0),
            ("quatReal", Kind::Attitude, "real", "", 0),
            ("r11", Kind::Attitude, "11", "", 0),
            ("R_0_2", Kind::Attitude, "02", "", 0),
            ("DCM[1][2]", Kind::Attitude, "12", "", 0),
            ("rotation_matrix_xz", Kind::Attitude, "xz", "", 0),
            ("Rxy", Kind::Attitude, "xy", "", 0),
            ("w", Kind::Attitude, "w", "", 2),
            ("omega_body_x_rad_s", Kind::Omega, "x", "rad/s", 0),
            ("wx", Kind::Omega, "x", "", 0),
            ("ωz [°/s]", Kind::Omega, "z", "deg/s", 0),
            ("robot.angularVelocity_y [rad/sec]", Kind::Omega, "y", "rad/s", 1),
            ("gyro_x_dps", Kind::Omega, "x", "deg/s", 1),
            ("omega[2]", Kind::Omega, "2", "", 0),
            ("Roll (deg)", Kind::Euler, "roll", "deg", 0),
            ("euler_phi_rad", Kind::Euler, "phi", "rad", 1),
            ("euler_x", Kind::Euler, "x", "", 0),
            ("θ", Kind::Euler, "theta", "", 0),
        ] {
            let unit = Some(unit.to_owned()).filter(|unit| !unit.is_empty());
            assert_eq!(said(text), Some((kind, label.to_owned(), unit, distance)), "{text}");
        }
        for text in [
            "",
            "x_t",
            "index",
            "mass_kg",
            "velocity_x",
            "position_y",
            "momentum_space_x_kg_m2_s",
            "torque_body_x_n_m",
            "kinetic_energy_j",
            "wheel_1_speed_rad_s",
            "orbit_roll_rad",
            "attitude_error_rad",
            "q_dot_w",
            "target_qw",
            "Ixx",
            "q",
            "roll_rate",
            "linear_acceleration.x",
            "max",
            "delta_t",
            "_",
            "w_é",
        ] {
            assert_eq!(said(text), None, "{text}");
        }
    }

    #[test]
    fn axes_and_senses_are_what_is_said() {
        let axes = |text: &str| Name::of(text).unwrap().axes;
        assert_eq!(axes("omega_body_x"), Some(OmegaAxes::Body));
        assert_eq!(axes("bodyRates.x"), Some(OmegaAxes::Body));
        assert_eq!(axes("gyro_x"), Some(OmegaAxes::Body));
        assert_eq!(axes("omega_world_x"), Some(OmegaAxes::Space));
        assert_eq!(axes("wx"), None);
        let sense = |text: &str| Name::of(text).unwrap().sense;
        assert_eq!(sense("q_body_to_world_w"), Some(AttitudeSense::BodyToSpace));
        assert_eq!(sense("R_eci2body_11"), Some(AttitudeSense::SpaceToBody));
        assert_eq!(sense("R_body_space_11"), None);
        assert_eq!(sense("qw"), None);
    }
}
