//! Reports the files of earlier bakes in an output folder, for people and as JSON.

use std::path::Path;

use super::answer::{LeftoversAnswer, LevelAnswer};

use crate::batch::Leftovers;
use crate::document::counted;

/// Most names in one line.
const LISTED_NAMES: usize = 5;

/// For people; `None` where nothing was left.
pub(super) fn leftovers_text(leftovers: &Leftovers, out: &Path) -> Option<String> {
    let Leftovers { levels, files, removed, changed } = leftovers;
    let mut lines = Vec::new();
    if !removed.is_empty() {
        lines.push(format!(
            "Removed {} that no plan has any more: {}.",
            counted(removed.len(), "file"),
            few(removed)
        ));
    }
    if !changed.is_empty() {
        let (files, names) = (counted(changed.len(), "file"), few(changed));
        lines.push(format!(
            "warning: {files} of levels that no plan has any more stay, because they were changed since: {names}"
        ));
    }
    if !levels.is_empty() {
        let names: Vec<String> =
            levels.iter().map(|(building, level)| format!("{building}/{level}")).collect();
        lines.push(format!(
            "warning: {} in {}, in none of these plans: {}. The files stay; audit and diff do not count them.",
            counted(levels.len(), "level"),
            out.display(),
            few(&names)
        ));
    }
    if !files.is_empty() {
        lines.push(format!(
            "warning: no level uses {}: {}.",
            counted(files.len(), "shared file"),
            few(files)
        ));
    }
    if !levels.is_empty() || !files.is_empty() {
        lines.push("  hint: `bake` with --prune removes them".to_owned());
    }
    (!lines.is_empty()).then(|| lines.join("\n"))
}

/// For machines.
pub(super) fn leftovers_answer(leftovers: &Leftovers) -> LeftoversAnswer {
    let Leftovers { levels, files, removed, changed } = leftovers.clone();
    let levels = levels.into_iter().map(|(building, level)| LevelAnswer { building, level }).collect();
    LeftoversAnswer { levels, files, removed, changed }
}

/// The first names, and how many more there are.
fn few(names: &[String]) -> String {
    let shown = names.iter().take(LISTED_NAMES).cloned().collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(LISTED_NAMES) {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leftovers_are_listed_with_the_flag_that_removes_them() {
        let levels = (0..7).map(|number| ("house".to_owned(), number.to_string())).collect();
        let leftovers = Leftovers { levels, ..Leftovers::default() };
        let text = leftovers_text(&leftovers, Path::new("out")).unwrap();
        assert!(
            text.contains("7 levels") && text.contains("house/4 and 2 more") && text.contains("--prune"),
            "{text}"
        );
        assert_eq!(leftovers_text(&Leftovers::default(), Path::new("out")), None);
        assert_eq!(leftovers_answer(&leftovers).levels[0].level, "0");
    }
}
