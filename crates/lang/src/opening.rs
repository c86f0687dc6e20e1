//! How far the assertions of a program demand that parts of objects open: with `opens` and `slides`, and by a bound on
//! `opening` and `sliding`.
//!
//! P-OPEN asks no more of a part than they do. So a program says it openly where something opens less far than is useful, and
//! the plan shows what is demanded.

use crate::natives::BuiltIn;
use crate::program::{Arg, Comparison, Constraint, ConstraintKind, Formula, Node, NodeId, ObjectId, Program, Unit};

/// What an assertion demands of the parts of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Opened {
    /// Everything that opens does as far as is of use.
    Useful,
    /// Everything that turns opens by an angle (degrees).
    Turned(f64),
    /// Everything that slides comes out by a distance (metres).
    Slid(f64),
}

/// What the assertions of a program demand: the index of the constraint, the object and how far. An amount that depends on
/// the layout is not among them.
pub fn asserted(program: &Program) -> Vec<(usize, ObjectId, Opened)> {
    let asserts = |c: &Constraint| c.kind == ConstraintKind::Assert;
    let constraints = program.constraints.iter().enumerate().filter(|(_, c)| asserts(c));
    let mut found = Vec::new();
    for (index, constraint) in constraints {
        let formula = &constraint.formula;
        demanded(formula, formula.root, &mut |object, opened| found.push((index, object, opened)));
    }
    found
}

/// Tells of each demand that must hold if a node does.
fn demanded(formula: &Formula, node: NodeId, found: &mut impl FnMut(ObjectId, Opened)) {
    let number = |node: NodeId| if let Node::Number(number) = formula.node(node) { Some(*number) } else { None };
    match formula.node(node) {
        Node::And(all) => all.iter().for_each(|node| demanded(formula, *node, found)),
        Node::BuiltIn(built_in, args) => match (built_in, &args[..]) {
            (BuiltIn::Opens, [Arg::Object(object)]) => found(*object, Opened::Useful),
            (BuiltIn::Opens, [Arg::Object(object), Arg::Value(amount)]) => {
                number(*amount).into_iter().for_each(|amount| found(*object, Opened::Turned(amount)));
            }
            (BuiltIn::Slides, [Arg::Object(object), Arg::Value(amount)]) => {
                number(*amount).into_iter().for_each(|amount| found(*object, Opened::Slid(amount)));
            }
            _ => {}
        },
        Node::Compare(comparison, unit, a, b) => {
            let (measure, least) = match comparison {
                Comparison::Ge | Comparison::Gt => (*a, number(*b)),
                Comparison::Le | Comparison::Lt => (*b, number(*a)),
                _ => return,
            };
            let (Node::BuiltIn(built_in, args), Some(least)) = (formula.node(measure), least) else { return };
            match (built_in, unit, &args[..]) {
                (BuiltIn::Opening, Unit::Degree, [Arg::Object(object)]) => found(*object, Opened::Turned(least)),
                (BuiltIn::Sliding, _, [Arg::Object(object)]) => found(*object, Opened::Slid(least)),
                _ => {}
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Options, compile_text};
    use std::path::Path;

    #[test]
    fn what_must_hold_with_a_number_is_a_demand() {
        let found = |statement: &str| {
            let text = format!("object a; object b; {statement}");
            let compiled = compile_text("room.scene", Path::new("room.scene"), &text, Options::default());
            let program = compiled.program.unwrap_or_else(|| panic!("{statement}: {:?}", compiled.diagnostics));
            asserted(&program).into_iter().map(|(_, object, opened)| (object.0, opened)).collect::<Vec<_>>()
        };
        for (statement, wanted) in [
            ("assert opens(a);", vec![(0, Opened::Useful)]),
            ("assert opens(b, 60deg);", vec![(1, Opened::Turned(60.0))]),
            ("assert slides(a, 0.3);", vec![(0, Opened::Slid(0.3))]),
            ("assert opening(a) >= 45deg;", vec![(0, Opened::Turned(45.0))]),
            ("assert 45deg <= opening(a);", vec![(0, Opened::Turned(45.0))]),
            (
                "assert opening(a) > 45deg and sliding(b) >= 0.2;",
                vec![(0, Opened::Turned(45.0)), (1, Opened::Slid(0.2))],
            ),
            (
                "assert forall x in objects: opens(x, 30deg);",
                vec![(0, Opened::Turned(30.0)), (1, Opened::Turned(30.0))],
            ),
            ("assert opening(a) <= 45deg;", vec![]),
            ("assert opens(a) or opens(b);", vec![]),
            ("assert not opens(a, 60deg);", vec![]),
            ("assert opening(a) >= opening(b);", vec![]),
            ("prefer opens(a, 60deg);", vec![]),
        ] {
            assert_eq!(found(statement), wanted, "{statement}");
        }
    }
}
