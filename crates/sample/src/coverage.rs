//! How far samples are spread: each thing's places and turns, how near samples are to each other, what was tried and what
//! refused it.

use crate::sampler::{Drawn, Missing};
use crate::tally::{KINDS, RULES, Tally};
use crate::values::Values;
use scenelang_lang::Program;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Edge of the cells in which places are counted (metres).
const CELL: f64 = 0.25;
/// Sectors in which turns are counted.
const SECTORS: usize = 16;
/// Distances are measured among the first so many samples: all pairs of more take too long.
const COMPARED: usize = 2_000;
/// A thing moves if its spread is more than this (metres).
const MOVES: f64 = 1e-4;
/// So many statements and things are named to people.
const NAMED: usize = 8;

/// One thing in all samples.
#[derive(Clone, Debug, Default)]
struct Spread {
    mean: [f64; 3],
    /// Sums of squared differences from the mean.
    squares: [f64; 3],
    cells: BTreeMap<[i64; 3], u64>,
    sectors: [u64; SECTORS],
}

impl Spread {
    fn add(&mut self, pos: [f64; 3], yaw: f64, count: f64) {
        for (axis, x) in pos.into_iter().enumerate() {
            let off = x - self.mean[axis];
            self.mean[axis] += off / count;
            self.squares[axis] += off * (x - self.mean[axis]);
        }
        *self.cells.entry(pos.map(|x| (x / CELL).floor() as i64)).or_default() += 1;
        // The middle of the first sector is 0, so that rounding does not part what is turned alike.
        let sector = (yaw.rem_euclid(360.0) / 360.0 * SECTORS as f64).round() as usize % SECTORS;
        self.sectors[sector] += 1;
    }

    /// The standard deviation of its place (metres).
    fn deviation(&self, count: u64) -> f64 {
        (self.squares.iter().sum::<f64>() / (count.max(2) - 1) as f64).sqrt()
    }
}

/// Shannon entropy in bits.
fn entropy(counts: impl Iterator<Item = u64> + Clone) -> f64 {
    let total: u64 = counts.clone().sum();
    let part = |n: u64| n as f64 / total as f64;
    counts.filter(|n| *n > 0).map(|n| -part(n) * part(n).log2()).sum::<f64>() + 0.0
}

#[derive(Clone, Debug, Default)]
pub struct Coverage {
    /// Samples asked for.
    pub asked: u64,
    /// Those stored.
    pub stored: u64,
    /// Those whose draws admit no layout, as far as the solver finds.
    pub no_layout: u64,
    /// Those that did not stand the check.
    pub unverified: u64,
    /// Those stored that were drawn as a whole.
    pub whole: u64,
    tally: Tally,
    /// By key, in the order of the program.
    draws: Vec<(String, Values)>,
    spreads: Vec<Spread>,
    /// By sample: where each thing is.
    places: Vec<Vec<[f64; 3]>>,
}

impl Coverage {
    /// Nothing yet.
    pub fn new(program: &Program) -> Self {
        let spreads = vec![Spread::default(); program.objects.len()];
        Self { tally: Tally::new(program), draws: Values::all(program), spreads, ..Self::default() }
    }

    /// Counts what was drawn, in the order of the samples.
    pub fn add(&mut self, drawn: &Drawn) {
        self.asked += 1;
        self.tally.add(&drawn.tally);
        let admits = match drawn.result {
            Ok(_) => Some(true),
            Err(Missing::NoLayout) => Some(false),
            Err(_) => None,
        };
        for (key, value) in &drawn.draws {
            let own = self.draws.iter_mut().find(|(known, _)| known == key);
            if let (Some((_, values)), Some(admits)) = (own, admits) {
                values.add(*value, admits);
            }
        }
        let sample = match &drawn.result {
            Ok(sample) => sample,
            Err(Missing::NoLayout) => return self.no_layout += 1,
            Err(Missing::Unverified) => return self.unverified += 1,
            Err(Missing::Stopped) => return self.asked -= 1,
        };
        self.stored += 1;
        self.whole += u64::from(sample.whole);
        let objects = &sample.layout.objects;
        for (spread, (_, placement)) in self.spreads.iter_mut().zip(objects) {
            spread.add(placement.pos.into(), placement.rot.y, self.stored as f64);
        }
        if self.places.len() < COMPARED {
            self.places.push(objects.iter().map(|(_, placement)| placement.pos.into()).collect());
        }
    }

    /// Counts what was tried for samples that were added without their own counts: all of it, and how many were drawn as a
    /// whole.
    pub fn count(&mut self, tally: &Tally, whole: u64) {
        self.tally.add(tally);
        self.whole += whole;
    }

    /// Things that are not where they were in another sample.
    fn moving(&self) -> Vec<usize> {
        (0..self.spreads.len()).filter(|i| self.spreads[*i].deviation(self.stored) > MOVES).collect()
    }

    /// The mean and the least of how far each sample is from the one most like it: metres that things that move are apart, on
    /// average.
    fn nearest(&self, moving: &[usize]) -> Option<[f64; 2]> {
        if self.places.len() < 2 || moving.is_empty() {
            return None;
        }
        let apart = |a: &[[f64; 3]], b: &[[f64; 3]]| {
            let of = |i: usize| std::iter::zip(a[i], b[i]).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt();
            moving.iter().map(|i| of(*i)).sum::<f64>() / moving.len() as f64
        };
        let nearest = self.places.iter().enumerate().map(|(i, a)| {
            let others = self.places.iter().enumerate().filter(|(j, _)| *j != i);
            others.map(|(_, b)| apart(a, b)).fold(f64::INFINITY, f64::min)
        });
        let nearest: Vec<f64> = nearest.collect();
        let mean = nearest.iter().sum::<f64>() / nearest.len() as f64;
        Some([mean, nearest.into_iter().fold(f64::INFINITY, f64::min)])
    }

    /// What refused moves, most first: a statement (its index) or a physical rule, and how many.
    fn refusals(&self) -> Vec<(Result<usize, &'static str>, u64)> {
        let statements = self.tally.refused.len() - RULES.len().min(self.tally.refused.len());
        let what = |i: usize| if i < statements { Ok(i) } else { Err(RULES[i - statements]) };
        let mut list: Vec<_> = self.tally.refused.iter().enumerate().map(|(i, n)| (what(i), *n)).collect();
        list.retain(|(_, n)| *n > 0);
        list.sort_by_key(|(_, n)| std::cmp::Reverse(*n));
        list
    }

    /// As JSON. `statement` says how reports call a statement.
    pub fn json(&self, program: &Program, statement: &dyn Fn(usize) -> String) -> Value {
        let moving = self.moving();
        let objects = moving.iter().map(|&i| {
            let spread = &self.spreads[i];
            json!({
                "object": program.objects[i].name.as_str(),
                "mean": spread.mean.map(rounded),
                "deviation": rounded(spread.deviation(self.stored)),
                "cells": spread.cells.len(),
                "entropyOfPlace": rounded(entropy(spread.cells.values().copied())),
                "entropyOfTurn": rounded(entropy(spread.sectors.iter().copied())),
            })
        });
        let moves = KINDS.iter().zip(self.tally.moves).filter(|(_, [tried, _])| *tried > 0);
        let moves = moves.map(|((.., name), [tried, taken])| json!({ "kind": name, "tried": tried, "taken": taken }));
        let refused = self.refusals().into_iter().map(|(what, times)| match what {
            Ok(index) => {
                json!({ "statement": statement(index), "text": program.constraints[index].text, "moves": times })
            }
            Err(rule) => json!({ "rule": rule, "moves": times }),
        });
        json!({
            "asked": self.asked,
            "stored": self.stored,
            "noLayout": self.no_layout,
            "unverified": self.unverified,
            "drawnAsWhole": self.whole,
            "nearestNeighbour": self.nearest(&moving).map(|[mean, least]| json!({
                "samples": self.places.len(), "mean": rounded(mean), "least": rounded(least),
            })),
            "draws": self.draws.iter().map(|(key, values)| values.json(key)).collect::<Vec<_>>(),
            "objects": objects.collect::<Vec<_>>(),
            "whole": { "tried": self.tally.whole[0], "taken": self.tally.whole[1] },
            "moves": moves.collect::<Vec<_>>(),
            "ways": { "runs": self.tally.ways[0], "taken": self.tally.ways[1] },
            "refused": refused.collect::<Vec<_>>(),
        })
    }

    /// For people.
    pub fn text(&self, program: &Program, statement: &dyn Fn(usize) -> String) -> String {
        let mut out = format!("{} of {} samples stored, each verified\n", self.stored, self.asked);
        if self.no_layout > 0 {
            let [were, their] = if self.no_layout == 1 { ["was", "its"] } else { ["were", "their"] };
            let no_layout = self.no_layout;
            let _ = writeln!(out, "{no_layout} {were} left out, because the solver found no layout for {their} draws");
        }
        if self.unverified > 0 {
            let were = if self.unverified == 1 { "was" } else { "were" };
            let _ = writeln!(out, "{} failed the check and {were} not stored", self.unverified);
        }
        let moving = self.moving();
        if let Some([mean, least]) = self.nearest(&moving) {
            let among = self.places.len();
            let _ = writeln!(
                out,
                "movable objects are {mean:.3} m from those in the most similar other sample on average (among {among}; \
                 least {least:.3} m)"
            );
        }
        if !self.draws.is_empty() {
            out += "draws:\n";
        }
        for (key, values) in self.draws.iter().take(NAMED) {
            let _ = writeln!(out, "  {key:<24} {}", values.text());
        }
        if self.draws.len() > NAMED {
            let _ = writeln!(out, "  and {} more", self.draws.len() - NAMED);
        }
        let mut things = moving;
        things.sort_by(|a, b| {
            let deviation = |i: &usize| self.spreads[*i].deviation(self.stored);
            deviation(a).total_cmp(&deviation(b))
        });
        if !things.is_empty() {
            out +=
                "spread of objects, the smallest first: deviation of the position, entropy of position and rotation\n";
        }
        for &i in things.iter().take(NAMED) {
            let spread = &self.spreads[i];
            let _ = writeln!(
                out,
                "  {:<24} {:>7.3} m {:>6.2} bits {:>6.2} bits",
                program.objects[i].name,
                spread.deviation(self.stored),
                entropy(spread.cells.values().copied()),
                entropy(spread.sectors.iter().copied()),
            );
        }
        if things.len() > NAMED {
            let _ = writeln!(out, "  and {} more", things.len() - NAMED);
        }
        let tried = self.tally.moves.iter().fold([0, 0], |sum, m| [sum[0] + m[0], sum[1] + m[1]]);
        for ([tried, taken], what) in
            [(self.tally.whole, "whole layouts"), (tried, "moves"), (self.tally.ways, "runs checked for paths")]
        {
            if tried > 0 {
                let _ =
                    writeln!(out, "{taken} of {tried} {what} accepted ({:.2} %)", 100.0 * taken as f64 / tried as f64);
            }
        }
        let refusals = self.refusals();
        if !refusals.is_empty() {
            out += "most frequent reasons for rejection:\n";
        }
        for (what, times) in refusals.into_iter().take(NAMED) {
            let (id, text) = match what {
                Ok(index) => (statement(index), program.constraints[index].text.as_str()),
                Err(rule) => (rule.to_owned(), ""),
            };
            let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
            let line = format!("  {times:>9}  {id}  {text}");
            let _ = writeln!(out, "{}", line.trim_end());
        }
        out
    }
}

/// To four digits: more of a statistic say nothing.
pub(crate) fn rounded(x: f64) -> f64 {
    (x * 1e4).round() / 1e4 + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entropy_of_equal_parts() {
        assert_eq!(entropy([5, 5, 5, 5, 0].into_iter()), 2.0);
        assert_eq!(entropy([9].into_iter()), 0.0);
        let mut spread = Spread::default();
        for (i, yaw) in [(0, 359.9), (1, 0.1), (2, 0.0)] {
            spread.add([f64::from(i), 0.0, 0.0], yaw, f64::from(i + 1));
        }
        assert_eq!((spread.sectors[0], spread.cells.len()), (3, 3));
        assert!((spread.deviation(3) - 1.0).abs() < 1e-12);
    }
}
