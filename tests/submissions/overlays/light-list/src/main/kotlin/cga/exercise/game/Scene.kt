package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground: Renderable
    private val bike: Renderable
    private val camera = TronCamera()

    private val pointLights = ArrayList<PointLight>()
    private val spotLights = ArrayList<SpotLight>()
    private val bikeLight: PointLight

    private val groundColor = Vector3f(0.0f, 1.0f, 0.0f)
    private val bikeColor = Vector3f()

    private var lastX: Double? = null
    private var speed = 0.0f

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        // ---- ground ----
        val diff = loadTexture("ground_diff")
        val emit = loadTexture("ground_emit")
        val spec = loadTexture("ground_spec")
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        ground = Renderable(mutableListOf(Mesh(obj.vertexData, obj.indexData, attributes, Material(diff, emit, spec, 60.0f, Vector2f(64.0f)))))

        // ---- bike ----
        bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw Exception("Could not load the bike")
        bike.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))

        // ---- camera ----
        camera.parent = bike
        camera.translateLocal(Vector3f(0.0f, 2.2f, 4.2f))
        camera.rotateLocal(Math.toRadians(-22.0f), 0.0f, 0.0f)

        // ---- lights ----
        bikeLight = PointLight(Vector3f(0.0f, 2.0f, 0.0f), Vector3f(1.0f, 0.0f, 1.0f))
        bikeLight.parent = bike
        pointLights.add(bikeLight)

        val corners = listOf(
            Vector3f(18.0f, 1.0f, 18.0f),
            Vector3f(-18.0f, 1.0f, 18.0f),
            Vector3f(18.0f, 1.0f, -18.0f),
            Vector3f(-18.0f, 1.0f, -18.0f)
        )
        val cornerColors = listOf(
            Vector3f(5.0f, 0.0f, 0.0f),
            Vector3f(0.0f, 5.0f, 0.0f),
            Vector3f(0.0f, 0.0f, 5.0f),
            Vector3f(4.0f, 4.0f, 0.0f)
        )
        for (i in 0 until 4) {
            pointLights.add(PointLight(corners[i], cornerColors[i]))
        }

        val headLight = SpotLight(Vector3f(0.0f, 0.9f, -1.7f), Vector3f(2.5f, 2.5f, 2.5f), Math.toRadians(18.0f), Math.toRadians(27.0f))
        headLight.rotateLocal(Math.toRadians(-9.0f), 0.0f, 0.0f)
        headLight.parent = bike
        spotLights.add(headLight)

        println("${pointLights.size} point lights, ${spotLights.size} spot lights")
        GLError.checkThrow("init")
    }

    private fun loadTexture(name: String): Texture2D {
        val texture = Texture2D("assets/textures/$name.png", true)
        texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return texture
    }

    private fun bindLights() {
        for (i in pointLights.indices) {
            pointLights[i].bind(staticShader, "pointLights[$i]")
        }
        for (i in spotLights.indices) {
            spotLights[i].bind(staticShader, "spotLights[$i]", camera.getCalculateViewMatrix())
        }
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        staticShader.use()
        camera.bind(staticShader)

        bikeColor.x = (sin(t) + 1.0f) / 2.0f
        bikeColor.y = (sin(1.5f * t + 2.0f) + 1.0f) / 2.0f
        bikeColor.z = (sin(0.7f * t + 4.0f) + 1.0f) / 2.0f
        bikeLight.color = bikeColor
        bindLights()

        staticShader.setUniform("emitColor", bikeColor)
        bike.render(staticShader)

        staticShader.setUniform("emitColor", groundColor)
        ground.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        // accelerate and brake slowly
        speed *= 0.97f
        if (window.getKeyState(GLFW_KEY_W)) speed = 6.0f
        if (window.getKeyState(GLFW_KEY_S)) speed = -3.0f
        if (Math.abs(speed) < 0.01f) {
            speed = 0.0f
            return
        }
        bike.translateLocal(Vector3f(0.0f, 0.0f, -speed * dt))
        if (window.getKeyState(GLFW_KEY_A)) bike.rotateLocal(0.0f, 0.25f * speed * dt, 0.0f)
        if (window.getKeyState(GLFW_KEY_D)) bike.rotateLocal(0.0f, -0.25f * speed * dt, 0.0f)
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        // debug
        if (key == GLFW_KEY_P && action == GLFW_PRESS) {
            println("bike   ${bike.getWorldPosition()}")
            println("camera ${camera.getWorldPosition()}")
            pointLights.forEach { println("light  ${it.getWorldPosition()}") }
        }
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        val last = lastX
        lastX = xpos
        if (last == null) return
        val angle = (last - xpos) * 0.002
        camera.rotateAroundPoint(0.0f, angle.toFloat(), 0.0f, Vector3f())
    }

    fun cleanup() {
        ground.cleanup()
        bike.cleanup()
        staticShader.cleanup()
    }
}
