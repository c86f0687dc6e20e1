//! W0301: order comparisons of components of a rotation that say something odd.
//!
//! Reading a component gives a value in [0, 360). Compared with a constant outside of that it tells nothing, and a
//! difference of two does not know that 359° is near 1°.

use super::scope::{Binder, Scopes};
use crate::ast::{BinaryOp, Expr, ExprId, ExprKind, Name, Stmt, StmtKind, TypeWord};
use crate::check::{Where, constant};
use crate::items::{ItemKind, Names};
use crate::program::Comparison;
use crate::types::Ty;
use scenelang_base::{Applicability, Diagnostic, Edit, Fix, TextRange, codes};

/// Looks at all comparisons of a statement.
pub fn check(names: &dyn Names, stmt: &Stmt, scopes: &Scopes<'_>, out: &mut Vec<Diagnostic<Where>>) {
    let look = Look { names, stmt, scopes };
    for id in &scopes.order {
        let expr = stmt.expr(*id);
        let ExprKind::Compare(left, steps) = &expr.kind else { continue };
        let [(op, _, right)] = steps.as_slice() else { continue };
        if matches!(op, Comparison::Eq | Comparison::Ne) {
            continue;
        }
        out.extend(look.outside(expr, *left, *right).or_else(|| look.difference(expr, *left, *right)));
    }
}

struct Look<'a> {
    names: &'a dyn Names,
    stmt: &'a Stmt,
    scopes: &'a Scopes<'a>,
}

impl<'a> Look<'a> {
    /// The rotation and the axis, if the expression is a component of a rotation.
    fn component(&self, id: ExprId) -> Option<(ExprId, &'a Name)> {
        let ExprKind::Member(of, axis) = &self.stmt.expr(id).kind else { return None };
        let rotation = match &self.stmt.expr(*of).kind {
            ExprKind::Member(_, property) => property.text == "rot",
            ExprKind::Call(function, _) => function.text == "rot",
            ExprKind::Name(name) => match self.scopes.binder(*of) {
                None => self.names.item(name) == Some(ItemKind::Variable(Ty::Rotation)),
                Some(Binder::Parameter(i)) => match &self.stmt.kind {
                    StmtKind::Predicate { params, .. } => params[i].ty == TypeWord::Rotation,
                    _ => false,
                },
                Some(Binder::Quantifier(_)) => false,
            },
            _ => false,
        };
        rotation.then_some((*of, axis))
    }

    /// A component compared with a constant that it cannot reach.
    fn outside(&self, whole: &Expr, left: ExprId, right: ExprId) -> Option<Diagnostic<Where>> {
        let sides = [(left, right), (right, left)];
        let (_, limit) = sides.into_iter().find(|(side, _)| self.component(*side).is_some())?;
        let value = constant::number(self.stmt, limit).filter(|x| !(0.0..360.0).contains(x))?;
        let message = format!(
            "a component of a rotation is in [0, 360), so comparing it with {value} always gives the same result"
        );
        let mut d = Diagnostic::new(codes::W0301, Where::Here(whole.range), message);
        if value < 0.0 {
            d = d.note(format!("{value}° is read as {}°", value.rem_euclid(360.0)));
        }
        Some(d.note("`angle` is the angle between two directions: `angle(a.front, b.front) < 10`"))
    }

    /// A difference of two components, or its magnitude, on either side.
    fn difference(&self, whole: &Expr, left: ExprId, right: ExprId) -> Option<Diagnostic<Where>> {
        let (side, (a, b)) = [left, right].into_iter().find_map(|side| Some((side, self.subtracted(side)?)))?;
        let message = "a difference of rotation components ignores that 359° is close to 1°";
        let mut d = Diagnostic::new(codes::W0301, Where::Here(whole.range), message)
            .note("`angle` is the angle between two directions or two orientations, 0 to 180");
        if let Some(edits) = self.as_angle(side, a, b) {
            let title = "write `angle(….front, ….front)`".to_owned();
            d.fixes.push(Fix { title, edits, applicability: Applicability::Unsafe });
        }
        Some(d)
    }

    /// The components whose difference it is; `abs` and a sign make no difference.
    fn subtracted(&self, mut id: ExprId) -> Option<(ExprId, ExprId)> {
        loop {
            match &self.stmt.expr(id).kind {
                ExprKind::Neg(of) => id = *of,
                ExprKind::Call(f, args) if f.text == "abs" && args.len() == 1 => id = args[0],
                ExprKind::Binary(BinaryOp::Sub, _, l, r) => {
                    return (self.component(*l).is_some() && self.component(*r).is_some()).then_some((*l, *r));
                }
                _ => return None,
            }
        }
    }

    /// Edits that make `angle(a.front, b.front)` of `a.rot.y - b.rot.y` with objects a and b, in `abs` or not.
    fn as_angle(&self, side: ExprId, a: ExprId, b: ExprId) -> Option<Vec<Edit<Where>>> {
        let object = |component: ExprId| {
            let (rotation, axis) = self.component(component).filter(|(_, axis)| axis.text == "y")?;
            let ExprKind::Member(object, _) = &self.stmt.expr(rotation).kind else { return None };
            let object = self.stmt.expr(*object);
            // Names and elements only, without parentheses of their own.
            let plain = matches!(object.kind, ExprKind::Name(_) | ExprKind::Index(..));
            let whole = self.stmt.expr(component).range;
            (plain && object.range.start == whole.start).then_some((object.range, axis.range.end))
        };
        let ((a, _), (b, b_end)) = (object(a)?, object(b)?);
        let all = self.stmt.expr(side);
        let (start, end) = match &all.kind {
            ExprKind::Binary(..) => (a.start, b_end),
            ExprKind::Call(..) => (all.range.start, all.range.end),
            _ => return None,
        };
        let edit = |start: u32, end: u32, text: &str| Edit {
            place: Where::Here(TextRange { start, end }),
            text: text.to_owned(),
        };
        Some(vec![edit(start, a.start, "angle("), edit(a.end, b.start, ".front, "), edit(b.end, end, ".front)")])
    }
}
