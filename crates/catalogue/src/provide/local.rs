//! A folder of models as a provider.
//!
//! A model is considered if it is the same kind of thing: the family of the furniture library that would draw it is that of
//! what is wanted, or, where no family knows the noun, the noun is the same. Of those, the ones with the best words are
//! read, and the best of them by words and size that can be brought to the size is given.
//!
//! Where the folder has features and vectors for the query in its published form, the published score decides instead, over
//! all models; the published threshold is then what a model must score, unless the user says another.

use super::fit::fit;
use super::{AssetProvider, Given, Query, Remark, Reply, Why, sum};
use crate::features::TAU;
use crate::folder::{Catalogue, Entry};
use crate::model::CatalogueModel;
use crate::search::{Hit, Index, size_factor};
use scenelang_assets::{family_of, words};
use scenelang_base::Diagnostic;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock};

/// So many models are read for an object at most.
const READ: usize = 8;
/// So many are looked at by their cards.
const LOOKED_AT: usize = 10_000;

/// A model with the sum of its file, or why it cannot be used.
type Read = Result<(Arc<CatalogueModel>, String), Box<Diagnostic>>;

/// A folder of models.
#[derive(Debug)]
pub struct Local {
    name: String,
    catalogue: Catalogue,
    index: Index,
    least: Option<f64>,
    /// By entry: what was read, so that six equal chairs are read once.
    read: Vec<OnceLock<Read>>,
}

impl Local {
    /// The models of `folder`, called `name` in reports; what scores less than `least` is not used (usually 0 by words, and
    /// [`TAU`] by features).
    ///
    /// # Errors
    /// There is no such folder, or nothing to read in it.
    pub fn open(folder: &Path, name: &str, least: Option<f64>) -> Result<Self, Box<Diagnostic>> {
        let catalogue = Catalogue::list(folder)?;
        let index = Index::of(&catalogue.entries);
        let read = catalogue.entries.iter().map(|_| OnceLock::new()).collect();
        Ok(Self { name: name.to_owned(), catalogue, index, least, read })
    }

    /// What of the folder cannot be used, as far as is known without reading the models.
    pub fn refused(&self) -> &[crate::Refused] {
        &self.catalogue.refused
    }

    fn model(&self, entry: usize) -> Read {
        let read = || {
            let entry = &self.catalogue.entries[entry];
            let bytes = self.catalogue.bytes(entry)?;
            let content = sum(&[&bytes]);
            let model = self.catalogue.model_of(entry, bytes)?;
            Ok((Arc::new(model), content))
        };
        self.read[entry].get_or_init(read).clone()
    }

    /// The models that are looked at, the best first; and whether their scores are the published ones.
    fn hits(&self, query: &Query) -> (Vec<Hit>, bool) {
        let entries = &self.catalogue.entries;
        let features = self.catalogue.features.as_ref();
        if let Some(hits) = features.and_then(|f| f.search(entries, &query.published(), READ)) {
            return (hits, true);
        }
        let mut hits = self.index.search(&query.text(), query.wanted(), LOOKED_AT);
        hits.retain(|hit| same_kind(query, &entries[hit.entry]));
        hits.truncate(READ);
        (hits, false)
    }

    fn one(&self, query: &Query) -> Reply {
        let entries = &self.catalogue.entries;
        let (hits, published) = self.hits(query);
        if hits.is_empty() {
            return Reply::passes(Why::Nothing, format!("it has no \"{}\"", query.what));
        }
        let wanted = query.wanted().filter(|_| !published);
        let least = self.least.unwrap_or(if published { TAU } else { 0.0 });
        let mut remarks = Vec::new();
        let mut found = Vec::new();
        for hit in hits {
            if published && hit.score < least {
                if found.is_empty() {
                    let file = &entries[hit.entry].file;
                    let say = format!("{file}: it scores {:.3}, less than {least}", hit.score);
                    remarks.push(Remark::new(Why::Score, say));
                }
                break;
            }
            match self.model(hit.entry) {
                Ok((model, content)) => {
                    // The card need not say how large it is; now that is known.
                    let score = wanted.map_or(hit.score, |wanted| {
                        hit.score / size_factor(entries[hit.entry].size, &wanted)
                            * size_factor(Some(model.size), &wanted)
                    });
                    found.push((score, hit.entry, model, content));
                }
                Err(finding) => remarks.push(Remark::broken(&entries[hit.entry].file, &finding)),
            }
        }
        found.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        for (score, entry, model, content) in found {
            if score < least {
                let say = format!("{}: it scores {score:.3}, less than {least}", model.file);
                remarks.push(Remark::new(Why::Score, say));
                break;
            }
            match fit(&model, query, true) {
                Ok(piece) => {
                    let given = Given {
                        piece,
                        source: model.file.clone(),
                        score: Some(score),
                        content: Some(content),
                        licence: entries[entry].card.licence.clone(),
                    };
                    return Reply { given: Some(given), remarks };
                }
                Err(remark) => remarks.push(remark),
            }
        }
        Reply { given: None, remarks }
    }
}

impl AssetProvider for Local {
    fn name(&self) -> &str {
        &self.name
    }

    fn provide(&self, queries: &[&Query], _: &mut dyn FnMut(&str)) -> Vec<Reply> {
        // Side by side; which thread answers which query changes no answer.
        let threads = std::thread::available_parallelism().map_or(1, usize::from).min(queries.len());
        let next = AtomicUsize::new(0);
        let mut replies: Vec<Option<Reply>> = vec![None; queries.len()];
        std::thread::scope(|scope| {
            let answer = || {
                let mut answers = Vec::new();
                loop {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    let Some(query) = queries.get(i) else { return answers };
                    answers.push((i, self.one(query)));
                }
            };
            let asked: Vec<_> = (0..threads).map(|_| scope.spawn(answer)).collect();
            for (i, reply) in asked.into_iter().filter_map(|thread| thread.join().ok()).flatten() {
                replies[i] = Some(reply);
            }
        });
        replies.into_iter().map(|reply| reply.unwrap_or_else(|| Reply::passes(Why::Failed, "it broke off"))).collect()
    }
}

/// Whether a model is the kind of thing that is wanted.
fn same_kind(query: &Query, entry: &Entry) -> bool {
    let wanted = family_of(&query.category, &query.name);
    let has = family_of(&entry.card.category, "");
    if wanted.is_some() || has.is_some() {
        return wanted == has;
    }
    let (wanted, has) = (words(&query.what), words(&entry.card.category));
    wanted.last().is_some() && wanted.last() == has.last()
}
