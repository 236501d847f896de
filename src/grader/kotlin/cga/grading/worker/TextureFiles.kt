package cga.grading.worker

import cga.grading.capture.Capture
import cga.grading.capture.CapturedTexture
import org.lwjgl.stb.STBImage
import org.lwjgl.system.MemoryStack
import java.nio.file.Files
import java.nio.file.LinkOption
import java.nio.file.Path

/**
 * Which files textures were made of: an image that says by its name whether it is diffuse, specular or emissive, and has the same texels,
 * either way up. What a texture is used for does not tell what it was made for.
 */
internal object TextureFiles {
    /** Names of files below [folder] by the number of the texture in [capture]; textures that several such files look like are left out. */
    fun of(
        capture: Capture,
        folder: Path,
    ): Map<Int, String> {
        val found = HashMap<Int, MutableList<String>>()
        for (file in files(folder)) {
            val numbers = matching(capture.textures, file)
            for (number in numbers) found.getOrPut(number) { mutableListOf() } += "${file.fileName}"
        }
        return found.filterValues { it.size == 1 }.mapValues { it.value.single() }
    }

    /** Names of such files below [folder] that are none of [read]; none where nothing was read, and nothing can have been mixed up. */
    fun others(
        folder: Path,
        read: Collection<String>,
    ): Set<String> = if (read.isEmpty()) emptySet() else files(folder).map { "${it.fileName}" }.toSet() - read.toSet()

    private fun files(folder: Path): List<Path> =
        Files.walk(folder, DEPTH).use { all ->
            all
                .limit(MOST_FILES)
                .filter { ROLE.containsMatchIn("${it.fileName}") && Files.isRegularFile(it, LinkOption.NOFOLLOW_LINKS) }
                .filter { Files.size(it) < LARGEST }
                .limit(MOST_IMAGES)
                .toList()
        }

    private fun matching(
        textures: List<CapturedTexture>,
        file: Path,
    ): List<Int> =
        MemoryStack.stackPush().use { stack ->
            val width = stack.mallocInt(1)
            val height = stack.mallocInt(1)
            val channels = stack.mallocInt(1)
            if (!STBImage.stbi_info("$file", width, height, channels)) return emptyList()
            val alike = textures.indices.filter { textures[it].width == width[0] && textures[it].height == height[0] }
            if (alike.isEmpty()) return emptyList()
            val image = STBImage.stbi_load("$file", width, height, channels, RGBA) ?: return emptyList()
            try {
                val texels = ByteArray(image.remaining()).also { image.get(it) }
                val flipped = flipped(texels, RGBA * width[0])
                alike.filter { same(textures[it].levels[0], texels) || same(textures[it].levels[0], flipped) }
            } finally {
                image.rewind()
                STBImage.stbi_image_free(image)
            }
        }

    private fun flipped(
        texels: ByteArray,
        row: Int,
    ) = ByteArray(texels.size) { texels[texels.size - row * (it / row + 1) + it % row] }

    /** Whether the colours are the same; alpha may have been left out. */
    private fun same(
        a: ByteArray,
        b: ByteArray,
    ) = a.size == b.size && a.indices.all { it % RGBA == RGBA - 1 || a[it] == b[it] }

    private const val RGBA = 4
    private const val DEPTH = 8
    private const val MOST_FILES = 2000L
    private const val MOST_IMAGES = 64L
    private const val LARGEST = 8L shl 20
    private val ROLE = Regex("diff|spec|emit|emis|glow", RegexOption.IGNORE_CASE)
}
