use super::*;

/// Beside a long edge, one step of the float grid separates hit and miss.
#[test]
fn one_step_beside_an_edge_is_outside() {
    let far = 1e7_f32;
    let oracle = Unculled::new(vec![[[0.5, -far, 3.0], [0.5, far, 7.0], [far, 0.1, 5.0]]]);
    for (x, count) in [(0.5_f32.next_down(), 0), (0.5, 1), (0.5_f32.next_up(), 1)] {
        let ray = Ray::new([x, 1.0 / 3.0, -1e-20], [0.0, 0.0, 1e-3]);
        assert_eq!(oracle.crossings(&ray, u32::MAX).len(), count);
    }
}

/// Both ends of a range belong to it exactly, wherever they are.
#[test]
fn ranges_end_exactly() {
    let oracle = Unculled::new(vec![[[0.0, 0.0, 3.0], [4.0, 0.0, 3.0], [0.0, 2.0, 3.0]]]);
    let at = |origin: f32, t_min: f32, t_max: f32| {
        let ray = Ray {
            t_min,
            t_max,
            ..Ray::new([1.0, 0.5, origin], [0.0, 0.0, 0.5])
        };
        oracle.is_met(&ray)
    };
    assert!(at(0.0, 0.0, 6.0) && at(0.0, 6.0, 6.0) && at(0.0, 6.0, f32::INFINITY));
    assert!(!at(0.0, 0.0, 6.0_f32.next_down()) && !at(0.0, 6.0_f32.next_up(), f32::MAX));
    assert!(at(4.0, -2.0, -1.0) && at(4.0, -2.0, -2.0));
    assert!(!at(4.0, (-2.0_f32).next_up(), 9.0) && !at(4.0, -9.0, (-2.0_f32).next_down()));
    // The first ray meets the back, the second one the front.
    let ray = Ray::new([1.0, 0.5, 0.0], [0.0, 0.0, 0.5]);
    let back = Ray::new([1.0, 0.5, 9.0], [0.0, 1e-30, -2.0]);
    assert_eq!((oracle.facing(&ray, 0), oracle.facing(&back, 0)), (-1, 1));
    let along = Ray::new([1.0, 0.5, 3.0], [1.0, 1.0, 0.0]);
    assert_eq!(oracle.facing(&along, 0), 0);
}

/// The largest and the smallest numbers are exact, too.
#[test]
fn nothing_overflows_or_underflows() {
    let (huge, tiny) = (f32::MAX, f32::from_bits(1));
    let wall = Unculled::new(vec![[
        [-huge, -huge, huge],
        [huge, -huge, huge],
        [0.0, huge, huge],
    ]]);
    let dust = Unculled::new(vec![[
        [-tiny, -tiny, tiny],
        [tiny, -tiny, tiny],
        [0.0, tiny, tiny],
    ]]);
    for direction in [tiny, 1.0, huge] {
        let ray = Ray::new([tiny, -tiny, -huge], [0.0, 0.0, direction]);
        let crossings = wall.crossings(&ray, u32::MAX);
        let t = 2.0 * f64::from(huge) / f64::from(direction);
        assert_eq!(crossings.len(), 1);
        assert!((crossings[0].t / t - 1.0).abs() < 1e-15);
        let ray = Ray::new([0.0, 0.0, -huge], [0.0, 0.0, direction]);
        assert!(dust.is_met(&ray));
        let beside = Ray::new([2.0 * tiny, 0.0, -huge], [0.0, 0.0, direction]);
        assert!(!dust.is_met(&beside));
    }
}
