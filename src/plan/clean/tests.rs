//! Rings and holes as real drawings have them.

use super::holes::{HoleFault, clean_region};
use super::{Ring, RingFault, clean_ring, refuse_sliver};
use crate::geometry::{Point, PolygonFault, Segment};
use crate::plan::sample::points;

fn cleaned(list: &[(f64, f64)]) -> Ring {
    clean_ring(&points(list), &[]).unwrap()
}

fn corners(ring: &Ring) -> Vec<(f64, f64)> {
    let round = |value: f64| (value * 1000.0).round() / 1000.0;
    ring.polygon.corners().iter().map(|corner| (round(corner.x), round(corner.y))).collect()
}

const SQUARE: [(f64, f64); 4] = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];

#[test]
fn edges_of_a_clockwise_ring_keep_their_numbers() {
    let ring = cleaned(&[(0.0, 0.0), (0.0, 4.0), (4.0, 4.0), (4.0, 0.0)]);
    for (Segment { start, end }, edge) in ring.polygon.edges().zip(&ring.edges) {
        let expected = match edge.unwrap() {
            0 => start.x == 0.0 && end.x == 0.0,
            1 => start.y == 4.0 && end.y == 4.0,
            2 => start.x == 4.0 && end.x == 4.0,
            _ => start.y == 0.0 && end.y == 0.0,
        };
        assert!(expected, "edge {edge:?} from {start} to {end}");
    }
}

#[test]
fn repeated_and_closing_corners_vanish() {
    let ring = cleaned(&[(0.0, 0.0), (0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (4.0, 4.0), (0.0, 4.0), (0.0, 0.0)]);
    assert_eq!(corners(&ring), SQUARE);
    assert_eq!(ring.edges, [1, 2, 4, 5].map(Some));
}

#[test]
fn spikes_vanish_also_one_after_the_other() {
    let out = [(4.0, 0.0), (6.0, 0.0), (4.0, 0.0005)];
    let twice = [(4.0, 4.0), (4.0, 7.0), (5.0, 7.0), (4.0, 7.0005), (4.0005, 4.0)];
    let mut list = vec![(0.0, 0.0)];
    list.extend(out);
    list.extend(twice);
    list.push((0.0, 4.0));
    let ring = cleaned(&list);
    assert_eq!(corners(&ring).len(), 4);
    assert!((ring.polygon.area() - 16.0).abs() < 0.01);
}

#[test]
fn corners_two_centimetres_apart_meet_where_their_walls_meet() {
    // A corner cut off by 1 cm becomes the corner again.
    let ring = cleaned(&[(0.0, 0.0), (4.0, 0.0), (4.0, 3.99), (3.99, 4.0), (0.0, 4.0)]);
    assert_eq!(corners(&ring), SQUARE);
    assert_eq!(ring.edges, [0, 1, 3, 4].map(Some));
}

#[test]
fn corners_that_do_not_bend_vanish_unless_tags_change_there() {
    let list = [(0.0, 0.0), (2.0, 0.001), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
    assert_eq!(corners(&cleaned(&list)), SQUARE);
    let tagged = clean_ring(&points(&list), &[1, 0, 0, 0, 0]).unwrap();
    assert_eq!(tagged.polygon.corners().len(), 5);
}

#[test]
fn a_gentle_arc_keeps_its_shape() {
    let arc: Vec<Point> = (0..=60)
        .map(|step| {
            let (sine, cosine) = libm::sincos(f64::from(step) * std::f64::consts::PI / 60.0);
            Point::new(cosine, sine) * 5.0
        })
        .collect();
    let ring = clean_ring(&arc, &[]).unwrap();
    let half_disc = std::f64::consts::PI * 12.5;
    assert!((ring.polygon.area() - half_disc).abs() < 0.2, "{}", ring.polygon.area());
}

#[test]
fn joining_never_breaks_a_ring() {
    // A slot 1.5 cm wide between two rooms' worth of floor: its four corners may not meet in pairs.
    let list =
        [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.015, 4.0), (2.015, 0.5), (2.0, 0.5), (2.0, 4.0), (0.0, 4.0)];
    let ring = cleaned(&list);
    assert!(ring.polygon.area() > 15.9);
}

#[test]
fn faults_name_the_point_as_found() {
    let crossing = clean_ring(&points(&[(0.0, 0.0), (0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)]), &[]);
    assert!(matches!(crossing, Err(RingFault::Polygon(PolygonFault::SelfCrossing(_, 3)))), "{crossing:?}");
    let mut list = points(&SQUARE);
    list[2].x = f64::NAN;
    assert_eq!(clean_ring(&list, &[]).unwrap_err(), RingFault::Polygon(PolygonFault::NotFinite(2)));
    list[2].x = 1e9;
    assert!(matches!(clean_ring(&list, &[]), Err(RingFault::TooFar(2, _))));
    let many = vec![Point::ZERO; 5000];
    assert_eq!(clean_ring(&many, &[]).unwrap_err(), RingFault::TooManyCorners(5000));
    assert!(clean_ring(&[], &[]).is_err());
}

#[test]
fn slivers_are_small_or_thin() {
    let refused = |list: &[(f64, f64)]| refuse_sliver(cleaned(list), 0.05).is_err();
    assert!(refused(&[(0.0, 0.0), (0.2, 0.0), (0.2, 0.2), (0.0, 0.2)]));
    assert!(refused(&[(0.0, 0.0), (9.0, 0.0), (9.0, 0.015), (0.0, 0.015)]));
    assert!(!refused(&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.1), (0.0, 0.1)]));
}

fn with_holes(holes: &[&[(f64, f64)]]) -> (f64, usize, Vec<HoleFault>) {
    let holes: Vec<Vec<Point>> = holes.iter().map(|hole| points(hole)).collect();
    let region = clean_region(cleaned(&SQUARE), &holes);
    let cut: f64 = region.holes.iter().map(crate::geometry::Polygon::area).sum();
    (region.ring.polygon.area() - cut, region.holes.len(), region.faults)
}

#[test]
fn holes_inside_stay_as_they_are() {
    let (area, count, faults) = with_holes(&[
        &[(1.0, 1.0), (1.0, 2.0), (2.0, 2.0), (2.0, 1.0)],
        &[(3.0, 3.0), (3.5, 3.0), (3.5, 3.5)],
    ]);
    assert_eq!((area, count, faults), (16.0 - 1.0 - 0.125, 2, vec![]));
}

#[test]
fn a_hole_on_the_border_becomes_a_notch() {
    let (area, count, faults) = with_holes(&[&[(1.0, -1.0), (2.0, -1.0), (2.0, 1.0), (1.0, 1.0)]]);
    assert!((area - 15.0).abs() < 0.05, "{area}");
    assert_eq!((count, faults), (0, vec![HoleFault::Merged]));
}

#[test]
fn touching_holes_are_merged() {
    let (area, count, faults) = with_holes(&[
        &[(1.0, 1.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0)],
        &[(2.0, 1.5), (3.0, 1.5), (3.0, 2.5), (2.0, 2.5)],
    ]);
    assert!((area - 14.0).abs() < 0.1, "{area}");
    assert_eq!((count, faults), (1, vec![HoleFault::Merged]));
}

#[test]
fn a_hole_that_splits_a_room_leaves_its_larger_part() {
    let (area, count, faults) = with_holes(&[&[(1.0, -1.0), (1.5, -1.0), (1.5, 5.0), (1.0, 5.0)]]);
    assert!((area - 10.0).abs() < 0.1, "{area}");
    assert_eq!((count, faults[0].clone()), (0, HoleFault::Merged));
    assert!(matches!(faults[1], HoleFault::CutOff(lost) if (lost - 4.0).abs() < 0.1));
}

#[test]
fn unusable_holes_are_named() {
    let everything: &[(f64, f64)] = &[(-1.0, -1.0), (5.0, -1.0), (5.0, 5.0), (-1.0, 5.0)];
    assert_eq!(with_holes(&[everything]).2, [HoleFault::AllDropped]);
    let (area, _, faults) = with_holes(&[&[(1.0, 1.0), (1.01, 1.0), (1.01, 1.01), (1.0, 1.01)], &[]]);
    assert_eq!(area, 16.0);
    assert!(matches!(faults[..], [HoleFault::Ring(0, _), HoleFault::Ring(1, _)]), "{faults:?}");
}
