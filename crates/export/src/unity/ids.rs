//! Identities that stay the same when a project is written again, so that a user's own references survive.

use md5::{Digest, Md5};
use std::fmt::Write;
use xxhash_rust::xxh64::xxh64;

/// The GUID of an asset by its path in the project: 32 lower-case hexadecimal digits.
pub(super) fn guid(path: &str) -> String {
    Md5::digest(format!("scenelang:{path}")).iter().fold(String::with_capacity(32), |mut out, byte| {
        let _ = write!(out, "{byte:02x}");
        out
    })
}

/// The anchor of a component in the scene; positive.
pub(super) fn anchor(owner: &str, component: &str) -> i64 {
    (xxh64(format!("scenelang:{owner}/{component}").as_bytes(), 0) >> 1) as i64
}

/// What Unity calls the one mesh of an OBJ file without groups: a hash of its class and the name `default`.
pub(super) fn obj_mesh() -> i64 {
    xxh64(b"Type:Mesh->default0", 0) as i64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hashes_are_those_that_unity_computes() {
        // Seen in prefabs that use OBJ meshes.
        assert_eq!(obj_mesh(), -2432090755550338912);
        // The root of every imported model.
        assert_eq!(xxh64(b"Type:GameObject->//RootNode/root0", 0) as i64, 919132149155446097);
    }

    #[test]
    fn identities_are_stable() {
        assert_eq!(guid("Assets/Scenes"), guid("Assets/Scenes"));
        assert_ne!(guid("Assets/Scenes"), guid("Assets/Scenes/a.unity"));
        assert!(guid("x").bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b)));
        assert!(anchor("chair[0]", "Transform") > 4);
        assert_ne!(anchor("chair[0]", "Transform"), anchor("chair[0]", "GameObject"));
    }
}
