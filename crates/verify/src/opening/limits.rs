//! How far P-OPEN asks parts to open at most: where a program asserts how far something opens, that is enough.

use scenelang_lang::opening::{Opened, asserted};
use scenelang_lang::program::{ObjectId, Program};
use scenelang_layout::Motion;

/// By object: the limits of what turns and of what slides (degrees, metres).
#[derive(Clone, Debug, Default)]
pub(super) struct Limits(Vec<(ObjectId, [f64; 2])>);

impl Limits {
    pub fn of(program: &Program) -> Self {
        let mut all: Vec<(ObjectId, [Option<f64>; 2])> = Vec::new();
        for (_, object, opened) in asserted(program) {
            let at = all.iter().position(|(other, _)| *other == object).unwrap_or_else(|| {
                all.push((object, [None; 2]));
                all.len() - 1
            });
            let [turned, slid] = &mut all[at].1;
            let raise = |limit: &mut Option<f64>, amount: f64| *limit = limit.map(|l| l.max(amount)).or(Some(amount));
            match opened {
                // What is of use is demanded in so many words.
                Opened::Useful => (*turned, *slid) = (Some(f64::INFINITY), Some(f64::INFINITY)),
                Opened::Turned(amount) => raise(turned, amount),
                Opened::Slid(amount) => raise(slid, amount),
            }
        }
        Self(all.into_iter().map(|(id, limits)| (id, limits.map(|l| l.unwrap_or(f64::INFINITY)))).collect())
    }

    /// How far the rule asks a part of an object to open, of which so much is useful.
    pub fn demand(&self, id: ObjectId, motion: Motion, useful: f64) -> f64 {
        let own = self.0.iter().find(|(other, _)| *other == id);
        own.map_or(useful, |(_, limits)| useful.min(limits[usize::from(motion == Motion::Slide)]))
    }
}
