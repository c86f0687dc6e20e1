//! `scenelang completions` and `scenelang man`: what shells, `man` and the book are told of the command line. All of it is
//! made of the options themselves, so that it cannot be out of date.

use crate::args::{Args, Completions, Man, Page};
use crate::replace::May;
use crate::{FAILED, GOOD, out, replace};
use clap::builder::{PossibleValue, StyledStr};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command, CommandFactory};
use clap_mangen::Man as Roff;
use scenelang_base::suggest;
use scenelang_export::OutFile;
use std::fmt::Write;
use std::io;

/// Prints the completions of a shell.
pub fn completions(args: &Completions) -> u8 {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Args::command(), "scenelang", &mut script);
    out::show(&String::from_utf8_lossy(&script));
    GOOD
}

/// The page of a command that is called by these words, such as `assets import`.
pub fn command(words: &str) -> Option<String> {
    let mut whole = Args::command().disable_help_subcommand(true);
    whole.build();
    let words: Vec<String> = words.split_whitespace().map(str::to_owned).collect();
    let command = find(&whole, &words).ok()?;
    (!words.is_empty() && !command.is_hide_set()).then(|| markdown(command))
}

/// The names of the commands, those below others with the names of these before them.
pub fn commands() -> Vec<String> {
    let mut whole = Args::command().disable_help_subcommand(true);
    whole.build();
    let names = all(&whole).into_iter().skip(1).map(called);
    names.map(|name| name.strip_prefix("scenelang ").unwrap_or(name).to_owned()).collect()
}

/// An error of the command line; of an unknown option it suggests the nearest one that the command has.
pub fn with_near_option(mut error: clap::Error) -> clap::Error {
    let unknown = match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::String(option)) if error.kind() == ErrorKind::UnknownArgument => option.clone(),
        _ => return error,
    };
    let Some(word) = unknown.strip_prefix("--").filter(|_| error.get(ContextKind::SuggestedArg).is_none()) else {
        return error;
    };
    let whole = Args::command();
    let words = std::env::args().skip(1);
    let command = words.fold(&whole, |command, word| command.find_subcommand(&word).unwrap_or(command));
    let options = command.get_arguments().filter(|arg| !arg.is_hide_set()).filter_map(Arg::get_long);
    if let Some(near) = suggest::nearest(word, options) {
        error.insert(ContextKind::SuggestedArg, ContextValue::String(format!("--{near}")));
        // That it may be a value is less likely than a slip.
        error.insert(ContextKind::Suggested, ContextValue::None);
    }
    error
}

/// Prints a page, or writes all of them.
pub fn man(args: &Man) -> u8 {
    match written(args) {
        Ok(()) => GOOD,
        Err(message) => {
            eprintln!("error: {message}");
            FAILED
        }
    }
}

fn written(args: &Man) -> Result<(), String> {
    let mut whole = Args::command().disable_help_subcommand(true);
    whole.build();
    let Some(folder) = &args.output else {
        let command = find(&whole, &args.command)?;
        out::show(&page(command, args.format)?);
        return Ok(());
    };
    let mut files = Vec::new();
    for command in all(&whole) {
        let (name, end) = match args.format {
            Page::Man => (called(command).replace(' ', "-"), "1"),
            Page::Markdown => (file_name(command), "md"),
        };
        files.push(OutFile::new(format!("{name}.{end}"), page(command, args.format)?.into_bytes()));
    }
    for path in replace::folder(folder, &files, &[], May { force: args.force, these: &[] })? {
        out::show(&format!("{}\n", path.display()));
    }
    Ok(())
}

/// What a command is called with all that stands before it: `scenelang bench solve`.
fn called(command: &Command) -> &str {
    command.get_bin_name().unwrap_or_else(|| command.get_name())
}

/// The file of its page in the book, without the ending.
fn file_name(command: &Command) -> String {
    let name = called(command);
    name.strip_prefix("scenelang ").unwrap_or(name).replace(' ', "-")
}

fn find<'c>(whole: &'c Command, words: &[String]) -> Result<&'c Command, String> {
    words.iter().try_fold(whole, |command, word| {
        command.find_subcommand(word).ok_or_else(|| {
            let names: Vec<&str> = below(command).map(Command::get_name).collect();
            match names.is_empty() {
                true => format!("{} has no commands of its own", called(command)),
                false => format!("{} has no command `{word}`; it has {}", called(command), names.join(", ")),
            }
        })
    })
}

/// The command, and all below that people call.
fn all(command: &Command) -> Vec<&Command> {
    std::iter::once(command).chain(below(command).flat_map(all)).collect()
}

fn below(command: &Command) -> impl Iterator<Item = &Command> {
    command.get_subcommands().filter(|command| !command.is_hide_set())
}

fn page(command: &Command, format: Page) -> Result<String, String> {
    match format {
        Page::Markdown => Ok(markdown(command)),
        Page::Man => {
            let mut text = Vec::new();
            let title = called(command).replace(' ', "-");
            let page = Roff::new(command.clone()).title(title).manual("scenelang").date("");
            page.render(&mut text).map_err(|e: io::Error| e.to_string())?;
            String::from_utf8(text).map_err(|e| e.to_string())
        }
    }
}

/// The page of the book.
fn markdown(command: &Command) -> String {
    let mut out = format!("# {}\n\n", called(command));
    let about = command.get_about().map(StyledStr::to_string).unwrap_or_default();
    let _ = writeln!(out, "{}.\n", escaped(about.trim_end_matches('.')));
    let usage = command.clone().render_usage().to_string();
    let _ = writeln!(out, "`{}`", usage.trim_start_matches("Usage: ").trim());
    let below: Vec<&Command> = below(command).collect();
    if !below.is_empty() {
        out += "\n## Commands\n\n";
        for command in below {
            let about = command.get_about().map(StyledStr::to_string).unwrap_or_default();
            let _ = writeln!(out, "- [`{}`]({}.md): {}", called(command), file_name(command), escaped(&about));
        }
    }
    let told = |arg: &&Arg| !arg.is_hide_set() && !matches!(arg.get_id().as_str(), "help" | "version");
    let (places, options): (Vec<&Arg>, Vec<&Arg>) =
        command.get_arguments().filter(told).partition(|arg| arg.is_positional());
    for (title, args) in [("Arguments", places), ("Options", options)] {
        if !args.is_empty() {
            let _ = writeln!(out, "\n## {title}\n");
            args.into_iter().for_each(|arg| option(&mut out, arg));
        }
    }
    out
}

/// A line on an option, and one on each of its values.
fn option(out: &mut String, arg: &Arg) {
    let names = arg.get_short().map(|c| format!("-{c}")).into_iter();
    let names: Vec<String> = names.chain(arg.get_long().map(|long| format!("--{long}"))).collect();
    let takes = arg.is_positional() || arg.get_action().takes_values();
    let values: Vec<String> =
        arg.get_value_names().unwrap_or_default().iter().filter(|_| takes).map(ToString::to_string).collect();
    let head = names.join(", ") + if names.is_empty() || values.is_empty() { "" } else { " " } + &values.join(" ");
    let help = arg.get_help().map(StyledStr::to_string).unwrap_or_default();
    let _ = write!(out, "- `{head}`: {}", escaped(&help));
    let defaults: Vec<String> =
        arg.get_default_values().iter().filter(|_| takes).map(|v| v.to_string_lossy().into_owned()).collect();
    if !defaults.is_empty() && !arg.is_hide_default_value_set() {
        let _ = write!(out, " (default: `{}`)", defaults.join(" "));
    }
    out.push('\n');
    let possible = if takes { arg.get_possible_values() } else { Vec::new() };
    let known: Vec<&PossibleValue> = possible.iter().filter(|value| !value.is_hide_set()).collect();
    if known.iter().all(|value| value.get_help().is_none()) && !known.is_empty() {
        let names: Vec<String> = known.iter().map(|value| format!("`{}`", value.get_name())).collect();
        let _ = writeln!(out, "  - one of {}", names.join(", "));
        return;
    }
    for value in known {
        let help = value.get_help().map(StyledStr::to_string).unwrap_or_default();
        let _ = writeln!(out, "  - `{}`: {}", value.get_name(), escaped(&help));
    }
}

/// What Markdown would take for something else.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    let mut in_code = false;
    for c in text.split_whitespace().collect::<Vec<_>>().join(" ").chars() {
        in_code ^= c == '`';
        if !in_code && matches!(c, '<' | '>' | '[' | ']' | '*' | '_' | '|') {
            out.push('\\');
        }
        out.push(c);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_command_has_a_page() {
        let mut whole = Args::command().disable_help_subcommand(true);
        whole.build();
        let commands = all(&whole);
        assert!(commands.len() > 25);
        for command in commands {
            for format in [Page::Man, Page::Markdown] {
                let text = page(command, format).unwrap_or_default();
                assert!(text.lines().count() > 3, "{}", called(command));
            }
        }
        let check = find(&whole, &["check".to_owned()]).map(markdown).unwrap_or_default();
        assert!(check.starts_with("# scenelang check\n\nCheck programs and layouts"), "{check}");
        assert!(check.contains("- `--format FORMAT`: The output format"), "{check}");
        assert!(find(&whole, &["chekc".to_owned()]).is_err_and(|why| why.contains("check")));
    }
}
