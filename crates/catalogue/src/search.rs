//! Which models of a catalogue fit some words, and how well.
//!
//! The score is BM25 over category, description, synset and materials, as in S. Robertson and H. Zaragoza, "The
//! Probabilistic Relevance Framework: BM25 and Beyond" (2009), with the inverse document frequency
//! ln(1 + (N − n + ½) / (n + ½)), which is never negative. Words are folded as the furniture library folds them ("Reading
//! lamps" is "reading lamp"), and the family that would draw a thing counts as one more word of it, so that a couch is
//! found where a sofa is asked for. Where a size is wanted, the score is multiplied by [`size_factor`].

use crate::folder::Entry;
use rustc_hash::FxHashMap;
use scenelang_assets::{family_of, words};
use scenelang_layout::Vec3;
use std::cmp::Ordering;

/// How soon more of the same word counts no more.
pub const K1: f64 = 1.2;
/// How much long texts are held against models: 0 not at all, 1 in full.
pub const B: f64 = 0.75;
/// Words that say nothing of a thing.
const EMPTY: &str = "a an and as at by for from in is it of on or some that the this to with";

/// An index over the entries of a catalogue. It is in memory, and as large as the texts.
#[derive(Debug, Default)]
pub struct Index {
    /// For each word, in which models it is and how often.
    postings: FxHashMap<String, Vec<(u32, u32)>>,
    /// What the length of the text of each model adds to the denominator of its scores.
    norms: Vec<f64>,
    sizes: Vec<Option<Vec3>>,
}

/// A model that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The index of the entry.
    pub entry: usize,
    /// More is better; more than 0.
    pub score: f64,
}

impl Index {
    /// An index over all of these.
    pub fn of(entries: &[Entry]) -> Self {
        let mut index = Self::default();
        let mut lengths = Vec::with_capacity(entries.len());
        for entry in entries {
            let card = &entry.card;
            // `chair.n.01` is a chair.
            let synset = card.synset.split('.').next().unwrap_or_default();
            let text = [card.category.as_str(), &card.description, synset, &card.materials.join(" ")].join(" . ");
            let terms = terms(&text, &card.category);
            lengths.push(terms.len() as f64);
            index.add(terms, entry.size);
        }
        let mean = lengths.iter().sum::<f64>() / lengths.len().max(1) as f64;
        index.norms = lengths.into_iter().map(|length| K1 * (1.0 - B + B * length / mean)).collect();
        index
    }

    fn add(&mut self, terms: Vec<String>, size: Option<Vec3>) {
        let own = self.sizes.len() as u32;
        self.sizes.push(size);
        for term in terms {
            let list = self.postings.entry(term).or_default();
            match list.last_mut() {
                Some((entry, count)) if *entry == own => *count += 1,
                _ => list.push((own, 1)),
            }
        }
    }

    /// The models that fit best, at most so many; of equal ones, those that come first in the catalogue.
    pub fn search(&self, text: &str, wanted: Option<Vec3>, most: usize) -> Vec<Hit> {
        self.best(text, wanted, most).0
    }

    /// The same, and for how many models the size was compared.
    fn best(&self, text: &str, wanted: Option<Vec3>, most: usize) -> (Vec<Hit>, usize) {
        if most == 0 {
            return (Vec::new(), 0);
        }
        let (mut best, mut compared) = (Best::new(most), 0);
        // A size only takes from a score, unless nonsense is wanted: what is no better without it needs no look.
        let takes = wanted.is_none_or(|wanted| wanted.min() > 0.0);
        for (entry, score) in self.scores(text).into_iter().enumerate() {
            if score <= 0.0 || takes && score <= best.least {
                continue;
            }
            let score = wanted.map_or(score, |wanted| {
                compared += 1;
                score * size_factor(self.sizes[entry], &wanted)
            });
            best.add(Hit { entry, score });
        }
        (best.sorted(), compared)
    }

    /// The score of each model, whatever its size.
    fn scores(&self, text: &str) -> Vec<f64> {
        let mut asked = terms(text, text);
        asked.sort_unstable();
        asked.dedup();
        let total = self.norms.len() as f64;
        let mut scores = vec![0.0; self.norms.len()];
        for list in asked.iter().filter_map(|term| self.postings.get(term)) {
            let with = list.len() as f64;
            let rarity = (1.0 + (total - with + 0.5) / (with + 0.5)).ln();
            for &(entry, count) in list {
                let often = f64::from(count);
                scores[entry as usize] += rarity * often * (K1 + 1.0) / (often + self.norms[entry as usize]);
            }
        }
        scores
    }
}

/// So many of the hits that were added that are best. They are added in the order of the catalogue.
struct Best {
    most: usize,
    /// The best ones, and some that were added since they were last picked out.
    hits: Vec<Hit>,
    /// What scores no more than this and comes later is not one of them.
    least: f64,
}

impl Best {
    /// Hits beyond those that are wanted, before the best are picked out.
    const SPARE: usize = 64;

    fn new(most: usize) -> Self {
        Self { most, hits: Vec::new(), least: f64::NEG_INFINITY }
    }

    fn order(a: &Hit, b: &Hit) -> Ordering {
        b.score.total_cmp(&a.score).then(a.entry.cmp(&b.entry))
    }

    fn add(&mut self, hit: Hit) {
        self.hits.push(hit);
        // Picking out takes time in proportion to what there is: so it waits until half of that is new.
        if self.hits.len() >= self.most.saturating_add(self.most.max(Self::SPARE)) {
            self.hits.select_nth_unstable_by(self.most - 1, Self::order);
            self.hits.truncate(self.most);
            self.least = self.hits[self.most - 1].score;
        }
    }

    fn sorted(mut self) -> Vec<Hit> {
        self.hits.sort_unstable_by(Self::order);
        self.hits.truncate(self.most);
        self.hits
    }
}

/// What a size that is not the wanted one takes from a score: 1 / (1 + d), where d is how much the extents differ: the mean
/// of |ln(is / wanted)| over height, longer and shorter side of the footprint. A size that is not known counts as one
/// that is twice the wanted one.
pub fn size_factor(size: Option<Vec3>, wanted: &Vec3) -> f64 {
    let Some(size) = size else { return 1.0 / (1.0 + std::f64::consts::LN_2) };
    let sorted = |v: &Vec3| [v.y, v.x.max(v.z), v.x.min(v.z)];
    let apart =
        sorted(&size).iter().zip(sorted(wanted)).map(|(is, wanted)| (is / wanted).ln().abs()).sum::<f64>() / 3.0;
    1.0 / (1.0 + apart)
}

/// The words of a text that say something, and the family of the thing it names.
fn terms(text: &str, named: &str) -> Vec<String> {
    let says = |word: &String| !EMPTY.split(' ').any(|empty| empty == word);
    let mut terms: Vec<String> = words(text).into_iter().filter(says).collect();
    terms.extend(family_of(named, "").map(|family| format!("family:{family}")));
    terms
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const WORDS: [&str; 8] = ["red", "oak", "chair", "table", "lamp", "modern", "details", "low"];

    /// An index of models that have some of the words, and sizes.
    fn index(models: &[(u8, u8, Option<[f64; 3]>)]) -> Index {
        let mut index = Index::default();
        let mut lengths = Vec::new();
        for (words, again, size) in models {
            let has = |bits: u8| (0..8).filter(move |i| bits >> i & 1 == 1).map(|i| WORDS[i].to_owned());
            let mut terms: Vec<String> = has(*words).chain(has(words & again)).collect();
            terms.sort();
            lengths.push(terms.len() as f64);
            index.add(terms, size.map(Vec3::from));
        }
        let mean = lengths.iter().sum::<f64>() / lengths.len().max(1) as f64;
        index.norms = lengths.iter().map(|length| K1 * (1.0 - B + B * length / mean)).collect();
        index
    }

    /// All that score anything, sorted, and then the first.
    fn plain(index: &Index, text: &str, wanted: Option<Vec3>, most: usize) -> Vec<Hit> {
        let scored = index.scores(text).into_iter().enumerate().filter(|(_, score)| *score > 0.0);
        let factor = |entry: usize| wanted.map_or(1.0, |wanted| size_factor(index.sizes[entry], &wanted));
        let mut hits: Vec<Hit> = scored.map(|(entry, score)| Hit { entry, score: score * factor(entry) }).collect();
        hits.sort_by(Best::order);
        hits.truncate(most);
        hits
    }

    fn same(a: &[Hit], b: &[Hit]) -> bool {
        let bits = |hits: &[Hit]| hits.iter().map(|h| (h.entry, h.score.to_bits())).collect::<Vec<_>>();
        bits(a) == bits(b)
    }

    proptest! {
        #[test]
        fn the_best_are_the_first_of_all_sorted(
            models in prop::collection::vec((any::<u8>(), any::<u8>(), prop::option::of([0.0..3.0, 0.1..3.0, 0.1..3.0])), 0..600),
            asked in any::<u8>(),
            wanted in prop::option::of([-0.1..3.0, 0.1..3.0, 0.1..3.0]),
            most in prop_oneof![0..70usize, Just(usize::MAX)],
        ) {
            let index = index(&models);
            let text = (0..8).filter(|i| asked >> i & 1 == 1).map(|i| WORDS[i]).collect::<Vec<_>>().join(" ");
            let wanted = wanted.map(Vec3::from);
            prop_assert!(same(&index.search(&text, wanted, most), &plain(&index, &text, wanted, most)));
        }
    }

    #[test]
    fn not_all_models_have_their_size_compared() {
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as u32
        };
        let models: Vec<_> = (0..50_000)
            .map(|_| {
                let size = [0; 3].map(|_| 0.1 + f64::from(random() % 3000) / 1000.0);
                (random() as u8 | 0b0100_0000, random() as u8, Some(size))
            })
            .collect();
        let index = index(&models);
        let wanted = Some(Vec3::new(0.5, 0.9, 0.5));
        for text in ["details", "modern red chair", "red oak chair table lamp modern details low"] {
            let (hits, compared) = index.best(text, wanted, 8);
            assert!(same(&hits, &plain(&index, text, wanted, 8)), "{text}");
            assert!(compared <= 20_000, "{text}: {compared} of 50,000");
        }
    }
}
