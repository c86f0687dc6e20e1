//! Estimates of the published score, of all models for the queries that a folder has vectors for.
//!
//! Only queries with vectors can be asked, so those are known when the folder is opened. Their products with the vectors of
//! the models are made for many queries at once, as products of matrices: the models, which are far more than a cache
//! holds, then come from memory once for a block of queries instead of once for each. A processor may add the terms in any
//! order, so these scores are only estimates with a bound on their error; what is returned is scored anew, one vector at a
//! time, in an order that is the same everywhere.

use super::{Vectors, published_score, similarity};
use nalgebra::{DMatrix, DMatrixView};
use std::sync::OnceLock;

/// So many queries are made ready at once. Estimates of a block take 4 bytes for each query and model.
const BLOCK: usize = 64;
/// So many blocks are made ready when a folder is opened; the others when one of their queries is first asked.
const AT_ONCE: usize = 4;
/// The products of so many models are in a cache together.
const MODELS: usize = 256;
/// Products of fewer rows are not made by the fast kernels.
const ROWS: usize = 8;

/// Estimates of scores.
#[derive(Debug)]
pub(super) struct Known {
    models: usize,
    /// For each block of queries: the estimates of the models for its first query, then for the next.
    blocks: Vec<OnceLock<Vec<f32>>>,
    /// No estimate is farther from the score than this.
    pub error: f64,
}

/// Vectors of the models, and of the queries.
#[derive(Clone, Copy)]
pub(super) struct Of<'a> {
    pub models: &'a Vectors,
    pub asked: &'a Vectors,
}

impl Known {
    /// Of so many models and queries; `width` is that of the longest vectors. None is made ready yet.
    pub fn new(models: usize, queries: usize, width: usize) -> Self {
        let blocks = (0..queries.div_ceil(BLOCK)).map(|_| OnceLock::new()).collect();
        // A sum of n products of numbers of two unit vectors is off by at most n·u, in whatever order it is made, with
        // u = ε/2. A similarity is half of it; the estimate and the score may both be off, and are rounded a few times.
        let error = (width + 32) as f64 * f64::from(f32::EPSILON);
        Self { models, blocks, error }
    }

    /// Makes the first queries ready.
    pub fn prepare(&self, clip: Of, sbert: Of) {
        for block in 0..self.blocks.len().min(AT_ONCE) {
            self.block(block, clip, sbert);
        }
    }

    /// The estimated scores of all models for a query.
    pub fn scores(&self, query: usize, clip: Of, sbert: Of) -> &[f32] {
        let block = self.block(query / BLOCK, clip, sbert);
        &block[query % BLOCK * self.models..][..self.models]
    }

    fn block(&self, block: usize, clip: Of, sbert: Of) -> &[f32] {
        self.blocks[block].get_or_init(|| {
            let first = block * BLOCK;
            let count = (clip.asked.rows() - first).min(BLOCK);
            let mut scores = vec![0.0; count * self.models];
            let (clip_asked, sbert_asked) = (matrix(clip.asked, first, count), matrix(sbert.asked, first, count));
            for from in (0..self.models).step_by(MODELS) {
                let until = (from + MODELS).min(self.models);
                let visual = products(&clip_asked, clip.models, from, until);
                let semantic = products(&sbert_asked, sbert.models, from, until);
                for (query, of) in scores.chunks_exact_mut(self.models).enumerate() {
                    for (at, score) in of[from..until].iter_mut().enumerate() {
                        let best = |all: &DMatrix<f32>, views: usize| {
                            (at * views..(at + 1) * views).map(|v| all[(query, v)]).fold(f32::NEG_INFINITY, f32::max)
                        };
                        let (visual, semantic) =
                            (best(&visual, clip.models.views), best(&semantic, sbert.models.views));
                        *score = published_score(similarity(visual.into()), similarity(semantic.into())) as f32;
                    }
                }
            }
            scores
        })
    }
}

/// Vectors of some queries, one in a row.
fn matrix(asked: &Vectors, first: usize, count: usize) -> DMatrix<f32> {
    DMatrix::from_fn(count.max(ROWS), asked.width, |i, j| if i < count { asked.row(first + i)[j] } else { 0.0 })
}

/// The products of queries with the views of some models.
fn products(asked: &DMatrix<f32>, models: &Vectors, from: usize, until: usize) -> DMatrix<f32> {
    let size = models.views * models.width;
    asked
        * DMatrixView::from_slice(
            &models.numbers[from * size..until * size],
            models.width,
            (until - from) * models.views,
        )
}
