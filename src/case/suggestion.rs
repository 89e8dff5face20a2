//! What somebody may have meant who wrote an unknown word.

use super::complaint::shorten;

/// The known word nearest to `word`, if it is near enough to be a slip of the keyboard.
pub(crate) fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = shorten(word, 60).to_lowercase();
    let allowed = (1 + word.chars().count() / 3).min(3);
    known
        .into_iter()
        // A swap of neighbours counts as one slip.
        .map(|candidate| (strsim::osa_distance(&word, candidate), candidate))
        .filter(|&(distance, _)| distance <= allowed)
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, candidate)| candidate)
}

/// Words in backticks with commas between, for help lines.
pub(crate) fn listed<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    let quoted: Vec<String> = words.into_iter().map(|word| format!("`{word}`")).collect();
    quoted.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_find_their_word_and_nonsense_does_not() {
        let known = ["friction", "overburden", "push"];
        assert_eq!(nearest("frction", known), Some("friction"));
        assert_eq!(nearest("psuh", known), Some("push"));
        assert_eq!(nearest("Overburden", known), Some("overburden"));
        assert_eq!(nearest("mortar", known), None);
    }
}
