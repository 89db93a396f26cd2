//! The places of numbers beside dots, so that no number is printed over another.

use super::{HEIGHT, WIDTH};

/// The room that a number of two digits takes, in pixels.
const SIZE: [i32; 2] = [18, 15];

/// The distance of a number's nearest edge from its dot.
const GAP: i32 = 5;

/// The top left corner of each dot's number: beside the dot, or above or below the numbers that are there already.
pub fn places(dots: &[[i32; 2]]) -> Vec<[i32; 2]> {
    let mut taken: Vec<[i32; 2]> = Vec::with_capacity(dots.len());
    for &[x, y] in dots {
        let sides = [x + GAP, x - GAP - SIZE[0]];
        let heights = (0..2 * dots.len() as i32 + 2).flat_map(|row| {
            // Upward from beside the dot, and downward.
            let up = y - GAP - SIZE[1] - row * SIZE[1];
            let down = y + GAP + row * SIZE[1];
            sides.into_iter().flat_map(move |x| [[x, up], [x, down]])
        });
        let is_free = |place: &[i32; 2]| {
            is_inside(*place) && taken.iter().all(|other| !overlaps(*place, *other))
        };
        let is_clear = |place: &[i32; 2]| dots.iter().all(|dot| !covers(*place, *dot));
        // Beside all dots if there is room, else at least not over another number.
        let mut free = heights.filter(is_free);
        let beside = free.clone().find(is_clear).or_else(|| free.next());
        let own = [x + GAP, y - GAP - SIZE[1]];
        taken.push(beside.unwrap_or(own));
    }
    taken
}

fn is_inside([x, y]: [i32; 2]) -> bool {
    x >= 0 && y >= 0 && x + SIZE[0] <= WIDTH as i32 && y + SIZE[1] <= HEIGHT as i32
}

/// Whether a number at this place lies over a dot.
fn covers(place: [i32; 2], dot: [i32; 2]) -> bool {
    (0..2)
        .all(|axis| (place[axis] - GAP < dot[axis]) && (dot[axis] < place[axis] + SIZE[axis] + GAP))
}

fn overlaps(a: [i32; 2], b: [i32; 2]) -> bool {
    (0..2).all(|axis| (a[axis] - b[axis]).abs() < SIZE[axis])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn overlap_count(places: &[[i32; 2]]) -> usize {
        let pairs = places.iter().enumerate();
        pairs
            .map(|(i, place)| {
                places[..i]
                    .iter()
                    .filter(|it| overlaps(*place, **it))
                    .count()
            })
            .sum()
    }

    #[test]
    fn numbers_at_one_dot_stand_around_it() {
        let four = places(&[[100, 100]; 4]);
        assert_eq!(four[0], [105, 80]);
        assert_eq!(overlap_count(&four), 0);
        assert!(four.iter().all(|place| (place[1] - 100).abs() < 40));
        // A dot beside another one pushes its number away.
        let pair = places(&[[100, 100], [110, 88]]);
        assert!(
            pair.iter()
                .all(|place| !covers(*place, [100, 100]) && !covers(*place, [110, 88]))
        );
        // What is not placed is printed over each other.
        assert_eq!(overlap_count(&[[100, 100]; 4]), 6);
    }

    proptest! {
        #[test]
        fn no_number_is_printed_over_another(
            dots in proptest::collection::vec([0..WIDTH as i32, 0..HEIGHT as i32], 0..14),
        ) {
            let places = places(&dots);
            prop_assert_eq!(places.len(), dots.len());
            prop_assert_eq!(overlap_count(&places), 0);
            prop_assert!(places.iter().all(|place| is_inside(*place)));
        }
    }
}
