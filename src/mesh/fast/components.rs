//! The connected components of a mesh, each as a surface.

use super::Found;
use super::polygons::Polygons;
use super::report::Component;
use crate::mesh::triangles::EdgeKey;
use crate::partition::Partition;

/// The components, those of most faces first. Vertices are joined by faces; an empty face belongs to none. ME-153.
///
/// χ = V − E + F = 2 − 2·genus − loops, for an orientable surface whose boundary has so many loops: where every edge has at
/// most two uses, every vertex one fan, no loop is broken, and its faces are wound consistently.
#[doc(alias = "ME-153")]
pub(super) fn components(
    mesh: &Polygons,
    used: &[bool],
    edges: &[EdgeKey],
    found: &Found,
    orientable: bool,
) -> Vec<Component> {
    let mut joined = Partition::new(mesh.vertices().len());
    for [a, b] in edges {
        joined.join(*a as usize, *b as usize);
    }
    // Numbers of the components, by representative.
    let mut number = vec![u32::MAX; mesh.vertices().len()];
    let mut components: Vec<Component> = Vec::new();
    for vertex in (0..used.len()).filter(|&v| used[v]) {
        let number = &mut number[joined.find(vertex)];
        if *number == u32::MAX {
            *number = components.len() as u32;
            components.push(Component { faces: 0, vertices: 0, edges: 0, boundary_loops: 0, genus: None });
        }
        components[*number as usize].vertices += 1;
    }
    let mut of = |vertex: u32| number[joined.find(vertex as usize)] as usize;
    for [a, _] in edges {
        components[of(*a)].edges += 1;
    }
    for face in mesh.loops() {
        if let Some(&vertex) = face.first() {
            components[of(vertex)].faces += 1;
        }
    }
    let mut curves = Partition::new(if found.boundary.is_empty() { 0 } else { mesh.vertices().len() });
    for [a, b] in &found.boundary {
        if !curves.join(*a as usize, *b as usize) {
            components[of(*a)].boundary_loops += 1;
        }
    }
    let mut sound = vec![orientable; components.len()];
    let at_edges = [&found.gt2, &found.twice, &found.inconsistent].into_iter().flatten().map(|edge| edge[0]);
    let at_faces = [&found.lt3, &found.repeated, &found.degenerate].into_iter().flatten();
    let at_faces = at_faces.filter_map(|&face| mesh.face(face as usize).first().copied());
    for vertex in at_edges.chain(at_faces).chain(found.nonmanifold.iter().copied()) {
        sound[of(vertex)] = false;
    }
    for (component, sound) in components.iter_mut().zip(sound) {
        let chi = component.vertices as i64 - component.edges as i64 + component.faces as i64;
        component.genus = sound.then_some((2 - chi - component.boundary_loops as i64) / 2);
    }
    components.sort_unstable_by(|a, b| b.cmp(a));
    components
}
