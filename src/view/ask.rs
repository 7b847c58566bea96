//! Questions as texts, for a page that has no server: the page in a worker of the browser asks itself.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use percent_encoding::percent_decode_str;
use serde::de::DeserializeOwned;
use serde_json::Value;

use super::questions::{Answers, Controls, Refusal};
use super::session::{EditsChange, Session, ViewSources};
use crate::contract::RoomId;
use crate::document::{Fault, Faults};
use crate::output::LevelOptions;
use crate::plan::{PlacedBuilding, RoomRef};
use crate::project::{Project, RoomWriter};

/// A plan in memory, furnished on demand on the thread that asks.
pub struct PlanPage {
    session: Session,
}

/// An answer: the status of HTTP, and JSON, or a file.
pub type PageAnswer = (u16, Vec<u8>);

impl PlanPage {
    /// Opens a plan in YAML or JSON; the name stands in its faults.
    ///
    /// # Errors
    /// All faults of the plan, in words, a line or more each.
    pub fn open(name: &str, text: &str, seed: Option<u64>) -> Result<Self, String> {
        let sources = TextSources { name: name.to_owned(), text: text.to_owned() };
        let controls = Controls { seed, style: None };
        let in_words = |faults: Faults| faults.0.iter().map(Fault::report).collect::<Vec<_>>().join("\n");
        let read = sources.read(&controls).map_err(in_words)?;
        let no_threads: Option<NonZeroUsize> = None;
        let session = Session::open(Box::new(sources), controls, read, no_threads)
            .map_err(|error| error.to_string())?;
        Ok(Self { session })
    }

    /// What the server of `roomwright view` answers to a question of its page: an address below its token, and a body.
    #[must_use]
    pub fn ask(&self, address: &str, body: &str) -> PageAnswer {
        match self.answer(address, body) {
            Ok(bytes) => (200, bytes),
            Err(refusal) => {
                let (status, error) = refusal.told();
                (status, json_bytes(&serde_json::json!({"error": error})))
            }
        }
    }

    fn answer(&self, address: &str, body: &str) -> Result<Vec<u8>, Refusal> {
        let (path, query) = address.split_once('?').unwrap_or((address, ""));
        let word = |key: &str| word_of(query, key);
        let id = || RoomId::new(&word("building"), &word("level"), &word("room"));
        let session = &self.session;
        match path {
            "api/site" => Ok(json_bytes(&session.site())),
            "api/level" => session.level(&word("building"), &word("level")).map(|answer| json_bytes(&answer)),
            "api/look" => session.look(&parsed(body)?).map(|answer| json_bytes(&serde_json::json!(answer))),
            "api/room" => session.room(&id()),
            "api/settings" => session.set_controls(parsed(body)?).map(|answer| json_bytes(&answer)),
            _ => match path.strip_prefix("shared/") {
                Some(path) => session.shared(path).map(|bytes| bytes.to_vec()),
                None => Err(Refusal::NotFound(format!("{path} needs the program on a machine"))),
            },
        }
    }

    /// All rooms of a level as one binary glTF file, as a bake writes it.
    ///
    /// # Errors
    /// If there is no such level, in words.
    pub fn level_glb(&self, building: &str, level: &str) -> Result<Vec<u8>, String> {
        self.session.level_glb(building, level)
    }
}

fn json_bytes(value: &Value) -> Vec<u8> {
    value.to_string().into_bytes()
}

fn parsed<T: DeserializeOwned>(body: &str) -> Result<T, Refusal> {
    serde_json::from_str(body).map_err(|error| Refusal::Bad(error.to_string()))
}

/// The value of a key in the query of an address.
fn word_of(query: &str, key: &str) -> String {
    let pairs = query.split('&').filter_map(|pair| pair.split_once('='));
    let found = pairs.filter(|(known, _)| *known == key).map(|(_, value)| value.replace('+', " ")).next();
    percent_decode_str(&found.unwrap_or_default()).decode_utf8_lossy().into_owned()
}

/// A plan that is always the same.
struct TextSources {
    name: String,
    text: String,
}

impl ViewSources for TextSources {
    fn read(&self, controls: &Controls) -> Result<(Project, LevelOptions), Faults> {
        let project = Project::parse(&self.name, &self.text)?;
        let defaults = project.level_options();
        let seed = controls.seed.unwrap_or(defaults.seed);
        let options = LevelOptions { seed, style: controls.style.clone(), ..defaults }.shared();
        Ok((project, options))
    }

    fn explain(&self, _: &Project, _: &LevelOptions, _: &PlacedBuilding, _: RoomRef<'_>) -> Option<Value> {
        None
    }

    fn change_edits(&self, _: &Project, _: &str, _: &EditsChange<'_>) -> Result<PathBuf, Faults> {
        Err(Fault::of_file(Path::new(&self.name), "is in memory: edits have no file").into())
    }

    fn is_editable(&self) -> bool {
        false
    }

    fn writer(&self, project: &Project, options: &LevelOptions) -> RoomWriter {
        RoomWriter::new(&project.catalog, options, None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAN: &str = "version: 1\nid: hut\nlevels:\n  - id: a\n    rooms:\n      - {id: bed & board, type: bedroom, rectangle: [0, 0, 4, 4]}\n";

    fn json(answer: &PageAnswer) -> Value {
        serde_json::from_slice(&answer.1).unwrap()
    }

    #[test]
    fn a_plan_in_memory_answers_as_a_server_does() {
        let page = PlanPage::open("hut.yaml", &PLAN.replace("bed & board", "bed"), Some(3)).unwrap();
        let site = json(&page.ask("api/site", ""));
        assert_eq!((&site["seed"], &site["is_editable"]), (&3.into(), &false.into()));
        assert_eq!(site["meanings"]["collision"], "Two bodies intersect.");
        let look = r#"{"building": "hut", "level": "a", "position": [1, 1], "mode": "orbit"}"#;
        let looked = json(&page.ask("api/look", look));
        assert_eq!(looked["waiting"], 0, "{looked}");
        assert_eq!(looked["rooms"][0]["room"], "bed");
        let (status, room) = page.ask("api/room?building=hut&level=a&room=bed&version=1", "");
        assert!(status == 200 && room.starts_with(b"glTF"));
        assert_eq!(page.ask("api/explain?building=hut&level=a&room=bed", "").0, 404);
        assert_eq!(page.ask("api/look", "{").0, 422);
        assert!(page.level_glb("hut", "a").unwrap().starts_with(b"glTF"));
    }

    #[test]
    fn faults_are_told_in_words() {
        let error = PlanPage::open("hut.yaml", "version: 1\nlevels: 7\n", None).err().unwrap();
        assert!(error.contains("hut.yaml:2"), "{error}");
        let error = PlanPage::open("p.yaml", "version: 1\nproject: {plans: []}\n", None).err().unwrap();
        assert!(error.contains("is a project"), "{error}");
    }

    #[test]
    fn words_of_addresses_are_decoded() {
        assert_eq!(word_of("building=a%20b&room=c+d%26e", "room"), "c d&e");
        assert_eq!(word_of("building=a", "room"), "");
    }
}
