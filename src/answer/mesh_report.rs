//! The report of a large mesh as JSON, in the terms of `mesh.check`, written as it goes.

use super::mesh_check::CountsOut;
use super::value::Exact;
use crate::mesh::defects::Category;
use crate::mesh::fast::area::Area;
use crate::mesh::fast::{Component, Elements, Report};
use crate::number::decimal::{DecimalEnclosure, Digits};
use serde::ser::{SerializeMap, SerializeSeq};
use serde::{Serialize, Serializer};

/// `{defects, counts, totals, area, components, welded_from, all_t_junctions}`: defects and counts as `mesh.check` has them.
pub struct ReportOut<'a> {
    /// The report.
    pub report: &'a Report,
    /// The number of vertices before those at one position were taken for one; `None` where they were not.
    pub welded_from: Option<usize>,
    /// At most so many elements of each category, and so many components, are listed.
    pub show: usize,
}

impl Serialize for ReportOut<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Report { defects, counts, components, area, all_junctions } = self.report;
        let mut map = serializer.serialize_map(Some(7))?;
        map.serialize_entry("defects", &DefectsOut { defects: self, totals: false })?;
        map.serialize_entry("counts", &counts.clone().map(CountsOut))?;
        map.serialize_entry("totals", &DefectsOut { defects: self, totals: true })?;
        map.serialize_entry("area", &area.as_ref().map(AreaOut))?;
        map.serialize_entry("components", &ComponentsOut(&components[..components.len().min(self.show)]))?;
        map.serialize_entry("welded_from", &self.welded_from)?;
        map.serialize_entry("all_t_junctions", &(*all_junctions || !defects.contains_key(&Category::TJunction)))?;
        map.end()
    }
}

struct DefectsOut<'a> {
    defects: &'a ReportOut<'a>,
    totals: bool,
}

impl Serialize for DefectsOut<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let ReportOut { report, show, .. } = *self.defects;
        let mut map = serializer.serialize_map(Some(report.defects.len()))?;
        for (category, elements) in &report.defects {
            if self.totals {
                map.serialize_entry(category.name(), &elements.len())?;
            } else {
                map.serialize_entry(category.name(), &ElementsOut { elements, show })?;
            }
        }
        map.end()
    }
}

struct ElementsOut<'a> {
    elements: &'a Elements,
    show: usize,
}

impl Serialize for ElementsOut<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let show = self.show;
        match self.elements {
            Elements::Faces(list) | Elements::Vertices(list) => serializer.collect_seq(list.iter().take(show)),
            Elements::Edges(list) => serializer.collect_seq(list.iter().take(show)),
            Elements::VertexGroups(list) | Elements::FaceGroups(list) => serializer.collect_seq(list.iter().take(show)),
            Elements::Junctions(list) => serializer.collect_seq(list.iter().take(show)),
            Elements::Whole => serializer.collect_seq([true]),
        }
    }
}

/// The narrowest decimals, of at most 30 digits, around an area: as the protocol has any real number.
pub fn area_digits(area: &Area) -> DecimalEnclosure {
    let narrow = |digits| DecimalEnclosure::around(&area.lo, &area.hi, Digits::new(digits).expect("few digits"));
    (0..=30).rev().find_map(narrow).expect("an area is enclosed to 18 digits, and 10^0·max(1, |x|) is wide")
}

struct AreaOut<'a>(&'a Area);

impl Serialize for AreaOut<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.0.lo == self.0.hi {
            return Exact(self.0.lo.clone()).serialize(serializer);
        }
        let DecimalEnclosure { lo, hi } = area_digits(self.0);
        let mut map = serializer.serialize_map(Some(2))?;
        map.serialize_entry("lo", &lo)?;
        map.serialize_entry("hi", &hi)?;
        map.end()
    }
}

struct ComponentsOut<'a>(&'a [Component]);

impl Serialize for ComponentsOut<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut list = serializer.serialize_seq(Some(self.0.len()))?;
        for component in self.0 {
            list.serialize_element(&ComponentOut(component))?;
        }
        list.end()
    }
}

struct ComponentOut<'a>(&'a Component);

impl Serialize for ComponentOut<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Component { faces, vertices, edges, boundary_loops, genus } = self.0;
        let mut map = serializer.serialize_map(Some(5))?;
        for (name, count) in [("V", vertices), ("E", edges), ("F", faces), ("boundary_loops", boundary_loops)] {
            map.serialize_entry(name, count)?;
        }
        map.serialize_entry("genus", genus)?;
        map.end()
    }
}
