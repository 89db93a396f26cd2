//! Exact answers for small integer coordinates, by other methods than those of the code under test.

type Point = [i128; 3];

/// The corners of a triangle.
pub(super) type Corners = [Point; 3];

fn minus(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

fn dot(a: Point, b: Point) -> i128 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Point, b: Point) -> Point {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn det(a: Point, b: Point, c: Point) -> i128 {
    dot(a, cross(b, c))
}

pub(super) fn normal([a, b, c]: Corners) -> Point {
    cross(minus(b, a), minus(c, a))
}

pub(super) fn has_area(corners: Corners) -> bool {
    normal(corners) != [0; 3]
}

/// The winding number of triangles around a point; `None` if it lies on one. Counts crossings of a ray that meets no edge.
pub(super) fn winding_number(triangles: &[Corners], point: Point) -> Option<i32> {
    const DIRECTIONS: [Point; 8] = [
        [101, 37, 59],
        [-211, 89, 23],
        [31, -157, 97],
        [43, 61, -197],
        [-83, -131, 17],
        [173, -29, -71],
        [-19, 223, -107],
        [-139, -47, -163],
    ];
    let winding = |direction: Point| {
        let mut sum = 0;
        for corners in triangles.iter().filter(|&&corners| has_area(corners)) {
            let [a, b, c] = corners.map(|p| minus(p, point));
            let areas = [
                det(direction, b, c),
                det(direction, c, a),
                det(direction, a, b),
            ];
            if areas.iter().any(|&e| e > 0) && areas.iter().any(|&e| e < 0) {
                continue;
            }
            if areas.contains(&0) {
                return None;
            }
            // The line passes inside; it is the ray if both signs agree.
            let height = det(a, b, c);
            if height == 0 {
                return None;
            }
            if height.signum() == areas[0].signum() {
                sum += areas[0].signum() as i32;
            }
        }
        Some(sum)
    };
    if triangles.iter().any(|&corners| contains(corners, point)) {
        return None;
    }
    let found = DIRECTIONS.into_iter().find_map(winding);
    Some(found.expect("some direction meets no edge"))
}

/// Whether a point lies on a triangle.
fn contains(corners: Corners, point: Point) -> bool {
    let [a, b, c] = corners.map(|p| minus(p, point));
    let n = normal(corners);
    if n == [0; 3] {
        // On a segment: no further from either end than the other end is.
        return [(a, b), (b, c), (c, a)]
            .into_iter()
            .any(|(p, q)| cross(p, q) == [0; 3] && dot(p, q) <= 0);
    }
    let areas = [(b, c), (c, a), (a, b)].map(|(p, q)| dot(n, cross(p, q)));
    dot(n, a) == 0 && areas.iter().all(|&area| area >= 0)
}

/// Whether two triangles of positive area meet beyond what they share.
pub(super) fn collide(t: Corners, u: Corners) -> bool {
    let shared: Vec<Point> = t.into_iter().filter(|p| u.contains(p)).collect();
    let free = |corners: Corners| corners.into_iter().filter(|p| !shared.contains(p));
    match shared[..] {
        [] => !are_separated(t, u),
        [p] => {
            // Two cones with one apex meet only there if a plane through it separates them strictly: the edges of one on
            // one side, those of the other on the other side.
            let edges = free(t).map(|q| minus(q, p));
            let opposites = free(u).map(|q| minus(p, q));
            let directions: Vec<Point> = edges.chain(opposites).collect();
            hull_holds_zero([directions[0], directions[1], directions[2], directions[3]])
        }
        [p, q] => {
            // Hinged: they meet only if folded flat onto each other.
            let [Some(a), Some(b)] = [free(t).next(), free(u).next()] else {
                return true;
            };
            let hinge = minus(q, p);
            let (n, m) = (cross(hinge, minus(a, p)), cross(hinge, minus(b, p)));
            cross(n, m) == [0; 3] && dot(n, m) > 0
        }
        _ => true,
    }
}

/// Whether some plane strictly separates them (separating axes; Gottschalk 1996).
fn are_separated(t: Corners, u: Corners) -> bool {
    let sides = |[a, b, c]: Corners| [minus(b, a), minus(c, b), minus(a, c)];
    let (n, m) = (normal(t), normal(u));
    let mut axes = vec![n, m];
    for e in sides(t) {
        axes.push(cross(n, e));
        axes.extend(sides(u).map(|f| cross(e, f)));
    }
    axes.extend(sides(u).map(|f| cross(m, f)));
    axes.into_iter().any(|axis| {
        let heights = |corners: Corners| corners.map(|p| dot(p, axis));
        let (a, b) = (heights(t), heights(u));
        a.iter().max() < b.iter().min() || b.iter().max() < a.iter().min()
    })
}

/// Whether zero is a convex combination of four vectors: by Carathéodory's theorem, of one to four independent ones.
fn hull_holds_zero(vectors: [Point; 4]) -> bool {
    let pairs = |f: &dyn Fn(Point, Point) -> bool| {
        (0..4).any(|i| (0..i).any(|j| f(vectors[i], vectors[j])))
    };
    let is_zero = vectors.contains(&[0; 3]);
    let are_opposite = pairs(&|a, b| cross(a, b) == [0; 3] && dot(a, b) < 0);
    let spans_plane = (0..4).any(|skipped| {
        let [a, b, c] = [1, 2, 3].map(|i| vectors[(skipped + i) % 4]);
        let crosses = [cross(a, b), cross(b, c), cross(c, a)];
        det(a, b, c) == 0
            && crosses[0] != [0; 3]
            && dot(crosses[0], crosses[1]) > 0
            && dot(crosses[0], crosses[2]) > 0
    });
    let [a, b, c, d] = vectors;
    let weights = [det(b, c, d), -det(a, c, d), det(a, b, d), -det(a, b, c)];
    let spans_space = weights.iter().all(|&w| w > 0) || weights.iter().all(|&w| w < 0);
    is_zero || are_opposite || spans_plane || spans_space
}

#[test]
fn known_answers() {
    let t = [[0, 0, 0], [4, 0, 0], [0, 4, 0]];
    assert!(collide(t, [[1, 1, -1], [1, 1, 1], [9, 9, 0]]));
    assert!(!collide(t, [[3, 3, -1], [3, 3, 1], [9, 9, 0]]));
    assert!(collide(t, [[1, 1, 0], [1, 1, 1], [9, 9, 1]]), "it touches");
    assert!(collide(t, [[0, 0, 0], [1, 1, 0], [1, 1, 1]]));
    assert!(!collide(t, [[0, 0, 0], [-1, -1, 0], [1, 1, 1]]));
    assert!(!collide(t, [[4, 0, 0], [0, 0, 0], [1, -1, 0]]));
    assert!(collide(t, [[4, 0, 0], [0, 0, 0], [1, 9, 0]]));
    assert!(collide(t, [[4, 0, 0], [0, 4, 0], [0, 0, 0]]));
    let [o, x, y, z] = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]];
    let solid = [[o, y, x], [o, z, y], [o, x, z], [x, y, z]].map(|t| t.map(|p| p.map(|c| 4 * c)));
    assert_eq!(winding_number(&solid, [1, 1, 1]), Some(1));
    assert_eq!(winding_number(&solid, [-1, 1, 1]), Some(0));
    assert_eq!(winding_number(&solid, [0, 1, 1]), None);
}
