//! The kernels that trace one kind of tree.

/// One row of the matrix of codecs and kernels: all kernels for one kind of nodes and triangles.
///
/// The first line lists the bindings: after the root (0), where the tree has one, come the numbers for all other arguments. A source
/// expression sees the bound slices under the names given and the root, decoded.
///
/// - closest: one thread per ray. Reads the scene's exponent, the tree and the ray. Stores the closest hit.
/// - any: one thread per ray. Stores 1 where the ray hits anything, else 0.
/// - nearest: one thread per ray. Stores the nearest hits in order, misses at the end.
/// - counted: one thread per ray. Stores how many nodes and triangles the search for the closest hit visits.
/// - paths: one thread per path. Reads the scene's exponent, a target, the tree, the components of the primitives and their
///   outer sides. Stores the closest hit that faces the target, a miss for paths that have ended. Where sides are 0, all
///   triangles are hits. Counts the paths that go on and the hits.
/// - paths counted: one thread per path. Stores the closest hit, and how many nodes the search for it opens. Counts the paths
///   that go on, the hits and the nodes.
/// - shadows: one thread per path. Reads what paths read, and what `shade_light` stored. Stores the path with the light where
///   no hit is in the way. Counts the shadow rays.
macro_rules! trace_kernels {
    (
        [($($root:ident)?) $a:tt $b:tt $c:tt $d:tt $e:tt $f:tt $g:tt $h:tt $i:tt]
        |$nodes:ident: $node:ty, $triangles:ident: $triangle:ty| $node_source:expr, $triangle_source:expr;
        pub fn $closest:ident;
        pub fn $any:ident;
        pub fn $nearest:ident;
        pub fn $counted:ident;
        pub fn $paths:ident;
        pub fn $paths_counted:ident;
        pub fn $shadows:ident;
    ) => {
        /// Answers rays by their closest hit.
        #[spirv(compute(threads(64)))]
        pub fn $closest(
            #[spirv(global_invocation_id)] id: UVec3,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $b)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $c)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] hits: &mut [Hit],
        ) {
            $(let $root = root_words($root);)?
            let (i, exponent) = (thread_index(id), exponent.x as i32);
            store::closest(i, exponent, &$node_source, &$triangle_source, rays, hits);
        }

        /// Answers rays by whether they hit anything.
        #[spirv(compute(threads(64)))]
        pub fn $any(
            #[spirv(global_invocation_id)] id: UVec3,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $b)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $c)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] found: &mut [u32],
        ) {
            $(let $root = root_words($root);)?
            let (i, exponent) = (thread_index(id), exponent.x as i32);
            store::any(i, exponent, &$node_source, &$triangle_source, rays, found);
        }

        /// Answers rays by their nearest hits.
        #[spirv(compute(threads(64)))]
        pub fn $nearest(
            #[spirv(global_invocation_id)] id: UVec3,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $b)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $c)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)]
            hits: &mut [[Hit; NEAREST_COUNT]],
        ) {
            $(let $root = root_words($root);)?
            let (i, exponent) = (thread_index(id), exponent.x as i32);
            store::nearest(i, exponent, &$node_source, &$triangle_source, rays, hits);
        }

        /// Answers rays by what the search for the closest hit visits.
        #[spirv(compute(threads(64)))]
        pub fn $counted(
            #[spirv(global_invocation_id)] id: UVec3,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(storage_buffer, descriptor_set = 0, binding = $b)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $c)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] rays: &[Ray],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] counts: &mut [[u32; 2]],
        ) {
            $(let $root = root_words($root);)?
            let (i, exponent) = (thread_index(id), exponent.x as i32);
            store::counted(i, exponent, &$node_source, &$triangle_source, rays, counts);
        }

        /// Finds the paths' closest hits that face a target.
        #[spirv(compute(threads(64)))]
        pub fn $paths(
            #[spirv(global_invocation_id)] id: UVec3,
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $b)] target: &[UVec4; 2],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $c)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] components: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] sides: &[i32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $g)] paths: &[Path],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $h)] hits: &mut [Hit],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $i)] counters: &mut [u32],
        ) {
            $(let $root = root_words($root);)?
            let i = thread_index(id);
            let filter = FacingFilter {
                skip: store::path_skip(i, paths),
                sides: Sides { components, sides },
                target: scaled_target(target, exponent.x),
            };
            let (nodes, triangles) = (&$node_source, &$triangle_source);
            store::paths(i, nodes, triangles, &filter, paths, hits, counters);
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
            $(#[spirv(uniform, descriptor_set = 0, binding = 0)] $root: &[UVec4; 2],)?
            #[spirv(uniform, descriptor_set = 0, binding = $a)] exponent: &UVec4,
            #[spirv(uniform, descriptor_set = 0, binding = $b)] target: &[UVec4; 2],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $c)] $nodes: &[$node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $d)] $triangles: &[$triangle],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $e)] components: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $f)] sides: &[i32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $g)] shadows: &[Shadow],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $h)] paths: &mut [Path],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $i)] counters: &mut [u32],
        ) {
            $(let $root = root_words($root);)?
            let i = thread_index(id);
            let filter = FacingFilter {
                skip: store::shadow_skip(i, shadows),
                sides: Sides { components, sides },
                target: scaled_target(target, exponent.x),
            };
            let (nodes, triangles) = (&$node_source, &$triangle_source);
            store::shadows(i, nodes, triangles, &filter, shadows, paths, counters);
        }
    };
}
