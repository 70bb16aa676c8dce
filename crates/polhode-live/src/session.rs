//! State that all requests of a page share.

use crate::documents::Documents;
use crate::dropped::Dropped;
use crate::guard::Guard;
use crate::lesson::Lessons;
use crate::turns::Turns;

/// State that all requests of a page share.
#[derive(Debug)]
pub(crate) struct Session {
    pub(crate) guard: Guard,
    pub(crate) documents: Documents,
    pub(crate) lessons: Lessons,
    pub(crate) dropped: Dropped,
    pub(crate) turns: Turns,
}
