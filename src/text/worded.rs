//! Enums whose variants are words.

/// Makes an enum from variants with their words. `ALL` has them in this order, `name` is the word that
/// files, tables and the command line use.
macro_rules! worded {
    ($(
        $(#[$about:meta])*
        $Name:ident {$( $(#[$meaning:meta])* $Variant:ident = $word:literal, )+}
    )+) => {$(
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $Name {$( $(#[$meaning])* $Variant, )+}

        impl $Name {
            /// Every one.
            pub const ALL: [Self; [$($word),+].len()] = [$(Self::$Variant),+];

            /// The word for it.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$Variant => $word,)+
                }
            }
        }
    )+};
}

pub(crate) use worded;
