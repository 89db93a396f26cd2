//! The kernels that trace one kind of tree.

/// One row of the matrix of codecs and kernels: all kernels for one kind of nodes and triangles.
///
/// The first line lists the bindings: after the root (0), where the tree has one, come the numbers for all other arguments. The second
/// names the stack in workgroup memory: its words, and how a lane's is made of them. A source expression sees the bound slices under the
/// names given and the root, decoded.
///
/// - closest: one thread per ray. Reads the scene's exponent, the number of rays, the tree and the ray. Stores the closest hit. Answers
///   of rays beyond the number are not stored.
/// - any: one thread per ray. Stores 1 where the ray hits anything, else 0.
/// - filtered closest, filtered any: the same for triangles that face a target and that no end of the ray lies on. Read a target, the
///   packed sides of the primitives and the ray's ends, too. Where sides are 0, all triangles face the target; rays beyond the last
///   ends have none. Nearest and counted are filtered, too. A filter takes up to 16 registers, so that there are both kinds.
/// - nearest: one thread per ray. Stores the nearest hits in order, misses at the end.
/// - counted: one thread per ray. Stores how many nodes and triangles the search for the closest hit visits.
/// - paths: one thread per path. Reads the scene's exponent, a target, the tree and the packed sides of the primitives. Stores the
///   closest hit that faces the target, a miss for paths that have ended. Where sides are 0, all triangles are hits. Counts the
///   paths that go on and the hits.
/// - paths counted: one thread per path. Stores the closest hit, and how many nodes the search for it opens. Counts the paths
///   that go on, the hits and the nodes.
/// - shadows: one thread per path. Reads what paths read, and what `shade_light` stored. Stores the path with the light where
///   no hit is in the way. Counts the shadow rays.
///
/// Those with a stack in workgroup memory store no answer for a ray that needs more of it, but list the ray
/// ([`super::overflow`]). Of each question there is a kernel for the listed rays, with a private stack, which also reads what
/// `trace_groups` stored: for rays one for all three questions, `params.x` being the number of hits a ray, 0 for any.
macro_rules! trace_kernels {
    (
        [($($root:ident)?) $a:tt $b:tt $c:tt $d:tt $e:tt $f:tt $g:tt $h:tt $i:tt $j:tt $k:tt]
        [$words:ty, $stack:path]
        |$nodes:ident: $node:ty, $triangles:ident: $triangle:ty| $node_source:expr, $triangle_source:expr;
        pub fn $closest:ident;
        pub fn $any:ident;
        pub fn $filtered_closest:ident;
        pub fn $filtered_any:ident;
        pub fn $nearest:ident;
        pub fn $rays_overflow:ident;
        pub fn $counted:ident;
        pub fn $paths:ident;
        pub fn $paths_overflow:ident;
        pub fn $paths_counted:ident;
        pub fn $shadows:ident;
        pub fn $shadows_overflow:ident;
    ) => {
        /// Answers rays by their closest hit.
        #[spirv(compute(threads(64)))]
        pub fn $closest(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $b)] count: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $c)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] hits: &mut [Hit],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $g)] list: &mut [u32],
            #[spirv(workgroup)] words: &mut $words,
        ) {
            $(let $root = root_words($root);)?
            let (stack, tree) = (&mut $stack(words, lane), (&$node_source, &$triangle_source));
            let rays = PlainRays { rays, count: count.x, exponent: exponent.x };
            store::closest(stack, tree, thread_index(id), rays, hits, list);
        }

        /// Answers rays by their closest hit that the filter accepts.
        #[spirv(compute(threads(64)))]
        pub fn $filtered_closest(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $b)] target: &[UVec4; 2],
            #[spirv(uniform, descriptor_set = 0, binding = $c)] count: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] sides: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $g)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $h)] ends: &[RayEnds],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $i)] hits: &mut [Hit],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $j)] list: &mut [u32],
            #[spirv(workgroup)] words: &mut $words,
        ) {
            $(let $root = root_words($root);)?
            let (stack, tree) = (&mut $stack(words, lane), (&$node_source, &$triangle_source));
            let rays = PlainRays { rays, count: count.x, exponent: exponent.x };
            let rays = FilteredRays { rays, ends, sides, target };
            store::closest(stack, tree, thread_index(id), rays, hits, list);
        }

        /// Answers rays by whether they hit anything.
        #[spirv(compute(threads(64)))]
        pub fn $any(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $b)] count: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $c)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] found: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $g)] list: &mut [u32],
            #[spirv(workgroup)] words: &mut $words,
        ) {
            $(let $root = root_words($root);)?
            let (stack, tree) = (&mut $stack(words, lane), (&$node_source, &$triangle_source));
            let rays = PlainRays { rays, count: count.x, exponent: exponent.x };
            store::any(stack, tree, thread_index(id), rays, found, list);
        }

        /// Answers rays by whether they hit anything that the filter accepts.
        #[spirv(compute(threads(64)))]
        pub fn $filtered_any(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $b)] target: &[UVec4; 2],
            #[spirv(uniform, descriptor_set = 0, binding = $c)] count: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] sides: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $g)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $h)] ends: &[RayEnds],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $i)] found: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $j)] list: &mut [u32],
            #[spirv(workgroup)] words: &mut $words,
        ) {
            $(let $root = root_words($root);)?
            let (stack, tree) = (&mut $stack(words, lane), (&$node_source, &$triangle_source));
            let rays = PlainRays { rays, count: count.x, exponent: exponent.x };
            let rays = FilteredRays { rays, ends, sides, target };
            store::any(stack, tree, thread_index(id), rays, found, list);
        }

        /// Answers rays by their nearest hits.
        #[spirv(compute(threads(64)))]
        pub fn $nearest(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $b)] target: &[UVec4; 2],
            #[spirv(uniform, descriptor_set = 0, binding = $c)] count: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] sides: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $g)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $h)] ends: &[RayEnds],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $i)] hits: &mut [[Hit; NEAREST_COUNT]],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $j)] list: &mut [u32],
            #[spirv(workgroup)] words: &mut $words,
        ) {
            $(let $root = root_words($root);)?
            let (stack, tree) = (&mut $stack(words, lane), (&$node_source, &$triangle_source));
            let rays = PlainRays { rays, count: count.x, exponent: exponent.x };
            let rays = FilteredRays { rays, ends, sides, target };
            store::nearest(stack, tree, thread_index(id), rays, hits, list);
        }

        /// Answers the rays of the list.
        #[spirv(compute(threads(64)))]
        pub fn $rays_overflow(
            #[spirv(global_invocation_id)] id: UVec3,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $b)] target: &[UVec4; 2],
            #[spirv(uniform, descriptor_set = 0, binding = $c)] groups: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $d)] params: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $g)] sides: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $h)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $i)] ends: &[RayEnds],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $j)] list: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $k)] answers: &mut [u32],
        ) {
            $(let $root = root_words($root);)?
            let tree = (&$node_source, &$triangle_source);
            let rays = PlainRays { rays, count: u32::MAX, exponent: exponent.x };
            let rays = FilteredRays { rays, ends, sides, target };
            store::listed_rays(tree, (thread_index(id), groups.x), params.x, rays, list, answers);
        }

        /// Answers rays by what the search for the closest hit visits.
        #[spirv(compute(threads(64)))]
        pub fn $counted(
            #[spirv(global_invocation_id)] id: UVec3,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $b)] target: &[UVec4; 2],
            #[spirv(uniform, descriptor_set = 0, binding = $c)] count: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] sides: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $g)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $h)] ends: &[RayEnds],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $i)] counts: &mut [[u32; 2]],
        ) {
            $(let $root = root_words($root);)?
            let rays = PlainRays { rays, count: count.x, exponent: exponent.x };
            let rays = FilteredRays { rays, ends, sides, target };
            store::counted(thread_index(id), &$node_source, &$triangle_source, rays, counts);
        }

        /// Finds the paths' closest hits that face a target.
        #[spirv(compute(threads(64)))]
        pub fn $paths(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $b)] target: &[UVec4; 2],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $c)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] sides: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] paths: &[Path],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $g)] hits: &mut [Hit],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $h)] tally: &mut [u32],
            #[spirv(workgroup)] words: &mut $words,
        ) {
            $(let $root = root_words($root);)?
            let i = thread_index(id);
            let filter = FacingFilter {
                skip: store::path_skip(i, paths),
                sides: PackedSides(sides),
                target: scaled_target(target, exponent.x),
            };
            let (stack, tree) = (&mut $stack(words, lane), (&$node_source, &$triangle_source));
            store::paths(stack, tree, i, &filter, paths, hits, tally);
        }

        /// Finds the closest hits of the paths of the list.
        #[spirv(compute(threads(64)))]
        pub fn $paths_overflow(
            #[spirv(global_invocation_id)] id: UVec3,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $b)] target: &[UVec4; 2],
            #[spirv(uniform, descriptor_set = 0, binding = $c)] groups: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] sides: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $g)] paths: &[Path],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $h)] hits: &mut [Hit],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $i)] tally: &mut [u32],
        ) {
            $(let $root = root_words($root);)?
            let i = noted(thread_index(id), groups.x, paths.len() as u32, tally);
            let filter = FacingFilter {
                skip: store::path_skip(i, paths),
                sides: PackedSides(sides),
                target: scaled_target(target, exponent.x),
            };
            let tree = (&$node_source, &$triangle_source);
            store::listed_path(tree, i, &filter, paths, hits, tally);
        }

        /// Finds the paths' closest hits, and counts the nodes opened.
        #[spirv(compute(threads(64)))]
        pub fn $paths_counted(
            #[spirv(global_invocation_id)] id: UVec3,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(storage_buffer, descriptor_set = 0, binding = $a)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $b)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $c)] paths: &[Path],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] hits: &mut [Hit],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] counts: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] counters: &mut [u32],
        ) {
            $(let $root = root_words($root);)?
            let (i, nodes, triangles) = (thread_index(id), &$node_source, &$triangle_source);
            store::paths_counted(i, nodes, triangles, paths, hits, counts, counters);
        }

        /// Adds the light of shadow rays without a hit that faces a target.
        #[spirv(compute(threads(64)))]
        pub fn $shadows(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $b)] target: &[UVec4; 2],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $c)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] sides: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] shadows: &[Shadow],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $g)] paths: &mut [Path],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $h)] tally: &mut [u32],
            #[spirv(workgroup)] words: &mut $words,
        ) {
            $(let $root = root_words($root);)?
            let i = thread_index(id);
            let filter = FacingFilter {
                skip: store::shadow_skip(i, shadows),
                sides: PackedSides(sides),
                target: scaled_target(target, exponent.x),
            };
            let (stack, tree) = (&mut $stack(words, lane), (&$node_source, &$triangle_source));
            store::shadows(stack, tree, i, &filter, shadows, paths, tally);
        }

        /// Adds the light of the shadow rays of the list.
        #[spirv(compute(threads(64)))]
        pub fn $shadows_overflow(
            #[spirv(global_invocation_id)] id: UVec3,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $b)] target: &[UVec4; 2],
            #[spirv(uniform, descriptor_set = 0, binding = $c)] groups: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] sides: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $g)] shadows: &[Shadow],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $h)] tally: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $i)] paths: &mut [Path],
        ) {
            $(let $root = root_words($root);)?
            let i = noted(thread_index(id), groups.x, shadows.len() as u32, tally);
            let filter = FacingFilter {
                skip: store::shadow_skip(i, shadows),
                sides: PackedSides(sides),
                target: scaled_target(target, exponent.x),
            };
            let tree = (&$node_source, &$triangle_source);
            store::listed_shadow(tree, i, &filter, shadows, paths);
        }
    };
}
