//! Frames: the axes in which components are written, as types.
//!
//! A frame has no value at run time. It exists so that `v_space + v_body` does not compile.

/// A set of axes. Implemented by [`Space`], [`Body`], [`Principal`], [`Part`] and [`Orbital`], and by nothing else.
pub trait Frame:
    sealed::Sealed + Copy + Clone + PartialEq + core::fmt::Debug + Send + Sync + 'static
{
    /// The frame's name as tables and messages print it.
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
    /// Inertial axes.
    Space = "space";
    /// Axes fixed in the body, as the user gave them.
    Body = "body";
    /// Axes fixed in the body along its principal axes, i1 ≤ i2 ≤ i3, right-handed.
    ///
    /// At the centre of mass; for a motion about a fixed pivot, at the pivot.
    Principal = "principal";
    /// Axes in which one part of an assembly is described, before it is placed in the body.
    Part = "part";
    /// Local vertical, local horizontal (LVLH): z towards the centre of the orbit (nadir), y against the orbit's normal, x the way that
    /// the body moves, as far as that is across z.
    Orbital = "orbit";
}
