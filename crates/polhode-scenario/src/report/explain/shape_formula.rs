//! Formulas for the tensors of shapes, with their integrals.

use std::f64::consts::PI;

use polhode::body::{BodyPart, Form};

use super::working::n;

/// Tensor of a shape about its centroid, along its own axes, as formulas and values.
pub(crate) struct Derived {
    /// Kind of shape, `:   `, and the integral with its result; as Unicode and as LaTeX.
    pub formula: [&'static str; 2],
    /// Dimensions in words, such as `a, b, c = 1, 2, 3 m`.
    pub measures: String,
    /// Moments Ixx, Iyy and Izz: formula and value, kg·m².
    pub moments: [(&'static str, f64); 3],
}

/// Returns the formulas for a part's tensor; `None` for other shapes.
///
/// Shapes with products of inertia along their own axes have no formulas here.
pub(crate) fn of(part: &BodyPart) -> Option<Derived> {
    let m = part.properties.mass();
    let sq = |x: f64| x * x;
    Some(match (&part.form.as_ref()?.form, part.kind) {
        (Form::Box { size: [a, b, c] }, "box") => Derived {
            formula: [
                "box of edges a, b, c:   (m/a) ∫ x² dx over ±a/2 = m a²/12,   Ixx = m (b² + c²)/12",
                r"\frac{m}{a} \int_{-a/2}^{a/2} x^2 dx = \frac{m a^2}{12}, \qquad I_{xx} = \frac{m}{12} (b^2 + c^2)",
            ],
            measures: format!("a, b, c = {}, {}, {} m", n(*a), n(*b), n(*c)),
            moments: [
                ("m (b² + c²)/12", m * (b * b + c * c) / 12.0),
                ("m (c² + a²)/12", m * (c * c + a * a) / 12.0),
                ("m (a² + b²)/12", m * (a * a + b * b) / 12.0),
            ],
        },
        (Form::Box { size: [a, b, c] }, "box_shell") => {
            // Two opposite plates per edge; masses are proportional to areas.
            let area = a * b + b * c + c * a;
            let pair = |x: f64, y: f64| m * x * y / area;
            let along = |edge: f64, x: f64, y: f64| {
                (pair(edge, x) + pair(edge, y)) * sq(edge) / 12.0 + pair(x, y) * sq(edge) / 4.0
            };
            let [x, y, z] = [along(*a, *b, *c), along(*b, *c, *a), along(*c, *a, *b)];
            Derived {
                formula: [
                    "shell of a box, by its six faces:   S = ab + bc + ca,   ∫ x² dm = m a² [(ab + ca)/12 + bc/4] / S,   Ixx = ∫ y² dm + ∫ z² dm",
                    r"S = ab + bc + ca, \qquad \int x^2 dm = \frac{m a^2}{S} \left(\frac{ab + ca}{12} + \frac{bc}{4}\right), \qquad I_{xx} = \int y^2 dm + \int z^2 dm",
                ],
                measures: format!("a, b, c = {}, {}, {} m", n(*a), n(*b), n(*c)),
                moments: [
                    ("∫ y² dm + ∫ z² dm", y + z),
                    ("∫ z² dm + ∫ x² dm", z + x),
                    ("∫ x² dm + ∫ y² dm", x + y),
                ],
            }
        }
        (Form::Ellipsoid { semi_axes: [r, ..] }, "sphere") => Derived {
            formula: [
                "sphere of radius r:   ∫ x² dm = (1/3) ∫ ρ² 4πρ² dρ · m / (4πr³/3) = m r²/5,   Ixx = (2/5) m r²",
                r"\int x^2 dm = \frac13 \frac{m}{\tfrac43 \pi r^3} \int_0^r \rho^2 4\pi \rho^2 d\rho = \frac{m r^2}{5}, \qquad I_{xx} = \frac25 m r^2",
            ],
            measures: format!("r = {} m", n(*r)),
            moments: [("(2/5) m r²", 0.4 * m * r * r); 3],
        },
        (Form::Ellipsoid { semi_axes: [r, ..] }, "sphere_shell") => Derived {
            formula: [
                "shell of a sphere:   ∫ x² dm = (1/3) ∫ r² dm = m r²/3,   Ixx = (2/3) m r²",
                r"\int x^2 dm = \frac13 \int r^2 dm = \frac{m r^2}{3}, \qquad I_{xx} = \frac23 m r^2",
            ],
            measures: format!("r = {} m", n(*r)),
            moments: [("(2/3) m r²", m * r * r / 1.5); 3],
        },
        (Form::Ellipsoid { semi_axes: [a, b, c] }, "ellipsoid") => Derived {
            formula: [
                "ellipsoid of semi-axes a, b, c, a sphere stretched:   ∫ x² dm = m a²/5,   Ixx = m (b² + c²)/5",
                r"\int x^2 dm = \frac{m a^2}{5}, \qquad I_{xx} = \frac{m}{5} (b^2 + c^2)",
            ],
            measures: format!("a, b, c = {}, {}, {} m", n(*a), n(*b), n(*c)),
            moments: [
                ("m (b² + c²)/5", m * (b * b + c * c) / 5.0),
                ("m (c² + a²)/5", m * (c * c + a * a) / 5.0),
                ("m (a² + b²)/5", m * (a * a + b * b) / 5.0),
            ],
        },
        (Form::HollowSphere { radius: outer, inner_radius: r }, "sphere") => hollow_sphere(m, *outer, *r),
        (Form::Cylinder { radius: r, inner_radius: 0.0, length: l }, "cylinder") => cylinder(m, *r, *l),
        (Form::Cylinder { radius: outer, inner_radius: r, length: l }, "cylinder") => {
            hollow_cylinder(m, *outer, *r, *l)
        }
        (Form::ConeShell { base_radius: a, top_radius: b, height: h, ends: false }, _) => {
            cone_shell(m, *a, *b, *h)
        }
        (Form::ConeShell { base_radius: a, top_radius: b, height: h, ends: true }, _) => {
            closed_cone_shell(m, *a, *b, *h)
        }
        (Form::Cone { base_radius: a, top_radius: b, height: h }, "cone") if a == b => cylinder(m, *a, *h),
        (Form::Cylinder { radius: r, inner_radius, length: l }, "cylinder_shell") if inner_radius == r => {
            let across = m * (6.0 * r * r + l * l) / 12.0;
            Derived {
                formula: [
                    "tube of radius r and length l along z:   Izz = m r²,   ∫ x² dm = m r²/2,   ∫ z² dm = m l²/12",
                    r"I_{zz} = m r^2, \qquad \int x^2 dm = \frac{m r^2}{2}, \qquad \int z^2 dm = \frac{m l^2}{12}",
                ],
                measures: format!("r = {}, l = {} m", n(*r), n(*l)),
                moments: [("m (6 r² + l²)/12", across), ("m (6 r² + l²)/12", across), ("m r²", m * r * r)],
            }
        }
        (Form::Cylinder { radius: r, length: l, .. }, "cylinder_shell") => {
            // Tube and two end plates; masses are proportional to areas.
            let (tube, ends) = (m * l / (l + r), m * r / (l + r));
            let across = tube * (6.0 * r * r + l * l) / 12.0 + ends * (r * r + l * l) / 4.0;
            Derived {
                formula: [
                    "tube with two ends, masses by area:   mt = m l/(l + r),   me = m r/(l + r),   Izz = mt r² + me r²/2,   Ixx = mt (6 r² + l²)/12 + me (r² + l²)/4",
                    r"m_t = \frac{m l}{l + r}, \qquad m_e = \frac{m r}{l + r}, \qquad I_{zz} = m_t r^2 + \tfrac12 m_e r^2, \qquad I_{xx} = \frac{m_t}{12} (6 r^2 + l^2) + \frac{m_e}{4} (r^2 + l^2)",
                ],
                measures: format!("r = {}, l = {} m,  mt = {}, me = {} kg", n(*r), n(*l), n(tube), n(ends)),
                moments: [
                    ("mt (6 r² + l²)/12 + me (r² + l²)/4", across),
                    ("mt (6 r² + l²)/12 + me (r² + l²)/4", across),
                    ("mt r² + me r²/2", tube * r * r + 0.5 * ends * r * r),
                ],
            }
        }
        (Form::Cone { base_radius: a, top_radius: b, height: h }, "cone") => cone(m, *a, *b, *h),
        (Form::Capsule { radius: r, length: l }, "capsule") => {
            let volume = PI * r * r * l + 4.0 / 3.0 * PI * r.powi(3);
            let (cylinder, balls) = (m * PI * r * r * l / volume, m * 4.0 / 3.0 * PI * r.powi(3) / volume);
            let across = cylinder * (3.0 * r * r + l * l) / 12.0
                + balls * (83.0 / 320.0 * r * r + sq(0.5 * l + 0.375 * r));
            Derived {
                formula: [
                    "capsule, a cylinder between half balls with their centroids 3r/8 beyond its ends:   Izz = mc r²/2 + (2/5) mb r²,   Ixx = mc (3 r² + l²)/12 + mb [(83/320) r² + (l/2 + 3r/8)²]",
                    r"I_{zz} = \frac{m_c r^2}{2} + \frac25 m_b r^2, \qquad I_{xx} = \frac{m_c}{12} (3 r^2 + l^2) + m_b \left[\frac{83}{320} r^2 + \left(\frac{l}{2} + \frac{3r}{8}\right)^2\right]",
                ],
                measures: format!(
                    "r = {}, l = {} m,  mc = {}, mb = {} kg",
                    n(*r),
                    n(*l),
                    n(cylinder),
                    n(balls)
                ),
                moments: [
                    ("mc (3 r² + l²)/12 + mb [(83/320) r² + (l/2 + 3r/8)²]", across),
                    ("mc (3 r² + l²)/12 + mb [(83/320) r² + (l/2 + 3r/8)²]", across),
                    ("mc r²/2 + (2/5) mb r²", 0.5 * cylinder * r * r + 0.4 * balls * r * r),
                ],
            }
        }
        (Form::Torus { ring_radius: ring, tube_radius: a }, "torus") => {
            let across = m * (0.5 * ring * ring + 0.625 * a * a);
            Derived {
                formula: [
                    "torus of ring radius R and tube radius a about z, with s and α polar in the section of the tube:   Izz = ∫ (R + s cos α)² dm = m (R² + 3a²/4),   Ixx = m (R²/2 + 5a²/8)",
                    r"I_{zz} = \int (R + s \cos\alpha)^2 dm = m \left(R^2 + \frac34 a^2\right), \qquad I_{xx} = m \left(\frac{R^2}{2} + \frac58 a^2\right)",
                ],
                measures: format!("R = {}, a = {} m", n(*ring), n(*a)),
                moments: [
                    ("m (R²/2 + 5a²/8)", across),
                    ("m (R²/2 + 5a²/8)", across),
                    ("m (R² + 3a²/4)", m * (ring * ring + 0.75 * a * a)),
                ],
            }
        }
        (Form::Rod { length: l }, "rod") => Derived {
            formula: [
                "thin rod of length l along z:   Ixx = (m/l) ∫ z² dz over ±l/2 = m l²/12",
                r"I_{xx} = \frac{m}{l} \int_{-l/2}^{l/2} z^2 dz = \frac{m l^2}{12}",
            ],
            measures: format!("l = {} m", n(*l)),
            moments: [("m l²/12", m * l * l / 12.0), ("m l²/12", m * l * l / 12.0), ("0", 0.0)],
        },
        (Form::Disk { radius: r }, "disk") => Derived {
            formula: [
                "thin disk of radius r across z:   Izz = (2m/r²) ∫ ρ³ dρ = m r²/2,   Ixx = Iyy = Izz/2",
                r"I_{zz} = \frac{2m}{r^2} \int_0^r \rho^3 d\rho = \frac{m r^2}{2}, \qquad I_{xx} = I_{yy} = \tfrac12 I_{zz}",
            ],
            measures: format!("r = {} m", n(*r)),
            moments: [
                ("m r²/4", 0.25 * m * r * r),
                ("m r²/4", 0.25 * m * r * r),
                ("m r²/2", 0.5 * m * r * r),
            ],
        },
        (Form::Plate { size: [a, b] }, "plate") => Derived {
            formula: [
                "thin plate of edges a, b across z:   Ixx = (m/b) ∫ y² dy over ±b/2 = m b²/12,   Izz = Ixx + Iyy",
                r"I_{xx} = \frac{m}{b} \int_{-b/2}^{b/2} y^2 dy = \frac{m b^2}{12}, \qquad I_{zz} = I_{xx} + I_{yy}",
            ],
            measures: format!("a, b = {}, {} m", n(*a), n(*b)),
            moments: [
                ("m b²/12", m * b * b / 12.0),
                ("m a²/12", m * a * a / 12.0),
                ("m (a² + b²)/12", m * (a * a + b * b) / 12.0),
            ],
        },
        _ => return None,
    })
}

fn cylinder(m: f64, r: f64, l: f64) -> Derived {
    let across = m * (3.0 * r * r + l * l) / 12.0;
    Derived {
        formula: [
            "cylinder of radius r and length l along z:   Izz = (2m/r²) ∫ ρ³ dρ = m r²/2,   ∫ x² dm = m r²/4,   ∫ z² dm = m l²/12",
            r"I_{zz} = \frac{2m}{r^2} \int_0^r \rho^3 d\rho = \frac{m r^2}{2}, \qquad \int x^2 dm = \frac{m r^2}{4}, \qquad \int z^2 dm = \frac{m l^2}{12}",
        ],
        measures: format!("r = {}, l = {} m", n(r), n(l)),
        moments: [("m (3 r² + l²)/12", across), ("m (3 r² + l²)/12", across), ("m r²/2", 0.5 * m * r * r)],
    }
}

fn hollow_cylinder(m: f64, outer: f64, inner: f64, l: f64) -> Derived {
    let squares = outer * outer + inner * inner;
    let across = m * (3.0 * squares + l * l) / 12.0;
    Derived {
        formula: [
            "hollow cylinder of radii R and r and length l along z:   Izz = 2m/(R² − r²) ∫ ρ³ dρ from r to R = m (R² + r²)/2,   ∫ x² dm = m (R² + r²)/4,   ∫ z² dm = m l²/12",
            r"I_{zz} = \frac{2m}{R^2 - r^2} \int_r^R \rho^3 d\rho = \frac{m}{2} (R^2 + r^2), \qquad \int x^2 dm = \frac{m}{4} (R^2 + r^2), \qquad \int z^2 dm = \frac{m l^2}{12}",
        ],
        measures: format!("R, r = {}, {}, l = {} m", n(outer), n(inner), n(l)),
        moments: [
            ("m (3 R² + 3 r² + l²)/12", across),
            ("m (3 R² + 3 r² + l²)/12", across),
            ("m (R² + r²)/2", 0.5 * m * squares),
        ],
    }
}

fn hollow_sphere(m: f64, outer: f64, inner: f64) -> Derived {
    // Value of (R⁵ − r⁵)/(R³ − r³) without cancellation.
    let k = inner / outer;
    let ratio = outer * outer * (1.0 + k + k * k + k.powi(3) + k.powi(4)) / (1.0 + k + k * k);
    Derived {
        formula: [
            "hollow sphere of radii R and r:   ∫ x² dm = (1/3) ∫ ρ² 4πρ² dρ from r to R · m / (4π (R³ − r³)/3) = (m/5) (R⁵ − r⁵)/(R³ − r³),   Ixx = (2/5) m (R⁵ − r⁵)/(R³ − r³)",
            r"\int x^2 dm = \frac13 \frac{m}{\tfrac43 \pi (R^3 - r^3)} \int_r^R \rho^2 4\pi \rho^2 d\rho = \frac{m}{5} \frac{R^5 - r^5}{R^3 - r^3}, \qquad I_{xx} = \frac25 m \frac{R^5 - r^5}{R^3 - r^3}",
        ],
        measures: format!("R, r = {}, {} m", n(outer), n(inner)),
        moments: [("(2/5) m (R⁵ − r⁵)/(R³ − r³)", 0.4 * m * ratio); 3],
    }
}

/// Returns ∫ x² dm, ∫ (z − z̄)² dm and z̄ of the lateral surface of a frustum with mass 1.
fn wall(a: f64, b: f64, h: f64) -> [f64; 3] {
    let sum = a + b;
    let along = h * h * (a * a + 4.0 * a * b + b * b) / (18.0 * sum * sum);
    [0.25 * (a * a + b * b), along, h * (a + 2.0 * b) / (3.0 * sum)]
}

fn cone_shell(m: f64, a: f64, b: f64, h: f64) -> Derived {
    let [x, z, _] = wall(a, b, h);
    Derived {
        formula: [
            "wall of a cone from radius a to b over the height h, its area by ρ(z) dz:   Izz = ∫ ρ² dm = m (a² + b²)/2,   Ixx = Izz/2 + m h² (a² + 4ab + b²)/[18 (a + b)²]",
            r"I_{zz} = \int \rho^2 dm = \frac{m}{2} (a^2 + b^2), \qquad I_{xx} = \tfrac12 I_{zz} + \frac{m h^2}{18} \frac{a^2 + 4ab + b^2}{(a + b)^2}",
        ],
        measures: format!("a, b = {}, {}, h = {} m", n(a), n(b), n(h)),
        moments: [
            ("Izz/2 + m h² (a² + 4ab + b²)/[18 (a + b)²]", m * (x + z)),
            ("Izz/2 + m h² (a² + 4ab + b²)/[18 (a + b)²]", m * (x + z)),
            ("m (a² + b²)/2", 2.0 * m * x),
        ],
    }
}

fn closed_cone_shell(m: f64, a: f64, b: f64, h: f64) -> Derived {
    // Lateral surface and two end plates; masses are proportional to areas.
    let areas = [(a + b) * h.hypot(a - b), a * a, b * b];
    let total: f64 = areas.iter().sum();
    let [side, base, top] = areas.map(|area| m * area / total);
    let [x, z, middle] = wall(a, b, h);
    let center = (side * middle + top * h) / m;
    let axial = 2.0 * side * x + 0.5 * (base * a * a + top * b * b);
    let sq = |x: f64| x * x;
    let along = side * (z + sq(middle - center)) + base * sq(center) + top * sq(h - center);
    Derived {
        formula: [
            "wall of a cone with its ends, masses by area (a + b) s, a² and b² with s² = h² + (a − b)²:   Izz = mw (a² + b²)/2 + (ma a² + mb b²)/2,   zw = h (a + 2b)/[3 (a + b)],   z̄ = (mw zw + mb h)/m,   Ixx = Izz/2 + mw {h² (a² + 4ab + b²)/[18 (a + b)²] + (zw − z̄)²} + ma z̄² + mb (h − z̄)²",
            r"I_{zz} = \frac{m_w}{2} (a^2 + b^2) + \tfrac12 (m_a a^2 + m_b b^2), \qquad z_w = \frac{h (a + 2b)}{3 (a + b)}, \qquad \bar z = \frac{m_w z_w + m_b h}{m}, \qquad I_{xx} = \tfrac12 I_{zz} + m_w \left[\frac{h^2}{18} \frac{a^2 + 4ab + b^2}{(a + b)^2} + (z_w - \bar z)^2\right] + m_a \bar z^2 + m_b (h - \bar z)^2",
        ],
        measures: format!(
            "a, b = {}, {}, h = {} m,  mw, ma, mb = {}, {}, {} kg,  z̄ = {} m",
            n(a),
            n(b),
            n(h),
            n(side),
            n(base),
            n(top),
            n(center)
        ),
        moments: [
            ("Izz/2 + ∫ (z − z̄)² dm", 0.5 * axial + along),
            ("Izz/2 + ∫ (z − z̄)² dm", 0.5 * axial + along),
            ("mw (a² + b²)/2 + (ma a² + mb b²)/2", axial),
        ],
    }
}

fn cone(m: f64, a: f64, b: f64, h: f64) -> Derived {
    if b == 0.0 || a == 0.0 {
        let r = a.max(b);
        let across = m * (0.15 * r * r + 0.0375 * h * h);
        return Derived {
            formula: [
                "cone of radius r and height h, its centroid h/4 from its base:   Izz = ∫ ½ ρ² dm = (3/10) m r²,   Ixx = m (3r²/20 + 3h²/80)",
                r"I_{zz} = \int \tfrac12 \rho^2 dm = \frac{3}{10} m r^2, \qquad I_{xx} = m \left(\frac{3 r^2}{20} + \frac{3 h^2}{80}\right)",
            ],
            measures: format!("r = {}, h = {} m", n(r), n(h)),
            moments: [
                ("m (3r²/20 + 3h²/80)", across),
                ("m (3r²/20 + 3h²/80)", across),
                ("(3/10) m r²", 0.3 * m * r * r),
            ],
        };
    }
    let larger = a.max(b);
    let (p, q) = (a / larger, b / larger);
    let sum = p * p + p * q + q * q;
    let axial =
        0.3 * m * larger * larger * (p.powi(4) + p.powi(3) * q + p * p * q * q + p * q.powi(3) + q.powi(4))
            / sum;
    let quartic = p.powi(4) + q.powi(4) + 4.0 * p * q * (p * p + q * q) + 10.0 * p * p * q * q;
    let across = 0.5 * axial + 0.0375 * m * h * h * quartic / (sum * sum);
    Derived {
        formula: [
            "frustum from radius a to b over the height h:   Izz = (3/10) m (a⁵ − b⁵)/(a³ − b³),   Ixx = Izz/2 + (3/80) m h² [a⁴ + b⁴ + 4ab(a² + b²) + 10a²b²] / (a² + ab + b²)²",
            r"I_{zz} = \frac{3}{10} m \frac{a^5 - b^5}{a^3 - b^3}, \qquad I_{xx} = \tfrac12 I_{zz} + \frac{3}{80} m h^2 \frac{a^4 + b^4 + 4ab(a^2 + b^2) + 10 a^2 b^2}{(a^2 + ab + b^2)^2}",
        ],
        measures: format!("a, b = {}, {}, h = {} m", n(a), n(b), n(h)),
        moments: [
            ("Izz/2 + m ⟨z²⟩", across),
            ("Izz/2 + m ⟨z²⟩", across),
            ("(3/10) m (a⁵ − b⁵)/(a³ − b³)", axial),
        ],
    }
}
