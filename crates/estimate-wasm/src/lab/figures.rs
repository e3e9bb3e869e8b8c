//! The classes of the labs that the first figures of the chapter show.

use wasm_bindgen::prelude::*;

lab_class! {
    "The rail robot of §8.2.6 under an observer whose gain the reader sets, or the filter does.",
    ObserverBench: labs::ObserverBench, "Partial<BenchParams>", "BenchFrame", "LabState<BenchParams>"
}

lab_class! {
    "A loop of the corridor on encoders with a biased wheel, with or without fixes from the mapped corners.",
    OdometryHook: labs::OdometryHook, "Partial<HookParams>", "HookFrame", "LabState<HookParams>"
}

lab_class! {
    "A prediction, the states that explain a reading, and the two ways of stepping onto them.",
    Picture: labs::Picture, "Partial<PictureParams>", "PictureFrame", "LabState<PictureParams>"
}
