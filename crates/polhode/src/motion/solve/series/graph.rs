//! Right-hand sides as graphs: an autonomous system ẏ = f(y) of sums, products, quotients and
//! square roots.
//!
//! A function that is generic over [`Field`] records its operations when it is called with
//! [`Node`]s. Equal values are recorded once, and constants are folded. Sums and products are
//! combined into a few bilinear forms, Σ fₖ aₖ + Σ gₖ aₖ bₖ + c.

use core::cell::RefCell;
use core::ops::{Add, Div, Mul, Neg, Sub};
use std::collections::BTreeMap;

use crate::math::algebra::Field;

/// Operation that computes a value from previous values, which are given by index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Operation {
    /// One of the variables y, by index.
    Variable(usize),
    Add(usize, usize),
    Multiply(usize, usize),
    /// Product with a constant, given by its bits.
    Scale(usize, u64),
    /// Sum with a constant, given by its bits.
    Shift(usize, u64),
    Divide(usize, usize),
    Invert(usize),
    Root(usize),
}

impl Operation {
    fn operands(&self) -> Vec<usize> {
        match *self {
            Self::Variable(_) => Vec::new(),
            Self::Add(a, b) | Self::Multiply(a, b) | Self::Divide(a, b) => vec![a, b],
            Self::Scale(a, _) | Self::Shift(a, _) | Self::Invert(a) | Self::Root(a) => vec![a],
        }
    }
}

/// Operations recorded so far.
#[derive(Debug, Default)]
pub(super) struct Recording {
    operations: Vec<Operation>,
    places: BTreeMap<Operation, usize>,
}

impl Recording {
    fn place(&mut self, operation: Operation) -> usize {
        let next = self.operations.len();
        let place = *self.places.entry(operation).or_insert(next);
        if place == next {
            self.operations.push(operation);
        }
        place
    }
}

/// Value of a graph, or a constant.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct Node<'g> {
    recording: &'g RefCell<Recording>,
    value: Value,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Value {
    Constant(f64),
    At(usize),
}

impl Node<'_> {
    fn with(self, value: Value) -> Self {
        Self { value, ..self }
    }

    fn make(self, operation: Operation) -> Self {
        let place = self.recording.borrow_mut().place(operation);
        self.with(Value::At(place))
    }

    fn shifted(self, by: f64) -> Self {
        match self.value {
            Value::Constant(a) => self.with(Value::Constant(a + by)),
            Value::At(_) if by == 0.0 => self,
            Value::At(a) => self.make(Operation::Shift(a, by.to_bits())),
        }
    }

    fn inverse(self) -> Self {
        match self.value {
            Value::Constant(a) => self.with(Value::Constant(1.0 / a)),
            Value::At(a) => self.make(Operation::Invert(a)),
        }
    }
}

impl Field for Node<'_> {
    fn times(self, constant: f64) -> Self {
        match self.value {
            Value::Constant(a) => self.with(Value::Constant(a * constant)),
            Value::At(_) if constant == 0.0 => self.with(Value::Constant(0.0)),
            Value::At(_) if constant == 1.0 => self,
            Value::At(a) => self.make(Operation::Scale(a, constant.to_bits())),
        }
    }

    fn root(self) -> Self {
        match self.value {
            Value::Constant(a) => self.with(Value::Constant(a.sqrt())),
            Value::At(a) => self.make(Operation::Root(a)),
        }
    }
}

impl Neg for Node<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        self.times(-1.0)
    }
}

impl Add for Node<'_> {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        match (self.value, b.value) {
            (_, Value::Constant(by)) => self.shifted(by),
            (Value::Constant(by), _) => b.shifted(by),
            (Value::At(a), Value::At(b)) => self.make(Operation::Add(a.min(b), a.max(b))),
        }
    }
}

impl Sub for Node<'_> {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl Mul for Node<'_> {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        match (self.value, b.value) {
            (_, Value::Constant(by)) => self.times(by),
            (Value::Constant(by), _) => b.times(by),
            (Value::At(a), Value::At(b)) => self.make(Operation::Multiply(a.min(b), a.max(b))),
        }
    }
}

impl Div for Node<'_> {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        match (self.value, b.value) {
            (_, Value::Constant(by)) => self.times(1.0 / by),
            (Value::Constant(by), _) => b.inverse().times(by),
            (Value::At(a), Value::At(b)) => self.make(Operation::Divide(a, b)),
        }
    }
}

/// Bilinear form Σ fₖ aₖ + Σ gₖ aₖ bₖ + c. The values are given by their indices.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Form {
    pub(super) constant: f64,
    pub(super) terms: Vec<(usize, f64)>,
    /// Products, grouped by common factor.
    pub(super) products: Vec<(f64, Vec<[usize; 2]>)>,
}

impl Form {
    fn of(place: usize) -> Self {
        Self { terms: vec![(place, 1.0)], ..Self::default() }
    }

    /// Adds a product of two values times a factor.
    fn multiply(&mut self, pair: [usize; 2], factor: f64) {
        match self.products.iter_mut().find(|(known, _)| *known == factor) {
            Some((_, pairs)) => pairs.push(pair),
            None => self.products.push((factor, vec![pair])),
        }
    }

    /// Adds a multiple of another form.
    fn add(&mut self, other: &Self, factor: f64) {
        self.constant += factor * other.constant;
        self.terms.extend(other.terms.iter().map(|&(a, f)| (a, f * factor)));
        for (own, pairs) in &other.products {
            for pair in pairs {
                self.multiply(*pair, own * factor);
            }
        }
    }
}

/// Value that has its own Taylor series.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Step {
    Variable(usize),
    Form(Form),
    Divide(usize, usize),
    Invert(usize),
    Root(usize),
}

/// Autonomous system ẏ = f(y), with further functions of y.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::motion) struct System {
    /// Steps in an order such that each one follows its operands.
    pub(super) steps: Vec<Step>,
    /// Rates of the variables.
    pub(super) rates: Vec<Form>,
    /// Further functions of the variables.
    pub(super) outputs: Vec<Form>,
}

impl System {
    /// Records the rates of `count` variables, and further functions of them. `record` receives the
    /// constant 1 and the variables.
    pub(in crate::motion) fn record(
        count: usize,
        record: impl for<'g> FnOnce(Node<'g>, &[Node<'g>]) -> [Vec<Node<'g>>; 2],
    ) -> Self {
        let recording = RefCell::new(Recording::default());
        let one = Node { recording: &recording, value: Value::Constant(1.0) };
        let variables: Vec<_> = (0..count).map(|k| one.make(Operation::Variable(k))).collect();
        let roots = record(one, &variables).map(|nodes| nodes.iter().map(|node| node.value).collect());
        Compiler::of(&recording.into_inner().operations, &roots).system(roots)
    }
}

/// Compiler from operations to steps. Forms that are used once are merged into the forms that use
/// them.
struct Compiler<'o> {
    operations: &'o [Operation],
    uses: Vec<usize>,
    /// Form of each operation that has been compiled.
    forms: Vec<Option<Form>>,
    steps: Vec<Step>,
}

impl<'o> Compiler<'o> {
    fn of(operations: &'o [Operation], roots: &[Vec<Value>; 2]) -> Self {
        let mut uses = vec![0; operations.len()];
        let mut count = |place: usize| {
            if let Some(uses) = uses.get_mut(place) {
                *uses += 1;
                return *uses == 1;
            }
            false
        };
        let mut open: Vec<usize> = Vec::new();
        for value in roots.iter().flatten() {
            if let Value::At(place) = *value
                && count(place)
            {
                open.push(place);
            }
        }
        while let Some(place) = open.pop() {
            for of in operations.get(place).map_or_else(Vec::new, Operation::operands) {
                if count(of) {
                    open.push(of);
                }
            }
        }
        Self { operations, uses, forms: vec![None; operations.len()], steps: Vec::new() }
    }

    fn system(mut self, [rates, outputs]: [Vec<Value>; 2]) -> System {
        for (place, &operation) in self.operations.iter().enumerate() {
            if self.uses[place] == 0 {
                continue;
            }
            let step = match operation {
                Operation::Variable(k) => Step::Variable(k),
                Operation::Divide(a, b) => Step::Divide(self.step_of(a), self.step_of(b)),
                Operation::Invert(a) => Step::Invert(self.step_of(a)),
                Operation::Root(a) => Step::Root(self.step_of(a)),
                _ => {
                    let form = self.form(operation);
                    // Merge a sum into the forms that use it, unless products would then be
                    // computed twice.
                    if self.uses[place] == 1 || form.products.is_empty() && form.terms.len() <= 1 {
                        self.forms[place] = Some(form);
                        continue;
                    }
                    Step::Form(form)
                }
            };
            let next = self.push(step);
            self.forms[place] = Some(Form::of(next));
        }
        let mut finish = |values: Vec<Value>| values.into_iter().map(|value| self.of_value(value)).collect();
        let (rates, outputs) = (finish(rates), finish(outputs));
        System { steps: self.steps, rates, outputs }
    }

    fn push(&mut self, step: Step) -> usize {
        self.steps.push(step);
        self.steps.len() - 1
    }

    fn of_value(&mut self, value: Value) -> Form {
        match value {
            Value::Constant(constant) => Form { constant, ..Form::default() },
            Value::At(place) => self.forms[place].clone().unwrap_or_default(),
        }
    }

    /// Returns an operation as a multiple of a series: index of the series, and factor.
    fn multiple_of(&mut self, place: usize) -> (usize, f64) {
        let form = self.forms[place].clone().unwrap_or_default();
        if let ([single], true) = (&form.terms[..], form.products.is_empty() && form.constant == 0.0) {
            return *single;
        }
        let next = self.push(Step::Form(form));
        self.forms[place] = Some(Form::of(next));
        (next, 1.0)
    }

    /// Returns the index of a series that equals this operation.
    fn step_of(&mut self, place: usize) -> usize {
        let (own, factor) = self.multiple_of(place);
        if factor == 1.0 {
            return own;
        }
        let next = self.push(Step::Form(Form { terms: vec![(own, factor)], ..Form::default() }));
        self.forms[place] = Some(Form::of(next));
        next
    }

    fn form(&mut self, operation: Operation) -> Form {
        let mut form = Form::default();
        match operation {
            Operation::Add(a, b) => {
                for part in [a, b] {
                    form.add(&self.forms[part].clone().unwrap_or_default(), 1.0);
                }
            }
            Operation::Scale(a, by) => {
                form.add(&self.forms[a].clone().unwrap_or_default(), f64::from_bits(by));
            }
            Operation::Shift(a, by) => {
                form.add(&self.forms[a].clone().unwrap_or_default(), 1.0);
                form.constant += f64::from_bits(by);
            }
            Operation::Multiply(a, b) => {
                // the factors of multiples are moved in front of the product
                let ((a, f), (b, g)) = (self.multiple_of(a), self.multiple_of(b));
                form.multiply([a, b], f * g);
            }
            _ => {}
        }
        form
    }
}
