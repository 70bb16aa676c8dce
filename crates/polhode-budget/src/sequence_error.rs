//! Errors of tanks and of sequences of changes over time.

use polhode::motion::MotionError;

use crate::error::BudgetError;
use crate::errors::errors;

errors! {
    /// Error of tanks, or of a sequence of changes over time.
    SequenceError;

    /// A number is out of range.
    Value {
        /// Name of the quantity.
        what: &'static str,
        value: f64,
        /// Condition that the value has to meet.
        rule: &'static str,
    } => ("{what} is {value}, and has to be {rule}");
    /// A table of a liquid has no rows, or its number of levels differs from its number of rows.
    EmptyTable => ("a table of a liquid has no rows, or not as many levels as rows");
    /// A tank or a change refers to a row that the list does not have.
    MissingRow {
        /// Name of the item that refers to the row.
        by: String,
        /// Name of the missing row.
        row: String,
    } => ("{by} names the row \"{row}\", which is not in the list");
    /// A burn refers to a tank that does not exist.
    MissingTank {
        /// Name of the missing tank.
        tank: String,
    } => ("there is no tank \"{tank}\"");
    /// Two tanks have the same name.
    DuplicateTank {
        tank: String,
    } => ("there are two tanks \"{tank}\"");
    /// A tank would contain more than it holds, or less than nothing.
    Fill {
        tank: String,
        /// Mass that would be in the tank, kg.
        mass: f64,
        /// Mass that the tank holds, kg.
        capacity: f64,
        /// Time of the event, s.
        time: f64,
    } => ("at t = {time} s there would be {mass} kg in the tank \"{tank}\", which holds {capacity} kg"),
        hint: "check the flow out of the tank, and what is in it at the start";
    /// A tank is in a row with several copies, so the filled one is ambiguous.
    Copies {
        tank: String,
        row: String,
    } => ("the tank \"{tank}\" is in \"{row}\", of which there are several"),
        hint: "give each copy a row of its own, and a tank in it";
    /// A change removes a row that was removed before, or liquid flows from a removed tank.
    Gone {
        /// Name of the removed item.
        what: String,
        /// Time of the event, s.
        time: f64,
    } => ("at t = {time} s \"{what}\" is not there any more");
    /// Two changes of the body have the same time.
    Simultaneous {
        /// Time of the changes, s.
        time: f64,
    } => ("two changes of the body are at t = {time} s");
    /// A deployment changes the mass of the body.
    MassChanges {
        /// Time of the deployment, s.
        time: f64,
        /// Mass before, kg.
        before: f64,
        /// Mass after, kg.
        after: f64,
    } => ("at t = {time} s the body takes another form, but its mass changes from {before} kg to {after} kg"),
        hint: "what is dropped goes first, at a time of its own: then the rest can unfold";
    /// All mass of the body was removed.
    Nothing {
        /// Time of the event, s.
        time: f64,
    } => ("after t = {time} s nothing is left of the body");
    /// Error of the parts list.
    Budget(error: BudgetError) => ("{error}"), hint: error.hint();
    /// Error of the mass history of the body.
    Motion(error: MotionError) => ("{error}"), hint: error.hint();
}
