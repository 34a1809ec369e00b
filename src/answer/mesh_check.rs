//! The operations `mesh.check` and `mesh.plane`.

use super::message::{Out, Refusal};
use super::value::{self, Exact, InvalidField, Object, Problem, Step};
use crate::format;
use crate::linear::Vector;
use crate::mesh::defects::{self, Counts, Element, ListedEdges};
use crate::mesh::face::Face;
use crate::mesh::plane::{Plane, Span, span};
use crate::mesh::vertex_list::{Point, VertexList};
use crate::number::binary::from_f64;
use crate::number::{Integer, Rational};
use serde::{Serialize, Serializer};
use serde_json::{Map, Value};
use std::path::Path;

/// `mesh.check` in `{vertices, faces, holes?, edges?, edge_faces?}`, or `{file, …}`.
///
/// Ill-posed: a field of another type, a hole of a face that does not exist, an edge of other than two vertex numbers,
/// `edge_faces` without `edges` or of another length. Everything else has an answer; numbers in loops that are no vertex's,
/// negative ones too, are the defect `index_out_of_range`.
pub fn check(input: &Object) -> Result<Out, Refusal> {
    let mesh = mesh(input)?;
    let listed = listed_edges(input)?;
    let report = defects::check(&mesh, listed.as_ref());
    let defects: Map<String, Value> = report
        .defects
        .iter()
        .map(|(category, elements)| (category.name().to_owned(), elements.iter().map(element).collect()))
        .collect();
    Ok(Out::new(&CheckOut { defects, counts: report.counts.map(CountsOut) }))
}

#[derive(Serialize)]
struct CheckOut {
    defects: Map<String, Value>,
    counts: Option<CountsOut>,
}

fn element(element: &Element) -> Value {
    match element {
        Element::Mesh => Value::from(true),
        Element::Vertex(v) => Value::from(*v),
        Element::Vertices(vertices) => Value::from(vertices.clone()),
        Element::Edge(edge) => Value::from(edge.to_vec()),
        Element::VertexInEdge(v, edge) => Value::from(vec![Value::from(*v), Value::from(edge.to_vec())]),
        Element::Face(i) | Element::Record(i) => Value::from(*i),
        Element::Faces(faces) => Value::from(faces.clone()),
    }
}

/// The numbers of a mesh, by the symbols of χ = V − E + F − H = 2(C − G).
pub(super) struct CountsOut(pub Counts);

impl Serialize for CountsOut {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeMap;
        let Counts { vertices, edges, faces, holes, components, chi, genus, closed, orientable, manifold, volume } =
            &self.0;
        let mut map = serializer.serialize_map(Some(11))?;
        for (name, count) in [("V", vertices), ("E", edges), ("F", faces), ("H", holes), ("C", components)] {
            map.serialize_entry(name, count)?;
        }
        map.serialize_entry("chi", chi)?;
        map.serialize_entry("G", genus)?;
        for (name, fact) in [("closed", closed), ("orientable", orientable), ("manifold", manifold)] {
            map.serialize_entry(name, fact)?;
        }
        map.serialize_entry("volume", &volume.clone().map(Exact))?;
        map.end()
    }
}

/// The mesh of `{vertices, faces, holes?}`, or `{file, holes?}`.
///
/// # Errors
/// The field that cannot be read.
pub fn mesh(input: &Object) -> Result<VertexList, InvalidField> {
    let mut mesh = match value::optional(input, "file", |file| value::string(file).map(str::to_owned))? {
        None => VertexList {
            vertices: value::field(input, "vertices", |list| value::items(list, point))?,
            faces: value::field(input, "faces", |list| value::items(list, |face| numbers(face).map(Face::new)))?,
        },
        Some(_) if input.contains_key("vertices") => {
            return Err(InvalidField::here(Problem::BesideFile).within(Step::Field("vertices")));
        }
        Some(file) => from_file(Path::new(&file)).map_err(|error| error.within(Step::Field("file")))?,
    };
    value::optional(input, "holes", |holes| {
        for (key, loops) in value::object(holes)? {
            let face = face_number(key)?;
            let loops = value::items(loops, numbers).map_err(|error| error.within(Step::Key(face)))?;
            match mesh.faces.get_mut(face) {
                Some(face) => face.holes = loops,
                None => {
                    let problem = Problem::NoSuchFace { faces: mesh.faces.len() };
                    return Err(InvalidField::here(problem).within(Step::Key(face)));
                }
            }
        }
        Ok(())
    })?;
    Ok(mesh)
}

/// The mesh in a file, each binary64 of it exactly.
fn from_file(path: &Path) -> Result<VertexList, InvalidField> {
    let record = format::read_mesh(path).map_err(|error| InvalidField::here(Problem::File(Box::new(error))))?;
    let exact = |(v, point): (usize, [f64; 3])| match point.map(from_f64) {
        [Ok(x), Ok(y), Ok(z)] => Ok(Vector([x, y, z])),
        _ => Err(InvalidField::here(Problem::NotFinite { vertex: v })),
    };
    let vertices = record.vertices.into_iter().enumerate().map(exact).collect::<Result<_, _>>()?;
    Ok(VertexList { vertices, faces: record.faces.into_iter().map(Face::new).collect() })
}

fn point(value: &Value) -> Result<Point, InvalidField> {
    value::numbers(value).map(Vector)
}

/// A list of integers as numbers of vertices or faces. What can be no number of one becomes the greatest `u32`, which is none
/// either.
fn numbers(value: &Value) -> Result<Vec<u32>, InvalidField> {
    value::items(value, |item| integer(item).map(|n| n.to_u32().unwrap_or(u32::MAX)))
}

fn integer(value: &Value) -> Result<Integer, InvalidField> {
    match value::number(value)? {
        n if n.is_integer() => Ok(n.into_numer_denom().0),
        n => Err(InvalidField::here(Problem::Integer(n))),
    }
}

/// A key of `holes`: a face number as JSON writes it.
fn face_number(key: &str) -> Result<usize, InvalidField> {
    let face = key.parse::<usize>().ok().filter(|face| face.to_string() == key);
    face.ok_or_else(|| {
        InvalidField::here(Problem::Word { expected: "face numbers as keys", found: key.chars().take(40).collect() })
    })
}

/// The edge list of `{edges?, edge_faces?}`.
///
/// # Errors
/// The field that cannot be read.
pub fn listed_edges(input: &Object) -> Result<Option<ListedEdges>, InvalidField> {
    let ends = |value: &Value| value::exactly(value, vertex_number);
    let edges = value::optional(input, "edges", |list| value::items(list, ends))?;
    let faces = value::optional(input, "edge_faces", |list| value::items(list, numbers))?;
    match (edges, faces) {
        (None, None) => Ok(None),
        (None, Some(_)) => Err(InvalidField::here(Problem::Missing).within(Step::Field("edges"))),
        (Some(edges), faces) => ListedEdges::new(edges, faces).map(Some).map_err(|error| {
            let problem = Problem::Length { expected: error.expected, found: error.found };
            InvalidField::here(problem).within(Step::Field("edge_faces"))
        }),
    }
}

/// A number that a vertex could have.
fn vertex_number(value: &Value) -> Result<u32, InvalidField> {
    let n = integer(value)?;
    n.to_u32().ok_or_else(|| InvalidField::here(Problem::VertexNumber(n.into())))
}

#[derive(Serialize)]
struct PlaneOut {
    normal: [Exact; 3],
    offset: Exact,
    planar: bool,
    worst_distance_squared: Exact,
}

/// The polygon of `{polygon:[[x,y,z],…]}`, of three vertices at least.
///
/// # Errors
/// The field that cannot be read.
pub fn polygon(input: &Object) -> Result<Vec<Point>, InvalidField> {
    value::field(input, "polygon", |list| match value::items(list, point)? {
        polygon if polygon.len() < 3 => Err(InvalidField::here(Problem::FewVertices { found: polygon.len() })),
        polygon => Ok(polygon),
    })
}

/// `mesh.plane` in `{polygon:[[x,y,z],…]}`: A x + B y + C z = `offset`, of least squares, (A, B, C) the projected areas.
///
/// Ill-posed: fewer than 3 vertices. Degenerate: (A, B, C) = 0.
pub fn plane(input: &Object) -> Result<Out, Refusal> {
    let polygon = polygon(input)?;
    let plane = Plane::of_polygon(&polygon).map_err(Refusal::NoPlane)?;
    let worst = polygon.iter().map(|vertex| plane.distance_squared(vertex)).max();
    Ok(Out::new(&PlaneOut {
        normal: plane.normal().clone().0.map(Exact),
        offset: Exact(plane.offset().clone()),
        planar: match span(&polygon) {
            Span::Empty | Span::Point | Span::Line | Span::Plane(_) => true,
            Span::Space => false,
        },
        worst_distance_squared: Exact(worst.unwrap_or_else(Rational::new)),
    }))
}
