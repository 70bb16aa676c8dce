//! Signed distance functions of MuJoCo's five plugins: torus, bowl, gear, nut and bolt, in metres.
//!
//! Source: MuJoCo 3.12, `plugin/sdf`; formulas from iquilezles.org (bowl) and shadertoy.com (gear
//! 3lG3WR, nut and bolt XtffzX).

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use crate::read::xml::Element;

/// Shape with its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Shape {
    Torus { ring: f64, tube: f64 },
    Bowl { height: f64, radius: f64, thickness: f64 },
    Gear { alpha: f64, diameter: f64, teeth: f64, thickness: f64, inner_diameter: f64 },
    Nut { radius: f64 },
    Bolt { radius: f64 },
}

impl Shape {
    /// Reads the `<config>` elements of a plugin.
    pub(super) fn of(plugin: &str, element: Element<'_>) -> Result<Self, String> {
        let keys: &[&str] = match plugin {
            "mujoco.sdf.torus" => &["radius1", "radius2"],
            "mujoco.sdf.bowl" => &["height", "radius", "thickness"],
            "mujoco.sdf.gear" => &["alpha", "diameter", "teeth", "thickness", "innerdiameter"],
            "mujoco.sdf.nut" | "mujoco.sdf.bolt" => &["radius"],
            _ => return Err(format!("its mesh is made by a plugin, {plugin:?}")),
        };
        for config in element.named("config") {
            let key = config.word("key").unwrap_or("");
            if !keys.contains(&key) {
                return Err(format!("{key:?} is no key of the plugin {plugin}, which makes its mesh"));
            }
        }
        let number = |key: &str, default: f64| {
            let config = element.named("config").find(|config| config.word("key") == Some(key));
            let written = config.and_then(|config| config.word("value")).filter(|value| !value.is_empty());
            written.map_or(Ok(default), |value| {
                value.parse().map_err(|_| format!("{key}={value:?} of its mesh's plugin is no number"))
            })
        };
        Ok(match plugin {
            "mujoco.sdf.torus" => {
                Self::Torus { ring: number("radius1", 0.35)?, tube: number("radius2", 0.15)? }
            }
            "mujoco.sdf.bowl" => Self::Bowl {
                height: number("height", 0.4)?,
                radius: number("radius", 1.0)?,
                thickness: number("thickness", 0.02)?,
            },
            "mujoco.sdf.gear" => Self::Gear {
                alpha: number("alpha", 0.0)?,
                diameter: number("diameter", 2.8)?,
                teeth: number("teeth", 25.0)?,
                thickness: number("thickness", 0.2)?,
                inner_diameter: number("innerdiameter", -1.0)?,
            },
            "mujoco.sdf.nut" => Self::Nut { radius: number("radius", 0.26)? },
            _ => Self::Bolt { radius: number("radius", 0.26)? },
        })
    }

    /// Returns the half edges of the box that MuJoCo samples.
    pub(super) fn half_box(self) -> [f64; 3] {
        match self {
            Self::Torus { ring, tube } => [ring + tube, ring + tube, tube],
            Self::Bowl { radius, thickness, .. } => [radius + thickness; 3],
            Self::Gear { diameter, thickness, .. } => {
                [0.5 * diameter * 1.25, 0.5 * diameter * 1.25, 0.5 * thickness * 1.1]
            }
            Self::Nut { .. } | Self::Bolt { .. } => [0.6, 0.6, 1.0],
        }
    }

    /// Returns the signed distance of a point, negative inside.
    pub(super) fn distance(self, point: [f64; 3]) -> f64 {
        let [x, y, z] = point;
        let rho = norm(x, y);
        match self {
            Self::Torus { ring, tube } => norm(rho - ring, z) - tube,
            Self::Bowl { height, radius, thickness } => {
                let width = (radius * radius - height * height).sqrt();
                let above_rim = height * rho < width * z;
                let middle =
                    if above_rim { norm(rho - width, z - height) } else { (norm(rho, z) - radius).abs() };
                middle - thickness
            }
            Self::Gear { thickness, .. } => {
                let (flat, high) = (self.gear(x, y, rho), z.abs() - 0.5 * thickness);
                flat.max(high).min(0.0) + norm(flat.max(0.0), high.max(0.0))
            }
            Self::Nut { radius } => {
                let out = rho - radius;
                let cone = (z - out) * FRAC_1_SQRT_2;
                let hole = less(thread(point, out), cone + 0.5 * FRAC_1_SQRT_2);
                let hole = hole.min(-cone - 0.05 * FRAC_1_SQRT_2);
                less(head(point, out), hole)
            }
            Self::Bolt { radius } => {
                let out = rho - radius;
                let cone = (z - out) * FRAC_1_SQRT_2;
                let shaft = less(thread(point, out), 0.5 - (z + 0.5).abs());
                less(shaft, cone + FRAC_1_SQRT_2).min(head(point, out))
            }
        }
    }

    /// Returns the distance in the plane of a gear: involutes between circles.
    fn gear(self, x: f64, y: f64, rho: f64) -> f64 {
        let Self::Gear { alpha, diameter, teeth, inner_diameter, .. } = self else { return f64::NAN };
        let pressure = 3.096e-5 * teeth * teeth - 6.557e-3 * teeth + 0.551;
        let pitch = teeth / diameter;
        let outer = 0.5 * (diameter + 2.0 / pitch);
        let depth = 2.2 / pitch;
        let inner =
            if inner_diameter >= 0.0 { 0.5 * inner_diameter } else { outer - depth - 0.14 * diameter };
        if inner - rho > 0.0 {
            return inner - rho;
        }
        if outer - rho < -0.2 {
            return rho - outer;
        }
        let base = 0.5 * diameter * libm::cos(pressure);
        let angle = libm::atan2(y, x) + alpha;
        let stride = PI / pitch / (0.5 * diameter);
        let at_pitch = libm::acos(base / (0.5 * diameter));
        let shift = 0.5 * stride - 2.0 * (libm::tan(at_pitch) - at_pitch);
        let within = |angle: f64| angle - stride * (angle / stride).floor();
        let left = within(angle + 0.5 * shift) - 0.5 * shift;
        let right = within(-angle - shift + 0.5 * shift) - 0.5 * shift;
        let involute = |theta: f64| match base < rho {
            true => (rho * rho - base * base).sqrt() - base * (theta + libm::acos(base / rho)),
            false => -1e6,
        };
        let walls = (left - (stride - shift)).max(right - (stride - shift));
        let cogs = walls.max(involute(left).max(involute(right)));
        let cogs = smooth_intersection(rho - outer, cogs, 0.0035 * diameter);
        let cogs = smooth_union(rho - (outer - depth), cogs, base - outer + depth);
        less(cogs, rho - inner)
    }
}

/// Returns the distance to a screw thread; `out` is the distance of the point from its cylinder.
fn thread([x, y, z]: [f64; 3], out: f64) -> f64 {
    const TURNS: f64 = 12.0;
    let turn = z * TURNS - libm::atan2(y, x) / PI / 2.0;
    let triangle = (turn - turn.floor() - 0.5).abs();
    (out - triangle / TURNS) * FRAC_1_SQRT_2
}

/// Returns the distance to the hexagon of a nut or of the head of a bolt.
fn head([x, y, z]: [f64; 3], out: f64) -> f64 {
    let sixth = 6.0 / PI / 2.0;
    let angle = -(libm::atan2(y, x) * sixth + 0.5).floor() / sixth;
    let across = libm::sin(angle + 0.5 * PI) * x - libm::sin(angle) * y;
    (across - 0.5).max((z + 0.25).abs() - 0.25).max((z + out - 0.22) * FRAC_1_SQRT_2)
}

fn norm(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}

/// Returns the distance of the difference of two shapes.
fn less(a: f64, b: f64) -> f64 {
    a.max(-b)
}

fn smooth_union(a: f64, b: f64, width: f64) -> f64 {
    let share = (0.5 + 0.5 * (b - a) / width).clamp(0.0, 1.0);
    b * (1.0 - share) + a * share - width * share * (1.0 - share)
}

fn smooth_intersection(a: f64, b: f64, width: f64) -> f64 {
    less(a.max(b), smooth_union(less(a, b), less(b, a), width))
}
