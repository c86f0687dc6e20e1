//! The table: one line each. A new row is tested as soon as it is here.

use super::{LAYOUT, ROOM, Repository, Row};
use std::os::unix::net::UnixListener;

/// Makes the table, and a test for each row of it.
macro_rules! rows {
    ($($name:ident $(with $setting:literal)?: $make:expr;)*) => {
        pub const ROWS: &[Row] = &[$(Row {
            name: stringify!($name),
            make: $make,
            setting: rows!(@setting $($setting)?),
        }),*];
        $(#[test]
        fn $name() {
            super::hold(stringify!($name));
        })*
    };
    (@setting) => { None };
    (@setting $setting:literal) => { Some($setting) };
}

/// A program that imports a path, in front of a good one.
fn import(repo: &Repository, path: &str) {
    repo.write("room.scene", format!("import \"{path}\";\n{ROOM}"));
}

/// A layout that names its program so.
fn of(repo: &Repository, program: &str) {
    repo.write("room.layout.json", LAYOUT.replace("room.scene", program));
}

/// A GLB file with a scene in it: a program, its imports, a layout, and a thing that stands there.
fn carrier(repo: &Repository, spec: &str, import: &str, layout: &str, thing: &str) {
    let document = serde_json::json!({
        "asset": { "version": "2.0" },
        "scenes": [{ "nodes": [0], "extras": { "scenelang": {
            "spec": spec, "layout": layout, "imports": { import: "object more;\n" } } } }],
        "nodes": [{ "name": thing, "mesh": 0 }],
    });
    let mut json = document.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let number = |n: usize| u32::try_from(n).unwrap().to_le_bytes();
    repo.write(
        "room.glb",
        [b"glTF", &number(2)[..], &number(20 + json.len()), &number(json.len()), b"JSON", &json].concat(),
    );
}

rows! {
    // ── Paths in a program ──
    import_from_above: |repo| import(repo, "../secret.scene");
    import_a_script_from_above: |repo| import(repo, "../victim.js");
    import_by_a_detour: |repo| import(repo, "lib/../../secret.scene");
    import_the_environment: |repo| import(repo, &format!("{}proc/self/environ", "../".repeat(40)));
    import_the_memory: |repo| import(repo, &format!("{}proc/self/mem", "../".repeat(40)));
    import_an_absolute_path: |repo| import(repo, &repo.at("../secret.scene").display().to_string());
    import_backslashes: |repo| import(repo, "..\\\\secret.scene");
    import_a_script: |repo| import(repo, "tool.js");
    import_from_home: |repo| import(repo, "~/.ssh/key");
    import_an_address: |repo| import(repo, "file:///etc/passwd");
    import_through_a_file: |repo| import(repo, "good.scene/../../secret.scene");
    // ── Links ──
    import_a_link: |repo| { repo.link("lib.scene", "../secret.scene"); import(repo, "lib.scene"); };
    import_an_absolute_link: |repo| { repo.link("lib.scene", repo.at("../secret.scene")); import(repo, "lib.scene"); };
    import_through_a_linked_folder: |repo| { repo.link("lib", ".."); import(repo, "lib/secret.scene"); };
    import_a_link_of_a_link: |repo| {
        repo.link("one.scene", "two.scene");
        repo.link("two.scene", "../secret.scene");
        import(repo, "one.scene");
    };
    import_a_circle_of_links: |repo| {
        repo.link("one.scene", "two.scene");
        repo.link("two.scene", "one.scene");
        import(repo, "one.scene");
    };
    the_program_is_a_link: |repo| repo.link("room.scene", "../secret.scene");
    the_layout_is_a_link: |repo| repo.link("room.layout.json", "../victim.json");
    the_settings_are_a_link: |repo| repo.link("scenelang.toml", "../secret.env");
    a_folder_is_a_circle: |repo| repo.link("again", ".");
    a_folder_leads_to_home: |repo| repo.link("rooms", "../home");
    the_output_is_a_link: |repo| repo.link("out", "../elsewhere");
    a_request_is_a_link: |repo| {
        repo.link("request.txt", "../home/.ssh/key");
        repo.write("request.expect.json", "{}");
    };
    // ── What is no file ──
    import_a_pipe: |repo| { repo.pipe("lib.scene"); import(repo, "lib.scene"); };
    import_a_device: |repo| { repo.link("zero", "/dev/zero"); import(repo, "zero"); };
    import_a_terminal: |repo| { repo.link("tty", "/dev/tty"); import(repo, "tty"); };
    import_a_folder: |repo| import(repo, ".git");
    import_a_socket: |repo| {
        // It stays when the listener is gone.
        drop(UnixListener::bind(repo.at("lib.scene")).unwrap());
        import(repo, "lib.scene");
    };
    the_program_is_a_pipe: |repo| repo.pipe("room.scene");
    the_layout_is_a_pipe: |repo| repo.pipe("room.layout.json");
    the_layout_is_a_device: |repo| repo.link("room.layout.json", "/dev/zero");
    the_settings_are_a_pipe: |repo| repo.pipe("scenelang.toml");
    the_settings_are_a_device: |repo| repo.link("scenelang.toml", "/dev/zero");
    the_settings_are_a_folder: |repo| repo.write("scenelang.toml/x", "");
    a_request_is_a_pipe: |repo| { repo.pipe("request.txt"); repo.write("request.expect.json", "{}"); };
    // ── Sizes ──
    import_a_huge_file: |repo| { repo.sparse("lib.scene", 8 << 30); import(repo, "lib.scene"); };
    the_layout_is_huge: |repo| repo.sparse("room.layout.json", 8 << 30);
    the_settings_are_huge: |repo| repo.sparse("scenelang.toml", 8 << 30);
    a_carrier_is_huge: |repo| repo.sparse("room.glb", 8 << 30);
    imports_in_a_long_chain: |repo| {
        for i in 0..100 {
            repo.write(&format!("lib/{i}.scene"), format!("import \"{}.scene\";\n", i + 1));
        }
        repo.write("lib/100.scene", "");
        import(repo, "lib/0.scene");
    };
    // ── What a layout names ──
    a_layout_of_a_script_above: |repo| of(repo, "../victim.js");
    a_layout_of_a_program_above: |repo| of(repo, "../secret.scene");
    a_layout_of_an_absolute_path: |repo| of(repo, &repo.at("../secret.scene").display().to_string());
    a_layout_of_the_environment: |repo| of(repo, "/proc/self/environ");
    a_layout_of_a_device: |repo| of(repo, "/dev/zero");
    a_layout_of_a_script: |repo| of(repo, "tool.js");
    a_layout_of_a_folder: |repo| of(repo, ".");
    a_layout_of_itself: |repo| of(repo, "room.layout.json");
    a_layout_of_a_pipe: |repo| { repo.pipe("lib.scene"); of(repo, "lib.scene"); };
    // ── What a GLB file carries ──
    a_carrier_is_a_link: |repo| repo.link("room.glb", "../secret.scene");
    a_carrier_is_a_pipe: |repo| repo.pipe("room.glb");
    a_carrier_with_a_hook: |repo| carrier(repo, ROOM, ".git/hooks/post-checkout", LAYOUT, "desk");
    a_carrier_with_a_script: |repo| carrier(repo, ROOM, "../tool.js", LAYOUT, "desk");
    a_carrier_with_a_program_far_above: |repo| carrier(repo, ROOM, "../../../../secret.scene", LAYOUT, "desk");
    a_carrier_of_a_program_above: |repo| {
        carrier(repo, "import \"secret.scene\";", "more.scene", &LAYOUT.replace("room.scene", "../secret.scene"), "desk");
    };
    a_carrier_with_an_absolute_path: |repo| {
        let path = repo.at("../secret.scene").display().to_string();
        carrier(repo, ROOM, &path, &LAYOUT.replace("room.scene", &path), "desk");
    };
    a_carrier_that_paints: |repo| {
        carrier(repo, "object desk; // \x1b]0;title\x07\n", "\x1b[31m.scene", LAYOUT, "\x1b[31m\n::error::x\u{202e}");
    };
    // ── Names and texts that act ──
    a_name_with_a_command: |repo| import(repo, "q\\n::error::x");
    a_name_with_a_line_break: |repo| repo.write("a\n::error::x.scene", "object a;;\nobject");
    a_name_that_is_a_command: |repo| repo.write("::error::x.scene", "object a;;\nobject");
    a_name_that_paints: |repo| repo.write("\x1b[31mred\x07.scene", "object a;;\nobject");
    a_name_that_turns: |repo| repo.write("\u{202e}enecs.scene", "object a;;\nobject");
    a_text_that_paints: |repo| {
        repo.write("room.scene", "object desk; // \x1b]0;title\x07\u{9b}31m\nassert \x1b[2J desk.pos.x > 1;;\n");
    };
    a_text_that_turns: |repo| repo.write("room.scene", "object desk;; // \u{202e}neves\u{2066}\nassert desk.x > \"\u{202e}\";\n");
    a_text_with_commands: |repo| {
        repo.write("room.scene", "object desk;\n// @req \x1b[31m::error::x\nassert desk.pos.x > 1\n::error::y\n;\n");
    };
    an_object_that_paints: |repo| repo.write("room.layout.json", LAYOUT.replace("desk", "\\u001b[31m\\n::error::x"));
    settings_that_paint: |repo| repo.write("scenelang.toml", "\"\\u001b[31m\\n::error::x\" = 1\n");
    // ── Settings of the editor ──
    a_setting_that_leads_up with "../victim.json": |_| {};
    a_setting_with_an_absolute_path with "/dev/zero": |_| {};
    a_setting_of_another_file with ".git/HEAD": |_| {};
    a_setting_of_a_script with "tool.js": |_| {};
    a_setting_through_a_link with "lib/victim.json": |repo| repo.link("lib", "..");
}

#[test]
fn there_is_a_row_for_every_kind_of_harm() {
    assert!(ROWS.len() >= 50, "{} rows", ROWS.len());
}
