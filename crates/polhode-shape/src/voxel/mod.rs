//! Voxel grids: one number for each cell of a lattice, in NPY and NRRD files.
//!
//! The numbers are decoded in blocks on demand and not stored, because a few compressed bytes may
//! expand to very many. An NRRD file usually states the positions of its voxels. An NPY file does
//! not, so the spacing must be given.
//!
//! ```
//! use polhode_shape::voxel::{self, VoxelOptions};
//!
//! let file = b"NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 1 1\nencoding: raw\n\
//!     space directions: (2,0,0) (0,2,0) (0,0,2)\nspace dimension: 3\nspace units: \"cm\" \"cm\" \"cm\"\n\n\x03\x01";
//! let mut voxels = voxel::read(file)?;
//! let grid = voxels.grid(&VoxelOptions::default())?;
//! // A value of 1 is 1000 kg/m³ here.
//! let body = voxels.mass_properties(&grid, 1000.0)?.unwrap();
//! assert!((body.properties.mass() - 4000.0 * 8e-6).abs() < 1e-17);
//! # Ok::<(), polhode_source::ContentError>(())
//! ```

mod data;
mod npy;
mod nrrd;

use std::io::{self, Read};
use std::path::Path;

use polhode::body::BodyError;
use polhode::body::density::{VoxelGrid, VoxelMassProperties};
use polhode_source::FormatError;
use polhode_source::file;
use polhode_source::files::Files;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use data::Source;

pub use data::VoxelValues;

/// Voxel file: its header, and its numbers, which are read on demand.
#[derive(Debug)]
pub struct Voxels<'a> {
    layout: Layout,
    source: Source<'a>,
}

/// Contents of a header.
#[derive(Clone, Debug, PartialEq)]
struct Layout {
    /// Number of voxels along the axes, in file order.
    counts: [usize; 3],
    /// File axes in memory order: the first varies fastest.
    order: [usize; 3],
    scalar: Scalar,
    big_endian: bool,
    placement: Placement,
    /// Offset of the numbers or of the compressed data, bytes.
    start: u64,
    /// Number of bytes to skip after decompression; `None` if the numbers are not compressed.
    compressed: Option<u64>,
    /// Total size of the numbers, bytes.
    declared: u64,
}

/// Position of the voxels according to the file, in its own unit.
#[derive(Clone, Debug, Default, PartialEq)]
struct Placement {
    /// Steps from a voxel to the next along each axis of the file.
    steps: Option<[[f64; 3]; 3]>,
    /// Centre of the first voxel.
    origin: Option<[f64; 3]>,
    /// Name of the unit, and its value in metres.
    unit: Option<(String, f64)>,
}

/// Values that a voxel file may omit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VoxelOptions {
    /// Distances of adjacent voxels along the axes of the file, m; for files without a spacing.
    pub spacing: Option<[f64; 3]>,
    /// Unit of the file's spacing, m; for files with a spacing but no unit.
    pub unit: Option<f64>,
    /// Centre of the first voxel, m. Without it, and if the file states none, it is the origin.
    pub origin: Option<[f64; 3]>,
}

/// Maximum size of a header, bytes.
const HEAD: u64 = 1 << 20;

/// Reads the bytes of an NPY or NRRD file; the first bytes determine the format.
///
/// # Errors
/// [`ContentError`] with place and hint for anything other than such a file with three dimensions.
/// A wrong count of compressed numbers is detected only when they are read.
pub fn read(bytes: &[u8]) -> Result<Voxels<'_>, ContentError> {
    let layout = layout(bytes, bytes.len() as u64)?;
    Ok(Voxels { layout, source: Source::Memory(bytes.into()) })
}

/// Opens an NPY or NRRD file, and reads its header.
///
/// # Errors
/// [`FormatError`] if the file cannot be read, and for the errors of [`read()`].
pub fn open<'a>(files: &'a dyn Files, path: &Path) -> Result<Voxels<'a>, FormatError> {
    let written = path.to_string_lossy();
    let failed = |error| FormatError::new(path, None, file::failed(&written, &error));
    if !files.look(path).map_err(failed)?.is_file() {
        // A pipe can be read only once, but the numbers are read twice.
        let bytes = file::bytes(files, path, &written, u64::MAX);
        let bytes = bytes.map_err(|kind| FormatError::new(path, None, kind))?;
        let layout =
            layout(&bytes, bytes.len() as u64).map_err(|e| FormatError::of_content(path, &bytes, e))?;
        return Ok(Voxels { layout, source: Source::Memory(bytes.into()) });
    }
    let file = files.open(path).map_err(failed)?;
    let before = file.look().map_err(failed)?;
    let mut head = Vec::new();
    file.take(HEAD).read_to_end(&mut head).map_err(failed)?;
    if (head.len() as u64) < before.length.min(HEAD) {
        return Err(failed(io::ErrorKind::UnexpectedEof.into()));
    }
    let layout = layout(&head, before.length).map_err(|e| FormatError::of_content(path, &head, e))?;
    Ok(Voxels { layout, source: Source::File { files, path: path.to_owned(), before } })
}

/// Reads the header from the first bytes of a file with this length.
fn layout(head: &[u8], length: u64) -> Result<Layout, ContentError> {
    if head.starts_with(npy::MAGIC) {
        npy::read(head, length)
    } else if head.starts_with(nrrd::MAGIC) {
        nrrd::read(head, length)
    } else {
        let found = String::from_utf8_lossy(&head[..head.len().min(6)]).into_owned();
        let kind = ContentErrorKind::expected("the start of an NPY or NRRD file", found);
        Err(kind.of_whole().hint("voxels are read from .npy, .nrrd"))
    }
}

impl Voxels<'_> {
    /// Returns the number of voxels along each axis of the file.
    pub const fn counts(&self) -> [usize; 3] {
        self.layout.counts
    }

    /// Returns the file's name for its number type: `float`, `uint8`.
    pub const fn type_name(&self) -> &'static str {
        self.layout.scalar.name()
    }

    /// Returns the values of the voxels by their numbers, as in the grid. The borrow is mutable,
    /// because only one reader may use an open file.
    pub fn values(&mut self) -> VoxelValues<'_> {
        VoxelValues::of(self)
    }

    /// Returns the mass properties of the voxels, where a value of 1 means the density `per_value`,
    /// kg/m³. The inner error is returned if they do not form a physical body.
    ///
    /// # Errors
    /// [`ContentError`] if the file has a different number of values than it declares, or cannot be
    /// decompressed.
    pub fn mass_properties(
        &mut self,
        grid: &VoxelGrid,
        per_value: f64,
    ) -> Result<Result<VoxelMassProperties, BodyError>, ContentError> {
        /// Reason for the end of the summation.
        enum End {
            Content(ContentError),
            Body(BodyError),
        }
        impl From<BodyError> for End {
            fn from(error: BodyError) -> Self {
                Self::Body(error)
            }
        }
        let mut values = self.values();
        match grid.try_mass_properties(|voxel| Ok(per_value * values.at(voxel).map_err(End::Content)?)) {
            Ok(body) => Ok(Ok(body)),
            Err(End::Body(error)) => Ok(Err(error)),
            Err(End::Content(error)) => Err(error),
        }
    }

    /// Returns the grid with the positions of the voxels, numbered as in [`Voxels::values`].
    ///
    /// # Errors
    /// [`ContentErrorKind::Missing`], with a question as its hint, if neither the file nor the
    /// options state the spacing or its unit. [`ContentErrorKind::Value`] if both state it, or if
    /// the steps do not form a grid.
    pub fn grid(&self, options: &VoxelOptions) -> Result<VoxelGrid, ContentError> {
        let whole = ContentErrorKind::of_whole;
        let missing = |what: &str| whole(ContentErrorKind::missing(what));
        let twice = |what: &str, value: String| {
            whole(ContentErrorKind::value(what, value, "absent, because the file states it"))
        };
        let Layout { placement: Placement { steps, origin, unit }, order, counts, .. } = &self.layout;
        if let (None, None, Some(given)) = (steps, origin, options.unit) {
            let (what, rule) = ("the unit", "absent, because every length in the file has a unit");
            let refused = whole(ContentErrorKind::value(what, given.to_string(), rule));
            return Err(refused.hint("the given spacing and origin have their own units"));
        }
        let unit = match (unit, options.unit) {
            (Some(_), Some(given)) => return Err(twice("the unit", given.to_string())),
            (unit, given) => unit.as_ref().map(|(_, metres)| *metres).or(given),
        };
        let needed = || {
            unit.ok_or_else(|| missing("unit of length").hint("give the unit of the spacing of the voxels"))
        };
        let steps = match (steps, options.spacing) {
            (Some(_), Some(given)) => return Err(twice("the spacing", format!("{given:?}"))),
            (Some(steps), None) => {
                let unit = needed()?;
                steps.map(|step| step.map(|c| c * unit))
            }
            (None, Some([a, b, c])) => [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]],
            (None, None) => {
                let hint = "give the spacing, the distance between adjacent voxels along each axis";
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
                other => ("the grid", format!("{counts:?}"), other.to_string()),
            };
            whole(ContentErrorKind::value(what, value, rule))
        };
        VoxelGrid::new(origin, order.map(|axis| steps[axis]), order.map(|axis| counts[axis])).map_err(refused)
    }
}

/// Number type of a file.
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

    /// Decodes to the nearest f64; integers beyond 2⁵³ are rounded.
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

/// Returns the size of all voxels, bytes.
fn declared_bytes(counts: [usize; 3], scalar: Scalar) -> Result<u64, ContentError> {
    let declared = counts.iter().try_fold(scalar.size() as u64, |all, &n| all.checked_mul(n as u64));
    declared.ok_or_else(|| {
        let value = counts.map(|n| n.to_string()).join(" × ");
        ContentErrorKind::value("the number of voxels", value, "addressable").of_whole()
    })
}

/// Checks that there are voxels, and that their size is the actual one, if that is known.
fn require_length(declared: u64, present: Option<u64>, start: u64) -> Result<(), ContentError> {
    if declared == 0 {
        return Err(ContentErrorKind::missing("voxels").of_whole());
    }
    let Some(present) = present.filter(|&present| present != declared) else { return Ok(()) };
    let kind = ContentErrorKind::count("bytes of voxels", declared, present);
    let hint =
        if present < declared { "the file is truncated" } else { "the file has bytes after the last voxel" };
    let place = ContentPlace::Byte { offset: start, what: "the first voxel".to_owned() };
    Err(ContentError::new(kind, place).hint(hint))
}
