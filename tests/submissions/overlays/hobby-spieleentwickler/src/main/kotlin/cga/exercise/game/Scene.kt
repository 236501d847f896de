package cga.exercise.game

import cga.exercise.components.camera.CameraRig
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.geometry.childOf
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.bindCamera
import cga.exercise.components.shader.bindLights
import cga.exercise.components.texture.Texture2D
import cga.exercise.util.hex
import cga.exercise.util.setHsv
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*

class Scene(private val window: GameWindow) {

    private data class Tuning(
        val topSpeed: Float = 6.0f,
        val reverseSpeed: Float = 3.0f,
        val turnRate: Float = 1.4f,
        val steerAngle: Float = toRadians(18.0f),
        val mouseSensitivity: Float = 0.002f,
        val hueSpeed: Float = 40.0f // degrees per second
    )

    private val tuning = Tuning()
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
        ?: error("motorcycle.obj is missing")
    private val ground = Renderable(mutableListOf(loadGround()))
    private val drawables = listOf(ground, bike)

    private val rig = CameraRig(bike, 4.8f, toRadians(32.0f))
    private val handlebar = Handlebar(Vector3f(0.0f, 0.85f, -1.5f)) childOf bike

    /** shared by the bike's emission and by its underglow */
    private val neon = Vector3f(1.0f)

    private val underglow = PointLight(Vector3f(0.0f, 1.6f, 0.3f), neon) childOf bike
    private val headlight = SpotLight(Vector3f(0.0f, 0.1f, -0.35f), hex(0xfff4d0, 3.2f), toRadians(14.0f), toRadians(28.0f)) childOf handlebar
    private val lights = mutableListOf(underglow, headlight)

    private var lastMouseX = Double.NaN

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        bike.scaleLocal(Vector3f(0.8f))
        bike.glow = neon
        ground.glow = Vector3f(0.0f, 1.0f, 0.0f)
        headlight.rotateLocal(toRadians(-11.0f), 0.0f, 0.0f)

        // arena lights, one in each corner
        val arena = listOf(0xff2030, 0x2060ff, 0xffb000, 0xc020ff)
        arena.forEachIndexed { i, rgb ->
            val x = if (i % 2 == 0) -14.0f else 14.0f
            val z = if (i < 2) -14.0f else 14.0f
            lights += PointLight(Vector3f(x, 1.8f, z), hex(rgb, 7.5f))
        }
        GLError.checkThrow("scene setup")
    }

    private fun loadGround(): Mesh {
        fun tex(kind: String) = Texture2D("assets/textures/ground_$kind.png", true).apply {
            setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        }

        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val layout = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        return Mesh(obj.vertexData, obj.indexData, layout, Material(tex("diff"), tex("emit"), tex("spec"), 60.0f, Vector2f(64.0f)))
    }

    fun update(dt: Float, t: Float) {
        // rainbow
        val hue = t * tuning.hueSpeed % 360.0f
        neon.setHsv(hue, 0.85f, 1.0f)

        // arcade steering: full lock or nothing, no smoothing (looked mushy)
        val throttle = axis(GLFW_KEY_W, GLFW_KEY_S)
        val turn = axis(GLFW_KEY_A, GLFW_KEY_D)
        handlebar.steer(turn * tuning.steerAngle)
        bike.rotateLocal(0.0f, throttle * turn * tuning.turnRate * dt, 0.0f)
        val speed = if (throttle > 0.0f) tuning.topSpeed else tuning.reverseSpeed
        bike.translateLocal(Vector3f(0.0f, 0.0f, -throttle * speed * dt))
    }

    private fun axis(plus: Int, minus: Int): Float {
        var value = 0.0f
        if (window.getKeyState(plus)) value += 1.0f
        if (window.getKeyState(minus)) value -= 1.0f
        return value
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        shader.use()
        shader.bindCamera(rig.camera)
        shader.bindLights(lights)

        val view = rig.camera.getCalculateViewMatrix()
        drawables.forEach { it.render(shader, view) }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        // TODO jump on space?
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        val dx = xpos - lastMouseX
        lastMouseX = xpos
        if (dx.isNaN()) return // very first event
        rig.yaw(-dx.toFloat() * tuning.mouseSensitivity)
    }

    fun cleanup() {
        drawables.forEach { it.cleanup() }
        shader.cleanup()
    }
}
