//! State that all requests of a page share.

use polhode_web::Engine;

use crate::dropped::Dropped;
use crate::guard::Guard;
use crate::turns::Turns;

/// State that all requests of a page share.
#[derive(Debug)]
pub(crate) struct Session {
    pub(crate) guard: Guard,
    pub(crate) engine: Engine,
    pub(crate) dropped: Dropped,
    pub(crate) turns: Turns,
}
