use super::domain::*;
use isoracle::complex::examples::*;
use isoracle::complex::realise::intersections::intersections;
use isoracle::complex::realise::{Options, realise};
#[test]
fn trial() {
    let go = |name: &str, mesh: &isoracle::complex::realise::mesh::TetrahedralMesh, n: usize| {
        let start = std::time::Instant::now();
        let r = realise(mesh, &Options { dimension: n, ..Options::default() }).unwrap();
        println!(
            "{name} R{n}: V {} T {}; E {} -> {} in {} steps; lengths {:?}; flat {} pairs {}/{}; {:?} {:?}",
            mesh.vertices(),
            mesh.tetrahedra().len(),
            r.energies[0],
            r.energies.last().unwrap(),
            r.energies.len() - 1,
            r.lengths,
            r.intersections.flat,
            r.intersections.pairs,
            r.intersections.tested,
            r.intersections.witness,
            start.elapsed()
        );
    };
    for n in [4] {
        go("simplex", &simplex_boundary(), n);
        go("16cell", &cross_polytope(), n);
        go("T3 4", &grid_torus([4, 4, 4]), n);
        if false {
            go("T3 6", &grid_torus([6, 6, 6]), n);
            go("T3 twice", &twice(three_torus()), n);
            go("L(5,2) twice", &twice(lens_space(5, 2)), n);
        }
    }
    let s = [10, 10, 16];
    let i = intersections(&grid_torus(s), &torus_of_revolution(s, [1.0, 2.2, 5.0]));
    println!("{i:?}");
}
