package cga.grading.findings

import cga.framework.AtomicFile
import cga.framework.InputError
import cga.imaging.JsonNode
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import kotlin.io.path.writeText

/**
 * [Findings] as `findings.json` in a folder, with the pictures that they name beside it.
 *
 * What is read may come out of a sandbox in which a submission ran: its size is limited, its numbers are finite, its picture names are plain
 * names of plain files, its checks and mistakes are known ones, and nothing else is in it.
 */
public object FindingsFile {
    /** Name of the file. */
    public const val NAME: String = "findings.json"

    internal const val MAX_BYTES = 8L shl 20
    internal const val MAX_PICTURE_BYTES = 16L shl 20

    /**
     * Writes [findings] into [folder], whole or not at all. A check's error that is no finite number is written as not measured. Throws
     * [IllegalArgumentException] where anything else is beyond what [read] takes, [InputError] where the file cannot be written.
     */
    public fun write(findings: Findings, folder: Path) {
        val text = findingsJson(findings)
        require(text.length <= MAX_BYTES) { "findings of ${text.length} characters are more than $MAX_BYTES" }
        AtomicFile.write(folder.resolve(NAME)) { it.writeText(text) }
    }

    /** The findings in [folder]. Throws [InputError] naming the file, the place in it and what is wrong. */
    public fun read(folder: Path): Findings {
        val file = folder.resolve(NAME)
        checkPlain(file, MAX_BYTES)
        return FindingsReader.findings(JsonNode.read(file, "findings")).also { findings ->
            for (picture in findings.pictures) for (name in listOfNotNull(picture.measured, picture.expected)) checkPicture(folder, name)
        }
    }

    private fun checkPicture(folder: Path, name: String) = checkPlain(folder.resolve(name), MAX_PICTURE_BYTES)

    /** Neither a link out of the folder nor a pipe that never ends. */
    private fun checkPlain(file: Path, limit: Long) {
        if (!Files.isRegularFile(
                file,
                NOFOLLOW_LINKS,
            )
        ) {
            throw InputError("$file is missing or not a plain file: grade the submission again.")
        }
        val size = Files.size(file)
        if (size > limit) throw InputError("$file is $size bytes long; at most $limit are read: grade the submission again.")
    }
}
