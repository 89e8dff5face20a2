//! What is proved of a scene that carries every push.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::certificate::Certificate;

/// What forces that carry every multiplier say of friction without dilatancy.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Standing {
    /// Nothing: the ray needs friction, and a joint that slips need not carry it.
    Associative,
    /// That nothing collapses: the ray needs no friction.
    WithoutFriction,
    /// That nothing collapses, although the ray needs friction: there is no collapse state.
    Certified {
        /// What proves that. It is large, and files of results leave it out.
        #[serde(skip)]
        certificate: Option<Arc<Certificate>>,
    },
}
