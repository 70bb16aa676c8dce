//! Text: CAD reports, measurement plans, numbers with units, formulas.

use std::path::Path;

use polhode::body::shape::Substance;
use polhode_identify::read as identify;
use polhode_shape::cad;
use polhode_shape::cad::{CadOptions, DecimalMark, GeometryProgram, GeometryReport, ProductConvention};
use polhode_source::expression::{Expression, formula_of_state, formula_of_time};
use polhode_source::files::Disk;
use polhode_source::unit;
use polhode_source::unit::Dimension;

use super::physical::{assert_physical, assert_reported_is_read};

/// Checks measurement plans, with the logs in the folder of examples: reading is deterministic.
pub fn identify(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else { return };
    let folders = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    let examples = folders.map(|folder| folder.join("examples/identify")).find(|folder| folder.is_dir());
    let path = examples.unwrap_or_default().join("plan.toml");
    // Plans are compared as text, because a missing limit may be NaN.
    let read = || identify::from_text(&Disk, &path, text).map(|plan| format!("{plan:?}"));
    match read() {
        Ok(plan) => assert_eq!(Ok(plan), read()),
        Err(error) => assert!(!error.to_string().is_empty() && error.hint() != Some(String::new())),
    }
}

pub fn cad(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else { return };
    let told = |decimal, products| CadOptions {
        decimal: Some(decimal),
        products: Some(products),
        mass_unit: Some(0.001),
        length_unit: Some(0.001),
    };
    let point = told(DecimalMark::Point, ProductConvention::Negative);
    let comma = told(DecimalMark::Comma, ProductConvention::Positive);
    for program in [GeometryProgram::MeshLab, GeometryProgram::FreeCad] {
        if let Ok(shape) = GeometryReport::read(program, text, Some(0.001))
            && let Ok(body) = shape.mass_properties(Substance::Mass(1.5))
        {
            assert_physical(&body);
        }
    }
    let mut first = true;
    for options in [CadOptions::default(), point, comma] {
        let Ok(report) = cad::read(text, &options) else { continue };
        assert_physical(&report.properties);
        let scalars = [report.volume, report.surface_area, report.density];
        assert!(scalars.iter().flatten().all(|scalar| scalar.is_finite()), "{scalars:?}");
        if std::mem::take(&mut first) {
            assert_reported_is_read(&report.properties);
            // Reports are compared as text, because an unknown residual is NaN.
            let again = cad::read(text, &options).map_err(|_| ());
            assert_eq!(format!("{:?}", Ok::<_, ()>(&report)), format!("{again:?}"));
        }
    }
}

pub fn unit(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else { return };
    if let Ok((value, dimension)) = unit::measured(text) {
        assert!(value.is_finite());
        assert_eq!(unit::parse(text, dimension).map(f64::to_bits), Ok(value.to_bits()));
        // The value as printed by Rust can be read back.
        assert_eq!(unit::parse(&format!("{value:?}"), dimension), Ok(value));
        assert_eq!(unit::parse(&format!("{value:e}"), dimension), Ok(value));
        let (scale, turned) = (value * 0.5, unit::measured(&format!("-{text}")));
        if let Ok((turned, _)) = turned {
            assert!(text.trim_start().starts_with(['-', '−', '+']) || turned == -value, "{turned} {scale}");
        }
    }
    for dimension in [Dimension::NONE, Dimension::LENGTH, Dimension::INERTIA, Dimension::ANGULAR_VELOCITY] {
        assert!(unit::parse(text, dimension).map_or(true, f64::is_finite));
        assert!(unit::factor(text, dimension).map_or(true, f64::is_finite));
    }
    let (_, _) = (unit::may_be_several(text), unit::bare_beside_units(text.split(',')));
}

/// Points at which formulas are evaluated: zero, both signs, the ends of the range.
const POINTS: [[f64; 3]; 6] = [
    [0.0; 3],
    [1.7, -0.4, 3.1],
    [-2.5e-8, 6.0e12, -0.9],
    [f64::MAX, f64::MIN_POSITIVE, -f64::MAX],
    [f64::INFINITY, f64::NEG_INFINITY, f64::NAN],
    [1e-320, -1.0, 0.5],
];

pub fn expression(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else { return };
    match Expression::parse(text, &["x", "y", "z"]) {
        Ok(expression) => {
            let mut all = [0.0; POINTS.len()];
            expression.evaluate_all(&POINTS, &mut all);
            for (point, value) in POINTS.into_iter().zip(all) {
                let one = expression.evaluate(point);
                assert!(
                    one.to_bits() == value.to_bits() || one.is_nan() && value.is_nan(),
                    "{one:e} {value:e}"
                );
            }
        }
        Err(error) => assert!(!error.to_string().is_empty() && error.hint() != Some(String::new())),
    }
}

pub fn formula(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else { return };
    let state = [
        0.7, 0.1, -2.0, 3.3, 0.2, 0.4, -0.1, 5.0, 0.3, -0.2, 0.9, 0.1, 0.5, 0.5, 0.5, 0.5, 1.0, 2.0, 3.0, 4.0,
    ];
    let formulas = [formula_of_state(text, None), formula_of_state(text, Some(Dimension::TORQUE))];
    let [any, torque] = formulas;
    if let Ok((formula, dimension)) = &any {
        let value = formula.evaluate(&state);
        assert!(value.to_bits() == formula.evaluate(&state).to_bits() || value.is_nan());
        assert!(torque.is_ok() || *dimension != Dimension::TORQUE);
    }
    if let Ok(formula) = formula_of_time(text, Dimension::ANGULAR_VELOCITY) {
        let _ = formula.evaluate(&[0.7]);
        assert!(!formula.depends_on(1));
    }
}
