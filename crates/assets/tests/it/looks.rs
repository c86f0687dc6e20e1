//! How things look, over every family: places on materials, faces that share a plane, numbers of triangles, textures
//! without seams.

use crate::geometry::{bounds, corners, triangles};
use crate::nouns::{SHAPES, families, sizes, table, usual};
use scenelang_assets::textures::Texture;
use scenelang_assets::{
    Asset, AssetRequest, MeshGroup, color_names, covering, difference, furnish, material_names, on_floor, stand_out,
    toned,
};
use scenelang_layout::Vec3;

/// Factors of the usual size.
const FACTORS: [[f64; 3]; 5] = [[1.0; 3], [0.6; 3], [1.5; 3], [1.7, 1.0, 0.8], [0.8, 1.3, 1.2]];
/// Words that change shapes of many families.
const FEATURES: [&str; 3] = ["", "round glass modern", "wooden with drawers and doors"];
/// No more triangles than this.
const MOST: usize = 3000;

/// Every family, and every noun that a family draws in a shape of its own, in all sizes with all features, with a name for
/// messages.
pub fn all() -> impl Iterator<Item = (String, Asset)> {
    let shapes = SHAPES.iter().map(|noun| ((*noun).to_owned(), table()[*noun].size));
    usual().values().cloned().chain(shapes).flat_map(|(noun, usual)| {
        FACTORS.into_iter().flat_map(move |factor| {
            let noun = noun.clone();
            let size = usual.component_mul(&Vec3::from(factor));
            FEATURES.into_iter().map(move |features| {
                let request =
                    AssetRequest { name: "it", category: &noun, features, size: Some(size), ..AssetRequest::default() };
                (format!("{noun} ({features}) {:.2} × {:.2} × {:.2}", size.x, size.y, size.z), furnish(&request))
            })
        })
    })
}

pub fn report(bad: &[String]) {
    assert!(bad.is_empty(), "{} bad:\n{}", bad.len(), bad[..bad.len().min(600)].join("\n"));
}

fn wide(p: [f32; 3]) -> Vec3 {
    Vec3::from(p.map(f64::from))
}

/// The least and the greatest factor from lengths on a triangle to lengths on its material.
fn density(group: &MeshGroup, t: &[u32]) -> [f64; 2] {
    let [a, b, c] = [t[0], t[1], t[2]].map(|i| wide(group.positions[i as usize]));
    let [p, q, r] = [t[0], t[1], t[2]].map(|i| group.uvs[i as usize].map(f64::from));
    // In axes of the triangle's own plane.
    let along = (b - a).normalize();
    let across = (b - a).cross(&(c - a)).normalize().cross(&along);
    let (x1, x2, y2) = ((b - a).norm(), (c - a).dot(&along), (c - a).dot(&across));
    let column = |k: usize| {
        let (d1, d2) = (q[k] - p[k], r[k] - p[k]);
        [d1 / x1, (d2 - d1 / x1 * x2) / y2]
    };
    let ([ux, uy], [vx, vy]) = (column(0), column(1));
    // The singular values of the map.
    let (half, det) = ((ux * ux + uy * uy + vx * vx + vy * vy) / 2.0, ux * vy - uy * vx);
    let root = (half * half - det * det).max(0.0).sqrt();
    [(half - root).max(0.0).sqrt(), (half + root).sqrt()]
}

#[test]
fn a_metre_of_a_thing_is_a_metre_of_its_material_within_a_factor_of_two() {
    let mut bad = Vec::new();
    for (name, asset) in all() {
        let (mut least, mut most) = (f64::MAX, 0.0_f64);
        for group in &asset.mesh.groups {
            assert_eq!(group.uvs.len(), group.positions.len(), "{name}");
            assert!(group.uvs.iter().flatten().all(|c| c.is_finite()), "{name}");
            for t in group.indices.chunks_exact(3) {
                let [a, b, c] = [t[0], t[1], t[2]].map(|i| wide(group.positions[i as usize]));
                // Of slivers nothing is seen, and rounding rules them.
                if (b - a).cross(&(c - a)).norm() > 1e-7 {
                    let [lo, hi] = density(group, t);
                    (least, most) = (least.min(lo), most.max(hi));
                }
            }
        }
        if least < 0.5 || most > 1.02 {
            bad.push(format!("{name}: {least:.3} to {most:.3}"));
        }
    }
    report(&bad);
}

#[test]
fn boxes_are_exact_and_triangles_few() {
    let mut bad = Vec::new();
    for (name, asset) in all() {
        let want = (Vec3::new(-asset.size.x / 2.0, 0.0, -asset.size.z / 2.0), asset.size);
        let want = (want.0, want.0 + want.1);
        let (parts, mesh) = (bounds(asset.parts.iter().flat_map(corners)), asset.mesh.bounds().unwrap());
        for (what, (lo, hi)) in [("parts", parts), ("mesh", mesh)] {
            if (lo - want.0).amax() > 1e-4 || (hi - want.1).amax() > 1e-4 {
                bad.push(format!("{name}: {what} fill {lo:?} {hi:?}"));
            }
        }
        if asset.mesh.triangles() > MOST {
            bad.push(format!("{name}: {} triangles", asset.mesh.triangles()));
        }
    }
    report(&bad);
}

#[test]
fn no_noun_has_too_many_triangles() {
    let mut bad = Vec::new();
    for (noun, known) in table() {
        for features in ["", "with flowers"] {
            let size = Some(known.size);
            let asset =
                furnish(&AssetRequest { name: "it", category: noun, features, size, ..AssetRequest::default() });
            if asset.mesh.triangles() > MOST {
                bad.push(format!("{noun} ({features}): {} triangles", asset.mesh.triangles()));
            }
        }
    }
    report(&bad);
}

/// A triangle with its plane and the surface it shows.
struct Face {
    corners: [Vec3; 3],
    normal: Vec3,
    offset: f64,
    surface: usize,
}

/// Faces no farther from each other than this are in one plane (metres); less area than this (square metres) is not seen.
const NEAR: f64 = 1e-4;
pub const SEEN: f64 = 1e-4;

fn faces(asset: &Asset) -> Vec<Face> {
    let mut out = Vec::new();
    for (surface, group) in asset.mesh.groups.iter().enumerate() {
        let one = scenelang_assets::Mesh::from(vec![group.clone()]);
        for corners in triangles(&one) {
            let [a, b, c] = corners;
            if let Some(normal) = (b - a).cross(&(c - a)).try_normalize(SEEN / 50.0) {
                out.push(Face { corners, normal, offset: normal.dot(&a), surface });
            }
        }
    }
    out
}

/// What two triangles of one plane share: its area and its middle.
fn shared(one: &Face, other: &Face) -> Option<(f64, Vec3)> {
    let along = (one.corners[1] - one.corners[0]).normalize();
    let across = one.normal.cross(&along);
    let flat = |p: Vec3| [(p - one.corners[0]).dot(&along), (p - one.corners[0]).dot(&across)];
    let mut left: Vec<[f64; 2]> = other.corners.map(flat).to_vec();
    let clip = one.corners.map(flat);
    for i in 0..3 {
        let (a, b) = (clip[i], clip[(i + 1) % 3]);
        let inside = |p: &[f64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        let mut kept = Vec::new();
        for k in 0..left.len() {
            let (p, q) = (left[k], left[(k + 1) % left.len()]);
            let (s, t) = (inside(&p), inside(&q));
            if s >= 0.0 {
                kept.push(p);
            }
            if (s >= 0.0) != (t >= 0.0) {
                let at = s / (s - t);
                kept.push([p[0] + (q[0] - p[0]) * at, p[1] + (q[1] - p[1]) * at]);
            }
        }
        left = kept;
    }
    if left.len() < 3 {
        return None;
    }
    let area: f64 = (0..left.len())
        .map(|k| {
            let (p, q) = (left[k], left[(k + 1) % left.len()]);
            (p[0] * q[1] - p[1] * q[0]) / 2.0
        })
        .sum();
    let sum = left.iter().fold([0.0; 2], |s, p| [s[0] + p[0], s[1] + p[1]]);
    let middle = sum.map(|v| v / left.len() as f64);
    Some((area.abs(), one.corners[0] + along * middle[0] + across * middle[1]))
}

/// In how many solids of the mesh a point is: how often a ray leaves one, less how often it enters.
fn depth(faces: &[[Vec3; 3]], from: Vec3) -> i32 {
    let way = Vec3::new(0.3717, 0.8491, 0.3755);
    let mut count = 0;
    for [a, b, c] in faces {
        let (ab, ac) = (b - a, c - a);
        let normal = ab.cross(&ac);
        let slope = normal.dot(&way);
        if slope.abs() < 1e-18 {
            continue;
        }
        let t = normal.dot(&(a - from)) / slope;
        let p = from + way * t - a;
        let (u, v) = (ac.cross(&normal).dot(&p), normal.cross(&ab).dot(&p));
        let square = normal.norm_squared();
        let (u, v) = (u / square, v / square);
        if t > 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0 {
            count += if slope > 0.0 { 1 } else { -1 };
        }
    }
    count
}

/// The area of faces that are seen in one plane, and where the most of it is.
pub fn fighting(asset: &Asset) -> (f64, String) {
    let mut faces = faces(asset);
    let whole: Vec<[Vec3; 3]> = triangles(&asset.mesh).collect();
    faces.sort_by(|a, b| a.offset.total_cmp(&b.offset));
    let (mut sum, mut worst, mut place) = (0.0, 0.0, String::new());
    for (i, one) in faces.iter().enumerate() {
        let level = faces[i + 1..].iter().take_while(|other| other.offset < one.offset + NEAR);
        for other in level.filter(|o| o.normal.dot(&one.normal) > 1.0 - 1e-6) {
            let Some((area, middle)) = shared(one, other).filter(|(area, _)| *area > SEEN / 20.0) else { continue };
            if depth(&whole, middle + one.normal * 5e-4) <= 0 {
                sum += area;
                if area > worst {
                    let names = [one, other].map(|f| asset.mesh.groups[f.surface].surface.name.as_str());
                    worst = area;
                    let [x, y, z] = [middle.x, middle.y, middle.z];
                    place = format!("{} and {} at {x:.3} {y:.3} {z:.3}", names[0], names[1]);
                }
            }
        }
    }
    (sum, place)
}

#[test]
fn no_two_faces_are_seen_in_one_plane() {
    let mut bad = Vec::new();
    for (name, asset) in all() {
        let (area, place) = fighting(&asset);
        if area > SEEN {
            bad.push(format!("{name}: {area:.4} m² of {place}"));
        }
    }
    report(&bad);
}

#[test]
fn textures_have_no_seam_and_keep_the_colour() {
    for texture in Texture::all() {
        let pixels = texture.pixels();
        let [width, height] = pixels.size;
        assert_eq!(pixels.shade.len(), width * height);
        assert_eq!([pixels.normal.len(), pixels.rough.len()], [width * height; 2]);
        // Across the edge values differ by no more than elsewhere: the mean step and the greatest.
        let step = |a: usize, b: usize| (f64::from(pixels.shade[a]) - f64::from(pixels.shade[b])).abs();
        let mean = |steps: Vec<f64>| steps.iter().sum::<f64>() / steps.len() as f64;
        let columns = |x: usize| mean((0..height).map(|y| step(y * width + x, y * width + (x + 1) % width)).collect());
        let rows = |y: usize| mean((0..width).map(|x| step(y * width + x, (y + 1) % height * width + x)).collect());
        let most = |of: &dyn Fn(usize) -> f64, n: usize| (0..n - 1).map(of).fold(0.0, f64::max);
        for (edge, inner) in [(columns(width - 1), most(&columns, width)), (rows(height - 1), most(&rows, height))] {
            assert!(edge <= 1.2 * inner + 1.0, "{texture:?}: {edge} at the edge, {inner} within");
        }
        // Quiet: most of a texture is near its mean, and none of it is dark.
        let least = pixels.shade.iter().map(|s| pixels.ramp[usize::from(*s)][1]).min().unwrap();
        assert!(least > 90, "{texture:?}: {least}");
        let factor = pixels.factor([0.5, 0.4, 0.3]);
        for i in 0..3 {
            assert!((factor[i] * pixels.mean[i] - [0.5, 0.4, 0.3][i]).abs() < 1e-6, "{texture:?}");
        }
        assert!(pixels.normal.iter().all(|n| n[2] > 128), "{texture:?}: a normal points inward");
    }
}

#[test]
fn grain_runs_along_a_board() {
    let size = Some(Vec3::new(2.0, 0.75, 0.8));
    let table = furnish(&AssetRequest { category: "table", material: "oak", size, ..AssetRequest::default() });
    let wood = table.mesh.groups.iter().find(|g| g.surface.name.starts_with("wood-")).unwrap();
    // Of the top the second axis of the material is the long side, of a leg the upright.
    let along = |keep: &dyn Fn(Vec3) -> bool, axis: usize| {
        let kept: Vec<usize> = (0..wood.positions.len()).filter(|&i| keep(wide(wood.positions[i]))).collect();
        let spread = |of: &dyn Fn(usize) -> f64| {
            let values: Vec<f64> = kept.iter().map(|&i| of(i)).collect();
            values.iter().copied().fold(f64::MIN, f64::max) - values.iter().copied().fold(f64::MAX, f64::min)
        };
        (spread(&|i| f64::from(wood.uvs[i][1])), spread(&|i| wide(wood.positions[i])[axis]))
    };
    let (grain, length) = along(&|p| p.y > 0.749, 0);
    assert!((grain - length).abs() < 0.02 && length > 1.9, "{grain} of {length}");
}

#[test]
fn lamps_give_light_from_where_they_shine() {
    for noun in ["floor lamp", "table lamp", "desk lamp", "pendant", "ceiling light", "chandelier", "sconce"] {
        let size = sizes()[noun];
        let asset = furnish(&AssetRequest { category: noun, size: Some(size), ..AssetRequest::default() });
        let [light] = &asset.lights[..] else { panic!("{noun}: {:?}", asset.lights) };
        let inside = (0..3).all(|i| {
            let (lo, hi) = asset.mesh.bounds().unwrap();
            (lo[i]..=hi[i]).contains(&light.pos[i])
        });
        assert!(inside && light.lumens > 100.0 && light.color[0] > 0.5, "{noun}: {light:?}");
    }
    assert!(furnish(&AssetRequest { category: "monitor", ..AssetRequest::default() }).lights.is_empty());
}

/// Materials that floors are made of.
const FLOORS: [&str; 18] = [
    "oak",
    "walnut",
    "pine",
    "maple",
    "birch",
    "bamboo",
    "cork",
    "parquet",
    "laminate",
    "tile",
    "terracotta",
    "marble",
    "slate",
    "concrete",
    "limestone",
    "carpet",
    "linoleum",
    "vinyl",
];

#[test]
fn things_of_no_particular_colour_stand_out_against_every_floor() {
    let mut bad = Vec::new();
    for family in families() {
        let (noun, size) = &usual()[family];
        let asset = furnish(&AssetRequest { name: "it", category: noun, size: Some(*size), ..AssetRequest::default() });
        for material in FLOORS {
            assert!(material_names().any(|m| m == material), "{material}");
            let floor = on_floor(&toned(&covering("", material, "", "oak"))).color;
            let mut mesh = asset.mesh.clone();
            stand_out(&mut mesh, floor);
            // More than half of what is seen differs; glass and mirrors show other things.
            let (mut clear, mut all) = (0.0, 0.0);
            let shows_itself = |g: &&MeshGroup| g.surface.opacity >= 1.0 && !g.surface.name.starts_with("mirror-");
            for group in mesh.groups.iter().filter(shows_itself) {
                let one = scenelang_assets::Mesh::from(vec![group.clone()]);
                let area: f64 = triangles(&one).map(|[a, b, c]| (b - a).cross(&(c - a)).norm()).sum();
                all += area;
                clear += if difference(group.surface.color, floor) > 8.0 { area } else { 0.0 };
            }
            if clear < 0.5 * all {
                bad.push(format!("{noun} on {material}: {:.2}", clear / all));
            }
        }
    }
    report(&bad);
}

#[test]
fn every_line_of_the_tables_is_read() {
    let lines = |table: &str| table.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#')).count();
    assert_eq!(color_names().count(), lines(include_str!("../../src/colors.txt")));
    assert_eq!(material_names().count(), lines(include_str!("../../src/materials.txt")));
}

/// The surfaces of a chair that words describe.
fn chair(color: &str, material: &str) -> Vec<String> {
    let size = Some(Vec3::new(0.45, 0.9, 0.5));
    let asset = furnish(&AssetRequest { category: "chair", color, material, size, ..AssetRequest::default() });
    asset.mesh.groups.into_iter().map(|group| group.surface.name).collect()
}

#[test]
fn colour_words() {
    let surface = |text: &str| covering(text, "", "", "").name;
    for (text, want) in [
        ("#336699", "336699"),
        ("#fff", "ffffff"),
        ("Light Grey", "d3d3d3"),
        ("lightgray", "d3d3d3"),
        ("SteelBlue", "4682b4"),
        ("mustard yellow", "d2a32b"),
        ("white tops, grey steel frames", "f4f3ef"),
        ("oak and black", "c49b6b"),
        ("dark wood", "6b5033"),
        ("matte charcoal", "3a3d40"),
        ("forest green", "2f6b3c"),
        ("nothing known", "cccccc"),
        ("", "cccccc"),
    ] {
        assert_eq!(surface(text), format!("paint-{want}"), "{text}");
    }
    for (text, second) in [("white tops, grey steel frames", "8a8d91"), ("oak and black", "1f2022")] {
        let chair = chair(text, "");
        assert!(chair.iter().any(|name| name.ends_with(second)), "{text}: {chair:?}");
    }
}

#[test]
fn material_words() {
    let surface = |text: &str| covering("", text, "", "").name;
    for (text, want) in [
        ("oak", "wood-c49b6b"),
        ("oak and steel", "wood-c49b6b"),
        ("stainless steel", "metal-bcc1c5"),
        ("birch plywood", "wood-e4cfa9"),
        ("tempered glass", "glass-d4e8ec"),
        ("dark wood", "wood-6b5033"),
        ("unobtainium", "paint-cccccc"),
    ] {
        assert_eq!(surface(text), want, "{text}");
    }
    let chair = chair("", "oak and steel");
    assert!(chair.iter().any(|name| name == "metal-adb2b7"), "{chair:?}");
}
