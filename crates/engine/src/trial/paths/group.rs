//! Paths of one width that begin at the same thing, and the corridors that are planned for them.

use super::{Flat, Span};

/// A corridor from where paths begin, or from another corridor of theirs, to a goal.
#[derive(Clone, Debug)]
pub(super) struct Branch {
    pub goal: usize,
    /// Whether it begins where the paths do.
    pub is_rooted: bool,
    /// Empty: there is none.
    pub bends: Vec<[f64; 2]>,
}

/// Paths of one width that begin at the same thing.
#[derive(Clone, Debug)]
pub struct PathGroup {
    pub(super) from: usize,
    /// What is to be reached: for each, things of which one will do.
    pub(super) targets: Vec<Vec<usize>>,
    pub(super) radius: f64,
    /// The preference that asks for them; `None`: they must be there.
    pub(super) preference: Option<usize>,
    /// By target; `None`: nothing is planned yet.
    pub(super) branches: Option<Vec<Branch>>,
    /// Where doors were when it was planned, and whether some are elsewhere now.
    pub(super) doors: Vec<[f64; 3]>,
    pub(super) stale: bool,
    /// The steps of all corridors, as rectangles without width.
    pub(super) steps: Vec<Flat>,
    /// What stands in the corridors, and what that costs.
    pub(super) lacks: Vec<(usize, f64)>,
    /// What it costs that ends are not where corridors begin, and that some targets have none.
    pub(super) off: f64,
    /// What surrounds the corridors.
    pub(super) bounds: Span,
    /// How much wider than asked for it is planned, since what was planned proved too narrow (metres).
    pub(super) doubt: f64,
}

impl PathGroup {
    pub(super) fn new(from: usize, goals: Vec<usize>, radius: f64, preference: Option<usize>) -> Self {
        Self {
            from,
            targets: vec![goals],
            radius,
            preference,
            branches: None,
            doors: Vec::new(),
            stale: false,
            steps: Vec::new(),
            lacks: Vec::new(),
            off: 0.0,
            bounds: Span::default(),
            doubt: 0.0,
        }
    }
    /// Half the width that is planned for.
    pub fn width(&self) -> f64 {
        self.radius + self.doubt
    }
    pub(super) fn is_planned(&self) -> bool {
        self.branches.is_some()
    }
    pub(super) fn branches(&self) -> &[Branch] {
        self.branches.as_deref().unwrap_or_default()
    }
    /// Its ends, each with where the corridor begins there.
    pub(super) fn stands(&self) -> impl Iterator<Item = (usize, [f64; 2])> + '_ {
        let begins =
            self.branches().iter().filter(|b| b.is_rooted).filter_map(|b| Some((self.from, *b.bends.first()?)));
        begins.chain(self.branches().iter().filter_map(|b| Some((b.goal, *b.bends.last()?))))
    }
    pub(super) fn has_end(&self, i: usize) -> bool {
        self.from == i || self.branches().iter().any(|b| b.goal == i)
    }
    /// Targets without a corridor.
    pub(super) fn unreached(&self) -> impl Iterator<Item = &Vec<usize>> {
        self.targets.iter().zip(self.branches()).filter(|(_, b)| b.bends.is_empty()).map(|(goals, _)| goals)
    }
    /// What surrounds the corridors, at any height.
    pub(super) fn surround(&self) -> Span {
        let r = self.width();
        let bends = || self.branches().iter().flat_map(|b| &b.bends);
        let least = |k: usize| bends().map(|p| p[k]).fold(f64::INFINITY, f64::min) - r;
        let most = |k: usize| bends().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max) + r;
        Span { min: [least(0), f64::NEG_INFINITY, least(1)], max: [most(0), f64::INFINITY, most(1)] }
    }
}
