//! The version of the program, with a hash of its sources.

/// Changes whenever the bytes that a level becomes may change although its inputs did not: the program's
/// version and a hash of its own sources and locked dependencies (see `build.rs`).
pub const PROGRAM: &str = concat!(env!("CARGO_PKG_VERSION"), "+", env!("ROOMWRIGHT_SOURCE_HASH"));

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_program_names_version_and_sources() {
        let (version, sources) = PROGRAM.split_once('+').unwrap();
        assert_eq!(version, env!("CARGO_PKG_VERSION"));
        assert!(sources.len() >= 12 && sources.bytes().all(|byte| byte.is_ascii_hexdigit()));
    }
}
