//! Open documents, and the programs among them.

use crate::config::Config;
use crate::disk::{Files, Reach, is_file, path_of, settings_for};
use crate::dispatch::Tokens;
use crate::reading::Reading;
use crate::text::Text;
use scenelang_analysis::Found;
use scenelang_base::door::Named;
use scenelang_ide::Host;
use scenelang_lang::sources::{Loader, normal};
use scenelang_verify::settings::Settings;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tower_lsp::ls_types::Uri;

/// A document that the editor has open.
pub struct Document {
    /// As the editor calls it.
    pub uri: Uri,
    /// Where it is.
    pub path: PathBuf,
    /// What the editor counts.
    pub version: i32,
    /// Its text.
    pub text: Arc<Text>,
    /// What can be said of it, if it is a program.
    pub scene: Option<Scene>,
}

/// An open program with its layout.
pub struct Scene {
    /// What is known of it.
    pub host: Host,
    /// Where its layout is, or would be.
    pub layout: Option<PathBuf>,
    /// The settings of its workspace.
    pub settings: Arc<Found>,
    /// The text is newer than what the host knows.
    pub stale_text: bool,
    /// The layout, or the settings, are newer than what the host knows.
    pub stale_layout: bool,
    /// Another number whenever something has changed that could change a verdict.
    pub generation: u64,
    /// The generation whose verdict was published.
    pub published: u64,
    /// Whether a verdict is being worked out.
    pub judging: bool,
    /// Something else than the document has changed since the last verdict: the editor must be told to ask again.
    pub outside: bool,
    /// What is proved of the program, until its text changes: marks.
    pub proofs: Vec<Value>,
    /// Whether the editor was told of proofs.
    pub told_proofs: bool,
    /// Proofs are to be looked for.
    pub unproved: bool,
    /// The semantic tokens that were sent last.
    pub tokens: Tokens,
}

/// All open documents by their address.
#[derive(Default)]
pub struct Documents {
    open: BTreeMap<String, Document>,
    /// Texts that the editor was given to write into files, and has not said since what became of them.
    assumed: BTreeMap<PathBuf, Arc<Text>>,
    /// The last generation of any program.
    generation: u64,
    /// The folders of the workspace.
    named: Arc<Named>,
    /// Who reads for the thread that owns all of this.
    reading: Option<Arc<Reading>>,
}

impl Documents {
    /// Opens a document, or takes it over anew.
    pub fn open(&mut self, uri: Uri, language: &str, version: i32, text: String, config: &Config) {
        let path = path_of(&uri);
        self.assumed.remove(&path);
        let text = Arc::new(Text::new(text));
        let key = uri.as_str().to_owned();
        self.open.insert(key.clone(), Document { uri, path: path.clone(), version, text, scene: None });
        if !is_data(&path, language) {
            let files = self.own_files().of(&path);
            let document = &self.open[&key];
            let name = name_of(&path);
            let host = Host::new(&name, &path, document.text.as_str(), &files);
            let layout = if is_file(&document.uri) { layout_of(&path, config) } else { None };
            let scene = Scene {
                host,
                layout,
                settings: Arc::default(),
                stale_text: false,
                stale_layout: true,
                generation: 0,
                published: 0,
                judging: false,
                outside: false,
                proofs: Vec::new(),
                told_proofs: false,
                unproved: true,
                tokens: Tokens::default(),
            };
            if let Some(document) = self.open.get_mut(&key) {
                document.scene = Some(scene);
            }
        }
        self.touched(&path, &key);
    }

    /// Closes a document; whether it was open.
    pub fn close(&mut self, uri: &str) -> bool {
        let Some(document) = self.open.remove(uri) else { return false };
        // Others read it from disk again.
        self.touched(&document.path, uri);
        true
    }

    /// A file or a document has changed: whoever reads it is told, `except` the document itself.
    pub fn touched(&mut self, path: &Path, except: &str) {
        for (key, document) in &mut self.open {
            let Some(scene) = &mut document.scene else { continue };
            if scene.layout.as_deref() == Some(path) || path.ends_with(scenelang_verify::settings::FILE) {
                scene.stale_layout = true;
                scene.outside = true;
            }
            let imports = key != except && scene.host.files().any(|file| normal(file) == path);
            if imports && document.path != path {
                scene.stale_text = true;
                scene.outside = true;
            }
        }
    }

    /// All files that something is known of because they were read, or would have been.
    pub fn read(&self) -> impl Iterator<Item = PathBuf> {
        let scenes = self.open.values().filter_map(|document| document.scene.as_ref());
        scenes.flat_map(|scene| {
            let imports = scene.host.files().map(normal);
            imports.chain(scene.layout.clone()).chain(scene.settings.file.clone())
        })
    }

    /// The settings of the editor have changed.
    pub fn reconfigured(&mut self, config: &Config) {
        for document in self.open.values_mut() {
            let Some(scene) = &mut document.scene else { continue };
            scene.layout = if is_file(&document.uri) { layout_of(&document.path, config) } else { None };
            scene.stale_layout = true;
            scene.outside = true;
        }
    }

    /// The document of an address.
    pub fn get(&self, uri: &str) -> Option<&Document> {
        self.open.get(uri)
    }
    /// The document of an address.
    pub fn get_mut(&mut self, uri: &str) -> Option<&mut Document> {
        self.open.get_mut(uri)
    }
    /// The document of a path.
    pub fn at(&self, path: &Path) -> Option<&Document> {
        self.open.values().find(|document| document.path == path)
    }
    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &Document> {
        self.open.values()
    }

    /// Their texts before the disk.
    pub fn files(&self) -> Files {
        let mut texts = self.assumed.clone();
        texts.extend(self.open.values().map(|d| (d.path.clone(), Arc::clone(&d.text))));
        Files { texts: Arc::new(texts), named: Arc::clone(&self.named), reading: None }
    }

    /// The same for the thread that owns all of this, which does not wait for a disk.
    fn own_files(&self) -> Files {
        Files { reading: self.reading.clone(), ..self.files() }
    }

    /// From now on files are read by somebody else.
    pub fn read_by(&mut self, reading: Arc<Reading>) {
        self.reading = Some(reading);
    }

    /// The workspace has other folders.
    pub fn set_folders(&mut self, folders: &[PathBuf]) {
        self.named = Named::new(folders.iter().map(PathBuf::as_path));
        self.read_again();
    }

    /// Whatever was read is read again.
    pub fn read_again(&mut self) {
        for scene in self.open.values_mut().filter_map(|document| document.scene.as_mut()) {
            (scene.stale_text, scene.stale_layout, scene.outside) = (true, true, true);
        }
    }

    /// The editor has made an edit of a file that it has not opened with us: until it says more of it, this is its text.
    pub fn assume(&mut self, path: &Path, text: String) {
        if self.at(path).is_none() {
            self.assumed.insert(path.to_owned(), Arc::new(Text::new(text)));
            self.touched(path, "");
        }
    }

    /// A file is what the disk has of it again.
    pub fn forget(&mut self, path: &Path) {
        self.assumed.remove(path);
    }

    /// Brings what is known of a program up to its text and its layout.
    pub fn sync(&mut self, uri: &str) {
        let stale = |s: &Scene| s.stale_text || s.stale_layout;
        if !self.open.get(uri).and_then(|d| d.scene.as_ref()).is_some_and(stale) {
            return;
        }
        let files = self.own_files();
        self.generation += 1;
        let Some(Document { path, text, scene: Some(scene), .. }) = self.open.get_mut(uri) else { return };
        let files = files.of(path);
        if std::mem::take(&mut scene.stale_text) {
            scene.host.set_text(text.as_str(), &files);
            scene.proofs.clear();
        }
        if std::mem::take(&mut scene.stale_layout) {
            scene.settings = judge_by(&mut scene.host, scene.layout.as_deref(), &files);
        }
        scene.generation = self.generation;
    }
}

/// Gives a program its layout and the settings of its workspace.
pub fn judge_by(host: &mut Host, layout: Option<&Path>, files: &Reach) -> Arc<Found> {
    let found = settings_for(files);
    host.set_judging(found.judging(&Settings::default()));
    let layout = layout.map(|path| (name_of(path), path, files.load(path)));
    host.set_layout(layout);
    Arc::new(found)
}

/// How a file is called in messages.
pub fn name_of(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}

/// Whether a document is a layout or other data, no program.
fn is_data(path: &Path, language: &str) -> bool {
    let extension = path.extension().unwrap_or_default();
    extension.eq_ignore_ascii_case("json")
        || extension.eq_ignore_ascii_case("toml")
        || matches!(language, "json" | "jsonc" | "toml")
}

/// Where the layout of a program is: where the settings say, else beside it.
pub fn layout_of(program: &Path, config: &Config) -> Option<PathBuf> {
    let stem = program.file_stem()?.to_string_lossy();
    Some(match &config.layout {
        Some(pattern) => normal(&program.parent()?.join(pattern.replace("{stem}", &stem))),
        None => program.with_extension("layout.json"),
    })
}
