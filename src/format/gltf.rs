//! glTF 2.0 in one file, its buffer as a data URI: coloured triangles and lines.

use super::Problem;
use gltf_json::validation::{Checked, USize64, Validate};
use gltf_json::{Index, Root, accessor, buffer, material, mesh, scene};
use std::io::{self, Write};

/// Triangles or lines of one colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The name of its material.
    pub name: String,
    /// Positions: three a triangle, two a line.
    pub positions: Vec<[f32; 3]>,
    /// A unit normal for each position of triangles; none for lines.
    pub normals: Vec<[f32; 3]>,
    /// Red, green, blue from 0 to 1, linear.
    pub colour: [f32; 3],
}

/// Writes a scene of these parts; those without positions are left out.
pub fn write(mut writer: impl Write, parts: &[Part]) -> Result<(), Problem> {
    let mut root = Root::default();
    root.asset.generator = Some(concat!("isoracle ", env!("CARGO_PKG_VERSION")).to_owned());
    let mut bytes = Vec::new();
    let mut primitives = Vec::new();
    for part in parts.iter().filter(|part| !part.positions.is_empty()) {
        let mut attributes = std::collections::BTreeMap::new();
        let positions = vectors(&mut root, &mut bytes, &part.positions, true);
        attributes.insert(Checked::Valid(mesh::Semantic::Positions), positions);
        let mode = match part.normals.is_empty() {
            true => mesh::Mode::Lines,
            false => mesh::Mode::Triangles,
        };
        if !part.normals.is_empty() {
            let normals = vectors(&mut root, &mut bytes, &part.normals, false);
            attributes.insert(Checked::Valid(mesh::Semantic::Normals), normals);
        }
        let [r, g, b] = part.colour;
        let material = root.push(material::Material {
            name: Some(part.name.clone()),
            double_sided: true,
            pbr_metallic_roughness: material::PbrMetallicRoughness {
                base_color_factor: material::PbrBaseColorFactor([r, g, b, 1.0]),
                metallic_factor: material::StrengthFactor(0.0),
                roughness_factor: material::StrengthFactor(0.8),
                ..Default::default()
            },
            ..Default::default()
        });
        primitives.push(mesh::Primitive {
            attributes,
            extensions: None,
            extras: Default::default(),
            indices: None,
            material: Some(material),
            mode: Checked::Valid(mode),
            targets: None,
        });
    }
    if !primitives.is_empty() {
        let mesh = mesh::Mesh { extensions: None, extras: Default::default(), name: None, primitives, weights: None };
        let mesh = root.push(mesh);
        let node = root.push(scene::Node { mesh: Some(mesh), ..Default::default() });
        root.buffers.push(buffer::Buffer {
            byte_length: USize64::from(bytes.len()),
            name: None,
            uri: Some(format!("data:application/octet-stream;base64,{}", base64(&bytes))),
            extensions: None,
            extras: Default::default(),
        });
        let scene = scene::Scene { extensions: None, extras: Default::default(), name: None, nodes: vec![node] };
        root.scene = Some(root.push(scene));
    }
    let mut flaw = None;
    root.validate(&root, gltf_json::Path::new, &mut |path, error| {
        flaw.get_or_insert_with(|| format!("{}: {error}", path()));
    });
    if let Some(flaw) = flaw {
        return Err(Problem::Library { field: "scene", source: flaw.into() });
    }
    serde_json::to_writer(&mut writer, &root).map_err(io::Error::from)?;
    writeln!(writer)?;
    Ok(())
}

/// An accessor of binary32 triples at the end of the buffer, with their bounds where they are positions.
fn vectors(root: &mut Root, bytes: &mut Vec<u8>, vectors: &[[f32; 3]], bounded: bool) -> Index<accessor::Accessor> {
    let offset = bytes.len();
    vectors.iter().flatten().for_each(|x| bytes.extend(x.to_le_bytes()));
    let view = root.push(buffer::View {
        buffer: Index::new(0),
        byte_length: USize64::from(bytes.len() - offset),
        byte_offset: Some(USize64::from(offset)),
        byte_stride: None,
        name: None,
        target: Some(Checked::Valid(buffer::Target::ArrayBuffer)),
        extensions: None,
        extras: Default::default(),
    });
    let bound = |choose: fn(f32, f32) -> f32| {
        let bound: [f32; 3] = std::array::from_fn(|i| vectors.iter().map(|v| v[i]).reduce(choose).unwrap_or(0.0));
        serde_json::json!(bound)
    };
    root.push(accessor::Accessor {
        buffer_view: Some(view),
        byte_offset: None,
        count: USize64::from(vectors.len()),
        component_type: Checked::Valid(accessor::GenericComponentType(accessor::ComponentType::F32)),
        extensions: None,
        extras: Default::default(),
        type_: Checked::Valid(accessor::Type::Vec3),
        min: bounded.then(|| bound(f32::min)),
        max: bounded.then(|| bound(f32::max)),
        name: None,
        normalized: false,
        sparse: None,
    })
}

/// RFC 4648, with padding.
pub fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let byte = |i: usize| u32::from(chunk.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for i in 0..4 {
            let digit = DIGITS[(bits >> (18 - 6 * i) & 63) as usize];
            text.push(if i <= chunk.len() { char::from(digit) } else { '=' });
        }
    }
    text
}
