use super::*;
use proptest::prelude::*;

#[test]
fn sizes_are_those_that_are_stated() {
    for (bits, words) in [
        (1, 3),
        (4, 3),
        (5, 4),
        (6, 4),
        (8, 4),
        (10, 4),
        (11, 5),
        (12, 5),
        (15, 5),
        (16, 7),
        (21, 7),
    ] {
        assert_eq!(node_words(bits), words, "{bits}");
    }
}

/// A box in another.
fn inside(outer: LatticeBox) -> impl Strategy<Value = LatticeBox> {
    let axis = move |i: usize| {
        let range = outer.min[i]..=outer.max[i];
        (range.clone(), range).prop_map(|(a, b)| [a.min(b), a.max(b)])
    };
    [axis(0), axis(1), axis(2)].prop_map(|[x, y, z]| LatticeBox {
        min: [x[0], y[0], z[0]],
        max: [x[1], y[1], z[1]],
    })
}

fn any_box() -> impl Strategy<Value = LatticeBox> {
    prop_oneof![Just((1 << 24) - 1), 0i32..5000, 0i32..1 << 20].prop_flat_map(|most| {
        inside(LatticeBox {
            min: [-most; 3],
            max: [most; 3],
        })
    })
}

/// A node with these boxes.
fn rounded(left: &LatticeBox, right: &LatticeBox) -> RoundedNode {
    RoundedNode {
        planes: [0, 1, 2].map(|i| [left.min[i], right.min[i], left.max[i], right.max[i]]),
        ..RoundedNode::EMPTY
    }
}

fn family() -> impl Strategy<Value = [LatticeBox; 3]> {
    any_box()
        .prop_flat_map(|parent| (Just(parent), inside(parent), inside(parent)))
        .prop_map(|(parent, left, right)| [parent, left, right])
}

fn links_of_any() -> impl Strategy<Value = Links> {
    (any::<u32>(), 0..1u32 << 30).prop_map(|(a, b)| Links([a, b]))
}

fn check<const BITS: u32, const WORDS: usize>(
    [parent, left, right]: [LatticeBox; 3],
    given: Links,
) -> Result<(), TestCaseError> {
    assert_eq!(WORDS, node_words(BITS));
    let rounded = rounded(&left, &right);
    let node = encode_node::<BITS, WORDS>(&parent, &rounded);
    for (decoded, exact) in [(node.left, left), (node.right, right)] {
        prop_assert!(decoded.contains(&exact), "{decoded:?} {exact:?}");
        prop_assert!(parent.contains(&decoded));
        for axis in 0..3 {
            // At most a step of the number beyond what the parent's own planes leave no choice of.
            let extent = i64::from(parent.max[axis]) - i64::from(parent.min[axis]);
            let step = (extent >> (BITS - 1)).max(1);
            let slack =
                |d: i32, e: i32, side: i32| d == side || i64::from(d.abs_diff(e)) < step.max(1);
            prop_assert!(slack(decoded.min[axis], exact.min[axis], parent.min[axis]));
            prop_assert!(slack(decoded.max[axis], exact.max[axis], parent.max[axis]));
        }
    }
    prop_assert_eq!(encode_child::<BITS>(&parent, &rounded, true), node.left);
    prop_assert_eq!(encode_child::<BITS>(&parent, &rounded, false), node.right);
    let words = with_links::<BITS, WORDS>(node.words, given);
    prop_assert_eq!(links_of::<BITS, WORDS>(&words), given);
    prop_assert_eq!(
        decode_node::<BITS, WORDS>(&words, &parent),
        [node.left, node.right]
    );
    Ok(())
}

proptest! {
    #[test]
    fn decoded_boxes_hold_the_children_and_stay_in_the_parent(family in family(), links in links_of_any()) {
        check::<4, 3>(family, links)?;
        check::<6, 4>(family, links)?;
        check::<8, 4>(family, links)?;
        check::<10, 4>(family, links)?;
        check::<12, 5>(family, links)?;
        check::<16, 7>(family, links)?;
        check::<21, 7>(family, links)?;
    }
}

/// The longest extents have more bits than floats: their exponents must be right all the same.
#[test]
fn the_longest_extents_decode_alike() {
    let most = (1 << 24) - 1;
    for low in [-most, 1 - most, 2 - most] {
        for high in [most, most - 1, most - 2] {
            let parent = LatticeBox {
                min: [low; 3],
                max: [high; 3],
            };
            let left = LatticeBox {
                min: [low, 5 + low, low],
                max: [high - 77, 9, 12],
            };
            let right = LatticeBox {
                min: [-3, low, 7],
                max: [high, high, high],
            };
            let checked = check::<10, 4>([parent, left, right], Links::default());
            assert!(checked.is_ok(), "{checked:?}");
        }
    }
}

/// All pairs of cells of one axis, for all extents up to 70 and 3 bits.
#[test]
fn every_pair_of_cells_of_one_axis() {
    for extent in 0..=70 {
        let parent = LatticeBox {
            min: [-7; 3],
            max: [extent - 7; 3],
        };
        for low in 0..=extent {
            for high in low..=extent {
                let child = LatticeBox {
                    min: [low - 7; 3],
                    max: [high - 7; 3],
                };
                for (left, right) in [(child, parent), (parent, child), (child, child)] {
                    let node = encode_node::<3, 3>(&parent, &rounded(&left, &right));
                    assert!(node.left.contains(&left) && node.right.contains(&right));
                    assert!(parent.contains(&node.left) && parent.contains(&node.right));
                }
            }
        }
    }
}

/// Extents that the numbers can count come out as they went in, where one child has each side.
#[test]
fn small_boxes_are_exact() {
    let parent = LatticeBox {
        min: [100, -100, 0],
        max: [1123, 923, 7],
    };
    let left = LatticeBox {
        min: [100, -99, 0],
        max: [600, 923, 3],
    };
    let right = LatticeBox {
        min: [599, -100, 2],
        max: [1123, 0, 7],
    };
    let node = encode_node::<10, 4>(&parent, &rounded(&left, &right));
    assert_eq!((node.left, node.right), (left, right));
}
