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
