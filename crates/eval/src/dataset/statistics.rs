//! How large a dataset is, beside the published one.

use super::DatasetScene;
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// The published dataset: what is counted, and how much of it there is in 50 scenes. Words are means for each scene.
pub const PUBLISHED: [(&str, f64); 7] = [
    ("scenes", 50.0),
    ("rooms", 75.0),
    ("objects", 2032.0),
    ("relations", 1837.0),
    ("words of a request", 508.4),
    ("words of a sentence", 28.5),
    ("kinds of rooms for each building", 36.8),
];

/// What a dataset has.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Scenes, rooms, objects, relations, words of a request, words of a sentence, kinds of rooms: as [`PUBLISHED`].
    pub counts: [f64; 7],
    /// Scenes by building and number of rooms.
    pub shares: BTreeMap<String, usize>,
    /// Scenes in which all that must hold does, of those that are not proved to have no layout.
    pub holding: [usize; 2],
    /// Relations that hold, of all.
    pub relations: [usize; 2],
}

impl Statistics {
    /// Counts scenes.
    pub fn of(scenes: &[DatasetScene]) -> Self {
        let sum = |of: &dyn Fn(&DatasetScene) -> usize| scenes.iter().map(of).sum::<usize>() as f64;
        let mean = |total: f64| if scenes.is_empty() { 0.0 } else { total / scenes.len() as f64 };
        let words = |text: &str| text.split_whitespace().count();
        let pools = &super::pools::tables().buildings;
        let kinds: usize = pools.iter().map(|b| b.kinds.len()).sum();
        let mut out = Self {
            counts: [
                scenes.len() as f64,
                sum(&|s| s.rooms.len()),
                sum(&DatasetScene::things),
                sum(&DatasetScene::instances),
                mean(sum(&|s| words(&s.request))),
                mean(sum(&|s| words(&s.sentence))),
                kinds as f64 / pools.len() as f64,
            ],
            ..Self::default()
        };
        for scene in scenes {
            *out.shares.entry(format!("{}, {} room(s)", scene.building, scene.rooms.len())).or_default() += 1;
            let Some(held) = scene.held else { continue };
            out.relations[0] += held.relations[0];
            out.relations[1] += held.relations[1];
            if scene.satisfiable != Some(false) {
                out.holding[0] += usize::from(scene.holds());
                out.holding[1] += 1;
            }
        }
        out
    }

    /// As a value, with the published numbers beside ours.
    pub fn json(&self) -> Value {
        let rows = PUBLISHED.iter().zip(self.counts).map(|((name, published), own)| {
            json!({ "what": name, "published": published, "own": (own * 10.0).round() / 10.0 })
        });
        json!({
            "format": "scenelang.datasetStatistics/1",
            "counts": rows.collect::<Vec<_>>(),
            "scenes": self.shares,
            "scenes_in_which_all_holds": self.holding,
            "relations_that_hold": self.relations,
        })
    }
}
