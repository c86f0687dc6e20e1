//! Signatures of built-in functions, predicates and measures, as data: name, parameters, result, what it says.
//!
//! What they compute is not here. Functions are computed by the evaluator; what needs geometry is a [`BuiltIn`], whose
//! meaning is a file of `scenelang_verify::builtins`.

use crate::program::{Arg, ObjectId, RegionId};
use crate::types::Ty;
use scenelang_base::suggest::nearest;

/// One signature; a name may have several.
#[derive(Debug, PartialEq, Eq)]
pub struct Signature {
    pub name: &'static str,
    /// Parameter types. `Ty::Literal` stands for "a Number or a Degree, all alike".
    pub params: &'static [Ty],
    /// Whether the last parameter may be repeated.
    pub variadic: bool,
    /// Result. `Ty::Literal`: the type of the arguments.
    pub result: Ty,
    /// Names of the parameters, for signature help and messages.
    pub names: &'static str,
    /// One sentence.
    pub doc: &'static str,
    /// What computes it, if it needs geometry.
    pub built_in: Option<BuiltIn>,
}

/// What a built-in says of its arguments that others than the evaluator act upon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Nothing.
    Plain,
    /// The object given first is in the region or the object given second. An assertion of it at top level allows that an
    /// object and what contains it overlap.
    Containment,
    /// The object given first is a door in the walls of the regions that follow. An assertion of it at top level allows
    /// that it stands in them.
    Door,
}

macro_rules! built_ins {
    (
        functions {
            $($function:ident($($param:ident),* $(; $rest:ident)?) -> $of:ident, $labels:literal, $says:literal;)*
        }
        geometry {
            $($variant:ident $name:ident $role:ident {
                $(($($ty:ident),*) -> $result:ident, $names:literal, $doc:literal;)*
            })*
        }
    ) => {
        /// A built-in predicate or measure: what needs geometry. A predicate yields a truth, a measure metres or degrees.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum BuiltIn {
            $(
                #[doc = concat!("`", stringify!($name), "`")]
                $variant,
            )*
        }

        impl BuiltIn {
            /// Each of them, in the order of the table.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// Its name in programs.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => stringify!($name),)*
                }
            }
            /// What it yields: `Ty::Bool`, `Ty::Number` or `Ty::Degree`.
            pub const fn result(self) -> Ty {
                match self {
                    $(Self::$variant => [$(Ty::$result),*][0],)*
                }
            }
            /// What it says that others act upon.
            pub const fn role(self) -> Role {
                match self {
                    $(Self::$variant => Role::$role,)*
                }
            }
        }

        /// Every signature.
        pub const BUILT_INS: &[Signature] = &[
            $(Signature {
                name: stringify!($function),
                params: &[$(Ty::$param),*],
                variadic: { let rest: &[&str] = &[$(stringify!($rest))?]; !rest.is_empty() },
                result: Ty::$of,
                names: $labels,
                doc: $says,
                built_in: None,
            },)*
            $($(Signature {
                name: stringify!($name),
                params: &[$(Ty::$ty),*],
                variadic: false,
                result: Ty::$result,
                names: $names,
                doc: $doc,
                built_in: Some(BuiltIn::$variant),
            },)*)*
        ];
    };
}

built_ins! {
    functions {
        vec3(Number, Number, Number) -> Vector3, "x, y, z", "The vector (x, y, z).";
        rot(Degree, Degree, Degree) -> Rotation, "x, y, z", "The rotation about x, then z, then y, about the fixed world axes.";
        rand(Literal, Literal) -> Literal, "lo, hi", "A number drawn uniformly from [lo, hi], once, fixed by the seed.";
        oneOf(Literal, Literal; Literal) -> Literal, "a, b, …", "One of the numbers, drawn with equal chances, once, fixed by the seed.";
        oneOf(Vector3, Vector3; Vector3) -> Vector3, "a, b, …", "One of the vectors, drawn with equal chances, once, fixed by the seed.";
        oneOf(Rotation, Rotation; Rotation) -> Rotation, "a, b, …", "One of the rotations, drawn with equal chances, once, fixed by the seed.";
        oneOf(String, String; String) -> String, "a, b, …", "One of the texts, drawn with equal chances, once, fixed by the seed.";
        polygon(Vector3, Vector3, Vector3; Vector3) -> Polygon, "a, b, c, …", "A floor polygon; the heights of its points are ignored.";

        abs(Literal) -> Literal, "x", "The magnitude of x.";
        min(Literal, Literal; Literal) -> Literal, "x, y, …", "The least of the numbers.";
        max(Literal, Literal; Literal) -> Literal, "x, y, …", "The greatest of the numbers.";
        sqrt(Number) -> Number, "x", "The square root of x, which must not be negative.";
        sin(Degree) -> Number, "angle", "The sine.";
        cos(Degree) -> Number, "angle", "The cosine.";
        length(Vector3) -> Number, "v", "The length of v.";
        normalize(Vector3) -> Vector3, "v", "The unit vector along v, which must not be zero.";
        cross(Vector3, Vector3) -> Vector3, "a, b", "The vector product.";
        dot(Vector3, Vector3) -> Number, "a, b", "The scalar product.";
        angle(Vector3, Vector3) -> Degree, "a, b", "The angle between two directions, 0 to 180.";
        angle(Rotation, Rotation) -> Degree, "a, b", "The angle between two orientations, 0 to 180.";
        distance(Object, Object) -> Number, "a, b", "The distance between the centres, in metres.";
        distance(Object, Region) -> Number, "a, r", "The distance between the centres, in metres.";
        distance(Object, Vector3) -> Number, "a, p", "The distance from the centre to the point, in metres.";
        distance(Region, Object) -> Number, "r, a", "The distance between the centres, in metres.";
        distance(Region, Region) -> Number, "r, s", "The distance between the centres, in metres.";
        distance(Region, Vector3) -> Number, "r, p", "The distance from the centre to the point, in metres.";
        distance(Vector3, Object) -> Number, "p, a", "The distance from the point to the centre, in metres.";
        distance(Vector3, Region) -> Number, "p, r", "The distance from the point to the centre, in metres.";
        distance(Vector3, Vector3) -> Number, "p, q", "The distance between two points, in metres.";
    }
    geometry {
        Gap gap Plain {
            (Object, Object) -> Number, "a, b", "The distance between the surfaces: 0 when touching, negative when overlapping.";
            (Object, Region) -> Number, "a, r", "The horizontal distance from an object to the nearest wall, negative outside.";
            (Vector3, Region) -> Number, "p, r", "The horizontal distance from a point to the nearest wall, negative outside.";
        }
        WalkDistance walkDistance Plain {
            (Object, Object) -> Number, "a, b", "The length of the shortest walk from a to b for a person 0.5 m wide.";
        }
        Inside inside Containment {
            (Object, Region) -> Bool, "a, r", "The box of a lies in the region.";
            (Object, Object) -> Bool, "a, b", "The box of a lies within the box of b.";
        }
        Collides collides Plain {
            (Object, Object) -> Bool, "a, b", "The solids overlap by more than 1 mm.";
        }
        Connects connects Door {
            (Object, Region) -> Bool, "door, r", "The door sits in a wall of r and leads outside.";
            (Object, Region, Region) -> Bool, "door, r, s", "The door sits in the wall that r and s share.";
        }
        Reachable reachable Plain {
            (Object, Object, Number) -> Bool, "a, b, width", "A disc of that width can move on the floor from a to b.";
        }
        Visible visible Plain {
            (Object, Object) -> Bool, "a, b", "No other object stands between the centres.";
        }
        Clear clear Plain {
            (Object, Side, Number) -> Bool, "a, side, depth", "The space on that side of a is free to that depth.";
        }
        Opens opens Plain {
            (Object) -> Bool, "a", "The doors, lids and drawers of a open far enough to be useful.";
            (Object, Degree) -> Bool, "a, angle", "All hinged parts of a open by that angle.";
        }
        Opening opening Plain {
            (Object) -> Degree, "a", "The angle by which all hinged parts of a can be opened.";
        }
        Slides slides Plain {
            (Object, Number) -> Bool, "a, distance", "All sliding parts of a slide out by that distance.";
        }
        Sliding sliding Plain {
            (Object) -> Number, "a", "The distance by which all sliding parts of a slide out, in metres.";
        }
    }
}

impl BuiltIn {
    pub fn signatures(self) -> impl Iterator<Item = &'static Signature> {
        BUILT_INS.iter().filter(move |s| s.built_in == Some(self))
    }
    /// Whether it is a predicate; else it is a measure.
    pub const fn is_predicate(self) -> bool {
        matches!(self.result(), Ty::Bool)
    }
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|b| b.name() == name)
    }
    /// The object that it says is in a region, and the region.
    pub fn contained(self, args: &[Arg]) -> Option<(ObjectId, RegionId)> {
        match (self.role(), args) {
            (Role::Containment, [Arg::Object(object), Arg::Region(region)]) => Some((*object, *region)),
            _ => None,
        }
    }
}

/// The words that `clear` takes for a side.
pub const SIDES: &[(&str, crate::program::ObjectSide)] = {
    use crate::program::ObjectSide;
    &[
        ("front", ObjectSide::Front),
        ("behind", ObjectSide::Behind),
        ("left", ObjectSide::Left),
        ("right", ObjectSide::Right),
        ("above", ObjectSide::Above),
    ]
};

/// The signatures of a name; none if it is no built-in.
pub fn overloads(name: &str) -> impl Iterator<Item = &'static Signature> + use<'_> {
    BUILT_INS.iter().filter(move |s| s.name == name)
}

/// Whether a name is a built-in.
pub fn is_built_in(name: &str) -> bool {
    overloads(name).next().is_some()
}

/// Whether a built-in is a draw, so that each occurrence has a value of its own.
pub fn is_draw(name: &str) -> bool {
    matches!(name, "rand" | "oneOf")
}

impl Signature {
    /// Whether `count` arguments are enough and not too many.
    pub fn takes(&self, count: usize) -> bool {
        if self.variadic { count >= self.params.len() } else { count == self.params.len() }
    }
    /// The type of the parameter at `index`.
    pub fn param(&self, index: usize) -> Ty {
        self.params.get(index).or(self.params.last()).copied().unwrap_or(Ty::Error)
    }
}

/// What can be read of an object or a region by `.name`.
#[derive(Debug, PartialEq, Eq)]
pub struct Property {
    pub name: &'static str,
    /// Its type.
    pub ty: Ty,
    /// Whether it can be assigned.
    pub assignable: bool,
    /// One sentence.
    pub doc: &'static str,
}

macro_rules! properties {
    ($($name:ident $ty:ident $assignable:literal $doc:literal;)*) => {
        &[$(Property { name: stringify!($name), ty: Ty::$ty, assignable: $assignable, doc: $doc }),*]
    };
}

/// Properties of objects.
pub const OBJECT_PROPERTIES: &[Property] = properties! {
    pos Vector3 true "Centre of the bottom face, and pivot of the rotation (metres).";
    rot Rotation true "Orientation (degrees).";
    scale Vector3 true "Full extents: width, height, depth (metres).";
    color Color true "Its colour, as text.";
    material Material true "Its material, as text.";
    features String true "Its other features, as text.";
    category String true "What kind of object it is, as text.";
    role String true "What it is for, as text: `seat`, `table`, …; unless assigned, it follows from its category.";
    dimensions Vector3 true "The requested size: width, height, depth (metres).";
    center Vector3 false "Centre of its box.";
    size Vector3 false "The same as scale.";
    top Number false "Height of its highest point.";
    bottom Number false "Height of its lowest point.";
    surface Number false "Height of the surface that other objects stand on.";
    front Vector3 false "The direction that it faces: a unit vector.";
    right Vector3 false "The direction to its right: a unit vector.";
    up Vector3 false "Its upward direction: a unit vector.";
    min Vector3 false "Minimum corner of its box along the world axes.";
    max Vector3 false "Maximum corner of its box along the world axes.";
};

/// The set of all regions that are rooms, where no object or region is called so.
pub const ROOMS: &str = "rooms";

/// Properties of objects that are known without a layout, so that filters may read them.
pub const STATIC_PROPERTIES: [&str; 5] = ["category", "color", "material", "features", "role"];

/// Properties of regions.
pub const REGION_PROPERTIES: &[Property] = properties! {
    pos Vector3 true "The centre of its floor, or of the rectangle around it if it has `vertices`.";
    rot Rotation true "Orientation; only the rotation about y counts.";
    scale Vector3 true "Full extents: width, height, depth (metres).";
    vertices Polygon true "The floor polygon.";
    color Color true "Colour of the walls.";
    material Material true "Material of the walls.";
    features String true "Its other features; \"outdoor\": no walls, no ceiling.";
    floorColor Color true "Colour of the floor.";
    floorMaterial Material true "Material of the floor.";
    wallColor Color true "Colour of the walls.";
    wallMaterial Material true "Material of the walls.";
    floor Number false "Height of the floor.";
    ceiling Number false "Height of the ceiling.";
    area Number false "Area of the floor (square metres).";
    center Vector3 false "Centroid of the floor, at half the height.";
};

/// A property of a type, by name.
pub fn property(of: Ty, name: &str) -> Option<&'static Property> {
    let table = match of {
        Ty::Object => OBJECT_PROPERTIES,
        Ty::Region => REGION_PROPERTIES,
        _ => return None,
    };
    table.iter().find(|p| p.name == name)
}

/// The property that other tools call by this name, or one nearly like it.
pub fn property_called(ty: Ty, name: &str) -> Option<&'static str> {
    let of_both = [
        ("position", "pos"),
        ("location", "pos"),
        ("x", "pos.x"),
        ("y", "pos.y"),
        ("z", "pos.z"),
        ("rotation", "rot"),
        ("orientation", "rot"),
        ("angle", "rot.y"),
        ("yaw", "rot.y"),
        ("width", "scale.x"),
        ("height", "scale.y"),
        ("depth", "scale.z"),
        ("length", "scale.z"),
    ];
    let of_objects = [("type", "category"), ("kind", "category"), ("colour", "color"), ("forward", "front")];
    let all = of_both.iter().chain(of_objects.iter().filter(|_| ty == Ty::Object));
    let called = |word: &str| all.clone().find(|(other, _)| other.eq_ignore_ascii_case(word)).map(|(_, ours)| *ours);
    called(name).or_else(|| {
        let own = if ty == Ty::Object { OBJECT_PROPERTIES } else { REGION_PROPERTIES };
        let words = own.iter().map(|p| p.name).chain(all.clone().map(|(other, _)| *other));
        called(nearest(name, words)?)
    })
}
