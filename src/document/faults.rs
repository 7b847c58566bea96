//! Collections of faults, and results that carry warnings.

use std::fmt;

use super::fault::Fault;

/// All faults of an input, in document order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Faults(pub Vec<Fault>);

/// A result with the warnings that came up on the way.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Warned<T> {
    /// The result.
    pub value: T,
    /// Warnings for the user; none of them is an error.
    pub warnings: Faults,
}

impl<T> Warned<T> {
    /// A result without warnings.
    #[must_use]
    pub fn new(value: T) -> Self {
        Self { value, warnings: Faults::default() }
    }
}

impl Faults {
    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether one of them makes the input useless.
    #[must_use]
    pub fn has_errors(&self) -> bool {
        self.0.iter().any(Fault::is_error)
    }

    /// Adds one.
    pub fn push(&mut self, fault: Fault) {
        self.0.push(fault);
    }

    /// Adds those of another input behind the present ones.
    pub fn merge(&mut self, others: Faults) {
        self.0.extend(others.0);
    }

    /// Sorts by file, place and text, and drops repetitions, so that the order in which checks ran does
    /// not show.
    pub fn sort(&mut self) {
        let key =
            |fault: &Fault| (fault.file.clone(), fault.position, fault.path.clone(), fault.message.clone());
        self.0.sort_by_cached_key(key);
        self.0.dedup();
    }

    /// The value with these faults as warnings if none of them is an error.
    ///
    /// # Errors
    /// All faults, sorted, if one of them is an error.
    pub fn into_result<T>(mut self, value: T) -> Result<Warned<T>, Self> {
        self.sort();
        if self.has_errors() { Err(self) } else { Ok(Warned { value, warnings: self }) }
    }
}

impl From<Fault> for Faults {
    fn from(fault: Fault) -> Self {
        Self(vec![fault])
    }
}

impl fmt::Display for Faults {
    /// The report of each fault, one after the other; see [`Fault::report`].
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, fault) in self.0.iter().enumerate() {
            let separator = if index == 0 { "" } else { "\n" };
            write!(f, "{separator}{}", fault.report())?;
        }
        Ok(())
    }
}

impl std::error::Error for Faults {}

impl IntoIterator for Faults {
    type Item = Fault;
    type IntoIter = std::vec::IntoIter<Fault>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'a> IntoIterator for &'a Faults {
    type Item = &'a Fault;
    type IntoIter = std::slice::Iter<'a, Fault>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    fn fault(file: &str, position: (usize, usize)) -> Fault {
        Fault { position: Some(position), ..Fault::of_file(Path::new(file), "wrong") }
    }

    #[test]
    fn sorted_by_file_and_place_without_repetition() {
        let list = [fault("b", (1, 1)), fault("a", (10, 1)), fault("a", (2, 5)), fault("a", (10, 1))];
        let mut faults = Faults(list.to_vec());
        faults.sort();
        assert_eq!(faults.to_string(), "a:2:5: wrong\na:10:1: wrong\nb:1:1: wrong");
    }

    #[test]
    fn warnings_alone_are_no_failure() {
        let mut faults = Faults::from(fault("a", (1, 1)).as_warning());
        assert_eq!(faults.clone().into_result(7).unwrap().value, 7);
        faults.merge(fault("a", (2, 1)).into());
        assert_eq!(faults.into_result(7).unwrap_err().0.len(), 2);
    }
}
