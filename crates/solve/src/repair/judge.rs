//! What is to hold after a change, and whether it does: every layout that is offered is judged here as a whole.

use super::{Damaged, RepairOptions, Unjudged, Which};
use rustc_hash::FxHashSet;
use scenelang_engine::limit::Limit;
use scenelang_lang::Program;
use scenelang_lang::program::ObjectId;
use scenelang_layout::Layout;
use scenelang_verify::check::Judged;
use scenelang_verify::explain::RowRef;
use scenelang_verify::report::model::RowKind;
use scenelang_verify::{CheckVerdict, Detail, Explain, Options, check};

/// What is to be repaired, and what fails besides.
#[derive(Clone)]
pub(super) struct Judge<'a> {
    pub program: &'a Program,
    pub layout: &'a Layout,
    pub options: Options,
    /// Objects that stay where they are.
    pub locked: Vec<ObjectId>,
    /// When looking has to end.
    pub limit: Limit,
    /// Rows that fail and are to hold.
    pub targets: Vec<RowRef>,
    /// The layout, judged.
    pub verdict: CheckVerdict,
    /// All rows that fail.
    failing: FxHashSet<RowRef>,
}

/// The name of a row.
pub(super) fn row(judged: &Judged) -> RowRef {
    RowRef { kind: judged.kind, subject: judged.subject }
}

impl<'a> Judge<'a> {
    pub fn new(damaged: &Damaged<'a>, which: &Which, options: &RepairOptions) -> Result<Self, Unjudged> {
        let detail = Detail { all: false, sentences: false, explain: Explain::First(0), ..Detail::default() };
        let judging = Options { detail, ..options.judge };
        let verdict = check(damaged.program, damaged.layout, &judging);
        if verdict.rows.iter().any(|row| row.satisfied.is_none()) || verdict.diagnostics.iter().any(|d| d.is_error()) {
            return Err(Unjudged);
        }
        let failing: Vec<RowRef> = verdict.rows.iter().filter(|r| r.satisfied == Some(false)).map(row).collect();
        let wanted = |r: &RowRef| match which {
            Which::All => r.kind != RowKind::Prefer,
            Which::Rows(rows) => rows.contains(r),
        };
        Ok(Self {
            program: damaged.program,
            layout: damaged.layout,
            options: judging,
            locked: options.locked.clone(),
            limit: Limit::new(options.time, &options.stop),
            targets: failing.iter().copied().filter(wanted).collect(),
            failing: failing.into_iter().collect(),
            verdict,
        })
    }

    /// The same, but doors and windows stay where they are, too; `None`: nothing else is asked for, or there are none.
    pub fn holding_fittings(&self) -> Option<Self> {
        let objects = (0..).map(ObjectId).zip(&self.program.objects);
        let fittings =
            objects.filter(|(id, o)| matches!(o.role.as_str(), "door" | "window") && !self.locked.contains(id));
        let more: Vec<ObjectId> = fittings.map(|(id, _)| id).collect();
        let locked: Vec<ObjectId> = self.locked.iter().chain(&more).copied().collect();
        (!more.is_empty()).then(|| Self { locked, ..self.clone() })
    }

    /// Whether a row may fail after a change: it did before, and nobody asked to repair it.
    pub fn may_fail(&self, row: &RowRef) -> bool {
        self.failing.contains(row) && !self.targets.contains(row)
    }

    /// Whether a row fails in the layout.
    pub fn failed(&self, row: &RowRef) -> bool {
        self.failing.contains(row)
    }

    /// What a changed layout is worth; `None`: it does not repair, or breaks what must hold. Else the rows of preferences that
    /// held and do not any more.
    pub fn judge(&self, layout: &Layout) -> Option<Vec<RowRef>> {
        self.judge_with(self.program, layout, Some)
    }

    /// Whether an object is where the layout has it.
    fn stays(&self, id: ObjectId, layout: &Layout) -> bool {
        let name = &self.program.objects[id.0 as usize].name;
        match (self.layout.object(name), layout.object(name)) {
            (Some(was), Some(is)) => was.pos == is.pos && was.rot == is.rot,
            (was, is) => was.is_none() && is.is_none(),
        }
    }

    /// The same with another program; `as_before` says which row of ours a row of that one is, if any.
    pub fn judge_with(
        &self,
        program: &Program,
        layout: &Layout,
        as_before: impl Fn(RowRef) -> Option<RowRef>,
    ) -> Option<Vec<RowRef>> {
        let verdict = check(program, layout, &self.options);
        if verdict.diagnostics.iter().any(|d| d.is_error()) {
            return None;
        }
        if self.locked.iter().any(|id| !self.stays(*id, layout)) {
            return None;
        }
        let mut broken = Vec::new();
        for judged in verdict.rows.iter().filter(|r| r.satisfied != Some(true)) {
            let Some(row) = as_before(row(judged)) else { continue };
            if self.may_fail(&row) {
                continue;
            }
            if row.kind != RowKind::Prefer || self.targets.contains(&row) {
                return None;
            }
            broken.push(row);
        }
        Some(broken)
    }
}
