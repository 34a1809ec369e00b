//! Every operation on every structure, on a torus of 50 × 50 quadrilaterals; and how long each structure takes to make.

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use isoracle::mesh::edge_list::EdgeList;
use isoracle::mesh::examples::{point, quad_torus};
use isoracle::mesh::explicit::ExplicitList;
use isoracle::mesh::half_edge::HalfEdges;
use isoracle::mesh::operations::Operations;
use isoracle::mesh::vertex_list::VertexList;
use isoracle::mesh::winged_edge::WingedEdges;
use std::hint::black_box;

const SIDE: u32 = 50;
const VERTEX: u32 = 1234;
const FACE: usize = 1234;

fn operations<M: Operations + Clone>(criterion: &mut Criterion, name: &str, mesh: &M, vertex: &M::Vertex) {
    let mut group = criterion.benchmark_group(format!("mesh/{name}"));
    let edge = &mesh.edges_at(vertex).expect("the vertex is there").answer[0];
    let bench = |group: &mut BenchmarkGroup<WallTime>, name: &str, operation: &dyn Fn(&M) -> u64| {
        group.bench_function(name, |bencher| bencher.iter(|| operation(black_box(mesh))));
    };
    bench(&mut group, "polygons", &|mesh| mesh.polygons().expect("sound").reads);
    bench(&mut group, "segments", &|mesh| mesh.segments().expect("sound").reads);
    bench(&mut group, "edges_at", &|mesh| mesh.edges_at(vertex).expect("sound").reads);
    bench(&mut group, "ends", &|mesh| mesh.ends(edge).expect("sound").reads);
    bench(&mut group, "faces_of_edge", &|mesh| mesh.faces_of_edge(edge).expect("sound").reads);
    bench(&mut group, "faces_at", &|mesh| mesh.faces_at(vertex).expect("sound").reads);
    bench(&mut group, "adjacent_faces", &|mesh| mesh.adjacent_faces(FACE).expect("sound").reads);
    bench(&mut group, "boundary_edges", &|mesh| mesh.boundary_edges().expect("sound").reads);
    bench(&mut group, "unused_vertices", &|mesh| mesh.unused_vertices().expect("sound").reads);
    // To its own place, so that the name stays good.
    let mut moved = mesh.clone();
    let [i, j] = [VERTEX / SIDE, VERTEX % SIDE];
    let place = point([i, j, i * j].map(i64::from));
    group.bench_function("move_vertex", |bencher| {
        bencher.iter(|| moved.move_vertex(black_box(vertex), place.clone()).expect("sound").reads);
    });
}

fn all(criterion: &mut Criterion) {
    let list = quad_torus(SIDE, SIDE);
    let explicit = ExplicitList::try_from(&list).expect("sound");
    let edges = EdgeList::try_from(&list).expect("sound");
    let wings = WingedEdges::try_from(&edges).expect("sound");
    operations(criterion, "explicit", &explicit, &list.vertices[VERTEX as usize]);
    operations(criterion, "vertex_list", &list, &VERTEX);
    operations(criterion, "edge_list", &edges, &VERTEX);
    operations(criterion, "winged_edge", &wings, &VERTEX);
    operations(criterion, "half_edge", &HalfEdges::from(&wings), &VERTEX);

    let mut group = criterion.benchmark_group("mesh/make");
    group.bench_function("explicit", |bencher| bencher.iter(|| ExplicitList::try_from(black_box(&list))));
    group.bench_function("vertex_list", |bencher| bencher.iter(|| VertexList::from(black_box(&explicit))));
    group.bench_function("edge_list", |bencher| bencher.iter(|| EdgeList::try_from(black_box(&list))));
    group.bench_function("winged_edge", |bencher| bencher.iter(|| WingedEdges::try_from(black_box(&edges))));
    group.bench_function("half_edge", |bencher| bencher.iter(|| HalfEdges::from(black_box(&wings))));
}

criterion_group!(benches, all);
criterion_main!(benches);
