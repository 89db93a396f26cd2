//! The printed figures of Wong, Cheng and Lii, "Reduced BVHs for GPU Ray Tracing" (CGIV 2012): milliseconds on a GTX 480
//! unless stated otherwise.

/// The printed figures of one scene.
pub struct Printed {
    pub triangles: usize,
    /// Table I: triangles of C+, C−, L+, L−.
    pub sizes: [usize; 4],
    /// Table III: construction over all triangles; division; construction over C+, C−, L+, L− where printed.
    pub all: f64,
    pub division: f64,
    pub sets: [Option<f64>; 4],
    /// Table IV, in µs.
    pub steps: &'static [Steps],
    /// Tables II and VI: primary rays with the whole tree and with a reduced one.
    pub primary: [f64; 2],
    /// Primary and shadow rays with the whole tree, then with reduced ones, for 1×1, 4×4 and 16×16 samples per pixel.
    pub pictures: [[f64; 3]; 2],
}

/// A row of Table IV, in µs.
pub struct Steps {
    /// The sets.
    pub sets: &'static str,
    pub orientation: f64,
    pub reduction: f64,
    pub prefix_sum: f64,
    pub compaction: f64,
    pub total: f64,
}

/// A row of Table V: the armadillo under lights that are near each other.
pub struct Lights {
    pub triangles: usize,
    /// For the camera's set, and for the lights'.
    pub division: [f64; 2],
    pub construction: [f64; 2],
    pub primary: f64,
    pub shadow: f64,
    pub total: f64,
}

const fn steps(
    sets: &'static str,
    [orientation, reduction, prefix_sum, compaction, total]: [f64; 5],
) -> Steps {
    Steps {
        sets,
        orientation,
        reduction,
        prefix_sum,
        compaction,
        total,
    }
}

pub const DOLL: Printed = Printed {
    triangles: 71_450,
    sizes: [35_556, 35_894, 36_340, 35_110],
    all: 18.7,
    division: 0.2,
    sets: [Some(8.9), Some(9.0), Some(9.1), None],
    steps: &[steps("C+, L+", [40.16, 6.91, 23.01, 129.01, 209.09])],
    primary: [28.7, 14.2],
    pictures: [[36.1, 172.6, 1925.3], [29.0, 120.0, 1582.2]],
};

pub const TOASTERS: Printed = Printed {
    triangles: 105_774,
    sizes: [81_794, 23_980, 81_848, 23_926],
    all: 28.7,
    division: 0.3,
    sets: [Some(17.4), Some(5.2), Some(17.4), Some(5.1)],
    steps: &[
        steps("C+, L+", [72.26, 7.94, 23.93, 335.10, 429.23]),
        steps("C-, L-", [65.63, 8.35, 22.40, 93.60, 189.98]),
    ],
    primary: [61.9, 38.1],
    pictures: [[77.6, 420.2, 4407.1], [48.3, 227.2, 3434.5]],
};

pub const TWENTY_FOUR_CELL: Printed = Printed {
    triangles: 122_882,
    sizes: [60_828, 62_054, 60_860, 62_022],
    all: 27.5,
    division: 0.4,
    sets: [Some(13.2), Some(13.5), Some(13.1), None],
    steps: &[steps("C+, L+", [67.79, 8.32, 21.76, 253.38, 351.25])],
    primary: [67.8, 34.1],
    pictures: [[100.9, 629.3, 6038.6], [68.3, 384.5, 4442.1]],
};

pub const ARMADILLO: Printed = Printed {
    triangles: 331_906,
    sizes: [166_115, 165_791, 166_483, 165_423],
    all: 74.6,
    division: 0.8,
    sets: [Some(38.3), Some(38.4), Some(40.1), None],
    steps: &[steps("C+, L+", [128.83, 14.34, 70.46, 548.93, 762.56])],
    primary: [107.3, 56.4],
    pictures: [[138.5, 611.4, 4978.1], [119.9, 405.2, 3707.9]],
};

/// Table V for this many lights: the whole tree, and a set for the camera with one for all lights.
pub fn lights(light_count: usize) -> Option<[Lights; 2]> {
    let default = |shadow, total| Lights {
        triangles: 331_906,
        division: [0.0; 2],
        construction: [74.6, 0.0],
        primary: 32.8,
        shadow,
        total,
    };
    let grouped = |triangles, construction, shadow, total| Lights {
        triangles,
        division: [0.8, 0.5],
        construction: [38.3, construction],
        primary: 17.5,
        shadow,
        total,
    };
    match light_count {
        4 => Some([default(154.3, 261.7), grouped(230_347, 52.9, 142.7, 252.7)]),
        9 => Some([default(368.3, 475.7), grouped(230_243, 52.6, 310.1, 419.8)]),
        _ => None,
    }
}

/// The share of the armadillo's triangles that the set of all lights together keeps.
pub fn group_share(light_count: usize) -> f64 {
    let [default, grouped] = match lights(light_count) {
        Some(rows) => rows.map(|row| row.triangles as f64),
        None => return 0.69,
    };
    grouped / default
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The printed figures agree with each other to their last digit, except for two totals of Table IV.
    #[test]
    fn sums_are_those_of_their_parts() {
        let mut differences = Vec::new();
        for printed in [DOLL, TOASTERS, TWENTY_FOUR_CELL, ARMADILLO] {
            let [front, back, lit, unlit] = printed.sizes;
            let sums = (front + back, lit + unlit);
            assert_eq!(sums, (printed.triangles, printed.triangles));
            for row in printed.steps {
                let sum = row.orientation + row.reduction + row.prefix_sum + row.compaction;
                differences.push((row.total - sum).round());
                assert!(
                    (row.total - sum).fract().abs() < 0.02
                        || (row.total - sum).fract().abs() > 0.98
                );
            }
        }
        assert_eq!(differences, [10.0, -10.0, 0.0, 0.0, 0.0]);
        for row in [4, 9].into_iter().filter_map(lights).flatten() {
            let builds: f64 = row.division.iter().chain(&row.construction).sum();
            let sum = builds + row.primary + row.shadow;
            assert!((sum - row.total).abs() < 0.15, "{sum} {}", row.total);
        }
    }
}
