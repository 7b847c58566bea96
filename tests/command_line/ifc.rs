//! IFC files from the file to furnished levels; they are cases of `tests/cases/plan_import`.

use std::path::Path;

use super::world::World;

/// All cases of the format, with the levels that each has.
const CASES: [(&str, usize); 5] = [("villa", 2), ("rotunda", 1), ("attic", 1), ("pavilion", 2), ("shell", 1)];

#[test]
fn an_imported_file_bakes_to_the_bytes_of_the_file() {
    let world = World::new();
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/plan_import");
    for (name, _) in CASES {
        let file = format!("{name}.ifc");
        world.write(&format!("models/{file}"), std::fs::read(cases.join(name).join(&file)).unwrap());
    }
    // One of the cases has spaces that are left out.
    for (command, from, to) in
        [("import", "models", "plans"), ("bake", "models", "direct"), ("bake", "plans", "native")]
    {
        let mut arguments = vec![command, from, "--out", to];
        if command == "bake" {
            arguments.extend(["--effort", "1"]);
        }
        let expected = i32::from(from == "models");
        assert_eq!(world.run(&arguments).code, Some(expected), "{command} {from}");
    }
    let [direct, native] = ["direct", "native"].map(|folder| world.levels(folder));
    assert_eq!(direct.len(), CASES.iter().map(|(_, levels)| levels).sum::<usize>());
    assert_eq!(native.len(), direct.len());
    for (one, other) in direct.iter().zip(&native) {
        assert!(one == other, "{} and {} differ", one.0, other.0);
    }
}
