package cga.framework.image

import cga.framework.AtomicFile
import cga.framework.InputError
import org.lwjgl.PointerBuffer
import org.lwjgl.system.MemoryStack
import org.lwjgl.system.MemoryUtil
import org.lwjgl.util.tinyexr.EXRChannelInfo
import org.lwjgl.util.tinyexr.EXRHeader
import org.lwjgl.util.tinyexr.EXRImage
import org.lwjgl.util.tinyexr.TinyEXR.*
import java.nio.FloatBuffer
import java.nio.file.Path

/** Writes float pictures as OpenEXR: 32-bit RGBA, ZIP-compressed, no loss. */
public object ExrFile {
    // OpenEXR wants the channels in alphabetical order.
    private const val CHANNELS = "ABGR"

    /** Writes [image] to [target], whole or not at all. Throws [InputError] when that is not possible. */
    public fun write(
        image: FloatImage,
        target: Path,
    ): Unit =
        AtomicFile.write(target) { temporary ->
            val planes = CHANNELS.map { plane(image, "RGBA".indexOf(it)) }
            try {
                MemoryStack.stackPush().use { stack -> save(stack, image, planes, temporary) }
            } finally {
                planes.forEach(MemoryUtil::memFree)
            }
        }

    private fun plane(
        image: FloatImage,
        channel: Int,
    ): FloatBuffer {
        val plane = MemoryUtil.memAllocFloat(image.width * image.height)
        for (pixel in 0 until image.width * image.height) plane.put(pixel, image.rgba[4 * pixel + channel])
        return plane
    }

    private fun save(
        stack: MemoryStack,
        image: FloatImage,
        planes: List<FloatBuffer>,
        file: Path,
    ) {
        val pointers: PointerBuffer = stack.mallocPointer(planes.size)
        planes.forEachIndexed { i, plane -> pointers.put(i, plane) }
        val picture = EXRImage.calloc(stack)
        InitEXRImage(picture)
        picture
            .num_channels(planes.size)
            .images(pointers)
            .width(image.width)
            .height(image.height)
        val error = stack.callocPointer(1)
        if (SaveEXRImageToFile(picture, header(stack), file.toString(), error) != TINYEXR_SUCCESS) {
            throw InputError("cannot write $file as OpenEXR: ${message(error)}.")
        }
    }

    private fun header(stack: MemoryStack): EXRHeader {
        val channels = EXRChannelInfo.calloc(CHANNELS.length, stack)
        CHANNELS.forEachIndexed { i, name -> channels[i].name(stack.ASCII(name.toString())) }
        val floats = IntArray(CHANNELS.length) { TINYEXR_PIXELTYPE_FLOAT }
        val header = EXRHeader.calloc(stack)
        InitEXRHeader(header)
        return header
            .num_channels(CHANNELS.length)
            .channels(channels)
            .pixel_types(stack.ints(*floats))
            .requested_pixel_types(stack.ints(*floats))
            .compression_type(TINYEXR_COMPRESSIONTYPE_ZIP)
    }

    private fun message(error: PointerBuffer): String =
        if (error[0] == MemoryUtil.NULL) "no reason given" else MemoryUtil.memASCII(error[0])
}
