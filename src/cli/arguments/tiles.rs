//! The arguments of `tiles`.

use std::fmt;
use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::RunArguments;
use super::number::{numbers, so_many_numbers};
use crate::output::IndexOptions;
use crate::plan::SiteOrigin;

/// `tiles`.
#[derive(Clone, Debug, Args)]
pub(crate) struct TilesArguments {
    #[command(flatten)]
    pub(crate) run: RunArguments,
    /// Folder to write into.
    #[arg(short, long, value_name = "DIR", default_value = "tiles")]
    pub(crate) out: PathBuf,
    /// Metres from which on boxes, reduced and full furniture are shown, on a screen 1080 pixels high in CesiumJS.
    #[arg(long, value_name = "BOXES,REDUCED,FULL", default_value_t = Near::default(), value_parser = near)]
    pub(crate) near: Near,
    /// Where the site's origin is: degrees of longitude and latitude on WGS 84, and metres above the ellipsoid [default: what the
    /// project or the map says, at height 0].
    #[arg(long, value_name = "LON,LAT[,HEIGHT]", allow_negative_numbers = true, value_parser = origin)]
    pub(crate) origin: Option<SiteOrigin>,
    /// Degrees clockwise from north to the site's y axis.
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true, value_parser = heading, requires = "origin")]
    pub(crate) heading: Option<f64>,
    /// Whether equal furniture is drawn as instances.
    #[arg(long, value_enum, default_value = "gpu")]
    pub(crate) instancing: InstancingWord,
}

/// Three falling distances in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Near(pub(crate) [f64; 3]);

impl Default for Near {
    fn default() -> Self {
        Self(IndexOptions::default().near)
    }
}

impl fmt::Display for Near {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self([boxes, reduced, full]) = self;
        write!(f, "{boxes},{reduced},{full}")
    }
}

/// The words of `--instancing`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum InstancingWord {
    /// As instances (EXT_mesh_gpu_instancing).
    Gpu,
    /// Merged, for clients without that extension; files are up to ten times as large.
    None,
}

fn near(text: &str) -> Result<Near, String> {
    let near = so_many_numbers(text)?;
    let [boxes, reduced, full] = near;
    if boxes > reduced && reduced > full && full > 0.0 {
        Ok(Near(near))
    } else {
        Err("distances fall: boxes are shown from farther away than reduced furniture, full furniture last"
            .to_owned())
    }
}

fn origin(text: &str) -> Result<SiteOrigin, String> {
    let (longitude, latitude, height) = match numbers(text)?.as_slice() {
        &[longitude, latitude] => (longitude, latitude, 0.0),
        &[longitude, latitude, height] => (longitude, latitude, height),
        found => return Err(format!("{} numbers instead of 2 or 3", found.len())),
    };
    SiteOrigin::at(longitude, latitude, height).ok_or_else(|| {
        "longitude is within 180 degrees, latitude within 85; longitude comes first".to_owned()
    })
}

fn heading(text: &str) -> Result<f64, String> {
    match so_many_numbers(text)? {
        [degrees] if degrees.abs() <= 360.0 => Ok(degrees),
        _ => Err("one number within 360 degrees".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_fall() {
        assert_eq!(near("100, 35,12"), Ok(Near([100.0, 35.0, 12.0])));
        for wrong in ["100,35", "35,100,12", "3,2,0", "3,2,x", "NaN,2,1", ""] {
            assert!(near(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn an_origin_is_a_place_on_the_earth() {
        assert_eq!(origin("13.41,52.53"), Ok(SiteOrigin::at(13.41, 52.53, 0.0).unwrap()));
        assert_eq!(origin("-70.5,-33,520.5"), Ok(SiteOrigin::at(-70.5, -33.0, 520.5).unwrap()));
        for wrong in ["52.53", "13,95", "200,5", "1,2,3,4", "a,b", "inf,0"] {
            assert!(origin(wrong).is_err(), "{wrong}");
        }
        assert!(heading("-90").is_ok() && heading("400").is_err() && heading("1,2").is_err());
    }
}
