//! Builds one [`Formula`]: equal nodes are shared, constants are folded where nothing can go wrong, and branches that a
//! static fact decides are cut as the language says (left to right).

use crate::program::{Arith, Axis, Formula, Node, NodeId};
use rustc_hash::{FxHashMap, FxHashSet, FxHasher};
use scenelang_base::TextRange;
use std::hash::{Hash, Hasher};

/// How many nodes are found by looking through their hashes.
const FIRST: usize = 16;

/// A formula under construction.
#[derive(Default)]
pub(super) struct Builder {
    nodes: Vec<Node>,
    ranges: Vec<TextRange>,
    /// Of the first nodes: most formulas are small, and looking through these takes less than making a map.
    hashes: Vec<u64>,
    shared: FxHashMap<u64, NodeId>,
    /// Nodes and members of lists, for the limit on a program's size.
    size: usize,
}

impl Builder {
    pub(super) fn size(&self) -> usize {
        self.size
    }

    pub(super) fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.0 as usize]
    }

    /// The place of a node.
    pub(super) fn range(&self, id: NodeId) -> TextRange {
        self.ranges[id.0 as usize]
    }

    /// Adds a node, or finds its equal. A hash met by a different node before only means that it is not shared.
    pub(super) fn add(&mut self, node: Node, range: TextRange) -> NodeId {
        let hash = hash(&node);
        let first = self.hashes.iter().position(|h| *h == hash).map(|i| NodeId(i as u32));
        if let Some(id) = first.or_else(|| self.shared.get(&hash).copied())
            && self.nodes[id.0 as usize] == node
        {
            return id;
        }
        let id = NodeId(self.nodes.len() as u32);
        self.size += 1;
        self.nodes.push(node);
        self.ranges.push(range);
        if self.hashes.len() < FIRST {
            self.hashes.push(hash);
        } else {
            self.shared.insert(hash, id);
        }
        id
    }

    pub(super) fn number(&mut self, x: f64, range: TextRange) -> NodeId {
        self.add(Node::Number(x), range)
    }

    /// The value of a node that is a constant number.
    pub(super) fn constant(&self, id: NodeId) -> Option<f64> {
        match self.node(id) {
            Node::Number(x) => Some(*x),
            _ => None,
        }
    }

    pub(super) fn neg(&mut self, id: NodeId, range: TextRange) -> NodeId {
        match self.constant(id) {
            Some(x) => self.number(-x, range),
            None => self.add(Node::Neg(id), range),
        }
    }

    pub(super) fn arith(&mut self, op: Arith, l: NodeId, r: NodeId, range: TextRange) -> NodeId {
        if let (Some(a), Some(b)) = (self.constant(l), self.constant(r)) {
            let x = match op {
                Arith::Add => a + b,
                Arith::Sub => a - b,
                Arith::Mul => a * b,
                Arith::Div => a / b,
            };
            if x.is_finite() {
                return self.number(x, range);
            }
        }
        self.add(Node::Arith(op, l, r), range)
    }

    /// A count of facts that no layout changes, as its number; anything else as it is.
    pub(super) fn tallied(&mut self, id: NodeId, range: TextRange) -> NodeId {
        let Node::Count(list) = self.node(id) else { return id };
        let known = list.iter().map(|member| match self.node(*member) {
            Node::Truth(truth) => Some(usize::from(*truth)),
            _ => None,
        });
        match known.sum::<Option<usize>>() {
            Some(number) => self.number(number as f64, range),
            None => id,
        }
    }

    pub(super) fn component(&mut self, axis: Axis, of: NodeId, range: TextRange) -> NodeId {
        match self.node(of) {
            Node::Vector(v) => v[axis as usize],
            _ => self.add(Node::Component(axis, of), range),
        }
    }

    pub(super) fn not(&mut self, id: NodeId, range: TextRange) -> NodeId {
        match self.node(id) {
            Node::Truth(t) => {
                let t = !t;
                self.add(Node::Truth(t), range)
            }
            Node::Not(inner) => *inner,
            _ => self.add(Node::Not(id), range),
        }
    }

    /// Conjunction (`all`) or disjunction: neutral members and repetitions vanish, a static deciding member ends the
    /// list.
    pub(super) fn junction(&mut self, all: bool, members: &[NodeId], range: TextRange) -> NodeId {
        let mut list: Vec<NodeId> = Vec::with_capacity(members.len());
        let mut seen: FxHashSet<NodeId> = FxHashSet::default();
        'members: for &m in members {
            let inner: Vec<NodeId> = match (all, self.node(m)) {
                (true, Node::And(list)) | (false, Node::Or(list)) => list.to_vec(),
                _ => vec![m],
            };
            for id in inner {
                match self.node(id) {
                    Node::Truth(t) if *t == all => {}
                    Node::Truth(_) => {
                        list.push(id);
                        break 'members;
                    }
                    _ if !seen.insert(id) => {}
                    _ => list.push(id),
                }
            }
        }
        self.size += list.len();
        match list.as_slice() {
            [] => self.add(Node::Truth(all), range),
            [only] => *only,
            _ if all => self.add(Node::And(list.into()), range),
            _ => self.add(Node::Or(list.into()), range),
        }
    }

    /// The part of the graph that `root` needs, as a formula of its own.
    pub(super) fn extract(&self, root: NodeId) -> Formula {
        self.extract_with_places(root).0
    }

    /// The same, and where each node went; `None`: the formula has no use for it.
    pub(super) fn extract_with_places(&self, root: NodeId) -> (Formula, Vec<Option<NodeId>>) {
        // Where a node goes: first only whether it does.
        let mut new: Vec<Option<NodeId>> = vec![None; root.0 as usize + 1];
        new[root.0 as usize] = Some(NodeId(0));
        let mut count = 0;
        for i in (0..new.len()).rev() {
            if new[i].is_some() {
                count += 1;
                self.nodes[i].for_each_child(|c| new[c.0 as usize] = Some(NodeId(0)));
            }
        }
        let mut nodes = Vec::with_capacity(count);
        let mut ranges = Vec::with_capacity(count);
        for i in 0..new.len() {
            if new[i].is_some() {
                new[i] = Some(NodeId(nodes.len() as u32));
                nodes.push(self.nodes[i].map_children(|c| new[c.0 as usize].unwrap_or(c)));
                ranges.push(self.ranges[i]);
            }
        }
        // The root comes last: all others are below it.
        (Formula { root: NodeId(nodes.len() as u32 - 1), nodes, ranges }, new)
    }
}

fn hash(node: &Node) -> u64 {
    let mut h = FxHasher::default();
    std::mem::discriminant(node).hash(&mut h);
    match node {
        Node::Number(x) => x.to_bits().hash(&mut h),
        Node::Truth(t) => t.hash(&mut h),
        Node::Object(p, id) => (p, id).hash(&mut h),
        Node::Region(p, id) => (p, id).hash(&mut h),
        Node::Variable(id) => id.hash(&mut h),
        Node::Draw(id) | Node::Choice(id, _) => id.hash(&mut h),
        Node::Arith(op, ..) => op.hash(&mut h),
        Node::Component(axis, _) => axis.hash(&mut h),
        Node::Call(f, _) => f.hash(&mut h),
        Node::Compare(c, u, ..) => (c, u).hash(&mut h),
        Node::AtLeast(n, _) => n.hash(&mut h),
        Node::BuiltIn(b, args) => {
            b.hash(&mut h);
            args.iter().for_each(|a| hash_arg(*a, &mut h));
        }
        Node::SamePolygon(id, _) => id.hash(&mut h),
        Node::Vector(_)
        | Node::Rotation(_)
        | Node::Neg(_)
        | Node::Same(..)
        | Node::And(_)
        | Node::Or(_)
        | Node::Not(_)
        | Node::Iff(..)
        | Node::Count(_) => {}
    }
    node.for_each_child(|c| c.hash(&mut h));
    h.finish()
}

fn hash_arg(arg: crate::program::Arg, h: &mut FxHasher) {
    use crate::program::Arg;
    match arg {
        Arg::Object(id) => (0u8, id.0).hash(h),
        Arg::Region(id) => (1u8, id.0).hash(h),
        Arg::Value(_) => 2u8.hash(h),
        Arg::Side(s) => (3u8, s).hash(h),
    }
}
