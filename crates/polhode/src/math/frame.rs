//! Frames: the axes of components, as types.
//!
//! A frame has no value at run time. Its purpose is that `v_space + v_body` does not compile.

/// Set of axes. Only [`Space`], [`Body`], [`Principal`], [`Part`] and [`Orbital`] implement it.
pub trait Frame:
    sealed::Sealed + Copy + Clone + PartialEq + core::fmt::Debug + Send + Sync + 'static
{
    /// Name of the frame in tables and messages.
    const NAME: &'static str;
}

mod sealed {
    #[expect(unnameable_types, reason = "that is what closes the set of frames")]
    pub trait Sealed {}
}

macro_rules! frames {
    ($($(#[$doc:meta])* $name:ident = $text:literal;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub struct $name;
        impl sealed::Sealed for $name {}
        impl Frame for $name {
            const NAME: &'static str = $text;
        }
    )*};
}

frames! {
    /// Inertial (space-fixed) axes.
    Space = "space";
    /// Axes fixed in the body, as defined by the user.
    Body = "body";
    /// Axes fixed in the body along its principal axes, i1 ≤ i2 ≤ i3, right-handed.
    ///
    /// The origin is the centre of mass, or the pivot for motion about a fixed pivot.
    Principal = "principal";
    /// Axes of one part of an assembly, before it is placed in the body.
    Part = "part";
    /// Local vertical, local horizontal (LVLH): z toward the centre of the orbit (nadir), y
    /// opposite to the orbit normal, x in the direction of motion, perpendicular to z.
    Orbital = "orbit";
}
