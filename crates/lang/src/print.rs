//! Formulas in words, for people who want to see what a program became: `scenelang constraints`, tests, logs.
//!
//! Shared nodes are written out each time; a long text is cut.

use crate::program::*;
use std::fmt::{self, Write};

/// A formula with the program that its ids belong to.
pub struct Printed<'a>(pub &'a Program, pub &'a Formula);

/// Longer texts end in `…` (bytes).
const LIMIT: usize = 100_000;

impl fmt::Display for Printed<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut out = String::new();
        // Cut by our own limit, not by an error of the formatter.
        let complete = self.node(self.1.root, &mut out).is_ok();
        f.write_str(&out)?;
        if complete { Ok(()) } else { f.write_str(" …") }
    }
}

impl Printed<'_> {
    fn node(&self, id: NodeId, out: &mut String) -> fmt::Result {
        if out.len() > LIMIT {
            return Err(fmt::Error);
        }
        // A chain of definitions put in place nests as deeply as it is long.
        stacker::maybe_grow(64 << 10, 1 << 20, || self.written(id, out))
    }

    fn written(&self, id: NodeId, out: &mut String) -> fmt::Result {
        match self.1.node(id) {
            Node::Number(x) => write!(out, "{x}"),
            Node::Truth(t) => write!(out, "{t}"),
            Node::Vector(v) => self.call("vec3", v, out),
            Node::Rotation(v) => self.call("rot", v, out),
            Node::Object(p, id) => write!(out, "{}.{}", self.object(*id), lower_first(&format!("{p:?}"))),
            Node::Region(p, id) => write!(out, "{}.{}", self.region(*id), lower_first(&format!("{p:?}"))),
            Node::Variable(id) => out.write_str(&self.0.variables[id.0 as usize].name),
            Node::Draw(id) => write!(out, "draw(\"{}\")", self.0.draws[id.0 as usize].key),
            Node::Choice(id, list) => {
                let list = list.to_vec();
                self.call(&format!("choice(\"{}\") of ", self.0.draws[id.0 as usize].key), &list, out)
            }
            Node::Neg(a) => self.joined("-", &[*a], out),
            Node::Arith(op, a, b) => {
                let sign = match op {
                    Arith::Add => " + ",
                    Arith::Sub => " - ",
                    Arith::Mul => " * ",
                    Arith::Div => " / ",
                };
                self.joined(sign, &[*a, *b], out)
            }
            Node::Component(axis, a) => {
                self.node(*a, out)?;
                write!(out, ".{}", lower_first(&format!("{axis:?}")))
            }
            Node::Call(function, args) => self.call(&lower_first(&format!("{function:?}")), args, out),
            Node::Compare(op, unit, a, b) => {
                self.node(*a, out)?;
                let sign = match op {
                    Comparison::Eq => "=",
                    Comparison::Ne => "!=",
                    Comparison::Lt => "<",
                    Comparison::Le => "<=",
                    Comparison::Gt => ">",
                    Comparison::Ge => ">=",
                };
                let unit = if *unit == Unit::Degree { "°" } else { "" };
                write!(out, " {sign}{unit} ")?;
                self.node(*b, out)
            }
            Node::Same(a, b) => {
                self.node(*a, out)?;
                out.write_str(" = ")?;
                self.node(*b, out)
            }
            Node::And(list) => self.joined(" and ", list, out),
            Node::Or(list) => self.joined(" or ", list, out),
            Node::Not(a) => {
                out.write_str("not ")?;
                self.joined("", &[*a], out)
            }
            Node::Iff(a, b) => self.joined(" iff ", &[*a, *b], out),
            Node::Count(list) => self.call("count", list, out),
            Node::AtLeast(n, list) => self.call(&format!("atLeast {n} of"), list, out),
            Node::BuiltIn(b, args) => self.built_in(b.name(), args, out),
            Node::SamePolygon(region, points) => {
                write!(out, "{}.vertices = ", self.region(*region))?;
                self.call("polygon", points, out)
            }
        }
    }

    fn joined(&self, sign: &str, list: &[NodeId], out: &mut String) -> fmt::Result {
        out.write_char('(')?;
        if list.len() == 1 {
            out.write_str(sign)?;
        }
        for (i, id) in list.iter().enumerate() {
            if i > 0 {
                out.write_str(sign)?;
            }
            self.node(*id, out)?;
        }
        out.write_char(')')
    }

    fn call(&self, name: &str, list: &[NodeId], out: &mut String) -> fmt::Result {
        write!(out, "{name}(")?;
        for (i, id) in list.iter().enumerate() {
            if i > 0 {
                out.write_str(", ")?;
            }
            self.node(*id, out)?;
        }
        out.write_char(')')
    }

    fn built_in(&self, name: &str, args: &[Arg], out: &mut String) -> fmt::Result {
        write!(out, "{name}(")?;
        for (i, arg) in args.iter().enumerate() {
            if i > 0 {
                out.write_str(", ")?;
            }
            match arg {
                Arg::Object(id) => out.write_str(self.object(*id))?,
                Arg::Region(id) => out.write_str(self.region(*id))?,
                Arg::Value(id) => self.node(*id, out)?,
                Arg::Side(side) => out.write_str(&lower_first(&format!("{side:?}")))?,
            }
        }
        out.write_char(')')
    }

    fn object(&self, id: ObjectId) -> &str {
        &self.0.objects[id.0 as usize].name
    }

    fn region(&self, id: RegionId) -> &str {
        &self.0.regions[id.0 as usize].name
    }
}

fn lower_first(word: &str) -> String {
    let mut chars = word.chars();
    chars.next().map_or(String::new(), |c| c.to_lowercase().chain(chars).collect())
}
