//! Any record comes back as it was written; any bytes are read or refused.

use super::*;
use proptest::prelude::*;

fn samples() -> impl Strategy<Value = VolumeRecord> {
    let shape = [1..5_usize, 1..5, 1..5];
    shape.prop_flat_map(|shape| {
        let n = shape.iter().product::<usize>();
        let samples = prop_oneof![
            prop::collection::vec(any::<u8>(), n).prop_map(Samples::U8),
            prop::collection::vec(any::<i8>(), n).prop_map(Samples::I8),
            prop::collection::vec(any::<u16>(), n).prop_map(Samples::U16),
            prop::collection::vec(any::<i16>(), n).prop_map(Samples::I16),
            prop::collection::vec(any::<u32>(), n).prop_map(Samples::U32),
            prop::collection::vec(any::<i32>(), n).prop_map(Samples::I32),
            prop::collection::vec(any::<u64>(), n).prop_map(Samples::U64),
            prop::collection::vec(any::<i64>(), n).prop_map(Samples::I64),
            prop::collection::vec(prop::num::f32::ANY, n).prop_map(Samples::F32),
            prop::collection::vec(prop::num::f64::ANY, n).prop_map(Samples::F64),
        ];
        samples.prop_map(move |samples| VolumeRecord { shape, samples })
    })
}

fn mesh() -> impl Strategy<Value = MeshRecord> {
    let vertices = prop::collection::vec(prop::array::uniform3(prop::num::f64::ANY), 0..9);
    let faces = prop::collection::vec(prop::collection::vec(any::<u32>(), 0..6), 0..9);
    (vertices, faces).prop_map(|(vertices, faces)| MeshRecord {
        vertices,
        faces,
        precision: Precision::Binary64,
        soup: false,
    })
}

/// Equal but for which NaN a NaN is.
fn same<T: std::fmt::Debug>(a: &T, b: &T) -> Result<(), TestCaseError> {
    prop_assert_eq!(format!("{a:?}"), format!("{b:?}"));
    Ok(())
}

/// Reads bytes as every format: what comes back is a record or an error, and an error has a message.
fn read_as_everything(bytes: &[u8]) {
    let volumes = [nrrd::read(bytes, &LIMITS), npy::read(bytes, &LIMITS)];
    let meshes = [ply::read(bytes), stl::read(bytes), obj::read(bytes), off::read(bytes)];
    for volume in volumes {
        match volume {
            Ok(volume) => assert_eq!(volume.samples.len(), volume.shape.iter().product::<usize>()),
            Err(problem) => assert!(!problem.to_string().is_empty()),
        }
    }
    for problem in meshes.into_iter().filter_map(Result::err) {
        assert!(!problem.to_string().is_empty());
    }
}

fn written<E: std::fmt::Debug>(write: impl FnOnce(&mut Vec<u8>) -> Result<(), E>) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(&mut bytes).expect("a sound record can be written");
    bytes
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn volumes_come_back(volume in samples()) {
        for encoding in [nrrd::Encoding::Raw, nrrd::Encoding::Gzip, nrrd::Encoding::Ascii] {
            let bytes = written(|out| nrrd::write(out, &volume, encoding));
            same(&nrrd::read(&bytes[..], &LIMITS).expect("as written"), &volume)?;
        }
        let bytes = written(|out| npy::write(out, &volume));
        same(&npy::read(&bytes[..], &LIMITS).expect("as written"), &volume)?;
    }

    #[test]
    fn meshes_come_back(mut mesh in mesh()) {
        for encoding in [ply::Encoding::Binary, ply::Encoding::Ascii] {
            let bytes = written(|out| ply::write(out, &mesh, encoding));
            same(&ply::read(&bytes[..]).expect("as written"), &mesh)?;
        }
        let bytes = written(|out| obj::write(out, &mesh));
        same(&obj::read(&bytes[..]).expect("as written"), &mesh)?;
        let bytes = written(|out| off::write(out, &mesh));
        same(&off::read(&bytes[..]).expect("as written"), &mesh)?;
        // STL: a soup of binary32.
        mesh.vertices.truncate(mesh.vertices.len() / 3 * 3);
        mesh.vertices.iter_mut().flatten().for_each(|c| *c = f64::from(*c as f32));
        mesh.faces = (0..mesh.vertices.len() as u32).step_by(3).map(|i| vec![i, i + 1, i + 2]).collect();
        (mesh.precision, mesh.soup) = (Precision::Binary32, true);
        let bytes = written(|out| stl::write(out, &mesh));
        same(&stl::read(&bytes[..]).expect("as written"), &mesh)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn damaged_files_are_read_or_refused(
        which in any::<prop::sample::Index>(),
        volume in samples(),
        mesh in mesh(),
        bytes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..4),
        words in prop::collection::vec((any::<prop::sample::Index>(), "(-?[0-9]{1,20}|[(\\[{:%/#\\\\]|\n|nan|1e999)"), 0..3),
        end in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let triangles = MeshRecord { faces: vec![vec![0, 0, 0]; mesh.vertices.len().min(2)], ..mesh.clone() };
        let files = [
            written(|out| nrrd::write(out, &volume, nrrd::Encoding::Raw)),
            written(|out| nrrd::write(out, &volume, nrrd::Encoding::Gzip)),
            written(|out| nrrd::write(out, &volume, nrrd::Encoding::Ascii)),
            written(|out| npy::write(out, &volume)),
            written(|out| ply::write(out, &mesh, ply::Encoding::Binary)),
            written(|out| ply::write(out, &mesh, ply::Encoding::Ascii)),
            written(|out| obj::write(out, &mesh)),
            written(|out| off::write(out, &mesh)),
            written(|out| stl::write(out, &triangles)),
            TWO_TRIANGLES.to_vec(),
        ];
        let mut file = which.get(&files).clone();
        for (place, byte) in &bytes {
            if !file.is_empty() {
                let place = place.index(file.len());
                file[place] = *byte;
            }
        }
        for (place, word) in &words {
            let place = place.index(file.len() + 1);
            file.splice(place..place, word.bytes());
        }
        if let Some(end) = end {
            file.truncate(end.index(file.len() + 1));
        }
        read_as_everything(&file);
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..300), magic in 0..7_usize) {
        let magic: &[u8] = [&b""[..], b"NRRD0004\n", b"\x93NUMPY\x01\x00", b"ply\nformat ascii 1.0\n", b"solid x\n", b"v ", b"OFF\n"][magic];
        read_as_everything(&[magic, &bytes].concat());
    }
}

const TWO_TRIANGLES: &[u8] = b"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n\
    endfacet\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid x\n";
