//! What is in the picture: all triangles in the world with their looks, after near walls and ceilings are out of the way.

use super::PictureView;
use super::cloth::Cloth;
use super::raster::{cross, dot, sub};
use super::sources::{self, Source};
use crate::Scene;
use crate::geometry::mesh::MeshGroup;
use crate::geometry::polygon::outward;
use crate::glb::linear;
use crate::scene::shell::{Role, Shell};
use crate::scene::view::hangs_on;
use crate::scene::{Object, RegionKind, View};
use crate::textures::rough_factor;
use scenelang_assets::Surface;
use scenelang_assets::textures::Texture;
use scenelang_layout::planar::edges;
use scenelang_layout::{Vec2, Vec3};

/// What is left of a wall that would stand in the way, metres.
const KERB: f64 = 0.08;
/// What is left of a wall between rooms, metres: enough to read the plan, too little to hide the room behind.
const PARAPET: f64 = 0.9;
/// What is left of walls seen from above, metres: through doors and windows, as in a plan.
const PLAN: f64 = 1.2;
/// What is this far beyond a wall (metres) is in the next room, if there is one.
const BESIDE: f64 = 0.25;

/// What hangs no further than this from the ceiling and is no longer than that is not drawn (metres).
const UNDER: f64 = 0.05;
const FLAT: f64 = 0.3;
/// What is taller than this and seen from behind is cut there, as a wall is (metres).
const TALL: f64 = 1.2;
/// What takes more of the floor is missed where it is hidden (square metres).
const BIN: f64 = 0.12;
/// How far before a thing (metres) something may stand that hides it, and at how many points that is looked at.
const REACH: f64 = 5.0;
const SAMPLES: u32 = 60;
/// What begins higher above the floor hangs (metres).
const LOW: f64 = 0.3;

/// The share of light that reaches a ceiling from below.
const BOUNCE: f32 = 0.45;
/// What is nearer to an eye in a room is not seen (metres).
const NEAR: f32 = 0.06;

#[derive(Clone, Copy)]
pub(super) struct TriangleLook {
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
    /// What is drawn on it: colour and roughness are factors of it.
    pub cloth: Option<&'static Cloth>,
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
    /// Where on its texture it is, in tiles: u and v of a point of the world are its products with these and 1.
    pub weave: [[f32; 4]; 2],
    /// Whether it throws a shadow.
    pub shadow: bool,
}

/// All that is in the picture.
#[derive(Default)]
pub(super) struct Stage {
    pub looks: Vec<TriangleLook>,
    pub triangles: Vec<Triangle>,
    /// Lamps and windows.
    pub sources: Vec<Source>,
    /// Height of what the building stands on.
    pub ground: f32,
    /// Edges of the floors that stand on it, x and z.
    footprint: Vec<[[f32; 2]; 2]>,
    /// What is in the way, and cut away, depends on where it is seen from.
    kind: PictureView,
}

impl Stage {
    /// The scene as seen by an eye.
    pub fn new(scene: &Scene, view: &View, kind: PictureView) -> Self {
        let mut stage = Self { kind, sources: sources::of(scene), ..Self::default() };
        let floors = || scene.shells.iter().filter(|s| s.role == Role::Floor).flat_map(|s| &s.pieces);
        let lowest = floors().map(|p| p.low).fold(f64::INFINITY, f64::min);
        stage.ground = if lowest.is_finite() { lowest as f32 } else { 0.0 };
        let flat = |v: Vec2| [v.x as f32, v.y as f32];
        stage.footprint = floors()
            .filter(|p| p.low < lowest + 0.01)
            .flat_map(|p| edges(&p.polygon))
            .map(|(a, b)| [flat(a), flat(b)])
            .collect();
        let cut: Vec<Cut> = scene.shells.iter().filter_map(|shell| Cut::of(scene, shell, view, kind)).collect();
        for shell in &scene.shells {
            stage.shell(scene, shell, view);
        }
        let short = |object: &&Object| {
            cut.iter().any(|wall| wall.is_near() && turns_its_back(object, wall, view)) && hides(scene, object, view)
        };
        let short: Vec<&Object> = scene.objects.iter().filter(short).collect();
        for object in &scene.objects {
            let is_lost = kind != PictureView::Eye && overhead(scene, object);
            if !is_lost && !short.iter().any(|below| stands_on(object, below)) {
                stage.object(scene, object, &cut, &short);
            }
        }
        stage
    }

    /// The triangles before an eye: of those that reach behind it, the part in front.
    pub fn before(&self, eye: [f32; 3], ahead: [f32; 3]) -> Vec<Triangle> {
        let depth = |p: [f32; 3]| dot(sub(p, eye), ahead) - NEAR;
        let front = |t: &Triangle| if t.points.iter().all(|p| depth(*p) >= 0.0) { vec![*t] } else { clipped(t, depth) };
        self.triangles.iter().flat_map(front).collect()
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
            Role::Ceiling if self.kind != PictureView::Eye => {}
            Role::Floor | Role::Tint | Role::Ceiling => {
                let look = self.look(surface);
                if shell.role == Role::Ceiling {
                    // The light that floor and walls send up to it.
                    let TriangleLook { color, glow, .. } = &mut self.looks[usize::from(look)];
                    *glow = color.map(|c| c * BOUNCE);
                }
                self.group(&shell.group, look, false, |p| p);
            }
            // What is left of a wall that is cut away is no higher than the board.
            Role::Skirting { .. } => {
                if height_left(scene, shell, view, self.kind).is_none_or(|left| left > KERB) {
                    let look = self.look(surface);
                    self.group(&shell.group, look, false, |p| p);
                }
            }
            Role::Wall { .. } => {
                let look = self.look(surface);
                // The cut through a wall is dark, as in a model; the kerb of a cut wall too.
                let section = self.section_look(surface);
                let top = height_left(scene, shell, view, self.kind).map_or(f64::INFINITY, |left| left + bottom(shell));
                for piece in shell.pieces.iter().filter(|p| p.low < top) {
                    let mut prism = MeshGroup::new(0);
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

    fn object(&mut self, scene: &Scene, object: &Object, cut: &[Cut], short: &[&Object]) {
        let opening = matches!(&*object.family, "door" | "window");
        let is_short = short.iter().any(|other| std::ptr::eq(*other, object));
        let on = || cut.iter().filter(|wall| hangs_on(object, wall.from, wall.to));
        // What hangs on a wall that is cut away would float; of a door its threshold is left.
        let floats = |wall: &Cut| {
            let low = object.place.pos.y - wall.floor;
            wall.is_near() && (low > LOW || low + object.place.scale.y > TALL)
        };
        if !opening && !is_short && on().any(floats) {
            return;
        }
        let hung = on().filter(|wall| opening || !wall.is_near()).map(|wall| wall.floor + wall.left);
        let tall = is_short.then_some(object.place.pos.y + TALL);
        let top = hung.chain(tall).fold(f64::INFINITY, f64::min);
        if object.place.pos.y >= top {
            return;
        }
        for group in &object.mesh {
            let look = self.look(&scene.surfaces[group.surface]);
            let shadow = scene.surfaces[group.surface].opacity > 0.5;
            let first = self.triangles.len();
            self.group(group, look, shadow, |p| object.at(p));
            if top.is_finite() {
                let whole = self.triangles.split_off(first);
                self.triangles.extend(whole.iter().flat_map(|t| below(t, top as f32)));
            }
        }
        if is_short {
            self.section(scene, object, top);
        }
    }

    /// The cut through something tall, in the grey of all cuts.
    fn section(&mut self, scene: &Scene, object: &Object, top: f64) {
        let Some(first) = object.mesh.first() else { return };
        let look = self.section_look(&scene.surfaces[first.surface]);
        let (w, d) = (object.place.scale.x / 2.0 - 0.005, object.place.scale.z / 2.0 - 0.005);
        let corner = |x: f64, z: f64| {
            let mut p = object.at(Vec3::new(x, 0.0, z));
            p.y = top;
            [p.x as f32, p.y as f32, p.z as f32]
        };
        let [a, b, c, e] = [corner(-w, -d), corner(w, -d), corner(w, d), corner(-w, d)];
        let normals = [[0.0, 1.0, 0.0]; 3];
        let weave = [[0.0; 4]; 2];
        let flat = |points| Triangle { points, normals, look, weave, shadow: false };
        self.triangles.extend([[a, c, b], [a, e, c]].map(flat));
    }

    fn group(&mut self, group: &MeshGroup, look: u16, shadow: bool, place: impl Fn(Vec3) -> Vec3) {
        let wide = |v: [f32; 3]| Vec3::from(v.map(f64::from));
        let narrow = |v: Vec3| [v.x as f32, v.y as f32, v.z as f32];
        let origin = place(Vec3::zeros());
        let points: Vec<[f32; 3]> = group.positions.iter().map(|&p| narrow(place(wide(p)))).collect();
        let normals: Vec<[f32; 3]> = group.normals.iter().map(|&n| narrow(place(wide(n)) - origin)).collect();
        let fine = self.looks[usize::from(look)].cloth.map(Cloth::tile);
        self.triangles.extend(group.indices.chunks_exact(3).map(|t| {
            let t = [t[0] as usize, t[1] as usize, t[2] as usize];
            let own = t.map(|i| points[i]);
            let weave = fine.map_or([[0.0; 4]; 2], |tile| woven(own, t.map(|i| group.uvs[i]), tile));
            Triangle { points: own, normals: t.map(|i| normals[i]), look, weave, shadow }
        }));
    }

    /// How a cut through a surface looks.
    fn section_look(&mut self, surface: &Surface) -> u16 {
        let section = Surface { name: "section".into(), color: [0.36, 0.38, 0.41], emissive: None, ..surface.clone() };
        self.look(&section)
    }

    fn look(&mut self, surface: &Surface) -> u16 {
        let texture = Texture::of(surface);
        let color = surface.color.map(|c| linear(c) as f32);
        self.looks.push(TriangleLook {
            color: texture.map_or(color, |t| t.pixels().factor(color)),
            glow: surface.emissive.map_or([0.0; 3], |e| e.map(|c| linear(c) as f32)),
            roughness: texture.map_or(surface.roughness, |t| rough_factor(t.pixels(), surface.roughness)),
            metallic: surface.metallic,
            opacity: surface.opacity,
            cloth: texture.map(Cloth::of),
        });
        (self.looks.len() - 1) as u16
    }
}

/// What takes a point of a triangle to its place on a texture of tiles of this size.
fn woven([a, b, c]: [[f32; 3]; 3], uvs: [[f32; 2]; 3], tile: [f32; 2]) -> [[f32; 4]; 2] {
    let (ab, ac) = (sub(b, a), sub(c, a));
    let normal = cross(ab, ac);
    let (to_b, to_c) = (cross(ac, normal), cross(normal, ab));
    let square = dot(normal, normal).max(1e-24);
    std::array::from_fn(|k| {
        let [at, by, cy] = uvs.map(|uv| uv[k] / tile[k]);
        let way: [f32; 3] = std::array::from_fn(|i| (to_b[i] * (by - at) + to_c[i] * (cy - at)) / square);
        [way[0], way[1], way[2], at - dot(way, a)]
    })
}

/// Whether something lies flat under a ceiling, which is off: it would float. What hangs lower shows where it hangs.
fn overhead(scene: &Scene, object: &Object) -> bool {
    let top = object.place.pos.y + object.place.scale.y;
    let over = |p: &scenelang_layout::Prism| {
        p.polygon.contains(object.place.pos.xz()) && (p.ceiling - top).abs() < UNDER && object.place.scale.y < FLAT
    };
    scene.regions.iter().any(|r| r.kind == RegionKind::Room && over(&r.prism))
}

/// A wall of which not all is left.
struct Cut {
    from: Vec2,
    to: Vec2,
    /// Where it stands, and how much of it is left (metres).
    floor: f64,
    left: f64,
}

impl Cut {
    fn of(scene: &Scene, shell: &Shell, view: &View, kind: PictureView) -> Option<Self> {
        let Role::Wall { from, to } = shell.role else { return None };
        Some(Self { from, to, floor: bottom(shell), left: height_left(scene, shell, view, kind)? })
    }

    /// Whether it is between the rooms and the eye.
    fn is_near(&self) -> bool {
        self.left <= KERB
    }
}

/// Whether something tall stands at a wall that is cut away and turns its back to the eye.
fn turns_its_back(object: &Object, wall: &Cut, view: &View) -> bool {
    let middle = object.place.pos.xz();
    let reach = object.place.scale.x.max(object.place.scale.z) / 2.0;
    let nearest = scenelang_layout::planar::nearest_on_segment(&middle, &wall.from, &wall.to);
    object.place.scale.y > TALL
        && (nearest - middle).norm() < reach.min(0.6)
        && object.axes.column(2).dot(&(view.eye - object.place.pos)) < 0.0
        && outward(wall.from, wall.to).dot(&object.axes.column(2).xz()) < -0.7
}

/// Whether something tall hides most of something larger than a bin behind it, which is seen once it is cut.
fn hides(scene: &Scene, object: &Object, view: &View) -> bool {
    let axes = object.axes.transpose();
    let half = object.place.scale / 2.0;
    let blocks = |point: Vec3| {
        let (from, to) = (axes * (point - object.place.pos), axes * (view.eye - object.place.pos));
        (1..=SAMPLES).any(|k| {
            let p = from + (to - from) * (f64::from(k) * REACH / f64::from(SAMPLES) / (to - from).norm());
            p.x.abs() < half.x && p.z.abs() < half.z && p.y > TALL && p.y < object.place.scale.y
        })
    };
    let is_hidden = |other: &&Object| {
        let size = other.place.scale;
        let seen = |x: f64, y: f64, z: f64| other.at(Vec3::new(x * size.x, y * size.y, z * size.z));
        let points = [(-0.4, -0.4), (-0.4, 0.4), (0.4, -0.4), (0.4, 0.4), (0.0, 0.0)];
        let blocked = points.iter().flat_map(|(x, z)| [seen(*x, 0.4, *z), seen(*x, 1.0, *z)]).filter(|p| blocks(*p));
        size.x * size.z > BIN && blocked.count() > points.len()
    };
    scene.objects.iter().filter(|other| !std::ptr::eq(*other, object)).any(|other| is_hidden(&other))
}

/// Whether something is above where another is cut, on it.
fn stands_on(object: &Object, other: &Object) -> bool {
    let local = other.axes.transpose() * (object.place.pos - other.place.pos);
    let half = other.place.scale / 2.0;
    local.y >= TALL - 0.01 && local.x.abs() <= half.x && local.z.abs() <= half.z
}

/// What of a triangle is below a height: none, one or two of them.
fn below(triangle: &Triangle, top: f32) -> Vec<Triangle> {
    clipped(triangle, |p| top - p[1])
}

/// What of a triangle is where a linear function is not negative: none, one or two of them.
fn clipped(triangle: &Triangle, inside: impl Fn([f32; 3]) -> f32) -> Vec<Triangle> {
    let mut corners: Vec<([f32; 3], [f32; 3])> = Vec::with_capacity(4);
    for i in 0..3 {
        let j = (i + 1) % 3;
        let (p, q) = (triangle.points[i], triangle.points[j]);
        let (n, m) = (triangle.normals[i], triangle.normals[j]);
        let (from, to) = (inside(p), inside(q));
        if from >= 0.0 {
            corners.push((p, n));
        }
        if (from >= 0.0) != (to >= 0.0) {
            let t = from / (from - to);
            let between = |a: [f32; 3], b: [f32; 3]| std::array::from_fn(|k| a[k] + (b[k] - a[k]) * t);
            corners.push((between(p, q), between(n, m)));
        }
    }
    (2..corners.len())
        .map(|k| {
            let of = [corners[0], corners[k - 1], corners[k]];
            Triangle { points: of.map(|c| c.0), normals: of.map(|c| c.1), ..*triangle }
        })
        .collect()
}

/// How much of a wall, or of the one behind a skirting board, is left, metres; `None`: all of it. Nothing else is cut.
fn height_left(scene: &Scene, shell: &Shell, view: &View, kind: PictureView) -> Option<f64> {
    let (Role::Wall { from, to } | Role::Skirting { from, to }) = shell.role else { return None };
    match kind {
        PictureView::Iso => {}
        PictureView::Top => return Some(PLAN),
        PictureView::Eye => return None,
    }
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
