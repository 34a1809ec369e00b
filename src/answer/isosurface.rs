//! The operations of the family `isosurface`.

use super::mesh::MeshOut;
use super::message::{Out, Refusal};
use super::value::{self, Exact, InvalidField, Object, Problem};
use super::volume;
use crate::isosurface::cell::{self, Side, Tie};
use crate::isosurface::cube::{Corner, Edge};
use crate::isosurface::polyline::{self, Raster};
use crate::isosurface::square::{self, SquareCorner, SquareEdge};
use crate::isosurface::tetrahedra::{self, Decomposition};
use crate::isosurface::volume::{Level, Volume};
use crate::isosurface::{mesh, topology, triangle};
use serde::Serialize;

#[derive(Serialize)]
struct SquareOut {
    saddle: Option<SaddleOut>,
    determinant_sign: i8,
    segments: Vec<[[usize; 2]; 2]>,
    crossings: Vec<CrossingOut>,
}

#[derive(Serialize)]
struct SaddleOut {
    u: Exact,
    v: Exact,
    value: Exact,
}

#[derive(Serialize)]
struct CrossingOut {
    edge: [usize; 2],
    t: Exact,
}

/// `isosurface.square` in `{values:[g00,g10,g01,g11], isovalue, tie?}`.
pub fn square(input: &Object) -> Result<Out, Refusal> {
    let values = value::field(input, "values", value::numbers)?;
    let isovalue = value::field(input, "isovalue", value::number)?;
    let contour = square::contour(&values, &isovalue, tie(input)?)?;
    let ends = |edge: SquareEdge| edge.corners().map(SquareCorner::index);
    let saddle =
        contour.saddle.map(|saddle| SaddleOut { u: Exact(saddle.u), v: Exact(saddle.v), value: Exact(saddle.value) });
    let crossings = contour.crossings.into_iter();
    Ok(Out::new(&SquareOut {
        saddle,
        determinant_sign: contour.determinant_sign.value(),
        segments: contour.segments.into_iter().map(|segment| segment.map(ends)).collect(),
        crossings: crossings.map(|c| CrossingOut { edge: ends(c.edge), t: Exact(c.t) }).collect(),
    }))
}

#[derive(Serialize)]
struct CellOut {
    case: &'static str,
    faces: [i8; 6],
    loops: Vec<Vec<[usize; 2]>>,
    components: Vec<ComponentOut>,
    chi: i64,
    b0_neg: usize,
    b0_pos: usize,
    b1_neg: i64,
    b1_pos: i64,
    neg_parts: Vec<Vec<usize>>,
    pos_parts: Vec<Vec<usize>>,
}

#[derive(Serialize)]
struct ComponentOut {
    loops: Vec<usize>,
    chi: i64,
    genus: i64,
}

/// `isosurface.cell` in `{values:[8], isovalue, tie?}`.
pub fn cell(input: &Object) -> Result<Out, Refusal> {
    let values = value::field(input, "values", value::numbers)?;
    let isovalue = value::field(input, "isovalue", value::number)?;
    let topology = cell::topology(&values, &isovalue, tie(input)?)?;
    Ok(Out::new(&CellOut {
        chi: topology.chi(),
        case: topology.case.name(),
        faces: topology.decisions.faces,
        loops: topology.loops.iter().map(|cycle| cycle.iter().map(corner_pair).collect()).collect(),
        components: topology
            .components
            .into_iter()
            .map(|component| ComponentOut { loops: component.loops, chi: component.chi, genus: component.genus })
            .collect(),
        b0_neg: topology.negative.parts.len(),
        b0_pos: topology.positive.parts.len(),
        b1_neg: topology.negative.b1,
        b1_pos: topology.positive.b1,
        neg_parts: parts(&topology.negative),
        pos_parts: parts(&topology.positive),
    }))
}

fn corner_pair(edge: &Edge) -> [usize; 2] {
    edge.corners().map(Corner::index)
}

fn parts(side: &Side) -> Vec<Vec<usize>> {
    side.parts.iter().map(|part| part.iter().map(|corner| corner.index()).collect()).collect()
}

#[derive(Serialize)]
struct TopologyOut {
    chi: i64,
    components: usize,
    boundary_loops: i64,
    b0_neg: usize,
    b0_pos: usize,
    edge_crossings: usize,
    component_list: Vec<[i64; 3]>,
}

/// `isosurface.topology` in `{volume, isovalue, tie?}`.
pub fn topology(input: &Object) -> Result<Out, Refusal> {
    let volume = value::field(input, "volume", volume::read)?;
    let topology = topology::topology(&level(input, &volume)?)?;
    Ok(Out::new(&TopologyOut {
        chi: topology.chi(),
        components: topology.components.len(),
        boundary_loops: topology.boundary_loops(),
        b0_neg: topology.b0_negative,
        b0_pos: topology.b0_positive,
        edge_crossings: topology.edge_crossings,
        component_list: topology.components.iter().map(|c| [c.chi, c.boundary_loops, c.genus]).collect(),
    }))
}

/// `isosurface.mesh` in `{volume, isovalue, tie?}`.
pub fn mesh(input: &Object) -> Result<Out, Refusal> {
    let volume = value::field(input, "volume", volume::read)?;
    let level = level(input, &volume)?;
    Ok(Out::new(&MeshOut::of(&mesh::extract(&level)?, &level)))
}

#[derive(Serialize)]
struct PolylineOut {
    vertices: Vec<[Exact; 2]>,
    segments: Vec<[u32; 2]>,
}

#[derive(Clone, Copy)]
enum Method {
    Squares,
    Triangles,
}

/// `isosurface.polyline` in `{shape:[nx,ny], values, isovalue, method:"squares"|"triangles", tie?}`.
pub fn polyline(input: &Object) -> Result<Out, Refusal> {
    let words = [("squares", Method::Squares), ("triangles", Method::Triangles)];
    let method = value::field(input, "method", |m| value::word(m, "\"squares\" or \"triangles\"", &words))?;
    let shape = value::field(input, "shape", value::shape)?;
    let values = value::field(input, "values", |values| value::items(values, value::number))?;
    let isovalue = value::field(input, "isovalue", value::number)?;
    let raster = Raster::new(shape, values).map_err(|error| InvalidField::here(Problem::Raster(error)))?;
    let polyline = match method {
        Method::Squares => polyline::squares(&raster, &isovalue, tie(input)?)?,
        Method::Triangles => triangle::triangles(&raster, &isovalue, tie(input)?)?,
    };
    Ok(Out::new(&PolylineOut {
        vertices: polyline.vertices.into_iter().map(|position| position.map(Exact)).collect(),
        segments: polyline.segments,
    }))
}

/// `isosurface.tetrahedra` in `{volume, isovalue, tie?}`: six Kuhn tetrahedra a cell, around the diagonal from
/// corner 0 to corner 7.
pub fn tetrahedra(input: &Object) -> Result<Out, Refusal> {
    let volume = value::field(input, "volume", volume::read)?;
    let level = level(input, &volume)?;
    let mesh = tetrahedra::extract(&level, Decomposition::default())?;
    Ok(Out::new(&MeshOut::of_tetrahedra(&mesh, &level)))
}

fn level<'a>(input: &Object, volume: &'a Volume) -> Result<Level<'a>, InvalidField> {
    Ok(Level { volume, isovalue: value::field(input, "isovalue", value::number)?, tie: tie(input)? })
}

/// A tie is degenerate, unless the question says `"tie":"below"`.
fn tie(input: &Object) -> Result<Tie, InvalidField> {
    let tie = value::optional(input, "tie", |tie| value::word(tie, "\"below\"", &[("below", Tie::Below)]))?;
    Ok(tie.unwrap_or_default())
}
