package cga.grading.course

import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.writeText

/** The process that [KilledCourseTest] kills: grades all in FOLDER/in slowly, and notes in FOLDER/graded.log whom it has begun. */
fun main(args: Array<String>) {
    val folder = Path.of(args[0])
    val grader = FakeGrader { submission ->
        synchronized(folder) {
            folder.resolve("graded.log").writeText(
                "${submission.name}\n",
                Charsets.UTF_8,
                CREATE,
                APPEND,
            )
        }
        Thread.sleep(100)
    }
    val submissions = Submission.of(folder.resolve("in").listDirectoryEntries().sorted())
    FakeGrader.run(folder.resolve("out"), submissions, grader, resume = true)
}
