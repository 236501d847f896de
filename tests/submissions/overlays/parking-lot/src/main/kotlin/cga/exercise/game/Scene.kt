package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.*
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.PI
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground = Renderable()
    private val bike: Renderable
    private val parkedBike: Renderable

    private val camera = TronCamera()

    private val bikeLight: PointLight
    private val headLight: SpotLight
    private val lamps = ArrayList<PointLight>()

    // ein Licht, das langsam um den Platz kreist
    private val circle = Transformable()
    private val circlingLight: PointLight

    private val groundColor = Vector3f(0.0f, 1.0f, 0.0f)
    private val parkedColor = Vector3f(0.1f, 0.4f, 0.9f)

    private var firstMouse = true
    private var lastX = 0.0

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // Boden
        val groundDiff = Texture2D("assets/textures/ground_diff.png", true)
        val groundEmit = Texture2D("assets/textures/ground_emit.png", true)
        val groundSpec = Texture2D("assets/textures/ground_spec.png", true)
        groundDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        groundEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        groundSpec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundMaterial = Material(groundDiff, groundEmit, groundSpec, 60.0f, Vector2f(64.0f, 64.0f))

        val res = OBJLoader.loadOBJ("assets/models/ground.obj")
        val vertexAttributes = arrayOf(
            VertexAttribute(3, 32, 0),
            VertexAttribute(2, 32, 12),
            VertexAttribute(3, 32, 20)
        )
        ground.meshes.add(Mesh(res.vertexData, res.indexData, vertexAttributes, groundMaterial))

        // Motorrad
        bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw Exception("Motorrad konnte nicht geladen werden")
        bike.scaleLocal(Vector3f(0.8f))

        // noch eins, geparkt (gleiche Meshes)
        parkedBike = Renderable(bike.meshes)
        parkedBike.translateGlobal(Vector3f(3.6f, 0.0f, -3.0f))
        parkedBike.rotateLocal(0.0f, rad(130.0f), 0.0f)
        parkedBike.scaleLocal(Vector3f(0.8f))

        // Kamera
        camera.rotateLocal(rad(-32.0f), 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.0f, 4.2f))
        camera.parent = bike

        // Licht am Motorrad
        bikeLight = PointLight(Vector3f(0.0f, 1.4f, 0.2f), Vector3f(1.0f, 1.0f, 1.0f))
        bikeLight.parent = bike

        // Scheinwerfer
        headLight = SpotLight(Vector3f(0.0f, 1.1f, -1.7f), Vector3f(2.0f, 2.0f, 1.9f), rad(13.0f), rad(27.0f))
        headLight.rotateLocal(rad(-11.0f), 0.0f, 0.0f)
        headLight.parent = bike

        // Lampen um den Platz
        val lampColor = Vector3f()
        lampColor.set(7.0f, 0.4f, 0.4f)
        lamps.add(PointLight(Vector3f(-12.0f, 1.6f, -12.0f), Vector3f(lampColor)))
        lampColor.set(0.4f, 0.4f, 7.0f)
        lamps.add(PointLight(Vector3f(12.0f, 1.6f, -12.0f), Vector3f(lampColor)))
        lampColor.set(6.0f, 5.0f, 0.4f)
        lamps.add(PointLight(Vector3f(-12.0f, 1.6f, 12.0f), Vector3f(lampColor)))
        lampColor.set(6.0f, 0.4f, 6.0f)
        lamps.add(PointLight(Vector3f(12.0f, 1.6f, 12.0f), Vector3f(lampColor)))
        lampColor.set(0.3f, 4.0f, 4.0f)
        lamps.add(PointLight(Vector3f(0.0f, 1.6f, -16.0f), Vector3f(lampColor)))
        lampColor.set(4.0f, 2.0f, 0.3f)
        lamps.add(PointLight(Vector3f(0.0f, 1.6f, 16.0f), Vector3f(lampColor)))

        lampColor.set(2.5f, 2.5f, 3.5f)
        circlingLight = PointLight(Vector3f(8.0f, 2.0f, 0.0f), Vector3f(lampColor))
        circlingLight.parent = circle
    }

    private fun rad(degrees: Float) = (degrees * PI / 180.0).toFloat()

    private fun rainbow(t: Float) = Vector3f(
        0.55f + 0.45f * sin(t),
        0.55f + 0.45f * sin(t * 0.7f + 2.0f),
        0.55f + 0.45f * sin(t * 1.3f + 4.0f)
    )

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        val bikeColor = rainbow(t)
        bikeLight.lightCol = bikeColor

        staticShader.use()
        camera.bind(staticShader)

        // 0 ist das Motorrad, dann die Lampen, zuletzt das kreisende
        bikeLight.bind(staticShader, "pointLight[0]")
        for (i in lamps.indices) {
            lamps[i].bind(staticShader, "pointLight[${i + 1}]")
        }
        circlingLight.bind(staticShader, "pointLight[${lamps.size + 1}]")
        headLight.bind(staticShader, "spotLight", camera.getCalculateViewMatrix())

        staticShader.setUniform("emitColor", groundColor)
        ground.render(staticShader)

        staticShader.setUniform("emitColor", parkedColor)
        parkedBike.render(staticShader)

        staticShader.setUniform("emitColor", bikeColor)
        bike.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        circle.rotateLocal(0.0f, 0.2f * dt, 0.0f)

        if (window.getKeyState(GLFW_KEY_W)) {
            bike.translateLocal(Vector3f(0.0f, 0.0f, -6.0f * dt))
            if (window.getKeyState(GLFW_KEY_A)) bike.rotateLocal(0.0f, 1.4f * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) bike.rotateLocal(0.0f, -1.4f * dt, 0.0f)
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            bike.translateLocal(Vector3f(0.0f, 0.0f, 4.0f * dt))
            if (window.getKeyState(GLFW_KEY_A)) bike.rotateLocal(0.0f, -1.4f * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) bike.rotateLocal(0.0f, 1.4f * dt, 0.0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (key == GLFW_KEY_L && action == GLFW_PRESS) headLight.on = !headLight.on
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            firstMouse = false
            lastX = xpos
            return
        }
        val deltaX = xpos - lastX
        camera.rotateAroundPoint(0.0f, (-deltaX * 0.002).toFloat(), 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
        lastX = xpos
    }

    fun cleanup() {
        ground.cleanup()
        bike.cleanup()
        staticShader.cleanup()
    }
}
