//! Every case and every built-in plan is read, and every fault is reported at its place.
//!
//! `tests/cases/plan/<case>.yaml` has its golden beside it: one line per level, room and opening. A missing golden
//! fails; `UPDATE_GOLDENS=1` writes all that are missing or differ, and fails, so that somebody looks at them.
//! `tests/cases/plan/faults/<case>.yaml` names its faults in comments: `# expect: <message>` on the line of the fault, `#
//! expect warning: <message>` for warnings; several are separated by ` | `. A hint follows the message in brackets and
//! may be left out. Files that cannot hold comments have a `.expect` file beside them.

#![allow(clippy::unwrap_used)] // a test that cannot read its case fails

mod golden;

mod plan {
    mod damaged;
    mod faults;
    mod good;
    mod import;
    mod limits;
    mod properties;
    mod reading;
    mod schema;
    mod support;
    mod unread;
    mod writing;
}
