//! Lessons that are part of the program.

/// Makes a list of the files of `lessons/` by id; the id is the name of the file.
macro_rules! lessons {
    ($($id:literal)*) => { &[$(($id, include_str!(concat!("../../lessons/", $id, ".toml")))),*] };
}

/// Ids and texts of lessons, in the recommended order.
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
