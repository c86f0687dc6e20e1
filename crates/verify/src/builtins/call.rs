//! A use of a built-in: its arguments, evaluated, and the instance that it speaks of.

use crate::eval::{Cause, EvalError, Value, Values};
use crate::number::Algebra;
use crate::vector::V3;
use crate::world::{ObjectInstance, RegionInstance, World};
use scenelang_lang::program::{Arg, BuiltIn, NodeId, ObjectId, ObjectSide, Program, RegionId};

#[derive(Clone, Copy)]
pub(crate) struct Call<'a, N: Algebra> {
    /// What is used.
    pub built_in: BuiltIn,
    /// The arguments.
    pub args: &'a [Arg],
    /// What the nodes before it have yielded.
    pub values: &'a Values<N>,
    /// The instance.
    pub world: &'a World<N>,
    /// Its own node.
    pub node: NodeId,
}

impl<'a, N: Algebra> Call<'a, N> {
    pub(super) fn fail(&self, cause: Cause) -> EvalError {
        EvalError { cause, node: self.node }
    }
    #[track_caller]
    fn ill_typed(&self) -> ! {
        unreachable!("`{}` with arguments of the wrong types: {:?}", self.built_in.name(), self.args)
    }
    pub(super) fn object(&self, index: usize) -> Result<(ObjectId, &'a ObjectInstance<N>), EvalError> {
        match self.args.get(index) {
            Some(Arg::Object(id)) => Ok((*id, self.world.object(*id).map_err(|c| self.fail(c))?)),
            _ => self.ill_typed(),
        }
    }
    pub(super) fn region(&self, index: usize) -> Result<(RegionId, &'a RegionInstance<N>), EvalError> {
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
    pub(super) fn number(&self, index: usize) -> Result<N, EvalError> {
        match self.value(index)? {
            Value::Number(n) => Ok(n),
            _ => self.ill_typed(),
        }
    }
    pub(super) fn vector(&self, index: usize) -> Result<V3<N>, EvalError> {
        match self.value(index)? {
            Value::Vector(v) => Ok(v),
            _ => self.ill_typed(),
        }
    }
    pub(super) fn side(&self, index: usize) -> ObjectSide {
        match self.args.get(index) {
            Some(Arg::Side(side)) => *side,
            _ => self.ill_typed(),
        }
    }
    /// The name of the object or region at an index.
    pub(super) fn name<'p>(&self, index: usize, names: &'p Program) -> &'p str {
        match self.args.get(index) {
            Some(Arg::Object(id)) => &names.objects[id.0 as usize].name,
            Some(Arg::Region(id)) => &names.regions[id.0 as usize].name,
            _ => self.ill_typed(),
        }
    }
    /// Built-in and arguments as one text: the same for the same question.
    ///
    /// # Errors
    /// Why a number or a vector among the arguments has no value.
    pub(crate) fn question(&self) -> Result<String, EvalError> {
        let mut text = self.built_in.name().to_owned();
        for arg in self.args {
            text += &match arg {
                Arg::Value(node) => format!(" {:?}", self.values[node.0 as usize]?),
                other => format!(" {other:?}"),
            };
        }
        Ok(text)
    }
}
