"""To which room and which part of a level each node of a document belongs."""

# The sub-collections of rooms; those of doors and windows are the level's, because a door belongs to two rooms.
PARTS = ("shell", "ceiling", "doors and windows", "furniture", "lights")


def shown_nodes(document: dict) -> list[int]:
    """The nodes of the document's scene, each once. Other nodes, such as coarser shapes, are in no scene."""
    nodes, scenes = document.get("nodes", []), document.get("scenes", [])
    waiting = list(scenes[document.get("scene", 0)].get("nodes", [])) if scenes else list(range(len(nodes)))
    shown = dict.fromkeys(waiting)
    for one in waiting:  # grows as it goes
        for child in nodes[one].get("children", []):
            if child not in shown:
                shown[child] = None
                waiting.append(child)
    return sorted(shown)


def sort_nodes(nodes: list[dict]) -> list[tuple[str | None, str]]:
    """For each node the id of its room, None outside of rooms, and the part: one of PARTS, "level" or "room"."""
    parents = {child: number for number, node in enumerate(nodes) for child in node.get("children", [])}
    sorted_nodes: list = [None] * len(nodes)
    for number in range(len(nodes)):
        chain = [number]  # up to an ancestor that is sorted; each node is visited once
        while chain[-1] in parents and sorted_nodes[parents[chain[-1]]] is None and len(chain) <= len(nodes):
            chain.append(parents[chain[-1]])
        for one in reversed(chain):
            above = sorted_nodes[parents[one]] if one in parents else None
            sorted_nodes[one] = sorted_nodes[one] or _sort(nodes[one].get("extras") or {}, above or (None, "level"))
    return sorted_nodes


def _sort(extras: dict, above: tuple[str | None, str]) -> tuple[str | None, str]:
    room, part = above
    kind = extras.get("kind")
    if kind == "room":
        return extras.get("room"), "room"
    if kind == "opening":
        return room, "doors and windows"
    if kind == "part" and part != "doors and windows":
        return room, "ceiling" if extras.get("part") == "ceiling" else "shell"
    if kind == "light":
        return room, "lights"
    # A node without extras in a room was added by hand: it belongs to the furniture.
    return room, "furniture" if kind == "furniture" or part in ("room", "shell", "ceiling") else part
