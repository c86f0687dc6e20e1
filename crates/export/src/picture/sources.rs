//! Light that comes from somewhere in the room: from lamps, and through windows. It is weaker than daylight, throws no shadow and
//! ends at the walls of its room.

use super::raster::{dot, sub};
use crate::Scene;
use crate::glb::linear;
use crate::scene::{Lamp, Object, RegionKind};
use scenelang_layout::{Obb, Vec2, Vec3};

/// What a lamp of so many candela adds at a distance of one metre to a surface that faces it.
const LAMP: f32 = 0.16;
const USUAL: f64 = 60.0;
/// What a window adds to a surface close to it.
const WINDOW: f32 = 0.3;
/// Daylight from the sky, linear.
const SKY: [f32; 3] = [0.92, 0.97, 1.0];
/// How far light is looked at, metres.
const REACH: [f32; 2] = [2.2, 4.0];
/// No place near a source is brighter than at this distance from it, metres squared.
const NEAR: f32 = 0.12;
/// Light reaches this far into the wall of its room, metres.
const WALL: f64 = 0.02;

/// A source of light.
pub(super) struct Source {
    place: [f32; 3],
    /// What it adds in each colour at one metre.
    color: [f32; 3],
    /// Where a window looks, and its area (square metres). A lamp shines in all directions.
    faces: Option<([f32; 3], f32)>,
    reach: f32,
    /// The bounds of its room, x and z.
    room: [[f32; 2]; 2],
}

/// Those of a scene.
pub(super) fn of(scene: &Scene) -> Vec<Source> {
    let lamps = scene.lamps.iter().filter(|lamp| lamp.object.is_some()).filter_map(|lamp| Source::lamp(scene, lamp));
    let windows = scene.objects.iter().filter(|o| o.family == "window").filter_map(|o| Source::window(scene, o));
    lamps.chain(windows).collect()
}

impl Source {
    fn lamp(scene: &Scene, lamp: &Lamp) -> Option<Self> {
        let strength = LAMP * (lamp.candela / USUAL).min(2.0) as f32;
        let color = lamp.color.map(|c| linear(c) as f32 * strength);
        Some(Self { place: narrow(lamp.pos), color, faces: None, reach: REACH[0], room: room(scene, lamp.pos.xz())? })
    }

    /// The half of the sky that a window shows, on the side on which its room is.
    fn window(scene: &Scene, window: &Object) -> Option<Self> {
        let center = Obb::from_placement(&window.place).center;
        let front: Vec3 = window.axes.column(2).into();
        let inside = [front, -front].into_iter().find(|way| room(scene, (center + way * 0.3).xz()).is_some())?;
        let area = (window.place.scale.x * window.place.scale.y) as f32;
        Some(Self {
            place: narrow(center),
            color: SKY.map(|c| c * WINDOW),
            faces: Some((narrow(inside), area)),
            reach: REACH[1],
            room: room(scene, (center + inside * 0.3).xz())?,
        })
    }

    /// What it adds to a place whose surface faces a direction.
    pub fn at(&self, place: [f32; 3], normal: [f32; 3]) -> [f32; 3] {
        let way = sub(self.place, place);
        let square = dot(way, way);
        let [low, high] = self.room;
        let outside = |k: usize, at: f32| at < low[k] || at > high[k];
        if square > self.reach * self.reach || outside(0, place[0]) || outside(1, place[2]) {
            return [0.0; 3];
        }
        let far = square.max(1e-6).sqrt();
        let facing = (dot(way, normal) / far).max(0.0);
        // It fades out where it is no longer looked at.
        let fade = 1.0 - square / (self.reach * self.reach);
        let share = match self.faces {
            None => 1.0 / (square + NEAR),
            Some((ahead, area)) => {
                let shown = (-dot(way, ahead) / far).max(0.0);
                shown * area / (area + std::f32::consts::PI * square)
            }
        };
        self.color.map(|c| c * share * facing * fade)
    }
}

/// The bounds of the room over a point of the floor.
fn room(scene: &Scene, at: Vec2) -> Option<[[f32; 2]; 2]> {
    let rooms = scene.regions.iter().filter(|r| r.kind == RegionKind::Room);
    let polygon = rooms.map(|r| &r.prism.polygon).find(|polygon| polygon.contains(at))?;
    let (mut low, mut high) = (at, at);
    for corner in polygon.corners() {
        low = low.inf(corner);
        high = high.sup(corner);
    }
    let flat = |v: Vec2, by: f64| [(v.x + by) as f32, (v.y + by) as f32];
    Some([flat(low, -WALL), flat(high, WALL)])
}

fn narrow(v: Vec3) -> [f32; 3] {
    [v.x as f32, v.y as f32, v.z as f32]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(faces: Option<([f32; 3], f32)>) -> Source {
        Source { place: [0.0, 1.0, 0.0], color: [1.0; 3], faces, reach: 2.0, room: [[-1.5, -3.0], [3.0, 3.0]] }
    }

    #[test]
    fn light_falls_off_and_ends_at_the_walls() {
        let lamp = source(None);
        let up = [0.0, 1.0, 0.0];
        let [below, beside, far] = [0.0, 1.0, 1.6].map(|x| lamp.at([x, 0.0, 0.0], up)[0]);
        assert!(below > beside && beside > far && far > 0.0);
        assert_eq!(lamp.at([-1.6, 0.0, 0.0], up), [0.0; 3], "behind the wall");
        assert_eq!(lamp.at([0.0, 0.0, 0.0], [0.0, -1.0, 0.0]), [0.0; 3], "from behind");
        assert_eq!(lamp.at([2.1, 1.0, 0.0], [-1.0, 0.0, 0.0]), [0.0; 3], "too far");
    }

    #[test]
    fn a_window_lights_what_is_before_it() {
        let window = source(Some(([1.0, 0.0, 0.0], 1.5)));
        let wall = |x: f32| window.at([x, 1.0, 0.0], [-x.signum(), 0.0, 0.0])[0];
        assert!(wall(0.5) > wall(1.5) && wall(1.5) > 0.0);
        assert_eq!(wall(-0.5), 0.0);
    }
}
