//! Plan and picture.

use crate::fixture::{named, scene};
use scenelang_export::picture::{self, Picture, PictureView};
use scenelang_export::scene::view::hangs_on;
use scenelang_export::scene::{Role, View};
use scenelang_export::{Exporter, Scene, plan};
use std::collections::BTreeSet;

/// A picture as it is read again.
struct Pixels {
    size: (u32, u32),
    /// Red, green, blue.
    all: Vec<[u8; 3]>,
}

impl Pixels {
    fn at(&self, x: u32, y: u32) -> [u8; 3] {
        self.all[(y * self.size.0 + x) as usize]
    }
}

fn png(bytes: &[u8]) -> Pixels {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    let all = bytes.chunks_exact(info.color_type.samples()).map(|p| [p[0], p[1], p[2]]).collect();
    Pixels { size: (info.width, info.height), all }
}

fn file(exporter: &dyn Exporter, scene: &Scene, name: &str) -> Vec<u8> {
    exporter.files(scene).unwrap().into_iter().find(|f| f.path.to_str() == Some(name)).unwrap().bytes
}

#[test]
fn the_plan_shows_every_object_and_region_by_name() {
    let scene = scene();
    let svg = plan::svg(&scene);
    for object in &scene.objects {
        assert!(svg.contains(&format!("data-object=\"{}\"", object.name)), "{}", object.name);
    }
    for region in &scene.regions {
        assert!(svg.contains(&format!("data-region=\"{}\"", region.name)), "{}", region.name);
    }
    assert_eq!(svg.matches("data-violated").count(), svg.matches("data-object=\"table\"").count());
    assert!(svg.contains(">4.00 m<") && svg.contains(">2.00 m<"), "rooms are measured");
    assert!(svg.contains("8 objects, 1 of 2 listed constraints hold"));
    assert!(svg.matches(" A ").count() == 1, "the door swings");
}

#[test]
fn the_plan_as_pixels_has_its_text_without_fonts_of_the_system() {
    let scene = scene();
    let picture = png(&file(&plan::Plan, &scene, "plan.png"));
    let dark = |x: u32, y: u32| picture.at(x, y).iter().all(|&c| c < 90);
    // The title stands at the upper left, where nothing else does.
    let title = (45..150).flat_map(|x| (20..55).map(move |y| (x, y))).filter(|&(x, y)| dark(x, y)).count();
    assert!(title > 100, "{title} dark pixels");
}

#[test]
fn names_cannot_break_out_of_the_plan() {
    let mut parts = crate::fixture::parts();
    parts.program.regions[2].name = "a\"><b>&".into();
    parts.layout.regions[2].0 = "a\"><b>&".into();
    let svg = plan::svg(&parts.build().unwrap());
    assert!(svg.contains("a&quot;&gt;&lt;b&gt;&amp;") && !svg.contains("<b>"));
    // Whatever script a name is in, the drawing is well-formed.
    plan::Plan.files(&named("größe灯").build().unwrap()).unwrap();
}

#[test]
fn a_wall_on_which_something_hangs_is_not_cut_away() {
    // A room with nothing else in it is seen from the side on which the picture's wall is at the back.
    for (pos, turn, out) in [
        ([0.0, 1.4, 1.98], 180.0, [0.0, 1.0]),
        ([0.0, 1.4, -1.98], 0.0, [0.0, -1.0]),
        ([1.98, 1.4, 0.0], 270.0, [1.0, 0.0]),
        ([-1.98, 1.4, 0.0], 90.0, [-1.0, 0.0]),
    ] {
        let mut parts = crate::fixture::parts();
        for (name, placement) in &mut parts.layout.objects {
            if name == "picture" {
                (placement.pos, placement.rot) = (pos.into(), [0.0, turn, 0.0].into());
            }
        }
        let mut scene = parts.build().unwrap();
        scene.objects.retain(|o| o.name == "picture");
        let view = View::of(&scene, 1.6);
        let way = view.eye - view.target;
        assert!(way.x * out[0] + way.z * out[1] < 0.0, "{pos:?}: {view:?}");
    }
}

#[test]
fn what_hangs_in_a_corner_hangs_on_the_wall_behind_it_alone() {
    // Otherwise it is left out of the picture when the wall beside it is cut away.
    for (pos, turn) in [([1.58, 1.4, 1.98], 180.0), ([-1.98, 1.4, -1.58], 90.0), ([-1.58, 1.4, -1.98], 0.0)] {
        let mut parts = crate::fixture::parts();
        for (name, placement) in &mut parts.layout.objects {
            if name == "picture" {
                (placement.pos, placement.rot) = (pos.into(), [0.0, turn, 0.0].into());
            }
        }
        let scene = parts.build().unwrap();
        let painting = scene.objects.iter().find(|o| o.name == "picture").unwrap();
        let walls: BTreeSet<String> = scene
            .shells
            .iter()
            .filter_map(|shell| match shell.role {
                Role::Wall { from, to } if hangs_on(painting, from, to) => Some(to - from),
                _ => None,
            })
            .map(|along| if along.x.abs() > along.y.abs() { "along x" } else { "along z" }.to_owned())
            .collect();
        assert_eq!(walls.len(), 1, "{pos:?}: {walls:?}");
    }
}

/// A quarter of the usual size: without optimisation the whole takes long.
fn small(view: PictureView) -> Picture {
    Picture { view, size: [640, 400] }
}

#[test]
fn someone_at_the_door_sees_walls_and_a_ceiling_all_round() {
    let scene = scene();
    let view = View::entering(&scene).unwrap();
    // The door of the hall, which is larger than the den, is at x = 2.03.
    assert!((view.eye.x - 1.7).abs() < 1e-6 && view.eye.y == 1.6 && view.eye.z.abs() < 1e-6, "{:?}", view.eye);
    let bytes = picture::png(&scene, small(PictureView::Eye)).unwrap();
    assert_eq!(bytes, picture::png(&scene, small(PictureView::Eye)).unwrap());
    let picture = png(&bytes);
    // Floor, walls and ceiling reach every edge of the picture: nothing of the pale sheet behind them is seen.
    let sheet = |p: [u8; 3]| p.iter().all(|&c| c > 225) && p[2] >= p[0];
    let rim = (0..640).flat_map(|x| [(x, 0), (x, 399)]).chain((0..400).flat_map(|y| [(0, y), (639, y)]));
    let seen = rim.filter(|&(x, y)| sheet(picture.at(x, y))).count();
    assert!(seen == 0, "{seen} pixels at the rim show what is outside");
    let blue = picture.all.iter().filter(|[r, g, b]| *b > 40 && u32::from(*b) > 2 * u32::from(*r.max(g))).count();
    assert!(blue > 1000, "the blue chairs are seen: {blue} pixels");
}

#[test]
fn from_above_everything_is_where_it_is_on_the_plan() {
    let scene = scene();
    let view = View::above(&scene, 1.6);
    let axes = view.axes();
    assert_eq!(axes.column(0).as_slice(), [1.0, 0.0, 0.0]);
    assert_eq!(axes.column(2).as_slice(), [0.0, -1.0, 0.0]);
    let picture = png(&picture::png(&scene, small(PictureView::Top)).unwrap());
    let is_blue = |[r, g, b]: [u8; 3]| b > 40 && u32::from(b) > 2 * u32::from(r.max(g));
    let blue: Vec<[f64; 2]> = (0..400)
        .flat_map(|y| (0..640).map(move |x| (x, y)))
        .filter(|&(x, y)| is_blue(picture.at(x, y)))
        .map(|(x, y)| [f64::from(x), f64::from(y)])
        .collect();
    let mean = |k: usize| blue.iter().map(|p| p[k]).sum::<f64>() / blue.len() as f64;
    let metres = (view.eye.y - 0.5) * 2.0 * (view.fov / 2.0).to_radians().tan() / 400.0;
    let at = [view.eye.x + (mean(0) - 320.0) * metres, view.eye.z - (mean(1) - 200.0) * metres];
    // Between the two chairs, which stand at x = ±0.4 and z = 1.
    assert!(at[0].abs() < 0.1 && (at[1] - 1.0).abs() < 0.15, "{at:?}");
}

#[test]
fn a_room_without_a_door_is_seen_from_a_corner_and_no_room_from_outside() {
    let mut parts = crate::fixture::parts();
    let door = parts.layout.objects.iter_mut().find(|(name, _)| name == "door").unwrap();
    door.1.pos.x = 0.0;
    let eye = View::entering(&parts.build().unwrap()).unwrap().eye;
    assert!((eye.x.abs() - 2.0).abs() < 0.3 && (eye.z.abs() - 2.0).abs() < 0.3, "{eye:?}");
    parts.program.regions.iter_mut().for_each(|region| region.texts.push(("features".into(), "outdoor".into())));
    let scene = parts.build().unwrap();
    assert!(View::entering(&scene).is_none());
    let [eye, iso] = [PictureView::Eye, PictureView::Iso].map(|view| picture::png(&scene, small(view)).unwrap());
    assert!(eye == iso);
}

#[test]
fn the_picture_shows_a_lit_room_on_a_pale_ground() {
    let bytes = picture::png(&scene(), small(PictureView::Iso)).unwrap();
    assert_eq!(bytes, picture::png(&scene(), small(PictureView::Iso)).unwrap());
    let picture = png(&bytes);
    assert_eq!(picture.size, (640, 400));
    let colors: BTreeSet<[u8; 3]> = picture.all.iter().copied().collect();
    assert!(colors.len() > 2000, "{} colours", colors.len());
    let corner = picture.at(2, 2);
    assert!(corner.iter().all(|&c| c > 200), "{corner:?}");
    let blue = picture.all.iter().filter(|[r, g, b]| *b > 40 && u32::from(*b) > 2 * u32::from(*r.max(g))).count();
    assert!(blue > 100, "the blue chairs are seen: {blue} pixels");
    let middle = picture.all.iter().filter(|p| p.iter().all(|&c| c < 250)).count();
    assert!(middle > 50_000, "the room fills the picture: {middle} pixels");
}
