//! Lists the files and folders that a bake reads.

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};

use super::super::arguments::{BakeArguments, SourceArguments};
use super::super::sources::read_plans_only;
use crate::document::Faults;
use crate::edits::edits_path;
use crate::plan::{Plan, project_settings};

/// Inputs as the system names them: without links, `.` and `..`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Inputs {
    /// Single files, there or not yet there.
    files: BTreeSet<PathBuf>,
    /// Folders with all that is in them.
    trees: BTreeSet<PathBuf>,
    /// Folders in which nothing is an input: what the bake writes.
    outputs: BTreeSet<PathBuf>,
}

impl Inputs {
    /// Everything that a bake reads: what was typed, the plans of projects, edits beside them, configuration, and the files
    /// that have faults.
    pub(super) fn of(arguments: &BakeArguments) -> Self {
        let outputs = [Some(&arguments.out), arguments.run.cache.as_ref()].into_iter().flatten();
        Self { outputs: outputs.filter_map(real).collect(), ..Self::of_sources(&arguments.run.sources) }
    }

    /// Everything that a project reads.
    fn of_sources(sources: &SourceArguments) -> Self {
        let read = read_plans_only(sources);
        Self::of_reading(sources, read.as_ref().map(|reading| (&reading.plan, &reading.faults)))
    }

    /// Everything that was read: the buildings and faults, or the faults alone where there are no buildings.
    pub(crate) fn of_reading(sources: &SourceArguments, read: Result<(&Plan, &Faults), &Faults>) -> Self {
        let mut inputs = Self::default();
        sources.paths.iter().for_each(|path| inputs.add_plan(path));
        sources.edits.files.iter().for_each(|path| inputs.add_file(path));
        sources.catalog.iter().for_each(|path| inputs.add_tree(path));
        let of_projects =
            project_settings(&sources.paths).map(|settings| settings.catalog).unwrap_or_default();
        of_projects.iter().for_each(|path| inputs.add_tree(path));
        let faults = match read {
            Ok((plan, faults)) => {
                for placed in &plan.buildings {
                    inputs.add_plan(&placed.source.plan);
                }
                faults
            }
            Err(faults) => faults,
        };
        inputs.add_faulty(faults);
        inputs
    }

    fn add_faulty(&mut self, faults: &Faults) {
        let files = faults.0.iter().map(|fault| &fault.file);
        files.filter(|file| file.is_file()).for_each(|file| self.add_file(file));
    }

    /// A plan, a project, a folder or a pattern, with its edits.
    fn add_plan(&mut self, path: &Path) {
        self.add_file(&edits_path(path));
        if path.is_dir() {
            self.add_tree(path);
        } else if path.exists() {
            self.add_file(path);
        } else {
            let is_plain =
                |part: &Component<'_>| !part.as_os_str().to_string_lossy().contains(['*', '?', '[']);
            let plain: PathBuf = path.components().take_while(is_plain).collect();
            if plain == path { self.add_file(path) } else { self.add_tree(&plain) }
        }
    }

    fn add_file(&mut self, path: &Path) {
        self.files.extend(real(path));
    }

    fn add_tree(&mut self, path: &Path) {
        self.trees.extend(real(path));
    }

    /// The files and folders that are there.
    pub(crate) fn found(&self) -> Vec<PathBuf> {
        self.files.union(&self.trees).filter(|path| path.exists()).cloned().collect()
    }

    pub(super) fn is_empty(&self) -> bool {
        self.folders().is_empty()
    }

    pub(super) fn count(&self) -> usize {
        self.files.iter().filter(|file| file.exists()).count() + self.trees.len()
    }

    /// The folders to watch, each with whether all below it are meant.
    pub(super) fn folders(&self) -> BTreeSet<(PathBuf, bool)> {
        let is_in_tree = |folder: &Path| self.trees.iter().any(|tree| folder.starts_with(tree));
        let of_files = self.files.iter().filter_map(|file| file.parent());
        let of_files = of_files.filter(|folder| folder.is_dir() && !is_in_tree(folder));
        let of_files = of_files.map(|folder| (folder.to_owned(), false));
        let trees = self.trees.iter().filter(|tree| tree.is_dir()).map(|tree| (tree.clone(), true));
        of_files.chain(trees).collect()
    }

    /// Whether a changed file is an input.
    pub(super) fn contains(&self, path: &Path) -> bool {
        if self.outputs.iter().any(|folder| path.starts_with(folder)) {
            return false;
        }
        self.files.contains(path)
            || self.trees.iter().any(|tree| path.strip_prefix(tree).is_ok_and(is_visible))
    }

    /// The name of a file for people: from this folder on, where it is below it.
    pub(super) fn show(&self, path: &Path) -> String {
        let here = real(Path::new(".")).unwrap_or_default();
        path.strip_prefix(here).unwrap_or(path).display().to_string()
    }
}

/// Readers pass over hidden files and folders, and editors keep their copies in `name~`.
fn is_visible(below: &Path) -> bool {
    below.iter().all(|part| {
        let part = part.to_string_lossy();
        !part.starts_with('.') && !part.ends_with('~')
    })
}

/// A path as the system reports it. It need not exist, but its folder must.
fn real(path: impl AsRef<Path>) -> Option<PathBuf> {
    let path = path.as_ref();
    if let Ok(found) = path.canonicalize() {
        return Some(found);
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    Some(folder.canonicalize().ok()?.join(path.file_name()?))
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::super::super::arguments::{Arguments, Command};
    use super::*;

    const PLAN: &str =
        "version: 1\nlevels: [{id: a, rooms: [{id: b, type: study, rectangle: [0, 0, 4, 4]}]}]\n";

    fn arguments(words: &[&Path]) -> BakeArguments {
        let start = [Path::new("roomwright"), Path::new("bake"), Path::new("--watch")];
        let typed = Arguments::parse_from(start.iter().chain(words).map(|word| word.as_os_str()));
        let Some(Command::Bake(arguments)) = typed.command else { panic!("bake was typed") };
        arguments
    }

    #[test]
    fn the_watched_inputs_are_plans_edits_and_configuration_but_not_the_output() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path().canonicalize().unwrap();
        let path = |name: &str| root.join(name);
        std::fs::create_dir_all(path("plans")).unwrap();
        std::fs::create_dir_all(path("mine/classes")).unwrap();
        std::fs::write(path("plans/house.yaml"), PLAN).unwrap();
        let project = "version: 1\nproject:\n  catalog: [mine]\n  plans: [{plan: plans/house.yaml}]\n";
        std::fs::write(path("project.yaml"), project).unwrap();
        let inputs = Inputs::of(&arguments(&[&path("project.yaml"), Path::new("--out"), &path("mine/out")]));
        for input in [
            "project.yaml",
            "project.edits.yaml",
            "plans/house.yaml",
            "plans/house.edits.yaml",
            "mine/classes/a.yaml",
        ] {
            assert!(inputs.contains(&path(input)), "{input}");
        }
        for other in
            ["plans/other.yaml", "notes.txt", "mine/out/manifest.json", "mine/.a.yaml.swp", "mine/a.yaml~"]
        {
            assert!(!inputs.contains(&path(other)), "{other}");
        }
    }

    #[test]
    fn faulty_and_missing_plans_are_watched_too() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path().canonicalize().unwrap();
        std::fs::write(root.join("bad.yaml"), "levels: [").unwrap();
        std::fs::write(root.join("project.yaml"), "version: 1\nproject: {plans: [{plan: bad.yaml}]}\n")
            .unwrap();
        let inputs = Inputs::of(&arguments(&[&root.join("project.yaml"), &root.join("new.yaml")]));
        assert!(inputs.contains(&root.join("bad.yaml")) && inputs.contains(&root.join("new.yaml")));
    }
}
