"""Bakes in Blender, without a window: `import_command` and `export_command`. `extension` is what Blender installs for its window."""
