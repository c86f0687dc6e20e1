//! The editors that a project can be written for, and what the fields of their files are called there.

/// A version of Unity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Editor {
    /// 2022.3; later editors bring its files up to date when they first open them.
    #[default]
    V2022,
    /// 6000.0, which is Unity 6.
    V6000,
}

impl Editor {
    /// The editor that a project is for, by what it says of its version; `None`: it says nothing.
    pub fn of_project(text: &str) -> Option<Self> {
        let version = text.lines().find_map(|line| line.strip_prefix("m_EditorVersion:"))?;
        let year: u32 = version.trim().split('.').next()?.parse().ok()?;
        // Between the two, files have the older fields.
        Some(if year >= 6000 { Self::V6000 } else { Self::V2022 })
    }

    /// The version that the project says it is of.
    pub(super) fn version(self) -> &'static str {
        self.either("2022.3.16f1", "6000.0.23f1")
    }

    /// The version of the package of the Universal Render Pipeline.
    pub(super) fn universal(self) -> &'static str {
        self.either("14.0.9", "17.0.3")
    }

    /// What the one has, or the other.
    pub(super) fn either<T>(self, v2022: T, v6000: T) -> T {
        match self {
            Self::V2022 => v2022,
            Self::V6000 => v6000,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_project_says_which_editor_it_is_for() {
        for editor in [Editor::V2022, Editor::V6000] {
            let text = format!("m_EditorVersion: {}\n", editor.version());
            assert_eq!(Editor::of_project(&text), Some(editor));
        }
        assert_eq!(Editor::of_project("m_EditorVersion: 2023.2.1f1\r\nm_Other: 1\r\n"), Some(Editor::V2022));
        for text in ["", "m_EditorVersion: new\n"] {
            assert_eq!(Editor::of_project(text), None);
        }
    }
}
