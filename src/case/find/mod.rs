//! Finding cases: the ones inside the binary, files, and folders of files.

mod argument;
mod embedded;
mod folder;
mod library;
mod unread;

pub(crate) use argument::locate;
pub use argument::{collect, find};
pub use embedded::embedded;
pub use library::{library, paper};
pub(crate) use unread::UnreadCase;
