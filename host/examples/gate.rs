use glam::Vec3;
use rayon::prelude::*;
use slimbvh::scene::{LoadOptions, load};
use slimbvh::*;
use slimbvh_core::classify::Except;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::*;
use slimbvh_core::{NodeRef, IndexedTriangles};

#[derive(Clone, Copy)]
struct C { b: Aabb, id: usize }

fn measure(a: &Aabb, b: &Aabb, metric: u32) -> f32 {
    let d = a.max.max(b.max) - a.min.min(b.min);
    let d = d.max(Vec3::splat(2f32.powi(-60)));
    let ar = |b: &Aabb| { let d = (b.max-b.min).max(Vec3::splat(2f32.powi(-60))); d.x*d.y+d.y*d.z+d.z*d.x };
    let u = d.x*d.y+d.y*d.z+d.z*d.x;
    match metric { 0 => u, 1 => d.x+d.y+d.z, 2 => u - ar(a).min(ar(b)), 3 => u - 0.5*(ar(a) + ar(b)), 4 => d.length_squared(), _ => u - ar(a).max(ar(b)) }
}

#[allow(dead_code)] fn cluster(t: &[LeafTriangle], radii: (usize,usize,usize), metric: u32, share: f32, ct: f32, rot: u32) -> (Vec<LeafTriangle>, Vec<Node>, usize, usize, u32) {
    let n = t.len();
    let bx = |t: &LeafTriangle| { let v = t.vertices; let p = |i: usize| Vec3::new(v[3*i],v[3*i+1],v[3*i+2]);
        Aabb { min: p(0).min(p(1)).min(p(2)), max: p(0).max(p(1)).max(p(2)) } };
    let mut cl: Vec<C> = t.iter().enumerate().map(|(i,t)| C{b:bx(t),id:i}).collect();
    let mut tree: Vec<(usize,usize,u32,u32)> = Vec::new(); // left,right,count,kept
    let mut costs: Vec<f32> = vec![]; let area = |b: &Aabb| b.half_area();
    let mut boxes: Vec<Aabb> = Vec::new();
    let mut depth = vec![0u32; n];
    let mut rotations = 0usize; let (mut iters, mut forced_n, mut evals) = (0,0,0usize);
    let mut forced = false;
    while cl.len() > 1 {
        let m = cl.len();
        let radius = if m * radii.2 > n { radii.0 } else { radii.1 };
        let near: Vec<usize> = if forced { forced_n += 1; (0..m).map(|i| if i^1 < m { i^1 } else { i }).collect() } else {
            evals += m*radius;
            (0..m).map(|i| {
            let lo = i.saturating_sub(radius); let hi = (i+radius).min(m-1);
            let mut best = (f32::MAX, 0u32, usize::MAX);
            for j in lo..=hi { if j==i {continue;}
                let (a,b) = (i.min(j), i.max(j));
                // symmetric tie rule: cost, then parity of the lower, distance, lower
                let key = (measure(&cl[i].b,&cl[j].b,metric), ((a & 1) as u32) | (((b-a) as u32) << 1), a);
                if key.0 < best.0 || (key.0 == best.0 && (key.1, key.2) < (best.1, if best.2==usize::MAX {usize::MAX} else {best.2.min(i)})) { best = (key.0, key.1, j); }
            }
            best.2 }).collect() };
        let mut next = Vec::with_capacity(m);
        for i in 0..m {
            let j = near[i];
            if j != i && near[j] == i {
                if i < j {
                    let (mut l, mut r) = (cl[i].id, cl[j].id);
                    let cn = |x: usize| if x < n { 1u32 } else { tree[x-n].2 };
 if rot > 0 && (rot < 3 || cn(l)+cn(r) > 4) {
                        let bxs = |x: usize| if x < n { bx(&t[x]) } else { boxes[x-n] };
                        let kids = |x: usize| if x < n { None } else { Some((tree[x-n].0, tree[x-n].1)) };
                        let (al, ar_) = (area(&bxs(l)), area(&bxs(r)));
                        let (mut best, mut pick) = (0.0f32, 0);
                        let mut tr = |gain: f32, k: u32| if gain > best { best = gain; pick = k; };
                        let u = |x: usize, y: usize| area(&bxs(x).union(bxs(y)));
                        let safe = |a: usize, b: usize, d: usize| rot <= 3 || (rot == 5 && cn(a) <= 4 && (cn(a) + cn(d) <= 4 || cn(b) > 4)) || (rot==6 && cn(b)>4 && cn(a)<=cn(b)/2);
                        if let Some((c,d)) = kids(r) { if safe(l,r,d) {tr(ar_ - u(l,d), 1);} if safe(l,r,c) {tr(ar_ - u(l,c), 2);} }
                        if let Some((e,f)) = kids(l) { if safe(r,l,f) {tr(al - u(f,r), 3);} if safe(r,l,e) {tr(al - u(e,r), 4);}
                          if rot > 1 { if let Some((c,d)) = kids(r) { tr(al+ar_-u(e,c)-u(f,d),5); tr(al+ar_-u(e,d)-u(f,c),6); } } }
                        let mut set = |x: usize, p: usize, q: usize, tree: &mut Vec<(usize,usize,u32,u32)>| {
                            let b = bxs(p).union(bxs(q));
                            let g = |x: usize| if x < n { (1u32,0u32) } else { (tree[x-n].2, tree[x-n].3) };
                            let count = g(p).0 + g(q).0; let kept = if count > 4 { 1 + g(p).1 + g(q).1 } else {0};
                            tree[x-n] = (p,q,count,kept); rotations += 1;
                            (x, b)
                        };
                        let done = match pick {
                          1 => { let (c,d) = kids(r).unwrap(); let z = set(r, l, d, &mut tree); l = c; Some(z) }
                          2 => { let (c,d) = kids(r).unwrap(); let z = set(r, l, c, &mut tree); l = r; r = d; Some(z) }
                          3 => { let (e,f) = kids(l).unwrap(); let z = set(l, f, r, &mut tree); r = l; l = e; Some(z) }
                          4 => { let (e,f) = kids(l).unwrap(); let z = set(l, e, r, &mut tree); r = f; Some(z) }
                          5 => { let (e,f) = kids(l).unwrap(); let (c,d) = kids(r).unwrap(); let z = set(l,e,c,&mut tree); let y = set(r,f,d,&mut tree); boxes[y.0-n]=y.1; Some(z) }
                          6 => { let (e,f) = kids(l).unwrap(); let (c,d) = kids(r).unwrap(); let z = set(l,e,d,&mut tree); let y = set(r,f,c,&mut tree); boxes[y.0-n]=y.1; Some(z) }
                          _ => None };
                        if let Some((x,b)) = done { boxes[x-n] = b; depth[x] = depth[tree[x-n].0].max(depth[tree[x-n].1]) + 1; }
                    }
                    let g = |x: usize| if x < n { (1u32,0u32) } else { (tree[x-n].2, tree[x-n].3) };
                    let cost = |x: usize, b: &Aabb| if x < n { ct * area(b) } else { costs[x-n] };
                    let count = g(l).0 + g(r).0;
                    let b = cl[i].b.union(cl[j].b); let inner = area(&b) + cost(l,&cl[i].b) + cost(r,&cl[j].b); let leaf = area(&b) * count as f32 * ct;
 let is_inner = count > 4 || (ct > 0.0 && inner < leaf) || g(l).1 + g(r).1 > 0; costs.push(if is_inner {inner} else {leaf});
 let kept = if is_inner { 1 + g(l).1 + g(r).1 } else { 0 };
                    let b = cl[i].b.union(cl[j].b);
                    let d = if is_inner { 1 + depth[l].max(depth[r]) } else { 0 };
                    tree.push((l,r,count,kept)); boxes.push(b); depth.push(d);
                    next.push(C { b, id: n + tree.len()-1 });
                }
            } else { next.push(cl[i]); }
        }
        forced = ((m - next.len()) as f32) < share * m as f32;
        cl = next; iters += 1;
    }
    let root = cl[0].id;
    // place
    let mut out = vec![LeafTriangle::default(); n];
    let kept = tree[root-n].3 as usize;
    let mut nodes = vec![Node::EMPTY; kept];
    let mut first = vec![(0u32,0u32,false); n + tree.len()]; // first leaf, run begin, left
    let g = |x: usize| if x < n { (1u32,0u32) } else { (tree[x-n].2, tree[x-n].3) };
    let bb = |x: usize| if x < n { bx(&t[x]) } else { boxes[x-n] };
    let mut stack = vec![root]; while let Some(x) = stack.pop() {
        if x < n { continue; } stack.push(tree[x-n].0); stack.push(tree[x-n].1);
        let (f, run, is_left) = first[x];
        let (l, r, count, k) = tree[x-n];
        let split = f + g(l).0 - 1;
        if k > 0 {
            let (own, begin) = if is_left { (run + k - 1, run) } else { (run, run + 1) };
            first[l] = (f, begin, true); first[r] = (split+1, begin + g(l).1, false);
            let rf = |x: usize, first: u32, own: u32| if g(x).1 > 0 { NodeRef::inner(own) } else { NodeRef::leaf(first, g(x).0) };
            let node = Node { left: rf(l, f, begin + g(l).1.wrapping_sub(1)), right: rf(r, split+1, begin + g(l).1), first: f, last: f + count - 1, ..Node::EMPTY };
            nodes[own as usize] = node.with_boxes(bb(l), bb(r));
        } else { first[l] = (f,0,true); first[r] = (split+1,0,false); }
    }
    for x in 0..n { out[first[x].0 as usize] = t[x]; }
    (out, nodes, iters, rotations, depth[root])
}

fn visits(nodes: &[Node], tris: &[LeafTriangle], e: i32, rays: &[Ray], any: bool) -> (f64, f64, usize) {
    let r: (u64,u64,usize) = rays.par_iter().map(|ray| {
        let ray = PreparedRay::new(ray, e);
        let (ns, ts) = (PlainNodes(nodes), LeafTriangles(tris));
        if any { let mut c = Counted::new(AnyHit::new(ray.t_max)); traverse(&ns,&ts,&ray,&Except::NOTHING,&mut c); (c.node_count as u64, c.triangle_count as u64, 0) }
        else { let mut c = Counted::new(ClosestHit::new(ray.t_max)); traverse(&ns,&ts,&ray,&Except::NOTHING,&mut c); (c.node_count as u64, c.triangle_count as u64, 0) }
    }).reduce(|| (0,0,0), |a,b| (a.0+b.0,a.1+b.1,a.2+b.2));
    (r.0 as f64 / rays.len() as f64, r.1 as f64 / rays.len() as f64, r.2)
}

fn main() {
    let mut names: Vec<String> = std::env::args().skip(1).collect();
    if names[0] == "build" {
        let mesh = match names[2].as_str() { "terrain" => generate::terrain(10.0, 256, 7), n => load(std::path::Path::new(&format!("scenes/{n}")), &LoadOptions::default()).unwrap().mesh };
        let n: u32 = names[3].parse().unwrap();
        let mut b = Builder::new(BuildConfig { tree: if names[1] == "radix" { TreeKind::Radix } else { TreeKind::Clustered }, ..Default::default() });
        let mut bvh = Bvh::default(); let mut st = Stages::default();
        let mut min = std::collections::BTreeMap::new();
        for _ in 0..n { st = b.build_into(&mesh, &mut bvh).unwrap(); for (k, v) in st.iter() { let e = min.entry(k).or_insert(f64::MAX); *e = e.min(v.as_secs_f64()*1e3); } }
        println!("min ms: {min:.2?} sum {:.2}", min.values().sum::<f64>());
        println!("{st:?} scratch {}", b.scratch_bytes());
        return;
    }
    let _ = &mut names;
    for name in &names {
        let mesh = match name.as_str() {
            "icosphere" => generate::icosphere(Vec3::ZERO, 1.0, 6),
            "terrain" => generate::terrain(10.0, 256, 7),
            "knot" => generate::torus_knot(&generate::TorusKnot { segments: 1024, ..generate::TorusKnot::default() }),
            "grid" => { let s = generate::icosphere(Vec3::ZERO, 1.0, 3); generate::grid_of_objects(&s, [5,5,5], Vec3::splat(3.0)) }
            _ => load(std::path::Path::new(&format!("scenes/{}", name.trim_end_matches('!'))), &LoadOptions::default()).unwrap().mesh,
        };
        let inside = name.ends_with('!');
        for bits in [CodeBits::Bits30, CodeBits::Bits63] {
        let bvh = Builder::new(bits.into()).build(&mesh).unwrap();
        let bounds = bvh.bounds().unwrap();
        let diag = (bounds.max - bounds.min).length();
        let center = (bounds.min + bounds.max) * 0.5;
        let (eye, target) = if inside { (center - Vec3::new(0.0, 0.2*(bounds.max.y-bounds.min.y), 0.0), center + Vec3::X*diag) } else { (center + Vec3::new(0.35,0.25,1.0).normalize()*1.1*diag, center) };
        let camera = Camera { eye: eye.to_array(), target: target.to_array(), up: [0.0,1.0,0.0], projection: Projection::Perspective { vertical_fov: if inside {60.0} else {35.0} } }.to_core([1280,720],1).unwrap();
        let primary: Vec<Ray> = (0..1280*720u32).into_par_iter().step_by(7).map(|p| { let r = camera.ray(p); Ray::new(r.origin, Vec3::from_array(r.direction).normalize().to_array()) }).collect();
        let sun = Vec3::new(0.3,0.8,0.5).normalize();
        let shadow: Vec<Ray> = primary.par_iter().filter_map(|ray| {
            let hit = bvh.closest_hit(ray); if !hit.is_hit() { return None; }
            let ts = IndexedTriangles { vertices: &mesh.vertices, indices: &mesh.indices };
            let normal = ts.triangle(hit.primitive).normal();
            let d = Vec3::from_array(ray.direction);
            let normal = (normal * -normal.dot(d).signum()).normalize_or_zero();
            let p = Vec3::from_array(ray.origin) + d*hit.t;
            (normal.dot(sun) > 0.0).then(|| Ray::new((p + normal*1e-4*diag).to_array(), sun.to_array()))
        }).collect();
        let e = bvh.scene_exponent();
        let n = bvh.leaf_triangles().len();
        let row = |what: &str, nodes: &[Node], tris: &[LeafTriangle], note: String| {
            let p = visits(nodes,tris,e,&primary,false); let s = visits(nodes,tris,e,&shadow,true);
            println!("{name:>20} {what:>14} primary {:6.2} {:5.2} shadow {:6.2} {:5.2}  sah {:7.2} B/tri {:.1} {note}", p.0,p.1,s.0,s.1, slimbvh::animate::sah_cost(nodes), nodes.len() as f64*64.0/n as f64);
        };
        let tag = if bits == CodeBits::Bits30 { 30 } else { 63 };
        row(&format!("karras{tag}"), bvh.nodes(), bvh.leaf_triangles(), String::new());
        let cb = Builder::new(BuildConfig { tree: TreeKind::Clustered, ..bits.into() }).build(&mesh).unwrap();
        cb.validate_over(&mesh).unwrap();
        for (i, ray) in primary.iter().enumerate() { if i % 97 == 0 { assert_eq!(cb.closest_hit(ray), bvh.closest_hit(ray)); } }
        row(&format!("clustered{tag}"), cb.nodes(), cb.leaf_triangles(), String::new());
    }
}
}
