//! Keys of the columns of a parts list.

use polhode_source::unit::Dimension;

/// Key of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Key {
    pub name: &'static str,
    pub holds: Holds,
}

/// Content of the cells of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Holds {
    Text,
    /// Exact numbers without errors.
    Number(Dimension),
    /// Numbers that may have errors, in the cell or in a separate column.
    Measured(Dimension),
    /// Errors without the numbers.
    Errors(Dimension),
    /// One or more numbers of one dimension, for sizes of a shape.
    Sizes(Dimension),
    /// Remarks for people, which are not read.
    Remark,
}

/// Defines the indices of keys and the names of their columns.
macro_rules! keys {
    ($($key:ident: $name:literal, $holds:expr;)*) => {
        #[derive(Clone, Copy)]
        #[allow(clippy::upper_case_acronyms, non_camel_case_types, reason = "it only counts")]
        enum Number { $($key,)* }

        /// All keys, by their indices.
        pub(crate) const KEYS: &[Key] = &[$(Key { name: $name, holds: $holds },)*];

        $(#[allow(dead_code, reason = "some are found by their names alone")]
        pub(crate) const $key: usize = Number::$key as usize;)*
    };
}

use Holds::{Errors, Measured, Number as Exact, Remark, Sizes, Text};

keys! {
    NAME: "name", Text;
    PATH: "path", Text;
    PARENT: "parent", Text;
    QUANTITY: "quantity", Exact(Dimension::NONE);
    COPIES: "copies", Text;
    CONFIGURATION: "configuration", Text;
    GROUP: "group", Text;
    MATURITY: "maturity", Text;
    GROWTH: "growth", Exact(Dimension::NONE);
    SUBTOTAL: "subtotal", Measured(Dimension::MASS);
    ALLOWABLE: "allowable", Exact(Dimension::MASS);
    MASS: "mass", Measured(Dimension::MASS);
    X: "x", Measured(Dimension::LENGTH);
    Y: "y", Measured(Dimension::LENGTH);
    Z: "z", Measured(Dimension::LENGTH);
    IXX: "ixx", Measured(Dimension::INERTIA);
    IYY: "iyy", Measured(Dimension::INERTIA);
    IZZ: "izz", Measured(Dimension::INERTIA);
    IXY: "ixy", Measured(Dimension::INERTIA);
    IXZ: "ixz", Measured(Dimension::INERTIA);
    IYZ: "iyz", Measured(Dimension::INERTIA);
    ABOUT: "about", Text;
    PRODUCTS: "products", Text;
    AT_X: "at x", Measured(Dimension::LENGTH);
    AT_Y: "at y", Measured(Dimension::LENGTH);
    AT_Z: "at z", Measured(Dimension::LENGTH);
    ROTATE: "rotate", Text;
    ROLL: "roll", Exact(Dimension::ANGLE);
    PITCH: "pitch", Exact(Dimension::ANGLE);
    YAW: "yaw", Exact(Dimension::ANGLE);
    QW: "qw", Exact(Dimension::NONE);
    QX: "qx", Exact(Dimension::NONE);
    QY: "qy", Exact(Dimension::NONE);
    QZ: "qz", Exact(Dimension::NONE);
    TURN_X: "rotate x", Errors(Dimension::ANGLE);
    TURN_Y: "rotate y", Errors(Dimension::ANGLE);
    TURN_Z: "rotate z", Errors(Dimension::ANGLE);
    SHAPE: "shape", Text;
    SIZE: "size", Sizes(Dimension::LENGTH);
    RADIUS: "radius", Sizes(Dimension::LENGTH);
    INNER_RADIUS: "inner radius", Sizes(Dimension::LENGTH);
    SEMI_AXES: "semi axes", Sizes(Dimension::LENGTH);
    LENGTH: "length", Sizes(Dimension::LENGTH);
    HEIGHT: "height", Sizes(Dimension::LENGTH);
    TOP_RADIUS: "top radius", Sizes(Dimension::LENGTH);
    RING_RADIUS: "ring radius", Sizes(Dimension::LENGTH);
    TUBE_RADIUS: "tube radius", Sizes(Dimension::LENGTH);
    VERTICES: "vertices", Sizes(Dimension::LENGTH);
    ENDS: "ends", Text;
    THICKNESS: "thickness", Sizes(Dimension::LENGTH);
    DENSITY: "density", Measured(Dimension::DENSITY);
    MATERIAL: "material", Text;
    MESH: "mesh", Text;
    UNIT: "unit", Text;
    WELD: "weld", Sizes(Dimension::LENGTH);
    FILL: "fill", Sizes(Dimension::LENGTH);
    UNION: "union", Text;
    CAD: "cad", Text;
    SCENARIO: "scenario", Text;
    FILE: "file", Text;
    NOTE: "note", Remark;
    NOTES: "notes", Remark;
    COMMENT: "comment", Remark;
    SUPPLIER: "supplier", Remark;
    PART_NUMBER: "part number", Remark;
}

/// Number of keys.
pub(crate) const COUNT: usize = KEYS.len();

/// Columns of the sizes of shapes: lengths and numbers.
pub(crate) const SIZES: [usize; 11] = [
    SIZE,
    RADIUS,
    INNER_RADIUS,
    SEMI_AXES,
    LENGTH,
    HEIGHT,
    TOP_RADIUS,
    RING_RADIUS,
    TUBE_RADIUS,
    VERTICES,
    THICKNESS,
];

impl Holds {
    /// Returns the dimension of the numbers; `None` for texts.
    pub(crate) const fn dimension(self) -> Option<Dimension> {
        match self {
            Exact(dimension) | Measured(dimension) | Errors(dimension) | Sizes(dimension) => Some(dimension),
            Text | Remark => None,
        }
    }

    /// Returns true if a column of errors is allowed.
    pub(crate) const fn may_err(self) -> bool {
        matches!(self, Measured(_) | Errors(_))
    }
}
