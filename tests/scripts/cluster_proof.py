"""Bakes on a Ray cluster of three nodes into a real S3 endpoint that fails one request in twenty; loses a node on the way.

    python tests/scripts/cluster_proof.py PLANS WHOLE UNITS

WHOLE is the same plans baked by one process with --textures none. Prints what happened as JSON; needs requirements-cluster.txt
and moto[server]. The program is that of ROOMWRIGHT_PROGRAM.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import json
import os
import random
import re
import sys
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))

FAILING_SHARE = 0.05
BUCKET = "city"


class FailingStore:
    """The application of moto's server; a share of its answers are errors."""

    def __init__(self, application):
        self.application, self.random, self.failed, self.answered, self.is_failing = application, random.Random(7), 0, 0, False
        self.lock = threading.Lock()

    def __call__(self, environment, start):
        with self.lock:
            self.answered += 1
            fails = self.is_failing and self.random.random() < FAILING_SHARE
            self.failed += fails
        if fails:
            # What was sent is read, or the connection could not be used again.
            environment["wsgi.input"].read(int(environment.get("CONTENT_LENGTH") or 0))
            start("503 Slow Down", [("Content-Length", "0")])
            return [b""]
        return self.application(environment, start)


def serve() -> tuple[FailingStore, str]:
    from moto.server import DomainDispatcherApplication, create_backend_app
    from werkzeug.serving import make_server
    store = FailingStore(DomainDispatcherApplication(create_backend_app))
    server = make_server("127.0.0.1", 0, store, threaded=True)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return store, f"http://127.0.0.1:{server.server_port}"


def start_nodes():
    import ray
    from ray.cluster_utils import Cluster
    # The head only coordinates.
    cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 0})
    nodes = [cluster.add_node(num_cpus=1) for _ in range(3)]
    ray.init(address=cluster.address, log_to_driver=False,
             runtime_env={"py_modules": [str(Path(__file__).resolve().parents[2] / "scripts" / "distributed")]})
    return cluster, nodes


def lose_a_node(cluster, node, system, after: int, events: list[str]) -> None:
    """Takes a node away without notice, once some units are done."""
    records = f"{BUCKET}/run/.cluster/records"
    while True:
        with contextlib.suppress(Exception):
            system.invalidate_cache()
            if len(system.ls(records)) >= after:
                break
        time.sleep(0.2)
    cluster.remove_node(node, allow_graceful=False)
    events.append(f"node lost after {len(system.ls(records))} units")


def run_driver(arguments: list[str]) -> tuple[int, str, float]:
    import cluster
    started, output = time.monotonic(), io.StringIO()
    with contextlib.redirect_stdout(output):
        code = cluster.main(arguments)
    return code, output.getvalue(), time.monotonic() - started


def differing(system, whole: Path) -> list[str]:
    """The files that are not those of one process."""
    expected = {path.relative_to(whole).as_posix(): path.read_bytes() for path in whole.rglob("*") if path.is_file()}
    expected = {name: content for name, content in expected.items() if not name.startswith(".")}
    system.invalidate_cache()
    prefix = f"{BUCKET}/run/"
    found = {path.removeprefix(prefix) for path in system.find(prefix)}
    found = {name for name in found if not name.startswith(".")}
    both = found & expected.keys()
    hashes = lambda content: hashlib.sha256(content).digest()  # noqa: E731
    return sorted(found ^ expected.keys()) + [
        name for name in sorted(both) if hashes(system.cat_file(prefix + name)) != hashes(expected[name])]


def main(plans: str, whole: str, units: str) -> int:
    store, url = serve()
    os.environ.update(AWS_ENDPOINT_URL=url, AWS_ACCESS_KEY_ID="test", AWS_SECRET_ACCESS_KEY="test",
                      AWS_DEFAULT_REGION="us-east-1", RAY_AUTH_MODE="disabled")
    import s3fs
    system = s3fs.S3FileSystem(use_listings_cache=False)
    system.mkdir(BUCKET)
    nodes_of_ray, nodes = start_nodes()
    events: list[str] = []
    loser = threading.Thread(target=lose_a_node, args=(nodes_of_ray, nodes[0], system, 2, events), daemon=True)
    loser.start()
    store.is_failing = True
    command = ["bake", plans, "--to", f"s3://{BUCKET}/run", "--ray", "--units", units, "--", "--textures", "none"]
    code, text, seconds = run_driver(command)
    loser.join(60)
    again_code, again_text, again_seconds = run_driver(command)
    answered, failed = store.answered, store.failed
    store.is_failing = False
    wrong = differing(system, Path(whole))
    kept_all = bool(re.search(rf"0 units baked, {units} kept", again_text))
    print(json.dumps({"first": [code, round(seconds, 1), text], "second": [again_code, round(again_seconds, 1), again_text],
                      "events": events, "requests": answered, "failed_requests": failed, "differing_files": wrong}, indent=1))
    return 0 if (code, again_code, wrong) == (0, 0, []) and kept_all and events else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
