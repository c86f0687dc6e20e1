//! Drawings of the book's layouts: seen from above, or from the side. `SPEC_UPDATE=1 cargo test` writes them anew.
//!
//! `draw=NAME` asks for `pictures/NAME.svg`; `view=side` looks along +z, `view=end` along −x; `zone=lamp` shades where
//! the centre of `lamp` may be so that the first statement about it holds, all else staying as it is; `room=0.5` leaves
//! so many metres around. The object that a statement is about (its first argument) is green where all of
//! these hold, and red where all fail, or where it breaks a physical rule.

use super::blocks::Block;
use scenelang_lang::program::{ConstraintKind, ObjectId, Program};
use scenelang_layout::planar::convex_hull;
use scenelang_layout::{Layout, Prism, Vec2, Vec3};
use scenelang_verify::report::model::Row;
use scenelang_verify::{Checked, Options, Value, World, evaluate};
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// Which two axes are drawn, to the right and up.
#[derive(Clone, Copy)]
struct View {
    across: usize,
    up: usize,
}

impl View {
    fn of(&self, p: &Vec3) -> Vec2 {
        Vec2::new(p[self.across], p[self.up])
    }
}

/// The drawing of a layout against its file; `None`: none is asked for, or it is as it should be.
pub fn compare(folder: &Path, layout: &Block, checked: &Checked) -> Option<String> {
    let name = layout.setting("draw")?;
    let (Some(program), Some(placed)) = (&checked.program, &checked.layout) else {
        return Some("nothing to draw".to_owned());
    };
    let path = folder.join(format!("{name}.svg"));
    let made = draw(layout, checked, program, placed);
    if std::env::var_os("SPEC_UPDATE").is_some() {
        fs::create_dir_all(folder).unwrap();
        fs::write(path, made).unwrap();
        return None;
    }
    let same = fs::read_to_string(path).is_ok_and(|file| file == made);
    (!same).then(|| format!("{name}.svg does not show this layout; SPEC_UPDATE=1 writes it"))
}

/// From metres to pixels.
struct Paper {
    view: View,
    least: Vec2,
    greatest: Vec2,
    scale: f64,
}

impl Paper {
    fn x(&self, x: f64) -> f64 {
        round((x - self.least.x) * self.scale)
    }
    fn y(&self, y: f64) -> f64 {
        round((self.greatest.y - y) * self.scale)
    }
    fn path(&self, points: &[Vec2]) -> String {
        let points: Vec<String> = points.iter().map(|p| format!("{} {}", self.x(p.x), self.y(p.y))).collect();
        format!("M{}z", points.join("L"))
    }
}

fn round(x: f64) -> f64 {
    (x * 10.0).round() / 10.0 + 0.0
}

const STYLE: &str = "path{stroke:#57606a;stroke-width:1.5;stroke-linejoin:round}.w{fill:#f6f8fa;stroke-width:4}\
                     .z{fill:#b6e3ff;stroke:none}.n{fill:#d0d7de}.g{fill:#aceebb}.b{fill:#ffcecb}.f{fill:#57606a;stroke:none}\
                     text{font:12px system-ui,sans-serif;fill:#1f2328}";

fn draw(block: &Block, checked: &Checked, program: &Program, layout: &Layout) -> String {
    let view = match block.setting("view") {
        Some("side") => View { across: 0, up: 1 },
        Some("end") => View { across: 2, up: 1 },
        _ => View { across: 0, up: 2 },
    };
    let world = World::<f64>::new(program, layout, &Options::default());
    let things: Vec<(ObjectId, Vec<Vec<Vec2>>)> = (0..program.objects.len())
        .map(|i| ObjectId(i as u32))
        .filter_map(|id| {
            let solid = world.object(id).ok()?.body.solid();
            Some((id, solid.iter().map(|part| convex_hull(part.vertices().iter().map(|v| view.of(v)))).collect()))
        })
        .collect();
    let rooms: Vec<Vec<Vec2>> =
        layout.regions.iter().filter_map(|(_, r)| Prism::from_placement(r).ok()).map(|p| outline(&p, view)).collect();
    let margin = block.setting("room").map_or(0.25, |m| m.parse().unwrap());
    let all: Vec<Vec2> =
        things.iter().flat_map(|(_, parts)| parts.iter().flatten()).chain(rooms.iter().flatten()).copied().collect();
    let bound = |f: fn(f64, f64) -> f64, start: f64, off: f64| {
        let by = |axis: usize| all.iter().map(|p| p[axis]).fold(start, f) + off;
        Vec2::new(by(0), by(1))
    };
    let (least, greatest) = (bound(f64::min, f64::INFINITY, -margin), bound(f64::max, f64::NEG_INFINITY, margin));
    let scale = (440.0 / (greatest.x - least.x)).min(330.0 / (greatest.y - least.y)).min(120.0);
    let paper = Paper { view, least, greatest, scale };
    let mut svg = String::new();
    for room in &rooms {
        let _ = writeln!(svg, "<path class=\"w\" d=\"{}\"/>", paper.path(room));
    }
    if let Some(name) = block.setting("zone") {
        let _ = writeln!(svg, "<path class=\"z\" d=\"{}\"/>", zone(&paper, program, layout, name));
    }
    let mut order = things;
    // What is higher, or nearer to the eye, is drawn later.
    let depth = 3 - view.across - view.up;
    let near = |id: ObjectId| {
        let body = &world.object(id).expect("only those that are there").body;
        let (low, high) = (body.aabb().min[depth], body.aabb().max[depth]);
        if depth == 2 { -low } else { high }
    };
    order.sort_by(|a, b| near(a.0).total_cmp(&near(b.0)));
    for (id, parts) in &order {
        let class = look(checked, &program.objects[id.0 as usize].name);
        for part in parts {
            let _ = writeln!(svg, "<path class=\"{class}\" d=\"{}\"/>", paper.path(part));
        }
        let body = &world.object(*id).expect("only those that are there").body;
        if depth == 1 {
            let (front, right) = (body.obb.axes.column(2), body.obb.axes.column(0));
            let tip = body.obb.center + front * (body.obb.half.z - 0.02);
            let (size, wide) = (body.obb.half.z.min(0.07), body.obb.half.x.min(0.07));
            let nose = [tip, tip - front * size + right * wide, tip - front * size - right * wide];
            let _ = writeln!(svg, "<path class=\"f\" d=\"{}\"/>", paper.path(&nose.map(|p| view.of(&p))));
        }
    }
    let (width, height) = (paper.x(greatest.x).ceil(), paper.y(least.y).ceil());
    for (id, _) in &order {
        let span = world.object(*id).expect("only those that are there").body.aabb();
        let mut name = program.objects[id.0 as usize].name.as_str();
        let (low, high) = (view.of(&span.min), view.of(&span.max));
        let (left, right, top, bottom) = (paper.x(low.x), paper.x(high.x), paper.y(high.y), paper.y(low.y));
        let room_for = |name: &str| name.chars().count() as f64 * 6.8 + 6.0;
        if let Some(bracket) = name.find('[').filter(|_| room_for(name) > right - left) {
            name = &name[bracket..];
        }
        let needed = room_for(name);
        let middle = (top + bottom) / 2.0 + 4.0;
        let (x, y, anchor) = if needed > right - left && right + needed <= width {
            (right + 4.0, middle, "start")
        } else if needed > right - left {
            (left - 4.0, middle, "end")
        } else if bottom - top >= 14.0 {
            ((left + right) / 2.0, middle, "middle")
        } else if bottom + 16.0 <= height {
            ((left + right) / 2.0, bottom + 13.0, "middle")
        } else {
            ((left + right) / 2.0, top - 5.0, "middle")
        };
        let _ =
            writeln!(svg, "<text style=\"text-anchor:{anchor}\" x=\"{}\" y=\"{}\">{name}</text>", round(x), round(y));
    }
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n\
         <style>{STYLE}</style><path style=\"fill:#fff;stroke:none\" d=\"M0 0H{width}V{height}H0z\"/>\n{svg}</svg>\n"
    )
}

fn outline(prism: &Prism, view: View) -> Vec<Vec2> {
    if view.up == 2 {
        return prism.polygon.corners().to_vec();
    }
    let axis = view.across / 2;
    let by = |f: fn(f64, f64) -> f64, start| prism.polygon.corners().iter().map(|c| c[axis]).fold(start, f);
    let (a, b) = (by(f64::min, f64::INFINITY), by(f64::max, f64::NEG_INFINITY));
    [(a, prism.floor), (b, prism.floor), (b, prism.ceiling), (a, prism.ceiling)].map(|(x, y)| Vec2::new(x, y)).to_vec()
}

/// The colour of an object: by the verdicts of the statements that are about it.
fn look(checked: &Checked, name: &str) -> &'static str {
    let about = checked.report.constraints.iter().filter(|row| {
        let subject = row.text.split_once('(').map_or("", |(_, rest)| rest);
        let word = subject.split([',', ')', ' ']).next().unwrap_or_default();
        let array = name.split('[').next() == Some(word) && row.text.contains('(');
        row.rule.is_none() && row.kind.as_str() == "assert" && (word == name || array)
    });
    let verdicts: Vec<Option<bool>> = about.map(|row| row.satisfied).collect();
    let broken = |row: &&Row| row.rule.is_some() && row.is_violation() && row.objects[0] == name;
    if checked.report.constraints.iter().any(|row| broken(&row)) {
        return "b";
    }
    match verdicts.as_slice() {
        [] => "n",
        all if all.iter().all(|v| *v == Some(true)) => "g",
        all if all.iter().all(|v| *v == Some(false)) => "b",
        _ => "n",
    }
}

/// Where the centre of an object may be, as strips of three pixels.
fn zone(paper: &Paper, program: &Program, layout: &Layout, name: &str) -> String {
    const STEP: f64 = 3.0;
    let id = program.objects.iter().position(|o| o.name == name).map(|i| ObjectId(i as u32)).expect("a known object");
    let speaks = |c: &&scenelang_lang::program::Constraint| {
        c.kind == ConstraintKind::Assert && c.formula.objects().contains(&id)
    };
    let formula = &program.constraints.iter().find(speaks).expect("a statement about it").formula;
    let mut moved = layout.clone();
    let mut margin = |across: f64, up: f64| {
        let (_, placed) = moved.objects.iter_mut().find(|(n, _)| n == name).expect("it is placed");
        placed.pos[paper.view.across] = across;
        // Heights are those of the centre, `pos` is that of the base.
        placed.pos[paper.view.up] = if paper.view.up == 1 { up - placed.scale.y / 2.0 } else { up };
        match evaluate(formula, &World::<f64>::new(program, &moved, &Options::default())) {
            Ok(Value::Truth(t)) => t.margin,
            other => panic!("{other:?}"),
        }
    };
    let step = STEP / paper.scale;
    let (rows, columns) =
        (((paper.greatest.y - paper.least.y) / step) as usize, ((paper.greatest.x - paper.least.x) / step) as usize);
    let mut path = String::new();
    for row in 0..rows {
        let y = paper.greatest.y - (row as f64 + 0.5) * step;
        let x_of = |column: usize| paper.least.x + column as f64 * step;
        let margins: Vec<f64> = (0..=columns).map(|c| margin(x_of(c), y)).collect();
        let mut start: Option<f64> = (margins[0] >= 0.0).then(|| x_of(0));
        for c in 1..=columns {
            let (a, b) = (margins[c - 1], margins[c]);
            if (a >= 0.0) != (b >= 0.0) {
                let part = if a.is_finite() && b.is_finite() { a / (a - b) } else { 0.5 };
                let x = x_of(c - 1) + part * step;
                match start.take() {
                    Some(from) => strip(&mut path, paper, from, x, y, step),
                    None => start = Some(x),
                }
            }
        }
        if let Some(from) = start {
            strip(&mut path, paper, from, x_of(columns), y, step);
        }
    }
    path
}

fn strip(path: &mut String, paper: &Paper, from: f64, to: f64, y: f64, step: f64) {
    let (x, end, top) = (paper.x(from), paper.x(to), paper.y(y + step / 2.0));
    let _ = write!(path, "M{x} {top}H{end}v3H{x}z");
}
