//! The local search: weighted min-conflicts over many sampled poses. Each is a [`Trial`]; whatever is found is judged by the
//! evaluator in the end.

mod clusters;
mod course;
mod first;
mod lean;
mod mirror;
mod moves;
mod optimise;
mod preferences;
mod rearrange;
mod ruin;
mod setup;
mod step;
#[cfg(test)]
mod tests;
mod tidy;
mod variables;
mod warm;

use clusters::Clusters;
use course::Course;
use scenelang_engine::frame::Frame;
use scenelang_engine::frame::checks::Numbering;
use scenelang_engine::trial::{Field, Inputs, Stretch, Trial, Wall};
use scenelang_verify::World;

/// Where an object belongs.
enum Home {
    /// On a floor or on something, in the field; with its back to one of these walls, if it likes.
    Stands(Vec<Wall>),
    /// On one of these walls.
    Hangs(Vec<Wall>),
    /// In this thing.
    Within(usize),
    /// Under a ceiling of this height.
    Ceiling(f64),
    /// In one of these stretches of wall.
    Door(Vec<Stretch>),
}

/// A layout under local search.
pub(crate) struct LocalSearch<'a> {
    /// The layout.
    pub trial: Trial<'a>,
    /// While preferences are raised against each other: by term, what it is worth that it holds.
    stake: Vec<f64>,
    /// Whether doors and windows stay where they are: in a layout that was given, none is moved for a preference.
    keeps_openings: bool,
    /// By object: where it was given a place; and what it costs to leave that.
    at_first: Vec<Option<Inputs>>,
    charge: f64,
    /// By object: floors that it may stand on.
    levels: Vec<Vec<f64>>,
    /// By object: others that the program asks it to go onto, perhaps.
    carriers: Vec<Vec<usize>>,
    homes: Vec<Home>,
    /// By object: rooms that it must be in and that are no rectangles.
    outlines: Vec<Vec<usize>>,
    course: Course,
    /// How often a move with whatever has to go along paid, and how often it was tried.
    along: [f64; 2],
    /// The same for moves after which paths are planned anew.
    rearranged: [f64; 2],
    /// Whether paths are looked at yet.
    walking: bool,
    /// How far apart things are put at first, for paths between them (metres).
    air: f64,
    /// By object: where its centre may be, its extents not counted.
    field: Vec<Field>,
    /// Whether turns that the program does not name are drawn: at first things stand square.
    skew: bool,
    /// Whether a thing may go onto any other: only where the floor is too small for all of them.
    stacks: bool,
    /// Whether turns in which they are drawn come first, and no room is left for paths at first unless most things stand in
    /// clusters.
    is_other: bool,
    /// By object: those that its height is set by.
    bases: Vec<Vec<usize>>,
    /// What the program keeps close together.
    clusters: Clusters,
    /// Whether that is most of what stands in the rooms.
    is_clustered: bool,
    /// By object: others that it shares terms with.
    related: Vec<Vec<usize>>,
}

impl<'a> LocalSearch<'a> {
    /// For an instance in which every object has a pose, though it need not be its place. With `tips`, whatever the program
    /// says of how things lean is searched for; else only what no upright thing fulfils.
    pub fn new(frame: &'a Frame<'a>, world: &World<f64>, numbering: Numbering, tips: bool) -> Self {
        let n = frame.program.objects.len();
        let mut local = Self {
            trial: Trial::new(frame, world, numbering, tips),
            stake: Vec::new(),
            keeps_openings: false,
            at_first: vec![None; n],
            charge: 0.0,
            levels: Vec::new(),
            carriers: frame.objects().map(|id| setup::carriers(frame, id)).collect(),
            homes: Vec::new(),
            outlines: Vec::new(),
            course: Course::default(),
            along: [0.0; 2],
            rearranged: [0.0; 2],
            walking: false,
            air: 0.0,
            field: Vec::new(),
            skew: false,
            stacks: false,
            is_other: false,
            bases: frame.sources.iter().map(|l| l.iter().map(|o| o.0 as usize).collect()).collect(),
            clusters: Clusters::default(),
            is_clustered: false,
            related: frame.related.iter().map(|l| l.iter().map(|(o, _)| o.0 as usize).collect()).collect(),
        };
        for id in frame.objects() {
            let field = local.field_of(id);
            local.field.push(field);
            local.levels.push(local.levels_of(id));
            local.outlines.push(local.outlines_of(id));
            local.homes.push(local.home_of(id, field, world));
        }
        for at in 0..local.trial.movable.len() {
            local.heed_followers(local.trial.movable[at]);
        }
        local.clusters = local.find_clusters();
        local.is_clustered = 2 * local.clusters.of.iter().flatten().count() > local.trial.movable.len();
        local
    }
}
