//! Decimation of curves: fewer points, the same picture.

/// True if a number can stand on an axis. The bound keeps differences of such numbers finite.
pub(super) fn drawable(number: f64) -> bool {
    number.abs() < 1e300
}

/// The unbroken segments of a curve: it is interrupted where a point has no place.
pub(super) fn segments(
    points: &[(f64, f64)],
    has_place: impl Fn((f64, f64)) -> bool,
) -> impl Iterator<Item = &[(f64, f64)]> {
    points.split(move |&point| !has_place(point)).filter(|segment| !segment.is_empty())
}

/// Drops points that cannot be seen. Of consecutive points in one pixel column, the first, the lowest, the highest and the last remain, in
/// their order. No peak is lost, however short.
///
/// `column` gives the pixel column of an abscissa.
pub(super) fn decimate(points: &[(f64, f64)], column: impl Fn(f64) -> i32) -> Vec<(f64, f64)> {
    let mut kept = Vec::new();
    for group in points.chunk_by(|a, b| column(a.0) == column(b.0)) {
        let by_height = |&a: &usize, &b: &usize| group[a].1.total_cmp(&group[b].1);
        let lowest = (0..group.len()).min_by(by_height).unwrap_or(0);
        let highest = (0..group.len()).max_by(by_height).unwrap_or(0);
        let mut chosen = [0, lowest, highest, group.len() - 1];
        chosen.sort_unstable();
        for (position, &index) in chosen.iter().enumerate() {
            if position == 0 || chosen[position - 1] != index {
                kept.push(group[index]);
            }
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_breaks_where_it_cannot_be_drawn() {
        let points =
            [(0.0, 1.0), (1.0, f64::NAN), (2.0, 2.0), (3.0, 3.0), (f64::INFINITY, 0.0), (5.0, 1e305)];
        let found: Vec<_> = segments(&points, |(x, y)| drawable(x) && drawable(y)).collect();
        assert_eq!(found, [&points[..1], &points[2..4]]);
    }

    #[test]
    fn few_points_are_all_kept() {
        let points = [(0.0, 3.0), (1.0, 1.0), (2.0, 2.0)];
        assert_eq!(decimate(&points, |x| x as i32), points);
    }

    #[test]
    fn many_points_become_at_most_four_a_column_and_keep_a_single_spike() {
        let mut points: Vec<_> = (0..10_000).map(|i| (f64::from(i), f64::from(i % 7))).collect();
        points[5005].1 = 99.0;
        points[5006].1 = -99.0;
        let kept = decimate(&points, |x| (x / 100.0) as i32);
        assert!(kept.len() <= 400, "{}", kept.len());
        assert!(kept.contains(&points[5005]) && kept.contains(&points[5006]));
        assert_eq!((kept[0], kept[kept.len() - 1]), (points[0], points[9999]));
        assert!(kept.is_sorted_by(|a, b| a.0 < b.0));
    }

    #[test]
    fn steps_back_in_time_are_kept_in_order() {
        let points = [(0.0, 0.0), (5.0, 1.0), (0.0, 2.0)];
        assert_eq!(decimate(&points, |x| x as i32), points);
    }
}
