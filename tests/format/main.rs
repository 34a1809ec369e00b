//! The readers and writers of `isoracle::format`: fixtures by hand and by numpy, other libraries as second witnesses,
//! round trips, and any bytes at all.
#![cfg(feature = "cli")]

use isoracle::format::{
    FormatError, Limits, MeshRecord, Precision, Problem, Samples, VolumeRecord, npy, nrrd, obj, off, ply,
    read_flat_mesh, read_mesh, read_volume, stl, write_mesh, write_volume,
};

mod any;
mod grid;
mod mesh;
mod off_;
mod snappea;
mod volume;

const LIMITS: Limits = Limits { samples: 1 << 16 };

fn message<T: std::fmt::Debug>(result: Result<T, Problem>) -> String {
    result.expect_err("this must be refused").to_string()
}

#[test]
fn the_extension_says_the_format() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let volume = VolumeRecord { shape: [2, 1, 1], samples: Samples::F32(vec![0.5, -0.0]) };
    for name in ["v.nrrd", "v.npy", "v.NRRD"] {
        write_volume(&at(name), &volume).expect(name);
        assert_eq!(read_volume(&at(name), &LIMITS).expect(name), volume);
    }
    let mesh = obj::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0.1\nf 1 2 3\n"[..]).expect("a triangle");
    for name in ["m.ply", "m.obj", "m.off", "m.OFF"] {
        write_mesh(&at(name), &mesh).expect(name);
        assert_eq!(read_mesh(&at(name)).expect(name), mesh);
        let flat = read_flat_mesh(&at(name)).expect(name);
        assert_eq!((&flat.vertices, &flat.corners[..], &flat.ends[..]), (&mesh.vertices, &[0, 1, 2][..], &[3][..]));
    }
    write_mesh(&at("m.stl"), &mesh).expect("a triangle");
    assert_eq!(read_mesh(&at("m.stl")).expect("a triangle").vertices[2], [0.0, 1.0, f64::from(0.1_f32)]);

    let message = |result: Result<(), FormatError>| result.expect_err("refused").to_string();
    assert!(
        message(read_mesh(&at("m.vtk")).map(drop))
            .ends_with("unknown extension \"vtk\", expected one of ply, stl, obj, off")
    );
    assert!(message(write_volume(&at("v"), &volume)).ends_with("unknown extension \"\", expected one of nrrd, npy"));
    assert!(message(read_volume(&at("none.npy"), &LIMITS).map(drop)).contains("none.npy: "));
    let wrong = VolumeRecord { shape: [2, 2, 1], ..volume };
    assert!(message(write_volume(&at("wrong.npy"), &wrong)).ends_with("shape: [2, 2, 1] does not fit 2 samples"));
    assert!(!at("wrong.npy").exists());
}
