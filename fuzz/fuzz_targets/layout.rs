//! Any text is read as a layout without a panic; a place of what is wrong with it is in the text.
#![no_main]

use libfuzzer_sys::fuzz_target;
use scenelang_base::FileId;
use scenelang_layout::file::{decode, read};

fuzz_target!(|bytes: &[u8]| {
    let Ok(text) = decode(bytes.to_vec()) else { return };
    for d in read(&text, FileId(0)).diagnostics {
        let Some(primary) = &d.primary else { continue };
        assert!(text.get(primary.place.range.bytes()).is_some(), "a place outside the text: {d:?}");
    }
});
