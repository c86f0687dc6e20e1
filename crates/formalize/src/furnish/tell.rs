//! What the program says of things of the inventory that have found their places.

use super::floor::Pose;
use super::kinds::{Line, PlanPlace};
use super::plan::{Plan, metres};
use super::{choose, groups, place, stand};

/// A line of an inventory that has found its place.
pub(super) struct Stood<'a> {
    pub(super) line: &'a Line,
    pub(super) thing: usize,
    pub(super) poses: &'a [Pose],
    /// Where it should be.
    pub(super) nominal: Pose,
    /// Of several in a run: so far apart.
    pub(super) gap: f64,
    /// Whether it is on a wall, and how high.
    pub(super) hung: bool,
    pub(super) y: f64,
    /// What it is opposite of, and where that is.
    pub(super) opposite: Option<(String, Pose)>,
}

/// Says in the program where things of a line stand.
pub(super) fn tell(plan: &mut Plan, at: &Stood, why: &str) {
    let Stood { line, thing, poses, nominal, gap, hung, y, opposite } = at;
    let (hung, y) = (*hung, *y);
    let size = plan.draft.things[*thing].size.unwrap_or_default();
    let rectangular = plan.draft.rooms[plan.room].outline.is_none();
    let (name, n) = (plan.draft.things[*thing].name.clone(), plan.draft.things[*thing].count);
    let room = plan.room_name();
    let every = |f: &dyn Fn(&str) -> String| match n {
        1 => format!("assert {};", f(&name)),
        _ => format!("assert forall a in {name}: {};", f("a")),
    };
    let access = stand::access(line.noun).filter(|_| !choose::front_taken(line.noun)).map(metres);
    let used = |x: &str| access.as_ref().map_or(String::new(), |a| format!(" and clear({x}, front, {a})"));
    let at = poses.first().copied().unwrap_or(*nominal);
    let fixed = |at: &Pose| place::absolute(&name, &room, [at.x, at.y, at.z], at.yaw);
    // Against the wall to a millimetre, so that what is on the wall above it touches the wall, too; or against a railing.
    let near = metres(0.01 + plan.ground.as_ref().map_or(0.0, |ground| ground.edge));
    let back = |x: &str| format!("onFloor({x}, {room}) and backToWall({x}, {room}, {near})");
    let text = match &line.place {
        _ if hung && matches!(line.place, PlanPlace::Hung | PlanPlace::Wall) => {
            every(&|x| format!("wallMounted({x}, {room}) and {x}.bottom = {}", metres(y)))
        }
        PlanPlace::Wall | PlanPlace::Hung => every(&|x| format!("{}{}", back(x), used(x))),
        PlanPlace::Run if n == 1 => every(&|x| format!("{}{}", back(x), used(x))),
        PlanPlace::Run => {
            let step = metres(size[0] + gap);
            let first = format!("{name}[0]");
            plan.say(format!("assert {}{};", back(&first), used(&first)), why);
            format!(
                "assert forall i in 1..{n}: {name}[i].pos = {name}[0].pos + {name}[0].right * (i * {step}) and {name}[i].rot.y = {name}[0].rot.y;"
            )
        }
        PlanPlace::Corner if line.noun == "plant" => every(&|x| format!("onFloor({x}, {room})")),
        // It rocks, a little off the walls.
        PlanPlace::Corner if stand::moving(line.noun, size) != size => {
            let (yaw, behind) = (metres(at.yaw), metres(stand::BEHIND_ROCKING));
            every(&|x| format!("onFloor({x}, {room}) and {x}.rot.y = {yaw} and clear({x}, behind, {behind})"))
        }
        PlanPlace::Corner => every(&|x| format!("onFloor({x}, {room}) and inCorner({x}, {room})")),
        PlanPlace::Middle if n == 1 && rectangular => format!("assert {};", fixed(&at)),
        PlanPlace::Floor if n == 1 && rectangular && groups::is_visited(line.noun, plan.kind.dress) => {
            format!("assert {};", fixed(&at))
        }
        PlanPlace::Middle | PlanPlace::Floor => {
            let (yaw, off) = (metres(at.yaw), metres(off_walls(plan, poses, size)));
            every(&|x| format!("onFloor({x}, {room}) and gap({x}, {room}) >= {off} and {x}.rot.y = {yaw}"))
        }
        PlanPlace::Back(_) | PlanPlace::Front(_) | PlanPlace::Before(..) | PlanPlace::Service(_) if n == 1 => {
            format!("assert {};", fixed(&at))
        }
        PlanPlace::Before(..) | PlanPlace::Service(_) if poses.len() == n => {
            let each = poses
                .iter()
                .enumerate()
                .map(|(i, at)| place::absolute(&format!("{name}[{i}]"), &room, [at.x, at.y, at.z], at.yaw));
            format!("assert {};", each.collect::<Vec<_>>().join(" and "))
        }
        PlanPlace::Back(_) | PlanPlace::Front(_) | PlanPlace::Before(..) | PlanPlace::Service(_) => every(&|x| back(x)),
        PlanPlace::Opposite(_) => {
            let straight = |seen: &Pose| poses.first().is_none_or(|at| (seen.yaw - at.yaw).rem_euclid(360.0) == 180.0);
            if let Some((to, _)) = opposite.as_ref().filter(|(_, seen)| straight(seen)) {
                plan.say(
                    format!(
                        "prefer angle({name}.front, {to}.front) >= 175 and abs(dot({name}.center - {to}.center, {to}.right)) <= 0.3;"
                    ),
                    why,
                );
            }
            every(&|x| back(x))
        }
        PlanPlace::Ceiling | PlanPlace::Edge | PlanPlace::Rows(_) => return,
    };
    plan.say(text, why);
    if matches!(line.place, PlanPlace::Back(_) | PlanPlace::Front(_)) && hung {
        plan.say(every(&|x| format!("wallMounted({x}, {room})")), why);
    }
}

/// How far from the walls something stands: so far that the chairs at it can be pulled out, as far as the plan has it so.
fn off_walls(plan: &Plan, poses: &[Pose], [width, _, depth]: [f64; 3]) -> f64 {
    const LEAST: f64 = 0.6;
    const SEATED: f64 = 1.2;
    if !plan.has_chairs() {
        return LEAST;
    }
    let [w, _, d] = plan.draft.rooms[plan.room].size;
    let gap = |at: &Pose| {
        let [x, z] = if at.yaw.rem_euclid(180.0) == 0.0 { [width, depth] } else { [depth, width] };
        ((w - x) / 2.0 - at.x.abs()).min((d - z) / 2.0 - at.z.abs())
    };
    let planned = poses.iter().map(gap).fold(SEATED, f64::min);
    ((planned * 20.0).floor() / 20.0).max(LEAST)
}
