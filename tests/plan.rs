//! Plans: every case and every ready plan is read, every fault is reported where it stands.
//!
//! `tests/cases/plan/<case>.yaml` has its golden beside it: one line per level, room and opening. A missing golden is
//! written and fails, so that it gets looked at; `UPDATE_GOLDENS=1` renews all.
//! `tests/cases/plan/faults/<case>.yaml` says in comments which faults it has: `# expect: <message>` on the line where
//! the fault is reported, `# expect warning: <message>` for warnings; several are parted by ` | `. A hint follows
//! the message in brackets and may be left out. Files that cannot hold comments have a `.expect` file beside them.

#![allow(clippy::unwrap_used)] // a test that cannot read its case fails

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
