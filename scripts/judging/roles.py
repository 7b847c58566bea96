"""What pieces are for, by the names of their classes.

This is the judge's own list. It does not read the catalogue, so that a class that says nonsense about itself is still
judged as what its name says it is.
"""

from __future__ import annotations

SINKS = {"sink_unit", "sink"}
COOKERS = {"cooker", "hob_unit", "hob"}
FRIDGES = {"fridge", "small_fridge"}
DISHWASHERS = {"dishwasher"}
ISLANDS = {"kitchen_island"}
# What carries a worktop between sink and cooker.
WORKTOPS = {"worktop", "prep_worktop", "landing_worktop", "corner_unit", "kitchen_unit", "filler_unit"} | DISHWASHERS
APPLIANCES = COOKERS | FRIDGES | DISHWASHERS
KITCHEN_UNITS = SINKS | APPLIANCES | ISLANDS | WORKTOPS | {"oven_tower", "tall_unit", "larder", "end_panel"}

TABLES = {"kitchen_table", "dining_table", "large_dining_table", "small_table", "folding_table", "bistro_table", "cafe_table",
          "round_table", "restaurant_table", "table_for_two", "garden_table", "terrace_table", "reading_table", "bar_table",
          "kitchen_island", "meeting_table", "small_meeting_table", "large_meeting_table", "canteen_table", "staff_table",
          "seminar_table"}
CHAIRS = {"chair", "dining_chair", "restaurant_chair", "meeting_chair"}

SCREENS = {"tv", "small_tv", "wall_tv", "hotel_tv", "large_hotel_tv", "living_wall_tv"}
PROJECTION = {"projector", "projection_screen"}
TV_STANDS = {"tv_stand", "wide_tv_stand", "lowboard"}
SOFAS = {"sofa", "lounge_sofa", "loveseat", "lounge_loveseat", "sofa_bed", "settee"}
EASY_CHAIRS = {"armchair", "club_chair", "corner_chair", "wing_chair", "shell_chair"}
READING_LAMPS = {"floor_lamp", "corner_lamp", "table_lamp"}
BOOKCASES = {"bookshelf", "low_bookshelf", "corner_shelf", "plank_shelf"}

DOUBLE_BEDS = {"double_bed", "king_bed"}
SINGLE_BEDS = {"single_bed", "day_bed"}
BEDS = DOUBLE_BEDS | SINGLE_BEDS | {"bunk_bed"}
CHILDRENS_THINGS = {"toy", "floor_toy", "crib", "bunk_bed", "play_rug", "child_table", "child_chair"}
WARDROBES = {"wardrobe", "large_wardrobe", "tall_clothes_press"}
DESKS = {"desk", "team_desk", "small_desk", "executive_desk", "teacher_desk", "lecture_desk"}
OFFICE_CHAIRS = {"office_chair"}

TOILETS = {"toilet"}
# With a toilet between walls of their own.
CUBICLES = {"toilet_cubicle"}
BASINS = {"washbasin", "hand_basin", "vanity", "row_basin"}
TUBS = {"bathtub", "sit_bath", "shower", "small_shower"}
# What is put where a gap is left.
BINS = {"bin", "basket", "laundry_basket", "stool", "plant", "small_plant"}

ART = {"picture", "gallery_picture", "poster", "mirror", "vanity_mirror"}
MIRRORS = {"mirror", "vanity_mirror"}
CURTAINS = {"curtain"}
SLIM_KINDS = {"plant", "hall_plant", "corridor_plant", "small_plant", "garden_plant", "planter", "team_planter", "floor_lamp",
              "corner_lamp"}
LIBRARY_SHELVES = {"library_shelf", "library_stack", "archive_shelf"}
ROW_SEATS = {"auditorium_seat"}

STORAGE = WARDROBES | {"dresser", "bookshelf", "low_bookshelf", "plank_shelf", "cabinet", "tall_cabinet", "filing_cabinet",
                       "china_cabinet"}
COFFEE_TABLES = {"coffee_table", "lounge_table"}
VIEWERS = SOFAS | EASY_CHAIRS | BEDS
DRESSING = {"dressing_table", "dresser", "console_table", "sideboard", "shoe_cabinet", "desk", "small_desk", "lowboard"}

LIVING_ROOMS = {"living_room", "living_dining", "living_kitchen", "studio", "studio_kitchen"}
# A room whose plan leaves open what it is.
OPEN_KINDS = {"room"}
BEDROOMS = {"bedroom", "room", "main_bedroom", "guest_bedroom", "elders_bedroom", "shared_room", "studio", "studio_kitchen"}
SLEEPING_ROOMS = BEDROOMS | {"childrens_room", "shared_childrens_room"}
KITCHENS = {"kitchen", "kitchen_dining", "living_kitchen", "studio_kitchen"}
BATHROOMS = {"bathroom", "toilet"}
HALLS = {"corridor", "walkway", "foyer"}
HOME_ROOMS = LIVING_ROOMS | SLEEPING_ROOMS | KITCHENS | {"sitting_room", "dining_room", "study"}
OUTDOOR = {"balcony", "loggia", "terrace"}
# Rooms that join dwellings, and are in none.
STAIRS = {"stairs", "staircase", "elevator", "shaft", "void"}
SHARED_WAYS = STAIRS | {"walkway", "foyer"} | OUTDOOR
