//! The plane that a drawing lies in: that of x and y, or a vertical one of space.

use nalgebra::Vector2;

use super::paths::{Path, complain};
use super::placing::Spatial;
use crate::case::complaint::Complaint;
use crate::number::ends_of;
use crate::scene::Point;

/// Paths that are this flat, as a part of the drawing's size, lie in a plane.
const FLAT: f64 = 1e-6;

/// Lays paths in the plane of the wall. Where all lie level, that is the plane of x and y, at whatever
/// heights; else all have to lie in one vertical plane.
pub(super) fn flatten(paths: &mut [Path], remarks: &mut Vec<String>) -> Result<(), Complaint> {
    let corners = || paths.iter().flat_map(|path| &path.in_space);
    let Some(first) = corners().next().copied() else {
        return Ok(());
    };
    let size = corners().map(|p| (p - first).norm()).fold(0.0, f64::max);
    let is_level = |path: &Path| {
        let [low, high] = ends_of(path.in_space.iter().map(|p| p.z));
        high - low <= FLAT * size
    };
    if paths.iter().all(is_level) {
        lay(paths, |p| Point::new(p.x, p.y));
        return Ok(());
    }
    let beside = corners().map(|p| (p - first).xy());
    let farthest = beside.max_by(|a, b| a.norm().total_cmp(&b.norm()));
    let along = farthest.expect("there are corners").normalize();
    let axis = |axis: Vector2<f64>| along.perp(&axis).abs() <= FLAT;
    // Along an axis, coordinates stay as they are.
    let (right, along, origin) = match along {
        _ if axis(Vector2::x()) => ("x", Vector2::x(), Vector2::zeros()),
        _ if axis(Vector2::y()) => ("y", Vector2::y(), Vector2::zeros()),
        _ => {
            let forward = if along.x < 0.0 { -along } else { along };
            ("a direction between x and y", forward, first.xy())
        }
    };
    let is_off = |path: &&Path| {
        let mut off = path
            .in_space
            .iter()
            .map(|p| (p - first).xy().perp(&along).abs());
        off.any(|off| off > FLAT * size)
    };
    let level = paths.iter().filter(|path| is_level(path)).count();
    let is_odd = |path: &&Path| !is_level(path) || 2 * level < paths.len();
    if paths.iter().any(|path| is_off(&path)) {
        let path = paths.iter().find(is_odd).expect("one is not level");
        let title = "a drawing that lies neither in the plane of x and y nor in one vertical plane";
        return Err(complain(path, title).help("draw the elevation in the plane of x and y"));
    }
    remarks.push(format!(
        "the drawing lies in a vertical plane of space: {right} is to the right, and z is up"
    ));
    lay(paths, |p| Point::new((p.xy() - origin).dot(&along), p.z));
    Ok(())
}

fn lay(paths: &mut [Path], to: impl Fn(Spatial) -> Point) {
    for path in paths {
        let in_space = std::mem::take(&mut path.in_space);
        path.points = in_space.into_iter().map(&to).collect();
    }
}
