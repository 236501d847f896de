package cga.grading.prepared

import cga.framework.InputError
import cga.grading.capture.BadCapture
import cga.grading.capture.LimitedInput
import cga.grading.findings.Likeness
import cga.grading.sandbox.SafeFiles
import java.io.ByteArrayOutputStream
import java.io.DataOutputStream
import java.nio.file.Path
import kotlin.io.path.writeBytes

/** The folder that the job that reads a submission has filled, and its manifest, every field of which has been checked. */
internal class PreparedTree private constructor(
    val folder: Path,
    val manifest: Prepared,
) {
    /** What the submission is started in. */
    val start: Path get() = folder.resolve(START)

    /** The folders of all [files]. */
    val sourceFolders: List<Path> get() = listOf(SOURCES, REFERENCE).map(folder::resolve)

    /** Where each source lies, or what takes its place where it is one of [replaced], if anything does. */
    fun files(replaced: Set<PreparedSource> = emptySet()): Map<PreparedSource, Path> {
        val (own, reference) = sourceFolders
        return manifest.sources.filter { it !in replaced || it.hasReference }.associateWith {
            (if (it in replaced) reference else own).resolve(it.file)
        }
    }

    companion object {
        const val SOURCES = "sources"
        const val REFERENCE = "reference"
        const val START = "start"
        private const val MANIFEST = "manifest"

        private const val MARK = 0x43474152
        private const val MOST_BYTES = 16L shl 20
        const val MOST_SOURCES = 2000
        private const val MOST_LIBRARIES = 100
        const val MOST_NOTES = 200

        /** Characters, each of at most three bytes. */
        const val LONGEST = 1000
        private const val LONGEST_BYTES = 3 * LONGEST

        /** Writes [prepared] beside the tree in [folder]; texts that are too long are cut. */
        fun write(prepared: Prepared, folder: Path) {
            val bytes = ByteArrayOutputStream()
            DataOutputStream(bytes).run {
                fun text(text: String) = text.take(LONGEST).toByteArray().let {
                    writeInt(it.size)
                    write(it)
                }

                fun optional(text: String?) {
                    writeBoolean(text != null)
                    text?.let(::text)
                }

                fun <T> list(elements: List<T>, element: (T) -> Unit) {
                    writeInt(elements.size)
                    elements.forEach(element)
                }
                writeInt(MARK)
                text(prepared.kind.name)
                text(prepared.edition.id)
                optional(prepared.mainClass)
                optional(prepared.kotlin)
                list(prepared.libraries.take(MOST_LIBRARIES)) { library ->
                    text(library.group)
                    text(library.name)
                    optional(library.version)
                }
                list(prepared.sources) { source ->
                    text(source.name)
                    text(source.file)
                    writeBoolean(source.isOurs)
                    writeBoolean(source.hasReference)
                }
                list(prepared.notes.take(MOST_NOTES), ::text)
                optional(prepared.sourcesKey)
            }
            folder.resolve(MANIFEST).writeBytes(bytes.toByteArray())
        }

        /** The tree that a job has left in [folder]. Throws [InputError] where anything in its manifest is not as it has to be. */
        fun read(folder: Path): PreparedTree {
            val bytes = SafeFiles.read(folder, MANIFEST, MOST_BYTES)
            val manifest = try {
                LimitedInput(bytes.inputStream(), MOST_BYTES).let { input -> manifest(input).also { input.expectEnd() } }
            } catch (e: BadCapture) {
                throw InputError("the manifest of a submission is not as it has to be: ${e.message}.", e)
            }
            for (source in manifest.sources) {
                require(SafeFiles.exists(folder, "$SOURCES/${source.file}"), "source ${source.file}")
                require(!source.hasReference || SafeFiles.exists(folder, "$REFERENCE/${source.file}"), "reference ${source.file}")
            }
            require(listOf(SOURCES, REFERENCE, START).all { SafeFiles.isFolder(folder.resolve(it)) }, "folder")
            return PreparedTree(folder, manifest)
        }

        private fun manifest(input: LimitedInput): Prepared {
            fun text(what: String, isSound: (String) -> Boolean) =
                input.text(what, LONGEST_BYTES).also { if (!isSound(it)) throw BadCapture("it has a $what that is none") }

            fun optional(what: String, isSound: (String) -> Boolean) = if (input.boolean()) text(what, isSound) else null
            if (input.int() != MARK) throw BadCapture("it does not begin as one")
            val kind = text("kind") { name -> Kind.entries.any { it.name == name } }
            val edition = text("edition") { id -> Edition.ALL.any { it.id == id } }
            return Prepared(
                Kind.valueOf(kind),
                Edition.named(edition),
                optional("main class", ::isClass),
                optional("version of Kotlin", ::isCoordinate),
                input.list("libraries", MOST_LIBRARIES) {
                    NamedLibrary(text("group", ::isCoordinate), text("library", ::isCoordinate), optional("version", ::isCoordinate))
                },
                sources(input, ::text),
                input.list("notes", MOST_NOTES) { text("note") { true } },
                optional("key of the sources", Likeness::isKey),
            )
        }

        private fun sources(input: LimitedInput, text: (String, (String) -> Boolean) -> String): List<PreparedSource> {
            var index = 0
            return input.list("sources", MOST_SOURCES) {
                val name = text("name of a source") { true }
                PreparedSource(name, text("source") { PreparedSource.isPlace(index++, it) }, input.boolean(), input.boolean())
            }
        }

        private fun require(isSound: Boolean, what: String) {
            if (!isSound) throw InputError("the manifest of a submission names a $what that is not there.")
        }

        /** Whether [text] is part of the coordinates of a library: they become paths and addresses. */
        fun isCoordinate(text: String): Boolean =
            text.length in 1..LONGEST_COORDINATE && text.all { it in 'A'..'Z' || it in 'a'..'z' || it in '0'..'9' || it in "._-" } &&
                !text.startsWith('.') && !text.endsWith('.') && ".." !in text

        private const val LONGEST_COORDINATE = 100

        /** Whether [text] is the name of a class: it becomes an argument of a JVM. */
        fun isClass(text: String): Boolean =
            text.length in 1..LONGEST &&
                text.split('.').all { part ->
                    part.isNotEmpty() && part[0].isJavaIdentifierStart() &&
                        part.all { it.isJavaIdentifierPart() && !it.isISOControl() }
                }
    }
}
