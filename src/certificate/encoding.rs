//! Certificates as bytes: a line that says what they are and of which version, then all numbers,
//! little-endian, compressed with a check sum of their own (zlib, RFC 1950).

use std::io::{Read, Write};

use flate2::Compression;
use flate2::read::ZlibDecoder;
use flate2::write::ZlibEncoder;

use super::types::{Assumption, Certificate, Factor, LongestWay, Slice};

/// What every file of a certificate begins with, before the number of its version.
const TITLE: &str = "trilith lower bound, version ";

/// The version that is written and read.
const VERSION: &str = "3";

/// Most bytes that a certificate may have when it is not compressed: some 200 slices of 33 blocks.
const LARGEST: u64 = 256 << 20;

/// Why bytes are no certificate.
#[allow(missing_docs, reason = "the sentence of each says it")]
#[derive(Clone, Debug, thiserror::Error, PartialEq, Eq)]
pub enum Unreadable {
    #[error("it is no certificate: it does not begin with `{TITLE}`")]
    NoCertificate,
    #[error("it is of version `{0}`, and this program reads version {VERSION}")]
    Version(String),
    #[error("it is cut off or damaged")]
    Damaged,
}

impl Certificate {
    /// The bytes of a file.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut plain = Vec::new();
        let scene = self.scene.as_bytes();
        count(&mut plain, scene.len());
        plain.extend_from_slice(scene);
        numbers(&mut plain, &[self.lower, self.cap]);
        list(&mut plain, &self.opening);
        count(&mut plain, self.longest_way as usize);
        count(&mut plain, self.slices.len());
        for slice in &self.slices {
            numbers(&mut plain, &[slice.from, slice.to, slice.sigma]);
            count(&mut plain, slice.assumed.len());
            for assumed in &slice.assumed {
                // Twice the product, and one more for the rate.
                let of_rate = usize::from(assumed.zero == Factor::Rate);
                count(&mut plain, 2 * assumed.pair + of_rate);
            }
            list(&mut plain, &slice.multipliers);
            list(&mut plain, &slice.balance);
        }
        // The best one takes four times as long, for 2 % less (openings-3).
        let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
        let compressed = encoder.write_all(&plain).and_then(|()| encoder.finish());
        let title = format!("{TITLE}{VERSION}\n");
        // Memory takes what is written.
        [title.into_bytes(), compressed.expect("a vector grows")].concat()
    }

    /// The certificate that bytes hold.
    ///
    /// # Errors
    /// They are none, of another version, or damaged.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Unreadable> {
        let after = bytes.strip_prefix(TITLE.as_bytes());
        let after = after.ok_or(Unreadable::NoCertificate)?;
        let end = after.iter().take(40).position(|&byte| byte == b'\n');
        let end = end.ok_or(Unreadable::Damaged)?;
        let version = String::from_utf8_lossy(&after[..end]).into_owned();
        if version != VERSION {
            return Err(Unreadable::Version(version));
        }
        let mut plain = Vec::new();
        let compressed = &after[end + 1..];
        let mut decoder = ZlibDecoder::new(compressed).take(LARGEST);
        let read = decoder.read_to_end(&mut plain);
        let decoder = decoder.into_inner();
        if read.is_err() || decoder.total_in() != compressed.len() as u64 {
            return Err(Unreadable::Damaged);
        }
        let mut rest = Rest(&plain);
        let certificate = rest.certificate().filter(|_| rest.0.is_empty());
        certificate.ok_or(Unreadable::Damaged)
    }
}

fn count(out: &mut Vec<u8>, number: usize) {
    out.extend_from_slice(&(number as u64).to_le_bytes());
}

fn numbers(out: &mut Vec<u8>, values: &[f64]) {
    for value in values {
        out.extend_from_slice(&value.to_le_bytes());
    }
}

/// A list: how many, then all first bytes, all second bytes and so on, as those of neighbours are
/// more alike than those of one number.
fn list(out: &mut Vec<u8>, values: &[f64]) {
    count(out, values.len());
    for byte in 0..8 {
        out.extend(values.iter().map(|value| value.to_le_bytes()[byte]));
    }
}

/// What is not read yet; every part is `None` where it is cut off.
struct Rest<'a>(&'a [u8]);

impl<'a> Rest<'a> {
    fn bytes(&mut self, length: usize) -> Option<&'a [u8]> {
        let (bytes, rest) = self.0.split_at_checked(length)?;
        self.0 = rest;
        Some(bytes)
    }

    fn eight(&mut self) -> Option<[u8; 8]> {
        self.bytes(8)?.try_into().ok()
    }

    fn count(&mut self) -> Option<usize> {
        usize::try_from(u64::from_le_bytes(self.eight()?)).ok()
    }

    fn number(&mut self) -> Option<f64> {
        Some(f64::from_le_bytes(self.eight()?))
    }

    fn list(&mut self) -> Option<Vec<f64>> {
        let length = self.count()?;
        let bytes = self.bytes(length.checked_mul(8)?)?;
        let value = |at: usize| f64::from_le_bytes(std::array::from_fn(|k| bytes[k * length + at]));
        Some((0..length).map(value).collect())
    }

    fn assumed(&mut self) -> Option<Vec<Assumption>> {
        let length = self.count()?;
        // One that is not there ends it, whatever the length.
        let assumption = |code: usize| Assumption {
            pair: code / 2,
            zero: [Factor::Force, Factor::Rate][code % 2],
        };
        (0..length).map(|_| self.count().map(assumption)).collect()
    }

    fn certificate(&mut self) -> Option<Certificate> {
        let length = self.count()?;
        let scene = String::from_utf8(self.bytes(length)?.to_vec()).ok()?;
        let (lower, cap) = (self.number()?, self.number()?);
        let opening = self.list()?;
        let longest_way = match self.count()? {
            1 => LongestWay::TwoJoints,
            2 => LongestWay::ThreeJoints,
            _ => return None,
        };
        let slices = self.count()?;
        Some(Certificate {
            scene,
            lower,
            cap,
            opening,
            longest_way,
            slices: (0..slices).map(|_| self.slice()).collect::<Option<_>>()?,
        })
    }

    fn slice(&mut self) -> Option<Slice> {
        Some(Slice {
            from: self.number()?,
            to: self.number()?,
            sigma: self.number()?,
            assumed: self.assumed()?,
            multipliers: self.list()?,
            balance: self.list()?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn certificate() -> Certificate {
        let slice = Slice {
            from: 0.0,
            to: 0.5,
            sigma: 0.25,
            assumed: [(3, Factor::Rate), (0, Factor::Force)]
                .map(|(pair, zero)| Assumption { pair, zero })
                .to_vec(),
            multipliers: vec![1.0, 0.0, -0.0, 1e-300],
            balance: vec![-3.5; 7],
        };
        Certificate {
            scene: "ab".to_owned(),
            lower: 0.25,
            cap: 1e4,
            opening: vec![0.1, 0.2],
            longest_way: LongestWay::ThreeJoints,
            slices: vec![slice.clone(), slice],
        }
    }

    #[test]
    fn what_is_written_is_read_back() {
        let bytes = certificate().to_bytes();
        assert_eq!(Certificate::from_bytes(&bytes), Ok(certificate()));
    }

    #[test]
    fn what_is_cut_off_changed_or_of_another_version_is_refused() {
        let bytes = certificate().to_bytes();
        let title = TITLE.len() + 2;
        for length in 0..bytes.len() {
            let read = Certificate::from_bytes(&bytes[..length]);
            let expected = if length < TITLE.len() {
                Unreadable::NoCertificate
            } else {
                Unreadable::Damaged
            };
            assert_eq!(read, Err(expected), "{length}");
        }
        for at in title..bytes.len() {
            let mut changed = bytes.clone();
            changed[at] ^= 1;
            // A bit of the stream that means nothing may differ, and then nothing else does.
            let read = Certificate::from_bytes(&changed);
            assert!(
                read == Err(Unreadable::Damaged) || read == Ok(certificate()),
                "{at}"
            );
        }
        let longer = [bytes.clone(), vec![0]].concat();
        assert_eq!(Certificate::from_bytes(&longer), Err(Unreadable::Damaged));
        let mut other = bytes;
        for version in ["2", "7"] {
            other[TITLE.len()] = version.as_bytes()[0];
            let refused = Certificate::from_bytes(&other).unwrap_err();
            assert_eq!(refused, Unreadable::Version(version.to_owned()));
            assert!(refused.to_string().ends_with("reads version 3"));
        }
    }
}
