package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.LightManager
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
import kotlin.math.abs
import kotlin.math.sign
import kotlin.math.sin

class Scene(private val window: GameWindow) {

    // [SerializeField] :)
    private val maxSpeed = 7.0f
    private val acceleration = 14.0f
    private val turnSpeed = 80.0f // degrees per second
    private val mouseSensitivity = 0.002f

    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground: Renderable
    private val bike: Renderable
    private val camera = TronCamera()
    private val mainLight: PointLight
    private val headLight: SpotLight
    private val lights: LightManager

    private var speed = 0.0f
    private var lastMouse: Vector2f? = null

    // ---- Awake ----
    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        ground = Renderable(mutableListOf(loadGroundMesh()))
        ground.emissionColor = Vector3f(0.0f, 1.0f, 0.0f)

        bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw IllegalStateException("no bike, no game")
        bike.localScale.set(0.8f)
        GLError.checkThrow("loading assets")

        camera.parent = bike
        camera.rotateLocal(toRadians(-28.0f), 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.3f, 5.2f))

        mainLight = PointLight(Vector3f(0.0f, 1.7f, 0.2f), Vector3f(1.0f))
        mainLight.parent = bike

        headLight = SpotLight(Vector3f(0.0f, 1.0f, -1.7f), Vector3f(3.4f, 3.3f, 3.0f), toRadians(12.0f), toRadians(24.0f))
        headLight.rotateLocal(toRadians(-11.0f), 0.0f, 0.0f)
        headLight.parent = bike

        lights = LightManager(mainLight, headLight)
        lights.add(PointLight(Vector3f(-13.0f, 1.6f, -13.0f), Vector3f(7.0f, 0.8f, 0.3f)))
        lights.add(PointLight(Vector3f(13.0f, 1.6f, -13.0f), Vector3f(0.3f, 1.0f, 8.0f)))
        lights.add(PointLight(Vector3f(-13.0f, 1.6f, 13.0f), Vector3f(0.4f, 6.0f, 5.5f)))
        lights.add(PointLight(Vector3f(13.0f, 1.6f, 13.0f), Vector3f(6.5f, 0.3f, 6.0f)))

        // glUniform goes to the program in use
        shader.use()
        lights.uploadStatic(shader)
    }

    private fun loadGroundMesh(): Mesh {
        val textures = listOf("diff", "emit", "spec").map { Texture2D("assets/textures/ground_$it.png", true) }
        textures.forEach { it.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR) }
        val material = Material(textures[0], textures[1], textures[2], 60.0f, Vector2f(64.0f))

        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val layout = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        return Mesh(obj.vertexData, obj.indexData, layout, material)
    }

    // ---- Update ----
    fun update(dt: Float, t: Float) {
        var targetSpeed = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) targetSpeed = maxSpeed
        if (window.getKeyState(GLFW_KEY_S)) targetSpeed = -maxSpeed / 2
        speed = moveTowards(speed, targetSpeed, acceleration * dt)

        var turn = 0.0f
        if (window.getKeyState(GLFW_KEY_A)) turn += 1.0f
        if (window.getKeyState(GLFW_KEY_D)) turn -= 1.0f
        // no turning on the spot
        val grip = speed / maxSpeed
        bike.rotateLocal(0.0f, toRadians(turn * turnSpeed) * grip * dt, 0.0f)
        bike.translateLocal(Vector3f(0.0f, 0.0f, -speed * dt))
    }

    // Mathf.MoveTowards
    private fun moveTowards(current: Float, target: Float, maxDelta: Float): Float {
        val delta = target - current
        if (abs(delta) <= maxDelta) return target
        return current + sign(delta) * maxDelta
    }

    // ---- OnRenderObject or so ----
    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        val glow = Vector3f(wave(t * 0.9f), wave(t * 0.6f + 2.0f), wave(t * 1.3f + 4.0f))
        bike.emissionColor.set(glow)
        mainLight.color.set(glow)

        shader.use()
        camera.bind(shader)
        val view = camera.getCalculateViewMatrix()
        lights.upload(shader, view)
        ground.render(shader, view)
        bike.render(shader, view)
    }

    // never completely dark
    private fun wave(x: Float) = 0.6f + 0.4f * sin(x)

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        val mouse = Vector2f(xpos.toFloat(), ypos.toFloat())
        val last = lastMouse
        lastMouse = mouse
        if (last == null) return // no delta yet

        val yaw = -(mouse.x - last.x) * mouseSensitivity
        // the bike is the parent, so the bike is at 0 0 0
        camera.rotateAround(Vector3f(0.0f), Vector3f(0.0f, 1.0f, 0.0f), yaw)
    }

    // ---- OnDestroy ----
    fun cleanup() {
        ground.cleanup()
        bike.cleanup()
        shader.cleanup()
    }
}
