//! Any text is read as settings without a panic, those of a workspace and those of a user; what is wrong with it has a place in
//! the text, and no workspace says where keys are sent.
#![no_main]

use libfuzzer_sys::fuzz_target;
use scenelang_base::FileId;
use scenelang_verify::settings::{read, read_own};

fuzz_target!(|text: &str| {
    let all = read(text, FileId(0)).map(|settings| settings.llm);
    if let Ok(llm) = &all {
        assert_eq!(llm.base_url, None);
        assert!(llm.rounds.is_none_or(|n| n <= 100) && llm.tries.is_none_or(|n| n <= 10));
    }
    for found in [all, read_own(text, FileId(0))].into_iter().filter_map(Result::err).flatten() {
        let primary = found.primary.as_ref().expect("everything said of a text has a place");
        assert!(text.get(primary.place.range.bytes()).is_some(), "a place outside the text: {found:?}");
    }
});
