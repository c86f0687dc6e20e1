//! `scenelang assets gallery`: a page with every family of the furniture library, in three sizes, closed and open. It is one
//! file that loads nothing; the pictures are those that `export` draws, and small.

use crate::args::AssetsGallery;
use crate::progress::Progress;
use crate::{FAILED, GOOD, out, replace};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use scenelang_assets::{AssetRequest, categories, families, family_of, furnish};
use scenelang_base::fs::write_set;
use scenelang_export::thumbnail;
use scenelang_lang::library::usual_size;
use scenelang_lang::nouns;
use scenelang_layout::Vec3;
use std::fmt::Write;

/// How large a picture is, pixels.
const PICTURE: [usize; 2] = [176, 132];
/// The sizes: what they are called, and how much of the usual one they are.
const SIZES: [(&str, f64); 3] = [("small", 0.7), ("usual", 1.0), ("large", 1.4)];
/// The edge of what has no usual size (metres).
const EDGE: f64 = 0.5;
/// How the page looks.
const STYLE: &str = "body{font:15px/1.4 system-ui,sans-serif;margin:2rem;background:#fbfaf7;color:#222}\
    main{display:grid;grid-template-columns:repeat(auto-fill,minmax(560px,1fr));gap:1rem}\
    section{background:#fff;border:1px solid #e4e1d8;border-radius:8px;padding:.6rem .8rem}h2{font-size:1rem;margin:0 0 .3rem}\
    div{display:flex;flex-wrap:wrap;gap:.4rem}figure{margin:0}figcaption{font-size:12px;color:#666}img{display:block;background:#eee}";

/// Writes the page.
pub fn run(args: &AssetsGallery) -> u8 {
    if let Err(message) = replace::permit(&args.output, &[], args.force) {
        return fail(&message);
    }
    let wanted = |family: &&str| args.families.is_empty() || args.families.iter().any(|name| name == family);
    let known: Vec<&str> = families().collect();
    if let Some(strange) = args.families.iter().find(|name| !known.contains(&name.as_str())) {
        return fail(&scenelang_verify::settings::unknown("family", strange, &known));
    }
    let chosen: Vec<&str> = known.into_iter().filter(wanted).collect();
    let progress = Progress::new("drawing");
    let mut page = String::new();
    let mut pictures = 0;
    for (n, family) in chosen.iter().enumerate() {
        progress.say(format!("drawing {family}: {} of {}", n + 1, chosen.len()));
        match section(family, &mut pictures) {
            Ok(text) => page += &text,
            Err(why) => {
                drop(progress);
                return fail(&format!("{family} cannot be drawn: {why}"));
            }
        }
    }
    drop(progress);
    let page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>Furniture of scenelang</title>\n\
         <style>{STYLE}</style>\n<h1>Furniture</h1>\n<p>{} families, {pictures} pictures.</p>\n<main>\n{page}</main>\n</html>\n",
        chosen.len(),
    );
    if let Err(e) = write_set(&[(args.output.clone(), page.as_bytes())]) {
        return fail(&e.to_string());
    }
    let size = page.len() as f64 / 1e6;
    let file = args.output.display();
    out::show(&format!("{file}: {} families, {pictures} pictures, {size:.1} MB\n", chosen.len()));
    GOOD
}

fn fail(message: &str) -> u8 {
    eprintln!("error: {message}");
    FAILED
}

/// A family in all sizes.
fn section(family: &str, pictures: &mut usize) -> Result<String, String> {
    let noun = family.replace('_', " ");
    // A family that is no noun of the vocabulary itself is as large as the first noun that it draws.
    let nouns = || categories().filter(|name| family_of(name, "") == Some(family) && nouns::noun(name).is_some());
    let named = nouns().find(|name| *name == noun).or_else(|| nouns().next()).unwrap_or(&noun);
    let usual = usual_size(named).map_or_else(|| Vec3::repeat(EDGE), Vec3::from);
    let mut text = format!("<section><h2>{noun}</h2><div>");
    for (size, factor) in SIZES {
        let asset = furnish(&AssetRequest {
            name: "it",
            category: &noun,
            size: Some(usual * factor),
            ..AssetRequest::default()
        });
        let opens = !asset.joints.is_empty();
        for open in [false, true].into_iter().filter(|open| !open || opens) {
            let png = thumbnail::png(&noun, &asset, open, PICTURE).map_err(|e| e.to_string())?;
            let [x, y, z]: [f64; 3] = asset.size.into();
            let state = match (opens, open) {
                (false, _) => "",
                (true, false) => ", closed",
                (true, true) => ", open",
            };
            let [width, height] = PICTURE;
            let data = STANDARD.encode(&png);
            let _ = write!(
                text,
                "<figure><img width=\"{width}\" height=\"{height}\" alt=\"{noun}, {size}{state}\" \
                 src=\"data:image/png;base64,{data}\"><figcaption>{size}{state}: {x:.2} × {y:.2} × {z:.2} m</figcaption></figure>"
            );
            *pictures += 1;
        }
    }
    text += "</div></section>\n";
    Ok(text)
}
