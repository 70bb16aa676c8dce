//! Search for the ballast of a configuration.

use crate::{Ballast, BallastAnswer, BallastError, Budget, Limit};

/// Result of the search for ballast, and the limits that were left out.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub answer: BallastAnswer,
    /// Names of limits that the search cannot treat, with the reason.
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
