//! Signed and mixed area (15), (16).

use isogeo::pair::{Forms, four_mixed_areas, twice_area};
use isogeo::scalar::RationalField;
use isogeo::space::{TopView, Vector2};
use proptest::prelude::*;

use super::{Draw, Verdict, laws};

laws! {
    mixed_area_is_the_polar_form_of_area
    areas_are_those_of_the_paper
    mixed_area_of_quads_comes_from_the_diagonals
}

type Polygon<Q> = Vec<TopView<Q>>;

fn any<Q: RationalField>(draw: &mut Draw<Q>, k: usize) -> Polygon<Q> {
    (0..k).map(|_| draw.top_view()).collect()
}

fn sum<Q: RationalField>(f: &Polygon<Q>, d: &Q, s: &Polygon<Q>) -> Polygon<Q> {
    f.iter().zip(s).map(|(v, w)| v + &w.position().scaled(d)).collect()
}

/// `eq-15-16-form`
fn mixed_area_is_the_polar_form_of_area<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let k = 3 + draw.index(6);
    let (f, g, s, d) = (any(draw, k), any(draw, k), any(draw, k), draw.number());
    let two = Q::from_i64(2);
    prop_assert_eq!(four_mixed_areas(&f, &s), four_mixed_areas(&s, &f));
    prop_assert_eq!(four_mixed_areas(&f, &f), twice_area(&f) * &two);
    prop_assert_eq!(
        four_mixed_areas(&sum(&f, &d, &g), &s),
        four_mixed_areas(&f, &s) + &d * four_mixed_areas(&g, &s)
    );
    let mut offset = sum(&f, &d, &s);
    prop_assert_eq!(Forms::of(&offset, &s), Forms::of(&f, &s).offset(&d));
    let shift = draw.vector();
    let moved: Polygon<Q> = f.iter().map(|v| v + &shift).collect();
    prop_assert_eq!(Forms::of(&moved, &s), Forms::of(&f, &s));

    // One corner disturbed: the area changes with the distance of the corner from a diagonal.
    let before = twice_area(&offset);
    let change = shift.det(&(&offset[2] - &offset[0]));
    offset[1] = &offset[1] + &shift;
    prop_assert_eq!(twice_area(&offset) == before, change.is_zero());
    prop_assert_eq!(twice_area(&offset), before + change);
    Ok(())
}

/// The implementation moves the first corner to the origin; here are the sums as printed.
fn areas_are_those_of_the_paper<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let k = 3 + draw.index(6);
    let (f, s) = (any(draw, k), any(draw, k));
    let det = |a: &TopView<Q>, b: &TopView<Q>| a.position().det(&b.position());
    let next = |j: usize| (j + 1) % k;
    let twice = (0..k).fold(Q::zero(), |sum, j| sum + det(&f[j], &f[next(j)]));
    let four =
        (0..k).fold(Q::zero(), |sum, j| sum + det(&f[j], &s[next(j)]) + det(&s[j], &f[next(j)]));
    prop_assert_eq!(twice_area(&f), twice);
    prop_assert_eq!(four_mixed_areas(&f, &s), four.clone());
    let reversed: Polygon<Q> = f.iter().rev().cloned().collect();
    prop_assert_eq!(twice_area(&reversed), -twice_area(&f));
    let four_with_one_more = four + Q::one();
    prop_assert_ne!(four_mixed_areas(&f, &s), four_with_one_more);
    Ok(())
}

/// The identity behind `eq-20`.
fn mixed_area_of_quads_comes_from_the_diagonals<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (f, mut s) = (any(draw, 4), any(draw, 4));
    let diagonals = |p: &Polygon<Q>| -> [Vector2<Q>; 2] { [&p[2] - &p[0], &p[3] - &p[1]] };
    let value = |s: &Polygon<Q>| {
        let ([f02, f13], [s02, s13]) = (diagonals(&f), diagonals(s));
        f02.det(&s13) + s02.det(&f13)
    };
    let before = value(&s);
    prop_assert_eq!(four_mixed_areas(&f, &s), before.clone());
    s[0].x += &Q::one();
    prop_assert_eq!(four_mixed_areas(&f, &s) == before, (&f[3] - &f[1]).y.is_zero());
    Ok(())
}
