//! One instance of a program: where its objects and regions are, what its variables and draws are.
//!
//! Positions, rotations, sizes and variables are held in any [`Number`], so that formulas can be differentiated; beside
//! them stand the bodies in plain floats, which geometry measures. Whatever the layout lacks is missing here, too.

use crate::eval::{Cause, Value};
use crate::navigation::Walks;
use crate::number::{Algebra, Number};
use crate::opening::Habits;
use crate::tolerances::Options;
use crate::vector::{M3, V3};
use nalgebra::Matrix3;
use rustc_hash::FxHashMap;
use scenelang_lang::program::{Allowances, DrawId, ObjectId, Program, RegionId, VariableId, VariableKind};
use scenelang_layout::convex::{self, local_solid, parts_fill_box};
use scenelang_layout::{
    Aabb, Convex, Geometry, Joint, Layout, Moving, Obb, Placement, Prism, RegionPlacement, Vec3, model, rotation,
};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// An instance of a program.
#[derive(Clone, Debug)]
pub struct World<N: Algebra> {
    /// By [`ObjectId`].
    pub(crate) objects: Vec<Option<ObjectInstance<N>>>,
    /// By [`RegionId`].
    pub(crate) regions: Vec<Option<RegionInstance<N>>>,
    /// By [`VariableId`].
    pub(crate) variables: Vec<Result<Value<N>, Cause>>,
    /// By [`DrawId`].
    pub(crate) draws: Vec<Result<f64, Cause>>,
    /// What the program says about the physical rules, and its doors.
    pub(crate) allow: Allowances,
    /// What it says that matters to what opens.
    pub(crate) habits: Arc<Habits>,
    /// Tolerances and what a solid is.
    pub options: Options,
    /// What is known about walking in this instance.
    pub(crate) walks: Walks,
}

#[derive(Clone, Debug)]
pub struct ObjectInstance<N: Algebra> {
    /// Centre of the bottom face (metres).
    pub pos: V3<N>,
    /// Euler triple (degrees).
    pub rot: V3<N>,
    /// Full extents (metres).
    pub scale: V3<N>,
    /// Its right, up and front.
    pub axes: M3<N>,
    /// Its body in plain floats.
    pub body: Body,
}

/// The body of an object, in plain floats.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its box.
    pub obb: Obb,
    /// Centre of the bottom face.
    pub pos: Vec3,
    /// Its parts in its own frame, where they count; else it is its box.
    parts: Option<Vec<Convex>>,
    /// Height of the support surface above the base, where one is declared and the parts count.
    pub surface: Option<f64>,
    /// What of it can be opened, where the parts count.
    joints: Arc<[Joint]>,
    solid: OnceLock<Vec<Convex>>,
    /// The solid as it was elsewhere, whose memory the next one takes.
    spare: Spare,
    aabb: OnceLock<Aabb>,
    moving: OnceLock<Vec<Moving>>,
}

impl Body {
    fn new(placement: &Placement, geometry: Geometry) -> Self {
        let none = Arc::default();
        let has_parts = geometry == Geometry::Parts && !placement.parts.is_empty() && parts_fill_box(placement);
        let parts = has_parts.then(|| local_solid(placement, geometry));
        let joints = if has_parts { joints(placement) } else { none };
        Self {
            obb: Obb::from_placement(placement),
            pos: placement.pos,
            parts,
            surface: placement.surface.filter(|_| has_parts),
            joints,
            solid: OnceLock::new(),
            spare: Spare::default(),
            aabb: OnceLock::new(),
            moving: OnceLock::new(),
        }
    }
    /// A cube of one metre at the origin, where no body is looked at.
    pub(crate) fn unit() -> Self {
        let (pos, rot, scale) = (Vec3::zeros(), Vec3::zeros(), Vec3::repeat(1.0));
        let placement = Placement { pos, rot, scale, parts: Vec::new(), surface: None, joints: Vec::new() };
        Self::new(&placement, Geometry::Box)
    }
    /// Whether it is more than its box.
    pub fn has_parts(&self) -> bool {
        self.parts.is_some()
    }
    /// Its parts in its own frame, the middle of its bottom face the origin, where they count.
    pub(crate) fn parts(&self) -> Option<&[Convex]> {
        self.parts.as_deref()
    }
    /// What of it can be opened.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }
    /// What each of its joints moves, in its own frame.
    pub fn moving_in_frame(&self) -> Vec<Moving> {
        self.all_moving(&Matrix3::identity(), &Vec3::zeros())
    }
    fn all_moving(&self, axes: &Matrix3<f64>, pos: &Vec3) -> Vec<Moving> {
        let parts = self.parts.as_deref().unwrap_or_default();
        let of = |joint: &Joint| Moving::new(joint, joint.parts.iter().filter_map(|&i| parts.get(i)), axes, pos);
        self.joints.iter().map(of).collect()
    }
    /// What one of its joints moves, in the world.
    pub(crate) fn moving(&self, joint: usize) -> Option<&Moving> {
        let all = self.moving.get_or_init(|| self.all_moving(&self.obb.axes, &self.pos));
        all.get(joint)
    }
    /// Its solid in the world: its parts, or its box.
    pub fn solid(&self) -> &[Convex] {
        self.solid.get_or_init(|| match &self.parts {
            Some(parts) => self.spare.filled(parts, &self.obb.axes, &self.pos),
            None => vec![Convex::from_box(&self.obb)],
        })
    }
    /// Its solid with the upright box around that, as [`convex::nearest_of`] takes it: exactly what its parts fill.
    pub(crate) fn bounded(&self) -> (&[Convex], Aabb) {
        let solid = self.solid();
        (solid, if self.has_parts() { self.aabb() } else { convex::aabb(solid) })
    }
    /// The upright box around its solid.
    pub fn aabb(&self) -> Aabb {
        *self.aabb.get_or_init(|| match &self.parts {
            Some(_) => convex::aabb(self.solid()),
            None => self.obb.aabb(),
        })
    }
    /// Puts it elsewhere.
    fn place(&mut self, pos: Vec3, rot: Vec3, scale: Vec3) {
        let axes = rotation::matrix(rot);
        let half = scale / 2.0;
        self.obb = Obb { center: pos + axes.column(1) * half.y, axes, half };
        self.pos = pos;
        if let (Some(old), Some(_)) = (self.solid.take(), &self.parts) {
            self.spare.keep(old);
        }
        self.aabb = OnceLock::new();
        self.moving = OnceLock::new();
    }
    /// The height of its lowest point.
    pub fn lowest(&self) -> f64 {
        self.aabb().min.y
    }
}

/// Bodies that are not needed any more.
#[derive(Debug, Default)]
struct Spare(Mutex<Vec<Convex>>);

impl Clone for Spare {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Spare {
    fn keep(&mut self, old: Vec<Convex>) {
        *self.0.get_mut().unwrap_or_else(PoisonError::into_inner) = old;
    }
    /// Parts elsewhere, in this memory.
    fn filled(&self, parts: &[Convex], axes: &Matrix3<f64>, by: &Vec3) -> Vec<Convex> {
        let mut solid = std::mem::take(&mut *self.0.lock().unwrap_or_else(PoisonError::into_inner));
        if solid.len() != parts.len() {
            return parts.iter().map(|part| part.moved(axes, by)).collect();
        }
        for (part, old) in parts.iter().zip(&mut solid) {
            part.moved_over(old, axes, by);
        }
        solid
    }
}

/// The joints of an object that move parts which it has.
fn joints(placement: &Placement) -> Arc<[Joint]> {
    let has = |joint: &&Joint| !joint.parts.is_empty() && joint.parts.iter().all(|&i| i < placement.parts.len());
    placement.joints.iter().filter(has).cloned().collect()
}

impl<N: Number> ObjectInstance<N> {
    fn new(placement: &Placement, geometry: Geometry) -> Self {
        let rot = V3::constant(&placement.rot);
        Self {
            pos: V3::constant(&placement.pos),
            rot,
            scale: V3::constant(&placement.scale),
            axes: M3::rotation(rot),
            body: Body::new(placement, geometry),
        }
    }

    /// How a point of the world that is fixed to this object moves with it. Parts keep their size; a box grows.
    pub(crate) fn attached(&self, point: &Vec3) -> V3<N> {
        let local = self.body.obb.axes.tr_mul(&(point - self.body.pos));
        if self.body.has_parts() {
            return self.pos + self.axes.turn_constant(&local);
        }
        self.pos + self.axes.turn(self.stretched(&local))
    }

    /// As [`Self::attached`], of a point of the box whether or not the object has parts.
    pub(crate) fn attached_to_box(&self, point: &Vec3) -> V3<N> {
        let local = self.body.obb.axes.tr_mul(&(point - self.body.pos));
        self.pos + self.axes.turn(self.stretched(&local))
    }

    fn stretched(&self, local: &Vec3) -> V3<N> {
        let half = self.body.obb.half;
        V3(std::array::from_fn(|i| self.scale.0[i].scale(local[i] / (2.0 * half[i]))))
    }
}

impl<N: Algebra> ObjectInstance<N> {
    /// Centre of the box.
    pub fn center(&self) -> V3<N> {
        self.pos + self.axes.0[1].times(self.scale.0[1].scale(0.5))
    }

    /// Half the extent of the box along the world's axes.
    pub fn reach(&self) -> V3<N> {
        let along = |i: usize| {
            let part = |axis: usize| self.axes.0[axis].0[i].abs() * self.scale.0[axis].scale(0.5);
            part(0) + part(1) + part(2)
        };
        V3([along(0), along(1), along(2)])
    }
}

#[derive(Clone, Debug)]
pub struct RegionInstance<N: Algebra> {
    /// Centre of the rectangle's floor (metres).
    pub pos: V3<N>,
    /// Euler triple (degrees); only y turns it.
    pub rot: V3<N>,
    /// Full extents (metres).
    pub scale: V3<N>,
    /// Whether the layout gives its outline: then pos.x/z, scale.x/z and rot.y have no say.
    pub outlined: bool,
    /// The prism in plain floats.
    pub prism: Prism,
}

impl<N: Number> RegionInstance<N> {
    fn new(placement: &RegionPlacement) -> Option<Self> {
        Some(Self {
            pos: V3::constant(&placement.pos),
            rot: V3::constant(&placement.rot),
            scale: V3::constant(&placement.scale),
            outlined: placement.vertices.is_some(),
            prism: Prism::from_placement(placement).ok()?,
        })
    }

    /// How a point of its outline (world x, z) moves with it.
    pub(crate) fn attached(&self, x: f64, z: f64) -> [N; 2] {
        if self.outlined {
            return [N::constant(x), N::constant(z)];
        }
        let (pos, scale) = (self.pos.value(), self.scale.value());
        let (sin, cos) = rotation::sin_cos(self.rot.0[1].value());
        let (dx, dz) = (x - pos.x, z - pos.z);
        // Its own frame, in parts of its extents; then back with numbers that move.
        let u = self.scale.0[0].scale((cos * dx - sin * dz) / scale.x);
        let v = self.scale.0[2].scale((sin * dx + cos * dz) / scale.z);
        let (sin, cos) = (self.rot.0[1].sin(), self.rot.0[1].cos());
        [self.pos.0[0] + cos * u + sin * v, self.pos.0[2] + cos * v - sin * u]
    }
}

impl<N: Number> World<N> {
    /// The instance that a layout describes. Values that the layout gives for unknown names are not looked at.
    pub fn new(program: &Program, layout: &Layout, options: &Options) -> Self {
        let placements: FxHashMap<&str, &Placement> =
            layout.objects.iter().map(|(name, placement)| (name.as_str(), placement)).collect();
        let objects = program.objects.iter().map(|object| {
            placements.get(object.name.as_str()).map(|placement| ObjectInstance::new(placement, options.geometry))
        });
        let regions = program.regions.iter().map(|region| layout.region(&region.name).and_then(RegionInstance::new));
        let values: FxHashMap<&str, model::DecisionValue> =
            layout.variables.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        let variables = program.variables.iter().enumerate().map(|(i, variable)| {
            let value = values.get(variable.name.as_str()).copied();
            value.ok_or(Cause::MissingVariable(VariableId(i as u32))).and_then(|value| setting(variable.kind, value))
        });
        let recorded: FxHashMap<&str, f64> = layout.draws.iter().map(|(key, value)| (key.as_str(), *value)).collect();
        let draws = program
            .draws
            .iter()
            .enumerate()
            .map(|(i, draw)| recorded.get(draw.key.as_str()).copied().ok_or(Cause::MissingDraw(DrawId(i as u32))));
        Self {
            objects: objects.collect(),
            regions: regions.collect(),
            variables: variables.collect(),
            draws: draws.collect(),
            allow: program.allow.clone(),
            habits: Arc::new(Habits::of(program)),
            options: *options,
            walks: Walks::default(),
        }
    }

    /// The same instance in other numbers, which depend on nothing yet.
    pub fn constant<M: Number>(&self) -> World<M> {
        let convert = |v: &V3<N>| V3::<M>::constant(&v.value());
        let thing = |t: &ObjectInstance<N>| ObjectInstance {
            pos: convert(&t.pos),
            rot: convert(&t.rot),
            scale: convert(&t.scale),
            axes: M3(std::array::from_fn(|i| convert(&t.axes.0[i]))),
            body: t.body.clone(),
        };
        let room = |r: &RegionInstance<N>| RegionInstance {
            pos: convert(&r.pos),
            rot: convert(&r.rot),
            scale: convert(&r.scale),
            outlined: r.outlined,
            prism: r.prism.clone(),
        };
        World {
            objects: self.objects.iter().map(|o| o.as_ref().map(thing)).collect(),
            regions: self.regions.iter().map(|r| r.as_ref().map(room)).collect(),
            variables: self.variables.iter().map(|v| v.map(Value::constant)).collect(),
            draws: self.draws.clone(),
            allow: self.allow.clone(),
            habits: Arc::clone(&self.habits),
            options: self.options,
            walks: Walks::default(),
        }
    }

    /// Puts an object elsewhere; its parts go with it. Does nothing for an object that the instance lacks.
    pub fn place(&mut self, object: ObjectId, pos: V3<N>, rot: V3<N>, scale: V3<N>) {
        self.walks.forget();
        if let Some(thing) = &mut self.objects[object.0 as usize] {
            thing.body.place(pos.value(), rot.value(), scale.value());
            (thing.pos, thing.rot, thing.scale, thing.axes) = (pos, rot, scale, M3::rotation(rot));
        }
    }

    /// Puts a rectangular region elsewhere; of an outlined one only floor and height change. Does nothing for a region
    /// that the instance lacks.
    pub fn place_region(&mut self, region: RegionId, pos: V3<N>, rot: V3<N>, scale: V3<N>) {
        self.walks.forget();
        if let Some(room) = &mut self.regions[region.0 as usize] {
            let plain = RegionPlacement { pos: pos.value(), rot: rot.value(), scale: scale.value(), vertices: None };
            if let Ok(prism) = Prism::from_placement(&plain) {
                let polygon = if room.outlined { room.prism.polygon.clone() } else { prism.polygon };
                room.prism = Prism { polygon, ..prism };
            }
            (room.pos, room.rot, room.scale) = (pos, rot, scale);
        }
    }

    /// Gives a decision variable a value of its kind.
    pub fn set_variable(&mut self, variable: VariableId, value: Value<N>) {
        self.variables[variable.0 as usize] = Ok(value);
    }

    /// Says why a decision variable has no value.
    pub fn refuse_variable(&mut self, variable: VariableId, cause: Cause) {
        self.variables[variable.0 as usize] = Err(cause);
    }

    /// Gives a draw a value, or the reason why it has none.
    pub fn set_draw(&mut self, draw: DrawId, value: Result<f64, Cause>) {
        self.draws[draw.0 as usize] = value;
    }

    /// Ids and bodies of the objects that are there.
    pub fn bodies(&self) -> impl Iterator<Item = (ObjectId, &Body)> {
        self.objects.iter().enumerate().filter_map(|(i, thing)| Some((ObjectId(i as u32), &thing.as_ref()?.body)))
    }
    /// Ids and prisms of the regions that are there.
    pub fn prisms(&self) -> impl Iterator<Item = (RegionId, &Prism)> {
        self.regions.iter().enumerate().filter_map(|(i, room)| Some((RegionId(i as u32), &room.as_ref()?.prism)))
    }
    /// Ids and values of the decision variables that have one.
    pub fn values(&self) -> impl Iterator<Item = (VariableId, Value<N>)> {
        self.variables.iter().enumerate().filter_map(|(i, value)| Some((VariableId(i as u32), value.ok()?)))
    }
    /// The first object that the layout lacks, if any.
    pub fn missing_object(&self) -> Option<Cause> {
        self.objects.iter().position(Option::is_none).map(|i| Cause::MissingObject(ObjectId(i as u32)))
    }
    /// The first region that the layout lacks, if any.
    pub fn missing_region(&self) -> Option<Cause> {
        self.regions.iter().position(Option::is_none).map(|i| Cause::MissingRegion(RegionId(i as u32)))
    }
}

impl<N: Algebra> World<N> {
    /// An instance that lacks everything.
    pub(crate) fn nowhere(program: &Program, options: &Options) -> Self {
        Self {
            objects: program.objects.iter().map(|_| None).collect(),
            regions: program.regions.iter().map(|_| None).collect(),
            variables: (0..program.variables.len())
                .map(|i| Err(Cause::MissingVariable(VariableId(i as u32))))
                .collect(),
            draws: (0..program.draws.len()).map(|i| Err(Cause::MissingDraw(DrawId(i as u32)))).collect(),
            allow: program.allow.clone(),
            habits: Arc::new(Habits::of(program)),
            options: *options,
            walks: Walks::default(),
        }
    }

    /// An object.
    ///
    /// # Errors
    /// The layout lacks it.
    pub fn object(&self, id: ObjectId) -> Result<&ObjectInstance<N>, Cause> {
        self.objects[id.0 as usize].as_ref().ok_or(Cause::MissingObject(id))
    }
    /// A region.
    ///
    /// # Errors
    /// The layout lacks it.
    pub fn region(&self, id: RegionId) -> Result<&RegionInstance<N>, Cause> {
        self.regions[id.0 as usize].as_ref().ok_or(Cause::MissingRegion(id))
    }
    /// A decision variable.
    ///
    /// # Errors
    /// The layout has no value for it.
    pub fn variable(&self, id: VariableId) -> Result<Value<N>, Cause> {
        self.variables[id.0 as usize]
    }
    /// A recorded draw.
    ///
    /// # Errors
    /// The layout does not record it, or outside its bounds.
    pub fn draw(&self, id: DrawId) -> Result<f64, Cause> {
        self.draws[id.0 as usize]
    }
}

/// The value of a variable, if it is of its kind.
fn setting<N: Number>(kind: VariableKind, value: model::DecisionValue) -> Result<Value<N>, Cause> {
    let triple = |t: [f64; 3]| V3(t.map(N::constant));
    match (kind, value) {
        (VariableKind::Number | VariableKind::Degree, model::DecisionValue::Number(n)) => {
            Ok(Value::Number(N::constant(n)))
        }
        (VariableKind::Bool, model::DecisionValue::Bool(b)) => Ok(Value::Truth(crate::eval::Truth::discrete(b))),
        (VariableKind::Vector, model::DecisionValue::Triple(t)) => Ok(Value::Vector(triple(t))),
        (VariableKind::Rotation, model::DecisionValue::Triple(t)) => Ok(Value::Rotation(triple(t))),
        _ => Err(Cause::Refused),
    }
}
