//! The formats that are known and not read, by the beginning of a file, with advice for the user.

use std::path::Path;

use super::foreign::head;
use super::readers::read_formats;
use super::sample::Sample;
use crate::document::{FILE_SIZE_LIMIT, Fault};

/// Bytes at the start of a file by which it is recognised.
const HEAD_SIZE: u64 = 64 * 1024;

/// A kind of file that is known and not read.
pub(crate) struct UnreadKind {
    /// The name for people.
    pub(crate) name: &'static str,
    looks: fn(&Sample) -> bool,
    /// Advice for the user.
    pub(crate) advice: &'static str,
}

const OTHER_PLANS: &str = "convert it, or write a native plan: docs/guide.md shows one";
const UNPACK: &str = "unpack it and name the file or folder inside";

/// The kinds that are known, special ones before general ones.
pub(crate) const UNREAD_KINDS: &[UnreadKind] = &[
    kind(
        "a binary glTF file (.glb)",
        |file| file.begins(b"glTF"),
        "it is what `bake` writes: `roomwright audit` judges it",
    ),
    kind("IFC in a ZIP archive (.ifczip)", |file| file.is_of(&["ifczip"]), UNPACK),
    kind("a USD archive (.usdz)", |file| file.is_of(&["usdz"]), "it is what convert.py writes, no plan"),
    kind("a ZIP archive", |file| file.begins(b"PK\x03\x04") || file.begins(b"PK\x05\x06"), UNPACK),
    kind("a TAR archive", |file| file.head.get(257..).is_some_and(|rest| rest.starts_with(b"ustar")), UNPACK),
    kind(
        "a compressed file",
        |file| file.begins(b"\x1f\x8b") || file.begins(b"7z\xbc\xaf") || file.begins(b"BZh"),
        UNPACK,
    ),
    kind(
        "OpenStreetMap PBF (.pbf)",
        |file| file.head.get(4..).is_some_and(|rest| rest.starts_with(b"\x0a\x09OSMHeader")),
        OTHER_PLANS,
    ),
    kind("an AutoCAD drawing (.dwg)", |file| file.begins(b"AC10"), OTHER_PLANS),
    kind("a DXF drawing", is_dxf, OTHER_PLANS),
    kind(
        "a Python pickle",
        is_pickle,
        "pickles are programs, which are not run: of Modified Swiss Dwellings name the table (mds_V2_5.372k.csv), of ResPlan \
         write JSON as docs/importing.md shows",
    ),
    kind("a PDF", |file| file.begins(b"%PDF"), OTHER_PLANS),
    kind(
        "a Blender file",
        |file| file.begins(b"BLENDER"),
        "export the level with blender_export.py, then audit it",
    ),
    kind("an image", is_image, OTHER_PLANS),
    kind("OpenStreetMap XML (.osm)", |file| file.is_xml("osm"), OTHER_PLANS),
    kind(
        "OpenStreetMap JSON of Overpass",
        |file| file.has(&["elements"]) && (file.has(&["osm3s"]) || file.has(&["version", "generator"])),
        "ask Overpass for [out:xml], or export GeoJSON in Overpass Turbo",
    ),
    kind(
        "ifcXML",
        |file| file.is_xml("ifcXML") || file.is_xml("iso_10303_28"),
        "export it as IFC in the STEP encoding (.ifc)",
    ),
    kind("gbXML", |file| file.is_xml("gbXML"), OTHER_PLANS),
    kind("CityGML", |file| file.is_xml("CityModel"), OTHER_PLANS),
    kind("an SVG drawing", |file| file.is_xml("svg"), OTHER_PLANS),
    kind("a web page (HTML)", |file| file.is_xml("html"), OTHER_PLANS),
    kind("an XML file", |file| file.xml_root().is_some() && file.text.starts_with("<?xml"), OTHER_PLANS),
    kind("CityJSON", |file| file.says("type", "CityJSON") || file.has(&["CityObjects"]), OTHER_PLANS),
    kind(
        "a file of an IMDF folder",
        |file| file.is_geojson() && file.text.contains("\"feature_type\""),
        "name the folder in which it lies",
    ),
    kind(
        "a file of a Japanese indoor map",
        |file| file.is_geojson() && file.text.contains("\"floor_id\""),
        "name the folder in which it lies, with the files _Floor and _Space of each storey",
    ),
    kind("GeoJSON", Sample::is_geojson, OTHER_PLANS),
    kind(
        "glTF (.gltf)",
        |file| file.has(&["asset"]) && (file.has(&["scenes"]) || file.has(&["nodes"])),
        "it is what `bake` writes: `roomwright audit` judges it",
    ),
    kind(
        "the manifest of a bake",
        |file| file.has(&["manifest", "program"]),
        "name the plans that were baked",
    ),
    kind("a RoomPlan capture", |file| file.has(&["walls", "doors", "windows", "objects"]), OTHER_PLANS),
    kind(
        "an edits file",
        |file| file.has(&["version", "edits"]),
        "name the plan: the edits beside it are read with it",
    ),
    kind("a file of a catalogue", is_catalogue, "name its folder with --catalog"),
    kind("a table of a react-planner site", is_site_table, "name the folder in which it lies"),
    kind("the areas of a react-planner drawing", is_areas, "name the drawing beside it, plan_N.json"),
    kind("a table (CSV)", is_table, OTHER_PLANS),
];

const fn kind(name: &'static str, looks: fn(&Sample) -> bool, advice: &'static str) -> UnreadKind {
    UnreadKind { name, looks, advice }
}

fn is_dxf(file: &Sample) -> bool {
    let mut lines = file.text.lines().map(str::trim);
    let is_text = lines.next() == Some("0") && lines.next() == Some("SECTION");
    is_text || file.is_of(&["dxf"]) || file.begins(b"AutoCAD Binary DXF")
}

/// Whether a file begins as pickles of protocol 2 and later do: with the protocol, then a frame, a list, a dictionary or a name.
fn is_pickle(file: &Sample) -> bool {
    let [0x80, protocol @ 2..=5, next, ..] = file.head[..] else { return file.is_of(&["pickle", "pkl"]) };
    protocol < 4 || next == 0x95
}

fn is_image(file: &Sample) -> bool {
    const SIGNATURES: [&[u8]; 6] = [b"\x89PNG", b"\xff\xd8\xff", b"GIF8", b"II*\0", b"MM\0*", b"BM"];
    let is_signed = SIGNATURES.iter().any(|signature| file.begins(signature));
    // Two letters alone may begin a text.
    is_signed && file.head.contains(&0)
}

fn is_catalogue(file: &Sample) -> bool {
    const KEYS: [&str; 8] = [
        "households",
        "classes",
        "room_types",
        "styles",
        "building_styles",
        "palettes",
        "formats",
        "thresholds",
    ];
    !file.has(&["levels"]) && KEYS.iter().any(|key| file.has(&[key]))
}

fn is_site_table(file: &Sample) -> bool {
    let is_list = file.text.starts_with('[');
    is_list && (file.text.contains("\"plan_id\"") || file.text.contains("\"unit_id\"")) && !is_areas(file)
}

fn is_areas(file: &Sample) -> bool {
    file.text.starts_with('[') && file.text.contains("\"scaled_polygon\"")
}

/// Whether the first lines have as many separators each, and some.
fn is_table(file: &Sample) -> bool {
    let count = |separator: char| {
        let counts: Vec<usize> =
            file.text.lines().take(3).map(|line| line.matches(separator).count()).collect();
        counts.len() > 1 && counts[0] > 1 && counts.iter().all(|count| *count == counts[0])
    };
    let is_plain = !file.text.starts_with(['{', '[', '#']) && !file.text.contains(": ");
    file.is_of(&["csv", "tsv"]) || (is_plain && [',', ';', '\t'].into_iter().any(count))
}

/// The kind of a file that is no plan; `None` if it may be one.
pub(super) fn recognise(path: &Path) -> Option<&'static UnreadKind> {
    recognise_head(path, head(path, HEAD_SIZE))
}

fn recognise_head(path: &Path, head: Vec<u8>) -> Option<&'static UnreadKind> {
    let sample = Sample::of(path, head);
    UNREAD_KINDS.iter().find(|kind| (kind.looks)(&sample))
}

/// Why a file is not read as a plan, if that shows at its beginning.
pub(super) fn refusal(path: &Path) -> Option<Fault> {
    let bytes = head(path, HEAD_SIZE);
    if bytes.is_empty() {
        return path
            .metadata()
            .is_ok_and(|found| found.is_file() && found.len() == 0)
            .then(|| Fault::of_file(path, "the file is empty").with_hint(read_are()));
    }
    // The limit of size is reported by the reader of the file.
    let has_zeros = bytes.contains(&0) && path.metadata().is_ok_and(|found| found.len() <= FILE_SIZE_LIMIT);
    match recognise_head(path, bytes) {
        Some(kind) => Some(refused(path, kind)),
        None if is_utf_16(path) => {
            let hint = "save it with the encoding UTF-8";
            Some(Fault::of_file(path, "is text in UTF-16, which is not read").with_hint(hint))
        }
        None if has_zeros => {
            Some(Fault::of_file(path, "is no text, but a file of some program").with_hint(read_are()))
        }
        None => None,
    }
}

/// Whether a file begins as texts of Windows in two bytes a letter do.
fn is_utf_16(path: &Path) -> bool {
    let mark = head(path, 2);
    mark == b"\xff\xfe" || mark == b"\xfe\xff"
}

/// The fault of a file of a kind that is not read.
fn refused(path: &Path, kind: &UnreadKind) -> Fault {
    let message = format!("looks like {}, which is not read as a plan", kind.name);
    Fault::of_file(path, message).with_hint(format!("{}; {}", kind.advice, read_are()))
}

/// The formats that are read, in one line.
pub(super) fn read_are() -> String {
    let names: Vec<&str> = read_formats().iter().map(|format| format.title).collect();
    format!("read are {} (`roomwright formats`)", names.join(", "))
}

/// The names of formats that are known and not read, and what to do instead.
#[must_use]
pub fn unread_formats() -> Vec<(&'static str, &'static str)> {
    UNREAD_KINDS.iter().map(|kind| (kind.name, kind.advice)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(file: &str, text: &str) -> Option<&'static str> {
        recognise_head(Path::new(file), text.as_bytes().to_vec()).map(|kind| kind.name)
    }

    #[test]
    fn files_are_recognised_by_their_beginnings() {
        let cases = [
            ("a.glb", "glTF\u{2}\0\0\0", "a binary glTF file (.glb)"),
            ("a.dxf", "  0\r\nSECTION\r\n  2\r\nHEADER", "a DXF drawing"),
            ("a", "0\nSECTION\n", "a DXF drawing"),
            ("1234.pickle", "whatever", "a Python pickle"),
            ("a.zip", "PK\u{3}\u{4}", "a ZIP archive"),
            ("a.sh3d", "PK\u{3}\u{4}", "a ZIP archive"),
            (
                "a.xml",
                "<?xml version='1.0'?>\n<!-- <svg> -->\n<osm version='0.6'>",
                "OpenStreetMap XML (.osm)",
            ),
            ("a.json", "{\"type\" : \"FeatureCollection\", \"features\": []}", "GeoJSON"),
            ("a.json", "{\"CityObjects\": {}", "CityJSON"),
            (
                "a.json",
                "{\"version\": 0.6, \"generator\": \"Overpass API\", \"osm3s\": {}, \"elements\": []}",
                "OpenStreetMap JSON of Overpass",
            ),
            ("a.csv", "a,b\n", "a table (CSV)"),
            ("a.txt", "id;x;y\n1;2;3\n2;3;4\n", "a table (CSV)"),
            ("a.yaml", "version: 1\nclasses:\n  a: {}\n", "a file of a catalogue"),
            ("a.json", "{\"manifest\": 3, \"program\": \"x\", \"levels\": []}", "the manifest of a bake"),
        ];
        for (file, text, expected) in cases {
            assert_eq!(name(file, text), Some(expected), "{file}: {text}");
        }
    }

    #[test]
    fn text_in_two_bytes_a_letter_is_told_with_its_encoding() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("plan.yaml");
        for bytes in [[0xff, 0xfe, b'v', 0], [0xfe, 0xff, 0, b'v']] {
            std::fs::write(&path, bytes).unwrap();
            let fault = refusal(&path).expect("a refusal");
            assert!(
                fault.message.contains("UTF-16") && fault.hint.is_some_and(|hint| hint.contains("UTF-8"))
            );
        }
    }

    #[test]
    fn plans_and_incomplete_plans_are_not_recognised_as_other_files() {
        for text in [
            "version: 1\nlevels: []\n",
            "{\"version\": 1, \"levels\": []}",
            "version: 1\nproject: {plans: []}\n",
            "version: 1\nlevel: []\nstyle: a\n",
            "",
            "hello, there, you\n",
        ] {
            assert_eq!(name("a.yaml", text), None, "{text}");
        }
    }
}
