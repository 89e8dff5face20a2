//! Lines over the wall: the push, the crack of a mechanism (paper, Fig. 5) and that of the
//! macro-block model (Fig. 3).

use super::frame::Frame;
use super::palette::{CRACK, FAINT, INK, LARGEST, MACRO_CRACK};
use super::svg::{Anchor, Path, Pixel, Svg, style};
use crate::mechanics::Crack;
use crate::number::short;
use crate::scene::{Point, Push, Scene, Vector};

/// Pixels between two dimension lines above the wall.
const DIMENSION: f64 = 17.0;

/// Pixels that the dimension lines of a crack take above the wall.
pub const DIMENSIONS: f64 = 2.0 * DIMENSION;

/// The toe that a push turns a wall about.
fn toe(scene: &Scene) -> Point {
    let (low, high) = scene.bounds();
    match scene.push() {
        Push::Right => Point::new(high.x, low.y),
        Push::Left => low,
    }
}

/// Into the wall from its toe.
fn inwards(scene: &Scene) -> f64 {
    -scene.push().sign()
}

/// The macro-block of the closed form as corners in order: a strip of width s beside the edge and a
/// triangle of slope tan β on it (Eqs. 2 and 3). `None` where the scene is no coursed wall.
fn macro_block(scene: &Scene, tan_beta: f64) -> Option<[Point; 4]> {
    let wall = scene.coursing()?;
    let (toe, into) = (toe(scene), inwards(scene));
    let top = wall.overlap + wall.height * tan_beta;
    let at = |x: f64, y: f64| toe + Vector::new(into * x, y);
    Some([
        at(0.0, 0.0),
        at(wall.overlap, 0.0),
        at(top, wall.height),
        at(0.0, wall.height),
    ])
}

/// The macro-block turned about its toe over the wall (the paper's Fig. 4b and d).
pub fn turned_macro_block(svg: &mut Svg, frame: &Frame, scene: &Scene, tan_beta: f64) {
    let Some(corners) = macro_block(scene, tan_beta) else {
        return;
    };
    let angle = -scene.push().sign() * TURN;
    let turned = corners.map(|corner| {
        let arm = corner - corners[0];
        frame.at(corner + Vector::new(-arm.y, arm.x) * angle)
    });
    let block = style().class("macro-block").fill(LARGEST);
    let block = block.fill_opacity(0.85).stroke(INK).stroke_width(1.2);
    let words = "macro-block: turns about the toe";
    svg.path(&Path::through(&turned, true), block, words);
}

/// Angle that the macro-block is shown turned by.
pub const TURN: f64 = 0.11;

/// The crack of the macro-block model: dashed, at tan β.
pub fn macro_crack(svg: &mut Svg, frame: &Frame, scene: &Scene, tan_beta: f64) {
    let Some([toe, foot, head, _]) = macro_block(scene, tan_beta) else {
        return;
    };
    let path = Path::through(&[toe, foot, head].map(|p| frame.at(p)), false);
    let line = style().class("macro-crack").line(MACRO_CRACK, 1.5);
    let tan_beta = crate::number::number(tan_beta, 4);
    let words = format!("crack of the macro-block model, tan β = {tan_beta}");
    svg.path(&path, line.dashes("7 4"), &words);
}

/// From the toe to the ends of c and e along the top, and their dimension lines at `above` pixels.
pub fn crack(svg: &mut Svg, frame: &Frame, scene: &Scene, crack: &Crack, above: f64) {
    let (Some(c), Some(e), Some(wall)) = (crack.c, crack.e, scene.coursing()) else {
        return;
    };
    let (toe, into) = (toe(scene), inwards(scene));
    let on_top = |x: f64| toe + Vector::new(into * x, wall.height);
    let lines = Path::through(&[on_top(c), toe, on_top(e)].map(|p| frame.at(p)), false);
    let words = "crack: all relative motion lies between these lines from the toe";
    svg.path(&lines, style().class("crack").line(CRACK, 1.4), words);
    for (row, (name, width)) in [("c", c), ("e", e)].into_iter().enumerate() {
        let y = above - DIMENSION * row as f64;
        let [edge, end] = [on_top(0.0), on_top(width)].map(|p| frame.at(p)[0]);
        let mut path = Path::through(&[[edge, y], [end, y]], false);
        for x in [edge, end] {
            path.add(&[[x, y - 3.5], [x, y + 3.5]], false);
        }
        svg.path(&path, style().class("dimension").line(CRACK, 0.9), "");
        // Beyond the end within the wall, where no line is.
        let anchor = match scene.push() {
            Push::Right => Anchor::End,
            Push::Left => Anchor::Start,
        };
        let words = format!("{name} = {}", short(width, 3));
        let style = style().font_size(11.5).fill(CRACK);
        svg.text([end + 6.0 * into, y + 4.0], anchor, style, &words);
    }
}

/// Pixels beside a scene that its push takes.
pub const PUSH: f64 = 46.0;

/// Which way the weights push, on the screen; along the push where they do not push upwards.
fn direction(scene: &Scene) -> Pixel {
    let first = scene.blocks().first().and_then(|block| block.loads.first());
    let live = first.map_or(Vector::zeros(), |load| load.live);
    if live.y == 0.0 {
        return [scene.push().sign(), 0.0];
    }
    let along = live.normalize();
    [along.x, -along.y]
}

/// The live load: an arrow towards the scene at two thirds of its height, inclined as the weights push.
pub fn push(svg: &mut Svg, frame: &Frame, scene: &Scene) {
    let (low, high) = scene.bounds();
    let sign = scene.push().sign();
    let x = match scene.push() {
        Push::Right => low.x,
        Push::Left => high.x,
    };
    let [x, y] = frame.at(Point::new(x, low.y + 0.62 * (high.y - low.y)));
    let tip = [x - sign * 9.0, y];
    let along = direction(scene);
    // `by` pixels behind the tip, and `aside` to the one side of the shaft.
    let behind = |by: f64, aside: f64| {
        [
            tip[0] - by * along[0] + aside * sign * along[1],
            tip[1] - by * along[1] - aside * sign * along[0],
        ]
    };
    let shaft = Path::through(&[behind(PUSH - 15.0, 0.0), behind(6.0, 0.0)], false);
    svg.path(&shaft, style().line(INK, 1.8), "");
    let head = Path::through(&[tip, behind(9.0, 4.5), behind(9.0, -4.5)], true);
    let fill = style().class("push").fill(INK);
    svg.path(&head, fill, "direction of the live load");
    let style = style().font_size(13.0).italic().fill(FAINT);
    let [x, y] = behind((PUSH - 15.0) / 2.0, 0.0);
    svg.text([x, y - 8.0], Anchor::Middle, style, "λ");
}
