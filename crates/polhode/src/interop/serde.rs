//! Serialization with serde; values that are read pass the checks of the constructors.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::body::{InertiaTensor, MassProperties};
use crate::math::{Frame, Rotation, Vector};
use crate::motion::model::state::State;

/// Implements serialization of a type as another type: generics, type, other type, and the
/// conversions in both directions.
macro_rules! written_as {
    ([$($generics:tt)*] $type:ty, $other:ty: $to:expr, $from:expr) => {
        impl<$($generics)*> Serialize for $type {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                let to: fn(&Self) -> $other = $to;
                to(self).serialize(serializer)
            }
        }

        impl<'de, $($generics)*> Deserialize<'de> for $type {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let read = <$other>::deserialize(deserializer)?;
                $from(read).map_err(D::Error::custom)
            }
        }
    };
}

written_as!([Q, F] Vector<Q, F>, [f64; 3]: |v| v.to_array(), |v| Ok::<_, &str>(Self::from_array(v)));
written_as!([A, B] Rotation<A, B>, [f64; 4]: |r| r.quaternion(), Self::from_quaternion);
written_as!([F: Frame] InertiaTensor<F>, [[f64; 3]; 3]: |tensor| tensor.matrix(), Self::from_matrix);

/// Mass, kg; centre of mass, m; rows of the tensor about it, kg·m².
#[derive(Serialize, Deserialize)]
#[serde(rename = "MassProperties", deny_unknown_fields, bound = "")]
struct MassPropertiesFields<F: Frame> {
    mass: f64,
    center_of_mass: Vector<crate::math::quantity::Length, F>,
    inertia: InertiaTensor<F>,
}

written_as!([F: Frame] MassProperties<F>, MassPropertiesFields<F>:
    |body| MassPropertiesFields { mass: body.mass(), center_of_mass: body.center_of_mass(), inertia: *body.inertia() },
    |read: MassPropertiesFields<F>| Self::new(read.mass, read.center_of_mass, read.inertia)
);

/// Time, s; quaternion, scalar first; ω along body axes, rad/s.
#[derive(Serialize, Deserialize)]
#[serde(rename = "State", deny_unknown_fields)]
struct StateFields {
    time: f64,
    attitude: crate::math::Attitude,
    omega: crate::math::AngularVelocity<crate::math::Body>,
}

written_as!([] State, StateFields:
    |state| StateFields { time: state.time, attitude: state.attitude, omega: state.omega },
    |StateFields { time, attitude, omega }| Ok::<_, &str>(Self { time, attitude, omega })
);
