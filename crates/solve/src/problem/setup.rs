//! Before the search: draws, fixed outlines, sizes that constraints ask for, and the world that the search starts from.

use crate::problem::draws;
use crate::problem::pose::Pose;
use crate::problem::{Options, Problem, opens, values};
use crate::search::least_squares::{Targets, least_squares};
use scenelang_engine::candidate::{Candidate, Change};
use scenelang_engine::frame::Frame;
use scenelang_engine::frame::terms::{self, Term};
use scenelang_lang::Program;
use scenelang_lang::program::{ObjectId, Owner, Pinned, RegionId, VariableId, VariableKind};
use scenelang_layout::{DecisionValue, Layout, Part, Placement, Polygon, RegionPlacement, Vec3};
use scenelang_verify::{World, evaluate, rules::Scope};
use smol_str::SmolStr;
use std::collections::{BTreeMap, BTreeSet};

/// The size of an object that nobody knows anything about (metres).
const UNKNOWN: f64 = 0.5;
/// A region before it is sized (metres).
const REGION: [f64; 3] = [4.0, 2.7, 4.0];

/// What a search starts from.
pub(crate) struct Setup<'a> {
    /// What stays the same.
    pub frame: Frame<'a>,
    /// The instance; objects without a place stand anywhere.
    pub world: World<f64>,
    /// A layout with everything that the search does not change: parts, surfaces, outlines, draws.
    pub layout: Layout,
    /// Objects that have a place already, and where.
    pub given: Vec<(ObjectId, Option<Pose>)>,
    /// What the user should know.
    pub warnings: Vec<String>,
}

/// Prepares a search.
pub(crate) fn setup<'a>(problem: &Problem<'a>, options: &Options) -> Setup<'a> {
    let program = problem.program;
    let mut warnings = Vec::new();
    let (draws, refused) = draws::draw(program, options.seed);
    warnings.extend(
        refused.into_iter().map(|key| format!("the bounds of the draw `{key}` are undefined or in the wrong order")),
    );
    let mut layout = Layout {
        scene: problem.start.scene.clone(),
        seed: Some(options.seed),
        incomplete: false,
        objects: objects(problem),
        categories: categories(program),
        regions: regions(problem),
        variables: variables(problem),
        draws,
    };
    let terms = terms::split(program);
    values::choose(program, &mut layout, options);
    outline(program, &mut layout, options, &mut warnings);
    size(program, &terms, &mut layout, options, &mut warnings);
    let world = World::<f64>::new(program, &layout, &options.judge);
    let scope = options.judge.physics.then(|| Scope::new(&world));
    let terms = terms.into_iter().chain(opens::terms(&world)).collect();
    let mut frame = Frame::new(program, terms, scope, |id| layout.objects[id.0 as usize].1.scale);
    let known = |id: &&ObjectId| {
        let object = program.objects.get(id.0 as usize);
        problem.placed.object(**id) && object.is_some_and(|o| problem.start.object(&o.name).is_some())
    };
    options.locked.iter().filter(known).for_each(|id| frame.lock(*id));
    let given = frame
        .objects()
        .filter(|id| problem.placed.object(*id))
        .filter_map(|id| problem.start.object(frame.name(id)).map(|p| (id, Some(pose(p)))))
        .collect();
    Setup { world, layout, given, warnings, frame }
}

fn pose(p: &Placement) -> Pose {
    Pose { pos: p.pos, rot: p.rot, scale: p.scale }
}

fn objects(problem: &Problem<'_>) -> Vec<(SmolStr, Placement)> {
    let known = |index: usize, name: &str| {
        let found = problem.start.object(name).cloned();
        let mut placement = found.unwrap_or(Placement {
            pos: Vec3::zeros(),
            rot: Vec3::zeros(),
            scale: Vec3::repeat(UNKNOWN),
            parts: Vec::new(),
            surface: None,
            joints: Vec::new(),
        });
        if !problem.placed.object(ObjectId(index as u32)) {
            (placement.pos, placement.rot) = (Vec3::zeros(), Vec3::zeros());
        }
        placement
    };
    let named = problem.program.objects.iter().enumerate();
    named.map(|(i, o)| (o.name.clone(), known(i, &o.name))).collect()
}

fn categories(program: &Program) -> BTreeMap<SmolStr, SmolStr> {
    let stated = program.objects.iter().filter(|object| !object.category.is_empty());
    stated.map(|object| (object.name.clone(), object.category.as_str().into())).collect()
}

fn regions(problem: &Problem<'_>) -> Vec<(SmolStr, RegionPlacement)> {
    let open = RegionPlacement { pos: Vec3::zeros(), rot: Vec3::zeros(), scale: Vec3::from(REGION), vertices: None };
    let known = |index: usize, name: &str| {
        let kept = problem.placed.region(RegionId(index as u32));
        problem.start.region(name).filter(|_| kept).cloned().unwrap_or_else(|| open.clone())
    };
    let named = problem.program.regions.iter().enumerate();
    named.map(|(i, r)| (r.name.clone(), known(i, &r.name))).collect()
}

fn variables(problem: &Problem<'_>) -> Vec<(SmolStr, DecisionValue)> {
    let warm = problem.placed != crate::problem::Placed::None;
    let value = |name: &str, kind: VariableKind| {
        let zero = match kind {
            VariableKind::Number | VariableKind::Degree => DecisionValue::Number(0.0),
            VariableKind::Bool => DecisionValue::Bool(false),
            VariableKind::Vector | VariableKind::Rotation => DecisionValue::Triple([0.0; 3]),
        };
        let old = problem.start.variables.iter().find(|(n, _)| n == name).map(|(_, v)| *v);
        old.filter(|v| warm && std::mem::discriminant(v) == std::mem::discriminant(&zero)).unwrap_or(zero)
    };
    problem.program.variables.iter().map(|v| (v.name.clone(), value(&v.name, v.kind))).collect()
}

/// Sets what the program assigns to regions, outlines included.
fn outline(program: &Program, layout: &mut Layout, options: &Options, warnings: &mut Vec<String>) {
    for pin in &program.pins {
        let Owner::Region(id) = pin.owner else { continue };
        let world = World::<f64>::new(program, layout, &options.judge);
        let values = pin.values.iter().filter_map(|f| match evaluate(f, &world) {
            Ok(scenelang_verify::Value::Vector(v) | scenelang_verify::Value::Rotation(v)) => Some(v.value()),
            _ => None,
        });
        let values: Vec<Vec3> = values.collect();
        let (Some(&first), region) = (values.first(), &mut layout.regions[id.0 as usize].1) else { continue };
        match pin.property {
            Pinned::Pos => region.pos = first,
            Pinned::Rot => region.rot = first,
            Pinned::Scale => region.scale = first,
            Pinned::Vertices => {
                let corners: Vec<[f64; 2]> = values.iter().map(|v| [v.x, v.z]).collect();
                match Polygon::new(&corners) {
                    Ok(_) => region.vertices = Some(corners),
                    Err(why) => {
                        let name = &program.regions[id.0 as usize].name;
                        warnings
                            .push(format!("`{name}` cannot have this outline and is treated as a rectangle: {why}"));
                    }
                }
            }
        }
    }
    for (_, region) in &mut layout.regions {
        surround(region);
    }
}

/// Where a region has an outline, its rectangle has no say: it is the one around the outline, whatever the program
/// assigns (often zeros).
fn surround(region: &mut RegionPlacement) {
    let Some(corners) = region.vertices.as_ref().filter(|corners| !corners.is_empty()) else { return };
    for (axis, k) in [(0, 0), (2, 1)] {
        let least = corners.iter().map(|c| c[k]).fold(f64::INFINITY, f64::min);
        let most = corners.iter().map(|c| c[k]).fold(f64::NEG_INFINITY, f64::max);
        if most > least {
            region.pos[axis] = (least + most) / 2.0;
            region.scale[axis] = most - least;
        }
    }
}

/// Gives objects the sizes that are assigned, or that constraints on sizes alone ask for. Parts stretch along.
fn size(program: &Program, terms: &[Term], layout: &mut Layout, options: &Options, warnings: &mut Vec<String>) {
    let speaking: Vec<Term> = terms.iter().filter(|t| t.sizes_only && t.is_hard()).cloned().collect();
    let mut resized: BTreeSet<ObjectId> = speaking.iter().flat_map(|t| t.objects.iter().copied()).collect();
    let targets: Vec<ObjectId> = resized.iter().copied().collect();
    for pin in &program.pins {
        if let (Owner::Object(id), Pinned::Scale) = (pin.owner, pin.property) {
            resized.insert(id);
        }
    }
    if resized.is_empty() {
        return;
    }
    let frame = Frame::new(program, speaking, None, |id| layout.objects[id.0 as usize].1.scale);
    let world = World::<f64>::new(program, layout, &options.judge);
    let mut state = Candidate::new(&frame, world);
    let all: Vec<Change> = frame.objects().map(|id| Change::Object(id, state.pose(id))).collect();
    if state.attempt(&all, f64::INFINITY).is_some() {
        state.keep_sizes();
    }
    // Decision variables that they speak of go along.
    let terms = targets.iter().flat_map(|o| frame.index.of_object(*o));
    let mut variables: Vec<VariableId> = terms.flat_map(|&t| frame.terms[t].variables.iter().copied()).collect();
    variables.sort_unstable();
    variables.dedup();
    least_squares(&mut state, &Targets { sizes: targets, variables, regions: Vec::new() });
    for id in resized {
        let (name, placement) = &mut layout.objects[id.0 as usize];
        let next = state.pose(id).scale;
        if (next - placement.scale).amax() > 1e-9 && next.iter().all(|c| c.is_finite() && *c > 0.0) {
            let had_parts = !placement.parts.is_empty();
            stretch(placement, next);
            if had_parts && placement.parts.is_empty() {
                warnings.push(format!(
                    "the size of `{name}` was changed; its parts cannot be stretched that way, so its box is used"
                ));
            }
        }
    }
}

/// Gives an object another size, and its parts with it; where these do not stretch they are dropped.
fn stretch(placement: &mut Placement, scale: Vec3) {
    let by = scale.component_div(&placement.scale);
    let even = (by.x - by.z).abs() < 1e-9;
    let stretched = placement.parts.iter().map(|part| match part {
        Part::Box { pos, size, rot } if *rot == Vec3::zeros() => {
            Some(Part::Box { pos: pos.component_mul(&by), size: size.component_mul(&by), rot: *rot })
        }
        Part::Cylinder { pos, radius, height, rot } if *rot == Vec3::zeros() && even => Some(Part::Cylinder {
            pos: pos.component_mul(&by),
            radius: radius * by.x,
            height: height * by.y,
            rot: *rot,
        }),
        Part::Hull { points } => Some(Part::Hull { points: points.iter().map(|p| p.component_mul(&by)).collect() }),
        _ => None,
    });
    placement.parts = stretched.collect::<Option<Vec<Part>>>().unwrap_or_default();
    placement.surface = placement.surface.map(|s| s * by.y);
    placement.joints = match placement.parts.is_empty() {
        true => Vec::new(),
        false => placement.joints.iter().map(|joint| joint.stretched(&by)).collect(),
    };
    placement.scale = scale;
}
