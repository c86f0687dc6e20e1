//! The library as its users see it: shapes that fill their boxes, meshes that are sound, nouns that are understood.

mod geometry;
mod nouns;
mod shapes;
