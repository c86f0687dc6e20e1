//! Walking, against a second and naive way to find out: a fine grid of cells, flooded. Random rooms (turned, L-shaped, two
//! with a door) with furniture at any angle; the two must agree as far as the cells are small.

use crate::given::layout;
use crate::gradients::compiled;
use scenelang_base::SourceMap;
use scenelang_layout::file::read;
use scenelang_verify::{Dual, Options, Value, World, evaluate, judge, vector::V3};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Side of a cell (metres).
const CELL: f64 = 0.015;
/// What a knight's way over the cells may be longer than the straight one.
const DETOUR: f64 = 1.028;
const NEAR: f64 = 0.05;

/// Numbers that look random (splitmix64).
struct Dice(u64);

impl Dice {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
    fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n - 1)
    }
}

/// An upright box seen from above.
#[derive(Clone, Copy, Debug)]
struct Rect {
    x: f64,
    z: f64,
    w: f64,
    d: f64,
    yaw: f64,
}

impl Rect {
    /// Metres from a point to the rectangle, 0 within.
    fn distance(&self, x: f64, z: f64) -> f64 {
        let (sin, cos) = self.yaw.to_radians().sin_cos();
        let (dx, dz) = (x - self.x, z - self.z);
        let (u, v) = (cos * dx - sin * dz, sin * dx + cos * dz);
        ((u.abs() - self.w / 2.0).max(0.0)).hypot((v.abs() - self.d / 2.0).max(0.0))
    }
    fn holds(&self, x: f64, z: f64) -> bool {
        self.distance(x, z) == 0.0
    }
}

/// A random instance: floors are unions of rectangles, the first two things are where the way begins and ends.
#[derive(Debug)]
struct Scene {
    floor: Vec<Rect>,
    things: Vec<Rect>,
    width: f64,
    program: String,
    layout: String,
}

fn scene(seed: u64) -> Scene {
    let mut dice = Dice(seed);
    let kind = dice.below(3);
    let mut things: Vec<Rect> = Vec::new();
    let n = 2 + dice.below(6);
    let (mut program, mut text) = (String::new(), String::new());
    let floor;
    let (reach_x, reach_z);
    match kind {
        0 => {
            let yaw = dice.between(0.0, 90.0);
            let (w, d) = (dice.between(2.5, 4.0), dice.between(2.0, 3.5));
            floor = vec![Rect { x: 0.3, z: -0.2, w, d, yaw }];
            text += &format!("region room 0.3 0 -0.2 | {w} 3 {d} | {yaw}\n");
            (reach_x, reach_z) = (w * 0.45, d * 0.45);
        }
        1 => {
            floor = vec![
                Rect { x: 0.0, z: -1.0, w: 4.0, d: 2.0, yaw: 0.0 },
                Rect { x: -1.0, z: 0.0, w: 2.0, d: 4.0, yaw: 0.0 },
            ];
            text += "outline room 0 3 | -2 -2, 2 -2, 2 0, 0 0, 0 2, -2 2\n";
            (reach_x, reach_z) = (1.9, 1.9);
        }
        _ => {
            let (z, w) = (dice.between(-0.7, 0.7), dice.between(0.6, 1.2));
            floor = vec![
                Rect { x: -1.53, z: 0.0, w: 3.0, d: 3.0, yaw: 0.0 },
                Rect { x: 1.53, z: 0.0, w: 3.0, d: 3.0, yaw: 0.0 },
                // The opening: the footprint of the door, turned, lengthened to both sides.
                Rect { x: 0.0, z, w, d: 0.06 + 2.0 * 0.07, yaw: 90.0 },
            ];
            text += "region room -1.53 0 0 | 3 3 3\nregion hall 1.53 0 0 | 3 3 3\n";
            text += &format!("object door 0 0 {z} | {w} 2 0.06 | 0 90 0\n");
            program += "region hall; object door; assert connects(door, room, hall);\n";
            (reach_x, reach_z) = (2.9, 1.4);
        }
    }
    for i in 0..n {
        let small = if i < 2 { 0.5 } else { 1.0 };
        // The ends stand apart more often than not.
        let side = [-1.0, 1.0].get(i).map(|s| s * dice.between(0.2, 1.0)).unwrap_or_else(|| dice.between(-1.0, 1.0));
        let thing = Rect {
            x: side * reach_x,
            z: dice.between(-1.0, 1.0) * reach_z,
            w: dice.between(0.15, 1.3) * small,
            d: dice.between(0.15, 0.9) * small,
            yaw: dice.between(0.0, 360.0),
        };
        text += &format!("object o[{i}] {} 0 {} | {} 1 {} | 0 {} 0\n", thing.x, thing.z, thing.w, thing.d, thing.yaw);
        things.push(thing);
    }
    let width = dice.between(0.2, 0.9);
    program += &format!("region room; object o[{n}];\nassert reachable(o[0], o[1], {width});\n");
    program += "assert walkDistance(o[0], o[1]) <= 0;\n";
    Scene { floor, things, width, program, layout: layout(&text) }
}

/// The parts of the sides of the floor's rectangles that are walls: in no other of them, to the millimetre.
fn walls(floor: &[Rect]) -> Vec<[(f64, f64); 2]> {
    let mut out = Vec::new();
    for (i, r) in floor.iter().enumerate() {
        let (sin, cos) = r.yaw.to_radians().sin_cos();
        let corner = |u: f64, v: f64| {
            (r.x + cos * u * r.w / 2.0 + sin * v * r.d / 2.0, r.z + cos * v * r.d / 2.0 - sin * u * r.w / 2.0)
        };
        let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        for k in 0..4 {
            let (a, b) = (corners[k], corners[(k + 1) % 4]);
            let pieces = ((b.0 - a.0).hypot(b.1 - a.1) * 1000.0).ceil() as usize;
            let on = |t: f64| (a.0 + (b.0 - a.0) * t, a.1 + (b.1 - a.1) * t);
            let mut start = None;
            for n in 0..=pieces {
                let (x, z) = on((n as f64 + 0.5) / pieces as f64);
                let deep = |r: &Rect| Rect { w: r.w - 1e-6, d: r.d - 1e-6, ..*r }.holds(x, z);
                let wall = n < pieces && !floor.iter().enumerate().any(|(j, other)| j != i && deep(other));
                match (wall, start) {
                    (true, None) => start = Some(on(n as f64 / pieces as f64)),
                    (false, Some(from)) => {
                        out.push([from, on(n as f64 / pieces as f64)]);
                        start = None;
                    }
                    _ => {}
                }
            }
        }
    }
    out
}

/// A grid of cells, each with the distance from its middle to whatever blocks, negative where there is no floor.
struct Grid {
    low: (f64, f64),
    columns: usize,
    rows: usize,
    clear: Vec<f64>,
}

impl Grid {
    fn new(scene: &Scene) -> Self {
        let walls = walls(&scene.floor);
        let ends = || walls.iter().flatten();
        let low = ends().fold((f64::INFINITY, f64::INFINITY), |m, p| (m.0.min(p.0), m.1.min(p.1)));
        let high = ends().fold((-f64::INFINITY, -f64::INFINITY), |m, p| (m.0.max(p.0), m.1.max(p.1)));
        let count = |low: f64, high: f64| ((high - low) / CELL) as usize + 1;
        let mut grid = Self { low, columns: count(low.0, high.0), rows: count(low.1, high.1), clear: Vec::new() };
        let clear = (0..grid.columns * grid.rows).map(|i| {
            let (x, z) = grid.at(i);
            if !scene.floor.iter().any(|r| r.holds(x, z)) {
                return -1.0;
            }
            let things = scene.things.iter().map(|r| r.distance(x, z)).fold(f64::INFINITY, f64::min);
            walls.iter().fold(things, |least, [(ax, az), (bx, bz)]| {
                let (ux, uz) = (bx - ax, bz - az);
                let t = (((x - ax) * ux + (z - az) * uz) / (ux * ux + uz * uz)).clamp(0.0, 1.0);
                least.min((ax + ux * t - x).hypot(az + uz * t - z))
            })
        });
        grid.clear = clear.collect();
        grid
    }
    fn at(&self, i: usize) -> (f64, f64) {
        (self.low.0 + CELL * (i % self.columns) as f64, self.low.1 + CELL * (i / self.columns) as f64)
    }

    /// The length of the shortest way over cells of at least this clearance, between cells within `near` of the ends;
    /// infinite where there is none.
    fn walk(&self, ends: [&Rect; 2], clear: f64, near: f64) -> f64 {
        let near = |i: usize, end: &Rect| {
            let (x, z) = self.at(i);
            end.distance(x, z) <= near
        };
        let mut cost = vec![f64::INFINITY; self.clear.len()];
        let mut open = BinaryHeap::new();
        for i in (0..self.clear.len()).filter(|&i| self.clear[i] >= clear && near(i, ends[0])) {
            cost[i] = 0.0;
            open.push(Reverse((0u64, i)));
        }
        let steps: Vec<(isize, isize)> = (-2..=2isize)
            .flat_map(|i| (-2..=2isize).map(move |j| (i, j)))
            .filter(|(i, j)| (*i, *j) != (0, 0) && (i.abs() != 2 || j.abs() == 1) && (j.abs() != 2 || i.abs() == 1))
            .collect();
        // Costs as whole micrometres: they have an order.
        while let Some(Reverse((micrometres, i))) = open.pop() {
            if micrometres as f64 > cost[i] * 1e6 + 1.0 {
                continue;
            }
            if near(i, ends[1]) {
                return cost[i];
            }
            let (column, row) = ((i % self.columns) as isize, (i / self.columns) as isize);
            for &(dx, dz) in &steps {
                let (x, z) = (column + dx, row + dz);
                if x < 0 || z < 0 || x >= self.columns as isize || z >= self.rows as isize {
                    continue;
                }
                let next = z as usize * self.columns + x as usize;
                let through = cost[i] + CELL * (dx as f64).hypot(dz as f64);
                if self.clear[next] >= clear && through < cost[next] - 1e-9 {
                    cost[next] = through;
                    open.push(Reverse(((through * 1e6) as u64, next)));
                }
            }
        }
        f64::INFINITY
    }
}

fn world(scene: &Scene) -> (scenelang_lang::Program, World<f64>) {
    let program = compiled(&scene.program);
    let mut sources = SourceMap::new();
    let file = sources.add(scenelang_base::SourceFile::new("t", "t", scene.layout.clone()));
    let read = read(sources.get(file).text(), file);
    assert_eq!(read.diagnostics, []);
    let world = World::new(&program, &read.layout, &Options { eta: 0.03, ..Options::default() });
    (program, world)
}

/// The verdict of `reachable`, and the length of the walk.
fn exact(scene: &Scene) -> (bool, f64) {
    let (program, world) = world(scene);
    let formula =
        |start: &str| &program.constraints.iter().find(|c| c.text.starts_with(start)).expect("it is stated").formula;
    let reachable = judge(formula("reachable"), &world).expect("all is there").holds;
    // `walkDistance(…) <= 0` has minus the length as its margin.
    let walk = -judge(formula("walkDistance"), &world).expect("all is there").margin;
    (reachable, walk)
}

#[test]
fn ways_are_those_over_a_grid() {
    let (mut ways, mut none, mut walks) = (0, 0, 0);
    for seed in 0..240 {
        let scene = scene(seed);
        let (reachable, walk) = exact(&scene);
        let grid = Grid::new(&scene);
        let ends = [&scene.things[0], &scene.things[1]];
        let radius = (scene.width - 0.001) / 2.0;
        // Middles that are surely free for the disc, and so is the way from one to the next; and all that may be.
        let surely = grid.walk(ends, radius + 1.2 * CELL, radius + NEAR).is_finite();
        let perhaps = grid.walk(ends, radius - CELL, radius + NEAR + CELL).is_finite();
        assert!(reachable || !surely, "seed {seed}: there is a way\n{scene:#?}");
        assert!(!reachable || perhaps, "seed {seed}: there is no way\n{scene:#?}");
        ways += usize::from(surely);
        none += usize::from(!perhaps);

        let person = (0.5 - 0.001) / 2.0;
        let most = grid.walk(ends, person + 1.2 * CELL, person + NEAR);
        let least = grid.walk(ends, person - CELL, person + NEAR + CELL) / DETOUR;
        let slack = 3.0 * CELL;
        assert!(walk <= most + 0.001, "seed {seed}: {walk} m, but {most} m is a way\n{scene:#?}");
        assert!(walk >= least - slack, "seed {seed}: {walk} m, but no way is shorter than {least} m\n{scene:#?}");
        walks += usize::from(most.is_finite() && most > 0.0 && most < 1.2 * least + 0.1);
    }
    // The cells decide most of them, either way.
    assert!(ways > 60 && none > 60 && walks > 40, "{ways} ways, {none} without, {walks} lengths");
}

#[test]
fn a_walk_lengthens_as_its_ends_and_bends_move() {
    let scene = |x: f64| Scene {
        floor: Vec::new(),
        things: Vec::new(),
        width: 0.5,
        program: "region room; object a; object b; object wall;\nassert walkDistance(a, b) <= 0;".to_owned(),
        layout: layout(&format!(
            "region room 0 0 0 | 8 3 6\nobject a -2 0 0.3 | 0.6 1 0.4 | 0 25 0\nobject b 2 0 -0.4 | 0.5 1 0.5 | 0 -10 0
             object wall {x} 0 0 | 0.3 1 3 | 0 12 0"
        )),
    };
    let (program, plain) = world(&scene(0.2));
    let formula = &program.constraints[0].formula;
    for object in 0..3u32 {
        let id = scenelang_lang::program::ObjectId(object);
        let thing = plain.object(id).expect("it is there").clone();
        let x = [thing.pos.0[0], thing.pos.0[2], thing.rot.0[1]];
        let at = |by: [f64; 3]| {
            let mut moved = plain.clone();
            let pos = V3([x[0] + by[0], 0.0, x[1] + by[1]]);
            moved.place(id, pos, V3([0.0, x[2] + by[2], 0.0]), thing.scale);
            judge(formula, &moved).expect("all is there").margin
        };
        let mut dual: World<Dual<3>> = plain.constant();
        let unknown = |i: usize| Dual::<3>::unknown(x[i], i);
        let zero = unknown(0) - unknown(0);
        let scale = dual.object(id).expect("it is there").scale;
        dual.place(id, V3([unknown(0), zero, unknown(1)]), V3([zero, unknown(2), zero]), scale);
        let Ok(Value::Truth(exact)) = evaluate(formula, &dual) else { panic!("no truth") };
        for k in 0..3 {
            let step = 1e-4;
            let mut by = [0.0; 3];
            by[k] = step;
            let above = at(by);
            by[k] = -step;
            let expect = (above - at(by)) / (2.0 * step);
            // Arcs have corners, at which the way bends by whole degrees.
            let slack = if k == 2 { 2e-3 } else { 0.06 };
            assert!(
                (exact.margin.slope[k] - expect).abs() < slack,
                "{object} by {k}: {:?}, {expect}",
                exact.margin.slope
            );
        }
    }
}

#[test]
fn the_slope_of_a_way_that_is_not_there_is_that_of_its_bottleneck() {
    let scene = Scene {
        floor: Vec::new(),
        things: Vec::new(),
        width: 0.9,
        program: "region room; object a; object b; object desk; object shelf;
            assert reachable(a, b, 0.9); assert gap(desk, shelf) >= 0.9;"
            .to_owned(),
        layout: layout(
            "region room 0 0 0 | 6 3 4\nobject a -2.5 0 0 | 0.4 1 0.4\nobject b 2.5 0 0 | 0.4 1 0.4
             object desk 0 0 -1.2 | 0.8 1 1.6 | 0 20 0\nobject shelf 0.1 0 1.2 | 0.8 1 1.6 | 0 -10 0",
        ),
    };
    let (program, plain) = world(&scene);
    let id = scenelang_lang::program::ObjectId(2);
    let thing = plain.object(id).expect("it is there");
    let x = [thing.pos.0[0], thing.pos.0[2], thing.rot.0[1]];
    let mut dual: World<Dual<3>> = plain.constant();
    let unknown = |i: usize| Dual::<3>::unknown(x[i], i);
    let zero = unknown(0) - unknown(0);
    let scale = dual.object(id).expect("it is there").scale;
    dual.place(id, V3([unknown(0), zero, unknown(1)]), V3([zero, unknown(2), zero]), scale);
    let [way, gap] = [0, 1].map(|i| judge(&program.constraints[i].formula, &dual).expect("all is there").margin);
    assert_eq!(way.value, f64::NEG_INFINITY);
    assert!(gap.value < 0.0 && gap.slope.iter().any(|s| s.abs() > 0.5), "{gap:?}");
    for (a, b) in way.slope.iter().zip(gap.slope) {
        assert!((a - b).abs() < 1e-6, "{way:?}, {gap:?}");
    }
}
