//! Small maps of OpenStreetMap, in XML and in protocol buffers.

use super::*;

/// Corners of a block of 33.4 × 22.2 m with a courtyard, a part on it, a street and a door, as nodes: longitude, latitude.
const NODES: [(i64, &str, &str); 14] = [
    (1, "14.4400000", "50.0700000"),
    (2, "14.4404667", "50.0700000"),
    (3, "14.4404667", "50.0702000"),
    (4, "14.4400000", "50.0702000"),
    (5, "14.4401000", "50.0700500"),
    (6, "14.4402000", "50.0700500"),
    (7, "14.4402000", "50.0701500"),
    (8, "14.4401000", "50.0701500"),
    (9, "14.4403000", "50.0700500"),
    (10, "14.4404000", "50.0700500"),
    (11, "14.4404000", "50.0701000"),
    (12, "14.4403000", "50.0701000"),
    (13, "14.4399000", "50.0699000"),
    (14, "14.4406000", "50.0699000"),
];

fn nodes() -> String {
    NODES.iter().map(|(id, x, y)| format!("<node id=\"{id}\" lat=\"{y}\" lon=\"{x}\"/>\n")).collect()
}

fn osm(elements: &str) -> String {
    format!("<?xml version=\"1.0\"?>\n<osm version=\"0.6\">\n{}{elements}</osm>\n", nodes())
}

fn way(id: i64, nodes: &[i64], tags: &[(&str, &str)]) -> String {
    let nodes: String = nodes.iter().map(|node| format!("<nd ref=\"{node}\"/>")).collect();
    format!("<way id=\"{id}\">{nodes}{}</way>\n", tags_of(tags))
}

fn tags_of(tags: &[(&str, &str)]) -> String {
    tags.iter().map(|(key, value)| format!("<tag k=\"{key}\" v='{value}'/>")).collect()
}

fn relation(id: i64, members: &[(&str, i64, &str)], tags: &[(&str, &str)]) -> String {
    let member = |(kind, id, role): &(&str, i64, &str)| {
        format!("<member type=\"{kind}\" ref=\"{id}\" role=\"{role}\"/>")
    };
    format!(
        "<relation id=\"{id}\">{}{}</relation>\n",
        members.iter().map(member).collect::<String>(),
        tags_of(tags)
    )
}

/// The block as a relation of three ways, its part, a street and a door.
fn block() -> String {
    let door = "<node id=\"99\" lat=\"50.07\" lon=\"14.4402\"><tag k=\"entrance\" v=\"main\"/></node>\n";
    [
        door.to_owned(),
        way(1, &[1, 2, 3], &[]),
        way(2, &[1, 4, 3], &[]),
        way(3, &[5, 6, 7, 8, 5], &[]),
        way(4, &[9, 10, 11, 12, 9], &[("building:part", "yes"), ("building:levels", "7")]),
        way(5, &[13, 14], &[("highway", "residential")]),
        relation(
            6,
            &[("way", 2, "outer"), ("way", 3, "inner"), ("way", 1, "outer")],
            &[
                ("type", "multipolygon"),
                ("building", "apartments"),
                ("building:levels", "5"),
                ("name", "U &amp; V"),
            ],
        ),
    ]
    .concat()
}

/// The same in GeoJSON.
fn block_as_geojson() -> String {
    let place = |node: usize| format!("[{}, {}]", NODES[node - 1].1, NODES[node - 1].2);
    let ring = |nodes: &[usize]| {
        let places: Vec<String> = nodes.iter().map(|node| place(*node)).collect();
        format!("[{}]", places.join(","))
    };
    let feature = |id: &str, properties: &str, kind: &str, coordinates: &str| {
        format!(
            r#"{{"type": "Feature", "id": "{id}", "properties": {properties}, "geometry": {{"type": "{kind}", "coordinates": {coordinates}}}}}"#
        )
    };
    let features = [
        feature("way/5", r#"{"highway": "residential"}"#, "LineString", &ring(&[13, 14])),
        feature(
            "way/4",
            r#"{"building:part": "yes", "building:levels": "7"}"#,
            "Polygon",
            &format!("[{}]", ring(&[12, 9, 10, 11, 12])),
        ),
        feature(
            "relation/6",
            r#"{"type": "multipolygon", "building": "apartments", "building:levels": "5", "name": "U & V"}"#,
            "MultiPolygon",
            &format!("[[{}, {}]]", ring(&[3, 4, 1, 2, 3]), ring(&[5, 6, 7, 8, 5])),
        ),
        feature("node/99", r#"{"entrance": "main"}"#, "Point", "[14.4402, 50.07]"),
    ];
    format!(r#"{{"type": "FeatureCollection", "features": [{}]}}"#, features.join(","))
}

#[test]
fn a_multipolygon_of_several_ways_is_a_building_with_its_part_street_and_door() {
    let read = read("a.osm", osm(&block())).unwrap();
    assert_eq!(ids(&read), ["r6"]);
    let block = &read.site.footprints[0];
    assert_eq!((block.region.holes.len(), block.parts.len(), block.entrances.len()), (1, 1, 1));
    assert!((block.region.area() - (33.4 * 22.2 - 7.2 * 11.1)).abs() < 5.0, "{}", block.region.area());
    assert_eq!(block.name.as_deref(), Some("U & V"));
    assert_eq!(block.parts[0].storeys.above_ground, Some(7.0));
    assert_eq!(read.site.streets.len(), 1);
    assert_accounted(&read);
}

#[test]
fn one_map_in_two_formats_is_one_site() {
    let one = read("a.osm", osm(&block())).unwrap();
    let other = read("a.geojson", block_as_geojson()).unwrap();
    assert_eq!(format!("{:#?}", one.site), format!("{:#?}", other.site));
}

#[test]
fn a_way_with_the_tags_of_its_multipolygon_is_drawn_twice() {
    let elements = [
        way(1, &[1, 2, 3, 4, 1], &[("building", "school"), ("building:levels", "2")]),
        way(3, &[5, 6, 7, 8, 5], &[]),
        relation(
            6,
            &[("way", 1, "outer"), ("way", 3, "inner")],
            &[("type", "multipolygon"), ("building", "yes")],
        ),
    ];
    let read = read("a.osm", osm(&elements.concat())).unwrap();
    assert_eq!(ids(&read), ["r6"]);
    assert_eq!(read.site.footprints[0].storeys.above_ground, Some(2.0));
    assert_eq!(read.notes.duplicates.len(), 1);
    assert_accounted(&read);
}

#[test]
fn the_relation_of_a_building_names_its_parts() {
    let elements = [
        way(1, &[1, 2, 3, 4, 1], &[("building:part", "yes"), ("building:levels", "2")]),
        way(
            4,
            &[9, 10, 11, 12, 9],
            &[("building:part", "yes"), ("building:levels", "7"), ("building:min_level", "2")],
        ),
        relation(7, &[("way", 1, "part"), ("way", 4, "part")], &[("type", "building")]),
    ];
    let read = read("a.osm", osm(&elements.concat())).unwrap();
    assert_eq!(ids(&read), ["r7"]);
    assert_eq!(read.site.footprints[0].parts.len(), 2);
    assert_eq!(read.site.footprints[0].storeys.above_ground, Some(7.0));
    assert_accounted(&read);
}

#[test]
fn incomplete_buildings_are_left_out() {
    let good = way(10, &[1, 2, 3, 4, 1], &[("building", "yes")]);
    let multipolygon = |members: &[(&str, i64, &str)]| {
        relation(6, members, &[("type", "multipolygon"), ("building", "yes")])
    };
    for bad in [
        way(1, &[1, 2, 3, 4], &[("building", "yes")]),
        way(1, &[1, 2, 777, 4, 1], &[("building", "yes")]),
        way(1, &[1, 1], &[("building", "yes")]),
        way(1, &[], &[("building", "yes")]),
        multipolygon(&[("way", 555, "outer")]),
        multipolygon(&[]),
        multipolygon(&[("way", 10, "inner")]),
        format!("{}{}", way(2, &[1, 2, 3], &[]), multipolygon(&[("way", 2, "outer")])),
    ] {
        let read = read("a.osm", osm(&format!("{good}{bad}"))).unwrap();
        assert_eq!(ids(&read), ["w10"], "{bad}");
        assert_eq!(read.notes.left_out.len(), 1, "{bad}");
        assert_accounted(&read);
    }
    let deleted =
        way(1, &[9, 10, 11, 12, 9], &[("building", "yes")]).replace("<way ", "<way visible=\"false\" ");
    assert_eq!(ids(&read("a.osm", osm(&format!("{good}{deleted}"))).unwrap()), ["w10"]);
}

#[test]
fn broken_files_in_xml_are_faults() {
    let whole = osm(&block());
    let cut = &whole[..whole.len() / 2];
    let cases = [
        (cut.to_owned(), "is no sound XML"),
        (whole.replace("</way>", "</wey>"), "is no sound XML"),
        (osm(""), "holds no building"),
        (osm(&way(1, &[1, 2, 3, 4, 1], &[("building", "no")])), "areas with building=no (1)"),
        ("<osm>".to_owned(), "the file is cut off"),
    ];
    for (text, message) in cases {
        let faults = read("a.osm", text).unwrap_err();
        assert!(faults.to_string().contains(message), "{faults}");
    }
}

#[test]
fn rooms_are_no_footprints() {
    let rooms = way(1, &[1, 2, 3, 4, 1], &[("indoor", "room"), ("building", "yes")]);
    assert!(read("a.osm", osm(&rooms)).unwrap_err().to_string().contains("holds no building"));
}

/// Protocol buffers, as the format has them.
mod protocol {
    /// A number, seven bits a byte.
    pub(super) fn number(mut number: u64) -> Vec<u8> {
        let mut bytes = Vec::new();
        while number > 0x7f {
            bytes.push(number as u8 | 0x80);
            number >>= 7;
        }
        bytes.push(number as u8);
        bytes
    }

    pub(super) fn signed(value: i64) -> u64 {
        ((value << 1) ^ (value >> 63)) as u64
    }

    pub(super) fn bytes(field: u64, bytes: &[u8]) -> Vec<u8> {
        [number(field << 3 | 2), number(bytes.len() as u64), bytes.to_vec()].concat()
    }

    pub(super) fn integer(field: u64, value: u64) -> Vec<u8> {
        [number(field << 3), number(value)].concat()
    }

    pub(super) fn packed(field: u64, values: impl IntoIterator<Item = u64>) -> Vec<u8> {
        bytes(field, &values.into_iter().flat_map(number).collect::<Vec<u8>>())
    }

    /// Differences of numbers with signs.
    pub(super) fn differences(values: &[i64]) -> Vec<u64> {
        let before = std::iter::once(0).chain(values.iter().copied());
        values.iter().zip(before).map(|(value, before)| signed(value - before)).collect()
    }

    /// A block of a file; its content is not packed, or packed where `is_packed`.
    pub(super) fn block(name: &str, content: &[u8], is_packed: bool) -> Vec<u8> {
        let blob = if is_packed {
            let mut packed = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::fast());
            std::io::Write::write_all(&mut packed, content).unwrap();
            [integer(2, content.len() as u64), bytes(3, &packed.finish().unwrap())].concat()
        } else {
            bytes(1, content)
        };
        let header = [bytes(1, name.as_bytes()), integer(3, blob.len() as u64)].concat();
        [(header.len() as u32).to_be_bytes().to_vec(), header, blob].concat()
    }
}

/// The texts of the block in protocol buffers, to which its elements refer by number.
const STRINGS: [&str; 18] = [
    "",
    "building:part",
    "yes",
    "building:levels",
    "7",
    "highway",
    "residential",
    "type",
    "multipolygon",
    "building",
    "apartments",
    "5",
    "name",
    "U & V",
    "outer",
    "inner",
    "entrance",
    "main",
];

fn units(degrees: &str) -> i64 {
    degrees.replace('.', "").parse().unwrap()
}

/// The nodes as lists, and the door as a node by itself.
fn nodes_as_pbf() -> Vec<u8> {
    use protocol::{bytes, differences, integer, packed, signed};
    let [ids, latitudes, longitudes] = [0, 1, 2].map(|part| {
        let values: Vec<i64> = NODES.iter().map(|(id, x, y)| [*id, units(y), units(x)][part]).collect();
        differences(&values)
    });
    let dense = [packed(1, ids), packed(8, latitudes), packed(9, longitudes), packed(10, [0; 14])].concat();
    let door = [
        integer(1, signed(99)),
        integer(8, signed(units("50.0700000"))),
        integer(9, signed(units("14.4402000"))),
        packed(2, [16]),
        packed(3, [17]),
    ];
    [bytes(2, &bytes(2, &dense)), bytes(2, &bytes(1, &door.concat()))].concat()
}

fn ways_as_pbf() -> Vec<u8> {
    use protocol::{bytes, differences, integer, packed};
    let way = |id: u64, nodes: &[i64], tags: &[(u64, u64)]| {
        let (keys, values) = (tags.iter().map(|tag| tag.0), tags.iter().map(|tag| tag.1));
        bytes(
            3,
            &[integer(1, id), packed(2, keys), packed(3, values), packed(8, differences(nodes))].concat(),
        )
    };
    let ways = [
        way(1, &[1, 2, 3], &[]),
        way(2, &[1, 4, 3], &[]),
        way(3, &[5, 6, 7, 8, 5], &[]),
        way(4, &[9, 10, 11, 12, 9], &[(1, 2), (3, 4)]),
        way(5, &[13, 14], &[(5, 6)]),
    ];
    bytes(2, &ways.concat())
}

/// The block of [`block`] in protocol buffers.
fn block_as_pbf(is_packed: bool) -> Vec<u8> {
    use protocol::{block, bytes, differences, integer, packed};
    let strings: Vec<u8> = STRINGS.iter().flat_map(|text| bytes(1, text.as_bytes())).collect();
    let relation = [
        integer(1, 6),
        packed(2, [7, 9, 3, 12]),
        packed(3, [8, 10, 11, 13]),
        packed(8, [14, 15, 14]),
        packed(9, differences(&[2, 3, 1])),
        packed(10, [1, 1, 1]),
    ];
    let relations = bytes(2, &bytes(4, &relation.concat()));
    let data = [bytes(1, &strings), nodes_as_pbf(), ways_as_pbf(), relations].concat();
    let header = [bytes(4, b"OsmSchema-V0.6"), bytes(4, b"DenseNodes")].concat();
    [block("OSMHeader", &header, is_packed), block("OSMData", &data, is_packed)].concat()
}

#[test]
fn one_map_in_xml_and_in_protocol_buffers_is_one_site() {
    let one = read("a.osm", osm(&block())).unwrap();
    for is_packed in [false, true] {
        let other = read("a.pbf", block_as_pbf(is_packed)).unwrap();
        assert_eq!(format!("{:#?}", one.site), format!("{:#?}", other.site));
    }
}

#[test]
fn damaged_files_in_protocol_buffers_are_faults_and_nothing_worse() {
    let whole = block_as_pbf(false);
    for length in (0..whole.len()).step_by(3) {
        assert!(read("a.pbf", &whole[..length]).is_err(), "{length}");
    }
    for place in (0..whole.len()).step_by(2) {
        for damage in [0x01, 0x7f, 0x80] {
            let mut damaged = whole.clone();
            damaged[place] ^= damage;
            let _ = read("a.pbf", &damaged);
        }
    }
}

#[test]
fn files_that_ask_for_more_than_is_read_are_refused() {
    use protocol::{block, bytes, integer};
    let historical = block("OSMHeader", &bytes(4, b"HistoricalInformation"), false);
    let header = block("OSMHeader", &[], false);
    let zstd = [integer(2, 5), bytes(7, b"12345")].concat();
    let block_header = [bytes(1, b"OSMData"), integer(3, zstd.len() as u64)].concat();
    let packed_otherwise =
        [header, (block_header.len() as u32).to_be_bytes().to_vec(), block_header, zstd].concat();
    for (file, message) in [
        (historical, "it requires the feature \"HistoricalInformation\""),
        (packed_otherwise, "not packed with zlib"),
    ] {
        let faults = read("a.pbf", file).unwrap_err();
        assert!(faults.to_string().contains(message), "{faults}");
    }
}

#[test]
fn blocks_that_unpack_to_much_more_than_their_file_are_refused() {
    use protocol::{block, bytes};
    let zeros = block("OSMData", &bytes(99, &vec![0; 25 << 20]), true);
    let file = [block("OSMHeader", &[], false), zeros.repeat(3)].concat();
    let faults = read("a.pbf", file).unwrap_err();
    assert!(faults.to_string().contains("unpacked, its blocks have more than"), "{faults}");
}

#[test]
fn elements_with_endless_lists_are_refused() {
    use protocol::{block, bytes, integer};
    let (long, short) = (vec![2; 100_001], vec![2; 4]);
    let way = |nodes: &[u8]| bytes(3, &[integer(1, 1), bytes(8, nodes)].concat());
    let member =
        |ids: &[u8]| bytes(4, &[integer(1, 1), bytes(8, ids), bytes(9, ids), bytes(10, ids)].concat());
    let dense =
        |tags: &[u8]| bytes(2, &[bytes(1, &[2]), bytes(8, &[2]), bytes(9, &[2]), bytes(10, tags)].concat());
    let file = |element: Vec<u8>| {
        let header = block("OSMHeader", &[], false);
        read("a.pbf", [header, block("OSMData", &bytes(2, &element), true)].concat()).unwrap_err().to_string()
    };
    for element in [way(&long), member(&long), dense(&long.repeat(2))] {
        let fault = file(element);
        assert!(fault.contains("a list of more than 100000 nodes, members or tags"), "{fault}");
    }
    for element in [way(&short), member(&short), dense(&short)] {
        assert!(file(element).contains("holds no building"));
    }
}

#[test]
fn ways_that_bound_endless_multipolygons_bound_some() {
    let relations = (1..=100)
        .map(|id| relation(id, &[("way", 1, "outer")], &[("type", "multipolygon"), ("building", "yes")]));
    let elements = way(1, &[1, 2, 3, 4, 1], &[]) + &relations.collect::<String>();
    let read = read("a.osm", osm(&elements)).unwrap();
    assert_eq!((read.site.footprints.len(), read.notes.left_out.len()), (1, 92));
    assert_eq!(read.notes.left_out[0].reason, "its ways are those of many others");
    assert_accounted(&read);
}
