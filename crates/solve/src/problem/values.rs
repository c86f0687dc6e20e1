//! Decision variables that sizes or regions are made of: they get their values before anything else, since rooms and things
//! keep their sizes while places are looked for.

use super::Options;
use crate::search::local::LocalSearch;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use scenelang_engine::frame::checks::Numbering;
use scenelang_engine::frame::terms::{self, Term};
use scenelang_engine::frame::{Frame, variables_of_sizes};
use scenelang_engine::limit::Limit;
use scenelang_lang::Program;
use scenelang_lang::program::Allowances;
use scenelang_layout::{DecisionValue, Layout, Vec3};
use scenelang_verify::World;
use std::time::Duration;

/// What a search for values may cost.
const BUDGET: u64 = 200_000;

/// Chooses values with which all holds that speaks of variables alone, where sizes depend on some of them.
pub(crate) fn choose(program: &Program, layout: &mut Layout, options: &Options) {
    if variables_of_sizes(program).is_empty() {
        return;
    }
    let alone = |term: &Term| term.objects.is_empty() && term.regions.is_empty();
    let terms: Vec<Term> = terms::split(program).into_iter().filter(alone).collect();
    let bare = Program {
        objects: Vec::new(),
        regions: Vec::new(),
        constraints: Vec::new(),
        pins: Vec::new(),
        allow: Allowances::default(),
        ..program.clone()
    };
    let world = World::<f64>::new(&bare, layout, &options.judge);
    let numbering = Numbering::new(terms.len(), 0);
    let frame = Frame::new(&bare, terms, None, |_| Vec3::zeros());
    let mut local = LocalSearch::new(&frame, &world, numbering, false);
    let limit = Limit::new(None::<Duration>, &options.stop);
    let mut chance = ChaCha8Rng::seed_from_u64(options.seed);
    if !local.search(&mut chance, BUDGET, &limit, &[]) {
        local.restore_best();
    }
    for (id, value) in local.trial.values() {
        layout.variables[id.0 as usize].1 = match value {
            scenelang_verify::Value::Number(n) => DecisionValue::Number(n),
            scenelang_verify::Value::Vector(v) | scenelang_verify::Value::Rotation(v) => DecisionValue::Triple(v.0),
            scenelang_verify::Value::Truth(truth) => DecisionValue::Bool(truth.holds),
        };
    }
}
