mod axes;
mod behaviour;
mod exact;
mod motions;
mod next;
mod statistics;
