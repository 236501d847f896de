package cga.grading.corpus

import kotlin.io.path.Path

/** Writes submissions of the corpus below the folder that the first argument names: those of the other arguments' names, or all. */
fun main(args: Array<String>) {
    val folder = Path(args.first())
    val chosen = if (args.size == 1) Corpus.all else args.drop(1).map(Corpus::byName)
    for (submission in chosen) Corpus.materialize(submission, folder.resolve(submission.name))
    println("${chosen.size} submissions in $folder")
}
