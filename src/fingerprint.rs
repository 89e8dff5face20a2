//! Names for what is too long to be one: FNV-1a of 128 bits, the same on every machine, which the
//! standard library's hashes do not promise.

/// A hash of texts in their order. It tells what differs by chance or by mistake, not by malice.
pub(crate) struct Fingerprint(u128);

/// Offset and prime of FNV-1a (Fowler, Noll, Vo; RFC 9923).
const OFFSET: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;

impl Fingerprint {
    /// Of nothing yet.
    pub(crate) fn new() -> Self {
        Self(OFFSET)
    }

    /// Adds a text; where one ends and the next begins counts.
    pub(crate) fn add(&mut self, text: &[u8]) {
        let length = (text.len() as u64).to_le_bytes();
        for byte in length.iter().chain(text) {
            self.0 = (self.0 ^ u128::from(*byte)).wrapping_mul(PRIME);
        }
    }

    /// 32 hexadecimal digits.
    pub(crate) fn hex(&self) -> String {
        format!("{:032x}", self.0)
    }
}
