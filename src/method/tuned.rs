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

            /// Its numbers with one of them times a factor: each once, with its name.
            #[cfg(test)]
            pub fn each_times(&self, by: f64) -> Vec<(&'static str, Self)> {
                let mut changed = Vec::new();
                $(for $field in $crate::method::tuned::Scaled::scaled(&self.$field, by) {
                    changed.push((stringify!($field), Self { $field, ..*self }));
                })+
                changed
            }
        }
    };
}

/// What a test can halve and double.
#[cfg(test)]
pub(super) trait Scaled: Sized {
    /// The same times a factor; of several numbers, each of them once.
    fn scaled(&self, by: f64) -> Vec<Self>;
}

#[cfg(test)]
impl Scaled for f64 {
    fn scaled(&self, by: f64) -> Vec<Self> {
        vec![self * by]
    }
}

#[cfg(test)]
impl Scaled for usize {
    fn scaled(&self, by: f64) -> Vec<Self> {
        vec![((*self as f64 * by) as usize).max(1)]
    }
}

#[cfg(test)]
impl Scaled for u32 {
    fn scaled(&self, by: f64) -> Vec<Self> {
        vec![((f64::from(*self) * by) as u32).max(1)]
    }
}

#[cfg(test)]
impl<const N: usize> Scaled for [f64; N] {
    fn scaled(&self, by: f64) -> Vec<Self> {
        let scaled = |place: usize| {
            let mut all = *self;
            all[place] *= by;
            all
        };
        (0..N).map(scaled).collect()
    }
}
