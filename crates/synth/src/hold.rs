//! Which objects stay where the layout to start from has them, by the names that a person gives.

use scenelang_base::suggest::nearest;
use scenelang_base::{Diagnostic, codes};
use scenelang_lang::Program;
use scenelang_lang::program::ObjectId;
use scenelang_layout::Layout;

/// What must not be moved. A name is that of an object (`chair[2]`) or of an array (`chair`: all its elements).
#[derive(Clone, Copy, Debug, Default)]
pub enum Hold<'a> {
    #[default]
    Nothing,
    These(&'a [String]),
    /// All but these.
    AllBut(&'a [String]),
}

impl Hold<'_> {
    /// The objects that it names.
    ///
    /// # Errors
    /// A name stands for nothing, or an object has no place to be held at.
    pub fn objects(self, program: &Program, start: Option<&Layout>) -> Result<Vec<ObjectId>, Box<Diagnostic>> {
        let (names, given) = match self {
            Self::Nothing => return Ok(Vec::new()),
            Self::These(names) => (names, true),
            Self::AllBut(names) => (names, false),
        };
        let mut named = vec![false; program.objects.len()];
        for name in names {
            let mut found = false;
            for (object, named) in program.objects.iter().zip(&mut named) {
                let own = object.is_meant_by(name);
                *named |= own;
                found |= own;
            }
            if !found {
                let known = program.objects.iter().map(|o| o.name.as_str());
                let finding = Diagnostic::without_place(codes::E0201, format!("the program has no object `{name}`"));
                return Err(Box::new(match nearest(name, known) {
                    Some(near) => finding.note(format!("did you mean `{near}`?")),
                    None => finding,
                }));
            }
        }
        let placed = |object: &&(usize, &str)| start.is_some_and(|layout| layout.object(object.1).is_some());
        let held = program.objects.iter().enumerate().map(|(i, o)| (i, o.name.as_str()));
        let held: Vec<(usize, &str)> = held.filter(|(i, _)| named[*i] == given).collect();
        if let Some((_, name)) = held.iter().find(|object| !placed(object)).filter(|_| given) {
            let say = format!("`{name}` cannot be locked: it is not in the layout to start from");
            let finding = Diagnostic::without_place(codes::E0201, say);
            return Err(Box::new(finding.note("name such a layout with `--layout`")));
        }
        Ok(held.iter().filter(placed).map(|(i, _)| ObjectId(*i as u32)).collect())
    }
}
