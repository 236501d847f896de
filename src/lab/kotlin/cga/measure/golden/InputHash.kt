package cga.measure.golden

import cga.framework.Home
import cga.framework.InputError
import cga.imaging.golden.Checksum
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/** Hashes of the files that the scene is made of: one for each shader, and one for each model with its materials and textures. */
internal object InputHash {
    private val MODEL_FILES = setOf("obj", "mtl", "png")

    fun ofFiles(): Map<String, String> {
        val shaders = entries("shaders").filter { it.isRegularFile() }.associate { "shaders/${it.name}" to hash(listOf(it)) }
        val models =
            entries("assets").filter { it.isDirectory() }.associateWith { folder ->
                folder.listDirectoryEntries().filter { it.extension in MODEL_FILES }.sortedBy { it.name }
            }
        return shaders +
            models.filterValues { it.isNotEmpty() }.entries.associate { (folder, files) -> "assets/${folder.name}" to hash(files) }
    }

    private fun hash(files: List<Path>): String {
        val sum = Checksum()
        for (file in files) sum.add(file.name).add(Home.read(file, "input"))
        return sum.hex()
    }

    private fun entries(folder: String): List<Path> {
        val path = Home.resolve(folder)
        if (!Files.isDirectory(path)) throw InputError("the folder $path does not exist: start the program in the project's folder.")
        return path.listDirectoryEntries().filterNot(Files::isHidden).sortedBy { it.name }
    }
}
