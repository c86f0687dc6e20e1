//! A program under edit beside its layout: the one place that is written to, and snapshots that everything else reads.

use scenelang_base::{Code, Diagnostic, FileId, SourceFile, SourceMap, Span, codes};
use scenelang_lang::Program;
use scenelang_lang::db::{Analysis, Cancelled};
use scenelang_lang::hir::Meanings;
use scenelang_lang::sources::{Loader, plain};
use scenelang_layout::{ReadLayout, file as layout_file};
use scenelang_verify::{Explain, Options, Verdict, check_read};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// How a layout is judged, and what is not told of.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Judging {
    /// Tolerances, η, what a solid is, whether the physical rules apply.
    pub options: Options,
    /// Warnings that are not reported.
    pub allow: Vec<Code>,
}

/// A program and its layout. Snapshots of it say what is known; a change of its text ends their questions.
pub struct Host {
    analysis: Analysis,
    sources: Arc<SourceMap>,
    main: FileId,
    compiled: Arc<Memo<Compiled>>,
    layout: Option<Arc<LayoutFile>>,
    judging: Arc<Judging>,
    judged: Arc<Memo<Judged>>,
    explained: Arc<Memo<Verdict>>,
}

/// What a host knew at one moment. For one thread; questions end with [`Cancelled`] when the text changes.
pub struct Snapshot {
    analysis: Analysis,
    sources: Arc<SourceMap>,
    main: FileId,
    compiled: Arc<Memo<Compiled>>,
    layout: Option<Arc<LayoutFile>>,
    judging: Arc<Judging>,
    judged: Arc<Memo<Judged>>,
    explained: Arc<Memo<Verdict>>,
}

/// A program as far as it can be judged.
#[derive(Debug)]
pub struct Compiled {
    /// Without statements that have errors, and those that need one of them.
    pub program: Program,
    /// Whether there is no error.
    pub complete: bool,
    /// Errors and warnings, by file and place.
    pub diagnostics: Vec<Diagnostic>,
}

/// The layout of a program.
#[derive(Debug)]
pub struct LayoutFile {
    /// Its id among the sources.
    pub file: FileId,
    /// Where it is.
    pub path: PathBuf,
    /// What it says, with places.
    pub read: ReadLayout,
    /// Why it cannot be read at all.
    pub unreadable: Option<Diagnostic>,
}

/// What holds in a layout. No violation in it is explained: that takes longer than the verdict.
#[derive(Debug)]
pub struct Judged {
    /// Rows and findings about the layout. While the program has errors, what the physical rules say is left out, since a
    /// statement that is missing may have lifted them.
    pub verdict: Verdict,
    /// The program that was judged by.
    pub compiled: Arc<Compiled>,
}

impl Host {
    /// A host of the program called `name` at `path`, with its text.
    pub fn new(name: &str, path: &Path, text: &str, loader: &dyn Loader) -> Self {
        let mut sources = SourceMap::new();
        let main = sources.add(SourceFile::new(name, path, text));
        let mut analysis = Analysis::new(scenelang_lang::Options::default());
        analysis.update(main, &mut sources, loader);
        Self {
            analysis,
            sources: Arc::new(sources),
            main,
            compiled: Arc::default(),
            layout: None,
            judging: Arc::default(),
            judged: Arc::default(),
            explained: Arc::default(),
        }
    }

    /// Takes over a new text of the program, and reads again what it imports.
    pub fn set_text(&mut self, text: &str, loader: &dyn Loader) {
        let file = self.sources.get(self.main);
        let (name, path) = (file.name().to_owned(), file.path().to_owned());
        let sources = Arc::make_mut(&mut self.sources);
        sources.put(SourceFile::new(name, path, text));
        self.analysis.update(self.main, sources, loader);
        self.compiled = Arc::default();
        self.forget();
    }

    /// Takes over the layout called `name` at `path`; `None`: there is none.
    pub fn set_layout(&mut self, layout: Option<(String, &Path, io::Result<Vec<u8>>)>) {
        self.layout = layout.and_then(|(name, path, bytes)| {
            let missing = bytes.as_ref().err().is_some_and(|e| e.kind() == io::ErrorKind::NotFound);
            if missing {
                return None;
            }
            let sources = Arc::make_mut(&mut self.sources);
            let told = |e: io::Error| {
                Box::new(Diagnostic::without_place(codes::E0001, format!("cannot read {name}: {}", plain(&e))))
            };
            let (text, unreadable) = match bytes.map_err(told).and_then(layout_file::decode) {
                Ok(text) => (text, None),
                Err(finding) => (String::new(), Some(*finding)),
            };
            let file = sources.put(SourceFile::new(name, path, text));
            let read = layout_file::read(sources.get(file).text(), file);
            Some(Arc::new(LayoutFile { file, path: path.to_owned(), read, unreadable }))
        });
        self.forget();
    }

    /// Judges in another way from now on.
    pub fn set_judging(&mut self, judging: Judging) {
        if *self.judging != judging {
            self.judging = Arc::new(judging);
            self.forget();
        }
    }

    fn forget(&mut self) {
        self.judged = Arc::default();
        self.explained = Arc::default();
    }

    /// What is known now, for another thread.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot {
            analysis: self.analysis.reader(),
            sources: Arc::clone(&self.sources),
            main: self.main,
            compiled: Arc::clone(&self.compiled),
            layout: self.layout.clone(),
            judging: Arc::clone(&self.judging),
            judged: Arc::clone(&self.judged),
            explained: Arc::clone(&self.explained),
        }
    }

    /// Where the program is.
    pub fn path(&self) -> &Path {
        self.sources.get(self.main).path()
    }

    /// The files that were read for the program, itself included, its layout not.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        let layout = self.layout.as_ref().map(|l| l.file);
        self.sources.iter().filter(move |(id, _)| Some(*id) != layout).map(|(_, file)| file.path())
    }
}

impl Snapshot {
    /// The program's files, and its layout.
    pub fn sources(&self) -> &SourceMap {
        &self.sources
    }
    /// The program's own file.
    pub fn main(&self) -> FileId {
        self.main
    }
    /// The text of the program's own file.
    pub fn text(&self) -> &str {
        self.sources.get(self.main).text()
    }
    /// The program's layout, if there is one.
    pub fn layout(&self) -> Option<&LayoutFile> {
        self.layout.as_deref()
    }
    /// The same, to keep.
    pub fn layout_file(&self) -> Option<Arc<LayoutFile>> {
        self.layout.clone()
    }
    /// How its layout is judged.
    pub fn judging(&self) -> &Judging {
        &self.judging
    }
    /// The front end.
    pub fn analysis(&self) -> &Analysis {
        &self.analysis
    }
    /// The files alone, with the id of the program's own: what is left of a snapshot that no change has to wait for.
    pub fn into_sources(self) -> (Arc<SourceMap>, FileId) {
        (self.sources, self.main)
    }
    /// The text of a place.
    pub fn slice(&self, span: Span) -> &str {
        self.sources.text(span)
    }

    /// What the statements of the program's own file mean.
    ///
    /// # Errors
    /// [`Cancelled`]: the text has changed.
    pub fn meanings(&self) -> Result<Meanings<'_>, Cancelled> {
        self.analysis.meanings(self.main)
    }

    /// The program; worked out once.
    ///
    /// # Errors
    /// [`Cancelled`]: the text has changed.
    pub fn compiled(&self) -> Result<Arc<Compiled>, Cancelled> {
        self.compiled.get_or(|| {
            let (program, mut diagnostics) = self.analysis.partial(&self.sources)?;
            let complete = !diagnostics.iter().any(Diagnostic::is_error);
            diagnostics.retain(|d| !self.judging.allow.contains(&d.code) || d.is_error());
            Ok(Compiled { program, complete, diagnostics })
        })
    }

    /// What holds in the layout; `None`: there is none that can be read. Worked out once.
    ///
    /// # Errors
    /// [`Cancelled`]: the text has changed.
    pub fn judged(&self) -> Result<Option<Arc<Judged>>, Cancelled> {
        let Some(layout) = self.layout.as_ref().filter(|l| l.read.usable) else { return Ok(None) };
        self.judged
            .get_or(|| {
                let compiled = self.compiled()?;
                let mut options = self.judging.options;
                options.detail.explain = Explain::First(0);
                options.detail.sentences = false;
                options.physics &= compiled.complete;
                let mut verdict = check_read(&compiled.program, &layout.read, &options);
                if !compiled.complete {
                    // What the layout has and the program has not may be declared where the program is broken.
                    verdict.diagnostics.retain(|d| d.code != codes::E0506);
                }
                scenelang_lang::lint::allow::silence(&self.sources, &mut verdict.diagnostics);
                verdict.diagnostics.retain(|d| !self.judging.allow.contains(&d.code) || d.is_error());
                Ok(Judged { verdict, compiled })
            })
            .map(Some)
    }

    /// The same with sentences, and with every violation explained; rows are in the same order. Takes much longer.
    ///
    /// # Errors
    /// [`Cancelled`]: the text has changed.
    pub fn explained(&self) -> Result<Option<Arc<Verdict>>, Cancelled> {
        let Some(layout) = self.layout.as_ref().filter(|l| l.read.usable) else { return Ok(None) };
        self.explained
            .get_or(|| {
                let compiled = self.compiled()?;
                let mut options = self.judging.options;
                options.detail.sentences = true;
                options.physics &= compiled.complete;
                Ok(check_read(&compiled.program, &layout.read, &options))
            })
            .map(Some)
    }
}

/// A value that is worked out once, by whoever needs it first.
#[derive(Debug)]
struct Memo<T>(Mutex<Option<Arc<T>>>);

impl<T> Default for Memo<T> {
    fn default() -> Self {
        Self(Mutex::new(None))
    }
}

impl<T> Memo<T> {
    fn get_or(&self, make: impl FnOnce() -> Result<T, Cancelled>) -> Result<Arc<T>, Cancelled> {
        // A thread that panicked while it held the lock has left nothing half-made.
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match &*known {
            Some(value) => Ok(Arc::clone(value)),
            None => Ok(Arc::clone(known.insert(Arc::new(make()?)))),
        }
    }
}
