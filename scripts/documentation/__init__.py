"""The parts of build_site.py: links of pages, their check, and the site's source."""
