//! Derivations of the tensors of shapes: the integral of each kind of shape, and its value.

use polhode::body::mesh::TriangleMesh;
use polhode::body::shape::Extent;
use polhode::body::{BodyPart, Form};
use polhode::math::{Part, Position};
use polhode_document::Section;

use super::shape_formula::{Derived, of};
use super::working::n;

/// Rounding threshold for the difference between a part's tensor and its formula, relative.
///
/// A part of variable density differs by more.
const AGREES: f64 = 1e-9;

/// Writes the derivations of the tensors of parts: the integral of each kind of shape once, and the
/// method for the other parts.
pub(crate) fn derive(parts: &[BodyPart], s: &mut Section) {
    let derived = |part: &BodyPart| of(part).filter(|derived| agrees(part, derived));
    let (shapes, others): (Vec<_>, Vec<_>) =
        parts.iter().map(|part| (part, derived(part))).partition(|(_, derived)| derived.is_some());
    let shapes: Vec<(&BodyPart, Derived)> =
        shapes.into_iter().filter_map(|(part, derived)| Some((part, derived?))).collect();
    if !shapes.is_empty() {
        formulas(&shapes, s);
    }
    for (part, _) in others {
        otherwise(part, s);
    }
    if shapes.iter().any(|(part, _)| part.form.as_ref().is_some_and(|form| form.rotation.angle() != 0.0)) {
        s.say("A part that is rotated by R has the tensor R I Rᵀ in body axes.");
    }
}

fn formulas(shapes: &[(&BodyPart, Derived)], s: &mut Section) {
    s.say(
        "The tensor of each shape is an integral over it, Ixx = ∫ (y² + z²) dm and so on, along its own axes from its centroid; the \
         products are zero by symmetry:",
    );
    let mut told: Vec<&str> = Vec::new();
    for (part, Derived { formula: [text, latex], measures, moments }) in shapes {
        if !told.contains(text) {
            // The text has the form `cylinder of radius r …:   Izz = …`.
            let (what, formula) = text.split_once(":   ").unwrap_or_default();
            s.say(format!("{what}:"));
            s.formula(formula, latex);
            told.push(text);
        }
        s.line(format!("{}: m = {} kg,  {measures}", part.name, n(part.properties.mass())));
        // Moments with the same formula are written together.
        let mut k = 0;
        while let Some((formula, value)) = moments.get(k) {
            let same = moments[k..].iter().take_while(|(other, _)| other == formula).count();
            let names: Vec<&str> = ["Ixx", "Iyy", "Izz"][k..k + same].to_vec();
            let equals =
                if *value == 0.0 && *formula == "0" { String::new() } else { format!(" = {}", n(*value)) };
            s.line(format!("  {} = {formula}{equals} kg·m²", names.join(" = ")));
            k += same;
        }
    }
}

/// Writes the method for a part without such a formula.
fn otherwise(part: &BodyPart, s: &mut Section) {
    let name = &part.name;
    match (part.kind, part.form.as_ref().map(|placed| &placed.form)) {
        ("tensor", _) => s.say(format!("{name}: the tensor is given.")),
        ("particles" | "molecule", _) => {
            s.say(format!("{name}: the sum over its {} particles.", part.particles.len()));
        }
        (_, Some(Form::TriangularPrism { vertices, length })) if is_prism(part, vertices, *length) => {
            triangle(part, vertices, *length, s);
        }
        (kind @ ("mesh" | "tetrahedron"), Some(Form::Mesh(mesh))) if is_uniform_mesh(part, mesh) => {
            s.say(format!(
                "{name}: a {kind} is the sum of tetrahedra from a point O to each of its triangles p, q, r, their volumes negative where O \
                 is on the outer side:"
            ));
            s.formula(
                "V = Σ p · (q × r) / 6,   ∫ xi xj dV = Σ [p · (q × r) / 120] (pi pj + qi qj + ri rj + si sj),   s = p + q + r",
                r"V = \sum \frac{\mathbf p \cdot (\mathbf q \times \mathbf r)}{6}, \qquad \int x_i x_j dV = \sum \frac{\mathbf p \cdot (\mathbf q \times \mathbf r)}{120} (p_i p_j + q_i q_j + r_i r_j + s_i s_j), \qquad \mathbf s = \mathbf p + \mathbf q + \mathbf r",
            );
            if let Some(Extent::Volume(volume)) = part.extent {
                let mass = part.properties.mass();
                s.line(format!(
                    "m = {} kg,  V = {} m³,  ρ = m/V = {} kg/m³",
                    n(mass),
                    n(volume),
                    n(mass / volume)
                ));
            }
        }
        _ => s.say(format!(
            "{name}: its density varies; the integral with ρ(x, y, z) is computed numerically."
        )),
    }
}

/// Writes the formula and values for a triangular plate or prism, whose products of inertia are
/// nonzero.
fn triangle(part: &BodyPart, vertices: &[[f64; 2]; 3], length: f64, s: &mut Section) {
    let kind = if length > 0.0 { "prism of length l along z" } else { "thin plate" };
    let sum = "Sij = ∫ xi xj dm = (m/12) Σ (pi − ci)(pj − cj) over its corners p,   c = Σ p/3,";
    let sum_tex = r"S_{ij} = \int x_i x_j dm = \frac{m}{12} \sum_p (p_i - c_i)(p_j - c_j), \qquad \mathbf c = \tfrac13 \sum_p \mathbf p,";
    s.say(format!("{}: a triangle is equivalent to particles at its vertices, each with 1/12 of its mass; this is a {kind}:", part.name));
    if length > 0.0 {
        s.formula(
            &format!("{sum}   Ixx = Syy + m l²/12,   Iyy = Sxx + m l²/12,   Izz = Sxx + Syy,   Ixy = −Sxy"),
            &format!(r"{sum_tex} \qquad I_{{xx}} = S_{{yy}} + \frac{{m l^2}}{{12}}, \quad I_{{yy}} = S_{{xx}} + \frac{{m l^2}}{{12}}, \quad I_{{zz}} = S_{{xx}} + S_{{yy}}, \quad I_{{xy}} = -S_{{xy}}"),
        );
    } else {
        s.formula(
            &format!("{sum}   Ixx = Syy,   Iyy = Sxx,   Izz = Sxx + Syy,   Ixy = −Sxy"),
            &format!(r"{sum_tex} \qquad I_{{xx}} = S_{{yy}}, \quad I_{{yy}} = S_{{xx}}, \quad I_{{zz}} = S_{{xx}} + S_{{yy}}, \quad I_{{xy}} = -S_{{xy}}"),
        );
    }
    let [xx, yy, zz, xy] = prism(part.properties.mass(), vertices, length);
    let along = if length > 0.0 { format!(",  l = {} m", n(length)) } else { String::new() };
    let corner = |p: &[f64; 2]| format!("({}, {})", n(p[0]), n(p[1]));
    let corners = vertices.each_ref().map(corner).join(", ");
    s.line(format!("m = {} kg,  p = {corners} m{along}", n(part.properties.mass())));
    s.line(format!("Ixx, Iyy, Izz, Ixy = {}, {}, {}, {} kg·m²", n(xx), n(yy), n(zz), n(xy)));
}

/// Returns Ixx, Iyy, Izz and Ixy about the centroid of a prism; for a length of 0, of a plate.
fn prism(m: f64, vertices: &[[f64; 2]; 3], length: f64) -> [f64; 4] {
    let center = [0, 1].map(|k| vertices.iter().map(|p| p[k]).sum::<f64>() / 3.0);
    let second = |i: usize, j: usize| {
        m / 12.0 * vertices.iter().map(|p| (p[i] - center[i]) * (p[j] - center[j])).sum::<f64>()
    };
    let along = m * length * length / 12.0;
    [second(1, 1) + along, second(0, 0) + along, second(0, 0) + second(1, 1), -second(0, 1)]
}

/// Returns true if the part's tensor is that of the prism with uniform density.
fn is_prism(part: &BodyPart, vertices: &[[f64; 2]; 3], length: f64) -> bool {
    let [xx, yy, zz, xy] = prism(part.properties.mass(), vertices, length);
    let rows = [[xx, xy, 0.0], [xy, yy, 0.0], [0.0, 0.0, zz]];
    is_own(part, |i, j| rows[i][j])
}

/// Returns true if the formulas give the part's tensor, which requires a uniform density.
fn agrees(part: &BodyPart, derived: &Derived) -> bool {
    is_own(part, |i, j| if i == j { derived.moments[i].1 } else { 0.0 })
}

/// Returns true if the part's tensor about its centroid, along its own axes, has these elements.
fn is_own(part: &BodyPart, element: impl Fn(usize, usize) -> f64) -> bool {
    let Some(placed) = &part.form else { return false };
    let own = part.properties.inertia().in_frame(placed.rotation.inverse()).matrix();
    let size = own[0][0].max(own[1][1]).max(own[2][2]);
    (0..3).all(|i| (0..3).all(|j| (own[i][j] - element(i, j)).abs() <= AGREES * size))
}

/// Returns true if the part's tensor is that of the mesh with uniform density, by the sum in the
/// text.
fn is_uniform_mesh(part: &BodyPart, mesh: &TriangleMesh) -> bool {
    let vertices: Vec<Position<Part>> = mesh.vertices().collect();
    let Some(origin) = vertices.first() else { return false };
    let (mut volume, mut first, mut second) = (0.0, [0.0; 3], [[0.0; 3]; 3]);
    for triangle in mesh.triangles() {
        let corners = triangle.map(|k| (vertices[k as usize] - *origin).to_array());
        let [p, q, r] = corners;
        // Six times the volume of a tetrahedron: p · (q × r).
        let six = p[0] * (q[1] * r[2] - q[2] * r[1])
            + p[1] * (q[2] * r[0] - q[0] * r[2])
            + p[2] * (q[0] * r[1] - q[1] * r[0]);
        let s = [0, 1, 2].map(|k| p[k] + q[k] + r[k]);
        volume += six / 6.0;
        for i in 0..3 {
            first[i] += six / 24.0 * s[i];
            for j in 0..3 {
                second[i][j] +=
                    six / 120.0 * (corners.iter().map(|v| v[i] * v[j]).sum::<f64>() + s[i] * s[j]);
            }
        }
    }
    // Second moments about the centroid: ∫ (x − c)i (x − c)j dm.
    let density = part.properties.mass() / volume;
    let spread = |i: usize, j: usize| density * (second[i][j] - first[i] * first[j] / volume);
    let trace: f64 = (0..3).map(|k| spread(k, k)).sum();
    is_own(part, |i, j| if i == j { trace - spread(i, j) } else { -spread(i, j) })
}
