//! The files of the page, inside the binary.

use include_dir::{Dir, include_dir};
use sha2::{Digest, Sha256};

static PAGE: Dir<'static> = include_dir!("$CARGO_MANIFEST_DIR/viewer");

/// The page itself.
const INDEX: &str = "index.html";

/// A file of the page and its type; none where the page has no such file.
pub(super) fn file(path: &str) -> Option<(&'static [u8], &'static str)> {
    let media_type = match path.rsplit_once('.')?.1 {
        "html" => "text/html; charset=utf-8",
        "js" | "mjs" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "json" => "application/json",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        _ => return None,
    };
    Some((PAGE.get_file(path)?.contents(), media_type))
}

/// The page itself.
pub(super) fn index() -> (&'static [u8], &'static str) {
    file(INDEX).expect("the page is in the binary")
}

/// The `Content-Security-Policy` of the page: nothing from elsewhere, and no script in it but its import map.
pub(super) fn policy() -> String {
    let text = core::str::from_utf8(index().0).unwrap_or_default();
    let hash = import_map(text).map(|map| format!(" 'sha256-{}'", base64(&Sha256::digest(map.as_bytes()))));
    format!(
        "default-src 'self'; script-src 'self'{}; style-src 'self'; img-src 'self' blob: data:; \
         connect-src 'self' blob: data:; worker-src 'self' blob:; object-src 'none'; base-uri 'none'; \
         form-action 'none'; frame-ancestors 'none'",
        hash.unwrap_or_default()
    )
}

/// The text of the import map, which has to stand in the page itself.
fn import_map(html: &str) -> Option<&str> {
    let (_, rest) = html.split_once("<script type=\"importmap\">")?;
    Some(rest.split_once("</script>")?.0)
}

fn base64(bytes: &[u8]) -> String {
    use base64::Engine;
    base64::engine::general_purpose::STANDARD.encode(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_import_map_is_allowed_by_its_hash() {
        assert!(policy().contains("script-src 'self' 'sha256-"), "{}", policy());
        assert_eq!(import_map("<script type=\"importmap\">{}</script>"), Some("{}"));
    }

    #[test]
    fn only_files_of_the_page_are_served() {
        assert!(file("index.html").is_some());
        for path in ["../Cargo.toml", "/etc/passwd", "README.md", "src", ""] {
            assert!(file(path).is_none(), "{path}");
        }
    }
}
