//! Planting a defect in a sound mesh. Others may come with it; whether it is there is the oracle's to say.

use super::bases::{beside, projective_plane};
use super::questions::Question;
use crate::linear::Vector;
use crate::mesh::defects::ListedEdges;
use crate::mesh::examples::point;
use crate::mesh::face::Face;
use crate::mesh::vertex_list::{Point, VertexList};
use crate::number::Rational;
use rand::Rng;
use rand_chacha::ChaCha8Rng;

/// Tries to give the mesh a defect of that category.
pub fn plant(random: &mut ChaCha8Rng, question: &mut Question, category: &str) {
    let mesh = &mut question.mesh;
    let f = random.random_range(0..mesh.faces.len());
    let length = mesh.faces[f].outer.len();
    let i = random.random_range(0..length);
    let [a, b] = [mesh.faces[f].outer[i], mesh.faces[f].outer[(i + 1) % length]];
    match category {
        "index_out_of_range" => mesh.faces[f].outer[i] = mesh.vertices.len() as u32 + random.random_range(0..3),
        "face_lt3_vertices" => {
            let short = [vec![], vec![a], vec![a, b]][random.random_range(0..3)].clone();
            mesh.faces.push(Face::new(short));
        }
        "repeated_vertex_in_loop" => mesh.faces[f].outer.push(b),
        "degenerate_edge_same_index" => mesh.faces[f].outer.insert(i, a),
        "zero_length_edge" => mesh.vertices[a as usize] = mesh.vertices[b as usize].clone(),
        "boundary_edge" => drop(mesh.faces.remove(f)),
        "edge_used_gt2" | "edge_odd_use" => {
            let tips = if category == "edge_odd_use" { 1 } else { random.random_range(1..3) };
            for _ in 0..tips {
                let tip = add(mesh, at(random));
                mesh.faces.push(Face::from([a, b, tip]));
            }
        }
        "edge_twice_in_same_face" | "vertex_lt2_edges" => {
            // A spike out of a corner and back.
            let tip = add(mesh, at(random));
            mesh.faces[f].outer.splice(i..=i, [a, tip, a]);
        }
        "inconsistent_winding_edge" => mesh.faces[f] = mesh.faces[f].reversed(),
        "isolated_vertex" => drop(add(mesh, at(random))),
        "duplicate_vertex_position" => {
            let twin = add(mesh, mesh.vertices[a as usize].clone());
            if random.random() {
                mesh.faces[f].outer[i] = twin;
            }
        }
        "duplicate_face" => {
            let mut twin = if random.random() { mesh.faces[f].clone() } else { mesh.faces[f].reversed() };
            twin.outer.rotate_left(i);
            mesh.faces.push(twin);
        }
        "zero_area_face" | "t_junction" => {
            // A vertex inside a side of one of its two faces.
            let middle = between(random, &mesh.vertices[a as usize], &mesh.vertices[b as usize]);
            let middle = add(mesh, middle);
            mesh.faces[f].outer.insert(i + 1, middle);
            if category == "zero_area_face" {
                mesh.faces.push(Face::from([a, b, middle]));
            }
        }
        "nonplanar_face" => {
            let axis = random.random_range(0..3);
            let amounts = [Rational::from(1), Rational::from((1, 1_000_000_000_000_000i64))];
            mesh.vertices[a as usize].0[axis] += &amounts[random.random_range(0..2)];
        }
        "zero_signed_area_face" | "self_crossing_loop" => mesh.faces[f].outer.swap(i, (i + 1) % length),
        "nonmanifold_vertex" => {
            // A tetrahedron at a vertex that it shares.
            let tips = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|tip| point(tip) + &mesh.vertices[a as usize]);
            let [b, c, d] = tips.map(|tip| add(mesh, tip));
            mesh.faces.extend([[a, c, b], [a, b, d], [b, c, d], [a, d, c]].map(Face::from));
        }
        "non_orientable" => {
            let plane = projective_plane();
            *mesh = if random.random() { plane } else { beside(mesh, &plane) };
        }
        "inside_out" => mesh.faces.iter_mut().for_each(|face| *face = face.reversed()),
        "zero_volume" => {
            // Both sides of one face.
            let mut kept = mesh.faces.swap_remove(f);
            kept.holes.clear();
            mesh.faces = vec![kept.reversed(), kept];
            drop_unused(mesh);
        }
        "hole_same_sense_as_outer" => {
            if let Some(hole) = mesh.faces.iter_mut().find_map(|face| face.holes.first_mut()) {
                hole.reverse();
            }
        }
        "edge_unreferenced" | "edge_missing_from_list" | "duplicate_edge_record" | "edge_face_not_reciprocal" => {
            plant_in_list(random, question, category);
        }
        other => unreachable!("no category {other}"),
    }
}

fn plant_in_list(random: &mut ChaCha8Rng, question: &mut Question, category: &str) {
    let count = question.mesh.vertices.len() as u32;
    let face_count = question.mesh.faces.len() as u32;
    let Some(listed) = &question.listed else { return };
    let mut edges = listed.edges().to_vec();
    let mut faces = listed.faces().unwrap_or_default().to_vec();
    let e = random.random_range(0..edges.len());
    match category {
        "edge_unreferenced" => {
            let a = random.random_range(0..count);
            edges.push([a, (a + random.random_range(1..count)) % count]);
            faces.push(Vec::new());
        }
        "edge_missing_from_list" => {
            edges.remove(e);
            faces.remove(e);
        }
        "duplicate_edge_record" => {
            let [a, b] = edges[e];
            edges.push(if random.random() { [a, b] } else { [b, a] });
            faces.push(faces[e].clone());
        }
        _ => match random.random_range(0..3) {
            0 => drop(faces[e].pop()),
            1 => faces[e].push(random.random_range(0..face_count)),
            _ => faces[e][0] = random.random_range(0..face_count),
        },
    }
    question.listed = Some(ListedEdges::new(edges, Some(faces)).expect("one list of faces for each edge"));
}

fn add(mesh: &mut VertexList, position: Point) -> u32 {
    mesh.vertices.push(position);
    mesh.vertices.len() as u32 - 1
}

fn at(random: &mut ChaCha8Rng) -> Point {
    Vector([(); 3].map(|()| Rational::from((random.random_range(-99..=99), random.random_range(1..=7)))))
}

/// A point strictly between two.
fn between(random: &mut ChaCha8Rng, a: &Point, b: &Point) -> Point {
    let share = Rational::from((random.random_range(1..=6), 7));
    (b.clone() - a).scaled(&share) + a
}

/// Leaves out the vertices that no face uses.
pub fn drop_unused(mesh: &mut VertexList) {
    let mut number = vec![None; mesh.vertices.len()];
    let mut kept = Vec::new();
    for v in mesh.faces.iter().flat_map(|face| face.vertices().collect::<Vec<_>>()) {
        if let Some(slot @ None) = number.get_mut(v as usize) {
            *slot = Some(kept.len() as u32);
            kept.push(mesh.vertices[v as usize].clone());
        }
    }
    let renumber = |l: &mut Vec<u32>| {
        for v in l {
            *v = number.get(*v as usize).copied().flatten().unwrap_or(*v);
        }
    };
    for face in &mut mesh.faces {
        renumber(&mut face.outer);
        face.holes.iter_mut().for_each(renumber);
    }
    mesh.vertices = kept;
}
