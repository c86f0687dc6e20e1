//! Compiles the committed parser of `editors/tree-sitter-scenelang`.

fn main() {
    let folder = "../../editors/tree-sitter-scenelang/src";
    let sources = ["parser.c", "scanner.c"].map(|name| format!("{folder}/{name}"));
    println!("cargo::rerun-if-changed={folder}");
    cc::Build::new()
        .include(folder)
        .files(sources)
        .std("c11")
        .warnings(true)
        .extra_warnings(false)
        .compile("scenelang");
}
