"""One file a subject; each lists its measures in MEASURES."""
