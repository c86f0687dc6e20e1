//! The textures of the furniture library as PNG files: one set for each kind that a scene shows, whatever its colours.

use crate::{ExportError, Scene};
use scenelang_assets::Surface;
use scenelang_assets::textures::{Pixels, Texture};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

/// What was encoded before in this process: a scene is often written in several formats, and they share their pictures.
static ENCODED: LazyLock<Mutex<BTreeMap<Key, Arc<Vec<u8>>>>> = LazyLock::new(Mutex::default);
/// More pictures than this are not kept: those of Unity depend on the surface.
const KEPT: usize = 256;

/// What a picture depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Key {
    Color(Texture),
    Normal(Texture),
    Roughness(Texture),
    Plain(Texture),
    /// Metalness and roughness, as their bits.
    Gloss(Texture, u32, u32),
}

/// The picture of a key, made unless it was before.
fn once(key: Key, make: impl FnOnce() -> Result<Vec<u8>, ExportError>) -> Result<Vec<u8>, ExportError> {
    let known = || ENCODED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(picture) = known().get(&key).cloned() {
        return Ok(picture.to_vec());
    }
    let picture = make()?;
    let mut all = known();
    if all.len() < KEPT {
        all.insert(key, Arc::new(picture.clone()));
    }
    Ok(picture)
}

/// The kinds that a scene shows, in order.
pub(crate) fn used(scene: &Scene) -> Vec<Texture> {
    kinds(&scene.surfaces)
}

/// The kinds that surfaces have, in order, each once.
pub(crate) fn kinds<'a>(surfaces: impl IntoIterator<Item = &'a Surface>) -> Vec<Texture> {
    let mut kinds: Vec<Texture> = surfaces.into_iter().filter_map(Texture::of).collect();
    kinds.sort();
    kinds.dedup();
    kinds
}

/// A picture in a file of its own, for formats whose files refer to pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Picture {
    /// See [`color`].
    Color,
    /// See [`normal`].
    Normal,
    /// The factor of the roughness in all channels.
    Roughness,
}

impl Picture {
    /// Its path, from where the file that refers to it is: `textures/wood_color.png`.
    pub fn path(self, texture: Texture) -> String {
        let what = match self {
            Self::Color => "color",
            Self::Normal => "normal",
            Self::Roughness => "roughness",
        };
        format!("textures/{}_{what}.png", texture.name())
    }

    /// The file.
    ///
    /// # Errors
    /// The picture cannot be encoded.
    pub fn bytes(self, texture: Texture) -> Result<Vec<u8>, ExportError> {
        match self {
            Self::Color => color(texture),
            Self::Normal => normal(texture),
            Self::Roughness => {
                let pixels = texture.pixels();
                let ramp: Vec<[u8; 3]> = (0..=255).map(|rough| [rough; 3]).collect();
                once(Key::Plain(texture), || indexed(pixels, &pixels.rough, &ramp, None))
            }
        }
    }
}

/// The factors of the colour, sRGB.
///
/// # Errors
/// The picture cannot be encoded.
pub(crate) fn color(texture: Texture) -> Result<Vec<u8>, ExportError> {
    let pixels = texture.pixels();
    once(Key::Color(texture), || indexed(pixels, &pixels.shade, &pixels.ramp, None))
}

/// Normals in the frame of the surface: along u, along v (upwards), outward.
///
/// # Errors
/// The picture cannot be encoded.
pub(crate) fn normal(texture: Texture) -> Result<Vec<u8>, ExportError> {
    let pixels = texture.pixels();
    once(Key::Normal(texture), || {
        let data: Vec<u8> = from_the_top(pixels, &pixels.normal).flatten().flatten().copied().collect();
        encoded(pixels, &data, |_| {})
    })
}

/// As glTF has it: the factor of the roughness in green, that of the metalness in blue.
///
/// # Errors
/// The picture cannot be encoded.
pub(crate) fn roughness(texture: Texture) -> Result<Vec<u8>, ExportError> {
    let pixels = texture.pixels();
    let ramp: Vec<[u8; 3]> = (0..=255).map(|rough| [255, rough, 255]).collect();
    once(Key::Roughness(texture), || indexed(pixels, &pixels.rough, &ramp, None))
}

/// As Unity has it: metalness in red, smoothness in alpha, for a surface of a metalness and a mean roughness.
///
/// # Errors
/// The picture cannot be encoded.
pub(crate) fn gloss(texture: Texture, metallic: f32, roughness: f32) -> Result<Vec<u8>, ExportError> {
    let pixels = texture.pixels();
    let factor = rough_factor(pixels, roughness);
    let byte = |v: f32| (v.clamp(0.0, 1.0) * 255.0).round() as u8;
    let ramp = vec![[byte(metallic); 3]; 256];
    let smooth: Vec<u8> = (0..=255_u8).map(|rough| byte(1.0 - factor * f32::from(rough) / 255.0)).collect();
    let key = Key::Gloss(texture, metallic.to_bits(), roughness.to_bits());
    once(key, || indexed(pixels, &pixels.rough, &ramp, Some(smooth)))
}

/// What to multiply the roughness of a texture by, for a surface of a mean roughness.
pub(crate) fn rough_factor(pixels: &Pixels, roughness: f32) -> f32 {
    (roughness / pixels.rough_mean).min(1.0)
}

/// The rows of a texture in the order of a picture.
fn from_the_top<'a, T>(pixels: &Pixels, values: &'a [T]) -> impl Iterator<Item = &'a [T]> {
    values.chunks_exact(pixels.size[0]).rev()
}

fn indexed(pixels: &Pixels, values: &[u8], ramp: &[[u8; 3]], alpha: Option<Vec<u8>>) -> Result<Vec<u8>, ExportError> {
    let data: Vec<u8> = from_the_top(pixels, values).flatten().copied().collect();
    encoded(pixels, &data, |encoder| {
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(Cow::Owned(ramp.concat()));
        if let Some(alpha) = alpha {
            encoder.set_trns(Cow::Owned(alpha));
        }
    })
}

fn encoded(
    pixels: &Pixels,
    data: &[u8],
    prepare: impl FnOnce(&mut png::Encoder<'_, &mut Vec<u8>>),
) -> Result<Vec<u8>, ExportError> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, pixels.size[0] as u32, pixels.size[1] as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    prepare(&mut encoder);
    let wrong = |e: png::EncodingError| ExportError::Format("textures", e.to_string());
    let mut writer = encoder.write_header().map_err(wrong)?;
    writer.write_image_data(data).map_err(wrong)?;
    writer.finish().map_err(wrong)?;
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_sets_together_are_small_and_every_picture_is_as_large_as_it_says() {
        let mut bytes = 0;
        for texture in Texture::all() {
            let [width, height] = texture.pixels().size.map(|n| n as u32);
            let glossy = gloss(texture, 0.5, 0.4).unwrap();
            let plain = Picture::Roughness.bytes(texture).unwrap();
            let set = [color(texture).unwrap(), normal(texture).unwrap(), roughness(texture).unwrap(), glossy, plain];
            for picture in set {
                let reader = png::Decoder::new(std::io::Cursor::new(&picture)).read_info().unwrap();
                assert_eq!(reader.info().size(), (width, height), "{texture:?}");
                bytes += picture.len();
            }
        }
        assert!(bytes < 1_500_000, "{bytes}");
    }

    #[test]
    fn a_picture_is_made_once_and_each_finish_has_its_own() {
        let key = Key::Gloss(Texture::Leather, 7, 7);
        let mut made = 0;
        for _ in 0..3 {
            let picture = once(key, || {
                made += 1;
                Ok(vec![1, 2])
            });
            assert_eq!(picture.unwrap(), [1, 2]);
        }
        assert_eq!(made, 1);
        let pictures = || {
            let glossy = [(0.0, 0.4), (0.0, 0.5), (1.0, 0.4)].map(|(m, r)| gloss(Texture::Leather, m, r).unwrap());
            let plain = Picture::Roughness.bytes(Texture::Leather).unwrap();
            let own = [color(Texture::Leather), normal(Texture::Leather), roughness(Texture::Leather)];
            own.map(Result::unwrap).into_iter().chain(glossy).chain([plain]).collect::<Vec<_>>()
        };
        let first = pictures();
        assert_eq!(first, pictures());
        assert!((1..first.len()).all(|i| !first[..i].contains(&first[i])), "no two are the same");
    }

    #[test]
    fn the_first_row_of_a_picture_is_the_uppermost() {
        let pixels = Texture::Wood.pixels();
        let [width, height] = pixels.size;
        let picture = normal(Texture::Wood).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(&picture)).read_info().unwrap();
        let mut read = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut read).unwrap();
        let last: Vec<u8> = pixels.normal[(height - 1) * width..].concat();
        assert_eq!(read[..3 * width], last[..]);
    }
}
