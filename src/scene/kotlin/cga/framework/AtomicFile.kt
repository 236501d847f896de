package cga.framework

import java.io.IOException
import java.nio.file.AtomicMoveNotSupportedException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.util.UUID

/** Writes files whole or not at all: to a temporary name beside the target, then renamed. */
public object AtomicFile {
    /** Calls [fill] with the temporary path and moves the result to [target]. Throws [InputError] when that is not possible. */
    public fun write(
        target: Path,
        fill: (Path) -> Unit,
    ) {
        checkWritable(target)
        val temporary = temporaryFor(target)
        try {
            fill(temporary)
            move(temporary, target)
        } catch (e: IOException) {
            throw InputError("cannot write $target (${e.reason()}): is the disk full or the folder read-only?", e)
        } finally {
            temporary.toFile().delete()
        }
    }

    /** Throws [InputError] when [target] can surely not be written, before time is spent on making its content. */
    public fun checkWritable(target: Path) {
        val folder = target.toAbsolutePath().parent
        when {
            "$target".isEmpty() -> throw InputError("the name of the file to write is empty: name one.")
            Files.isDirectory(target) -> throw InputError("cannot write $target: it is a folder. Name a file in it.")
            // Renaming would put a plain file in the place of a device or a pipe.
            Files.exists(target) && !Files.isRegularFile(target) ->
                throw InputError("cannot write $target: it is not a regular file. Name another.")
            folder == null || !Files.isDirectory(folder) ->
                throw InputError("cannot write $target: the folder $folder does not exist. Create it, or name another.")
            !Files.isWritable(folder) -> throw InputError("cannot write $target: the folder $folder is read-only. Name another.")
        }
    }

    /** Several may write the same file at a time, in one process and in containers whose process numbers are alike. */
    private fun temporaryFor(target: Path): Path = target.resolveSibling(".${target.fileName}.${UUID.randomUUID()}.part")

    private fun move(
        from: Path,
        to: Path,
    ) {
        try {
            Files.move(from, to, ATOMIC_MOVE, REPLACE_EXISTING)
        } catch (_: AtomicMoveNotSupportedException) {
            Files.move(from, to, REPLACE_EXISTING)
        }
    }
}
