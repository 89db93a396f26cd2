//! The times at which a frame samples the scene.

/// How long a frame's shutter is open, and how many times it samples. By default it closes at once: the frame shows the
/// scene at the frame's beginning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shutter {
    /// The share of the time to the next frame, 0 to 1, from the frame's beginning.
    pub share: f64,
    /// Samples in time; 0 counts as 1. The frame's picture is the [mean](crate::PictureMean) of theirs.
    pub time_count: u32,
}

impl Default for Shutter {
    fn default() -> Self {
        Self {
            share: 0.0,
            time_count: 1,
        }
    }
}

impl Shutter {
    /// The sample times of a frame, in frames: the middles of equal parts of the open time.
    ///
    /// ```
    /// use slimbvh::animate::Shutter;
    /// let shutter = Shutter { share: 0.5, time_count: 2 };
    /// let times: Vec<f64> = shutter.times(7).collect();
    /// assert_eq!(times, [7.125, 7.375]);
    /// ```
    pub fn times(&self, frame: u32) -> impl Iterator<Item = f64> + use<> {
        let (share, count) = (self.share, self.time_count.max(1));
        (0..count).map(move |i| {
            let middle = (f64::from(i) + 0.5) / f64::from(count);
            f64::from(frame) + share * middle
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shutter_that_closes_at_once_sees_the_frames_beginning() {
        for time_count in [0, 1, 5] {
            let shutter = Shutter {
                time_count,
                ..Shutter::default()
            };
            let times: Vec<f64> = shutter.times(9998).collect();
            assert_eq!(times, vec![9998.0; time_count.max(1) as usize]);
        }
    }

    /// With the shutter always open, sample times are evenly spaced across frames.
    #[test]
    fn times_are_evenly_apart_across_frames() {
        let shutter = Shutter {
            share: 1.0,
            time_count: 4,
        };
        let times: Vec<f64> = (3..6).flat_map(|frame| shutter.times(frame)).collect();
        assert_eq!((times[0], times.len()), (3.125, 12));
        assert!(times.windows(2).all(|pair| pair[1] - pair[0] == 0.25));
    }
}
