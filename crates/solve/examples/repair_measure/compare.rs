//! What `check` offers beside what `repair` offers: the same objects, the same places, and nothing broken?

use scenelang_engine::check;
use scenelang_lang::Program;
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Layout, Placement, Vec3};
use scenelang_solve::repair::{Alternative, Damaged, How, RepairOptions, Which, repair};
use scenelang_verify::explain::{RowRef, SmallestMove};
use scenelang_verify::report::model::RowKind;
use scenelang_verify::{Explain, Options};
use std::collections::BTreeSet;

/// Two targets closer than this are the same (metres; degrees count a hundredth of a metre each).
const SAME: f64 = 1e-3;

/// What two offers have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Agreement {
    /// The same objects at the same places.
    Same,
    /// The same objects, up to 5 cm apart.
    Near,
    /// The same objects, further apart.
    Far,
    /// Other objects.
    Other,
    /// Only `check` offers a move.
    OnlyCheck,
    /// Only `repair` does.
    OnlyRepair,
    /// Neither does.
    Neither,
}

/// One comparison.
#[derive(Clone, Copy, Debug)]
pub struct Compared {
    pub agreement: Agreement,
    /// How many rows the move of `check` breaks that held.
    pub breaks: usize,
    /// Whether `check` says that it breaks some.
    pub said: bool,
    /// How many rows the move of `repair` breaks.
    pub repair_breaks: usize,
}

/// What is offered for a layout as a whole, and for each row that fails.
pub struct Compare {
    pub layout: Compared,
    pub rows: Vec<Compared>,
}

/// Compares for a damaged layout; `None`: nothing fails that must hold.
pub fn compare(program: &Program, layout: &Layout) -> Option<Compare> {
    let mut options = Options::default();
    options.detail.explain = Explain::default();
    let verdict = check(program, layout, &options);
    let fails = verdict.rows.iter().filter(|r| r.satisfied == Some(false) && r.kind != RowKind::Prefer);
    let failing: Vec<(RowRef, Option<&SmallestMove>)> = fails
        .map(|r| (RowRef { kind: r.kind, subject: r.subject }, r.explanation.as_ref().and_then(|e| e.repair.as_ref())))
        .collect();
    let judged = Judged { program, layout, broken: failing_rows(program, layout) };
    let first = failing.first()?.1;
    let layout_wide = judged.compare(first, &Which::All);
    let rows = failing.iter().map(|(row, repair)| judged.compare(*repair, &Which::Rows(vec![*row]))).collect();
    Some(Compare { layout: layout_wide, rows })
}

/// All rows of a layout that fail, preferences too.
fn failing_rows(program: &Program, layout: &Layout) -> BTreeSet<RowRef> {
    let mut options = Options::default();
    options.detail.explain = Explain::First(0);
    let verdict = check(program, layout, &options);
    let fails = verdict.rows.iter().filter(|r| r.satisfied != Some(true));
    fails.map(|r| RowRef { kind: r.kind, subject: r.subject }).collect()
}

struct Judged<'a> {
    program: &'a Program,
    layout: &'a Layout,
    broken: BTreeSet<RowRef>,
}

impl Judged<'_> {
    fn compare(&self, offered: Option<&SmallestMove>, which: &Which) -> Compared {
        let damaged = Damaged { program: self.program, layout: self.layout, text: None };
        let found = repair(&damaged, which, &RepairOptions::default()).ok();
        let found = found.and_then(|f| f.alternatives.into_iter().find(|a| a.how == How::Moves));
        let moved = offered.map(|repair| self.after(repair));
        let breaks = |layout: &Layout| failing_rows(self.program, layout).difference(&self.broken).count();
        Compared {
            agreement: match (&moved, &found) {
                (None, None) => Agreement::Neither,
                (Some(_), None) => Agreement::OnlyCheck,
                (None, Some(_)) => Agreement::OnlyRepair,
                (Some(layout), Some(found)) => self.agreement(layout, found),
            },
            breaks: moved.as_ref().map_or(0, breaks),
            said: offered.is_some_and(|repair| !repair.breaks.is_empty()),
            repair_breaks: found.as_ref().map_or(0, |a| breaks(&a.layout)),
        }
    }

    /// The layout after a move that `check` offers.
    fn after(&self, repair: &SmallestMove) -> Layout {
        let mut layout = self.layout.clone();
        for step in &repair.steps {
            let name = self.name(step.object);
            if let Some((_, placed)) = layout.objects.iter_mut().find(|(n, _)| n == name) {
                placed.pos += Vec3::from(step.by);
                placed.rot.y += step.turn;
            }
        }
        layout
    }

    fn agreement(&self, checked: &Layout, repaired: &Alternative) -> Agreement {
        let differ = |layout: &Layout| -> BTreeSet<&str> {
            let names = self.program.objects.iter().map(|o| o.name.as_str());
            names.filter(|n| layout.object(n) != self.layout.object(n)).collect()
        };
        let (ours, theirs) = (differ(checked), differ(&repaired.layout));
        if ours != theirs {
            return Agreement::Other;
        }
        let apart = ours.iter().filter_map(|n| Some(distance(checked.object(n)?, repaired.layout.object(n)?)));
        match apart.fold(0.0, f64::max) {
            d if d <= SAME => Agreement::Same,
            d if d <= 0.05 => Agreement::Near,
            _ => Agreement::Far,
        }
    }

    fn name(&self, id: ObjectId) -> &str {
        &self.program.objects[id.0 as usize].name
    }
}

/// How far two places of an object are apart.
fn distance(a: &Placement, b: &Placement) -> f64 {
    let turn = (a.rot.y - b.rot.y).rem_euclid(360.0);
    (a.pos - b.pos).norm() + turn.min(360.0 - turn) / 100.0
}

/// The counts as a table: a line for each kind of agreement, then what breaks.
pub fn table(layouts: &[Compared], rows: &[Compared]) -> String {
    use Agreement::{Far, Near, Neither, OnlyCheck, OnlyRepair, Other, Same};
    let mut out = format!("{:44} {:>8} {:>8}\n", "check beside repair", "layouts", "rows");
    let mut line = |what: &str, test: &dyn Fn(&Compared) -> bool| {
        let count = |all: &[Compared]| all.iter().filter(|c| test(c)).count();
        out += &format!("{what:44} {:8} {:8}\n", count(layouts), count(rows));
    };
    for (kind, what) in [
        (Same, "the same move (1 mm)"),
        (Near, "the same objects, up to 5 cm apart"),
        (Far, "the same objects, further apart"),
        (Other, "other objects"),
        (OnlyCheck, "only check offers a move"),
        (OnlyRepair, "only repair offers a move"),
        (Neither, "neither does"),
    ] {
        line(what, &|c| c.agreement == kind);
    }
    line("the move of check breaks something", &|c| c.breaks > 0);
    line("  and check does not say so", &|c| c.breaks > 0 && !c.said);
    line("the move of repair breaks something", &|c| c.repair_breaks > 0);
    line("all", &|_| true);
    out
}
