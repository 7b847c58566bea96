//! The published JSON Schemas are those of the types that are read.

use roomwright::edits::edits_schema;
use roomwright::plan::{native_schema, project_schema};

use super::support::{check_golden, files, repository};

#[test]
fn published_schemas_are_those_of_the_types() {
    for (name, schema) in
        [("plan", native_schema()), ("project", project_schema()), ("edits", edits_schema())]
    {
        let text = format!("{}\n", serde_json::to_string_pretty(&schema).unwrap());
        check_golden(&repository(&format!("configs/schema/{name}.schema.json")), &text);
    }
}

#[test]
fn ready_plans_name_their_schema_and_obey_it() {
    for (folder, schema, mark) in [
        ("configs/plans", native_schema(), "$schema=../schema/plan.schema.json"),
        ("configs", project_schema(), "$schema=schema/project.schema.json"),
    ] {
        let validator = jsonschema::validator_for(&schema).unwrap();
        for plan in files(&repository(folder), &["yaml"]) {
            let text = std::fs::read_to_string(&plan).unwrap();
            if folder == "configs" && !text.contains("\nproject:") {
                continue;
            }
            assert!(text.lines().next().unwrap().ends_with(mark), "{}", plan.display());
            let value: serde_json::Value = serde_saphyr::from_str(&text).unwrap();
            let errors: Vec<String> = validator.iter_errors(&value).map(|error| error.to_string()).collect();
            assert!(errors.is_empty(), "{}: {errors:?}", plan.display());
        }
    }
}
