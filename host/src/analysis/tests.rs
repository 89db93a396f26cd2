use super::*;

/// A box of 1 × 2 × 3 from `min`, wound outward, with one square of two triangles a side.
fn cuboid(min: [f32; 3]) -> Mesh {
    let vertices = (0..8).map(|corner| {
        let [x, y, z] = min;
        [
            x + (corner & 1) as f32,
            y + (corner & 2) as f32,
            z + 3.0 * (corner >> 2) as f32,
        ]
    });
    let squares = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    Mesh {
        vertices: vertices.collect(),
        indices: squares
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
            .collect(),
        ..Mesh::default()
    }
}

/// Both meshes' triangles over their own vertices.
fn join(mut mesh: Mesh, other: Mesh) -> Mesh {
    let first = mesh.vertices.len() as u32;
    mesh.vertices.extend(other.vertices);
    let indices = other.indices.iter().map(|t| t.map(|v| first + v));
    mesh.indices.extend(indices);
    mesh
}

/// Gives every triangle its own three vertices.
fn unweld(mesh: &Mesh) -> Mesh {
    let corners = mesh.indices.as_flattened();
    Mesh {
        vertices: corners.iter().map(|&v| mesh.vertices[v as usize]).collect(),
        indices: (0..mesh.indices.len() as u32)
            .map(|t| [3 * t, 3 * t + 1, 3 * t + 2])
            .collect(),
        ..Mesh::default()
    }
}

#[test]
fn a_cuboid_is_closed_and_faces_out() {
    let analysis = analyze(&cuboid([10.0, 20.0, 30.0]));
    let bounds = Aabb {
        min: Vec3::new(10.0, 20.0, 30.0),
        max: Vec3::new(11.0, 22.0, 33.0),
    };
    let expected = Analysis {
        triangle_count: 12,
        vertex_count: 8,
        welded_vertex_count: 8,
        components: vec![Component {
            triangle_count: 12,
            closed: true,
            consistently_wound: true,
            outward: Some(true),
            signed_volume: 6.0,
            bounds,
        }],
        bounds: Some(bounds),
        degenerate_triangle_count: 0,
        duplicate_triangle_count: 0,
    };
    assert_eq!(analysis, expected);
}

#[test]
fn nothing_has_no_bounds() {
    let analysis = analyze(&Mesh::default());
    assert_eq!((analysis.bounds, analysis.components.len()), (None, 0));
}

#[test]
fn a_cuboid_inside_out_faces_in() {
    let mut mesh = cuboid([0.0; 3]);
    for triangle in &mut mesh.indices {
        triangle.swap(0, 1);
    }
    let component = &analyze(&mesh).components[0];
    assert!(component.closed && component.consistently_wound);
    assert_eq!(
        (component.outward, component.signed_volume),
        (Some(false), -6.0)
    );
}

#[test]
fn welding_makes_triangle_soup_closed() {
    let mesh = unweld(&cuboid([0.0; 3]));
    let analysis = analyze(&mesh);
    assert_eq!(
        (analysis.vertex_count, analysis.welded_vertex_count),
        (36, 8)
    );
    assert_eq!(analysis.components, analyze(&cuboid([0.0; 3])).components);
}

#[test]
fn negative_zero_is_zero() {
    let mut mesh = unweld(&cuboid([0.0; 3]));
    for (number, vertex) in mesh.vertices.iter_mut().enumerate() {
        if number % 2 == 0 {
            *vertex = vertex.map(|x| if x == 0.0 { -0.0 } else { x });
        }
    }
    let analysis = analyze(&mesh);
    assert_eq!(analysis.welded_vertex_count, 8);
    assert_eq!(analysis.components.len(), 1);
    assert!(analysis.components[0].closed);
}

#[test]
fn components_are_sorted_and_touching_in_a_point_does_not_connect() {
    let mut small = cuboid([1.0, 2.0, 3.0]);
    small.indices.truncate(10);
    let analysis = analyze(&join(small, cuboid([0.0; 3])));
    assert_eq!(analysis.vertex_count, 16);
    assert_eq!(analysis.welded_vertex_count, 15);
    let found: Vec<_> = analysis
        .components
        .iter()
        .map(|c| (c.triangle_count, c.closed, c.consistently_wound, c.outward))
        .collect();
    assert_eq!(
        found,
        [(12, true, true, Some(true)), (10, false, true, None)]
    );
    assert_eq!(
        analysis.components[1].bounds.max.to_array(),
        [2.0, 4.0, 6.0]
    );
}

#[test]
fn cuboids_that_share_an_edge_are_one_closed_component() {
    let analysis = analyze(&join(cuboid([0.0; 3]), cuboid([1.0, 2.0, 0.0])));
    assert_eq!(analysis.welded_vertex_count, 14);
    assert_eq!(analysis.components.len(), 1);
    let component = &analysis.components[0];
    assert!(component.closed && component.consistently_wound);
    assert_eq!(
        (component.outward, component.signed_volume),
        (Some(true), 12.0)
    );
}

#[test]
fn a_face_turned_over_is_found() {
    let mut mesh = cuboid([0.0; 3]);
    for triangle in &mut mesh.indices[..2] {
        triangle.swap(0, 1);
    }
    let component = &analyze(&mesh).components[0];
    assert_eq!(component.triangle_count, 12);
    assert!(!component.closed && !component.consistently_wound);
    assert_eq!(component.outward, None);
}

#[test]
fn a_sheet_with_a_back_has_no_certain_side() {
    let mesh = Mesh {
        vertices: vec![[0.0, 0.0, 0.1], [1.0, 0.0, 0.2], [0.0, 2.0, 0.7]],
        indices: vec![[0, 1, 2], [2, 1, 0]],
        ..Mesh::default()
    };
    let analysis = analyze(&mesh);
    assert!(analysis.components[0].closed);
    assert_eq!(analysis.components[0].outward, None);
    assert_eq!(analysis.duplicate_triangle_count, 1);
}

#[test]
fn duplicates_count_beyond_the_first_in_any_rotation_and_winding() {
    let mut mesh = unweld(&cuboid([0.0; 3]));
    let [a, b, c] = mesh.indices[3];
    mesh.indices.extend([[b, c, a], [c, b, a], [a, b, c]]);
    assert_eq!(analyze(&mesh).duplicate_triangle_count, 3);
    assert_eq!(analyze(&mesh).degenerate_triangle_count, 0);
}

#[test]
fn degenerate_triangles_are_counted_and_leave_a_solid_closed() {
    let mut mesh = cuboid([0.0; 3]);
    // Equal indices, equal positions, three points on a line, and one point.
    mesh.vertices.push([0.0, 0.0, 0.0]);
    mesh.vertices.push([0.5, 1.0, 1.5]);
    mesh.indices
        .extend([[1, 1, 3], [0, 8, 4], [0, 9, 7], [8, 0, 8]]);
    let analysis = analyze(&mesh);
    assert_eq!(analysis.degenerate_triangle_count, 4);
    assert_eq!(analysis.components.len(), 2);
    assert_eq!(analysis.components[0].triangle_count, 14);
    assert_eq!(analysis.components[0].outward, Some(true));
}

#[test]
fn unused_vertices_do_not_matter() {
    let mut mesh = cuboid([0.0; 3]);
    mesh.vertices.push([f32::NAN, f32::INFINITY, 1e30]);
    let analysis = analyze(&mesh);
    assert_eq!(
        (analysis.vertex_count, analysis.welded_vertex_count),
        (9, 8)
    );
    assert_eq!(
        analysis.bounds.map(|b| b.max.to_array()),
        Some([1.0, 2.0, 3.0])
    );
}

#[test]
fn far_and_tiny_solids_keep_their_sign() {
    let far = analyze(&cuboid([1e6, -3e6, 2e6]));
    assert_eq!(far.components[0].signed_volume, 6.0);
    let mut tiny = cuboid([0.0; 3]);
    for vertex in &mut tiny.vertices {
        *vertex = vertex.map(|x| x * 1e-40);
    }
    assert_eq!(analyze(&tiny).components[0].outward, Some(true));
    assert_eq!(analyze(&tiny).degenerate_triangle_count, 0);
}
