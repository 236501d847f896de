package cga.grading.course

import cga.framework.InputError
import cga.grading.report.GradedSubmission
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.copyTo
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/**
 * What became of results that were put together.
 *
 * @param missing names of submissions that a result folder is about and has no result of.
 * @param warnings what is incomplete, a sentence each.
 */
public class Merged(
    public val submissions: List<GradedSubmission>,
    public val missing: List<String>,
    public val warnings: List<String>,
)

/** Puts the result folders of shards together in one. The submissions are not needed, only their results. */
public class Merge(
    private val store: ResultStore,
    private val settings: CourseSettings,
    private val listener: CourseListener,
) {
    private val pages = SubmissionReports(settings)
    private val placed = LinkedHashMap<String, StoredOutcome>()
    private val missing = LinkedHashMap<String, String>()
    private val warnings = mutableListOf<String>()

    /** Takes over all results of [parts]. Throws [InputError] where one of them is no result folder, or is this one. */
    public fun run(parts: List<Path>): Merged {
        val manifests = parts.distinctBy { it.toAbsolutePath().normalize() }.map { part ->
            if (Files.exists(part) &&
                Files.isSameFile(part, store.out)
            ) {
                throw InputError("--out $part is one of those to merge: name another.")
            }
            part to Manifest.read(part)
        }
        manifests.forEach { (part, manifest) -> manifest.entries.forEach { take(part, it) } }
        checkShards(manifests.map { it.second.shard })
        // What one folder lacks another may have.
        val lacking = missing.filterKeys { it !in placed }
        if (lacking.isNotEmpty()) {
            warnings +=
                "${lacking.size} without a result: ${lacking.values.joinToString()}; resume that shard and merge again."
        }
        val entries =
            placed.map { (folder, stored) -> Manifest.Entry(stored.name, folder) } + lacking.map { Manifest.Entry(it.value, it.key) }
        Manifest(Shard.WHOLE, entries).write(store.out)
        val submissions = placed.map { (folder, stored) ->
            GradedSubmission(stored.name, store.folder(folder), stored.outcome, settings.rubric, stored.seconds)
        }
        submissions.forEach {
            pages.writeOrComplain(it, listener)
            listener.finished(it, isNew = false)
        }
        return Merged(pages.withTwins(submissions, listener), lacking.values.toList(), warnings)
    }

    private fun take(part: Path, entry: Manifest.Entry) {
        val source = part.resolve(entry.folder)
        val stored =
            try {
                OutcomeFile.read(source)
            } catch (_: InputError) {
                missing[entry.folder] = entry.name
                return
            }
        val other = placed[entry.folder]
        if (other != null && other.checksum == stored.checksum) return
        val folder = if (other == null) entry.folder else "${entry.folder}-${stored.checksum.take(SUFFIX)}"
        if (other != null) warnings += "${entry.name} was graded twice, with different contents: both are shown."
        val staged = store.stage(folder)
        source
            .listDirectoryEntries()
            .filter {
                it.isRegularFile() && !it.name.startsWith(
                    ".",
                )
            }.forEach { it.copyTo(staged.resolve(it.name)) }
        store.place(staged)
        placed[folder] = stored
    }

    private fun checkShards(shards: List<Shard>) {
        for ((count, parts) in shards.groupBy { it.count }) {
            val absent = (1..count) - parts.map { it.index }.toSet()
            if (absent.isNotEmpty()) warnings += "of $count shards these are not here: ${absent.joinToString()}; merge again with them."
        }
    }

    private companion object {
        const val SUFFIX = 6
    }
}
