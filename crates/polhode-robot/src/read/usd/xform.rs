//! Transform of a prim relative to its parent: `xformOpOrder` and its operations.
//!
//! The first operation of the order is the outermost: x' = O₁ O₂ … x. Angles are in degrees,
//! quaternions are (w, x, y, z). Matrices act on row vectors from the right.
//!
//! Source: openusd.org, `UsdGeomXformable`.

use super::layer::Prim;
use super::value::Value;
use crate::model::{Number, Pose};
use crate::pose::{about, dot, product, unit};

/// Affine transform x' = L x + t.
#[derive(Clone, Debug)]
pub(super) struct Affine {
    pub(super) linear: [[f64; 3]; 3],
    pub(super) shift: [f64; 3],
    /// Operations whose numbers are unreadable or incomplete.
    pub(super) unreadable: Vec<Number>,
}

impl Affine {
    pub(super) const IDENTITY: Self = Self {
        linear: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        shift: [0.0; 3],
        unreadable: Vec::new(),
    };

    fn of_turn(rotation: [f64; 4]) -> Self {
        Self { linear: Pose::new([0.0; 3], rotation).matrix(), ..Self::IDENTITY }
    }

    pub(super) fn placed(&self, point: [f64; 3]) -> [f64; 3] {
        let turned = self.linear.map(|row| dot(row, point));
        [0, 1, 2].map(|k| turned[k] + self.shift[k])
    }

    pub(super) fn then(&self, inner: &Self) -> Self {
        let column = |k: usize| [0, 1, 2].map(|i| inner.linear[i][k]);
        let linear = self.linear.map(|row| [0, 1, 2].map(|k| dot(row, column(k))));
        let unreadable = self.unreadable.iter().chain(&inner.unreadable).cloned().collect();
        Self { linear, shift: self.placed(inner.shift), unreadable }
    }

    /// Returns true if it changes handedness: det < 0.
    pub(super) fn is_mirrored(&self) -> bool {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.linear;
        a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) < 0.0
    }

    /// Returns true if it does more than turn and move.
    pub(super) fn is_scaled(&self) -> bool {
        self.is_mirrored()
            || self
                .scaled_pose()
                .is_none_or(|(scale, _)| scale.iter().any(|factor| (factor - 1.0).abs() > 1e-5))
    }

    fn inverse(&self) -> Option<Self> {
        let [a, b, c] = self.linear;
        let cross = |u: [f64; 3], v: [f64; 3]| {
            [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        };
        let columns = [cross(b, c), cross(c, a), cross(a, b)];
        let determinant = dot(a, columns[0]);
        if determinant == 0.0 || !determinant.is_finite() {
            return None;
        }
        let linear = [0, 1, 2].map(|i| [0, 1, 2].map(|k| columns[k][i] / determinant));
        let inner = Self { linear, ..Self::IDENTITY };
        let shift = inner.placed(self.shift).map(|c| -c);
        Some(Self { shift, ..inner })
    }

    /// Returns the scale factors along the inner axes, and the pose without them; `None` if the
    /// axes are not orthogonal.
    pub(super) fn scaled_pose(&self) -> Option<([f64; 3], Pose)> {
        /// Tolerance for orthogonal axes: rounding in single precision.
        const RIGHT: f64 = 1e-5;
        self.scaled_pose_within(RIGHT)
    }

    /// Works like [`Affine::scaled_pose`], with this tolerance for the cosines between the axes.
    pub(super) fn scaled_pose_within(&self, tolerance: f64) -> Option<([f64; 3], Pose)> {
        let columns = [0, 1, 2].map(|k| self.linear.map(|row| row[k]));
        let lengths = columns.map(|column| dot(column, column).sqrt());
        if lengths.iter().any(|length| !(*length > 0.0 && length.is_finite())) {
            return None;
        }
        let [x, y, z] = [0, 1, 2].map(|k| columns[k].map(|c| c / lengths[k]));
        if dot(x, y).abs().max(dot(y, z).abs()).max(dot(x, z).abs()) > tolerance {
            return None;
        }
        let rotation = crate::pose::of_x_and_y(x, y)?;
        // A mirror reverses one axis. The shape keeps its size, and the attitude is that of the
        // other two axes.
        let pose = Pose { unreadable: self.unreadable.clone(), ..Pose::new(self.shift, rotation) };
        Some((lengths, pose))
    }

    /// Composes the operations of a prim. The flag is true if the transforms of its ancestors do
    /// not apply.
    pub(super) fn of(prim: &Prim, metres: f64) -> (Self, bool) {
        let mut all = Self::IDENTITY;
        let mut resets = false;
        for written in prim.properties.get("xformOpOrder").map_or(&[][..], |order| &order.words) {
            if written == "!resetXformStack!" {
                (all, resets) = (Self::IDENTITY, true);
                continue;
            }
            let (inverts, name) =
                written.strip_prefix("!invert!").map_or((false, written.as_str()), |name| (true, name));
            let Some(value) = prim.properties.get(name) else {
                // For example, an operation that has only time samples.
                let order = prim.properties.get("xformOpOrder");
                let span = order.map_or_else(|| prim.span.clone(), |order| order.span.clone());
                all.unreadable.push(Number { text: shown(name), span, value: None });
                continue;
            };
            let operation = Self::of_operation(name, value, metres);
            let operation = if inverts { operation.as_ref().and_then(Self::inverse) } else { operation };
            all = match operation {
                Some(operation) => all.then(&operation),
                None => {
                    all.unreadable.push(Number { text: shown(name), span: value.span.clone(), value: None });
                    all
                }
            };
        }
        (all, resets)
    }

    /// Returns one operation; `None` if its numbers are unreadable or incomplete.
    fn of_operation(name: &str, value: &Value, metres: f64) -> Option<Self> {
        let kind = name.strip_prefix("xformOp:")?.split(':').next()?;
        if let Some(axes) = kind.strip_prefix("rotate").filter(|axes| axes.len() == 3) {
            // The first-named axis rotates first; it is the innermost.
            let angles: [f64; 3] = numbers(value)?;
            let mut turn = Pose::IDENTITY.rotation;
            for axis in axes.bytes() {
                let number = usize::from(axis.checked_sub(b'X')?);
                turn = product(about(number, angles.get(number)?.to_radians()), turn);
            }
            return Some(Self::of_turn(turn));
        }
        Some(match kind {
            "translate" => Self { shift: numbers(value)?.map(|c: f64| metres * c), ..Self::IDENTITY },
            "scale" => {
                let [x, y, z]: [f64; 3] = numbers(value)?;
                Self { linear: [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]], ..Self::IDENTITY }
            }
            "orient" => Self::of_turn(unit(numbers(value)?)?),
            "rotateX" | "rotateY" | "rotateZ" => {
                let [angle]: [f64; 1] = numbers(value)?;
                let axis = usize::from(kind.bytes().next_back()?.checked_sub(b'X')?);
                Self::of_turn(about(axis, angle.to_radians()))
            }
            "transform" => {
                let m: [f64; 16] = numbers(value)?;
                let linear = [0, 1, 2].map(|i| [0, 1, 2].map(|k| m[4 * k + i]));
                Self { linear, shift: [12, 13, 14].map(|k| metres * m[k]), ..Self::IDENTITY }
            }
            _ => return None,
        })
    }
}

/// Returns the start of a name, for messages. All descendants may repeat it.
fn shown(name: &str) -> String {
    const MOST: usize = 80;
    name.chars().take(MOST).collect()
}

/// Returns exactly `N` finite numbers.
pub(super) fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let values: Vec<f64> = value.numbers.iter().map(|number| number.value).collect::<Option<_>>()?;
    values.try_into().ok().filter(|values: &[f64; N]| values.iter().all(|c| c.is_finite()))
}
