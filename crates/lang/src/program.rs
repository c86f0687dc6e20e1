//! What the front end hands on: a [`Program`] of objects, regions, decision variables and constraints.
//!
//! Everything static is gone by now: arrays are elements, quantifiers are conjunctions, predicates and definitions are
//! put in place, names are numbers. A [`Formula`] is a small acyclic graph in one vector, children before parents and
//! equal nodes shared, so that it is evaluated by one walk over the vector, with any kind of number.
//!
//! Lengths are metres, angles degrees.

use crate::ast::Allow;
pub use crate::natives::BuiltIn;
use crate::overlaps::Overlaps;
pub use crate::wording::Wording;
use scenelang_base::{Span, TextRange};
use smol_str::SmolStr;
use std::borrow::Cow;
use std::sync::Arc;

/// Index into [`Program::objects`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ObjectId(pub u32);
/// Index into [`Program::regions`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RegionId(pub u32);
/// Index into [`Program::variables`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct VariableId(pub u32);
/// Index into [`Program::draws`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct DrawId(pub u32);
/// Index into [`Formula::nodes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeId(pub u32);

/// A compiled program.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// Objects in order of declaration, arrays as their elements (`chair[0]`, `chair[1]`, …).
    pub objects: Vec<Object>,
    /// Regions in order of declaration.
    pub regions: Vec<Region>,
    /// Decision variables: declared and never assigned, for the solver to choose. Assigned ones are put in place.
    pub variables: Vec<Variable>,
    /// Names of variables that are assigned (a layout's value for one of these is ignored).
    pub assigned_variables: Vec<SmolStr>,
    /// Their assignments, where a formula came to use them.
    pub definitions: Vec<Definition>,
    /// Occurrences of `rand` and `oneOf`, in order of their bounds' dependence: a draw's bounds use earlier draws only.
    pub draws: Vec<Draw>,
    /// Text properties that are drawn. Until [`Self::dressed`], each has the first of its texts.
    pub drawn_texts: Vec<DrawnText>,
    /// Assertions, preferences and pins, main file first, then imports, in source order.
    pub constraints: Vec<Constraint>,
    /// What the pins assign, for who wants to set it rather than check it.
    pub pins: Vec<Pin>,
    /// What the physical rules let pass.
    pub allow: Allowances,
}

/// An object, or an element of an array of objects.
#[derive(Clone, Debug)]
pub struct Object {
    /// As in the layout: `lamp`, `chair[0]`.
    pub name: SmolStr,
    /// The array it is an element of, and which.
    pub array: Option<(SmolStr, u32)>,
    /// Assigned text, or empty.
    pub color: String,
    /// Assigned text, or empty.
    pub material: String,
    /// Assigned text, or empty.
    pub features: String,
    /// Assigned text, or empty.
    pub category: String,
    /// Assigned text, or that of the category, or empty.
    pub role: String,
    /// The `dimensions` assigned (a vector), if any.
    pub dimensions: Option<Formula>,
    /// The declared name.
    pub span: Span,
    /// The documentation comment.
    pub doc: String,
    /// `@req` sentences of the declaration.
    pub requirements: Vec<String>,
}

impl Object {
    /// Whether a name stands for it: its own, or that of the array it is an element of.
    pub fn is_meant_by(&self, name: &str) -> bool {
        self.name == name || self.array.as_ref().is_some_and(|(array, _)| array == name)
    }
}

/// A region: a prism over a floor polygon.
#[derive(Clone, Debug)]
pub struct Region {
    /// As in the layout.
    pub name: SmolStr,
    /// Assigned text of `color material features floorColor floorMaterial wallColor wallMaterial`, where assigned.
    pub texts: Vec<(SmolStr, String)>,
    /// Whether the program assigns `vertices`.
    pub has_vertices: bool,
    /// Whether the program assigns `scale`.
    pub has_scale: bool,
    /// The declared name.
    pub span: Span,
    /// The documentation comment.
    pub doc: String,
    /// `@req` sentences of the declaration.
    pub requirements: Vec<String>,
}

impl Region {
    /// An assigned text property, or `""`.
    pub fn text(&self, property: &str) -> &str {
        self.texts.iter().find(|(p, _)| p == property).map_or("", |(_, t)| t)
    }
}

/// A decision variable.
#[derive(Clone, Debug)]
pub struct Variable {
    pub name: SmolStr,
    /// What it holds.
    pub kind: VariableKind,
    /// The declared name.
    pub span: Span,
    /// Whether any constraint uses it.
    pub used: bool,
}

/// An assignment to a variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Definition {
    /// The variable.
    pub name: SmolStr,
    /// The statement.
    pub span: Span,
    /// As written, blanks folded.
    pub text: String,
}

/// What a decision variable holds. The solver starts from 0, `false`, the zero vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VariableKind {
    /// In [−1e6, 1e6].
    Number,
    /// In [0, 360).
    Degree,
    /// True or false.
    Bool,
    /// Three numbers.
    Vector,
    /// Any orientation, as an Euler triple.
    Rotation,
}

/// One occurrence of `rand(lo, hi)`, or of `oneOf(…)`, after expansion.
#[derive(Clone, Debug)]
pub struct Draw {
    /// Its key in the layout: `lamp.pos/0`, `assert[2]/1`.
    pub key: String,
    /// The bounds: numbers that depend on no layout, on earlier draws at most.
    pub lo: Formula,
    /// See `lo`.
    pub hi: Formula,
    /// Whether it is the number of an argument of `oneOf`, counted from 0.
    pub is_choice: bool,
    /// The statement it stands in.
    pub span: Span,
}

/// A text property that `oneOf` chooses.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnText {
    /// Whose property.
    pub owner: Owner,
    /// Its name: `color`, `floorMaterial`.
    pub property: SmolStr,
    pub draw: DrawId,
    /// What it chooses from.
    pub texts: Vec<String>,
}

impl Program {
    /// The program with the texts that the draws of a layout choose. A draw that the layout does not have chooses the first.
    pub fn dressed(&self, draws: &[(String, f64)]) -> Cow<'_, Self> {
        if self.drawn_texts.is_empty() {
            return Cow::Borrowed(self);
        }
        let mut dressed = self.clone();
        for drawn in &self.drawn_texts {
            let key = &self.draws[drawn.draw.0 as usize].key;
            let chosen = draws.iter().find(|(known, _)| known == key).map_or(0, |(_, value)| *value as usize);
            if let Some(text) = drawn.texts.get(chosen) {
                dressed.set_text(drawn.owner, &drawn.property, text);
            }
        }
        Cow::Owned(dressed)
    }

    fn set_text(&mut self, owner: Owner, property: &str, text: &str) {
        match owner {
            Owner::Object(id) => {
                let object = &mut self.objects[id.0 as usize];
                match property {
                    "color" => object.color = text.to_owned(),
                    "material" => object.material = text.to_owned(),
                    _ => {}
                }
            }
            Owner::Region(id) => {
                let texts = &mut self.regions[id.0 as usize].texts;
                if let Some((_, own)) = texts.iter_mut().find(|(name, _)| name == property) {
                    text.clone_into(own);
                }
            }
        }
    }

    /// The draws that constraints and sizes depend on. The others, which choose texts that no statement reads, have no say in
    /// where anything is.
    pub fn draws_of_places(&self) -> Vec<DrawId> {
        let formulas = self.constraints.iter().map(|c| &c.formula).chain(self.allow.mounts.iter().map(|m| &m.formula));
        let values = self.pins.iter().flat_map(|p| &p.values).chain(self.objects.iter().flat_map(|o| &o.dimensions));
        let used = |formula: &Formula| formula.nodes.iter().filter_map(Node::draw).collect::<Vec<_>>();
        let mut found: Vec<DrawId> = formulas.chain(values).flat_map(used).collect();
        let mut seen = 0;
        while seen < found.len() {
            let draw = &self.draws[found[seen].0 as usize];
            found.extend(
                [&draw.lo, &draw.hi].into_iter().flat_map(used).filter(|id| !found.contains(id)).collect::<Vec<_>>(),
            );
            seen += 1;
        }
        found.sort_unstable();
        found.dedup();
        found
    }
}

/// A stated constraint: one row of a report.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// Hard, soft, or an assignment.
    pub kind: ConstraintKind,
    /// What must hold; its root is a truth.
    pub formula: Formula,
    /// From the statement's first keyword or target to its `;`, exclusive.
    pub span: Span,
    /// The formula as written, blanks folded (an assertion without its keyword, an assignment whole).
    pub text: String,
    /// `@req` sentences of the statement.
    pub requirements: Vec<String>,
    /// Assignments to variables that the formula was made with: indices into [`Program::definitions`], sorted.
    pub definitions: Vec<usize>,
    /// How to say what comparisons of the formula measured, by node; of the others their own text says it.
    pub wordings: Vec<Wording>,
    /// The guideline that it is an instance of, if it is one.
    pub guideline: Option<Guideline>,
}

/// A preference by a predicate of `std/guidelines.scene`, as far as it speaks of one thing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Guideline {
    /// The predicate.
    pub name: SmolStr,
    /// What it asks for: the documentation of the predicate.
    pub says: String,
    /// The thing.
    pub of: Option<ObjectId>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ConstraintKind {
    Assert,
    /// `prefer … weight w`, w > 0.
    Prefer {
        /// The weight, 1 by default.
        weight: f64,
    },
    /// An assignment to `pos`, `rot`, `scale`, `vertices` (or `dimensions` where no `scale` is assigned).
    Pin,
}

/// What an assignment fixes, with the value to fix it to.
#[derive(Clone, Debug)]
pub struct Pin {
    /// Whose property.
    pub owner: Owner,
    pub property: Pinned,
    /// Vector for `pos` and `scale`, rotation for `rot`; for `vertices` one vector per vertex (y ignored).
    pub values: Vec<Formula>,
    /// The row of the report it belongs to: an index into [`Program::constraints`].
    pub constraint: usize,
}

/// Owner of a pinned property.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Owner {
    Object(ObjectId),
    Region(RegionId),
}

/// A property that an assignment can fix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pinned {
    /// Position (metres).
    Pos,
    /// Euler triple (degrees).
    Rot,
    /// Full extents (metres).
    Scale,
    /// Floor polygon of a region.
    Vertices,
}

/// What the program says about the physical rules.
#[derive(Clone, Debug, Default)]
pub struct Allowances {
    /// Pairs that may overlap. (`inside` pairs are in `contents`.)
    pub collide: Arc<Overlaps>,
    /// Objects that may be outside every region, sorted.
    pub outside: Vec<ObjectId>,
    /// Objects that need no support, sorted.
    pub float: Vec<ObjectId>,
    /// `inside(a, b)` of two objects asserted at top level: (content, container).
    pub contents: Vec<(ObjectId, ObjectId)>,
    /// `wallMounted(a, r)` and `ceilingMounted(a, r)` asserted at top level: the formula that replaces P-SUPPORT.
    pub mounts: Vec<Mount>,
    /// `connects(d, r1, r2)` and `connects(d, r)` asserted at top level.
    pub doors: Vec<Door>,
    /// The statements that `collide`, `outside` and `float` come from, in source order.
    pub stated: Vec<Allowance>,
}

/// An `allow…` statement.
#[derive(Clone, Debug)]
pub struct Allowance {
    /// Which rule it lifts.
    pub rule: Allow,
    /// The objects that each argument stands for.
    pub arguments: Vec<Vec<ObjectId>>,
    /// From its word to its `;`, exclusive.
    pub span: Span,
    /// As written, blanks folded.
    pub text: String,
    /// `@req` sentences of the statement.
    pub requirements: Vec<String>,
}

/// An object held by a wall or a ceiling.
#[derive(Clone, Debug)]
pub struct Mount {
    pub object: ObjectId,
    /// The region whose wall or ceiling holds it.
    pub region: RegionId,
    /// Wall or ceiling.
    pub on: MountedOn,
    /// Holds where it touches (within 1 cm).
    pub formula: Formula,
}

/// What holds a mounted object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MountedOn {
    /// A wall of the region.
    Wall,
    Ceiling,
}

/// A door or opening in the wall of one region (to the outside) or shared by two.
#[derive(Clone, Debug)]
pub struct Door {
    pub object: ObjectId,
    /// One side.
    pub first: RegionId,
    /// The other side; `None`: the outside.
    pub second: Option<RegionId>,
}

/// A value or a truth as an acyclic graph: children stand before parents, equal nodes are shared.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    pub nodes: Vec<Node>,
    /// Where each node came from, relative to the start of the constraint's span (for inlined definitions and library
    /// predicates: the place that uses them). Same length as `nodes`.
    pub ranges: Vec<TextRange>,
    /// The value of the whole.
    pub root: NodeId,
}

impl Formula {
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.0 as usize]
    }
    pub fn root_node(&self) -> &Node {
        self.node(self.root)
    }
    /// Objects that it reads, sorted, each once.
    pub fn objects(&self) -> Vec<ObjectId> {
        let mut out = Vec::new();
        for node in &self.nodes {
            match node {
                Node::Object(_, id) => out.push(*id),
                Node::BuiltIn(_, args) => {
                    out.extend(args.iter().filter_map(|a| match a {
                        Arg::Object(id) => Some(*id),
                        _ => None,
                    }));
                }
                _ => {}
            }
        }
        out.sort_unstable();
        out.dedup();
        out
    }
}

/// One node of a [`Formula`]. A node is a number, a vector, a rotation, or a truth (a signed margin with its verdict).
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// A number (finite).
    Number(f64),
    /// A discrete truth: margin +∞ or −∞.
    Truth(bool),
    /// A vector of three numbers.
    Vector([NodeId; 3]),
    /// A rotation from three numbers, degrees: about x, then z, then y, fixed axes.
    Rotation([NodeId; 3]),
    Object(ObjectProperty, ObjectId),
    Region(RegionProperty, RegionId),
    /// A decision variable; its kind is that of the variable (a Bool is a discrete truth).
    Variable(VariableId),
    /// A recorded draw (number).
    Draw(DrawId),
    /// That of the values, all of one kind, whose number (from 0) is the draw.
    Choice(DrawId, Box<[NodeId]>),
    /// Minus a number or a vector.
    Neg(NodeId),
    /// Two numbers; two vectors (`+ −`); a vector and a number (`* /`); a number and a vector (`*`).
    Arith(Arith, NodeId, NodeId),
    /// A component of a vector, or of a rotation (degrees in [0, 360)).
    Component(Axis, NodeId),
    /// A function of numbers, vectors or rotations.
    Call(Function, Box<[NodeId]>),
    /// Comparison of two numbers; with [`Unit::Degree`], `=` and `!=` are modulo 360.
    Compare(Comparison, Unit, NodeId, NodeId),
    /// Equality of two vectors (distance ≤ 1 mm) or two rotations (angle ≤ 0.1°).
    Same(NodeId, NodeId),
    /// All hold: least margin. Left to right, a discrete falsehood ends it. Empty: holds, +∞.
    And(Box<[NodeId]>),
    /// One holds: greatest margin. Left to right, a discrete truth ends it. Empty: fails, −∞.
    Or(Box<[NodeId]>),
    /// Minus the margin, the opposite verdict.
    Not(NodeId),
    /// Equivalence: margin max(min(p, q), min(−p, −q)).
    Iff(NodeId, NodeId),
    /// How many of the truths hold, as a plain number.
    Count(Box<[NodeId]>),
    /// At least n hold: the n-th greatest margin (n = 0 or less: +∞; more than there are: −∞), truth by counting.
    AtLeast(u32, Box<[NodeId]>),
    /// A built-in predicate (truth) or measure (number, metres).
    BuiltIn(BuiltIn, Box<[Arg]>),
    /// The region's floor polygon is the one given, up to start vertex and winding, 1 mm per vertex (x and z).
    SamePolygon(RegionId, Box<[NodeId]>),
}

impl Node {
    /// The draw that it reads itself.
    pub fn draw(&self) -> Option<DrawId> {
        match self {
            Self::Draw(id) | Self::Choice(id, _) => Some(*id),
            _ => None,
        }
    }

    /// Calls `f` with each child, in order.
    pub fn for_each_child(&self, mut f: impl FnMut(NodeId)) {
        match self {
            Self::Number(_)
            | Self::Truth(_)
            | Self::Object(..)
            | Self::Region(..)
            | Self::Variable(_)
            | Self::Draw(_) => {}
            Self::Vector(v) | Self::Rotation(v) => v.iter().for_each(|c| f(*c)),
            Self::Neg(a) | Self::Component(_, a) | Self::Not(a) => f(*a),
            Self::Arith(_, a, b) | Self::Compare(_, _, a, b) | Self::Same(a, b) | Self::Iff(a, b) => {
                f(*a);
                f(*b);
            }
            Self::Call(_, list)
            | Self::And(list)
            | Self::Or(list)
            | Self::Count(list)
            | Self::AtLeast(_, list)
            | Self::Choice(_, list)
            | Self::SamePolygon(_, list) => list.iter().for_each(|c| f(*c)),
            Self::BuiltIn(_, args) => {
                for a in args {
                    if let Arg::Value(c) = a {
                        f(*c);
                    }
                }
            }
        }
    }

    /// The same node with its children replaced.
    pub fn map_children(&self, f: impl Fn(NodeId) -> NodeId) -> Self {
        let list = |l: &[NodeId]| l.iter().map(|c| f(*c)).collect::<Box<[NodeId]>>();
        let args = |l: &[Arg]| {
            let map = |a: &Arg| if let Arg::Value(c) = a { Arg::Value(f(*c)) } else { *a };
            l.iter().map(map).collect::<Box<[Arg]>>()
        };
        match self {
            Self::Number(_)
            | Self::Truth(_)
            | Self::Object(..)
            | Self::Region(..)
            | Self::Variable(_)
            | Self::Draw(_) => self.clone(),
            Self::Vector(v) => Self::Vector(v.map(f)),
            Self::Rotation(v) => Self::Rotation(v.map(f)),
            Self::Neg(a) => Self::Neg(f(*a)),
            Self::Component(axis, a) => Self::Component(*axis, f(*a)),
            Self::Not(a) => Self::Not(f(*a)),
            Self::Arith(op, a, b) => Self::Arith(*op, f(*a), f(*b)),
            Self::Compare(c, u, a, b) => Self::Compare(*c, *u, f(*a), f(*b)),
            Self::Same(a, b) => Self::Same(f(*a), f(*b)),
            Self::Iff(a, b) => Self::Iff(f(*a), f(*b)),
            Self::Call(x, l) => Self::Call(*x, list(l)),
            Self::And(l) => Self::And(list(l)),
            Self::Or(l) => Self::Or(list(l)),
            Self::Count(l) => Self::Count(list(l)),
            Self::AtLeast(n, l) => Self::AtLeast(*n, list(l)),
            Self::SamePolygon(r, l) => Self::SamePolygon(*r, list(l)),
            Self::Choice(d, l) => Self::Choice(*d, list(l)),
            Self::BuiltIn(b, a) => Self::BuiltIn(*b, args(a)),
        }
    }
}

/// An argument of a built-in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Arg {
    Object(ObjectId),
    Region(RegionId),
    /// A number or a vector.
    Value(NodeId),
    /// A side, of `clear`.
    Side(ObjectSide),
}

/// What can be read of an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ObjectProperty {
    /// Vector: centre of the bottom face, pivot of the rotation.
    Pos,
    /// Rotation.
    Rot,
    /// Vector: full extents.
    Scale,
    /// Vector: centre of the box.
    Center,
    /// Number: greatest height of the box.
    Top,
    /// Number: least height of the box.
    Bottom,
    /// Number: height of the support surface (`asset.surface` above the base where the layout gives it, else top).
    Surface,
    /// Vector: unit, where it faces (local +z).
    Front,
    /// Vector: unit, local +x.
    Right,
    /// Vector: unit, local +y.
    Up,
    /// Vector: least corner of the world-axis box.
    Min,
    /// Vector: greatest corner of the world-axis box.
    Max,
}

/// What can be read of a region.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RegionProperty {
    /// Vector.
    Pos,
    /// Rotation.
    Rot,
    /// Vector.
    Scale,
    /// Number: height of the floor.
    Floor,
    /// Number: height of the ceiling.
    Ceiling,
    /// Number: area of the floor, square metres.
    Area,
    /// Vector: centroid of the floor polygon, at half the height.
    Center,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Arith {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`; by zero: an error.
    Div,
}

/// A component.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    X,
    Y,
    Z,
}

/// Unit of a comparison, hence of a margin. Plain numbers count as metres.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unit {
    /// Metres and plain numbers.
    Metre,
    Degree,
}

/// Comparison operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Comparison {
    /// `=`
    Eq,
    /// `!=`
    Ne,
    /// `<`
    Lt,
    /// `<=`
    Le,
    /// `>`
    Gt,
    /// `>=`
    Ge,
}

impl Comparison {
    /// How it is written.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Eq => "=",
            Self::Ne => "!=",
            Self::Lt => "<",
            Self::Le => "<=",
            Self::Gt => ">",
            Self::Ge => ">=",
        }
    }
}

/// Functions of values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function {
    /// Of a number.
    Abs,
    /// Of two or more numbers.
    Min,
    /// Of two or more numbers.
    Max,
    /// Of a number ≥ 0; else an error.
    Sqrt,
    /// Of degrees.
    Sin,
    /// Of degrees.
    Cos,
    /// Length of a vector.
    Length,
    /// Unit vector; of the zero vector: an error.
    Normalize,
    /// Vector product (the left-handed frame has the same formula).
    Cross,
    /// Scalar product.
    Dot,
    /// Degrees between two vectors (a zero vector: an error) or two rotations.
    Angle,
    /// Distance of two points.
    Distance,
}

/// A side of an object, in its own frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ObjectSide {
    /// Local +z.
    Front,
    /// Local −z.
    Behind,
    /// Local −x.
    Left,
    /// Local +x.
    Right,
    /// Local +y.
    Above,
}
