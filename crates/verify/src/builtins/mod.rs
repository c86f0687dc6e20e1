//! Built-in predicates and measures: those that need geometry, one file each.
//!
//! A file says everything about its built-in: its exact value, what proofs may assume of it, fast code for it where
//! there is some, what it depends on, and the words of a message. All others ask through [`Call`] and [`declared`], and
//! know no built-in by its name. A new one is a row in the table of signatures of `scenelang_lang`, a file here that
//! implements [`Semantics`], and a line in the table below.

mod call;
mod clear;
mod collides;
mod connects;
mod declared;
mod gap;
mod inside;
mod opens;
mod passages;
mod reachable;
mod visible;
mod walk_distance;

pub(crate) use call::Call;
pub(crate) use clear::region_of as region_beside;
pub(crate) use collides::in_proofs as collides_in_proofs;
pub use declared::{Declared, Slack, Surroundings};
pub use gap::between as gap;
pub(crate) use gap::in_proofs as gap_in_proofs;
pub(crate) use gap::in_words as gap_in_words;
pub(crate) use gap::is_in_proofs as gap_is_in_proofs;
pub(crate) use inside::in_proofs as region_in_proofs;
pub use inside::in_region;
pub(crate) use passages::past as path_past_in_proofs;

use crate::coded::Boxes;
use crate::eval::{EvalError, Scratch, Truth, Value};
use crate::number::{Algebra, Number};
use crate::prove::tape::Term;
use crate::prove::unknowns::Unknowns;
use crate::world::World;
use declared::Given;
use scenelang_lang::program::{BuiltIn, Formula, Node, NodeId, ObjectId, Program};

/// What a built-in means. A predicate yields a [`Truth`], a measure a number; in nothing else do they differ.
pub(crate) trait Semantics {
    type Yields<N: Algebra>: Into<Value<N>>;
    /// What others need to know to treat it well.
    const DECLARED: Declared;

    /// What it looks at beside its arguments.
    fn surroundings(given: &Given<'_>) -> Surroundings;

    /// Its value. It is measured on plain floats; [`Number::measured`] takes beside it what moves as the value does, where
    /// that is known.
    fn exact<N: Number>(call: &Call<'_, N>) -> Result<Self::Yields<N>, EvalError>;

    /// Its value in proofs: a number or a verdict of which everything is true that is claimed. `None`: nothing is known
    /// but that the same question has the same answer.
    fn bounds(_call: &Call<'_, Term>, _facts: &mut Unknowns<'_>) -> Result<Option<Self::Yields<Term>>, EvalError> {
        Ok(None)
    }

    /// Its value as fast code on upright boxes; `None`: there is no such code.
    fn fast(_call: &Call<'_, Term>, _boxes: &mut Boxes<'_, '_>) -> Result<Option<Self::Yields<Term>>, EvalError> {
        Ok(None)
    }

    /// What was measured: of a predicate a clause of a sentence ("`a` is 0.20 m from `b`"), of a measure a noun ("the gap
    /// between `a` and `b`"). `None` where margin and formula say it all.
    fn words(call: &Call<'_, f64>, names: &Program) -> Option<String>;

    /// What a predicate measured, and what that may be at worst (metres).
    fn measured(call: &Call<'_, f64>) -> Option<(f64, f64)> {
        let slack = Self::DECLARED.wanted.map_or(0.0, |slack| slack(&call.world.options.tolerances));
        match Self::exact(call).ok()?.into() {
            Value::Truth(Truth { margin, .. }) if margin.is_finite() => Some((margin - slack, -slack)),
            _ => None,
        }
    }

    /// Objects, beside its arguments, that decide.
    fn in_the_way(_call: &Call<'_, f64>) -> Vec<ObjectId> {
        Vec::new()
    }
}

macro_rules! table {
    ($($variant:ident => $file:ident::$type:ident,)*) => {
        /// What a built-in declares about itself.
        pub fn declared(built_in: BuiltIn) -> &'static Declared {
            match built_in {
                $(BuiltIn::$variant => const { &<$file::$type as Semantics>::DECLARED },)*
            }
        }

        fn looks_at(built_in: BuiltIn, given: &Given<'_>) -> Surroundings {
            match built_in {
                $(BuiltIn::$variant => $file::$type::surroundings(given),)*
            }
        }

        impl<N: Number> Call<'_, N> {
            pub(crate) fn exact(&self) -> Result<Value<N>, EvalError> {
                match self.built_in {
                    $(BuiltIn::$variant => $file::$type::exact(self).map(Into::into),)*
                }
            }
        }

        impl Call<'_, Term> {
            /// What proofs may assume.
            pub(crate) fn bounds(&self, facts: &mut Unknowns<'_>) -> Result<Value<Term>, EvalError> {
                let known = match self.built_in {
                    $(BuiltIn::$variant => $file::$type::bounds(self, facts)?.map(Into::into),)*
                };
                known.map_or_else(|| facts.of_unknown(self), Ok)
            }
            /// Fast code on upright boxes.
            pub(crate) fn fast(&self, boxes: &mut Boxes<'_, '_>) -> Result<Option<Value<Term>>, EvalError> {
                Ok(match self.built_in {
                    $(BuiltIn::$variant => $file::$type::fast(self, boxes)?.map(Into::into),)*
                })
            }
        }

        impl Call<'_, f64> {
            /// What was measured, in words.
            pub(crate) fn words(&self, names: &Program) -> Option<String> {
                match self.built_in {
                    $(BuiltIn::$variant => $file::$type::words(self, names),)*
                }
            }
            /// What a predicate measured, and what that may be at worst (metres).
            pub(crate) fn measured(&self) -> Option<(f64, f64)> {
                match self.built_in {
                    $(BuiltIn::$variant => $file::$type::measured(self),)*
                }
            }
            /// Objects, beside the arguments, that decide.
            pub(crate) fn in_the_way(&self) -> Vec<ObjectId> {
                match self.built_in {
                    $(BuiltIn::$variant => $file::$type::in_the_way(self),)*
                }
            }
        }
    };
}

table! {
    Gap => gap::Gap,
    WalkDistance => walk_distance::WalkDistance,
    Inside => inside::Inside,
    Collides => collides::Collides,
    Connects => connects::Connects,
    Reachable => reachable::Reachable,
    Visible => visible::Visible,
    Clear => clear::Clear,
    Opens => opens::Opens,
    Opening => opens::Opening,
    Slides => opens::Slides,
    Sliding => opens::Sliding,
}

/// Objects, beside the arguments of a built-in, that decide what it says; none, if the node is none. The formula is the one
/// that was last evaluated, in this instance.
pub fn in_the_way(formula: &Formula, node: NodeId, scratch: &Scratch<f64>, world: &World<f64>) -> Vec<ObjectId> {
    match formula.node(node) {
        Node::BuiltIn(built_in, args) => {
            Call { built_in: *built_in, args, values: scratch.values(), world, node }.in_the_way()
        }
        _ => Vec::new(),
    }
}

/// What a node of a formula looks at beside the arguments of a built-in; nothing, if it is none.
pub fn surroundings(formula: &Formula, node: &Node) -> Surroundings {
    match node {
        Node::BuiltIn(built_in, args) => looks_at(*built_in, &Given { formula, args }),
        _ => Surroundings::Nothing,
    }
}

/// Distance in words: two digits for what is seen, more for what is not.
pub(crate) fn metres(x: f64) -> String {
    if x.abs() < 0.01 && x != 0.0 { format!("{:.4} m", x) } else { format!("{x:.2} m") }
}
