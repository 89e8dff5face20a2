//! The macro behind the table of settings: from one entry a setting follow its field, its default, its
//! name, its place in help and listings, and how a text sets it.

/// Makes [`Settings`](super::Settings), one struct a group, and the list of all settings from
/// entries `field: type = default, what is allowed, unit;`. The comment above an entry is its
/// meaning in the help and in the documentation.
macro_rules! settings {
    ($(
        $(#[doc = $about:literal])+
        $group:ident: $Group:ident {$(
            $(#[doc = $meaning:literal])+
            $field:ident: $Type:ty = $default:expr, $allowed:expr, $unit:literal;
        )+}
    )+) => {
        $(
            $(#[doc = $about])+
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct $Group {$(
                $(#[doc = $meaning])+
                ///
                #[doc = concat!(" By default `", stringify!($default), "`; allowed: `",
                                stringify!($allowed), "` ", $unit, ".")]
                pub $field: $Type,
            )+}

            impl Default for $Group {
                fn default() -> Self {
                    Self { $($field: $default),+ }
                }
            }
        )+

        /// What a user may change about the methods; the defaults are what tables show.
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct Settings {$(
            $(#[doc = $about])+
            pub $group: $Group,
        )+}

        /// Every setting, in the order of the table.
        static ALL: LazyLock<Vec<Setting>> = LazyLock::new(|| vec![$($(
            Setting {
                name: stringify!($field).replace('_', "-").leak(),
                meaning: concat!($($meaning),+).trim().trim_end_matches('.'),
                unit: $unit,
                allowed: $allowed,
                written: |settings| settings.$group.$field.written(),
                read: |settings, text| {
                    SettingValue::read(text).map(|value| settings.$group.$field = value)
                },
            },
        )+)+]);
    };
}
