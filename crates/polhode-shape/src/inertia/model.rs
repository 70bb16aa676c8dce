//! What a mesh file is taken as, before it has a mass.

use polhode::body::BodyError;
use polhode::body::shape::Shape;
use polhode_document::SourceInfo;
use polhode_source::Failure;

use super::field;

/// What a file's mesh is taken as.
pub(super) struct Model {
    pub(super) source: SourceInfo,
    /// Metres in the file's unit of length.
    pub(super) unit: f64,
    pub(super) pieces: Vec<Piece>,
    pub(super) field: Option<field::Found>,
}

/// One part with a shape.
pub(super) struct Piece {
    pub(super) name: String,
    pub(super) shape: Box<dyn Shape>,
}

impl Piece {
    pub(super) fn volume(&self) -> f64 {
        self.shape.spread().extent().measure()
    }
}

#[allow(clippy::needless_pass_by_value, reason = "a function for map_err")]
pub(super) fn unfit(error: BodyError) -> Failure {
    let hint = match error {
        BodyError::FlatPoints { .. } => "a hull needs four points that do not lie in one plane",
        _ => "check --density, --mass, --part and --unit",
    };
    Failure::usage(error.to_string(), hint)
}
