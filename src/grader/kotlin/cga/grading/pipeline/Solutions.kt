package cga.grading.pipeline

import cga.framework.AtomicFile
import cga.framework.Home
import cga.framework.InputError
import cga.grading.findings.Likeness
import cga.grading.findings.LikenessFile
import cga.grading.prepared.COURSE_PROJECT
import cga.grading.prepared.Kind
import cga.grading.sandbox.Scratch
import cga.grading.sandbox.Temporary
import cga.grading.starter.StarterFiles
import cga.grading.starter.StarterLanguage
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap
import kotlin.io.path.createDirectories
import kotlin.io.path.createParentDirectories
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/**
 * Our own solutions as something to compare with, each taken through the pipeline like a submission, once for this program.
 *
 * @param folder where what was found is kept.
 * @param program tells this program from others; null where that cannot be told, and nothing is kept.
 * @param likeness takes a project through the pipeline, in an empty folder. Throws [Stopped].
 */
internal class Solutions(
    private val folder: Path,
    private val program: String?,
    private val likeness: (Path, Path) -> Likeness,
) {
    private val known = ConcurrentHashMap<Kind, Likeness>()

    /** The one of [kind]; nothing is like it where it cannot be graded here. Safe to use from several threads. */
    fun of(kind: Kind): Likeness = known.computeIfAbsent(kind) { kept(it) ?: made(it) }

    private fun file(kind: Kind) = program?.let { folder.resolve("solution-${kind.name.lowercase()}-$it") }

    private fun kept(kind: Kind): Likeness? =
        try {
            file(kind)?.takeIf { it.exists() }?.let { Likeness(LikenessFile.keys(it.readText())) }
        } catch (_: InputError) {
            null
        }

    private fun made(kind: Kind): Likeness {
        val work = Temporary.folder("solution")
        return try {
            val project = if (kind == Kind.COURSE) Home.resolve(COURSE_PROJECT) else filledIn(work.resolve("starter"))
            likeness(project, work.resolve("work").createDirectories()).also { keep(kind, it) }
        } catch (_: Stopped) {
            Likeness()
        } catch (_: InputError) {
            Likeness()
        } finally {
            Scratch.delete(work)
        }
    }

    private fun keep(kind: Kind, likeness: Likeness) {
        val file = file(kind) ?: return
        folder.toFile().listFiles { old -> old.name.startsWith("solution-${kind.name.lowercase()}-") }.orEmpty().forEach { it.delete() }
        AtomicFile.write(file) { it.writeText(LikenessFile.text(likeness.keys)) }
    }

    private fun filledIn(folder: Path): Path {
        val files = StarterFiles(StarterLanguage.ENGLISH).solution()
        for ((name, bytes) in files) folder.resolve(name).createParentDirectories().writeBytes(bytes)
        return folder
    }
}
