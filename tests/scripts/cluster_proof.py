"""Bakes on a Ray cluster of three nodes into a real S3 endpoint; loses a node and a worker process on the way.

The endpoint fails one request in twenty and alters a byte of one level in twenty that it is sent.

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
import signal
import sys
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))

FAILING_SHARE = 0.05
DAMAGED_SHARE = 0.05
BUCKET = "city"
# The name of a worker of Ray that does a unit.
WORKER = b"ray::run_unit"


class FailingStore:
    """The application of moto's server; a share of its answers are errors, and a share of the levels are stored altered."""

    def __init__(self, application):
        self.application, self.random, self.is_failing = application, random.Random(7), False
        self.answered, self.failed, self.damaged = 0, 0, 0
        self.lock = threading.Lock()

    def __call__(self, environment, start):
        is_level = environment["REQUEST_METHOD"] == "PUT" and environment["PATH_INFO"].endswith(".glb")
        with self.lock:
            self.answered += 1
            fails = self.is_failing and self.random.random() < FAILING_SHARE
            damages = self.is_failing and is_level and not fails and self.random.random() < DAMAGED_SHARE
            self.failed += fails
            self.damaged += damages
        if fails:
            # What was sent is read, or the connection could not be used again.
            environment["wsgi.input"].read(int(environment.get("CONTENT_LENGTH") or 0))
            start("503 Slow Down", [("Content-Length", "0")])
            return [b""]
        if damages:
            content = bytearray(environment["wsgi.input"].read(int(environment["CONTENT_LENGTH"])))
            content[len(content) // 2] ^= 1
            environment["wsgi.input"] = io.BytesIO(content)
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
             runtime_env={"py_modules": [str(Path(__file__).resolve().parents[2] / "python" / "roomwright")]})
    return cluster, nodes


def wait_for_units(system, count: int) -> int:
    """Waits until so many units are done; how many are."""
    while True:
        # The store fails, and the folder is not there at first.
        with contextlib.suppress(Exception):
            system.invalidate_cache()
            if (done := len(system.ls(f"{BUCKET}/run/.cluster/records"))) >= count:
                return done
        time.sleep(0.1)


def busy_workers(endpoint: str) -> list[int]:
    """The workers of this cluster that are baking: it alone knows the endpoint."""
    found = []
    for process in filter(lambda path: path.name.isdigit(), Path("/proc").iterdir()):
        with contextlib.suppress(OSError):
            is_ours = (process / "cmdline").read_bytes().startswith(WORKER) and endpoint.encode() in (process / "environ").read_bytes()
            if is_ours and any(child.read_text().strip() for child in process.glob("task/*/children")):
                found.append(int(process.name))
    return found


def break_things(cluster, node, system, endpoint: str, events: list[str]) -> None:
    """Kills a worker in the middle of a unit, and later takes a node away without notice."""
    done = wait_for_units(system, 1)
    while not (workers := busy_workers(endpoint)):
        time.sleep(0.02)
    os.kill(workers[0], signal.SIGKILL)
    events.append(f"a worker killed after {done} units")
    done = wait_for_units(system, done + 1)
    cluster.remove_node(node, allow_graceful=False)
    events.append(f"a node lost after {done} units")


def run_driver(arguments: list[str]) -> tuple[int, str, float]:
    from roomwright import cluster
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
    breaker = threading.Thread(target=break_things, args=(nodes_of_ray, nodes[0], system, url, events), daemon=True)
    breaker.start()
    store.is_failing = True
    command = ["bake", plans, "--to", f"s3://{BUCKET}/run", "--ray", "--units", units, "--", "--textures", "none"]
    code, text, seconds = run_driver(command)
    breaker.join(60)
    again_code, again_text, again_seconds = run_driver(command)
    answered, failed, damaged = store.answered, store.failed, store.damaged
    store.is_failing = False
    wrong = differing(system, Path(whole))
    kept_all = bool(re.search(rf"0 units baked, {units} kept", again_text))
    print(json.dumps({"first": [code, round(seconds, 1), text], "second": [again_code, round(again_seconds, 1), again_text],
                      "events": events, "requests": answered, "failed_requests": failed, "damaged_levels": damaged,
                      "differing_files": wrong}, indent=1))
    return 0 if (code, again_code, wrong) == (0, 0, []) and kept_all and len(events) == 2 else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
