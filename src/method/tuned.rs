//! Tables of tuned numbers, each with its meaning, and how tests halve and double them.

/// Makes a table from entries `field: type = value;`, each below its meaning.
macro_rules! tuned {
    ($(#[doc = $what:literal])+ $Table:ident: $(
        $(#[doc = $meaning:literal])+
        $field:ident: $Type:ty = $value:expr;
    )+) => {
        $(#[doc = $what])+
        #[derive(Clone, Copy, Debug)]
        pub struct $Table {$(
            $(#[doc = $meaning])+
            pub $field: $Type,
        )+}

        impl $Table {
            /// The numbers that answers are found with.
            pub const TUNED: Self = Self { $($field: $value),+ };

            /// The name of every number, and what multiplies it.
            #[cfg(test)]
            pub const EACH: &'static [(&'static str, fn(&mut Self, f64))] = &[$((
                stringify!($field),
                |table, by| $crate::method::tuned::Scaled::scale(&mut table.$field, by),
            )),+];
        }
    };
}

/// What a test can halve and double.
#[cfg(test)]
pub(super) trait Scaled {
    fn scale(&mut self, by: f64);
}

#[cfg(test)]
impl Scaled for f64 {
    fn scale(&mut self, by: f64) {
        *self *= by;
    }
}

#[cfg(test)]
impl Scaled for usize {
    fn scale(&mut self, by: f64) {
        *self = ((*self as f64 * by) as usize).max(1);
    }
}

#[cfg(test)]
impl Scaled for u32 {
    fn scale(&mut self, by: f64) {
        *self = ((f64::from(*self) * by) as u32).max(1);
    }
}

#[cfg(test)]
impl<const N: usize> Scaled for [f64; N] {
    fn scale(&mut self, by: f64) {
        self.iter_mut().for_each(|number| *number *= by);
    }
}
