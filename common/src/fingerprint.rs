//! Fingerprints: 64 bits that tell whether bytes are still the same.

/// A fingerprint of bytes, FNV-1a.
///
/// One byte that changes always changes it; other damage goes unnoticed once in 2⁶⁴ times. It protects from accidents
/// and not from forgers.
///
/// Source: Fowler, Noll, Vo, Eastlake, Hansen, *The FNV Non-Cryptographic Hash Algorithm*, RFC 9923.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fingerprint(u64);

impl Default for Fingerprint {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Fingerprint {
    /// The fingerprint of some bytes.
    #[must_use]
    pub fn of(bytes: &[u8]) -> Self {
        let mut fingerprint = Self::default();
        fingerprint.add(bytes);
        fingerprint
    }

    /// Take more bytes into it.
    pub fn add(&mut self, bytes: &[u8]) {
        const PRIME: u64 = 0x0100_0000_01b3;
        self.0 = bytes.iter().fold(self.0, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(PRIME));
    }

    /// Its bits.
    #[must_use]
    pub fn bits(self) -> u64 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The test vectors of the RFC.
    #[test]
    fn it_is_fnv_1a() {
        for (text, bits) in
            [("", 0xcbf2_9ce4_8422_2325), ("a", 0xaf63_dc4c_8601_ec8c), ("foobar", 0x8594_4171_f739_67e8)]
        {
            assert_eq!(Fingerprint::of(text.as_bytes()).bits(), bits);
        }
    }

    #[test]
    fn bytes_may_come_in_pieces() {
        let mut fingerprint = Fingerprint::of(b"foo");
        fingerprint.add(b"bar");
        assert_eq!(fingerprint, Fingerprint::of(b"foobar"));
    }
}
