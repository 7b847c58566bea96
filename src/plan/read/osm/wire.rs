//! The wire format of protocol buffers, as far as OpenStreetMap uses it.
//!
//! Encoding of Protocol Buffers (protobuf.dev/programming-guides/encoding): a message is a list of fields, each a key (number and
//! wire type) and a value. Nothing here allocates by a length that the file claims.

/// A field of a message: its number and value.
pub(super) type Field<'a> = (u64, Value<'a>);

/// The value of a field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Value<'a> {
    /// A whole number.
    Number(u64),
    /// Bytes: a text, a message, or a packed list.
    Bytes(&'a [u8]),
}

impl<'a> Value<'a> {
    /// The bytes; none of a number.
    pub(super) fn bytes(self) -> &'a [u8] {
        match self {
            Self::Bytes(bytes) => bytes,
            Self::Number(_) => &[],
        }
    }

    /// The number; zero of bytes.
    pub(super) fn number(self) -> u64 {
        match self {
            Self::Number(number) => number,
            Self::Bytes(_) => 0,
        }
    }

    /// The numbers of a packed list, or the one of a list that is not packed.
    pub(super) fn numbers(self) -> Numbers<'a> {
        match self {
            Self::Number(number) => Numbers { rest: &[], one: Some(number) },
            Self::Bytes(rest) => Numbers { rest, one: None },
        }
    }
}

/// Numbers of a list, up to the first that is cut off.
#[derive(Clone, Debug)]
pub(super) struct Numbers<'a> {
    rest: &'a [u8],
    one: Option<u64>,
}

impl Iterator for Numbers<'_> {
    type Item = u64;

    fn next(&mut self) -> Option<u64> {
        if let Some(one) = self.one.take() {
            return Some(one);
        }
        take_number(&mut self.rest)
    }
}

/// The fields of a message; `None` for the rest of one that is damaged.
#[derive(Clone, Debug)]
pub(super) struct Fields<'a> {
    rest: &'a [u8],
}

impl<'a> Fields<'a> {
    /// Of the bytes of a message.
    pub(super) fn of(message: &'a [u8]) -> Self {
        Self { rest: message }
    }
}

impl<'a> Iterator for Fields<'a> {
    /// A field, or a sign that the message is damaged there.
    type Item = Result<Field<'a>, Damaged>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.rest.is_empty() {
            return None;
        }
        let field = take_field(&mut self.rest).ok_or(Damaged);
        if field.is_err() {
            self.rest = &[];
        }
        Some(field)
    }
}

/// A message that is cut off, or none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Damaged;

fn take_field<'a>(rest: &mut &'a [u8]) -> Option<Field<'a>> {
    let key = take_number(rest)?;
    let value = match key & 7 {
        0 => Value::Number(take_number(rest)?),
        1 => Value::Bytes(take_bytes(rest, 8)?),
        2 => {
            let length = usize::try_from(take_number(rest)?).ok()?;
            Value::Bytes(take_bytes(rest, length)?)
        }
        5 => Value::Bytes(take_bytes(rest, 4)?),
        _ => return None,
    };
    Some((key >> 3, value))
}

fn take_bytes<'a>(rest: &mut &'a [u8], count: usize) -> Option<&'a [u8]> {
    let (bytes, after) = rest.split_at_checked(count)?;
    *rest = after;
    Some(bytes)
}

/// A number of up to ten bytes, seven bits each, the lowest first.
fn take_number(rest: &mut &[u8]) -> Option<u64> {
    let mut number = 0;
    for (index, byte) in rest.iter().take(10).enumerate() {
        number |= u64::from(byte & 0x7f).checked_shl(7 * index as u32).unwrap_or(0);
        if byte & 0x80 == 0 {
            *rest = &rest[index + 1..];
            return Some(number);
        }
    }
    None
}

/// A number with its sign in the lowest bit.
pub(super) fn signed(number: u64) -> i64 {
    (number >> 1) as i64 ^ -((number & 1) as i64)
}

/// The sums of differences with signs, as lists of ids and coordinates are packed.
pub(super) fn summed(differences: Numbers<'_>) -> impl Iterator<Item = i64> {
    differences.scan(0_i64, |sum, difference| {
        *sum = sum.wrapping_add(signed(difference));
        Some(*sum)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_numbers_and_bytes() {
        let message = [0x08, 0x96, 0x01, 0x12, 0x02, b'h', b'i'];
        let fields: Vec<_> = Fields::of(&message).collect();
        assert_eq!(fields, [Ok((1, Value::Number(150))), Ok((2, Value::Bytes(b"hi")))]);
    }

    #[test]
    fn damaged_messages_end() {
        for message in [
            &[0x08][..],
            &[0x12, 0x7f, 1],
            &[0x0b],
            &[0xff; 12],
            &[0x12, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x01],
        ] {
            assert_eq!(Fields::of(message).last(), Some(Err(Damaged)), "{message:?}");
        }
    }

    #[test]
    fn numbers_have_signs_and_are_summed() {
        assert_eq!([0, 1, 2, 3, u64::MAX].map(signed), [0, -1, 1, -2, i64::MIN]);
        let list = Value::Bytes(&[2, 4, 1]).numbers();
        assert_eq!(summed(list).collect::<Vec<_>>(), [1, 3, 2]);
    }
}
