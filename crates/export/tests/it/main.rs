//! What exporters write for one small scene, read back by hand.

mod fixture;
mod glb;
mod pictures;
mod scene;
mod unity;
mod written;
