"""Bakes in Blender, without a window: `import_command` and `export_command`. Blender installs `extension` for its window."""
