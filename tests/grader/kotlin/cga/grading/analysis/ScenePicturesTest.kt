package cga.grading.analysis

import cga.framework.image.ImageData
import cga.grading.findings.Check
import cga.grading.findings.Evidence
import cga.grading.replay.Replay
import cga.grading.sheet4.scene.SceneJudge
import cga.grading.study.CourseShaders
import cga.grading.study.SceneCapture
import cga.grading.study.ShaderStudy
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import java.nio.file.Path
import kotlin.math.abs

/** The pictures of a report: the submission's beside the reference's. */
@ExtendWith(Offscreen::class)
@Slow
class ScenePicturesTest {
    @TempDir
    lateinit var folder: Path

    private fun pictures(fragment: String): List<Evidence> {
        // Texture coordinates that are not those of the vertices.
        val vertex = CourseShaders.VERTEX.replace("uniform vec2 tcMultiplier;", "const vec2 tcMultiplier = vec2(4.0, 2.0);")
        val capture = SceneCapture.of(vertex, fragment)
        return Replay(capture).use { replay ->
            ShaderStudy.of(capture).use { study ->
                val observed = capture.frames.mapNotNull(study::observe)
                val expected =
                    ExpectedFrame(
                        capture,
                        study.materials,
                        Verdict.of(ShadingVerdict(study.checks, study.mistakes), SceneJudge.judge(observed, capture.events)),
                    )
                ScenePictures(capture, replay, study.materials, expected, observed, folder).take()
            }
        }
    }

    private fun read(name: String?): ImageData = ImageData.read("${folder.resolve(checkNotNull(name))}")

    /** The share of pixels with a channel that differs by more than 2 of 255: one for rounding, one for float against double. */
    private fun differing(evidence: Evidence): Double = differing(read(evidence.measured).rgba, read(evidence.expected).rgba)

    private fun differing(a: ByteArray, b: ByteArray): Double = (0 until a.size / 4).count { p ->
        (0..2).any { abs((a[4 * p + it].toInt() and 0xFF) - (b[4 * p + it].toInt() and 0xFF)) > 2 }
    } /
        (a.size / 4.0)

    private fun brightness(image: ImageData): Double =
        image.rgba.indices.filter { it % 4 != 3 }.sumOf { image.rgba[it].toInt() and 0xFF } / (image.rgba.size * 0.75)

    @Test
    fun `a correct submission looks as it should, and so does each of its lights`() {
        val all = pictures(CourseShaders.FRAGMENT)
        // Edges: OpenGL may round vertices to 1/256 of a pixel, so that samples on them fall to the one or the other side.
        for (evidence in all) assertTrue(differing(evidence) < 0.01) { "${evidence.title}: ${differing(evidence)}" }
        assertEquals(
            listOf(null, Check.POINT_LIGHT, Check.POINT_LIGHT, Check.SPOT_LIGHT),
            all.map { it.check }.sortedBy { it?.ordinal ?: -1 },
        )
    }

    @ParameterizedTest
    @ValueSource(strings = ["emission diffuse specular", "emission diffuse", ""])
    fun `with a gamma the expected picture is encoded as well, from textures decoded as the submission's`(decoded: String) {
        val fragment = decoded.split(' ').filter(String::isNotEmpty).fold(CourseShaders.FRAGMENT) { text, name ->
            text.replace(Regex("""vec3 $name = (texture\([^)]*\)\.rgb)"""), "vec3 $name = pow($1, vec3(2.2))")
        }
        val whole = pictures(fragment.replace("vec4(result, 1.0)", "vec4(pow(result, vec3(1.0 / 2.2)), 1.0)")).first()
        // Texels of 8 bits that are decoded to 8 bits are off by half of 1/255, which the encoding of what is dark makes 2 and more.
        assertTrue(differing(whole) < 0.05) { "${differing(whole)}" }
    }

    @Test
    fun `a cone that is inside out is expected about the axis that was meant`() {
        fun expected(fragment: String) = brightness(read(pictures(fragment).first().expected))
        val swapped = "clamp((theta - inner) / (outer - inner), 0.0, 1.0)"
        val right = expected(CourseShaders.FRAGMENT)
        val inverted = expected(CourseShaders.FRAGMENT.replace("clamp((theta - outer) / (inner - outer), 0.0, 1.0)", swapped))
        // The edges are measured, to some 1e-5 of a radian: nothing that an average of all pixels shows.
        assertEquals(right, inverted, 0.01)
    }

    @Test
    fun `light multiplied with what glows is expected with the textures where they are`() {
        val product = CourseShaders.FRAGMENT
            .replace(
                "* attenuate(",
                "* emission * attenuate(",
            ).replace("result = emission;", "result = vec3(0.0);")

        // Of a light alone, as no colour of what glows is known.
        fun expected(fragment: String) = read(pictures(fragment).single { it.check == Check.SPOT_LIGHT }.expected).rgba.copyOf()
        val off = differing(expected(product), expected(CourseShaders.FRAGMENT))
        // Coordinates are the root of what shows: what floats lose of it, 1e-8, is 1e-4 of a texture, a few hundredths of a texel.
        assertTrue(off < 0.03) { "$off" }
    }

    @Test
    fun `a light alone is without the emission`() {
        val all = pictures(CourseShaders.FRAGMENT)
        val spot = all.single { it.check == Check.SPOT_LIGHT }
        val picture = read(spot.measured)
        // Far from the cone there is nothing: the upper left corner of the ground glows otherwise.
        val dark = (0 until picture.rgba.size / 4).count { p -> (0..2).all { picture.rgba[4 * p + it].toInt() == 0 } }
        assertTrue(dark > picture.rgba.size / 4 / 2) { "$dark dark pixels" }
        assertTrue(brightness(picture) > 0.1) { "the light itself is gone" }
    }

    @Test
    fun `without attenuation the expected picture has Table 1's`() {
        val bright = pictures(CourseShaders.FRAGMENT.replace(Regex("""1\.0 / \([^;]*;"""), "1.0;"))
        val whole = bright.first()
        assertTrue(differing(whole) > 0.3) { "${differing(whole)}" }
        assertTrue(brightness(read(whole.expected)) < 0.8 * brightness(read(whole.measured)))
    }
}
