//! The kinds of bakes that are killed, each with the files that it leaves when it is not disturbed.

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use super::world::{World, plan};

/// What ends a process without asking: the kernel, a service manager, a person.
pub(crate) const SIGNALS: [&str; 3] = ["KILL", "TERM", "INT"];

/// Levels of the plan: each is a moment at which a file goes into place.
const LEVELS: usize = 5;

/// Share of the levels that each process bakes, where several work into one folder.
const SHARES: [&str; 2] = ["1/2", "2/2"];

/// One kind of bake.
pub(crate) struct Kind {
    name: &'static str,
    arguments: &'static [&'static str],
    has_cache: Cache,
    /// Two processes share the levels.
    is_shared_out: bool,
    /// What is killed is the joining of what is there.
    is_merge: bool,
}

/// What is kept between the runs of a scene.
#[derive(PartialEq)]
enum Cache {
    None,
    /// Empty at the beginning of each session.
    Cold,
    /// Filled once: painting takes longer than all the rest.
    Warm,
}

const PLAIN: Kind =
    Kind { name: "plain", arguments: &[], has_cache: Cache::None, is_shared_out: false, is_merge: false };

pub(crate) const SCENES: [Kind; 6] = [
    PLAIN,
    Kind { name: "text format", arguments: &["--format", "gltf"], ..PLAIN },
    Kind {
        name: "shared library, cold cache",
        arguments: &["--shared-library"],
        has_cache: Cache::Cold,
        ..PLAIN
    },
    Kind {
        name: "shared textures and library",
        arguments: &["--textures", "small", "--shared-textures", "--shared-library"],
        has_cache: Cache::Warm,
        ..PLAIN
    },
    Kind { name: "several processes", arguments: &["--format", "gltf"], is_shared_out: true, ..PLAIN },
    Kind { name: "merge", is_merge: true, is_shared_out: true, ..PLAIN },
];

/// A kind of bake in a folder of its own.
pub(crate) struct Scene {
    kind: &'static Kind,
    world: World,
    /// What an undisturbed bake leaves.
    whole: BTreeMap<String, String>,
    duration: Duration,
}

impl Scene {
    /// Bakes undisturbed first.
    pub(crate) fn new(kind: &'static Kind) -> Self {
        let world = World::new();
        world.write("a.yaml", plan("alpha", LEVELS));
        let mut scene = Self { kind, world, whole: BTreeMap::new(), duration: Duration::ZERO };
        // A second time where the first had to paint.
        for _ in 0..if kind.has_cache == Cache::Warm { 2 } else { 1 } {
            let _ = fs::remove_dir_all(scene.world.path("whole"));
            let start = Instant::now();
            let status = scene.bake("whole", None, "1").status().unwrap();
            assert!(status.success(), "{}", kind.name);
            scene.duration = start.elapsed();
        }
        scene.whole = scene.world.files("whole");
        if kind.is_merge {
            scene.fill();
            let start = Instant::now();
            assert!(scene.merge().status().unwrap().success());
            scene.duration = start.elapsed();
        }
        scene
    }

    pub(crate) fn name(&self) -> &str {
        self.kind.name
    }

    pub(crate) fn out(&self) -> PathBuf {
        self.world.path("out")
    }

    /// How long what is killed takes undisturbed, in about.
    pub(crate) fn duration(&self) -> Duration {
        self.duration
    }

    /// An output folder that is new, or holds what an earlier bake with another seed left.
    pub(crate) fn prepare(&self, has_earlier: bool) {
        let _ = fs::remove_dir_all(self.out());
        if self.kind.has_cache == Cache::Cold {
            let _ = fs::remove_dir_all(self.world.path("cache"));
        }
        if has_earlier {
            assert!(self.bake("out", None, "2").status().unwrap().success());
        }
        if self.kind.is_merge {
            self.fill();
        }
    }

    /// Starts, waits, sends the signal to the first process or to all; answers how many it has ended.
    pub(crate) fn killed(&self, moment: Duration, signal: &str, all: bool) -> u64 {
        let mut children: Vec<Child> =
            self.commands().into_iter().map(|mut command| command.spawn().unwrap()).collect();
        sleep(moment);
        for child in &mut children[..if all { self.commands().len() } else { 1 }] {
            // Once it has ended and was waited for, its id may be another's.
            if child.try_wait().unwrap().is_none() {
                let id = child.id().to_string();
                let sent = Command::new("kill").args(["-s", signal, &id]).stderr(Stdio::null()).status();
                assert!(sent.is_ok());
            }
        }
        let ends = children.iter_mut().map(|child| child.wait().unwrap());
        ends.filter(|status| {
            assert!(status.success() || status.signal().is_some(), "{}: {status}", self.kind.name);
            status.signal().is_some()
        })
        .count() as u64
    }

    /// Runs to the end, and compares with what an undisturbed bake leaves.
    pub(crate) fn complete(&self) {
        if self.kind.is_merge {
            // Joins what there is; the rest is baked by those that were killed.
            assert!(self.merge().status().unwrap().success());
        }
        for share in self.shares() {
            let mut bake = self.bake("out", share, "1");
            // Without it, shared files of the earlier seed stay, listed apart.
            bake.args(share.is_none().then_some("--prune"));
            assert!(bake.status().unwrap().success(), "{}", self.kind.name);
        }
        let left = self.world.files("out");
        let differing = |from: &BTreeMap<String, String>, to: &BTreeMap<String, String>| {
            from.iter()
                .filter(|&(name, hash)| to.get(name) != Some(hash))
                .map(|(name, _)| name.clone())
                .collect()
        };
        let found: [Vec<String>; 2] = [differing(&left, &self.whole), differing(&self.whole, &left)];
        assert_eq!(found, <[Vec<String>; 2]>::default(), "{}: found, and expected", self.kind.name);
        let is_begun = |name: &String| name.contains("/entry-") || name.contains("/note-");
        let cached = self.world.contents("cache").into_keys().filter(is_begun);
        assert_eq!(cached.collect::<Vec<_>>(), Vec::<String>::new(), "{}", self.kind.name);
    }

    /// What is killed.
    fn commands(&self) -> Vec<Command> {
        if self.kind.is_merge {
            return vec![self.merge()];
        }
        self.shares().map(|share| self.bake("out", share, "1")).collect()
    }

    fn shares(&self) -> impl Iterator<Item = Option<&'static str>> {
        let shares = if self.kind.is_shared_out { SHARES.map(Some).to_vec() } else { vec![None] };
        shares.into_iter()
    }

    fn bake(&self, out: &str, share: Option<&str>, seed: &str) -> Command {
        let mut arguments = vec!["bake", "a.yaml", "--quiet", "--threads", "2", "--out", out, "--seed", seed];
        arguments.extend(self.kind.arguments);
        arguments.extend(share.map(|share| ["--shard", share]).into_iter().flatten());
        let mut command = self.world.command(&arguments);
        if self.kind.has_cache != Cache::None {
            command.env("ROOMWRIGHT_CACHE", "cache");
        }
        command
    }

    fn merge(&self) -> Command {
        self.world.command(&["merge", "out", "--quiet"])
    }

    /// What a merge has to join: the part of one process, and the journal of another that was killed.
    fn fill(&self) {
        assert!(self.bake("out", Some(SHARES[0]), "1").status().unwrap().success());
        let mut child = self.bake("out", Some(SHARES[1]), "1").spawn().unwrap();
        let second = self.out().join("alpha/2.glb");
        while !second.exists() && child.try_wait().unwrap().is_none() {
            sleep(Duration::from_millis(1));
        }
        child.kill().unwrap();
        child.wait().unwrap();
    }
}
