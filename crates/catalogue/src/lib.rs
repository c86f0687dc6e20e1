//! The user's own models: a folder of GLB and OBJ files, each with a card (a JSON file beside it) where there is one, or
//! the folder of objathor and Holodeck.
//!
//! What comes in is not trusted. Each file is read up to [`limits`], may refer to nothing outside of its folder, and
//! what cannot be used is one diagnostic, after which the next file goes on. A [`CatalogueModel`] is in metres and in the frame
//! of the layout (left-handed, y up; origin in the middle of the bottom face; front to +z), like the furniture of
//! `scenelang_assets`, and made of convex parts.
//!
//! Models are searched by words or, where a folder has features that were computed before, by the published score.
//! Which of them an object gets is decided by a [`Chain`] of providers: folders, generators, the furniture library, a box.
//!
//! Absent here: textures (a material is its plain colour), programs, and usual sizes.

mod card;
mod check;
mod cut;
mod faults;
mod features;
mod folder;
mod glb;
mod import;
pub mod limits;
mod model;
mod npy;
mod obj;
mod objathor;
mod pickle;
mod pieces;
mod provide;
mod raw;
mod search;

pub use card::Card;
pub use check::{Checked, check};
pub use features::{Features, LAMBDA_SEMANTIC, LAMBDA_VISUAL, TAU, published_score};
pub use folder::{Catalogue, Entry, Refused};
pub use import::{Imported, Kept, import};
pub use model::{CatalogueModel, Origin};
pub use provide::generator;
pub use provide::{
    AssetProvider, Boxed, Chain, Choice, Given, Library, Local, ProvidedModel, Query, Remark, Reply, Why,
};
pub use search::{B, Hit, Index, K1, size_factor};
