//! Properties of every accepted body.

use std::path::Path;

use polhode::body::MassProperties;
use polhode::math::{Body, Frame};
use polhode_robot::lump::{Lumping, lump};
use polhode_robot::read::{ReadOptions, read_text};
use polhode_shape::cad;
use polhode_shape::cad::CadOptions;
use polhode_shape::export;
use polhode_shape::{ExportBody, ExportFormat};

/// Rounding error of i1 + i2 − i3, relative to i3.
const ROUNDING: f64 = 1e-12;

/// Checks that the mass is positive, all numbers are finite, the tensor is symmetric, and i1 + i2 ≥
/// i3.
#[track_caller]
pub(crate) fn assert_physical<F: Frame>(body: &MassProperties<F>) {
    let inertia = body.inertia().matrix();
    assert!(body.mass() > 0.0 && body.mass().is_finite(), "mass {:e}", body.mass());
    assert!(body.center_of_mass().is_finite(), "centre {:?}", body.center_of_mass());
    for (i, row) in inertia.iter().enumerate() {
        for (j, element) in row.iter().enumerate() {
            assert!(element.is_finite() && *element == inertia[j][i], "{inertia:?}");
        }
    }
    let [i1, i2, i3] = body.principal().moments();
    assert!(0.0 <= i1 && i1 <= i2 && i2 <= i3 && i3.is_finite(), "{i1:e} {i2:e} {i3:e}");
    assert!(i1 + (i2 - i3) >= -ROUNDING * i3, "{i1:e} + {i2:e} < {i3:e}");
}

/// Checks that a body exported as URDF reads back bit-identical.
#[track_caller]
pub(crate) fn assert_written_is_read(body: &MassProperties<Body>) {
    let Ok(text) = export(ExportFormat::Urdf, &[ExportBody::new("a", *body)]) else { return };
    let model = read_text(&text, Path::new("/nowhere/a.urdf"), &ReadOptions::default());
    let lumps = lump(&model.unwrap(), Lumping::All, &[]);
    let lump = lumps.as_ref().ok().and_then(|lumps| lumps.first());
    let lump = lump.unwrap_or_else(|| panic!("{lumps:?}\n{text}"));
    assert!(lump.rounding > 0.0 || lump.properties == *body, "{:?}\n{text}", lump.properties);
}

/// Checks that a body exported as a CAD report reads back equal up to rounding.
#[track_caller]
pub(crate) fn assert_reported_is_read(body: &MassProperties<Body>) {
    let Ok(text) = export(ExportFormat::SolidWorks, &[ExportBody::new("a", *body)]) else { return };
    let report = cad::read(&text, &CadOptions::default()).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let close = |read: &[f64], was: &[f64]| {
        let size = was.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        read.iter().zip(was).all(|(a, b)| (a - b).abs() <= 1e-12 * size)
    };
    let again = &report.properties;
    assert!(
        close(&[again.mass()], &[body.mass()])
            && close(&again.center_of_mass().to_array(), &body.center_of_mass().to_array())
            && close(again.inertia().matrix().as_flattened(), body.inertia().matrix().as_flattened()),
        "{again:?}\n{text}"
    );
}
