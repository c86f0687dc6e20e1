//! What the parts of a thing are made of, and what they weigh.
//!
//! The parts of furniture are closed solids, but furniture is not solid: a wardrobe is boards, a table leg may be a tube, a
//! fridge is sheet metal. So a part weighs as much as a skin of the usual thickness of its material over its whole surface,
//! and never more than if it were solid through and through. What is soft, or grows, counts as solid, with the density that
//! it has with all its air.

use crate::geometry::mesh::{MeshGroup, enclosed};
use scenelang_assets::Surface;
use scenelang_layout::{Convex, Vec3};

/// Kinds of material by the first word of a surface's name: kilograms per cubic metre, and the thickness of the skin in
/// metres.
const MATERIALS: [(&str, f64, f64); 27] = [
    ("wood", 600.0, 0.018),
    ("paint", 600.0, 0.018),
    ("metal", 7800.0, 0.0015),
    ("iron", 7800.0, 0.002),
    ("chrome", 7800.0, 0.0015),
    ("brass", 8500.0, 0.0015),
    ("fabric", 50.0, SOLID),
    ("velvet", 50.0, SOLID),
    ("leather", 60.0, SOLID),
    ("carpet", 250.0, SOLID),
    ("wicker", 300.0, 0.01),
    ("mesh", 300.0, 0.01),
    ("plastic", 1000.0, 0.004),
    ("rubber", 1100.0, 0.03),
    ("glass", 2500.0, 0.008),
    ("mirror", 2500.0, 0.006),
    ("ceramic", 2300.0, 0.01),
    ("stone", 2500.0, 0.03),
    ("paper", 700.0, 0.02),
    ("leaf", 15.0, SOLID),
    ("soil", 1400.0, SOLID),
    ("water", 1000.0, SOLID),
    ("glow", 1000.0, 0.004),
    ("screen", 1200.0, 0.02),
    ("plaster", 1200.0, 0.015),
    ("boards", 600.0, 0.018),
    ("tiles", 2300.0, 0.01),
];
/// No skin: solid.
const SOLID: f64 = f64::INFINITY;
/// The lightest part, kilograms: engines divide by masses.
const LIGHTEST: f64 = 0.01;
/// A triangle belongs to a part that it is no farther from than this, metres.
const NEAR: f64 = 0.002;

/// Kilograms of a part that looks so.
pub(super) fn weight(part: &Convex, surface: &Surface) -> f64 {
    let word = surface.name.split('-').next().unwrap_or_default();
    let (_, density, skin) = MATERIALS.iter().find(|(name, ..)| *name == word).copied().unwrap_or(MATERIALS[0]);
    let mut group = MeshGroup::new(0);
    group.solid(part);
    let area: f64 = group.triangles().map(area).sum();
    (density * enclosed(&group).min(area * skin)).max(LIGHTEST)
}

/// For each part the surface of most of what is drawn within it; where nothing is, of most of the thing.
pub(super) fn looks(parts: &[Convex], mesh: &[MeshGroup]) -> Vec<usize> {
    let triangles: Vec<(usize, Vec3, f64)> =
        mesh.iter().flat_map(|group| group.triangles().map(|t| (group.surface, middle(t), area(t)))).collect();
    let most = |within: &dyn Fn(&Vec3) -> bool| {
        let mut sums: Vec<(usize, f64)> = Vec::new();
        for (surface, _, area) in triangles.iter().filter(|(_, middle, _)| within(middle)) {
            match sums.iter_mut().find(|(known, _)| known == surface) {
                Some((_, sum)) => *sum += area,
                None => sums.push((*surface, *area)),
            }
        }
        sums.into_iter().reduce(|best, next| if next.1 > best.1 { next } else { best }).map(|(surface, _)| surface)
    };
    let whole = most(&|_| true).or(mesh.first().map(|g| g.surface)).unwrap_or_default();
    let of = |part: &Convex| {
        let around = part.aabb();
        let (min, max) = (around.min.add_scalar(-NEAR), around.max.add_scalar(NEAR));
        most(&|p| (0..3).all(|i| min[i] <= p[i] && p[i] <= max[i])).unwrap_or(whole)
    };
    parts.iter().map(of).collect()
}

fn wide(p: [f32; 3]) -> Vec3 {
    Vec3::from(p.map(f64::from))
}

fn middle(t: [[f32; 3]; 3]) -> Vec3 {
    t.map(wide).iter().sum::<Vec3>() / 3.0
}

fn area(t: [[f32; 3]; 3]) -> f64 {
    let [a, b, c] = t.map(wide);
    (b - a).cross(&(c - a)).norm() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_layout::{Obb, Placement};

    fn part(size: Vec3) -> Convex {
        let place = Placement {
            pos: Vec3::zeros(),
            rot: Vec3::zeros(),
            scale: size,
            parts: Vec::new(),
            surface: None,
            joints: Vec::new(),
        };
        Convex::from_box(&Obb::from_placement(&place))
    }

    fn of(name: &str) -> Surface {
        Surface { name: name.into(), color: [0.5; 3], roughness: 0.5, metallic: 0.0, emissive: None, opacity: 1.0 }
    }

    #[test]
    fn a_board_is_solid_and_a_case_is_not() {
        let board = weight(&part(Vec3::new(2.0, 0.018, 1.0)), &of("wood-c49b6b"));
        assert!((board - 600.0 * 0.036).abs() < 1e-4, "{board}");
        let case = weight(&part(Vec3::new(1.0, 2.0, 0.5)), &of("wood-c49b6b"));
        assert!((case - 600.0 * 7.0 * 0.018).abs() < 1e-4, "{case}");
        let cushion = weight(&part(Vec3::new(1.0, 0.4, 0.5)), &of("fabric-7f8b98"));
        assert!((cushion - 10.0).abs() < 1e-4, "{cushion}");
        assert_eq!(weight(&part(Vec3::repeat(1e-4)), &of("wood-c49b6b")), LIGHTEST);
    }

    #[test]
    fn every_finish_of_the_library_has_a_weight() {
        for material in scenelang_assets::material_names() {
            let name = scenelang_assets::covering("", material, "grey", "wood").name;
            let word = name.split('-').next().unwrap();
            assert!(MATERIALS.iter().any(|(known, ..)| *known == word), "{material}: {word}");
        }
    }

    #[test]
    fn a_part_looks_like_what_is_drawn_in_it() {
        let (top, leg) = (part(Vec3::new(1.0, 0.1, 1.0)), part(Vec3::new(0.1, 0.9, 0.1)));
        let leg = leg.moved(&nalgebra::Matrix3::identity(), &Vec3::new(0.0, -0.9, 0.0));
        let mut mesh = [MeshGroup::new(3), MeshGroup::new(5)];
        mesh[0].solid(&top);
        mesh[1].solid(&leg);
        let bare = part(Vec3::repeat(0.1)).moved(&nalgebra::Matrix3::identity(), &Vec3::new(9.0, 0.0, 0.0));
        assert_eq!(looks(&[top, leg, bare], &mesh), [3, 5, 3]);
    }
}
