//! What `isoracle complex` says: a page of text, or JSON, with every invariant of a scheme, or the reasons why not.

use isoracle::answer::complex::report;
use isoracle::complex::abelian::AbelianGroup;
use isoracle::complex::check::Facts;
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::embedding::{R4Obstruction, r4_obstruction};
use isoracle::complex::isosig_fast as isosig;
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::presentation::Presentation;
use isoracle::complex::refine::counts::printed_counts;
use isoracle::complex::scheme::{GluingScheme, SchemeDefect};
use isoracle::mesh::classify::{ClosedSurface, Surface};
use isoracle::mesh::homology::Homology;
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::fmt::Display;
use std::io::{self, Write};

/// The most topological tetrahedra whose isomorphism signature stands on the page: longer ones fill it.
const MAX_SIGNED: usize = 200;

/// What is known of a scheme.
pub struct Page {
    /// What it was called on the command line.
    pub name: String,
    /// What is known of it, where it is an example.
    pub about: Option<String>,
    /// The scheme.
    pub scheme: GluingScheme,
    /// Its complex, where its cells are cells.
    pub complex: Option<ClosedComplex>,
    /// What keeps it from being a manifold.
    pub defects: Vec<SchemeDefect>,
    /// The order of its refinement, and what that is.
    pub refinement: Option<(u32, Facts)>,
    /// Further lines of text, and fields of JSON.
    pub more: Vec<(String, Value)>,
}

impl Page {
    /// The page of a scheme, its refinement not yet on it.
    pub fn of(name: String, about: Option<String>, scheme: GluingScheme) -> Page {
        let (complex, defects) = match ClosedComplex::new(scheme.clone()) {
            Err(defects) => (None, defects),
            Ok(complex) => {
                let defects = Manifold3::of(complex.clone()).err().unwrap_or_default();
                (Some(complex), defects)
            }
        };
        Page { name, about, scheme, complex, defects, refinement: None, more: Vec::new() }
    }

    /// As text.
    pub fn write_text(&self, out: &mut impl Write) -> io::Result<()> {
        writeln!(out, "{}: {}", self.name, self.verdict())?;
        if let Some(about) = &self.about {
            writeln!(out, "  {about}")?;
        }
        for defect in &self.defects {
            writeln!(out, "  {:<23}{defect}", defect.reason().name())?;
        }
        let Some(complex) = &self.complex else { return Ok(()) };
        write_cells(out, complex)?;
        let homology = complex.chain_complex().homology();
        writeln!(out, "  homology               {}", homology_text(&homology))?;
        for group in groups(complex) {
            writeln!(out, "  fundamental group      {group}")?;
        }
        if let Some(manifold) = self.manifold() {
            writeln!(out, "  embedding in ℝ⁴        {}", embedding(r4_obstruction(&manifold)))?;
        }
        write_tetrahedra(out, complex)?;
        if let Some((order, facts)) = &self.refinement {
            write_refinement(out, *order, complex.facet_edge_pairs(), facts)?;
        }
        self.more.iter().try_for_each(|(line, _)| writeln!(out, "{line}"))
    }

    fn manifold(&self) -> Option<Manifold3> {
        Manifold3::of(self.complex.clone()?).ok()
    }

    fn verdict(&self) -> String {
        let Some(complex) = self.complex.as_ref().filter(|_| self.defects.is_empty()) else {
            let what = if self.complex.is_some() { "a closed complex, but no 3-manifold" } else { "no closed complex" };
            return what.to_owned();
        };
        let orientable = if complex.is_orientable() { "orientable" } else { "not orientable" };
        match complex.component_count() {
            1 => format!("a closed 3-manifold, {orientable}"),
            n => format!("a closed 3-manifold of {n} components, {orientable}"),
        }
    }

    /// As JSON: what `complex.glue` answers, and more.
    pub fn json(&self) -> Value {
        let mut fields = report(self.scheme.clone());
        fields.insert("name".to_owned(), json!(self.name));
        if let Some(complex) = &self.complex {
            fields.insert("homology".to_owned(), homology_json(&complex.chain_complex().homology()));
            fields.insert("vertex_links".to_owned(), complex.vertex_links().into_iter().map(name_of).collect());
            let groups = groups(complex);
            fields.insert("fundamental_groups".to_owned(), groups.iter().map(ToString::to_string).collect());
            fields.insert("isomorphism_signature".to_owned(), json!(signature(complex)));
        }
        if let Some(manifold) = self.manifold() {
            let obstruction = r4_obstruction(&manifold).map(|obstruction| embedding(Some(obstruction)));
            fields.insert("embedding_in_r4".to_owned(), json!({"obstruction": obstruction}));
        }
        if let (Some((order, facts)), Some(complex)) = (&self.refinement, &self.complex) {
            fields.insert("refinement".to_owned(), refinement_json(*order, complex.facet_edge_pairs(), facts));
        }
        fields.extend(self.more.iter().filter_map(|(_, value)| value.as_object().cloned()).flatten());
        Value::Object(fields)
    }
}

fn write_cells(out: &mut impl Write, complex: &ClosedComplex) -> io::Result<()> {
    let [v, e, f, p] = complex.counts();
    writeln!(
        out,
        "  cells                  V = {v}, E = {e}, F = {f}, P = {p}, χ = {}",
        complex.euler_characteristic()
    )?;
    writeln!(out, "  face-edge pairs        t = {}", complex.facet_edge_pairs())?;
    writeln!(out, "  faces around an edge   {}", tally(complex.edge_ring_sizes()))?;
    writeln!(out, "  sides of a face        {}", tally(complex.face_degrees()))?;
    writeln!(out, "  link of a vertex       {}", tally(complex.vertex_links().into_iter().map(name_of)))
}

fn write_tetrahedra(out: &mut impl Write, complex: &ClosedComplex) -> io::Result<()> {
    for (what, counts) in [
        ("topological tetrahedra", complex.tetrahedra().skeleton().counts),
        ("barycentric tetrahedra", complex.barycentric().skeleton().counts),
    ] {
        let [v, e, f, t] = counts;
        writeln!(out, "  {what} V = {v}, E = {e}, F = {f}, T = {t}")?;
    }
    match signature(complex) {
        Some(signature) => writeln!(out, "  isomorphism signature  {signature}"),
        None => Ok(()),
    }
}

fn write_refinement(out: &mut impl Write, order: u32, pairs: usize, facts: &Facts) -> io::Result<()> {
    let [v, e, f, t] = facts.counts;
    writeln!(out, "refined to order {order}")?;
    writeln!(out, "  cells                  V = {v}, E = {e}, F = {f}, T = {t}")?;
    let [printed, _, _] = printed_counts(pairs as u64, u64::from(order));
    let verdict = if printed == e as u128 { "right here" } else { "wrong" };
    writeln!(out, "  edges as printed       t(k³ + k² + 1) = {printed}, {verdict}")?;
    let sets = &facts.vertex_sets;
    if sets.simplicial {
        return writeln!(out, "  simplicial complex     yes");
    }
    writeln!(out, "  simplicial complex     no")?;
    writeln!(out, "  degenerate tetrahedra  {} with a vertex twice", sets.degenerate_tetrahedra)?;
    writeln!(out, "  duplicate tetrahedra   {} with the vertices of another", sets.duplicate_tetrahedra)
}

fn refinement_json(order: u32, pairs: usize, facts: &Facts) -> Value {
    let [v, e, f, t] = facts.counts;
    let [printed_e, printed_f, printed_t] = printed_counts(pairs as u64, u64::from(order));
    let sets = &facts.vertex_sets;
    json!({
        "order": order, "V": v, "E": e, "F": f, "T": t,
        "simplicial": sets.simplicial,
        "degenerate_tetrahedra": sets.degenerate_tetrahedra,
        "duplicate_tetrahedra": sets.duplicate_tetrahedra,
        "as_printed": {"T": printed_t, "F": printed_f, "E": printed_e},
    })
}

fn groups(complex: &ClosedComplex) -> Vec<Presentation> {
    complex.fundamental_groups().iter().map(Presentation::simplified).collect()
}

/// What is known against an embedding; nothing known is no promise.
fn embedding(obstruction: Option<R4Obstruction>) -> String {
    match obstruction {
        None => "not excluded".to_owned(),
        Some(R4Obstruction::NonOrientable { .. }) => "impossible, a closed hypersurface of ℝ⁴ is orientable".to_owned(),
        Some(R4Obstruction::Torsion { torsion, .. }) => {
            let group = AbelianGroup { rank: 0, torsion };
            format!("impossible, the torsion {group} of H₁ is no A ⊕ A (Hantzsche)")
        }
    }
}

fn signature(complex: &ClosedComplex) -> Option<String> {
    (complex.facet_edge_pairs() <= MAX_SIGNED).then(|| isosig::signature(&complex.tetrahedra()))
}

fn homology_text(homology: &Homology) -> String {
    let group = |(k, name)| format!("{name} = {}", AbelianGroup::of_homology(homology, k));
    (0..).zip(["H₀", "H₁", "H₂", "H₃"]).map(group).collect::<Vec<_>>().join(", ")
}

fn homology_json(homology: &Homology) -> Value {
    let group = |(k, name): (usize, &str)| {
        let AbelianGroup { rank, torsion } = AbelianGroup::of_homology(homology, k);
        let torsion = torsion.iter().map(|n| serde_json::from_str::<Value>(&n.to_string()).expect("digits"));
        (name.to_owned(), json!({"rank": rank, "torsion": torsion.collect::<Vec<_>>()}))
    };
    Value::Object((0..).zip(["h0", "h1", "h2", "h3"]).map(group).collect::<Map<_, _>>())
}

fn name_of(link: ClosedSurface) -> String {
    Surface { closed: link, boundary_loops: 0 }.to_string()
}

/// "3, 4 (12 times)": how often each value occurs.
fn tally<T: Ord + Display>(values: impl IntoIterator<Item = T>) -> String {
    let mut times: BTreeMap<T, usize> = BTreeMap::new();
    values.into_iter().for_each(|value| *times.entry(value).or_default() += 1);
    let term = |(value, n): (&T, &usize)| if *n == 1 { value.to_string() } else { format!("{value} ({n} times)") };
    times.iter().map(term).collect::<Vec<_>>().join(", ")
}
