//! Stage `fit`.

use crate::trace::root_words;
use glam::{UVec3, UVec4};
use slimbvh_core::encode::RootWords;
use slimbvh_core::fit::Fit;
use slimbvh_core::launch::{PART_STEP, count_in_part, dispatch_each};
use spirv_std_macros::spirv;

/// One thread works. Reads the number of triangles in a set, of which `params.x` fit. Stores what is known of the set, and the number of
/// triangles that are built with the dispatch of a thread for each.
#[spirv(compute(threads(64)))]
pub fn fit_count(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] counts: &mut [[u32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] fits: &mut [Fit],
) {
    if id.x == 0 && !counts.is_empty() && !fits.is_empty() {
        let [count, ..] = counts[0];
        let fit = Fit::new(count, params.x);
        fits[0] = fit;
        counts[0] = dispatch_each(fit.built_count());
    }
}

/// One thread works. Reads where the set begins in lists of nodes (`params.x`) and triangles (`params.y`) that begin with the whole tree,
/// what is known of the set, and the whole tree's root. Stores behind the scene's exponent where the tree begins that rays go through,
/// and that tree's root.
#[spirv(compute(threads(64)))]
pub fn fit_base(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] whole: &[UVec4; 2],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] fits: &[Fit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] exponents: &mut [[u32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] roots: &mut [RootWords],
) {
    if id.x == 0 && !fits.is_empty() && !exponents.is_empty() && !roots.is_empty() {
        let fit = fits[0];
        let [exponent, ..] = exponents[0];
        exponents[0] = [exponent, fit.base(params.x), fit.base(params.y), 0];
        if !fit.fits() {
            roots[0] = root_words(whole);
        }
    }
}

/// One thread works. Reads what is known of a set, and the number of rays: `params.z`, or if `params.w` is 1 as `trace_count` does.
/// Stores `[count, x, y, z]` of those that go through the set, with the dispatch of a thread for each, and [`PART_STEP`] behind it
/// that of those that go through the whole tree.
#[spirv(compute(threads(64)))]
pub fn fit_rays(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] params: &UVec4,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] fits: &[Fit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] groups: &mut [[u32; 4]],
) {
    let word = params.x as usize;
    let is_here = !fits.is_empty() && word < words.len() && PART_STEP < groups.len();
    if id.x == 0 && is_here {
        let mut count = params.z;
        if params.w == 1 {
            count = count_in_part(words[word], params.y, params.z);
        }
        let [set, whole] = fits[0].parts(count);
        groups[0] = dispatch_each(set);
        groups[PART_STEP] = dispatch_each(whole);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counted(count: u32, limit: u32) -> (Fit, [u32; 4]) {
        let (mut counts, mut fits) = ([dispatch_each(count)], [Fit::default()]);
        let params = UVec4::new(limit, 0, 0, 0);
        fit_count(UVec3::ZERO, &params, &mut counts, &mut fits);
        (fits[0], counts[0])
    }

    #[test]
    fn a_set_beyond_the_limit_is_not_built() {
        assert_eq!(counted(100, 100), (Fit::new(100, 100), [100, 2, 1, 1]));
        assert_eq!(counted(101, 100), (Fit::new(101, 100), [0, 0, 0, 1]));
    }

    #[test]
    fn rays_go_where_the_set_is() {
        let whole = [UVec4::splat(7); 2];
        for (count, base, root) in [(9, [3, 5], 1), (11, [0, 0], 7)] {
            let (mut exponents, mut roots) = ([[8, 0, 0, 0]], [root_words(&[UVec4::ONE; 2])]);
            let fits = [Fit::new(count, 10)];
            let params = UVec4::new(3, 5, 0, 0);
            fit_base(
                UVec3::ZERO,
                &params,
                &whole,
                &fits,
                &mut exponents,
                &mut roots,
            );
            assert_eq!(exponents[0], [8, base[0], base[1], 0]);
            assert_eq!(roots[0].low, [root; 4]);
        }
    }

    #[test]
    fn rays_are_dispatched_once() {
        let groups = |count: u32, params: [u32; 4]| {
            let mut groups = [[7; 4]; PART_STEP + 1];
            let fits = [Fit::new(count, 10)];
            fit_rays(UVec3::ZERO, &params.into(), &fits, &[9, 165], &mut groups);
            [groups[0], groups[PART_STEP]]
        };
        let (all, none) = ([100, 2, 1, 1], [0, 0, 0, 1]);
        assert_eq!(groups(10, [0, 0, 100, 0]), [all, none]);
        assert_eq!(groups(11, [0, 0, 100, 0]), [none, all]);
        assert_eq!(groups(11, [1, 100, 100, 1]), [none, [65, 2, 1, 1]]);
    }
}
