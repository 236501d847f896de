package cga.grading.corpus

import java.util.concurrent.Executors
import java.util.concurrent.Future
import java.util.concurrent.atomic.AtomicInteger
import kotlin.system.exitProcess

/** Makes the captures that are still missing: of one submission for every mistake and of the correct ones first, then of all. */
fun main(args: Array<String>) {
    val some = if (args.isEmpty()) {
        (
            Guard.chosen() + Corpus.correct.sortedBy {
                it.name.hashCode()
            } + Corpus.all
        ).distinct()
    } else {
        args.map(Corpus::byName)
    }
    val runs = Executors.newFixedThreadPool(Guard.RUNS)
    val done = AtomicInteger()
    val failed = AtomicInteger()
    CorpusCaptures().use { captures ->
        val all: List<Future<*>> = some.map { submission ->
            runs.submit {
                try {
                    captures.of(submission)
                } catch (e: IllegalStateException) {
                    failed.incrementAndGet()
                    println("${submission.name}: ${e.message}")
                }
                if (done.incrementAndGet() % 10 == 0) println("${done.get()} of ${some.size}")
            }
        }
        all.forEach { it.get() }
    }
    runs.shutdown()
    println("${done.get() - failed.get()} captures, ${failed.get()} without")
    exitProcess(if (failed.get() > 0) 1 else 0)
}
