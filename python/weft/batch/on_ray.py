"""Runs of a sweep on a Ray cluster."""

import collections
import importlib
from collections.abc import Generator
from typing import Any

from ..errors import Error, InputError
from .plan import Run
from .processes import MOST_LOSSES, Result
from .run import do, lost


def results(
    runs: list[Run], address: str, cpus: float, gpus: float, models: str | None, adapter: str
) -> Generator[Result, None, None]:
    """Each run once, in the order in which they end: a task with so many processors and GPUs.

    Ray does the run of a worker that dies again. Errors: InputError, there is no cluster at `address`, or none of its
    machines has so many. Error, ray is not installed.
    """
    try:
        ray: Any = importlib.import_module("ray")
    except ImportError:
        raise Error("A sweep on a cluster needs ray: pip install weft[ray].") from None
    try:
        ray.init(address=None if address == "local" else address, log_to_driver=False, logging_level="ERROR")
    except (ConnectionError, ValueError, RuntimeError) as error:
        raise InputError(f"There is no Ray cluster at {address}: {error}") from None
    try:
        _check_resources(ray, cpus, gpus)
        task = ray.remote(num_cpus=cpus, num_gpus=gpus, max_retries=MOST_LOSSES - 1)(do)
        waiting = collections.deque(runs)
        tasks: dict[Any, Run] = {}
        while waiting or tasks:
            # Twice as many as there is room for: so that none waits for the next, and a long list stays here.
            room = 2 * max(1, round(ray.cluster_resources().get("CPU", 1) / cpus if cpus else 1))
            while waiting and len(tasks) < room:
                run = waiting.popleft()
                tasks[task.remote(run, models, adapter)] = run
            for ended in ray.wait(list(tasks), num_returns=1)[0]:
                run = tasks.pop(ended)
                try:
                    row, shape = ray.get(ended)
                except ray.exceptions.RayTaskError as error:  # nothing that a run can do: weft is not there
                    raise Error(f"A worker of the cluster cannot do runs: {error.cause}.") from None
                except ray.exceptions.RayError:
                    row, shape = lost(run, MOST_LOSSES), None
                yield run, row, shape
    finally:
        ray.shutdown()


def _check_resources(ray: Any, cpus: float, gpus: float) -> None:
    resources = [node["Resources"] for node in ray.nodes() if node["Alive"]]
    machines = sorted((machine.get("CPU", 0), machine.get("GPU", 0)) for machine in resources)
    if not any(there >= cpus and cards >= gpus for there, cards in machines):
        most = ", ".join(f"{there:g} and {cards:g}" for there, cards in machines)
        raise InputError(
            f"A run takes {cpus:g} processors and {gpus:g} GPUs; the machines of the cluster have {most} of them."
        )
