//! Reference systems in metres that cities are published in, as definitions of PROJ.
//!
//! Parameters are those of the register of EPSG. The crate `crs-definitions` has all six thousand; it is five megabytes of source and
//! takes two minutes to compile, for the origin of a map alone.

use std::fmt::Write;

/// On the ellipsoid of today's systems, which coincide with WGS 84 as far as buildings see.
const GRS80: &str = "+ellps=GRS80 +towgs84=0,0,0";
/// Latitudes and longitudes of the origins of the 19 plane rectangular systems of Japan, from the first.
const JAPAN: [(f64, f64); 19] = [
    (33.0, 129.5),
    (33.0, 131.0),
    (36.0, 132.0 + 1.0 / 6.0),
    (33.0, 133.5),
    (36.0, 134.0 + 1.0 / 3.0),
    (36.0, 136.0),
    (36.0, 137.0 + 1.0 / 6.0),
    (36.0, 138.5),
    (36.0, 139.0 + 5.0 / 6.0),
    (40.0, 140.0 + 5.0 / 6.0),
    (44.0, 140.25),
    (44.0, 142.25),
    (44.0, 144.25),
    (26.0, 142.0),
    (26.0, 127.5),
    (26.0, 124.0),
    (26.0, 131.0),
    (20.0, 136.0),
    (26.0, 154.0),
];
/// National systems: numbers, and what they are but for their ellipsoid where that is GRS 80.
const NATIONAL: [(&[u32], &str); 34] = [
    // The Netherlands, also with heights.
    (
        &[28992, 7415],
        "+proj=sterea +lat_0=52.15616055555555 +lon_0=5.38763888888889 +k=0.9999079 +x_0=155000 +y_0=463000 \
         +ellps=bessel +towgs84=565.2369,50.0087,465.658,-0.406857,0.350733,-1.87035,4.0812",
    ),
    // France.
    (&[2154], "+proj=lcc +lat_1=49 +lat_2=44 +lat_0=46.5 +lon_0=3 +x_0=700000 +y_0=6600000"),
    // Great Britain, also with heights.
    (
        &[27700, 7405],
        "+proj=tmerc +lat_0=49 +lon_0=-2 +k=0.9996012717 +x_0=400000 +y_0=-100000 +ellps=airy \
         +towgs84=446.448,-125.157,542.06,0.15,0.247,0.842,-20.489",
    ),
    // Switzerland, new and old.
    (
        &[2056],
        "+proj=somerc +lat_0=46.95240555555556 +lon_0=7.439583333333333 +k_0=1 +x_0=2600000 +y_0=1200000 \
         +ellps=bessel +towgs84=674.374,15.056,405.346",
    ),
    (
        &[21781],
        "+proj=somerc +lat_0=46.95240555555556 +lon_0=7.439583333333333 +k_0=1 +x_0=600000 +y_0=200000 \
         +ellps=bessel +towgs84=674.374,15.056,405.346",
    ),
    // Belgium, old and new; Luxembourg.
    (
        &[31370],
        "+proj=lcc +lat_1=51.16666723333333 +lat_2=49.8333339 +lat_0=90 +lon_0=4.367486666666666 +x_0=150000.013 \
         +y_0=5400088.438 +ellps=intl +towgs84=-106.8686,52.2978,-103.7239,0.3366,-0.457,1.8422,-1.2747",
    ),
    (
        &[3812],
        "+proj=lcc +lat_1=49.83333333333334 +lat_2=51.16666666666666 +lat_0=50.797815 +lon_0=4.359215833333333 \
         +x_0=649328 +y_0=665262",
    ),
    (
        &[2169],
        "+proj=tmerc +lat_0=49.83333333333334 +lon_0=6.166666666666667 +k=1 +x_0=80000 +y_0=100000 +ellps=intl \
         +towgs84=-189.6806,18.3463,-42.7695,-0.33746,-3.09264,2.53861,0.4598",
    ),
    // Finland, Sweden.
    (&[3067], "+proj=utm +zone=35"),
    (&[3006], "+proj=utm +zone=33"),
    // Estonia, Latvia, Lithuania, Poland.
    (
        &[3301],
        "+proj=lcc +lat_1=59.33333333333334 +lat_2=58 +lat_0=57.51755393055556 +lon_0=24 +x_0=500000 +y_0=6375000",
    ),
    (&[3059], "+proj=tmerc +lat_0=0 +lon_0=24 +k=0.9996 +x_0=500000 +y_0=-6000000"),
    (&[3346], "+proj=tmerc +lat_0=0 +lon_0=24 +k=0.9998 +x_0=500000 +y_0=0"),
    (&[2180], "+proj=tmerc +lat_0=0 +lon_0=19 +k=0.9993 +x_0=500000 +y_0=-5300000"),
    // Czechia and Slovakia.
    (
        &[5514],
        "+proj=krovak +lat_0=49.5 +lon_0=24.83333333333333 +alpha=30.28813972222222 +k=0.9999 +x_0=0 +y_0=0 \
         +ellps=bessel +towgs84=589,76,480",
    ),
    // Austria: Lambert, and the three meridian strips.
    (
        &[31287],
        "+proj=lcc +lat_1=49 +lat_2=46 +lat_0=47.5 +lon_0=13.33333333333333 +x_0=400000 +y_0=400000 +ellps=bessel \
         +towgs84=577.326,90.129,463.919,5.137,1.474,5.297,2.4232",
    ),
    (
        &[31254],
        "+proj=tmerc +lat_0=0 +lon_0=10.33333333333333 +k=1 +x_0=0 +y_0=-5000000 +ellps=bessel \
         +towgs84=577.326,90.129,463.919,5.137,1.474,5.297,2.4232",
    ),
    (
        &[31255],
        "+proj=tmerc +lat_0=0 +lon_0=13.33333333333333 +k=1 +x_0=0 +y_0=-5000000 +ellps=bessel \
         +towgs84=577.326,90.129,463.919,5.137,1.474,5.297,2.4232",
    ),
    (
        &[31256],
        "+proj=tmerc +lat_0=0 +lon_0=16.33333333333333 +k=1 +x_0=0 +y_0=-5000000 +ellps=bessel \
         +towgs84=577.326,90.129,463.919,5.137,1.474,5.297,2.4232",
    ),
    // Germany with the zone in front.
    (&[4647], "+proj=tmerc +lat_0=0 +lon_0=9 +k=0.9996 +x_0=32500000 +y_0=0"),
    // Slovenia, Croatia, Romania, Hungary, Greece.
    (&[3794], "+proj=tmerc +lat_0=0 +lon_0=15 +k=0.9999 +x_0=500000 +y_0=-5000000"),
    (&[3765], "+proj=tmerc +lat_0=0 +lon_0=16.5 +k=0.9999 +x_0=500000 +y_0=0"),
    (
        &[3844],
        "+proj=sterea +lat_0=46 +lon_0=25 +k=0.99975 +x_0=500000 +y_0=500000 +ellps=krass \
         +towgs84=2.329,-147.042,-92.08,0.309,-0.325,-0.497,5.69",
    ),
    (
        &[23700],
        "+proj=somerc +lat_0=47.14439372222222 +lon_0=19.04857177777778 +k_0=0.99993 +x_0=650000 +y_0=200000 \
         +ellps=GRS67 +towgs84=52.17,-71.82,-14.9",
    ),
    (
        &[2100],
        "+proj=tmerc +lat_0=0 +lon_0=24 +k=0.9996 +x_0=500000 +y_0=0 +ellps=GRS80 +towgs84=-199.87,74.79,246.62",
    ),
    // Portugal, Ireland.
    (&[3763], "+proj=tmerc +lat_0=39.66825833333333 +lon_0=-8.133108333333334 +k=1 +x_0=0 +y_0=0"),
    (&[2157], "+proj=tmerc +lat_0=53.5 +lon_0=-8 +k=0.99982 +x_0=600000 +y_0=750000"),
    // Europe.
    (&[3035], "+proj=laea +lat_0=52 +lon_0=10 +x_0=4321000 +y_0=3210000"),
    // Israel, Singapore, Hong Kong, Korea (two), New Zealand.
    (
        &[2039],
        "+proj=tmerc +lat_0=31.73439361111111 +lon_0=35.20451694444445 +k=1.0000067 +x_0=219529.584 +y_0=626907.39 \
         +ellps=GRS80 +towgs84=-48,55,52",
    ),
    (
        &[3414],
        "+proj=tmerc +lat_0=1.366666666666667 +lon_0=103.8333333333333 +k=1 +x_0=28001.642 +y_0=38744.572",
    ),
    (
        &[2326],
        "+proj=tmerc +lat_0=22.31213333333334 +lon_0=114.1785555555556 +k=1 +x_0=836694.05 +y_0=819069.8 \
         +ellps=intl +towgs84=-162.619,-276.959,-161.764,0.067753,-2.243649,-1.158827,-1.094246",
    ),
    (&[5179], "+proj=tmerc +lat_0=38 +lon_0=127.5 +k=0.9996 +x_0=1000000 +y_0=2000000"),
    (&[5186], "+proj=tmerc +lat_0=38 +lon_0=127 +k=1 +x_0=200000 +y_0=600000"),
    (&[2193], "+proj=tmerc +lat_0=0 +lon_0=173 +k=0.9996 +x_0=1600000 +y_0=10000000"),
];

/// What PROJ takes a reference system in metres for; `None` of one that is not listed.
pub(super) fn definition_of(code: u32) -> Option<String> {
    let national =
        || NATIONAL.iter().find(|(codes, _)| codes.contains(&code)).map(|(_, text)| (*text).to_owned());
    let mut definition = national().or_else(|| zone_of(code))?;
    if !definition.contains("+ellps") && !definition.contains("+a=") {
        write!(definition, " {GRS80}").ok()?;
    }
    Some(definition)
}

/// Whether a reference system counts in feet: the state planes of the United States on NAD 83, and its later realisations.
pub(super) fn is_in_feet(code: u32) -> bool {
    matches!(code, 2222..=2289 | 2867..=2930 | 3417..=3438 | 3441..=3446)
}

/// Families of numbers: UTM on WGS 84, of Europe, the Americas and Australia; Gauß-Krüger; Canada; Japan; the web.
fn zone_of(code: u32) -> Option<String> {
    let utm = |zone: u32, south: &str| Some(format!("+proj=utm +zone={zone}{south}"));
    match code {
        32601..=32660 => utm(code - 32600, ""),
        32701..=32760 => utm(code - 32700, " +south"),
        25828..=25838 => utm(code - 25800, ""),
        // With German, with Norwegian heights.
        5554..=5556 => utm(code - 5523, ""),
        5972..=5976 => utm(code - 5940, ""),
        26901..=26923 => utm(code - 26900, ""),
        6330..=6348 => utm(code - 6329, ""),
        2955..=2957 => utm(code - 2944, ""),
        2958..=2962 => utm(code - 2941, ""),
        31978..=31985 => utm(code - 31960, " +south"),
        28348..=28358 => utm(code - 28300, " +south"),
        7846..=7859 => utm(code - 7800, " +south"),
        31466..=31469 => {
            let zone = code - 31464;
            let (meridian, east) = (3 * zone, zone * 1_000_000 + 500_000);
            Some(format!(
                "+proj=tmerc +lat_0=0 +lon_0={meridian} +k=1 +x_0={east} +y_0=0 +ellps=bessel \
                 +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7"
            ))
        }
        3873..=3885 => {
            let zone = code - 3854;
            let east = zone * 1_000_000 + 500_000;
            Some(format!("+proj=tmerc +lat_0=0 +lon_0={zone} +k=1 +x_0={east} +y_0=0"))
        }
        2945..=2952 => canada(code - 2945),
        32183..=32190 => canada(code - 32183),
        6669..=6687 => japan(code - 6669),
        2443..=2461 => japan(code - 2443),
        3857 | 900_913 => Some(
            "+proj=merc +a=6378137 +b=6378137 +lat_ts=0 +lon_0=0 +x_0=0 +y_0=0 +k=1 +nadgrids=@null"
                .to_owned(),
        ),
        _ => None,
    }
}

/// Modified transverse Mercator of eastern Canada, from its third zone.
fn canada(index: u32) -> Option<String> {
    let west = 58.5 + 3.0 * f64::from(index);
    Some(format!("+proj=tmerc +lat_0=0 +lon_0=-{west} +k=0.9999 +x_0=304800 +y_0=0"))
}

fn japan(index: u32) -> Option<String> {
    let (latitude, longitude) = JAPAN.get(usize::try_from(index).ok()?)?;
    Some(format!("+proj=tmerc +lat_0={latitude} +lon_0={longitude} +k=0.9999 +x_0=0 +y_0=0"))
}
