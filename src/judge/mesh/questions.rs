//! The questions of the suite `mesh`: the same seed, the same questions.

use super::bases;
use super::has_defect;
use super::plant::plant;
use crate::answer::mesh_check;
use crate::answer::value::{self, InvalidField, Object};
use crate::linear::Vector;
use crate::mesh::defects::ListedEdges;
use crate::mesh::face::{Face, edge};
use crate::mesh::vertex_list::VertexList;
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

/// A question. That of a plane is a mesh of one face whose vertices are the polygon.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// The row that it belongs to.
    pub row: Row,
    /// The mesh.
    pub mesh: VertexList,
    /// Its edge list, where it has one.
    pub listed: Option<ListedEdges>,
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
            input["edges"] = json!(listed.edges());
            if let Some(faces) = listed.faces() {
                input["edge_faces"] = json!(faces);
            }
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
        if row == Row::Planes {
            let vertices = mesh_check::polygon(input)?;
            let face = Face::new((0..vertices.len() as u32).collect::<Vec<u32>>());
            return Ok(Question { row, mesh: VertexList { vertices, faces: vec![face] }, listed: None });
        }
        Ok(Question { row, mesh: mesh_check::mesh(input)?, listed: mesh_check::listed_edges(input)? })
    }
}

fn coordinate(x: &Rational) -> Value {
    match (x.is_integer(), x.numer().to_i64()) {
        (true, Some(n)) => json!(n),
        _ => json!(exact_text(x)),
    }
}

/// The true edge list of a mesh.
pub fn listed(mesh: &VertexList) -> ListedEdges {
    let mut faces_of: BTreeMap<[u32; 2], BTreeSet<u32>> = BTreeMap::new();
    for (f, face) in mesh.faces.iter().enumerate() {
        for side in face.sides().filter(|[a, b]| a != b) {
            faces_of.entry(edge(side)).or_default().insert(f as u32);
        }
    }
    let faces = faces_of.values().map(|faces| faces.iter().copied().collect()).collect();
    ListedEdges::new(faces_of.into_keys().collect(), Some(faces)).expect("one list of faces for each edge")
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
            let mesh = bases::moved(random, mesh);
            let listed = random.random::<bool>().then(|| listed(&mesh));
            Question { row, mesh, listed }
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
