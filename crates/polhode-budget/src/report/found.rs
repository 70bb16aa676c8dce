//! The search for ballast.

use crate::{Ballast, BallastAnswer, BallastError, Budget, Limit};

/// What ballast there is to be, and for what it was not sought.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub answer: BallastAnswer,
    /// Limits, and why no ballast can be sought for them.
    pub left_out: Vec<(String, &'static str)>,
}

impl Found {
    pub(crate) fn is_left_out(&self, limit: &Limit) -> bool {
        self.left_out.iter().any(|(name, _)| *name == limit.name)
    }

    pub(crate) fn new(budget: &Budget, ballast: &Ballast, limits: &[Limit]) -> Result<Self, BallastError> {
        let (mut sought, mut left_out) = (limits.to_vec(), Vec::new());
        loop {
            match budget.ballast(ballast, &sought) {
                Ok(answer) => return Ok(Self { answer, left_out }),
                Err(BallastError::Limit { limit, why }) if sought.len() > 1 => {
                    sought.retain(|other| other.name != limit);
                    left_out.push((limit, why));
                }
                Err(error) => return Err(error),
            }
        }
    }
}
