//! The text form of USD: prims that nest, properties, values.

use crate::numbers::{number, numbers};
use scenelang_layout::Vec3;
use std::fmt::Write;

/// A layer as it grows.
#[derive(Debug)]
pub(super) struct Usda {
    out: String,
    depth: usize,
}

impl Usda {
    /// A layer with its metadata, a line each; lines of a nested dictionary are indented by who writes them.
    pub fn new(metadata: &[String]) -> Self {
        let mut out = Self { out: "#usda 1.0\n".into(), depth: 0 };
        out.parentheses(metadata);
        out.out.push('\n');
        out
    }

    /// Begins a prim, `def Xform`, that [`Usda::end`] ends.
    pub fn begin(&mut self, kind: &str, name: &str, metadata: &[String]) {
        self.indent();
        let _ = write!(self.out, "{kind} \"{name}\"");
        if metadata.is_empty() {
            self.out.push('\n');
        } else {
            self.out.push(' ');
            self.parentheses(metadata);
        }
        self.line("{");
        self.depth += 1;
    }

    /// Ends the prim that began last.
    pub fn end(&mut self) {
        self.depth -= 1;
        self.line("}");
    }

    /// A property.
    pub fn line(&mut self, text: &str) {
        self.indent();
        self.out.push_str(text);
        self.out.push('\n');
    }

    /// The layer.
    pub fn finish(self) -> String {
        debug_assert_eq!(self.depth, 0);
        self.out
    }

    fn parentheses(&mut self, lines: &[String]) {
        self.out.push_str("(\n");
        self.depth += 1;
        lines.iter().for_each(|line| self.line(line));
        self.depth -= 1;
        self.line(")");
    }

    fn indent(&mut self) {
        self.out.extend(std::iter::repeat_n("    ", self.depth));
    }
}

/// A text in quotation marks. Signs that a layer has no place for become U+FFFD.
pub(super) fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            c if c.is_control() => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// `(1, 2, 3)`
pub(super) fn triple(v: &Vec3) -> String {
    format!("({})", numbers(v.iter().copied(), ", "))
}

/// A quaternion x, y, z, w as USD writes it: the real part first.
pub(super) fn quaternion([x, y, z, w]: [f64; 4]) -> String {
    format!("({})", numbers([w, x, y, z], ", "))
}

/// `[(1, 2, 3), …]` of the numbers of a mesh.
pub(super) fn triples(values: impl Iterator<Item = [f32; 3]>) -> String {
    // A short f32 is a long f64: it is written as what it is.
    let one = |v: f32| if v.abs() < 1e-9 { "0".to_owned() } else { v.to_string() };
    let all: Vec<String> = values.map(|[x, y, z]| format!("({}, {}, {})", one(x), one(y), one(z))).collect();
    format!("[{}]", all.join(", "))
}

/// An `apiSchemas` line.
pub(super) fn schemas(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("\"{name}\"")).collect();
    format!("prepend apiSchemas = [{}]", quoted.join(", "))
}

/// A property of one number.
pub(super) fn scalar(declaration: &str, value: f64) -> String {
    format!("{declaration} = {}", number(value))
}
