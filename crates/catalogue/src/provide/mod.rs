//! Where furniture comes from: providers that are asked one after the other, for each object by itself, until one has
//! something. Who gave what, and why the ones before it did not, is part of the answer.

mod fit;
pub mod generator;
mod library;
mod local;

pub use library::{Boxed, Library};
pub use local::Local;

use scenelang_assets::{Mesh, words};
use scenelang_base::{Code, Diagnostic};
use scenelang_layout::{Joint, Part, Vec3};
use sha2::{Digest, Sha256};
use std::fmt;

/// What is wanted for an object. Texts are as the program has them; empty ones mean nothing was said.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Query {
    /// The object's name.
    pub name: String,
    /// The noun; where there is none, what the name says.
    pub what: String,
    /// The category as the program has it.
    pub category: String,
    pub color: String,
    pub material: String,
    /// Free words.
    pub features: String,
    /// Extents that the program demands (metres).
    pub size: Option<Vec3>,
    /// Extents that are usual, where it demands none (metres).
    pub usual: Option<Vec3>,
}

impl Query {
    /// What is searched for, and what a generator is asked to make: "red oak office chair, with armrests".
    pub fn text(&self) -> String {
        let noun = words(&self.what).join(" ");
        let said = [self.color.trim(), self.material.trim(), &noun];
        let said: Vec<&str> = said.into_iter().filter(|t| !t.is_empty()).collect();
        let features = self.features.trim();
        if features.is_empty() { said.join(" ") } else { format!("{}, {features}", said.join(" ")) }
    }

    /// The published form of the query, which features are computed for: "a 3D model of a red office chair made with oak that
    /// is with armrests". What was not said is left out.
    pub fn published(&self) -> String {
        let noun = words(&self.what).join(" ");
        let kind: Vec<&str> = [self.color.trim(), &noun].into_iter().filter(|t| !t.is_empty()).collect();
        let mut text = format!("a 3D model of a {}", kind.join(" "));
        for (before, said) in [(" made with ", self.material.trim()), (" that is ", self.features.trim())] {
            if !said.is_empty() {
                text += before;
                text += said;
            }
        }
        text
    }

    /// The extents that are demanded or usual.
    pub fn wanted(&self) -> Option<Vec3> {
        self.size.or(self.usual)
    }

    /// What an answer is found by again: a sum of who is asked, the words, the sizes, and of `content`, which the answer
    /// was made from.
    pub fn key(&self, provider: &str, content: &[u8]) -> String {
        let bits = |size: Option<Vec3>| size.map(|s| [s.x, s.y, s.z].map(f64::to_bits));
        let said = format!(
            "scenelang.piece/1\0{provider}\0{}\0{:x?}\0{:x?}\0",
            self.text(),
            bits(self.size),
            bits(self.usual)
        );
        sum(&[said.as_bytes(), content])
    }
}

/// The SHA-256 sum of all of these, one after the other.
pub(crate) fn sum(bytes: &[&[u8]]) -> String {
    let mut hash = Sha256::new();
    bytes.iter().for_each(|b| hash.update(b));
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// A thing, ready to be placed: frame and unit are those of the layout.
#[derive(Clone, Debug)]
pub struct ProvidedModel {
    /// Extents w, h, d (metres).
    pub size: Vec3,
    /// Convex solids; their common box is that of the piece.
    pub parts: Vec<Part>,
    /// Height of the support surface above the base where it is not the top.
    pub surface: Option<f64>,
    /// What of it can be opened.
    pub joints: Vec<Joint>,
    /// What is seen.
    pub mesh: Mesh,
}

/// A piece, and where it comes from.
#[derive(Clone, Debug)]
pub struct Given {
    /// What is placed.
    pub piece: ProvidedModel,
    /// The file, the family of the library, or what was asked of a generator.
    pub source: String,
    /// How well it fits, where that is measured.
    pub score: Option<f64>,
    /// SHA-256 of the file that it was read from.
    pub content: Option<String>,
    /// Under which licence it may be used, where that is known.
    pub licence: Option<String>,
}

/// Why a provider, or a model of it, was not used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Why {
    /// It has no such thing.
    Nothing,
    /// What it has fits the words too little.
    Score,
    /// What it has is of another size.
    Size,
    /// A model cannot be used.
    Broken,
    /// The provider did not work.
    Failed,
    /// Nothing more may be asked of it.
    Budget,
}

impl Why {
    /// As it is written for programs.
    pub fn name(self) -> &'static str {
        match self {
            Self::Nothing => "nothing",
            Self::Score => "score",
            Self::Size => "size",
            Self::Broken => "broken",
            Self::Failed => "failed",
            Self::Budget => "budget",
        }
    }
}

/// What was not used, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Remark {
    /// In one word.
    pub why: Why,
    /// In a sentence, which names the file if it is about one.
    pub say: String,
    /// Of a file that cannot be used: what is wrong with it.
    pub code: Option<Code>,
}

impl Remark {
    pub(crate) fn new(why: Why, say: impl Into<String>) -> Self {
        Self { why, say: say.into(), code: None }
    }

    pub(crate) fn broken(file: &str, finding: &Diagnostic) -> Self {
        Self { why: Why::Broken, say: format!("{file}: {}", finding.message), code: Some(finding.code) }
    }
}

/// What a provider says to a query.
#[derive(Clone, Debug, Default)]
pub struct Reply {
    /// What it gives, if it has something.
    pub given: Option<Given>,
    /// What it did not use.
    pub remarks: Vec<Remark>,
}

impl Reply {
    pub(crate) fn passes(why: Why, say: impl Into<String>) -> Self {
        Self { given: None, remarks: vec![Remark::new(why, say)] }
    }
}

/// Somebody who has furniture, or makes it.
pub trait AssetProvider: fmt::Debug + Send + Sync {
    /// What it is called in reports: `models`, `library`.
    fn name(&self) -> &str;

    /// Answers all queries, in their order. An answer depends on its query and on what the provider has, never on the
    /// other queries, unless a budget is spent. `say` is told how far it is.
    fn provide(&self, queries: &[&Query], say: &mut dyn FnMut(&str)) -> Vec<Reply>;
}

/// What was chosen for a query.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Who gave it.
    pub provider: String,
    pub given: Given,
    /// What was not used before: who, and why.
    pub passed: Vec<(String, Remark)>,
}

/// Providers in the order in which they are asked. The last one is always the labelled box.
#[derive(Debug)]
pub struct Chain {
    providers: Vec<Box<dyn AssetProvider>>,
}

impl Chain {
    /// Asks these first.
    pub fn new(providers: Vec<Box<dyn AssetProvider>>) -> Self {
        Self { providers }
    }

    /// Chooses for each query by itself.
    pub fn choose(&self, queries: &[Query], say: &mut dyn FnMut(&str)) -> Vec<Choice> {
        let mut chosen: Vec<Option<(String, Given)>> = vec![None; queries.len()];
        let mut passed: Vec<Vec<(String, Remark)>> = vec![Vec::new(); queries.len()];
        let last: Box<dyn AssetProvider> = Box::new(Boxed);
        for provider in self.providers.iter().chain([&last]) {
            let open: Vec<usize> = (0..queries.len()).filter(|&i| chosen[i].is_none()).collect();
            if open.is_empty() {
                break;
            }
            let asked: Vec<&Query> = open.iter().map(|&i| &queries[i]).collect();
            for (i, reply) in open.into_iter().zip(provider.provide(&asked, say)) {
                let name = provider.name().to_owned();
                passed[i].extend(reply.remarks.into_iter().map(|remark| (name.clone(), remark)));
                chosen[i] = reply.given.map(|given| (name, given));
            }
        }
        let both = chosen.into_iter().zip(passed).zip(queries);
        both.map(|((chosen, passed), query)| {
            let (provider, given) = chosen.unwrap_or_else(|| (Boxed.name().to_owned(), library::boxed(query)));
            Choice { provider, given, passed }
        })
        .collect()
    }
}
