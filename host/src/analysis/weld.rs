//! Welding: vertices of equal position.

/// A number for each vertex, below the number of vertices. Two numbers are equal exactly if the positions are. Numbers
/// follow the first vertex of each position. -0 equals +0; a NaN equals a NaN with the same bits.
#[must_use]
pub fn weld(vertices: &[[f32; 3]]) -> Vec<u32> {
    // Sort positions together with the vertex: x (32 bits) | y (32) | z (32) | vertex (32).
    let mut keys: Vec<u128> = (0_u32..)
        .zip(vertices)
        .map(|(vertex, position)| {
            let bits = position
                .iter()
                .fold(0, |bits, &x| bits << 32 | u128::from((x + 0.0).to_bits()));
            bits << 32 | u128::from(vertex)
        })
        .collect();
    keys.sort_unstable();

    // The first of each run represents it.
    let mut ids = vec![0; vertices.len()];
    for run in keys.chunk_by(|a, b| a >> 32 == b >> 32) {
        for &key in run {
            ids[key as u32 as usize] = run[0] as u32;
        }
    }

    // Close the gaps between the firsts.
    let mut count = 0;
    for vertex in 0..ids.len() {
        let first = ids[vertex] as usize;
        ids[vertex] = if first == vertex {
            count += 1;
            count - 1
        } else {
            ids[first]
        };
    }
    ids
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_positions_get_one_number() {
        let vertices = [
            [3.0, 0.0, 1.0],
            [1.0, -0.0, 2.0],
            [3.0, -0.0, 1.0],
            [1.0, 0.0, 2.0],
            [1.0, 1e-45, 2.0],
        ];
        assert_eq!(weld(&vertices), [0, 1, 0, 1, 2]);
        assert!(weld(&[]).is_empty());
    }
}
