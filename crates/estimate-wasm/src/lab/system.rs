//! The class of the lab in which a reader types a system.

use wasm_bindgen::prelude::*;

lab_class! {
    "A linear system that the reader types: what can be known of it, the eigenvalues that a gain gives it, and a simulated run.",
    OwnSystem: labs::OwnSystem, "Partial<OwnParams>", "OwnFrame", "LabState<OwnParams>"
}
