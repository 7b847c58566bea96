"""The parts of site.py: links of pages, their check, and the site's source."""
