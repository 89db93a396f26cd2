//! Planted faults in trees of the laboratory's lattice codec.

use super::*;
use crate::LatticeBits;
use crate::tree::parent_frame::LatticeTree;
use slimbvh_core::encode::{Links, links_of, with_links};

fn on_lattice(bvh: &mut Bvh) -> &mut LatticeTree {
    match &mut bvh.stored {
        StoredTree::Lattice(tree) => tree,
        _ => panic!("the tree is on a lattice"),
    }
}

#[test]
fn faults_of_coded_trees_are_found() {
    let codec = MeshCodec::Lattice {
        step_exponent: STEP,
    };
    let sound = built(NodeCodec::Lattice(LatticeBits::Q10), codec);
    let found = |spoil: &dyn Fn(&mut Bvh)| {
        let mut bvh = sound.clone();
        spoil(&mut bvh);
        bvh.validate()
    };
    let root_of = |change: &dyn Fn(&mut slimbvh_core::lattice::LatticeBox, &mut i32)| {
        found(&|bvh| {
            let tree = on_lattice(bvh);
            change(&mut tree.root, &mut tree.step_exponent);
        })
    };
    assert_eq!(root_of(&|_, _| {}), Ok(()));
    for x in [i32::MAX, i32::MIN, 1 << 24, 1 << 20] {
        assert_eq!(root_of(&|root, _| root.max[1] = x), Err(TreeError::RootBox));
    }
    let inverted = root_of(&|root, _| std::mem::swap(&mut root.min, &mut root.max));
    assert_eq!(inverted, Err(TreeError::RootBox));
    assert!(root_of(&|root, _| root.max[2] -= 1).is_err());
    for step in [i32::MIN, -127, 128, i32::MAX] {
        let expected = Err(TreeError::Step {
            step_exponent: step,
        });
        assert_eq!(root_of(&|_, exponent| *exponent = step), expected);
    }
    assert!(root_of(&|_, exponent| *exponent += 1).is_err());

    // Each node's links, replaced by the root's.
    let nodes = sound.node_count();
    for node in 1..nodes {
        let error = found(&|bvh| {
            let (all, _) = on_lattice(bvh).words.as_chunks_mut::<4>();
            let links: Links = links_of::<10, 4>(&all[0]);
            let mut bare = all[node];
            bare[0] = 0;
            for word in &mut bare[1..] {
                *word &= (1 << 22) - 1;
            }
            all[node] = with_links::<10, 4>(bare, links);
        });
        assert!(
            matches!(error, Err(TreeError::ChildOutOfPlace { .. })),
            "{error:?}"
        );
    }
    let fewer = found(&|bvh| {
        if let LatticeMesh::Lattice { count, .. } = &mut on_lattice(bvh).triangles {
            *count -= 1;
        }
    });
    assert!(matches!(fewer, Err(TreeError::LeafCount { .. })));
}
