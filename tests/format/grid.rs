//! Grids of one to three axes, and painted meshes.

use isoracle::format::ply_painted::{self, Painted};
use isoracle::format::{GridRecord, Limits, MeshRecord, Precision, Problem, Samples, read_grid, read_mesh, write_grid};
use std::fs;

#[test]
fn grids_of_one_to_three_axes_are_read_back() {
    let folder = tempfile::tempdir().expect("a folder");
    for shape in [vec![6], vec![2, 3], vec![3, 1, 2]] {
        let grid = GridRecord { shape, samples: Samples::F64(vec![0.5, -1.0, 3.25, 4.0, 1e-300, 6.0]) };
        let path = folder.path().join("grid.npy");
        write_grid(&path, &grid).expect("it can be written");
        assert_eq!(read_grid(&path, &Limits::default()).expect("it can be read"), grid);
        let nrrd = folder.path().join("grid.nrrd");
        match (write_grid(&nrrd, &grid), grid.shape.len()) {
            (Ok(()), 3) => assert_eq!(read_grid(&nrrd, &Limits::default()).expect("it can be read"), grid),
            (Err(error), 1 | 2) => assert!(matches!(error.problem, Problem::NotThreeAxes { .. }), "{error}"),
            (outcome, _) => panic!("{outcome:?}"),
        }
    }
}

#[test]
fn the_first_index_of_an_array_is_x() {
    // numpy.save of [[0, 1, 2], [3, 4, 5]]: x is the row.
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("rows.npy");
    let header = "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3), }";
    let header = format!("{header:<117}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.bytes());
    bytes.extend([0, 1, 2, 3, 4, 5]);
    fs::write(&path, bytes).expect("it can be written");
    let grid = read_grid(&path, &Limits::default()).expect("it can be read");
    assert_eq!(grid, GridRecord { shape: vec![2, 3], samples: Samples::U8(vec![0, 3, 1, 4, 2, 5]) });
}

#[test]
fn other_numbers_of_axes_and_samples_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("grid.npy");
    let refused = |shape: &[usize], samples: usize| {
        let grid = GridRecord { shape: shape.to_vec(), samples: Samples::U8(vec![0; samples]) };
        write_grid(&path, &grid).expect_err("it is refused").problem
    };
    assert!(matches!(refused(&[], 1), Problem::NotAGrid { .. }));
    assert!(matches!(refused(&[1, 1, 1, 1], 1), Problem::NotAGrid { .. }));
    assert!(matches!(refused(&[2, 3], 5), Problem::ShapeMismatch { .. }));
}

#[test]
fn a_painted_mesh_is_the_mesh_with_colours_and_numbers() {
    let mesh = MeshRecord {
        vertices: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.1], [0.0, 1.0, 1e-300]],
        faces: vec![vec![0, 1, 2]],
        precision: Precision::Binary64,
        soup: false,
    };
    let paint: Vec<Painted> =
        (0..3).map(|i| Painted { colour: [i, 100 + i, 255 - i], number: f64::from(i) / 3.0 }).collect();
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("painted.ply");
    ply_painted::write(&path, &mesh, "gaussian", &paint).expect("it can be written");
    assert_eq!(read_mesh(&path).expect("it can be read"), mesh);
    let bytes = fs::read(&path).expect("it is there");
    let end = bytes.windows(11).position(|w| w == b"end_header\n").expect("a header") + 11;
    let header = String::from_utf8_lossy(&bytes[..end]);
    assert!(header.contains("property uchar blue\nproperty double gaussian\n"), "{header}");
    // Three doubles, three bytes and a double a vertex.
    for (i, row) in bytes[end..end + 3 * 35].chunks(35).enumerate() {
        assert_eq!(row[24..27], paint[i].colour);
        assert_eq!(row[27..], paint[i].number.to_le_bytes());
    }
    assert!(ply_painted::write(&path, &mesh, "gaussian", &paint[1..]).is_err());
}
