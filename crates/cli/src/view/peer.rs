//! Which user of this machine has opened a connection. Where the system says so (Linux), other users do not get as far as to
//! be asked for the secret: a program that opens the browser shows its address, and the secret in it, to all of them.

use std::net::SocketAddr;

/// Whether a connection on loopback was opened by another user. `false` also where nobody can say.
#[cfg(target_os = "linux")]
pub fn is_another_user(peer: SocketAddr, here: SocketAddr) -> bool {
    use std::os::unix::fs::MetadataExt;
    let Ok(own) = std::fs::metadata("/proc/self").map(|own| own.uid()) else { return false };
    let tables = ["/proc/net/tcp", "/proc/net/tcp6"];
    let found = tables.iter().find_map(|table| owner(&std::fs::read_to_string(table).ok()?, peer.port(), here.port()));
    // Whoever runs this as the administrator has the browser of somebody else.
    own != 0 && found.is_some_and(|user| user != own)
}

/// The same where the system does not say.
#[cfg(not(target_os = "linux"))]
pub fn is_another_user(_: SocketAddr, _: SocketAddr) -> bool {
    false
}

/// The user of the socket that is connected from one port of this machine to another, in a table of the system:
/// ` 0: 0100007F:A506 0100007F:01BB 01 … uid …`.
#[cfg(any(target_os = "linux", test))]
fn owner(table: &str, from: u16, to: u16) -> Option<u32> {
    // Addresses are 127.0.0.1 as the table writes it, alone or within an address of IPv6.
    let is = |text: &str, port: u16| {
        let own = text.split_once(':').filter(|(address, _)| address.ends_with("0100007F"));
        own.and_then(|(_, written)| u16::from_str_radix(written, 16).ok()) == Some(port)
    };
    table.lines().skip(1).find_map(|line| {
        let mut words = line.split_whitespace().skip(1);
        let both = is(words.next()?, from) && is(words.next()?, to);
        if both { words.nth(4)?.parse().ok() } else { None }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str =
        "  sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode
   0: 0100007F:07E8 00000000:0000 0A 00000000:00000000 00:00000000 00000000     0        0 1066 1 0 100 0 0 10 0
   1: 0100007F:07E8 0100007F:A506 01 00000000:00000000 02:0000047E 00000000  1000        0 2435 2 0 20 4 24 10 -1
   2: 0100007F:A506 0100007F:07E8 01 00000000:00000000 02:0000047E 00000000  1001        0 2436 2 0 20 4 24 10 -1
   3: broken
   4: 0000000000000000FFFF00000100007F:A507 0000000000000000FFFF00000100007F:07E8 01 0:0 0:0 0  1002 0 2437
   5: 020200C0:A508 507100CB:07E8 01 00000000:00000000 00:00000000 00000000  1003        0 2438 2 0 20 20 0 62 146";

    #[test]
    fn the_other_end_is_found() {
        for (from, wanted) in [(0xA506, Some(1001)), (0xA507, Some(1002)), (0xA508, None), (0x07E8, None), (1, None)] {
            assert_eq!(owner(TABLE, from, 0x07E8), wanted, "{from}");
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn we_are_no_other_user() {
        use std::net::{TcpListener, TcpStream};
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let here = listener.local_addr().unwrap();
        let client = TcpStream::connect(here).unwrap();
        assert!(!is_another_user(client.local_addr().unwrap(), here));
    }
}
