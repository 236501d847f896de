package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.LampMesh
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.UniformBlock
import cga.exercise.components.texture.Canvas
import cga.exercise.components.texture.Sampler
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
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val groundShader = ShaderProgram("ground")
    private val cycleShader = ShaderProgram("cycle")
    private val lampShader = ShaderProgram("lamp")
    private val screenShader = ShaderProgram("screen")

    private val cameraBlock = UniformBlock("Camera", 0, 2 * 64)
    private val lightBlock = UniformBlock("Lights", 1, PointLight.MAX * PointLight.BYTES + 16)
    private val smooth = Sampler(GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
    private var canvas: Canvas? = null

    private val ground: Renderable
    private val cycle: Renderable
    private val camera: TronCamera
    private val lampMesh = LampMesh()

    private val cycleLight = PointLight(Vector3f(0.0f, 1.4f, 0.2f), Vector3f(1.0f))
    private val headlight = SpotLight(Vector3f(0.0f, 0.9f, -1.7f), Vector3f(4.0f, 4.0f, 3.5f), toRadians(11.0f), toRadians(23.0f))
    private val lamps = listOf(
        PointLight(Vector3f(12.0f, 1.8f, 12.0f), Vector3f(6.0f, 1.0f, 0.0f)),
        PointLight(Vector3f(12.0f, 1.8f, -12.0f), Vector3f(0.0f, 5.0f, 2.0f)),
        PointLight(Vector3f(-12.0f, 1.8f, -12.0f), Vector3f(1.0f, 1.0f, 7.0f)),
        PointLight(Vector3f(-12.0f, 1.8f, 12.0f), Vector3f(5.0f, 0.0f, 5.0f))
    )
    private val lights = listOf(cycleLight, headlight) + lamps

    private var lastX: Double? = null

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_CULL_FACE)

        for (program in listOf(groundShader, cycleShader, lampShader)) {
            cameraBlock.attachTo(program)
            lightBlock.attachTo(program)
        }

        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        val material = Material(
            Texture2D("assets/textures/ground_diff.png", true),
            Texture2D("assets/textures/ground_emit.png", true),
            Texture2D("assets/textures/ground_spec.png", true),
            60.0f,
            Vector2f(64.0f)
        )
        ground = Renderable(mutableListOf(Mesh(obj.vertexData, obj.indexData, attributes, material)))

        cycle = checkNotNull(ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f))
        cycle.scaleLocal(Vector3f(0.8f))
        camera = TronCamera(cycle)

        cycleLight.parent = cycle
        headlight.parent = cycle
        headlight.rotateLocal(toRadians(-12.0f), 0.0f, 0.0f)
        GLError.checkThrow("Scene.init")
    }

    fun render(dt: Float, t: Float) {
        val color = Vector3f(wave(t), wave(1.4f * t + 2.0f), wave(0.8f * t + 4.0f))
        cycleLight.lightColor = color
        sendLights()
        camera.aspect = window.framebufferWidth / window.framebufferHeight.toFloat()
        camera.bind(cameraBlock)

        val target = canvas()
        target.begin()
        smooth.bind(0..2)
        groundShader.use()
        groundShader.setUniform("emissionColor", Vector3f(0.0f, 1.0f, 0.0f))
        ground.render(groundShader)
        cycleShader.use()
        cycleShader.setUniform("emissionColor", color)
        cycle.render(cycleShader)
        lampShader.use()
        lampShader.setUniform("firstLamp", lights.size - lamps.size)
        lampShader.setUniform("lampSize", 0.25f)
        lampMesh.render(lamps.size)
        target.show(screenShader)
    }

    private fun wave(x: Float) = 0.55f + 0.45f * sin(x)

    private fun sendLights() {
        val view = camera.getCalculateViewMatrix()
        for ((i, light) in lights.withIndex()) light.bind(lightBlock, i, view)
        lightBlock.put(PointLight.MAX * PointLight.BYTES, lights.size)
        lightBlock.send()
    }

    /** The canvas, made again when the window has got another size. */
    private fun canvas(): Canvas {
        val (width, height) = window.framebufferWidth to window.framebufferHeight
        canvas?.let { if (it.fits(width, height)) return it else it.cleanup() }
        return Canvas(width, height).also { canvas = it }
    }

    fun update(dt: Float, t: Float) {
        var speed = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) speed += 6.0f
        if (window.getKeyState(GLFW_KEY_S)) speed -= 4.0f
        var turn = 0.0f
        if (window.getKeyState(GLFW_KEY_A)) turn += 1.2f
        if (window.getKeyState(GLFW_KEY_D)) turn -= 1.2f
        if (speed != 0.0f) cycle.rotateLocal(0.0f, turn * dt, 0.0f)
        cycle.translateLocal(Vector3f(0.0f, 0.0f, -speed * dt))
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (action == GLFW_RELEASE) return
        if (key == GLFW_KEY_UP) camera.radius = maxOf(2.0f, camera.radius - 0.5f)
        if (key == GLFW_KEY_DOWN) camera.radius = minOf(12.0f, camera.radius + 0.5f)
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        val before = lastX ?: xpos
        lastX = xpos
        camera.yaw -= ((xpos - before) * 0.002).toFloat()
    }

    fun cleanup() {
        canvas?.cleanup()
        lampMesh.cleanup()
        ground.cleanup()
        cycle.cleanup()
        smooth.cleanup()
        cameraBlock.cleanup()
        lightBlock.cleanup()
        for (program in listOf(groundShader, cycleShader, lampShader, screenShader)) program.cleanup()
    }
}
