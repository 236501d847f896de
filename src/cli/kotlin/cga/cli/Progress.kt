package cga.cli

import com.github.ajalt.mordant.animation.progress.animateOnThread
import com.github.ajalt.mordant.animation.progress.execute
import com.github.ajalt.mordant.terminal.Terminal
import com.github.ajalt.mordant.widgets.progress.completed
import com.github.ajalt.mordant.widgets.progress.progressBar
import com.github.ajalt.mordant.widgets.progress.progressBarLayout
import com.github.ajalt.mordant.widgets.progress.text
import com.github.ajalt.mordant.widgets.progress.timeRemaining

/** What [transform] makes of each of these, one after the other, under a progress bar called [label] where this is a terminal. */
public fun <T, R> List<T>.mapWithProgress(
    terminal: Terminal,
    label: String,
    transform: (T) -> R,
): List<R> {
    if (isEmpty()) return emptyList()
    val progress =
        progressBarLayout {
            text(label)
            progressBar()
            completed()
            timeRemaining()
        }.animateOnThread(terminal, total = size.toLong())
    val drawing = progress.execute()
    try {
        val results = mapIndexed { i, it -> transform(it).also { progress.update { completed = i + 1L } } }
        // It ends when all is completed, its last state drawn.
        drawing.get()
        return results
    } finally {
        progress.stop()
    }
}
