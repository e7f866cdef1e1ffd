"""Runs of a sweep on the processes of this machine."""

import collections
import contextlib
import multiprocessing
import multiprocessing.connection
import signal
from collections.abc import Generator
from multiprocessing.connection import Connection
from multiprocessing.context import SpawnProcess

from .plan import Run
from .run import Row, do, lost

MOST_LOSSES = 3  # of workers over one run: then the run is what ends them
Result = tuple[Run, Row, bytes | None]


def results(runs: list[Run], workers: int, models: str | None, adapter: str) -> Generator[Result, None, None]:
    """Each run once, in the order in which they end. A worker that dies is replaced, and its run done again."""
    waiting = collections.deque(runs)
    losses: collections.Counter[int] = collections.Counter()
    busy: dict[Connection, tuple[Worker, Run]] = {}
    idle: list[Worker] = []
    try:
        while waiting or busy:
            while waiting and len(busy) < workers:
                worker = idle.pop() if idle else Worker(models, adapter)
                run = waiting.popleft()
                busy[worker.pipe] = worker, run
                worker.begin(run)
            ended = multiprocessing.connection.wait(list(busy))
            for pipe in [pipe for pipe in busy if pipe in ended]:
                worker, run = busy.pop(pipe)
                try:
                    row, shape = worker.end()
                except (EOFError, OSError):
                    worker.stop()
                    losses[run.number] += 1
                    if losses[run.number] < MOST_LOSSES:
                        waiting.appendleft(run)
                    else:
                        yield run, lost(run, MOST_LOSSES), None
                    continue
                idle.append(worker)
                yield run, row, shape
    finally:
        for worker in [*idle, *(worker for worker, _ in busy.values())]:
            worker.stop()


class Worker:
    """A process that does one run after the other."""

    def __init__(self, models: str | None, adapter: str) -> None:
        context = multiprocessing.get_context("spawn")
        self.pipe, theirs = context.Pipe()
        self._process: SpawnProcess = context.Process(target=_work, args=(theirs, models, adapter), daemon=True)
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})  # the sweep hears it, and stops its workers
        try:
            self._process.start()
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)
        theirs.close()  # so that the pipe ends with the process

    def begin(self, run: Run) -> None:
        with contextlib.suppress(OSError):  # it has died: end() says so
            self.pipe.send(run)

    def end(self) -> tuple[Row, bytes | None]:
        row, shape = self.pipe.recv()
        return row, shape

    def stop(self) -> None:
        self._process.kill()
        self._process.join()
        self.pipe.close()


def _work(pipe: Connection, models: str | None, adapter: str) -> None:
    with contextlib.suppress(EOFError, BrokenPipeError):
        while True:
            pipe.send(do(pipe.recv(), models, adapter))
