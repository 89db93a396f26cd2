//! The printed figures of the paper on compressed hierarchies: milliseconds on a GTX 970, pictures of 1280×720 pixels.

/// The printed figures of one scene.
#[derive(Clone, Copy, Debug)]
pub struct Printed {
    /// The number as printed.
    pub triangles: &'static str,
    /// Additional box tests and triangle tests with compressed nodes, as shares.
    pub more_tests: [f64; 2],
    /// Additional bytes read with compressed nodes, and with compressed nodes and triangles, as shares.
    pub more_read: [f64; 2],
    pub creation: f64,
    /// Compression of nodes, and of triangles.
    pub compression: [f64; 2],
    /// The plain tree, compressed nodes, and compressed nodes and triangles.
    pub rendering: [f64; 3],
}

pub const SHINY: Printed = Printed {
    triangles: "152",
    more_tests: [0.09, 0.111],
    more_read: [-0.145, 0.0],
    creation: 2.17,
    compression: [0.01, 0.01],
    rendering: [48.93, 45.68, 43.68],
};

pub const BUNNY: Printed = Printed {
    triangles: "70 k",
    more_tests: [0.071, 0.074],
    more_read: [-0.14, -0.22],
    creation: 7.82,
    compression: [0.24, 0.35],
    rendering: [80.74, 64.15, 46.83],
};

pub const ASIAN_DRAGON: Printed = Printed {
    triangles: "7.2 M",
    more_tests: [0.1238, 0.1075],
    more_read: [-0.119, -0.203],
    creation: 424.64,
    compression: [16.33, 24.43],
    rendering: [246.36, 194.44, 160.95],
};

impl Printed {
    /// A whole frame: the plain tree, compressed nodes, and compressed nodes and triangles.
    pub fn frames(&self) -> [f64; 3] {
        let [nodes, triangles] = self.compression;
        let compression = [0.0, nodes, nodes + triangles];
        [0, 1, 2].map(|i| self.creation + compression[i] + self.rendering[i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The headlines of the paper's text agree with its tables, with two exceptions. The text gives 41 % less rendering for
    /// the bunny, and the table 42 %. The text gives no figure for a frame of the shiny scene.
    #[test]
    fn headlines_are_those_of_the_tables() {
        let less = |after: f64, before: f64| (1000.0 * (1.0 - after / before)).round() / 10.0;
        let rendering = |printed: Printed| less(printed.rendering[2], printed.rendering[0]);
        assert_eq!(
            [SHINY, BUNNY, ASIAN_DRAGON].map(rendering),
            [10.7, 42.0, 34.7]
        );
        let frame = |printed: Printed| less(printed.frames()[2], printed.frames()[0]);
        assert_eq!([BUNNY, ASIAN_DRAGON].map(frame), [37.6, 6.7]);
    }
}
