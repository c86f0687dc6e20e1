//! What is in the picture: all triangles in the world with their looks, after near walls and ceilings are out of the way.

use super::pattern::Pattern;
use crate::Scene;
use crate::geometry::mesh::Group;
use crate::geometry::polygon::outward;
use crate::glb::linear;
use crate::scene::shell::{Role, Shell};
use crate::scene::view::hangs_on;
use crate::scene::{Object, RegionKind, View};
use scenelang_assets::Surface;
use scenelang_layout::planar::edges;
use scenelang_layout::{Vec2, Vec3};

/// What is left of a wall that would stand in the way, metres.
const KERB: f64 = 0.08;
/// What is left of a wall between rooms, metres: enough to read the plan, too little to hide the room behind.
const PARAPET: f64 = 0.9;
/// What is this far beyond a wall (metres) is in the next room, if there is one.
const BESIDE: f64 = 0.25;
/// How solid something that hangs on a cut wall remains.
const GHOST: f32 = 0.22;

/// What hangs no further than this from the ceiling, and above this height, is not drawn (metres).
const UNDER: f64 = 0.05;
const HEAD: f64 = 1.7;
/// What is taller than this and seen from behind is drawn so that one sees through it (metres).
const TALL: f64 = 1.2;

/// How solid something tall remains that is seen from behind.
const FADED: f32 = 0.5;

/// How a triangle looks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Look {
    /// Linear light reflected.
    pub color: [f32; 3],
    /// Linear light given off.
    pub glow: [f32; 3],
    /// 0 a mirror, 1 chalk.
    pub roughness: f32,
    /// 0 to 1.
    pub metallic: f32,
    /// 1 opaque.
    pub opacity: f32,
    /// What is drawn on it.
    pub pattern: Pattern,
}

/// A triangle in the world.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triangle {
    /// Corners.
    pub points: [[f32; 3]; 3],
    /// Unit normals at the corners.
    pub normals: [[f32; 3]; 3],
    /// Index into [`Stage::looks`].
    pub look: u16,
    /// Whether it throws a shadow.
    pub shadow: bool,
}

/// All that is in the picture.
#[derive(Debug, Default)]
pub(super) struct Stage {
    pub looks: Vec<Look>,
    pub triangles: Vec<Triangle>,
    /// Height of what the building stands on.
    pub ground: f32,
    /// Edges of the floors that stand on it, x and z.
    footprint: Vec<[[f32; 2]; 2]>,
}

impl Stage {
    /// The scene as seen by an eye.
    pub fn new(scene: &Scene, view: &View) -> Self {
        let mut stage = Self::default();
        let floors = || scene.shells.iter().filter(|s| s.role == Role::Floor).flat_map(|s| &s.pieces);
        let lowest = floors().map(|p| p.low).fold(f64::INFINITY, f64::min);
        stage.ground = if lowest.is_finite() { lowest as f32 } else { 0.0 };
        let flat = |v: Vec2| [v.x as f32, v.y as f32];
        stage.footprint = floors()
            .filter(|p| p.low < lowest + 0.01)
            .flat_map(|p| edges(&p.polygon))
            .map(|(a, b)| [flat(a), flat(b)])
            .collect();
        let cut: Vec<&Shell> =
            scene.shells.iter().filter(|s| height_left(scene, s, view).is_some_and(|h| h <= KERB)).collect();
        for shell in &scene.shells {
            stage.shell(scene, shell, view);
        }
        for object in &scene.objects {
            if !overhead(scene, object) {
                stage.object(scene, object, &cut, view);
            }
        }
        stage
    }

    /// How far a point of the ground is from the building, metres.
    pub fn distance_to_footprint(&self, [x, z]: [f32; 2]) -> f32 {
        let nearest = self.footprint.iter().map(|[a, b]| {
            let (dx, dz) = (b[0] - a[0], b[1] - a[1]);
            let t = (((x - a[0]) * dx + (z - a[1]) * dz) / (dx * dx + dz * dz).max(1e-12)).clamp(0.0, 1.0);
            let (ex, ez) = (x - a[0] - t * dx, z - a[1] - t * dz);
            ex * ex + ez * ez
        });
        nearest.fold(f32::INFINITY, f32::min).sqrt()
    }

    fn shell(&mut self, scene: &Scene, shell: &Shell, view: &View) {
        let surface = &scene.surfaces[shell.group.surface];
        match shell.role {
            Role::Ceiling => {}
            Role::Floor | Role::Tint => {
                let look = self.look(surface, Pattern::of_floor(surface), 1.0);
                self.group(&shell.group, look, false, |p| p);
            }
            Role::Wall { .. } => {
                let look = self.look(surface, Pattern::of_wall(surface), 1.0);
                // The cut through a wall is dark, as in a model; the kerb of a cut wall too.
                let section =
                    Surface { name: "section".into(), color: [0.36, 0.38, 0.41], emissive: None, ..surface.clone() };
                let section = self.look(&section, Pattern::Plain, 1.0);
                let top = height_left(scene, shell, view).map_or(f64::INFINITY, |left| left + bottom(shell));
                for piece in shell.pieces.iter().filter(|p| p.low < top) {
                    let mut prism = Group::new(0);
                    prism.prism(&piece.polygon, piece.low, piece.high.min(top));
                    let first = self.triangles.len();
                    self.group(&prism, look, false, |p| p);
                    let level = piece.high.min(top) >= top.min(ceiling(shell)) - 1e-6;
                    for t in &mut self.triangles[first..] {
                        if level && t.normals[0][1] > 0.9 {
                            t.look = section;
                        }
                    }
                }
            }
        }
    }

    fn object(&mut self, scene: &Scene, object: &Object, cut: &[&Shell], view: &View) {
        let hides =
            cut.iter().any(|s| matches!(s.role, Role::Wall { from, to } if turns_its_back(object, from, to, view)));
        let hangs = cut.iter().any(|s| matches!(s.role, Role::Wall { from, to } if hangs_on(object, from, to)));
        let share = match (hangs, hides) {
            (true, _) => GHOST,
            (_, true) => FADED,
            _ => 1.0,
        };
        for group in &object.mesh {
            let look = self.look(&scene.surfaces[group.surface], Pattern::Plain, share);
            let shadow = share * scene.surfaces[group.surface].opacity > 0.5;
            self.group(group, look, shadow, |p| object.at(p));
        }
    }

    fn group(&mut self, group: &Group, look: u16, shadow: bool, place: impl Fn(Vec3) -> Vec3) {
        let wide = |v: [f32; 3]| Vec3::from(v.map(f64::from));
        let narrow = |v: Vec3| [v.x as f32, v.y as f32, v.z as f32];
        let origin = place(Vec3::zeros());
        let points: Vec<[f32; 3]> = group.positions.iter().map(|&p| narrow(place(wide(p)))).collect();
        let normals: Vec<[f32; 3]> = group.normals.iter().map(|&n| narrow(place(wide(n)) - origin)).collect();
        self.triangles.extend(group.indices.chunks_exact(3).map(|t| {
            let t = [t[0] as usize, t[1] as usize, t[2] as usize];
            Triangle { points: t.map(|i| points[i]), normals: t.map(|i| normals[i]), look, shadow }
        }));
    }

    fn look(&mut self, surface: &Surface, pattern: Pattern, share: f32) -> u16 {
        self.looks.push(Look {
            color: surface.color.map(|c| linear(c) as f32),
            glow: surface.emissive.map_or([0.0; 3], |e| e.map(|c| linear(c) as f32)),
            roughness: surface.roughness,
            metallic: surface.metallic,
            opacity: surface.opacity * share,
            pattern,
        });
        (self.looks.len() - 1) as u16
    }
}

/// Whether something hangs under a ceiling, which is off: it would float.
fn overhead(scene: &Scene, object: &Object) -> bool {
    let top = object.place.pos.y + object.place.scale.y;
    let over = |p: &scenelang_layout::Prism| {
        p.polygon.contains(object.place.pos.xz())
            && (p.ceiling - top).abs() < UNDER
            && object.place.pos.y > p.floor + HEAD
    };
    scene.regions.iter().any(|r| r.kind == RegionKind::Room && over(&r.prism))
}

/// Whether something tall stands at a wall that is cut away and turns its back to the eye.
fn turns_its_back(object: &Object, from: Vec2, to: Vec2, view: &View) -> bool {
    let middle = object.place.pos.xz();
    let reach = object.place.scale.x.max(object.place.scale.z) / 2.0;
    let nearest = scenelang_layout::planar::nearest_on_segment(&middle, &from, &to);
    object.place.scale.y > TALL
        && (nearest - middle).norm() < reach.min(0.6)
        && object.axes.column(2).dot(&(view.eye - object.place.pos)) < 0.0
        && outward(from, to).dot(&object.axes.column(2).xz()) < -0.7
}

/// How much of a wall is left, metres; `None`: all of it. Nothing but walls is cut.
fn height_left(scene: &Scene, shell: &Shell, view: &View) -> Option<f64> {
    let Role::Wall { from, to } = shell.role else { return None };
    let normal = outward(from, to);
    let along = |i: u32| from + (to - from) * f64::from(i) / 10.0;
    let rooms = |p: Vec2| scene.regions.iter().any(|r| r.kind == RegionKind::Room && r.prism.polygon.contains(p));
    // Both faces of a wall between rooms end at the same height.
    if (1..=9).any(|i| rooms(along(i) + normal * BESIDE)) {
        return Some(PARAPET);
    }
    let eye = view.eye.xz();
    if normal.dot(&(eye - along(5))) > 0.0 {
        return Some(KERB);
    }
    // A wall at the back may still hide what lies behind a corner of its own room, as far as its height reaches.
    let height = ceiling(shell) - bottom(shell);
    let slope = (view.eye.y - ceiling(shell)).max(0.1) / (along(5) - eye).norm();
    let hides = |p: Vec2| {
        let away = (p - eye).normalize();
        (1..=8).any(|k| rooms(p + away * (BESIDE + height / slope * f64::from(k) / 8.0)))
    };
    ((1..=9).filter(|&i| hides(along(i))).count() > 2).then_some(PARAPET)
}

fn bottom(shell: &Shell) -> f64 {
    shell.pieces.iter().map(|p| p.low).fold(f64::INFINITY, f64::min)
}

fn ceiling(shell: &Shell) -> f64 {
    shell.pieces.iter().map(|p| p.high).fold(f64::NEG_INFINITY, f64::max)
}
