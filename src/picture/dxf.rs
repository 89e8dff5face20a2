//! A scene as a drawing for CAD: blocks, supports, names, mechanism and thrust on layers of their own.
//!
//! DXF of version R12, which every program reads; written here, so that the same scene is the same
//! bytes.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use super::frame::Displacement;
use crate::mechanics::{Mechanism, Thrust};
use crate::scene::{Assembly, Point, Scene};

/// Layers and their colours, by CAD's numbers.
const LAYERS: [(&str, u8); 6] = [
    ("blocks", 7),
    ("support", 8),
    ("names", 9),
    ("mechanism", 1),
    ("thrust", 5),
    ("resultants", 4),
];

/// Part of the scene's height that letters are high, and the largest resultant is long.
const LETTERS: f64 = 0.02;
const LONGEST: f64 = 0.2;

/// The drawing of a scene; the mechanism is magnified as in pictures. Coordinates are the case's own, to
/// the last digit. Bodies that came from a drawing have the handle and the layer that they had there.
pub fn dxf(
    scene: &Scene,
    assembly: &Assembly,
    mechanism: Option<&Mechanism>,
    thrust: Option<&Thrust>,
) -> String {
    let mut drawing = Drawing::new(assembly);
    for (index, block) in scene.blocks().iter().enumerate() {
        let layer = match scene.is_moving_support(index) {
            true => "support",
            false => "blocks",
        };
        let known = assembly.blocks.get(index).map(|block| block.name.as_str());
        drawing.body(known, layer, block.shape.corners());
    }
    for (index, shape) in scene.still_supports() {
        let known = assembly.supports.get(index);
        let known = known.filter(|support| support.shape == shape);
        let name = known.map(|support| support.name.as_str());
        drawing.body(name, "support", shape.corners());
    }
    for (index, block) in scene.blocks().iter().enumerate() {
        let name = match assembly.blocks.get(index) {
            Some(block) if drawing.layers.contains_key(&block.name) => block.name.clone(),
            _ => scene.block_name(index),
        };
        drawing.text(
            "names",
            block.shape.centroid(),
            LETTERS * scene.height(),
            &name,
        );
    }
    if mechanism.is_some() {
        let moved = Displacement::new(scene, mechanism);
        for block in 0..scene.blocks().len() {
            let corners: Vec<Point> = moved.corners(block).collect();
            drawing.polyline("mechanism", &corners, true);
        }
    }
    if let Some(thrust) = thrust {
        for line in &thrust.lines {
            drawing.polyline("thrust", line, false);
        }
        let largest = thrust.courses.iter().map(|of| of.force.norm());
        let largest = largest.fold(0.0, f64::max);
        for of in &thrust.courses {
            if let Some(x) = of.x.filter(|_| largest > 0.0) {
                let at = Point::new(x, of.level);
                let way = of.force * (LONGEST * scene.height() / largest);
                drawing.polyline("resultants", &[at, at + way], false);
            }
        }
    }
    drawing.end()
}

struct Drawing<'a> {
    text: String,
    handle: u64,
    layers: &'a BTreeMap<String, String>,
}

/// The handle that a name of a drawing is.
fn handle(name: &str) -> Option<u64> {
    let handle = u64::from_str_radix(name, 16).ok()?;
    (format!("{handle:X}") == name && (1..1 << 60).contains(&handle)).then_some(handle)
}

impl<'a> Drawing<'a> {
    fn new(assembly: &'a Assembly) -> Self {
        let layers = &assembly.layers;
        // Behind the handles that readers give to tables, and those of the bodies.
        let last = layers
            .keys()
            .filter_map(|name| handle(name))
            .fold(0xFF, u64::max);
        let own: BTreeSet<&str> = layers.values().map(String::as_str).collect();
        // The remark tells a reader of ours which layers are no walls.
        let mut text = String::from("999\ntrilith\n");
        text.push_str("0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n");
        text.push_str("0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n");
        let others = own
            .iter()
            .filter(|name| LAYERS.iter().all(|layer| layer.0 != **name));
        let layers_of_all: Vec<(&str, u8)> = LAYERS
            .into_iter()
            .chain(others.map(|name| (*name, 7)))
            .collect();
        let _ = writeln!(text, "70\n{}", layers_of_all.len());
        for (name, colour) in layers_of_all {
            let _ = writeln!(
                text,
                "0\nLAYER\n2\n{name}\n70\n0\n62\n{colour}\n6\nCONTINUOUS"
            );
        }
        text.push_str("0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");
        Self {
            text,
            handle: last,
            layers,
        }
    }

    fn begin(&mut self, kind: &str, layer: &str) {
        self.handle += 1;
        let _ = writeln!(self.text, "0\n{kind}\n5\n{:X}\n8\n{layer}", self.handle);
    }

    /// An outline with the handle and the layer that it had where it came from, or else on a layer.
    fn body(&mut self, name: Option<&str>, layer: &str, corners: &[Point]) {
        let known = name.and_then(|name| self.layers.get_key_value(name));
        let layer = known.map_or(layer, |(_, known)| known.as_str());
        match known.and_then(|(name, _)| handle(name)) {
            Some(handle) => {
                let _ = writeln!(self.text, "0\nPOLYLINE\n5\n{handle:X}\n8\n{layer}");
                self.vertices(layer, corners, true);
            }
            None => self.polyline(layer, corners, true),
        }
    }

    fn point(&mut self, at: Point) {
        let _ = writeln!(self.text, "10\n{:?}\n20\n{:?}\n30\n0.0", at.x, at.y);
    }

    fn polyline(&mut self, layer: &str, points: &[Point], closed: bool) {
        self.begin("POLYLINE", layer);
        self.vertices(layer, points, closed);
    }

    fn vertices(&mut self, layer: &str, points: &[Point], closed: bool) {
        self.text.push_str("66\n1\n");
        self.point(Point::origin());
        let _ = writeln!(self.text, "70\n{}", u8::from(closed));
        for &point in points {
            let _ = writeln!(self.text, "0\nVERTEX\n8\n{layer}");
            self.point(point);
        }
        let _ = writeln!(self.text, "0\nSEQEND\n8\n{layer}");
    }

    fn text(&mut self, layer: &str, at: Point, height: f64, words: &str) {
        self.begin("TEXT", layer);
        self.point(at);
        // R12 knows no Unicode: other letters as CAD writes them.
        let escaped = |c: char| match c {
            ' '..='~' => c.to_string(),
            c => format!("\\U+{:04X}", u32::from(c)),
        };
        let words: String = words.chars().map(escaped).collect();
        let _ = writeln!(self.text, "40\n{height:?}\n1\n{words}");
    }

    fn end(mut self) -> String {
        self.text.push_str("0\nENDSEC\n0\nEOF\n");
        self.text
    }
}
