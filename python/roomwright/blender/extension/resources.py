"""Which files a floor may name.

The extension is installed alone. Therefore it has the rule of ../../resources.py in short; a test
gives both the same names.
"""

import os
import re
from pathlib import Path, PureWindowsPath
from urllib.parse import unquote

from .errors import BakeError

# The folders beside OUT/<building>/ that floors share.
SHARED_FOLDERS = ("shared-textures", "shared-geometry", "shared-models")
# How absolute URIs begin.
SCHEME = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:")


def locate(uri: object, floor: Path) -> Path:
    """The file of a URI: below the floor's folder or in the shared ones beside it, reached by no link that leads out.

    Raises BakeError for any other name. The file itself may be missing.
    """
    folder = Path(os.path.abspath(floor)).parent.resolve()
    roots = (folder, *(folder.parent / name for name in SHARED_FOLDERS))
    joined = Path(os.path.normpath(folder / unquote(uri, errors="surrogateescape"))) if _is_relative(uri) else folder
    # The file system is not asked about paths outside.
    real = joined.resolve() if joined != folder and _is_below(joined, roots) else None
    if real is None or not _is_below(real, roots):
        raise BakeError(f"{floor}: names the file {uri!r:.120}, which is not in the folder of the floor\n"
                        "  hint: keep the file beside the floor")
    if joined.exists() and not joined.is_file():
        raise BakeError(f"{floor}: names {uri!r:.120}, which is no regular file")
    return real


def _is_relative(uri: object) -> bool:
    if not isinstance(uri, str) or SCHEME.match(uri):
        return False
    path = unquote(uri, errors="surrogateescape")
    return bool(path) and not (path.startswith("/") or PureWindowsPath(path).anchor or "\\" in path or "\0" in path)


def _is_below(path: Path, roots: tuple) -> bool:
    return any(path.is_relative_to(root) for root in roots)
