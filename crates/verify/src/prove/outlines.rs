//! Outlines that no region can have: the assigned polygon touches or crosses itself.

use super::Contradiction;
use crate::eval::{Value, evaluate};
use crate::tolerances::Options;
use crate::world::World;
use scenelang_lang::program::{Pinned, Program};
use scenelang_layout::{Layout, Polygon};

/// A contradiction for each assigned polygon that is known without a layout and is not simple.
pub(super) fn impossible(program: &Program, options: &Options) -> Vec<Contradiction> {
    let mut pins = program.pins.iter().filter(|pin| pin.property == Pinned::Vertices).peekable();
    if pins.peek().is_none() {
        return Vec::new();
    }
    let nothing = World::<f64>::new(program, &Layout::default(), options);
    pins.filter_map(|pin| {
        let vertices: Option<Vec<[f64; 2]>> = pin
            .values
            .iter()
            .map(|formula| match evaluate(formula, &nothing) {
                Ok(Value::Vector(v)) => Some([v.value().x, v.value().z]),
                // It depends on the layout.
                _ => None,
            })
            .collect();
        let why = Polygon::new(&vertices?).err()?.to_string();
        Some(Contradiction { statements: vec![pin.constraint], rules: vec![why], ..Contradiction::default() })
    })
    .collect()
}
