//! Quantities in a log of wrenches, their column names, and units in names: `fx_n`, `force_x_n`,
//! `Fx [N]`.

use polhode_source::unit;
use polhode_source::unit::{Dimension, UnitError};

/// Quantity in a log.
pub(crate) struct Quantity {
    /// Key in `columns` and `units`.
    pub key: &'static str,
    pub what: &'static str,
    pub dimension: Dimension,
    pub axes: &'static [&'static str],
    /// Accepted names before the axis.
    pub names: &'static [&'static str],
    /// Example of column names in a header.
    pub example: &'static str,
}

const XYZ: &[&str] = &["x", "y", "z"];

pub(crate) const TIME: Quantity = Quantity {
    key: "time",
    what: "time",
    dimension: Dimension::TIME,
    axes: &[""],
    names: &["time", "t"],
    example: "time_s",
};
pub(crate) const MEASURED: [Quantity; 5] = [
    Quantity {
        key: "omega",
        what: "angular velocity",
        dimension: Dimension::ANGULAR_VELOCITY,
        axes: XYZ,
        names: &["w", "omega", "omega_body", "gyro", "angular_velocity"],
        example: "wx_rad_s,wy_rad_s,wz_rad_s",
    },
    Quantity {
        key: "alpha",
        what: "angular acceleration",
        dimension: Dimension::ANGULAR_ACCELERATION,
        axes: XYZ,
        names: &["alpha", "alpha_body", "angular_acceleration"],
        example: "alphax_rad_s2,alphay_rad_s2,alphaz_rad_s2",
    },
    Quantity {
        key: "acceleration",
        what: "acceleration",
        dimension: Dimension::ACCELERATION,
        axes: XYZ,
        names: &["a", "acc", "acceleration"],
        example: "ax_m_s2,ay_m_s2,az_m_s2",
    },
    Quantity {
        key: "force",
        what: "force",
        dimension: Dimension::FORCE,
        axes: XYZ,
        names: &["f", "force"],
        example: "fx_n,fy_n,fz_n",
    },
    Quantity {
        key: "torque",
        what: "torque",
        dimension: Dimension::TORQUE,
        axes: XYZ,
        names: &["t", "tau", "torque"],
        example: "tx_n_m,ty_n_m,tz_n_m",
    },
];
pub(crate) const GRAVITY: Quantity = Quantity {
    key: "gravity",
    what: "gravity",
    dimension: Dimension::ACCELERATION,
    axes: XYZ,
    names: &["g", "gravity"],
    example: "gx_m_s2,gy_m_s2,gz_m_s2",
};
pub(crate) const ATTITUDE: Quantity = Quantity {
    key: "attitude",
    what: "attitude",
    dimension: Dimension::NONE,
    axes: &["w", "x", "y", "z"],
    names: &["q", "quaternion", "attitude"],
    example: "qw,qx,qy,qz",
};

/// Spelling of units in column names.
const SUFFIXES: [(&str, &str); 7] = [
    ("rad_s", "rad/s"),
    ("deg_s", "deg/s"),
    ("rad_s2", "rad/s^2"),
    ("deg_s2", "deg/s^2"),
    ("m_s2", "m/s^2"),
    ("n", "N"),
    ("n_m", "N m"),
];

/// Returns the part of a name after quantity and axis, if the name begins with them.
pub(crate) fn rest<'a>(name: &'a str, quantity: &Quantity, axis: &str) -> Option<&'a str> {
    quantity.names.iter().find_map(|own| {
        let (head, rest) = (name.get(..own.len())?, name.get(own.len()..)?);
        // Lower-case t is a time; upper-case T may be a temperature.
        let is_own =
            if *own == "t" && axis.is_empty() { head == *own } else { head.eq_ignore_ascii_case(own) };
        let rest = if axis.is_empty() { rest } else { rest.strip_prefix('_').unwrap_or(rest) };
        let (letter, rest) = (rest.get(..axis.len())?, rest.get(axis.len()..)?);
        let ends = rest.is_empty() || rest.starts_with(['_', ' ', '[', '(']);
        (is_own && letter.eq_ignore_ascii_case(axis) && ends).then_some(rest)
    })
}

/// Factor to SI, if a unit is present; or the unit and its error.
pub(crate) type Written = Result<Option<f64>, (String, UnitError)>;

/// Returns the unit at the end of a name, such as `_rad_s` or ` [rad/s]`; `None` if there is none.
pub(crate) fn written_unit(rest: &str, dimension: Dimension) -> Written {
    let rest = rest.trim();
    let unit = match (rest.strip_prefix(['[', '(']), rest.strip_prefix('_')) {
        (Some(inner), _) => inner.trim_end_matches([']', ')']).trim().to_owned(),
        (None, Some(suffix)) => {
            let known = SUFFIXES.iter().find(|(known, _)| *known == suffix);
            known.map_or_else(|| suffix.replace('_', " "), |(_, unit)| (*unit).to_owned())
        }
        (None, None) if rest.is_empty() => return Ok(None),
        (None, None) => rest.to_owned(),
    };
    if dimension == Dimension::NONE {
        return Ok(None);
    }
    unit::factor(&unit, dimension).map(Some).map_err(|error| (unit, error))
}

/// Returns the unit at the end of a name that begins with any text; otherwise the same as
/// [`written_unit`].
pub(crate) fn trailing_unit(name: &str, dimension: Dimension) -> Written {
    if let Some(open) = name.find(['[', '(']) {
        return written_unit(&name[open..], dimension);
    }
    let ends = name.match_indices('_').map(|(at, _)| &name[at..]);
    Ok(ends.filter_map(|end| written_unit(end, dimension).ok()).flatten().next())
}
