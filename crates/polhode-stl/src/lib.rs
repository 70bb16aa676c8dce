//! The ten moments of the records of a binary STL file, in one pass over its bytes.
//!
//! A record is 50 bytes: a normal, which is ignored, three vertices of three `f32`, and two bytes more. From the records
//! come [`Moments`]: sums over the signed tetrahedra between a point near the middle of the body and each triangle,
//! the area, the box, and, if asked for, a hash of the edges that is zero when the mesh is closed.
//!
//! ```
//! use polhode_stl::{Options, Record, moments_of_records};
//! let [o, x, y, z] = [[0.0_f32, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
//! let record = |triangle: [[f32; 3]; 3]| -> Record {
//!     let mut bytes = [0; 50];
//!     for (word, c) in bytes[12..48].as_chunks_mut::<4>().0.iter_mut().zip(triangle.as_flattened()) {
//!         *word = c.to_le_bytes();
//!     }
//!     bytes
//! };
//! let corner = [[o, y, x], [o, x, z], [o, z, y], [x, y, z]].map(record);
//! let moments = moments_of_records(&corner, &Options::default());
//! assert!((moments.six_volume - 6.0).abs() < 1e-14);
//! assert_eq!(moments.edge_hash, Some(0));
//! assert_eq!(moments_of_records(&corner[1..], &Options::default()).edge_hash == Some(0), false);
//! ```
//!
//! The result has the same bits with any number of threads, in any width of vectors, from records in memory or from a file:
//! the file is cut into blocks that depend on its length only, and what is fused is fused everywhere (slowly, on processors that have no
//! instruction for it).

mod block;
mod columns;
#[cfg(target_arch = "x86_64")]
mod columns512;
mod edges;
mod moments;
mod not_finite;
mod record;
mod sums;
mod work;

pub use moments::Moments;
pub use not_finite::NotFinite;
pub use record::Record;
pub use work::{Options, moments_of_file, moments_of_records};
