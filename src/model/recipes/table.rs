//! The table of recipes.

use super::input::{Draft, RecipeInput};
use super::{
    apparatus, appliances, barber, basins, bathing, beds, belongings, bin, boards, books, car, carts,
    cash_register, ceiling_panel, clocks, coat_stand, computer, cooker, copier, counter, countertop, cubicle,
    desk_lamps, dispenser, fire_extinguisher, football_table, fridges, gym, hangings, hook_board, keyboard,
    kitchen, lamps, laptop, laundry, lights, lounge, luggage_belt, luggage_rack, microwave, ovens, papers,
    partition, phone, plants, projection_screen, projector, radiators, rugs, screens, seating, server_rack,
    shelving, signage, soap, storage, tables, tableware, ticket_machine, toilets, towels, toys,
    umbrella_stand, urinal, utility_sink, wall_lamps, windows, workbench,
};
use crate::catalog::Size;
use crate::model::kit::Builder;
use crate::model::{Detail, Model};

/// One recipe.
#[derive(Debug)]
pub(crate) struct Recipe {
    /// The word in `model:` of a class.
    pub(crate) name: &'static str,
    /// Width, depth and height that it is drawn for, in metres.
    pub(crate) usual: [f64; 3],
    /// The most triangles it makes in about its usual size.
    #[cfg_attr(not(test), expect(dead_code, reason = "what the tests hold recipes to"))]
    pub(crate) most_triangles: usize,
    /// Drawn in a square seen from above and stretched to the box, because most of it is round.
    is_round: bool,
    /// Parameters with their defaults, sorted by name.
    pub(crate) parameters: &'static [(&'static str, f64)],
    /// Adds the parts.
    parts: fn(&Draft, &mut Builder),
}

/// Share of the usual size under which a piece is not drawn anew but scaled down, so that boards and legs of fixed
/// thickness still find room.
const LEAST_SHARE: f64 = 0.6;
/// The most triangles of furniture.
const LARGE: usize = 2500;
/// The most triangles of what stands on furniture, hangs on walls or gives light.
const SMALL: usize = 300;

impl Recipe {
    /// The finished model.
    pub(crate) fn build(&'static self, input: &RecipeInput) -> Model {
        self.parts(input).finish(input.size)
    }

    /// The model with fewer triangles; see [`Detail::Reduced`].
    pub(crate) fn build_reduced(&'static self, input: &RecipeInput) -> Model {
        self.parts(input).finish_reduced(input.size, Detail::REDUCED_SHARE)
    }

    /// The parts before they are fitted to the box.
    pub(crate) fn parts(&'static self, input: &RecipeInput) -> Builder {
        let mut builder = Builder::new(self.drawn_size(input.size));
        (self.parts)(&self.draft(input), &mut builder);
        builder
    }

    /// What its function is given.
    pub(crate) fn draft<'a>(&'static self, input: &'a RecipeInput<'a>) -> Draft<'a> {
        Draft { name: self.name, defaults: self.parameters, input }
    }

    fn drawn_size(&self, size: Size) -> Size {
        let [width, depth, height] = self.usual.map(|length| length * LEAST_SHARE);
        let size = Size {
            width: size.width.max(width),
            depth: size.depth.max(depth),
            height: size.height.max(height),
        };
        let side = size.width.min(size.depth);
        if self.is_round { Size { width: side, depth: side, ..size } } else { size }
    }

    const fn round(mut self) -> Self {
        self.is_round = true;
        self
    }

    const fn with(mut self, parameters: &'static [(&'static str, f64)]) -> Self {
        self.parameters = parameters;
        self
    }
}

const fn large(name: &'static str, usual: [f64; 3], parts: fn(&Draft, &mut Builder)) -> Recipe {
    Recipe { name, usual, most_triangles: LARGE, is_round: false, parameters: &[], parts }
}

const fn small(name: &'static str, usual: [f64; 3], parts: fn(&Draft, &mut Builder)) -> Recipe {
    Recipe { most_triangles: SMALL, ..large(name, usual, parts) }
}

/// All recipes, sorted by name.
pub(crate) static RECIPES: &[Recipe] = &[
    large("armchair", [0.85, 0.85, 0.82], lounge::armchair),
    large("auditorium_seat", [0.55, 0.7, 0.95], seating::auditorium_seat),
    large("barber_chair", [0.65, 0.95, 1.05], barber::barber_chair),
    small("basket", [0.35, 0.35, 0.3], tableware::basket),
    large("bathtub", [1.7, 0.75, 0.7], bathing::bathtub),
    large("beam_seats", [2.0, 0.62, 0.82], seating::beam_seats).with(&[("seats", 0.0)]),
    large("bed", [1.6, 2.1, 1.0], beds::bed).with(&[("double", 0.0)]),
    large("bench", [1.2, 0.4, 0.45], seating::bench),
    small("bin", [0.3, 0.3, 0.4], bin::bin).round(),
    small("books", [0.2, 0.25, 0.12], books::books),
    large("bookshelf", [0.9, 0.3, 2.0], shelving::bookshelf).with(&[("shelves", 0.0)]),
    small("bottle", [0.08, 0.08, 0.3], tableware::bottle),
    small("bowl", [0.22, 0.22, 0.09], tableware::bowl),
    large("bunk_bed", [1.0, 2.1, 1.7], beds::bunk_bed),
    large("cabinet", [0.8, 0.4, 1.2], storage::cabinet).with(&[("doors", 0.0)]),
    large("car", [1.8, 4.5, 1.48], car::car),
    large("cash_register", [0.4, 0.45, 0.4], cash_register::cash_register),
    small("ceiling_lamp", [0.4, 0.4, 0.12], lights::ceiling_lamp),
    small("ceiling_panel", [0.6, 0.6, 0.05], ceiling_panel::ceiling_panel),
    large("chair", [0.45, 0.5, 0.88], seating::chair),
    large("checkout", [2.2, 1.0, 0.95], apparatus::checkout),
    large("chest_freezer", [1.85, 0.9, 0.88], apparatus::chest_freezer),
    large("chilled_shelf", [1.25, 0.85, 2.0], apparatus::chilled_shelf),
    small("clock", [0.3, 0.05, 0.3], clocks::clock),
    large("coat_rack", [0.5, 0.5, 1.8], coat_stand::coat_rack),
    large("coffee_machine", [0.3, 0.4, 0.38], countertop::coffee_machine),
    large("coffee_table", [1.1, 0.6, 0.42], tables::coffee_table),
    small("computer", [0.55, 0.2, 0.45], computer::computer),
    large("console_table", [1.1, 0.35, 0.8], tables::console_table).with(&[("knees", 0.0)]),
    large("cooker", [0.6, 0.6, 0.9], cooker::cooker),
    large("copier", [0.62, 0.64, 1.05], copier::copier),
    large("counter", [2.4, 0.7, 1.1], counter::counter),
    large("crib", [0.7, 1.3, 1.0], beds::crib),
    small("cup", [0.1, 0.08, 0.09], tableware::cup),
    large("curtain", [1.6, 0.15, 2.3], windows::curtain),
    large("desk", [1.6, 0.8, 0.74], tables::desk).with(&[("drawers", 0.0)]),
    small("desk_lamp", [0.2, 0.3, 0.45], desk_lamps::desk_lamp),
    large("dishwasher", [0.6, 0.6, 0.85], laundry::dishwasher),
    small("dispenser", [0.3, 0.14, 0.35], dispenser::dispenser),
    large("display_case", [1.0, 0.5, 1.6], shelving::display_case),
    large("dresser", [1.0, 0.45, 0.85], storage::dresser).with(&[("drawers", 0.0)]),
    large("drip_stand", [0.45, 0.45, 1.9], carts::drip_stand),
    large("dumbbell_rack", [1.4, 0.55, 0.9], gym::dumbbell_rack),
    large("exercise_bench", [1.5, 1.4, 1.2], gym::exercise_bench),
    large("filing_cabinet", [0.45, 0.6, 1.3], storage::filing_cabinet).with(&[("drawers", 0.0)]),
    small("fire_extinguisher", [0.18, 0.16, 0.55], fire_extinguisher::fire_extinguisher),
    large("floor_lamp", [0.4, 0.4, 1.6], lamps::floor_lamp).round(),
    large("football_table", [1.4, 0.75, 0.9], football_table::football_table),
    large("fridge", [0.6, 0.65, 1.9], fridges::fridge),
    large("fume_cupboard", [1.5, 0.8, 2.2], apparatus::fume_cupboard),
    large("garden_chair", [0.48, 0.52, 0.85], seating::garden_chair),
    small("glass", [0.07, 0.07, 0.12], tableware::glass),
    large("gondola", [1.0, 0.45, 1.4], shelving::gondola),
    large("hood", [0.6, 0.5, 0.7], ovens::hood),
    large("hook_board", [0.9, 0.14, 0.3], hook_board::hook_board),
    large("hospital_bed", [0.99, 2.15, 1.0], beds::hospital_bed),
    small("kettle", [0.22, 0.16, 0.24], countertop::kettle),
    small("keyboard", [0.45, 0.15, 0.03], keyboard::keyboard),
    large("lab_bench", [1.8, 0.75, 0.9], tables::lab_bench),
    small("laptop", [0.34, 0.28, 0.24], laptop::laptop),
    large("lectern", [0.6, 0.5, 1.15], tables::lectern),
    large("locker", [0.9, 0.5, 1.9], storage::locker).with(&[("doors", 0.0)]),
    large("lounger", [1.9, 0.66, 0.4], seating::lounger),
    large("luggage_belt", [6.0, 1.2, 0.45], luggage_belt::luggage_belt),
    large("luggage_rack", [0.7, 0.45, 0.5], luggage_rack::luggage_rack),
    large("luggage_trolley", [0.6, 1.0, 1.0], carts::luggage_trolley),
    large("magazine_rack", [0.8, 0.35, 1.4], shelving::magazine_rack),
    small("microwave", [0.5, 0.38, 0.3], microwave::microwave),
    large("minibar", [0.5, 0.5, 0.75], appliances::minibar),
    small("mirror", [0.6, 0.03, 0.8], hangings::mirror),
    large("mirror_station", [1.0, 0.35, 1.9], barber::mirror_station),
    large("nightstand", [0.45, 0.4, 0.5], storage::nightstand),
    small("notice_board", [1.2, 0.04, 0.9], boards::notice_board),
    large("office_chair", [0.62, 0.62, 1.05], seating::office_chair).round(),
    small("papers", [0.22, 0.3, 0.02], papers::papers),
    large("partition", [1.6, 0.05, 1.6], partition::partition),
    large("pendant", [0.4, 0.4, 0.9], lights::pendant).round(),
    small("phone", [0.2, 0.22, 0.1], phone::phone),
    small("picture", [0.7, 0.03, 0.5], hangings::picture),
    small("picture_frame", [0.15, 0.08, 0.2], belongings::picture_frame),
    small("pillow", [0.5, 0.4, 0.14], belongings::pillow),
    large("plant", [0.6, 0.6, 1.4], plants::plant).round(),
    large("planter", [1.2, 0.4, 0.9], plants::planter),
    small("plate", [0.45, 0.32, 0.03], tableware::plate),
    large("pool_table", [2.54, 1.42, 0.8], gym::pool_table),
    large("printer", [0.5, 0.45, 0.4], appliances::printer),
    small("projection_screen", [2.4, 0.1, 1.8], projection_screen::projection_screen),
    small("projector", [0.35, 0.3, 0.12], projector::projector),
    large("radiator", [1.0, 0.1, 0.6], radiators::radiator),
    large("round_table", [1.1, 1.1, 0.74], tables::round_table),
    large("rug", [2.4, 1.7, 0.012], rugs::rug),
    large("school_chair", [0.42, 0.46, 0.8], seating::school_chair),
    large("server_rack", [0.6, 1.07, 2.0], server_rack::server_rack),
    large("serving_trolley", [0.8, 0.5, 0.85], carts::serving_trolley),
    large("shelf", [0.9, 0.4, 1.8], shelving::shelf),
    large("shoe_cabinet", [0.8, 0.25, 1.1], storage::shoe_cabinet),
    large("shower", [0.9, 0.9, 2.0], bathing::shower),
    large("sideboard", [1.6, 0.42, 0.8], storage::sideboard),
    small("signage", [0.6, 0.03, 0.2], signage::signage),
    small("small_plant", [0.2, 0.2, 0.3], plants::small_plant).round(),
    small("soap", [0.12, 0.08, 0.04], soap::soap),
    large("sofa", [2.2, 0.9, 0.82], lounge::sofa).with(&[("seats", 0.0)]),
    large("stool", [0.36, 0.36, 0.65], seating::stool).round(),
    large("table", [1.4, 0.8, 0.74], tables::table),
    small("table_lamp", [0.2, 0.2, 0.4], lamps::table_lamp).round(),
    large("tennis_table", [2.74, 1.525, 0.91], gym::tennis_table),
    large("ticket_machine", [0.8, 0.6, 1.85], ticket_machine::ticket_machine),
    large("toilet", [0.38, 0.68, 0.8], toilets::toilet),
    large("toilet_cubicle", [0.95, 1.5, 2.0], cubicle::toilet_cubicle),
    large("tool_trolley", [0.7, 0.46, 0.95], carts::tool_trolley),
    small("towel", [0.4, 0.3, 0.08], towels::towel),
    small("towel_rail", [0.5, 0.1, 0.8], towels::towel_rail),
    small("toy", [0.25, 0.2, 0.25], toys::toy),
    small("tray", [0.4, 0.3, 0.04], tableware::tray),
    large("treadmill", [0.85, 1.95, 1.45], gym::treadmill),
    large("treatment_bed", [0.7, 1.95, 0.85], beds::treatment_bed),
    small("tv", [1.2, 0.22, 0.75], screens::tv),
    large("tv_stand", [1.5, 0.4, 0.5], storage::tv_stand),
    small("umbrella_stand", [0.25, 0.25, 0.6], umbrella_stand::umbrella_stand).round(),
    large("urinal", [0.4, 0.36, 0.7], urinal::urinal),
    large("utility_sink", [0.6, 0.5, 1.0], utility_sink::utility_sink),
    large("vanity", [0.8, 0.5, 0.95], basins::vanity),
    small("vase", [0.15, 0.15, 0.3], plants::vase).round(),
    large("vending_machine", [0.9, 0.8, 1.85], appliances::vending_machine),
    large("wall_cabinet", [0.8, 0.35, 0.7], storage::wall_cabinet).with(&[("doors", 0.0)]),
    small("wall_lamp", [0.2, 0.2, 0.3], wall_lamps::wall_lamp),
    large("wardrobe", [1.5, 0.6, 2.1], storage::wardrobe).with(&[("doors", 0.0)]),
    large("washbasin", [0.55, 0.45, 0.95], basins::washbasin),
    large("washing_machine", [0.6, 0.6, 0.85], laundry::washing_machine).with(&[("dryer", 0.0)]),
    small("whiteboard", [1.8, 0.08, 1.2], boards::whiteboard),
    large("workbench", [2.0, 0.75, 0.98], workbench::workbench),
    large("worktop", [0.9, 0.6, 0.9], kitchen::worktop).with(&[
        ("drawers", 0.0),
        ("hob", 0.0),
        ("oven", 0.0),
        ("sink", 0.0),
    ]),
];
