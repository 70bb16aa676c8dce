//! Conversions to types of other crates, each behind a feature.
//!
//! | feature | vector | rotation | inertia tensor |
//! |---|---|---|---|
//! | `mint` | `mint::Vector3<f64>` | `mint::Quaternion<f64>` | `mint::RowMatrix3<f64>` |
//! | `nalgebra` | `nalgebra::Vector3<f64>` | `nalgebra::UnitQuaternion<f64>` | `nalgebra::Matrix3<f64>` |
//! | `glam` | `glam::DVec3` | `glam::DQuat` | `glam::DMat3` |
//! | `serde` | `[x, y, z]` | `[w, x, y, z]` | rows `[[xx, xy, xz], …]` |
//!
//! `From` is implemented where the conversion cannot fail. `TryFrom` is implemented where numbers
//! become a [`Rotation`](crate::math::Rotation) or an
//! [`InertiaTensor`](crate::body::InertiaTensor), with the checks of their constructors. Other
//! crates have neither frames nor quantities; the target type of the conversion determines them.
//!
#![cfg_attr(
    feature = "nalgebra",
    doc = r#"
```
use polhode::math::{AngularVelocity, Attitude, Body};
let spin: AngularVelocity<Body> = nalgebra::Vector3::new(0.1, 0.2, 0.3).into();
let attitude = Attitude::try_from(nalgebra::UnitQuaternion::identity())?;
let matrix: nalgebra::Vector3<f64> = (attitude * spin).into();
assert_eq!(matrix.z, 0.3);
# Ok::<(), polhode::math::RotationError>(())
```"#
)]

#[cfg(any(feature = "mint", feature = "nalgebra", feature = "glam"))]
mod linear_algebra;
#[cfg(feature = "serde")]
mod serde;
