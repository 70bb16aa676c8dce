//! Exercises with generic numbers, their solutions, and marks for answers.
