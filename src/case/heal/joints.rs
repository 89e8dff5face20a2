//! The joints that gaps are closed to: lines in their middle, and the points where they meet.

use super::line::Line;
use super::measured::{Measured, measured, usual};
use super::nodes::{Meeting, Nodes, nodes};
use super::parts::{Part, lines, parts_of};
use super::void::{End, Void};
use crate::scene::Point;

/// A joint from end to end.
pub(super) struct Joint {
    /// The ends; `None` where no other joint begins.
    pub ends: [Option<Point>; 2],
    /// A line for each straight part, and the bends between them.
    pub lines: Vec<Line>,
    pub bends: Vec<Point>,
}

/// Everything that the void settles about its joints.
struct Settled {
    parts: Vec<Part>,
    lines: Vec<Line>,
    /// The first part of each gap.
    first: Vec<usize>,
    nodes: Nodes,
}

/// Gaps are turned at most so often, as each turns those beside it.
const TURNS: usize = 8;

/// The joints of all gaps, and where four bodies meet nearly in one point. Where lines say that of four
/// bodies the other two touch, the gap is turned to be theirs.
pub(super) fn joints(void: &mut Void) -> (Vec<Joint>, Vec<Meeting>) {
    for _ in 0..TURNS {
        let turned = settled(void).nodes.turned;
        if turned.is_empty() {
            break;
        }
        turned.into_iter().for_each(|gap| void.turn(gap));
    }
    let settled = settled(void);
    let joints = (0..void.gaps.len()).map(|gap| joint(void, &settled, gap));
    (joints.collect(), settled.nodes.meetings)
}

fn settled(void: &Void) -> Settled {
    let measured: Vec<Measured> = void.gaps.iter().map(|gap| measured(void, gap)).collect();
    let usual = usual(&measured);
    let (mut parts, mut first) = (Vec::new(), vec![0]);
    for (index, of) in measured.iter().enumerate() {
        parts.extend(parts_of(void, index, of, of.within(usual)));
        first.push(parts.len());
    }
    let lines = lines(&parts);
    let nodes = nodes(void, &measured, usual, &lines, &first);
    Settled {
        parts,
        lines,
        first,
        nodes,
    }
}

fn joint(void: &Void, settled: &Settled, gap: usize) -> Joint {
    let (own, all) = (settled.first[gap]..settled.first[gap + 1], &settled.lines);
    let bends = own.clone().skip(1).map(|part| {
        let corner = settled.parts[part].points[0];
        let meeting = all[part - 1].meet(&all[part], corner);
        meeting.unwrap_or(corner)
    });
    let bends: Vec<Point> = bends.collect();
    let ends = void.gaps[gap].ends.map(|end| match end {
        End::Junction(face) => Some(settled.nodes.points[&face]),
        End::Open => None,
    });
    let mut lines = all[own].to_vec();
    // An end line goes through the point at its other end, as both bodies' outlines do.
    let last = lines.len() - 1;
    for (line, through, end) in [
        (0, bends.first().copied().or(ends[1]), ends[0]),
        (last, bends.last().copied().or(ends[0]), ends[1]),
    ] {
        if let (Some(point), None) = (through, end) {
            lines[line].point = point;
        }
    }
    Joint { ends, lines, bends }
}
