//! Masses that MuJoCo's compiler computes: from geoms, then modified by `boundmass`,
//! `boundinertia`, `balanceinertia` and `settotalmass`.
//!
//! Source: MuJoCo 3.x, `mjCBody::InertiaFromGeom` and `mjCBody::Compile`.

use crate::model::{ComputedMass, Inertial, Link, Slot, Tensor};
use crate::moments::{Elements, Moments, parallel_axes, rotated, scaled};
use crate::pose::transposed;

use super::compiler::Settings;

/// Mass below which MuJoCo treats a body as massless, kg.
pub(super) const LEAST: f64 = 1e-14;

/// Mass data of one body, collected while its geoms are read.
#[derive(Debug, Default)]
pub(super) struct BodyMass {
    /// Index of the context with its settings.
    pub(super) context: usize,
    /// True if the geoms count, and not the inertial.
    pub(super) from_geoms: bool,
    /// Inertial that counts only if the body has no geoms.
    pub(super) inertial: Option<Inertial>,
    /// Mass properties of the geoms with mass.
    pub(super) parts: Vec<ComputedMass>,
    /// Reason why the mass of a geom is unknown.
    pub(super) unknown: Option<String>,
    /// Attribute `pos` of the body: its centre if it has neither inertial nor mass.
    pub(super) position: [f64; 3],
}

/// Sets the compiled mass of each link. `incomplete` is the reason why bodies may be missing,
/// `blind` the reason why settings may be missing.
pub(super) fn compile(
    links: &mut [Link],
    bodies: Vec<BodyMass>,
    settings: &[&Settings<'_>],
    incomplete: Option<String>,
    blind: Option<&str>,
) {
    for (link, body) in links.iter_mut().zip(bodies) {
        let Some(settings) = settings.get(body.context) else { continue };
        compile_one(link, body, settings, blind);
    }
    let total = settings.first().map_or(0.0, |settings| settings.total_mass);
    if total > 0.0 {
        set_total(links, total, incomplete.or(blind.map(str::to_owned)));
    }
}

fn compile_one(link: &mut Link, body: BodyMass, settings: &Settings<'_>, blind: Option<&str>) {
    let BodyMass { from_geoms, inertial, parts, unknown, position, .. } = body;
    if let Some(why) = settings.unreadable.clone().or(unknown) {
        link.computed = Some(Err(why));
        return;
    }
    if from_geoms && parts.is_empty() && inertial.is_some() {
        link.inertial = inertial;
        link.from_geometry = false;
    }
    if let Some(why) = blind.filter(|_| from_geoms && link.inertial.is_none() && !parts.is_empty()) {
        link.computed = Some(Err(why.to_owned()));
        return;
    }
    let of_geoms = from_geoms && !parts.is_empty();
    let read = if of_geoms {
        Some(joined(&parts))
    } else {
        match &link.inertial {
            Some(inertial) => written(inertial),
            None => Some(ComputedMass { mass: 0.0, center: position, tensor: [0.0; 6] }),
        }
    };
    let Some(read) = read else { return };
    let is_diagonal =
        link.inertial.as_ref().is_some_and(|inertial| matches!(inertial.tensor, Tensor::Diagonal(_)));
    match changed(&read, settings, is_diagonal) {
        Err(why) => link.computed = Some(Err(why)),
        Ok(Some(changed)) => link.computed = Some(Ok(changed)),
        Ok(None) if of_geoms || link.from_geometry => link.computed = Some(Ok(read)),
        Ok(None) => {}
    }
}

/// Applies bounds and balancing; `None` if they change nothing.
fn changed(
    read: &ComputedMass,
    settings: &Settings<'_>,
    is_diagonal: bool,
) -> Result<Option<ComputedMass>, String> {
    /// Relative distance from the triangle equality below which the result of balancing is
    /// ambiguous.
    const EDGE: f64 = 1e-12;
    let mass = read.mass.max(settings.bound_mass);
    let Moments { values, axes } = Moments::of(&read.tensor);
    let mut moments = values.map(|moment| moment.max(settings.bound_inertia));
    let [i1, i2, i3] = moments;
    if settings.balance && i3 > 0.0 {
        if !is_diagonal && (i1 + i2 - i3).abs() <= EDGE * i3 {
            return Err("whether balanceinertia changes its moments depends on rounding".to_owned());
        }
        if i1 + i2 < i3 && (i1 + i2 - i3).abs() > 1e-15 * i3 {
            moments = [(i1 + i2 + i3) / 3.0; 3];
        }
    }
    if mass.to_bits() == read.mass.to_bits() && moments == values {
        return Ok(None);
    }
    if mass == 0.0 {
        return Err("boundinertia gives it moments without a mass".to_owned());
    }
    let [a, b, c] = moments;
    let tensor = rotated(&[a, b, c, 0.0, 0.0, 0.0], &transposed(&axes));
    Ok(Some(ComputedMass { mass, center: read.center, tensor }))
}

/// Scales all masses and tensors, so that the sum of the masses is `total`.
fn set_total(links: &mut [Link], total: f64, incomplete: Option<String>) {
    let own = |link: &Link| match (&link.computed, &link.inertial) {
        (Some(Ok(computed)), _) => Some(*computed),
        (Some(Err(_)), _) => None,
        (None, Some(inertial)) => written(inertial),
        (None, None) => Some(ComputedMass { mass: 0.0, center: [0.0; 3], tensor: [0.0; 6] }),
    };
    let all: Option<Vec<ComputedMass>> = links.iter().map(own).collect();
    let sum: f64 = all.iter().flatten().map(|body| body.mass).sum();
    match (all, incomplete) {
        (Some(all), None) if sum > 0.0 => {
            for (link, body) in links.iter_mut().zip(all) {
                let factor = total / sum;
                let tensor = scaled(&body.tensor, factor);
                link.computed = Some(Ok(ComputedMass { mass: factor * body.mass, tensor, ..body }));
            }
        }
        (_, why) => {
            let why = why.unwrap_or_else(|| "it needs the mass of another body, which is unknown".to_owned());
            for link in links {
                link.computed = Some(Err(format!("settotalmass cannot be applied: {why}")));
            }
        }
    }
}

/// Combines the parts: c = Σ m_k c_k / m,  I = Σ (I_k + m_k (d² 1 − d dᵀ)),  d = c_k − c.
fn joined(parts: &[ComputedMass]) -> ComputedMass {
    if let [part] = parts {
        return *part;
    }
    let mass: f64 = parts.iter().map(|part| part.mass).sum();
    let center = [0, 1, 2].map(|k| parts.iter().map(|part| part.mass * part.center[k]).sum::<f64>() / mass);
    let mut tensor: Elements = [0.0; 6];
    for part in parts {
        let moved = parallel_axes(part.mass, [0, 1, 2].map(|k| part.center[k] - center[k]));
        tensor = std::array::from_fn(|k| tensor[k] + part.tensor[k] + moved[k]);
    }
    ComputedMass { mass, center, tensor }
}

/// Returns the mass properties of an inertial in the link's frame; `None` if a number cannot be
/// read.
fn written(inertial: &Inertial) -> Option<ComputedMass> {
    let mass = inertial.mass.finite()?;
    if !inertial.pose.unreadable.is_empty() {
        return None;
    }
    let own = match &inertial.tensor {
        Tensor::Missing(_) => return None,
        Tensor::Six(six) => six.each_ref().map(Slot::finite),
        Tensor::Diagonal(three) => {
            let [a, b, c] = three.each_ref().map(Slot::finite);
            [a, b, c, Some(0.0), Some(0.0), Some(0.0)]
        }
    };
    let [Some(xx), Some(yy), Some(zz), Some(xy), Some(xz), Some(yz)] = own else { return None };
    let tensor = rotated(&[xx, yy, zz, xy, xz, yz], &inertial.pose.matrix());
    Some(ComputedMass { mass, center: inertial.pose.position, tensor })
}
