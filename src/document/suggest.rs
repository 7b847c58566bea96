//! Finds the known word nearest to a mistyped one, for hints such as "did you mean ...?".

/// Least similarity (Jaro-Winkler, 0 to 1) of a suggestion: 0.8 pairs `kitchin` with `kitchen` and
/// `rom` with `room`, but not `sofa` with `stove`. Lower suggests nonsense, higher misses swapped letters.
const LEAST_SIMILARITY: f64 = 0.8;

/// Letters of the longest word that is compared: people mistype words, not pages.
const LONGEST_WORD: usize = 100;

/// The candidate most like a word, if one is like it at all. Equal ones are settled by the alphabet.
#[must_use]
pub fn suggest<I>(word: &str, candidates: I) -> Option<String>
where
    I: IntoIterator,
    I::Item: AsRef<str>,
{
    if word.len() > LONGEST_WORD {
        return None;
    }
    let word = word.to_lowercase();
    let score = |candidate: &str| strsim::jaro_winkler(&word, &candidate.to_lowercase());
    // A front_door is a door, whatever the letters before it.
    let is_kind = |candidate: &str| word.ends_with(&format!("_{}", candidate.to_lowercase()));
    let similarity = |candidate: &str| if is_kind(candidate) { 1.0 } else { score(candidate) };
    let scored = candidates
        .into_iter()
        .map(|candidate| (similarity(candidate.as_ref()), candidate.as_ref().to_owned()));
    scored
        .filter(|(score, _)| *score >= LEAST_SIMILARITY)
        .max_by(|a, b| a.0.total_cmp(&b.0).then_with(|| b.1.cmp(&a.1)))
        .map(|(_, candidate)| candidate)
}

/// Most candidates that a hint lists.
const LISTED_CANDIDATES: usize = 24;

/// A hint about an unknown word: the most similar candidate, or all of them if they are few.
#[must_use]
pub fn did_you_mean<I>(word: &str, candidates: I) -> Option<String>
where
    I: IntoIterator + Clone,
    I::Item: AsRef<str>,
{
    if let Some(suggestion) = suggest(word, candidates.clone()) {
        return Some(format!("did you mean \"{suggestion}\"?"));
    }
    let mut all: Vec<String> =
        candidates.into_iter().map(|candidate| candidate.as_ref().to_owned()).collect();
    all.sort();
    all.dedup();
    (!all.is_empty() && all.len() <= LISTED_CANDIDATES).then(|| format!("possible here: {}", all.join(", ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_word_is_suggested() {
        let words = ["kitchenette", "bedroom", "kitchen"];
        assert_eq!(suggest("kitchin", words).as_deref(), Some("kitchen"));
        assert_eq!(suggest("Bedrom", words).as_deref(), Some("bedroom"));
        assert_eq!(suggest("xyz", words), None);
        assert_eq!(suggest("front_door", ["window", "door"]).as_deref(), Some("door"));
    }

    #[test]
    fn few_candidates_are_listed_where_none_is_near() {
        assert_eq!(did_you_mean("xyz", ["b", "a"]).as_deref(), Some("possible here: a, b"));
        assert_eq!(did_you_mean("xyz", (0..100).map(|i| i.to_string())), None);
    }
}
