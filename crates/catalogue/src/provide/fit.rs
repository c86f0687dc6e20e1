//! A model at the size that an object has to have.

use super::{ProvidedModel, Query, Remark, Why};
use crate::model::CatalogueModel;
use scenelang_layout::{Convex, Part, Vec3};

/// By how much a model is stretched more along one axis than along another, at most. Beyond it a chair looks wrong.
const STRETCH: f64 = 1.5;
/// A model whose unit is known is not made larger or smaller than by this factor: a chair for dolls is no chair.
const SCALE: f64 = 2.0;
/// The longest edge of what has no size at all (metres), as it is for furniture of the library.
const EDGE: f64 = 0.5;

/// Brings a model to the size that is wanted. `metric`: whether its own size is one in metres. Then it keeps its size
/// where the program demands none; otherwise it takes the usual one.
pub(super) fn fit(model: &CatalogueModel, query: &Query, metric: bool) -> Result<ProvidedModel, Remark> {
    let wanted = if metric { query.size } else { query.wanted() };
    let Some(wanted) = wanted else {
        let scale = if metric { 1.0 } else { EDGE / model.size.max() };
        if let Some(usual) = query.usual.filter(|_| metric) {
            let ratio = model.size.max() / usual.max();
            if !(1.0 / SCALE..=SCALE).contains(&ratio) {
                let say = format!(
                    "{}: it is {} m, but such objects are usually {} m",
                    model.file,
                    shown(&model.size),
                    shown(&usual)
                );
                return Err(Remark::new(Why::Size, say));
            }
        }
        return Ok(scaled(model, &Vec3::repeat(scale), model.size * scale));
    };
    let by = wanted.component_div(&model.size);
    let sizes = || format!("it is {} m, but {} m is required", shown(&model.size), shown(&wanted));
    if by.max() / by.min() > STRETCH {
        let say =
            format!("{}: it would be stretched by a factor of {:.2}; {}", model.file, by.max() / by.min(), sizes());
        return Err(Remark::new(Why::Size, say));
    }
    if metric && !(by.min() >= 1.0 / SCALE && by.max() <= SCALE) {
        return Err(Remark::new(Why::Size, format!("{}: {}", model.file, sizes())));
    }
    Ok(scaled(model, &by, wanted))
}

fn shown(size: &Vec3) -> String {
    format!("{:.2} × {:.2} × {:.2}", size.x, size.y, size.z)
}

fn scaled(model: &CatalogueModel, by: &Vec3, size: Vec3) -> ProvidedModel {
    let mut mesh = model.mesh.clone();
    if *by != Vec3::repeat(1.0) {
        let even = by.min() == by.max();
        for group in &mut mesh.groups {
            for p in &mut group.positions {
                *p = [0, 1, 2].map(|axis| (f64::from(p[axis]) * by[axis]) as f32);
            }
            if !even {
                for n in &mut group.normals {
                    let turned = Vec3::new(n[0].into(), n[1].into(), n[2].into()).component_div(by);
                    let turned = turned.try_normalize(1e-12).unwrap_or_else(Vec3::y);
                    *n = [turned.x as f32, turned.y as f32, turned.z as f32];
                }
            }
        }
    }
    let parts = model.parts.iter().filter_map(|p| part(p, by)).collect();
    ProvidedModel { size, parts, surface: None, joints: Vec::new(), mesh }
}

fn part(part: &Part, by: &Vec3) -> Option<Part> {
    let place = |p: &Vec3| p.component_mul(by);
    Some(match part {
        Part::Box { pos, size, rot } if *rot == Vec3::zeros() => {
            Part::Box { pos: place(pos), size: place(size), rot: *rot }
        }
        Part::Hull { points } => Part::Hull { points: points.iter().map(place).collect() },
        other => Part::Hull { points: Convex::from_part(other)?.vertices().iter().map(place).collect() },
    })
}
