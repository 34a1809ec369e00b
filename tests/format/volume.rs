//! Volumes: fixtures by hand and by numpy.

use super::*;
use std::io::Write;

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    encoder.write_all(bytes).expect("memory takes all");
    encoder.finish().expect("memory takes all")
}

mod nrrd_ {
    use super::*;

    fn read(header: &str, data: &[u8]) -> Result<VolumeRecord, Problem> {
        nrrd::read([b"NRRD0004\n", header.as_bytes(), b"\n", data].concat().as_slice(), &LIMITS)
    }

    const BYTES: &str = "type: uint8\ndimension: 3\nsizes: 2 1 2\n";

    #[test]
    fn the_first_axis_is_x_and_every_type_has_all_its_names() {
        let names = [
            ("uchar, unsigned char, uint8, uint8_t", Samples::U8(vec![1, 255])),
            ("signed char, int8, int8_t", Samples::I8(vec![1, -1])),
            ("ushort, unsigned short, unsigned short int, uint16, uint16_t", Samples::U16(vec![1, 0xFF02])),
            ("short, short int, signed short, signed short int, int16, int16_t", Samples::I16(vec![1, -2])),
            ("uint, unsigned int, uint32, uint32_t", Samples::U32(vec![1, 0xFF00_0002])),
            ("int, signed int, int32, int32_t", Samples::I32(vec![1, -2])),
            ("ulonglong, unsigned long long, unsigned long long int, uint64, uint64_t", Samples::U64(vec![1, !2])),
            (
                "longlong, long long, long long int, signed long long, signed long long int, int64, int64_t",
                Samples::I64(vec![1, -2]),
            ),
            ("float", Samples::F32(vec![0.1, f32::NEG_INFINITY])),
            ("double", Samples::F64(vec![0.1, f64::INFINITY])),
        ];
        for (names, samples) in names {
            for name in names.split(", ") {
                for (endian, bytes) in [("little", little(&samples)), ("big", big(&samples))] {
                    let header = format!("type: {name}\nendian: {endian}\ndimension: 3\nsizes: 2 1 1\nencoding: raw\n");
                    let volume = read(&header, &bytes).expect(name);
                    assert_eq!(volume, VolumeRecord { shape: [2, 1, 1], samples: samples.clone() }, "{name}");
                }
            }
        }
    }

    fn little(samples: &Samples) -> Vec<u8> {
        match samples {
            Samples::U8(v) => v.iter().flat_map(|n| n.to_le_bytes()).collect(),
            Samples::I8(v) => v.iter().flat_map(|n| n.to_le_bytes()).collect(),
            Samples::U16(v) => v.iter().flat_map(|n| n.to_le_bytes()).collect(),
            Samples::I16(v) => v.iter().flat_map(|n| n.to_le_bytes()).collect(),
            Samples::U32(v) => v.iter().flat_map(|n| n.to_le_bytes()).collect(),
            Samples::I32(v) => v.iter().flat_map(|n| n.to_le_bytes()).collect(),
            Samples::U64(v) => v.iter().flat_map(|n| n.to_le_bytes()).collect(),
            Samples::I64(v) => v.iter().flat_map(|n| n.to_le_bytes()).collect(),
            Samples::F32(v) => v.iter().flat_map(|n| n.to_le_bytes()).collect(),
            Samples::F64(v) => v.iter().flat_map(|n| n.to_le_bytes()).collect(),
        }
    }

    fn big(samples: &Samples) -> Vec<u8> {
        let mut bytes = little(samples);
        let width = bytes.len() / 2;
        bytes.chunks_exact_mut(width).for_each(<[u8]>::reverse);
        bytes
    }

    #[test]
    fn every_encoding_reads_the_same() {
        let expected = VolumeRecord { shape: [2, 1, 2], samples: Samples::U8(vec![7, 0, 200, 9]) };
        let raw = [7, 0, 200, 9];
        let two_members = [gzip(&raw[..3]), gzip(&raw[3..])].concat();
        for (header, data) in [
            ("encoding: raw\n", raw.to_vec()),
            ("# a comment\nspacings: 1 1 3\nkey:=value: 1\nencoding: RAW\n", raw.to_vec()),
            ("encoding: gzip\n", gzip(&raw)),
            ("encoding: gz\n", two_members),
            ("encoding: ascii\n", b"7 0\n200\t9\n".to_vec()),
            ("encoding: txt\n", b"7 0 200 9".to_vec()),
            ("encoding: raw\nline skip: 2\n", b"one\ntwo\n\x07\0\xc8\x09".to_vec()),
            ("encoding: raw\nline skip: 1\nbyte skip: 3\n", b"one\ntwo\x07\0\xc8\x09".to_vec()),
            ("encoding: raw\nbyte skip: -1\n", [vec![b'x'; 300_000], raw.to_vec()].concat()),
            ("encoding: gzip\nlineskip: 1\nbyteskip: 2\n", [b"line\n".to_vec(), gzip(b"ab\x07\0\xc8\x09")].concat()),
            ("encoding: text\nbyte skip: 1\n", b"!7 0 200 9".to_vec()),
        ] {
            assert_eq!(read(&format!("{BYTES}{header}"), &data).expect(header), expected, "{header}");
            let windows = format!("{BYTES}{header}").replace('\n', "\r\n");
            let windows = [b"NRRD0005\r\n", windows.as_bytes(), b"\r\n", &data].concat();
            assert_eq!(nrrd::read(&windows[..], &LIMITS).expect(header), expected, "{header}");
        }
        let four = "type: uint8\ndimension: 5\nsizes: 2 1 2 1 1\nencoding: raw\n";
        assert_eq!(read(four, &raw).expect("further axes of size 1"), expected);
    }

    #[test]
    fn an_error_names_its_field() {
        let raw = |fields: &str, data: &[u8]| message(read(&format!("{BYTES}encoding: raw\n{fields}"), data));
        assert_eq!(raw("", &[1, 2, 3]), "data: truncated, expected 4 bytes, found 3");
        assert_eq!(raw("", &[1, 2, 3, 4, 5]), "data: data goes on after the expected 4 bytes");
        assert_eq!(raw("byte skip: -1\n", &[1, 2]), "data: truncated, expected 4 bytes, found 2");
        assert_eq!(raw("byte skip: 9\n", &[1, 2]), "byte skip: truncated, expected 9 bytes, found 2");
        assert_eq!(raw("line skip: 2\n", b"x"), "line skip: truncated, expected 2 lines, found 1");
        assert!(raw("byte skip: -2\n", &[]).starts_with("byte skip: expected a whole number or -1"));
        assert_eq!(raw("type: short\n", &[]), "type: stated twice");
        assert!(raw("nonsense\n", &[]).starts_with("header: expected 'field: value'"));
        assert!(raw("data file: x.raw\n", &[]).starts_with("data file: expected data behind the header"));

        let header = |header: &str| message(read(header, &[]));
        assert_eq!(header("dimension: 3\nsizes: 1 1 1\nencoding: raw\n"), "type: missing");
        assert_eq!(header("type: short\ndimension: 3\nencoding: raw\n"), "sizes: missing");
        assert_eq!(header("type: short\ndimension: 3\nsizes: 1 1 1\n"), "encoding: missing");
        assert_eq!(header("type: short\nsizes: 1 1 1\nencoding: raw\n"), "dimension: missing");
        assert_eq!(header("type: short\ndimension: 3\nsizes: 1 1 1\nencoding: raw\n"), "endian: missing");
        let sizes =
            |dimension, sizes| header(&format!("type: int8\ndimension: {dimension}\nsizes: {sizes}\nencoding: raw\n"));
        assert_eq!(sizes(2, "4 4"), "sizes: expected three axes, found [4, 4]");
        assert_eq!(sizes(4, "3 4 4 4"), "sizes: expected three axes, found [3, 4, 4, 4]");
        assert!(sizes(3, "4 4").starts_with("sizes: expected whole numbers above 0, as many as the dimension says"));
        assert!(sizes(3, "4 -4 4").starts_with("sizes: expected whole numbers"));
        assert!(sizes(3, "4 0 4").starts_with("sizes: expected whole numbers"));
        assert_eq!(sizes(3, "64 64 17"), "sizes: [64, 64, 17] is more than the limit of 65536 samples");
        assert!(sizes(3, "4294967296 4294967296 4294967296").ends_with("more than the limit of 65536 samples"));
        let encoding = |encoding, data: &[u8]| message(read(&format!("{BYTES}encoding: {encoding}\n"), data));
        assert_eq!(encoding("hex", &[]), "encoding: expected raw, gzip, gz, ascii, text or txt, found \"hex\"");
        assert_eq!(encoding("ascii", b"1 2 3"), "data: truncated, expected 4 numbers, found 3");
        assert_eq!(encoding("ascii", b"1 2 3 4 5"), "data: data goes on after the expected 4 numbers");
        assert_eq!(encoding("ascii", b"1 2 256 4"), "data, number 2: expected uint8, found \"256\"");
        assert!(encoding("gzip", b"not gzip at all").starts_with("data, gzip: "));
        // What is bombed is not unpacked: a mebibyte of zeros is refused at its fifth byte.
        assert_eq!(encoding("gzip", &gzip(&[0; 1 << 20])), "data: data goes on after the expected 4 bytes");
        let mut wrong_checksum = gzip(&[1, 2, 3, 4]);
        let crc = wrong_checksum.len() - 8;
        wrong_checksum[crc] ^= 1;
        assert!(encoding("gzip", &wrong_checksum).starts_with("data, gzip: "));
        assert!(message(nrrd::read(&b"NRRD0006\n"[..], &LIMITS)).starts_with("not a file of the format NRRD"));
        let endless = [b"NRRD0001\n".to_vec(), b"# x\n".repeat(1 << 18)].concat();
        assert_eq!(message(nrrd::read(&endless[..], &LIMITS)), "header: no end within 1048576 bytes");
    }

    #[test]
    fn detached_data_lies_beside_its_header() {
        let folder = tempfile::tempdir().expect("a folder");
        let header = |fields: &str| {
            let path = folder.path().join("v.nhdr");
            std::fs::write(&path, format!("NRRD0004\n{BYTES}encoding: raw\n{fields}")).expect("written");
            read_volume(&path, &LIMITS)
        };
        std::fs::write(folder.path().join("the data.raw"), b"head\n\x01\x02\x03\x04").expect("written");
        let volume = header("line skip: 1\ndata file: the data.raw\n").expect("read");
        assert_eq!(volume, VolumeRecord { shape: [2, 1, 2], samples: Samples::U8(vec![1, 2, 3, 4]) });
        let message = |fields| header(fields).expect_err("refused").to_string();
        assert!(message("data file: other.raw").contains("v.nhdr: data file: expected a file that can be read"));
        assert!(message("datafile: a%03d.raw 1 2 1\n").contains("data file: expected the name of one file"));
        assert!(message("data file: LIST\n").contains("data file: expected the name of one file"));
    }

    #[test]
    fn the_sample_volume_is_a_part_of_the_head() {
        let bytes = include_bytes!("../../data/mni152_crop.nrrd");
        let volume = nrrd::read(&bytes[..], &Limits::default()).expect("the crate's own file");
        assert_eq!(volume.shape, [72, 72, 64]);
        let Samples::U8(samples) = volume.samples else { panic!("it is stored as uint8") };
        // Counted by numpy.
        assert_eq!(samples[..8], [206, 191, 169, 149, 150, 161, 158, 153]);
        assert_eq!(samples[36 + 72 * 36 + 72 * 72 * 32], 227);
        assert_eq!(samples.iter().map(|&sample| u64::from(sample)).sum::<u64>(), 59_944_987);
        assert_eq!(samples.iter().filter(|&&sample| sample < 64).count(), 14_724);
    }
}

mod npy_ {
    use super::*;

    /// A header, the blanks that numpy puts behind it, the data; each made by `np.save`.
    type Saved = (&'static [u8], usize, &'static [u8]);

    fn file((header, blanks, data): Saved) -> Vec<u8> {
        [header, &b" ".repeat(blanks), b"\n", data].concat()
    }

    /// `np.arange(24, dtype='u1').reshape(2, 3, 4)`
    const U1_C: Saved = (
        b"\x93NUMPY\x01\x00v\x00{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3, 4), }",
        55,
        b"\x00\x01\x02\x03\x04\x05\x06\x07\x08\x09\n\x0b\x0c\x0d\x0e\x0f\x10\x11\x12\x13\x14\x15\x16\x17",
    );
    /// `np.asfortranarray(np.arange(-5, 7).reshape(2, 3, 2).astype('>i2'))`
    const BIG_I2_FORTRAN: Saved = (
        b"\x93NUMPY\x01\x00v\x00{'descr': '>i2', 'fortran_order': True, 'shape': (2, 3, 2), }",
        56,
        b"\xff\xfb\x00\x01\xff\xfd\x00\x03\xff\xff\x00\x05\xff\xfc\x00\x02\xff\xfe\x00\x04\x00\x00\x00\x06",
    );
    /// `np.array([[[0.1, -np.inf], [np.nan, 1e300]]])`
    const F8_C: Saved = (
        b"\x93NUMPY\x01\x00v\x00{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2, 2), }",
        55,
        b"\x9a\x99\x99\x99\x99\x99\xb9?\0\0\0\0\0\0\xf0\xff\0\0\0\0\0\0\xf8\x7f\x9cu\x00\x88<\xe47~",
    );
    /// `np.array([[[True], [False]], [[False], [True]]])`
    const BOOL: Saved = (
        b"\x93NUMPY\x01\x00v\x00{'descr': '|b1', 'fortran_order': False, 'shape': (2, 2, 1), }",
        55,
        b"\x01\x00\x00\x01",
    );
    /// `np.zeros((2, 2), dtype='u1')`
    const TWO_AXES: Saved =
        (b"\x93NUMPY\x01\x00v\x00{'descr': '|u1', 'fortran_order': False, 'shape': (2, 2), }", 58, b"\0\0\0\0");
    /// `np.zeros((1, 1, 1), dtype='c8')`
    const COMPLEX: Saved = (
        b"\x93NUMPY\x01\x00v\x00{'descr': '<c8', 'fortran_order': False, 'shape': (1, 1, 1), }",
        55,
        b"\0\0\0\0\0\0\0\0",
    );

    fn read(saved: Saved) -> Result<VolumeRecord, Problem> {
        npy::read(&file(saved)[..], &LIMITS)
    }

    #[test]
    fn the_first_index_is_x_in_either_memory_order() {
        // Element [x, y, z] of the first array is 4(3x + y) + z.
        let samples = (0..4).flat_map(|z| (0..3).flat_map(move |y| (0..2).map(move |x| 4 * (3 * x + y) + z)));
        let expected = VolumeRecord { shape: [2, 3, 4], samples: Samples::U8(samples.collect()) };
        assert_eq!(read(U1_C).expect("C order"), expected);
        // Element [x, y, z] of the second is 2(3x + y) + z − 5.
        let samples = (0..2).flat_map(|z| (0..3).flat_map(move |y| (0..2).map(move |x| 2 * (3 * x + y) + z - 5)));
        let expected = VolumeRecord { shape: [2, 3, 2], samples: Samples::I16(samples.collect()) };
        assert_eq!(read(BIG_I2_FORTRAN).expect("Fortran order, big endian"), expected);
        let expected = VolumeRecord { shape: [2, 2, 1], samples: Samples::U8(vec![1, 0, 0, 1]) };
        assert_eq!(read(BOOL).expect("booleans"), expected);
        let volume = read(F8_C).expect("NaN and infinities are kept");
        assert_eq!(format!("{:?}", volume.samples), "F64([0.1, NaN, -inf, 1e300])");
    }

    #[test]
    fn an_error_names_its_field() {
        assert_eq!(message(read(TWO_AXES)), "shape: expected three axes, found [2, 2]");
        assert!(message(read(COMPLEX)).starts_with("descr: expected 'u1'"));
        let whole = file(F8_C);
        let cut = |end| message(npy::read(&whole[..end], &LIMITS));
        assert_eq!(cut(whole.len() - 1), "data: truncated, expected 32 bytes, found 31");
        assert_eq!(cut(100), "header: truncated, expected 128 bytes, found 100");
        let long = [&whole[..], b"x"].concat();
        assert_eq!(message(npy::read(&long[..], &LIMITS)), "data: data goes on after the expected 32 bytes");
        let limits = Limits { samples: 3 };
        let over = message(npy::read(&whole[..], &limits));
        assert_eq!(over, "shape: [1, 2, 2] is more than the limit of 3 samples");
        assert!(message(npy::read(&b"hello, world"[..], &LIMITS)).starts_with("not a file of the format NPY"));
        // Neither a header of 4 GiB nor one nested 60,000 deep is given to the parser.
        let huge = b"\x93NUMPY\x02\x00\xff\xff\xff\xff{}";
        assert_eq!(message(npy::read(&huge[..], &LIMITS)), "header: no end within 65536 bytes");
        let deep = [b"\x93NUMPY\x01\x00\x60\xea".to_vec(), b"(".repeat(60_000)].concat();
        assert!(message(npy::read(&deep[..], &LIMITS)).starts_with("descr: "));
    }
}
