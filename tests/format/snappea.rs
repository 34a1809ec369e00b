//! Triangulation files of SnapPea: as SnapPy and Regina write them, and broken.

use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, three_torus};
use isoracle::complex::gluing_table::TableError;
use isoracle::complex::isosig::{signature, triangulation};
use isoracle::complex::triangulation::{Triangulation, TriangulationError};
use isoracle::format::Problem;
use isoracle::format::snappea::{Cusp, CuspSurface, Orientability, SnapPeaRecord, Solution, read, write};
use proptest::prelude::*;

/// The complement of the figure-eight knot, as SnapPy 3.3 writes it.
const FIGURE_EIGHT: &str = include_str!("m004.tri");

fn text(record: &SnapPeaRecord) -> String {
    let mut bytes = Vec::new();
    write(&mut bytes, record).expect("it can be written");
    String::from_utf8(bytes).expect("text")
}

fn message(text: &str) -> String {
    read(text.as_bytes()).expect_err("it is broken").to_string()
}

/// A file of L(3, 1).
fn lens() -> String {
    let complex = ClosedComplex::new(lens_space(3, 1)).expect("a complex");
    text(&SnapPeaRecord::of_rows("L(3,1)", complex.tetrahedra().rows()))
}

mod cx_96 {
    use super::*;

    #[test]
    fn a_triangulation_is_written_and_read_back() {
        for scheme in [lens_space(1, 0), lens_space(3, 1), lens_space(5, 2), three_torus()] {
            let complex = ClosedComplex::new(scheme).expect("a complex");
            for t in [complex.tetrahedra(), complex.barycentric()] {
                let record = SnapPeaRecord::of_rows("any name", t.rows());
                let read = read(text(&record).as_bytes()).expect("our own file");
                assert_eq!(read, record);
                assert_eq!(Triangulation::of_rows(read.rows()), Ok(t));
            }
        }
    }

    #[test]
    fn a_file_of_regina_is_ours() {
        // Triangulation3.fromIsoSig("bkaaid").snapPea(), Regina 7.4.
        let regina = "% Triangulation\nRegina_Triangulation\nnot_attempted 0.0\nunknown_orientability\nCS_unknown\n0 0\n1\n   0    0    0    0 \n 1203 2013 0231 0312\n  -1   -1   -1   -1 \n  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0\n  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0\n  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0\n  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0  0\n0.0 0.0\n";
        let record = read(regina.as_bytes()).expect("a file of Regina");
        let t = Triangulation::of_rows(record.rows()).expect("closed");
        assert_eq!(signature(&t), "bkaaid");
        let own = text(&SnapPeaRecord::of_rows("Regina_Triangulation", t.rows()));
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(words(&own), words(regina));
    }

    #[test]
    fn a_file_of_snappy_keeps_all_that_it_says() {
        let record = read(FIGURE_EIGHT.as_bytes()).expect("a file of SnapPy");
        assert_eq!((record.name.as_str(), record.tetrahedra.len()), ("m004", 2));
        assert_eq!((record.solution, record.orientability), (Solution::Geometric, Orientability::Oriented));
        assert!((record.volume - 2.029_883_21).abs() < 1e-8);
        assert_eq!(record.cusps, [Cusp { surface: CuspSurface::Torus, filling: [0.0, 0.0] }]);
        assert_eq!(record.tetrahedra[1].cusps, [0; 4]);
        assert!(record.tetrahedra.iter().any(|t| t.peripheral_curves.as_flattened().contains(&-1)));
        assert!((record.tetrahedra[0].shape[1] - 0.75_f64.sqrt()).abs() < 1e-9);
        assert_eq!(record.chern_simons, None);
        assert_eq!(read(text(&record).as_bytes()).expect("our own file"), record);
        // Regina 7.4, Example3.figureEight().isoSig().
        let t = Triangulation::of_rows(record.rows()).expect("closed, with an ideal vertex");
        assert_eq!(signature(&t), "cPcbbbiht");
        assert_eq!(triangulation("cPcbbbiht").map(|t| t.skeleton().counts), Ok([1, 2, 4, 2]));
    }

    #[test]
    fn rows_that_do_not_fit_one_another_are_no_triangulation() {
        let mut record = read(lens().as_bytes()).expect("our own file");
        record.tetrahedra[1].gluings[2] = [0, 0, 1, 2];
        let images = [0, 0, 1, 2];
        let error = TableError::NoPermutation { tetrahedron: 1, triangle: 2, images };
        assert_eq!(Triangulation::of_rows(record.rows()), Err(error));
        let mut record = read(lens().as_bytes()).expect("our own file");
        record.tetrahedra[0].neighbours[0] = 3;
        let error = TriangulationError::NoSuchTetrahedron { tetrahedron: 0, triangle: 0 };
        assert_eq!(Triangulation::of_rows(record.rows()), Err(TableError::Gluings(error)));
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 50, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn any_record_is_written_and_read_back(
            name in "[!-~]( ?[!-~]){0,20}", reals in prop::array::uniform4(-1e300_f64..1e300), whole: [i32; 4], tori in 0..3_usize, bottles in 0..3_usize,
        ) {
            let mut record = read(lens().as_bytes()).expect("our own file");
            record.name = name;
            record.volume = reals[0];
            record.chern_simons = (whole[0] % 2 == 0).then_some(reals[1]);
            record.solution = [Solution::Flat, Solution::Degenerate, Solution::None][tori];
            record.orientability = [Orientability::Nonorientable, Orientability::Oriented, Orientability::Unknown][bottles];
            let cusp = |surface| Cusp { surface, filling: [reals[2], reals[3]] };
            record.cusps = vec![cusp(CuspSurface::KleinBottle); bottles];
            record.cusps.extend(vec![cusp(CuspSurface::Torus); tori]);
            record.tetrahedra[1].cusps = whole;
            record.tetrahedra[2].peripheral_curves[3][15] = whole[1];
            record.tetrahedra[0].shape = [reals[3], reals[0]];
            prop_assert_eq!(read(text(&record).as_bytes()).expect("our own file"), record);
        }

        #[test]
        fn a_broken_file_is_refused(at: usize, byte in any::<u8>(), cut: bool) {
            let mut bytes = lens().into_bytes();
            let at = at % bytes.len();
            if cut { bytes.truncate(at) } else { bytes[at] = byte }
            // No panic; and what is cut before its last number is never read.
            let is_read = read(&bytes[..]).is_ok();
            prop_assert!(!(cut && is_read && at + 8 < lens().len()));
        }
    }
}

#[test]
fn what_is_wrong_with_a_file_is_told_with_its_line() {
    let good = lens();
    let lines: Vec<&str> = good.lines().collect();
    let with = |line: usize, other: &str| {
        let mut lines = lines.clone();
        lines[line - 1] = other;
        lines.join("\n")
    };
    for (text, expected) in [
        ("".to_owned(), r#"not a file of the format SnapPea: it begins with """#),
        ("% Link Projection\n".to_owned(), r#"not a file of the format SnapPea: it begins with "% Link Projection""#),
        ("% Triangulation".to_owned(), "name: missing"),
        ("% Triangulation\nname".to_owned(), "solution: missing"),
        (with(3, "attempted 0.0"), r#"line 3: solution: expected the kind of a solution, found "attempted""#),
        (with(3, "flat_solution NaN"), r#"line 3: volume: expected a number, found "NaN""#),
        (with(3, "flat_solution inf"), r#"line 3: volume: expected a number, found "inf""#),
        (with(4, "orientable"), r#"line 4: orientability: expected a word on orientability, found "orientable""#),
        (with(5, "CS_known x"), r#"line 5: Chern-Simons: expected a number, found "x""#),
        (with(5, "CS"), r#"line 5: Chern-Simons: expected CS_known or CS_unknown, found "CS""#),
        (with(6, "-1 0"), r#"line 6: tori: expected a count, found "-1""#),
        (with(6, "1 0 Klein 0 0"), r#"line 6: cusps: expected as many tori as the count says, found "0""#),
        (with(6, "0 1 sphere 0 0"), r#"line 6: cusp: expected torus or Klein, found "sphere""#),
        (with(7, "2.5"), r#"line 7: tetrahedra: expected a count, found "2.5""#),
        (with(7, "4000000000"), "neighbour: missing"),
        (with(7, "2"), "line 24: data goes on after the expected 2 tetrahedra"),
        (with(8, "0 1 -2 2"), r#"line 8: neighbour: expected the number of a tetrahedron, found "-2""#),
        (with(9, " 0123 0124 0123 0123"), r#"line 9: gluing: expected four of the digits 0, 1, 2, 3, found "0124""#),
        (with(9, " 0123 01 0123 0123"), r#"line 9: gluing: expected four of the digits 0, 1, 2, 3, found "01""#),
        (with(10, " -1 -1 -1 x"), r#"line 10: cusp of a corner: expected the number of a cusp, or -1, found "x""#),
        (with(15, "0.0 i"), r#"line 15: shape: expected a number, found "i""#),
        (lines[..lines.len() - 1].join("\n"), "shape: missing"),
        (good.clone() + "0", "line 32: data goes on after the expected 3 tetrahedra"),
    ] {
        assert_eq!(message(&text), expected);
    }
    assert!(matches!(read(&b"% Triangulation\n\xff\n"[..]), Err(Problem::Io(_))));
}

#[test]
fn what_a_file_cannot_hold_is_not_written() {
    let record = read(lens().as_bytes()).expect("our own file");
    let broken = [
        SnapPeaRecord { name: "two\nlines".to_owned(), ..record.clone() },
        SnapPeaRecord { volume: f64::NAN, ..record.clone() },
        SnapPeaRecord { chern_simons: Some(f64::INFINITY), ..record.clone() },
        {
            let mut record = record.clone();
            record.tetrahedra[1].gluings[3][2] = 4;
            record
        },
        {
            let mut record = record.clone();
            record.tetrahedra[2].shape[1] = f64::NAN;
            record
        },
    ];
    for record in broken {
        assert!(matches!(write(Vec::new(), &record), Err(Problem::Invalid { .. })));
    }
}
