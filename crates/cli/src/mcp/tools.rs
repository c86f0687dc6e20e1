//! The table of tools: what each takes, what it is for, and what does it.

use super::workspace::Workspace;
use super::{judging, looking, making};
use rmcp::model::{CallToolResult, ContentBlock, JsonObject, Tool, ToolAnnotations};
use scenelang_base::plain;
use scenelang_solve::Stop;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use std::time::Duration;

/// A call of a tool.
pub struct Call<'a> {
    /// Where it works.
    pub workspace: &'a Workspace,
    /// Set when the call is cancelled, or its time is over.
    pub stop: &'a Stop,
    /// How long it may take.
    pub time: Duration,
}

impl Call<'_> {
    /// What is said when it was ended before there was anything to show.
    pub fn late(&self) -> String {
        format!(
            "it was stopped after {} s, before it had a result; `scenelang mcp --time SECONDS` lets a call take longer",
            self.time.as_secs_f64()
        )
    }
}

/// What a tool says: a JSON object, and perhaps a picture.
pub struct ToolAnswer {
    /// In names and sentences.
    pub said: Value,
    /// PNG, as base64.
    pub picture: Option<String>,
}

impl ToolAnswer {
    /// Without a picture.
    pub fn of(said: Value) -> Self {
        Self { said, picture: None }
    }

    /// As the protocol has it.
    pub fn into_result(self) -> CallToolResult {
        let mut result = CallToolResult::structured(self.said);
        result.content.extend(self.picture.map(|data| ContentBlock::image(data, "image/png")));
        result
    }
}

/// What a tool says, or why it could not do its work and what to do about it.
pub type Answered = Result<ToolAnswer, String>;

pub struct Spec {
    /// As it is called.
    pub name: &'static str,
    says: &'static str,
    takes: &'static [Param],
    /// Whether it makes files.
    makes: bool,
    run: fn(&Call<'_>, JsonObject) -> Answered,
}

struct Param {
    name: &'static str,
    kind: Kind,
    needed: bool,
    says: &'static str,
}

#[derive(Clone, Copy)]
enum Kind {
    Text,
    OneOf(&'static [&'static str]),
    Whole,
    Flag,
    Texts,
    Edits,
}

const fn needed(name: &'static str, kind: Kind, says: &'static str) -> Param {
    Param { name, kind, needed: true, says }
}

const fn may(name: &'static str, kind: Kind, says: &'static str) -> Param {
    Param { name, kind, needed: false, says }
}

const FILE: Param = needed(
    "file",
    Kind::Text,
    "a program (such as room.scene) or a layout (such as room.layout.json), as a path relative to the workspace folder",
);
const PROGRAM: Param =
    needed("file", Kind::Text, "a program (such as room.scene), as a path relative to the workspace folder");

/// All of them.
pub const TOOLS: &[Spec] = &[
    Spec {
        name: "check",
        says: "Check a program and the layout beside it: what holds, what fails and why, and the errors in the program.",
        takes: &[FILE],
        makes: false,
        run: |call, args| judging::check(call, read(args)?),
    },
    Spec {
        name: "explain",
        says: "Explain a code (E0201, V0102) or a word of the language (near, gap, surface), with examples.",
        takes: &[needed("word", Kind::Text, "the code or the word")],
        makes: false,
        run: |call, args| looking::explain(call, read(args)?),
    },
    Spec {
        name: "formalize",
        says: "Write a program from a request in plain English, and list the words that were not used.",
        takes: &[
            needed("request", Kind::Text, "what is wanted: a study with a desk by the window and a lamp on it"),
            may("file", Kind::Text, "the file to write, such as room.scene; if omitted, the program is only returned"),
            may("literal", Kind::Flag, "add nothing that the request does not mention"),
        ],
        makes: true,
        run: |call, args| making::formalize(call, read(args)?),
    },
    Spec {
        name: "solve",
        says: "Find a layout that satisfies a program; it is written beside the program, as room.layout.json.",
        takes: &[
            PROGRAM,
            may(
                "seed",
                Kind::Whole,
                "a different seed gives a different layout; the same seed always gives the same one",
            ),
            may(
                "lock",
                Kind::Texts,
                "objects or whole arrays that stay where they are in the layout beside the program",
            ),
        ],
        makes: true,
        run: |call, args| making::solve(call, read(args)?),
    },
    Spec {
        name: "repair",
        says: "List the smallest verified changes of a layout or its program that make everything hold; with `apply`, apply one of them.",
        takes: &[
            FILE,
            may("constraint", Kind::Text, "repair only this: a line of the program, or an id that check gives"),
            may("apply", Kind::Whole, "apply the repair with this number"),
            may("lock", Kind::Texts, "objects or whole arrays that stay where they are"),
        ],
        makes: true,
        run: |call, args| making::repair(call, read(args)?),
    },
    Spec {
        name: "why_not",
        says: "List the statements of a program that contradict each other, as the smallest sets for which this is proved.",
        takes: &[
            PROGRAM,
            may(
                "statement",
                Kind::Text,
                "a statement to add to the program before the search, to find out why it cannot hold, \
                 such as `assert near(desk, window);`",
            ),
            may("proof", Kind::Flag, "explain the proof step by step"),
        ],
        makes: false,
        run: |call, args| judging::why_not(call, read(args)?),
    },
    Spec {
        name: "render",
        says: "Show a layout as a picture: from above with names, or in perspective.",
        takes: &[
            FILE,
            may("view", Kind::OneOf(&["plan", "picture"]), "from above (plan, the default) or in perspective"),
        ],
        makes: false,
        run: |call, args| judging::render(call, read(args)?),
    },
    Spec {
        name: "speculate",
        says: "Show what an edit of a program or a layout would change in the results, without making the edit.",
        takes: &[
            FILE,
            may("text", Kind::Text, "the whole new text of the file"),
            may(
                "edits",
                Kind::Edits,
                "instead of `text`: pieces of the file, each of which occurs in it once, with their replacements",
            ),
        ],
        makes: false,
        run: |call, args| judging::speculate(call, read(args)?),
    },
    Spec {
        name: "vocabulary",
        says: "List all predicates, functions and properties; with a word, explain those whose names contain it, and list the categories of objects whose names contain it, with their usual sizes.",
        takes: &[may("word", Kind::Text, "a part of the names: near, chair")],
        makes: false,
        run: |call, args| looking::vocabulary(call, read(args)?),
    },
];

/// How it begins to be said that arguments are wrong.
const UNFIT: &str = "the arguments are not valid";

/// The tool of a name.
pub fn find(name: &str) -> Option<&'static Spec> {
    TOOLS.iter().find(|tool| tool.name == name)
}

impl Spec {
    /// Does it.
    ///
    /// # Errors
    /// For the assistant: what was wrong, and what to do about it.
    pub fn call(&self, call: &Call<'_>, args: JsonObject) -> Answered {
        let fit = |why: String| match why.starts_with(UNFIT) {
            true => format!("{why}; `{}` {}", self.name, self.taken()),
            false => why,
        };
        (self.run)(call, args).map_err(|why| plain::line(&fit(why)).into_owned())
    }

    /// What it takes, in a line.
    fn taken(&self) -> String {
        let names = |needed: bool| {
            let params = self.takes.iter().filter(|param| param.needed == needed);
            let names: Vec<String> = params.map(|param| format!("`{}`", param.name)).collect();
            match names.split_last() {
                Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
                _ => names.join(""),
            }
        };
        match (names(true), names(false)) {
            (needed, others) if others.is_empty() => format!("takes {needed}"),
            (needed, others) if needed.is_empty() => format!("optionally takes {others}"),
            (needed, others) => format!("takes {needed} and, optionally, {others}"),
        }
    }

    /// As clients are told of it.
    pub fn described(&self) -> Tool {
        let properties: JsonObject = self.takes.iter().map(|param| (param.name.to_owned(), param.schema())).collect();
        let needed: Vec<&str> = self.takes.iter().filter(|param| param.needed).map(|param| param.name).collect();
        let schema = json!({
            "type": "object",
            "properties": properties,
            "required": needed,
            "additionalProperties": false,
        });
        let Value::Object(schema) = schema else { unreachable!("it was written as an object") };
        let about = ToolAnnotations::new().read_only(!self.makes).destructive(false).open_world(false);
        Tool::new(self.name, self.says, schema).with_annotations(about)
    }
}

impl Param {
    fn schema(&self) -> Value {
        let mut schema = match self.kind {
            Kind::Text => json!({ "type": "string" }),
            Kind::OneOf(names) => json!({ "type": "string", "enum": names }),
            Kind::Whole => json!({ "type": "integer", "minimum": 0 }),
            Kind::Flag => json!({ "type": "boolean" }),
            Kind::Texts => json!({ "type": "array", "items": { "type": "string" } }),
            Kind::Edits => json!({
                "type": "array",
                "items": {
                    "type": "object",
                    "properties": { "old": { "type": "string" }, "new": { "type": "string" } },
                    "required": ["old", "new"],
                    "additionalProperties": false,
                },
            }),
        };
        schema["description"] = self.says.into();
        schema
    }
}

fn read<T: DeserializeOwned>(args: JsonObject) -> Result<T, String> {
    serde_json::from_value(Value::Object(args)).map_err(|e| format!("{UNFIT}: {e}"))
}
