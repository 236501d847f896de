package cga.grading.analysis

import cga.framework.Frame
import cga.framework.FrameCone
import cga.framework.FrameDraw
import cga.framework.FrameLight
import cga.framework.FrameMaterial
import cga.framework.FrameTexture
import cga.framework.SpecularModel
import cga.framework.image.ImageData
import cga.framework.image.TextureImage
import cga.grading.capture.Capture
import cga.grading.capture.CapturedFrame
import cga.grading.capture.CapturedTexture
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.ObservedCone
import cga.grading.scene.ObservedFrame
import cga.grading.scene.ObservedLight
import cga.grading.scene.isUsable
import cga.grading.scene.rigidPart
import cga.grading.study.Materials
import cga.grading.study.Surface
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3d
import org.joml.Vector3dc
import org.joml.Vector3f
import org.lwjgl.opengl.GL33C.GL_LINEAR
import org.lwjgl.opengl.GL33C.GL_REPEAT
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.pow
import kotlin.math.roundToInt

/**
 * What a captured picture should look like, for the reference to shade: the submission's own meshes, textures, places, colours and angles,
 * and the sheet's lighting. Where a number of its own cannot be what was meant, the sheet's takes its place.
 *
 * @param wrong what the submission got wrong, and where: numbers behind those mistakes are not its own will.
 */
internal class ExpectedFrame(
    private val capture: Capture,
    private val materials: Materials,
    private val wrong: Verdict,
) {
    private val textures = HashMap<Pair<Int, Double>, FrameTexture>()
    private val surfaces = HashMap<CapturedFrame, List<Surface>>()
    private val isKWrong = K_CHECKS.any { check -> wrong.checks.any { it.check == check && (it.error ?: 0.0) > SOUND } }

    /** The whole picture of [frame]; null where the submission is not understood well enough. */
    fun whole(
        frame: CapturedFrame,
        observed: ObservedFrame,
    ): Frame? = frame(frame, observed, observed.lights, emission = true)

    /** What the light called [name] alone adds. */
    fun light(
        frame: CapturedFrame,
        observed: ObservedFrame,
        name: String,
    ): Frame? = frame(frame, observed, observed.lights.filter { it.name == name }, emission = false)

    private fun frame(
        frame: CapturedFrame,
        observed: ObservedFrame,
        lights: List<ObservedLight>,
        emission: Boolean,
    ): Frame? {
        if (!observed.view.isUsable()) return null
        val surfaces = surfaces.getOrPut(frame) { materials.of(frame, observed.view).orEmpty() }.ifEmpty { return null }
        val gamma = surfaces.map { meant(it.gamma) }.distinct().singleOrNull() ?: return null
        val fromView = Matrix4d(observed.view).invert()
        return Frame(
            view = rigidPart(fromView).invert(),
            projection = Matrix4f(observed.projection),
            ambient = Vector3f(surfaces.first().ambient?.takeIf { emission } ?: Vector3d()),
            specularModel = SpecularModel.BLINN_PHONG,
            gamma = gamma.toFloat(),
            lights = lights.mapNotNull { light(it, fromView) },
            draws = surfaces.map { draw(it, emission) ?: return null },
        )
    }

    private fun light(
        light: ObservedLight,
        fromView: Matrix4d,
    ): FrameLight? {
        // A position that no view matrix was applied to is one in the world.
        val isWorld = light.spot == null && wrong.mistakes.any { it.mistake == Mistake.TO_LIGHT_WORLD }
        val position = Vector3d(light.position).let { if (isWorld) it else fromView.transformPosition(it) }
        if (!position.isFinite || !light.color.isFinite) return null
        val cone = light.spot?.let { cone(it, fromView) ?: return null }
        return FrameLight(position, Vector3f(Vector3d(light.color).max(Vector3d())), Vector3f(k(light)), cone)
    }

    private fun cone(
        cone: ObservedCone,
        fromView: Matrix4d,
    ): FrameCone? {
        val isWorld = wrong.mistakes.any { it.mistake == Mistake.SPOT_DIRECTION_WORLD }
        // Lit but for a cone is what an inverted one is about its own axis.
        val isInverted = minOf(cone.innerAngle, cone.outerAngle) > PI / 2
        val isReversed = isInverted != wrong.mistakes.any { it.mistake == Mistake.SPOT_DIRECTION_SIGN }
        val direction = Vector3d(cone.direction)
            .let {
                if (isWorld) it else fromView.transformDirection(it)
            }.normalize(if (isReversed) -1.0 else 1.0)
        if (!direction.isFinite) return null
        val (inner, outer) = angles(listOf(cone.innerAngle, cone.outerAngle).map { if (isInverted) PI - it else it })
        return FrameCone(direction.normalize(), inner.toFloat(), outer.toFloat())
    }

    private fun angles(edges: List<Double>): Pair<Double, Double> {
        val (inner, outer) = edges.sorted()
        val isMeant = inner >= 0 && outer <= PI / 2 && wrong.mistakes.none { it.mistake in OTHER_ANGLES }
        return if (isMeant) inner to outer else USUAL_INNER to USUAL_OUTER
    }

    private fun k(light: ObservedLight): Vector3dc {
        val k = light.k
        val isSound = k.isFinite && minOf(k.x(), minOf(k.y(), k.z())) >= 0 && k.y() + k.z() > 0
        return if (isSound && !isKWrong) {
            k
        } else if (light.spot == null) {
            POINT_K
        } else {
            SPOT_K
        }
    }

    private fun draw(
        surface: Surface,
        emission: Boolean,
    ): FrameDraw? {
        // Swapped maps were found by what they do; what they are for is the other way round.
        val isSwapped = wrong.mistakes.any { it.mistake == Mistake.MAPS_SWAPPED }
        val diffuse = if (isSwapped) surface.specular else surface.diffuse
        val specular = if (isSwapped) surface.diffuse else surface.specular
        val material =
            FrameMaterial(
                emissive = texture(surface.emission.takeIf { emission }, surface) ?: return null,
                diffuse = texture(diffuse, surface) ?: return null,
                specular = texture(specular, surface) ?: return null,
                shininess = surface.exponent.takeIf { it.isFinite() && it >= 0 }?.toFloat() ?: return null,
                tcMultiplier = Vector2f(1f),
            )
        val tint = Vector3f(Vector3d(surface.tint ?: WHITE).max(Vector3d()))
        return FrameDraw(surface.vertices, surface.indices, surface.model, tint, material)
    }

    /** Texture [number] as [surface] reads it, black for none; null where its texels are decoded by OpenGL. */
    private fun texture(number: Int?, surface: Surface): FrameTexture? {
        if (number == null) return BLACK
        val captured = capture.textures.getOrNull(number)?.takeUnless { it.srgb } ?: return null
        val power = meant(surface.powers[number] ?: 1.0)
        return textures.getOrPut(number to power) {
            val stored = TextureImage(ImageData(captured.width, captured.height, topFirst(captured)), mipmaps = captured.levels.size > 1)
            // As a shader does it: what is read has been made smaller already.
            val image = TextureImage(stored.levels.map { TextureImage.Level(it.width, it.height, raised(it.rgba, power)) })
            FrameTexture(image, captured.wrapS, captured.wrapT, captured.minFilter, captured.magFilter)
        }
    }

    /** A gamma that is none, or the usual one; the wrong way round, or of another size, was never meant. */
    private fun meant(gamma: Double): Double = if (abs(gamma - 1) < PLAIN) 1.0 else GAMMA

    /** [rgba] with colours to the power of [power]: rounded to 8 bits, which no eye sees once the light is encoded again. */
    private fun raised(rgba: ByteArray, power: Double): ByteArray {
        if (power == 1.0) return rgba
        val powers = ByteArray(BYTES) { (BYTE * (it / BYTE).pow(power)).roundToInt().toByte() }
        return ByteArray(rgba.size) { if (it % 4 == 3) rgba[it] else powers[rgba[it].toInt() and 0xFF] }
    }

    private fun topFirst(texture: CapturedTexture): ByteArray {
        val row = 4 * texture.width
        val texels = texture.levels[0]
        return ByteArray(texels.size) { texels[(texture.height - 1 - it / row) * row + it % row] }
    }

    private companion object {
        val K_CHECKS = listOf(Check.ATTENUATION_FORM, Check.ATTENUATION_POINT, Check.ATTENUATION_SPOT)
        const val SOUND = 0.02

        /** The later edition's. */
        const val GAMMA = 2.2
        const val PLAIN = 0.1
        const val BYTES = 256
        const val BYTE = 255.0

        /** Table 1 of the sheet. */
        val POINT_K: Vector3dc = Vector3d(1.0, 0.5, 0.1)
        val SPOT_K: Vector3dc = Vector3d(0.5, 0.05, 0.01)

        /** The cone's edges are not where they were meant to be. */
        val OTHER_ANGLES = setOf(Mistake.DEGREES_FOR_RADIANS, Mistake.COSINE_OF_COSINE, Mistake.CONE_NEVER_SENT)

        /** The sheet names no angles; these are a headlight's. */
        const val USUAL_INNER = 12 * PI / 180
        const val USUAL_OUTER = 25 * PI / 180
        val WHITE = Vector3d(1.0)
        val BLACK = FrameTexture(TextureImage(ImageData.ofColor(0f, 0f, 0f), mipmaps = false), GL_REPEAT, GL_REPEAT, GL_LINEAR, GL_LINEAR)
    }
}
