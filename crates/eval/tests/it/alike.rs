//! Requests that mean the same hold of the same layouts: "X within d of every Y" and "every Y within d of X", judged on
//! random layouts.

use scenelang_formalize::as_said;
use scenelang_formalize::write::write;
use scenelang_lang::{Options, Program, compile_text};
use scenelang_layout::{Layout, Placement, Vec3};
use scenelang_verify::check;
use std::path::Path;

const CASES: usize = 500;
const LAYOUTS: usize = 4;
/// Things stand within so many metres of the origin.
const REACH: f64 = 3.0;

/// A choice that is the same each time.
struct Dice(u64);

impl Dice {
    fn part(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn upto(&mut self, n: usize) -> usize {
        ((self.part() * n as f64) as usize).min(n - 1)
    }
}

fn program(request: &str) -> Program {
    let text = write(&as_said(request));
    compile_text("room.scene", Path::new("room.scene"), &text, Options::default()).program.unwrap()
}

/// Whether what a program says of nearness holds of a layout.
fn holds(program: &Program, layout: &Layout) -> bool {
    let verdict = check(program, layout, &scenelang_verify::Options::default());
    let mut near = verdict.rows.iter().filter(|row| row.text.contains("near(")).peekable();
    assert!(near.peek().is_some(), "nothing is said of nearness");
    near.all(|row| row.satisfied.unwrap())
}

#[test]
fn every_one_of_them_on_random_layouts() {
    const FURNITURE: [&str; 6] = ["sofa", "wardrobe", "piano", "fridge", "bench", "locker"];
    let mut dice = Dice(11);
    let mut seen = [0; 2];
    for case in 0..CASES {
        let (thing, n, d) = (FURNITURE[dice.upto(FURNITURE.len())], 2 + dice.upto(2), 2 + dice.upto(3));
        let every = ["every", "each"][dice.upto(2)];
        let setting = format!("A hall with {n} desks and a {thing}. ");
        let of_every = program(&format!("{setting}The {thing} is within {d} m of {every} desk."));
        let by_one = program(&format!("{setting}Every desk is within {d} m of the {thing}."));
        for _ in 0..LAYOUTS {
            let mut at = || (2.0 * dice.part() - 1.0) * REACH;
            let objects = of_every.objects.iter().map(|object| {
                let placement = Placement {
                    pos: Vec3::new(at(), 0.0, at()),
                    rot: Vec3::new(0.0, 60.0 * at(), 0.0),
                    scale: Vec3::new(1.4, 0.7, 0.7),
                    parts: Vec::new(),
                    surface: None,
                    joints: Vec::new(),
                };
                (object.name.clone(), placement)
            });
            let layout = Layout { objects: objects.collect(), ..Layout::default() };
            let both = [&of_every, &by_one].map(|program| holds(program, &layout));
            assert_eq!(both[0], both[1], "case {case}: {setting}{every}, {d} m: {layout:?}");
            seen[usize::from(both[0])] += 1;
        }
    }
    assert!(seen.iter().all(|times| *times > CASES / 4), "both verdicts are to occur often: {seen:?}");
}
