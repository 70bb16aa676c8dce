<<<<<<< HEAD
//! Causes of wrong motions, planted by a program of the test's own and named.

use polhode::infer::judge::ReadMotion;
use polhode::infer::judge::{Cause, Causes, Scheme, TriedStart, Turn, Untried, causes};
use polhode::prelude::*;
=======
//! Causes of wrong motions, planted by a program of the test's own, and named; and right motions, which are not accused.
>>>>>>> cause

mod bodies;
mod equations;
mod methods;
mod program;
mod right_motions;
mod scene;
mod torques;
