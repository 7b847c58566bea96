//! `view` as a real process: who may ask, what is answered, what is written.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::world::World;

/// A machine that is busy with other tests is slow; this long it is never.
const PATIENCE: Duration = Duration::from_secs(120);

/// A server, ended at the latest with the test.
struct Serving {
    child: Child,
    host: String,
    token: String,
}

/// An answer: status, head, body.
struct Answer {
    status: u16,
    head: String,
    body: Vec<u8>,
}

impl Answer {
    fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap_or_else(|error| {
            panic!("{error}: {} {}", self.status, String::from_utf8_lossy(&self.body))
        })
    }
}

impl Serving {
    fn start(world: &World, words: &[&str]) -> Self {
        let words = [&["view", "--no-open", "--effort", "1", "--textures", "none"], words].concat();
        let mut child = world.command(&words).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let mut address = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut address).unwrap();
        let address =
            address.trim().strip_prefix("http://").unwrap_or_else(|| panic!("no address: {address:?}"));
        let (host, rest) = address.split_once('/').unwrap();
        Self { child, host: host.to_owned(), token: rest.trim_end_matches('/').to_owned() }
    }

    /// Asks as a browser does; a header replaces the usual one of its name, and an empty one is left out.
    fn ask(&self, method: &str, path: &str, headers: &[(&str, &str)], body: &str) -> Answer {
        let length = body.len().to_string();
        let mut all: BTreeMap<&str, &str> =
            BTreeMap::from([("Host", self.host.as_str()), ("Connection", "close")]);
        if method == "POST" {
            all.extend([
                ("Content-Type", "application/json"),
                ("X-Roomwright", "1"),
                ("Content-Length", length.as_str()),
            ]);
        }
        all.extend(headers.iter().copied());
        let lines = all.iter().filter(|(_, value)| !value.is_empty());
        let lines: String = lines.map(|(name, value)| format!("{name}: {value}\r\n")).collect();
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        write!(stream, "{method} {path} HTTP/1.1\r\n{lines}\r\n{body}").unwrap();
        let mut bytes = Vec::new();
        stream.read_to_end(&mut bytes).unwrap();
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n").unwrap();
        let head = String::from_utf8_lossy(&bytes[..end]).to_ascii_lowercase();
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        let mut body = bytes.split_off(end + 4);
        if head.contains("transfer-encoding: chunked") {
            body = without_chunks(&body);
        }
        Answer { status, head, body }
    }

    fn get(&self, path: &str) -> Answer {
        self.ask("GET", &format!("/{}/{path}", self.token), &[], "")
    }

    fn post(&self, path: &str, body: &Value) -> Answer {
        self.ask("POST", &format!("/{}/{path}", self.token), &[], &body.to_string())
    }

    /// The rooms of a level by id with their versions, when all are there.
    fn rooms(&self, building: &str, level: &str) -> BTreeMap<String, String> {
        let body = json!({"building": building, "level": level, "position": [0, 0], "mode": "orbit"});
        let looked = wait(|| {
            let answer = self.post("api/look", &body).json();
            (answer["waiting"] == 0).then_some(answer)
        });
        let rooms = looked["rooms"].as_array().unwrap().iter();
        let text = |room: &Value, key: &str| room[key].as_str().unwrap().to_owned();
        rooms.map(|room| (text(room, "room"), text(room, "version"))).collect()
    }
}

impl Drop for Serving {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[expect(
    clippy::disallowed_methods,
    reason = "a test that waits for another process, which tells nobody when it is done"
)]
fn wait<T>(look: impl Fn() -> Option<T>) -> T {
    let started = Instant::now();
    loop {
        if let Some(found) = look() {
            return found;
        }
        assert!(started.elapsed() < PATIENCE, "it does not come");
        std::thread::sleep(Duration::from_millis(20));
    }
}

fn without_chunks(mut bytes: &[u8]) -> Vec<u8> {
    let mut whole = Vec::new();
    while let Some(end) = bytes.windows(2).position(|two| two == b"\r\n") {
        let length = usize::from_str_radix(std::str::from_utf8(&bytes[..end]).unwrap(), 16).unwrap();
        whole.extend_from_slice(&bytes[end + 2..end + 2 + length]);
        bytes = &bytes[end + 4 + length..];
        if length == 0 {
            break;
        }
    }
    whole
}

fn house(world: &World) {
    let plan = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("configs/plans/house.yaml");
    world.write("plans/house.yaml", std::fs::read_to_string(plan).unwrap());
}

/// The nodes of a file below a room: place and extras by name.
fn nodes(bytes: &[u8], room: &str) -> BTreeMap<String, String> {
    let document = gltf::Gltf::from_slice_without_validation(bytes).unwrap();
    let mut open: Vec<gltf::Node<'_>> =
        document.nodes().filter(|node| node.name() == Some(&format!("room:{room}"))).collect();
    let mut found = BTreeMap::new();
    while let Some(node) = open.pop() {
        let extras = node.extras().as_ref().map(|extras| extras.get().to_owned());
        found.insert(node.name().unwrap().to_owned(), format!("{:?} {extras:?}", node.transform()));
        open.extend(node.children());
    }
    found
}

#[test]
fn rooms_are_those_of_a_bake() {
    let world = World::new();
    house(&world);
    world.must(&["bake", "plans/house.yaml", "--effort", "1"]);
    let serving = Serving::start(&world, &["plans/house.yaml"]);
    for level in ["ground", "upper"] {
        let baked = std::fs::read(world.path(&format!("out/house/{level}.glb"))).unwrap();
        let rooms = serving.rooms("house", level);
        assert!(rooms.len() >= 7);
        for (room, version) in rooms {
            let path = format!("api/room?building=house&level={level}&room={room}&version={version}");
            let answer = serving.get(&path);
            assert_eq!(answer.status, 200);
            assert!(
                answer.head.contains("content-type: model/gltf-binary") && answer.head.contains("immutable")
            );
            let (served, known) = (nodes(&answer.body, &room), nodes(&baked, &room));
            assert!(!served.is_empty());
            assert_eq!(served, known, "{level}/{room}");
            for uri in gltf_uris(&answer.body) {
                assert_eq!(serving.get(&format!("shared/{uri}")).status, 200, "{uri}");
            }
        }
    }
}

fn gltf_uris(bytes: &[u8]) -> Vec<String> {
    let document = gltf::Gltf::from_slice_without_validation(bytes).unwrap();
    let json = document.document.into_json();
    let buffers = json.buffers.into_iter().filter_map(|buffer| buffer.uri);
    buffers.chain(json.images.into_iter().filter_map(|image| image.uri)).collect()
}

#[test]
fn only_the_page_of_the_server_gets_answers() {
    let world = World::new();
    house(&world);
    world.write("secret.txt", "secret");
    let serving = Serving::start(&world, &["plans/house.yaml"]);
    let token = serving.token.clone();
    let site = format!("/{token}/api/site");
    assert_eq!(serving.get("").status, 200);
    assert_eq!(serving.get("api/site").status, 200);
    assert!(token.len() == 32 && serving.host.starts_with("127.0.0.1:"));
    // Without the token, or with another.
    for path in ["/", "/api/site", "/index.html", &format!("/{}/api/site", "0".repeat(32))] {
        assert_eq!(serving.ask("GET", path, &[], "").status, 404, "{path}");
    }
    // Under another name, and from another page.
    let port = serving.host.rsplit_once(':').unwrap().1.to_owned();
    for host in ["example.com".to_owned(), format!("example.com:{port}"), "127.0.0.1".to_owned()] {
        assert_eq!(serving.ask("GET", &site, &[("Host", &host)], "").status, 403, "{host}");
    }
    let own = format!("http://127.0.0.1:{port}");
    for (origin, status) in
        [("http://example.com", 403), ("null", 403), ("http://127.0.0.1:1", 403), (own.as_str(), 200)]
    {
        assert_eq!(serving.ask("GET", &site, &[("Origin", origin)], "").status, status, "{origin}");
    }
    let look =
        json!({"building": "house", "level": "ground", "position": [1, 1], "mode": "orbit"}).to_string();
    let path = format!("/{token}/api/look");
    assert_eq!(serving.ask("POST", &path, &[("X-Roomwright", "")], &look).status, 403);
    assert_eq!(serving.ask("POST", &path, &[("Content-Type", "text/plain")], &look).status, 415);
    assert_eq!(serving.ask("POST", &path, &[], &look).status, 200);
    // Out of the folder.
    for path in [
        "page/../Cargo.toml",
        "page/..%2f..%2fsecret.txt",
        "page/%2e%2e/secret.txt",
        "page//etc/passwd",
        "shared/../secret.txt",
        "shared/%2fetc%2fpasswd",
        "shared/secret.txt",
        "secret.txt",
        "plans/house.yaml",
    ] {
        let answer = serving.get(path);
        assert!(answer.status == 404 || answer.status == 400, "{path}: {}", answer.status);
    }
    let head = serving.get("").head;
    for header in
        ["content-security-policy: default-src 'self'", "nosniff", "x-frame-options: deny", "no-store"]
    {
        assert!(head.contains(header), "{header}: {head}");
    }
}

#[test]
fn odd_questions_are_refused_in_words() {
    let world = World::new();
    house(&world);
    let serving = Serving::start(&world, &["plans/house.yaml"]);
    for (path, body, status, part) in [
        (
            "api/look",
            json!({"building": "house", "level": "attic", "position": [0, 0], "mode": "walk"}),
            404,
            "house/attic",
        ),
        (
            "api/edit",
            json!({"building": "house", "level": "ground", "room": "bar", "object": "sofa.1", "entry": {}}),
            404,
            "bar",
        ),
        (
            "api/edit",
            json!({"building": "house", "level": "ground", "room": "living", "object": "sofa.1", "entry": {"att": 1}}),
            422,
            "att",
        ),
        ("api/settings", json!({"seed": 1, "style": "baroque"}), 422, "baroque"),
    ] {
        let answer = serving.post(path, &body);
        assert_eq!(answer.status, status, "{path} {body}");
        assert!(answer.json()["error"].as_str().unwrap().contains(part), "{}", answer.json());
    }
    for (path, body) in [("api/look", "{"), ("api/look", "{\"building\": 7}"), ("api/edit", "[]")] {
        let answer = serving.ask("POST", &format!("/{}/{path}", serving.token), &[], body);
        assert!((400..500).contains(&answer.status), "{body}: {}", answer.status);
    }
    let long = "x".repeat(100_000);
    let answer = serving.ask(
        "POST",
        &format!("/{}/api/look", serving.token),
        &[],
        &format!("{{\"building\": \"{long}\"}}"),
    );
    assert_eq!(answer.status, 413);
    assert_eq!(serving.get("api/room?building=house&level=ground&room=bar").status, 404);
    assert_eq!(serving.get("api/room?building=house").status, 400);
    assert_eq!(serving.get("api/explain?building=house&level=ground&room=bar").status, 404);
    assert!(!world.path("plans/house.edits.yaml").exists());
}

#[test]
fn edits_are_written_beside_the_plan_and_are_there_after_a_restart() {
    let world = World::new();
    house(&world);
    let id = json!({"building": "house", "level": "ground", "room": "living"});
    let place = |serving: &Serving| {
        let explained = serving.get("api/explain?building=house&level=ground&room=living").json();
        let version = serving.rooms("house", "ground")["living"].clone();
        let room =
            serving.get(&format!("api/room?building=house&level=ground&room=living&version={version}"));
        (explained["seed"].clone(), nodes(&room.body, "living"))
    };
    let serving = Serving::start(&world, &["plans/house.yaml"]);
    let before = place(&serving).1;
    let sofa = before.iter().find(|(_, node)| node.contains("furniture")).map(|(name, _)| name).unwrap();
    let object = sofa.split('@').next().unwrap();
    let mut edit = id.clone();
    edit["object"] = json!(object);
    edit["entry"] = json!({"remove": true});
    let answer = serving.post("api/edit", &edit).json();
    assert!(answer["file"].as_str().unwrap().ends_with("house.edits.yaml"), "{answer}");
    assert!(!place(&serving).1.contains_key(sofa));
    edit["entry"] = Value::Null;
    serving.post("api/edit", &edit).json();
    assert_eq!(place(&serving).1, before, "the edit is forgotten");
    let rolled = serving.post("api/reroll", &id).json();
    assert_eq!(rolled["seed"], 2);
    let after = place(&serving).1;
    assert_ne!(after, before);
    drop(serving);
    let text = std::fs::read_to_string(world.path("plans/house.edits.yaml")).unwrap();
    assert!(text.contains("seed: 2"), "{text}");
    assert_eq!(place(&Serving::start(&world, &["plans/house.yaml"])).1, after);
}

#[test]
fn a_saved_plan_changes_its_rooms_and_a_fault_is_told() {
    let world = World::new();
    house(&world);
    let serving = Serving::start(&world, &["plans/house.yaml"]);
    let before = serving.rooms("house", "ground");
    let mut events = TcpStream::connect(&serving.host).unwrap();
    events.set_read_timeout(Some(PATIENCE)).unwrap();
    write!(events, "GET /{}/api/events HTTP/1.1\r\nHost: {}\r\n\r\n", serving.token, serving.host).unwrap();
    let mut events = BufReader::new(events);
    let mut line = String::new();
    events.read_line(&mut line).unwrap();
    assert!(line.contains("200"), "from now on it is told what changes: {line}");
    let mut next = || loop {
        let mut line = String::new();
        assert!(events.read_line(&mut line).unwrap() > 0);
        if let Some(data) = line.strip_prefix("data: ") {
            break serde_json::from_str::<Value>(data).unwrap();
        }
    };
    let text = std::fs::read_to_string(world.path("plans/house.yaml")).unwrap();
    world.write("plans/house.yaml", "version: 1\nlevels: 7\n");
    let told = next();
    assert_eq!(told["kind"], "faults");
    assert!(told["faults"][0].as_str().unwrap().contains("house.yaml:2"), "{told}");
    assert_eq!(serving.rooms("house", "ground"), before, "what was there stays");
    // One room becomes another; the upper floor stays as it is.
    world.write("plans/house.yaml", text.replace("type: study", "type: bedroom"));
    while next()["kind"] != "changed" {}
    // The fault is mended, or the room is another already.
    let after = wait(|| {
        let now = serving.rooms("house", "ground");
        (now != before).then_some(now)
    });
    assert_eq!(after.len(), before.len());
}

#[test]
fn a_port_that_is_taken_is_said() {
    let world = World::new();
    house(&world);
    let serving = Serving::start(&world, &["plans/house.yaml"]);
    let port = serving.host.rsplit_once(':').unwrap().1;
    let output = world.command(&["view", "--no-open", "plans/house.yaml", "--port", port]).output().unwrap();
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        !output.status.success() && error.contains("--port") && error.contains("another port"),
        "{error}"
    );
}

#[test]
fn a_finished_bake_is_shown_as_it_is() {
    let world = World::new();
    house(&world);
    world.must(&["bake", "plans/house.yaml", "--effort", "1", "--shared-library"]);
    for path in ["out", "out/house/ground.glb"] {
        let serving = Serving::start(&world, &[path]);
        let site = serving.get("api/site").json();
        assert_eq!((&site["kind"], &site["is_editable"]), (&json!("bake"), &json!(false)));
        assert_eq!(site["buildings"][0]["levels"][0]["id"], "ground");
        let level = serving.get("api/level?building=house&level=ground").json();
        assert_eq!(level["rooms"].as_array().unwrap().len(), 7);
        let file = serving.get("api/levelfile?building=house&level=ground").body;
        assert_eq!(file, world.read("out/house/ground.glb"));
        let uris = gltf_uris(&file);
        assert!(!uris.is_empty());
        for uri in uris {
            assert_eq!(
                serving.get(&format!("shared/{uri}")).body,
                world.read(&format!("out/house/{uri}")),
                "{uri}"
            );
        }
        for path in [
            "shared/ground.glb",
            "shared/shared-geometry/../ground.glb",
            "shared/../manifest.json",
            "shared/shared-geometry/",
        ] {
            assert!(serving.get(path).status >= 400, "{path}");
        }
        let roll = json!({"building": "house", "level": "ground", "room": "living"});
        assert_eq!(serving.post("api/reroll", &roll).status, 422);
    }
    assert!(!world.path("plans/house.edits.yaml").exists());
}
