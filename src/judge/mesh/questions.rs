//! The questions of the suite `mesh`: the same seed, the same questions.

use super::bases;
use super::has_defect;
use super::plant::plant;
use crate::answer::value::{self, InvalidField, Object, Problem, Step};
use crate::linear::Vector;
use crate::mesh::face::{Face, edge};
use crate::mesh::vertex_list::{Point, VertexList};
use crate::number::Rational;
use crate::number::text::exact_text;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, BTreeSet};

/// A row of the report's tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Row {
    /// Meshes without defects.
    Sound,
    /// Meshes with at least this defect.
    Defect(&'static str),
    /// A few random faces over a few vertices.
    Random,
    /// Planes of polygons.
    Planes,
    /// Angle deficits of triangle meshes.
    Angles,
}

/// The categories of `mesh.check`, in the order of the rules.
pub const CATEGORIES: [&str; 28] = [
    "index_out_of_range",
    "face_lt3_vertices",
    "repeated_vertex_in_loop",
    "degenerate_edge_same_index",
    "zero_length_edge",
    "boundary_edge",
    "edge_used_gt2",
    "edge_odd_use",
    "edge_twice_in_same_face",
    "inconsistent_winding_edge",
    "isolated_vertex",
    "duplicate_vertex_position",
    "duplicate_face",
    "zero_area_face",
    "nonplanar_face",
    "zero_signed_area_face",
    "self_crossing_loop",
    "t_junction",
    "nonmanifold_vertex",
    "vertex_lt2_edges",
    "non_orientable",
    "inside_out",
    "zero_volume",
    "hole_same_sense_as_outer",
    "edge_unreferenced",
    "edge_missing_from_list",
    "duplicate_edge_record",
    "edge_face_not_reciprocal",
];

/// Those that only an edge list can have.
const OF_EDGE_LISTS: [&str; 4] =
    ["edge_unreferenced", "edge_missing_from_list", "duplicate_edge_record", "edge_face_not_reciprocal"];

impl Row {
    /// Sound meshes, and each category.
    pub const CASES: [Row; 29] = {
        let mut rows = [Row::Sound; 29];
        let mut i = 0;
        while i < CATEGORIES.len() {
            rows[i + 1] = Row::Defect(CATEGORIES[i]);
            i += 1;
        }
        rows
    };

    /// The groups beside the cases.
    pub const GROUPS: [Row; 3] = [Row::Random, Row::Planes, Row::Angles];

    /// "sound", "boundary_edge", …, "planes".
    pub const fn name(self) -> &'static str {
        match self {
            Row::Sound => "sound",
            Row::Defect(category) => category,
            Row::Random => "random",
            Row::Planes => "planes",
            Row::Angles => "angles",
        }
    }

    /// The operation that is asked.
    pub const fn operation(self) -> &'static str {
        match self {
            Row::Sound | Row::Defect(_) | Row::Random => "mesh.check",
            Row::Planes => "mesh.plane",
            Row::Angles => "mesh.angle_deficits",
        }
    }
}

/// An edge list beside the faces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Listed {
    /// The ends of each edge.
    pub edges: Vec<[u32; 2]>,
    /// The faces that each says it is used by.
    pub faces: Vec<Vec<u32>>,
}

/// A question. That of a plane is a mesh of one face whose vertices are the polygon.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// The row that it belongs to.
    pub row: Row,
    /// The mesh.
    pub mesh: VertexList,
    /// Its edge list, where it has one.
    pub listed: Option<Listed>,
}

impl Question {
    /// The question's `in`.
    pub fn input(&self) -> Value {
        let vertices: Vec<Value> = self.mesh.vertices.iter().map(|v| json!(v.0.each_ref().map(coordinate))).collect();
        if self.row == Row::Planes {
            return json!({"polygon": vertices});
        }
        let faces: Vec<&[u32]> = self.mesh.faces.iter().map(|face| &face.outer[..]).collect();
        let mut input = json!({"vertices": vertices, "faces": faces});
        let with_holes = self.mesh.faces.iter().enumerate().filter(|(_, face)| !face.holes.is_empty());
        let holes: Map<String, Value> = with_holes.map(|(i, face)| (i.to_string(), json!(face.holes))).collect();
        if !holes.is_empty() {
            input["holes"] = Value::Object(holes);
        }
        if let Some(listed) = &self.listed {
            input["edges"] = json!(listed.edges);
            input["edge_faces"] = json!(listed.faces);
        }
        input
    }

    /// A question from `{"op":…,"in":…}`.
    ///
    /// # Errors
    /// The field that cannot be read.
    pub fn parse(text: &Object) -> Result<Question, InvalidField> {
        let rows = [("mesh.check", Row::Random), ("mesh.plane", Row::Planes), ("mesh.angle_deficits", Row::Angles)];
        let row = value::field(text, "op", |op| value::word(op, "an operation of meshes", &rows))?;
        value::field(text, "in", |input| Question::read(row, value::object(input)?))
    }

    fn read(row: Row, input: &Object) -> Result<Question, InvalidField> {
        let points = |list: &Value| value::items(list, |v| Ok(Vector(value::numbers::<3>(v)?)));
        if row == Row::Planes {
            let vertices: Vec<Point> = value::field(input, "polygon", points)?;
            let face = Face::new((0..vertices.len() as u32).collect::<Vec<u32>>());
            return Ok(Question { row, mesh: VertexList { vertices, faces: vec![face] }, listed: None });
        }
        let loops = |list: &Value| value::items(list, |l| value::items(l, index));
        let vertices = value::field(input, "vertices", points)?;
        let mut faces: Vec<Face> = value::field(input, "faces", loops)?.into_iter().map(Face::new).collect();
        let holes = value::optional(input, "holes", |holes| {
            let of_face = |(name, list): (&String, &Value)| {
                let face = name.parse::<usize>().ok().filter(|face| *face < faces.len());
                let face = face.ok_or_else(|| InvalidField::here(Problem::Missing).within(Step::Field("face")))?;
                Ok((face, loops(list)?))
            };
            value::object(holes)?.iter().map(of_face).collect::<Result<Vec<_>, InvalidField>>()
        })?;
        for (face, loops) in holes.into_iter().flatten() {
            faces[face].holes = loops;
        }
        let ends = |list: &Value| value::items(list, |edge| value::exactly(edge, index));
        let listed = value::optional(input, "edges", ends)?.map(|edges| -> Result<Listed, InvalidField> {
            let faces = value::optional(input, "edge_faces", loops)?.unwrap_or_default();
            Ok(Listed { edges, faces })
        });
        Ok(Question { row, mesh: VertexList { vertices, faces }, listed: listed.transpose()? })
    }
}

fn index(value: &Value) -> Result<u32, InvalidField> {
    let number = value::number(value)?;
    Ok(if number.is_integer() { number.numer().to_u32().unwrap_or(u32::MAX) } else { u32::MAX })
}

fn coordinate(x: &Rational) -> Value {
    match (x.is_integer(), x.numer().to_i64()) {
        (true, Some(n)) => json!(n),
        _ => json!(exact_text(x)),
    }
}

/// The true edge list of a mesh.
pub fn listed(mesh: &VertexList) -> Listed {
    let mut faces_of: BTreeMap<[u32; 2], BTreeSet<u32>> = BTreeMap::new();
    for (f, face) in mesh.faces.iter().enumerate() {
        for side in face.sides().filter(|[a, b]| a != b) {
            faces_of.entry(edge(side)).or_default().insert(f as u32);
        }
    }
    let (edges, faces) = faces_of.into_iter().map(|(e, faces)| (e, faces.into_iter().collect())).unzip();
    Listed { edges, faces }
}

/// The suite: `cases` questions of each row.
pub fn questions(seed: u64, cases: usize) -> Vec<Question> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let rows = Row::CASES.into_iter().chain(Row::GROUPS);
    rows.flat_map(|row| (0..cases).map(move |i| (row, i))).map(|(row, i)| question(&mut random, row, i)).collect()
}

fn question(random: &mut ChaCha8Rng, row: Row, number: usize) -> Question {
    match row {
        // The first few are the bases as they are, each at least once.
        Row::Sound => {
            let mesh = bases::solid(random, number);
            let listed = random.random::<bool>().then(|| listed(&mesh));
            Question { row, mesh: bases::moved(random, mesh), listed }
        }
        Row::Defect(category) => loop {
            let kind = random.random_range(0..bases::SOLIDS);
            let mesh = bases::solid(random, kind);
            let mesh = bases::moved(random, mesh);
            let mut question = Question { row, mesh, listed: None };
            if OF_EDGE_LISTS.contains(&category) {
                question.listed = Some(listed(&question.mesh));
            }
            plant(random, &mut question, category);
            if has_defect(&question, category) {
                return question;
            }
        },
        Row::Random => {
            let count = random.random_range(4..7);
            let vertices =
                (0..count).map(|_| Vector([(); 3].map(|()| Rational::from(random.random_range(0..3))))).collect();
            let faces = (0..random.random_range(1..7)).map(|_| {
                let length = random.random_range(2..5);
                Face::new((0..length).map(|_| random.random_range(0..count)).collect::<Vec<u32>>())
            });
            let faces = faces.collect();
            Question { row, mesh: VertexList { vertices, faces }, listed: None }
        }
        Row::Planes => Question { row, mesh: bases::polygon(random), listed: None },
        Row::Angles => {
            let mesh = bases::triangulated(&bases::solid(random, number));
            let mut mesh = bases::moved(random, mesh);
            if random.random_range(0..3) == 0 {
                mesh.faces.pop();
            }
            Question { row, mesh, listed: None }
        }
    }
}
