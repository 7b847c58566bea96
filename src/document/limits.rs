//! Limits on the size and depth of inputs, in one place.

/// Bytes of the largest file that is read. A city of real floor plans in one file stays far below it; a
/// file beyond it is a mistake (a mesh, a log, an image) or an attack, and is refused before it is read.
pub const FILE_SIZE_LIMIT: u64 = 512 * 1024 * 1024;

/// Deepest nesting of lists and mappings. Formats here need about ten; `serde_json` refuses 128. Without optimisation a level
/// takes up to 22 kB of stack, of which threads have 2 MB.
pub(super) const DEPTH_LIMIT: usize = 48;

/// Values of a document after aliases are copied out, in YAML and where the faults of JSON are located. Above
/// it a file's first fault is reported alone. A value takes about 100 bytes.
pub(super) const VALUE_LIMIT: usize = 4_000_000;

/// Faults listed for one file: beyond, a file has the wrong format rather than so many mistakes.
pub(super) const FAULT_LIMIT: usize = 100;

/// Characters of a source line that are shown; machine-written JSON often has one line of megabytes.
pub(super) const EXCERPT_WIDTH: usize = 120;

/// Characters shown before the fault where the beginning of a long line is cut.
pub(super) const EXCERPT_LEAD: usize = 40;
