package cga.coach.host

import cga.coach.ui.UiColor

/** How far a task is. */
internal enum class TaskState(
    val color: Long,
) {
    DONE(UiColor.GOOD),
    OPEN(UiColor.FAINT),
    WRONG(UiColor.WARNING),
}

/**
 * What is found of one of the sheet's tasks in the program that plays.
 *
 * @param task its number; [title] what it asks for, in the window's language.
 * @param lines what is wrong, with file and line, and a hint; empty where nothing is to be said.
 */
internal class TaskFinding(
    val task: String,
    val title: String,
    val state: TaskState,
    val lines: List<String>,
)

/** Looks at a program and says what it finds. The window asks it when the program or its numbers have changed, outside of its own thread. */
internal fun interface TaskReader {
    /** What is found, in the order of the sheet; empty where nothing can be told. */
    fun read(): List<TaskFinding>

    companion object {
        /** Says nothing, until there is something that reads programs. */
        val NONE: TaskReader = TaskReader { emptyList() }
    }
}
