package cga.grading.submission

import cga.framework.InputError
import cga.grading.prepared.Edition
import cga.grading.prepared.Kind
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.name

/** Recognises submissions. Reads only; runs nothing of theirs. */
internal object SubmissionReader {
    /** At the root of a starter, with its version in the first line. */
    const val STARTER_MARKER: String = ".cga-starter"

    /**
     * The submission in the folder or archive [given]; an archive is unpacked to [unpackTo], which must not exist yet.
     *
     * @param edition the sheet's edition, null to detect it.
     *
     * Throws [NotASubmission] when it is none, and other [InputError]s when it cannot be read.
     */
    fun read(given: Path, unpackTo: Path, edition: Edition? = null): Submission {
        val notes = mutableListOf<String>()
        val root = when {
            given.isDirectory() -> given.toRealPath()
            given.isRegularFile() -> unpack(given, unpackTo, notes)
            else -> throw InputError("$given does not exist: name the folder or the archive of a submission.")
        }
        return try {
            recognise(FileTree(root), edition, notes)
        } catch (e: NotASubmission) {
            throw NotASubmission("$given is not a submission: ${e.message}" + notes.joinToString("") { " $it" })
        }
    }

    private fun unpack(file: Path, folder: Path, notes: MutableList<String>): Path {
        val archive =
            Archive.of(file) ?: throw NotASubmission("$file is neither a folder nor an archive: pack the project as zip, tar or tar.gz.")
        notes += archive.unpack(file, folder)
        // Learning platforms pack what was packed already.
        val inner = FileTree(folder).files.filterNot { it.name.startsWith(".") }.singleOrNull()
        val innerArchive = inner?.let(Archive::of) ?: return folder.toRealPath()
        val unpacked = folder.resolve("unpacked")
        notes += innerArchive.unpack(inner, unpacked)
        return unpacked.toRealPath()
    }

    private fun recognise(tree: FileTree, edition: Edition?, notes: MutableList<String>): Submission {
        val marker = tree.files.filter { it.name == STARTER_MARKER }.minByOrNull { it.nameCount }
        val finder = ProjectFinder(tree)
        val sources = finder.sources()
        notes += finder.notes
        val project = sources.first { it.packageName.startsWith("cga.") }.project
        val detected = edition?.let { DetectedEdition(it, listOf("asked for")) } ?: DetectedEdition.of(sources)
        val buildFiles = buildFiles(tree, project)
        return Submission(
            tree = tree,
            kind = if (marker == null) Kind.COURSE else Kind.STARTER,
            sources = sources,
            workingDirectory = AssetsFinder.find(tree, project) ?: project.also { notes += "There is no folder assets." },
            mainClass = mainClass(sources, notes),
            kotlin = Versions.kotlin(buildFiles),
            edition = detected,
            notes = notes,
            libraries = LibraryFinder.find(Versions.withoutComments(buildFiles).values),
        )
    }

    private fun mainClass(sources: List<SourceFile>, notes: MutableList<String>): String? {
        val starting = sources.filter { it.mainClass != null }.sortedBy { "Game(" !in it.text }
        if (starting.isEmpty()) notes += "There is no main function."
        if (starting.count { "Game(" in it.text } >
            1
        ) {
            notes += "There are several main functions; the one in ${starting.first().name} is started."
        }
        return starting.firstOrNull()?.mainClass
    }

    /** Build files of the project and of the folders around it, the nearest first. */
    private fun buildFiles(tree: FileTree, project: Path): Map<Path, String> =
        tree.files
            .filter { it.name in Versions.FILES && project.startsWith(home(it)) }
            .sortedWith(compareBy({ -home(it).nameCount }, { it.name == "kotlinc.xml" }, { it.name }))
            .mapNotNull { file -> tree.text(file)?.let { file to it } }
            .toMap()

    /** The folder of the project that [buildFile] is about. */
    private fun home(buildFile: Path): Path = buildFile.parent.let {
        if (it.name in setOf("gradle", ".idea") &&
            Files.exists(it)
        ) {
            it.parent
        } else {
            it
        }
    }
}
