package cga.exercise.game

import cga.exercise.components.camera.OrbitRig
import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.Shapes
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.cos
import kotlin.math.PI
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val hud = Hud()

    private val ground = loadGround()
    private val player = loadCycle()
    private val rival = loadCycle()
    private val pillars = ArrayList<Renderable>()
    private val driver = Driver(player)

    // C changes between the two cameras
    private val rig = OrbitRig(player)
    private val overview = TronCamera()
    private var fromAbove = false

    private val playerLight = PointLight(Vector3f(0.0f, 1.6f, 0.0f), Vector3f(1.0f))
    private val rivalLight = PointLight(Vector3f(0.0f, 1.6f, 0.0f), Vector3f(2.0f, 0.8f, 0.1f))
    private val playerHeadlight = headlight(Vector3f(3.2f, 3.2f, 3.0f))
    private val rivalHeadlight = headlight(Vector3f(3.0f, 1.8f, 0.8f))
    private val lamps = ArrayList<PointLight>()

    private val points: List<PointLight>
    private val spots: List<SpotLight>

    private val playerGlow = Vector3f()
    private val rivalGlow = Vector3f(1.0f, 0.45f, 0.05f)
    private val groundGlow = Vector3f(0.0f, 1.0f, 0.0f)

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glEnable(GL_DEPTH_TEST)

        rival.translateGlobal(Vector3f(10.0f, 0.0f, -12.0f))
        overview.rotateLocal(toRadians(-50.0f), 0.0f, 0.0f)
        overview.translateLocal(Vector3f(0.0f, 0.0f, 22.0f))

        playerLight.parent = player
        playerHeadlight.parent = player
        rivalLight.parent = rival
        rivalHeadlight.parent = rival

        // six lamps in a ring, each on a pillar
        val stone = Material.plain(0x707680, 0xb0b0b0, 24.0f)
        for (i in 0 until LAMPS) {
            val angle = (2.0 * PI * i / LAMPS + PI / 6).toFloat()
            val x = 15.0f * sin(angle)
            val z = 15.0f * cos(angle)
            lamps += PointLight(Vector3f(x, 2.4f, z), rainbow(i.toFloat() / LAMPS).mul(6.0f))
            val pillar = Renderable(mutableListOf(Shapes.box(0.4f, 2.0f, 0.4f, stone)))
            pillar.translateGlobal(Vector3f(x, 0.0f, z))
            pillars += pillar
        }
        points = listOf(playerLight, rivalLight) + lamps
        spots = listOf(playerHeadlight, rivalHeadlight)
        GLError.checkThrow("in Scene.init")
    }

    private fun headlight(color: Vector3f): SpotLight {
        val light = SpotLight(Vector3f(0.0f, 0.9f, -1.8f), color, toRadians(13.0f), toRadians(24.0f))
        light.rotateLocal(toRadians(-9.0f), 0.0f, 0.0f)
        return light
    }

    private fun loadCycle(): Renderable {
        val cycle = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw IllegalStateException("no motorcycle")
        cycle.scaleLocal(Vector3f(0.8f))
        return cycle
    }

    private fun loadGround(): Renderable {
        fun map(kind: String) = Texture2D("assets/textures/ground_$kind.png", true).apply {
            setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        }
        val material = Material(map("diff"), map("emit"), map("spec"), 60.0f, Vector2f(64.0f))
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val layout = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        return Renderable(mutableListOf(Mesh(obj.vertexData, obj.indexData, layout, material)))
    }

    /** Colours once around the circle, for 0 to 1. */
    private fun rainbow(hue: Float): Vector3f {
        val a = hue * 2.0f * PI.toFloat()
        return Vector3f(0.5f + 0.5f * sin(a), 0.5f + 0.5f * sin(a + 2.094f), 0.5f + 0.5f * sin(a + 4.189f))
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        playerGlow.set(rainbow(0.15f * t))
        playerLight.lightColor.set(playerGlow)

        val camera = if (fromAbove) overview else rig.camera
        shader.use()
        camera.bind(shader)
        points.forEachIndexed { i, light -> light.bind(shader, "points[$i]") }
        val view = camera.getCalculateViewMatrix()
        spots.forEachIndexed { i, light -> light.bind(shader, "spots[$i]", view) }
        shader.setUniform("ambient", Vector3f(0.03f))

        draw(ground, groundGlow)
        for (pillar in pillars) draw(pillar, groundGlow)
        draw(rival, rivalGlow)
        draw(player, playerGlow)

        hud.render(driver.speed)
    }

    private fun draw(thing: Renderable, glow: Vector3f) {
        shader.setUniform("glow", glow)
        thing.render(shader)
    }

    fun update(dt: Float, t: Float) {
        driver.drive(keys(GLFW_KEY_W, GLFW_KEY_S), keys(GLFW_KEY_A, GLFW_KEY_D), dt)

        // the rival goes round in a circle
        rival.rotateLocal(0.0f, 0.4f * dt, 0.0f)
        rival.translateLocal(Vector3f(0.0f, 0.0f, -3.0f * dt))

        rig.zoom(3.0f * dt * keys(GLFW_KEY_Q, GLFW_KEY_E))
    }

    private fun keys(plus: Int, minus: Int): Float {
        val a = if (window.getKeyState(plus)) 1.0f else 0.0f
        val b = if (window.getKeyState(minus)) 1.0f else 0.0f
        return a - b
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (action != GLFW_PRESS) return
        when (key) {
            GLFW_KEY_L -> playerHeadlight.toggle()
            GLFW_KEY_K -> lamps.forEach { it.toggle() }
            GLFW_KEY_C -> fromAbove = !fromAbove
        }
    }

    fun onMouseMove(xpos: Double, ypos: Double) = rig.mouse(xpos, ypos)

    fun onMouseScroll(yoffset: Double) = rig.zoom(yoffset.toFloat() * 0.5f)

    fun cleanup() {
        hud.cleanup()
        for (thing in pillars + listOf(ground, rival, player)) thing.cleanup()
        shader.cleanup()
    }

    private companion object {
        const val LAMPS = 6
    }
}
