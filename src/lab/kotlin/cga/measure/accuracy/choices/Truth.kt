package cga.measure.accuracy.choices

import cga.exercise.game.ScriptedScene
import cga.framework.Frame
import cga.framework.FrameCone
import cga.framework.FrameDraw
import cga.framework.FrameLight
import cga.framework.FrameMaterial
import cga.framework.FrameTexture
import cga.framework.SpecularModel
import cga.framework.image.ImageData
import cga.framework.image.TextureImage
import cga.reference.ReferencePicture
import cga.reference.ReferenceRenderer
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Matrix4f
import org.joml.Vector3d
import org.joml.Vector3dc
import org.joml.Vector3f
import org.lwjgl.opengl.GL33C.GL_LINEAR

/** Which picture is the truth: the scene's last step with these changes, and grid×grid samples a pixel. */
internal data class TruthKey(
    val specular: SpecularModel = SpecularModel.BLINN_PHONG,
    val cone: Cone? = null,
    val surface: Surface = Surface.TEXTURED,
    val grid: Int = 1,
) {
    companion object {
        /** The grid that stands for the exact area of a pixel. */
        const val FINE = 16

        /** The truth of antialiasing: of the scene, or of its edges alone. */
        fun fine(group: DrawingGroup) = TruthKey(
            surface = if (group ==
                DrawingGroup.EDGES
            ) {
                Surface.PLAIN
            } else {
                Surface.TEXTURED
            },
            grid = FINE,
        )
    }
}

/** What the truth's surfaces look like. */
internal enum class Surface {
    /** As the scene has it. */
    TEXTURED,

    /** Textures at their largest level, whatever the distance. */
    FIRST_LEVEL,

    /** M_d and M_s of [Truth.GREY], no emission. */
    PLAIN,
}

/** The scene as all choices draw it. */
internal fun scene(size: PictureSize): ScriptedScene = ScriptedScene(size.width, size.height).apply { advanceTo(MOMENT) }

/** A time at which the motorcycle has a saturated colour. */
private const val MOMENT = 5.3

/** Makes frames of the scene, and the reference's pictures of them. */
internal object Truth {
    fun picture(
        key: TruthKey,
        size: PictureSize,
    ): ReferencePicture = ReferenceRenderer(frame(key, size), size.width, size.height).render(key.grid)

    fun frame(
        key: TruthKey,
        size: PictureSize,
    ): Frame {
        val scene = scene(size).scene.apply { specularModel = key.specular }
        val frame = scene.frame()
        return frame.with(
            lights = if (key.cone == null) frame.lights else frame.lights.map { it.with(key.cone) },
            draws = frame.draws.map { it.with(it.material.with(key.surface)) },
        )
    }

    /** [frame] with matrices and lights rounded to floats, as OpenGL gets them: in view space. */
    fun roundedToFloats(frame: Frame): Frame =
        Frame(
            Matrix4d(),
            frame.projection,
            frame.ambient,
            frame.specularModel,
            frame.gamma,
            frame.lights.map { it.rounded(frame.view) },
            frame.draws.map { draw ->
                val modelView = Matrix4d(Matrix4f(frame.view.mul(draw.model, Matrix4d())))
                FrameDraw(draw.vertices, draw.indices, modelView, draw.tint, draw.material)
            },
        )

    private fun FrameLight.rounded(view: Matrix4dc) =
        FrameLight(
            Vector3d(Vector3f(view.transformPosition(position, Vector3d()))),
            color,
            attenuation,
            cone?.run { FrameCone(direction(direction, view), innerAngle, outerAngle) },
        )

    private fun direction(
        direction: Vector3dc,
        view: Matrix4dc,
    ) = Vector3d(Vector3f(view.transformDirection(direction, Vector3d()))).normalize()

    private fun Frame.with(
        lights: List<FrameLight>,
        draws: List<FrameDraw>,
    ) = Frame(view, projection, ambient, specularModel, gamma, lights, draws)

    /** A spotlight's cone becomes [other]. */
    private fun FrameLight.with(other: Cone) =
        FrameLight(
            position,
            color,
            attenuation,
            cone?.run { FrameCone(direction, Math.toRadians(other.inner).toFloat(), Math.toRadians(other.outer).toFloat()) },
        )

    private fun FrameDraw.with(material: FrameMaterial) = FrameDraw(vertices, indices, model, tint, material)

    private fun FrameMaterial.with(surface: Surface) =
        when (surface) {
            Surface.TEXTURED -> this
            Surface.FIRST_LEVEL -> FrameMaterial(
                emissive.firstLevel(),
                diffuse.firstLevel(),
                specular.firstLevel(),
                shininess,
                tcMultiplier,
            )
            Surface.PLAIN -> FrameMaterial(emissive.plain(0), diffuse.plain(GREY), specular.plain(GREY), shininess, tcMultiplier)
        }

    private fun FrameTexture.firstLevel() = FrameTexture(image, wrapS, wrapT, GL_LINEAR, magFilter)

    private fun FrameTexture.plain(value: Int) =
        FrameTexture(TextureImage(ImageData(1, 1, ByteArray(4) { value.toByte() }), false), wrapS, wrapT, GL_LINEAR, GL_LINEAR)

    /** Of 255. */
    const val GREY = 128
}
