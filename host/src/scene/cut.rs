//! A polygon as triangles, also where it is concave or has a keyhole. Ears are clipped by `earcut`.

use earcut::Earcut;
use glam::DVec3;
use std::collections::HashSet;

/// What triangles of a fan may overlap, as a share of the polygon's area: less than rounding of the corners moves.
const OVERLAP: f64 = 1e-6;

/// Corners of a polygon whose ears are clipped, at most: that takes quadratic time where it crosses itself.
pub(super) const MOST_CORNERS: usize = 1 << 15;

/// Cuts polygons, with buffers that are kept from one to the next.
#[derive(Default)]
pub(super) struct Cutter {
    corners: Vec<DVec3>,
    ears: Ears,
    /// Concave polygons with more than [`MOST_CORNERS`], which became fans.
    pub large_count: usize,
}

struct Ears {
    earcut: Earcut<f64>,
    /// Three corners of each triangle.
    triangles: Vec<u32>,
}

impl Default for Ears {
    fn default() -> Self {
        Self {
            earcut: Earcut::new(),
            triangles: Vec::new(),
        }
    }
}

impl Cutter {
    /// The triangles of a polygon with these corners, as positions in its list: two fewer than corners, each with the polygon's
    /// orientation. They are the fan around the first corner where that is right, so for all convex polygons, and where a
    /// polygon has no area or too many corners. A polygon that is not flat is cut as it looks along its normal, by Newell.
    pub fn cut(
        &mut self,
        corners: impl ExactSizeIterator<Item = DVec3>,
        mut triangle: impl FnMut([u32; 3]),
    ) {
        let count = corners.len() as u32;
        self.corners.clear();
        self.corners.extend(corners);
        self.ears.triangles.clear();
        match self.normal_if_concave() {
            Some(_) if self.corners.len() > MOST_CORNERS => self.large_count += 1,
            Some(normal) => self.ears.clip(&self.corners, normal),
            None => {}
        }
        match self.ears.triangles.as_chunks::<3>() {
            ([], _) => (2..count).for_each(|i| triangle([0, i - 1, i])),
            (triangles, _) => triangles.iter().copied().for_each(triangle),
        }
    }

    /// The polygon's normal, if it has one and the fan is wrong.
    fn normal_if_concave(&self) -> Option<DVec3> {
        let &[first, ref rest @ ..] = &self.corners[..] else {
            return None;
        };
        // Twice the areas of the fan's triangles, with their normals.
        let areas = || {
            let edges = rest.windows(2);
            edges.map(|edge| (edge[0] - first).cross(edge[1] - first))
        };
        let normal: DVec3 = areas().sum();
        let square = normal.length_squared();
        if !(square > 0.0 && square.is_finite()) {
            return None;
        }
        // A fan is right if no triangle looks to the other side, and all corners lie on one side of the first edge, so that it does not
        // go around more than once.
        let least = -OVERLAP * square;
        let is_right = |area: DVec3| area.dot(normal) >= least;
        let edge = rest.iter().map(|&corner| corner - first);
        let edge = edge.into_iter().find(|edge| *edge != DVec3::ZERO)?;
        let mut sides = rest.iter().map(|&corner| edge.cross(corner - first));
        let is_fan = areas().all(is_right) && (rest.len() < 4 || sides.all(is_right));
        (!is_fan).then(|| normal.normalize())
    }
}

impl Ears {
    /// Cuts a polygon as it looks along this normal.
    fn clip(&mut self, corners: &[DVec3], normal: DVec3) {
        let (u, v) = normal.any_orthonormal_pair();
        let flat = corners.iter().map(|corner| {
            let d = corner - corners[0];
            [u.dot(d), v.dot(d)]
        });
        self.earcut.earcut(flat, &[], &mut self.triangles);
        let (triangles, _) = self.triangles.as_chunks_mut::<3>();
        for triangle in triangles.iter_mut() {
            let [a, b, c] = triangle.map(|i| corners[i as usize]);
            if (b - a).cross(c - a).dot(normal) < 0.0 {
                triangle.swap(1, 2);
            }
        }
        if self.triangles.len() / 3 < corners.len() - 2 {
            self.restore_corners(corners.len() as u32);
        }
    }

    /// Adds triangles without area for corners that lie on a line between two others and were left out: a neighbour has them.
    fn restore_corners(&mut self, count: u32) {
        let (triangles, _) = self.triangles.as_chunks::<3>();
        let edges: HashSet<[u32; 2]> = triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .collect();
        let mut added = Vec::new();
        for &[a, b] in &edges {
            let skipped = (b + count - a) % count;
            if skipped > 1 && !edges.contains(&[b, a]) {
                let corner = |i| (a + i) % count;
                added.extend((2..=skipped).map(|i| [a, corner(i - 1), corner(i)]));
            }
        }
        // In an order that does not depend on hashes.
        added.sort_unstable();
        let room = (count as usize - 2).saturating_sub(self.triangles.len() / 3);
        added.truncate(room);
        self.triangles.extend(added.into_flattened());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(corners: &[[f64; 3]]) -> (Vec<[u32; 3]>, usize) {
        let mut cutter = Cutter::default();
        let mut triangles = Vec::new();
        let corners = corners.iter().map(|&corner| DVec3::from(corner));
        cutter.cut(corners, |triangle| triangles.push(triangle));
        (triangles, cutter.large_count)
    }

    fn fan(count: usize) -> Vec<[u32; 3]> {
        (2..count as u32).map(|i| [0, i - 1, i]).collect()
    }

    #[test]
    fn convex_polygons_and_those_without_area_are_fans() {
        let circle = |i: i32| {
            let (sin, cos) = f64::from(i).sin_cos();
            [cos, sin, 0.1 * cos]
        };
        // One radian a corner, so that the last is short of one turn.
        let circle: Vec<[f64; 3]> = (0..7).map(circle).collect();
        let line = [0.0, 3.0, 1.0, 2.0, 5.0].map(|x| [x, x, x]);
        let nowhere = [[f64::NAN; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.2; 3]];
        let far = [[1e300, 0.0, 0.0], [0.0, 1e300, 0.0], [0.0; 3], [1e299; 3]];
        let once = [[1.0; 3]; 6];
        // A corner within an edge.
        let square = [
            [0.0; 3],
            [1.0, 0.0, 0.0],
            [2.0, 0.0, 0.0],
            [2.0, 2.0, 0.0],
            [0.0, 2.0, 0.0],
        ];
        for corners in [&circle[..], &line, &nowhere, &far, &once, &square] {
            assert_eq!(cut(corners), (fan(corners.len()), 0), "{corners:?}");
        }
    }

    #[test]
    fn a_corner_on_an_edge_stays_a_corner() {
        // An L with a corner in the middle of its longest edge: a neighbour has that corner, too.
        let corners = [
            [3.0, 0.0, 0.0],
            [3.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
            [1.0, 3.0, 0.0],
            [0.0, 3.0, 0.0],
            [0.0, 1.5, 0.0],
            [0.0; 3],
        ];
        let (triangles, _) = cut(&corners);
        assert_eq!(triangles.len(), 5);
        let edges = triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let edges: Vec<[u32; 2]> = edges.collect();
        for i in 0..7 {
            let edge = [i, (i + 1) % 7];
            assert_eq!(edges.iter().filter(|e| **e == edge).count(), 1, "{edge:?}");
        }
    }

    #[test]
    fn concave_polygons_with_too_many_corners_are_fans() {
        let tooth = |i: usize| [i as f64, if i.is_multiple_of(2) { 1.0 } else { 2.0 }, 0.0];
        let comb = |count: usize| {
            let mut corners: Vec<[f64; 3]> = (2..count).map(tooth).collect();
            corners.extend([[count as f64, -1.0, 0.0], [0.0, -1.0, 0.0]]);
            corners
        };
        assert_eq!(cut(&comb(MOST_CORNERS)).1, 0);
        assert_eq!(cut(&comb(MOST_CORNERS + 1)), (fan(MOST_CORNERS + 1), 1));
    }
}
