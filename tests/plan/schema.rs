//! The plans in `configs/` obey the published JSON Schemas.

use roomwright::internals::document::Source;

use super::support::{files, repository};

#[test]
fn ready_plans_name_their_schema_and_obey_it() {
    for (folder, schema, mark) in [
        ("configs/plans", "plan", "$schema=../schema/plan.schema.json"),
        ("configs", "project", "$schema=schema/project.schema.json"),
    ] {
        let schema =
            std::fs::read_to_string(repository(&format!("configs/schema/{schema}.schema.json"))).unwrap();
        let schema: serde_json::Value = serde_json::from_str(&schema).unwrap();
        let validator = jsonschema::validator_for(&schema).unwrap();
        for plan in files(&repository(folder), &["yaml"]) {
            let text = std::fs::read_to_string(&plan).unwrap();
            if folder == "configs" && !text.contains("\nproject:") {
                continue;
            }
            assert!(text.lines().next().unwrap().ends_with(mark), "{}", plan.display());
            let value: serde_json::Value = Source::new("text.yaml".as_ref(), &text).parse().unwrap();
            let errors: Vec<String> = validator.iter_errors(&value).map(|error| error.to_string()).collect();
            assert!(errors.is_empty(), "{}: {errors:?}", plan.display());
        }
    }
}
