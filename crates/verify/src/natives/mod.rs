//! Built-in predicates and measures: those that need geometry, one file each.
//!
//! A new one is a file that implements [`Predicate`] or [`Measuring`], and a line in the table below. Its value is
//! measured on plain floats; [`Number::measured`] takes beside it what moves as the value does, where that is known.

mod clear;
mod collides;
mod connects;
mod inside;
mod reachable;
mod visible;

pub use collides::gap;
pub(crate) use collides::in_words as gap_in_words;
pub(crate) use inside::in_box;
pub use inside::in_region;

use crate::eval::{Cause, EvalError, Truth, Value};
use crate::number::Number;
use crate::vector::V3;
use crate::world::{Room, Thing, World};
use scenelang_lang::program::{Arg, Measure, Native, NodeId, ObjectId, Program, RegionId, Side};

/// A use of a built-in: its arguments, evaluated, and the instance it speaks of.
#[derive(Clone, Copy)]
pub(crate) struct Call<'a, N: Number> {
    /// The arguments.
    pub args: &'a [Arg],
    /// What the nodes before it have yielded.
    pub values: &'a [Result<Value<N>, EvalError>],
    /// The instance.
    pub world: &'a World<N>,
    /// Its own node.
    pub node: NodeId,
}

impl<'a, N: Number> Call<'a, N> {
    fn fail(&self, cause: Cause) -> EvalError {
        EvalError { cause, node: self.node }
    }
    #[track_caller]
    fn ill_typed(&self) -> ! {
        unreachable!("a built-in with arguments of the wrong types: {:?}", self.args)
    }
    /// The object at an index.
    fn object(&self, index: usize) -> Result<(ObjectId, &'a Thing<N>), EvalError> {
        match self.args.get(index) {
            Some(Arg::Object(id)) => Ok((*id, self.world.object(*id).map_err(|c| self.fail(c))?)),
            _ => self.ill_typed(),
        }
    }
    /// The region at an index.
    fn region(&self, index: usize) -> Result<(RegionId, &'a Room<N>), EvalError> {
        match self.args.get(index) {
            Some(Arg::Region(id)) => Ok((*id, self.world.region(*id).map_err(|c| self.fail(c))?)),
            _ => self.ill_typed(),
        }
    }
    fn value(&self, index: usize) -> Result<Value<N>, EvalError> {
        match self.args.get(index) {
            Some(Arg::Value(node)) => self.values[node.0 as usize],
            _ => self.ill_typed(),
        }
    }
    /// The number at an index.
    fn number(&self, index: usize) -> Result<N, EvalError> {
        match self.value(index)? {
            Value::Number(n) => Ok(n),
            _ => self.ill_typed(),
        }
    }
    /// The vector at an index.
    fn vector(&self, index: usize) -> Result<V3<N>, EvalError> {
        match self.value(index)? {
            Value::Vector(v) => Ok(v),
            _ => self.ill_typed(),
        }
    }
    /// The side at an index.
    fn side(&self, index: usize) -> Side {
        match self.args.get(index) {
            Some(Arg::Side(side)) => *side,
            _ => self.ill_typed(),
        }
    }
}

/// A built-in predicate.
pub(crate) trait Predicate {
    /// Whether it holds, and by how much.
    fn truth<N: Number>(call: &Call<'_, N>) -> Result<Truth<N>, EvalError>;
    /// What was measured, as a clause of a sentence; `None` where the margin says it all.
    fn explain(_call: &Call<'_, f64>, _names: &Program) -> Option<String> {
        None
    }
    /// What was measured, and what it may be at worst (metres).
    fn measured(call: &Call<'_, f64>) -> Option<(f64, f64)> {
        let contact = call.world.options.tolerances.contact;
        let margin = Self::truth(call).ok()?.margin;
        margin.is_finite().then_some((margin - contact, -contact))
    }
    /// Objects, beside its arguments, that decide.
    fn in_the_way(_call: &Call<'_, f64>) -> Vec<ObjectId> {
        Vec::new()
    }
}

/// A built-in measure: a number in metres.
pub(crate) trait Measuring {
    /// The number.
    fn measure<N: Number>(call: &Call<'_, N>) -> Result<N, EvalError>;
}

macro_rules! table {
    ($($native:ident $file:ident::$predicate:ident)*; $($measure:ident $of:ident::$measuring:ident)*) => {
        /// The truth of a predicate.
        pub(crate) fn truth<N: Number>(native: Native, call: &Call<'_, N>) -> Result<Truth<N>, EvalError> {
            match native {
                $(Native::$native => $file::$predicate::truth(call),)*
            }
        }
        /// What a predicate measured.
        pub(crate) fn explain(native: Native, call: &Call<'_, f64>, names: &Program) -> Option<String> {
            match native {
                $(Native::$native => $file::$predicate::explain(call, names),)*
            }
        }
        /// What a predicate measured, and what that may be at worst (metres).
        pub(crate) fn measured(native: Native, call: &Call<'_, f64>) -> Option<(f64, f64)> {
            match native {
                $(Native::$native => $file::$predicate::measured(call),)*
            }
        }
        /// Objects, beside the arguments of a predicate, that decide.
        pub(crate) fn in_the_way(native: Native, call: &Call<'_, f64>) -> Vec<ObjectId> {
            match native {
                $(Native::$native => $file::$predicate::in_the_way(call),)*
            }
        }
        /// The value of a measure.
        pub(crate) fn measure<N: Number>(measure: Measure, call: &Call<'_, N>) -> Result<N, EvalError> {
            match measure {
                $(Measure::$measure => $of::$measuring::measure(call),)*
            }
        }
    };
}

table! {
    Inside inside::Inside
    Collides collides::Collides
    Connects connects::Connects
    Reachable reachable::Reachable
    Visible visible::Visible
    Clear clear::Clear;
    Gap collides::Gap
    WalkDistance reachable::WalkDistance
}

/// Distance in words: two digits for what is seen, more for what is not.
pub(crate) fn metres(x: f64) -> String {
    if x.abs() < 0.01 && x != 0.0 { format!("{:.4} m", x) } else { format!("{x:.2} m") }
}
