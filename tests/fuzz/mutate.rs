//! Makes inputs from others: changes bytes, replaces numbers and words, repeats lines, deepens nesting.

/// Numbers drawn from a seed (S. Vigna's SplitMix64).
pub(crate) struct Draw(u64);

impl Draw {
    /// Other numbers for each target.
    pub(crate) fn new(target: &str, seed: u64) -> Self {
        let fold = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        Self(target.bytes().fold(seed ^ 0xcbf2_9ce4_8422_2325, fold))
    }

    /// A number below another.
    fn below(&mut self, most: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) % most.max(1) as u64) as usize
    }

    /// A length of which short ones are as likely as long ones.
    fn length(&mut self) -> usize {
        let digits = self.below(12);
        self.below(1 << digits)
    }

    fn one_of<'a, T: ?Sized>(&mut self, items: &[&'a T]) -> &'a T {
        items[self.below(items.len())]
    }

    /// A place between two bytes, or at an end.
    fn place(&mut self, bytes: &[u8]) -> usize {
        self.below(bytes.len() + 1)
    }
}

/// Numbers at the edges of what can be written and meant.
const NUMBERS: [&str; 23] = [
    "0",
    "-0",
    "-1",
    "1",
    "2",
    "0.1",
    "1e-9",
    "1e-320",
    "1e9",
    "1e39",
    "-1e308",
    "1e400",
    "90",
    "180.0001",
    "255",
    "65536",
    "2147483648",
    "4294967295",
    "9007199254740993",
    "-9223372036854775809",
    "18446744073709551615",
    "123456.789",
    "3.0000000000000004",
];

/// Words that mean something to readers, terminals and file systems.
const WORDS: [&str; 26] = [
    "null",
    "true",
    "[]",
    "{}",
    "\"\"",
    "~",
    "NaN",
    ".inf",
    "*a",
    "&a ",
    "<<: *a",
    "!!binary x",
    "../../x",
    "/etc/passwd",
    "C:\\x",
    "\u{1b}[31m",
    "\u{0}",
    "\u{fffe}",
    "\u{2028}",
    "\u{202e}",
    "\r\n",
    "%2e%2e/",
    "data:;base64,AAAA",
    "'",
    "#",
    "$",
];

/// An input of at most so many bytes.
pub(crate) fn made(cases: &[(String, Vec<u8>)], draw: &mut Draw, largest: usize) -> Vec<u8> {
    let bytes = &cases[draw.below(cases.len())].1;
    let other = &cases[draw.below(cases.len())].1;
    // Of a binary floor, half of the inputs have a document that can be read.
    let mut made = match split(bytes) {
        Some((document, rest)) if draw.below(2) == 0 => join(&changed(document.to_vec(), other, draw), rest),
        _ => changed(bytes.clone(), other, draw),
    };
    made.truncate(largest);
    made
}

fn changed(mut bytes: Vec<u8>, other: &[u8], draw: &mut Draw) -> Vec<u8> {
    for _ in 0..=draw.below(4) {
        bytes = match draw.below(12) {
            0 => with_other_bytes(bytes, draw),
            1 => without_a_part(bytes, draw),
            2 => with_a_part_of(bytes, other, draw),
            3 => with_lines_repeated(&bytes, draw),
            4 => with_a_nest(bytes, draw),
            5 => with_a_word(bytes, draw),
            6 => with_a_word_of_itself(bytes, draw),
            _ => with_another_number(bytes, draw),
        };
    }
    bytes
}

fn with_other_bytes(mut bytes: Vec<u8>, draw: &mut Draw) -> Vec<u8> {
    for _ in 0..=draw.below(8) {
        // Half of them near the beginning, where lengths stand.
        let most = if draw.below(2) == 0 { bytes.len().min(200) } else { bytes.len() };
        let (place, byte) = (draw.below(most), draw.below(256) as u8);
        if let Some(found) = bytes.get_mut(place) {
            *found = byte;
        }
    }
    bytes
}

fn without_a_part(mut bytes: Vec<u8>, draw: &mut Draw) -> Vec<u8> {
    let start = draw.place(&bytes);
    let length = draw.length();
    bytes.drain(start..(start + length).min(bytes.len()));
    bytes
}

fn with_a_part_of(mut bytes: Vec<u8>, other: &[u8], draw: &mut Draw) -> Vec<u8> {
    let (from, to) = (draw.place(other), draw.place(&bytes));
    let length = draw.length();
    bytes.splice(to..to, other[from..(from + length).min(other.len())].iter().copied());
    bytes
}

fn with_lines_repeated(bytes: &[u8], draw: &mut Draw) -> Vec<u8> {
    let mut lines: Vec<&[u8]> = bytes.split_inclusive(|&byte| byte == b'\n').collect();
    let start = draw.below(lines.len());
    let end = (start + 1 + draw.below(4)).min(lines.len());
    let part: Vec<&[u8]> = lines[start.min(end)..end].to_vec();
    let most = 20_000 / part.concat().len().max(1);
    let to = if draw.below(2) == 0 { end } else { draw.below(lines.len()) };
    lines.splice(to..to, part.iter().copied().cycle().take(part.len() * (1 + draw.below(most))));
    lines.concat()
}

fn with_a_nest(mut bytes: Vec<u8>, draw: &mut Draw) -> Vec<u8> {
    let depth = [10, 200, 20_000][draw.below(3)];
    let (open, close) = [("[", "]"), ("{\"a\":", "}"), ("{a: ", "}"), ("(", ")"), ("- ", "")][draw.below(5)];
    let nest = format!("{}0{}", open.repeat(depth), close.repeat(depth));
    let place = number_in(&bytes, draw).unwrap_or_else(|| {
        let place = draw.place(&bytes);
        place..place
    });
    bytes.splice(place, nest.into_bytes());
    bytes
}

fn with_a_word(mut bytes: Vec<u8>, draw: &mut Draw) -> Vec<u8> {
    let word = draw.one_of(&WORDS).repeat([1, 1, 1, 2, 5000][draw.below(5)]);
    let place = draw.place(&bytes);
    let place =
        if draw.below(2) == 0 { number_in(&bytes, draw).unwrap_or(place..place) } else { place..place };
    bytes.splice(place, word.into_bytes());
    bytes
}

/// A word in place of another of the same text: keys go to other values, ids to other things.
fn with_a_word_of_itself(mut bytes: Vec<u8>, draw: &mut Draw) -> Vec<u8> {
    let is_of_word = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'.' || byte == b'-';
    let [from, to] = [0, 1].map(|_| run_from(&bytes, draw.place(&bytes), is_of_word));
    let (Some(from), Some(to)) = (from, to) else { return bytes };
    let word = bytes[from].to_vec();
    bytes.splice(to, word);
    bytes
}

fn with_another_number(mut bytes: Vec<u8>, draw: &mut Draw) -> Vec<u8> {
    let Some(place) = number_in(&bytes, draw) else { return bytes };
    let number = if draw.below(4) == 0 {
        format!("{}{}", String::from_utf8_lossy(&bytes[place.clone()]), draw.below(1000))
    } else {
        draw.one_of(&NUMBERS).to_owned()
    };
    bytes.splice(place, number.into_bytes());
    bytes
}

/// The next number after some place.
fn number_in(bytes: &[u8], draw: &mut Draw) -> Option<std::ops::Range<usize>> {
    let is_of_number = |byte: u8| byte.is_ascii_digit() || byte == b'.' || byte == b'-';
    run_from(bytes, draw.place(bytes), is_of_number)
}

/// The next run of bytes of a kind.
fn run_from(bytes: &[u8], from: usize, is_kind: impl Fn(u8) -> bool) -> Option<std::ops::Range<usize>> {
    let start = from + bytes[from..].iter().position(|&byte| is_kind(byte))?;
    let length = bytes[start..].iter().position(|&byte| !is_kind(byte)).unwrap_or(bytes.len() - start);
    Some(start..start + length)
}

/// The document and the rest of a binary glTF file.
fn split(glb: &[u8]) -> Option<(&[u8], &[u8])> {
    let length = glb.starts_with(b"glTF").then(|| glb.get(12..16)).flatten()?;
    let length = u32::from_le_bytes(length.try_into().unwrap()) as usize;
    glb.get(20..)?.split_at_checked(length)
}

/// A binary glTF file of the text of a document and the chunks that follow it.
fn join(document: &[u8], rest: &[u8]) -> Vec<u8> {
    let mut text = document.to_vec();
    text.resize(text.len().next_multiple_of(4), b' ');
    let word = |number: usize| u32::try_from(number).unwrap().to_le_bytes();
    let all = 20 + text.len() + rest.len();
    [&b"glTF"[..], &word(2), &word(all), &word(text.len()), b"JSON", &text, rest].concat()
}
