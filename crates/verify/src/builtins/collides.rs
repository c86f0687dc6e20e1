//! `collides(Object, Object)`: the solids overlap by more than the tolerance.

use super::declared::Given;
use super::gap::{between, in_words};
use super::{Call, Declared, Semantics, Surroundings};
use crate::coded::Boxes;
use crate::eval::{EvalError, Truth};
use crate::number::{Algebra, Number};
use crate::prove::tape::{Claim, Term, open};
use crate::prove::unknowns::{Unknowns, claimed};
use scenelang_base::codes;
use scenelang_lang::program::{ObjectId, Program, Unit};

pub(super) struct Collides;

impl Semantics for Collides {
    type Yields<N: Algebra> = Truth<N>;
    const DECLARED: Declared = Declared {
        unit: Unit::Metre,
        wanted: None,
        unwanted: Some(|t| t.contact),
        may_be_infinite: false,
        violation: Some(codes::V0102),
    };

    fn surroundings(_given: &Given<'_>) -> Surroundings {
        Surroundings::Nothing
    }

    fn exact<N: Number>(call: &Call<'_, N>) -> Result<Truth<N>, EvalError> {
        Ok(of_gap(between(call.object(0)?.1, call.object(1)?.1), call.world.options.tolerances.contact))
    }

    fn bounds(call: &Call<'_, Term>, facts: &mut Unknowns<'_>) -> Result<Option<Truth<Term>>, EvalError> {
        Ok(Some(claimed(in_proofs(facts, call.object(0)?.0, call.object(1)?.0))))
    }

    fn fast(call: &Call<'_, Term>, boxes: &mut Boxes<'_, '_>) -> Result<Option<Truth<Term>>, EvalError> {
        let gap = boxes.gap(call.object(0)?.1, call.object(1)?.1);
        Ok(gap.map(|gap| of_gap(gap, call.world.options.tolerances.contact)))
    }

    fn words(call: &Call<'_, f64>, names: &Program) -> Option<String> {
        let gap = between(call.object(0).ok()?.1, call.object(1).ok()?.1);
        Some(in_words(call.name(0, names), call.name(1, names), gap))
    }

    fn measured(call: &Call<'_, f64>) -> Option<(f64, f64)> {
        let gap = between(call.object(0).ok()?.1, call.object(1).ok()?.1);
        Some((gap, -call.world.options.tolerances.contact))
    }
}

/// A strict one: solids that touch, or overlap by no more than the tolerance, do not collide.
fn of_gap<N: Algebra>(gap: N, contact: f64) -> Truth<N> {
    let margin = -(gap + N::constant(contact));
    Truth { margin, holds: margin.above(0.0), unit: Unit::Metre }
}

/// Whether two objects collide, in proofs.
pub(crate) fn in_proofs(facts: &mut Unknowns<'_>, a: ObjectId, b: ObjectId) -> Claim {
    if a == b {
        return open();
    }
    let gap = super::gap::in_proofs(facts, a, b);
    of_gap(gap, facts.options.tolerances.contact).holds
}
