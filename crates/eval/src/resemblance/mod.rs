//! Constraint resemblance as published: how much of the objects and of the constraints of the ground truth a program has, at a
//! threshold τ of similarity.
//!
//! - Objects: the confidence of a pair is the harmonic mean of the similarities of names and of descriptions; the Hungarian
//!   method pairs them one to one; pairs below τ are none.
//! - Constraints: each of both sides may go with many; a pair counts if its similarity is at least τ and the made sentence
//!   has the name of an object of the true one.
//!
//! Similarity is whatever implements [`Similarity`]: by default [`Lexical`], which is of letters and not of meaning, so its
//! figures are not those of the embeddings that the published ones were made with.

mod clauses;
mod similarity;

pub use clauses::{Clause, Described, Sayings, of_program, of_scene};
pub use similarity::{Embedded, Lexical, Similarity};

use crate::pairing::pair;

/// The published thresholds.
pub const TAUS: [f64; 3] = [0.7, 0.8, 0.9];
/// Similarities are told apart to this many digits when pairs are chosen, so that the choice is one of whole numbers.
const DIGITS: f64 = 1e9;

/// Precision, recall and their harmonic mean.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Quality {
    /// Of what was made, how much is true.
    pub precision: f64,
    /// Of what is true, how much was made.
    pub recall: f64,
    /// The harmonic mean of both.
    pub f1: f64,
}

impl Quality {
    /// Of counts: what was found, what was made in vain, what was missed.
    pub fn of(found: usize, vain: usize, missed: usize) -> Self {
        let share = |of: usize| if of == 0 { 0.0 } else { found as f64 / of as f64 };
        let (precision, recall) = (share(found + vain), share(found + missed));
        Self { precision, recall, f1: harmonic(precision, recall) }
    }

    /// The mean of several, each number for itself: as published, over scenes.
    pub fn mean(all: &[Self]) -> Self {
        let mean = |of: fn(&Self) -> f64| all.iter().map(of).sum::<f64>() / all.len().max(1) as f64;
        Self { precision: mean(|q| q.precision), recall: mean(|q| q.recall), f1: mean(|q| q.f1) }
    }

    /// The harmonic mean of two, each number for itself: as published, of objects and constraints.
    pub fn overall(objects: Self, layout: Self) -> Self {
        Self {
            precision: harmonic(objects.precision, layout.precision),
            recall: harmonic(objects.recall, layout.recall),
            f1: harmonic(objects.f1, layout.f1),
        }
    }
}

/// The words of a text in small letters, with a blank on each side.
fn spaced(text: &str) -> String {
    let words = text.split(|c: char| !c.is_alphabetic()).filter(|word| !word.is_empty());
    words.fold(" ".to_owned(), |all, word| all + &word.to_lowercase() + " ")
}

/// 0 where both are.
fn harmonic(a: f64, b: f64) -> f64 {
    if a + b > 0.0 { 2.0 * a * b / (a + b) } else { 0.0 }
}

/// How well objects go with those of the ground truth.
pub fn objects(truth: &[Described], made: &[Described], by: &dyn Similarity, tau: f64) -> Quality {
    let confidence =
        |t: &Described, m: &Described| harmonic(by.of(&t.name, &m.name), by.of(&t.description, &m.description));
    let weights: Vec<Vec<f64>> = truth.iter().map(|t| made.iter().map(|m| confidence(t, m)).collect()).collect();
    let whole: Vec<Vec<i64>> =
        weights.iter().map(|row| row.iter().map(|w| (w * DIGITS).round() as i64).collect()).collect();
    let pairs = pair(&whole);
    let found = pairs.iter().enumerate().filter(|(t, m)| m.is_some_and(|m| weights[*t][m] >= tau)).count();
    Quality::of(found, made.len() - found, truth.len() - found)
}

/// How well constraints go with those of the ground truth.
pub fn layout(truth: &[Clause], made: &[String], by: &dyn Similarity, tau: f64) -> Quality {
    let sentences: Vec<String> = made.iter().map(|sentence| spaced(sentence)).collect();
    let (mut hit, mut used) = (vec![false; truth.len()], vec![false; made.len()]);
    for (t, clause) in truth.iter().enumerate() {
        let names: Vec<String> = clause.names.iter().map(|name| spaced(name)).collect();
        for (m, sentence) in made.iter().enumerate() {
            if names.iter().any(|name| sentences[m].contains(name)) && by.of(&clause.sentence, sentence) >= tau {
                (hit[t], used[m]) = (true, true);
            }
        }
    }
    let count = |of: &[bool], is: bool| of.iter().filter(|x| **x == is).count();
    // As published: what is found is counted in the ground truth, what is in vain among what was made.
    Quality::of(count(&hit, true), count(&used, false), count(&hit, false))
}
