//! Speed against accuracy: every method over its ladder of settings, on one plane.

mod reference;

pub use reference::reference;
