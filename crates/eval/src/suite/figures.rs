//! The figures of a suite, and those that others have published.

use super::{Case, Placed};
use crate::resemblance::{Quality, TAUS};
use serde::{Deserialize, Serialize};

/// The paper that the figures are from.
pub const PAPER: &str = "arXiv 2507.18625";

/// Published shares of constraints (percent) after 0 to 5 iterations, by model: table of RQ1.3.
pub const PUBLISHED_CORRECTNESS: [(&str, [f64; 6]); 3] = [
    ("GPT-4o", [47.1, 60.4, 63.2, 65.6, 67.3, 68.3]),
    ("Gemini 2.5 Pro", [74.1, 91.1, 92.5, 93.8, 93.5, 93.4]),
    ("DeepSeek R1", [47.8, 87.6, 90.6, 91.7, 92.9, 93.0]),
];

/// Published resemblance (percent) by model, at τ = 0.7, 0.8, 0.9: precision, recall, F1 of objects, layout, overall (RQ1.1).
pub const PUBLISHED_RESEMBLANCE: [(&str, [[f64; 9]; 3]); 3] = [
    (
        "GPT-4o",
        [
            [99.2, 98.0, 98.5, 98.3, 80.3, 86.4, 98.7, 88.3, 92.1],
            [99.1, 97.9, 98.4, 69.1, 55.4, 57.7, 81.4, 70.8, 72.7],
            [97.8, 96.6, 97.1, 14.9, 11.4, 12.0, 25.9, 20.5, 21.4],
        ],
    ),
    (
        "Gemini 2.5 Pro",
        [
            [97.9, 98.7, 98.2, 89.3, 99.9, 93.8, 93.4, 99.3, 95.9],
            [97.6, 98.5, 97.9, 33.3, 92.7, 48.0, 49.6, 95.5, 64.4],
            [96.8, 97.7, 97.1, 4.0, 18.2, 6.5, 7.7, 30.7, 12.2],
        ],
    ),
    (
        "DeepSeek R1",
        [
            [99.1, 95.9, 96.7, 97.1, 97.1, 97.1, 98.1, 96.5, 96.7],
            [99.0, 95.7, 96.6, 62.0, 82.0, 69.1, 76.3, 88.3, 80.5],
            [96.8, 94.0, 94.7, 7.4, 15.6, 9.8, 13.7, 26.8, 17.7],
        ],
    ),
];

/// Published coherence of pictures from above by questions to a vision model (percent), by system and model: with the request, and
/// with its one sentence (RQ2).
pub const PUBLISHED_COHERENCE: [(&str, [f64; 2]); 9] = [
    ("GPT-4o", [28.3, 44.8]),
    ("Gemini 2.5 Pro", [29.5, 47.9]),
    ("DeepSeek R1", [29.8, 48.6]),
    ("direct prompting, GPT-4o", [15.1, 28.6]),
    ("direct prompting, Gemini 2.5 Pro", [27.1, 41.1]),
    ("direct prompting, DeepSeek R1", [23.9, 38.9]),
    ("Holodeck, GPT-4o", [24.7, 37.7]),
    ("Holodeck, Gemini 2.5 Pro", [26.0, 42.1]),
    ("Holodeck, DeepSeek R1", [19.8, 31.8]),
];

/// What is the same in each run on each machine.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Figures {
    pub suite: String,
    /// Scenes, rooms, objects, relations, words in all requests.
    pub size: [usize; 5],
    /// Share of the relations that hold after 0, 1, … iterations, and without a limit; percent.
    pub search: Vec<f64>,
    /// Scenes in which all that must hold does.
    pub scenes: usize,
    /// Share of the relations that hold in what the grid has placed, and of the objects that it has placed; percent.
    pub grid: [f64; 2],
    /// The same of a model that was asked directly.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub direct: Option<[f64; 2]>,
    /// How well a model finds that pictures show the requests, and their one sentences; percent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coherence: Option<[f64; 2]>,
    pub similarity: String,
    /// As [`PUBLISHED_RESEMBLANCE`], percent.
    pub resemblance: [[f64; 9]; 3],
}

impl Figures {
    /// Of the cases of a suite. Relations are pooled; resemblance is the mean over the scenes, overall the harmonic mean of the
    /// two means, as the published numbers fit together.
    pub fn of(suite: &str, cases: &[Case]) -> Self {
        let sum = |of: &dyn Fn(&Case) -> usize| cases.iter().map(of).sum::<usize>();
        let percent =
            |[part, whole]: [usize; 2]| if whole == 0 { 100.0 } else { round(100.0 * part as f64 / whole as f64) };
        let pooled = |of: &dyn Fn(&Case) -> [usize; 2]| percent([0, 1].map(|i| sum(&|case| of(case)[i])));
        let placed = |of: &dyn Fn(&Case) -> Placed| {
            let kept =
                |case: &Case| [of(case).dropped[1] - of(case).dropped[0].min(of(case).dropped[1]), of(case).dropped[1]];
            [pooled(&|case| of(case).relations), pooled(&kept)]
        };
        let steps = cases.iter().map(|case| case.search.len()).min().unwrap_or(0);
        let asked = !cases.is_empty() && cases.iter().all(|case| case.direct.is_some());
        let rated: Option<Vec<[f64; 2]>> = cases.iter().map(|case| case.coherence).collect();
        let rated = rated.filter(|rated| !rated.is_empty());
        let resemblance = std::array::from_fn(|t| {
            let mean = |of: &dyn Fn(&Case) -> [f64; 3]| {
                let all = cases.iter().map(|case| {
                    let [precision, recall, f1] = of(case);
                    Quality { precision, recall, f1 }
                });
                Quality::mean(&all.collect::<Vec<_>>())
            };
            let (objects, layout) = (mean(&|case| case.objects[t]), mean(&|case| case.layout[t]));
            let all = [objects, layout, Quality::overall(objects, layout)];
            let numbers = all.iter().flat_map(|q| [q.precision, q.recall, q.f1]).map(|x| round(100.0 * x));
            let mut out = [0.0; 9];
            out.iter_mut().zip(numbers).for_each(|(to, from)| *to = from);
            out
        });
        Self {
            suite: suite.to_owned(),
            size: [
                cases.len(),
                sum(&|case| case.size[0]),
                sum(&|case| case.size[1]),
                sum(&|case| case.size[2]),
                sum(&|case| case.size[3]),
            ],
            search: (0..steps).map(|i| pooled(&|case| case.search[i])).collect(),
            scenes: sum(&|case| usize::from(case.all[0] == case.all[1])),
            grid: placed(&|case| case.grid),
            direct: asked.then(|| placed(&|case| case.direct.unwrap_or_default())),
            coherence: rated
                .map(|all| [0, 1].map(|i| round(all.iter().map(|two| two[i]).sum::<f64>() / all.len() as f64))),
            similarity: cases.first().map_or_else(String::new, |case| case.similarity.clone()),
            resemblance,
        }
    }

    /// What of ours is lower than it was: what, before, now. Baselines are not among them.
    pub fn fallen(&self, before: &Self) -> Vec<(String, f64, f64)> {
        let mut all: Vec<(String, f64, f64)> =
            vec![("scenes in which everything holds".to_owned(), before.scenes as f64, self.scenes as f64)];
        let at = |of: &Self, i: usize| of.search.get(i).copied().unwrap_or(0.0);
        all.extend(
            (0..before.search.len()).map(|i| (format!("relations after iteration {i}"), at(before, i), at(self, i))),
        );
        let parts = ["objects", "layout", "overall"]
            .iter()
            .flat_map(|part| ["precision", "recall", "F1"].iter().map(move |what| format!("{what} of {part}")));
        for (i, part) in parts.enumerate() {
            for (t, tau) in TAUS.iter().enumerate() {
                all.push((format!("{part} at {tau}"), before.resemblance[t][i], self.resemblance[t][i]));
            }
        }
        all.retain(|(_, before, now)| now < before);
        all
    }
}

/// To a tenth.
fn round(x: f64) -> f64 {
    (x * 10.0).round() / 10.0
}
