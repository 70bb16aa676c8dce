//! Binary STL straight to the moments of its solid, in one pass, without keeping a triangle.
//!
//! What [`super::MeshSolid::read`] does in several passes and 100 bytes a triangle, at about the speed of reading the bytes. The price:
//! where a mesh is open or wrongly wound this says so, but not at which edge, and it finds no duplicates. For
//! everything that is not binary STL it answers `None`: the ordinary reader is there.

use std::fs::File;
use std::io::Read;
use std::num::NonZeroUsize;
use std::path::Path;

use polhode::body::{BodyError, MeasuredSolid};
use polhode::math::Position;
use polhode_stl::{Moments, NotFinite, Options, Record, moments_of_file, moments_of_records};

use super::stl;
use super::stl_error::{StlError, StlPlace};
use crate::error::{FormatError, FormatErrorKind};
use crate::file;

const PREAMBLE: u64 = 84;
const RECORD: u64 = size_of::<Record>() as u64;

/// How to read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuickOptions {
    /// How many threads; the answer has the same bits with any number.
    pub threads: NonZeroUsize,
    /// Whether to find out if the mesh is closed and consistently wound.
    pub verdict: bool,
}

impl Default for QuickOptions {
    /// As many threads as the machine has processors, and the verdict.
    fn default() -> Self {
        let threads = std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN);
        Self { threads, verdict: true }
    }
}

/// The moments of the solid that a binary STL file bounds, in the file's unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuickMoments {
    /// Triangles in the file, degenerate ones too.
    pub triangles: u64,
    /// Volume, positive.
    pub volume: f64,
    /// Area of all triangles.
    pub area: f64,
    /// Centre of the volume.
    pub centroid: [f64; 3],
    /// ⟨x xᵀ⟩ about the centroid, per unit volume: xx, yy, zz, xy, xz, yz; products with the sign of the integral.
    pub covariance: [f64; 6],
    /// Least and greatest coordinates.
    pub bounds: [[f64; 3]; 2],
    /// True if the normals point inward: the numbers are those of the mesh turned.
    pub inverted: bool,
    /// Whether every edge is run along as often one way as the other: closed and consistently wound. If `false`, it is
    /// not, and the numbers mean little. If `true`, it is, but for one chance in some 2⁶⁰. `None` if not asked for.
    pub closed: Option<bool>,
}

impl QuickMoments {
    /// The solid, for a unit of length of so many metres.
    ///
    /// ```
    /// use polhode::body::shape::{Shape, Substance};
    /// use polhode_formats::mesh::stl_quick::{QuickOptions, parse};
    /// let [o, x, y, z] = [[0.0_f32, 0.0, 0.0], [20.0, 0.0, 0.0], [0.0, 30.0, 0.0], [0.0, 0.0, 10.0]];
    /// let mut bytes = vec![0; 80];
    /// bytes.extend(4_u32.to_le_bytes());
    /// for triangle in [[o, y, x], [o, x, z], [o, z, y], [x, y, z]] {
    ///     bytes.extend([0; 12]); // the normal is ignored
    ///     bytes.extend(triangle.as_flattened().iter().flat_map(|c| c.to_le_bytes()));
    ///     bytes.extend([0; 2]);
    /// }
    /// let corner = parse(&bytes, "corner.stl".as_ref(), &QuickOptions::default())?.unwrap();
    /// assert_eq!(corner.closed, Some(true));
    /// let body = corner.solid(0.001)?.mass_properties(Substance::Density(2700.0))?;
    /// assert!((body.mass() - 2.7e-3).abs() < 1e-17);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BodyError`] if the unit is not positive and finite, or no solid has such moments: those of an open mesh may be
    /// anything.
    pub fn solid(&self, unit: f64) -> Result<MeasuredSolid, BodyError> {
        if !(unit > 0.0 && unit.is_finite()) {
            let what = "the mesh's unit";
            return Err(BodyError::Parameter { what, value: unit, rule: "positive and finite" });
        }
        MeasuredSolid::from_moments(
            self.volume * unit * unit * unit,
            self.area * unit * unit,
            Position::from_array(self.centroid.map(|c| c * unit)),
            self.covariance.map(|c| c * unit * unit),
        )
    }

    /// From sums about the reference point; why there is no solid, if there is none.
    fn of(moments: &Moments, path: &Path) -> Result<Self, FormatError> {
        let fail = |kind| Err(FormatError::new(path, None, kind));
        if moments.count == 0 {
            return fail(FormatErrorKind::Stl(StlError::NoTriangles));
        }
        if let Some(found) = moments.not_finite {
            return fail(FormatErrorKind::Stl(not_finite(&found)));
        }
        let six_volume = moments.six_volume;
        // No noise of flat triangles is larger: each one's area times its distance, rounded.
        let size = (0..3).map(|k| moments.high[k] - moments.low[k]).fold(0.0, f64::max);
        if six_volume.abs() <= 16.0 * f64::EPSILON * moments.area * size {
            return fail(FormatErrorKind::Body(BodyError::FlatMesh { volume: six_volume / 6.0 }));
        }
        // 24 V c = Σ d s and 120 V ⟨x xᵀ⟩ = Σ d (a aᵀ + b bᵀ + c cᵀ + s sᵀ), from the reference point.
        let c = moments.first.map(|f| f / (4.0 * six_volume));
        let square = [c[0] * c[0], c[1] * c[1], c[2] * c[2], c[0] * c[1], c[0] * c[2], c[1] * c[2]];
        Ok(Self {
            triangles: moments.count,
            volume: six_volume.abs() / 6.0,
            area: moments.area,
            centroid: core::array::from_fn(|k| moments.reference[k] + c[k]),
            covariance: core::array::from_fn(|k| moments.second[k] / (20.0 * six_volume) - square[k]),
            bounds: [moments.low, moments.high],
            inverted: six_volume < 0.0,
            closed: moments.edge_hash.map(|hash| hash == 0),
        })
    }
}

/// The moments of the solid in a file; `None` if it is not a regular file, or text: the ordinary reader's work.
///
/// # Errors
/// [`FormatError`] if the file cannot be read, is as long as no STL file, has no triangles or a vertex that is not
/// finite, or bounds no volume, and if it changes while it is read. A count that does not fit the file's length is refused before anything else is read.
pub fn read(path: &Path, options: &QuickOptions) -> Result<Option<QuickMoments>, FormatError> {
    let io = |error| FormatError::new(path, None, file::failed(&path.to_string_lossy(), &error));
    let mut file = File::open(path).map_err(io)?;
    let metadata = file.metadata().map_err(io)?;
    if !metadata.is_file() {
        return Ok(None);
    }
    let mut head = Vec::new();
    (&mut file).take(HEAD).read_to_end(&mut head).map_err(io)?;
    let Some(count) = count(&head, metadata.len()).map_err(|e| stl::refused(path, &head, e))? else {
        return Ok(None);
    };
    let sums = Options { threads: options.threads, edges: options.verdict };
    let moments = moments_of_file(&file, PREAMBLE, count, &sums).map_err(io)?;
    file::unchanged(&file, &metadata).map_err(io)?;
    QuickMoments::of(&moments, path).map(Some)
}

/// The moments of the solid in the bytes of a file; `path` is for messages. See [`read`].
///
/// # Errors
/// As [`read`], without what is about reading.
pub fn parse(bytes: &[u8], path: &Path, options: &QuickOptions) -> Result<Option<QuickMoments>, FormatError> {
    let head = &bytes[..bytes.len().min(HEAD as usize)];
    if count(head, bytes.len() as u64).map_err(|e| stl::refused(path, head, e))?.is_none() {
        return Ok(None);
    }
    let sums = Options { threads: options.threads, edges: options.verdict };
    // The length fits the count.
    let records = bytes.get(PREAMBLE as usize..).unwrap_or_default().as_chunks().0;
    QuickMoments::of(&moments_of_records(records, &sums), path).map(Some)
}

/// As much of a file as tells binary from text.
const HEAD: u64 = 512;

/// How many triangles a file of this length has; `None` if it is text.
fn count(head: &[u8], length: u64) -> Result<Option<u64>, StlError> {
    let declared = head.get(80..).and_then(<[u8]>::first_chunk).map(|&count| u32::from_le_bytes(count));
    let in_bytes = usize::try_from(length).unwrap_or(usize::MAX);
    match declared {
        Some(n) if length == PREAMBLE + RECORD * u64::from(n) => Ok(Some(u64::from(n))),
        _ if is_text(head) => Ok(None),
        Some(declared) => Err(StlError::WrongCount { declared, length: in_bytes }),
        None => Err(StlError::Unrecognized { length: in_bytes }),
    }
}

/// Starts with `solid`, and has no zero byte, which the count of a binary file has up to 16 million triangles.
fn is_text(head: &[u8]) -> bool {
    let text = head.strip_prefix("\u{feff}".as_bytes()).unwrap_or(head).trim_ascii_start();
    text.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid")) && !head.contains(&0)
}

fn not_finite(found: &NotFinite) -> StlError {
    let index = usize::try_from(found.triangle).unwrap_or(usize::MAX);
    let offset =
        usize::try_from(PREAMBLE + RECORD * found.triangle + found.offset as u64).unwrap_or(usize::MAX);
    StlError::NotFinite { at: StlPlace::Record { index, offset }, found: found.value.to_string() }
}
