//! What can be wrong with tanks and with what happens to a body over time.

use polhode::motion::MotionError;

use crate::error::BudgetError;
use crate::errors::errors;

errors! {
    /// Error of tanks, or of what is to happen over time.
    SequenceError;

    /// A number that cannot be.
    Value {
        /// What it is.
        what: &'static str,
        /// As it was given.
        value: f64,
        /// What it has to be.
        rule: &'static str,
    } => ("{what} is {value}, and has to be {rule}");
    /// A table of a liquid without rows, or with another number of levels.
    EmptyTable => ("a table of a liquid has no rows, or not as many levels as rows");
    /// A row that the list does not have.
    MissingRow {
        /// Where it is named.
        by: String,
        /// What is named.
        row: String,
    } => ("{by} names the row \"{row}\", which is not in the list");
    /// A tank that there is not.
    MissingTank {
        /// What is named.
        tank: String,
    } => ("there is no tank \"{tank}\"");
    /// Two tanks of one name.
    DuplicateTank {
        /// The name.
        tank: String,
    } => ("there are two tanks \"{tank}\"");
    /// More in a tank than it holds, or less than nothing.
    Fill {
        /// The tank.
        tank: String,
        /// What would be in it, kg.
        mass: f64,
        /// What it holds, kg.
        capacity: f64,
        /// When, s.
        time: f64,
    } => ("at t = {time} s there would be {mass} kg in the tank \"{tank}\", which holds {capacity} kg"),
        hint: "check the flow out of the tank, and what is in it at the start";
    /// A tank in a row of which there are several: which of them is filled is not known.
    Copies {
        /// The tank.
        tank: String,
        /// The row.
        row: String,
    } => ("the tank \"{tank}\" is in \"{row}\", of which there are several"),
        hint: "give each copy a row of its own, and a tank in it";
    /// Something that happens to what has gone already, or a tank without the row that it stands in.
    Gone {
        /// What has gone.
        what: String,
        /// When, s.
        time: f64,
    } => ("at t = {time} s \"{what}\" is not there any more");
    /// Two changes of the body at one time.
    Simultaneous {
        /// When, s.
        time: f64,
    } => ("two changes of the body are at t = {time} s");
    /// A deployment that changes the mass.
    MassChanges {
        /// When, s.
        time: f64,
        /// Before, kg.
        before: f64,
        /// After, kg.
        after: f64,
    } => ("at t = {time} s the body takes another form, but its mass changes from {before} kg to {after} kg"),
        hint: "what is dropped goes first, at a time of its own: then the rest can unfold";
    /// Everything has gone.
    Nothing {
        /// When, s.
        time: f64,
    } => ("after t = {time} s nothing is left of the body");
    /// What is wrong with the parts list.
    Budget(error: BudgetError) => ("{error}"), hint: error.hint();
    /// What the motion of the body cannot take.
    Motion(error: MotionError) => ("{error}"), hint: error.hint();
}
