package cga.grading.starter

import cga.framework.InputError
import cga.framework.reason
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.createDirectories
import kotlin.io.path.deleteRecursively
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.writeBytes

/** Writes the starter. */
public object StarterExport {
    /**
     * Makes [folder] the starter in [language]: whole or not at all. Throws [InputError] when it is there and not empty, when it is the working
     * directory, or when it cannot be written.
     */
    public fun write(folder: Path, language: StarterLanguage = StarterLanguage.ENGLISH) {
        val target = folder.toAbsolutePath().normalize()
        check(target)
        val files = StarterFiles(language).all()
        val temporary = target.resolveSibling(".${target.name}.${ProcessHandle.current().pid()}.part")
        try {
            for ((path, content) in files) {
                val file = temporary.resolve(path)
                file.parent.createDirectories()
                file.writeBytes(content)
            }
            for (script in listOf("gradlew", "cga")) temporary.resolve(script).toFile().setExecutable(true, false)
            Files.move(temporary, target, REPLACE_EXISTING)
        } catch (e: IOException) {
            throw InputError("cannot write $folder (${e.reason()}): is the disk full or the folder read-only?", e)
        } finally {
            remove(temporary)
        }
    }

    private fun check(target: Path) {
        val parent = target.parent
        when {
            parent == null || !parent.isDirectory() ->
                throw InputError("cannot write $target: the folder $parent does not exist. Create it, or name another.")
            target.exists() && !target.isDirectory() -> throw InputError("cannot write $target: it is a file. Name a new folder.")
            target.exists() && target.listDirectoryEntries().isNotEmpty() ->
                throw InputError("cannot write $target: the folder is not empty. Name a new one.")
            // It is replaced as a whole; whoever stands in it would stand in a folder that is gone.
            target == Path.of("").toAbsolutePath() -> throw InputError("cannot write $target: you are in it. Name a folder beside it.")
            !Files.isWritable(parent) -> throw InputError("cannot write $target: the folder $parent is read-only. Name another.")
        }
    }

    @OptIn(ExperimentalPathApi::class)
    private fun remove(folder: Path) {
        try {
            folder.deleteRecursively()
        } catch (_: IOException) {
            // The error that matters is on its way already.
        }
    }
}
