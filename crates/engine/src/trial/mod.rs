//! A layout under trial moves, judged fast: poses are a row of floats, formulas are code (see [`scenelang_verify::coded`]),
//! parts are boxes, and a trial looks only at what the moved objects touch. What has no code is asked of the evaluator
//! (`evaluator`), so a term without code costs its own price and no more.
//!
//! A trial is begun by [`Trial::go`] and its like, judged by [`Trial::judge`], and then kept or undone. Which trials are worth
//! making is decided elsewhere; whatever comes of them is judged by the evaluator in the end.

mod clear;
mod evaluator;
mod judge;
mod lean;
mod moves;
mod near;
mod paths;
mod physical;
mod rooms;
mod seats;
mod setup;
mod swing;
mod variables;

use crate::candidate::Change;
use crate::frame::checks::Numbering;
use crate::frame::rules::Sets;
use crate::frame::{Frame, Hold};
use crate::pose::Pose;
pub use clear::Clear;
use evaluator::Instance;
pub use evaluator::Mixed;
use lean::Lean;
pub use moves::{Moved, carried};
use near::Near;
pub use paths::{PathGroup, Plans};
pub use rooms::{Field, RoomBox, Stretch, Wall, stretches};
use scenelang_lang::program::ObjectId;
use scenelang_layout::Vec3;
use scenelang_verify::coded::{self, Block, Coded, CodedValue, Coder, INPUTS, Slots};
use scenelang_verify::{Tolerances, World, rules};
use seats::Seats;
use setup::Known;
pub use setup::inside_of;
use std::sync::Arc;
use swing::Reach;
use variables::Variables;

/// One pose of an object: see [`Slots`].
pub type Inputs = [f64; INPUTS];

/// Overlaps of less than this are rounding (metres).
const TOUCHING: f64 = 1e-7;

/// How a term is judged here.
pub enum Judge {
    /// An object is in a room.
    Inside(usize, usize),
    /// The space beside an object is free.
    Clear(Clear),
    /// There are paths.
    PathGroup(usize),
    /// It asks for one of the paths that another term answers for.
    Shared(usize),
    Code(Coded),
    /// By its code as far as that goes, and by the evaluator.
    Mixed(Mixed),
    /// It speaks of the turn of one object only, whose yaws are chosen so that it holds.
    Turn,
    /// Not here: it speaks of sizes, which do not change.
    Absent,
}

impl Judge {
    /// Whether what stands around may change the verdict though no object of the term moves.
    fn looks_around(&self) -> bool {
        match self {
            Self::Clear(_) => true,
            Self::Mixed(mixed) => mixed.looks_around(),
            _ => false,
        }
    }
}

/// What a rule sets, as code; without code it is asked of the evaluator.
pub struct CodedRule {
    /// Whose.
    pub owner: usize,
    sets: Sets,
    value: Option<CodedValue>,
}

/// The upright box around an object.
#[derive(Clone, Copy, Debug, Default)]
pub struct Span {
    /// The least x, y and z (metres).
    pub min: [f64; 3],
    /// The greatest.
    pub max: [f64; 3],
}

impl Span {
    /// That of what is not there: it meets nothing.
    const NONE: Self = Self { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };

    /// Whether two share more than a face.
    pub fn meets(&self, other: &Self) -> bool {
        let on = |k: usize| (self.min[k] < other.max[k] - TOUCHING) & (other.min[k] < self.max[k] - TOUCHING);
        // Most are apart on the floor; to look at both axes at once is faster than to decide after each.
        on(0) & on(2) && on(1)
    }
}

/// A layout under trial moves.
pub struct Trial<'a> {
    /// What stays the same.
    pub frame: &'a Frame<'a>,
    /// How checks are numbered.
    pub numbering: Numbering,
    tolerances: Tolerances,
    slots: Slots,
    /// By term.
    pub judges: Vec<Judge>,
    /// Equations that set something, in the order of the frame.
    pub rules: Vec<CodedRule>,
    /// By object: rules to be obeyed when it moves, in order.
    pub followers: Vec<Vec<usize>>,
    /// By object: its terms, cheap ones first.
    pub terms_of: Vec<Vec<usize>>,
    /// By object: preferences that speak of it.
    pub preferences_of: Vec<Vec<usize>>,
    /// Whether preferences count.
    pub preferring: bool,
    /// By term: whether it counts as violated where it fails, though it is a preference.
    demanded: Vec<bool>,
    /// By object: how large it is as the program means it.
    scale: Vec<[f64; 3]>,
    /// By object: how large it is as it lies there, seen from its position (metres).
    pub size: Vec<[f64; 3]>,
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
    pub surface: Vec<f64>,
    /// By object: what it is in, if that carries it.
    pub container: Vec<Option<usize>>,
    /// By object: the upright box around it.
    pub span: Vec<Span>,
    /// Whether P-COLLIDE speaks of a pair.
    collide: Vec<bool>,
    /// By object: whether it must rest on something.
    pub rests: Vec<bool>,
    /// By object: whether P-BOUNDS speaks of it and no term says the same.
    pub bounded: Vec<bool>,
    /// The regions.
    pub rooms: Vec<RoomBox>,
    /// The floor of all rooms, if they share one.
    floor: Option<f64>,
    /// Objects that are doors, and how far their openings reach beyond them.
    pub doors: Vec<usize>,
    doorway: f64,
    /// Paths that are planned together.
    pub groups: Vec<PathGroup>,
    /// Where there is floor for paths, as last worked out.
    floors: Vec<paths::Floor>,
    /// By object: how much more is walked round it, since it proved unwilling to get out of the way.
    pub reluctance: Vec<f64>,
    /// Terms that depend on whatever stands around.
    onlookers: Vec<usize>,
    /// Terms that ask for paths, each with its group.
    pub walks: Vec<(usize, usize)>,
    /// Terms that ask for paths beside other things: those that must hold.
    pub path_terms: Vec<usize>,
    /// The same of preferences.
    path_preferences: Vec<usize>,
    /// By object: what opens of it.
    reaches: Vec<Option<Reach>>,
    /// The instance that terms without code are judged on; whether there are such.
    instance: Instance,
    follows: bool,
    /// By object: whether it has no place yet.
    pub away: Vec<bool>,
    /// How many have none.
    pub away_count: usize,
    /// By object: yaws to choose from.
    pub yaws: Vec<Vec<f64>>,
    /// By object: whether other yaws are worth a try.
    pub turns: Vec<bool>,
    /// Decision variables.
    pub variables: Variables,
    /// Objects whose pose is not fixed.
    pub movable: Vec<usize>,
    /// By check: what it costs, without its weight.
    pub cost: Vec<f64>,
    /// By check: whether it holds.
    pub holds: Vec<bool>,
    /// By check: how much it counts.
    pub weight: Vec<f64>,
    /// What is violated.
    pub bad: Vec<usize>,
    /// By check: where it stands in that list; `u32::MAX`: it does not.
    bad_at: Vec<u32>,
    /// Where objects are that no trial moves.
    pub near: Near,
    /// By object: others that it overlaps.
    pub hits: Vec<Vec<usize>>,
    /// By object: whether it stands on something else than a floor.
    raised: Vec<bool>,
    raised_count: usize,
    /// What stands on what, if that is not a floor.
    seats: Seats,
    /// What has moved in the trial, and where it was.
    pub moved: Vec<Moved>,
    /// By object: whether it is among these.
    is_moved: Vec<bool>,
    /// What the trial changed: check, cost, whether it holds.
    pub fresh: Vec<(usize, f64, bool)>,
    /// Room for a list of what is around something.
    around: Vec<usize>,
    stamp: Vec<u32>,
    now: u32,
    /// Work done.
    pub work: u64,
}

/// The height of the floors, if all rooms have the same.
fn common_floor(rooms: &[RoomBox]) -> Option<f64> {
    let level = rooms.first().map_or(0.0, |room| room.floor);
    rooms.iter().all(|room| room.floor == level).then_some(level)
}

impl<'a> Trial<'a> {
    /// For an instance in which every object has a pose, though it need not be its place. With `tips`, how things lean may
    /// change wherever the program speaks of it; else only where no upright thing fulfils what it says.
    pub fn new(frame: &'a Frame<'a>, world: &World<f64>, numbering: Numbering, tips: bool) -> Self {
        let n = frame.program.objects.len();
        let still = |id: ObjectId| !frame.is_movable(id) && frame.sources[id.0 as usize].is_empty();
        let leans = lean::leaning(frame, world, tips);
        let stands = |id: ObjectId| !leans[id.0 as usize];
        let rooms: Vec<RoomBox> = world.prisms().filter_map(|(id, prism)| RoomBox::new(id, prism)).collect();
        let floor = common_floor(&rooms);
        let doors: Vec<usize> = frame.program.allow.doors.iter().map(|door| door.object.0 as usize).collect();
        let mut coder = Coder::new(frame.program, world, &still, &stands);
        let plans = floor.is_some() && !rooms.is_empty();
        let reaches = Reach::of_all(world, n);
        let has_panels = |i: usize| !leans[i] && reaches[i].as_ref().is_some_and(Reach::has_panels);
        let known = Known { world, rooms: &rooms, doors: &doors, stands: &stands, has_panels: &has_panels, plans };
        let (judges, groups) = setup::judges(frame, &known, &mut coder);
        let coded = |rule: &crate::frame::rules::Rule| CodedRule {
            owner: rule.owner.0 as usize,
            sets: rule.sets,
            value: coder.value(&rule.formula),
        };
        let rules: Vec<CodedRule> = frame.rules.list.iter().map(coded).collect();
        let follows = judges.iter().any(|judge| matches!(judge, Judge::Mixed(_)));
        let follows = follows || rules.iter().any(|rule| rule.value.is_none());
        let terms = |which: &dyn Fn(&Judge) -> bool| -> Vec<usize> {
            (0..judges.len()).filter(|&t| which(&judges[t])).collect()
        };
        let onlookers = terms(&Judge::looks_around);
        let mut path_terms = terms(&|judge| matches!(judge, Judge::Mixed(mixed) if mixed.walks()));
        // Paths that preferences ask for are taken for granted; what is found is held against them.
        let path_preferences = path_terms.extract_if(.., |t| !frame.terms[*t].is_hard()).collect();
        let walks = |(t, judge): (usize, &Judge)| if let Judge::PathGroup(g) = judge { Some((t, *g)) } else { None };
        let pose = |id: ObjectId| world.object(id).map(Pose::of);
        let size: Vec<[f64; 3]> = frame.objects().filter_map(|id| Some(pose(id).ok()?.scale.into())).collect();
        let bodies = || frame.objects().filter_map(|id| Some(&world.object(id).ok()?.body));
        let bounded = |id: ObjectId| !rooms.is_empty() && setup::is_bounded(frame, id);
        let container = |id: ObjectId| if let Hold::Container(c) = frame.hold(id) { Some(c.0 as usize) } else { None };
        let rests = |id: ObjectId| frame.scope.as_ref().is_some_and(|s| s.support(id) == rules::Support::Rests);
        let trial = Self {
            tolerances: world.options.tolerances,
            numbering,
            slots: coder.slots(),
            followers: vec![Vec::new(); n],
            terms_of: Vec::new(),
            preferences_of: Vec::new(),
            preferring: false,
            demanded: vec![false; frame.terms.len()],
            blocks: bodies().map(coded::blocks).collect(),
            feet: bodies().map(|body| setup::feet(&coded::blocks(body), world.options.tolerances.support)).collect(),
            surface: bodies().zip(&size).map(|(body, size)| body.surface.unwrap_or(size[1])).collect(),
            container: frame.objects().map(container).collect(),
            scale: size.clone(),
            size,
            leans: vec![None; n],
            leaned: Vec::new(),
            asked: vec![false; n],
            span: vec![Span::default(); n],
            collide: setup::collide(frame),
            rests: frame.objects().map(rests).collect(),
            bounded: frame.objects().map(bounded).collect(),
            floor,
            yaws: Vec::new(),
            turns: Vec::new(),
            variables: Variables::new(frame, world),
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
            seats: Seats::new(n),
            is_moved: vec![false; n],
            doors,
            doorway: 2.0 * world.options.eta + world.options.tolerances.door,
            reluctance: vec![0.0; n],
            onlookers,
            path_terms,
            path_preferences,
            reaches,
            instance: Instance::new(world.clone()),
            follows,
            walks: judges.iter().enumerate().filter_map(walks).collect(),
            groups,
            floors: Vec::new(),
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
        trial.ready(&leans, world)
    }

    /// With all that follows from its terms and rules.
    fn ready(mut self, leans: &[bool], world: &World<f64>) -> Self {
        self.begin_to_lean(leans, world);
        // What the program fixes is so from here on.
        for rule in 0..self.rules.len() {
            self.obey(rule, 0);
        }
        self.moved.clear();
        self.is_moved.fill(false);
        self.leaned.clear();
        let n = self.size.len();
        self.followers = self.frame.objects().map(|id| self.followers_of(id)).collect();
        self.terms_of = (0..n).map(|i| self.sorted_terms(i, true)).collect();
        self.preferences_of = (0..n).map(|i| self.sorted_terms(i, false)).collect();
        self.know_variables();
        self.know_turns(world);
        self
    }

    /// The layout as changes of a candidate.
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
