//! Voxel grids: one number for each box of a lattice, as NPY and NRRD.
//!
//! A file is read where it lies: the numbers are decoded one by one as they are asked for, and never copied, unless the
//! file is compressed. NRRD says where its voxels are, mostly; NPY never does, so the spacing has to be given.
//!
//! ```
//! use polhode_formats::voxel::{self, VoxelOptions};
//!
//! let file = b"NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 1 1\nencoding: raw\n\
//!     space directions: (2,0,0) (0,2,0) (0,0,2)\nspace dimension: 3\nspace units: \"cm\" \"cm\" \"cm\"\n\n\x03\x01";
//! let voxels = voxel::read(file)?;
//! let grid = voxels.grid(&VoxelOptions::default())?;
//! // A value of 1 is 1000 kg/m³ here.
//! let body = grid.mass_properties(|voxel| 1000.0 * voxels.value(voxel)).unwrap();
//! assert!((body.properties.mass() - 4000.0 * 8e-6).abs() < 1e-17);
//! # Ok::<(), polhode_formats::ContentError>(())
//! ```

mod gzip;
mod npy;
mod nrrd;

use std::borrow::Cow;

use polhode::{BodyError, VoxelGrid};

use crate::content::{ContentError, ContentErrorKind, ContentPlace};

/// The numbers of a voxel file, still in its bytes, or in those that were compressed there.
#[derive(Clone, Debug)]
pub struct Voxels<'a> {
    /// Along the axes in the file's order.
    counts: [usize; 3],
    /// The file's axes in the order of memory: the first varies fastest.
    order: [usize; 3],
    scalar: Scalar,
    big_endian: bool,
    data: Cow<'a, [u8]>,
    placement: Placement,
}

/// Where a file says that its voxels are, in its own unit.
#[derive(Clone, Debug, Default, PartialEq)]
struct Placement {
    /// From a voxel to the next along each of the file's axes.
    steps: Option<[[f64; 3]; 3]>,
    /// The middle of the first voxel.
    origin: Option<[f64; 3]>,
    /// The name of the unit, and what it is in m.
    unit: Option<(String, f64)>,
}

/// What a voxel file does not say, and its user may.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VoxelOptions {
    /// From a voxel to the next along each of the file's axes, m; for files that have no spacing.
    pub spacing: Option<[f64; 3]>,
    /// Unit of the file's spacing, m; for files that have a spacing and no unit.
    pub unit: Option<f64>,
    /// The middle of the first voxel, m. Without it, and where the file says nothing, it is the origin.
    pub origin: Option<[f64; 3]>,
}

/// Reads the bytes of an NPY or NRRD file; which one it is, its first bytes say.
///
/// # Errors
/// [`ContentError`] for anything that is not exactly such a file of three dimensions: what, where, and a hint.
pub fn read(bytes: &[u8]) -> Result<Voxels<'_>, ContentError> {
    if bytes.starts_with(npy::MAGIC) {
        npy::read(bytes)
    } else if bytes.starts_with(nrrd::MAGIC) {
        nrrd::read(bytes)
    } else {
        let found = String::from_utf8_lossy(&bytes[..bytes.len().min(6)]).into_owned();
        let kind = ContentErrorKind::Expected { what: "the start of an NPY or NRRD file".to_owned(), found };
        Err(ContentError::new(kind, ContentPlace::Whole).hint("voxels are read from .npy, .nrrd"))
    }
}

impl Voxels<'_> {
    /// How many voxels there are along each of the file's axes.
    pub const fn counts(&self) -> [usize; 3] {
        self.counts
    }

    /// The file's word for the type of its numbers: `float`, `uint8`.
    pub const fn type_name(&self) -> &'static str {
        self.scalar.name()
    }

    /// The value of a voxel by its number in the grid; NaN beyond the last.
    pub fn value(&self, voxel: usize) -> f64 {
        let size = self.scalar.size();
        let start = voxel.saturating_mul(size);
        let Some(bytes) = start.checked_add(size).and_then(|end| self.data.get(start..end)) else {
            return f64::NAN;
        };
        self.scalar.decode(bytes, self.big_endian)
    }

    /// Where the voxels are, numbered as [`Voxels::value`] numbers them.
    ///
    /// # Errors
    /// [`ContentErrorKind::Missing`], with a question as its hint, if neither the file nor the options say the spacing or
    /// its unit; [`ContentErrorKind::Value`] if both do, or if no grid has such steps.
    pub fn grid(&self, options: &VoxelOptions) -> Result<VoxelGrid, ContentError> {
        let whole = |kind| ContentError::new(kind, ContentPlace::Whole);
        let missing = |what: &str| whole(ContentErrorKind::Missing { what: what.to_owned() });
        let twice = |what: &str, value: String| {
            let rule = "left out, since the file says it itself".to_owned();
            whole(ContentErrorKind::Value { what: what.to_owned(), value, rule })
        };
        let Placement { steps, origin, unit } = &self.placement;
        if let (None, None, Some(given)) = (steps, origin, options.unit) {
            let (what, rule) =
                ("the unit".to_owned(), "left out, since no length of the file is without one".to_owned());
            let refused = whole(ContentErrorKind::Value { what, value: given.to_string(), rule });
            return Err(refused.hint("the spacing and the origin that are given have units of their own"));
        }
        let unit = match (unit, options.unit) {
            (Some(_), Some(given)) => return Err(twice("the unit", given.to_string())),
            (unit, given) => unit.as_ref().map(|(_, metres)| *metres).or(given),
        };
        let needed = || {
            unit.ok_or_else(|| {
                missing("unit of length").hint("in which unit is the spacing of the voxels? give it")
            })
        };
        let steps = match (steps, options.spacing) {
            (Some(_), Some(given)) => return Err(twice("the spacing", format!("{given:?}"))),
            (Some(steps), None) => {
                let unit = needed()?;
                steps.map(|step| step.map(|c| c * unit))
            }
            (None, Some([a, b, c])) => [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]],
            (None, None) => {
                let hint = "how far is it from one voxel to the next, along each axis? give the spacing";
                return Err(missing("spacing of its voxels").hint(hint));
            }
        };
        let origin = match (origin, options.origin) {
            (Some(_), Some(given)) => return Err(twice("the origin", format!("{given:?}"))),
            (Some(origin), None) => {
                let unit = needed()?;
                origin.map(|c| c * unit)
            }
            (None, given) => given.unwrap_or_default(),
        };
        let refused = |error: BodyError| {
            let (what, value, rule) = match error {
                BodyError::Parameter { what, value, rule } => (what, value.to_string(), rule.to_owned()),
                other => ("the grid", format!("{:?}", self.counts), other.to_string()),
            };
            whole(ContentErrorKind::Value { what: what.to_owned(), value, rule })
        };
        VoxelGrid::new(origin, self.order.map(|axis| steps[axis]), self.order.map(|axis| self.counts[axis]))
            .map_err(refused)
    }
}

/// The type of a file's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Scalar {
    Bool,
    U8,
    I8,
    U16,
    I16,
    U32,
    I32,
    U64,
    I64,
    F32,
    F64,
}

impl Scalar {
    const fn size(self) -> usize {
        match self {
            Self::Bool | Self::U8 | Self::I8 => 1,
            Self::U16 | Self::I16 => 2,
            Self::U32 | Self::I32 | Self::F32 => 4,
            Self::U64 | Self::I64 | Self::F64 => 8,
        }
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Bool => "bool",
            Self::U8 => "uint8",
            Self::I8 => "int8",
            Self::U16 => "uint16",
            Self::I16 => "int16",
            Self::U32 => "uint32",
            Self::I32 => "int32",
            Self::U64 => "uint64",
            Self::I64 => "int64",
            Self::F32 => "float",
            Self::F64 => "double",
        }
    }

    /// The nearest f64; integers beyond 2⁵³ are rounded.
    fn decode(self, bytes: &[u8], big_endian: bool) -> f64 {
        let pick = |little: u64, big: u64| if big_endian { big } else { little };
        let bits = match *bytes {
            [a] => a.into(),
            [a, b] => pick(u16::from_le_bytes([a, b]).into(), u16::from_be_bytes([a, b]).into()),
            [a, b, c, d] => {
                pick(u32::from_le_bytes([a, b, c, d]).into(), u32::from_be_bytes([a, b, c, d]).into())
            }
            [a, b, c, d, e, f, g, h] => {
                let word = [a, b, c, d, e, f, g, h];
                pick(u64::from_le_bytes(word), u64::from_be_bytes(word))
            }
            _ => return f64::NAN,
        };
        match self {
            Self::Bool => f64::from(u8::from(bits != 0)),
            Self::U8 | Self::U16 | Self::U32 | Self::U64 => bits as f64,
            Self::I8 => f64::from(bits as u8 as i8),
            Self::I16 => f64::from(bits as u16 as i16),
            Self::I32 => f64::from(bits as u32 as i32),
            Self::I64 => bits as i64 as f64,
            Self::F32 => f64::from(f32::from_bits(bits as u32)),
            Self::F64 => f64::from_bits(bits),
        }
    }
}

/// How many bytes the voxels take.
fn declared_bytes(counts: [usize; 3], scalar: Scalar) -> Result<u64, ContentError> {
    let declared = counts.iter().try_fold(scalar.size() as u64, |all, &n| all.checked_mul(n as u64));
    declared.ok_or_else(|| {
        let value = counts.map(|n| n.to_string()).join(" × ");
        let rule = "addressable".to_owned();
        let kind = ContentErrorKind::Value { what: "the number of voxels".to_owned(), value, rule };
        ContentError::new(kind, ContentPlace::Whole)
    })
}

/// The voxels must take the bytes that are there.
fn require_length(counts: [usize; 3], scalar: Scalar, data: &[u8], start: usize) -> Result<(), ContentError> {
    let place = || ContentPlace::Byte { offset: start as u64, what: "the first voxel".to_owned() };
    let declared = declared_bytes(counts, scalar)?;
    let present = data.len() as u64;
    if declared == 0 {
        let kind = ContentErrorKind::Missing { what: "voxels".to_owned() };
        return Err(ContentError::new(kind, ContentPlace::Whole));
    }
    if declared != present {
        let kind = ContentErrorKind::Count { what: "bytes of voxels".to_owned(), declared, present };
        let hint = if present < declared {
            "the file is cut short"
        } else {
            "the file has bytes that belong to no voxel"
        };
        return Err(ContentError::new(kind, place()).hint(hint));
    }
    Ok(())
}
