//! Files of other systems, written here from their descriptions, read back; and such as are broken.
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic, too")]

mod broken;
mod exact;
mod houses;
mod written;
