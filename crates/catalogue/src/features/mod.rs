//! The published score of retrieval, from features that a user has computed before: vectors of CLIP for views of the models
//! and of Sentence-BERT for their descriptions, and vectors of both for the queries.
//!
//! The score is (λv · visual + λt · semantic) / (λv + λt) with λv = 100 and λt = 1. Both similarities are cosines brought to
//! 0…1, (1 + cos) / 2; of several views of a model the one that fits best counts, as in Holodeck. No network and no model is
//! used here: where a query has no vectors, there is no such score.

mod known;

use crate::faults::{Fault, fault};
use crate::folder::Entry;
use crate::npy::{self, Array};
use crate::pickle::Pickle;
use crate::search::Hit;
use known::{Known, Of};
use rustc_hash::FxHashMap;
use scenelang_base::codes;
use scenelang_base::door::Door;
use std::path::Path;

/// The weights of both similarities.
pub const LAMBDA_VISUAL: f64 = 100.0;
/// See [`LAMBDA_VISUAL`].
pub const LAMBDA_SEMANTIC: f64 = 1.0;
/// Models that score less are not used: the published threshold.
pub const TAU: f64 = 0.652;

/// The folder of features below that of the models, and its files.
pub(crate) const FOLDER: &str = "features";
const NAMES: &str = "names.json";
const QUERIES: &str = "queries.json";
const ARRAYS: [&str; 4] = ["clip_models.npy", "sbert_models.npy", "clip_queries.npy", "sbert_queries.npy"];
/// The features of models in a folder of Holodeck, with the members that are used: they take the place of the list of
/// names and of the arrays of the models.
const PICKLES: [(&str, &str); 2] = [("clip_features.pkl", "img_features"), ("sbert_features.pkl", "text_features")];

/// Vectors of the models of a folder and of queries.
#[derive(Debug)]
pub struct Features {
    /// The row of a model by its name.
    models: FxHashMap<String, usize>,
    /// The row of a query by its text.
    queries: FxHashMap<String, usize>,
    clip: Vectors,
    sbert: Vectors,
    clip_asked: Vectors,
    sbert_asked: Vectors,
    known: Known,
}

/// Rows of unit vectors, `views` for each model or query.
#[derive(Debug)]
struct Vectors {
    views: usize,
    width: usize,
    numbers: Vec<f32>,
}

/// The published score of two similarities.
pub fn published_score(visual: f64, semantic: f64) -> f64 {
    (LAMBDA_VISUAL * visual + LAMBDA_SEMANTIC * semantic) / (LAMBDA_VISUAL + LAMBDA_SEMANTIC)
}

/// A fault of the features.
pub(crate) fn broken(message: impl Into<String>) -> Fault {
    fault(codes::E0706, message)
}

/// Features beyond the limits.
pub(crate) use crate::faults::beyond;

impl Features {
    /// The features below a folder of models; `None` where there are none.
    ///
    /// # Errors
    /// A file is missing, is not what it should be, does not fit the others, or goes beyond the limits.
    pub(crate) fn open(folder: &Path, door: &Door) -> Result<Option<Self>, Fault> {
        let folder = folder.join(FOLDER);
        // Holodeck has features of its models, and none of queries until they are computed.
        if ![NAMES, QUERIES].iter().chain(&ARRAYS).any(|name| door.is_file(&folder.join(name))) {
            return Ok(None);
        }
        let bytes = |name: &str| {
            door.read(&folder.join(name)).map_err(|e| {
                let mut fault = crate::faults::unreadable(&e);
                fault.message = format!("{FOLDER}/{name}: {}", fault.message);
                fault
            })
        };
        let rows = |name: &str| -> Result<FxHashMap<String, usize>, Fault> {
            let list = serde_json::from_slice(&bytes(name)?)
                .map_err(|e| broken(format!("{FOLDER}/{name}: it is not a list of strings: {e}")))?;
            numbered(list, name)
        };
        let vectors = |name: &str, rows: &FxHashMap<String, usize>| {
            Vectors::of(npy::read(&bytes(name)?, &format!("{FOLDER}/{name}"))?, rows.len(), name)
        };
        let is_pickled = !door.is_file(&folder.join(NAMES)) && door.is_file(&folder.join(PICKLES[0].0));
        let (models, clip, sbert) = if is_pickled {
            let read = |at: usize| pickled(&bytes(PICKLES[at].0)?, PICKLES[at]);
            let ((models, clip), (others, sbert)) = (read(0)?, read(1)?);
            if models != others {
                let [clip, sbert] = PICKLES.map(|(name, _)| name);
                return Err(broken(format!(
                    "{FOLDER}/: {clip} and {sbert} do not list the same models in the same order"
                )));
            }
            (models, clip, sbert)
        } else {
            let models = rows(NAMES)?;
            let (clip, sbert) = (vectors(ARRAYS[0], &models)?, vectors(ARRAYS[1], &models)?);
            (models, clip, sbert)
        };
        let queries = rows(QUERIES)?;
        let found = Self {
            clip,
            sbert,
            clip_asked: vectors(ARRAYS[2], &queries)?,
            sbert_asked: vectors(ARRAYS[3], &queries)?,
            known: Known::new(0, 0, 0),
            models,
            queries,
        };
        for (a, b, names) in [(&found.clip, &found.clip_asked, [0, 2]), (&found.sbert, &found.sbert_asked, [1, 3])] {
            let [a_name, b_name] = names.map(|i| ARRAYS[i]);
            if a.width != b.width {
                let say =
                    format!("the vectors of {a_name} have {} numbers, but those of {b_name} have {}", a.width, b.width);
                return Err(broken(format!("{FOLDER}/: {say}; both must come from the same network")));
            }
        }
        Ok(Some(found.ready()))
    }

    /// Makes estimates for the queries.
    fn ready(mut self) -> Self {
        let width = self.clip.width.max(self.sbert.width);
        self.known = Known::new(self.models.len(), self.queries.len(), width);
        let (clip, sbert) = self.vectors();
        self.known.prepare(clip, sbert);
        self
    }

    fn vectors(&self) -> (Of<'_>, Of<'_>) {
        let clip = Of { models: &self.clip, asked: &self.clip_asked };
        (clip, Of { models: &self.sbert, asked: &self.sbert_asked })
    }

    /// Whether there are vectors for a query.
    pub fn knows(&self, query: &str) -> bool {
        self.queries.contains_key(query)
    }

    /// The row of the vectors of a model.
    pub(crate) fn row(&self, model: &str) -> Option<u32> {
        self.models.get(model).map(|row| *row as u32)
    }

    /// The models of a catalogue that fit a query best, at most so many, with the published score; of equal ones, those that
    /// come first. `None` where there are no vectors for the query. The entries are those of the folder of these features.
    pub fn search(&self, entries: &[Entry], query: &str, most: usize) -> Option<Vec<Hit>> {
        let query = *self.queries.get(query)?;
        let rows = entries.iter().enumerate().filter_map(|(at, entry)| Some((at as u32, entry.row?)));
        let hit = |(entry, row): (u32, u32)| Hit { entry: entry as usize, score: self.score_of(query, row as usize) };
        let mut hits: Vec<Hit> = self.candidates(rows, query, most).into_iter().map(hit).collect();
        hits.sort_by(|a, b| b.score.total_cmp(&a.score).then(a.entry.cmp(&b.entry)));
        hits.truncate(most);
        Some(hits)
    }

    /// Those of the models, with their rows, that can be among the `most` best ones for a query.
    fn candidates(&self, rows: impl Iterator<Item = (u32, u32)>, query: usize, most: usize) -> Vec<(u32, u32)> {
        if most == 0 {
            return Vec::new();
        }
        let (clip, sbert) = self.vectors();
        let scores = self.known.scores(query, clip, sbert);
        let score = |row: u32| f64::from(scores[row as usize]);
        let mut rows: Vec<(u32, u32)> = rows.collect();
        if most < rows.len() {
            rows.select_nth_unstable_by(most - 1, |a, b| score(b.1).total_cmp(&score(a.1)));
            // So many models score at least this.
            let least = score(rows[most - 1].1) - self.known.error;
            rows.retain(|(_, row)| score(*row) + self.known.error >= least);
        }
        rows
    }

    /// The published score of a model, from 0 to 1; `None` where there are no vectors for it or for the query.
    pub fn score(&self, query: &str, model: &str) -> Option<f64> {
        Some(self.score_of(*self.queries.get(query)?, *self.models.get(model)?))
    }

    fn score_of(&self, query: usize, model: usize) -> f64 {
        let visual = self.clip.nearest(model, self.clip_asked.row(query));
        let semantic = self.sbert.nearest(model, self.sbert_asked.row(query));
        published_score(visual, semantic)
    }
}

/// The row of each text of a list.
fn numbered(list: Vec<String>, name: &str) -> Result<FxHashMap<String, usize>, Fault> {
    let count = list.len();
    let rows: FxHashMap<String, usize> = list.into_iter().enumerate().map(|(i, text)| (text, i)).collect();
    if rows.len() < count {
        return Err(broken(format!("{FOLDER}/{name}: it contains the same text twice")));
    }
    Ok(rows)
}

/// The models of a file of Holodeck, and the vectors that are called `of` in it.
fn pickled(bytes: &[u8], (name, of): (&str, &str)) -> Result<(FxHashMap<String, usize>, Vectors), Fault> {
    let wrong = |why: String| broken(format!("{FOLDER}/{name}: {why}"));
    let data = Pickle::read(bytes).map_err(wrong)?;
    let member = |key: &str| data.get(data.root, key).ok_or_else(|| wrong(format!("it has no member `{key}`")));
    let texts = data.texts(member("uids")?).ok_or_else(|| wrong("`uids` is not a list of texts".to_owned()))?;
    let array = data.array(member(of)?).map_err(|why| wrong(format!("`{of}`: {why}")))?;
    let rows = numbered(texts, name)?;
    let vectors = Vectors::of(array, rows.len(), name)?;
    Ok((rows, vectors))
}

/// A cosine brought to 0…1.
fn similarity(cosine: f64) -> f64 {
    ((1.0 + cosine) / 2.0).clamp(0.0, 1.0)
}

impl Vectors {
    /// The vectors of an array of so many models or queries, each of length 1.
    fn of(array: Array, rows: usize, name: &str) -> Result<Self, Fault> {
        let Array { shape, mut numbers } = array;
        let (views, width) = match shape[..] {
            [_, width] => (1, width),
            [_, views, width] => (views, width),
            _ => {
                return Err(broken(format!(
                    "{FOLDER}/{name}: it has one dimension, but needs one row of numbers for each entry"
                )));
            }
        };
        if shape[0] != rows {
            let list = match name {
                _ if name.ends_with("queries.npy") => &format!("{FOLDER}/{QUERIES}"),
                _ if name.ends_with(".pkl") => "its list `uids`",
                _ => &format!("{FOLDER}/{NAMES}"),
            };
            return Err(broken(format!("{FOLDER}/{name}: it has {} rows, but {list} has {rows} texts", shape[0])));
        }
        if views > 1 && name.ends_with("queries.npy") {
            return Err(broken(format!("{FOLDER}/{name}: a query has one vector, not {views}")));
        }
        for (at, vector) in numbers.chunks_exact_mut(width).enumerate() {
            let length = vector.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>().sqrt();
            if length < f64::from(f32::MIN_POSITIVE) {
                return Err(broken(format!("{FOLDER}/{name}: row {} is a vector of zeros", at / views)));
            }
            vector.iter_mut().for_each(|x| *x = (f64::from(*x) / length) as f32);
        }
        Ok(Self { views, width, numbers })
    }

    fn rows(&self) -> usize {
        self.numbers.len() / (self.views * self.width)
    }

    fn row(&self, row: usize) -> &[f32] {
        let size = self.views * self.width;
        &self.numbers[row * size..][..size]
    }

    /// The greatest similarity of the views of a row to a vector, from 0 to 1.
    fn nearest(&self, row: usize, to: &[f32]) -> f64 {
        let cosines = self.row(row).chunks_exact(self.width).map(|view| f64::from(dot(view, to)));
        similarity(cosines.fold(f64::NEG_INFINITY, f64::max))
    }
}

/// A sum of products, in sixteen sums that a processor makes side by side.
fn dot(a: &[f32], b: &[f32]) -> f32 {
    const LANES: usize = 16;
    let mut sums = [0.0_f32; LANES];
    let (left, right) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest: f32 = left.remainder().iter().zip(right.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in left.zip(right) {
        for lane in 0..LANES {
            sums[lane] += x[lane] * y[lane];
        }
    }
    sums.iter().sum::<f32>() + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIDTH: usize = 768;

    /// Vectors of random directions, the same on every machine.
    fn random(rows: usize, views: usize, state: &mut u64) -> Vectors {
        let mut next = || {
            *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (*state >> 40) as f32 / (1_u64 << 23) as f32 - 1.0
        };
        let numbers = (0..rows * views * WIDTH).map(|_| next()).collect();
        Vectors::of(Array { shape: vec![rows, views, WIDTH], numbers }, rows, NAMES).unwrap()
    }

    /// Features of models and queries that are called by their numbers.
    fn features(models: usize, queries: usize) -> Features {
        let named = |count: usize| (0..count).map(|i| (i.to_string(), i)).collect();
        let mut state = 18;
        Features {
            models: named(models),
            queries: named(queries),
            clip: random(models, 3, &mut state),
            sbert: random(models, 1, &mut state),
            clip_asked: random(queries, 1, &mut state),
            sbert_asked: random(queries, 1, &mut state),
            known: Known::new(0, 0, 0),
        }
        .ready()
    }

    #[test]
    fn a_query_scores_few_models_and_misses_none() {
        const MODELS: usize = 2_000;
        let features = features(MODELS, 70);
        let rows = || (0..MODELS as u32).map(|i| (i, i));
        // The last queries are of the second block, which is not full.
        for query in (0..70).step_by(3).chain([69]) {
            let exact: Vec<f64> = (0..MODELS).map(|model| features.score_of(query, model)).collect();
            let (clip, sbert) = features.vectors();
            let estimates = features.known.scores(query, clip, sbert);
            for (exact, estimate) in exact.iter().zip(estimates) {
                assert!(
                    (exact - f64::from(*estimate)).abs() < f64::min(1e-6, features.known.error),
                    "{exact} {estimate}"
                );
            }
            for most in [1, 8, 100] {
                let mut best: Vec<u32> = (0..MODELS as u32).collect();
                best.sort_by(|a, b| exact[*b as usize].total_cmp(&exact[*a as usize]));
                let candidates = features.candidates(rows(), query, most);
                assert!(best[..most].iter().all(|b| candidates.iter().any(|(_, row)| row == b)), "{query} {most}");
                assert!(candidates.len() <= most + 20, "{query}: {} are scored for {most}", candidates.len());
            }
        }
        assert!(features.candidates(rows(), 0, 0).is_empty());
        assert_eq!(features.candidates(rows(), 0, MODELS).len(), MODELS);
    }
}
