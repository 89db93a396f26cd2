//! Real meshes, if present: times, and numbers of seams.

use super::*;
use crate::scene::{LoadOptions, load};
use std::path::PathBuf;
use std::time::Instant;

/// Prints a line for each mesh in the folder that `SLIMBVH_SCENES` names.
#[test]
fn real_meshes_are_taken_stock_of() {
    let Some(folder) = std::env::var_os("SLIMBVH_SCENES").map(PathBuf::from) else {
        eprintln!("SKIPPED: SLIMBVH_SCENES is not set");
        return;
    };
    for name in [
        "armadillo.off",
        "dragon.ply",
        "sponza.obj",
        "bunny00.off",
        "refined_elephant.off",
    ] {
        let path = folder.join(name);
        if !path.exists() {
            eprintln!("SKIPPED: {} is not there", path.display());
            continue;
        }
        let mesh = load(&path, &LoadOptions::default()).unwrap().mesh;
        let bvh = build(&mesh);
        let ms = |begin: Instant| begin.elapsed().as_secs_f64() * 1e3;

        let begin = Instant::now();
        let mut topology = Topology::new(&mesh);
        let new_ms = ms(begin);
        let begin = Instant::now();
        topology.update(&mesh);
        let update_ms = ms(begin);
        let begin = Instant::now();
        topology.find_seams(&mesh, &bvh);
        let seams_ms = ms(begin);

        // A point near the middle of the box, in no simple ratio.
        let bounds = mesh.bounds().unwrap();
        let middle = Target::Point(bounds.min.lerp(bounds.max, 0.481_966).to_array());
        let begin = Instant::now();
        let sides = topology.sides(&middle);
        let sides_ms = ms(begin);
        let facts = topology.facts();
        let share = |shape: &Shape| shape.spending.steps as f64 / shape.spending.budget as f64;
        let largest = topology.shapes.iter().map(share).fold(0.0, f64::max);
        eprintln!(
            "{name}: {} triangles, {} components, {} closed, {} reducible, {} seams, {} bytes, \
             at most {:.1} % of a budget; \
             new {new_ms:.1}, update {update_ms:.1}, seams {seams_ms:.0}, sides {sides_ms:.1} ms",
            mesh.indices.len(),
            facts.len(),
            facts.iter().filter(|facts| facts.closed).count(),
            facts.iter().filter(|facts| facts.reducible).count(),
            topology.seam_count(),
            topology.bytes(),
            100.0 * largest,
        );
        assert!(facts.iter().all(|facts| !facts.search_given_up), "{name}");
        let far = Target::Point((bounds.max + (bounds.max - bounds.min)).to_array());
        let is_reducible = topology.sides(&far).into_iter().map(|side| side != 0);
        assert!(is_reducible.eq(facts.iter().map(|f| f.reducible).chain([false])));
        assert_eq!(sides.len(), facts.len() + 1);
    }
}
