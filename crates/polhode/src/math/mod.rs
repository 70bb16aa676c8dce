//! Numbers, vectors and rotations. This room knows no physics: nothing here has a mass.

pub(crate) mod algebra;
pub(crate) mod complex;
pub(crate) mod display;
pub(crate) mod double;
pub(crate) mod eigenvalues;
pub(crate) mod elementary;
pub(crate) mod elliptic;
pub(crate) mod fine_eigen;
pub(crate) mod formula;
pub(crate) mod frame;
pub(crate) mod jet;
pub(crate) mod kepler;
pub(crate) mod landen;
pub(crate) mod lanes;
pub(crate) mod machine;
pub(crate) mod means;
pub(crate) mod number;
pub(crate) mod quaternion;
pub(crate) mod real;
pub(crate) mod root;
pub(crate) mod rotation;
pub(crate) mod spline;
pub(crate) mod sum;
pub(crate) mod symmetric3;
pub(crate) mod triple;
pub(crate) mod vector;
