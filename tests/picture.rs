//! Pictures and files of realised complexes, read again.
#![cfg(feature = "cli")]

use isoracle::complex::realise::mesh::TetrahedralMesh;
use isoracle::complex::realise::{Options, Realised, realise};
use isoracle::format::{TetrahedraRecord, gltf, msh, read_mesh, vtu};
use isoracle::picture::scene::{SHRUNK, Scene};
use isoracle::picture::{EXTENSIONS, Paint, page, still, tetrahedra, write};
use quick_xml::Reader;
use quick_xml::events::Event;
use serde_json::Value;
use std::collections::BTreeMap;

/// The boundary of the 16-cell, its tetrahedra in two groups.
fn sphere(dimension: usize) -> (Realised, Paint) {
    let corners: Vec<[u32; 4]> = (0..16_u32).map(|s| std::array::from_fn(|i| 2 * i as u32 + (s >> i & 1))).collect();
    let mesh = TetrahedralMesh::of_tetrahedra(8, &corners).expect("tetrahedra");
    let options = Options { dimension, iterations: 20, ..Options::default() };
    let paint = Paint {
        title: "The 3-sphere <S³> & \"16 cells\"".to_owned(),
        groups: (0..16).map(|i| u32::from(i >= 10)).collect(),
        names: vec!["ten".to_owned(), "six".to_owned(), "none".to_owned()],
        // The last line has an end that does not exist.
        lines: vec![[0, 2], [0, 4], [2, 4], [7, 8]],
    };
    (realise(&mesh, &options).expect("a placement"), paint)
}

/// The elements of a text, by name and attributes, and the text in each.
fn elements(xml: &str) -> Vec<(String, BTreeMap<String, String>, String)> {
    let mut reader = Reader::from_str(xml);
    let (mut found, mut open) = (Vec::new(), Vec::new());
    loop {
        let event = reader.read_event().expect("XML");
        match &event {
            Event::Start(start) | Event::Empty(start) => {
                let attributes = start.attributes().map(|attribute| {
                    let attribute = attribute.expect("an attribute");
                    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("a text");
                    (text(attribute.key.as_ref()), text(&attribute.value))
                });
                found.push((
                    String::from_utf8(start.name().as_ref().to_vec()).expect("a name"),
                    attributes.collect(),
                    String::new(),
                ));
                if matches!(event, Event::Start(_)) {
                    open.push(found.len() - 1);
                }
            }
            Event::Text(text) => {
                if let Some(last) = open.last() {
                    found[*last].2.push_str(std::str::from_utf8(text).expect("a text"));
                }
            }
            Event::End(_) => drop(open.pop()),
            Event::Eof => break,
            _ => {}
        }
    }
    assert!(open.is_empty());
    found
}

fn numbers(text: &str) -> Vec<f64> {
    text.split_whitespace().map(|word| word.parse().expect("a number")).collect()
}

#[test]
fn every_extension_is_written_and_no_other() {
    let folder = tempfile::tempdir().expect("a folder");
    let (realised, paint) = sphere(4);
    for extension in EXTENSIONS.split(", ") {
        let path = folder.path().join(format!("x.{extension}"));
        write(&path, &realised, &paint).expect(extension);
        assert!(std::fs::metadata(&path).expect("a file").len() > 500, "{extension}");
    }
    let refused = write(&folder.path().join("x.stl"), &realised, &paint).expect_err("refused").to_string();
    assert!(refused.ends_with(&format!("unknown extension \"stl\", expected one of {EXTENSIONS}")), "{refused}");
    let mesh = read_mesh(&folder.path().join("x.ply")).expect("a mesh");
    assert_eq!(mesh.vertices, realised.positions);
    assert_eq!(mesh.faces.len(), 32);
    assert!(mesh.faces.iter().zip(realised.mesh.triangles()).all(|(face, triangle)| face == triangle));
}

#[test]
fn vtu_holds_every_cell_and_every_coordinate() {
    for dimension in [3, 4, 5] {
        let (realised, paint) = sphere(dimension);
        let mut bytes = Vec::new();
        vtu::write(&mut bytes, &tetrahedra(&realised, &paint)).expect("a file");
        let all = elements(&String::from_utf8(bytes).expect("a text"));
        let piece = all.iter().find(|(name, ..)| name == "Piece").expect("a piece");
        assert_eq!((&piece.1["NumberOfPoints"][..], &piece.1["NumberOfCells"][..]), ("8", "19"));
        let array = |name: &str| {
            let found = all.iter().find(|(element, a, _)| element == "DataArray" && a["Name"] == name);
            found.map(|(_, attributes, text)| (attributes["NumberOfComponents"].clone(), numbers(text)))
        };
        let of = |numbers: &[u32]| numbers.iter().map(|n| f64::from(*n)).collect::<Vec<_>>();
        assert_eq!(array("Points"), Some(("3".to_owned(), realised.positions.concat())));
        let cells = [realised.mesh.tetrahedra().concat(), paint.lines[..3].concat()].concat();
        assert_eq!(array("connectivity"), Some(("1".to_owned(), of(&cells))));
        let ends: Vec<u32> = (1..=16).map(|i| 4 * i).chain([66, 68, 70]).collect();
        assert_eq!(array("offsets"), Some(("1".to_owned(), of(&ends))));
        assert_eq!(array("types"), Some(("1".to_owned(), [vec![10.0; 16], vec![3.0; 3]].concat())));
        assert_eq!(array("group"), Some(("1".to_owned(), [of(&paint.groups), vec![-1.0; 3]].concat())));
        let position = (dimension > 3).then(|| (dimension.to_string(), realised.points.coordinates().to_vec()));
        assert_eq!(array("position"), position);
    }
}

#[test]
fn msh_numbers_from_one_and_counts_right() {
    let (realised, paint) = sphere(4);
    let record = tetrahedra(&realised, &paint);
    let mut bytes = Vec::new();
    msh::write(&mut bytes, &record).expect("a file");
    let text = String::from_utf8(bytes).expect("a text");
    let section = |name: &str| {
        let body = text.split(&format!("${name}\n")).nth(1).expect("a section");
        body.split(&format!("$End{name}")).next().expect("an end").lines().map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(section("MeshFormat"), ["4.1 0 8"]);
    assert_eq!(section("PhysicalNames"), ["3", "1 1 \"edges\"", "3 1 \"group 0\"", "3 2 \"group 1\""]);
    let entities = section("Entities");
    assert_eq!((entities.len(), &entities[0][..]), (4, "0 1 0 2"));
    let nodes = section("Nodes");
    assert_eq!(nodes[..2], ["1 8 1 8", "3 1 0 8"]);
    assert_eq!(nodes[2..10].join(" "), "1 2 3 4 5 6 7 8");
    assert_eq!(numbers(&nodes[10..].join(" ")), realised.positions.concat());
    let elements = section("Elements");
    assert_eq!(elements[0], "3 19 1 19");
    assert_eq!((&elements[1][..], &elements[2][..]), ("1 1 1 3", "1 1 3"));
    assert_eq!((&elements[5][..], &elements[16][..]), ("3 1 4 10", "3 2 4 6"));
    let first: Vec<f64> = realised.mesh.tetrahedra()[0].iter().map(|v| f64::from(*v) + 1.0).collect();
    assert_eq!(numbers(&elements[6])[1..], first[..]);
    // Nothing at all is a file too.
    let empty = TetrahedraRecord {
        vertices: vec![],
        dimension: 4,
        coordinates: vec![],
        tetrahedra: vec![],
        groups: vec![],
        lines: vec![],
    };
    let mut bytes = Vec::new();
    msh::write(&mut bytes, &empty).expect("a file");
    assert!(String::from_utf8(bytes).expect("a text").contains("$Elements\n0 0 0 0\n"));
}

/// The bytes of a text in base 64, by RFC 4648.
fn decoded(text: &str) -> Vec<u8> {
    let digit = |c: u8| match c {
        b'A'..=b'Z' => c - b'A',
        b'a'..=b'z' => c - b'a' + 26,
        b'0'..=b'9' => c - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        _ => panic!("no digit: {c}"),
    };
    let digits: Vec<u8> = text.bytes().filter(|c| *c != b'=').map(digit).collect();
    let bits = digits.iter().flat_map(|d| (0..6).rev().map(move |i| d >> i & 1)).collect::<Vec<_>>();
    bits.chunks_exact(8).map(|byte| byte.iter().fold(0, |n, bit| 2 * n + bit)).collect()
}

#[test]
fn gltf_points_into_its_buffer_and_bounds_its_positions() {
    let (realised, paint) = sphere(4);
    let scene = Scene::of(&realised, &paint);
    let mut bytes = Vec::new();
    gltf::write(&mut bytes, &scene.parts()).expect("a file");
    let root: Value = serde_json::from_slice(&bytes).expect("JSON");
    gltf_json::Root::from_slice(&bytes).expect("glTF");
    assert_eq!(root["asset"]["version"], "2.0");
    let uri = root["buffers"][0]["uri"].as_str().expect("a URI");
    let buffer = decoded(uri.strip_prefix("data:application/octet-stream;base64,").expect("a data URI"));
    assert_eq!(root["buffers"][0]["byteLength"], buffer.len());
    let vectors = |accessor: &Value| -> Vec<[f32; 3]> {
        let accessor = &root["accessors"][accessor.as_u64().expect("an index") as usize];
        assert_eq!((accessor["componentType"].as_u64(), accessor["type"].as_str()), (Some(5126), Some("VEC3")));
        let view = &root["bufferViews"][accessor["bufferView"].as_u64().expect("a view") as usize];
        let [start, length] = ["byteOffset", "byteLength"].map(|key| view[key].as_u64().expect("a number") as usize);
        let floats: Vec<f32> = buffer[start..start + length]
            .chunks_exact(4)
            .map(|b| f32::from_le_bytes(b.try_into().expect("four bytes")))
            .collect();
        let vectors: Vec<[f32; 3]> = floats.chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect();
        assert_eq!(accessor["count"], vectors.len());
        for (key, choose) in [("min", f32::min as fn(f32, f32) -> f32), ("max", f32::max)] {
            for i in (0..3).filter(|_| !accessor[key].is_null()) {
                let bound = vectors.iter().map(|v| v[i]).reduce(choose).expect("positions");
                assert_eq!(accessor[key][i].as_f64().expect("a bound") as f32, bound);
            }
        }
        vectors
    };
    let primitives = root["meshes"][0]["primitives"].as_array().expect("primitives");
    let modes: Vec<u64> = primitives.iter().map(|p| p["mode"].as_u64().unwrap_or(4)).collect();
    assert_eq!(modes, [4, 4, 1]);
    for (primitive, triangles) in primitives.iter().zip([40, 24]) {
        let [positions, normals] = ["POSITION", "NORMAL"].map(|name| vectors(&primitive["attributes"][name]));
        assert_eq!((positions.len(), normals.len()), (3 * triangles, 3 * triangles));
        let middle = |p: &[[f32; 3]], i: usize| p.iter().map(|p| p[i]).sum::<f32>() / p.len() as f32;
        for (tetrahedron, normals) in positions.chunks_exact(12).zip(normals.chunks_exact(12)) {
            for (face, normals) in tetrahedron.chunks_exact(3).zip(normals.chunks_exact(3)) {
                // Outward, of length 1, across the face.
                let out: f32 = (0..3).map(|i| (middle(face, i) - middle(tetrahedron, i)) * normals[0][i]).sum();
                let length: f32 = normals[0].iter().map(|x| x * x).sum();
                let along: f32 = (0..3).map(|i| (face[1][i] - face[0][i]) * normals[0][i]).sum();
                assert!(out > 0.0 && (length - 1.0).abs() < 1e-5 && along.abs() < 1e-5);
            }
        }
    }
    assert_eq!(vectors(&primitives[2]["attributes"]["POSITION"]).len(), 6);
    for part in [vec![], vec![gltf::Part { name: String::new(), positions: vec![], normals: vec![], colour: [0.0; 3] }]]
    {
        let mut bytes = Vec::new();
        gltf::write(&mut bytes, &part).expect("an empty scene");
        gltf_json::Root::from_slice(&bytes).expect("glTF");
    }
}

#[test]
fn base_64_is_that_of_the_standard() {
    for (bytes, text) in [
        ("", ""),
        ("f", "Zg=="),
        ("fo", "Zm8="),
        ("foo", "Zm9v"),
        ("foob", "Zm9vYg=="),
        ("fooba", "Zm9vYmE="),
        ("foobar", "Zm9vYmFy"),
    ] {
        assert_eq!(gltf::base64(bytes.as_bytes()), text);
    }
    let all: Vec<u8> = (0..=255).collect();
    assert_eq!(decoded(&gltf::base64(&all)), all);
}

#[test]
fn a_scene_is_within_distance_1_and_its_tetrahedra_are_drawn_apart() {
    let (realised, paint) = sphere(4);
    let scene = Scene::of(&realised, &paint);
    let farthest = scene.positions.iter().map(|p| p.iter().map(|x| x * x).sum::<f64>()).fold(0.0, f64::max);
    assert!((farthest - 1.0).abs() < 1e-12);
    let [a, b, ..] = scene.corners(0);
    let [v, w, ..] = scene.tetrahedra[0].map(|v| scene.positions[v as usize]);
    assert!((0..3).all(|i| ((a[i] - b[i]) - SHRUNK * (v[i] - w[i])).abs() < 1e-12));
    assert_eq!(scene.legend(), [(0, "ten"), (1, "six")]);
    assert_eq!(scene.lines.len(), 3);
}

#[test]
fn the_still_is_drawn_from_behind_forward() {
    let (realised, paint) = sphere(4);
    let drawn = elements(&still::still(&Scene::of(&realised, &paint)));
    let of = |name: &str| drawn.iter().filter(|(element, ..)| element == name).count();
    // At least one triangle of each tetrahedron faces the viewer, at most three.
    assert!((16..=48).contains(&of("polygon")), "{}", of("polygon"));
    assert_eq!((of("line"), of("circle")), (3, 2));
    let faint: Vec<f64> = drawn.iter().filter_map(|(_, a, _)| a.get("opacity")?.parse().ok()).collect();
    assert_eq!(faint.len(), 19);
    assert!(faint.windows(2).all(|pair| pair[0] <= pair[1]), "{faint:?}");
    let words = drawn.iter().map(|(.., text)| text.as_str()).collect::<String>();
    assert!(words.contains("16 tetrahedra") && words.contains("ℝ⁴: yes") && words.contains("ten"), "{words}");
}

#[test]
fn the_page_needs_nothing_but_itself() {
    let (realised, paint) = sphere(5);
    let page = page::page(&Scene::of(&realised, &paint));
    for foreign in ["src=", "href=", "@import", "fetch(", "url(", "https://"] {
        assert!(!page.contains(foreign), "{foreign}");
    }
    // The title is a text, not a tag.
    assert!(page.contains("&lt;S³&gt; &amp;") && !page.contains("<S³>"));
    let data = page.split("const SCENE = ").nth(1).and_then(|rest| rest.split(";\n").next()).expect("the scene");
    let data: Value = serde_json::from_str(data).expect("JSON");
    assert_eq!(data["points"].as_array().map(Vec::len), Some(8));
    assert_eq!(data["points"][0].as_array().map(Vec::len), Some(5));
    assert_eq!(data["tetrahedra"].as_array().map(Vec::len), Some(16));
    assert_eq!((&data["groups"][9], &data["groups"][10]), (&Value::from(0), &Value::from(1)));
    assert_eq!(data["lines"].as_array().map(Vec::len), Some(3));
    assert!(page.matches("<script>").count() == 1 && page.ends_with("</script></body></html>"));
}
