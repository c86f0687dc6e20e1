//! The local search: weighted min-conflicts over many sampled poses.
//!
//! The layout is a row of floats here, formulas are code (see [`scenelang_verify::coded`]), parts are boxes, and a trial
//! looks only at what the moved objects touch. What has no code is asked of the evaluator (`exact`). Whatever is found is
//! judged by the evaluator in the end.

mod clear;
mod clusters;
mod corridors;
mod course;
mod exact;
mod first;
mod judge;
mod lean;
mod mirror;
mod moves;
mod near;
mod optimise;
mod paths;
mod preferences;
mod rearrange;
mod rooms;
mod setup;
mod step;
#[cfg(test)]
mod tests;
mod tidy;
mod variables;
mod warm;

use crate::problem::pose::Pose;
use clear::Clear;
use clusters::Clusters;
use course::Course;
use exact::{Instance, Mixed};
use judge::Moved;
use lean::Lean;
use moves::Inputs;
use near::Near;
use paths::{Asked, PathGroup};
use rooms::{Field, Room, Stretch, Wall};
use scenelang_engine::candidate::Change;
use scenelang_engine::frame::checks::Numbering;
use scenelang_engine::frame::rules::Sets;
use scenelang_engine::frame::{Frame, Hold};
use scenelang_engine::penalty::Truths;
use scenelang_lang::program::{Formula, Node, NodeId, ObjectId, RegionId};
use scenelang_layout::Vec3;
use scenelang_verify::coded::{self, Block, Coded, CodedValue, Coder, Slots};
use scenelang_verify::{Tolerances, Truth, World, rules};
use std::sync::Arc;
use variables::Variables;

/// Overlaps of less than this are rounding (metres).
const TOUCHING: f64 = 1e-7;

/// How a term is judged here.
enum Judge {
    /// An object is in a room.
    Inside(usize, usize),
    /// The space beside an object is free.
    Clear(Clear),
    /// There are paths.
    PathGroup(usize),
    /// It asks for one of the paths that another term answers for.
    Shared(usize),
    /// By its code.
    Code(Coded),
    /// By its code as far as that goes, and by the evaluator.
    Mixed(Mixed),
    /// It speaks of the turn of one object only, whose yaws are chosen so that it holds.
    Turn,
    /// Not here: it speaks of sizes, which do not change.
    Absent,
}

/// What a rule sets, as code; without code it is asked of the evaluator.
struct CodedRule {
    owner: usize,
    sets: Sets,
    value: Option<CodedValue>,
}

/// The upright box around an object.
#[derive(Clone, Copy, Debug, Default)]
struct Span {
    min: [f64; 3],
    max: [f64; 3],
}

impl Span {
    /// That of what is not there: it meets nothing.
    const NONE: Self = Self { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };

    /// Whether two share more than a face.
    fn meets(&self, other: &Self) -> bool {
        (0..3).all(|k| self.min[k] < other.max[k] - TOUCHING && other.min[k] < self.max[k] - TOUCHING)
    }
}

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
    frame: &'a Frame<'a>,
    tolerances: Tolerances,
    numbering: Numbering,
    slots: Slots,
    judges: Vec<Judge>,
    rules: Vec<CodedRule>,
    /// By object: rules to be obeyed when it moves, in order.
    followers: Vec<Vec<usize>>,
    /// By object: its terms, cheap ones first.
    terms_of: Vec<Vec<usize>>,
    /// By object: preferences that speak of it.
    preferences_of: Vec<Vec<usize>>,
    /// Whether preferences count, and which of them is demanded.
    preferring: bool,
    demanded: Vec<usize>,
    /// While preferences are raised against each other: by term, what it is worth that it holds.
    stake: Vec<f64>,
    /// By object: where it was given a place; and what it costs to leave that.
    at_first: Vec<Option<Inputs>>,
    charge: f64,
    /// By object: how large it is as the program means it, and as it lies there, seen from its position.
    scale: Vec<[f64; 3]>,
    size: Vec<[f64; 3]>,
    /// By object: how it leans; `None`: it stands upright. And in the trial: what leaned otherwise.
    leans: Vec<Option<Lean>>,
    leaned: Vec<(usize, [f64; 2])>,
    /// By object: whether the evaluator is asked for the physical rules.
    asked: Vec<bool>,
    /// By object: what it is made of.
    blocks: Vec<Arc<[Block]>>,
    /// By object: where it touches what it stands on, in its frame (x, z).
    feet: Vec<Vec<[f64; 2]>>,
    /// By object: how high above its base things are put on it.
    surface: Vec<f64>,
    /// By object: what it is in, if that carries it.
    container: Vec<Option<usize>>,
    span: Vec<Span>,
    /// Whether P-COLLIDE speaks of a pair.
    collide: Vec<bool>,
    rests: Vec<bool>,
    /// By object: whether P-BOUNDS speaks of it and no term says the same.
    bounded: Vec<bool>,
    rooms: Vec<Room>,
    /// The floor of all rooms, if they share one.
    floor: Option<f64>,
    /// By object: floors that it may stand on.
    levels: Vec<Vec<f64>>,
    /// By object: others that the program asks it to go onto, perhaps.
    carriers: Vec<Vec<usize>>,
    homes: Vec<Home>,
    /// By object: rooms that it must be in and that are no rectangles.
    outlines: Vec<Vec<usize>>,
    /// Objects that are doors, and how far their openings reach beyond them.
    doors: Vec<usize>,
    doorway: f64,
    groups: Vec<PathGroup>,
    course: Course,
    /// How often a move with whatever has to go along paid, and how often it was tried.
    along: [f64; 2],
    /// The same for moves after which paths are planned anew.
    rearranged: [f64; 2],
    /// By object: how unwilling it proved to get out of the way.
    reluctance: Vec<f64>,
    /// Terms that depend on whatever stands around.
    onlookers: Vec<usize>,
    /// Whether paths are looked at yet.
    walking: bool,
    /// How far apart things are put at first, for paths between them (metres).
    air: f64,
    /// Terms that ask for paths, each with its way.
    walks: Vec<(usize, usize)>,
    /// Terms that ask for paths beside other things: those that must hold, and preferences.
    path_terms: Vec<usize>,
    path_preferences: Vec<usize>,
    /// The instance that terms without code are judged on; whether there are such.
    instance: Instance,
    follows: bool,
    /// Objects that have no place yet, and how many those are.
    away: Vec<bool>,
    away_count: usize,
    /// By object: yaws to choose from.
    yaws: Vec<Vec<f64>>,
    /// By object: whether other yaws are worth a try.
    turns: Vec<bool>,
    /// By object: where its centre may be, its extents not counted.
    field: Vec<Field>,
    /// Whether such yaws are drawn at all: at first things stand square.
    skew: bool,
    /// Whether a thing may go onto any other: only where the floor is too small for all of them.
    stacks: bool,
    /// Whether turns in which they are drawn come first, and no room is left for paths at first.
    is_other: bool,
    /// By object: those that its height is set by.
    bases: Vec<Vec<usize>>,
    variables: Variables,
    /// What the program keeps close together.
    clusters: Clusters,
    /// Whether that is most of what stands in the rooms.
    is_clustered: bool,
    /// By object: others that it shares terms with.
    related: Vec<Vec<usize>>,
    movable: Vec<usize>,
    cost: Vec<f64>,
    holds: Vec<bool>,
    weight: Vec<f64>,
    /// What is violated, and by check where it stands in that list.
    bad: Vec<usize>,
    bad_at: Vec<u32>,
    /// Where objects are that no trial moves.
    near: Near,
    /// By object: others that it overlaps.
    hits: Vec<Vec<usize>>,
    /// By object: whether it stands on something else than a floor.
    raised: Vec<bool>,
    raised_count: usize,
    /// By object: what it stands on, if that is not a floor.
    seat: Vec<Option<usize>>,
    moved: Vec<Moved>,
    fresh: Vec<(usize, f64, bool)>,
    /// Room for a list of what is around something.
    around: Vec<usize>,
    stamp: Vec<u32>,
    now: u32,
    /// Work done.
    pub work: u64,
}

/// Truths of code that has run.
struct Ran<'r> {
    code: &'r Coded,
    slots: &'r Slots,
}

impl Truths<f64> for Ran<'_> {
    fn truth(&self, node: NodeId) -> Option<Truth<f64>> {
        self.code.truth(node, self.slots)
    }
}

impl<'a> LocalSearch<'a> {
    /// For an instance in which every object has a pose, though it need not be its place. With `tips`, whatever the program
    /// says of how things lean is searched for; else only what no upright thing fulfils.
    pub fn new(frame: &'a Frame<'a>, world: &World<f64>, numbering: Numbering, tips: bool) -> Self {
        let n = frame.program.objects.len();
        let still = |id: ObjectId| !frame.is_movable(id) && frame.sources[id.0 as usize].is_empty();
        let pose = |id: ObjectId| world.object(id).map(Pose::of);
        let leans = lean::leaning(frame, world, tips);
        let stands = |id: ObjectId| !leans[id.0 as usize];
        let rooms: Vec<Room> = world.prisms().filter_map(|(id, prism)| Room::new(id, prism)).collect();
        let level = rooms.first().map_or(0.0, |room| room.floor);
        let floor = rooms.iter().all(|room| room.floor == level).then_some(level);
        let doors: Vec<usize> = frame.program.allow.doors.iter().map(|door| door.object.0 as usize).collect();
        let mut coder = Coder::new(frame.program, world, &still, &stands);
        let clear_of = |node: &Node, formula: &Formula| {
            Clear::of(node, formula, &doors, world).filter(|clear| !leans[clear.owner])
        };
        let mut judges = Vec::with_capacity(frame.terms.len());
        let mut asked = Vec::new();
        for term in &frame.terms {
            let formula = &term.formula;
            let room = |region: RegionId| rooms.iter().position(|room| room.id == region);
            judges.push(if term.sizes_only {
                Judge::Absent
            } else if let Some((id, room)) =
                setup::inside(formula).filter(|(id, _)| stands(*id)).and_then(|(id, r)| Some((id, room(r)?)))
            {
                Judge::Inside(id.0 as usize, room)
            } else if let Some(clear) = clear_of(formula.root_node(), formula) {
                Judge::Clear(clear)
            } else if let Some(group) = Asked::of(judges.len(), formula, (!term.is_hard()).then_some(term.constraint))
                .filter(|_| floor.is_some() && !rooms.is_empty())
            {
                asked.push(group);
                Judge::Absent
            } else {
                let (code, missing) = coder.partly(formula);
                if missing.is_empty() {
                    Judge::Code(code)
                } else if term.is_hard() && setup::turned(formula).is_some_and(stands) {
                    Judge::Turn
                } else {
                    Judge::Mixed(Mixed::new(formula, code, &missing, clear_of, n))
                }
            });
        }
        let mut groups = Vec::new();
        for (index, (group, terms)) in Asked::together(&asked, world).into_iter().enumerate() {
            terms.iter().for_each(|&t| judges[t] = Judge::Shared(index));
            judges[terms[0]] = Judge::PathGroup(index);
            groups.push(group);
        }
        let mut rules = Vec::new();
        for rule in &frame.rules.list {
            let value = coder.value(&rule.formula);
            rules.push(CodedRule { owner: rule.owner.0 as usize, sets: rule.sets, value });
        }
        let follows = judges.iter().any(|judge| matches!(judge, Judge::Mixed(_)));
        let follows = follows || rules.iter().any(|rule| rule.value.is_none());
        let looks_around = |judge: &Judge| match judge {
            Judge::Clear(_) => true,
            Judge::Mixed(mixed) => mixed.looks_around(),
            _ => false,
        };
        let walks = |judge: &Judge| matches!(judge, Judge::Mixed(mixed) if mixed.walks());
        let terms = |which: &dyn Fn(&Judge) -> bool| -> Vec<usize> {
            (0..judges.len()).filter(|&t| which(&judges[t])).collect()
        };
        let (onlookers, mut path_terms) = (terms(&looks_around), terms(&walks));
        // A search takes paths for granted that preferences ask for; what it finds is held against them.
        let path_preferences = path_terms.extract_if(.., |t| !frame.terms[*t].is_hard()).collect();
        let size: Vec<[f64; 3]> = frame.objects().filter_map(|id| Some(pose(id).ok()?.scale.into())).collect();
        let bodies = || frame.objects().filter_map(|id| Some(&world.object(id).ok()?.body));
        let scope = frame.scope.as_ref();
        let mut collide = vec![false; n * n];
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            collide[i * n + j] = scope.is_some_and(|s| s.collide(ObjectId(i as u32), ObjectId(j as u32)));
        }
        let holds_inside = |id: ObjectId| {
            frame
                .index
                .of_object(id)
                .iter()
                .any(|&t| frame.terms[t].is_hard() && setup::inside_of(&frame.terms[t].formula, id).is_some())
        };
        let mut local = Self {
            tolerances: world.options.tolerances,
            numbering,
            slots: coder.slots(),
            followers: vec![Vec::new(); n],
            terms_of: Vec::new(),
            preferences_of: Vec::new(),
            preferring: false,
            demanded: Vec::new(),
            stake: Vec::new(),
            at_first: vec![None; n],
            charge: 0.0,
            blocks: bodies().map(coded::blocks).collect(),
            feet: bodies().map(|body| setup::feet(&coded::blocks(body), world.options.tolerances.support)).collect(),
            surface: bodies().zip(&size).map(|(body, size)| body.surface.unwrap_or(size[1])).collect(),
            container: frame
                .objects()
                .map(|id| if let Hold::Container(c) = frame.hold(id) { Some(c.0 as usize) } else { None })
                .collect(),
            scale: size.clone(),
            size,
            leans: vec![None; n],
            leaned: Vec::new(),
            asked: vec![false; n],
            span: vec![Span::default(); n],
            collide,
            rests: frame.objects().map(|id| scope.is_some_and(|s| s.support(id) == rules::Support::Rests)).collect(),
            bounded: frame
                .objects()
                .map(|id| scope.is_some_and(|s| s.bounds(id)) && !rooms.is_empty() && !holds_inside(id))
                .collect(),
            floor,
            levels: Vec::new(),
            carriers: frame.objects().map(|id| setup::carriers(frame, id)).collect(),
            yaws: Vec::new(),
            turns: Vec::new(),
            field: Vec::new(),
            skew: false,
            stacks: false,
            is_other: false,
            bases: frame.sources.iter().map(|l| l.iter().map(|o| o.0 as usize).collect()).collect(),
            variables: Variables::new(frame, world),
            related: frame.related.iter().map(|l| l.iter().map(|(o, _)| o.0 as usize).collect()).collect(),
            clusters: Clusters::default(),
            is_clustered: false,
            movable: (0..n).filter(|&i| frame.is_movable(ObjectId(i as u32))).collect(),
            cost: vec![0.0; numbering.len()],
            holds: vec![true; numbering.len()],
            weight: vec![1.0; numbering.len()],
            bad: Vec::new(),
            bad_at: vec![u32::MAX; numbering.len()],
            near: Near::new(rooms.iter().map(|room| room.field).reduce(Field::join), n),
            hits: vec![Vec::new(); n],
            raised: vec![false; n],
            raised_count: 0,
            seat: vec![None; n],
            homes: Vec::new(),
            outlines: Vec::new(),
            doors,
            doorway: 2.0 * world.options.eta + world.options.tolerances.door,
            walking: false,
            air: 0.0,
            onlookers,
            path_terms,
            path_preferences,
            instance: Instance::new(world.clone()),
            follows,
            walks: judges
                .iter()
                .enumerate()
                .filter_map(|(t, judge)| if let Judge::PathGroup(group) = judge { Some((t, *group)) } else { None })
                .collect(),
            groups,
            course: Course::default(),
            along: [0.0; 2],
            rearranged: [0.0; 2],
            reluctance: vec![0.0; n],
            away: vec![false; n],
            away_count: 0,
            moved: Vec::new(),
            fresh: Vec::new(),
            around: Vec::new(),
            stamp: vec![0; numbering.len()],
            now: 0,
            work: 0,
            rooms,
            rules,
            judges,
            frame,
        };
        local.begin_to_lean(&leans, world);
        // What the program fixes is so from here on.
        for rule in 0..local.rules.len() {
            local.obey(rule, 0);
        }
        local.moved.clear();
        local.leaned.clear();
        local.followers = frame.objects().map(|id| local.followers_of(id)).collect();
        local.terms_of = (0..n).map(|i| local.sorted_terms(i, true)).collect();
        local.preferences_of = (0..n).map(|i| local.sorted_terms(i, false)).collect();
        local.know_variables();
        for id in frame.objects() {
            let domain = local.yaws_of(world, id);
            let told = frame.index.of_object(id).iter().any(|&t| matches!(local.judges[t], Judge::Turn));
            local.turns.push(!frame.fixed(id).rot && !told);
            local.yaws.push(domain);
            let field = local.field_of(id);
            local.field.push(field);
            local.levels.push(local.levels_of(id));
            local.outlines.push(local.outlines_of(id));
            local.homes.push(local.home_of(id, field, world));
        }
        for at in 0..local.movable.len() {
            local.heed_followers(local.movable[at]);
        }
        local.clusters = local.find_clusters();
        local.is_clustered = 2 * local.clusters.of.iter().flatten().count() > local.movable.len();
        local
    }

    /// The layout as changes of the search proper.
    pub fn changes(&self) -> Vec<Change> {
        let pose = |id: ObjectId| {
            let [x, y, z, yaw, ..] = self.slots.get(id);
            let scale = self.scale[id.0 as usize].into();
            let [tilt, roll] = self.angles(id.0 as usize);
            Pose { rot: Vec3::new(tilt, yaw, roll), pos: Vec3::new(x, y, z), scale }
        };
        let objects = self.frame.objects().map(|id| Change::Object(id, pose(id)));
        objects.chain(self.values().map(|(id, value)| Change::Variable(id, value))).collect()
    }
}
