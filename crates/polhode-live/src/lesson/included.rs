//! The lessons that are part of the program.

/// A lesson of `lessons/` by its id, which is the file's name.
macro_rules! lessons {
    ($($id:literal)*) => { &[$(($id, include_str!(concat!("../../lessons/", $id, ".toml")))),*] };
}

/// Id and text, in the order in which they can be taken.
pub(super) const INCLUDED: &[(&str, &str)] = lessons! {
    "cube"
    "parallel-axes"
    "pendulum"
    "dumbbell"
    "cones"
    "racket"
    "bicycle-wheel"
    "sleeping-top"
    "sliding-ball"
    "euler-disk"
    "tippe-top"
    "spinning-egg"
    "rattleback"
    "flat-spin"
    "dual-spin"
    "gravity-gradient"
    "chandler"
    "water"
    "tumbling"
    "hyperion"
};
