package cga.framework.image

import cga.framework.AtomicFile
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.IIOImage
import javax.imageio.ImageIO
import javax.imageio.ImageWriteParam
import javax.imageio.stream.FileImageOutputStream

/** Writes pictures as 8-bit RGB PNG; alpha is dropped, since a framebuffer's picture is opaque. */
public object PngFile {
    // The standard setting (0.5) takes twice as long as 0.9 (zlib level 1) for files a tenth smaller.
    private const val QUALITY = 0.9f

    /** Writes [image] to [target], whole or not at all. Throws [cga.framework.InputError] when that is not possible. */
    public fun write(
        image: ImageData,
        target: Path,
    ): Unit = AtomicFile.write(target) { temporary -> encode(bgr(image), temporary) }

    private fun encode(
        picture: BufferedImage,
        file: Path,
    ) {
        val writer = ImageIO.getImageWritersByFormatName("png").next()
        try {
            FileImageOutputStream(file.toFile()).use { stream ->
                writer.output = stream
                val settings = writer.defaultWriteParam
                settings.compressionMode = ImageWriteParam.MODE_EXPLICIT
                settings.compressionQuality = QUALITY
                writer.write(null, IIOImage(picture, null, null), settings)
            }
        } finally {
            writer.dispose()
        }
    }

    private fun bgr(image: ImageData): BufferedImage {
        val picture = BufferedImage(image.width, image.height, BufferedImage.TYPE_3BYTE_BGR)
        val target = (picture.raster.dataBuffer as java.awt.image.DataBufferByte).data
        val source = image.rgba
        for (pixel in 0 until image.width * image.height) {
            target[3 * pixel] = source[4 * pixel + 2]
            target[3 * pixel + 1] = source[4 * pixel + 1]
            target[3 * pixel + 2] = source[4 * pixel]
        }
        return picture
    }
}
