//! The furniture library as a provider, and the labelled box that comes when nobody has anything.

use super::{AssetProvider, Given, ProvidedModel, Query, Reply, Why};
use scenelang_assets::{Asset, AssetRequest, family_of, furnish};

/// Furniture made to order: what a family draws.
#[derive(Clone, Copy, Debug)]
pub struct Library;

/// A box of the right size with the name of the thing on it.
#[derive(Clone, Copy, Debug)]
pub struct Boxed;

impl AssetProvider for Library {
    fn name(&self) -> &str {
        "library"
    }

    fn provide(&self, queries: &[&Query], _: &mut dyn FnMut(&str)) -> Vec<Reply> {
        let one = |query: &&Query| {
            if family_of(&query.category, &query.name).is_none() {
                return Reply::passes(Why::Nothing, format!("no family draws \"{}\"", query.what));
            }
            Reply { given: Some(given(drawn(query))), remarks: Vec::new() }
        };
        queries.iter().map(one).collect()
    }
}

impl AssetProvider for Boxed {
    fn name(&self) -> &str {
        "box"
    }

    fn provide(&self, queries: &[&Query], _: &mut dyn FnMut(&str)) -> Vec<Reply> {
        queries.iter().map(|query| Reply { given: Some(boxed(query)), remarks: Vec::new() }).collect()
    }
}

/// The box of a thing, whether or not a family would draw it.
pub(super) fn boxed(query: &Query) -> Given {
    let known = family_of(&query.category, &query.name).is_some();
    let asked = if known { AssetRequest { name: "", category: "", ..request(query) } } else { request(query) };
    given(furnish(&asked))
}

fn drawn(query: &Query) -> Asset {
    furnish(&request(query))
}

fn request(query: &Query) -> AssetRequest<'_> {
    AssetRequest {
        name: &query.name,
        category: &query.category,
        color: &query.color,
        material: &query.material,
        features: &query.features,
        size: query.wanted(),
    }
}

fn given(asset: Asset) -> Given {
    let Asset { family, size, parts, surface, joints, mesh, .. } = asset;
    Given {
        piece: ProvidedModel { size, parts, surface, joints, mesh },
        source: family.to_owned(),
        score: None,
        content: None,
        licence: None,
    }
}
