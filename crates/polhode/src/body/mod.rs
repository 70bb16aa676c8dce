//! Bodies: how much mass, where, and how it resists being turned. This room knows no time.

pub(crate) mod assembly;
pub(crate) mod density;
pub(crate) mod error;
pub(crate) mod finding;
pub(crate) mod form;
pub(crate) mod inertia;
pub(crate) mod mass_properties;
pub(crate) mod material;
pub(crate) mod mesh;
pub(crate) mod particles;
pub(crate) mod principal;
pub(crate) mod shape;
pub(crate) mod solid;
