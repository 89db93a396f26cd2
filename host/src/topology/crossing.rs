//! The winding number beside a triangle, by counting crossings along an axis out to infinity.

/// A line of sight from a point inside a triangle, along an axis. Only the point's projection along the axis is exact; its
/// distance from the triangle's plane is bounded.
#[derive(Clone, Copy, Debug)]
pub(super) struct Probe {
    /// The point.
    pub(super) point: [f64; 3],
    /// The axis of the line.
    pub(super) axis: usize,
    /// Whether it runs toward larger coordinates.
    pub(super) is_upward: bool,
    slack: f64,
}

impl Probe {
    /// A line of sight that leaves a triangle through its front (`side` 1) or back (`side` −1). `weights` are the point's
    /// barycentric coordinates, whose sum is 1. `None` if the point is not certainly inside the triangle's projection.
    pub(super) fn new(
        corners: [[f32; 3]; 3],
        weights: [f64; 3],
        axis: usize,
        side: i32,
    ) -> Option<Self> {
        let point = [0, 1, 2].map(|axis| {
            let weighted = (0..3).map(|i| weights[i] * f64::from(corners[i][axis]));
            weighted.sum::<f64>()
        });
        let shadow = Shadow::new(corners, point, axis);
        let Inside::Yes(turn) = shadow.inside() else {
            return None;
        };
        let (height, error) = shadow.height_times_area(corners, point[axis]);
        let least_area = shadow.area - shadow.area_error;
        Some(Self {
            point,
            axis,
            is_upward: turn == side,
            slack: (height.abs() + error) / least_area,
        })
    }

    /// The decrease of the winding number where the line crosses another triangle, which must not touch the first one's
    /// inside: 0 if it misses. `None` if uncertain.
    pub(super) fn fall(&self, corners: [[f32; 3]; 3]) -> Option<i32> {
        let shadow = Shadow::new(corners, self.point, self.axis);
        let turn = match shadow.inside() {
            Inside::Yes(turn) => turn,
            Inside::No => return Some(0),
            Inside::Unknown => return None,
        };
        let (height, error) = shadow.height_times_area(corners, self.point[self.axis]);
        let error = error + self.slack * (shadow.area + shadow.area_error);
        if height.abs() <= error {
            return None;
        }
        let is_above = height > 0.0;
        let is_seen = is_above == self.is_upward;
        // Crossing a counter-clockwise triangle upward leads out of its front.
        let out = if self.is_upward { turn } else { -turn };
        Some(if is_seen { out } else { 0 })
    }
}

/// A triangle projected along an axis, relative to a point: the areas that the point spans with each side.
struct Shadow {
    areas: [f64; 3],
    errors: [f64; 3],
    axis: usize,
    /// Twice its area, positive.
    area: f64,
    area_error: f64,
}

/// Whether a point lies inside a projection, and its orientation: 1 for counter-clockwise.
enum Inside {
    Yes(i32),
    No,
    Unknown,
}

impl Shadow {
    fn new(corners: [[f32; 3]; 3], point: [f64; 3], axis: usize) -> Self {
        let (x, y) = ((axis + 1) % 3, (axis + 2) % 3);
        let flat = corners.map(|p| [f64::from(p[x]) - point[x], f64::from(p[y]) - point[y]]);
        let mut areas = [0.0; 3];
        let mut errors = [0.0; 3];
        for i in 0..3 {
            let (b, c) = (flat[(i + 1) % 3], flat[(i + 2) % 3]);
            let (positive, negative) = (b[0] * c[1], b[1] * c[0]);
            areas[i] = positive - negative;
            // Shewchuk 1997, section 4.2: below 4 half epsilons, differences included.
            errors[i] = 4.0 * f64::EPSILON * (positive.abs() + negative.abs());
        }
        let sum: f64 = areas.iter().sum();
        Self {
            areas,
            errors,
            axis,
            area: sum.abs(),
            area_error: errors.iter().sum::<f64>() + 4.0 * f64::EPSILON * sum.abs(),
        }
    }

    fn inside(&self) -> Inside {
        let sides = || self.areas.iter().zip(&self.errors);
        let positive = sides().filter(|(area, error)| *area > error).count();
        let negative = sides().filter(|(area, error)| -*area > **error).count();
        match (positive, negative) {
            (3, 0) => Inside::Yes(1),
            (0, 3) => Inside::Yes(-1),
            (1.., 1..) => Inside::No,
            _ => Inside::Unknown,
        }
    }

    /// The triangle's height above `height` at the point, times `area`, and a bound on the error. The point must be inside.
    fn height_times_area(&self, corners: [[f32; 3]; 3], height: f64) -> (f64, f64) {
        let (mut sum, mut error) = (0.0, 0.0);
        for (i, corner) in corners.iter().enumerate() {
            let rise = f64::from(corner[self.axis]) - height;
            sum += self.areas[i].abs() * rise;
            error += (self.errors[i] + 8.0 * f64::EPSILON * self.areas[i].abs()) * rise.abs();
        }
        (sum, error)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FLOOR: [[f32; 3]; 3] = [[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 3.0, 1.0]];
    const THIRDS: [f64; 3] = [0.25, 0.25, 0.5];

    fn lifted(by: f32) -> [[f32; 3]; 3] {
        FLOOR.map(|[x, y, z]| [x, y, z + by])
    }

    #[test]
    fn what_lies_ahead_counts_by_its_turn() {
        let up = Probe::new(FLOOR, THIRDS, 2, 1).expect("the point is inside");
        let down = Probe::new(FLOOR, THIRDS, 2, -1).expect("the point is inside");
        assert!(up.is_upward && !down.is_upward);
        let [a, b, c] = lifted(2.0);
        assert_eq!(up.fall([a, b, c]), Some(1));
        assert_eq!(up.fall([b, a, c]), Some(-1));
        assert_eq!(down.fall([a, b, c]), Some(0));
        assert_eq!(down.fall(lifted(-2.0)), Some(-1));
        assert_eq!(up.fall(lifted(-2.0)), Some(0));
        assert_eq!(
            up.fall(lifted(2.0).map(|[x, y, z]| [x + 4.0, y, z])),
            Some(0)
        );
        // One step of the float grid suffices; height 0 does not.
        assert_eq!(up.fall(lifted(1.2e-7)), Some(1));
        assert_eq!(up.fall(FLOOR), None);
        // A corner directly above the point.
        assert_eq!(
            up.fall([[1.0, 1.5, 5.0], [9.0, 0.0, 5.0], [9.0, 8.0, 5.0]]),
            None
        );
    }

    #[test]
    fn no_probe_from_a_triangle_seen_from_its_edge() {
        let wall = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 0.0, 2.0]];
        assert!(Probe::new(wall, THIRDS, 2, 1).is_none());
        assert!(Probe::new(wall, THIRDS, 1, 1).is_some());
    }
}
