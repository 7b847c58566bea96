//! Books, papers and albums on desks and tables: paperbacks are 0.11 by 0.18 m, octavo 0.15 by 0.22, ring binders 0.29 by
//! 0.32 m with backs of 0.05 or 0.08 (usual formats).

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK, Sampler, Solid, cuboid, lathe};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres of a book in a stack.
const THICKNESS: f64 = 0.035;
/// Share of a book's thickness that each cover takes, and the most metres of it.
const COVER: (f64, f64) = (0.12, 0.004);
/// Radians by which books of a stack are turned at most.
const TURN: f64 = 0.12;

/// A stack: bound books, leather with bands, ring binders, or paperbacks and magazines.
pub(super) static BOOKS: Recipe = Recipe::accessory("books", [0.2, 0.25, 0.12]).every_set(books);

fn books(draft: &Draft, builder: &mut Builder) {
    let form = draft.form();
    let mut sampler = draft.sampler();
    let bay = builder.bay();
    let set = draft.set();
    let has_glasses = set == GeometrySet::Plain && form == 3;
    // As many as the triangles of a small thing allow.
    let (thick, most) = match set {
        GeometrySet::Traditional => (THICKNESS * 1.2, 3),
        GeometrySet::Industrial => (THICKNESS * 1.6, 3),
        GeometrySet::Plain => (THICKNESS, if has_glasses { 2 } else { 5 }),
        GeometrySet::Budget => (THICKNESS * 0.7, 5),
    };
    let count = ((bay.height() / thick).round() as u32).clamp(1, most);
    let top = if has_glasses { 0.08 } else { 0.0 } * bay.height();
    for (index, row) in bay.without(Side::Above, top).rows(count, -SINK).into_iter().enumerate() {
        let is_lowest = index == 0;
        let shrink = if is_lowest { 0.0 } else { sampler.between(0.04, 0.16) };
        let turn = if is_lowest { 0.0 } else { sampler.between(-TURN, TURN) };
        let book = row.inset(bay.width() * shrink, 0.0, bay.depth() * shrink);
        let mut stack = Stack { builder, turn };
        match set {
            GeometrySet::Plain => bound(&mut stack, &mut sampler, book),
            GeometrySet::Traditional => banded(&mut stack, &mut sampler, book),
            GeometrySet::Industrial => binder(&mut stack, book, index + form),
            GeometrySet::Budget => paperback(&mut stack, &mut sampler, book, form),
        }
    }
    if top > 0.0 {
        glasses(builder, bay.slab(Side::Above, top + SINK));
    }
}

/// Adds the parts of one book, turned with it.
struct Stack<'a> {
    builder: &'a mut Builder,
    turn: f64,
}

impl Stack<'_> {
    fn add(&mut self, slot: Slot, bay: Bay) {
        self.solid(slot, cuboid(bay));
    }

    fn solid(&mut self, slot: Slot, solid: Solid) {
        self.builder.add(slot, solid.turned_y(self.turn));
    }

    /// Two covers, a spine on the left, and pages that stand back from the covers by `back` metres; gives the cover's
    /// thickness.
    fn case(&mut self, slot: Slot, book: Bay, back: f64) -> f64 {
        let cover = (book.height() * COVER.0).min(COVER.1);
        for side in [Side::Below, Side::Above] {
            self.add(slot, book.slab(side, cover));
        }
        let inner = book.inset(0.0, cover - SINK / 2.0, 0.0);
        self.add(slot, inner.slab(Side::Left, cover).inset(0.0002, 0.0, 0.0002));
        let pages = inner.without(Side::Left, cover - SINK).without(Side::Right, back);
        self.add(Slot::Paper, pages.inset(0.0, 0.0, back));
        cover
    }
}

/// A book in boards.
fn bound(stack: &mut Stack, sampler: &mut Sampler, book: Bay) {
    let slot = sampler.pick(&[Slot::Book, Slot::PaintedAccent, Slot::Leather, Slot::Linen, Slot::WoodDark]);
    stack.case(slot, book, 0.0025);
    let label = book.inset(0.0, book.height() * 0.3, book.depth() * 0.3).slab(Side::Left, 0.001);
    stack
        .add(if slot == Slot::Linen { Slot::MetalDark } else { Slot::Paper }, label.moved(-0.0004, 0.0, 0.0));
}

/// Leather with raised bands across its back and a gilt title.
fn banded(stack: &mut Stack, sampler: &mut Sampler, book: Bay) {
    let slot = sampler.pick(&[Slot::Leather, Slot::Book, Slot::WoodDark]);
    let cover = stack.case(slot, book.without(Side::Left, 0.003), 0.004);
    let back = book.slab(Side::Left, 0.0045).inset(0.0, cover * 0.5, 0.0);
    for share in [-0.3, 0.3] {
        let at = back.center() + DVec3::Z * share * book.depth();
        stack.add(slot, Bay::around(at, 0.0045, back.height(), 0.007));
    }
    let title =
        Bay::around(back.center() + DVec3::X * 0.0014, 0.003, back.height() * 0.7, book.depth() * 0.14);
    stack.add(Slot::Brass, title);
}

/// A ring binder of board, its finger hole and label on the back.
fn binder(stack: &mut Stack, book: Bay, index: usize) {
    let slot = [Slot::MetalDark, Slot::Book, Slot::PaintedAccent, Slot::Concrete][index % 4];
    stack.case(slot, book, 0.006);
    let back = book.slab(Side::Left, 0.001).moved(-0.0004, 0.0, 0.0);
    let tall = book.height() * 0.6;
    stack.add(
        Slot::Paper,
        Bay::around(back.center() - DVec3::Z * book.depth() * 0.12, 0.001, tall, book.depth() * 0.42),
    );
    let hole =
        lathe(&[(tall * 0.34, -0.001), (tall * 0.34, 0.0008)], 8).turned_z(std::f64::consts::FRAC_PI_2);
    let at = back.center() + DVec3::Z * book.depth() * 0.3;
    stack.solid(Slot::Chrome, hole.moved(at.x, at.y, at.z));
}

/// A paperback: cover and pages end in one plane; magazines where thin.
fn paperback(stack: &mut Stack, sampler: &mut Sampler, book: Bay, form: usize) {
    let slot = sampler.pick(&[Slot::PaintedAccent, Slot::Leaf, Slot::Book, Slot::Brass, Slot::FabricAccent]);
    let cover = (book.height() * 0.08).min(0.0016);
    stack.add(Slot::Paper, book.inset(0.0008, cover * 0.9, 0.0004));
    for side in [Side::Below, Side::Above] {
        stack.add(slot, book.slab(side, cover));
    }
    stack.add(slot, book.slab(Side::Left, cover).inset(0.0003, cover * 0.5, 0.0002));
    let title = book.slab(Side::Above, 0.001).moved(0.0, 0.0003, 0.0);
    let title =
        title.inset(book.width() * 0.16, 0.0, book.depth() * if form.is_multiple_of(2) { 0.36 } else { 0.2 });
    stack.add(if form < 2 { Slot::Paper } else { Slot::Linen }, title.slab(Side::Back, book.depth() * 0.2));
}

/// Reading glasses that were left on top.
fn glasses(builder: &mut Builder, bay: Bay) {
    let middle = bay.center();
    let radius = (bay.depth() * 0.12).min(0.022);
    let y = [bay.low.y, bay.high.y];
    for side in [-1.0, 1.0] {
        let x = middle.x + side * radius * 1.2;
        let rim = lathe(&[(radius, y[0]), (radius, y[1]), (radius * 0.8, y[1]), (radius * 0.8, y[0])], 8);
        builder.add(Slot::MetalDark, rim.moved(x, 0.0, middle.z));
        let arm = Bay::new(
            [x + side * radius * 0.86, x + side * radius * 1.1],
            y,
            [middle.z - radius * 3.0, middle.z],
        );
        builder.cuboid(Slot::MetalDark, arm.inset(0.0, 0.0004, 0.0));
    }
}
