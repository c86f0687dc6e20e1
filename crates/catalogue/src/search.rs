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
    /// How many words each model has.
    lengths: Vec<u32>,
    sizes: Vec<Option<Vec3>>,
    mean: f64,
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
        for entry in entries {
            let card = &entry.card;
            // `chair.n.01` is a chair.
            let synset = card.synset.split('.').next().unwrap_or_default();
            let text = [card.category.as_str(), &card.description, synset, &card.materials.join(" ")].join(" . ");
            index.add(terms(&text, &card.category), entry.size);
        }
        index.mean = index.lengths.iter().map(|n| f64::from(*n)).sum::<f64>() / index.lengths.len().max(1) as f64;
        index
    }

    fn add(&mut self, terms: Vec<String>, size: Option<Vec3>) {
        let own = self.lengths.len() as u32;
        self.lengths.push(terms.len() as u32);
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
        let mut asked = terms(text, text);
        asked.sort_unstable();
        asked.dedup();
        let total = self.lengths.len() as f64;
        let mut scores = vec![0.0; self.lengths.len()];
        for list in asked.iter().filter_map(|term| self.postings.get(term)) {
            let with = list.len() as f64;
            let rarity = (1.0 + (total - with + 0.5) / (with + 0.5)).ln();
            for &(entry, count) in list {
                let (often, length) = (f64::from(count), f64::from(self.lengths[entry as usize]));
                scores[entry as usize] +=
                    rarity * often * (K1 + 1.0) / (often + K1 * (1.0 - B + B * length / self.mean));
            }
        }
        let hit = |(entry, score): (usize, f64)| Hit {
            entry,
            score: wanted.map_or(score, |wanted| score * size_factor(self.sizes[entry], &wanted)),
        };
        let mut hits: Vec<Hit> = scores.into_iter().enumerate().filter(|(_, s)| *s > 0.0).map(hit).collect();
        hits.sort_by(|a, b| b.score.total_cmp(&a.score).then(a.entry.cmp(&b.entry)));
        hits.truncate(most);
        hits
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
