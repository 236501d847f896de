package cga.measure.speed

import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.Transformable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.RenderTarget
import cga.framework.image.ImageData
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector3f
import org.lwjgl.opengl.GL33C.*
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText

/** How a frame is sent to OpenGL. */
internal enum class Way(val title: String) {
    /** As our solution does it. */
    OURS("ours"),

    /** As the course's original framework does it: see [CourseWay]. */
    COURSE("the course's way"),
}

/**
 * Many small objects and lights: each object is a triangle with a material and a parent, a draw call of its own; each light has a
 * parent, too. The picture is so small that sending it is what takes the time.
 */
internal class Submission(
    way: Way,
    objects: Int,
    lights: Int,
) : TimedFrame() {
    private val target = RenderTarget(SIZE, SIZE)
    private val folder = createTempDirectory("cga-submission")
    private val program = ShaderProgram(write("submission.vert", VERTEX), write("submission.frag", FRAGMENT))
    private val parent = Transformable(Matrix4f().rotateY(0.3f).scale(0.8f))
    private val material = grey().let { Material(it, it, it, 60f) }
    private val mesh = Mesh(TRIANGLE, intArrayOf(0, 1, 2), LAYOUT, material)
    private val renderables = List(objects) { Renderable(listOf(mesh), Matrix4f().translate(it % 7f, 0f, -1f - it % 11), parent) }
    private val pointLights =
        List(lights) { i -> PointLight(Vector3f(i % 5f, 1f, i % 3f), Vector3f(1f)).also { it.parent = parent } }
    private val names = List(lights) { "pointLight[$it]" }
    private val view = Matrix4d().translate(0.0, -1.0, -4.0)
    private val send: () -> Unit = if (way ==
        Way.OURS
    ) {
        ::sendOurs
    } else {
        CourseWay(parent, renderables, pointLights, mesh, material, view)::send
    }

    override fun draw() {
        target.bind()
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        program.use()
        send()
        glFinish()
    }

    private fun sendOurs() {
        for (i in pointLights.indices) pointLights[i].bind(program, names[i], view)
        for (i in renderables.indices) renderables[i].render(program, view)
    }

    override fun close() {
        program.cleanup()
        mesh.cleanup()
        material.cleanup()
        target.close()
        folder.toFile().deleteRecursively()
    }

    private fun write(
        name: String,
        text: String,
    ): String = folder.resolve(name).also { it.writeText(text) }.toString()

    internal companion object {
        const val MOST_LIGHTS = 64
        private const val SIZE = 16
        private val TRIANGLE =
            floatArrayOf(0f, 0f, 0f, 0f, 0f, 0f, 1f, 0f, 0.1f, 0f, 0f, 1f, 0f, 0f, 1f, 0f, 0f, 0.1f, 0f, 0f, 1f, 0f, 0f, 1f)
        private val LAYOUT = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))

        private fun grey() = Texture2D(ImageData.ofColor(0.5f, 0.5f, 0.5f), false)

        // Uses all that is sent, so that the compiler leaves nothing out.
        private val VERTEX =
            """
            #version 330 core
            layout(location = 0) in vec3 position;
            layout(location = 1) in vec2 texCoord;
            layout(location = 2) in vec3 normal;
            struct PointLight { vec3 position; vec3 color; vec3 attenuation; };
            uniform PointLight pointLight[$MOST_LIGHTS];
            uniform mat4 modelView;
            uniform mat3 normalMatrix;
            uniform vec2 tcMultiplier;
            out vec3 light;
            out vec2 uv;
            void main() {
                light = normalMatrix * normal;
                for (int i = 0; i < $MOST_LIGHTS; i++) light += pointLight[i].position * pointLight[i].color + pointLight[i].attenuation;
                uv = texCoord * tcMultiplier;
                gl_Position = modelView * vec4(position, 4.0);
            }
            """.trimIndent()
        private val FRAGMENT =
            """
            #version 330 core
            struct Material { sampler2D diffuse; sampler2D emissive; sampler2D specular; float shininess; };
            uniform Material material;
            in vec3 light;
            in vec2 uv;
            out vec4 color;
            void main() {
                vec4 texels = texture(material.diffuse, uv) + texture(material.emissive, uv) + texture(material.specular, uv);
                color = texels * vec4(light, material.shininess);
            }
            """.trimIndent()
    }
}
