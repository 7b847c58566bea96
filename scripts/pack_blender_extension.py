#!/usr/bin/env python3
"""Zips Blender's extension, which imports bakes and exports edited floors.

  python scripts/pack_blender_extension.py [--out roomwright-1.0.0.zip]
  blender --command extension install-file --repo user_default --enable roomwright-1.0.0.zip

or, in Blender's window, Edit > Preferences > Get Extensions > Install from Disk. The name's number is the version of
python/roomwright/blender/extension/blender_manifest.toml. The same sources give the same bytes. Needs Python alone. Exit 0:
written. 2: nothing is written.
"""

import argparse
import sys
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "python" / "roomwright" / "blender" / "extension"
MANIFEST = "blender_manifest.toml"
# The first time that a zip can hold: times of files differ between copies of the project.
TIME = (1980, 1, 1, 0, 0, 0)
# Readable by all, writable by the owner, in the place that Unix has in a zip.
PERMISSIONS = 0o100644 << 16
UNIX = 3


def content() -> dict[str, bytes]:
    """The files of the extension by their names in the zip, in the zip's order."""
    files = [PACKAGE / MANIFEST, *PACKAGE.glob("*.py"), *ROOT.glob("LICENSE-*")]
    return {file.name: file.read_bytes() for file in sorted(files, key=lambda file: file.name)}


def pack(path: Path) -> None:
    """Writes the zip. Its files are stored, because compressed bytes depend on the version of zlib."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_STORED) as archive:
        for name, data in content().items():
            entry = zipfile.ZipInfo(name, TIME)
            entry.create_system, entry.external_attr = UNIX, PERMISSIONS
            archive.writestr(entry, data)


def main(arguments: list[str] | None = None) -> int:
    manifest = tomllib.loads((PACKAGE / MANIFEST).read_text(encoding="utf-8"))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=Path(f"{manifest['id']}-{manifest['version']}.zip"),
                        metavar="FILE.zip", help="where to write (default: here, by its version)")
    options = parser.parse_args(arguments)
    try:
        options.out.parent.mkdir(parents=True, exist_ok=True)
        pack(options.out)
    except OSError as error:
        print(f"{options.out}: cannot be written: {error.strerror}", file=sys.stderr)
        return 2
    print(options.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
