"""Long work: it can be interrupted, reports on its way, and leaves other threads running."""

import _thread
import threading

import pytest
import subcert

HARD = "primal:n=6,d=3"  # does not close within an hour


def test_an_interrupt_ends_it():
    timer = threading.Timer(1, _thread.interrupt_main)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        subcert.scheme(HARD).holder(budget=3600)
    timer.join()


def test_progress_is_told_and_may_end_it():
    seconds = []

    class Enough(Exception):
        pass

    def progress(passed):
        seconds.append(passed)
        if len(seconds) == 5:
            raise Enough

    with pytest.raises(Enough):
        subcert.scheme(HARD).holder(budget=3600, progress=progress)
    assert len(seconds) == 5 and seconds == sorted(seconds)


def test_other_threads_run_meanwhile():
    counted = 0
    worker = threading.Thread(target=lambda: subcert.scheme(HARD).holder(budget=1))
    worker.start()
    while worker.is_alive():
        counted += 1
    worker.join()
    assert counted > 1000


def test_several_threads_at_once():
    found = {}

    def work(n):
        found[n] = subcert.scheme(f"primal:n={n}").holder()

    threads = [threading.Thread(target=work, args=(n,)) for n in range(2, 8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(found[n].exact for n in range(2, 8))
