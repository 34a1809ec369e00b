//! VTU, VTK's XML file of an unstructured grid: tetrahedra and lines, with the coordinates that ℝ³ has no room for.

use super::{Problem, TetrahedraRecord};
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};
use std::io::{self, Write};

/// VTK's numbers of cell types.
const LINE: u8 = 3;
const TETRAHEDRON: u8 = 10;

/// Writes the tetrahedra, then the lines, as ascii; numbers are the shortest decimals that read back as the same binary64. Each cell
/// has its group, lines −1; each point has all its coordinates, where it has more than three.
pub fn write(writer: impl Write, record: &TetrahedraRecord) -> Result<(), Problem> {
    let mut xml = Writer::new_with_indent(writer, b' ', 1);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", None, None)))?;
    let file = [("type", "UnstructuredGrid"), ("version", "1.0"), ("byte_order", "LittleEndian")];
    xml.create_element("VTKFile").with_attributes(file).write_inner_content(|xml| {
        xml.create_element("UnstructuredGrid").write_inner_content(|xml| piece(xml, record)).map(drop)
    })?;
    writeln!(xml.get_mut())?;
    Ok(())
}

fn piece<W: Write>(xml: &mut Writer<W>, record: &TetrahedraRecord) -> io::Result<()> {
    let (points, tetrahedra, lines) = (record.vertices.len(), record.tetrahedra.len(), record.lines.len());
    let counts = [("NumberOfPoints", points.to_string()), ("NumberOfCells", (tetrahedra + lines).to_string())];
    let counts = counts.each_ref().map(|(name, count)| (*name, count.as_str()));
    let indices = |cells: &mut dyn Iterator<Item = &[u32]>| rows(cells.map(|cell| cell.iter().map(u32::to_string)));
    xml.create_element("Piece").with_attributes(counts).write_inner_content(|xml| {
        xml.create_element("Points").write_inner_content(|xml| {
            array(xml, "Float64", "Points", 3, &rows(record.vertices.iter().map(|p| p.iter().map(decimal))))
        })?;
        xml.create_element("Cells").write_inner_content(|xml| {
            let tetrahedra_of = record.tetrahedra.iter().map(<[u32; 4]>::as_slice);
            let mut cells = tetrahedra_of.chain(record.lines.iter().map(<[u32; 2]>::as_slice));
            array(xml, "Int64", "connectivity", 1, &indices(&mut cells))?;
            let ends = (1..=tetrahedra).map(|i| 4 * i).chain((1..=lines).map(|i| 4 * tetrahedra + 2 * i));
            array(xml, "Int64", "offsets", 1, &rows(ends.map(|end| [end.to_string()])))?;
            let types = [vec![TETRAHEDRON; tetrahedra], vec![LINE; lines]].concat();
            array(xml, "UInt8", "types", 1, &rows(types.iter().map(|kind| [kind.to_string()])))
        })?;
        if record.dimension > 3 {
            xml.create_element("PointData").write_inner_content(|xml| {
                let points = record.coordinates.chunks(record.dimension).map(|p| p.iter().map(decimal));
                array(xml, "Float64", "position", record.dimension, &rows(points))
            })?;
        }
        xml.create_element("CellData").with_attribute(("Scalars", "group")).write_inner_content(|xml| {
            let groups = record.groups.iter().map(u32::to_string).chain((0..lines).map(|_| "-1".to_owned()));
            array(xml, "Int32", "group", 1, &rows(groups.map(|group| [group])))
        })?;
        Ok(())
    })?;
    Ok(())
}

fn array<W: Write>(xml: &mut Writer<W>, kind: &str, name: &str, components: usize, text: &str) -> io::Result<()> {
    let components = components.to_string();
    let attributes = [("type", kind), ("Name", name), ("NumberOfComponents", components.as_str()), ("format", "ascii")];
    xml.create_element("DataArray").with_attributes(attributes).write_text_content(BytesText::new(text)).map(drop)
}

fn decimal(x: &f64) -> String {
    format!("{x:?}")
}

/// A row of words a line.
fn rows<R: IntoIterator<Item = String>>(rows: impl Iterator<Item = R>) -> String {
    let mut text = String::from("\n");
    for row in rows {
        let words: Vec<String> = row.into_iter().collect();
        text.push_str(&words.join(" "));
        text.push('\n');
    }
    text
}
