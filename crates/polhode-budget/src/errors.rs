//! Error enums whose variants define their message and hint.

/// Defines an error enum. A variant has the form
/// `Variant { fields } => ("message", arguments), hint: "advice";`.
///
/// A variant `Variant(error: Type)` wraps another error. It gets a `From<Type>`, so that `?`
/// converts that error.
macro_rules! errors {
    (
        $(#[$meta:meta])*
        $Name:ident;
        $(
            $(#[$of_variant:meta])*
            $Variant:ident
            $({ $($(#[$of_field:meta])* $field:ident: $Field:ty,)+ })?
            $(($inner:ident: $Inner:ty))?
            => ($($message:tt)+) $(, hint: $hint:expr)?;
        )+
    ) => {
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum $Name {
            $($(#[$of_variant])* $Variant $({ $($(#[$of_field])* $field: $Field,)+ })? $(($Inner))?,)+
        }

        impl $Name {
            /// Returns advice on how to correct the input, if there is any.
            #[allow(unused_variables, reason = "hints need few fields")]
            pub fn hint(&self) -> Option<&'static str> {
                match self {
                    $(Self::$Variant $({ $($field),+ })? $(($inner))? => None $(.or($hint.into()))?,)+
                }
            }
        }

        impl core::fmt::Display for $Name {
            #[allow(unused_variables, reason = "not every message has all fields")]
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                match self {
                    $(Self::$Variant $({ $($field),+ })? $(($inner))? => write!(f, $($message)+),)+
                }
            }
        }

        impl core::error::Error for $Name {}

        impl From<$Name> for polhode_source::Failure {
            fn from(error: $Name) -> Self {
                Self::usage(error.to_string(), error.hint().unwrap_or_default())
            }
        }

        $($(impl From<$Inner> for $Name {
            fn from(error: $Inner) -> Self {
                Self::$Variant(error)
            }
        })?)+
    };
}

pub(crate) use errors;
