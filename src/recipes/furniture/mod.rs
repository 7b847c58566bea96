//! Every recipe, one file or one folder for each kind of furniture, and the list of all of them.
//!
//! To add one: a file here with a `static` [`Recipe`] beside its forms, its module line, and its line in [`RECIPES`].

mod apparatus;
mod appliances;
mod barber;
mod basins;
mod bathtub;
mod beds;
mod belongings;
mod bin;
mod boards;
mod books;
mod car;
mod carts;
mod cash_register;
mod ceiling_panel;
mod clocks;
mod coat_stand;
mod computer;
mod cooker;
mod copier;
mod counter;
mod countertop;
mod cubicle;
mod desk_lamps;
mod dispenser;
mod exhibition_wall;
mod fire_extinguisher;
mod football_table;
mod fridges;
mod gym;
mod hangings;
mod hook_board;
mod keyboard;
mod kitchen;
mod lamps;
mod laptop;
mod laundry;
mod lights;
mod lounge;
mod luggage_belt;
mod luggage_rack;
mod microwave;
mod ovens;
mod papers;
mod partition;
mod parts;
mod phone;
mod plants;
mod projection_screen;
mod projector;
mod queue_barrier;
mod radiators;
mod rugs;
mod screens;
mod sculpture;
mod seating;
mod server_rack;
mod shelving;
mod shower;
mod signage;
mod soap;
mod step_stool;
mod storage;
mod suitcase;
mod tables;
mod tableware;
mod ticket_machine;
mod toilets;
mod towels;
mod toys;
mod umbrella_stand;
mod urinal;
mod utility_sink;
mod wall_lamps;
mod windows;
mod workbench;

use super::recipe::Recipe;

/// All recipes, sorted by name.
pub(super) static RECIPES: &[&Recipe] = &[
    &lounge::ARMCHAIR,
    &seating::AUDITORIUM_SEAT,
    &barber::BARBER_CHAIR,
    &tableware::BASKET,
    &bathtub::BATHTUB,
    &seating::BEAM_SEATS,
    &beds::BED,
    &seating::BENCH,
    &bin::BIN,
    &books::BOOKS,
    &shelving::BOOKSHELF,
    &tableware::BOTTLE,
    &tableware::BOWL,
    &beds::BUNK_BED,
    &storage::CABINET,
    &car::CAR,
    &cash_register::CASH_REGISTER,
    &lights::CEILING_LAMP,
    &ceiling_panel::CEILING_PANEL,
    &seating::CHAIR,
    &apparatus::CHECKOUT,
    &apparatus::CHEST_FREEZER,
    &apparatus::CHILLED_SHELF,
    &clocks::CLOCK,
    &coat_stand::COAT_RACK,
    &countertop::COFFEE_MACHINE,
    &tables::COFFEE_TABLE,
    &computer::COMPUTER,
    &tables::CONSOLE_TABLE,
    &cooker::COOKER,
    &copier::COPIER,
    &counter::COUNTER,
    &beds::CRIB,
    &tableware::CUP,
    &windows::CURTAIN,
    &tables::DESK,
    &desk_lamps::DESK_LAMP,
    &laundry::DISHWASHER,
    &dispenser::DISPENSER,
    &shelving::DISPLAY_CASE,
    &storage::DRESSER,
    &carts::DRIP_STAND,
    &gym::DUMBBELL_RACK,
    &gym::EXERCISE_BENCH,
    &exhibition_wall::EXHIBITION_WALL,
    &storage::FILING_CABINET,
    &fire_extinguisher::FIRE_EXTINGUISHER,
    &lamps::FLOOR_LAMP,
    &football_table::FOOTBALL_TABLE,
    &fridges::FRIDGE,
    &apparatus::FUME_CUPBOARD,
    &seating::GARDEN_CHAIR,
    &tableware::GLASS,
    &gym::GOAL,
    &shelving::GONDOLA,
    &ovens::HOOD,
    &hook_board::HOOK_BOARD,
    &beds::HOSPITAL_BED,
    &countertop::KETTLE,
    &keyboard::KEYBOARD,
    &tables::LAB_BENCH,
    &laptop::LAPTOP,
    &tables::LECTERN,
    &storage::LOCKER,
    &seating::LOUNGER,
    &luggage_belt::LUGGAGE_BELT,
    &luggage_rack::LUGGAGE_RACK,
    &carts::LUGGAGE_TROLLEY,
    &shelving::MAGAZINE_RACK,
    &microwave::MICROWAVE,
    &appliances::MINIBAR,
    &hangings::MIRROR,
    &barber::MIRROR_STATION,
    &storage::NIGHTSTAND,
    &boards::NOTICE_BOARD,
    &seating::OFFICE_CHAIR,
    &papers::PAPERS,
    &partition::PARTITION,
    &lights::PENDANT,
    &phone::PHONE,
    &hangings::PICTURE,
    &belongings::PICTURE_FRAME,
    &belongings::PILLOW,
    &plants::PLANT,
    &plants::PLANTER,
    &tableware::PLATE,
    &gym::POOL_TABLE,
    &appliances::PRINTER,
    &projection_screen::PROJECTION_SCREEN,
    &projector::PROJECTOR,
    &queue_barrier::QUEUE_BARRIER,
    &radiators::RADIATOR,
    &tables::ROUND_TABLE,
    &rugs::RUG,
    &seating::SCHOOL_CHAIR,
    &sculpture::SCULPTURE,
    &server_rack::SERVER_RACK,
    &carts::SERVING_TROLLEY,
    &shelving::SHELF,
    &storage::SHOE_CABINET,
    &shower::SHOWER,
    &storage::SIDEBOARD,
    &signage::SIGNAGE,
    &plants::SMALL_PLANT,
    &soap::SOAP,
    &lounge::SOFA,
    &step_stool::STEP_STOOL,
    &seating::STOOL,
    &suitcase::SUITCASE,
    &tables::TABLE,
    &lamps::TABLE_LAMP,
    &gym::TENNIS_TABLE,
    &ticket_machine::TICKET_MACHINE,
    &toilets::TOILET,
    &cubicle::TOILET_CUBICLE,
    &carts::TOOL_TROLLEY,
    &towels::TOWEL,
    &towels::TOWEL_RAIL,
    &toys::TOY,
    &tableware::TRAY,
    &gym::TREADMILL,
    &beds::TREATMENT_BED,
    &screens::TV,
    &storage::TV_STAND,
    &umbrella_stand::UMBRELLA_STAND,
    &urinal::URINAL,
    &utility_sink::UTILITY_SINK,
    &basins::VANITY,
    &plants::VASE,
    &appliances::VENDING_MACHINE,
    &gym::WALL_BARS,
    &storage::WALL_CABINET,
    &wall_lamps::WALL_LAMP,
    &storage::WARDROBE,
    &basins::WASHBASIN,
    &laundry::WASHING_MACHINE,
    &boards::WHITEBOARD,
    &workbench::WORKBENCH,
    &kitchen::WORKTOP,
];
