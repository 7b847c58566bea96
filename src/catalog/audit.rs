//! The thresholds of the audit, from `configs/audit.yaml`.

use std::path::Path;

use schemars::JsonSchema;
use serde::Deserialize;

use super::builtin::builtin_file;
use super::file::FormatVersion;
use crate::document::Source;

/// The file in a folder of configuration, without its extension.
pub(crate) const AUDIT_FILE: &str = "audit";

/// The measure of a threshold. Angles are degrees in the file and radians in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unit {
    /// Metres.
    Metres,
    /// Square metres.
    Area,
    /// Degrees.
    Degrees,
    /// A share of a whole.
    Share,
    /// A factor or weight.
    Factor,
}

/// One list for the three forms of a threshold: what may be written (`written`), what is meant
/// ([`AuditRules`]), and the way from the one to the other.
macro_rules! thresholds {
    ($($(#[$about:meta])* $section:ident: $Section:ident { $($(#[$doc:meta])* $key:ident: $unit:ident,)+ })+) => {
        /// The thresholds of the audit: metres, radians, shares.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct AuditRules {
            $($(#[$about])* pub $section: $Section,)+
        }

        $($(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $Section {
            $($(#[$doc])* pub $key: f64,)+
        })+

        impl AuditRules {
            /// Nothing is a number yet.
            const UNSET: Self = Self { $($section: $Section { $($key: f64::NAN,)+ },)+ };

            /// Whether every threshold has been written somewhere.
            pub(crate) fn is_complete(&self) -> bool {
                true $($(&& !self.$section.$key.is_nan())+)+
            }

            /// Takes over what a file writes; `check` is given section, key, unit and value, and answers with
            /// the value to use.
            pub(crate) fn overlay(
                &mut self,
                file: &AuditFile,
                mut check: impl FnMut([&str; 2], Unit, f64) -> f64,
            ) {
                $(if let Some(section) = &file.thresholds.$section {
                    $(if let Some(value) = section.$key {
                        let value = check([stringify!($section), stringify!($key)], Unit::$unit, value);
                        let is_angle = Unit::$unit == Unit::Degrees;
                        self.$section.$key = if is_angle { value.to_radians() } else { value };
                    })+
                })+
            }
        }

        mod written {
            use super::{Deserialize, JsonSchema};

            /// Thresholds; what a later folder does not write is as in the earlier ones.
            #[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
            #[serde(deny_unknown_fields)]
            pub(crate) struct Thresholds {
                $($(#[$about])* pub(crate) $section: Option<$Section>,)+
            }

            $($(#[$about])*
            #[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
            #[serde(deny_unknown_fields)]
            pub(crate) struct $Section {
                $($(#[$doc])* pub(crate) $key: Option<f64>,)+
            })+
        }
    };
}

thresholds! {
    /// Bodies and what carries them.
    bodies: BodyRules {
        /// Depth at which two bodies collide.
        collision_depth: Metres,
        /// How far a body may stick out of the room.
        out_of_room: Metres,
        /// Gap between a body and its support above which it floats.
        support_gap: Metres,
        /// Share of a footprint that may hang over the edge of its support.
        overhang_share: Share,
    }
    /// The space that stays free before doors.
    doors: DoorRules {
        /// Deepest approach before a door.
        approach_depth: Metres,
        /// Approach before an edge without a wall.
        open_boundary_depth: Metres,
        /// What of it need not stay free at either end of such an edge, along it.
        open_boundary_end: Metres,
        /// Depth at which a body stands in a door's way.
        intrusion: Metres,
    }
    /// The space that stays free before furniture.
    clearances: ClearanceRules {
        /// Depth at which a clearance is taken.
        intrusion: Metres,
        /// How far a piece on a wall may reach into a clearance.
        flat_depth: Metres,
        /// Underside of pieces on a wall from which that applies.
        flat_elevation: Metres,
    }
    /// The people who walk through a room.
    walking: WalkingRules {
        /// Bodies whose underside is higher are walked under.
        body_height: Metres,
        /// Bodies whose top is lower are stepped on.
        step: Metres,
        /// Diameter of the disc that has to get everywhere.
        person: Metres,
        /// Diameter where the plan itself is narrower.
        narrow_person: Metres,
        /// Diameter for the walkable rate.
        robot: Metres,
    }
    /// Where the style asks for access by wheelchair.
    access: AccessRules {
        /// Diameter of the disc in which a wheelchair turns.
        turning: Metres,
        /// Diameter of the disc that has to get everywhere with it.
        walkway: Metres,
    }
    /// The furniture that may stand before windows.
    windows: WindowRules {
        /// How far a body may rise over the sill.
        over_sill: Metres,
        /// How far before the window.
        depth: Metres,
        /// Top of pieces that are low wherever the sill is.
        low_piece: Metres,
        /// Plants and small objects narrower than this may stand there.
        slim_width: Metres,
        /// So may a piece of which no part as wide as this rises so far: a sink with its tap.
        slim_part: Metres,
    }
    /// The view of a screen.
    screens: ScreenRules {
        /// Angle off the screen's axis within which it is seen.
        angle: Degrees,
        /// Screen diagonals of the nearest viewer.
        nearest: Factor,
        /// Screen diagonals of the farthest viewer.
        farthest: Factor,
        /// Bodies that reach above this stand in the line of sight.
        sight_low: Metres,
        /// Bodies whose underside is above this do not.
        sight_high: Metres,
    }
    /// Which way seats and desks face.
    facing: FacingRules {
        /// Angle off the way they should face.
        angle: Degrees,
    }
    /// Bathrooms.
    wet_rooms: WetRoomRules {
        /// Depth of the zone before the toilet bowl.
        toilet_front: Metres,
    }
    /// Beds.
    beds: BedRules {
        /// Depth of the strip beside a bed by which its other side is reached.
        other_side: Metres,
    }
    /// How furniture is spread over the room.
    balance: BalanceRules {
        /// Floor of the smallest room that is judged.
        least_area: Area,
        /// Share of the furniture's footprint that one half may hold.
        share: Share,
    }
    /// How furniture stands to its wall.
    alignment: AlignmentRules {
        /// Angle off the wall.
        angle: Degrees,
    }
    /// The pieces that a room should have.
    fulfilment: FulfilmentRules {
        /// Share of the requested pieces that must rest.
        resting: Share,
        /// Share of the lowest density of style and room type below which a room is sparse.
        sparse: Share,
        /// Floor of the smallest room that is judged by its density.
        sparse_area: Area,
        /// Share of the surfaces for small objects that must carry some.
        carrying: Share,
    }
    /// Weights of the terms of the score.
    score: ScoreRules {
        /// How much of the good clearances is there.
        clearance: Factor,
        /// How much of the floor can be walked to.
        walking: Factor,
        /// How near the furniture's middle is to the room's.
        balance: Factor,
        /// How parallel furniture stands to the walls.
        alignment: Factor,
        /// How many wishes of the classes are met.
        relations: Factor,
        /// How many of the requested pieces rest.
        fulfilment: Factor,
    }
}

/// `audit.yaml`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Thresholds of the audit")]
pub(crate) struct AuditFile {
    #[expect(dead_code, reason = "checked while reading")]
    pub(crate) version: FormatVersion,
    /// The thresholds by what they are about.
    pub(crate) thresholds: written::Thresholds,
}

impl DoorRules {
    /// Metres at each end of an edge without a wall that need not stay free. Between them as much does as before a door.
    #[must_use]
    pub fn free_ends(&self, width: f64) -> f64 {
        self.open_boundary_end.min((width - self.approach_depth) / 2.0).max(0.0)
    }
}

impl Default for AuditRules {
    /// The built-in ones.
    fn default() -> Self {
        let text = builtin_file("audit.yaml").expect("the file is inside the program");
        let file = Source::new(Path::new("audit.yaml"), text).parse::<AuditFile>();
        let mut rules = Self::UNSET;
        rules.overlay(&file.expect("a test reads it"), |_, _, value| value);
        assert!(rules.is_complete(), "the built-in file writes every threshold");
        rules
    }
}
