//! A state that is taken back is what it was, to the last digit, and a mirror shows what it follows.

use crate::given::{judged, layout};
use scenelang_engine::{Mirror, Pose, State};
use scenelang_lang::program::{ObjectId, Program, RegionId, VariableId};
use scenelang_layout::Vec3;
use scenelang_verify::{Algebra, Dual, Number, Options, Value, World, evaluate};

const SCENE: &str = "
region room; object a; object b; object c; Number far;
assert a.pos.x + far > 0 and inside(b, room);
assert a.front.x > 0.2 or gap(b, c) > far;
assert room.area > 10 and b.top < 2;
";
const LAYOUT: &str = "
region room 0 0 0 | 5 2.6 4
object a 1 0 0.5 | 1 1 1 | 0 30 0
object b 0 0 1 | 0.5 1 0.5
object c -1 0.3 -1 | 0.5 0.5 0.5 | 0 77 0
value far 0.25
";

/// All margins, to the last digit.
fn margins<N: Number>(program: &Program, world: &World<N>) -> Vec<f64> {
    let margin = |value: Value<N>| if let Value::Truth(truth) = value { truth.margin.value() } else { f64::NAN };
    program.constraints.iter().map(|c| margin(evaluate(&c.formula, world).unwrap())).collect()
}

#[test]
fn what_is_taken_back_is_as_before_and_mirrors_follow() {
    let checked = judged(SCENE, &layout(LAYOUT), &Options::default());
    let (program, layout) = (checked.program.unwrap(), checked.layout.unwrap());
    let mut state = State::new(World::new(&program, &layout, &Options::default()));
    let mut mirror: Mirror<Dual<4>> = Mirror::of(&state);
    let mut home = margins(&program, state.world());
    let room = RegionId(0);
    for round in 0..60_u32 {
        let id = ObjectId(round % 3);
        let turn = f64::from(round);
        let pose = state.pose(id).unwrap();
        state.set_pose(id, &Pose { pos: pose.pos + Vec3::new(0.1, 0.0, 0.03 * turn), ..pose });
        // A second move of the same object, before anything is kept.
        state.set_pose(id, &state.pose(id).unwrap().facing(17.0 * turn));
        if round % 4 == 0 {
            let pose = state.region_pose(room).unwrap();
            state.set_region(room, &Pose { scale: pose.scale * 1.1, ..pose });
            state.set_variable(VariableId(0), Value::Number(0.01 * turn));
        }
        // What is put elsewhere for a look is back at the next one.
        mirror.set(ObjectId(1), pose.at(3.0, 0.0, 3.0).constant());
        mirror.set_variable(VariableId(0), Value::Number(Dual::constant(9.0)));
        mirror.catch_up(&state);
        assert_eq!(margins(&program, mirror.world()), margins(&program, state.world()), "round {round}");
        match round % 5 {
            0 => {
                state.keep();
                home = margins(&program, state.world());
            }
            1 | 3 => {
                assert!(state.moved().any(|(moved, _)| moved == id));
                state.undo();
                assert_eq!(margins(&program, state.world()), home, "round {round}");
                assert_eq!(state.moved().count(), 0);
            }
            _ => {}
        }
    }
}

#[test]
fn what_is_not_there_is_not_moved() {
    let checked = judged(SCENE, &layout("object a 1 0 0"), &Options::default());
    let program = checked.program.unwrap();
    let mut state = State::new(World::new(&program, &checked.layout.unwrap(), &Options::default()));
    let pose = state.pose(ObjectId(0)).unwrap();
    state.set_pose(ObjectId(2), &pose);
    state.set_region(RegionId(0), &pose);
    assert_eq!((state.pose(ObjectId(2)), state.home(ObjectId(2)), state.moved().count()), (None, None, 0));
    state.undo();
    let mut mirror: Mirror<f64> = Mirror::of(&state);
    mirror.moved(ObjectId(2));
    mirror.catch_up(&state);
}
