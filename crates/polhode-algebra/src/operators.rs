//! Operators `+`, `−` and `·` of exact values, from their methods on references.

/// Implements the operators of a type with the methods `plus`, `times` and `negated`, for values
/// and references.
macro_rules! operators {
    ($type:ty) => {
        operators!($type, Add, add, |a: &$type, b: &$type| a.plus(b));
        operators!($type, Sub, sub, |a: &$type, b: &$type| a.plus(&b.negated()));
        operators!($type, Mul, mul, |a: &$type, b: &$type| a.times(b));
        operators!($type, negative);
    };
    ($type:ty, negative) => {
        impl core::ops::Neg for &$type {
            type Output = $type;
            fn neg(self) -> $type {
                self.negated()
            }
        }
        impl core::ops::Neg for $type {
            type Output = $type;
            fn neg(self) -> $type {
                self.negated()
            }
        }
    };
    ($type:ty, $operator:ident, $method:ident, $result:expr) => {
        impl core::ops::$operator<&$type> for &$type {
            type Output = $type;
            fn $method(self, other: &$type) -> $type {
                $result(self, other)
            }
        }
        impl core::ops::$operator<&$type> for $type {
            type Output = $type;
            fn $method(self, other: &$type) -> $type {
                $result(&self, other)
            }
        }
        impl core::ops::$operator<$type> for &$type {
            type Output = $type;
            fn $method(self, other: $type) -> $type {
                $result(self, &other)
            }
        }
        impl core::ops::$operator<$type> for $type {
            type Output = $type;
            fn $method(self, other: $type) -> $type {
                $result(&self, &other)
            }
        }
    };
}

pub(crate) use operators;
