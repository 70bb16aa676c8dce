mod exact;
mod motions;
mod statistics;
