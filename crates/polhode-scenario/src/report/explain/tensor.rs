//! Step 3: the inertia tensor, its principal moments and axes, and L = {I} ω.

use polhode::body::{Particle, Symmetry};
use polhode::math::{Body, Direction};
use polhode::motion::angular_momentum;
use polhode_document::Section;
use polhode_document::number::{tidy, tidy_beside, tidy_matrix};
use polhode_document::unit::angle;

use super::inside::Inside;
use super::symbols;
use super::working::{Working, cells, exactly, factor, n, v};
use crate::symbolic::Exact;

/// Names of the body axes; the principal axes are 1, 2 and 3.
const AXES: [&str; 3] = ["x", "y", "z"];

/// Largest number of particles in a written sum.
const MOST_TERMS: usize = 6;

/// Largest number of parts in the table.
const MOST_PARTS: usize = 20;

pub(crate) fn section(w: &Working<'_>, inside: Option<&Inside<'_, '_>>) -> Section {
    let mut s = Section::new(3, "Calculate {I}, its principal moments and axes");
    s.formula(
        "Iij = Σ mα (δij Σk xα,k² − xα,i xα,j)      for a continuous body  ∫ ρ (δij Σk xk² − xi xj) dV",
        r"I_{ij} = \sum_\alpha m_\alpha \left(\delta_{ij} \sum_k x_{\alpha,k}^2 - x_{\alpha,i} x_{\alpha,j}\right) \quad\text{or}\quad \int \rho \left(\delta_{ij} \sum_k x_k^2 - x_i x_j\right) dV",
    );
    if let Some(symbolic) = w.exact.symbols() {
        symbols::tensor(symbolic, w.point_name(), w.rotor.principal().moments(), &mut s);
        if w.is_turning() {
            symbols::momentum(symbolic, w.rotor.kinetic_energy(w.start.omega), &mut s);
        }
        s.say("In numbers:");
    }
    let particles = w.scenario.particles();
    if w.scenario.is_all_particles() && (1..=MOST_TERMS).contains(&particles.len()) {
        terms(w, &particles, &mut s);
    } else if !w.scenario.parts().is_empty() {
        parts(w, &mut s);
    }
    s.say(format!(
        "The tensor about {}, along body axes (off-diagonal elements are -∫xy dm):",
        w.point_name()
    ));
    let tensor = w.rotor.inertia().matrix();
    s.matrix("{I}", tensor, "kg·m²");
    if let Exact::Fractions(exact) = w.exact {
        symbols::fractions(exact, w.rotor.principal().moments(), &mut s);
    }
    if w.rotor.principal().symmetry() == Symmetry::Point {
        s.say("All the mass is at the reference point, so the inertia is zero and every axis is a principal axis.");
        return s;
    }
    characteristic(w, tidy_matrix(tensor), &mut s);
    axes(w, tidy_matrix(tensor), &mut s);
    momentum(w, tidy_matrix(tensor), inside, &mut s);
    s
}

/// Writes the sums for the six elements, term by term.
fn terms(w: &Working<'_>, particles: &[Particle<Body>], s: &mut Section) {
    s.say(format!("With xα measured from {}:", w.point_name()));
    let places: Vec<(f64, [f64; 3])> =
        particles.iter().map(|p| (p.mass(), tidy((p.position() - w.point()).to_array()))).collect();
    let tensor = tidy_matrix(w.rotor.inertia().matrix());
    let [x, y, z] = [0, 1, 2];
    for (i, names, (a, b)) in [(0, "y² + z²", (y, z)), (1, "x² + z²", (x, z)), (2, "x² + y²", (x, y))] {
        let term = |(m, r): &(f64, [f64; 3])| format!("{}·({}² + {}²)", n(*m), factor(r[a]), factor(r[b]));
        let terms: Vec<String> = places.iter().map(term).collect();
        let result = format!("{} kg·m²", n(tensor[i][i]));
        s.sum(&format!("I{0}{0} = Σ m ({names})", AXES[i]), &terms, &result);
    }
    for (i, j, names) in [(0, 1, "x y"), (0, 2, "x z"), (1, 2, "y z")] {
        let last = places.len() - 1;
        let term = |(k, (m, r)): (usize, &(f64, [f64; 3]))| {
            let (open, close) = (if k == 0 { "-[" } else { "" }, if k == last { "]" } else { "" });
            format!("{open}{}·{}·{}{close}", n(*m), factor(r[i]), factor(r[j]))
        };
        let terms: Vec<String> = places.iter().enumerate().map(term).collect();
        let result = format!("{} kg·m²", n(tensor[i][j]));
        let lhs = format!("I{}{} = -Σ m {names}", AXES[i], AXES[j]);
        s.sum(&lhs, &terms, &result);
    }
}

/// Writes each part's own tensor, and its shift to the common reference point.
fn parts(w: &Working<'_>, s: &mut Section) {
    let shown = w.scenario.parts().len().min(MOST_PARTS);
    super::shape::derive(&w.scenario.parts()[..shown], s);
    s.say(format!(
        "Each part has its own tensor about its own centre of mass, and d leads from {} to it; the parallel-axis theorem shifts it there:",
        w.point_name()
    ));
    s.formula(
        "Iij = Σ parts [ Iij,own + m (d² δij − di dj) ]",
        r"I_{ij} = \sum_{\text{parts}} \left[ I_{ij}^{\text{own}} + m (d^2 \delta_{ij} - d_i d_j) \right]",
    );
    let six = |m: [[f64; 3]; 3]| vec![m[0][0], m[1][1], m[2][2], m[0][1], m[0][2], m[1][2]];
    let (mut names, mut rows) = (Vec::new(), Vec::new());
    for part in w.scenario.parts().iter().take(MOST_PARTS) {
        let own = part.properties.inertia().matrix();
        let moved = part.properties.inertia_about(w.point()).matrix();
        let shift = std::array::from_fn(|i| std::array::from_fn(|j| moved[i][j] - own[i][j]));
        names.extend([format!("{}, own", part.name), "  + shift".to_owned()]);
        rows.extend([six(tidy_matrix(own)), six(tidy_matrix(shift))]);
    }
    let more = w.scenario.parts().len().saturating_sub(MOST_PARTS);
    names.push(if more == 0 { "sum".to_owned() } else { format!("sum, with {more} more parts") });
    let sum = w.body().inertia_about(w.point()).matrix();
    rows.push(six(tidy_matrix(sum)));
    let tensor = w.rotor.inertia().matrix();
    if !w.scenario.wheels().is_empty() && tensor != sum {
        names.extend(["  - wheels with a motor, about their axes".to_owned(), "{I}".to_owned()]);
        let less = std::array::from_fn(|i| std::array::from_fn(|j| tensor[i][j] - sum[i][j]));
        rows.extend([six(tidy_matrix(less)), six(tidy_matrix(tensor))]);
    }
    let rows = names.into_iter().zip(cells(&rows)).map(|(name, row)| [vec![name], row].concat());
    s.table(&["kg·m²", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"], rows.collect());
}

/// Writes the characteristic equation |{I} − λ 1| = 0 and its roots.
fn characteristic(w: &Working<'_>, m: [[f64; 3]; 3], s: &mut Section) {
    let [i1, i2, i3] = w.rotor.principal().moments();
    s.say(
        "Along a principal axis L = λ ω, so ({I} − λ 1) ω = 0, which has a solution other than ω = 0 only if",
    );
    s.formula(
        "| Ixx−λ   Ixy     Ixz   |\n\
         | Iyx     Iyy−λ   Iyz   |  =  0\n\
         | Izx     Izy     Izz−λ |",
        "\\begin{vmatrix}\nI_{xx}-\\lambda & I_{xy} & I_{xz} \\cr\nI_{yx} & I_{yy}-\\lambda & I_{yz} \\cr\nI_{zx} & I_{zy} & I_{zz}-\\lambda\n\\end{vmatrix} = 0",
    );
    if is_diagonal(m) {
        s.say("{I} is diagonal: the body axes are principal axes, and the roots are the diagonal elements.");
    } else {
        cubic(m, s);
    }
    s.line(format!("i1 = {},  i2 = {},  i3 = {} kg·m²", n(i1), n(i2), n(i3)));
    let [k1, k2, k3] = [i1, i2, i3].map(|i| n((i / w.rotor.mass()).sqrt()));
    s.line(format!("gyration radii √(i/M):  {k1},  {k2},  {k3} m"));
}

/// Writes the cubic with its coefficients in powers of kg·m², scaled if these would overflow.
fn cubic(m: [[f64; 3]; 3], s: &mut Section) {
    let trace = m[0][0] + m[1][1] + m[2][2];
    let (scale, name) = if (1e-90..1e90).contains(&trace) { (1.0, "λ") } else { (trace, "λ*") };
    let m = m.map(|row| row.map(|x| x / scale));
    let minor = |i: usize, j: usize| m[i][i] * m[j][j] - m[i][j] * m[j][i];
    let determinant = m[0][0] * minor(1, 2) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    let trace_of = trace / scale;
    // A determinant of rounding size is 0: one root is zero.
    let determinant = if determinant.abs() <= 1e-15 * trace_of.powi(3) { 0.0 } else { determinant };
    if scale != 1.0 {
        s.line(format!("with λ = λ* · {} kg·m² (the trace):", n(scale)));
    }
    s.line(format!(
        "{name}³ - {} {name}² + {} {name}{} = 0",
        n(trace_of),
        n(minor(0, 1) + minor(0, 2) + minor(1, 2)),
        if determinant == 0.0 { String::new() } else { format!(" - {}", factor(determinant)) }
    ));
}

fn is_diagonal(m: [[f64; 3]; 3]) -> bool {
    m[0][1] == 0.0 && m[0][2] == 0.0 && m[1][2] == 0.0
}

/// Writes the principal axes, by substitution of each distinct root.
///
/// Equal roots allow any axes in a plane, or in space.
fn axes(w: &Working<'_>, m: [[f64; 3]; 3], s: &mut Section) {
    let principal = w.rotor.principal();
    let symmetry = principal.symmetry();
    let moments = principal.moments();
    if !is_diagonal(m) {
        // Simple roots, each of which determines an axis.
        let alone: &[usize] = match symmetry {
            Symmetry::Asymmetric => &[0, 1, 2],
            Symmetry::Prolate | Symmetry::Rod => &[0],
            Symmetry::Oblate => &[2],
            Symmetry::Spherical | Symmetry::Point => &[],
        };
        for &k in alone {
            s.say(format!("Put λ = i{} in and solve for the direction of the axis:", k + 1));
            let rows: [[f64; 3]; 3] = std::array::from_fn(|i| {
                std::array::from_fn(|j| m[i][j] - if i == j { moments[k] } else { 0.0 })
            });
            let scale = moments[2];
            for row in rows {
                let [a, b, c] = tidy_beside(row, scale).map(factor);
                s.line(format!("{a} ωx + {b} ωy + {c} ωz = 0"));
            }
            s.line(format!("→ axis {} = {}", k + 1, v(principal.axis(k).to_array())));
        }
    }
    match symmetry {
        Symmetry::Oblate | Symmetry::Prolate | Symmetry::Rod => s.say(format!(
            "The root {} is double, so only one independent equation remains: every direction in the plane perpendicular to axis {} is principal. Any two perpendicular directions are valid; here the two nearest to the body axes are chosen ({}).",
            if symmetry == Symmetry::Oblate { "i1 = i2" } else { "i2 = i3" },
            if symmetry == Symmetry::Oblate { 3 } else { 1 },
            symmetry.freedom()
        )),
        Symmetry::Spherical => {
            s.say(format!("The root is triple: {}; the body axes are used.", symmetry.freedom()));
        }
        Symmetry::Asymmetric | Symmetry::Point => {}
    }
    s.say("Principal axes, right-handed, in body axes; ω1, ω2, ω3 are the components along them:");
    for (k, axis) in principal.axes().into_iter().enumerate() {
        let name = along_body_axis(axis).map_or_else(String::new, |name| format!(" = {name}"));
        s.line(format!("axis {0} = {1}{name}   i{0} = {2} kg·m²", k + 1, v(axis.to_array()), n(moments[k])));
    }
}

/// Formats a direction along a body axis, `x̂` or `−x̂`; `None` for other directions.
pub(crate) fn along_body_axis(direction: Direction<Body>) -> Option<String> {
    const UNITS: [&str; 3] = ["x̂", "ŷ", "ẑ"];
    let exact = |(k, c): (usize, f64)| {
        (c.abs() == 1.0).then(|| format!("{}{}", if c < 0.0 { "−" } else { "" }, UNITS[k]))
    };
    tidy(direction.to_array()).into_iter().enumerate().find_map(exact)
}

/// Writes L = {I} ω, T = ½ ω · L, and the angle between ω and L.
fn momentum(w: &Working<'_>, m: [[f64; 3]; 3], inside: Option<&Inside<'_, '_>>, s: &mut Section) {
    let wheels = inside.filter(|_| !w.scenario.wheels().is_empty());
    if !w.is_turning() {
        match wheels {
            Some(inside) => inside.momentum(s),
            None => s.say("With ω = 0 the angular momentum is zero: L = 0."),
        }
        return;
    }
    let omega = w.start.omega;
    let l = w.rotor.angular_momentum(omega);
    if wheels.is_some() {
        s.say("The tensor maps ω to the angular momentum of the body without the wheels:");
    } else {
        s.say("The tensor maps ω to the angular momentum:");
    }
    if wheels.is_none() {
        s.formula(
            "L = {I} ω,   T_rot = ½ ω · L",
            r"\mathbf L = \lbrace \mathbf I \rbrace \cdot \boldsymbol\omega, \qquad T_{\text{rot}} = \tfrac12 \boldsymbol\omega \cdot \mathbf L",
        );
    }
    let shown = tidy(l.to_array());
    let name = |axis: &str| if wheels.is_some() { format!("({{I}} ω){axis}") } else { format!("L{axis}") };
    for (i, row) in m.iter().enumerate() {
        let terms: Vec<String> =
            row.iter().zip(omega.to_array()).map(|(a, b)| format!("{}·{}", factor(*a), factor(b))).collect();
        s.sum(&name(AXES[i]), &terms, &format!("{} kg·m²/s", n(shown[i])));
    }
    if let Some(inside) = wheels {
        inside.momentum(s);
        return;
    }
    s.line(format!("L  = {} kg·m²/s, |L| = {} kg·m²/s, body axes", v(l.to_array()), n(l.norm())));
    if w.start.attitude != polhode::math::Attitude::identity() {
        s.line(format!(
            "   = {} kg·m²/s, space axes",
            v(w.rotor.angular_momentum_space(&w.start).to_array())
        ));
    }
    let about = w.point_name();
    s.line(format!("T_rot = ½ ω · L = {} J, about {about}", n(w.rotor.kinetic_energy(omega))));
    let between = omega.angle_to(l);
    if between <= 1e-12 {
        s.line("L is along ω: the rotation is about a principal axis");
    } else {
        s.line(format!("angle between ω and L = {}: ω is not along a principal axis", angle(between)));
    }
    by_particles(w, s);
}

/// Writes L as Σ m r × v, which is independent of the tensor.
fn by_particles(w: &Working<'_>, s: &mut Section) {
    let moving = w.moving_particles();
    if !w.scenario.is_all_particles() || moving.is_empty() {
        return;
    }
    // Positions are relative to the centre of mass, so that the pivot is at −l.
    let attitude = w.start.attitude;
    let (point, velocity) = match w.scenario.pivot() {
        Some(_) => (attitude * -w.rotor.lever(), polhode::math::Velocity::ZERO),
        None => (polhode::math::Position::ZERO, w.center_velocity()),
    };
    let l = angular_momentum(&moving, point, velocity);
    let gap = (l - w.rotor.angular_momentum_space(&w.start)).norm();
    s.line(format!(
        "check: Σ mα rα × vα = {} kg·m²/s in body axes (differs by {})",
        exactly(tidy((attitude.inverse() * l).to_array())),
        polhode_document::number::error(gap)
    ));
}
