//! What a generator is told: the size, the words said of the object, how it should look, and its own dice.

use crate::looks::{self, Finish, Rgb, Stuff};
use crate::mesh::Surface;
use crate::words::{Dice, hash, words};
use crate::{AssetRequest, block::Block, block::block};
use scenelang_layout::Vec3;

/// One order for a piece of furniture.
#[derive(Debug)]
pub(crate) struct Ask {
    /// Width (m).
    pub w: f64,
    /// Height (m).
    pub h: f64,
    /// Depth (m).
    pub d: f64,
    words: Vec<String>,
    colors: Vec<Rgb>,
    materials: Vec<(Finish, Rgb)>,
    seed: u64,
}

impl Ask {
    /// Reads a request at a size.
    pub fn new(request: &AssetRequest<'_>, size: Vec3) -> Self {
        let text = [request.category, request.features, request.name];
        Self {
            w: size.x,
            h: size.y,
            d: size.z,
            words: text.iter().flat_map(|t| words(t)).collect(),
            colors: looks::colors(request.color),
            materials: looks::materials(request.material),
            seed: hash(request.name),
        }
    }
    /// The whole box.
    pub fn whole(&self) -> Block {
        block(-self.w / 2.0..self.w / 2.0, 0.0..self.h, -self.d / 2.0..self.d / 2.0)
    }
    /// Whether category, features or name have one of these words (lower case, singular).
    pub fn says(&self, any: &[&str]) -> bool {
        self.words.iter().any(|w| any.contains(&w.as_str()))
    }
    /// The surface of the main group: as asked, else as usual.
    pub fn main(&self, usual: Stuff) -> Surface {
        let (finish, own) = self.materials.first().copied().unwrap_or((usual.0, looks::rgb(usual.1)));
        looks::surface(finish, self.colors.first().copied().unwrap_or(own))
    }
    /// The main surface of something whose material is not for the asker to choose (a screen, a fire extinguisher).
    pub fn tinted(&self, usual: Stuff) -> Surface {
        looks::surface(usual.0, self.colors.first().copied().unwrap_or(looks::rgb(usual.1)))
    }
    /// The first material asked for in its own colour, whatever colour was asked for.
    pub fn unpainted(&self, usual: Stuff) -> Surface {
        let (finish, own) = self.materials.first().copied().unwrap_or((usual.0, looks::rgb(usual.1)));
        looks::surface(finish, own)
    }
    /// The surface of the secondary parts: the second material or colour asked for, else as given.
    pub fn second(&self, usual: Stuff) -> Surface {
        let (finish, own) = self.materials.get(1).copied().unwrap_or((usual.0, looks::rgb(usual.1)));
        looks::surface(finish, self.colors.get(1).copied().unwrap_or(own))
    }
    /// The surface of legs under something of `main`: wood under bare wood, metal under glass and stone.
    pub fn legs(&self, main: &Surface) -> Surface {
        if self.materials.len() > 1 || self.colors.len() > 1 {
            return self.second(looks::stuff::BLACK_STEEL);
        }
        let bare = looks::is(main, Finish::Wood) && looks::woody(main.color);
        if bare || looks::is(main, Finish::Metal) {
            main.clone()
        } else if [Finish::Glass, Finish::Stone, Finish::Plastic].iter().any(|f| looks::is(main, *f)) {
            looks::stuff::BLACK_STEEL.surface()
        } else {
            looks::stuff::OAK.surface()
        }
    }
    /// The first material asked for, if it is one of these.
    pub fn made_of(&self, any: &[Finish]) -> bool {
        self.materials.first().is_some_and(|m| any.contains(&m.0))
    }
    /// Whether a colour was asked for.
    pub fn has_color(&self) -> bool {
        !self.colors.is_empty()
    }
    /// Dice that roll differently for each set of words, too: two pictures of one name and two styles differ.
    pub fn varied(&self) -> Dice {
        Dice::new(self.seed ^ hash(&self.words.join(" ")).rotate_left(7))
    }
    /// The object's own dice: the same name rolls the same.
    pub fn dice(&self) -> Dice {
        Dice::new(self.seed)
    }
}
