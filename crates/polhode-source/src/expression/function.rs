//! Functions of formulas, by name.

use polhode::math::formula::{Binary, Instruction, Unary};

/// Function of formulas, with its name.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Function {
    pub name: &'static str,
    pub op: Instruction,
}

pub(crate) const FUNCTIONS: [Function; 24] = {
    const fn one(name: &'static str, op: Unary) -> Function {
        Function { name, op: Instruction::Unary(op) }
    }
    const fn two(name: &'static str, op: Binary) -> Function {
        Function { name, op: Instruction::Binary(op) }
    }
    [
        one("sqrt", Unary::Sqrt),
        one("exp", Unary::Exp),
        one("log", Unary::Log),
        one("sin", Unary::Sin),
        one("cos", Unary::Cos),
        one("tan", Unary::Tan),
        one("asin", Unary::Asin),
        one("acos", Unary::Acos),
        one("atan", Unary::Atan),
        one("sinh", Unary::Sinh),
        one("cosh", Unary::Cosh),
        one("tanh", Unary::Tanh),
        one("log1p", Unary::Log1p),
        one("expm1", Unary::Expm1),
        one("abs", Unary::Abs),
        one("floor", Unary::Floor),
        two("atan2", Binary::Atan2),
        two("min", Binary::Min),
        two("max", Binary::Max),
        two("hypot", Binary::Hypot),
        two("pow", Binary::Power),
        two("mod", Binary::Mod),
        Function { name: "clip", op: Instruction::Clip },
        Function { name: "if", op: Instruction::If },
    ]
};

impl Function {
    pub(crate) const fn takes(self) -> usize {
        self.op.operands()
    }
}
