//! Meshes: fixtures by hand, and other libraries as second witnesses.

use super::*;

mod ply_ {
    use super::*;

    const PYRAMID: &str = "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 5\nproperty float x\nproperty float y\n\
        property float z\nproperty uchar red\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n\
        element face 2\nproperty list uchar int vertex_index\nproperty list uchar float texcoord\nend_header\n\
        0 0 0 255\n1. 0 -0 1\n1 1e0 0 2\n0 1 .5 3\n0.1 nan -inf 4\n3 4\n4 0 1 2 3 2 0.5 0.5\n3 0 1 4 0\n";

    #[test]
    fn ascii_keeps_polygons_and_passes_over_the_rest() {
        let mesh = ply::read(PYRAMID.as_bytes()).expect("a pyramid");
        assert_eq!(mesh.faces, [vec![0, 1, 2, 3], vec![0, 1, 4]]);
        assert_eq!((mesh.precision, mesh.soup), (Precision::Binary32, false));
        let last = [f64::from(0.1_f32), f64::NAN, f64::NEG_INFINITY];
        assert_eq!(format!("{:?}", mesh.vertices[3..].concat()), format!("{:?}", [[0.0, 1.0, 0.5], last].concat()));
        assert!(mesh.vertices[1][2].is_sign_negative());
        assert_eq!(ply::read(PYRAMID.replace('\n', "\r\n").as_bytes()).expect("the same").faces, mesh.faces);
    }

    #[test]
    fn big_endian_doubles_are_read() {
        let header = "ply\nformat binary_big_endian 1.0\nelement face 1\nproperty list uint ushort vertex_indices\n\
            element vertex 1\nproperty double x\nproperty short y\nproperty float z\nend_header\n";
        let data = b"\0\0\0\x03\0\0\0\x01\xff\xfe\x3f\xf8\0\0\0\0\0\0\xff\xfe\x40\x40\0\0";
        let mesh = ply::read(&[header.as_bytes(), data].concat()[..]).expect("faces may stand first");
        assert_eq!((&mesh.vertices[..], &mesh.faces[..]), (&[[1.5, -2.0, 3.0]][..], &[vec![0, 1, 65534]][..]));
        assert_eq!(mesh.precision, Precision::Binary64);
    }

    #[test]
    fn an_error_names_its_element() {
        let with = |old: &str, new: &str| message(ply::read(PYRAMID.replace(old, new).as_bytes()));
        assert!(with("ply\n", "PLY\n").starts_with("not a file of the format PLY"));
        assert_eq!(with("element face", "element vertex"), "element vertex: stated twice");
        assert_eq!(with("float y", "float x"), "element vertex, property x: stated twice");
        assert_eq!(with("float y", "float v"), "vertex property y: missing");
        assert_eq!(with("element vertex", "element corner"), "element vertex: missing");
        assert_eq!(with("vertex_index", "corners"), "face property vertex_indices: missing");
        assert_eq!(with("texcoord", "vertex_indices"), "face property vertex_indices: stated twice");
        assert!(with("list uchar int", "list uchar float").contains("expected a list of integers"));
        assert_eq!(with("face 2", "face 3"), "element face: truncated, expected 3 rows, found 2");
        assert_eq!(with("face 2", "face 1"), "data: data goes on after the expected 7 rows");
        assert!(with("3 0 1 4 0", "3 0 1 -4 0").starts_with("face 1, vertex index: expected a whole number from 0"));
        assert!(with("3 0 1 4 0", "3 0 1").starts_with("element face 1: expected its properties"));
        assert!(with("3 0 1 4 0", "3 0 1 4 0 7").contains("one number too many"));
        assert!(with("1 1e0", "1 1f0").starts_with("element vertex 2: "));
        assert!(with("end_header\n", "").starts_with("header: "));
        assert!(with("element face", "element tristrips").starts_with("element tristrips: "));
    }
}

mod stl_ {
    use super::*;

    const TWO_SOLIDS: &str = "solid\n facet normal nan nan nan\n  OUTER LOOP\n   vertex 0 0 0\n   vertex 1e0 0 0\n\
        vertex 0 0.1 0\n  endloop\n endfacet\nendsolid\n\nsolid the second\nfacet normal 0 0 1\nouter loop\n\
        vertex 0 0 0\nvertex 1 0 0\nvertex 0 0 inf\nendloop\nendfacet\nendsolid the second\n";

    #[test]
    fn ascii_reads_every_solid_and_welds_nothing() {
        let mesh = stl::read(TWO_SOLIDS.as_bytes()).expect("two solids");
        assert_eq!(mesh.faces, [[0, 1, 2], [3, 4, 5]]);
        assert_eq!(mesh.vertices[2], [0.0, f64::from(0.1_f32), 0.0]);
        assert_eq!(mesh.vertices[5], [0.0, 0.0, f64::INFINITY]);
        assert_eq!((mesh.precision, mesh.soup), (Precision::Binary32, true));
        let cut = |end| message(stl::read(&TWO_SOLIDS.as_bytes()[..end]));
        assert_eq!(cut(TWO_SOLIDS.len() - 21), "line 19: expected facet or endsolid, found \"the end of the file\"");
        let wrong = message(stl::read(TWO_SOLIDS.replace("1e0", "1e").as_bytes()));
        assert_eq!(wrong, "line 5: expected vertex and three numbers, found \"vertex 1e 0 0\"");
    }

    #[test]
    fn a_binary_file_may_call_itself_solid() {
        let mut bytes = [b"solid ".repeat(14)[..80].to_vec(), vec![1, 0, 0, 0], vec![0; 50]].concat();
        bytes[84 + 12..84 + 16].copy_from_slice(&1.5_f32.to_le_bytes());
        let mesh = stl::read(&bytes[..]).expect("one triangle");
        assert_eq!((mesh.vertices[0], mesh.faces), ([1.5, 0.0, 0.0], vec![vec![0, 1, 2]]));
        bytes[..80].fill(b' ');
        let cut = message(stl::read(&bytes[..133]));
        assert_eq!(cut, "triangles: truncated, expected 134 bytes, found 133");
        bytes.push(0);
        assert_eq!(message(stl::read(&bytes[..])), "triangles: data goes on after the expected 134 bytes");
        assert!(message(stl::read(&b"not"[..])).starts_with("not a file of the format STL"));
    }

    #[test]
    fn only_triangles_with_vertices_are_written() {
        let mut mesh = obj::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 1\n"[..]).expect("a quadrilateral");
        let refused = message(stl::write(Vec::new(), &mesh));
        assert_eq!(refused, "face 0: 4 vertices, but the format has triangles only");
        mesh.faces = vec![vec![0, 1, 2], vec![0, 1, 3]];
        let refused = message(stl::write(Vec::new(), &mesh));
        assert_eq!(refused, "face 1: vertex index 3 is out of range, and the format stores positions");
    }

    #[test]
    fn stl_io_reads_the_same_triangles() {
        let one = TWO_SOLIDS.split("\n\n").next().expect("the first solid").to_lowercase();
        let one = one.replace("solid\n", "solid x\n").replace("nan", "0");
        let mut cursor = std::io::Cursor::new(one.as_bytes());
        let theirs = stl_io::create_stl_reader(&mut cursor).expect("ascii");
        let theirs = theirs.flat_map(|triangle| triangle.expect("a triangle").vertices);
        let theirs: Vec<[f64; 3]> = theirs.map(|vertex| vertex.0.map(f64::from)).collect();
        assert_eq!(theirs, stl::read(one.as_bytes()).expect("ascii").vertices);
    }
}

mod obj_ {
    use super::*;

    const HOUSE: &str = "# a house\nmtllib none.mtl\no walls\nv 0 0 0 # ground\nv 1 0 0 1\nv 1 1 0 0.5 0.5 0.5\n\
        v 0.1 1 0\nvt 0 0\nvn 0 0 1\nusemtl brick\ns off\nf 1/1/1 2//1 3/1 4\ng roof\nv 0.5 2 0\nv 9 9 9\n\
        f -3 \\\n -4 -2/-1/-1\nl 1 2\nf 3 4 5\nf 1 2 8\n";

    #[test]
    fn vertices_keep_their_numbers() {
        let mesh = obj::read(HOUSE.as_bytes()).expect("a house");
        assert_eq!(mesh.faces, [vec![0, 1, 2, 3], vec![3, 2, 4], vec![2, 3, 4], vec![0, 1, 7]]);
        assert_eq!(mesh.vertices.len(), 6);
        assert_eq!(mesh.vertices[3], [0.1, 1.0, 0.0]);
        assert_eq!((mesh.precision, mesh.soup), (Precision::Binary64, false));
        let with = |old: &str, new: &str| message(obj::read(HOUSE.replace(old, new).as_bytes()));
        assert!(with("f 3 4 5", "f 3 0 5").starts_with("line 19: expected vertex indices"));
        assert!(with("f 3 4 5", "f 3 -7 5").starts_with("line 19: expected vertex indices"));
        assert!(with("f 3 4 5", "f 3 4294967297 5").starts_with("line 19: expected vertex indices"));
        assert!(with("f 3 4 5", "surf 0 1 0 1 1 2").starts_with("line 19: expected polygons only"));
        assert!(with("v 9 9 9", "v 9 9").starts_with("line 15: expected three coordinates"));
        assert!(with("v 9 9 9", "v 9 9 x").starts_with("line 15: expected three coordinates"));
        assert!(with("v 1 0 0 1", "v 1 0 0 2").starts_with("line 5: expected the weight 1"));
    }

    #[test]
    fn tobj_finds_the_same_polygons() {
        let text = HOUSE.replace("f 1 2 8\n", "");
        let ours = obj::read(text.as_bytes()).expect("a house");
        let ours = ours.faces.iter().map(|face| face.iter().map(|&i| ours.vertices[i as usize]).collect::<Vec<_>>());
        let options = tobj::LoadOptions { ignore_lines: true, ..Default::default() };
        let none = |_: &std::path::Path| Err(tobj::LoadError::OpenFileFailed);
        // It takes neither a continued line, nor a comment behind a position, nor a colour for some of them only.
        let text = text.replace("\\\n", "").replace(" # ground", "").replace(" 0.5 0.5 0.5", "");
        let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, none).expect("a house");
        let mut theirs = Vec::new();
        for mesh in models.iter().map(|model| &model.mesh) {
            let corner = |&i: &u32| [0, 1, 2].map(|axis| mesh.positions[3 * i as usize + axis]);
            let mut indices = &mesh.indices[..];
            let triangles = vec![3; mesh.indices.len() / 3];
            for &n in if mesh.face_arities.is_empty() { &triangles } else { &mesh.face_arities } {
                let (face, rest) = indices.split_at(n as usize);
                theirs.push(face.iter().map(corner).collect::<Vec<_>>());
                indices = rest;
            }
        }
        let single = |face: Vec<[f64; 3]>| face.into_iter().map(|p| p.map(|c| c as f32)).collect::<Vec<_>>();
        assert_eq!(ours.map(single).collect::<Vec<_>>(), theirs);
    }
}

mod ply_binary_ {
    use super::*;

    /// Every kind of number, lists beside them, either byte order; rows of faces of 0 … 300 corners.
    fn file(big_endian: bool) -> Vec<u8> {
        let order = if big_endian { "big" } else { "little" };
        let mut bytes = format!(
            "ply\nformat binary_{order}_endian 1.0\nelement vertex 3\nproperty list uchar short tags\nproperty float z\n\
             property double x\nproperty short y\nelement other 2\nproperty list int double data\nproperty char c\n\
             element face 2\nproperty uchar flags\nproperty list ushort int vertex_index\nproperty float area\nend_header\n"
        )
        .into_bytes();
        let mut put = |value: &[u8]| bytes.extend_from_slice(value);
        let swap = |mut value: Vec<u8>| {
            if big_endian {
                value.reverse();
            }
            value
        };
        for v in 0..3_i16 {
            put(&[v as u8]);
            (0..v).for_each(|tag| put(&swap(tag.to_le_bytes().into())));
            put(&swap((f32::from(v) / 2.0).to_le_bytes().into()));
            put(&swap((f64::from(v) / 10.0).to_le_bytes().into()));
            put(&swap((-v).to_le_bytes().into()));
        }
        for n in [0_i32, 2] {
            put(&swap(n.to_le_bytes().into()));
            (0..n).for_each(|x| put(&swap(f64::from(x).to_le_bytes().into())));
            put(&[7]);
        }
        for n in [300_u16, 3] {
            put(&[1]);
            put(&swap(n.to_le_bytes().into()));
            (0..n).for_each(|i| put(&swap(i32::from(i % 3).to_le_bytes().into())));
            put(&swap(1.5_f32.to_le_bytes().into()));
        }
        bytes
    }

    #[test]
    fn every_kind_of_row_is_read_in_either_byte_order() {
        for big_endian in [false, true] {
            let mesh = ply::read(&file(big_endian)[..]).expect("a mesh");
            assert_eq!(mesh.vertices, [[0.0, 0.0, 0.0], [0.1, -1.0, 0.5], [0.2, -2.0, 1.0]]);
            assert_eq!(mesh.faces, [(0..300).map(|i| i % 3).collect::<Vec<u32>>(), vec![0, 1, 2]]);
            assert_eq!(mesh.precision, Precision::Binary64);
        }
    }

    #[test]
    fn a_cut_a_tail_and_a_negative_number_are_refused() {
        let whole = file(false);
        let header = whole.windows(11).position(|w| w == b"end_header\n").expect("a header") + 11;
        for end in header..whole.len() {
            let problem = message(ply::read(&whole[..end]));
            assert!(problem.contains("truncated, expected "), "{end}: {problem}");
        }
        assert_eq!(message(ply::read(&whole[..whole.len() - 1])), "element face: truncated, expected 2 rows, found 1");
        assert!(ply::read(&[&whole[..], b"\n \n"].concat()[..]).is_ok());
        assert_eq!(
            message(ply::read(&[&whole[..], b"\n7"].concat()[..])),
            "data: data goes on after the expected 7 rows"
        );
        let mut negative = whole.clone();
        let last = whole.len() - 8;
        negative[last..last + 4].copy_from_slice(&(-2_i32).to_le_bytes());
        assert!(message(ply::read(&negative[..])).contains("expected a whole number from 0, found -2"));
        // A list of −1 numbers, and one of 2³¹ − 1 that is not there.
        let lists = header + 3 + 3 * 14 + 2 * 3;
        for (length, named) in
            [(-1, "property data: a list of -1"), (i32::MAX, "element other: truncated, expected 2 rows, found 0")]
        {
            let mut wrong = whole.clone();
            wrong[lists..lists + 4].copy_from_slice(&length.to_le_bytes());
            let problem = message(ply::read(&wrong[..]));
            assert!(problem.contains(named), "{problem}");
        }
    }

    #[test]
    fn more_rows_than_one_window_are_read() {
        let mesh = MeshRecord {
            vertices: (0..50_000).map(|v| [f64::from(v), 0.5, -1.0]).collect(),
            faces: (0..90_000_u32).map(|f| (0..2 + f % 4).map(|i| (f + i) % 50_000).collect()).collect(),
            precision: Precision::Binary64,
            soup: false,
        };
        let mut bytes = Vec::new();
        ply::write(&mut bytes, &mesh, ply::Encoding::Binary).expect("it can be written");
        assert!(bytes.len() > 2 << 20 && ply::read(&bytes[..]).expect("as written") == mesh);
    }
}
