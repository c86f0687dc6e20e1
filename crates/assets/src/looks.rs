//! Colours and materials: what the words mean, and what a surface made of them looks like.

use crate::mesh::Surface;
use crate::words::words;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// sRGB, each 0 to 1.
pub(crate) type Rgb = [f32; 3];

/// What a thing is made of, as far as light is concerned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Finish {
    Wood,
    Paint,
    Metal,
    Iron,
    Chrome,
    Brass,
    Fabric,
    Velvet,
    Leather,
    Carpet,
    Wicker,
    Mesh,
    Plastic,
    Rubber,
    Glass,
    Mirror,
    Ceramic,
    Stone,
    Paper,
    Leaf,
    Soil,
    Water,
    /// Gives light.
    Glow,
    /// A lit display.
    Screen,
    /// A wall as it is finished.
    Plaster,
    /// Wood laid as a floor.
    Boards,
    /// Ceramic laid on floors and walls.
    Tiles,
}

/// Name, roughness, metalness, opacity. Metal is kept half-way: viewers without surroundings to reflect show it black.
const FINISHES: &[(Finish, &str, f32, f32, f32)] = &[
    (Finish::Wood, "wood", 0.6, 0.0, 1.0),
    (Finish::Paint, "paint", 0.5, 0.0, 1.0),
    (Finish::Metal, "metal", 0.38, 0.55, 1.0),
    (Finish::Iron, "iron", 0.55, 0.3, 1.0),
    (Finish::Chrome, "chrome", 0.15, 0.7, 1.0),
    (Finish::Brass, "brass", 0.3, 0.6, 1.0),
    (Finish::Fabric, "fabric", 0.95, 0.0, 1.0),
    (Finish::Velvet, "velvet", 0.8, 0.0, 1.0),
    (Finish::Leather, "leather", 0.5, 0.0, 1.0),
    (Finish::Carpet, "carpet", 1.0, 0.0, 1.0),
    (Finish::Wicker, "wicker", 0.85, 0.0, 1.0),
    (Finish::Mesh, "mesh", 0.9, 0.0, 1.0),
    (Finish::Plastic, "plastic", 0.45, 0.0, 1.0),
    (Finish::Rubber, "rubber", 0.85, 0.0, 1.0),
    (Finish::Glass, "glass", 0.06, 0.0, 0.32),
    (Finish::Mirror, "mirror", 0.04, 0.8, 1.0),
    (Finish::Ceramic, "ceramic", 0.18, 0.0, 1.0),
    (Finish::Stone, "stone", 0.55, 0.0, 1.0),
    (Finish::Paper, "paper", 0.9, 0.0, 1.0),
    (Finish::Leaf, "leaf", 0.7, 0.0, 1.0),
    (Finish::Soil, "soil", 1.0, 0.0, 1.0),
    (Finish::Water, "water", 0.05, 0.0, 0.55),
    (Finish::Glow, "glow", 0.6, 0.0, 1.0),
    (Finish::Screen, "screen", 0.2, 0.0, 1.0),
    (Finish::Plaster, "plaster", 0.9, 0.0, 1.0),
    (Finish::Boards, "boards", 0.55, 0.0, 1.0),
    (Finish::Tiles, "tiles", 0.22, 0.0, 1.0),
];

// A finish is found by its index, so the table must be in the order of the type.
const _: () = {
    let mut i = 0;
    while i < FINISHES.len() {
        assert!(FINISHES[i].0 as usize == i);
        i += 1;
    }
};

/// A finish and a colour (0xrrggbb).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stuff(pub Finish, pub u32);

impl Stuff {
    pub fn surface(self) -> Surface {
        surface(self.0, rgb(self.1))
    }
}

/// The usual stuff of furniture.
pub(crate) mod stuff {
    use super::{Finish::*, Stuff};
    pub const OAK: Stuff = Stuff(Wood, 0xc49b6b);
    pub const WALNUT: Stuff = Stuff(Wood, 0x74503a);
    pub const BIRCH: Stuff = Stuff(Wood, 0xe4cfa9);
    pub const WHITE: Stuff = Stuff(Paint, 0xf1f0ec);
    pub const GRAY: Stuff = Stuff(Paint, 0xb9bcbf);
    pub const STEEL: Stuff = Stuff(Metal, 0xb4b9be);
    pub const BLACK_STEEL: Stuff = Stuff(Iron, 0x2e3135);
    pub const CHROME: Stuff = Stuff(Chrome, 0xcdd2d6);
    pub const BRASS: Stuff = Stuff(Brass, 0xb9964f);
    pub const LINEN: Stuff = Stuff(Fabric, 0xe6dfd2);
    pub const SHEET: Stuff = Stuff(Fabric, 0xf3f1ec);
    pub const CLOTH: Stuff = Stuff(Fabric, 0x7f8b98);
    pub const DARK_CLOTH: Stuff = Stuff(Fabric, 0x3c434b);
    pub const PLASTIC: Stuff = Stuff(Plastic, 0xe4e6e7);
    pub const DARK_PLASTIC: Stuff = Stuff(Plastic, 0x26282b);
    pub const GRAY_PLASTIC: Stuff = Stuff(Plastic, 0x8b9096);
    pub const RUBBER: Stuff = Stuff(Rubber, 0x2a2b2d);
    pub const GLASS: Stuff = Stuff(Glass, 0xcfe4ea);
    pub const MIRROR: Stuff = Stuff(Mirror, 0xd9e4e8);
    pub const CERAMIC: Stuff = Stuff(Ceramic, 0xf4f4f1);
    pub const STONE: Stuff = Stuff(Stone, 0xd5d0c6);
    pub const PAPER: Stuff = Stuff(Paper, 0xf4f0e6);
    pub const CARDBOARD: Stuff = Stuff(Paper, 0xbd9462);
    pub const LEAF: Stuff = Stuff(Leaf, 0x4c7d43);
    pub const SOIL: Stuff = Stuff(Soil, 0x44342a);
    pub const SCREEN: Stuff = Stuff(Screen, 0x1d2733);
    pub const WARM: Stuff = Stuff(Glow, 0xffe9c4);
    pub const GREEN_LIGHT: Stuff = Stuff(Glow, 0x19a35a);
    pub const RED: Stuff = Stuff(Paint, 0xc22f2a);
}

/// A colour from 0xrrggbb.
pub(crate) fn rgb(hex: u32) -> Rgb {
    [hex >> 16, hex >> 8, hex].map(|c| (c & 0xff) as f32 / 255.0)
}

pub(crate) fn surface(finish: Finish, color: Rgb) -> Surface {
    let (_, name, roughness, metallic, opacity) = FINISHES[finish as usize];
    let [r, g, b] = color.map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8);
    let color = [r, g, b].map(|c| f32::from(c) / 255.0);
    let emissive = match finish {
        Finish::Glow => Some(color),
        Finish::Screen => Some(color.map(|c| c * 0.6)),
        _ => None,
    };
    Surface { name: format!("{name}-{r:02x}{g:02x}{b:02x}"), color, roughness, metallic, emissive, opacity }
}

/// Off-white, a little darker than usual walls, so that it is seen at their foot (sRGB).
const SKIRTING: [f32; 3] = [0.85, 0.83, 0.79];

/// The surface of a colour and a material as texts name them, else the usual ones.
pub fn covering(color: &str, material: &str, usual_color: &str, usual_material: &str) -> Surface {
    let usual = materials(usual_material).first().map_or(Finish::Paint, |m| m.0);
    let (finish, own) = materials(material)
        .first()
        .copied()
        .unwrap_or_else(|| (usual, colors(usual_color).first().copied().unwrap_or([0.8; 3])));
    surface(finish, colors(color).first().copied().unwrap_or(own))
}

/// A floor of a material in no particular colour: paler than furniture of the same wood, and darker than white things.
pub fn toned(s: &Surface) -> Surface {
    let toward = |target: f32, by: f32| s.color.map(|c| c + (target - c) * by);
    let is_dark = s.color[0] < 0.6;
    if is(s, Finish::Wood) && is_dark {
        // White would take the colour out of it.
        surface(Finish::Wood, s.color.map(|c| 1.35 * c))
    } else if is(s, Finish::Wood) {
        surface(Finish::Wood, toward(1.0, 0.3))
    } else if is(s, Finish::Plastic) {
        surface(Finish::Plastic, toward(0.0, 0.13))
    } else if is(s, Finish::Ceramic) {
        surface(Finish::Ceramic, toward(0.0, 0.13))
    } else if is(s, Finish::Stone) {
        surface(Finish::Stone, toward(0.0, 0.1))
    } else {
        s.clone()
    }
}

/// A surface as it covers a floor: wood is laid in boards, ceramic in tiles.
pub fn on_floor(s: &Surface) -> Surface {
    laid(s, &[(Finish::Wood, Finish::Boards), (Finish::Ceramic, Finish::Tiles)])
}

/// A surface as it covers a wall: ceramic is laid in tiles, and what is painted is plaster.
pub fn on_wall(s: &Surface) -> Surface {
    laid(s, &[(Finish::Ceramic, Finish::Tiles), (Finish::Paint, Finish::Plaster)])
}

/// The board at the foot of a wall: painted, where the floor is of boards, carpet, laminate or linoleum and the wall is
/// plastered. There is none on concrete and stone, at tiled walls and at those of brick.
pub fn skirting(floor: &Surface, wall: &Surface) -> Option<Surface> {
    let any = |s: &Surface, finishes: &[Finish]| finishes.iter().any(|finish| is(s, *finish));
    let has =
        any(floor, &[Finish::Boards, Finish::Carpet, Finish::Plastic]) && any(wall, &[Finish::Plaster, Finish::Paper]);
    has.then(|| surface(Finish::Paint, SKIRTING))
}

fn laid(s: &Surface, table: &[(Finish, Finish)]) -> Surface {
    table.iter().find(|(from, _)| is(s, *from)).map_or_else(|| s.clone(), |(_, to)| surface(*to, s.color))
}

/// The same finish, darker (< 1) or towards white (> 1).
pub(crate) fn shade(s: &Surface, by: f32) -> Surface {
    let finish = FINISHES.iter().find(|f| is(s, f.0));
    surface(finish.map_or(Finish::Paint, |f| f.0), tinted_by(s.color, by))
}

/// A colour, darker (< 1) or towards white (> 1).
pub(crate) fn tinted_by(color: Rgb, by: f32) -> Rgb {
    color.map(|c| if by <= 1.0 { c * by } else { 1.0 - (1.0 - c) / by })
}

/// Whether a colour could be that of bare wood: brown to cream, not too vivid.
pub(crate) fn woody([r, g, b]: Rgb) -> bool {
    r > g && g > b && (0.45..0.92).contains(&(g / r)) && (0.15..0.66).contains(&((r - b) / r))
}

/// Whether a surface is of this finish.
pub(crate) fn is(s: &Surface, finish: Finish) -> bool {
    s.name.strip_prefix(FINISHES[finish as usize].1).is_some_and(|rest| rest.starts_with('-'))
}

static COLORS: LazyLock<BTreeMap<&str, u32>> = LazyLock::new(|| {
    lines(include_str!("colors.txt")).filter_map(|l| Some((l[0], u32::from_str_radix(l.get(1)?, 16).ok()?))).collect()
});

static MATERIALS: LazyLock<BTreeMap<&str, Stuff>> = LazyLock::new(|| {
    lines(include_str!("materials.txt"))
        .filter_map(|l| {
            let finish = FINISHES.iter().find(|f| Some(&f.1) == l.get(1))?.0;
            Some((l[0], Stuff(finish, u32::from_str_radix(l.get(2)?, 16).ok()?)))
        })
        .collect()
});

fn lines(text: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    text.lines().map(|l| l.split_whitespace().collect::<Vec<_>>()).filter(|l| !l.is_empty() && !l[0].starts_with('#'))
}

/// Names of colours, in alphabetical order.
pub fn color_names() -> impl Iterator<Item = &'static str> {
    COLORS.keys().copied()
}

/// Names of materials, in alphabetical order.
pub fn material_names() -> impl Iterator<Item = &'static str> {
    MATERIALS.keys().copied()
}

/// The colour that a text names first, as red, green and blue (sRGB).
pub fn color_of(text: &str) -> Option<[u8; 3]> {
    colors(text).first().map(|rgb| rgb.map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8))
}

/// The colours a text names, one per phrase ("white top, steel-blue legs": two). In a phrase the longest known name
/// counts, the first of several; `light`, `dark`, `pale` and the like change it; a material stands for its usual colour.
/// Hex triples are exact.
pub(crate) fn colors(text: &str) -> Vec<Rgb> {
    phrases(text)
        .filter_map(|p| hex(p).or_else(|| tinted(p, |w| COLORS.get(w).or(MATERIALS.get(w).map(|m| &m.1)).copied())))
        .collect()
}

/// The materials a text names, one per phrase ("oak and steel": two), with the usual colour or the one that goes with it
/// ("dark wood").
pub(crate) fn materials(text: &str) -> Vec<(Finish, Rgb)> {
    phrases(text)
        .filter_map(|p| {
            let finish = words(p).iter().rev().find_map(|w| MATERIALS.get(w.as_str()))?.0;
            let color = tinted(p, |w| MATERIALS.get(w).map(|m| m.1))?;
            Some((finish, color))
        })
        .collect()
}

fn phrases(text: &str) -> impl Iterator<Item = &str> {
    text.split([',', ';', '/', '+', '&']).flat_map(|p| p.split(" and ")).flat_map(|p| p.split(" with "))
}

fn hex(phrase: &str) -> Option<Rgb> {
    let digits: String = phrase.split('#').nth(1)?.chars().take_while(char::is_ascii_hexdigit).collect();
    let value = u32::from_str_radix(&digits, 16).ok()?;
    match digits.len() {
        3 => Some([value >> 8, value >> 4, value].map(|c| (c & 0xf) as f32 / 15.0)),
        6 => Some(rgb(value)),
        8 => Some(rgb(value >> 8)),
        _ => None,
    }
}

/// The colour of a phrase by a table, its adjectives applied.
fn tinted(phrase: &str, table: impl Fn(&str) -> Option<u32>) -> Option<Rgb> {
    let words = words(phrase);
    let (start, length, found) = (1..=3.min(words.len())).rev().find_map(|length| {
        (0..=words.len() - length).find_map(|i| table(&words[i..i + length].concat()).map(|found| (i, length, found)))
    })?;
    let mut color = rgb(found);
    for (i, word) in words.iter().enumerate() {
        if (start..start + length).contains(&i) {
            continue;
        }
        let toward = |target: f32, by: f32| color.map(|c| c + (target - c) * by);
        color = match word.as_str() {
            "light" | "pale" | "soft" | "pastel" | "bright" | "whitewashed" | "bleached" => toward(1.0, 0.4),
            "very" | "off" => toward(1.0, 0.15),
            "dark" | "deep" | "smoked" | "stained" => toward(0.0, 0.42),
            "muted" | "dusty" | "faded" => toward(0.6, 0.35),
            _ => color,
        };
    }
    Some(color)
}
