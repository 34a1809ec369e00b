//! Linear programs over ℚ: the second derivation of what orientations decide.

use isoracle::complex::realise::circuit::Side;
use isoracle::number::Rational;

/// Whether Ax = b has a solution x ≥ 0: the simplex method's first phase, with Bland's rule.
pub fn is_feasible(a: &[Vec<Rational>], b: &[Rational]) -> bool {
    let (rows, columns) = (a.len(), a.first().map_or(0, Vec::len));
    // An artificial variable a row, whose sum is to become 0; the last column is the right side, not negative.
    let mut table: Vec<Vec<Rational>> = (0..rows)
        .map(|i| {
            let sign = Rational::from(if b[i] < 0 { -1 } else { 1 });
            let artificial = (0..rows).map(|j| Rational::from(u32::from(i == j)));
            let row = a[i].iter().map(|x| Rational::from(x * &sign)).chain(artificial);
            row.chain([Rational::from(&b[i] * &sign)]).collect()
        })
        .collect();
    let mut basis: Vec<usize> = (columns..columns + rows).collect();
    let last = columns + rows;
    loop {
        // How much the sum of the artificial variables falls as a variable grows.
        let gain = |j: usize| {
            let artificial = (0..rows).filter(|i| basis[*i] >= columns);
            artificial.fold(Rational::new(), |sum, i| sum + &table[i][j])
        };
        let Some(entering) = (0..columns).find(|j| !basis.contains(j) && gain(*j) > 0) else {
            return gain(last) == 0;
        };
        let rows_up = (0..rows).filter(|i| table[*i][entering] > 0);
        let ratio = |i: &usize| Rational::from(&table[*i][last] / &table[*i][entering]);
        let leaving = rows_up.min_by(|i, j| ratio(i).cmp(&ratio(j)).then(basis[*i].cmp(&basis[*j]))).expect("bounded");
        let pivot = table[leaving][entering].clone();
        table[leaving].iter_mut().for_each(|x| *x /= &pivot);
        let pivot_row = table[leaving].clone();
        for (_, row) in table.iter_mut().enumerate().filter(|(i, _)| *i != leaving) {
            let factor = row[entering].clone();
            row.iter_mut().zip(&pivot_row).for_each(|(x, p)| *x -= Rational::from(&factor * p));
        }
        basis[leaving] = entering;
    }
}

/// Whether Σλp = 0, Σλ = 0 has a solution λ ≠ 0, λ ≥ 0 at points of the first side only, ≤ 0 at those of the second only: for some
/// point its λ is 1 or −1.
pub fn meet(points: &[&[f64]], sides: &[Side]) -> bool {
    let column = |i: usize, sign: i32| -> Vec<Rational> {
        let coordinates = points[i].iter().map(|x| Rational::from_f64(*x).expect("finite"));
        coordinates.chain([Rational::from(1)]).map(|x| x * sign).collect()
    };
    let signs = |i: usize| match sides[i] {
        Side::First => vec![1],
        Side::Second => vec![-1],
        Side::Both => vec![1, -1],
    };
    (0..points.len()).any(|fixed| {
        signs(fixed).into_iter().any(|sign| {
            let others = (0..points.len()).filter(|i| *i != fixed);
            let columns: Vec<Vec<Rational>> = others
                .flat_map(|i| signs(i).into_iter().map(move |sign| (i, sign)))
                .map(|(i, s)| column(i, s))
                .collect();
            let right = column(fixed, -sign);
            let rows: Vec<Vec<Rational>> =
                (0..right.len()).map(|row| columns.iter().map(|c| c[row].clone()).collect()).collect();
            is_feasible(&rows, &right)
        })
    })
}

/// Whether a point lies in the hull of others.
pub fn is_in_hull(point: &[Rational], others: &[&[f64]]) -> bool {
    let row = |axis: usize| others.iter().map(|p| Rational::from_f64(p[axis]).expect("finite")).collect();
    let mut rows: Vec<Vec<Rational>> = (0..point.len()).map(row).collect();
    rows.push(vec![Rational::from(1); others.len()]);
    is_feasible(&rows, &[point, &[Rational::from(1)]].concat())
}
