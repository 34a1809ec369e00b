//! Pictures of realised complexes: a still, a page in which they turn, and the same as files for other programs.

pub mod page;
pub mod scene;
pub mod still;

use crate::complex::realise::Realised;
use crate::format::{
    FormatError, MeshRecord, Precision, Problem, TetrahedraRecord, at, create, extension, gltf, msh, ply,
    unknown_extension, vtu,
};
use scene::Scene;
use std::io::Write;
use std::path::Path;

/// What a picture shows beside the placement.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Paint {
    /// What it is a picture of.
    pub title: String,
    /// The group of each tetrahedron, which chooses its colour; 0 where the list ends early.
    pub groups: Vec<u32>,
    /// What the groups are called; the legend leaves out those without a name.
    pub names: Vec<String>,
    /// Lines drawn strongly, such as the edges of the complex that was refined, by their ends. Those with an end that does
    /// not exist are left out.
    pub lines: Vec<[u32; 2]>,
}

/// The extensions that [`write()`] knows.
pub const EXTENSIONS: &str = "ply, vtu, gltf, msh, svg, html";

/// Writes a realised complex as the extension says: `.ply` its triangles in ℝ³; `.vtu` and `.msh` its tetrahedra with their
/// groups, and the lines (VTU with the coordinates in ℝⁿ too); `.gltf` the tetrahedra drawn apart, and the lines; `.svg` a still;
/// `.html` a page in which it turns.
///
/// # Errors
/// Iff the extension is another one, or the file cannot be written.
pub fn write(path: &Path, realised: &Realised, paint: &Paint) -> Result<(), FormatError> {
    let text = |text: String| create(path, |out| Ok::<(), Problem>(out.write_all(text.as_bytes())?));
    at(path, || match extension(path).as_str() {
        "ply" => create(path, |out| ply::write(out, &triangles(realised), ply::Encoding::Binary)),
        "vtu" => create(path, |out| vtu::write(out, &tetrahedra(realised, paint))),
        "msh" => create(path, |out| msh::write(out, &tetrahedra(realised, paint))),
        "gltf" => create(path, |out| gltf::write(out, &Scene::of(realised, paint).parts())),
        "svg" => text(still::still(&Scene::of(realised, paint))),
        "html" => text(page::page(&Scene::of(realised, paint))),
        _ => Err(unknown_extension(path, EXTENSIONS)),
    })
}

/// The triangles of all tetrahedra, each once, in ℝ³.
pub fn triangles(realised: &Realised) -> MeshRecord {
    MeshRecord {
        vertices: realised.positions.clone(),
        faces: realised.mesh.triangles().iter().map(|t| t.to_vec()).collect(),
        precision: Precision::Binary64,
        soup: false,
    }
}

/// The tetrahedra and the lines.
pub fn tetrahedra(realised: &Realised, paint: &Paint) -> TetrahedraRecord {
    TetrahedraRecord {
        vertices: realised.positions.clone(),
        dimension: realised.points.dimension(),
        coordinates: realised.points.coordinates().to_vec(),
        tetrahedra: realised.mesh.tetrahedra().to_vec(),
        groups: scene::groups(realised, paint),
        lines: scene::lines(realised, paint),
    }
}
