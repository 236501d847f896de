package cga.reference

import cga.exercise.game.Step
import cga.testing.CgaProcess
import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource
import java.nio.file.Path
import java.util.stream.IntStream
import kotlin.io.path.createDirectory
import kotlin.math.abs

/**
 * Every step drawn by llvmpipe into a float target, against the reference. Errors are the largest of a pixel's three channels, in units
 * of 1/255, over all pixels in which both show the same triangle, silhouettes included.
 *
 * Mip levels are where OpenGL leaves a driver the most freedom, so the comparison is made twice: with the ideal levels, and with those
 * that the driver chose ([LlvmpipeMipmaps]), after which all that is left is the rounding of floats.
 */
class GlAgainstTruthRenderTest {
    @ParameterizedTest
    @EnumSource(Step::class)
    fun `both show the same triangle, but for pixels on an edge`(step: Step) {
        val truth = truth(step).picture
        val gl = GlShot.read(floatFilter, step)
        val differing = truth.surface.indices.filter { truth.surface[it] != gl.surface[it] }
        // OpenGL rounds corners to 1/256 of a pixel, and a centre nearer to an edge than that may fall on either side of it: a chance of
        // 1/128 for each edge that runs through the pixel, and few pixels have one.
        assertTrue(differing.size < 1e-3 * truth.surface.size) { "${differing.size} pixels show another triangle" }
        for (pixel in differing) {
            val around = neighbours(pixel).map { truth.surface[it] }
            assertTrue(gl.surface[pixel] in around) { "pixel ${place(pixel)} shows triangle ${gl.surface[pixel]}, around it are $around" }
        }
    }

    @ParameterizedTest
    @EnumSource(Step::class)
    fun `with the driver's mip levels and a float filter the errors are those of floats`(step: Step) {
        val errors = errors(step, floatFilter, truth(step).withMipmapsOfDriver)
        // The ground's texture coordinates go up to 64, where a float errs by 2⁻¹⁹ at every rounding: 2⁻¹¹ of a texel of 256. Four roundings
        // (a sum of three products, a quotient) across an edge from black to white: 4·2⁻¹¹·255.
        assertTrue(errors.max < 0.5 && errors.mean < 0.01) { describe(step, errors) }
    }

    @ParameterizedTest
    @EnumSource(Step::class)
    fun `with the driver's mip levels an 8-bit filter adds its rounding`(step: Step) {
        val errors = errors(step, standardFilter, truth(step).withMipmapsOfDriver)
        // Up to 0.75 for each of the three textures.
        assertTrue(errors.max < 0.5 + 3 * 0.75 && errors.mean < 0.5) { describe(step, errors) }
    }

    @ParameterizedTest
    @EnumSource(Step::class)
    fun `ideal mip levels differ where a texture is minified`(step: Step) {
        val errors = errors(step, floatFilter, truth(step).picture.rgb)
        // The driver's λ is up to 0.043 too small, and neighbouring levels of the grid differ by up to 100. Where triangles are as small as
        // pixels differences within a quad are no derivatives; a tenth of the range is provisional.
        assertTrue(errors.max < 25.5 && errors.p999 < 0.043 * 100 + 0.5 && errors.mean < 0.5) { describe(step, errors) }
    }

    private fun errors(
        step: Step,
        shots: Path,
        rgb: DoubleArray,
    ): Errors {
        val gl = GlShot.read(shots, step)
        val surface = truth(step).picture.surface
        val pixels = surface.indices.filter { surface[it] != ReferencePicture.NO_SURFACE && surface[it] == gl.surface[it] }
        val errors = pixels.map { pixel -> 255 * (0..2).maxOf { abs(rgb[3 * pixel + it] - gl.picture.rgba[4 * pixel + it]) } }
        return Errors(errors.sorted(), pixels[errors.indices.maxBy { errors[it] }])
    }

    private class Errors(
        sorted: List<Double>,
        val worst: Int,
    ) {
        val max = sorted.last()
        val p999 = sorted[(0.999 * sorted.size).toInt()]
        val mean = sorted.average()
    }

    /** The figures, and the terms of the worst pixel. */
    private fun describe(
        step: Step,
        errors: Errors,
    ): String {
        val (x, y) = errors.worst % GlShot.WIDTH to errors.worst / GlShot.WIDTH
        val point = truth(step).renderer.probe(x, y) ?: error("nothing is in ${place(errors.worst)}")
        return "max %.5f at %s, 99.9 %% %.5f, mean %.6f\n".format(errors.max, place(errors.worst), errors.p999, errors.mean) +
            "draw ${point.draw}, emission ${point.emission}, ambient ${point.ambient}\n" +
            point.lights.joinToString("\n") { "d ${it.distance}, cos α ${it.cosAlpha}, diffuse ${it.diffuse}, specular ${it.specular}" }
    }

    private class Truth(step: Step) {
        private val frame = GlShot.scene(step).scene.frame()
        val renderer = ReferenceRenderer(frame, GlShot.WIDTH, GlShot.HEIGHT)
        val picture = renderer.render()

        /** [picture]'s colours, but with the mip levels of the driver. */
        val withMipmapsOfDriver: DoubleArray by lazy {
            val triangles = Triangles(frame, GlShot.WIDTH, GlShot.HEIGHT)
            val rgb = DoubleArray(picture.rgb.size)
            IntStream.range(0, GlShot.HEIGHT).parallel().forEach { row ->
                val mipmaps = LlvmpipeMipmaps(frame, triangles)
                for (column in 0 until GlShot.WIDTH) {
                    val pixel = row * GlShot.WIDTH + column
                    if (picture.surface[pixel] == ReferencePicture.NO_SURFACE) continue
                    val color = mipmaps.shade(picture.surface[pixel], column, GlShot.HEIGHT - 1 - row).color
                    for (c in 0..2) rgb[3 * pixel + c] = color[c]
                }
            }
            rgb
        }
    }

    companion object {
        @TempDir
        @JvmStatic
        private lateinit var folder: Path
        private lateinit var floatFilter: Path
        private lateinit var standardFilter: Path
        private val truths = HashMap<Step, Truth>()

        @BeforeAll
        @JvmStatic
        fun `OpenGL draws`() {
            Offscreen.openOrSkip().close()
            floatFilter = shoot("no_aos_sampling,no_quad_lod")
            standardFilter = shoot("")
        }

        /** A process of its own: Mesa reads how to filter from the environment, once. */
        private fun shoot(filter: String): Path {
            val to = folder.resolve("filter-$filter").createDirectory()
            val process = CgaProcess.java("cga.reference.GlShotsKt", listOf("$to"), folder, env = mapOf("GALLIVM_PERF" to filter))
            assertEquals(0, process.exitCode, "$process")
            return to
        }

        private fun truth(step: Step) = truths.getOrPut(step) { Truth(step) }

        private fun place(pixel: Int) = "(${pixel % GlShot.WIDTH}, ${pixel / GlShot.WIDTH})"

        private fun neighbours(pixel: Int): List<Int> =
            (-1..1).flatMap { j ->
                (-1..1).map { i ->
                    val x = (pixel % GlShot.WIDTH + i).coerceIn(0, GlShot.WIDTH - 1)
                    val y = (pixel / GlShot.WIDTH + j).coerceIn(0, GlShot.HEIGHT - 1)
                    y * GlShot.WIDTH + x
                }
            }
    }
}
