//! Files of other systems, written here from their descriptions, read back; and such as are broken.

mod broken;
mod exact;
mod houses;
mod written;
