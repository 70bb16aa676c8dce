//! Options for meshes.

use std::path::PathBuf;
use std::str::FromStr;

use polhode_source::expression::Expression;
use polhode_source::given::{Given, Length, Number, Positive};
use serde::{Deserialize, Serialize};

use super::substance::PartSubstance;
use crate::mesh::{Fraction, MeshLength, Share};

/// Options that conflict with --field, and therefore with --tolerance. clap does not check the
/// conflicts of a required option.
#[cfg(feature = "arguments")]
const WITHOUT_FIELD: [&str; 5] = ["density", "mass", "material", "part", "shell"];

/// Options for meshes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct MeshChoice {
    /// The substance of one part of a mesh: its name in the file, and its density, mass or
    /// material; may be repeated.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "NAME=WHAT"))]
    pub part: Vec<Given<PartSubstance>>,
    /// Use the convex hull of each part of a mesh, closed or not, instead of the mesh. Point clouds
    /// are also accepted: .xyz files, and .ply and .obj files without faces.
    #[cfg_attr(feature = "arguments", arg(long, conflicts_with = "shell"))]
    pub hull: bool,
    /// Use a shell of this thickness along a mesh, closed or not, instead of the solid in it.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "THICKNESS"))]
    pub shell: Option<Given<Positive<Length>>>,
    /// Density of a mesh as a formula of x, y, z in metres, in kg/m³, such as "2700 - 300*hypot(x,
    /// y)".
    #[cfg_attr(feature = "arguments", arg(long, value_name = "FORMULA", conflicts_with_all = WITHOUT_FIELD, allow_hyphen_values = true))]
    pub field: Option<Given<DensityFormula>>,
    /// Tolerance for the estimated relative error of --field [default: 1e-10].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "ERROR", requires = "field", conflicts_with_all = WITHOUT_FIELD))]
    pub tolerance: Option<Given<Positive<Number>>>,
    /// Join vertices of open edges within this distance, and split open edges at vertices within
    /// it: a length such as "0.01 mm", or a plain number relative to the mesh's size (the diagonal
    /// of its box).
    #[cfg_attr(feature = "arguments", arg(long, value_name = "TOL", conflicts_with_all = ["hull", "shell"]))]
    pub weld: Option<Given<Positive<MeshLength>>>,
    /// Close holes up to this size, after a weld: a length such as "2 mm", or a plain number
    /// relative to the mesh's size.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "SIZE", conflicts_with_all = ["hull", "shell"]))]
    pub fill: Option<Given<Positive<MeshLength>>>,
    /// Close all holes that remain, if they leave at most this share of the volume uncertain, such
    /// as 5%; the report then has error bounds, valid if each missing surface lies within the
    /// convex hull of its hole.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "SHARE", conflicts_with_all = ["hull", "shell", "union", "field", "tolerance"]))]
    pub close_within: Option<Given<Share>>,
    /// Print the mesh with walls of this thickness along its surface, and an infill (--infill)
    /// behind them.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "THICKNESS", requires = "infill", conflicts_with_all = ["hull", "shell", "union", "field", "tolerance", "close_within"]))]
    pub walls: Option<Given<Positive<Length>>>,
    /// Print solid layers of this thickness under all that faces up; z is up.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "THICKNESS", requires = "walls", conflicts_with_all = ["hull", "shell", "union", "field", "tolerance", "close_within"]))]
    pub top_layers: Option<Given<Positive<Length>>>,
    /// Print solid layers of this thickness over all that faces down.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "THICKNESS", requires = "walls", conflicts_with_all = ["hull", "shell", "union", "field", "tolerance", "close_within"]))]
    pub bottom_layers: Option<Given<Positive<Length>>>,
    /// Density of the infill behind --walls relative to the material's, such as 15%; its distance
    /// from the surface exceeds the walls' thickness.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "SHARE", requires = "walls", conflicts_with_all = ["hull", "shell", "union", "field", "tolerance", "close_within"]))]
    pub infill: Option<Given<Fraction>>,
    /// Use the union of all parts, so that regions that overlap or repeat count once; after a weld
    /// and a fill.
    #[cfg_attr(feature = "arguments", arg(long, conflicts_with_all = ["shell", "part", "field", "tolerance", "write_mesh", "force"]))]
    pub union: bool,
    /// Write the mesh after repairs (weld, fill, outward winding), in the file's unit: .stl
    /// (binary), .obj or .ply.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "FILE", conflicts_with = "shell"))]
    pub write_mesh: Option<PathBuf>,
}

/// Density formula of x, y, z in metres, in kg/m³.
#[derive(Clone, Debug, PartialEq)]
pub struct DensityFormula(pub Expression);

impl FromStr for DensityFormula {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Expression::parse(text, &["x", "y", "z"]).map(Self).map_err(|error| match error.hint() {
            Some(hint) => format!("{error} (hint: {hint})"),
            None => error.to_string(),
        })
    }
}

impl MeshChoice {
    /// Returns the name of the first option that is set.
    pub(in crate::inertia) fn given(&self) -> Option<&'static str> {
        let flags = [
            (!self.part.is_empty(), "--part"),
            (self.hull, "--hull"),
            (self.shell.is_some(), "--shell"),
            (self.field.is_some(), "--field"),
            (self.tolerance.is_some(), "--tolerance"),
            (self.weld.is_some(), "--weld"),
            (self.fill.is_some(), "--fill"),
            (self.close_within.is_some(), "--close-within"),
            (self.walls.is_some(), "--walls"),
            (self.top_layers.is_some(), "--top-layers"),
            (self.bottom_layers.is_some(), "--bottom-layers"),
            (self.infill.is_some(), "--infill"),
            (self.union, "--union"),
            (self.write_mesh.is_some(), "--write-mesh"),
        ];
        flags.into_iter().find(|(given, _)| *given).map(|(_, flag)| flag)
    }
}
