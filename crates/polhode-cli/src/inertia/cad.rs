//! The mass properties in a CAD program's report.

use std::path::Path;

use clap::{Args, ValueEnum};
use polhode_formats::cad::{self, CadOptions, CadReport, DecimalMark, ProductConvention};
use polhode_formats::read_text_file;
use polhode_report::{Extra, InertiaReport, SourceInfo, sign_proof};

use crate::failure::Failure;

/// Flags for CAD reports: answers to what a report may leave open.
#[derive(Debug, Args)]
pub(super) struct CadFlags {
    /// What the products of inertia in a CAD report are, where nothing in it proves it.
    #[arg(long, value_name = "SIGN")]
    products: Option<Sign>,
    /// The decimal mark of a CAD report, where its numbers leave it open.
    #[arg(long, value_name = "MARK")]
    decimal: Option<Mark>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Sign {
    /// -∫xy dm: the elements of the tensor.
    Negative,
    /// +∫xy dm
    Positive,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Mark {
    /// 1.5
    Point,
    /// 1,5
    Comma,
}

impl CadFlags {
    /// The first that is given.
    pub(super) const fn given(&self) -> Option<&'static str> {
        match self {
            Self { products: Some(_), .. } => Some("--products"),
            Self { decimal: Some(_), .. } => Some("--decimal"),
            _ => None,
        }
    }
}

pub(super) fn report(
    file: &Path,
    flags: &CadFlags,
    length_unit: Option<f64>,
    mass_unit: Option<f64>,
) -> Result<InertiaReport, Failure> {
    let options = CadOptions {
        decimal: flags.decimal.map(|mark| match mark {
            Mark::Point => DecimalMark::Point,
            Mark::Comma => DecimalMark::Comma,
        }),
        products: flags.products.map(|sign| match sign {
            Sign::Negative => ProductConvention::Negative,
            Sign::Positive => ProductConvention::Positive,
        }),
        mass_unit,
        length_unit,
    };
    let CadReport { product, properties, volume, surface_area, density, proof, findings } =
        read_text_file(file, |text| cad::read(text, &options))?;
    let source = SourceInfo::new(file.display().to_string(), "cad")
        .described(format!("mass properties by {}", product.name()))
        .with("product", product.name());
    let proof: Extra = sign_proof(
        proof.convention.name(),
        proof.by.name(),
        [proof.residual_negative, proof.residual_positive],
        proof.rounding,
    );
    Ok(InertiaReport {
        volume,
        surface_area,
        density,
        extras: vec![proof],
        findings,
        ..InertiaReport::new(source, properties)
    })
}
